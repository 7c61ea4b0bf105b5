// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "libsmart/shading/fixed_state.h"
#include "libsmart/shading/shader_object.h"

namespace smart {

/// A fixed-function light as programmable surfaces see it: its diffuse colour, attenuated as in
/// OpenGL 1.5, section 2.13.1. What it is to specular and ambient terms they decide themselves.
std::shared_ptr<const ShaderObject> makeFrameLight(const FixedLight& light);

} // namespace smart
