// SPDX-License-Identifier: MIT
// Tiles over wide nodes against single rays in the kd-tree: the same bits, whatever the rays.
// Single rays are held against exact arithmetic elsewhere.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/kernel_runs.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"
#include "tests/support/traced_scene.h"

namespace smart::test {
namespace {

/// A scene with kd-trees in its models, for single rays, and one with wide trees, for tiles.
class TwoTrees {
public:
    explicit TwoTrees(std::vector<Triangle> triangles, Precision precision = Precision::Watertight)
        : TwoTrees({place(makeModel(std::move(triangles)))}, precision) {}
    explicit TwoTrees(std::vector<Instance> instances,
                      Precision precision = Precision::Watertight, bool lastOfEqual = false)
        : kd_(withKdTrees(instances), precision, 1, lastOfEqual),
          wide_(std::move(instances), precision, 1, lastOfEqual) {}

    const ModelView& kd() const { return kd_.view(); }
    const ModelView& wide() const { return wide_.view(); }
    Precision precision() const { return kd_.precision(); }

private:
    Scene kd_, wide_;
};

struct Disagreement {
    std::size_t rays = 0, hits = 0, closest = 0, any = 0;
};

/// Single rays in one view against tiles in another.
Disagreement compare(const KernelTable& kernels, Precision precision, const ModelView& kd,
                     const ModelView& view, std::span<const Ray> rays, Filling filling) {
    const std::vector<Hit> truth = traceSingles(kernels, precision, kd, rays);
    const std::vector<uint8_t> blocked = blockedSingles(kernels, precision, kd, rays);
    const std::vector<uint8_t> tiles = blockedTiles(kernels, precision, view, rays, filling);
    Disagreement result;
    result.rays = rays.size();
    result.closest = differences(traceTiles(kernels, precision, view, rays, filling), truth);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        result.hits += truth[i].triangle != kNoHit;
        result.any += tiles[i] != blocked[i];
    }
    return result;
}

/// All tables, both ways to fill packets, both modes that tiles have; returns how many rays hit.
std::size_t expectSame(const TwoTrees& scene, std::span<const Ray> rays, const std::string& name) {
    SCOPED_TRACE(name);
    std::size_t hits = 0;
    for (const KernelTable* kernels : availableKernels()) {
        SCOPED_TRACE(kernels->name);
        for (const Filling filling : {Filling::Full, Filling::Sparse}) {
            const Disagreement found =
                compare(*kernels, scene.precision(), scene.kd(), scene.wide(), rays, filling);
            EXPECT_EQ(found.closest, 0u) << "of " << found.rays;
            EXPECT_EQ(found.any, 0u) << "of " << found.rays;
            hits = found.hits;
        }
    }
    return hits;
}

/// Rays to a point from what other rays hit: t = 1 is the point, or the length is 1.
std::vector<Ray> raysTo(const double light[3], const ModelView& view, std::span<const Ray> rays,
                        bool unit) {
    std::vector<Ray> result;
    for (const Ray& ray : rays) {
        Hit hit;
        kernels().intersect1[int(Precision::Watertight)](view, ray, hit);
        Ray shadow{};
        double length = 0;
        for (int k = 0; k < 3; ++k) {
            const double t = hit.triangle == kNoHit ? 3.0 : hit.t * (1 - 1e-6);
            shadow.org[k] = float(double(ray.org[k]) + t * double(ray.dir[k]));
            length += (light[k] - shadow.org[k]) * (light[k] - shadow.org[k]);
        }
        length = std::sqrt(length);
        for (int k = 0; k < 3; ++k)
            shadow.dir[k] = float((light[k] - shadow.org[k]) / (unit ? length : 1));
        shadow.tFar = unit ? float(length) * (1 - 0x1p-20f) : 1.0f;
        result.push_back(shadow);
    }
    return result;
}

const CameraPose kPoses[] = {{{0.3, 0.4, 3}, {0, 0, 0}, {0, 1, 0}, 40},
                             {{0.1, -0.1, 0.2}, {1, 0.2, 0}, {0, 1, 0}, 70},
                             {{-3, 0, 0}, {0, 0, 0}, {0, 0, 1}, 45},
                             {{1.5, 1.5, 1.5}, {0, 0, 0}, {0, 1, 0}, 2}};
const double kLights[][3] = {{2, 3, 2}, {0, 0, 0}, {0.4, -0.2, 0.3}, {40, 1, 2}};

void expectSameFromEverywhere(const TwoTrees& scene, const std::string& name, uint32_t size = 40) {
    std::size_t hits = 0;
    for (const CameraPose& pose : kPoses) {
        const std::vector<Ray> rays = cameraRays(pose, size, size);
        hits += expectSame(scene, rays, name + ", camera");
        for (const bool unit : {false, true}) {
            const double* const light = kLights[(&pose - kPoses + unit) % 4];
            expectSame(scene, raysTo(light, scene.kd(), rays, unit), name + ", to a light");
        }
    }
    EXPECT_GT(hits, 0u) << name;
}

TEST(TileTraversal, CameraAndShadowRaysHitAsSingleRays) {
    for (const Precision precision : {Precision::Watertight, Precision::Fast}) {
        const std::pair<const char*, std::vector<Triangle>> meshes[] = {
            {"bumpy sphere", bumpySphere(3000)},
            {"soup of large triangles", triangleSoup(300, 0.5f, 1)},
            {"soup of small triangles", triangleSoup(3000, 0.05f, 2)},
            {"heightfield", heightfield(2000)},
            {"room", closedRoom()}};
        for (const auto& [name, mesh] : meshes)
            expectSameFromEverywhere(TwoTrees(mesh, precision), name);
    }
}

TEST(TileTraversal, ManySmallTriangles) {
    const TwoTrees scene(bumpySphere(40000));
    expectSameFromEverywhere(scene, "bumpy sphere of 40,000", 80);
}

/// The same scene with one box of its root gone.
class Damaged {
public:
    explicit Damaged(const ModelView& scene)
        : model_(*scene.children[0].model), instance_(scene.children[0]), view_(scene) {
        const WideNode& root = model_.wide.nodes[0];
        // Nodes refer to each other by number, so that all are copied.
        uint32_t last = 0;
        for (uint32_t i = 0; i <= last; ++i)
            for (const uint32_t child : model_.wide.nodes[i].child)
                if (!(child & kWideLeaf)) last = std::max(last, child);
        nodes_.assign(&root, &root + last + 1);
        for (int k = 0; k < 3; ++k) nodes_[0].lo[k][0] = Aabb::kInf;
        model_.wide.nodes = nodes_.data();
        instance_.model = &model_;
        view_.children = &instance_;
    }
    const ModelView& view() const { return view_; }

private:
    std::vector<WideNode> nodes_;
    ModelView model_;
    InstanceView instance_;
    ModelView view_;
};

TEST(TileTraversal, ControlADamagedTreeIsNoticedByBothKindsOfTiles) {
    const TwoTrees scene(bumpySphere(3000));
    const Damaged damaged(scene.wide());
    const std::vector<Ray> camera = cameraRays(kPoses[0], 64, 64);
    const Disagreement found = compare(kernels(), Precision::Watertight, scene.kd(), damaged.view(),
                                       camera, Filling::Full);
    EXPECT_GT(found.closest, 0u);
    EXPECT_GT(found.any, 0u);
    const double light[] = {-2, -3, -4}; // behind the sphere: nearly all are blocked
    const std::vector<Ray> shadow = raysTo(light, scene.kd(), camera, false);
    std::size_t wrong = 0;
    const auto truth = blockedSingles(kernels(), Precision::Watertight, scene.kd(), shadow);
    const auto tiles =
        blockedTiles(kernels(), Precision::Watertight, damaged.view(), shadow, Filling::Full);
    for (std::size_t i = 0; i < shadow.size(); ++i) wrong += truth[i] != tiles[i];
    EXPECT_GT(wrong, 0u);
}

/// Rays from one origin at vertices, edges and interiors, 64 at a time near one triangle.
std::vector<Ray> aimedTiles(std::span<const Triangle> mesh, const double origin[3],
                            std::size_t tiles, Aim aim, uint64_t seed) {
    Random random(seed);
    std::vector<Ray> rays;
    for (std::size_t tile = 0; tile < tiles; ++tile) {
        const Triangle& triangle = mesh[random.below(uint32_t(mesh.size()))];
        for (int i = 0; i < 64; ++i) {
            double w[3] = {};
            const uint32_t corner = random.below(3);
            w[corner] = 1;
            if (i % 3) {
                w[(corner + 1) % 3] = random.unit();
                w[corner] -= w[(corner + 1) % 3];
            }
            double target[3];
            for (int k = 0; k < 3; ++k)
                target[k] =
                    w[0] * triangle.v0[k] + w[1] * triangle.v1[k] + w[2] * triangle.v2[k];
            rays.push_back(makeRay(origin, target, aim));
        }
    }
    return rays;
}

TEST(TileTraversal, LosesNothingAtVerticesAndEdgesAtAnyScale) {
    for (const double scale : {1e-12, 1e-3, 1.0, 1e3, 1e12}) {
        auto mesh = icosphere(3);
        for (Triangle& triangle : mesh)
            for (float* v : {triangle.v0, triangle.v1, triangle.v2})
                for (int k = 0; k < 3; ++k) v[k] = float(v[k] * scale);
        const TwoTrees scene(mesh);
        const double inside[] = {0.1 * scale, -0.2 * scale, 0.05 * scale}, centre[] = {0, 0, 0};
        for (const double* origin : {inside, centre}) {
            const auto rays = aimedTiles(mesh, origin, rayCount(40), Aim::Normalised, 3);
            EXPECT_EQ(expectSame(scene, rays, "scale " + std::to_string(scale)),
                      rays.size());
        }
    }
}

TEST(TileTraversal, OriginsOnVerticesAndPlanes) {
    const auto mesh = snapped(icosphere(2), 16);
    const TwoTrees scene(mesh);
    const double vertex[] = {mesh[5].v0[0], mesh[5].v0[1], mesh[5].v0[2]};
    const double middle[] = {0.5 * (mesh[5].v0[0] + mesh[5].v1[0]),
                             0.5 * (mesh[5].v0[1] + mesh[5].v1[1]),
                             0.5 * (mesh[5].v0[2] + mesh[5].v1[2])};
    for (const double* origin : {vertex, middle})
        expectSame(scene, aimedTiles(mesh, origin, rayCount(40), Aim::Rounded, 4), "on it");
    const TwoTrees room(closedRoom());
    for (const CameraPose& pose : {CameraPose{{8, 0, 0}, {0, 0, 0}, {0, 1, 0}, 40},
                                   CameraPose{{1, 1, 1}, {5, 1, 1}, {0, 1, 0}, 60},
                                   CameraPose{{7, -8, 3}, {7, 0, 3}, {1, 0, 0}, 50}})
        expectSame(room, cameraRays(pose, 32, 32), "integer eye");
}

TEST(TileTraversal, BadRays) {
    const TwoTrees scene(bumpySphere(2000));
    Random random(5);
    std::vector<Ray> rays = cameraRays(kPoses[0], 64, 64);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray& ray = rays[i];
        switch (i % 23) {
            case 0: ray.dir[i % 3] = NAN; break;
            case 3: ray.org[i % 3] = INFINITY; break;
            case 5: ray.tFar = -1; break;
            case 7: ray.tNear = NAN; break;
            case 9: ray.dir[0] = ray.dir[1] = ray.dir[2] = 0; break;
            case 11: ray.dir[i % 3] = 0; break;
            case 13: ray.tFar = float(random.between(1, 4)); break;
            case 15: ray.tNear = float(random.between(1, 4)); break;
            case 17:
                for (float& d : ray.dir) d *= 1e30f;
                break;
            case 19:
                for (float& d : ray.dir) d *= 1e-30f;
                break;
            default: break;
        }
    }
    expectSame(scene, rays, "bad rays among good ones");
    for (Ray& ray : rays) ray.dir[2] = NAN;
    EXPECT_EQ(expectSame(scene, rays, "bad rays only"), 0u);
}

