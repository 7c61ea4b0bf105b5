// SPDX-License-Identifier: MIT
// Pictures by latitude and longitude: OpenEXR and Radiance's format.
#include "samples/common/environment_file.h"

#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    try {
        samples::PixelBudget budget{1 << 20};
        const samples::Environment picture = samples::decodeEnvironment({data, size}, budget);
        if (picture.rgb.size() != std::size_t(3) * picture.width * picture.height) std::abort();
        for (const float number : picture.rgb)
            if (!std::isfinite(number) || number < 0) std::abort();
    } catch (const samples::LoadError&) {
    }
    return 0;
}
