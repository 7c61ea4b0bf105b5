// SPDX-License-Identifier: MIT
#include "libsmart/accel/kd_builder.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstring>
#include <new>
#include <thread>

#include "tests/libsmart/accel/kd_test_support.h"
#include "tests/support/procedural_meshes.h"

namespace smart {
namespace {

using test::checkKdStructure;
using test::countMissing;
using test::kSanitized;
using test::TrianglePrimitives;

struct Named {
    const char* name;
    std::vector<Triangle> triangles;
};

std::vector<Named> meshes() {
    const uint32_t n = kSanitized ? 3000 : 30000;
    std::vector<Named> all{{"icosphere", test::icosphere(4)},
                           {"bumpy sphere", test::bumpySphere(n)},
                           {"heightfield", test::heightfield(n)},
                           {"fine soup", test::triangleSoup(n, 0.02f, 1)},
                           {"coarse soup", test::triangleSoup(n / 10, 0.5f, 2)},
                           {"room", test::closedRoom()}};
    std::vector<Triangle> moved = test::icosphere(3), flat = test::heightfield(2000),
                          tilted = test::heightfield(2000);
    for (Triangle& t : moved) {
        for (float* v : {t.v0, t.v1, t.v2}) v[0] = v[0] * 1e-3f + 5000;
    }
    for (Triangle& t : flat) t.v0[1] = t.v1[1] = t.v2[1] = 0.25f;
    for (Triangle& t : tilted) {
        for (float* v : {t.v0, t.v1, t.v2}) v[1] = 0.37f * v[0] - 0.61f * v[2];
    }
    all.push_back({"far away", std::move(moved)});
    all.push_back({"flat", std::move(flat)});
    all.push_back({"tilted plane", std::move(tilted)});
    return all;
}

TEST(KdBuilder, EachTriangleIsInEveryLeafWhoseCellItMeets) {
    for (const Named& mesh : meshes()) {
        for (const float cost : {0.3f, 1.5f}) {
            KdBuildOptions options;
            options.intersectionCost = cost;
            KdBuildStats stats;
            const KdTree tree =
                buildKdTree(TrianglePrimitives(mesh.triangles), options, &stats);
            test::KdLeafCounts counts;
            EXPECT_EQ(checkKdStructure(tree, uint32_t(mesh.triangles.size()), &counts), "")
                << mesh.name;
            EXPECT_EQ(counts.depth, stats.depth) << mesh.name;
            EXPECT_GT(counts.leaves, 1u) << mesh.name;
            EXPECT_EQ(countMissing(tree, mesh.triangles), 0u) << mesh.name;
            Aabb bounds;
            for (const Triangle& triangle : mesh.triangles) bounds.add(test::boundsOf(triangle));
            EXPECT_EQ(std::memcmp(&bounds, &tree.bounds, sizeof bounds), 0) << mesh.name;
            EXPECT_GE(tree.bytes(), tree.nodes.size() * 8 + tree.prims.size() * 4);
        }
    }
}

/// Splits that lose what straddles: such a triangle stays on the left only.
class OneSided final : public TrianglePrimitives {
public:
    using TrianglePrimitives::TrianglePrimitives;
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        const Aabb box = bounds(prim);
        for (int k = 0; k < 3; ++k) {
            if (box.lo[k] < cell.lo[k]) return Aabb{};
        }
        return TrianglePrimitives::clipped(prim, cell);
    }
};

/// Clipped boxes rounded inward by a little more than they are padded.
class RoundedInward final : public TrianglePrimitives {
public:
    using TrianglePrimitives::TrianglePrimitives;
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        Aabb part = TrianglePrimitives::clipped(prim, cell);
        for (int k = 0; k < 3 && !part.empty(); ++k) {
            const float middle = (part.lo[k] + part.hi[k]) / 2;
            part.lo[k] = std::min(part.lo[k] + 4e-6f, middle);
            part.hi[k] = std::max(part.hi[k] - 4e-6f, middle);
        }
        return part;
    }
};

