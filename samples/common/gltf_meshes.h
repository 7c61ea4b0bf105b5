// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>

#include "samples/common/gltf_file.h"
#include "samples/common/scene_description.h"

namespace samples {

/// Where the textures of a material take their coordinates from: a set of the mesh's, moved by
/// KHR_texture_transform.
struct TextureCoordinates {
    int set = 0;
    glm::mat3 transform{1.0f};

    bool operator==(const TextureCoordinates&) const = default;
};

/// All meshes of a file, in its order; `coordinates`: one for each of its materials. Parts that are
/// not triangles are left out with a note. Throws LoadError.
std::vector<MeshDescription> readGltfMeshes(const GltfFile& file,
                                            const std::vector<TextureCoordinates>& coordinates,
                                            std::vector<std::string>& notes);

} // namespace samples
