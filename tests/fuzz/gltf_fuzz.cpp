// SPDX-License-Identifier: MIT
// glTF files, as text or, by their first four bytes, binary.
#include <cstring>

#include "tests/fuzz/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const bool binary = size >= 4 && std::memcmp(data, "glTF", 4) == 0;
    openrt::test::loadSceneFile(binary ? ".glb" : ".gltf", data, size);
    return 0;
}
