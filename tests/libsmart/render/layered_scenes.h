// SPDX-License-Identifier: MIT
// Frames of flat rectangles with state blocks, seen orthographically: one unit is one pixel.
#pragma once

#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <utility>
#include <vector>

#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {

using StateChange = std::function<void(FixedState&)>;

inline std::shared_ptr<const FixedState> stateWith(const StateChange& change) {
    auto state = std::make_shared<FixedState>();
    change(*state);
    return state;
}

/// A surface of one colour.
inline std::shared_ptr<const ShaderObject> flat(const glm::vec4& color) {
    return makeSurface([color](RTSstate* s) {
        for (int k = 0; k < 4; ++k) s->result[k] = color[k];
        return 0;
    });
}

/// Instances whose i-th has shader i + 1, of one colour.
class FlatScene {
public:
    void add(std::vector<Triangle> triangles, const glm::vec4& color,
             std::shared_ptr<const FixedState> state = nullptr,
             const glm::dmat4x3& toParent = glm::dmat4x3(1.0)) {
        shaders_.push_back(flat(color));
        Instance instance = placeWithShader(makeModel(std::move(triangles)),
                                            uint32_t(shaders_.size()) - 1, toParent);
        instance.state = std::move(state);
        instances_.push_back(std::move(instance));
    }

    ScenePtr scene(bool lastOfEqual = false) const {
        return std::make_shared<const Scene>(instances_, Precision::Watertight, 1u, lastOfEqual);
    }
    const std::vector<std::shared_ptr<const ShaderObject>>& shaders() const { return shaders_; }
    /// Seen with z from -100 (the far plane) to 100.
    Picture picture(uint32_t width, uint32_t height) const {
        Picture picture(width, height, scene(), shaders_);
        picture.frame->matrixCamera = pixelCamera(width, height);
        return picture;
    }
    /// A layer below a picture's frame, with its size.
    std::shared_ptr<Frame> layer(const Picture& under) const {
        const Frame& top = *under.frame;
        auto frame = std::make_shared<Frame>();
        frame->scene = scene();
        frame->shaders = std::make_shared<const ShaderTable>(shaders_);
        frame->viewport = top.viewport;
        frame->matrixCamera = top.matrixCamera;
        frame->clearColor = top.clearColor;
        frame->target = top.target;
        return frame;
    }
    static MatrixCamera pixelCamera(uint32_t width, uint32_t height) {
        return cameraOf(glm::ortho(0.0, double(width), 0.0, double(height), -100.0, 100.0));
    }

private:
    std::vector<Instance> instances_;
    std::vector<std::shared_ptr<const ShaderObject>> shaders_{flat(glm::vec4(1.0f))};
};

inline void blendOver(FixedState& state) {
    state.ops.blend = true;
    state.ops.sourceRgb = state.ops.sourceAlpha = BlendFactor::SourceAlpha;
    state.ops.destinationRgb = state.ops.destinationAlpha = BlendFactor::OneMinusSourceAlpha;
}

/// Window depth of the pixel camera.
inline double depthOf(double z) {
    return (100.0 - z) / 200.0;
}

} // namespace smart::test
