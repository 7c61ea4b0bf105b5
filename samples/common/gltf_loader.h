// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "samples/common/scene_description.h"

namespace samples {

/// Reads the default scene of a .gltf or .glb file: nodes, meshes of triangles, materials with
/// textures, cameras, KHR_lights_punctual. A mesh used by several nodes is one mesh with several
/// instances. Throws LoadError.
SceneDescription loadGltf(const std::filesystem::path& path);

} // namespace samples
