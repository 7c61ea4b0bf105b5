// SPDX-License-Identifier: MIT
// GLFW and OpenGL as far as rtut's screen calls them, played: no display is needed.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <string>
#include <vector>

namespace rtut::test {

/// What a window has told GLFW to call, and what it looks like.
struct PlayedWindow {
    void* user = nullptr;
    int width = 0, height = 0;
    bool isFullScreen = false;
    int pressedButton = -1;
    GLFWframebuffersizefun resized = nullptr;
    GLFWwindowposfun moved = nullptr;
    GLFWwindowrefreshfun exposed = nullptr;
    GLFWwindowclosefun closed = nullptr;
    GLFWwindowiconifyfun iconified = nullptr;
    GLFWcursorenterfun entered = nullptr;
    GLFWcursorposfun pointer = nullptr;
    GLFWmousebuttonfun button = nullptr;
    GLFWscrollfun wheel = nullptr;
    GLFWkeyfun key = nullptr;
    GLFWcharfun character = nullptr;
};

extern PlayedWindow playedWindow;
inline GLFWwindow* handle() {
    return reinterpret_cast<GLFWwindow*>(&playedWindow);
}

extern bool hasDisplay, hasMonitor, opensWindows;
/// Calls that have an effect, with their numbers.
extern std::vector<std::string> playedCalls;
/// Whether the calls end with these.
bool endWith(const std::vector<std::string>& calls);

} // namespace rtut::test
