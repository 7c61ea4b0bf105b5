// SPDX-License-Identifier: MIT
// The precise mode on single models, against exact arithmetic.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/libsmart/kernel/precise_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

TEST(PreciseMode, RandomRaysHitAsExact) {
    const std::pair<const char*, std::vector<Triangle>> meshes[] = {
        {"soup of large triangles", triangleSoup(400, 0.5f, 1)},
        {"soup of small triangles", triangleSoup(3000, 0.03f, 2)},
        {"bumpy sphere", bumpySphere(3000)},
        {"heightfield", heightfield(3000)},
        {"one triangle", triangleSoup(1, 1.0f, 3)}};
    for (const auto& [name, mesh] : meshes) {
        checkPrecise(TracedScene(mesh), randomRays(mesh, rayCount(1000), 4), name);
    }
}

TEST(PreciseMode, AimedRaysHitAsExact) {
    for (const Aim aim : {Aim::Exact, Aim::Rounded, Aim::Normalised}) {
        const auto mesh = aim == Aim::Exact ? snapped(icosphere(3), 16) : icosphere(3);
        const TracedScene scene(mesh);
        for (const Target target : {Target::Vertex, Target::Edge, Target::Interior}) {
            const auto outside = raysFromOutside(mesh, 1, rayCount(1000), target, aim, 7);
            EXPECT_EQ(checkPrecise(scene, outside, "outside").hits, outside.size());
            const auto inside = raysFromInside(mesh, 1, rayCount(1000), target, aim, 6);
            EXPECT_EQ(checkPrecise(scene, inside, "inside").hits, inside.size());
        }
    }
}

std::vector<Triangle> transformed(std::vector<Triangle> mesh, double x, double y, double z,
                                  double offset) {
    const double scale[3] = {x, y, z}, by[3] = {0.577 * offset, -0.59 * offset, 0.565 * offset};
    for (Triangle& triangle : mesh) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) v[k] = float(v[k] * scale[k] + by[k]);
        }
    }
    return mesh;
}

/// Rays aimed at the sphere, mapped as `transformed` maps its vertices.
std::vector<Ray> transformedRays(const std::vector<Triangle>& sphere, double x, double y, double z,
                                 double offset, std::size_t count) {
    const double scale[3] = {x, y, z}, by[3] = {0.577 * offset, -0.59 * offset, 0.565 * offset};
    std::vector<Ray> rays;
    for (const Target target : {Target::Vertex, Target::Edge}) {
        for (Ray ray : raysFromOutside(sphere, 1, count / 2, target, Aim::Rounded, 8)) {
            for (int k = 0; k < 3; ++k) {
                ray.org[k] = float(ray.org[k] * scale[k] + by[k]);
                ray.dir[k] = float(ray.dir[k] * scale[k]);
            }
            rays.push_back(ray);
        }
    }
    return rays;
}

TEST(PreciseMode, HitsAsExactAtAnyScaleOffsetAndAspect) {
    const auto sphere = icosphere(3);
    const auto check = [&](double x, double y, double z, double offset) {
        const TracedScene scene(transformed(sphere, x, y, z, offset));
        checkPrecise(scene, transformedRays(sphere, x, y, z, offset, rayCount(200)),
                     "scale " + std::to_string(std::log10(x)) + ", " +
                         std::to_string(std::log10(z / x)) + " longer, offset " +
                         std::to_string(offset));
    };
    for (const double scale : {1e-44, 1e-40, 1e-30, 1e-12, 1e-3, 1e6, 1e12, 1e20, 1e30, 5e37})
        check(scale, scale, scale, 0);
    for (const double offset : {1e3, 1e5, 1e6}) check(1, 1, 1, offset);
    for (const double aspect : {1e4, 1e6, 1e-4, 1e12, 1e30}) check(1, 1, aspect, 0);
}

/// Layers of 8 x 8 quads, neighbours one unit in the last place of 3 apart, in shuffled order.
std::vector<Triangle> layers(double tiltX, double tiltY) {
    std::vector<Triangle> mesh;
    const auto corner = [&](double x, double y, int layer, float* v) {
        v[0] = float(x);
        v[1] = float(y);
        v[2] = float(3 + tiltX * x + tiltY * y) + float(layer) * 0x1p-22f;
    };
    for (int i = 0; i < 64; ++i) {
        const int layer = i * 29 % 64;
        for (int cell = 0; cell < 64; ++cell) {
            const double x = cell % 8 * 0.25 - 1, y = cell / 8 * 0.25 - 1;
            Triangle first, second;
            corner(x, y, layer, first.v0);
            corner(x + 0.25, y, layer, first.v1);
            corner(x + 0.25, y + 0.25, layer, first.v2);
            corner(x, y, layer, second.v0);
            corner(x + 0.25, y + 0.25, layer, second.v1);
            corner(x, y + 0.25, layer, second.v2);
            mesh.push_back(first);
            mesh.push_back(second);
        }
    }
    return mesh;
}