TEST(KdBuilder, ControlLostTrianglesAreSeen) {
    const std::vector<Triangle> mesh = test::bumpySphere(2000);
    KdBuildOptions options;
    options.intersectionCost = 1.5f;
    EXPECT_GT(countMissing(buildKdTree(OneSided(mesh), options), mesh), 0u);
    EXPECT_GT(countMissing(buildKdTree(RoundedInward(mesh), options), mesh), 0u);

    // A single reference that is replaced by another one.
    const KdTree whole = buildKdTree(TrianglePrimitives(mesh), options);
    KdTree corrupt = whole;
    corrupt.prims[corrupt.prims.size() / 2] ^= 1;
    EXPECT_GT(countMissing(corrupt, mesh), 0u);

    const uint32_t count = uint32_t(mesh.size());
    corrupt = whole;
    corrupt.nodes[0].split = corrupt.bounds.hi[corrupt.nodes[0].bits & 3];
    EXPECT_NE(checkKdStructure(corrupt, count), "");
    corrupt = whole;
    corrupt.nodes[0].bits += 8;
    EXPECT_NE(checkKdStructure(corrupt, count), "");
    corrupt = whole;
    corrupt.prims.push_back(0);
    EXPECT_NE(checkKdStructure(corrupt, count), "");
}

TEST(KdBuilder, TreeDoesNotDependOnTheNumberOfThreads) {
    const uint32_t n = kSanitized ? 25000 : 60000;
    // The last one makes too many references and is built a second time.
    for (const auto& mesh : {test::bumpySphere(n), test::triangleSoup(n, 0.03f, 3),
                             test::triangleSoup(20000, 0.2f, 4)}) {
        KdBuildOptions options;
        KdBuildStats expectedStats, stats;
        const KdTree expected = buildKdTree(TrianglePrimitives(mesh), options, &expectedStats);
        for (const unsigned threads : {0u, 2u, 4u, 7u}) {
            options.threads = threads;
            const KdTree tree = buildKdTree(TrianglePrimitives(mesh), options, &stats);
            ASSERT_EQ(tree.nodes.size(), expected.nodes.size());
            EXPECT_EQ(std::memcmp(tree.nodes.data(), expected.nodes.data(),
                                  tree.nodes.size() * sizeof(KdNode)),
                      0);
            EXPECT_EQ(tree.prims, expected.prims);
            EXPECT_EQ(stats.depth, expectedStats.depth);
        }
    }
}

/// Whether work divided by N log2 N stays within 10 % of its mean.
bool growsAsNLogN(const std::vector<std::pair<double, double>>& countsAndWork) {
    double least = INFINITY, most = 0, sum = 0;
    for (const auto& [count, work] : countsAndWork) {
        const double ratio = work / (count * std::log2(count));
        least = std::min(least, ratio);
        most = std::max(most, ratio);
        sum += ratio;
    }
    const double mean = sum / double(countsAndWork.size());
    return least >= 0.9 * mean && most <= 1.1 * mean;
}

TEST(KdBuilder, EventsGrowAsNLogN) {
    const uint32_t largest = kSanitized ? 60000 : 1000000;
    for (const auto make : {test::bumpySphere, test::heightfield}) {
        std::vector<std::pair<double, double>> measured, worse;
        for (const uint32_t n : {10000u, uint32_t(std::sqrt(1e4 * largest)), largest}) {
            const std::vector<Triangle> mesh = make(n);
            KdBuildOptions options;
            options.threads = 2;
            KdBuildStats stats;
            buildKdTree(TrianglePrimitives(mesh), options, &stats);
            const double count = double(mesh.size());
            measured.emplace_back(count, double(stats.events));
            worse.emplace_back(count, double(stats.events) * std::pow(count, 0.25));
        }
        EXPECT_TRUE(growsAsNLogN(measured)) << testing::PrintToString(measured);
        EXPECT_FALSE(growsAsNLogN(worse)); // control: a little more than linear is seen
    }
}

/// Runs out of memory in the middle, wherever it is called.
class Failing final : public TrianglePrimitives {
public:
    Failing(const std::vector<Triangle>& triangles, int calls, bool inHelper)
        : TrianglePrimitives(triangles), left_(calls), inHelper_(inHelper) {}
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        if (inHelper_ && std::this_thread::get_id() == caller_) {
            std::this_thread::yield();
        } else if (left_-- <= 0) {
            throw std::bad_alloc();
        }
        return TrianglePrimitives::clipped(prim, cell);
    }

private:
    mutable std::atomic<int> left_;
    bool inHelper_;
    std::thread::id caller_ = std::this_thread::get_id();
};

