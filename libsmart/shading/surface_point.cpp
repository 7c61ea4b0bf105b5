// SPDX-License-Identifier: MIT
#include "libsmart/shading/surface_point.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <limits>

#include "libsmart/kernel/point_math.h"
#include "libsmart/shading/corner_attributes.h"

namespace smart {

namespace {

/// Length 1 whatever the length before; false for zero and what is not finite.
bool normalizeSafely(glm::dvec3& v) {
    Real3 usual{v.x, v.y, v.z};
    if (normalizeUsual(usual)) {
        v = {usual.x, usual.y, usual.z};
        return true;
    }
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (!(largest > 0) || !(largest <= std::numeric_limits<double>::max())) return false;
    v /= largest;
    v /= std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return true;
}

void store(float (&to)[3], const glm::dvec3& from) {
    for (int k = 0; k < 3; ++k) to[k] = float(from[k]);
}

glm::dvec3 vertex(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

/// Shading normal in the world, as interpolation leaves it; false: no vertex has a normal.
bool interpolateNormal(SurfaceTriangle& triangle, const CornerAttributes& corners,
                       const glm::dvec3& weights, glm::dvec3& normal) {
    const HitChain& chain = triangle.chain();
    const ShadingData& shading = chain.model->shading;
    const glm::vec3* given[3];
    for (int i = 0; i < 3; ++i) given[i] = corners.find(shading.normals, shading.firstNormal, i);
    if (!given[0] && !given[1] && !given[2]) return false;
    glm::dvec3 geometric(0.0);
    if (!given[0] || !given[1] || !given[2]) {
        const Triangle& t = chain.model->triangles[chain.triangle];
        geometric = glm::cross(vertex(t.v1) - vertex(t.v0), vertex(t.v2) - vertex(t.v0));
        normalizeSafely(geometric);
    }
    glm::dvec3 corner[3];
    for (int i = 0; i < 3; ++i) corner[i] = given[i] ? glm::dvec3(*given[i]) : geometric;
    normal = triangle.toWorld(weights[0] * corner[0] + weights[1] * corner[1] +
                              weights[2] * corner[2]);
    return true;
}

void interpolate(const glm::vec4 (&corners)[3], const glm::dvec3& weights, float (&to)[4]) {
    for (int k = 0; k < 4; ++k)
        to[k] = float(weights[0] * corners[0][k] + weights[1] * corners[1][k] +
                      weights[2] * corners[2][k]);
}

/// Texture coordinates per unit of length on a triangle: the root of its area in the one divided
/// by its area in the other.
float densityOf(const glm::vec4 (&corners)[3], double doubleArea) {
    const double s1 = double(corners[1].x) - corners[0].x, t1 = double(corners[1].y) - corners[0].y;
    const double s2 = double(corners[2].x) - corners[0].x, t2 = double(corners[2].y) - corners[0].y;
    const float density = float(std::sqrt(std::fabs(s1 * t2 - s2 * t1) / doubleArea));
    return std::isfinite(density) ? density : 0.0f;
}

const std::byte* findBlock(const std::vector<uint32_t>& offsets, const std::vector<std::byte>& data,
                           uint32_t index) {
    if (offsets.empty() || offsets[index] == ShadingData::kNone) return nullptr;
    return data.data() + offsets[index];
}

uint32_t ownShader(const HitChain& chain) {
    const ShadingData& shading = chain.model->shading;
    if (shading.shaders.empty()) return 0;
    return shading.shaders[shading.slots.empty() ? 0 : shading.slots[chain.triangle]];
}

} // namespace

uint32_t effectiveShader(const HitChain& chain) {
    uint32_t shader = ownShader(chain);
    for (uint32_t level = chain.levels; level-- > 0;)
        if (const auto& replacement = chain.instances[level]->traits->replacement)
            shader = (*replacement)(shader);
    return shader;
}

SurfaceTriangle::SurfaceTriangle(const HitChain& chain)
    : chain_(&chain),
      corners_{chain.worldVertex(0), chain.worldVertex(1), chain.worldVertex(2)},
      areaNormal_(chain.worldNormal()),
      normal_(areaNormal_),
      hasNormal_(normalizeSafely(normal_)) {}

glm::dvec3 SurfaceTriangle::toWorld(const glm::dvec3& normal) {
    if (!hasCofactors_) {
        const glm::dvec3 x = chain_->toWorld[0], y = chain_->toWorld[1], z = chain_->toWorld[2];
        cofactors_ = {glm::cross(y, z), glm::cross(z, x), glm::cross(x, y)};
        shrink_ = 1.0 / glm::dot(x, cofactors_[0]);
        hasCofactors_ = true;
    }
    return cofactors_ * normal * shrink_;
}

void fillSurfacePoint(SurfaceTriangle& triangle, uint32_t instance, const Ray& ray, float t,
                      float u, float v, RTSstate& state) {
    const HitChain& chain = triangle.chain();
    glm::dvec3 direction(ray.dir[0], ray.dir[1], ray.dir[2]);
    const double length = std::sqrt(glm::dot(direction, direction));
    normalizeSafely(direction);
    std::memcpy(state.rayOrigin, ray.org, sizeof(state.rayOrigin));
    store(state.rayDirection, direction);
    state.rayDistance = float(t * length);

    const glm::dvec3 weights = cornerWeights(u, v);
    store(state.barycentric, weights);
    store(state.position, weights[0] * triangle.corner(0) + weights[1] * triangle.corner(1) +
                              weights[2] * triangle.corner(2));

    // Underflow may take the normal of a triangle that is hit: then it faces the ray.
    const glm::dvec3 geometric = triangle.normal() ? *triangle.normal() : -direction;
    store(state.geometricNormal, geometric);
    state.frontFace = glm::dot(direction, geometric) > 0 ? 0u : 1u;

    const CornerAttributes corners(chain);
    glm::dvec3 normal;
    if (interpolateNormal(triangle, corners, weights, normal)) {
        store(state.rawNormal, normal);
        store(state.shadingNormal, normalizeSafely(normal) ? normal : geometric);
    } else {
        store(state.rawNormal, geometric);
        store(state.shadingNormal, geometric);
    }

    const ShadingData& shading = chain.model->shading;
    glm::vec4 values[3];
    corners.get(shading.texCoords, shading.firstTexCoord, &InheritedAttributes::ownTexCoord,
                &InheritedAttributes::texCoord, values);
    interpolate(values, weights, state.texCoord);
    state.texCoordDensity =
        shading.texCoords.empty()
            ? 0.0f
            : densityOf(values, std::sqrt(glm::dot(triangle.areaNormal(), triangle.areaNormal())));
    corners.get(shading.colors, shading.firstColor, &InheritedAttributes::ownColor,
                &InheritedAttributes::color, values);
    interpolate(values, weights, state.color);

    state.object = chain.instances[chain.levels - 1]->objectId;
    state.instance = instance;
    state.primitive = chain.triangle;
}

void fillParameterBlocks(const HitChain& chain, const ShaderTable& table,
                         const ShaderObject& shader, VertexScratch& scratch, RTSstate& state) {
    const ShaderClass& shaderClass = shader.shaderClass();
    const RTshaderclass& d = shaderClass.descriptor();
    state.triangleParam = nullptr;
    state.vertexParam = nullptr;
    if (d.triangleSize == 0 && d.vertexSize == 0) return;

    // The model's blocks are those of the class that the triangle was given with.
    const ShadingData& shading = chain.model->shading;
    const uint32_t own = ownShader(chain);
    const bool sameClass =
        own < table.size() && table[own] && &table[own]->shaderClass() == &shaderClass;
    if (d.triangleSize) {
        const std::byte* block =
            sameClass ? findBlock(shading.triangleBlocks, shading.triangleData, chain.triangle)
                      : nullptr;
        state.triangleParam = block ? block : shaderClass.triangleDefaults().data();
    }
    if (d.vertexSize) {
        const std::byte* blocks[3] = {};
        for (int i = 0; i < 3; ++i) {
            if (sameClass && !shading.corners.empty())
                blocks[i] = findBlock(shading.vertexBlocks, shading.vertexData,
                                      shading.corners[chain.triangle][std::size_t(i)]);
            if (!blocks[i]) blocks[i] = shaderClass.vertexDefaults().data();
        }
        const double w0 = 1.0 - state.barycentric[1] - state.barycentric[2];
        for (std::size_t at = 0; at < d.vertexSize; at += sizeof(float)) {
            float a[3];
            for (int i = 0; i < 3; ++i) std::memcpy(&a[i], blocks[i] + at, sizeof(float));
            const float value = float(w0 * a[0] + double(state.barycentric[1]) * a[1] +
                                      double(state.barycentric[2]) * a[2]);
            std::memcpy(scratch.bytes + at, &value, sizeof(value));
        }
        state.vertexParam = scratch.bytes;
    }
}

} // namespace smart