TEST(TileTraversal, RaysThatAreNoTile) {
    const auto mesh = bumpySphere(2000);
    const TwoTrees scene(mesh);
    expectSame(scene, randomRays(mesh, rayCount(2000), 6), "unrelated");
    expectSame(scene, axisParallelRays(1.2, 0, rayCount(1000), 7), "axis-parallel");
    std::vector<Ray> rays = cameraRays(kPoses[1], 40, 40);
    Random random(8);
    for (Ray& ray : rays) {
        const auto d = random.onSphere();
        for (std::size_t k = 0; k < 3; ++k) ray.dir[k] = float(d[k]);
    }
    expectSame(scene, rays, "all ways from one origin");
    rays = cameraRays(kPoses[0], 40, 40);
    for (Ray& ray : rays)
        for (float& x : ray.org) x += float(random.between(-1e-3, 1e-3));
    expectSame(scene, rays, "origins near each other");
    const double light[] = {2, 3, 2};
    std::vector<Ray> shadow = raysTo(light, scene.kd(), cameraRays(kPoses[0], 40, 40), false);
    for (std::size_t i = 0; i < shadow.size(); ++i) {
        if (i % 5 == 0) shadow[i].tFar = 1.5f; // beyond the light
        if (i % 7 == 0) shadow[i].dir[i % 3] += 1e-3f;
    }
    expectSame(scene, shadow, "not quite to one point");
}

