// SPDX-License-Identifier: MIT
// openrt-view: a scene file in a window. Left button: orbit, middle or right: pan, wheel: zoom,
// R: back to the first view, Escape: leave.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <openrt/rt.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "samples/common/orbit_camera.h"
#include "samples/tools/picture_window.h"
#include "samples/tools/scene_options.h"

namespace {

using samples::PictureSize;
using Clock = std::chrono::steady_clock;

struct ViewOptions : samples::SceneOptions {
    ViewOptions() { frames = 0; }
} options;

/// What the mouse does to the camera. GLFW's callbacks write it, between frames, on one thread.
struct Controls {
    samples::OrbitCamera camera;
    double x = 0, y = 0;
    bool changed = true;
    Clock::time_point lastMove{};
};

Controls& controlsOf(GLFWwindow* window) {
    return *static_cast<Controls*>(glfwGetWindowUserPointer(window));
}

void onMove(GLFWwindow* window, double x, double y) {
    Controls& controls = controlsOf(window);
    int width = 1, height = 1;
    glfwGetWindowSize(window, &width, &height);
    const float right = float(x - controls.x) / float(std::max(height, 1));
    const float up = -float(y - controls.y) / float(std::max(height, 1));
    controls.x = x;
    controls.y = y;
    const auto held = [&](int button) { return glfwGetMouseButton(window, button) == GLFW_PRESS; };
    if (held(GLFW_MOUSE_BUTTON_LEFT)) {
        constexpr float kTurn = 3.14159265f; // across the window's height
        controls.camera.orbit(right * kTurn, -up * kTurn);
    } else if (held(GLFW_MOUSE_BUTTON_MIDDLE) || held(GLFW_MOUSE_BUTTON_RIGHT)) {
        controls.camera.pan(right, up);
    } else {
        return;
    }
    controls.changed = true;
    controls.lastMove = Clock::now();
}

void onScroll(GLFWwindow* window, double, double steps) {
    Controls& controls = controlsOf(window);
    controls.camera.zoom(std::pow(1.1f, float(steps)));
    controls.changed = true;
    controls.lastMove = Clock::now();
}

void onKey(GLFWwindow* window, int key, int, int action, int) {
    if (action != GLFW_PRESS) return;
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window, GLFW_TRUE);
    if (key == GLFW_KEY_R) {
        controlsOf(window).camera.reset();
        controlsOf(window).changed = true;
    }
}

void onResize(GLFWwindow* window, int, int) { controlsOf(window).changed = true; }

/// Mouse and keyboard go to the controls.
void connect(const samples::PictureWindow& window, Controls& controls) {
    glfwSetWindowUserPointer(window.handle(), &controls);
    glfwSetCursorPosCallback(window.handle(), &onMove);
    glfwSetScrollCallback(window.handle(), &onScroll);
    glfwSetKeyCallback(window.handle(), &onKey);
    glfwSetFramebufferSizeCallback(window.handle(), &onResize);
}

/// Renders one picture while the one before is shown.
class FrameLoop {
public:
    /// findFocus: the camera is to circle around what the middle of the first picture shows.
    FrameLoop(samples::PictureWindow& window, Controls& controls, const samples::RtScene& scene,
              bool findFocus)
        : window_(window), controls_(controls), scene_(scene), findFocus_(findFocus) {}
    ~FrameLoop() {
        if (inFlight_) rtEndRendering(); // into a picture of this loop
    }
    FrameLoop(const FrameLoop&) = delete;
    FrameLoop& operator=(const FrameLoop&) = delete;

    void run() {
        while (!window_.wantsToClose()) {
            samples::Display::poll();
            chooseDivisor();
            if (!controls_.changed && options.frames == 0) {
                finish();
                glfwWaitEventsTimeout(0.2);
                continue;
            }
            start();
            if (shown_.size.width > 0) window_.draw(shown_.size, shown_.rgba);
            finish();
            if (options.frames > 0 && ++rendered_ >= options.frames) break;
        }
    }

private:
    struct Picture {
        PictureSize size{0, 0};
        std::vector<uint8_t> rgba;
    };

    /// Coarser pixels while the view moves and full ones are too slow; full ones at rest.
    void chooseDivisor() {
        using namespace std::chrono_literals;
        constexpr double kSmooth = 1.0 / 15;
        const bool moving = Clock::now() - controls_.lastMove < 250ms;
        const double fullSeconds = seconds_ * double(divisor_) * double(divisor_);
        uint32_t wanted = 1;
        while (moving && wanted < 8 && fullSeconds / (wanted * wanted) > kSmooth) wanted *= 2;
        if (wanted == divisor_) return;
        divisor_ = wanted;
        controls_.changed = true;
    }

