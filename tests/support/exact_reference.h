// SPDX-License-Identifier: MIT
// The truth about rays and triangles in exact arithmetic: brute force over all triangles, every
// decision by the sign of an integer determinant. Nothing of the library's traversal is used.
#pragma once

#include <gmpxx.h>

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "libsmart/kernel/packet.h"
#include "tests/support/mesh_topology.h"

namespace smart::test {

/// Affine map, three rows of four, the fourth column the translation.
using Matrix34 = std::array<double, 12>;

/// One place where the line of a ray meets a closed triangle, and where exactly.
struct ExactCrossing : Touch {
    mpq_class t, u, v;
};

/// What a ray must and may hit. The nearest must layer is the first crossing in the interior of a
/// triangle, or on an edge (vertex) whose two (all) triangles face the ray the same way. Boundary
/// and silhouette touches, and crossings at a range limit, are mays: both answers are right.
struct ExactAnswer {
    bool must = false;
    std::vector<ExactCrossing> nearest; ///< crossings of the must layer: exact ties
    std::vector<ExactCrossing> touches; ///< mays not behind the must layer
};

class ExactReference {
public:
    /// Adds triangles as they are; the first gets the returned number, the others follow.
    uint32_t add(std::span<const Triangle> triangles);
    /// Adds triangles multiplied exactly by the matrices, the outermost first in the list. Where
    /// one is not finite, all its triangles count as degenerate.
    uint32_t add(std::span<const Triangle> triangles, std::span<const Matrix34> toWorld);

    uint32_t count() const { return uint32_t(corners_.size()); }
    /// Corners in world space, rounded to double (exact when no matrix was given).
    const std::array<double, 9>& corners(uint32_t triangle) const { return corners_[triangle]; }
    /// Not finite, or of no area in exact arithmetic: nothing can hit it.
    bool degenerate(uint32_t triangle) const { return degenerate_[triangle] != 0; }

    const MeshTopology& topology() const { return topology_; }
    /// Whether corners() are the corners themselves.
    bool exactInDouble(uint32_t triangle) const;

    /// Where the ray's line, at any t, meets one triangle; false if nowhere or along its plane.
    bool crosses(uint32_t triangle, const Ray& ray, ExactCrossing& crossing) const;
    /// The truth for a ray; limits as documented at RayPacket.
    ExactAnswer nearest(const Ray& ray) const;

    /// Largest absolute coordinate and largest side of the bounding box.
    double maxAbs() const { return maxAbs_; }
    double extent() const;

private:
    struct Determinants {
        mpz_class w[3], volume, sum; ///< t = volume / sum, weights w / sum
    };
    uint32_t append(std::span<const Triangle> triangles, std::span<const Matrix34> toWorld);
    void exactCorners(uint32_t triangle, int shift, mpz_class corners[9]) const;
    bool isDegenerate(uint32_t triangle) const;
    void determinants(uint32_t triangle, const Ray& ray, Determinants& result) const;
    bool certainlyMissed(uint32_t triangle, const Ray& ray) const;

    std::vector<std::array<double, 9>> corners_;
    std::map<uint32_t, std::array<mpq_class, 9>> exact_; ///< where corners_ are rounded
    std::vector<uint8_t> degenerate_;
    MeshTopology topology_;
    std::vector<double> centre_[3], radius_;        ///< bounding spheres, rounded up
    double maxAbs_ = 0;
    double lo_[3], hi_[3];
    int shift_ = 0; ///< every coordinate is an integer after multiplication with 2^shift_
};

/// |value - exact| in units of the last place of a float at `exact`.
double ulpError(float value, const mpq_class& exact);

/// The same question answered another way, after Moeller and Trumbore (1997), in rationals.
bool crossesMollerTrumbore(const Triangle& triangle, const Ray& ray, ExactCrossing& crossing);

} // namespace smart::test
