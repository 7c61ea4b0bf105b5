// SPDX-License-Identifier: MIT
#include "libsmart/render/frame_shading.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "libsmart/shading/fixed_function.h"

namespace smart {
namespace {

using Indices = std::set<uint32_t>;

/// The shaders below a group of instances; what is shared is looked at once.
class ShaderCollector {
public:
    Indices below(const InstanceGroup& group) {
        Indices found;
        std::set<std::pair<const Model*, const ShaderReplacement*>> seen;
        std::pair<const Model*, const ShaderReplacement*> last;
        for (const auto& traits : group.traits()) {
            const std::pair<const Model*, const ShaderReplacement*> placed{
                traits->model.get(), traits->replacement.get()};
            if (!placed.first || placed == last || !seen.insert(placed).second) continue;
            last = placed;
            for (const uint32_t shader : of(*placed.first))
                found.insert(placed.second ? (*placed.second)(shader) : shader);
        }
        return found;
    }

private:
    const Indices& of(const Model& model) {
        const auto known = models_.find(&model);
        if (known != models_.end()) return known->second;
        Indices found = below(model.children);
        const std::vector<uint32_t>& own = model.shading.shaders;
        if (!model.triangles.empty()) {
            if (own.empty()) found.insert(0);
            found.insert(own.begin(), own.end());
        }
        return models_.emplace(&model, std::move(found)).first->second;
    }

    std::map<const Model*, Indices> models_;
};

bool mayLetLightPass(const ShaderObject& surface) {
    const RTshaderclass& functions = surface.functions();
    if (!functions.transparency) return false;
    return !functions.opaque || functions.opaque(surface.block()) != 1;
}

uint32_t samplesOf(const ShaderObject& light) {
    const RTshaderclass& functions = light.functions();
    if (!functions.illuminateSample || !functions.lightSamples) return 1;
    return std::clamp<uint32_t>(functions.lightSamples(light.block()), 1, kMaxLightSamples);
}

const builtin::PointLight* pointLightOf(const ShaderObject& light) {
    using Functions = openrt::detail::Functions<builtin::PointLight>;
    return light.functions().illuminate == Functions::illuminate
               ? static_cast<const builtin::PointLight*>(light.block())
               : nullptr;
}

} // namespace

std::vector<uint32_t> usedShaders(const Scene& scene) {
    const Indices found = ShaderCollector().below(scene.group());
    return {found.begin(), found.end()};
}

FrameShading findFrameShading(const Scene& scene, const ShaderTable& shaders,
                              const std::vector<std::shared_ptr<const ShaderObject>>& lights) {
    FrameShading shading;
    for (const uint32_t index : usedShaders(scene)) {
        const ShaderObject* surface = index < shaders.size() ? shaders[index].get() : nullptr;
        if (surface && surface->shaderClass().kind() == RT_SURFACE_SHADER)
            shading.surfaces.push_back(surface);
        else
            shading.complete = false;
    }
    if (!shading.surfaces.empty()) {
        const auto shade = shading.surfaces.front()->functions().shade;
        const bool common = std::ranges::all_of(shading.surfaces, [&](const ShaderObject* surface) {
            return surface->functions().shade == shade;
        });
        if (common) shading.commonShade = shade;
    }
    shading.transparent = std::ranges::any_of(
        shading.surfaces, [](const ShaderObject* surface) { return mayLetLightPass(*surface); });
    const FixedState* last = nullptr;
    for (const auto& traits : scene.group().traits()) {
        const FixedState* state = traits->state.get();
        if (!state || state == last) continue;
        last = state;
        shading.fixedFunction = true;
        shading.blended |= letsThrough(state->ops);
    }
    shading.transparent |= shading.blended;
    for (const auto& light : lights) {
        const uint32_t samples = samplesOf(*light);
        const builtin::PointLight* const point = pointLightOf(*light);
        for (uint32_t i = 0; i < samples; ++i)
            shading.lights.push_back({light.get(), i, samples, point});
        shading.lightsSeePoints |= light->functions().illuminateSample != nullptr;
    }
    // Transparency is asked at points with all values.
    shading.readsFootprints =
        shading.lightsSeePoints || shading.transparent || shading.fixedFunction ||
        std::ranges::any_of(shading.surfaces, [](const ShaderObject* surface) {
            return (surface->reads() & RTS_READS_FOOTPRINT) != 0;
        });
    return shading;
}

} // namespace smart
