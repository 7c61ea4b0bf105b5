// SPDX-License-Identifier: MIT
#include "libsmart/accel/spatial_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "libsmart/accel/triangle_clip.h"

namespace smart {
namespace {

using Vertices = std::array<float, 9>;

/// References to triangles, some of them to a part only, as splits leave them.
struct Parts {
    std::vector<Vertices> triangles;
    std::vector<BoxReference> references;
    Box4 box;

    Aabb clipped(std::size_t number, const Aabb& cell) const {
        const float* const v = triangles[number].data();
        return clipTriangle(v, v + 3, v + 6, cell);
    }
    void add(const Vertices& triangle, const Aabb& cell) {
        triangles.push_back(triangle);
        const Aabb part = clipped(triangles.size() - 1, cell);
        if (part.empty()) return;
        references.emplace_back(Box4(part), uint32_t(triangles.size() - 1));
        box.add(references.back());
    }
};

Parts randomParts(int count, float scale, uint32_t seed) {
    std::mt19937 generator(seed);
    const auto uniform = [&] { return scale * (float(generator() >> 8) * 0x1p-23f - 1); };
    Parts parts;
    for (int i = 0; i < count; ++i) {
        Vertices triangle;
        for (float& x : triangle) x = uniform();
        if (i % 5 == 0) triangle[3] = triangle[0]; // an edge along the planes
        if (i % 7 == 0) triangle[1] = triangle[4] = triangle[7];
        Aabb cell{{-scale, -scale, -scale}, {scale, scale, scale}};
        if (i % 3 == 0)
            for (int k = 0; k < 3; ++k) {
                const auto [lo, hi] = std::minmax({uniform(), uniform()});
                cell.lo[k] = lo;
                cell.hi[k] = hi;
            }
        parts.add(triangle, cell);
    }
    return parts;
}

struct Sides {
    Box4 box[2];
    uint32_t count[2] = {};
};

/// What lies on both sides of a plane, each triangle clipped by itself.
Sides sidesOf(const Parts& parts, const SpacePlanes& planes, int axis, int i) {
    Sides sides;
    const float plane = planes.plane(axis, i);
    for (const BoxReference& reference : parts.references) {
        const bool onSide[2] = {planes.binsOf(reference.lo)[axis] < i,
                                planes.binsOf(reference.hi)[axis] >= i};
        for (int side = 0; side < 2; ++side) {
            if (!onSide[side]) continue;
            ++sides.count[side];
            Aabb cell = reference.aabb();
            if (side == 0)
                cell.hi[axis] = std::min(cell.hi[axis], plane);
            else
                cell.lo[axis] = std::max(cell.lo[axis], plane);
            const Aabb part = parts.clipped(reference.number(), cell);
            if (!part.empty()) sides.box[side].add(Box4(part));
        }
    }
    return sides;
}

TEST(SpatialBins, FindWhatClippingEachTriangleAtEachPlaneFinds) {
    for (const int count : {12, 100, 400}) // four, eight and sixteen bins
        for (uint32_t seed = 1; seed <= 20; ++seed) {
            const Parts parts = randomParts(count, 10.0f, seed);
            const SpacePlanes planes(parts.box, parts.references.size());
            const BoxMeasure measure(parts.box);
            SpatialBins bins;
            bins.add(parts.references, parts.triangles.front().data(), planes);
            const SpatialSplit split = bins.best(planes, measure, 10000);
            float least = Aabb::kInf;
            for (int axis = 0; axis < 3; ++axis)
                for (int i = 1; i < planes.bins(); ++i) {
                    const Sides sides = sidesOf(parts, planes, axis, i);
                    const float cost = measure(sides.box[0]) * float(sides.count[0]) +
                                       measure(sides.box[1]) * float(sides.count[1]);
                    const bool isBest = split.axis == axis && split.plane == planes.plane(axis, i);
                    if (isBest) {
                        EXPECT_EQ(split.leftCount, sides.count[0]);
                        EXPECT_EQ(split.rightCount, sides.count[1]);
                        for (int k = 0; k < 3; ++k) {
                            EXPECT_NEAR(split.left.lo[k], sides.box[0].lo[k], 1e-3f);
                            EXPECT_NEAR(split.left.hi[k], sides.box[0].hi[k], 1e-3f);
                            EXPECT_NEAR(split.right.lo[k], sides.box[1].lo[k], 1e-3f);
                            EXPECT_NEAR(split.right.hi[k], sides.box[1].hi[k], 1e-3f);
                        }
                        EXPECT_NEAR(split.cost / cost, 1, 1e-3f);
                    }
                    if (std::max(sides.count[0], sides.count[1]) < parts.references.size())
                        least = std::min(least, cost);
                }
            EXPECT_NEAR(split.cost / least, 1, 1e-3f) << count << " triangles, seed " << seed;
        }
}

TEST(SpatialBins, NumbersAtTheEndsOfFloatDoNoHarm) {
    for (const float scale : {1e-44f, 1e-30f, 1e18f, 1e38f}) {
        const Parts parts = randomParts(100, scale, 3);
        const SpacePlanes planes(parts.box, parts.references.size());
        const BoxMeasure measure(parts.box);
        SpatialBins bins;
        bins.add(parts.references, parts.triangles.front().data(), planes);
        const SpatialSplit split = bins.best(planes, measure, 10000);
        EXPECT_FALSE(std::isnan(split.cost)) << scale;
        if (!(split.cost < Aabb::kInf)) continue;
        SplitSides sides;
        divideAtPlane(parts.references, parts.triangles.front().data(), split, measure, 10000,
                      sides);
        EXPECT_GE(sides.left.size() + sides.right.size(), parts.references.size()) << scale;
    }
}

} // namespace
} // namespace smart
