// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "samples/common/scene_description.h"

namespace samples {

/// Bare triangles: a 32-bit count, then nine 32-bit floats for each triangle (x, y, z of three
/// vertices), little endian. Throws LoadError.
SceneDescription loadTri(const std::filesystem::path& path);

} // namespace samples
