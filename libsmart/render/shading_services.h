// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "libsmart/render/crossings.h"
#include "libsmart/render/point_values.h"
#include "libsmart/render/ray_services.h"
#include "libsmart/render/shading_policy.h"

namespace smart {

/// Shades what rays meet, in the manner of the policy, and answers all that shaders ask.
template <class Shading = DynamicShading>
class ShadingServices final : public RayServices {
public:
    ShadingServices(const Frame& frame, TilePixels& counters,
                    ShadingForm form = ShadingForm::Packets)
        : RayServices(frame, counters, form, kFunctions, kPacketFunctions) {}

    ShadedSample traceCameraRay(const Ray& ray, const PathState& path) override;
    /// Shades hits that all have the shader; nullptr is a fault of each.
    void shadeGroup(const ShaderObject* surface, const HitGroup& group);
    /// The same for up to kTilePackets groups of neighbours.
    void shadeGroups(const ShaderObject* surface, std::span<const HitGroup> groups);

    /// The entries of the function tables that shade surfaces.
    static int trace(RTSstate*, const float origin[3], const float direction[3], float weight,
                     float radiance[3]);
    static int shadow(RTSstate*, const float origin[3], const float direction[3], float distance,
                      float attenuation[3]);
    static RTuint packetTrace(RTSpacket*, RTuint lanes, const RTSvectors* origin,
                              const RTSvectors* direction, const RTSfloats* weight, RTScolors*);
    static RTuint packetShadow(RTSpacket*, RTuint lanes, const RTSvectors* origin,
                               const RTSvectors* direction, const RTSfloats* distance, RTScolors*);

private:
    static constexpr RTSfunctions kFunctions = {
        sizeof(RTSfunctions), trace,   traceHit,    shadow, lightCount,
        illuminate,           texture, environment, random};
    static constexpr RTSpacketfunctions kPacketFunctions = {
        sizeof(RTSpacketfunctions), packetTrace,   packetTraceHit,    packetShadow,
        packetLightCount,           packetIlluminate, packetTexture, packetEnvironment,
        packetRandom};

