// SPDX-License-Identifier: MIT
#include "tests/calls/rtut_places.h"

#include <sys/wait.h>
#include <unistd.h>

#include <iterator>
#include <thread>
#include <utility>

#include "openrt/rt.h"
#include "openrt/rtut.h"

namespace openrt::test {

std::function<void(const std::string&)> tellSeen;
unsigned rtutErrors = 0;

namespace {

constexpr int kFrames = 3, kMostRounds = 8;

const std::function<void()>* madeIn[4] = {}; ///< calls that a callback makes, once
enum Moment { Display, Reshape, Idle, Timer };
int displays = 0, rounds = 0;

void see(const char* what) {
    tellSeen(std::string(what) + " at " + std::to_string(rtutGet(RTUT_ELAPSED_TIME)) + " in " +
             std::to_string(rtutGetWindow()));
}
void makeCallsIn(Moment moment) {
    if (const std::function<void()>* const calls = std::exchange(madeIn[moment], nullptr))
        (*calls)();
}

/// Which of a few rays hit something.
void seeScene() {
    constexpr int kRays = 25;
    RTray rays[kRays] = {};
    RThit hits[kRays];
    std::string seen = "scene ";
    for (int i = 0; i < kRays; ++i)
        rays[i] = {{float(i % 5) / 2 - 1, float(i / 5) / 2 - 0.9f, 5}, 0, {0, 0, -1}, 1000};
    const RTuint scene = rtCompileScene();
    rtIntersect(scene, rays, hits, kRays, RT_INCOHERENT);
    rtReleaseScene(scene);
    for (const RThit& hit : hits) seen += hit.primitive == RT_INVALID ? '.' : '#';
    tellSeen(seen);
}

void onError(RTenum, const char*, const char*, void*) {
    ++rtutErrors;
}
void onDisplay() {
    see("display");
    makeCallsIn(Display);
    rtBegin(RT_TRIANGLES);
    for (const float x : {-1.0f, 0.0f, 1.0f}) rtVertex3f(x, x * x, 0);
    rtEnd();
    seeScene();
    rtutSwapBuffers();
    if (++displays >= kFrames) rtutLeaveMainLoop();
}
void onReshape(int width, int height) {
    see(("reshape to " + std::to_string(width) + " " + std::to_string(height)).c_str());
    makeCallsIn(Reshape);
}
void onIdle() {
    see("idle");
    makeCallsIn(Idle);
    if (++rounds >= kMostRounds) rtutLeaveMainLoop();
}
void onTimer(int value) {
    see(("timer " + std::to_string(value)).c_str());
    makeCallsIn(Timer);
}
void onVisibility(int state) {
    see(("visibility " + std::to_string(state)).c_str());
}

void start() {
    static char program[] = "program", frames[] = "--rt-offscreen", many[] = "1000";
    static char threads[] = "--rt-threads", one[] = "1", geometry[] = "-geometry", size[] = "16x16";
    static char* arguments[] = {program, frames, many, threads, one, geometry, size, nullptr};
    int count = int(std::size(arguments)) - 1;
    rtutInit(&count, arguments);
}
void openWindow() {
    rtutCreateWindow("window");
    rtErrorCallback(onError, nullptr);
    rtutDisplayFunc(onDisplay);
    rtutReshapeFunc(onReshape);
    rtutVisibilityFunc(onVisibility);
    rtutIdleFunc(onIdle);
    rtutTimerFunc(30, onTimer, 1);
}
void startWithWindow(unsigned mode = RTUT_DOUBLE) {
    start();
    rtutInitDisplayMode(mode);
    openWindow();
}

using Calls = std::function<void()>;

void unstarted(const Calls& calls) {
    calls();
    startWithWindow();
    rtutMainLoop();
}
void started(const Calls& calls) {
    start();
    calls();
    openWindow();
    rtutMainLoop();
}
void withWindow(const Calls& calls) {
    startWithWindow();
    calls();
    rtutMainLoop();
}
void withSingleBufferedWindow(const Calls& calls) {
    startWithWindow(RTUT_SINGLE);
    calls();
    rtutMainLoop();
}
void withTwoWindows(const Calls& calls) {
    startWithWindow();
    openWindow();
    calls();
    rtutMainLoop();
}
void withFrameUnderWay(const Calls& calls) {
    startWithWindow();
    rtutSwapBuffers();
    calls();
    rtutMainLoop();
}
void withMenu(const Calls& calls) {
    startWithWindow();
    rtutCreateMenu(nullptr);
    rtutAddMenuEntry("entry", 1);
    rtutAttachMenu(RTUT_RIGHT_BUTTON);
    calls();
    rtutMainLoop();
}
void inPrimitive(const Calls& calls) {
    startWithWindow();
    rtBegin(RT_TRIANGLES);
    calls();
    rtEnd();
    rtutMainLoop();
}
void inList(const Calls& calls) {
    startWithWindow();
    rtNewList(1, RT_COMPILE);
    calls();
    rtEndList();
    rtutMainLoop();
}
void in(Moment moment, const Calls& calls) {
    startWithWindow();
    madeIn[moment] = &calls;
    rtutMainLoop();
}
void inDisplay(const Calls& calls) {
    in(Display, calls);
}
void inReshape(const Calls& calls) {
    in(Reshape, calls);
}
void inIdle(const Calls& calls) {
    in(Idle, calls);
}
void inTimer(const Calls& calls) {
    in(Timer, calls);
}
void afterMainLoop(const Calls& calls) {
    startWithWindow();
    rtutMainLoop();
    calls();
    displays = rounds = 0;
    rtutMainLoop();
}
void withoutTheWindow(const Calls& calls) {
    startWithWindow();
    rtutDestroyWindow(rtutGetWindow());
    calls();
    openWindow();
    rtutMainLoop();
}
void afterRtExit(const Calls& calls) {
    startWithWindow();
    rtExit();
    calls();
    rtutMainLoop();
}
void onAnotherThread(const Calls& calls) {
    startWithWindow();
    std::thread(calls).join();
    rtutMainLoop();
}
void inForkedChild(const Calls& calls) {
    startWithWindow();
    rtutSwapBuffers();
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    rtFinish(); // their allocators, unlike glibc's, are not held over a fork: a worker may be in them
#endif
    const pid_t child = fork();
    if (child == 0) {
        alarm(30);
        calls();
        _exit(0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    tellSeen("child ended with " + std::to_string(status));
    rtutMainLoop();
}

} // namespace

const std::vector<RtutPlace>& rtutPlaces() {
    static const std::vector<RtutPlace> all = {
        {"before rtutInit", unstarted, false, false},
        {"after rtutInit", started, false},
        {"with a window", withWindow},
        {"with a single-buffered window", withSingleBufferedWindow},
        {"with two windows", withTwoWindows},
        {"with a frame under way", withFrameUnderWay},
        {"with a menu asked for", withMenu},
        {"in a primitive", inPrimitive, true, true, true},
        {"in a list", inList, true, true, true},
        {"in the display callback", inDisplay, true, true, false, true},
        {"in the reshape callback", inReshape, true, true, false, true},
        {"in the idle callback", inIdle, true, true, false, true},
        {"in a timer", inTimer, true, true, false, true},
        {"after the main loop", afterMainLoop},
        {"after the window's end", withoutTheWindow, false},
        {"after rtExit", afterRtExit},
        {"on another thread", onAnotherThread},
        {"in the child of a fork", inForkedChild},
    };
    return all;
}

} // namespace openrt::test
