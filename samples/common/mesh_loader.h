// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "samples/common/scene_description.h"

namespace samples {

/// Reads .obj (with the materials and textures of its .mtl file) and .ply. Throws LoadError.
SceneDescription loadMesh(const std::filesystem::path& path);

} // namespace samples