    /// Radiance and alpha from a hit; black if the shader fails.
    glm::vec4 shadeHit(const Ray& ray, const Hit& hit, const PathState& path,
                       ShadedSample* found);
    /// Shades lanes of a group that have the shader, as a packet where that pays.
    void shadeLanes(const ShaderObject* surface, const HitGroup& group, uint32_t lanes);
    /// Shades lanes of a group one by one.
    void shadePoints(const HitGroup& group, uint32_t lanes);
    /// Shades the packet of a group as such; false: that failed, and nothing counts.
    bool shadePacket(PointPacket& packet, const HitGroup& group);
    /// What rays see, whatever they met.
    void shadeRays(const RayGroup& rays, uint32_t lanes, glm::vec4 (&colors)[kPacketSize]);
    /// What a ray sees by itself: by depth through what is blended.
    glm::vec4 shadeRay(const Ray& ray, const Hit& hit, const PathState& path,
                       ShadedSample* found);
    glm::vec4 shadeBlended(Ray ray, Hit hit, const PathState& path, ShadedSample* found);
    glm::vec3 attenuate(Ray ray, const PathState& path);
    void attenuate(RayGroup& rays, uint32_t lanes, glm::vec3 (&products)[kPacketSize]);
    glm::vec3 transparency(const Ray& ray, const Hit& hit, const PathState& path);
};

template <class Shading>
ShadedSample ShadingServices<Shading>::traceCameraRay(const Ray& ray, const PathState& path) {
    ++counters_.primaryRays;
    const Hit hit = findHit(ray);
    ShadedSample sample;
    sample.color = shadeRay(ray, hit, path, &sample);
    sample.judge(*path.sample);
    return sample;
}

template <class Shading>
glm::vec4 ShadingServices<Shading>::shadeHit(const Ray& ray, const Hit& hit, const PathState& path,
                                             ShadedSample* found) {
    PointState point;
    atHit(ray, hit, path, point);
    RTSstate& state = point.state;
    if (found) found->describe(hit, state);
    if (isFixed(point.chain)) return fixed_.shade(point, hit);
    const ShaderObject* shader = findSurface(point.chain);
    if (shader) {
        fillParameterBlocks(point.chain, *frame_.shaders, *shader, point.scratch, state);
        clearValues(state, ~valuesFor(Shading::reads(*shader)));
    }
    if (!shader || Shading::template shade<ShadingServices>(*shader, state) != 0) {
        path.sample->fault = true;
        return {0.0f, 0.0f, 0.0f, 1.0f};
    }
    return {state.result[0], state.result[1], state.result[2], state.result[3]};
}

template <class Shading>
glm::vec4 ShadingServices<Shading>::shadeRay(const Ray& ray, const Hit& hit, const PathState& path,
                                             ShadedSample* found) {
    if (hit.triangle == kNoHit) return shadeMiss(ray, path);
    return shading_.blended ? shadeBlended(ray, hit, path, found)
                            : shadeHit(ray, hit, path, found);
}

template <class Shading>
glm::vec4 ShadingServices<Shading>::shadeBlended(Ray ray, Hit hit, const PathState& path,
                                                 ShadedSample* found) {
    glm::vec3 sum(0.0f), left(1.0f);
    float alphaLeft = 1.0f;
    Crossings crossings;
    for (int i = 0; i < kMaxTransparentHits; ++i) {
        if (hit.triangle == kNoHit) {
            const glm::vec4 color = shadeMiss(ray, path);
            return {sum + left * glm::vec3(color), 1.0f - alphaLeft * (1.0f - color.a)};
        }
        if (crossings.add(hit)) {
            const glm::vec4 color = shadeHit(ray, hit, path, found);
            found = nullptr;
            const FixedState* state = stateOf(hit);
            if (!state || !letsThrough(state->ops))
                return {sum + left * glm::vec3(color), 1.0f - alphaLeft * (1.0f - color.a)};
            const FixedBlend blend = blendOf(state->ops, color);
            sum += left * blend.own;
            left *= blend.through;
            alphaLeft *= 1.0f - color.a;
            if (left == glm::vec3(0.0f)) break;
        }
        ray.tNear = crossings.beyond(hit);
        hit = findHit(ray);
    }
    return {sum, 1.0f - alphaLeft};
}

// What transparent surfaces leave of the light: the nearest hits one after the other.
template <class Shading>
glm::vec3 ShadingServices<Shading>::attenuate(Ray ray, const PathState& path) {
    glm::vec3 product(1.0f);
    Crossings crossings;
    for (int i = 0; i < kMaxTransparentHits; ++i) {
        ++counters_.shadowRays;
        const Hit hit = findHit(ray);
        if (hit.triangle == kNoHit) return product;
        if (crossings.add(hit)) product *= transparency(ray, hit, path);
        if (product == glm::vec3(0.0f)) return product;
        ray.tNear = crossings.beyond(hit);
    }
    return glm::vec3(0.0f);
}

template <class Shading>
glm::vec3 ShadingServices<Shading>::transparency(const Ray& ray, const Hit& hit,
                                                 const PathState& path) {
    const HitChain chain = resolve(*frame_.scene, hit.path, hit.levels, hit.triangle);
    if (isFixed(chain)) return fixedTransparency(ray, hit, path);
    const ShaderObject* shader = findSurface(chain);
    if (!shader || !Shading::answersTransparency(*shader)) return glm::vec3(0.0f);
    PointState point;
    atHit(ray, hit, path, point);
    point.start.mayTrace = false;
    fillParameterBlocks(point.chain, *frame_.shaders, *shader, point.scratch, point.state);
    float rgb[3] = {0.0f, 0.0f, 0.0f};
    const int result = Shading::template transparency<ShadingServices>(*shader, point.state, rgb);
    if (result != 0 || !isFinite({rgb[0], rgb[1], rgb[2], 0.0f})) {
        point.start.sample->fault = true;
        return glm::vec3(0.0f);
    }
    return {std::clamp(rgb[0], 0.0f, 1.0f), std::clamp(rgb[1], 0.0f, 1.0f),
            std::clamp(rgb[2], 0.0f, 1.0f)};
}

template <class Shading>
int ShadingServices<Shading>::trace(RTSstate* state, const float origin[3],
                                    const float direction[3], float weight, float radiance[3]) {
    ShadingServices& self = static_cast<ShadingServices&>(*startOf(*state).services);
    std::fill_n(radiance, 3, 0.0f);
    const float share = self.shareOf(weight, state->weight, state->depth);
    if (share < 0.0f || !mayTrace(*state)) return 0;
    const Ray ray = spawn(*state, origin, direction);
    ++self.counters_.secondaryRays;
    const Hit hit = self.findHit(ray);
    const PathState path = onward(*state, share);
    const glm::vec4 color = self.shadeRay(ray, hit, path, nullptr);
    path.sample->fault |= !hasFiniteRadiance(color);
    for (int k = 0; k < 3; ++k) radiance[k] = color[k];
    return 1;
}

template <class Shading>
int ShadingServices<Shading>::shadow(RTSstate* state, const float origin[3],
                                     const float direction[3], float distance,
                                     float attenuation[3]) {
    ShadingServices& self = static_cast<ShadingServices&>(*startOf(*state).services);
    const bool traced = mayTrace(*state);
    std::fill_n(attenuation, 3, traced ? 1.0f : 0.0f);
    if (!traced) return 0;
    if (!(distance > 0.0f)) return 1;
    Ray ray = spawn(*state, origin, direction);
    ray.tFar = distance * kBeforeLight;
    if (self.shading_.transparent) {
        const glm::vec3 left = self.attenuate(ray, onward(*state, state->weight));
        for (int k = 0; k < 3; ++k) attenuation[k] = left[k];
        return 1;
    }
    ++self.counters_.shadowRays;
    if (self.isOccluded(ray)) std::fill_n(attenuation, 3, 0.0f);
    return 1;
}

} // namespace smart

#include "libsmart/render/packet_shading.h"

namespace smart {

extern template class ShadingServices<DynamicShading>;

} // namespace smart
