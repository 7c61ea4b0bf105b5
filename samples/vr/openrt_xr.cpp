// SPDX-License-Identifier: MIT
// openrt-xr: a scene in a head-mounted display, through an OpenXR runtime. Both eyes of a moment
// show the same frozen scene; the runtime says when the moment is and where the eyes are then.
#include <openrt/rt.h>
#include <openrt/rtu.h>

#include <cstdio>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <optional>
#include <vector>

#include "samples/tools/picture_window.h"
#include "samples/tools/scene_options.h"
#include "samples/vr/cave_room.h"
#include "samples/vr/headset_session.h"

namespace {

struct XrOptions : samples::SceneOptions {
    double scale = 1.0;
} options;

/// The eye in the scene: its pose in the room, at the scene's scale.
glm::dmat4 poseIn(const samples::CavePlace& place, const samples::HeadsetEye& eye) {
    const glm::dvec3 origin = place.toScene(eye.position);
    glm::dmat4 pose(1);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 unit(0);
        unit[axis] = 1;
        const glm::dvec3 tip = place.toScene(eye.position + eye.orientation * unit);
        pose[axis] = glm::dvec4((tip - origin) / options.scale, 0);
    }
    pose[3] = glm::dvec4(origin, 1);
    return pose;
}

/// The first eye's frame freezes the scene, the other's shows it again. Throws when both are over.
void render(const samples::RtScene& scene, const samples::CavePlace& place,
            const std::vector<samples::HeadsetEye>& eyes, samples::PictureSize size,
            std::vector<std::vector<uint8_t>>& pictures) {
    std::vector<RTuint> frames;
    for (std::size_t i = 0; i < eyes.size(); ++i) {
        rtSetFrameBuffer(pictures[i].data(), size.width, size.height, RT_RGBA_8);
        const samples::HeadsetEye& eye = eyes[i];
        rtuCameraFromFov(glm::value_ptr(poseIn(place, eye)), eye.left, eye.right, eye.up,
                         eye.down);
        if (frames.empty()) scene.describeWorld();
        frames.push_back(frames.empty() ? rtQueueFrame() : rtQueueView());
    }
    for (const RTuint frame : frames) rtWaitFrame(frame);
    samples::checkRt();
}

int run() {
    const samples::Lighting lighting = samples::lightingFrom(options);
    const std::optional<samples::View> wantedView = samples::viewFrom(options);
    if (!(options.scale > 0)) throw CLI::ValidationError("--scale is above 0");
    samples::Display display;
    samples::PictureWindow window(display, {320, 240}, "openrt-xr"); // its OpenGL is the runtime's
    samples::HeadsetSession session("openrt-xr");

    rtInit(nullptr, nullptr);
    samples::applySettings(options);
    rtEnable(RT_FRAMEBUFFER_SRGB);
    samples::Bounds bounds;
    const samples::SceneDescription description = samples::loadVisibleScene(options, bounds);
    samples::printNotes(description);
    const samples::View view =
        wantedView ? *wantedView : samples::defaultView(description, bounds, 1.0f);
    const samples::RtScene scene(description, bounds, view, lighting);
    const samples::CavePlace place(view, options.scale);
    rtFrameDepth(2);

    const samples::PictureSize size = session.pictureSize();
    std::vector<std::vector<uint8_t>> pictures(
        session.eyes(), std::vector<uint8_t>(std::size_t(size.width) * size.height * 4));
    uint32_t moments = 0;
    while (!window.wantsToClose() && session.poll()) {
        samples::Display::poll();
        if (!session.running()) continue;
        const std::vector<samples::HeadsetEye> eyes = session.beginFrame();
        if (!eyes.empty()) render(scene, place, eyes, size, pictures);
        session.endFrame(eyes, pictures);
        if (++moments == options.frames) break;
    }
    std::printf("%u moments of %zu views\n", moments, session.eyes());
    rtExit();
    return 0;
}

} // namespace

int main(int argc, char* argv[]) {
    CLI::App app("Shows a scene in a head-mounted display, through an OpenXR runtime.",
                 "openrt-xr");
    options.frames = 0;
    options.addRoomTo(app);
    options.addTo(app);
    app.add_option("--scale", options.scale, "units of the scene to the metre")
        ->capture_default_str();
    app.add_option("--frames", options.frames, "how many moments; 0: until the session ends")
        ->capture_default_str();
    return samples::runProgram(app, argc, argv, &run);
}
