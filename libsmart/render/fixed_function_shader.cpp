// SPDX-License-Identifier: MIT
#include "libsmart/render/fixed_function_shader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "libsmart/render/ray_cone.h"
#include "libsmart/render/ray_services.h"
#include "libsmart/shading/builtin/surfaces.h"

namespace smart {
namespace {

/// Sides of the texture's first level.
glm::dvec2 sizeOf(const FixedTexture& texture) {
    const TextureImage& first = texture.image->levels()[texture.image->options().firstLevel];
    return {double(first.width()), texture.enabled2D ? double(first.height()) : 0.0};
}

bool asksForTexels(const FixedState& state) {
    const auto asks = [](const FixedTexture& texture) {
        return texture.image && texture.image->asksForFootprint();
    };
    return asks(state.texture) ||
           std::any_of(state.moreTextures.begin(), state.moreTextures.end(), asks);
}

} // namespace

FixedFunctionShader::Known& FixedFunctionShader::find(const Hit& hit, const FixedViewer& viewer) {
    if (!known_) (*known_.emplace()).clear();
    bool isNew = false;
    Known& known = (*known_)->find(hit, isNew);
    const FixedViewer& before = known.triangle.viewer();
    if (!isNew && before.position == viewer.position && before.alwaysLocal == viewer.alwaysLocal)
        return known;
    // What is the same for all triangles of a model is found once.
    if (!way_ || way_->chain.levels != hit.levels ||
        !std::equal(hit.path, hit.path + hit.levels, path_)) {
        way_.emplace(resolve(*frame_.scene, hit.path, hit.levels, hit.triangle));
        std::copy_n(hit.path, hit.levels, path_);
    }
    known.triangle.set(*way_, hit.triangle, viewer);
    known.hasScreen = known.hasTexture = false;
    return known;
}

glm::vec4 FixedFunctionShader::colorAlone(Known& known, const glm::dvec3& weights, bool back,
                                          const FixedArrival& arrival) const {
    const FixedState& fixed = known.triangle.state();
    const LitVertex fragment = known.triangle.at(weights, back, arrival);
    const Texels texels =
        asksForTexels(fixed) ? texelsToNeighbours(known, weights, back) : Texels{};
    return fogged(fixed.fog, colorOf(fixed, fragment, texels), fragment.fogDistance);
}

glm::vec4 FixedFunctionShader::shadeAlone(const Ray& ray, const Hit& hit,
                                          const FixedArrival& arrival) {
    Known& known = find(hit, {});
    const bool back = hasSides(known.triangle.state()) && showsBackOnScreen(known, ray.dir);
    return colorAlone(known, cornerWeights(hit.u, hit.v), back, arrival);
}

void FixedFunctionShader::shadeAlone(const RayGroup& rays, uint32_t lanes,
                                     const uint32_t (&hidden)[kPacketSize],
                                     glm::vec4 (&colors)[kPacketSize]) {
    Known& known = find(rays.hit(std::countr_zero(lanes)), {});
    const bool sides = hasSides(known.triangle.state());
    const bool onlyPrimary = known.triangle.onlyPrimary();
    forEach(lanes, [&](int i) {
        const bool back = sides && showsBackOnScreen(known, rays.ray(i).dir);
        const glm::dvec3 weights = cornerWeights(rays.hits.u[i], rays.hits.v[i]);
        colors[i] = onlyPrimary ? known.triangle.primaryAt(weights, back, hidden[i])
                                : colorAlone(known, weights, back, {hidden[i]});
    });
}

void FixedFunctionShader::findLights(const RayGroup& rays, uint32_t lanes,
                                     uint32_t (&lights)[kPacketSize]) {
    Known& known = find(rays.hit(std::countr_zero(lanes)), {});
    const bool sides = hasSides(known.triangle.state());
    forEach(lanes, [&](int i) {
        const bool back = sides && showsBackOnScreen(known, rays.ray(i).dir);
        lights[i] =
            known.triangle.lightsAt(cornerWeights(rays.hits.u[i], rays.hits.v[i]), back);
    });
}

glm::vec4 FixedFunctionShader::shade(PointState& point, const Hit& hit) {
    const RTSstate& state = point.state;
    const FixedViewer viewer = viewerOf(state);
    Known* known = &find(hit, viewer);
    const FixedState& fixed = known->triangle.state();
    const bool fromCamera = state.depth == 0 && !frame_.camera;
    const bool back =
        fromCamera ? hasSides(fixed) && showsBackOnScreen(*known, state.rayDirection)
                   : (state.frontFace != 0) == fixed.raster.frontFaceClockwise;
    const glm::dvec3 weights = cornerWeights(hit.u, hit.v);

    Texels texels{};
    if (fixed.isTextured())
        texels = fromCamera ? texelsToNeighbours(*known, weights, back)
                            : texelsInCone(*known, state, back);
    LitVertex fragment = known->triangle.at(weights, back);
    if (asksForShadows(fixed) && point.start.mayTrace) {
        glm::vec3 shares[kFixedLights];
        const FixedArrival arrival = findArrival(point, fragment.lightsIn, shares);
        if (arrival.hidden != 0 || arrival.shares) {
            known = &find(hit, viewer); // shadow rays may have met others
            fragment = known->triangle.at(weights, back, arrival);
        }
    }
    if (!fromCamera && !fixed.fog.fromCoordinate) fragment.fogDistance = state.rayDistance;
    glm::vec4 color = colorOf(fixed, fragment, texels);
    if (fixed.lighting.reflections && fragment.reflection > 0.0f && point.start.mayTrace)
        color = reflected(point, color, fragment.reflection);
    return fogged(fixed.fog, color, fragment.fogDistance);
}

glm::vec4 FixedFunctionShader::colorOf(const FixedState& state, const LitVertex& fragment,
                                       const Texels& texels) {
    glm::vec4 memory[kTextureUnits];
    return surfaceColor(state, fragment, fixedTexels(state, fragment, texels.data(), memory));
}

FixedViewer FixedFunctionShader::viewerOf(const RTSstate& state) const {
    if (!frame_.camera) return {};
    return {{state.rayOrigin[0], state.rayOrigin[1], state.rayOrigin[2]}, true};
}

const FixedFunctionShader::OnScreen& FixedFunctionShader::screenOf(Known& known) const {
    OnScreen& screen = known.screen;
    if (known.hasScreen) return screen;
    const glm::dmat4& projection = frame_.matrixCamera.projection;
    const Viewport& viewport = frame_.viewport;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec4 clip = projection * glm::dvec4(known.triangle.position(i), 1.0);
        screen.corners[i] = {viewport.x * clip.w + viewport.width * 0.5 * (clip.x + clip.w),
                             viewport.y * clip.w + viewport.height * 0.5 * (clip.y + clip.w),
                             clip.w};
    }
    const auto& c = screen.corners;
    screen.doubleArea = glm::dot(c[0], glm::cross(c[1], c[2]));
    known.hasScreen = true;
    return screen;
}

