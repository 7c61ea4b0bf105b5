/* SPDX-License-Identifier: MIT */
/* The counterpart of GLUT 3.7, in a library of its own: windows, events, timers, shapes and text.
 * C99, usable from C++.
 *
 * Where nothing else is said a call does what its namesake of GLUT does. What differs:
 *
 * Frames. Each window has a rendering context (the first: the default one) and is its frame
 *   buffer, RT_RGBA_8. rtutSwapBuffers queues the frame and shows the newest finished one, so that
 *   the next is described while one is rendered. In a single-buffered window the end of the
 *   display callback renders and shows the frame; each frame starts from the clear colour. A frame
 *   is shown as a texture on one rectangle by OpenGL, GLFW opens the window; both are started by
 *   the first window, not before.
 * Off-screen. With --rt-offscreen N on its command line any program renders N frames, writes each,
 *   and ends with exit status 0; GLFW and OpenGL are not touched. The clock is fixed: when the
 *   display callback is called for the n-th time (from 0) it is 40 n milliseconds. At first the
 *   reshape and visibility callbacks are called; for each frame the timers due until then, in
 *   order of time, each at its time; the idle callback once; the display callback, whether a
 *   redisplay was posted or not. A frame is delivered by each rtutSwapBuffers, or by the end of
 *   the display callback of a single-buffered window. After 1000 display callbacks without a frame
 *   the program ends with a message and exit status 1. All windows count, in order; no event comes.
 *     --rt-offscreen N       frames to render, 1 to 1,000,000
 *     --rt-output PATTERN    a PNG file for each frame, rows from the top, 8-bit RGB; one %d, as
 *                            in frame%03d.png, stands for its number from 0. Without: no files
 *     --rt-depth PATTERN     the same, of PFM files with the window depth, float, rows from below
 *     --rt-size WxH          the size of windows, whatever the program asks for; also on screen
 *   A wrong value prints a message and ends the program with exit status 2. So does, as in GLUT,
 *   -geometry WxH+X+Y; -display NAME, -iconic, -direct, -indirect, -sync, -gldebug are taken out
 *   and ignored.
 * Left out. Menus, overlays, colour index, subwindows, game mode, video resizing, and the devices
 *   joystick, spaceball, dials, button box and tablet: their calls do nothing but to tell so, once
 *   each, on stderr and in rtutGetErrorText. Queries about them answer that there are none.
 *
 * Threads. All calls on the thread that called rtutInit. Wrong arguments have no effect but a
 * message (rtutGetErrorText). Callbacks may be NULL, which takes them away.
 *
 * The sources of shapes and text (compat/rtut/shapes.c, teapot.c, text.c, fonts) also compile
 * against OpenGL and GLU, under GLUT's names, with RTUT_ON_OPENGL defined.
 */
#ifndef OPENRT_RTUT_H
#define OPENRT_RTUT_H

#include "openrt/rtut_enums.h"
#include "openrt/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Start and main loop ---------------------------------------------------------------- */

/* Starts the library of windows. Takes the arguments that this header names out of argv, then calls
 * rtInit with it unless a context is current.
 * A program whose first call is another one is as if it had called rtutInit(NULL, NULL).
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtutInit(int *argcp, char **argv);

/* Position and size, in pixels, and display mode of windows opened from now on. The mode (RTUT_RGBA
 * | RTUT_SINGLE at the start; RTUT_DOUBLE; RTUT_MULTISAMPLE enables RT_MULTISAMPLE; RTUT_INDEX is
 * left out, the rest is always there or ignored) is also given as a string, which asks for "double"
 * or "single", "samples"; the rest of it is ignored. Since: 0.1 */
RTAPI void RTAPIENTRY rtutInitDisplayMode(unsigned int mode);
RTAPI void RTAPIENTRY rtutInitDisplayString(const char *string);
RTAPI void RTAPIENTRY rtutInitWindowPosition(int x, int y);
RTAPI void RTAPIENTRY rtutInitWindowSize(int width, int height);

/* Calls callbacks until the last window is closed or rtutLeaveMainLoop is called. Then the contexts
 * end and so does the program, exit status 0: it never returns, but after rtutLeaveMainLoop it
 * does. A window without a display callback, a lack of memory, an exception that leaves a callback:
 * message and exit status 1. In a callback: a message. Since: 0.1 */
RTAPI void RTAPIENTRY rtutMainLoop(void);
RTAPI void RTAPIENTRY rtutLeaveMainLoop(void);

