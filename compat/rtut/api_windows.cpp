// SPDX-License-Identifier: MIT
// Start, windows, callbacks, main loop.
#include <cstdlib>
#include <cstring>
#include <new>

#include "compat/rtut/app.h"
#include "openrt/rt.h"
#include "openrt/rtut.h"

using namespace rtut;

namespace {

/// Runs body with the current window; without one it tells.
template <class Body>
void withWindow(const char* function, Body&& body) noexcept {
    guarded(function, [&] {
        Window* const window = startedApp().current();
        if (!window) return tell(function, "there is no current window");
        body(*window);
    });
}

/// The same with what is on the screen; off-screen nothing.
template <class Body>
void withSurface(const char* function, Body&& body) noexcept {
    withWindow(function, [&](Window& window) {
        if (window.surface()) body(*window.surface());
    });
}

bool isSize(const char* function, int width, int height) {
    if (width >= 1 && height >= 1 && width <= kMaxWindowSize && height <= kMaxWindowSize)
        return true;
    tell(function, "not a size of windows");
    return false;
}

} // namespace

RTAPI void RTAPIENTRY rtutInit(int* argcp, char** argv) {
    guarded(__func__, [&] { app().start(argcp, argv); });
}

RTAPI void RTAPIENTRY rtutInitDisplayMode(unsigned int mode) {
    if (mode & RTUT_INDEX) tellOnce(__func__, "colour index is not part of this release");
    startedApp().displayMode = mode & ~unsigned(RTUT_INDEX);
}

RTAPI void RTAPIENTRY rtutInitDisplayString(const char* string) {
    guarded(__func__, [&] {
        if (!string) return tell("rtutInitDisplayString", "the string is NULL");
        unsigned mode = RTUT_RGBA | RTUT_DEPTH;
        if (std::strstr(string, "double")) mode |= RTUT_DOUBLE;
        if (std::strstr(string, "samples")) mode |= RTUT_MULTISAMPLE;
        if (std::strstr(string, "index"))
            tellOnce("rtutInitDisplayString", "colour index is not part of this release");
        startedApp().displayMode = mode;
    });
}

RTAPI void RTAPIENTRY rtutInitWindowPosition(int x, int y) { startedApp().initialPlace = {x, y}; }

RTAPI void RTAPIENTRY rtutInitWindowSize(int width, int height) {
    if (isSize(__func__, width, height) && !startedApp().options().initialSize)
        startedApp().initialSize = {width, height};
}

RTAPI void RTAPIENTRY rtutMainLoop(void) {
    try {
        if (startedApp().isRunning()) return tell(__func__, "the main loop is running");
        app().run();
    } catch (const std::bad_alloc&) {
        endProgram(1, "out of memory");
    } catch (...) {
        endProgram(1, "an exception left a callback");
    }
}
RTAPI void RTAPIENTRY rtutLeaveMainLoop(void) { startedApp().leave(); }
RTAPI const char* RTAPIENTRY rtutGetErrorText(void) { return newestMessage(); }

RTAPI int RTAPIENTRY rtutCreateWindow(const char* title) {
    int id = 0;
    try {
        id = startedApp().createWindow(title ? title : "").id();
    } catch (...) {
        endProgram(1, "out of memory");
    }
    return id;
}

RTAPI void RTAPIENTRY rtutDestroyWindow(int window) {
    guarded(__func__, [&] {
        Window* const gone = startedApp().find(window);
        if (!gone) return;
        gone->close();
        if (app().current() == gone) app().setCurrent(nullptr);
    });
}

RTAPI void RTAPIENTRY rtutSetWindow(int window) {
    guarded(__func__, [&] {
        if (Window* const found = startedApp().find(window)) found->select();
    });
}

RTAPI int RTAPIENTRY rtutGetWindow(void) {
    return startedApp().current() ? app().current()->id() : 0;
}

RTAPI void RTAPIENTRY rtutSetWindowTitle(const char* title) {
    withSurface(__func__, [&](Surface& surface) { surface.setTitle(title ? title : ""); });
}
RTAPI void RTAPIENTRY rtutSetIconTitle(const char*) {
    withWindow(__func__, [](Window&) {}); // windows of today have one title
}
RTAPI void RTAPIENTRY rtutReshapeWindow(int width, int height) {
    if (!isSize(__func__, width, height)) return;
    withWindow(__func__, [&](Window& window) { window.setSize({width, height}); });
}
RTAPI void RTAPIENTRY rtutPositionWindow(int x, int y) {
    withSurface(__func__, [&](Surface& surface) { surface.setPlace({x, y}); });
}
RTAPI void RTAPIENTRY rtutShowWindow(void) {
    withSurface(__func__, [](Surface& surface) { surface.setVisible(true); });
}
RTAPI void RTAPIENTRY rtutHideWindow(void) {
    withSurface(__func__, [](Surface& surface) { surface.setVisible(false); });
}
RTAPI void RTAPIENTRY rtutIconifyWindow(void) {
    withSurface(__func__, [](Surface& surface) { surface.iconify(); });
}
RTAPI void RTAPIENTRY rtutPushWindow(void) {
    withWindow(__func__, [](Window&) {
        tellOnce("rtutPushWindow", "windows can not be put behind others");
    });
}
RTAPI void RTAPIENTRY rtutPopWindow(void) {
    withSurface(__func__, [](Surface& surface) { surface.raise(); });
}
RTAPI void RTAPIENTRY rtutFullScreen(void) {
    withSurface(__func__, [](Surface& surface) { surface.fullScreen(); });
}