bool FixedFunctionShader::hasSides(const FixedState& state) {
    return state.lighting.reflections || (state.lighting.enabled && state.lighting.twoSided);
}

bool FixedFunctionShader::showsBackOnScreen(Known& known,
                                            const float (&rayDirection)[3]) const {
    const bool clockwiseIsFront = known.triangle.state().raster.frontFaceClockwise;
    const double doubleArea = screenOf(known).doubleArea;
    if (doubleArea != 0.0 && std::isfinite(doubleArea))
        return (doubleArea > 0.0) == clockwiseIsFront;
    const glm::dvec3 normal =
        glm::cross(known.triangle.position(1) - known.triangle.position(0),
                   known.triangle.position(2) - known.triangle.position(0));
    const glm::dvec3 direction(rayDirection[0], rayDirection[1], rayDirection[2]);
    const bool facesRay = !(glm::dot(direction, normal) > 0.0);
    return facesRay == clockwiseIsFront;
}

// The same on both sides.
void FixedFunctionShader::findPlanes(Known& known, bool back) const {
    const auto& c = screenOf(known).corners;
    const LitVertex (&lit)[3] = known.triangle.corners(back);
    const FixedState& state = known.triangle.state();
    const glm::dvec3 weights[3] = {glm::cross(c[1], c[2]), glm::cross(c[2], c[0]),
                                   glm::cross(c[0], c[1])};
    known.moreTextures.resize(state.moreTextures.size());
    for (int i = 0; i < 3; ++i)
        forEachTexture(state, lit[i],
                       [&](std::size_t unit, const FixedTexture&, const glm::vec4& at) {
                           TexturePlanes& to =
                               unit == 0 ? known.texture : known.moreTextures[unit - 1];
                           if (i == 0) to.s = to.t = to.q = glm::dvec3(0.0);
                           to.s += double(at.x) * weights[i];
                           to.t += double(at.y) * weights[i];
                           to.q += double(at.w) * weights[i];
                       });
    known.hasTexture = true;
}

