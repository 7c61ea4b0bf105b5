// SPDX-License-Identifier: MIT
#pragma once

#include <openrt/rt.h>

#include <array>
#include <vector>

#include "samples/common/environment_file.h"
#include "samples/common/scene_description.h"
#include "samples/common/view.h"

namespace samples {

/// How a scene is lit beyond what its file says.
struct Lighting {
    std::vector<glm::vec3> pointLights; ///< added to those of the file
    float exposure = 1.0f;              ///< factor on all light
    Environment environment;            ///< in the place of a sky, if it has pixels
};

/// Shaders in the place of what the scene says; 0: none. The lights are beside those of the scene.
struct FrameShaders {
    RTuint surface = 0, camera = 0, environment = 0, renderingObject = 0;
    std::vector<RTuint> lights;
};

/// A scene description as objects, shaders and textures of the current OpenRT context, which
/// must outlive it. Throws std::runtime_error with the library's text if a call failed.
class RtScene {
public:
    /// `view`: where it will be seen from first; places the light of a scene that has none.
    RtScene(const SceneDescription& scene, const Bounds& bounds, const View& view,
            const Lighting& lighting);

    /// Gives the next frame its instances, lights and sky.
    void describeWorld(const FrameShaders& shaders = {}) const;
    /// The camera too.
    void describeFrame(const View& view, float aspect, const FrameShaders& shaders = {}) const;

private:
    struct Instance {
        RTuint object;
        double matrix[16];
    };

    RTuint texture(const SceneDescription& scene, int index, bool srgb);
    RTuint surface(const SceneDescription& scene, const MaterialDescription& material);
    /// `mirrored`: some instance turns the winding of its triangles.
    RTuint object(const MeshDescription& mesh, bool mirrored, const std::vector<RTuint>& shaders);
    void useCamera(const View& view, float aspect) const;
    void addLights(const SceneDescription& scene, const Bounds& bounds, const View& view,
                   const Lighting& lighting);
    void addSky(const Environment& environment);

    std::vector<std::array<RTuint, 2>> textures_; ///< by index: [0] linear, [1] sRGB; 0 = not made
    std::vector<Instance> instances_;
    std::vector<RTuint> lights_;
    RTuint sky_ = 0, perspective_ = 0, orthographic_ = 0;
    float exposure_;
};

/// Throws std::runtime_error with the library's text if a call since the last check failed.
void checkRt();

/// Waits for the frame in flight, and throws as checkRt does. Pixels in which a shader failed are
/// no reason to: they are black, and counted (RT_STAT_BAD_PIXELS).
void endFrame();

} // namespace samples