RTAPI void RTAPIENTRY rtutPostRedisplay(void) {
    withWindow(__func__, [](Window& window) { window.redisplay = true; });
}
RTAPI void RTAPIENTRY rtutPostWindowRedisplay(int window) {
    guarded(__func__, [&] {
        if (Window* const found = startedApp().find(window)) found->redisplay = true;
    });
}

RTAPI void RTAPIENTRY rtutSwapBuffers(void) {
    withWindow(__func__, [](Window& window) {
        if (window.isDoubleBuffered()) window.swap();
    });
}

RTAPI void RTAPIENTRY rtutWarpPointer(int x, int y) {
    withSurface(__func__, [&](Surface& surface) { surface.warpPointer({x, y}); });
}
RTAPI void RTAPIENTRY rtutSetCursor(int cursor) {
    const auto isIn = [&](int low, int high) { return cursor >= low && cursor <= high; };
    if (!isIn(RTUT_CURSOR_RIGHT_ARROW, RTUT_CURSOR_BOTTOM_LEFT_CORNER) &&
        !isIn(RTUT_CURSOR_INHERIT, RTUT_CURSOR_FULL_CROSSHAIR))
        return tell(__func__, "not a cursor");
    withWindow(__func__, [&](Window& window) {
        window.cursor = cursor;
        if (window.surface()) window.surface()->setCursor(cursor);
    });
}

RTAPI void RTAPIENTRY rtutIgnoreKeyRepeat(int ignore) {
    withWindow(__func__, [&](Window& window) { window.ignoresRepeat = ignore != 0; });
}
RTAPI void RTAPIENTRY rtutSetKeyRepeat(int repeatMode) {
    if (repeatMode < RTUT_KEY_REPEAT_OFF || repeatMode > RTUT_KEY_REPEAT_DEFAULT)
        return tell(__func__, "not a mode of repeating keys");
    startedApp().repeatsKeys = repeatMode != RTUT_KEY_REPEAT_OFF;
}

// ---- Callbacks -------------------------------------------------------------------------------

RTAPI void RTAPIENTRY rtutDisplayFunc(void (*callback)(void)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.display = callback; });
}
RTAPI void RTAPIENTRY rtutReshapeFunc(void (*callback)(int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.reshape = callback; });
}
RTAPI void RTAPIENTRY rtutKeyboardFunc(void (*callback)(unsigned char, int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.keyboard = callback; });
}
RTAPI void RTAPIENTRY rtutKeyboardUpFunc(void (*callback)(unsigned char, int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.keyboardUp = callback; });
}
RTAPI void RTAPIENTRY rtutSpecialFunc(void (*callback)(int, int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.special = callback; });
}
RTAPI void RTAPIENTRY rtutSpecialUpFunc(void (*callback)(int, int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.specialUp = callback; });
}
RTAPI void RTAPIENTRY rtutMouseFunc(void (*callback)(int, int, int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.mouse = callback; });
}
RTAPI void RTAPIENTRY rtutMotionFunc(void (*callback)(int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.motion = callback; });
}
RTAPI void RTAPIENTRY rtutPassiveMotionFunc(void (*callback)(int, int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.passiveMotion = callback; });
}
RTAPI void RTAPIENTRY rtutEntryFunc(void (*callback)(int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.entry = callback; });
}
RTAPI void RTAPIENTRY rtutVisibilityFunc(void (*callback)(int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.visibility = callback; });
}
RTAPI void RTAPIENTRY rtutWindowStatusFunc(void (*callback)(int)) {
    withWindow(__func__, [&](Window& window) { window.callbacks.windowStatus = callback; });
}
RTAPI void RTAPIENTRY rtutIdleFunc(void (*callback)(void)) { startedApp().idle = callback; }
RTAPI void RTAPIENTRY rtutTimerFunc(unsigned int milliseconds, void (*callback)(int), int value) {
    guarded(__func__, [&] {
        if (callback) startedApp().addTimer(milliseconds, callback, value);
    });
}
