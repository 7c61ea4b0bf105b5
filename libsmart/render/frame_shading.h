// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "libsmart/scene/scene.h"
#include "libsmart/shading/builtin/lights.h"
#include "libsmart/shading/shader_object.h"

namespace smart {

/// One of the samples that a light is split into; shaders take each for a light.
struct LightPart {
    const ShaderObject* light;
    uint32_t sample, samples;
    /// Of a built-in point light, nullptr otherwise.
    const builtin::PointLight* point;
};

/// A light that asks to be split into more samples than this is split into so many.
inline constexpr uint32_t kMaxLightSamples = 4096;

/// What the shaders of a frame amount to.
struct FrameShading {
    /// The surface shaders that some triangle of the scene has, in the order of their indices.
    std::vector<const ShaderObject*> surfaces;
    /// The function of RTshaderclass that all of them have; nullptr: they differ.
    int (*commonShade)(const void*, RTSstate*) = nullptr;
    bool complete = true;     ///< every triangle has a surface shader
    bool transparent = false; ///< some of the surfaces may let light pass
    bool fixedFunction = false; ///< some instances have state blocks
    bool blended = false;       ///< of which some let what is behind shine through
    std::vector<LightPart> lights;
    /// Some light sees the points as the surfaces do (illuminateSample): these get all values.
    bool lightsSeePoints = false;
    /// Whether a surface, or a light, may ask how wide a ray's cone is.
    bool readsFootprints = false;
};

/// Asks the shaders of a frame: those in use whether they are opaque, lights how often to be
/// sampled.
FrameShading findFrameShading(const Scene& scene, const ShaderTable& shaders,
                              const std::vector<std::shared_ptr<const ShaderObject>>& lights);

/// Indices of the shaders that triangles of the scene have once replaced ones are; ascending.
std::vector<uint32_t> usedShaders(const Scene& scene);

} // namespace smart
