// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "samples/tools/scene_options.h"

struct GLFWwindow;

namespace samples {

/// GLFW, as long as there are windows. One at a time.
class Display {
public:
    /// Throws std::runtime_error with the reason.
    Display();
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    /// Lets events reach the windows.
    static void poll();
};

/// A window that shows a picture as the texture of one rectangle. Used by the main thread.
class PictureWindow {
public:
    /// Throws std::runtime_error with the reason.
    PictureWindow(const Display& display, PictureSize size, const std::string& title);
    ~PictureWindow();
    PictureWindow(const PictureWindow&) = delete;
    PictureWindow& operator=(const PictureWindow&) = delete;

    GLFWwindow* handle() const { return window_; }
    /// Of what it shows, not of its frame.
    PictureSize pixels() const;
    bool wantsToClose() const;
    /// RGBA pixels, rows from the bottom, over the whole window.
    void draw(PictureSize size, const std::vector<uint8_t>& rgba);

private:
    GLFWwindow* window_;
};

} // namespace samples
