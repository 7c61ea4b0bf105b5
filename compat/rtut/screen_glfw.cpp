// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GL/gl.h>
#include <GLFW/glfw3.h>

#include <algorithm>
#include <map>
#include <string>

#include "compat/rtut/messages.h"
#include "compat/rtut/screen.h"
#include "openrt/rtut_enums.h"

namespace rtut {

namespace {

std::string lastError = "no reason is known";

/// Whether there is a display.
bool startGlfw() {
    static const bool started = [] {
        glfwSetErrorCallback([](int, const char* text) { lastError = text; });
        return glfwInit() == GLFW_TRUE;
    }();
    return started;
}

int modifiersOf(int mods) {
    return (mods & GLFW_MOD_SHIFT ? RTUT_ACTIVE_SHIFT : 0) |
           (mods & GLFW_MOD_CONTROL ? RTUT_ACTIVE_CTRL : 0) |
           (mods & GLFW_MOD_ALT ? RTUT_ACTIVE_ALT : 0);
}

/// GLUT's number of a key that stands for no character; 0: it has none.
int specialKey(int key) {
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return RTUT_KEY_F1 + key - GLFW_KEY_F1;
    switch (key) {
    case GLFW_KEY_LEFT: return RTUT_KEY_LEFT;
    case GLFW_KEY_UP: return RTUT_KEY_UP;
    case GLFW_KEY_RIGHT: return RTUT_KEY_RIGHT;
    case GLFW_KEY_DOWN: return RTUT_KEY_DOWN;
    case GLFW_KEY_PAGE_UP: return RTUT_KEY_PAGE_UP;
    case GLFW_KEY_PAGE_DOWN: return RTUT_KEY_PAGE_DOWN;
    case GLFW_KEY_HOME: return RTUT_KEY_HOME;
    case GLFW_KEY_END: return RTUT_KEY_END;
    case GLFW_KEY_INSERT: return RTUT_KEY_INSERT;
    default: return 0;
    }
}

/// The character of a key for which the window system sends none; 0: it has none.
unsigned char controlCharacter(int key, int mods) {
    if ((mods & GLFW_MOD_CONTROL) && key >= GLFW_KEY_A && key <= GLFW_KEY_Z)
        return static_cast<unsigned char>(key - GLFW_KEY_A + 1);
    switch (key) {
    case GLFW_KEY_ESCAPE: return 27;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return 13;
    case GLFW_KEY_TAB: return 9;
    case GLFW_KEY_BACKSPACE: return 8;
    case GLFW_KEY_DELETE: return 127;
    default: return 0;
    }
}

int standardCursor(int cursor) {
    switch (cursor) {
    case RTUT_CURSOR_INFO:
    case RTUT_CURSOR_HELP: return GLFW_HAND_CURSOR;
    case RTUT_CURSOR_TEXT: return GLFW_IBEAM_CURSOR;
    case RTUT_CURSOR_CROSSHAIR:
    case RTUT_CURSOR_FULL_CROSSHAIR: return GLFW_CROSSHAIR_CURSOR;
    case RTUT_CURSOR_UP_DOWN:
    case RTUT_CURSOR_TOP_SIDE:
    case RTUT_CURSOR_BOTTOM_SIDE: return GLFW_VRESIZE_CURSOR;
    case RTUT_CURSOR_LEFT_RIGHT:
    case RTUT_CURSOR_LEFT_SIDE:
    case RTUT_CURSOR_RIGHT_SIDE: return GLFW_HRESIZE_CURSOR;
    default: return GLFW_ARROW_CURSOR;
    }
}

class GlfwSurface final : public Surface {
public:
    GlfwSurface(const char* title, Size size, const Place* place, SurfaceEvents& events)
        : events_(events) {
        glfwDefaultWindowHints();
        window_ = glfwCreateWindow(size.width, size.height, title, nullptr, nullptr);
        if (!window_) endProgram(1, "no window can be opened: ", lastError.c_str());
        if (place) glfwSetWindowPos(window_, place->x, place->y);
        glfwSetWindowUserPointer(window_, this);
        listen();
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(0);
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        glEnable(GL_TEXTURE_2D);
    }
    ~GlfwSurface() override {
        glfwDestroyWindow(window_); // the texture goes with its context
    }
    GlfwSurface(const GlfwSurface&) = delete;
    GlfwSurface& operator=(const GlfwSurface&) = delete;

