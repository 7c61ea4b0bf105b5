// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "libsmart/geometry/triangle_tree.h"
#include "tests/libsmart/accel/wide_tree_check.h"
#include "tests/support/woop_brute_force.h"

namespace smart {
namespace {

using test::Claim;

constexpr WideQuality kQualities[] = {WideQuality::Fast, WideQuality::Binned, WideQuality::Spatial};

bool meets(const Ray& ray, const WideNode& node, int slot) {
    double near = ray.tNear, far = ray.tFar;
    for (int k = 0; k < 3; ++k) {
        const double a = (double(node.lo[k][slot]) - 1e-5 - ray.org[k]) / ray.dir[k];
        const double b = (double(node.hi[k][slot]) + 1e-5 - ray.org[k]) / ray.dir[k];
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    return near <= far && node.lo[0][slot] <= node.hi[0][slot];
}

/// The triangles in the leaves whose boxes a ray meets; each must be the one of its number.
std::set<uint32_t> candidates(const TriangleTree& tree, const Ray& ray,
                              const std::vector<Triangle>& triangles) {
    std::set<uint32_t> found;
    std::vector<uint32_t> open;
    if (!tree.empty()) open.push_back(0);
    while (!open.empty()) {
        const WideNode& node = tree.nodes()[open.back()];
        open.pop_back();
        for (int slot = 0; slot < kWideChildren; ++slot) {
            if (!meets(ray, node, slot)) continue;
            const uint32_t child = node.child[slot];
            if (!(child & kWideLeaf)) {
                open.push_back(child);
                continue;
            }
            const std::size_t first = (child & ~kWideLeaf) >> 4, count = (child & 15u) + 1;
            const float* const block = tree.blocks() + first * kWordsOfTriangle;
            for (std::size_t i = 0; i < count; ++i) {
                uint32_t number;
                std::memcpy(&number, block + 9 * count + i, sizeof number);
                found.insert(number);
                const Triangle& t = triangles.at(number);
                for (std::size_t k = 0; k < 3; ++k) {
                    EXPECT_EQ(block[k * count + i], t.v0[k]);
                    EXPECT_EQ(block[(3 + k) * count + i], t.v1[k]);
                    EXPECT_EQ(block[(6 + k) * count + i], t.v2[k]);
                }
            }
        }
    }
    return found;
}

/// Rays whose nearest triangle the tree does not lead to.
int lost(const TriangleTree& tree, const std::vector<Triangle>& triangles) {
    int count = 0, hits = 0;
    for (const Ray& ray : test::randomRays(triangles, 300, 5)) {
        const Claim truth = test::woopNearest<false>(triangles, ray);
        if (!std::isfinite(truth.t)) continue;
        ++hits;
        count += candidates(tree, ray, triangles).count(truth.triangle) == 0;
    }
    EXPECT_GT(hits, 40);
    return count;
}

std::vector<Triangle> deformed(std::vector<Triangle> triangles, double by, uint64_t seed) {
    test::Random random(seed);
    for (Triangle& t : triangles)
        for (float* corner : {t.v0, t.v1, t.v2})
            for (int k = 0; k < 3; ++k) corner[k] += float(by * (random.unit() - 0.5));
    return triangles;
}

TEST(TriangleTree, LeadsToWhatBruteForceFinds) {
    const std::vector<Triangle> triangles = test::mixedTriangles(3000, 1);
    for (const WideQuality quality : kQualities) {
        const TriangleTree tree(triangles, test::boxesOf(triangles), quality, 2);
        EXPECT_EQ(lost(tree, triangles), 0);
        EXPECT_EQ(tree.decay(), 1.0f);
        EXPECT_GE(tree.entries(), triangles.size());
        EXPECT_LE(tree.bytes(), triangles.size() * 70);
    }
}

TEST(TriangleTree, RefittedItLeadsToWhereTrianglesWent) {
    const std::vector<Triangle> triangles = test::mixedTriangles(3000, 2);
    for (const WideQuality quality : kQualities) {
        TriangleTree tree(triangles, test::boxesOf(triangles), quality, 1);
        for (int step = 1; step <= 3; ++step) {
            const std::vector<Triangle> moved = deformed(triangles, 0.1 * step, step);
            std::optional<TriangleTree> next =
                tree.refitted(moved, test::boxesOf(moved), unsigned(step));
            ASSERT_TRUE(next);
            EXPECT_EQ(lost(*next, moved), 0);
            EXPECT_EQ(next->entries(), tree.entries());
            EXPECT_GT(next->decay(), 1.0f);
            EXPECT_EQ(lost(tree, step == 1 ? triangles : deformed(triangles, 0.1 * (step - 1),
                                                                  step - 1)),
                      0); // the old one is as it was
            tree = std::move(*next);
        }
    }
}

TEST(TriangleTree, ControlUnfittedTreesLoseHits) {
    const std::vector<Triangle> triangles = test::mixedTriangles(3000, 2);
    const std::vector<Triangle> moved = deformed(triangles, 0.3, 3);
    const TriangleTree tree(moved, test::boxesOf(triangles), WideQuality::Binned, 1);
    EXPECT_GT(lost(tree, moved), 0);
}

TEST(TriangleTree, DecayTellsWhenANewTreePays) {
    const std::vector<Triangle> triangles = test::mixedTriangles(3000, 4);
    const TriangleTree tree(triangles, test::boxesOf(triangles), WideQuality::Fast, 1);
    const std::vector<Triangle> little = deformed(triangles, 0.001, 1);
    EXPECT_LT(tree.refitted(little, test::boxesOf(little), 1)->decay(), TriangleTree::kDecayed);
    std::vector<Triangle> mixed = triangles;
    test::Random random(7);
    for (std::size_t i = 1; i < mixed.size(); ++i)
        std::swap(mixed[i], mixed[random.below(uint32_t(i))]);
    EXPECT_GT(tree.refitted(mixed, test::boxesOf(mixed), 1)->decay(), TriangleTree::kDecayed);
}

TEST(TriangleTree, OtherTrianglesLeftOutNeedANewTree) {
    const std::vector<Triangle> triangles = test::mixedTriangles(100, 5);
    std::vector<Aabb> boxes = test::boxesOf(triangles);
    const Aabb box = boxes[9];
    boxes[9] = Aabb();
    for (const WideQuality quality : kQualities) {
        const TriangleTree tree(triangles, boxes, quality, 1);
        EXPECT_TRUE(tree.refitted(triangles, boxes, 1));
        std::vector<Aabb> others = boxes;
        others[9] = box;
        EXPECT_FALSE(tree.refitted(triangles, others, 1));
        others[10] = Aabb();
        EXPECT_FALSE(tree.refitted(triangles, others, 1));
    }
}

TEST(TriangleTree, OfNothing) {
    for (const WideQuality quality : kQualities) {
        const TriangleTree tree({}, {}, quality, 2);
        EXPECT_TRUE(tree.empty());
        EXPECT_EQ(tree.bytes(), 0u);
        EXPECT_TRUE(tree.refitted({}, {}, 2)->empty());
        const std::vector<Triangle> degenerate(40);
        EXPECT_TRUE(TriangleTree(degenerate, std::vector<Aabb>(40), quality, 1).empty());
    }
}

} // namespace
} // namespace smart
