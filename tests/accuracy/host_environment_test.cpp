// SPDX-License-Identifier: MIT
// Applications that flush denormals, change the rounding mode or hand in bad numbers get the same
// hits as everybody else, and their good triangles and instances keep theirs.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "libsmart/scene/query.h"
#include "tests/accuracy/case_run.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/kernel_runs.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/traced_scene.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace smart::test {
namespace {

struct Results {
    std::vector<float> t, u, v;
    std::vector<uint32_t> primitive, instance;
    std::vector<uint8_t> blocked;

    bool operator==(const Results&) const = default;
};

/// Through the functions that applications reach; builds the scene as well.
Results trace(const std::vector<Triangle>& mesh, const glm::dmat4x3& matrix, Precision precision,
              std::span<const Ray> rays) {
    const Scene scene({place(makeModel(mesh)), place(makeModel(mesh), matrix)}, precision, 1);
    constexpr std::size_t kFloats = sizeof(Ray) / sizeof(float);
    RayStream in{};
    for (int k = 0; k < 3; ++k) {
        in.org[k] = &rays[0].org[k];
        in.dir[k] = &rays[0].dir[k];
    }
    in.tNear = &rays[0].tNear;
    in.tFar = &rays[0].tFar;
    in.stride = kFloats;
    const std::size_t count = rays.size();
    Results results{std::vector<float>(count),    std::vector<float>(count),
                    std::vector<float>(count),    std::vector<uint32_t>(count),
                    std::vector<uint32_t>(count), std::vector<uint8_t>(count)};
    HitStream out{};
    out.t = results.t.data();
    out.u = results.u.data();
    out.v = results.v.data();
    out.primitive = results.primitive.data();
    out.instance = results.instance.data();
    intersect(scene, in, out, count, Coherence::Coherent);
    occluded(scene, in, results.blocked.data(), count, Coherence::Incoherent);
    return results;
}

std::vector<Triangle> scaled(std::vector<Triangle> mesh, float by) {
    for (Triangle& triangle : mesh) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) v[k] *= by;
        }
    }
    return mesh;
}

/// Vertices and origins are denormal numbers.
constexpr float kTiny = 0x1p-133f;

class HostEnvironment : public testing::TestWithParam<int> {
protected:
    void SetUp() override {
        std::fegetenv(&found_);
        for (const float scale : {1.0f, kTiny}) {
            meshes_.push_back(scaled(icosphere(2), scale));
            rays_.push_back(
                raysFromOutside(meshes_.back(), scale, 500, Target::Edge, Aim::Rounded, 1));
            // Directions of denormals have few bits; half are made long.
            for (std::size_t i = 0; i < rays_.back().size() && scale < 1; i += 2) {
                for (float& x : rays_.back()[i].dir) x *= 0x1p100f;
            }
        }
        matrix_[0][0] = 0.7;
        matrix_[3][1] = 0.1;
    }
    void TearDown() override { std::fesetenv(&found_); }

    Precision precision() const { return Precision(GetParam()); }
    std::vector<Results> traceAll() const {
        std::vector<Results> all;
        for (std::size_t i = 0; i < meshes_.size(); ++i)
            all.push_back(trace(meshes_[i], matrix_, precision(), rays_[i]));
        return all;
    }

    std::vector<std::vector<Triangle>> meshes_;
    std::vector<std::vector<Ray>> rays_;
    glm::dmat4x3 matrix_{1.0};

private:
    std::fenv_t found_;
};

TEST_P(HostEnvironment, RoundingModesChangeNothing) {
    const std::vector<Results> standard = traceAll();
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        ASSERT_EQ(std::fesetround(mode), 0);
        const std::vector<Results> other = traceAll();
        EXPECT_EQ(std::fegetround(), mode);
        std::fesetround(FE_TONEAREST);
        EXPECT_TRUE(other == standard) << mode;
    }
}

#if defined(__SSE2__)
constexpr unsigned kFlushAndDaz = 0x8040;

TEST_P(HostEnvironment, FlushedDenormalsChangeNothing) {
    const std::vector<Results> standard = traceAll();
    std::size_t hits = 0; // the fast mode has none here
    for (const uint32_t primitive : standard[1].primitive) hits += primitive != kNoId;
    if (precision() != Precision::Fast) {
        EXPECT_GT(hits, rays_[1].size() * 9 / 10);
    }
    _mm_setcsr(_mm_getcsr() | kFlushAndDaz);
    const std::vector<Results> other = traceAll();
    EXPECT_EQ(_mm_getcsr() & kFlushAndDaz, kFlushAndDaz);
    _mm_setcsr(_mm_getcsr() & ~kFlushAndDaz);
    EXPECT_TRUE(other == standard);
}

