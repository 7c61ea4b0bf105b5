// SPDX-License-Identifier: MIT
// Scenes in which the n-th allocation fails, for many n or for all: alone, or with all that follow.
// The process lives; the picture before stays as it was; the error is recorded, unless the picture
// is right all the same; the context renders the scene again, to the bit; nothing is leaked.
//
//     failing_scenes [--whole] [--json FILE] [SCENE]
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "openrt/rt.h"
#include "tests/memory/failing_new.h"
#include "tests/memory/scenes.h"

namespace openrt::test {
namespace {

constexpr RTuint kSize = 16;
constexpr int64_t kQuick = 24; // failures of each kind in a scene, without --whole
using Picture = std::vector<RTubyte>;

unsigned errors = 0;
void countErrors(RTenum, const char*, const char*, void*) { ++errors; }

struct Result {
    const char* scene;
    int64_t allocations = 0, failures = 0, recorded = 0, absorbed = 0, faults = 0;
};

class Trials {
public:
    explicit Trials(const Scene& scene, bool silent = false)
        : scene_(scene), silent_(silent), result_{scene.name} {}

    Result run(bool whole) {
        expected_ = Picture(kSize * kSize * 4);
        for (int i = 0; i < 3; ++i) { // tables of the process grow once
            startContext();
            render(expected_);
            render(expected_); // of a context, too
            endContext();
        }
        result_.allocations = countAllocations();
        for (const Failing how : {Failing::Once, Failing::FromThenOn})
            for (int64_t i = 0; i < result_.allocations; i += step(whole)) {
                // The process may keep something of a first time; not of a second one.
                const int64_t first = blocksKept(how, i);
                if (first > 0 && blocksKept(how, i) > 0) fault(how, i, "blocks are leaked");
            }
        return result_;
    }

private:
    int64_t step(bool whole) const {
        return whole ? 1 : std::max<int64_t>(1, result_.allocations / kQuick);
    }
    static void startContext() {
        rtInit(nullptr, nullptr);
        rtThreads(1);
        rtErrorCallback(countErrors, nullptr);
    }
    static void endContext() { rtExit(); }

    void render(Picture& picture) const {
        backToStart();
        std::fill(picture.begin(), picture.end(), RTubyte(0));
        rtSetFrameBuffer(picture.data(), kSize, kSize, RT_RGBA_8);
        rtClearColor(0.25f, 0.25f, 0.25f, 1);
        scene_.describeAndRender();
    }
    int64_t countAllocations() const {
        Picture picture(expected_.size());
        startContext();
        render(picture);
        backToStart();
        rtSetFrameBuffer(picture.data(), kSize, kSize, RT_RGBA_8);
        failAllocation(Failing::Never, 0);
        scene_.describeAndRender();
        const int64_t allocations = endFailing();
        endContext();
        return allocations;
    }
    int64_t blocksKept(Failing how, int64_t n) {
        const int64_t before = liveBlocks();
        tryFailure(how, n);
        return liveBlocks() - before;
    }
    void tryFailure(Failing how, int64_t n) {
        Picture before(expected_.size()), during(expected_.size()), after(expected_.size());
        startContext();
        render(before);
        backToStart();
        rtSetFrameBuffer(during.data(), kSize, kSize, RT_RGBA_8);
        rtClearColor(0.25f, 0.25f, 0.25f, 1);
        errors = 0;
        failAllocation(how, n);
        scene_.describeAndRender();
        endFailing();
        const int64_t failed = failedAllocations();
        const unsigned recorded = errors;
        const bool right = during == expected_;
        render(after);
        endContext();

        result_.failures += failed > 0;
        result_.recorded += failed > 0 && recorded > 0;
        if (before != expected_) fault(how, n, "the picture before has changed");
        if (after != expected_) fault(how, n, "the scene is not rendered again as before");
        if (failed > 0 && recorded == 0) {
            ++result_.absorbed;
            if (!right) fault(how, n, "a wrong picture, and no error");
        }
    }
    void fault(Failing how, int64_t n, const std::string& what) {
        if (++result_.faults > 20 || silent_) return;
        std::fprintf(stderr, "%s, %s allocation %lld: %s\n", scene_.name,
                     how == Failing::Once ? "only" : "from", static_cast<long long>(n),
                     what.c_str());
    }

    const Scene& scene_;
    bool silent_;
    Picture expected_;
    Result result_;
};

/// Scenes that break the rules have to be found out, and failures to reach the library.
bool controlsHold(const std::vector<Result>& results) {
    static int times = 0;
    struct Block {
        Block* next;
    };
    static Block* kept = nullptr; // the leaks, of which a leak checker may not hear
    const Scene wrong[] = {{"control: leaks",
                            [] {
                                if (void* const m = ::operator new(sizeof(Block), std::nothrow))
                                    kept = new (m) Block{kept};
                                rtRender();
                            }},
                           {"control: changes", [] {
                                rtClearColor(float(++times % 256) / 256, 0, 0, 1);
                                rtRender();
                            }}};
    bool found = true;
    for (const Scene& scene : wrong) found &= Trials(scene, true).run(false).faults > 0;
    while (kept) ::operator delete(std::exchange(kept, kept->next));
    if (!found) return false;
    int64_t recorded = 0;
    for (const Result& result : results) recorded += result.recorded;
    return recorded > 0;
}

/// Before anything else in the process: the tables that live as long as it can not be made either.
void startWithoutMemory() {
    failAllocation(Failing::FromThenOn, 0);
    rtInit(nullptr, nullptr);
    rtGetError();
    rtDestroyContext(rtCreateContext());
    rtExit();
    endFailing();
}

void writeReport(const std::vector<Result>& results, const char* path, bool whole) {
    FILE* const file = std::fopen(path, "w");
    if (!file) return;
    std::fprintf(file, "{\"whole\": %s, \"scenes\": [", whole ? "true" : "false");
    const char* separator = "\n";
    for (const Result& r : results) {
        std::fprintf(file,
                     "%s{\"scene\": \"%s\", \"allocations\": %lld, \"failures\": %lld, "
                     "\"recorded\": %lld, \"absorbed\": %lld, \"faults\": %lld}",
                     separator, r.scene, (long long)r.allocations, (long long)r.failures,
                     (long long)r.recorded, (long long)r.absorbed, (long long)r.faults);
        separator = ",\n";
    }
    std::fprintf(file, "]}\n");
    std::fclose(file);
}

} // namespace
} // namespace openrt::test

int main(int argc, char* argv[]) {
    using namespace openrt::test;
    bool whole = false;
    const char *json = nullptr, *only = nullptr;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--whole") == 0) whole = true;
        else if (std::strcmp(argv[i], "--json") == 0 && i + 1 < argc) json = argv[++i];
        else only = argv[i];
    }
    startWithoutMemory();
    std::vector<Result> results;
    int64_t faults = 0;
    for (const Scene& scene : scenes()) {
        if (only && std::strcmp(only, scene.name) != 0) continue;
        results.push_back(Trials(scene).run(whole));
        const Result& r = results.back();
        faults += r.faults;
        std::fprintf(stderr, "%s: %lld allocations, %lld failed, %lld recorded, %lld absorbed\n",
                     r.scene, (long long)r.allocations, (long long)r.failures,
                     (long long)r.recorded, (long long)r.absorbed);
    }
    if (json) writeReport(results, json, whole);
    return faults == 0 && controlsHold(results) ? 0 : 1;
}
