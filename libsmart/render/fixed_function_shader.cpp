// SPDX-License-Identifier: MIT
#include "libsmart/render/fixed_function_shader.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "libsmart/render/ray_cone.h"
#include "libsmart/render/ray_services.h"

namespace smart {
namespace {

glm::dvec3 weightsOf(const RTSstate& state) {
    return {state.barycentric[0], state.barycentric[1], state.barycentric[2]};
}

/// Sides of the texture's first level.
glm::dvec2 sizeOf(const FixedTexture& texture) {
    const TextureImage& first = texture.image->levels()[texture.image->options().firstLevel];
    return {double(first.width()), texture.enabled2D ? double(first.height()) : 0.0};
}

} // namespace

glm::vec4 FixedFunctionShader::shade(PointState& point) {
    const RTSstate& state = point.state;
    const FixedViewer viewer = viewerOf(state);
    useTriangle(point.chain, viewer);
    const FixedState& fixed = triangle_.state();
    const bool fromCamera = state.depth == 0 && !frame_.camera;
    const bool back = showsBack(state, fromCamera);
    const glm::dvec3 weights = weightsOf(state);

    double texels = 0.0;
    if (fixed.texture.image)
        texels = fromCamera ? texelsToNeighbours(weights, back) : texelsInCone(state, back);
    LitVertex fragment = triangle_.at(weights, back);
    if (fixed.lighting.enabled && fixed.lighting.shadows && point.start.mayTrace) {
        glm::vec3 visibility[kFixedLights];
        if (findVisibility(point, fragment.lightsIn, visibility)) {
            useTriangle(point.chain, viewer); // shadow rays may have met others
            fragment = triangle_.at(weights, back, visibility);
        }
    }
    if (!fromCamera && !fixed.fog.fromCoordinate) fragment.fogDistance = state.rayDistance;
    glm::vec4 color;
    if (fixed.texture.image) {
        const glm::vec4 texel = fixedTexel(fixed.texture, fragment, texels);
        color = surfaceColor(fixed, fragment, &texel);
    } else {
        color = surfaceColor(fixed, fragment, nullptr);
    }
    if (fixed.lighting.reflections && fragment.reflection > 0.0f && point.start.mayTrace)
        color = reflected(point, color, fragment.reflection);
    return fogged(fixed.fog, color, fragment.fogDistance);
}

void FixedFunctionShader::useTriangle(const HitChain& chain, const FixedViewer& viewer) {
    if (triangle_.isOf(chain, viewer)) return;
    triangle_ = FixedTriangle(chain, viewer);
    hasScreen_ = hasTexture_ = false;
}

FixedViewer FixedFunctionShader::viewerOf(const RTSstate& state) const {
    if (!frame_.camera) return {};
    return {{state.rayOrigin[0], state.rayOrigin[1], state.rayOrigin[2]}, true};
}

bool FixedFunctionShader::showsBack(const RTSstate& state, bool fromCamera) {
    const bool clockwiseIsFront = triangle_.state().raster.frontFaceClockwise;
    const bool byRay = (state.frontFace != 0) == clockwiseIsFront;
    if (!fromCamera) return byRay;
    if (!hasScreen_) {
        const glm::dmat4& projection = frame_.matrixCamera.projection;
        const Viewport& viewport = frame_.viewport;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec4 clip = projection * glm::dvec4(triangle_.position(i), 1.0);
            screen_.corners[i] = {viewport.x * clip.w + viewport.width * 0.5 * (clip.x + clip.w),
                                  viewport.y * clip.w + viewport.height * 0.5 * (clip.y + clip.w),
                                  clip.w};
        }
        const auto& c = screen_.corners;
        screen_.doubleArea = glm::dot(c[0], glm::cross(c[1], c[2]));
        hasScreen_ = true;
    }
    if (screen_.doubleArea == 0.0 || !std::isfinite(screen_.doubleArea)) return byRay;
    return (screen_.doubleArea > 0.0) == clockwiseIsFront;
}