TEST(TileTraversal, MissesAndHorizon) {
    const TwoTrees scene(heightfield(5000));
    expectSameFromEverywhere(scene, "heightfield");
    for (const double height : {0.0, 0.05, 0.3}) {
        const CameraPose grazing{{-3, height, 0.1}, {3, height, 0}, {0, 1, 0}, 30};
        expectSame(scene, cameraRays(grazing, 48, 48), "along it");
        const CameraPose other{{-3, 0.1, height}, {3, 0, height}, {0, 1, 0}, 30};
        expectSame(scene, cameraRays(other, 48, 48), "along it");
    }
    const CameraPose away{{0, 0, 5}, {0, 0, 10}, {0, 1, 0}, 40};
    EXPECT_EQ(expectSame(scene, cameraRays(away, 32, 32), "away"), 0u);
}

TEST(TileTraversal, OneTriangleAndNone) {
    expectSameFromEverywhere(TwoTrees(triangleSoup(1, 1.0f, 3)), "one");
    const TwoTrees empty{std::vector<Triangle>{}}, nothing{std::vector<Instance>{}};
    const auto rays = cameraRays(kPoses[0], 16, 16);
    EXPECT_EQ(expectSame(empty, rays, "no triangle"), 0u);
    EXPECT_EQ(expectSame(nothing, rays, "no instance"), 0u);
}

