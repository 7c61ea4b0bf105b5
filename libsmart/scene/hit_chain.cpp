// SPDX-License-Identifier: MIT
#include "libsmart/scene/hit_chain.h"

#include <cassert>
#include <glm/geometric.hpp>

namespace smart {
namespace {

glm::dvec3 transformedVector(const glm::dmat4x3& matrix, const glm::dvec3& vector) {
    return matrix[0] * vector.x + matrix[1] * vector.y + matrix[2] * vector.z;
}

/// What `inner` does followed by what `outer` does.
glm::dmat4x3 composed(const glm::dmat4x3& outer, const glm::dmat4x3& inner) {
    return glm::dmat4x3(transformedVector(outer, inner[0]), transformedVector(outer, inner[1]),
                        transformedVector(outer, inner[2]),
                        transformedVector(outer, inner[3]) + outer[3]);
}

glm::dvec3 toVector(const float (&vertex)[3]) {
    return {vertex[0], vertex[1], vertex[2]};
}

} // namespace

glm::dvec3 HitChain::worldNormal() const {
    // Edges before the matrix: no digit is lost to the translation.
    const Triangle& corners = model->triangles[triangle];
    const glm::dvec3 v0 = toVector(corners.v0);
    return glm::cross(transformedVector(toWorld, toVector(corners.v1) - v0),
                      transformedVector(toWorld, toVector(corners.v2) - v0));
}

glm::dvec3 HitChain::worldVertex(int corner) const {
    const Triangle& corners = model->triangles[triangle];
    const auto& vertex = corner == 0 ? corners.v0 : corner == 1 ? corners.v1 : corners.v2;
    return transformedVector(toWorld, toVector(vertex)) + toWorld[3];
}

HitChain resolve(const Scene& scene, const uint32_t* path, uint32_t levels, uint32_t triangle) {
    assert(levels >= 1 && levels <= uint32_t(kMaxLevels));
    HitChain chain{};
    chain.levels = levels;
    chain.triangle = triangle;
    const InstanceGroup* group = &scene.group();
    for (uint32_t level = 0; level < levels; ++level) {
        const InstanceView& instance = group->instances()[path[level]];
        chain.instances[level] = &instance;
        chain.toWorld =
            level == 0 ? toParent(instance) : composed(chain.toWorld, toParent(instance));
        chain.model = instance.traits->model.get();
        group = &chain.model->children;
    }
    assert(triangle < chain.model->triangles.size());
    return chain;
}

} // namespace smart
