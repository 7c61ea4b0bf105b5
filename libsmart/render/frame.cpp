// SPDX-License-Identifier: MIT
#include "libsmart/render/frame.h"

#include <algorithm>

namespace smart {

bool Frame::hasTransparency() const {
    std::call_once(transparencyOnce_, [this] {
        transparency_ = shaders && std::ranges::any_of(*shaders, [](const auto& shader) {
                            return shader && shader->shaderClass().kind() == RT_SURFACE_SHADER &&
                                   shader->functions().transparency;
                        });
    });
    return transparency_;
}

} // namespace smart
