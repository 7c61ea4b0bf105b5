// SPDX-License-Identifier: MIT
// Every function of librtut, with legal arguments and with wrong ones, in every state of a program
// with windows, off-screen; each call in a process of its own. Whatever comes of it: the process
// neither dies nor hangs, and the host is as it was. A call that tells a message or records an
// error has changed nothing that can be asked for, takes no memory for good, and the program goes
// on as if it had not been made. What the header calls wrong tells a message.
//
//     every_rtut_call [--whole] [--json FILE] [FUNCTION]
//
// Without --whole each parameter gets its legal value and, in a third of the states, two others.
#include <malloc.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cfenv>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

#include "openrt/rt.h"
#include "tests/calls/host_state.h"
#include "tests/calls/observation.h"
#include "tests/calls/rtut_calls.h"
#include "tests/calls/rtut_places.h"
#include "tests/calls/variants.h"

namespace openrt::test {
namespace {

/// A message of these does not say that nothing happened; why.
const std::map<std::string, const char*> kMayActAndTell = {
    {"rtutInitDisplayMode", "takes what is beside colour index"},
    {"rtutInitDisplayString", "takes what is beside colour index"},
    {"rtutInit", "tells of arguments of rtInit that it ignores"},
    {"rtutMainLoop", "tells what callbacks told"},
    {"rtutReportErrors", "takes the errors"},
    {"rtutCreateMenu", "gives the next number"},
};

bool mayActAndTell(const std::string& name, const RtutPlace& place) {
    return kMayActAndTell.contains(name) && !(name == "rtutMainLoop" && place.isInLoop);
}

/// Exit statuses with which these end the program by their documentation.
const std::map<std::string, std::set<int>> kMayEnd = {
    {"rtutInit", {2}}, {"rtutMainLoop", {0, 1}}, {"rtutCreateWindow", {1}}};

/// Those of the current window, beside callbacks.
const std::set<std::string> kOfTheWindow = {
    "rtutSetWindowTitle", "rtutSetIconTitle",    "rtutReshapeWindow", "rtutPositionWindow",
    "rtutShowWindow",     "rtutHideWindow",      "rtutIconifyWindow", "rtutPushWindow",
    "rtutPopWindow",      "rtutFullScreen",      "rtutPostRedisplay", "rtutSwapBuffers",
    "rtutWarpPointer",    "rtutIgnoreKeyRepeat", "rtutSetCursor"};

/// Tokens that a function knows, in ranges of their values.
const std::map<std::string, std::vector<std::pair<int, int>>> kKnownTokens = {
    {"rtutGet", {{100, 122}, {200, 203}, {300, 300}, {400, 400}, {500, 504}, {700, 700}}},
    {"rtutDeviceGet", {{600, 616}}},
    {"rtutLayerGet", {{800, 805}}},
    {"rtutGameModeGet", {{0, 6}}},
    {"rtutVideoResizeGet", {{900, 909}}},
    {"rtutSetCursor", {{0, 19}, {100, 102}}},
    {"rtutSetKeyRepeat", {{0, 2}}},
};

bool endsWith(const std::string& text, const char* end) {
    const std::size_t length = std::strlen(end);
    return text.size() >= length && text.compare(text.size() - length, length, end) == 0;
}

/// Whether the header promises a message.
bool mustTell(const ApiFunction& function, const std::vector<Value>& arguments,
              const RtutPlace& place) {
    const std::string name = function.name;
    if (const auto known = kKnownTokens.find(name); known != kKnownTokens.end()) {
        const int token = arguments[0].to<int>();
        bool isKnown = false;
        for (const auto& [low, high] : known->second) isKnown |= token >= low && token <= high;
        if (!isKnown) return true;
        if (function.isLeftOut) return false; // a query: there is none
    }
    if (function.isLeftOut || (name == "rtutMainLoop" && place.isInLoop)) return true;
    const bool ofWindow =
        kOfTheWindow.contains(name) ||
        (endsWith(name, "Func") && name != "rtutIdleFunc" && name != "rtutTimerFunc");
    if (ofWindow && !place.hasWindow) return true;
    if (name == "rtutInitWindowSize" || name == "rtutReshapeWindow")
        for (const Value& size : arguments)
            if (size.to<int>() < 1 || size.to<int>() > 16384) return true;
    return name == "rtutInitDisplayString" && !arguments[0].p;
}

/// What rtut answers.
class Answers {
public:
    static Answers now() {
        Answers answers;
        for (const RTenum token : toolkitTokens())
            answers.values_[token] = {token == RTUT_ELAPSED_TIME ? 0 : rtutGet(token),
                                      rtutDeviceGet(token), rtutLayerGet(token),
                                      rtutGameModeGet(token), rtutVideoResizeGet(token)};
        answers.values_[0xFFFF] = {rtutGetWindow(), rtutGetModifiers()};
        return answers;
    }
    /// Names of what differs; empty: nothing.
    std::string differences(const Answers& other) const {
        std::string text;
        for (const auto& [token, values] : values_)
            if (other.values_.at(token) != values) text += " answer " + std::to_string(token);
        return text;
    }

private:
    std::map<RTenum, std::vector<int>> values_;
};

/// Of OpenRT, without which nothing can be asked for.
bool canObserve(const RtutPlace& place) {
    return place.isStarted && !place.isOpen && rtGetCurrentContext();
}

long toldBytes() {
    return long(lseek(STDERR_FILENO, 0, SEEK_END));
}
bool hasTold(const std::string& function) {
    std::string text(std::size_t(toldBytes()), ' ');
    if (pread(STDERR_FILENO, text.data(), text.size(), 0) < 0) return false;
    return text.find("rtut: " + function + ": ") != text.npos;
}

/// The call, and what is to be said of it, in lines that begin with '!': "told", or a fault.
void judgeCall(const ApiFunction& function, const Variant& variant, const RtutPlace& place) {
    const auto answers = [&] { return place.isStarted ? Answers::now() : Answers(); };
    const auto observed = [&] {
        rtFinish(); // what memory a frame holds is its own affair
        return canObserve(place) ? Observation::now() : Observation();
    };
    const Answers answersBefore = answers();
    const Observation before = observed();
    const long toldBefore = toldBytes();
    const unsigned errorsBefore = rtutErrors;
    const HostState host = HostState::now();
    tellSeen("!calling");
    function.call(variant.arguments.data());
    tellSeen("!returned");
    const std::string disturbed = host.differences(HostState::now());
    const bool told = toldBytes() > toldBefore || rtutErrors > errorsBefore;
    if (!disturbed.empty()) tellSeen("!fault: the host is not as it was: " + disturbed);
    if (mustTell(function, variant.arguments, place) && !hasTold(function.name))
        tellSeen("!fault: no message");
    if (!told || mayActAndTell(function.name, place)) return;
    tellSeen("!told");
    const std::string changed =
        answersBefore.differences(answers()) + before.differences(observed());
    if (!changed.empty()) tellSeen("!fault: a message, and state has changed: " + changed);
    constexpr int kTimes = 10; // more than free blocks of a size that the allocator keeps aside
    const auto bytesAfterMore = [&] {
        for (int i = 0; i < kTimes; ++i) function.call(variant.arguments.data());
        return mallinfo2().uordblks;
    };
    const std::size_t bytes = bytesAfterMore();
    if (bytesAfterMore() > bytes) tellSeen("!fault: a message, and memory is taken each time");
}

struct Account {
    std::vector<std::string> seen, faults;
    bool isTold = false, isReturned = false;
};

/// Runs the program in a process of its own.
Account accountOf(const RtutPlace& place, unsigned seconds, const std::function<void()>& calls) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    const pid_t child = fork();
    if (child == 0) {
        alarm(seconds);
        dup2(memfd_create("messages", 0), STDERR_FILENO);
        tellSeen = [&](const std::string& line) {
            if (write(ends[1], (line + "\n").c_str(), line.size() + 1) < 0) _exit(3);
        };
        place.run(calls);
        tellSeen("the end");
        _exit(0);
    }
    close(ends[1]);
    std::string text;
    char block[4096];
    for (ssize_t n; (n = read(ends[0], block, sizeof block)) > 0;)
        text.append(block, std::size_t(n));
    close(ends[0]);
    int status = -1;
    waitpid(child, &status, 0);
    Account account;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line == "!told") account.isTold = true;
        if (line == "!returned") account.isReturned = true;
        if (line.starts_with("!fault: ")) account.faults.push_back(line.substr(8));
        if (line[0] != '!') account.seen.push_back(line);
    }
    if (WIFSIGNALED(status))
        account.faults.push_back("ended by signal " + std::to_string(WTERMSIG(status)));
    account.seen.push_back("status " + std::to_string(WEXITSTATUS(status)));
    return account;
}

