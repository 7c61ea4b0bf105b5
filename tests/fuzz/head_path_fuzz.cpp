// SPDX-License-Identifier: MIT
// Recorded heads, as openrt-cave replays them.
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

#include "samples/vr/head_path.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
    std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
    try {
        const samples::HeadPath path(stream, "head");
        for (const double share : {-1.0, 0.0, 0.3, 1.0, 2.0}) {
            const glm::dvec3 eye = path.at(share * path.end()).eye(1, 0.06);
            if (!std::isfinite(eye.x + eye.y + eye.z)) std::abort();
        }
    } catch (const std::runtime_error&) { // a refusal
    }
    return 0;
}
