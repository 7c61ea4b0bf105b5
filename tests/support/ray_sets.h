// SPDX-License-Identifier: MIT
// Rays by rule: fixed seeds, the same on every machine.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "libsmart/kernel/packet.h"
#include "libsmart/kernel/view.h"

namespace smart::test {

/// Deterministic numbers, equal on every platform (SplitMix64).
class Random {
public:
    explicit Random(uint64_t seed) : state_(seed) {}
    uint64_t bits();
    double unit(); ///< [0, 1)
    double between(double lo, double hi) { return lo + (hi - lo) * unit(); }
    uint32_t below(uint32_t count) { return uint32_t(bits() % count); }
    std::array<double, 3> onSphere();

private:
    uint64_t state_;
};

enum class Target { Vertex, Edge, Interior };

/// How an aimed ray is made. Exact: origin and target lie on a grid of 2^-16 (so must the mesh),
/// direction = target - origin without rounding, t = 1. Rounded: the direction is rounded.
/// Normalised: scaled to length 1 in double, then rounded.
enum class Aim { Exact, Rounded, Normalised };

Ray makeRay(const double origin[3], const double target[3], Aim aim);

/// Corners moved to the nearest multiple of 2^-bits.
std::vector<Triangle> snapped(std::vector<Triangle> triangles, int bits);

/// Between random points of the bounding box enlarged 1.5 times.
std::vector<Ray> randomRays(std::span<const Triangle> triangles, std::size_t count, uint64_t seed);

/// At random vertices, edges or interiors of a closed, roughly spherical mesh about the origin of
/// the given radius, from 1.5 to 3 radii away, where the target is in sight.
std::vector<Ray> raysFromOutside(std::span<const Triangle> triangles, double radius,
                                 std::size_t count, Target target, Aim aim, uint64_t seed);

/// The same from random points within half the radius.
std::vector<Ray> raysFromInside(std::span<const Triangle> triangles, double radius,
                                std::size_t count, Target target, Aim aim, uint64_t seed);

/// One or two components of each direction are +0 or -0; origins in [-halfSize, halfSize]^3 on
/// multiples of `step`, or anywhere for step 0.
std::vector<Ray> axisParallelRays(double halfSize, double step, std::size_t count, uint64_t seed);

struct CameraPose {
    double eye[3], target[3], up[3];
    double fov; ///< vertical, degrees
};

/// One ray through each pixel, (dx, dy) pixels off its centre, in blocks of 4x4 pixels, block after
/// block: the order of packets. Width and height are multiples of 4.
std::vector<Ray> cameraRays(const CameraPose& pose, uint32_t width, uint32_t height, double dx = 0,
                            double dy = 0);

/// Rays first..first+15 as a packet; missing ones are inactive.
RayPacket packet(std::span<const Ray> rays, std::size_t first);

} // namespace smart::test