std::string firstDifference(const std::vector<std::string>& a, const std::vector<std::string>& b) {
    for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
        if (i >= a.size() || i >= b.size() || a[i] != b[i])
            return (i < b.size() ? b[i] : "nothing") + " instead of " +
                   (i < a.size() ? a[i] : "nothing");
    return "";
}

struct Result {
    long calls = 0, recorded = 0;
    std::map<std::string, long> callsAt;
    std::vector<std::string> faults;
};

constexpr unsigned kSeconds = 60; ///< in which every program has ended

class Trials {
public:
    explicit Trials(bool whole, bool isSilent = false, unsigned seconds = kSeconds)
        : whole_(whole), isSilent_(isSilent), seconds_(seconds) {
        for (const RtutPlace& place : rtutPlaces()) {
            untouched_.push_back(accountOf(place, kSeconds, [] {}));
            const Account again = accountOf(place, kSeconds, [&] {
                if (place.isStarted) Answers::now();
                if (canObserve(place)) Observation::now();
            });
            if (again.seen != untouched_.back().seen)
                fault(place.name, "the observation itself disturbs: " +
                                      firstDifference(untouched_.back().seen, again.seen));
        }
    }
    void run(const ApiFunction& function) {
        const std::vector<Variant> variants = variantsOf(function, whole_);
        for (const Variant& variant : variants)
            for (std::size_t i = 0; i < rtutPlaces().size(); ++i)
                if (whole_ || &variant == &variants.front() || ++turn_ % 3 == 0)
                    tryCall(function, variant, i);
    }
    bool findsOut(const ApiFunction& wrong) {
        for (std::size_t i = 0; i < rtutPlaces().size() && result_.faults.empty(); ++i)
            tryCall(wrong, variantsOf(wrong, whole_).front(), i);
        return !result_.faults.empty();
    }
    const Result& result() const { return result_; }

private:
    void tryCall(const ApiFunction& function, const Variant& variant, std::size_t number) {
        const RtutPlace& place = rtutPlaces()[number];
        const std::string name =
            std::string(function.name) + " (" + variant.what + ") " + place.name;
        if (std::getenv("OPENRT_TELL_CALLS")) std::fprintf(stderr, "%s\n", name.c_str());
        const Account account =
            accountOf(place, seconds_, [&] { judgeCall(function, variant, place); });
        ++result_.calls;
        ++result_.callsAt[place.name];
        result_.recorded += account.isTold;
        for (const std::string& text : account.faults) fault(name, text);
        const auto mayEnd = kMayEnd.find(function.name);
        if (!account.isReturned && account.faults.empty() && mayEnd == kMayEnd.end())
            fault(name, "the program ended: " +
                            firstDifference(untouched_[number].seen, account.seen));
        if (account.isTold && account.seen != untouched_[number].seen)
            fault(name, "a message, and the program goes on otherwise: " +
                            firstDifference(untouched_[number].seen, account.seen));
    }
    void fault(const std::string& call, const std::string& what) {
        result_.faults.push_back(call + ": " + what);
        if (!isSilent_ && result_.faults.size() <= 50)
            std::fprintf(stderr, "%s\n", result_.faults.back().c_str());
    }

