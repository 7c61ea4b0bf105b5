// SPDX-License-Identifier: MIT
#include "libsmart/geometry/triangle_corners.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace smart {
namespace {

using Corners = TriangleCorners::Corners;

void expectStored(const std::vector<Corners>& expected) {
    TriangleCorners corners;
    for (const Corners& triangle : expected) {
        corners.makeRoom(1);
        corners.push_back(triangle);
    }
    for (int pass = 0; pass < 2; ++pass) {
        ASSERT_EQ(corners.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(corners[i], expected[i]) << i;
        corners.shrink_to_fit();
    }
}

TEST(TriangleCornersTest, GivesBackWhatWasAppended) {
    std::mt19937 random(5);
    for (int round = 0; round < 200; ++round) {
        std::vector<Corners> all;
        uint32_t vertex = 0;
        while (all.size() < 300) {
            const uint32_t length = random() % 40;
            switch (random() % 5) {
            case 0: // separate triangles
                for (uint32_t i = 0; i < length; ++i, vertex += 3)
                    all.push_back({vertex, vertex + 1, vertex + 2});
                break;
            case 1: // a strip
                for (uint32_t i = 0; i < length; ++i, ++vertex)
                    all.push_back({vertex + i % 2, vertex + 1 - i % 2, vertex + 2});
                vertex += 2;
                break;
            case 2: // a fan
                for (uint32_t i = 0; i < length; ++i)
                    all.push_back({vertex, vertex + i + 1, vertex + i + 2});
                vertex += length + 2;
                break;
            case 3: // quads
                for (uint32_t i = 0; i < length; ++i, vertex += 4) {
                    all.push_back({vertex, vertex + 1, vertex + 2});
                    all.push_back({vertex, vertex + 2, vertex + 3});
                }
                break;
            default: // anything
                all.push_back({uint32_t(random()), uint32_t(random()), uint32_t(random())});
            }
        }
        expectStored(all);
    }
}

TEST(TriangleCornersTest, RegularOnesTakeNextToNothing) {
    TriangleCorners triangles, strip;
    for (uint32_t i = 0; i < 100000; ++i) {
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
        strip.push_back({i + i % 2, i + 1 - i % 2, i + 2});
    }
    triangles.shrink_to_fit();
    strip.shrink_to_fit();
    EXPECT_LT(triangles.bytes(), 100000 / 10);
    EXPECT_LT(strip.bytes(), 100000 / 10);
    EXPECT_NE(triangles, strip);
    EXPECT_EQ(triangles, TriangleCorners(triangles));
}

TEST(TriangleCornersTest, IrregularOnesTakeLittleMoreThanTheirNumbers) {
    std::mt19937 random(6);
    TriangleCorners corners;
    for (uint32_t i = 0; i < 100000; ++i)
        corners.push_back({uint32_t(random()), uint32_t(random()), uint32_t(random())});
    corners.shrink_to_fit();
    EXPECT_LT(corners.bytes(), 100000 * 16);
}

} // namespace
} // namespace smart
