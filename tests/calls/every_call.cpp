// SPDX-License-Identifier: MIT
// Every function of the library, with legal arguments and with each wrong one, in every state that
// a program can be in. Whatever comes of it: the process lives; a call that records an error has
// changed nothing that can be asked for; and the host is as it was before the call.
//
//     every_call [--whole] [--json FILE] [FUNCTION]
//
// Without --whole each parameter gets its legal value and two others. With it all values of its
// kind, every token, and each two of four values of each pair of parameters.
#include <unistd.h>

#include <cfenv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <thread>

#include "tests/calls/host_state.h"
#include "tests/calls/observation.h"
#include "tests/calls/places.h"
#include "tests/calls/variants.h"

namespace openrt::test {
namespace {

/// An error of these does not say that nothing happened; why.
const std::map<std::string, const char*> kMayActAndFail = {
    {"rtEndRendering", "records what went wrong with a frame that has ended"},
    {"rtRender", "records what went wrong with a frame that has ended"},
    {"rtFinish", "records what went wrong with a frame that has ended"},
    {"rtWaitFrame", "records what went wrong with a frame that has ended"},
};

/// Without a context these still do something, by their documentation.
const std::set<std::string> kNeedNoContext = {
    "rtInit", "rtExit", "rtMakeCurrent", "rtDestroyContext", "rtReleaseScene", "rtCancelFrame"};

struct Result {
    long calls = 0, errors = 0;
    std::map<std::string, long> callsAt;
    std::vector<std::string> faults;
};

unsigned errorsOfCall = 0;
void countErrors(RTenum, const char*, const char*, void*) {
    ++errorsOfCall;
}

/// A context of its own for each trial.
class FreshContext {
public:
    FreshContext() {
        std::memset(framePixels, 0, sizeof framePixels);
        context_ = rtCreateContext();
        rtMakeCurrent(context_);
        prepareContext();
        rtErrorCallback(countErrors, nullptr);
    }
    ~FreshContext() {
        if (rtGetCurrentContext() != context_) rtMakeCurrent(context_);
        rtDestroyContext(context_); // unknown if the call has ended it
    }
    FreshContext(const FreshContext&) = delete;
    FreshContext& operator=(const FreshContext&) = delete;
    bool isCurrent() const { return rtGetCurrentContext() == context_; }

private:
    RTcontext context_;
};

class Trials {
public:
    explicit Trials(bool whole, bool silent = false) : whole_(whole), silent_(silent) {
        for (const Place& place : places()) {
            FreshContext context;
            place.enter();
            place.leave();
            untouched_.push_back(Observation::now());
            const FreshContext again;
            place.enter();
            place.leave();
            const std::string different = untouched_.back().differences(Observation::now());
            if (!different.empty()) fault(place.name, "the observation itself differs", different);
        }
    }

    void run(const ApiFunction& function) {
        for (const Variant& variant : variantsOf(function, whole_))
            for (std::size_t i = 0; i < places().size(); ++i) tryCall(function, variant, i);
    }
    /// Tokens, and pairs of wrong arguments: what records an error is called in one context.
    void sweep(const ApiFunction& function, const std::vector<Variant>& variants) {
        for (std::size_t i = 0; i < places().size() && !variants.empty(); ++i)
            sweepIn(function, variants, i);
    }
    /// After the end of the library, in a callback, in the child of a fork, on a new thread.
    void runElsewhere();
    Result& result() { return result_; }

private:
    void tryCall(const ApiFunction& function, const Variant& variant, std::size_t placeNumber);
    void sweepIn(const ApiFunction& function, const std::vector<Variant>& variants,
                 std::size_t placeNumber);
    void callAll(const char* where, const std::set<std::string>& except);
    void fault(const std::string& call, const std::string& what, const std::string& details) {
        result_.faults.push_back(call + ": " + what + ": " + details);
        if (!silent_ && result_.faults.size() <= 50)
            std::fprintf(stderr, "%s\n", result_.faults.back().c_str());
    }

