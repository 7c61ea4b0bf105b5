// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "samples/common/scene_description.h"

namespace samples {

/// Reads .glb, .gltf, .obj, .ply or .tri, as the file's name ends. Throws LoadError, whose text
/// is one line of bounded length.
SceneDescription loadScene(const std::filesystem::path& path);

/// Text from elsewhere as one line of printable characters and bounded length.
std::string oneLine(const std::string& text);

} // namespace samples
