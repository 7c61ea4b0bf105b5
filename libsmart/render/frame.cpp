// SPDX-License-Identifier: MIT
#include "libsmart/render/frame.h"

#include <algorithm>

namespace smart {

LayerNeeds findLayerNeeds(const Scene& scene) {
    LayerNeeds needs;
    bool first = false, last = false; // which of equal hits some state asks for
    const FixedState* before = nullptr;
    for (const Instance& instance : scene.group().instances()) {
        const FixedState* const state = instance.state.get();
        if (!state) first = true;
        if (!state || state == before) continue;
        before = state;
        (state->ops.depthFunction == CompareFunction::LessEqual ? last : first) = true;
        needs.collects |= !state->isOpaque();
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
    needs.collects |= takesLast ? first : last;
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
