// SPDX-License-Identifier: MIT
#include "compat/rtut/app.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

#include "openrt/rt.h"
#include "openrt/rtut_enums.h"

namespace rtut {

namespace {

constexpr int kFrameMilliseconds = 40;      ///< off-screen
constexpr int kMaxFruitlessDisplays = 1000; ///< off-screen

} // namespace

App& app() {
    static App* const only = new App;
    return *only;
}

App& startedApp() noexcept {
    try {
        if (!app().isStarted()) app().start(nullptr, nullptr);
        return app();
    } catch (...) {
        endProgram(1, "out of memory");
    }
}

void App::start(int* argcp, char** argv) {
    if (!started_) startTime_ = Clock::now();
    started_ = true;
    std::string problem;
    const Options options = takeArguments(argcp, argv, problem);
    if (!problem.empty()) endProgram(2, problem.c_str());
    if (windows_.empty()) options_ = options;
    if (options.initialSize) initialSize = *options.initialSize;
    if (options.initialPlace) initialPlace = *options.initialPlace;
    if (!rtGetCurrentContext()) rtInit(argcp, argv);
}

Window& App::createWindow(const char* title) {
    const bool first = windows_.empty() && rtGetCurrentContext() != nullptr;
    const RTcontext context = first ? rtGetCurrentContext() : rtCreateContext();
    if (!context) endProgram(1, "out of memory");
    const Size size = options_.size ? *options_.size : initialSize;
    windows_.push_back(std::make_unique<Window>(++lastWindow_, context, !first, displayMode, size));
    Window& window = *windows_.back();
    const bool placed = initialPlace.x >= 0 && initialPlace.y >= 0;
    window.open(title, placed ? &initialPlace : nullptr);
    return window;
}

Window* App::find(int id) const {
    for (const auto& window : windows_)
        if (window->id() == id && window->isAlive()) return window.get();
    return nullptr;
}

int App::elapsed() const {
    if (isOffscreen()) return fixedTime_;
    const auto passed = Clock::now() - startTime_;
    return int(std::chrono::duration_cast<std::chrono::milliseconds>(passed).count());
}

void App::addTimer(unsigned milliseconds, void (*callback)(int), int value) {
    constexpr unsigned kLongest = 1u << 30;
    timers_.push_back({elapsed() + int(std::min(milliseconds, kLongest)), ++lastTimer_,
                       milliseconds == 0, callback, value});
}

/// Those due until now, earliest first; off-screen each at its time.
void App::callTimers(int now) {
    const uint64_t newest = lastTimer_;
    // One of no time that a timer asks for waits for the next round: it may be the same again.
    const auto waits = [&](const Timer& timer) {
        return timer.due > now || (timer.isAtOnce && timer.number > newest);
    };
    while (!leaving_) {
        const auto next =
            std::min_element(timers_.begin(), timers_.end(), [&](const Timer& a, const Timer& b) {
                return std::tuple(waits(a), a.due, a.number) <
                       std::tuple(waits(b), b.due, b.number);
            });
        if (next == timers_.end() || waits(*next)) break;
        const Timer timer = *next;
        timers_.erase(next);
        fixedTime_ = std::max(fixedTime_, timer.due); // what has waited is due in the past
        timer.callback(timer.value);
    }
    fixedTime_ = now;
}

void App::countFrame() {
    if (!isOffscreen() || ++countedFrames_ < options_.offscreenFrames) return;
    for (const auto& window : windows_) window->finish();
    end(0);
}

void App::writeFrame(const Picture& picture) {
    const int number = writtenFrames_++;
    const auto write = [&](const std::string& pattern, auto writePicture) {
        if (pattern.empty()) return;
        const std::string path = frameFile(pattern, number);
        const std::string problem = writePicture(path, picture);
        if (!problem.empty()) endProgram(1, (path + ": ").c_str(), problem.c_str());
    };
    write(options_.output, writePng);
    write(options_.depth, writePfm);
}

void App::end(int status) {
    rtExit();
    std::exit(status);
}

void App::run() {
    leaving_ = false;
    running_ = true;
    if (windows_.empty()) endProgram(1, "the main loop needs a window");
    for (std::size_t i = 0; i < windows_.size(); ++i) windows_[i]->reshapeIfNeeded();
    if (isOffscreen())
        runOffscreen();
    else
        runOnScreen();
    if (!leaving_) end(0);
    running_ = false;
    for (const auto& window : windows_) window->finish();
}

void App::runOffscreen() {
    int fruitless = 0;
    for (int64_t pass = 0; !leaving_ && !windows_.empty(); ++pass) {
        const int before = countedFrames_;
        callTimers(int(std::min<int64_t>(pass * kFrameMilliseconds, 1 << 30)));
        if (idle && !leaving_) idle();
        for (std::size_t i = 0; i < windows_.size() && !leaving_; ++i) {
            if (!windows_[i]->isAlive()) continue;
            windows_[i]->reshapeIfNeeded();
            windows_[i]->display();
        }
        removeClosedWindows();
        fruitless = countedFrames_ > before ? 0 : fruitless + 1;
        if (fruitless >= kMaxFruitlessDisplays)
            endProgram(1, "the program displays, but delivers no frame (rtutSwapBuffers)");
    }
}

double App::secondsToWait() const {
    if (idle) return 0;
    double seconds = 1;
    for (const auto& window : windows_) {
        if (window->redisplay) return 0;
        if (window->hasFrameUnderWay()) seconds = std::min(seconds, 0.005);
    }
    for (const Timer& timer : timers_)
        seconds = std::min(seconds, std::max(timer.due - elapsed(), 0) * 1e-3);
    return seconds;
}

void App::runOnScreen() {
    while (!leaving_ && !windows_.empty()) {
        waitForEvents(secondsToWait());
        removeClosedWindows();
        callTimers(elapsed());
        bool displayed = false;
        for (std::size_t i = 0; i < windows_.size() && !leaving_; ++i) {
            if (!windows_[i]->isAlive()) continue;
            windows_[i]->reshapeIfNeeded();
            if (windows_[i]->redisplay) {
                windows_[i]->display();
                displayed = true;
            } else {
                windows_[i]->finishIfDone();
            }
        }
        if (idle && !displayed && !leaving_) idle();
        removeClosedWindows();
    }
}

void App::removeClosedWindows() {
    const auto isClosed = [](const std::unique_ptr<Window>& window) { return !window->isAlive(); };
    if (std::none_of(windows_.begin(), windows_.end(), isClosed)) return;
    Window* const current = current_ && current_->isAlive() ? current_ : nullptr;
    const RTcontext context = rtGetCurrentContext();
    for (const auto& window : windows_)
        if (isClosed(window)) window->finish();
    current_ = current;
    if (rtGetCurrentContext() != context) rtMakeCurrent(context);
    std::erase_if(windows_, isClosed);
}

} // namespace rtut
