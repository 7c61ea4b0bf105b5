// SPDX-License-Identifier: MIT
#include "libsmart/render/frame.h"

namespace smart {

const FrameShading& Frame::shading() const {
    std::call_once(shadingOnce_, [this] {
        static const ShaderTable none;
        shading_ = findFrameShading(*scene, shaders ? *shaders : none, lights);
    });
    return shading_;
}

} // namespace smart