/* The text of the newest message of this library; "" if there was none. Since: 0.1 */
RTAPI const char *RTAPIENTRY rtutGetErrorText(void);

/* ---- Windows ---------------------------------------------------------------------------- */

/* Opens a window, makes it and its context current, and returns its number; from 1. Where no
 * window can be opened: message and exit status 1. Since: 0.1 */
RTAPI int RTAPIENTRY rtutCreateWindow(const char *title);

/* Subwindows, which are left out: returns 0. Since: 0.1 */
RTAPI int RTAPIENTRY rtutCreateSubWindow(int window, int x, int y, int width, int height);

/* Close a window, and which window is current. Unknown windows are ignored. rtutGetWindow is 0
 * without a window. Since: 0.1 */
RTAPI void RTAPIENTRY rtutDestroyWindow(int window);
RTAPI void RTAPIENTRY rtutSetWindow(int window);
RTAPI int RTAPIENTRY rtutGetWindow(void);

/* Change the current window, in pixels: off-screen rtutReshapeWindow alone has an effect.
 * rtutPostRedisplay asks for a call of the display callback. Since: 0.1 */
RTAPI void RTAPIENTRY rtutSetWindowTitle(const char *title);
RTAPI void RTAPIENTRY rtutSetIconTitle(const char *title);
RTAPI void RTAPIENTRY rtutReshapeWindow(int width, int height);
RTAPI void RTAPIENTRY rtutPositionWindow(int x, int y);
RTAPI void RTAPIENTRY rtutShowWindow(void);
RTAPI void RTAPIENTRY rtutHideWindow(void);
RTAPI void RTAPIENTRY rtutIconifyWindow(void);
RTAPI void RTAPIENTRY rtutPushWindow(void);
RTAPI void RTAPIENTRY rtutPopWindow(void);
RTAPI void RTAPIENTRY rtutFullScreen(void);
RTAPI void RTAPIENTRY rtutPostRedisplay(void);
RTAPI void RTAPIENTRY rtutPostWindowRedisplay(int window);

/* Queues the frame and shows the newest finished one. No effect in a single-buffered window.
 * rtutWarpPointer moves the pointer.
 * Errors:  of rtutSwapBuffers: what went wrong with a frame, in the context of its window
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtutSwapBuffers(void);
RTAPI void RTAPIENTRY rtutWarpPointer(int x, int y);

/* Sets the cursor of the current window: cursor is an RTUT_CURSOR_ constant; those that the window
 * system lacks become the arrow. Since: 0.1 */
RTAPI void RTAPIENTRY rtutSetCursor(int cursor);

/* ---- Callbacks -------------------------------------------------------------------------- */

/* The callbacks of the current window. Without a reshape callback rtViewport is set to the window's
 * size. Positions are in pixels from the upper left corner. Since: 0.1 */
RTAPI void RTAPIENTRY rtutDisplayFunc(void (*callback)(void));
RTAPI void RTAPIENTRY rtutReshapeFunc(void (*callback)(int width, int height));
RTAPI void RTAPIENTRY rtutKeyboardFunc(void (*callback)(unsigned char key, int x, int y));
RTAPI void RTAPIENTRY rtutKeyboardUpFunc(void (*callback)(unsigned char key, int x, int y));
RTAPI void RTAPIENTRY rtutSpecialFunc(void (*callback)(int key, int x, int y));
RTAPI void RTAPIENTRY rtutSpecialUpFunc(void (*callback)(int key, int x, int y));
RTAPI void RTAPIENTRY rtutMouseFunc(void (*callback)(int button, int state, int x, int y));
RTAPI void RTAPIENTRY rtutMotionFunc(void (*callback)(int x, int y));
RTAPI void RTAPIENTRY rtutPassiveMotionFunc(void (*callback)(int x, int y));
RTAPI void RTAPIENTRY rtutEntryFunc(void (*callback)(int state));
RTAPI void RTAPIENTRY rtutVisibilityFunc(void (*callback)(int state));
RTAPI void RTAPIENTRY rtutWindowStatusFunc(void (*callback)(int state));

/* The callbacks of the program. A timer is called once, at the earliest after so many milliseconds;
 * one of 0 milliseconds that is asked for by a timer, in the next round of the main loop.
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtutIdleFunc(void (*callback)(void));
RTAPI void RTAPIENTRY rtutTimerFunc(unsigned int milliseconds, void (*callback)(int value),
                                    int value);

/* Callbacks of devices and menus, which are left out: never called. Since: 0.1 */
RTAPI void RTAPIENTRY rtutMenuStateFunc(void (*callback)(int state));
RTAPI void RTAPIENTRY rtutMenuStatusFunc(void (*callback)(int status, int x, int y));
RTAPI void RTAPIENTRY rtutOverlayDisplayFunc(void (*callback)(void));
RTAPI void RTAPIENTRY rtutJoystickFunc(void (*callback)(unsigned int buttons, int x, int y, int z),
                                       int pollInterval);