FixedFunctionShader::Texels FixedFunctionShader::texelsToNeighbours(Known& known,
                                                                    const glm::dvec3& weights,
                                                                    bool back) const {
    if (!known.hasTexture) findPlanes(known, back);
    const auto& c = known.screen.corners;
    const glm::dvec3 here = weights[0] * c[0] + weights[1] * c[1] + weights[2] * c[2];
    const glm::dvec3 pixel(here.x / here.z, here.y / here.z, 1.0);
    const FixedState& state = known.triangle.state();
    Texels texels{};
    if (state.texture.image)
        texels[0] = distanceInTexels(known.texture, pixel, sizeOf(state.texture));
    for (std::size_t i = 0; i < state.moreTextures.size(); ++i)
        if (state.moreTextures[i].image)
            texels[i + 1] = distanceInTexels(known.moreTextures[i], pixel,
                                             sizeOf(state.moreTextures[i]));
    return texels;
}

double FixedFunctionShader::distanceInTexels(const TexturePlanes& planes,
                                             const glm::dvec3& pixel,
                                             const glm::dvec2& size) const {
    const double q = glm::dot(planes.q, pixel);
    const glm::dvec2 from(glm::dot(planes.s, pixel) / q, glm::dot(planes.t, pixel) / q);
    double squared = 0.0;
    for (int k = 0; k < 2; ++k) {
        glm::dvec3 next = pixel;
        next[k] += 1.0;
        const double nextQ = glm::dot(planes.q, next);
        if (!(nextQ * q > 0.0)) return HUGE_VAL; // beyond the horizon
        const glm::dvec2 step =
            (glm::dvec2(glm::dot(planes.s, next), glm::dot(planes.t, next)) / nextQ - from) *
            size;
        squared = std::max(squared, glm::dot(step, step));
    }
    return std::sqrt(squared / std::max(frame_.samples, 1u));
}

FixedFunctionShader::Texels FixedFunctionShader::texelsInCone(Known& known,
                                                              const RTSstate& state, bool back) {
    FixedTriangle& triangle = known.triangle;
    const LitVertex (&lit)[3] = triangle.corners(back);
    const glm::dvec3 normal = glm::cross(triangle.position(1) - triangle.position(0),
                                         triangle.position(2) - triangle.position(0));
    const float* n = state.geometricNormal;
    const float* d = state.rayDirection;
    Texels texels{};
    const auto measure = [&](std::size_t unit, const FixedTexture& texture, const glm::vec4&) {
        const glm::dvec2 size = sizeOf(texture);
        glm::dvec2 at[3];
        for (int i = 0; i < 3; ++i) {
            const glm::vec4& c = unit == 0 ? lit[i].texCoord : lit[i].moreTexCoords[unit - 1];
            at[i] = glm::dvec2(c.x, c.y) / double(c.w) *
                    glm::dvec2(size.x, std::max(size.y, 1.0));
        }
        const glm::dvec2 a = at[1] - at[0], b = at[2] - at[0];
        const double density =
            std::sqrt(std::fabs(a.x * b.y - a.y * b.x) / std::sqrt(glm::dot(normal, normal)));
        texels[unit] = double(textureFootprint(state.footprint, float(density),
                                               {n[0], n[1], n[2]}, {d[0], d[1], d[2]}));
    };
    forEachTexture(triangle.state(), lit[0], measure);
    return texels;
}

FixedArrival FixedFunctionShader::findArrival(PointState& point, uint32_t lights,
                                              glm::vec3 (&shares)[kFixedLights]) const {
    RTSstate& state = point.state;
    const FixedLighting& lighting = point.chain.instances[0]->traits->state->lighting;
    const glm::dvec3 position(state.position[0], state.position[1], state.position[2]);
    FixedArrival arrival;
    for (int i = 0; i < kFixedLights; ++i) {
        shares[i] = glm::vec3(1.0f);
        if (!(lights >> i & 1u)) continue;
        float direction[3], left[3];
        const float distance = ToLight(lighting.lights[i]).from(position, direction);
        if (!state.functions->shadow(&state, state.position, direction, distance, left)) continue;
        shares[i] = {left[0], left[1], left[2]};
        arrival.add(i, shares);
    }
    return arrival;
}

glm::vec4 FixedFunctionShader::reflected(PointState& point, const glm::vec4& color,
                                         float share) const {
    RTSstate& state = point.state;
    const openrt::Vec3 mirrored = builtin::mirroredInFront(openrt::TraceContext(&state));
    const float direction[3] = {mirrored.x, mirrored.y, mirrored.z};
    float seen[3];
    if (!state.functions->trace(&state, state.position, direction, share * state.weight, seen))
        return color;
    return {(1.0f - share) * color.r + share * seen[0], (1.0f - share) * color.g + share * seen[1],
            (1.0f - share) * color.b + share * seen[2], color.a};
}

} // namespace smart
