// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "samples/tools/scene_options.h"

namespace samples {

/// An eye as the runtime predicts it: in metres from the middle of the room's floor, and the
/// angles of its field of view in radians, left and down negative.
struct HeadsetEye {
    glm::dvec3 position{0.0};
    glm::dquat orientation{1, 0, 0, 0};
    double left = 0, right = 0, up = 0, down = 0;
};

/// An OpenXR session with a head-mounted display (OpenXR 1.0, The Khronos Group, 2019) that shows
/// pictures of the OpenGL context which is current when it is made.
class HeadsetSession {
public:
    /// Throws std::runtime_error with what is missing: a runtime, OpenGL in it, a display.
    explicit HeadsetSession(const std::string& application);
    ~HeadsetSession();

    /// As many as the display shows, with the size that the runtime recommends.
    std::size_t eyes() const;
    PictureSize pictureSize() const;

    /// Takes what the runtime has to tell. false: the session is over.
    bool poll();
    /// Whether frames are wanted now.
    bool running() const;
    /// Waits for the next moment; the eyes then, or none if it will not be seen.
    std::vector<HeadsetEye> beginFrame();
    /// Shows RGBA pictures, rows from the bottom, seen by these eyes; none: nothing.
    void endFrame(const std::vector<HeadsetEye>& eyes,
                  const std::vector<std::vector<uint8_t>>& pictures);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace samples