    void start() {
        controls_.changed = false;
        const PictureSize whole = window_.pixels();
        next_.size = {std::max(whole.width / divisor_, 1u), std::max(whole.height / divisor_, 1u)};
        next_.rgba.resize(std::size_t(next_.size.width) * next_.size.height * 4);
        rtSetFrameBuffer(next_.rgba.data(), next_.size.width, next_.size.height, RT_RGBA_8);
        scene_.describeFrame(controls_.camera.view(), whole.aspect());
        if (std::exchange(findFocus_, false)) focus();
        samples::checkRt();
        startTime_ = Clock::now();
        rtStartRendering();
        samples::checkRt();
        inFlight_ = true;
    }

    /// Shoots a ray through the middle of the scene that was just described.
    void focus() {
        const samples::View& view = controls_.camera.view();
        const glm::vec3 forward = glm::normalize(view.target - view.eye);
        const RTray ray{{view.eye.x, view.eye.y, view.eye.z}, 0.0f,
                        {forward.x, forward.y, forward.z},
                        std::numeric_limits<float>::infinity()};
        RThit hit{};
        const RTuint compiled = rtCompileScene();
        rtIntersect(compiled, &ray, &hit, 1, RT_INCOHERENT);
        rtReleaseScene(compiled);
        samples::checkRt();
        if (std::isfinite(hit.t) && hit.t > 0.0f) controls_.camera.focus(hit.t);
    }

    void finish() {
        if (!inFlight_) return;
        samples::endFrame();
        inFlight_ = false;
        seconds_ = std::chrono::duration<double>(Clock::now() - startTime_).count();
        std::swap(shown_, next_);
        window_.draw(shown_.size, shown_.rgba);
        showRate();
    }

    void showRate() {
        using namespace std::chrono_literals;
        smoothed_ = smoothed_ > 0 ? 0.8 * smoothed_ + 0.2 * seconds_ : seconds_;
        if (Clock::now() - titleTime_ < 250ms) return;
        titleTime_ = Clock::now();
        char title[160];
        std::snprintf(title, sizeof title, "openrt-view - %.1f frames/s, %.1f ms, %u x %u",
                      1.0 / smoothed_, smoothed_ * 1e3, shown_.size.width, shown_.size.height);
        glfwSetWindowTitle(window_.handle(), title);
    }

    samples::PictureWindow& window_;
    Controls& controls_;
    const samples::RtScene& scene_;
    Picture shown_, next_;
    Clock::time_point startTime_{}, titleTime_{};
    double seconds_ = 0, smoothed_ = 0;
    uint32_t divisor_ = 1, rendered_ = 0;
    bool inFlight_ = false, findFocus_;
};

int run() {
    const PictureSize size = samples::sizeFrom(options);
    const samples::Lighting lighting = samples::lightingFrom(options);
    const std::optional<samples::View> wantedView = samples::viewFrom(options);
    rtInit(nullptr, nullptr);
    samples::applySettings(options);
    samples::Bounds bounds;
    const samples::SceneDescription description = samples::loadVisibleScene(options, bounds);
    samples::printNotes(description);

    Controls controls{samples::OrbitCamera(
        wantedView ? *wantedView : samples::defaultView(description, bounds, size.aspect()))};
    const samples::Display display;
    samples::PictureWindow window(display, size, "openrt-view");
    connect(window, controls);
    const samples::RtScene scene(description, bounds, controls.camera.view(), lighting);
    rtEnable(RT_FRAMEBUFFER_SRGB);
    FrameLoop(window, controls, scene, !wantedView && !description.cameras.empty()).run();
    rtExit();
    return 0;
}

} // namespace

int main(int argc, char* argv[]) {
    CLI::App app("Shows a scene file in a window. Left button: orbit, middle or right button: "
                 "pan, wheel: zoom, R: first view, Escape: leave.",
                 "openrt-view");
    options.addSizeTo(app);
    options.addViewTo(app);
    options.addEnvironmentTo(app);
    options.addTo(app);
    app.add_option("--frames", options.frames,
                   "renders without pause and leaves after so many pictures");
    return samples::runProgram(app, argc, argv, &run);
}
