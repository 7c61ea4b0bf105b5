// SPDX-License-Identifier: MIT
#include "libsmart/accel/triangle_clip.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/procedural_meshes.h"

namespace smart {
namespace {

using Point = std::array<mpq_class, 3>;

/// The exact polygon of a triangle within a cell, faces included; in rational numbers.
std::vector<Point> clipExactly(const Triangle& triangle, const Aabb& cell) {
    std::vector<Point> polygon;
    for (const float* v : {triangle.v0, triangle.v1, triangle.v2}) {
        polygon.push_back({mpq_class(v[0]), mpq_class(v[1]), mpq_class(v[2])});
    }
    for (std::size_t k = 0; k < 3; ++k) {
        for (const int sign : {-1, 1}) {
            const mpq_class plane(sign < 0 ? cell.lo[k] : cell.hi[k]);
            std::vector<Point> kept;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
                const mpq_class da = sign * (a[k] - plane), db = sign * (b[k] - plane);
                if (da <= 0) kept.push_back(a);
                if ((da < 0 && db > 0) || (da > 0 && db < 0)) {
                    Point crossing;
                    for (std::size_t j = 0; j < 3; ++j) {
                        crossing[j] = a[j] + da / (da - db) * (b[j] - a[j]);
                    }
                    kept.push_back(crossing);
                }
            }
            polygon = std::move(kept);
        }
    }
    return polygon;
}

struct Verdict {
    int nonEmpty = 0, clippedEnds = 0, notContained = 0, loose = 0, outsideCell = 0;
};

/// Compares a clipping function with the exact one on random triangles and cells about `offset`.
template <class Clip>
Verdict compareWithExact(const Clip& clip, float offset, float scale, int rounds, uint32_t seed) {
    Verdict verdict;
    std::mt19937 generator(seed);
    const auto uniform = [&] { return offset + scale * (float(generator() >> 8) * 0x1p-23f - 1); };
    for (int round = 0; round < rounds; ++round) {
        Triangle triangle;
        Aabb cell;
        float corner[2][3];
        for (int k = 0; k < 3; ++k) {
            for (float* v : {triangle.v0, triangle.v1, triangle.v2, corner[0], corner[1]}) {
                v[k] = uniform();
            }
        }
        if (round % 4 == 1) std::copy_n(triangle.v1, 3, corner[0]); // a vertex on the cell's corner
        if (round % 4 == 2) triangle.v0[1] = triangle.v1[1] = triangle.v2[1] = corner[0][1];
        if (round % 4 == 3) std::copy_n(triangle.v0, 3, triangle.v2); // degenerate
        cell.add(corner[0]);
        cell.add(corner[1]);
        const Aabb box = clip(triangle, cell);
        const std::vector<Point> exact = clipExactly(triangle, cell);
        if (exact.empty()) continue;
        ++verdict.nonEmpty;
        for (std::size_t k = 0; k < 3; ++k) {
            mpq_class lo = exact[0][k], hi = exact[0][k];
            for (const Point& p : exact) {
                if (p[k] < lo) lo = p[k];
                if (p[k] > hi) hi = p[k];
            }
            if (box.empty() || mpq_class(box.lo[k]) > lo || mpq_class(box.hi[k]) < hi) {
                ++verdict.notContained;
                continue;
            }
            verdict.outsideCell += box.lo[k] < cell.lo[k] || box.hi[k] > cell.hi[k];
            // A thin triangle's end moves further than the cell is enlarged: by its slope. Random
            // triangles are seldom that steep, so count instead of forbidding.
            const double slack =
                16 * 0x1p-22 * std::fmax(std::fabs(cell.lo[k]), std::fabs(cell.hi[k]));
            const mpq_class looseLo = lo - box.lo[k], looseHi = box.hi[k] - hi;
            verdict.loose += looseLo > slack || looseHi > slack;
            verdict.clippedEnds += sgn(looseLo) != 0 || sgn(looseHi) != 0;
        }
    }
    return verdict;
}

Aabb clip(const Triangle& triangle, const Aabb& cell) {
    return clipTriangle(triangle.v0, triangle.v1, triangle.v2, cell);
}

TEST(TriangleClip, ContainsTheExactPartAndLittleMore) {
    for (const auto& [offset, scale] : {std::pair{0.0f, 1.0f}, {0.0f, 1e-30f}, {0.0f, 1e30f},
                                        {1000.0f, 1.0f}, {-3e5f, 1.0f}, {0.0f, 1e-44f}}) {
        const Verdict verdict = compareWithExact(clip, offset, scale, 3000, 11);
        EXPECT_GT(verdict.nonEmpty, 500);
        EXPECT_EQ(verdict.notContained, 0) << offset << " " << scale;
        EXPECT_EQ(verdict.outsideCell, 0) << offset << " " << scale;
        if (scale > 1e-40f) {
            EXPECT_LT(verdict.loose, verdict.nonEmpty / 20) << offset << " " << scale;
        }
    }
}

TEST(TriangleClip, ControlInwardRoundingIsSeen) {
    const auto inward = [](const Triangle& triangle, const Aabb& cell) {
        Aabb box = clip(triangle, cell);
        for (int k = 0; k < 3; ++k) {
            const float pad =
                0x1p-20f * std::fmax(std::fabs(cell.lo[k]), std::fabs(cell.hi[k]));
            if (box.lo[k] + pad <= box.hi[k] - pad) {
                box.lo[k] += pad;
                box.hi[k] -= pad;
            }
        }
        return box;
    };
    EXPECT_GT(compareWithExact(inward, 0, 1, 500, 11).notContained, 100);
}

TEST(TriangleClip, InsideIsItsOwnBoxExactly) {
    for (const Triangle& triangle : test::triangleSoup(100, 0.1f, 4)) {
        Aabb cell;
        for (const float x : {-2.0f, 2.0f}) {
            const float p[3] = {x, x, x};
            cell.add(p);
        }
        const Aabb box = clip(triangle, cell);
        for (int k = 0; k < 3; ++k) {
            EXPECT_EQ(box.lo[k], std::min({triangle.v0[k], triangle.v1[k], triangle.v2[k]}));
            EXPECT_EQ(box.hi[k], std::max({triangle.v0[k], triangle.v1[k], triangle.v2[k]}));
        }
    }
}

TEST(TriangleClip, DisjointIsEmptyEvenWhereTheBoxesMeet) {
    // The triangle passes a corner of the cell: boxes overlap, the triangle does not.
    const Triangle triangle{{2, 0, 0.5f}, {0, 2, 0.5f}, {2, 2, 0.5f}};
    Aabb cell;
    const float lo[3] = {0, 0, 0}, hi[3] = {0.9f, 0.9f, 1};
    cell.add(lo);
    cell.add(hi);
    EXPECT_TRUE(clip(triangle, cell).empty());
    cell.hi[0] = cell.hi[1] = 1; // now it touches in one point, which belongs to both
    EXPECT_FALSE(clip(triangle, cell).empty());
}

} // namespace
} // namespace smart
