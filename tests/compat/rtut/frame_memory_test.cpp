// SPDX-License-Identifier: MIT
// The memory that windows' frames are rendered to: it lives while a frame or the context may use
// it, and no longer; what happens without memory. This program replaces operator new.
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtut.h>

#include <atomic>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <new>

namespace {

constexpr int kSize = 307, kOtherSize = 311; ///< no other block is as large as such a picture
constexpr std::size_t bytesOf(int size) {
    return std::size_t(size) * std::size_t(size) * 4;
}

/// The blocks that have the size of pictures.
struct Pictures {
    static constexpr std::size_t kMost = 64;
    std::mutex mutex;
    void* blocks[kMost] = {};
    int sizes[kMost] = {};

    void replace(void* block, void* by, int size) {
        const std::lock_guard lock(mutex);
        for (std::size_t i = 0; i < kMost; ++i)
            if (blocks[i] == block) {
                blocks[i] = by;
                sizes[i] = size;
                return;
            }
        if (!block) std::abort();
    }
    int count(int size) {
        const std::lock_guard lock(mutex);
        int found = 0;
        for (std::size_t i = 0; i < kMost; ++i) found += blocks[i] && sizes[i] == size;
        return found;
    }
};
constinit Pictures pictures;

constexpr std::size_t kNone = ~std::size_t(0);
constinit std::atomic<std::size_t> refusedFrom{kNone}; ///< blocks of so many bytes there are not

void* allocated(std::size_t bytes) noexcept {
    void* const block = bytes < refusedFrom ? std::malloc(bytes ? bytes : 1) : nullptr;
    if (!block) return nullptr;
    for (const int size : {kSize, kOtherSize})
        if (bytes == bytesOf(size)) pictures.replace(nullptr, block, size);
    return block;
}
void release(void* block) noexcept {
    if (block) pictures.replace(block, nullptr, 0);
    std::free(block);
}

} // namespace

void* operator new(std::size_t bytes) {
    if (void* const block = allocated(bytes)) return block;
    throw std::bad_alloc();
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return allocated(bytes);
}
void operator delete(void* block) noexcept {
    release(block);
}
void operator delete(void* block, std::size_t) noexcept {
    release(block);
}

namespace {

/// Holds a frame up until it is opened.
class Gate {
public:
    void open() {
        const std::lock_guard lock(mutex_);
        isOpen_ = true;
        opened_.notify_all();
    }
    static void RTAPIENTRY hold(RTuint, RTenum, RTint, RTint, RTsizei, RTsizei, void* gate) {
        Gate& self = *static_cast<Gate*>(gate);
        std::unique_lock lock(self.mutex_);
        self.opened_.wait(lock, [&] { return self.isOpen_; });
    }

private:
    std::mutex mutex_;
    std::condition_variable opened_;
    bool isOpen_ = false;
};

int displays, window;
Gate* gate;

void start() {
    char name[] = "test", option[] = "--rt-offscreen", frames[] = "1000";
    char* arguments[] = {name, option, frames, nullptr};
    int count = 3;
    rtutInit(&count, arguments);
}

void openWindow(void (*display)()) {
    start();
    rtutInitDisplayMode(RTUT_DOUBLE);
    rtutInitWindowSize(kSize, kSize);
    window = rtutCreateWindow("");
    rtutDisplayFunc(display);
    displays = 0;
}

void closeAndLeave() {
    rtutDestroyWindow(window);
    rtutLeaveMainLoop();
}

TEST(FrameMemory, livesAsLongAsTheContextThatAClosedWindowLeaves) {
    for (int i = 0; i < 3; ++i) { // the context's next window uses it again
        openWindow([] {
            rtutSwapBuffers();
            closeAndLeave();
        });
        rtutMainLoop();
        EXPECT_EQ(pictures.count(kSize), 2) << i;
        rtRender(); // goes there
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
    }
}

TEST(FrameMemory, livesWhileAFrameOfTheApplicationIsRenderedToIt) {
    static int inFlight;
    Gate held;
    gate = &held;
    openWindow([] {
        if (++displays == 1) {
            rtSetFrameCallback(Gate::hold, gate);
            rtStartRendering();
            rtSetFrameCallback(nullptr, nullptr);
            rtutReshapeWindow(kOtherSize, kOtherSize);
        } else if (displays == 2) {
            inFlight = pictures.count(kSize);
            gate->open();
            rtEndRendering();
            rtutSwapBuffers();
        } else {
            rtutSwapBuffers();
            closeAndLeave();
        }
    });
    rtutMainLoop();
    EXPECT_EQ(inFlight, 2);
    EXPECT_EQ(pictures.count(kSize), 0);
    EXPECT_EQ(pictures.count(kOtherSize), 2);
    EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
}

TEST(FrameMemory, aWindowWithoutMemoryEndsTheProgram) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [] {
        openWindow([] {
            refusedFrom = bytesOf(kOtherSize);
            rtutReshapeWindow(kOtherSize, kOtherSize);
            rtutSwapBuffers();
        });
        rtutMainLoop();
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(1), "rtut: out of memory");
}

TEST(Messages, needNoMemory) {
    start();
    refusedFrom = 0;
    rtutInitWindowSize(-1, 0);
    rtutInitDisplayMode(RTUT_INDEX);
    rtutCreateMenu(nullptr);
    const int value = rtutGet(12345);
    refusedFrom = kNone;
    EXPECT_EQ(value, -1);
    EXPECT_STREQ(rtutGetErrorText(), "rtutGet: an unknown query");
}

TEST(Exceptions, thatLeaveACallbackEndTheProgram) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    const auto run = [] {
        openWindow([] { throw 1; });
        rtutMainLoop();
    };
    EXPECT_EXIT(run(), testing::ExitedWithCode(1), "rtut: an exception left a callback");
}

} // namespace
