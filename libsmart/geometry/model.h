// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "libsmart/accel/kd_tree.h"
#include "libsmart/accel/wide_node.h"
#include "libsmart/geometry/instance_group.h"
#include "libsmart/geometry/model_build_options.h"
#include "libsmart/geometry/pixel_geometry.h"
#include "libsmart/geometry/texture_units.h"
#include "libsmart/geometry/triangle_corners.h"
#include "libsmart/kernel/view.h"

namespace smart {

/// What shading reads after a hit; only what the object used is stored. Traversal never looks here.
struct ShadingData {
    static constexpr uint32_t kNone = 0xFFFFFFFFu;

    uint32_t vertices = 0; ///< how many were given, those of no triangle included
    TriangleCorners corners; ///< empty: vertices have neither attributes nor new positions
    /// Attributes of vertices first..; vertices before the first take the instance's.
    uint32_t firstNormal = kNone, firstTexCoord = kNone, firstColor = kNone;
    uint32_t firstMaterial = kNone, firstSecondaryColor = kNone, firstFogCoordinate = kNone;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec4> texCoords;
    std::vector<UnitTexCoords> moreTexCoords; ///< of each unit after the first; empty: none has any
    std::vector<glm::vec4> colors;
    std::vector<glm::vec3> secondaryColors;
    std::vector<float> fogCoordinates;
    std::vector<uint32_t> vertexMaterials; ///< numbers in materials
    std::vector<std::shared_ptr<const FixedMaterials>> materials;
    /// The corner of each triangle that flat shading takes; from kOfNext on, a corner of the
    /// triangle after it. Empty: the last one of each.
    std::vector<uint8_t> provoking;
    static constexpr uint8_t kOfNext = 3, kLastCorner = 2;
    /// Bit k: the edge from corner k to the next is one of the polygon that the triangle is a part
    /// of, and to be drawn where polygons are drawn as lines. Empty: all are.
    std::vector<uint8_t> boundary;
    static constexpr uint8_t kAllEdges = 7;
    /// Shader slot of each triangle (empty: all 0), and the shader index of each slot in order of
    /// first use.
    std::vector<uint32_t> slots;
    std::vector<uint32_t> shaders;
    /// Byte offset of each triangle's parameter block in triangleData; kNone without one. Empty
    /// when no shader of the model has such parameters. Blocks are 16-byte aligned, shared by
    /// runs of triangles that did not change them.
    std::vector<uint32_t> triangleBlocks;
    std::vector<std::byte> triangleData;
    /// The same for vertices; blocks consist of floats.
    std::vector<uint32_t> vertexBlocks;
    std::vector<std::byte> vertexData;
    /// Keeps shaders (and through them plug-ins) alive as long as the model.
    std::vector<std::shared_ptr<const void>> keepAlive;

    std::size_t bytes() const;
    /// Gives back memory that nothing lies in.
    void shrink();
    bool operator==(const ShadingData&) const = default;
};

/// Sizes of a tree of either kind.
struct TreeSizes {
    uint64_t nodes = 0, leaves = 0, references = 0;

    void add(const KdTree& tree);
    void add(std::span<const WideNode> tree);
};

class ModelTree;

/// A compiled object: immutable, shared by scenes, frames and threads without locks.
/// Made by ModelBuilder, and from another one by updateModel().
struct Model {
    /// Both are filled before the first ray comes.
    explicit Model(std::shared_ptr<const ShadingData> shadingData = std::make_shared<ShadingData>(),
                   std::shared_ptr<const InstanceGroup> group = std::make_shared<InstanceGroup>(),
                   const ModelBuildOptions& options = {});
    ~Model();
    Model(const Model&) = delete;
    Model& operator=(const Model&) = delete;

    std::vector<Triangle> triangles; ///< in the order given; dropped ones keep their number
    /// Models that differ in positions alone have these in common.
    const std::shared_ptr<const ShadingData> sharedShading;
    const std::shared_ptr<const InstanceGroup> sharedChildren;
    const ShadingData& shading = *sharedShading;
    const InstanceGroup& children = *sharedChildren;
    PixelGeometry pixels;
    uint32_t droppedTriangles = 0; ///< not finite or degenerate; not in a tree
    bool drawsPixels = false;      ///< it, or a child, has something in `pixels`
    uint32_t levels = 1;           ///< 1 without children, else 1 + the deepest child's
    double buildSeconds = 0;
    Aabb bounds; ///< of triangles and children

    const ModelView& view() const;
    /// How far all of it reaches into the corners of `bounds`; see cornerReach().
    double reach() const;
    /// Empty where there is none: where another tree was asked for, and of a lazy model before the
    /// first ray.
    const KdTree& kdTree() const;
    uint64_t treeEvents() const; ///< events the kd-tree's builder swept
    /// False for a lazy model that no ray has reached.
    bool treeBuilt() const;
    /// Of the tree over its own triangles, once it exists.
    TreeSizes treeSizes() const;
    /// Of its own, and with what it has in common with others.
    std::size_t ownBytes() const;
    std::size_t bytes() const { return ownBytes() + shading.bytes() + children.bytes(); }

    /// Makes the fast mode's records, here and in the models nested below, unless they exist; of a
    /// lazy model with its tree. Thread-safe; traversal of this model in another mode may be
    /// under way.
    void prepareFastRecords() const;

private:
    friend class ModelBuilder;
    friend std::shared_ptr<const Model> updateModel(const Model& old, uint32_t first,
                                                    uint32_t count, const float* positions,
                                                    const ModelBuildOptions& options);
    /// Of triangles that become the model's later; and what follows from the children.
    /// old: the model that these have moved away from, if there is one.
    void buildTree(const std::vector<Triangle>& from, const Model* old = nullptr);
    /// The last step.
    void show();

    std::unique_ptr<ModelTree> tree_; ///< thread-safe where it is not const
    CountedBytes counted_;
    mutable std::atomic<bool> recordsPrepared_{false}; ///< nested ones too
};

using ModelPtr = std::shared_ptr<const Model>;

/// What kept the calling thread from building the tree of a lazy model that its rays reached; they
/// went through it then. nullptr: nothing, since the last call.
std::exception_ptr takeBuildFailure() noexcept;

} // namespace smart
