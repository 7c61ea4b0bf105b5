// SPDX-License-Identifier: MIT
// Files of bare triangles.
#include "tests/fuzz/scene_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    openrt::test::loadSceneFile(".tri", data, size);
    return 0;
}