    bool whole_, silent_;
    std::vector<Observation> untouched_;
    Result result_;
};

void Trials::tryCall(const ApiFunction& function, const Variant& variant, std::size_t placeNumber) {
    const Place& place = places()[placeNumber];
    const std::string name = std::string(function.name) + " (" + variant.what + ") " + place.name;
    if (std::getenv("OPENRT_TELL_CALLS")) std::fprintf(stderr, "%s\n", name.c_str());
    FreshContext context;
    place.enter();
    const HostState before = HostState::now();
    errorsOfCall = 0;
    function.call(variant.arguments.data());
    const unsigned errors = errorsOfCall;
    const std::string disturbed = before.differences(HostState::now());
    if (!disturbed.empty()) fault(name, "the host is not as it was", disturbed);
    ++result_.calls;
    ++result_.callsAt[place.name];
    result_.errors += errors > 0;
    place.leave();
    if (!context.isCurrent()) return;
    if (errors == 0 && (place.current || kNeedNoContext.contains(function.name))) return;
    if (kMayActAndFail.contains(function.name)) return;
    const std::string changed = untouched_[placeNumber].differences(Observation::now());
    if (!changed.empty())
        fault(name, errors ? "an error was recorded, and state has changed" : "state has changed",
              changed);
}

void Trials::sweepIn(const ApiFunction& function, const std::vector<Variant>& variants,
                     std::size_t placeNumber) {
    const Place& place = places()[placeNumber];
    std::optional<FreshContext> context;
    const auto restart = [&] {
        if (context) place.leave();
        context.reset();
        context.emplace();
        place.enter();
    };
    const auto recordsError = [&](const Variant& variant) {
        errorsOfCall = 0;
        function.call(variant.arguments.data());
        ++result_.calls;
        ++result_.callsAt[place.name];
        result_.errors += errorsOfCall > 0;
        return errorsOfCall > 0;
    };
    // Where nothing can be recorded, nothing may happen.
    std::vector<const Variant*> without;
    restart();
    const HostState before = HostState::now();
    for (const Variant& variant : variants)
        if (recordsError(variant) || !place.current)
            without.push_back(&variant);
        else
            restart(); // it may have acted
    bool isSound = before.differences(HostState::now()).empty();
    restart();
    if (!kMayActAndFail.contains(function.name)) {
        for (const Variant* const variant : without) recordsError(*variant);
        place.leave();
        isSound = isSound && context->isCurrent() &&
                  untouched_[placeNumber].differences(Observation::now()).empty();
    }
    context.reset();
    if (isSound) return;
    const std::size_t faults = result_.faults.size();
    for (const Variant& variant : variants) tryCall(function, variant, placeNumber);
    if (result_.faults.size() == faults)
        fault(std::string(function.name) + " " + place.name,
              "calls that record errors change state together", variants.front().what);
}

/// Each function once with legal arguments, whatever state the one before has left.
void Trials::callAll(const char* where, const std::set<std::string>& except) {
    for (const ApiFunction& function : apiFunctions()) {
        if (except.contains(function.name)) continue;
        if (std::getenv("OPENRT_TELL_CALLS")) std::fprintf(stderr, "%s %s\n", function.name, where);
        const Variant legal = variantsOf(function, false).front();
        const HostState before = HostState::now();
        function.call(legal.arguments.data());
        const std::string disturbed = before.differences(HostState::now());
        if (!disturbed.empty())
            fault(std::string(function.name) + " " + where, "the host is not as it was", disturbed);
        ++result_.calls;
        ++result_.callsAt[where];
    }
}

void Trials::runElsewhere() {
    {
        FreshContext context;
        insideFrameCallback([this] { callAll("in a frame callback", {}); });
        if (!context.isCurrent()) fault("in a frame callback", "the context ended", "");
    }
    {
        FreshContext context;
        std::thread([this] {
            callAll("on a thread without a context", {"rtExit", "rtInit"});
        }).join();
    }
    {
        FreshContext context;
        const std::size_t faults = result_.faults.size();
        const bool ended = inChild([this, faults] {
            callAll("in the child of a fork", {});
            return result_.faults.size() == faults ? 0 : 1;
        });
        if (!ended) fault("in the child of a fork", "it did not end well", "");
        result_.callsAt["in the child of a fork"] += long(apiFunctions().size());
        result_.calls += long(apiFunctions().size());
    }
    forgetContext();
    rtExit();
    callAll("after rtExit", {"rtInit", "rtCreateContext", "rtMakeCurrent"});
}

/// Calls that break the rules, each of which has to be found out.
bool controlsHold() {
    const ApiFunction wrong[] = {
        {"control: acts and fails",
         [](const Value*) {
             rtColor3f(1, 0, 0);
             rtEnable(0x9999);
         },
         {}},
        {"control: rounds otherwise", [](const Value*) { std::fesetround(FE_DOWNWARD); }, {}},
        {"control: prints", [](const Value*) { std::puts("hello"); }, {}},
        {"control: acts without a context",
         [](const Value*) {
             rtMakeCurrent(first(Kind::Context).as<RTcontext>());
             rtPushMatrix();
         },
         {}},
    };
    for (const ApiFunction& function : wrong) {
        Trials trials(false, true);
        trials.run(function);
        std::fesetround(FE_UPWARD);
        if (trials.result().faults.empty()) {
            std::fprintf(stderr, "%s: not found out\n", function.name);
            return false;
        }
    }
    return true;
}

void writeReport(const Result& result, const char* path, bool whole) {
    FILE* const file = std::fopen(path, "w");
    if (!file) return;
    std::fprintf(file,
                 "{\"whole\": %s, \"functions\": %zu, \"calls\": %ld, \"errors\": %ld, "
                 "\"faults\": %zu,\n \"places\": {",
                 whole ? "true" : "false", apiFunctions().size(), result.calls, result.errors,
                 result.faults.size());
    const char* separator = "";
    for (const auto& [place, calls] : result.callsAt) {
        std::fprintf(file, "%s\"%s\": %ld", separator, place.c_str(), calls);
        separator = ", ";
    }
    std::fprintf(file, "}}\n");
    std::fclose(file);
}

} // namespace
} // namespace openrt::test