TEST(TileTraversal, LargeCoordinates) {
    for (const double scale : {1e13, 1e20, 1e-20}) {
        auto mesh = bumpySphere(500);
        for (Triangle& triangle : mesh)
            for (float* v : {triangle.v0, triangle.v1, triangle.v2})
                for (int k = 0; k < 3; ++k) v[k] = float(v[k] * scale);
        const TwoTrees scene(mesh);
        auto rays = cameraRays(kPoses[0], 24, 24);
        for (Ray& ray : rays)
            for (float& x : ray.org) x = float(x * scale);
        EXPECT_GT(expectSame(scene, rays, "scale " + std::to_string(scale)), 0u);
    }
}

TEST(TileTraversal, DistancesBeyondFloat) {
    auto mesh = bumpySphere(500);
    for (Triangle& triangle : mesh)
        for (float* v : {triangle.v0, triangle.v1, triangle.v2})
            for (int k = 0; k < 3; ++k) v[k] *= 1e10f;
    const TwoTrees scene(mesh);
    auto rays = cameraRays(kPoses[0], 24, 24);
    for (Ray& ray : rays)
        for (int k = 0; k < 3; ++k) {
            ray.org[k] *= 1e10f;
            ray.dir[k] *= 1e-32f;
        }
    EXPECT_GT(expectSame(scene, rays, "t of some 1e42"), 0u);
    std::size_t infinite = 0;
    for (const Hit& hit : traceSingles(kernels(), Precision::Watertight, scene.kd(), rays))
        infinite += hit.triangle != kNoHit && hit.t == INFINITY;
    EXPECT_GT(infinite, 0u);
}

/// 1 + 2^-bits and 1 - 2^-bits in turns.
double nearOne(std::size_t i, int bits) { return 1 + std::ldexp(i % 2 ? 1.0 : -1.0, -bits); }

TEST(TileTraversal, LimitsNearTheHit) {
    const TwoTrees scene(bumpySphere(3000));
    const std::vector<Ray> camera = cameraRays(kPoses[0], 40, 40);
    for (const bool far : {true, false}) {
        std::vector<Ray> rays;
        for (std::size_t i = 0; i < camera.size(); ++i) {
            Hit hit;
            kernels().intersect1[int(Precision::Watertight)](scene.kd(), camera[i], hit);
            if (hit.triangle == kNoHit) continue;
            Ray ray = camera[i];
            (far ? ray.tFar : ray.tNear) = float(hit.t * nearOne(i, 6 + int(i / 2 % 20)));
            rays.push_back(ray);
        }
        expectSame(scene, rays, far ? "far limits" : "near limits");
    }
}

TEST(TileTraversal, ShadowRaysThatStartNearTheirSurface) {
    for (const auto& mesh : {bumpySphere(3000), heightfield(3000)}) {
        const TwoTrees scene(mesh);
        const std::vector<Ray> camera = cameraRays(kPoses[0], 40, 40);
        for (const auto& light : kLights) {
            std::vector<Ray> rays;
            for (std::size_t i = 0; i < camera.size(); ++i) {
                Hit hit;
                kernels().intersect1[int(Precision::Watertight)](scene.kd(), camera[i], hit);
                if (hit.triangle == kNoHit) continue;
                Ray ray{};
                const double t = hit.t * nearOne(i, 6 + int(i / 2 % 20));
                for (int k = 0; k < 3; ++k) {
                    ray.org[k] = float(camera[i].org[k] + t * camera[i].dir[k]);
                    ray.dir[k] = float(light[k] - ray.org[k]);
                }
                ray.tFar = 1;
                rays.push_back(ray);
            }
            expectSame(scene, rays, "behind and before what was seen");
        }
    }
}

