// SPDX-License-Identifier: MIT
// Geometry that no plane separates: the builder must neither take long nor fill the memory.
#include <gtest/gtest.h>
#include <malloc.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <random>

#include "tests/libsmart/accel/kd_test_support.h"
#include "tests/support/procedural_meshes.h"

namespace {

// Every allocation of this program is counted: what is in use, and the most that ever was.
std::atomic<std::size_t> liveBytes{0}, peakBytes{0};

} // namespace

void* operator new(std::size_t size) {
    void* memory = std::malloc(size ? size : 1);
    if (!memory) throw std::bad_alloc();
    const std::size_t live = liveBytes += malloc_usable_size(memory);
    std::size_t peak = peakBytes;
    while (live > peak && !peakBytes.compare_exchange_weak(peak, live)) {}
    return memory;
}
void operator delete(void* memory) noexcept {
    if (!memory) return;
    liveBytes -= malloc_usable_size(memory);
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept { operator delete(memory); }

namespace smart {
namespace {

constexpr uint32_t kCount = test::kSanitized ? 10000 : 100000;
constexpr double kMaxReferences = test::kSanitized ? 8 : 4; // a triangle; 8 for any input

/// Counts how often triangles are clipped to cells.
class CountedTriangles final : public test::TrianglePrimitives {
public:
    using TrianglePrimitives::TrianglePrimitives;
    Aabb clipped(uint32_t prim, const Aabb& cell) const override {
        ++clips;
        return TrianglePrimitives::clipped(prim, cell);
    }
    mutable std::atomic<uint64_t> clips{0};
};

class KdHardCases : public testing::Test {
protected:
    /// Builds with one thread and with two and holds the result to its bounds. Steps are counted
    /// and not timed: others may be at work on the machine. On each level a reference has two
    /// events an axis and is clipped for both children at most.
    void expectBounded(const std::vector<Triangle>& mesh) {
        for (const unsigned threads : {1u, 2u}) {
            KdBuildOptions options;
            options.threads = threads;
            const std::size_t before = liveBytes;
            peakBytes = before;
            const CountedTriangles triangles(mesh);
            KdBuildStats stats;
            const KdTree tree = buildKdTree(triangles, options, &stats);
            const double levels = double(mesh.size()) * (stats.depth + 1.0);
            const double events = double(stats.events) / levels;
            const double clips = double(triangles.clips) / levels;
            const double bytes = double(peakBytes - before) / double(mesh.size());
            const double references = double(tree.prims.size()) / double(mesh.size());
            RecordProperty("events", std::to_string(events));
            RecordProperty("clips", std::to_string(clips));
            RecordProperty("bytes", std::to_string(bytes));
            RecordProperty("references", std::to_string(references));
            EXPECT_EQ(test::checkKdStructure(tree, uint32_t(mesh.size())), "");
            EXPECT_LE(references, kMaxReferences);
            EXPECT_LT(bytes, 300.0);
            EXPECT_LE(events, 6 * kMaxReferences);
            EXPECT_LE(clips, 2 * kMaxReferences);
        }
    }

    float uniform() { return float(generator_() >> 8) * 0x1p-23f - 1.0f; }

    std::mt19937 generator_{1};
};

TEST_F(KdHardCases, IdenticalQuads) {
    std::vector<Triangle> mesh;
    for (uint32_t i = 0; i < kCount / 2; ++i) {
        mesh.push_back({{-1, -1, 0}, {1, -1, 0.5f}, {1, 1, 1}});
        mesh.push_back({{-1, -1, 0}, {1, 1, 1}, {-1, 1, 0.5f}});
    }
    expectBounded(mesh);
}

TEST_F(KdHardCases, OneTriangleRepeated) {
    expectBounded(std::vector<Triangle>(kCount, {{0.1f, 0.2f, 0.3f}, {1, 0, 0}, {-0.3f, 0.8f, 1}}));
}

TEST_F(KdHardCases, AllThroughOneCentre) {
    std::vector<Triangle> mesh(kCount);
    for (Triangle& triangle : mesh) {
        for (int k = 0; k < 3; ++k) {
            triangle.v0[k] = uniform();
            triangle.v1[k] = uniform();
            triangle.v2[k] = -triangle.v0[k] - triangle.v1[k];
        }
    }
    expectBounded(mesh);
}

TEST_F(KdHardCases, FansOfOneVertex) {
    for (const float height : {0.0f, 1.0f}) {
        std::vector<Triangle> mesh(kCount);
        for (uint32_t i = 0; i < kCount; ++i) {
            const double step = 2 * 3.14159265358979323846 / kCount;
            const auto rim = [step](uint32_t j, float (&v)[3]) {
                v[0] = float(std::cos(step * j));
                v[1] = float(std::sin(step * j));
                v[2] = 0;
            };
            mesh[i].v0[0] = mesh[i].v0[1] = 0;
            mesh[i].v0[2] = height;
            rim(i, mesh[i].v1);
            rim((i + 1) % kCount, mesh[i].v2);
        }
        expectBounded(mesh);
    }
}

TEST_F(KdHardCases, ParallelLayers) {
    for (const float tilt : {0.0f, 0.5f}) {
        std::vector<Triangle> mesh(kCount);
        for (uint32_t i = 0; i < kCount; ++i) {
            const float z = float(i) / float(kCount);
            mesh[i] = {{-1, -1, z}, {1, -1, z + tilt}, {0, 1, z - tilt}};
        }
        expectBounded(mesh);
    }
}

TEST_F(KdHardCases, CrossingSlivers) {
    std::vector<Triangle> mesh(kCount);
    for (Triangle& triangle : mesh) {
        for (int k = 0; k < 3; ++k) {
            triangle.v0[k] = uniform();
            triangle.v1[k] = uniform();
            triangle.v2[k] = triangle.v1[k] + 1e-3f * uniform();
        }
    }
    expectBounded(mesh);
}

TEST_F(KdHardCases, LongTrianglesEverywhere) { expectBounded(test::triangleSoup(kCount, 0.2f, 5)); }

} // namespace
} // namespace smart