    void show(const Picture& picture) override {
        const Size whole = pixels();
        glfwMakeContextCurrent(window_);
        glViewport(0, 0, whole.width, whole.height);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, picture.size.width, picture.size.height, 0,
                     GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
        glBegin(GL_TRIANGLE_STRIP);
        for (int corner = 0; corner < 4; ++corner) {
            const float x = float(corner & 1), y = float(corner >> 1);
            glTexCoord2f(x, y);
            glVertex2f(2 * x - 1, 2 * y - 1);
        }
        glEnd();
        glfwSwapBuffers(window_);
    }
    Size pixels() const override {
        Size size{1, 1};
        glfwGetFramebufferSize(window_, &size.width, &size.height);
        return {std::max(size.width, 1), std::max(size.height, 1)};
    }
    void setTitle(const char* title) override { glfwSetWindowTitle(window_, title); }
    void setSize(Size size) override {
        if (glfwGetWindowMonitor(window_))
            glfwSetWindowMonitor(window_, nullptr, 100, 100, size.width, size.height, 0);
        else
            glfwSetWindowSize(window_, size.width, size.height);
    }
    void setPlace(Place place) override { glfwSetWindowPos(window_, place.x, place.y); }
    void setVisible(bool visible) override {
        if (!visible) return glfwHideWindow(window_);
        glfwRestoreWindow(window_);
        glfwShowWindow(window_);
    }
    void iconify() override { glfwIconifyWindow(window_); }
    void raise() override { glfwFocusWindow(window_); }
    void fullScreen() override {
        GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
        const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
        if (mode) glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, 0);
    }
    void warpPointer(Place place) override { glfwSetCursorPos(window_, place.x, place.y); }
    void setCursor(int cursor) override {
        static std::map<int, GLFWcursor*> cursors; // the system frees them with itself
        glfwSetInputMode(window_, GLFW_CURSOR,
                         cursor == RTUT_CURSOR_NONE ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
        const int shape = standardCursor(cursor);
        auto [place, isNew] = cursors.emplace(shape, nullptr);
        if (isNew) place->second = glfwCreateStandardCursor(shape);
        glfwSetCursor(window_, place->second);
    }

private:
    static GlfwSurface& of(GLFWwindow* window) {
        return *static_cast<GlfwSurface*>(glfwGetWindowUserPointer(window));
    }
    static SurfaceEvents& eventsOf(GLFWwindow* window) { return of(window).events_; }

    void listen() {
        glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int width, int height) {
            if (width > 0 && height > 0) eventsOf(w).resized({width, height});
        });
        glfwSetWindowPosCallback(
            window_, [](GLFWwindow* w, int x, int y) { eventsOf(w).moved({x, y}); });
        glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { eventsOf(w).exposed(); });
        glfwSetWindowCloseCallback(window_, [](GLFWwindow* w) { eventsOf(w).closed(); });
        glfwSetWindowIconifyCallback(
            window_, [](GLFWwindow* w, int iconified) { eventsOf(w).shown(!iconified); });
        glfwSetCursorEnterCallback(
            window_, [](GLFWwindow* w, int inside) { eventsOf(w).entered(inside != 0); });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) {
            bool pressed = false;
            for (int button = GLFW_MOUSE_BUTTON_1; button <= GLFW_MOUSE_BUTTON_3; ++button)
                pressed = pressed || glfwGetMouseButton(w, button) == GLFW_PRESS;
            eventsOf(w).pointer({int(x), int(y)}, pressed);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
            if (button > GLFW_MOUSE_BUTTON_3) return;
            const int numbers[] = {RTUT_LEFT_BUTTON, RTUT_RIGHT_BUTTON, RTUT_MIDDLE_BUTTON};
            eventsOf(w).button(numbers[button], action == GLFW_PRESS, modifiersOf(mods));
        });
        glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double steps) {
            // Wheels are the buttons 3 and 4 of X.
            const int button = steps > 0 ? 3 : 4;
            eventsOf(w).button(button, true, 0);
            eventsOf(w).button(button, false, 0);
        });
        glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int mods) {
            of(w).onKey(key, action, mods);
        });
        glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned code) { of(w).onCharacter(code); });
    }

    void onKey(int key, int action, int mods) {
        const int modifiers = modifiersOf(mods);
        if (action == GLFW_RELEASE) {
            if (const int special = specialKey(key)) events_.special(special, false, modifiers);
            const auto held = held_.find(key);
            if (held == held_.end()) return;
            const unsigned char character = held->second;
            held_.erase(held);
            return events_.character(character, false, modifiers);
        }
        if (action == GLFW_REPEAT && !events_.wantsRepeat()) {
            pressed_ = GLFW_KEY_UNKNOWN;
            return;
        }
        pressed_ = key;
        modifiers_ = modifiers;
        if (const int special = specialKey(key)) return events_.special(special, true, modifiers);
        if (const unsigned char character = controlCharacter(key, mods)) {
            held_[key] = character;
            events_.character(character, true, modifiers);
        }
    }
    /// Comes after the key that it belongs to.
    void onCharacter(unsigned code) {
        if (code > 255 || pressed_ == GLFW_KEY_UNKNOWN) return;
        held_[pressed_] = static_cast<unsigned char>(code);
        events_.character(static_cast<unsigned char>(code), true, modifiers_);
    }

    GLFWwindow* window_ = nullptr;
    SurfaceEvents& events_;
    int pressed_ = GLFW_KEY_UNKNOWN, modifiers_ = 0;
    std::map<int, unsigned char> held_; ///< characters by the keys that are down
};

} // namespace

std::unique_ptr<Surface> openSurface(const char* title, Size size, const Place* place,
                                     SurfaceEvents& events) {
    if (!startGlfw()) endProgram(1, "there is no display: ", lastError.c_str());
    return std::make_unique<GlfwSurface>(title, size, place, events);
}

void waitForEvents(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
}

ScreenSize screenSize() {
    ScreenSize size{{0, 0}, {0, 0}};
    GLFWmonitor* const monitor = startGlfw() ? glfwGetPrimaryMonitor() : nullptr;
    if (!monitor) return size;
    if (const GLFWvidmode* const mode = glfwGetVideoMode(monitor))
        size.pixels = {mode->width, mode->height};
    glfwGetMonitorPhysicalSize(monitor, &size.millimetres.width, &size.millimetres.height);
    return size;
}

} // namespace rtut