TEST(TileTraversal, EqualDistancesGoToTheLowest) {
    const auto mesh = icosphere(3);
    std::vector<Triangle> twice = mesh;
    twice.insert(twice.end(), mesh.begin(), mesh.end());
    const TwoTrees scene(twice);
    expectSameFromEverywhere(scene, "each triangle twice");
    const ModelPtr model = makeModel(mesh);
    const TwoTrees thrice({place(model), place(model), place(model)});
    expectSameFromEverywhere(thrice, "three instances in one place");
    const TwoTrees last({place(model), place(makeModel(twice)), place(model), place(model)},
                          Precision::Watertight, true);
    expectSameFromEverywhere(last, "the last of equal ones");
    const TwoTrees nested({place(makeModel(mesh, {place(model), place(model)})), place(model)});
    expectSameFromEverywhere(nested, "nested in one place");
}

TEST(TileTraversal, Instances) {
    const glm::dmat4 one(1.0);
    const glm::dvec3 axis(0.36, 0.48, 0.8);
    Random random(9);
    const ModelPtr models[] = {makeModel(bumpySphere(800)), makeModel(triangleSoup(60, 0.4f, 10))};
    for (const std::size_t count : {1u, 2u, 30u}) {
        std::vector<Instance> instances;
        for (std::size_t i = 0; i < count; ++i) {
            const double size = count == 1 ? 0.9 : random.between(0.1, 0.5);
            const glm::dmat4 matrix =
                glm::translate(one, glm::dvec3(random.between(-1, 1), random.between(-1, 1),
                                               random.between(-1, 1)) * (count > 1 ? 1.0 : 0.1)) *
                glm::rotate(one, random.between(0, 6), axis) *
                glm::scale(one, glm::dvec3(i % 2 ? -size : size, size, size * 1.5));
            instances.push_back(place(models[i % 2], glm::dmat4x3(matrix)));
        }
        for (const Precision precision : {Precision::Watertight, Precision::Fast}) {
            expectSameFromEverywhere(TwoTrees(instances, precision),
                                     std::to_string(count) + " instances");
        }
        const ModelPtr group = makeModel(triangleSoup(40, 0.5f, 11), instances);
        std::vector<Instance> outer = {
            place(group, glm::dmat4x3(glm::rotate(one, 0.5, axis))),
            place(group, glm::dmat4x3(glm::translate(one, glm::dvec3(0.5, 0.2, -1))))};
        expectSameFromEverywhere(TwoTrees(outer), "nested instances");
    }
}

TEST(TileTraversal, PreciseModeAndKdTreesTakePackets) {
    const auto rays = cameraRays(kPoses[0], 16, 16);
    const TwoTrees precise(bumpySphere(500), Precision::Precise);
    EXPECT_GT(expectSame(precise, rays, "precise"), 0u);
    for (const Precision precision : {Precision::Watertight, Precision::Fast}) {
        const TwoTrees scene(bumpySphere(500), precision);
        const Disagreement found =
            compare(kernels(), precision, scene.kd(), scene.kd(), rays, Filling::Full);
        EXPECT_EQ(found.closest + found.any, 0u);
        EXPECT_GT(found.hits, 0u);
    }
}

TEST(TileTraversal, ModelsOfBothKindsSideBySide) {
    const auto nearer = glm::translate(glm::dmat4(1.0), glm::dvec3(0.4, 0.3, 0.7));
    for (const Precision precision : {Precision::Watertight, Precision::Fast}) {
        std::vector<Instance> instances = {
            place(makeModel(bumpySphere(500), {}, BuildQuality::KdTree)),
            place(makeModel(icosphere(3)), glm::dmat4x3(nearer))};
        const ModelPtr group =
            makeModel(triangleSoup(40, 0.5f, 11), instances, BuildQuality::KdTree);
        expectSameFromEverywhere(TwoTrees(instances, precision), "side by side");
        expectSameFromEverywhere(TwoTrees({place(group)}, precision), "in a kd-tree's model");
    }
}

} // namespace
} // namespace smart::test
