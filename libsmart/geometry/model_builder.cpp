// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model_builder.h"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "libsmart/accel/triangle_clip.h"
#include "libsmart/base/fp_environment.h"
#include "libsmart/geometry/degenerate.h"
#include "libsmart/kernel/packet.h"

namespace smart {
namespace {

/// The triangles of a model as the tree's builder sees them.
class TrianglePrimitives final : public KdPrimitives {
public:
    explicit TrianglePrimitives(const std::vector<Triangle>& triangles)
        : triangles_(triangles), dropped_(triangles.size()) {
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            dropped_[i] = !isFinite(triangles[i]) || isDegenerate(triangles[i]);
            droppedCount_ += dropped_[i];
        }
    }
    uint32_t droppedCount() const { return droppedCount_; }

    uint32_t count() const override { return uint32_t(triangles_.size()); }
    Aabb bounds(uint32_t prim) const override {
        Aabb box;
        if (dropped_[prim]) return box;
        const Triangle& triangle = triangles_[prim];
        box.add(triangle.v0);
        box.add(triangle.v1);
        box.add(triangle.v2);
        return box;
    }
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        const Triangle& triangle = triangles_[prim];
        return clipTriangle(triangle.v0, triangle.v1, triangle.v2, cell);
    }

private:
    const std::vector<Triangle>& triangles_;
    std::vector<uint8_t> dropped_;
    uint32_t droppedCount_ = 0;
};

/// Whether the sizes of the vectors agree, as ShadingData says they do.
[[maybe_unused]] bool isConsistent(const ShadingData& shading, std::size_t triangles) {
    const auto perTriangle = [triangles](std::size_t size) {
        return size == 0 || size == triangles;
    };
    uint32_t vertices = 0;
    for (const auto& corners : shading.corners) {
        for (const uint32_t corner : corners) vertices = std::max(vertices, corner + 1);
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
           std::all_of(shading.slots.begin(), shading.slots.end(), slotExists);
}

} // namespace

ModelPtr ModelBuilder::build(const KdBuildOptions& options) && {
    const FpEnvironment standard;
    const auto start = std::chrono::steady_clock::now();
    assert(triangles.size() < kNoHit);
    assert(isConsistent(shading, triangles.size()));

    // Build aside, so that this builder still holds all it was given when memory runs out.
    const auto model = std::make_shared<Model>();
    const TrianglePrimitives primitives(triangles);
    model->droppedTriangles = primitives.droppedCount();
    if (!triangles.empty()) {
        KdBuildStats stats;
        model->tree = buildKdTree(primitives, options, &stats);
        model->treeEvents = stats.events;
    }
    if (!children.empty()) model->children = InstanceGroup(children, options.threads);
    model->drawsPixels = !pixels.empty();
    for (const Instance& child : children) {
        if (!child.model) continue;
        model->levels = std::max(model->levels, 1 + child.model->levels);
        model->drawsPixels |= child.model->drawsPixels;
    }
    assert(model->levels <= uint32_t(kMaxLevels));
    triangles.shrink_to_fit();

    model->triangles = std::move(triangles);
    model->shading = std::move(shading);
    model->pixels = std::move(pixels);
    children.clear();
    model->bounds = model->tree.bounds;
    model->bounds.add(model->children.bounds());
    model->makeView();
    model->buildSeconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return model;
}

} // namespace smart