    bool whole_, isSilent_;
    unsigned seconds_, turn_ = 0;
    std::vector<Account> untouched_;
    Result result_;
};

/// Sanitizers have memory of their own.
bool memoryIsCounted() {
    const std::size_t before = mallinfo2().uordblks;
    const std::vector<char> block(100);
    return mallinfo2().uordblks > before;
}

/// Calls that break the rules, each of which has to be found out.
bool controlsHold() {
    std::vector<ApiFunction> wrong = {
        {"control: acts and tells",
         [](const Value*) {
             rtutInitWindowPosition(rtutGet(RTUT_INIT_WINDOW_X) + 1, 2);
             rtutGet(0x9999);
         },
         {}},
        {"control: takes a callback and tells",
         [](const Value*) {
             rtutTimerFunc(
                 10, [](int) { tellSeen("timer"); }, 0);
             rtutGet(0x9999);
         },
         {}},
        {"control: rounds otherwise", [](const Value*) { std::fesetround(FE_DOWNWARD); }, {}},
        {"control: dies", [](const Value*) { std::raise(SIGSEGV); }, {}},
        {"control: hangs", [](const Value*) { pause(); }, {}},
        {"control: ends the program", [](const Value*) { _exit(0); }, {}},
        {"rtutSetCursor", [](const Value*) {}, {{"cursor", Kind::ToolkitToken, Value::of(55)}}},
    };
    if (memoryIsCounted())
        wrong.push_back({"control: takes memory and tells",
                         [](const Value*) {
                             static std::vector<void*> kept;
                             kept.push_back(std::malloc(100));
                             rtutGet(0x9999);
                         },
                         {}});
    for (const ApiFunction& function : wrong) {
        if (!Trials(false, true, 2).findsOut(function)) {
            std::fprintf(stderr, "%s: not found out\n", function.name);
            return false;
        }
    }
    return true;
}

void writeReport(const Result& result, const char* path, bool whole) {
    std::FILE* const file = std::fopen(path, "w");
    if (!file) return;
    std::fprintf(file,
                 "{\"whole\": %s, \"functions\": %zu, \"calls\": %ld, \"recorded\": %ld, "
                 "\"faults\": %zu,\n \"places\": {",
                 whole ? "true" : "false", rtutFunctions().size(), result.calls, result.recorded,
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
    if (!std::freopen("/dev/null", "w", stdout)) return 2;
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY"}) unsetenv(name); // nothing is shown
    makeHostUnusual();
    if (!controlsHold()) return 1;
    Trials trials(whole);
    for (const ApiFunction& function : rtutFunctions())
        if (!only || std::strcmp(function.name, only) == 0) trials.run(function);
    const Result& result = trials.result();
    std::fprintf(stderr, "%ld calls of %zu functions, %ld told or recorded an error; %zu faults\n",
                 result.calls, rtutFunctions().size(), result.recorded, result.faults.size());
    if (json) writeReport(result, json, whole);
    return result.faults.empty() && result.calls > 0 ? 0 : 1;
}
