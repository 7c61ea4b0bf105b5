// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <limits>

#include "libsmart/kernel/kernels.h"
#include "libsmart/render/frame.h"
#include "libsmart/render/ray_cone.h"
#include "libsmart/render/sampling.h"
#include "libsmart/scene/hit_chain.h"
#include "libsmart/scene/query.h"

namespace smart {

/// What one camera ray brings home.
struct ShadedSample {
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};
    float distance = std::numeric_limits<float>::infinity();
    glm::vec3 normal{0.0f}; ///< shading normal
    uint32_t object = kNoId, instance = kNoId, primitive = kNoId;
    bool bad = false; ///< a shader failed or its radiance is not finite; the colour is black then
};

/// Shades hits, and answers what shaders ask (RTSfunctions). One for each tile under way; belongs
/// to the thread that renders it. The rays that shaders spawn are single ones.
class ShadingServices {
public:
    /// `counters`: where rays are counted.
    ShadingServices(const Frame& frame, TilePixels& counters);
    ShadingServices(const ShadingServices&) = delete;
    ShadingServices& operator=(const ShadingServices&) = delete;

    /// Says which sample of which pixel the following calls belong to; restarts the random stream.
    void beginSample(uint32_t x, uint32_t y, uint32_t sample);

    /// Shades what a camera ray, with a direction of length 1, met. hit.triangle may be kNoHit.
    ShadedSample shadeCameraRay(const Ray& ray, const Hit& hit, const RayCone& cone = {});

    /// Traces and shades a camera ray.
    ShadedSample traceCameraRay(const Ray& ray, const RayCone& cone = {});

    /// A state at no surface, for shaders that are asked before a ray is traced.
    RTSstate emptyState();

    /// True if a shader failed since the last call.
    bool takeFault();

private:
    /// Behind RTSstate::tracer: where the rays of a state start.
    struct Origin {
        ShadingServices* services;
        const HitChain* chain = nullptr; ///< of the shaded point; nullptr: none
        float u = 0, v = 0;
        RayCone cone{};       ///< of the rays that go on from the point
        bool mayTrace = true; ///< false while shadows ask for transparency
    };

    // The entries of the function table.
    static const RTSfunctions kFunctions;
    static int trace(RTSstate*, const float origin[3], const float direction[3], float weight,
                     float radiance[3]);
    static int traceHit(RTSstate*, const float origin[3], const float direction[3], RTShitinfo*);
    static int shadow(RTSstate*, const float origin[3], const float direction[3], float distance,
                      float attenuation[3]);
    static RTuint lightCount(const RTSstate*);
    static int illuminate(RTSstate*, RTuint light, RTSlightsample*);
    static void texture(RTSstate*, RTuint texture, float s, float t, float rgba[4]);
    static void environment(RTSstate*, const float direction[3], float radiance[3]);
    static float random(RTSstate*);

    RTSstate makeState(Origin& origin, const Ray& ray, uint32_t depth, float weight) const;
    Ray spawn(const RTSstate& state, const float origin[3], const float direction[3]) const;
    Hit findHit(const Ray& ray) const;
    HitChain chainOf(const Hit& hit) const;
    /// Radiance and alpha from a hit; black if the shader fails. `camera`: what else a camera
    /// ray's sample is to know, or nullptr.
    glm::vec4 shadeHit(const Ray& ray, const RayCone& cone, const Hit& hit, uint32_t depth,
                       float weight, ShadedSample* camera);
    glm::vec4 shadeMiss(const Ray& ray, const RayCone& cone, uint32_t depth, float weight);
    glm::vec3 attenuate(Ray ray, const RTSstate& from);
    glm::vec3 transparency(const Ray& ray, const Hit& hit, const RTSstate& from);
    const ShaderObject* findSurface(const HitChain& chain) const;

    const Frame& frame_;
    TilePixels& counters_;
    const KernelTable& kernels_;
    const std::size_t precision_;
    const uint32_t recursionLimit_;
    uint32_t pixel_[2] = {0, 0};
    uint32_t sample_ = 0;
    RandomStream random_;
    Origin nowhere_{this};
    bool fault_ = false;
};

} // namespace smart