TEST(KdBuilder, FailureOfAnyThreadReachesTheCaller) {
    const std::vector<Triangle> mesh = test::bumpySphere(60000);
    for (const unsigned threads : {1u, 4u}) {
        for (const int calls : {0, 3000}) {
            KdBuildOptions options;
            options.threads = threads;
            EXPECT_THROW(buildKdTree(Failing(mesh, calls, threads > 1), options), std::bad_alloc);
        }
    }
}

TEST(KdBuilder, FewPrimitives) {
    std::vector<Triangle> mesh;
    KdTree tree = buildKdTree(TrianglePrimitives(mesh));
    EXPECT_TRUE(tree.nodes.empty());
    EXPECT_TRUE(tree.prims.empty());
    EXPECT_TRUE(tree.bounds.empty());

    mesh.push_back({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    tree = buildKdTree(TrianglePrimitives(mesh));
    ASSERT_EQ(tree.nodes.size(), 1u);
    EXPECT_EQ(tree.nodes[0].bits, (1u << 2) | kKdLeaf);
    EXPECT_EQ(tree.prims, std::vector<uint32_t>{0});
}

/// Boxes; some of them empty.
class SomeEmpty final : public KdPrimitives {
public:
    uint32_t count() const override { return 3000; }
    Aabb bounds(uint32_t prim) const override {
        Aabb box;
        if (prim % 3 == 1) return box;
        const float lo[3] = {float(prim), float(prim % 50), 0}, hi[3] = {lo[0] + 2, lo[1] + 1, 1};
        box.add(lo);
        box.add(hi);
        return box;
    }
};

TEST(KdBuilder, EmptyBoxesAreLeftOut) {
    const SomeEmpty boxes;
    const KdTree tree = buildKdTree(boxes);
    EXPECT_EQ(checkKdStructure(tree, boxes.count()), "");
    std::vector<int> seen(boxes.count(), 0);
    for (const uint32_t prim : tree.prims) seen[prim] = 1;
    for (uint32_t prim = 0; prim < boxes.count(); ++prim) EXPECT_EQ(seen[prim], prim % 3 != 1);
    EXPECT_EQ(tree.bounds.hi[0], 3001.0f);
}

TEST(KdBuilder, DegenerateInput) {
    const float tiny = 1e-45f, huge = 3.4e38f;
    std::vector<Named> inputs(6);
    for (uint32_t i = 0; i < 500; ++i) {
        const float x = float(i);
        inputs[0].triangles.push_back({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
        inputs[1].triangles.push_back({{x, 0, 0}, {x, 0, 0}, {x + 1, 0, 0}});
        inputs[2].triangles.push_back({{x, x, x}, {x, x, x}, {x, x, x}});
        inputs[3].triangles.push_back({{x * tiny, 0, 0}, {0, x * tiny, 0}, {0, 0, tiny}});
        inputs[4].triangles.push_back(
            {{-huge, x, 0}, {huge, -huge, x * 1e30f}, {x * 1e35f, huge, huge}});
        inputs[5].triangles.push_back({{x, 0.0f, -0.0f}, {x + 1, -0.0f, 0}, {x, 1, 0}});
    }
    const char* const names[] = {"one point", "line", "points", "denormal", "huge", "zeros"};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto& mesh = inputs[i].triangles;
        const KdTree tree = buildKdTree(TrianglePrimitives(mesh));
        EXPECT_EQ(checkKdStructure(tree, uint32_t(mesh.size())), "") << names[i];
        EXPECT_EQ(countMissing(tree, mesh), 0u) << names[i];
    }
}

TEST(KdBuilder, OptionsAtTheirEnds) {
    const std::vector<Triangle> mesh = test::icosphere(3);
    for (const float cost : {0.0f, 1e-6f, 1e6f}) {
        for (const float factor : {0.01f, 1.0f}) {
            KdBuildOptions options;
            options.intersectionCost = cost;
            options.emptyFactor = factor;
            const KdTree tree = buildKdTree(TrianglePrimitives(mesh), options);
            EXPECT_EQ(checkKdStructure(tree, uint32_t(mesh.size())), "");
            EXPECT_EQ(countMissing(tree, mesh), 0u);
            if (cost < 1e-3f && factor == 1.0f) {
                EXPECT_EQ(tree.nodes.size(), 1u);
            }
        }
    }
}

} // namespace
} // namespace smart
