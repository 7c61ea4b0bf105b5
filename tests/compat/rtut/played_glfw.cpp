// SPDX-License-Identifier: MIT
#include "tests/compat/rtut/played_glfw.h"

#include <GL/gl.h>

#include <algorithm>

namespace rtut::test {

PlayedWindow playedWindow;
bool hasDisplay = true, hasMonitor = true, opensWindows = true;
std::vector<std::string> playedCalls;

bool endWith(const std::vector<std::string>& calls) {
    return calls.size() <= playedCalls.size() &&
           std::equal(calls.rbegin(), calls.rend(), playedCalls.rbegin());
}

namespace {

GLFWerrorfun onError = nullptr;
int monitor; ///< its address is the monitor's

template <class... Numbers>
void note(const char* what, Numbers... numbers) {
    std::string line = what;
    ((line += ' ' + std::to_string(int(numbers))), ...);
    playedCalls.push_back(line);
}

} // namespace
} // namespace rtut::test

using namespace rtut::test;

extern "C" {

GLFWerrorfun glfwSetErrorCallback(GLFWerrorfun callback) {
    onError = callback;
    return nullptr;
}
int glfwInit(void) {
    if (!hasDisplay) onError(1, "it is played");
    return hasDisplay;
}
void glfwDefaultWindowHints(void) {}
GLFWwindow* glfwCreateWindow(int width, int height, const char* title, GLFWmonitor*, GLFWwindow*) {
    if (!opensWindows) onError(1, "there is no room");
    playedWindow = {};
    playedWindow.width = width;
    playedWindow.height = height;
    playedCalls = {std::string("open ") + title};
    return opensWindows ? handle() : nullptr;
}
void glfwDestroyWindow(GLFWwindow*) {
    note("destroy");
}
void glfwSetWindowUserPointer(GLFWwindow*, void* user) {
    playedWindow.user = user;
}
void* glfwGetWindowUserPointer(GLFWwindow*) {
    return playedWindow.user;
}
void glfwMakeContextCurrent(GLFWwindow*) {}
void glfwSwapInterval(int) {}
void glfwSwapBuffers(GLFWwindow*) {
    note("swap");
}
void glfwGetFramebufferSize(GLFWwindow*, int* width, int* height) {
    *width = playedWindow.width;
    *height = playedWindow.height;
}
void glfwSetWindowTitle(GLFWwindow*, const char* title) {
    playedCalls.push_back(std::string("title ") + title);
}
void glfwSetWindowSize(GLFWwindow*, int width, int height) {
    note("size", width, height);
}
void glfwSetWindowPos(GLFWwindow*, int x, int y) {
    note("place", x, y);
}
void glfwShowWindow(GLFWwindow*) {
    note("show");
}
void glfwHideWindow(GLFWwindow*) {
    note("hide");
}
void glfwRestoreWindow(GLFWwindow*) {
    note("restore");
}
void glfwIconifyWindow(GLFWwindow*) {
    note("iconify");
}
void glfwFocusWindow(GLFWwindow*) {
    note("focus");
}
GLFWmonitor* glfwGetPrimaryMonitor(void) {
    return hasMonitor ? reinterpret_cast<GLFWmonitor*>(&monitor) : nullptr;
}
const GLFWvidmode* glfwGetVideoMode(GLFWmonitor*) {
    static const GLFWvidmode mode = {1280, 1024, 8, 8, 8, 60};
    return &mode;
}
void glfwGetMonitorPhysicalSize(GLFWmonitor*, int* width, int* height) {
    *width = 340;
    *height = 270;
}
GLFWmonitor* glfwGetWindowMonitor(GLFWwindow*) {
    return playedWindow.isFullScreen ? glfwGetPrimaryMonitor() : nullptr;
}
void glfwSetWindowMonitor(GLFWwindow*, GLFWmonitor* on, int, int, int width, int height, int) {
    playedWindow.isFullScreen = on != nullptr;
    note(on ? "full screen" : "no full screen", width, height);
}
void glfwSetCursorPos(GLFWwindow*, double x, double y) {
    note("warp", x, y);
}
void glfwSetInputMode(GLFWwindow*, int, int value) {
    note("pointer shown", value == GLFW_CURSOR_NORMAL);
}
GLFWcursor* glfwCreateStandardCursor(int shape) {
    note("make cursor", shape);
    static int cursors[16];
    return reinterpret_cast<GLFWcursor*>(&cursors[shape - GLFW_ARROW_CURSOR]);
}
void glfwSetCursor(GLFWwindow*, GLFWcursor*) {
    note("cursor");
}
int glfwGetMouseButton(GLFWwindow*, int button) {
    return button == playedWindow.pressedButton;
}
void glfwWaitEventsTimeout(double seconds) {
    note("wait", seconds * 1000);
}
void glfwPollEvents(void) {
    note("poll");
}

#define PLAYED(function, type, member)          \
    type function(GLFWwindow*, type callback) { \
        playedWindow.member = callback;         \
        return nullptr;                         \
    }
PLAYED(glfwSetFramebufferSizeCallback, GLFWframebuffersizefun, resized)
PLAYED(glfwSetWindowPosCallback, GLFWwindowposfun, moved)
PLAYED(glfwSetWindowRefreshCallback, GLFWwindowrefreshfun, exposed)
PLAYED(glfwSetWindowCloseCallback, GLFWwindowclosefun, closed)
PLAYED(glfwSetWindowIconifyCallback, GLFWwindowiconifyfun, iconified)
PLAYED(glfwSetCursorEnterCallback, GLFWcursorenterfun, entered)
PLAYED(glfwSetCursorPosCallback, GLFWcursorposfun, pointer)
PLAYED(glfwSetMouseButtonCallback, GLFWmousebuttonfun, button)
PLAYED(glfwSetScrollCallback, GLFWscrollfun, wheel)
PLAYED(glfwSetKeyCallback, GLFWkeyfun, key)
PLAYED(glfwSetCharCallback, GLFWcharfun, character)
#undef PLAYED

void glGenTextures(GLsizei, GLuint* names) {
    *names = 1;
}
void glBindTexture(GLenum, GLuint) {}
void glTexParameteri(GLenum, GLenum, GLint) {}
void glTexEnvi(GLenum, GLenum, GLint) {}
void glEnable(GLenum) {}
void glViewport(GLint, GLint, GLsizei width, GLsizei height) {
    note("viewport", width, height);
}
void glTexImage2D(GLenum, GLint, GLint, GLsizei width, GLsizei height, GLint, GLenum, GLenum,
                  const void* pixels) {
    note("picture", width, height, *static_cast<const unsigned char*>(pixels));
}
void glBegin(GLenum) {}
void glEnd(void) {}
void glTexCoord2f(GLfloat x, GLfloat y) {
    note("texel", x, y);
}
void glVertex2f(GLfloat x, GLfloat y) {
    note("corner", x, y);
}

} // extern "C"
