// SPDX-License-Identifier: MIT
#include "libsmart/geometry/model.h"

#include <algorithm>
#include <cassert>

#include "libsmart/geometry/model_tree.h"
#include "libsmart/kernel/packet.h"

namespace smart {
namespace {

template <class T>
std::size_t heldBytes(const std::vector<T>& vector) {
    return vector.capacity() * sizeof(T);
}

template <class... Vectors>
void shrinkAll(Vectors&... vectors) {
    (vectors.shrink_to_fit(), ...);
}

} // namespace

std::size_t ShadingData::bytes() const {
    std::size_t ofUnits = heldBytes(moreTexCoords);
    for (const UnitTexCoords& unit : moreTexCoords) ofUnits += heldBytes(unit.values);
    return ofUnits + corners.bytes() + heldBytes(normals) + heldBytes(texCoords) +
           heldBytes(colors) + heldBytes(slots) + heldBytes(shaders) + heldBytes(triangleBlocks) +
           heldBytes(triangleData) + heldBytes(vertexBlocks) + heldBytes(vertexData) +
           heldBytes(secondaryColors) + heldBytes(fogCoordinates) + heldBytes(vertexMaterials) +
           heldBytes(materials) + heldBytes(provoking) + heldBytes(boundary) + heldBytes(keepAlive);
}

void ShadingData::shrink() {
    shrinkAll(corners, normals, texCoords, colors, secondaryColors, fogCoordinates, vertexMaterials,
              materials, provoking, boundary, slots, shaders, triangleBlocks, triangleData,
              vertexBlocks, vertexData, keepAlive);
    for (UnitTexCoords& unit : moreTexCoords) unit.values.shrink_to_fit();
}

void TreeSizes::add(const KdTree& tree) {
    nodes += tree.nodes.size();
    references += tree.prims.size();
    leaves += (tree.nodes.size() + 1) / 2; // inner nodes have two children
}

void TreeSizes::add(std::span<const WideNode> tree) {
    nodes += tree.size();
    for (const WideNode& node : tree) {
        for (const uint32_t child : node.child) {
            if (!(child & kWideLeaf)) continue;
            ++leaves;
            references += (child & 15u) + 1;
        }
    }
}

Model::Model(std::shared_ptr<const ShadingData> shadingData,
             std::shared_ptr<const InstanceGroup> group, const ModelBuildOptions& options)
    : sharedShading(std::move(shadingData)), sharedChildren(std::move(group)),
      tree_(std::make_unique<ModelTree>(options)), counted_(options.memory, sizeof(Model)) {}

Model::~Model() = default;

const ModelView& Model::view() const { return tree_->view(); }
double Model::reach() const {
    return children.bounds().empty() ? tree_->reach() : kReachesCorners;
}
const KdTree& Model::kdTree() const { return tree_->kdTree(); }
uint64_t Model::treeEvents() const { return tree_->events(); }
bool Model::treeBuilt() const { return tree_->built(); }
TreeSizes Model::treeSizes() const { return tree_->sizes(); }
std::size_t Model::ownBytes() const { return tree_->bytes() + std::size_t(counted_.bytes()); }

void Model::buildTree(const std::vector<Triangle>& from, const Model* old) {
    if (old)
        tree_->makeMoved(from, *old->tree_);
    else
        tree_->make(from);
    droppedTriangles = tree_->dropped();
    for (const auto& child : children.traits()) {
        if (!child->model) continue;
        levels = std::max(levels, 1 + child->model->levels);
        drawsPixels |= child->model->drawsPixels;
    }
    assert(levels <= uint32_t(kMaxLevels));
    bounds = tree_->bounds();
    bounds.add(children.bounds());
}

void Model::show() {
    drawsPixels |= !pixels.empty();
    counted_.add(pixels.bytes());
    tree_->show(triangles, children);
}

// The flag keeps models that are nested often, and deep, from being visited often.
void Model::prepareFastRecords() const {
    if (recordsPrepared_.load(std::memory_order_acquire)) return;
    for (const auto& child : children.traits())
        if (child->model) child->model->prepareFastRecords();
    tree_->prepareRecords();
    recordsPrepared_.store(true, std::memory_order_release);
}

} // namespace smart
