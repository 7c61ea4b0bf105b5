// SPDX-License-Identifier: MIT
#include "compat/recorder/primitive_assembler.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace smart::compat {
namespace {

using Corners = std::array<uint32_t, 3>;
struct Expected {
    Corners corners;
    uint32_t provoking;
};

std::vector<Expected> assemble(PrimitiveAssembler& assembler, Primitive primitive, uint32_t first,
                               uint32_t count) {
    std::vector<Expected> found;
    assembler.begin(primitive);
    for (uint32_t i = 0; i < count; ++i) {
        AssembledTriangle out[PrimitiveAssembler::kMaxTriangles];
        const int made = assembler.add(first + i, out);
        for (int k = 0; k < made; ++k)
            found.push_back({{out[k].corners[0], out[k].corners[1], out[k].corners[2]},
                             out[k].provoking});
    }
    return found;
}

// The definitions, each triangle by its number in closed form. f is the first vertex.
std::vector<Expected> byDefinition(Primitive primitive, uint32_t f, uint32_t n) {
    std::vector<Expected> all;
    switch (primitive) {
    case Primitive::Triangles:
        for (uint32_t i = f; i + 3 <= f + n; i += 3) all.push_back({{i, i + 1, i + 2}, i + 2});
        break;
    case Primitive::TriangleStrip:
        for (uint32_t i = 0; i + 3 <= n; ++i) {
            const uint32_t v = f + i;
            all.push_back({i % 2 ? Corners{v + 1, v, v + 2} : Corners{v, v + 1, v + 2}, v + 2});
        }
        break;
    case Primitive::TriangleFan:
    case Primitive::Polygon:
        for (uint32_t i = 1; i + 2 <= n; ++i)
            all.push_back({{f, f + i, f + i + 1},
                           primitive == Primitive::Polygon ? f : f + i + 1});
        break;
    case Primitive::Quads:
        for (uint32_t i = f; i + 4 <= f + n; i += 4) {
            all.push_back({{i, i + 1, i + 2}, i + 3});
            all.push_back({{i, i + 2, i + 3}, i + 3});
        }
        break;
    case Primitive::QuadStrip:
        for (uint32_t i = f; i + 4 <= f + n; i += 2) {
            all.push_back({{i, i + 1, i + 3}, i + 3});
            all.push_back({{i, i + 3, i + 2}, i + 3});
        }
        break;
    default: break; // what is drawn in pixels has no triangles
    }
    return all;
}

constexpr Primitive kAll[] = {Primitive::Triangles, Primitive::TriangleStrip,
                              Primitive::TriangleFan, Primitive::Quads,
                              Primitive::QuadStrip,  Primitive::Polygon};

TEST(PrimitiveAssembler, FollowsTheDefinitionsForEveryCount) {
    PrimitiveAssembler assembler; // one for all: nothing is left over from what was incomplete
    for (uint32_t count = 0; count <= 17; ++count) {
        for (const Primitive primitive : kAll) {
            const auto found = assemble(assembler, primitive, 100, count);
            const auto expected = byDefinition(primitive, 100, count);
            ASSERT_EQ(found.size(), expected.size()) << int(primitive) << " of " << count;
            for (std::size_t i = 0; i < found.size(); ++i) {
                EXPECT_EQ(found[i].corners, expected[i].corners);
                EXPECT_EQ(found[i].provoking, expected[i].provoking);
            }
        }
    }
}

// Vertices on a zigzag or a circle: every triangle has to turn the same way.
TEST(PrimitiveAssembler, AllTrianglesTurnTheSameWay) {
    const auto area = [](const float (&p)[12][2], const Corners& c) {
        return (p[c[1]][0] - p[c[0]][0]) * (p[c[2]][1] - p[c[0]][1]) -
               (p[c[2]][0] - p[c[0]][0]) * (p[c[1]][1] - p[c[0]][1]);
    };
    float zigzag[12][2];
    for (int i = 0; i < 12; ++i) {
        zigzag[i][0] = float(i / 2);
        zigzag[i][1] = float(1 - i % 2);
    }
    PrimitiveAssembler assembler;
    for (const Primitive primitive : {Primitive::TriangleStrip, Primitive::QuadStrip}) {
        const auto found = assemble(assembler, primitive, 0, 12);
        ASSERT_EQ(found.size(), 10u);
        for (const Expected& triangle : found) EXPECT_GT(area(zigzag, triangle.corners), 0);
    }
}

using Edge = std::pair<uint32_t, uint32_t>;

/// Edges to be drawn; flags are bits by vertex.
std::multiset<Edge> edgesOf(Primitive primitive, uint32_t count, uint32_t flags) {
    PrimitiveAssembler assembler;
    assembler.begin(primitive);
    std::vector<AssembledTriangle> triangles;
    for (uint32_t i = 0; i < count; ++i) {
        AssembledTriangle out[PrimitiveAssembler::kMaxTriangles];
        const int made = assembler.add(i, out, (flags >> i & 1u) != 0);
        for (int k = 0; k < made; ++k) {
            if (out[k].extendsPolygon) triangles.back().boundary &= 3;
            triangles.push_back(out[k]);
        }
    }
    std::multiset<Edge> edges;
    for (const AssembledTriangle& triangle : triangles)
        for (int k = 0; k < 3; ++k)
            if (triangle.boundary >> k & 1)
                edges.insert({triangle.corners[k], triangle.corners[(k + 1) % 3]});
    return edges;
}

TEST(PrimitiveAssembler, EdgesAreThoseOfThePolygon) {
    for (uint32_t count = 3; count <= 7; ++count)
        for (uint32_t flags = 0; flags < 1u << count; ++flags) {
            std::multiset<Edge> polygon;
            for (uint32_t i = 0; i < count; ++i)
                if (flags >> i & 1u) polygon.insert({i, (i + 1) % count});
            EXPECT_EQ(edgesOf(Primitive::Polygon, count, flags), polygon);
        }
    for (uint32_t flags = 0; flags < 256; ++flags) {
        std::multiset<Edge> quads, triangles;
        for (uint32_t i = 0; i < 8; ++i)
            if (flags >> i & 1u) quads.insert({i, i % 4 == 3 ? i - 3 : i + 1});
        EXPECT_EQ(edgesOf(Primitive::Quads, 8, flags), quads);
        for (uint32_t i = 0; i < 6; ++i)
            if (flags >> i & 1u) triangles.insert({i, i % 3 == 2 ? i - 2 : i + 1});
        EXPECT_EQ(edgesOf(Primitive::Triangles, 6, flags), triangles);
    }
    // Strips ignore the flags; quads of a strip go 0, 1, 3, 2.
    const std::multiset<Edge> strip{{0, 1}, {1, 3}, {3, 2}, {2, 0}, {2, 3}, {3, 5}, {5, 4}, {4, 2}};
    EXPECT_EQ(edgesOf(Primitive::QuadStrip, 6, 0), strip);
    EXPECT_EQ(edgesOf(Primitive::TriangleFan, 5, 0).size(), 9u);
}

TEST(PrimitiveAssembler, PointsAndLinesHaveNoTriangles) {
    for (const Primitive primitive :
         {Primitive::Points, Primitive::Lines, Primitive::LineStrip, Primitive::LineLoop}) {
        EXPECT_FALSE(isFilled(primitive));
        EXPECT_TRUE(edgesOf(primitive, 9, 0x1FF).empty());
    }
    for (const Primitive primitive : kAll) EXPECT_TRUE(isFilled(primitive));
}

} // namespace
} // namespace smart::compat
