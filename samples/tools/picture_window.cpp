// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include "samples/tools/picture_window.h"

#include <GL/gl.h>
#include <GLFW/glfw3.h>

#include <algorithm>
#include <stdexcept>

namespace samples {

namespace {

std::string& lastError() {
    static std::string text;
    return text;
}

} // namespace

Display::Display() {
    glfwSetErrorCallback([](int, const char* text) { lastError() = text; });
    if (!glfwInit()) throw std::runtime_error("there is no display: " + lastError());
}

Display::~Display() { glfwTerminate(); }

void Display::poll() { glfwPollEvents(); }

PictureWindow::PictureWindow(const Display&, PictureSize size, const std::string& title)
    : window_(glfwCreateWindow(int(size.width), int(size.height), title.c_str(), nullptr,
                               nullptr)) {
    if (!window_) throw std::runtime_error("no window can be opened: " + lastError());
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(0);
    GLuint texture = 0; // of this window's OpenGL, which frees it
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glEnable(GL_TEXTURE_2D);
}

PictureWindow::~PictureWindow() { glfwDestroyWindow(window_); }

PictureSize PictureWindow::pixels() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    return {uint32_t(std::max(width, 1)), uint32_t(std::max(height, 1))};
}

bool PictureWindow::wantsToClose() const { return glfwWindowShouldClose(window_); }

void PictureWindow::draw(PictureSize size, const std::vector<uint8_t>& rgba) {
    glfwMakeContextCurrent(window_);
    const PictureSize whole = pixels();
    glViewport(0, 0, GLsizei(whole.width), GLsizei(whole.height));
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, GLsizei(size.width), GLsizei(size.height), 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, rgba.data());
    glBegin(GL_TRIANGLE_STRIP);
    for (int corner = 0; corner < 4; ++corner) {
        const float x = float(corner & 1), y = float(corner >> 1);
        glTexCoord2f(x, y);
        glVertex2f(2 * x - 1, 2 * y - 1);
    }
    glEnd();
    glfwSwapBuffers(window_);
}

} // namespace samples