std::vector<Ray> obliqueRays(std::size_t count) {
    Random random(40);
    std::vector<Ray> rays;
    while (rays.size() < count) {
        const double side = random.below(2) ? 3 : -3;
        const double target[3] = {random.between(-1, 1), random.between(-1, 1), 3};
        const double origin[3] = {random.between(-2, 2), random.between(-2, 2), 3 + side};
        rays.push_back(makeRay(origin, target, Aim::Normalised));
    }
    return rays;
}

TEST(PreciseMode, OrdersLayersOneUlpApart) {
    const auto rays = obliqueRays(rayCount(200));
    for (const double tilt : {0.0, 0.25}) {
        const TracedScene scene(layers(tilt, -0.5 * tilt));
        checkPrecise(scene, rays, "layers");
        // Watertight compares distances within a model in double.
        auto hits =
            tracePackets(kernels(), Precision::Watertight, scene.view(), rays, Filling::Full);
        EXPECT_EQ(compareAll(scene, rays, hits).triangle, 0u);
        // The check must find the layer next to the right one.
        hits[7].triangle = (hits[7].triangle + 128) % (64 * 128);
        EXPECT_EQ(compareAll(scene, rays, hits).triangle, 1u);
    }
}

/// 64 x 64 quads in a tilted plane, or two such planes 0.01 apart.
std::vector<Triangle> tiltedPlanes(bool slab) {
    IndexedMesh mesh;
    for (int side = 0; side < (slab ? 2 : 1); ++side) {
        const auto first = uint32_t(mesh.xyz.size() / 3);
        for (int i = 0; i <= 64; ++i) {
            for (int j = 0; j <= 64; ++j) {
                const double x = j / 32.0 - 1, y = i / 32.0 - 1;
                mesh.addVertex(x, y, 0.3 * x - 0.2 * y - 0.01 * side);
            }
        }
        for (uint32_t i = 0; i < 64; ++i) {
            for (uint32_t j = 0; j < 64; ++j) {
                const uint32_t a = first + i * 65 + j;
                mesh.addQuad(a, a + 1, a + 66, a + 65);
            }
        }
    }
    return mesh.triangles();
}

TEST(PreciseMode, GrazingRaysHitAsExact) {
    std::size_t found = 0;
    for (const bool slab : {false, true}) {
        const TracedScene scene(tiltedPlanes(slab));
        for (const double angle : {1e-2, 1e-4, 1e-5, 1e-6}) {
            Random random(41);
            std::vector<Ray> rays;
            while (rays.size() < rayCount(60)) {
                const double turn = random.between(0, 6.28);
                double x = random.between(-0.9, 0.9), y = random.between(-0.9, 0.9);
                if (rays.size() % 2) x = std::round(x * 32) / 32;
                const double far = 3, c = std::cos(turn) * far, s = std::sin(turn) * far;
                const double target[3] = {x, y, 0.3 * x - 0.2 * y};
                const double origin[3] = {x + c, y + s,
                                          0.3 * (x + c) - 0.2 * (y + s) + far * angle};
                rays.push_back(makeRay(origin, target, Aim::Normalised));
            }
            checkPrecise(scene, rays, "angle " + std::to_string(angle));
            const auto watertight =
                tracePackets(kernels(), Precision::Watertight, scene.view(), rays, Filling::Full);
            found += compareAll(scene, rays, watertight).triangle;
        }
    }
    EXPECT_GT(found, 0u) << "the check must find what float gets wrong";
}

