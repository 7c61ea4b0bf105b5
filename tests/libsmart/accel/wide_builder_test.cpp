// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <string>

#include "tests/libsmart/accel/wide_tree_check.h"

namespace {

/// Allocations that may still succeed; below 0: all.
std::atomic<long> gAllocations{-1};
std::atomic<long> gHeld{0};

} // namespace

void* operator new(std::size_t size) {
    if (gAllocations.load() >= 0 && gAllocations.fetch_sub(1) <= 0) {
        gAllocations = 0;
        throw std::bad_alloc();
    }
    void* const memory = std::malloc(size ? size : 1);
    if (!memory) throw std::bad_alloc();
    ++gHeld;
    return memory;
}
// Not inlined: g++ would take the call of free for one that does not fit to new.
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    if (memory) --gHeld;
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace smart::test {
namespace {

using Build = WideTree (*)(std::span<const Aabb>, unsigned, const WideCosts&);

struct Builder {
    const char* name;
    Build build;
};
WideTree buildCut(std::span<const Aabb> boxes, unsigned threads, const WideCosts& costs) {
    // Triangles that fill their boxes from corner to corner.
    std::vector<float> vertices;
    for (const Aabb& box : boxes)
        vertices.insert(vertices.end(), {box.lo[0], box.lo[1], box.lo[2], box.hi[0], box.hi[1],
                                         box.lo[2], box.lo[0], box.hi[1], box.hi[2]});
    return buildWideTreeSpatial(boxes, vertices.data(), threads, costs);
}

class WideBuilder : public ::testing::TestWithParam<Builder> {
protected:
    static bool cuts() { return GetParam().build == buildCut; }
    static WideTree build(const std::vector<Aabb>& boxes, unsigned threads = 1,
                          const WideCosts& costs = kTriangleCosts) {
        return GetParam().build(boxes, threads, costs);
    }
    static void expectSound(const std::vector<Aabb>& boxes, const std::string& name,
                            const WideCosts& costs = kTriangleCosts) {
        const WideTree tree = build(boxes, 1, costs);
        if (!cuts()) {
            const WideTreeCheck check(tree, boxes);
            EXPECT_EQ(check.mistakes(), 0u) << name;
            EXPECT_LE(check.depth(), kWideMaxDepth) << name;
            return;
        }
        std::vector<Triangle> triangles(boxes.size());
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Aabb& b = boxes[i];
            triangles[i] = {{b.lo[0], b.lo[1], b.lo[2]},
                            {b.hi[0], b.hi[1], b.lo[2]},
                            {b.lo[0], b.hi[1], b.hi[2]}};
        }
        const WideTreeCheck check(tree, boxes, triangles, 20);
        EXPECT_EQ(check.mistakes(), 0u) << name;
        EXPECT_LE(check.depth(), kWideMaxDepth) << name;
    }
};

TEST_P(WideBuilder, EveryPrimitiveIsInALeafInsideAllItsBoxes) {
    for (const std::size_t count : {1u, 2u, 4u, 5u, 15u, 16u, 17u, 64u, 65u, 257u, 5000u})
        expectSound(scatteredBoxes(count, 1, count), std::to_string(count));
}

TEST_P(WideBuilder, ManyPrimitivesAreSharedByThreads) {
    expectSound(scatteredBoxes(20000, 1, 40), "20000");
}

TEST_P(WideBuilder, LeavesOfInstancesHoldOne) {
    std::vector<Aabb> boxes = scatteredBoxes(3000, 1, 12);
    for (Aabb& box : boxes) // as large as their distances
        box = boxAt(box.lo[0], box.lo[1], box.lo[2], 0.035);
    expectSound(boxes, "instances", kInstanceCosts);
    const WideTree tree = build(boxes, 1, kInstanceCosts);
    std::size_t crowded = 0;
    for (const WideNode& node : tree.nodes)
        for (const uint32_t child : node.child) crowded += child & kWideLeaf && (child & 15u) > 0;
    EXPECT_LE(crowded, boxes.size() / 100);
    EXPECT_LE(tree.nodes.size() * 8, boxes.size()); // half of the places are used, at least
}

TEST_P(WideBuilder, NothingMakesAnEmptyTree) {
    EXPECT_TRUE(build({}).nodes.empty());
    EXPECT_TRUE(build(std::vector<Aabb>(2)).nodes.empty());
    EXPECT_TRUE(build(std::vector<Aabb>(200)).nodes.empty());
}

TEST_P(WideBuilder, EmptyBoxesAndSuchOfNoNumberAreLeftOut) {
    std::vector<Aabb> boxes = scatteredBoxes(500, 1, 3);
    for (std::size_t i = 0; i < boxes.size(); i += 3) boxes[i] = Aabb();
    expectSound(boxes, "every third empty");
    for (std::size_t i = 1; i < boxes.size(); i += 3)
        boxes[i].lo[i % 2] = std::numeric_limits<float>::quiet_NaN();
    expectSound(boxes, "and every third not a number");
}

TEST_P(WideBuilder, HardShapes) {
    expectSound(std::vector<Aabb>(1000, boxAt(1, 2, 3, 0.5)), "all the same");
    expectSound(std::vector<Aabb>(9000, boxAt(1, 2, 3, 0.5)), "many all the same");
    expectSound(std::vector<Aabb>(100, boxAt(1, 2, 3, 0)), "all one point");
    std::vector<Aabb> boxes;
    for (int i = 0; i < 2000; ++i) boxes.push_back(boxAt(i, 0, 0, 0));
    expectSound(boxes, "points on a line");
    boxes.clear();
    for (int i = 0; i < 120; ++i) boxes.push_back(boxAt(std::ldexp(1.0, i), 0, 0, 1e-6));
    expectSound(boxes, "each twice as far as the one before");
    boxes.clear();
    for (int i = 0; i < 120; ++i) boxes.push_back(boxAt(0, 0, 0, std::ldexp(1.0, i)));
    expectSound(boxes, "each around the one before");
    boxes.clear();
    for (int i = -120; i < 120; ++i)
        for (int k = 0; k < 30; ++k)
            boxes.push_back(boxAt(std::ldexp(1.0 + k * 0x1p-10, i), 0, 0, std::ldexp(1.0, i - 20)));
    expectSound(boxes, "clusters of all sizes");
    for (const double scale : {1e-44, 1e-40, 1e-30, 1e-12, 1e12, 1e30, 1e38, 3e38})
        expectSound(scatteredBoxes(300, scale, 5), "scale " + std::to_string(std::log10(scale)));
    boxes = scatteredBoxes(1000, 1, 9);
    for (Aabb& box : boxes) box.lo[2] = box.hi[2] = 7.0f;
    expectSound(boxes, "flat");
    boxes[5] = boxAt(3.2e38, -3.2e38, 0, 1e37);
    expectSound(boxes, "flat, and one far away");
    if (cuts()) return; // triangles are finite
    boxes[6].hi[0] = boxes[7].hi[1] = Aabb::kInf;
    boxes[7].lo[1] = -Aabb::kInf;
    expectSound(boxes, "infinite ones among them");
}

TEST_P(WideBuilder, WideNodesAreWellFilled) {
    const std::size_t count = 20000;
    const WideTree tree = build(scatteredBoxes(count, 1, 6));
    EXPECT_LE(tree.nodes.size() * 30, count); // 30 primitives a node, at least
    EXPECT_EQ(tree.bytes(), tree.nodes.capacity() * 448 + tree.prims.capacity() * 4);
    EXPECT_LE(tree.bytes(), tree.nodes.size() * 448 * 33 / 32 + tree.prims.size() * 4 * 33 / 32);
}

TEST_P(WideBuilder, TheSameTreeByAnyNumberOfThreads) {
    for (const std::size_t count : {3000u, 20000u}) {
        const std::vector<Aabb> boxes = scatteredBoxes(count, 1, 7);
        const WideTree one = build(boxes, 1);
        for (const unsigned threads : {0u, 2u, 5u}) {
            const WideTree other = build(boxes, threads);
            EXPECT_EQ(one.prims, other.prims) << threads;
            ASSERT_EQ(one.nodes.size(), other.nodes.size()) << threads;
            EXPECT_EQ(std::memcmp(one.nodes.data(), other.nodes.data(),
                                  one.nodes.size() * sizeof(WideNode)),
                      0)
                << threads;
            EXPECT_EQ(one.cost, other.cost);
        }
    }
}

TEST_P(WideBuilder, WithoutMemoryNothingIsLeftBehind) {
    const std::vector<Aabb> boxes = scatteredBoxes(9000, 1, 8);
    for (const unsigned threads : {1u, 3u}) {
        bool built = false;
        int failures = 0;
        for (long n = 0; !built; n = n < 12 ? n + 1 : n + n / 3) {
            const long before = gHeld;
            gAllocations = n;
            try {
                const WideTree tree = build(boxes, threads);
                built = true;
            } catch (const std::bad_alloc&) {
                ++failures;
            }
            gAllocations = -1;
            EXPECT_EQ(gHeld, before) << n;
        }
        EXPECT_GT(failures, 10);
    }
}

INSTANTIATE_TEST_SUITE_P(All, WideBuilder,
                         ::testing::Values(Builder{"Binned", buildWideTree},
                                           Builder{"Fast", buildWideTreeFast},
                                           Builder{"Spatial", buildCut}),
                         [](const auto& of) { return of.param.name; });

TEST(WideTreeSpatial, CutsWhatOverlapsWithinItsBudget) {
    const std::vector<Triangle> triangles = mixedTriangles(6000, 21);
    const std::vector<Aabb> boxes = boxesOf(triangles);
    const WideTree whole = buildWideTree(boxes);
    const WideTree cut = buildWideTreeSpatial(boxes, triangles[0].v0);
    EXPECT_EQ(WideTreeCheck(cut, boxes, triangles, 100).mistakes(), 0u);
    EXPECT_GT(cut.prims.size(), triangles.size() * 105 / 100);
    EXPECT_LE(cut.prims.size(), triangles.size() * 125 / 100);
    EXPECT_EQ(cut.primitives, triangles.size());
    EXPECT_LT(cut.cost, whole.cost * 0.95f);
    for (const WideNode& node : cut.nodes) { // no triangle twice in a leaf
        for (const uint32_t child : node.child) {
            if (!(child & kWideLeaf)) continue;
            const auto first = cut.prims.begin() + ((child & ~kWideLeaf) >> 4);
            std::vector<uint32_t> leaf(first, first + (child & 15u) + 1);
            std::sort(leaf.begin(), leaf.end());
            EXPECT_EQ(std::adjacent_find(leaf.begin(), leaf.end()), leaf.end());
        }
    }
}

TEST(WideTreeQuality, FastTreesCostLittleMore) {
    const std::vector<Triangle> triangles = mixedTriangles(20000, 22);
    const std::vector<Aabb> boxes = boxesOf(triangles);
    EXPECT_LT(buildWideTreeFast(boxes).cost, buildWideTree(boxes).cost * 1.4f);
}

TEST(WideTreeCheckControls, TheCheckFindsFaults) {
    const std::vector<Aabb> boxes = scatteredBoxes(500, 1, 8);
    const WideTree sound = buildWideTree(boxes);
    EXPECT_EQ(WideTreeCheck(sound, boxes).mistakes(), 0u);
    const auto expectFault = [&](const auto& spoil) {
        WideTree tree = sound;
        spoil(tree);
        EXPECT_GT(WideTreeCheck(tree, boxes).mistakes(), 0u);
    };
    expectFault([](WideTree& tree) { tree.prims[7] = tree.prims[8]; });
    expectFault([](WideTree& tree) {
        tree.nodes[0].hi[1][0] = std::nextafter(tree.nodes[0].hi[1][0], -1.0f);
    });
    expectFault([](WideTree& tree) { tree.nodes[0].lo[0][0] = Aabb::kInf; });

    const std::vector<Triangle> triangles = mixedTriangles(500, 9);
    const std::vector<Aabb> triangleBoxes = boxesOf(triangles);
    WideTree cut = buildWideTreeSpatial(triangleBoxes, triangles[0].v0);
    EXPECT_EQ(WideTreeCheck(cut, triangleBoxes, triangles, 50).mistakes(), 0u);
    for (WideNode& node : cut.nodes) {
        for (int slot = 0; slot < kWideChildren; ++slot) {
            if (!(node.child[slot] & kWideLeaf)) continue;
            const float extent = node.hi[0][slot] - node.lo[0][slot];
            node.hi[0][slot] -= 0.05f * extent;
        }
    }
    EXPECT_GT(WideTreeCheck(cut, triangleBoxes, triangles, 50).mistakes(), 0u);
}

} // namespace
} // namespace smart::test
