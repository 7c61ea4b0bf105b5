// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>

#include "libsmart/render/camera_rays.h"
#include "libsmart/render/ray_services.h"

namespace smart {

/// A pixel as the frame's rendering object made it.
struct PixelResult {
    glm::vec4 color{0.0f, 0.0f, 0.0f, 1.0f};
    bool bad = false;      ///< the object or a shader failed, or the colour is not finite: black
    bool hasFirst = false; ///< some camera ray was traced; then these are the first one and what
    Ray firstRay;          ///< it found
    ShadedSample first;
};

/// Lets the frame's rendering object make one pixel. Precondition: the frame has one.
PixelResult renderPixel(const Frame& frame, const CameraRays& camera, RayServices& services,
                        uint32_t x, uint32_t y);

} // namespace smart