int main(int argc, char* argv[]) {
    using namespace openrt::test;
    bool whole = false;
    const char* json = nullptr;
    const char* only = nullptr;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--whole") == 0)
            whole = true;
        else if (std::strcmp(argv[i], "--json") == 0 && i + 1 < argc)
            json = argv[++i];
        else
            only = argv[i];
    }
    // A file, so that it can be asked whether anything was written.
    char output[] = "/tmp/openrt_every_call_XXXXXX";
    const int descriptor = mkstemp(output);
    if (descriptor < 0 || !std::freopen(output, "w", stdout)) return 2;
    close(descriptor);
    unlink(output);

    makeHostUnusual();
    if (!controlsHold()) return 1;
    Trials trials(whole);
    for (const ApiFunction& function : apiFunctions()) {
        if (only && std::strcmp(function.name, only) != 0) continue;
        trials.run(function);
        if (!whole) continue;
        trials.sweep(function, tokenVariantsOf(function));
        trials.sweep(function, pairVariantsOf(function));
    }
    if (!only) trials.runElsewhere();
    const Result& result = trials.result();
    std::fprintf(stderr, "%ld calls of %zu functions, %ld recorded an error; %zu faults\n",
                 result.calls, apiFunctions().size(), result.errors, result.faults.size());
    if (json) writeReport(result, json, whole);
    return result.faults.empty() && result.calls > 0 ? 0 : 1;
}
