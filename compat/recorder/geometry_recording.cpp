// SPDX-License-Identifier: MIT
#include "compat/recorder/geometry_recording.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <new>
#include <span>
#include <utility>

#include "compat/recorder/fixed_state_recorder.h"
#include "libsmart/shading/shader_class.h"

namespace smart::compat {

namespace {

constexpr uint32_t kNone = ShadingData::kNone;
constexpr unsigned kClosingEdge = 4; ///< bit of the edge from a triangle's last corner to its first

/// Room for n more elements, so that appending them can not fail.
template <class T>
void makeRoom(std::vector<T>& vector, std::size_t n) {
    if (vector.capacity() - vector.size() >= n) return;
    vector.reserve(std::max(vector.size() + n, 2 * vector.capacity()));
}

/// See ShadingData::provoking. Only of a quad's first triangle the provoking vertex is no corner;
/// it is the last one of the second.
uint8_t provokingCode(const AssembledTriangle& triangle) {
    const auto* const end = std::end(triangle.corners);
    const auto* const found = std::find(std::begin(triangle.corners), end, triangle.provoking);
    return found == end ? uint8_t(ShadingData::kOfNext + ShadingData::kLastCorner)
                        : uint8_t(found - std::begin(triangle.corners));
}

/// Room for the list to be as long as `count` and n more.
template <class T>
void makeRoomFrom(std::vector<T>& vector, std::size_t count, std::size_t n) {
    makeRoom(vector, count - vector.size() + n);
}

std::size_t aligned(std::size_t bytes) {
    return (bytes + kBlockAlignment - 1) & ~(kBlockAlignment - 1);
}

/// Appends a block, aligned, into room made before; returns its offset.
uint32_t append(std::vector<std::byte>& data, const std::vector<std::byte>& block) noexcept {
    data.resize(aligned(data.size()));
    const std::size_t offset = data.size();
    data.insert(data.end(), block.begin(), block.end());
    return uint32_t(offset);
}

bool uses(const std::vector<UsedShader>& list, uint32_t index) {
    return std::any_of(list.begin(), list.end(),
                       [&](const UsedShader& used) { return used.index == index; });
}

void store(float (&out)[3], const glm::vec3& v) {
    for (int k = 0; k < 3; ++k) out[k] = v[k];
}

} // namespace

void GeometryRecording::reserveVertex(const Attributes& attributes, const BoundShader& shader) {
    constexpr std::size_t kTriangles = PrimitiveAssembler::kMaxTriangles;
    ShadingData& shading = builder_.shading;
    const std::size_t triangles = builder_.triangles.size();
    if (vertexCount_ >= kNone - 1 || triangles >= kNone - 1 - kTriangles) throw std::bad_alloc();
    makeRoom(positions_, 1);
    if (given.normal) makeRoom(shading.normals, 1);
    if (given.texCoord) makeRoom(shading.texCoords, 1);
    if (given.color) makeRoom(shading.colors, 1);
    if (given.secondaryColor) makeRoom(shading.secondaryColors, 1);
    if (given.fogCoordinate) makeRoom(shading.fogCoordinates, 1);
    if (given.moreTexCoords) {
        if (shading.moreTexCoords.empty()) shading.moreTexCoords.resize(kMoreUnits);
        for (std::size_t unit = 0; unit < kMoreUnits; ++unit)
            if (given.moreTexCoords >> unit & 1u) makeRoom(shading.moreTexCoords[unit].values, 1);
    }
    if (given.materials) {
        makeRoom(shading.vertexMaterials, 1);
        makeRoom(shading.materials, 1);
    }
    makeRoom(builder_.triangles, kTriangles);
    if (!attributes.edgeFlag || !assembler_.lastCornerProvokes() || !shading.boundary.empty())
        makeRoomFrom(shading.boundary, triangles, kTriangles);
    shading.corners.makeRoom(kTriangles);
    makeRoom(shading.slots, kTriangles);
    if (!assembler_.lastCornerProvokes() || !shading.provoking.empty())
        makeRoomFrom(shading.provoking, triangles, kTriangles);
    if (!isFilled(assembler_.primitive())) {
        makeRoom(builder_.pixels.runs, 1);
        makeRoom(builder_.pixels.positions, 1);
    }
    makeRoom(shading.shaders, 1);
    makeRoom(shading.keepAlive, 1);
    makeRoom(usedShaders_, 1);
    if (!shader.vertexBlock.empty() || !shading.vertexBlocks.empty()) {
        makeRoomFrom(shading.vertexBlocks, vertexCount_, 1);
        makeRoom(shading.vertexData, aligned(shader.vertexBlock.size()) + kBlockAlignment);
        if (shading.vertexData.capacity() >= kNone) throw std::bad_alloc();
    }
    if (!shader.triangleBlock.empty() || !shading.triangleBlocks.empty()) {
        makeRoomFrom(shading.triangleBlocks, triangles, kTriangles);
        makeRoom(shading.triangleData, aligned(shader.triangleBlock.size()) + kBlockAlignment);
        if (shading.triangleData.capacity() >= kNone) throw std::bad_alloc();
    }
}

uint32_t GeometryRecording::slotOf(const BoundShader& shader) noexcept {
    std::vector<uint32_t>& shaders = builder_.shading.shaders;
    const uint32_t index = shader.shader->index();
    if (lastSlot_ < shaders.size() && shaders[lastSlot_] == index) return lastSlot_;
    lastSlot_ = uint32_t(std::find(shaders.begin(), shaders.end(), index) - shaders.begin());
    if (lastSlot_ == shaders.size()) {
        shaders.push_back(index);
        builder_.shading.keepAlive.push_back(shader.shader);
        if (!uses(usedShaders_, index)) usedShaders_.push_back({index, shader.id});
    }
    return lastSlot_;
}

uint32_t GeometryRecording::materialsNumber(
    const std::shared_ptr<const FixedMaterials>& materials) noexcept {
    // Programs go back and forth between few materials: the last ones are looked through.
    constexpr std::size_t kLookedAt = 8;
    const std::shared_ptr<const FixedMaterials>& wanted =
        materials ? materials : initialMaterials();
    auto& list = builder_.shading.materials;
    for (std::size_t back = 1; back <= std::min(list.size(), kLookedAt); ++back) {
        const auto& known = list[list.size() - back];
        if (known == wanted || *known == *wanted) return uint32_t(list.size() - back);
    }
    list.push_back(wanted);
    return uint32_t(list.size() - 1);
}

void GeometryRecording::addTriangle(const AssembledTriangle& triangle,
                                    const BoundShader& shader) noexcept {
    ShadingData& shading = builder_.shading;
    const uint32_t (&corners)[3] = triangle.corners;
    Triangle& out = builder_.triangles.emplace_back();
    store(out.v0, positions_[corners[0]]);
    store(out.v1, positions_[corners[1]]);
    store(out.v2, positions_[corners[2]]);
    shading.corners.push_back({corners[0], corners[1], corners[2]});
    shading.slots.push_back(slotOf(shader));
    const uint8_t provoking = provokingCode(triangle);
    if (provoking != ShadingData::kLastCorner || !shading.provoking.empty()) {
        shading.provoking.resize(builder_.triangles.size() - 1, ShadingData::kLastCorner);
        shading.provoking.push_back(provoking);
    }
    if (triangle.boundary != ShadingData::kAllEdges || !shading.boundary.empty()) {
        shading.boundary.resize(builder_.triangles.size() - 1, ShadingData::kAllEdges);
        if (triangle.extendsPolygon) shading.boundary.back() &= uint8_t(~kClosingEdge);
        shading.boundary.push_back(triangle.boundary);
    }

    if (!shader.triangleBlock.empty()) {
        shading.triangleBlocks.resize(builder_.triangles.size() - 1, kNone);
        if (lastTriangleBlock_.stamp != shader.triangleStamp)
            lastTriangleBlock_ = {shader.triangleStamp,
                                  append(shading.triangleData, shader.triangleBlock)};
        shading.triangleBlocks.push_back(lastTriangleBlock_.offset);
    } else if (!shading.triangleBlocks.empty()) {
        shading.triangleBlocks.push_back(kNone);
    }
}

void GeometryRecording::vertex(const glm::vec3& position, const Attributes& attributes,
                               const glm::vec3& normal, const BoundShader& shader) {
    reserveVertex(attributes, shader);
    ShadingData& shading = builder_.shading;
    const auto latch = [&](bool isGiven, uint32_t& first, auto& values, const auto& value) {
        if (!isGiven) return;
        if (first == kNone) first = vertexCount_;
        values.push_back(value);
    };
    latch(given.normal, shading.firstNormal, shading.normals, normal);
    latch(given.texCoord, shading.firstTexCoord, shading.texCoords, attributes.texCoord);
    latch(given.color, shading.firstColor, shading.colors, attributes.color);
    latch(given.secondaryColor, shading.firstSecondaryColor, shading.secondaryColors,
          glm::vec3(attributes.secondaryColor));
    latch(given.fogCoordinate, shading.firstFogCoordinate, shading.fogCoordinates,
          attributes.fogCoordinate);
    for (std::size_t unit = 0; unit < kMoreUnits && given.moreTexCoords; ++unit)
        if (given.moreTexCoords >> unit & 1u) {
            UnitTexCoords& texCoords = shading.moreTexCoords[unit];
            latch(true, texCoords.first, texCoords.values, attributes.moreTexCoords[unit]);
        }
    if (given.materials)
        latch(true, shading.firstMaterial, shading.vertexMaterials,
              materialsNumber(attributes.materials));
    if (!shader.vertexBlock.empty()) {
        shading.vertexBlocks.resize(vertexCount_, kNone);
        if (lastVertexBlock_.stamp != shader.vertexStamp)
            lastVertexBlock_ = {shader.vertexStamp, append(shading.vertexData, shader.vertexBlock)};
        shading.vertexBlocks.push_back(lastVertexBlock_.offset);
    } else if (!shading.vertexBlocks.empty()) {
        shading.vertexBlocks.push_back(kNone);
    }
    positions_.push_back(position);

    if (!isFilled(assembler_.primitive())) addPixelVertex(position);
    AssembledTriangle triangles[PrimitiveAssembler::kMaxTriangles];
    const int count = assembler_.add(vertexCount_++, triangles, attributes.edgeFlag);
    for (int i = 0; i < count; ++i) addTriangle(triangles[i], shader);
}

// Points and separate lines go on with the run before where its last line is whole.
void GeometryRecording::addPixelVertex(const glm::vec3& position) noexcept {
    PixelGeometry& pixels = builder_.pixels;
    const auto kind = [this] {
        switch (assembler_.primitive()) {
        case Primitive::Lines: return PixelRun::Kind::Lines;
        case Primitive::LineStrip: return PixelRun::Kind::LineStrip;
        case Primitive::LineLoop: return PixelRun::Kind::LineLoop;
        default: return PixelRun::Kind::Points;
        }
    }();
    if (!continuesRun_ && !pixels.runs.empty()) {
        const PixelRun& last = pixels.runs.back();
        const bool wholes = kind == PixelRun::Kind::Points ||
                            (kind == PixelRun::Kind::Lines && last.count % 2 == 0);
        continuesRun_ = wholes && last.kind == kind && last.beforeTriangle == triangleCount() &&
                        last.firstVertex + last.count == vertexCount_;
    }
    if (!continuesRun_)
        pixels.runs.push_back({kind, triangleCount(), uint32_t(pixels.positions.size()), 0,
                               vertexCount_});
    continuesRun_ = true;
    ++pixels.runs.back().count;
    pixels.positions.push_back(position);
}

void GeometryRecording::addImage(std::shared_ptr<const WindowImage> image) {
    PixelGeometry& pixels = builder_.pixels;
    makeRoom(pixels.runs, 1);
    makeRoom(pixels.images, 1);
    pixels.runs.push_back({PixelRun::Kind::Image, triangleCount(), uint32_t(pixels.images.size()),
                           1, 0});
    pixels.images.push_back(std::move(image));
}

void GeometryRecording::addChild(Instance child, uint32_t childLevels,
                                 const std::vector<UsedShader>& shaders) {
    makeRoom(usedShaders_, shaders.size());
    builder_.children.add(std::move(child));
    levels_ = std::max(levels_, childLevels + 1);
    for (const UsedShader& shader : shaders)
        if (!uses(usedShaders_, shader.index)) usedShaders_.push_back(shader);
}

ModelPtr GeometryRecording::compile(const ModelBuildOptions& options) {
    // What the model does not need is set aside, and comes back if the build fails.
    ShadingData& shading = builder_.shading;
    shading.vertices = vertexCount_;
    std::vector<uint32_t> slots;
    if (!slotsAreNeeded()) slots.swap(shading.slots);
    ModelPtr model;
    try {
        model = std::move(builder_).build(options);
    } catch (...) {
        if (!slotsAreNeeded()) slots.swap(shading.slots);
        throw;
    }
    *this = GeometryRecording();
    return model;
}

bool GeometryRecording::givesAgain(const Model& model) const {
    if (!builder_.children.empty() || !model.children.instances().empty() ||
        !builder_.pixels.empty() || !model.pixels.empty())
        return false;
    const std::vector<Triangle>& triangles = builder_.triangles;
    if (triangles.empty() || triangles.size() != model.triangles.size() ||
        std::memcmp(triangles.data(), model.triangles.data(),
                    triangles.size() * sizeof(Triangle)) != 0)
        return false;
    ShadingData shading = builder_.shading;
    shading.vertices = vertexCount_;
    if (!slotsAreNeeded()) shading.slots.clear();
    return shading == model.shading;
}

} // namespace smart::compat
