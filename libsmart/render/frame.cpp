// SPDX-License-Identifier: MIT
#include "libsmart/render/frame.h"

#include <algorithm>
#include <cmath>

#include "libsmart/geometry/model.h"

namespace smart {

namespace {

constexpr std::size_t kMostBoxes = 16;

/// Of an instance in its scene, with room for what rounding does to hits.
Aabb roomyBounds(const InstanceView& instance) {
    constexpr float kRoom = 0x1p-10f;
    Aabb box;
    const Model* const model = instance.traits->model.get();
    if (!model || model->bounds.empty()) return box;
    const Aabb& own = model->bounds;
    const glm::dmat4x3 matrix = toParent(instance);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 place(corner & 1 ? own.hi[0] : own.lo[0],
                               corner & 2 ? own.hi[1] : own.lo[1],
                               corner & 4 ? own.hi[2] : own.lo[2]);
        const glm::vec3 moved(matrix * glm::dvec4(place, 1.0));
        box.add(&moved.x);
    }
    float size = 0.0f;
    for (int k = 0; k < 3; ++k)
        size = std::max({size, std::fabs(box.lo[k]), std::fabs(box.hi[k])});
    for (int k = 0; k < 3; ++k) {
        box.lo[k] -= kRoom * size;
        box.hi[k] += kRoom * size;
    }
    return box;
}

/// Of instances that are not opaque; none where there are too many.
std::vector<Aabb> findSeeThrough(const InstanceGroup& group) {
    std::vector<Aabb> boxes;
    for (const InstanceView& instance : group.instances()) {
        const FixedState* const state = instance.traits->state.get();
        if (!state || state->isOpaque()) continue;
        if (boxes.size() == kMostBoxes) return {};
        boxes.push_back(roomyBounds(instance));
    }
    return boxes;
}

} // namespace

bool LayerNeeds::isAlone(const glm::vec3& place) const {
    if (seeThrough.empty() || equalsDiffer) return false;
    return std::none_of(seeThrough.begin(), seeThrough.end(), [&](const Aabb& box) {
        for (int k = 0; k < 3; ++k)
            if (!(place[k] >= box.lo[k] && place[k] <= box.hi[k])) return false;
        return true;
    });
}

LayerNeeds findLayerNeeds(const Scene& scene) {
    LayerNeeds needs;
    bool opaque = true;
    bool first = false, last = false; // which of equal hits some state asks for
    const FixedState* before = nullptr;
    for (const auto& traits : scene.group().traits()) {
        const FixedState* const state = traits->state.get();
        if (!state) first = true;
        if (!state) continue;
        if (state == before) continue;
        before = state;
        (state->ops.depthFunction == CompareFunction::LessEqual ? last : first) = true;
        opaque &= state->isOpaque();
        const FixedFragmentOps& ops = state->ops;
        const FixedRaster& raster = state->raster;
        needs.opaqueHides &= ops.depthTest && !raster.offsetFill &&
                             (ops.depthFunction == CompareFunction::Less ||
                              ops.depthFunction == CompareFunction::LessEqual);
        needs.sifts |= raster.cull || raster.polygonMode[0] != FixedPolygonMode::Fill ||
                       raster.polygonMode[1] != FixedPolygonMode::Fill ||
                       std::any_of(std::begin(raster.clip), std::end(raster.clip),
                                   [](bool plane) { return plane; });
    }
    const bool takesLast = scene.view().lastOfEqual != 0;
    needs.equalsDiffer = takesLast ? first : last;
    needs.collects = !opaque || needs.equalsDiffer;
    if (!opaque) needs.seeThrough = findSeeThrough(scene.group());
    return needs;
}

bool Frame::isLayered() const {
    return !below.empty() || !clears.empty() || scissor || clearDepth != 1.0f || !drawsColor ||
           primitives || needs().collects || needs().sifts;
}

const Frame::Found& Frame::found() const {
    std::call_once(found_.once, [this] {
        static const ShaderTable none;
        found_.found.shading = findFrameShading(*scene, shaders ? *shaders : none, lights);
        found_.found.needs = findLayerNeeds(*scene);
    });
    return found_.found;
}

} // namespace smart
