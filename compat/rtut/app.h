// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "compat/rtut/messages.h"
#include "compat/rtut/options.h"
#include "compat/rtut/window.h"
#include "openrt/rtut.h"

namespace rtut {

/// The program: its windows, its clock, its timers and its main loop. There is one; all is done
/// by the thread that calls.
class App {
public:
    /// What rtutInit does; a call before it comes here too, without arguments.
    void start(int* argcp, char** argv);
    bool isStarted() const { return started_; }

    const Options& options() const { return options_; }
    bool isOffscreen() const { return options_.offscreenFrames > 0; }

    // Windows.
    Window& createWindow(const char* title);
    Window* current() const { return current_; }
    void setCurrent(Window* window) { current_ = window; }
    /// nullptr: there is none of that number.
    Window* find(int id) const;
    /// Stays where it is until it is forgotten.
    FrameMemory& frameMemory(RTcontext context) { return frameMemory_[context]; }
    /// After the context's end.
    void forgetFrameMemory(RTcontext context) { frameMemory_.erase(context); }

    // Time, in milliseconds.
    int elapsed() const;
    void addTimer(unsigned milliseconds, void (*callback)(int), int value);

    // Frames off-screen.
    void countFrame();
    void writeFrame(const Picture& picture);

    void run();
    bool isRunning() const { return running_; }
    void leave() { leaving_ = true; }

    int modifiers() const { return modifiers_; }
    void setModifiers(int modifiers) { modifiers_ = modifiers; }

    unsigned displayMode = RTUT_RGBA | RTUT_SINGLE | RTUT_DEPTH;
    Size initialSize{300, 300};
    Place initialPlace{-1, -1};
    void (*idle)() = nullptr;
    bool repeatsKeys = true;

private:
    using Clock = std::chrono::steady_clock;
    struct Timer {
        int due;
        uint64_t number;
        bool isAtOnce; ///< of no time
        void (*callback)(int);
        int value;
    };

    void runOffscreen();
    void runOnScreen();
    void callTimers(int now);
    double secondsToWait() const;
    void removeClosedWindows();
    [[noreturn]] void end(int status);

    bool started_ = false, running_ = false, leaving_ = false;
    Options options_;
    std::map<RTcontext, FrameMemory> frameMemory_;
    std::vector<std::unique_ptr<Window>> windows_;
    Window* current_ = nullptr;
    int lastWindow_ = 0, modifiers_ = 0;
    std::vector<Timer> timers_;
    uint64_t lastTimer_ = 0;
    Clock::time_point startTime_{};
    int fixedTime_ = 0;                       ///< off-screen
    int countedFrames_ = 0, writtenFrames_ = 0; ///< off-screen
};

/// Lives until the process ends.
App& app();
/// The same, started; without memory for it the program ends.
App& startedApp() noexcept;

} // namespace rtut
