// SPDX-License-Identifier: MIT
#include "libsmart/shading/fixed_state.h"

namespace smart {

FixedState::FixedState() {
    lighting.lights[0].diffuse = lighting.lights[0].specular = glm::vec4(1.0f);
}

bool FixedState::isOpaque() const {
    const bool allWritten =
        ops.colorMask[0] && ops.colorMask[1] && ops.colorMask[2] && ops.colorMask[3];
    const bool nearest = ops.depthTest && ops.depthMask &&
                         (ops.depthFunction == CompareFunction::Less ||
                          ops.depthFunction == CompareFunction::LessEqual);
    return nearest && allWritten && !ops.blend && !ops.alphaTest && !ops.colorLogicOp &&
           !raster.offsetFill && !raster.polygonStippled;
}

} // namespace smart