RTAPI void RTAPIENTRY rtutForceJoystickFunc(void);
RTAPI void RTAPIENTRY rtutSpaceballMotionFunc(void (*callback)(int x, int y, int z));
RTAPI void RTAPIENTRY rtutSpaceballRotateFunc(void (*callback)(int x, int y, int z));
RTAPI void RTAPIENTRY rtutSpaceballButtonFunc(void (*callback)(int button, int state));
RTAPI void RTAPIENTRY rtutButtonBoxFunc(void (*callback)(int button, int state));
RTAPI void RTAPIENTRY rtutDialsFunc(void (*callback)(int dial, int value));
RTAPI void RTAPIENTRY rtutTabletMotionFunc(void (*callback)(int x, int y));
RTAPI void RTAPIENTRY rtutTabletButtonFunc(void (*callback)(int button, int state, int x, int y));

/* ---- Queries ---------------------------------------------------------------------------- */

/* Answers about windows, devices and the program. -1, and a message, for another query. Without a
 * window the RTUT_WINDOW_ values are 0, without a display, other than off-screen, the RTUT_SCREEN_
 * values. Since: 0.1 */
RTAPI int RTAPIENTRY rtutGet(RTenum query);
RTAPI int RTAPIENTRY rtutDeviceGet(RTenum query);
RTAPI int RTAPIENTRY rtutLayerGet(RTenum query);

/* Which of shift, control and alt were held; of the event whose callback is running, 0 elsewhere.
 * Since: 0.1 */
RTAPI int RTAPIENTRY rtutGetModifiers(void);

/* Whether RT_EXTENSIONS (rtGetString) of the current context names it. Since: 0.1 */
RTAPI int RTAPIENTRY rtutExtensionSupported(const char *extension);

/* Prints the errors of rtGetError on stderr, and so clears them.
 * Errors:  None.
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtutReportErrors(void);

/* Whether holding a key calls the callbacks again; it does at the start. Since: 0.1 */
RTAPI void RTAPIENTRY rtutIgnoreKeyRepeat(int ignore);
RTAPI void RTAPIENTRY rtutSetKeyRepeat(int repeatMode);

/* ---- Left out: menus, overlays, colour index, game mode, video ---------------------------- */

/* Menus, overlays, colour index, game mode, video: left out. rtutCreateMenu returns a number from
 * 1, the others 0, or -1 where GLUT has that.
 * Since: 0.1 */
RTAPI int RTAPIENTRY rtutCreateMenu(void (*callback)(int value));
RTAPI void RTAPIENTRY rtutDestroyMenu(int menu);
RTAPI int RTAPIENTRY rtutGetMenu(void);
RTAPI void RTAPIENTRY rtutSetMenu(int menu);
RTAPI void RTAPIENTRY rtutAddMenuEntry(const char *label, int value);
RTAPI void RTAPIENTRY rtutAddSubMenu(const char *label, int submenu);
RTAPI void RTAPIENTRY rtutChangeToMenuEntry(int item, const char *label, int value);
RTAPI void RTAPIENTRY rtutChangeToSubMenu(int item, const char *label, int submenu);
RTAPI void RTAPIENTRY rtutRemoveMenuItem(int item);
RTAPI void RTAPIENTRY rtutAttachMenu(int button);
RTAPI void RTAPIENTRY rtutDetachMenu(int button);
RTAPI void RTAPIENTRY rtutEstablishOverlay(void);
RTAPI void RTAPIENTRY rtutRemoveOverlay(void);
RTAPI void RTAPIENTRY rtutUseLayer(RTenum layer);
RTAPI void RTAPIENTRY rtutPostOverlayRedisplay(void);
RTAPI void RTAPIENTRY rtutPostWindowOverlayRedisplay(int window);
RTAPI void RTAPIENTRY rtutShowOverlay(void);
RTAPI void RTAPIENTRY rtutHideOverlay(void);
RTAPI void RTAPIENTRY rtutSetColor(int cell, RTfloat red, RTfloat green, RTfloat blue);
RTAPI RTfloat RTAPIENTRY rtutGetColor(int cell, int component);
RTAPI void RTAPIENTRY rtutCopyColormap(int window);
RTAPI void RTAPIENTRY rtutGameModeString(const char *string);
RTAPI int RTAPIENTRY rtutEnterGameMode(void);
RTAPI void RTAPIENTRY rtutLeaveGameMode(void);
RTAPI int RTAPIENTRY rtutGameModeGet(RTenum query);
RTAPI int RTAPIENTRY rtutVideoResizeGet(RTenum query);
RTAPI void RTAPIENTRY rtutSetupVideoResizing(void);
RTAPI void RTAPIENTRY rtutStopVideoResizing(void);
RTAPI void RTAPIENTRY rtutVideoResize(int x, int y, int width, int height);
RTAPI void RTAPIENTRY rtutVideoPan(int x, int y, int width, int height);

