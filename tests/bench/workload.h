// SPDX-License-Identifier: MIT
// What is measured: triangles, and rays made once for all engines.
#pragma once

#include <cstdint>
#include <span>
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

/// What is asked about a ray: its nearest hit, or whether there is one.
enum class Query { Closest, Any };

/// Rays in two forms with the same numbers: packets, and arrays of all lanes one after another.
/// Lanes that are not active have limits out of order in the arrays.
struct RaySet {
    std::vector<RayPacket> packets;
    std::vector<float> org[3], dir[3], tNear, tFar;
    std::size_t active = 0;

    void add(const RayPacket& packet);
    void add(std::span<const Ray> rays); ///< sixteen a packet
};

/// One ray a pixel, packets of 4x4 pixels, packets in Morton order. All go through one place of
/// their pixels, which `seed` chooses; 0 is the centre.
RaySet primaryRays(const View& view, uint32_t size, uint64_t seed = 0);

/// Where a primary ray ends: 4 units in the last place off the surface, on the ray's side.
struct SurfacePoint {
    float position[3];
    double normal[3]; ///< of length 1, on the ray's side
};

/// What the primary rays see. Points of a packet lie at its lanes; `seen` tells which there are.
struct SurfacePacket {
    SurfacePoint point[kPacketSize];
    uint32_t seen = 0;
};
std::vector<SurfacePacket> surfacePoints(const RaySet& primary, const ModelView& scene,
                                         const std::vector<Triangle>& triangles);

/// From the points that face the light to the light: t = 1.
RaySet shadowRays(const View& view, std::span<const SurfacePacket> points);

/// `count` rays a point, those of a point adjacent, with the cosine's distribution, as far as
/// tFar; directions are of length 1.
RaySet diffuseRays(std::span<const SurfacePacket> points, uint32_t count, float tFar,
                   uint64_t seed);

/// Of the box around all corners.
double diagonalOf(const std::vector<Triangle>& triangles);

} // namespace smart::bench
