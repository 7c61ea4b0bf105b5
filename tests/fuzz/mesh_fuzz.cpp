// SPDX-License-Identifier: MIT
// Mesh files: ply by their first three bytes, obj otherwise.
#include <cstring>

#include "tests/fuzz/scene_file.h"

// Assimp 5.2 forgets the mesh in which it finds an index beyond the vertices.
extern "C" [[gnu::visibility("default")]] const char* __lsan_default_suppressions() {
    return "leak:libassimp";
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    const bool ply = size >= 3 && std::memcmp(data, "ply", 3) == 0;
    openrt::test::loadSceneFile(ply ? ".ply" : ".obj", data, size);
    return 0;
}