/* ---- Text ------------------------------------------------------------------------------- */

/* Draws a character at the raster position and moves that on, as rtBitmap does. Fonts
 * RTUT_BITMAP_..., codes 32 to 126 and 160 to 255 (Latin-1); others draw nothing and are 0 pixels
 * wide. Since: 0.1 */
RTAPI void RTAPIENTRY rtutBitmapCharacter(void *font, int character);
RTAPI int RTAPIENTRY rtutBitmapWidth(void *font, int character);
RTAPI int RTAPIENTRY rtutBitmapLength(void *font, const unsigned char *string);

/* Draws a character as line strips and translates the current matrix by its width. Fonts
 * RTUT_STROKE_ROMAN, Hershey's Roman Simplex with its own widths, capitals 100 units high, and
 * RTUT_STROKE_MONO_ROMAN, the same in cells 104.76 units wide; codes 32 to 127. From 33.33 units
 * below the base line to 119.05 above it. Since: 0.1 */
RTAPI void RTAPIENTRY rtutStrokeCharacter(void *font, int character);
RTAPI int RTAPIENTRY rtutStrokeWidth(void *font, int character);
RTAPI int RTAPIENTRY rtutStrokeLength(void *font, const unsigned char *string);

/* ---- Shapes ----------------------------------------------------------------------------- */

/* Draw a shape about the origin, with normals. Solid shapes are anticlockwise from outside, but for
 * the teapot, which is clockwise as GLUT's is and has texture coordinates. Sphere and cone (base in
 * z = 0, top at z = height, no cap) are rtuSphere's and rtuCylinder's; a torus
 * (inner: the radius of the tube, outer: of the ring) with sides or rings below 1 draws nothing,
 * and has 4096 of each at most. Circumscribed radii: dodecahedron sqrt(3), octahedron and
 * icosahedron 1, tetrahedron 3.
 * Errors:  RT_INVALID_VALUE  numbers that rtuSphere and rtuCylinder refuse: nothing is drawn
 * Since: 0.1 */
RTAPI void RTAPIENTRY rtutWireSphere(RTdouble radius, RTint slices, RTint stacks);
RTAPI void RTAPIENTRY rtutSolidSphere(RTdouble radius, RTint slices, RTint stacks);
RTAPI void RTAPIENTRY rtutWireCone(RTdouble base, RTdouble height, RTint slices, RTint stacks);
RTAPI void RTAPIENTRY rtutSolidCone(RTdouble base, RTdouble height, RTint slices, RTint stacks);
RTAPI void RTAPIENTRY rtutWireCube(RTdouble size);
RTAPI void RTAPIENTRY rtutSolidCube(RTdouble size);
RTAPI void RTAPIENTRY rtutWireTorus(RTdouble innerRadius, RTdouble outerRadius, RTint sides,
                                    RTint rings);
RTAPI void RTAPIENTRY rtutSolidTorus(RTdouble innerRadius, RTdouble outerRadius, RTint sides,
                                     RTint rings);
RTAPI void RTAPIENTRY rtutWireDodecahedron(void);
RTAPI void RTAPIENTRY rtutSolidDodecahedron(void);
RTAPI void RTAPIENTRY rtutWireOctahedron(void);
RTAPI void RTAPIENTRY rtutSolidOctahedron(void);
RTAPI void RTAPIENTRY rtutWireTetrahedron(void);
RTAPI void RTAPIENTRY rtutSolidTetrahedron(void);
RTAPI void RTAPIENTRY rtutWireIcosahedron(void);
RTAPI void RTAPIENTRY rtutSolidIcosahedron(void);
RTAPI void RTAPIENTRY rtutWireTeapot(RTdouble size);
RTAPI void RTAPIENTRY rtutSolidTeapot(RTdouble size);

#ifdef __cplusplus
}
#endif
#endif
