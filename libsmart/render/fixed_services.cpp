// SPDX-License-Identifier: MIT
// The part of RayServices that deals with fixed function.
#include <algorithm>
#include <optional>

#include "libsmart/render/ray_services.h"

namespace smart {

uint32_t RayServices::fixedLanes(const ShaderObject* surface, const RayGroup& rays,
                                 uint32_t lanes) const {
    if (!surface || surface != frame_.shaders->front().get()) return 0;
    uint32_t fixed = 0;
    forEach(lanes, [&](int i) {
        if (stateOf(rays.hits.path[0][i])) fixed |= 1u << i;
    });
    return fixed;
}

bool RayServices::shadeAlone(const Ray& ray, const Hit& hit, const ShaderObject* surface,
                             glm::vec4& color) {
    if (!shading_.fixedFunction || surface != frame_.shaders->front().get()) return false;
    const FixedState* const state = stateOf(hit);
    if (!state || !fixed_.dependsOnHitAlone(*state)) return false;
    color = fixed_.shadeAlone(ray, hit);
    return true;
}

void RayServices::describe(const Hit& hit, ShadedSample& found) const {
    found.distance = hit.t;
    found.instance = hit.path[0];
    found.primitive = hit.triangle;
    const InstanceGroup* group = &frame_.scene->group();
    for (uint32_t level = 0; level < hit.levels; ++level) {
        const InstanceView& instance = group->instances()[hit.path[level]];
        found.object = instance.objectId;
        group = &instance.traits->model->children;
    }
}

void RayServices::shadeFixedPoints(const HitGroup& group, uint32_t lanes) {
    const RayGroup& rays = *group.rays;
    PointState point;
    std::optional<SurfaceTriangle> triangle; // of the lane before: neighbours often share it
    std::optional<Hit> last;
    forEach(lanes, [&](int i) {
        const Hit hit = rays.hit(i);
        const bool sameWay = last && last->levels == hit.levels &&
                             std::equal(hit.path, hit.path + hit.levels, last->path);
        if (!sameWay)
            point.chain = resolve(*frame_.scene, hit.path, hit.levels, hit.triangle);
        else
            point.chain.triangle = hit.triangle;
        if (!sameWay || hit.triangle != last->triangle) triangle.emplace(point.chain);
        last = hit;
        placeAt(rays.ray(i), hit, rays.path(i), *triangle, point);
        if (group.found) group.found[i].describe(hit, point.state);
        group.colors[i] = fixed_.shade(point, hit);
    });
}

glm::vec3 RayServices::fixedTransparency(const Ray& ray, const Hit& hit, const PathState& path) {
    const FixedFragmentOps& ops = stateOf(hit)->ops;
    if (!letsThrough(ops)) return glm::vec3(0.0f);
    PointState point;
    atHit(ray, hit, path, point);
    point.start.mayTrace = false;
    const glm::vec3 through = blendOf(ops, fixed_.shade(point, hit)).through;
    return {std::clamp(through.r, 0.0f, 1.0f), std::clamp(through.g, 0.0f, 1.0f),
            std::clamp(through.b, 0.0f, 1.0f)};
}

} // namespace smart
