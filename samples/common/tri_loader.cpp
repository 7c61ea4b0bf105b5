// SPDX-License-Identifier: MIT
#include "samples/common/tri_loader.h"

#include <cstring>
#include <utility>

#include "samples/common/confined_folder.h"

namespace samples {

SceneDescription loadTri(const std::filesystem::path& path) {
    const std::vector<uint8_t> bytes = readWholeFile(path, uint64_t(8) << 30);
    uint32_t count = 0;
    if (bytes.size() < sizeof count) throw LoadError("it is too short to hold a triangle count");
    std::memcpy(&count, bytes.data(), sizeof count);
    const uint64_t wanted = sizeof count + uint64_t(count) * 9 * sizeof(float);
    if (bytes.size() != wanted) {
        throw LoadError("it says that it has " + std::to_string(count) +
                        " triangles, which makes " + std::to_string(wanted) +
                        " bytes, but it has " + std::to_string(bytes.size()));
    }
    SceneDescription scene;
    if (count == 0) return scene;
    MeshPart part;
    part.positions.resize(std::size_t(count) * 3);
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    std::memcpy(part.positions.data(), bytes.data() + sizeof count, wanted - sizeof count);
    scene.meshes.emplace_back().parts.push_back(std::move(part));
    scene.instances.emplace_back();
    return scene;
}

} // namespace samples
