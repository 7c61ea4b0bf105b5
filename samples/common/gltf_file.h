// SPDX-License-Identifier: MIT
#pragma once

#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace samples {

/// A parsed glTF file. Images are left encoded: in `image` of those from files and data URIs, in
/// their buffer view otherwise. Indices and ranges inside the model are still unchecked.
struct GltfFile {
    tinygltf::Model model;
    uint64_t bufferBytes = 0;
};

/// Whether the loader does what an extension asks for.
bool knowsGltfExtension(std::string_view name);

/// Reads .gltf and .glb. The container and the shape of the JSON are checked before tinygltf sees
/// them, and files it refers to are read through ConfinedFolder. Throws LoadError.
GltfFile readGltf(const std::filesystem::path& path);

} // namespace samples
