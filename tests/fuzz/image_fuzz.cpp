// SPDX-License-Identifier: MIT
// Pictures as scenes have them for textures: PNG and JPEG.
#include "samples/common/image_file.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    try {
        samples::PixelBudget budget{1 << 20};
        (void)samples::decodeImage({data, size}, budget);
    } catch (const samples::LoadError&) {
    }
    return 0;
}