TEST(PreciseMode, LimitsAreClosedAndExact) {
    const auto mesh = bumpySphere(500);
    const TracedScene scene(mesh);
    auto rays = randomRays(mesh, rayCount(200), 21);
    std::vector<Ray> limited;
    for (const Ray& ray : rays) {
        const ExactAnswer answer = scene.reference().nearest(ray);
        if (!answer.must) continue;
        const float t = float(answer.nearest[0].t.get_d());
        const float below = std::nextafter(t, -INFINITY), above = std::nextafter(t, INFINITY);
        for (const float x : {below, t, above}) {
            for (const bool far : {false, true}) {
                Ray copy = ray;
                (far ? copy.tFar : copy.tNear) = x;
                limited.push_back(copy);
            }
        }
    }
    checkPrecise(scene, limited, "limits at the hit");
    // At exact distances: the layer itself belongs to the range.
    const TracedScene room(closedRoom());
    std::vector<Ray> exact;
    for (Ray ray : axisParallelRays(7, 1, rayCount(100), 12)) {
        const ExactAnswer answer = room.reference().nearest(ray);
        if (!answer.must || mpq_class(float(answer.nearest[0].t.get_d())) != answer.nearest[0].t)
            continue;
        const float t = float(answer.nearest[0].t.get_d());
        for (const float step : {-INFINITY, INFINITY}) {
            for (const float x : {t, std::nextafter(t, step)}) {
                ray.tNear = 0;
                ray.tFar = x;
                exact.push_back(ray);
                ray.tNear = x;
                ray.tFar = INFINITY;
                exact.push_back(ray);
                ray.tFar = x;
                exact.push_back(ray);
            }
        }
    }
    checkPrecise(room, exact, "limits exactly at walls");
}

TEST(PreciseMode, DirectionsOfAnyLengthHitAsExact) {
    const auto mesh = snapped(icosphere(2), 16);
    const TracedScene scene(mesh);
    const auto base = raysFromInside(mesh, 1, rayCount(100) + 10, Target::Edge, Aim::Exact, 23);
    for (const int power : {-149, -140, -126, -60, 60, 100, 126}) {
        std::vector<Ray> rays;
        for (Ray ray : base) {
            bool usable = false, finite = true;
            for (float& x : ray.dir) {
                x = std::ldexp(x, power);
                usable = usable || x != 0;
                finite = finite && std::isfinite(x);
            }
            if (power > 0) ray.tFar = std::ldexp(1.25f, -power);
            if (usable && finite) rays.push_back(ray);
        }
        checkPrecise(scene, rays, "length 2^" + std::to_string(power));
    }
}

TEST(PreciseMode, ExtremeComponentsHitAsExact) {
    Random random(42);
    const float values[] = {0.0f,  -0.0f,  1.0f,   -1.0f,   0.3f,    1e-45f, -1e-38f,
                            1e38f, -3e38f, 1e-20f, -1e-20f, 12345.f, 1e-10f, 1e10f};
    const auto any = [&] { return values[random.below(uint32_t(std::size(values)))]; };
    std::vector<Triangle> mesh(60);
    for (Triangle& triangle : mesh) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) v[k] = any();
        }
    }
    std::vector<Ray> rays(rayCount(400));
    for (Ray& ray : rays) {
        for (int k = 0; k < 3; ++k) {
            ray.org[k] = any();
            ray.dir[k] = any();
        }
        ray.tNear = random.below(2) ? 0.0f : std::abs(any());
        ray.tFar = random.below(2) ? INFINITY : std::abs(any());
    }
    EXPECT_GT(checkPrecise(TracedScene(mesh), rays, "extreme components").hits, rays.size() / 50);
}

TEST(PreciseMode, DoubleAndExactArithmeticAreRareAndCounted) {
    const auto count = [](const TracedScene& scene, std::span<const Ray> rays) {
        TraversalCounts counts;
        HitPacket hits;
        for (std::size_t i = 0; i < rays.size(); i += kPacketSize) {
            kernels().intersectCounted[int(Precision::Precise)](scene.view(), packet(rays, i), hits,
                                                                counts);
        }
        return counts;
    };
    const auto mesh = snapped(icosphere(3), 16);
    const TracedScene scene(mesh);
    const std::size_t size = rayCount(4000);
    const auto interior = raysFromOutside(mesh, 1, size, Target::Interior, Aim::Normalised, 43);
    const TraversalCounts usual = count(scene, interior);
    EXPECT_LT(usual.doubles, size / 50);
    EXPECT_LT(usual.exacts, size / 200);
    // Through vertices exactly: several triangles at the same distance.
    const auto vertices = raysFromOutside(mesh, 1, size, Target::Vertex, Aim::Exact, 44);
    const TraversalCounts hard = count(scene, vertices);
    EXPECT_GE(hard.exacts, size);
    EXPECT_GE(hard.doubles, hard.exacts);
}

TEST(PreciseMode, AxisParallelRaysHitAsExact) {
    const TracedScene scene(closedRoom());
    checkPrecise(scene, axisParallelRays(7.9, 0, rayCount(500), 10), "anywhere");
    checkPrecise(scene, axisParallelRays(7.5, 0.5, rayCount(500), 11), "half-integer origins");
    checkPrecise(scene, axisParallelRays(7, 1, rayCount(500), 12), "integer origins");
    checkPrecise(scene, axisParallelRays(8, 8, rayCount(250), 13), "origins on walls");
}

} // namespace
} // namespace smart::test
