// SPDX-License-Identifier: MIT
#include "samples/common/gltf_meshes.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>

#include "samples/common/gltf_accessor.h"

namespace samples {
namespace {

/// Vertices of the file that a part uses, numbered in order of first use. Several parts may share
/// one large accessor, so the cost follows the part's size and not the accessor's.
class UsedVertices {
public:
    uint32_t number(uint32_t original) {
        const auto [at, added] = numbers_.try_emplace(original, uint32_t(originals_.size()));
        if (added) originals_.push_back(original);
        return at->second;
    }
    const std::vector<uint32_t>& originals() const { return originals_; }

private:
    std::unordered_map<uint32_t, uint32_t> numbers_;
    std::vector<uint32_t> originals_;
};

template <class Vec>
std::vector<Vec> gather(const GltfAccessor& accessor, const std::vector<uint32_t>& originals,
                        float missing) {
    std::vector<Vec> values;
    values.reserve(originals.size());
    for (uint32_t vertex : originals) {
        Vec& value = values.emplace_back(missing);
        for (int c = 0; c < std::min(int(Vec::length()), accessor.components()); ++c) {
            value[c] = accessor.value(vertex, c);
        }
    }
    return values;
}

/// Turns a list, strip or fan of `count` corners into a list; corner(i) is the i-th vertex.
template <class Corner>
std::vector<uint32_t> triangleList(int mode, std::size_t count, Corner corner) {
    std::vector<uint32_t> list;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
        list.insert(list.end(), {corner(a), corner(b), corner(c)});
    };
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        for (std::size_t i = 0; i + 2 < count; i += 3) add(i, i + 1, i + 2);
    } else if (mode == TINYGLTF_MODE_TRIANGLE_STRIP) {
        for (std::size_t i = 0; i + 2 < count; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
    } else {
        for (std::size_t i = 1; i + 1 < count; ++i) add(0, i, i + 1);
    }
    return list;
}

class MeshReader {
public:
    MeshReader(const GltfFile& file, const std::vector<TextureCoordinates>& coordinates,
               std::vector<std::string>& notes)
        : model_(file.model),
          coordinates_(coordinates),
          notes_(notes),
          indicesLeft_(kFreeIndices + 8 * file.bufferBytes) {}

    std::optional<MeshPart> read(const tinygltf::Primitive& primitive) {
        // tinygltf leaves -1 where the file says nothing; the default is triangles.
        const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
        if (mode < TINYGLTF_MODE_TRIANGLES || mode > TINYGLTF_MODE_TRIANGLE_FAN) {
            notes_.push_back("points and lines are left out");
            return std::nullopt;
        }
        const auto positions =
            attribute(primitive, "POSITION", {TINYGLTF_TYPE_VEC3});
        if (!positions) return std::nullopt;
        if (!primitive.targets.empty()) notes_.push_back("morph targets are left out");
        MeshPart part;
        part.material = primitive.material;
        if (part.material < -1 || part.material >= int(model_.materials.size())) {
            throw LoadError("there is no material " + std::to_string(part.material));
        }
        UsedVertices used;
        part.indices = indices(primitive, mode, positions->count(), used);
        const std::vector<uint32_t>& originals = used.originals();
        part.positions = gather<glm::vec3>(*positions, originals, 0.0f);
        if (const auto a = attribute(primitive, "NORMAL", {TINYGLTF_TYPE_VEC3})) {
            part.normals = gather<glm::vec3>(sameCount(*a, *positions), originals, 0.0f);
        }
        const TextureCoordinates coordinates =
            part.material < 0 ? TextureCoordinates() : coordinates_[std::size_t(part.material)];
        const std::string set = "TEXCOORD_" + std::to_string(coordinates.set);
        if (const auto a = attribute(primitive, set, {TINYGLTF_TYPE_VEC2})) {
            part.texCoords = gather<glm::vec2>(sameCount(*a, *positions), originals, 0.0f);
            for (glm::vec2& t : part.texCoords) {
                t = glm::vec2(coordinates.transform * glm::vec3(t, 1.0f));
            }
        }
        if (const auto a =
                attribute(primitive, "COLOR_0", {TINYGLTF_TYPE_VEC3, TINYGLTF_TYPE_VEC4})) {
            part.colors = gather<glm::vec4>(sameCount(*a, *positions), originals, 1.0f);
        }
        return part;
    }

private:
    static constexpr uint64_t kFreeIndices = uint64_t(1) << 20;

    std::optional<GltfAccessor> attribute(const tinygltf::Primitive& primitive,
                                          const std::string& name,
                                          std::initializer_list<int> types) const {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return std::nullopt;
        return GltfAccessor(model_, found->second, types, name);
    }

    static const GltfAccessor& sameCount(const GltfAccessor& a, const GltfAccessor& positions) {
        if (a.count() != positions.count()) {
            throw LoadError("a mesh has attributes of different counts");
        }
        return a;
    }

    /// Many primitives may repeat the same accessor, so a small file could ask for any amount.
    void take(uint64_t corners) {
        if (corners > indicesLeft_) {
            throw LoadError("it repeats its triangles too often for its size");
        }
        indicesLeft_ -= corners;
    }

    std::vector<uint32_t> indices(const tinygltf::Primitive& primitive, int mode,
                                  std::size_t vertexCount, UsedVertices& used) {
        if (vertexCount > UINT32_MAX) throw LoadError("a mesh has too many vertices");
        const uint64_t perCorner = mode == TINYGLTF_MODE_TRIANGLES ? 1 : 3;
        if (primitive.indices < 0) {
            take(vertexCount * perCorner);
            return triangleList(mode, vertexCount,
                                [&](std::size_t i) { return used.number(uint32_t(i)); });
        }
        const GltfAccessor list(model_, primitive.indices, {TINYGLTF_TYPE_SCALAR}, "indices");
        if (!list.holdsIndices()) throw LoadError("indices have a wrong component type");
        take(list.count() * perCorner);
        return triangleList(mode, list.count(), [&](std::size_t i) {
            const uint32_t vertex = list.index(i);
            if (vertex >= vertexCount) {
                throw LoadError("index " + std::to_string(vertex) + " is beyond the " +
                                std::to_string(vertexCount) + " vertices");
            }
            return used.number(vertex);
        });
    }

    const tinygltf::Model& model_;
    const std::vector<TextureCoordinates>& coordinates_;
    std::vector<std::string>& notes_;
    uint64_t indicesLeft_;
};

} // namespace

std::vector<MeshDescription> readGltfMeshes(const GltfFile& file,
                                            const std::vector<TextureCoordinates>& coordinates,
                                            std::vector<std::string>& notes) {
    MeshReader reader(file, coordinates, notes);
    std::vector<MeshDescription> meshes;
    for (const tinygltf::Mesh& mesh : file.model.meshes) {
        MeshDescription& description = meshes.emplace_back();
        for (const tinygltf::Primitive& primitive : mesh.primitives) {
            if (auto part = reader.read(primitive)) {
                description.parts.push_back(std::move(*part));
            }
        }
    }
    return meshes;
}

} // namespace samples
