// SPDX-License-Identifier: MIT
// What GLUT has and this release has not: each call says so once and does nothing else.
#include <string>

#include "compat/rtut/messages.h"
#include "openrt/rtut.h"

using namespace rtut;

namespace {

void leftOut(const char* function, const char* what) noexcept {
    guarded(function, [&] {
        tellOnce(function, (std::string(what) + " not part of this release").c_str());
    });
}
void noMenus(const char* function) { leftOut(function, "menus are"); }
void noOverlays(const char* function) { leftOut(function, "overlays are"); }
void noColorIndex(const char* function) { leftOut(function, "colour index is"); }
void noGameMode(const char* function) { leftOut(function, "game mode is"); }
void noVideoResizing(const char* function) { leftOut(function, "video resizing is"); }
void noDevice(const char* function) { leftOut(function, "this device is"); }

} // namespace

RTAPI int RTAPIENTRY rtutCreateSubWindow(int, int, int, int, int) {
    leftOut(__func__, "subwindows are");
    return 0;
}

RTAPI int RTAPIENTRY rtutCreateMenu(void (*)(int)) {
    static int lastMenu = 0;
    noMenus(__func__);
    return ++lastMenu;
}
RTAPI void RTAPIENTRY rtutDestroyMenu(int) { noMenus(__func__); }
RTAPI int RTAPIENTRY rtutGetMenu(void) {
    noMenus(__func__);
    return 0;
}
RTAPI void RTAPIENTRY rtutSetMenu(int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutAddMenuEntry(const char*, int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutAddSubMenu(const char*, int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutChangeToMenuEntry(int, const char*, int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutChangeToSubMenu(int, const char*, int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutRemoveMenuItem(int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutAttachMenu(int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutDetachMenu(int) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutMenuStateFunc(void (*)(int)) { noMenus(__func__); }
RTAPI void RTAPIENTRY rtutMenuStatusFunc(void (*)(int, int, int)) { noMenus(__func__); }

RTAPI void RTAPIENTRY rtutEstablishOverlay(void) { noOverlays(__func__); }
RTAPI void RTAPIENTRY rtutRemoveOverlay(void) { noOverlays(__func__); }
RTAPI void RTAPIENTRY rtutUseLayer(RTenum) { noOverlays(__func__); }
RTAPI void RTAPIENTRY rtutPostOverlayRedisplay(void) { noOverlays(__func__); }
RTAPI void RTAPIENTRY rtutPostWindowOverlayRedisplay(int) { noOverlays(__func__); }
RTAPI void RTAPIENTRY rtutShowOverlay(void) { noOverlays(__func__); }
RTAPI void RTAPIENTRY rtutHideOverlay(void) { noOverlays(__func__); }
RTAPI void RTAPIENTRY rtutOverlayDisplayFunc(void (*)(void)) { noOverlays(__func__); }

RTAPI void RTAPIENTRY rtutSetColor(int, RTfloat, RTfloat, RTfloat) { noColorIndex(__func__); }
RTAPI RTfloat RTAPIENTRY rtutGetColor(int, int) {
    noColorIndex(__func__);
    return -1.0f;
}
RTAPI void RTAPIENTRY rtutCopyColormap(int) { noColorIndex(__func__); }

RTAPI void RTAPIENTRY rtutGameModeString(const char*) { noGameMode(__func__); }
RTAPI int RTAPIENTRY rtutEnterGameMode(void) {
    noGameMode(__func__);
    return 0;
}
RTAPI void RTAPIENTRY rtutLeaveGameMode(void) { noGameMode(__func__); }
RTAPI int RTAPIENTRY rtutGameModeGet(RTenum query) {
    switch (query) {
    case RTUT_GAME_MODE_ACTIVE:
    case RTUT_GAME_MODE_POSSIBLE:
    case RTUT_GAME_MODE_DISPLAY_CHANGED: return 0;
    default:
        if (query > RTUT_GAME_MODE_DISPLAY_CHANGED) tell(__func__, "an unknown query");
        return -1;
    }
}

RTAPI int RTAPIENTRY rtutVideoResizeGet(RTenum query) {
    if (query == RTUT_VIDEO_RESIZE_POSSIBLE || query == RTUT_VIDEO_RESIZE_IN_USE) return 0;
    if (query < RTUT_VIDEO_RESIZE_POSSIBLE || query > RTUT_VIDEO_RESIZE_HEIGHT)
        tell(__func__, "an unknown query");
    return -1;
}
RTAPI void RTAPIENTRY rtutSetupVideoResizing(void) { noVideoResizing(__func__); }
RTAPI void RTAPIENTRY rtutStopVideoResizing(void) { noVideoResizing(__func__); }
RTAPI void RTAPIENTRY rtutVideoResize(int, int, int, int) { noVideoResizing(__func__); }
RTAPI void RTAPIENTRY rtutVideoPan(int, int, int, int) { noVideoResizing(__func__); }

RTAPI void RTAPIENTRY rtutJoystickFunc(void (*)(unsigned int, int, int, int), int) {
    noDevice(__func__);
}
RTAPI void RTAPIENTRY rtutForceJoystickFunc(void) { noDevice(__func__); }
RTAPI void RTAPIENTRY rtutSpaceballMotionFunc(void (*)(int, int, int)) { noDevice(__func__); }
RTAPI void RTAPIENTRY rtutSpaceballRotateFunc(void (*)(int, int, int)) { noDevice(__func__); }
RTAPI void RTAPIENTRY rtutSpaceballButtonFunc(void (*)(int, int)) { noDevice(__func__); }
RTAPI void RTAPIENTRY rtutButtonBoxFunc(void (*)(int, int)) { noDevice(__func__); }
RTAPI void RTAPIENTRY rtutDialsFunc(void (*)(int, int)) { noDevice(__func__); }
RTAPI void RTAPIENTRY rtutTabletMotionFunc(void (*)(int, int)) { noDevice(__func__); }
RTAPI void RTAPIENTRY rtutTabletButtonFunc(void (*)(int, int, int, int)) { noDevice(__func__); }
