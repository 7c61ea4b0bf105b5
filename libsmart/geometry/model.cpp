// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "libsmart/accel/triangle_clip.h"
#include "libsmart/base/fp_environment.h"
#include "libsmart/geometry/degenerate.h"
#include "libsmart/geometry/kd_view.h"

namespace smart {
namespace {

template <class T>
std::size_t heldBytes(const std::vector<T>& vector) {
    return vector.capacity() * sizeof(T);
}

/// Computed in double, each entry rounded once.
TriangleRecord makeRecord(const Triangle& triangle) {
    double e1[3], e2[3], normal[3];
    for (int k = 0; k < 3; ++k) {
        e1[k] = double(triangle.v1[k]) - triangle.v0[k];
        e2[k] = double(triangle.v2[k]) - triangle.v0[k];
    }
    int axis = 0;
    for (int k = 0; k < 3; ++k) {
        const int ku = (k + 1) % 3, kv = (k + 2) % 3;
        normal[k] = e1[ku] * e2[kv] - e1[kv] * e2[ku];
        if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
    }
    const int ku = (axis + 1) % 3, kv = (axis + 2) % 3;
    const double area = normal[axis];
    const double p = triangle.v0[ku], q = triangle.v0[kv];
    TriangleRecord record{};
    record.nu = float(normal[ku] / area);
    record.nv = float(normal[kv] / area);
    record.nd = float(triangle.v0[axis] + (normal[ku] * p + normal[kv] * q) / area);
    record.bu = float(e2[kv] / area);
    record.bv = float(-e2[ku] / area);
    record.bd = float((e2[ku] * q - e2[kv] * p) / area);
    record.cu = float(-e1[kv] / area);
    record.cv = float(e1[ku] / area);
    record.cd = float((e1[kv] * p - e1[ku] * q) / area);
    // Degenerate, not finite, or too small or too large for single precision: never hit.
    for (const float entry : {record.nu, record.nv, record.nd, record.bu, record.bv, record.bd,
                              record.cu, record.cv, record.cd}) {
        if (!std::isfinite(entry)) return {0, 0, 0, 3, 0, 0, 0, 0, 0, 0};
    }
    record.axis = uint32_t(axis);
    return record;
}

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

template <class... Vectors>
void shrinkAll(Vectors&... vectors) {
    (vectors.shrink_to_fit(), ...);
}

} // namespace

std::size_t ShadingData::bytes() const {
    return corners.bytes() + heldBytes(normals) + heldBytes(texCoords) + heldBytes(colors) +
           heldBytes(slots) + heldBytes(shaders) + heldBytes(triangleBlocks) +
           heldBytes(triangleData) + heldBytes(vertexBlocks) + heldBytes(vertexData) +
           heldBytes(vertexMaterials) + heldBytes(materials) + heldBytes(provoking) +
           heldBytes(boundary) + heldBytes(keepAlive);
}

void ShadingData::shrink() {
    shrinkAll(corners, normals, texCoords, colors, vertexMaterials, materials, provoking, boundary,
              slots, shaders, triangleBlocks, triangleData, vertexBlocks, vertexData, keepAlive);
}

std::size_t Model::bytes() const {
    return sizeof(Model) + heldBytes(triangles) + tree.bytes() + shading.bytes() + pixels.bytes() +
           children.bytes() + preparedBytes_.load(std::memory_order_relaxed);
}

void Model::buildTrees(const std::vector<Triangle>& from, const KdBuildOptions& options) {
    const TrianglePrimitives primitives(from);
    droppedTriangles = primitives.droppedCount();
    if (!from.empty()) {
        KdBuildStats stats;
        tree = buildKdTree(primitives, options, &stats);
        treeEvents = stats.events;
    }
    for (const Instance& child : children.instances()) {
        if (!child.model) continue;
        levels = std::max(levels, 1 + child.model->levels);
        drawsPixels |= child.model->drawsPixels;
    }
    assert(levels <= uint32_t(kMaxLevels));
    bounds = tree.bounds;
    bounds.add(children.bounds());
}

void Model::makeView() {
    drawsPixels |= !pixels.empty();
    view_.triangles = triangles.data();
    view_.tree = makeKdView(tree, tree.bounds);
    children.show(view_);
}

void Model::prepareFastRecords() const {
    std::call_once(recordsOnce_, [this] {
        const FpEnvironment standard;
        for (const Instance& child : children.instances()) {
            if (child.model) child.model->prepareFastRecords();
        }
        records_.reserve(triangles.size());
        for (const Triangle& triangle : triangles) records_.push_back(makeRecord(triangle));
        preparedBytes_.fetch_add(heldBytes(records_), std::memory_order_relaxed);
        view_.records = records_.data();
    });
}

void Model::prepareTiles() const {
    std::call_once(tilesOnce_, [this] {
        const FpEnvironment standard;
        for (const Instance& child : children.instances()) {
            if (child.model) child.model->prepareTiles();
        }
        std::vector<Aabb> boxes(triangles.size());
        for (const uint32_t i : tree.prims) {
            boxes[i].add(triangles[i].v0);
            boxes[i].add(triangles[i].v1);
            boxes[i].add(triangles[i].v2);
        }
        tileTrees_ = TileTrees(triangles, boxes);
        preparedBytes_.fetch_add(tileTrees_.bytes(), std::memory_order_relaxed);
        tileTrees_.show(view_);
    });
}

} // namespace smart
