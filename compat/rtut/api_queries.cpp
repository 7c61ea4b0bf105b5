// SPDX-License-Identifier: MIT
#include <cstdio>
#include <optional>

#include "compat/rtut/app.h"
#include "openrt/rt.h"
#include "openrt/rtu.h"
#include "openrt/rtut.h"

using namespace rtut;

namespace {

/// nullopt: not a value of windows.
std::optional<int> windowValue(RTenum query) {
    const Window* const window = startedApp().current();
    const auto of = [&](int value) { return window ? value : 0; };
    switch (query) {
    case RTUT_WINDOW_X: return window ? window->place().x : 0;
    case RTUT_WINDOW_Y: return window ? window->place().y : 0;
    case RTUT_WINDOW_WIDTH: return window ? window->size.width : 0;
    case RTUT_WINDOW_HEIGHT: return window ? window->size.height : 0;
    case RTUT_WINDOW_BUFFER_SIZE: return of(32);
    case RTUT_WINDOW_DEPTH_SIZE: return of(24);
    case RTUT_WINDOW_RED_SIZE:
    case RTUT_WINDOW_GREEN_SIZE:
    case RTUT_WINDOW_BLUE_SIZE:
    case RTUT_WINDOW_ALPHA_SIZE: return of(8);
    case RTUT_WINDOW_DOUBLEBUFFER: return window ? window->isDoubleBuffered() : 0;
    case RTUT_WINDOW_RGBA: return of(1);
    case RTUT_WINDOW_NUM_SAMPLES:
        return window && (window->displayMode & RTUT_MULTISAMPLE) ? 4 : 0;
    case RTUT_WINDOW_CURSOR: return window ? window->cursor : 0;
    case RTUT_WINDOW_STENCIL_SIZE:
    case RTUT_WINDOW_ACCUM_RED_SIZE:
    case RTUT_WINDOW_ACCUM_GREEN_SIZE:
    case RTUT_WINDOW_ACCUM_BLUE_SIZE:
    case RTUT_WINDOW_ACCUM_ALPHA_SIZE:
    case RTUT_WINDOW_PARENT:
    case RTUT_WINDOW_NUM_CHILDREN:
    case RTUT_WINDOW_COLORMAP_SIZE:
    case RTUT_WINDOW_STEREO: return 0;
    default: return std::nullopt;
    }
}

std::optional<int> screenValue(RTenum query) {
    if (query < RTUT_SCREEN_WIDTH || query > RTUT_SCREEN_HEIGHT_MM) return std::nullopt;
    // Off-screen the screen is an ordinary one.
    const ScreenSize screen = startedApp().isOffscreen() ? ScreenSize{{1920, 1080}, {508, 286}}
                                                         : screenSize();
    switch (query) {
    case RTUT_SCREEN_WIDTH: return screen.pixels.width;
    case RTUT_SCREEN_HEIGHT: return screen.pixels.height;
    case RTUT_SCREEN_WIDTH_MM: return screen.millimetres.width;
    default: return screen.millimetres.height;
    }
}

} // namespace

RTAPI int RTAPIENTRY rtutGet(RTenum query) {
    if (const auto value = windowValue(query)) return *value;
    if (const auto value = screenValue(query)) return *value;
    const App& program = startedApp();
    switch (query) {
    case RTUT_MENU_NUM_ITEMS: return 0;
    case RTUT_DISPLAY_MODE_POSSIBLE: return 1;
    case RTUT_INIT_WINDOW_X: return program.initialPlace.x;
    case RTUT_INIT_WINDOW_Y: return program.initialPlace.y;
    case RTUT_INIT_WINDOW_WIDTH: return program.initialSize.width;
    case RTUT_INIT_WINDOW_HEIGHT: return program.initialSize.height;
    case RTUT_INIT_DISPLAY_MODE: return int(program.displayMode);
    case RTUT_ELAPSED_TIME: return program.elapsed();
    default: tell(__func__, "an unknown query"); return -1;
    }
}

RTAPI int RTAPIENTRY rtutDeviceGet(RTenum query) {
    const App& program = startedApp();
    switch (query) {
    case RTUT_HAS_KEYBOARD:
    case RTUT_HAS_MOUSE: return !program.isOffscreen();
    case RTUT_NUM_MOUSE_BUTTONS: return program.isOffscreen() ? 0 : 3;
    case RTUT_DEVICE_IGNORE_KEY_REPEAT:
        return program.current() ? program.current()->ignoresRepeat : 0;
    case RTUT_DEVICE_KEY_REPEAT:
        return program.repeatsKeys ? RTUT_KEY_REPEAT_ON : RTUT_KEY_REPEAT_OFF;
    case RTUT_HAS_SPACEBALL:
    case RTUT_HAS_DIAL_AND_BUTTON_BOX:
    case RTUT_HAS_TABLET:
    case RTUT_HAS_JOYSTICK:
    case RTUT_OWNS_JOYSTICK:
    case RTUT_NUM_SPACEBALL_BUTTONS:
    case RTUT_NUM_BUTTON_BOX_BUTTONS:
    case RTUT_NUM_DIALS:
    case RTUT_NUM_TABLET_BUTTONS:
    case RTUT_JOYSTICK_BUTTONS:
    case RTUT_JOYSTICK_AXES:
    case RTUT_JOYSTICK_POLL_RATE: return 0;
    default: tell(__func__, "an unknown query"); return -1;
    }
}

RTAPI int RTAPIENTRY rtutLayerGet(RTenum query) {
    switch (query) {
    case RTUT_LAYER_IN_USE: return RTUT_NORMAL;
    case RTUT_OVERLAY_POSSIBLE:
    case RTUT_HAS_OVERLAY: return 0;
    case RTUT_NORMAL_DAMAGED: return startedApp().current() && app().current()->redisplay;
    case RTUT_TRANSPARENT_INDEX:
    case RTUT_OVERLAY_DAMAGED: return -1;
    default: tell(__func__, "an unknown query"); return -1;
    }
}

RTAPI int RTAPIENTRY rtutGetModifiers(void) { return startedApp().modifiers(); }
RTAPI int RTAPIENTRY rtutExtensionSupported(const char* extension) {
    if (!rtGetCurrentContext()) return 0;
    return rtuCheckExtension(reinterpret_cast<const RTubyte*>(extension),
                             rtGetString(RT_EXTENSIONS));
}

RTAPI void RTAPIENTRY rtutReportErrors(void) {
    if (!rtGetCurrentContext()) return;
    for (RTenum error; (error = rtGetError()) != RT_NO_ERROR;)
        std::fprintf(stderr, "rtut: error %s: %s\n",
                     reinterpret_cast<const char*>(rtuErrorString(error)), rtGetErrorText());
}
