// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model_builder.h"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "libsmart/base/fp_environment.h"
#include "libsmart/kernel/packet.h"

namespace smart {
namespace {

/// Whether the sizes of the vectors agree, as ShadingData says they do.
[[maybe_unused]] bool isConsistent(const ShadingData& shading, std::size_t triangles) {
    const auto perTriangle = [triangles](std::size_t size) {
        return size == 0 || size == triangles;
    };
    uint32_t vertices = 0;
    for (std::size_t i = 0; i < shading.corners.size(); ++i) {
        for (const uint32_t corner : shading.corners[i]) vertices = std::max(vertices, corner + 1);
    }
    const auto reaches = [vertices](uint32_t first, std::size_t size) {
        return first == ShadingData::kNone ? size == 0 : first + size >= vertices;
    };
    const auto slotExists = [&shading](uint32_t slot) { return slot < shading.shaders.size(); };
    return perTriangle(shading.corners.size()) && perTriangle(shading.slots.size()) &&
           perTriangle(shading.boundary.size()) &&
           perTriangle(shading.triangleBlocks.size()) &&
           (shading.vertexBlocks.empty() || shading.vertexBlocks.size() >= vertices) &&
           reaches(shading.firstNormal, shading.normals.size()) &&
           reaches(shading.firstTexCoord, shading.texCoords.size()) &&
           reaches(shading.firstColor, shading.colors.size()) &&
           std::all_of(shading.moreTexCoords.begin(), shading.moreTexCoords.end(),
                       [&](const UnitTexCoords& unit) {
                           return reaches(unit.first, unit.values.size());
                       }) &&
           std::all_of(shading.slots.begin(), shading.slots.end(), slotExists);
}

} // namespace

ModelPtr ModelBuilder::build(const ModelBuildOptions& options) && {
    const FpEnvironment standard;
    const auto start = std::chrono::steady_clock::now();
    assert(triangles.size() < kNoHit);
    assert(isConsistent(shading, triangles.size()));

    // Build aside, so that this builder still holds all it was given when memory runs out.
    const auto shared = std::make_shared<Counted<ShadingData>>(options.memory);
    const auto group = std::make_shared<Counted<InstanceGroup>>(options.memory);
    if (!children.empty()) group->value = InstanceGroup(children, options.threads);
    const auto model = std::make_shared<Model>(
        std::shared_ptr<const ShadingData>(shared, &shared->value),
        std::shared_ptr<const InstanceGroup>(group, &group->value), options);
    model->buildTree(triangles);
    triangles.shrink_to_fit();
    shading.shrink();

    model->triangles = std::move(triangles);
    shared->value = std::move(shading);
    shared->bytes.add(sizeof(ShadingData) + shared->value.bytes());
    group->bytes.add(sizeof(InstanceGroup) + group->value.bytes());
    model->pixels = std::move(pixels);
    children = {};
    model->show();
    model->buildSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return model;
}

} // namespace smart
