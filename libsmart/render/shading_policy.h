// SPDX-License-Identifier: MIT
// How a tracer reaches the surface shaders: through their class's functions, whatever the class,
// or, compiled for one class, directly.
#pragma once

#include "libsmart/shading/shader_object.h"
#include "openrt/rts_packet.h"

namespace smart {

/// Surfaces of any class.
struct DynamicShading {
    template <class Services>
    static int shade(const ShaderObject& surface, RTSstate& state) {
        return surface.functions().shade(surface.block(), &state);
    }
    static bool answersTransparency(const ShaderObject& surface) {
        return surface.functions().transparency != nullptr;
    }
    template <class Services>
    static int transparency(const ShaderObject& surface, RTSstate& state, float (&rgb)[3]) {
        return surface.functions().transparency(surface.block(), &state, rgb);
    }
};

} // namespace smart
