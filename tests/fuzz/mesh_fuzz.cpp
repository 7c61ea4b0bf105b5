// SPDX-License-Identifier: MIT
// Mesh files: ply by their first three bytes, obj otherwise.
#include <cstring>

#include "tests/fuzz/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const bool ply = size >= 3 && std::memcmp(data, "ply", 3) == 0;
    openrt::test::loadSceneFile(ply ? ".ply" : ".obj", data, size);
    return 0;
}