double FixedFunctionShader::texelsToNeighbours(const glm::dvec3& weights, bool back) {
    const auto& c = screen_.corners;
    if (!hasTexture_) { // the same on both sides
        const LitVertex (&lit)[3] = triangle_.corners(back);
        screen_.s = screen_.t = screen_.q = glm::dvec3(0.0);
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 weight = glm::cross(c[(i + 1) % 3], c[(i + 2) % 3]);
            screen_.s += double(lit[i].texCoord.x) * weight;
            screen_.t += double(lit[i].texCoord.y) * weight;
            screen_.q += double(lit[i].texCoord.w) * weight;
        }
        hasTexture_ = true;
    }
    const glm::dvec3 here = weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
    const glm::dvec3 pixel(here.x / here.z, here.y / here.z, 1.0);
    const glm::dvec2 size = sizeOf(triangle_.state().texture);
    const double q = glm::dot(screen_.q, pixel);
    const glm::dvec2 from(glm::dot(screen_.s, pixel) / q, glm::dot(screen_.t, pixel) / q);
    double squared = 0.0;
    for (int k = 0; k < 2; ++k) {
        glm::dvec3 next = pixel;
        next[k] += 1.0;
        const double nextQ = glm::dot(screen_.q, next);
        if (!(nextQ * q > 0.0)) return HUGE_VAL; // beyond the horizon
        const glm::dvec2 step =
            (glm::dvec2(glm::dot(screen_.s, next), glm::dot(screen_.t, next)) / nextQ - from) *
            size;
        squared = std::max(squared, glm::dot(step, step));
    }
    return std::sqrt(squared / std::max(frame_.samples, 1u));
}

double FixedFunctionShader::texelsInCone(const RTSstate& state, bool back) {
    const LitVertex (&lit)[3] = triangle_.corners(back);
    const glm::dvec2 size = sizeOf(triangle_.state().texture);
    glm::dvec2 at[3];
    for (int i = 0; i < 3; ++i)
        at[i] = glm::dvec2(lit[i].texCoord.x, lit[i].texCoord.y) / double(lit[i].texCoord.w) *
                glm::dvec2(size.x, std::max(size.y, 1.0));
    const glm::dvec2 a = at[1] - at[0], b = at[2] - at[0];
    const glm::dvec3 normal = glm::cross(triangle_.position(1) - triangle_.position(0),
                                         triangle_.position(2) - triangle_.position(0));
    const double density =
        std::sqrt(std::fabs(a.x * b.y - a.y * b.x) / std::sqrt(glm::dot(normal, normal)));
    const float* n = state.geometricNormal;
    const float* d = state.rayDirection;
    return double(textureFootprint(state.footprint, float(density), {n[0], n[1], n[2]},
                                   {d[0], d[1], d[2]}));
}

bool FixedFunctionShader::findVisibility(PointState& point, uint32_t lights,
                                         glm::vec3 (&visibility)[kFixedLights]) const {
    RTSstate& state = point.state;
    const FixedLighting& lighting = point.chain.instances[0]->traits->state->lighting;
    bool hidden = false;
    for (int i = 0; i < kFixedLights; ++i) {
        visibility[i] = glm::vec3(1.0f);
        if (!(lights >> i & 1u)) continue;
        const glm::vec4& place = lighting.lights[i].position;
        glm::dvec3 towards{glm::vec3(place)};
        float distance = std::numeric_limits<float>::infinity();
        if (place.w != 0.0f) {
            towards = towards / double(place.w) -
                      glm::dvec3(state.position[0], state.position[1], state.position[2]);
            distance = float(std::sqrt(glm::dot(towards, towards)));
        }
        const float direction[3] = {float(towards.x), float(towards.y), float(towards.z)};
        float left[3];
        if (!state.functions->shadow(&state, state.position, direction, distance, left)) continue;
        visibility[i] = {left[0], left[1], left[2]};
        hidden |= visibility[i] != glm::vec3(1.0f);
    }
    return hidden;
}

glm::vec4 FixedFunctionShader::reflected(PointState& point, const glm::vec4& color,
                                         float share) const {
    RTSstate& state = point.state;
    float direction[3], seen[3];
    rtsReflectedDirection(&state, direction);
    if (!state.functions->trace(&state, state.position, direction, share * state.weight, seen))
        return color;
    return {(1.0f - share) * color.r + share * seen[0], (1.0f - share) * color.g + share * seen[1],
            (1.0f - share) * color.b + share * seen[2], color.a};
}

} // namespace smart
