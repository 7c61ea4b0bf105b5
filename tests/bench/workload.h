// SPDX-License-Identifier: MIT
// What is measured: triangles, and rays made once for all engines.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/view.h"
#include "tests/support/ray_sets.h"

namespace smart::bench {

/// Reads NAME.tri: a 32-bit count, then nine floats a triangle; or makes a bumpy sphere of about
/// N triangles for "generated:N". Throws std::runtime_error.
std::vector<Triangle> readTriangles(const std::string& scene);

struct View {
    test::CameraPose camera{{0.4, 0.7, 2.6}, {0, 0, 0}, {0, 1, 0}, 45}; ///< of generated scenes
    double light[3] = {2, 3, 2};
};

/// The line of a camera file that starts with `name`: eye, target, up, fov in degrees, light.
/// Throws std::runtime_error.
View readView(const std::string& file, const std::string& name);

/// Rays in two forms with the same numbers: packets, and arrays of all lanes one after another.
/// Lanes that are not active have limits out of order in the arrays.
struct RaySet {
    std::vector<RayPacket> packets;
    std::vector<float> org[3], dir[3], tNear, tFar;
    std::size_t active = 0;

    void add(const RayPacket& packet);
};

/// One ray a pixel, packets of 4x4 pixels, packets in Morton order.
RaySet primaryRays(const View& view, uint32_t size);

/// From what the primary rays hit, where that faces the light, to the light: t = 1. Origins lie
/// 4 units in the last place off the surface.
RaySet shadowRays(const View& view, const RaySet& primary, const ModelView& scene,
                  const std::vector<Triangle>& triangles);

} // namespace smart::bench