/// Control: kernels that nobody protects do feel the application's setting. Not in fast mode, which
/// hits nothing among denormal numbers anyway.
class HostEnvironmentControl : public HostEnvironment {};
TEST_P(HostEnvironmentControl, KernelsAloneWouldFeelIt) {
    const Scene scene({place(makeModel(meshes_[1]))}, precision(), 1);
    const auto hits = traceSingles(kernels(), precision(), scene.view(), rays_[1]);
    _mm_setcsr(_mm_getcsr() | kFlushAndDaz);
    const auto flushed = traceSingles(kernels(), precision(), scene.view(), rays_[1]);
    _mm_setcsr(_mm_getcsr() & ~kFlushAndDaz);
    EXPECT_GT(differences(hits, flushed), 0u);
}
#endif

INSTANTIATE_TEST_SUITE_P(Modes, HostEnvironment, testing::Range(0, kPrecisionCount),
                         [](const auto& each) { return std::string(modeName(each.param)); });

class BadNumbers : public testing::TestWithParam<int> {};

/// Instances that have no place are dropped and counted; the others are hit as if alone.
TEST_P(BadNumbers, InMatricesLeaveOtherInstancesAlone) {
    const auto precision = Precision(GetParam());
    const std::vector<Triangle> mesh = icosphere(2);
    const ModelPtr model = makeModel(mesh);
    const std::vector<Ray> rays =
        raysFromOutside(mesh, 1, rayCount(2000), Target::Edge, Aim::Rounded, 2);
    const Scene alone({place(model)}, precision, 1);
    const auto expected = traceSingles(kernels(), precision, alone.view(), rays);

    std::vector<Instance> instances;
    const float bad[] = {NAN, INFINITY, -INFINITY};
    for (int column = 0; column < 4; ++column) {
        for (const float x : bad) {
            glm::dmat4x3 matrix(1.0);
            matrix[column][column % 3] = x;
            instances.push_back(place(model, matrix));
        }
    }
    for (int column = 0; column < 3; ++column) {
        glm::dmat4x3 matrix(1.0);
        matrix[column] = glm::dvec3(0);
        instances.push_back(place(model, matrix));
    }
    const auto dropped = instances.size();
    instances.push_back(place(model));
    const Scene scene(std::move(instances), precision, 1);
    EXPECT_EQ(statistics(scene).droppedInstances, dropped);
    auto hits = traceSingles(kernels(), precision, scene.view(), rays);
    EXPECT_EQ(
        differences(tracePackets(kernels(), precision, scene.view(), rays, Filling::Full), hits),
        0u);
    for (Hit& hit : hits) {
        if (hit.triangle == kNoHit) continue;
        EXPECT_EQ(hit.path[0], dropped);
        hit.path[0] = 0;
    }
    EXPECT_EQ(differences(hits, expected), 0u);
}

/// Every combination of bad values in a ray is a miss in all forms, and no neighbour in a packet
/// changes.
TEST_P(BadNumbers, InRaysLeaveOtherLanesAlone) {
    const auto precision = Precision(GetParam());
    const std::vector<Triangle> mesh = icosphere(2);
    const Scene scene({place(makeModel(mesh))}, precision, 1);
    const std::vector<Ray> good = raysFromOutside(mesh, 1, 512, Target::Edge, Aim::Rounded, 3);
    const auto expected = traceSingles(kernels(), precision, scene.view(), good);
    const float bad[] = {NAN, INFINITY, -INFINITY, -NAN};
    Random random(4);
    std::vector<Ray> rays = good;
    for (std::size_t i = 0; i < rays.size(); i += 2) {
        float* values[] = {&rays[i].org[0], &rays[i].org[1], &rays[i].org[2], &rays[i].dir[0],
                           &rays[i].dir[1], &rays[i].dir[2], &rays[i].tNear};
        for (uint32_t n = random.below(3) + 1; n > 0; --n)
            *values[random.below(6)] = bad[random.below(4)];
        if (random.below(4) == 0) rays[i].tNear = NAN;
        if (random.below(4) == 0) rays[i].tFar = NAN;
    }
    for (const KernelTable* table : availableKernels()) {
        const auto packets = tracePackets(*table, precision, scene.view(), rays, Filling::Full);
        const auto singles = traceSingles(*table, precision, scene.view(), rays);
        const auto blocked = blockedPackets(*table, precision, scene.view(), rays, Filling::Full);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const bool spoilt = i % 2 == 0;
            ASSERT_TRUE(spoilt ? packets[i].triangle == kNoHit : sameHit(packets[i], expected[i]));
            ASSERT_TRUE(sameHit(packets[i], singles[i]));
            ASSERT_EQ(blocked[i] != 0, packets[i].triangle != kNoHit);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, HostEnvironmentControl,
                         testing::Values(int(Precision::Watertight), int(Precision::Precise)),
                         [](const auto& each) { return std::string(modeName(each.param)); });
INSTANTIATE_TEST_SUITE_P(Modes, BadNumbers, testing::Range(0, kPrecisionCount),
                         [](const auto& each) { return std::string(modeName(each.param)); });

} // namespace
} // namespace smart::test
