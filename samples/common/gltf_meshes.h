// SPDX-License-Identifier: MIT
#pragma once

#include "samples/common/gltf_file.h"
#include "samples/common/scene_description.h"

namespace samples {

/// All meshes of a file, in its order; parts that are not triangles are left out with a note.
/// Throws LoadError.
std::vector<MeshDescription> readGltfMeshes(const GltfFile& file, std::vector<std::string>& notes);

} // namespace samples
