// SPDX-License-Identifier: MIT
// Rays alone and in packets through wide trees: the bits that they find in the kd-tree, which is
// held against exact arithmetic elsewhere, and what each triangle alone says.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/libsmart/kernel/engine_check.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"

namespace smart::test {
namespace {

constexpr Precision kPrecisions[] = {Precision::Fast, Precision::Watertight, Precision::Precise};
constexpr const char* kNames[] = {"fast", "watertight", "precise"};

/// Streams of incoherent rays against hits that are known.
void expectStreams(const ModelView& view, std::span<const Ray> rays, Precision precision,
                   std::span<const Hit> truth) {
    for (const KernelTable* kernels : availableKernels())
        for (const Filling filling : {Filling::Full, Filling::Sparse}) {
            SCOPED_TRACE(kernels->name);
            EXPECT_EQ(differences(traceStream(*kernels, precision, view, rays, filling), truth),
                      0u);
            const auto blocked = blockedStream(*kernels, precision, view, rays, filling);
            std::size_t unlike = 0;
            for (std::size_t i = 0; i < rays.size(); ++i)
                unlike += (blocked[i] != 0) != (truth[i].triangle != kNoHit);
            EXPECT_EQ(unlike, 0u);
        }
}

/// All tables and all ways to call them. Returns how many rays hit.
std::size_t expectSame(std::vector<Instance> instances, std::span<const Ray> rays,
                       const std::string& name,
                       std::span<const Precision> precisions = kPrecisions) {
    std::size_t hits = 0;
    for (const Precision precision : precisions) {
        SCOPED_TRACE(name + ", " + kNames[int(precision)]);
        const TracedScene scene(instances, precision);
        std::vector<Hit> truth = traceSingles(kernels(), precision, scene.view(), rays);
        traceAllWays(scene.wideView(), rays, precision, truth);
        expectStreams(scene.wideView(), rays, precision, truth);
        expectStreams(scene.view(), rays, precision, truth);
        hits = 0;
        for (const Hit& hit : truth) hits += hit.triangle != kNoHit;
    }
    return hits;
}
std::size_t expectSame(const std::vector<Triangle>& mesh, std::span<const Ray> rays,
                       const std::string& name) {
    return expectSame({place(makeModel(mesh))}, rays, name);
}

std::vector<Triangle> scaled(std::vector<Triangle> mesh, double factor) {
    for (Triangle& triangle : mesh)
        for (float* v : {triangle.v0, triangle.v1, triangle.v2})
            for (int k = 0; k < 3; ++k) v[k] = float(v[k] * factor);
    return mesh;
}

TEST(WideRays, OneToFortyTriangles) {
    for (uint32_t count = 1; count <= 40; count += count < 20 ? 1 : 5) {
        const auto mesh = triangleSoup(count, 0.7f, count);
        expectSame(mesh, randomRays(mesh, rayCount(100), count), std::to_string(count));
    }
}

TEST(WideRays, RandomRays) {
    for (const auto& [name, mesh] : {std::pair{"bumpy sphere", bumpySphere(3000)},
                                     std::pair{"soup", triangleSoup(2000, 0.15f, 3)},
                                     std::pair{"heightfield", heightfield(2000)},
                                     std::pair{"room", closedRoom()}})
        EXPECT_GT(expectSame(mesh, randomRays(mesh, rayCount(1500), 4), name), 0u);
}

TEST(WideRays, AimedAtVerticesAndEdgesAtAnyScale) {
    const auto mesh = snapped(icosphere(3), 16);
    for (const Target target : {Target::Vertex, Target::Edge}) {
        const auto inside = raysFromInside(mesh, 1, rayCount(500), target, Aim::Exact, 5);
        EXPECT_EQ(expectSame(mesh, inside, "from inside"), inside.size());
        expectSame(mesh, raysFromOutside(mesh, 1, rayCount(500), target, Aim::Exact, 6),
                   "from outside");
    }
    const auto rays = raysFromInside(mesh, 1, rayCount(200), Target::Edge, Aim::Normalised, 7);
    for (const double scale : {1e-30, 1e-12, 1e-3, 1e6, 1e12, 1e20}) {
        auto moved = rays;
        for (Ray& ray : moved)
            for (float& x : ray.org) x = float(x * scale);
        const Precision modes[] = {Precision::Watertight, Precision::Precise};
        const Precision sound[] = {Precision::Precise};
        // Products of three coordinates underflow below some 1e-13.
        const bool holds = scale > 1e-13;
        const std::size_t hits =
            expectSame({place(makeModel(scaled(mesh, scale)))}, moved,
                       "scale " + std::to_string(scale),
                       holds ? std::span<const Precision>(modes) : sound);
        EXPECT_EQ(hits, rays.size()) << scale;
    }
}

TEST(WideRays, AxisParallelRaysAndZeros) {
    const auto mesh = snapped(closedRoom(), 4);
    expectSame(mesh, axisParallelRays(9, 0.5, rayCount(1000), 8), "on planes of boxes");
    std::vector<Ray> rays = axisParallelRays(1.2, 0, rayCount(400), 9);
    for (std::size_t i = 0; i < rays.size(); i += 2)
        for (float& d : rays[i].dir) d = d == 0 ? -d : d;
    for (std::size_t i = 0; i < rays.size(); i += 3)
        for (float& x : rays[i].org) x = i % 2 ? -0.0f : 0.0f;
    for (std::size_t i = 0; i < rays.size(); i += 5) rays[i].tFar = INFINITY;
    for (std::size_t i = 0; i < rays.size(); i += 7) rays[i].tNear = -0.0f;
    for (std::size_t i = 0; i < rays.size(); i += 11)
        rays[i].dir[0] = rays[i].dir[1] = rays[i].dir[2] = 0;
    expectSame(bumpySphere(1000), rays, "zeros of either sign");
    // Flat boxes, met in their plane and across it.
    std::vector<Triangle> flat;
    for (int i = 0; i < 30; ++i) {
        const float x = float(i % 6) - 3, y = float(i / 6) - 3;
        flat.push_back({{x, y, 0}, {x + 1, y, 0}, {x, y + 1, 0}});
    }
    expectSame(flat, axisParallelRays(4, 0.5, rayCount(600), 10), "flat");
}

TEST(WideRays, Limits) {
    const auto mesh = icosphere(3);
    std::vector<Ray> rays = randomRays(mesh, rayCount(1000), 11);
    Random random(12);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        Ray& ray = rays[i];
        switch (i % 8) {
            case 0: ray.tFar = float(random.between(0, 2)); break;
            case 1: ray.tNear = float(random.between(0, 2)); break;
            case 2: ray.tFar = INFINITY; break;
            case 3: ray.tNear = ray.tFar = float(random.between(0, 2)); break;
            case 4: ray.tNear = NAN; break;
            case 5: ray.dir[i % 3] *= 1e30f; break;
            case 6: ray.org[i % 3] = INFINITY; break;
            default: ray.tNear = -INFINITY; ray.tFar = INFINITY;
        }
    }
    EXPECT_GT(expectSame(mesh, rays, "limits"), 0u);
}

/// Rays as an application sends them: several from each place that others hit, all ways.
TEST(WideRays, SecondaryRays) {
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1.0), 0.7, glm::dvec3(0.36, 0.48, 0.8));
    for (const auto& [name, mesh] : {std::pair{"bumpy sphere", bumpySphere(5000)},
                                     std::pair{"room", closedRoom()},
                                     std::pair{"soup", triangleSoup(1000, 0.2f, 21)}}) {
        const TracedScene source(mesh);
        Random random(22);
        std::vector<Ray> rays;
        for (const Ray& ray : randomRays(mesh, rayCount(300), 23)) {
            Hit hit;
            kernels().intersect1[int(Precision::Watertight)](source.view(), ray, hit);
            for (int i = 0; i < 5; ++i) {
                Ray next{};
                const auto way = random.onSphere();
                const float t = hit.triangle == kNoHit ? 0.5f : hit.t;
                for (int k = 0; k < 3; ++k) {
                    next.org[k] = ray.org[k] + t * ray.dir[k];
                    next.dir[k] = float(way[std::size_t(k)]);
                }
                next.tFar = i < 4 ? float(random.between(0, 1)) : INFINITY;
                rays.push_back(next);
            }
        }
        expectSame(mesh, rays, name);
        expectSame({place(makeModel(mesh), glm::dmat4x3(turned))}, rays, "turned");
    }
}

/// From each of `places` places 48 rays, the last sixteen from close by; many at vertices.
std::vector<Ray> raysFromPlaces(const std::vector<Triangle>& mesh, std::size_t places) {
    Random random(32);
    std::vector<Ray> rays;
    for (const Ray& place : randomRays(mesh, places, 33)) {
        for (int i = 0; i < 48; ++i) {
            const Triangle& triangle = mesh[std::size_t(random.between(0, double(mesh.size())))];
            const auto way = random.onSphere();
            const bool aimed = i % 3 == 0; // at a vertex: equal distances and edges
            Ray ray{};
            for (int k = 0; k < 3; ++k) {
                ray.org[k] = 0.4f * place.org[k];
                if (i >= 32) ray.org[k] += float(random.between(-0.02, 0.02));
                ray.dir[k] = aimed ? triangle.v1[k] - ray.org[k] : float(way[std::size_t(k)]);
            }
            if (i % 7 == 1) ray.dir[i % 3] = i % 2 ? 0.0f : -0.0f;
            ray.tFar = i % 4 == 0 ? INFINITY : float(random.between(0, 1.5));
            ray.tNear = i % 5 == 0 ? 0.3f * ray.tFar : 0.0f;
            if (i == 9) ray.tFar = NAN;
            rays.push_back(ray);
        }
    }
    return rays;
}

// Packets of such rays stay together to the end.
TEST(WideRays, PacketsThatStartCloseTogether) {
    for (const auto& [name, mesh] : {std::pair{"icosphere", snapped(icosphere(3), 16)},
                                     std::pair{"soup", triangleSoup(1000, 0.2f, 31)},
                                     std::pair{"room", closedRoom()}}) {
        const std::vector<Ray> rays = raysFromPlaces(mesh, rayCount(40));
        EXPECT_GT(expectSame(mesh, rays, name), 0u);
        std::vector<Ray> far = rays;
        for (Ray& ray : far)
            for (int k = 0; k < 3; ++k) ray.org[k] *= 0x1p50f;
        const Precision modes[] = {Precision::Watertight};
        expectSame({place(makeModel(scaled(mesh, 0x1p50)))}, far, "large coordinates", modes);
    }
}

// They come to each instance as a packet: of two in one place the hits are equally far.
TEST(WideRays, PacketsThatStartCloseTogetherAmongInstances) {
    const glm::dmat4 one(1.0);
    const Precision modes[] = {Precision::Fast, Precision::Watertight};
    for (const auto& [name, mesh] : {std::pair{"icosphere", snapped(icosphere(2), 16)},
                                     std::pair{"soup", triangleSoup(300, 0.2f, 34)}}) {
        const ModelPtr model = makeModel(mesh);
        const auto turned = glm::dmat4x3(glm::rotate(one, 0.7, glm::dvec3(0.36, 0.48, 0.8)));
        const auto mirrored = glm::dmat4x3(glm::scale(one, glm::dvec3(-1, 0.5, 2)));
        const auto near = glm::dmat4x3(glm::translate(one, glm::dvec3(0.01, 0, 0)));
        const ModelPtr nested = makeModel(
            triangleSoup(40, 0.5f, 35), {place(model, turned), place(model), place(model, near)});
        const std::vector<Ray> rays = raysFromPlaces(mesh, rayCount(8));
        const std::vector<std::vector<Instance>> scenes = {
            {place(model), place(model)},
            {place(nested)},
            {place(model, mirrored), place(nested), place(model), place(nested, turned),
             place(makeModel({})), place(model, near), place(model)}};
        for (const std::vector<Instance>& instances : scenes)
            EXPECT_GT(expectSame(instances, rays,
                                 name + (", " + std::to_string(instances.size())), modes),
                      0u);
    }
    std::vector<Instance> many;
    Random random(36);
    const ModelPtr small = makeModel(icosphere(1));
    for (int i = 0; i < 60; ++i) {
        const glm::dvec3 at(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        const glm::dmat4 size = glm::scale(one, glm::dvec3(random.between(0.05, 0.3)));
        many.push_back(place(small, glm::dmat4x3(glm::translate(one, at) * size)));
    }
    EXPECT_GT(expectSame(many, raysFromPlaces(icosphere(2), rayCount(8)), "many", modes), 0u);
}

TEST(WideRays, EqualDistances) {
    const auto mesh = icosphere(2);
    std::vector<Triangle> twice = mesh;
    twice.insert(twice.end(), mesh.begin(), mesh.end());
    const auto rays = raysFromOutside(mesh, 1, rayCount(200), Target::Edge, Aim::Rounded, 13);
    expectSame(twice, rays, "each triangle twice");
    const ModelPtr model = makeModel(mesh);
    std::vector<Instance> places(20, place(model));
    places.push_back(place(makeModel(twice, {place(model), place(model)})));
    expectSame(places, rays, "instances in one place");
    // Interiors: on an edge, float distances of two neighbours differ.
    const auto inside =
        raysFromOutside(mesh, 1, rayCount(200), Target::Interior, Aim::Rounded, 13);
    for (const Precision precision : kPrecisions) {
        const Scene scene(withKdTrees(places), precision, 1, true);
        std::vector<Hit> truth = traceSingles(kernels(), precision, scene.view(), inside);
        for (const Hit& hit : truth) EXPECT_TRUE(hit.triangle == kNoHit || hit.path[0] == 20);
        const Scene wide(places, precision, 1, true);
        traceAllWays(wide.view(), inside, precision, truth);
    }
}

TEST(WideRays, ManyInstancesThatOverlap) {
    Random random(14);
    const ModelPtr models[] = {makeModel(bumpySphere(300)), makeModel(triangleSoup(30, 0.4f, 15))};
    for (const int count : {2, 5, 17, 100}) {
        std::vector<Instance> instances;
        for (int i = 0; i < count; ++i) {
            const glm::dmat4 one(1.0);
            const glm::dmat4 matrix =
                glm::translate(one, glm::dvec3(random.between(-0.3, 0.3), random.between(-0.3, 0.3),
                                               random.between(-0.3, 0.3))) *
                glm::rotate(one, random.between(0, 6), glm::dvec3(0.36, 0.48, 0.8)) *
                glm::scale(one, glm::dvec3(random.between(0.2, 1.5)));
            instances.push_back(place(models[i % 2], glm::dmat4x3(matrix)));
        }
        const TracedScene scene(instances);
        const auto rays = randomRays(models[0]->triangles, rayCount(count > 50 ? 60 : 200), 16);
        checkWatertight(scene, rays, std::to_string(count) + " instances");
        expectSame({place(makeModel(triangleSoup(40, 0.5f, 17), instances))},
                   std::span(rays).first(rays.size() / 2), "nested");
    }
}

/// Every triangle in a model of its own: nothing is left of trees but the boxes of instances.
TEST(WideRays, WhatEachTriangleAloneSays) {
    const auto mesh = triangleSoup(60, 0.6f, 18);
    const auto rays = randomRays(mesh, rayCount(400), 19);
    std::vector<Hit> nearest(rays.size());
    for (Hit& hit : nearest) hit.triangle = kNoHit;
    for (uint32_t i = 0; i < mesh.size(); ++i) {
        const Scene alone({place(makeModel({mesh[i]}, {}, BuildQuality::KdTree))},
                          Precision::Precise, 1);
        const auto hits = traceSingles(kernels(), Precision::Precise, alone.view(), rays);
        for (std::size_t r = 0; r < rays.size(); ++r) {
            if (hits[r].triangle == kNoHit) continue;
            if (nearest[r].triangle != kNoHit && nearest[r].t <= hits[r].t) continue;
            nearest[r] = hits[r];
            nearest[r].triangle = i;
        }
    }
    const TracedScene scene(mesh, Precision::Precise);
    traceAllWays(scene.wideView(), rays, Precision::Precise, nearest);
}

TEST(WideRays, ControlADamagedTreeIsNoticed) {
    const auto mesh = bumpySphere(2000);
    const TracedScene scene(mesh);
    const auto rays = raysFromOutside(mesh, 1, 1000, Target::Interior, Aim::Rounded, 20);
    ModelView view = scene.wideView();
    InstanceView instance = view.children[0];
    ModelView model = *instance.model;
    std::vector<WideNode> nodes(1);
    uint32_t last = 0;
    for (uint32_t i = 0; i <= last; ++i)
        for (const uint32_t child : model.wide.nodes[i].child)
            if (!(child & kWideLeaf)) last = std::max(last, child);
    nodes.assign(model.wide.nodes, model.wide.nodes + last + 1);
    for (int k = 0; k < 3; ++k) nodes[0].lo[k][0] += 0.05f;
    model.wide.nodes = nodes.data();
    instance.model = &model;
    view.children = &instance;
    const auto truth = traceSingles(kernels(), Precision::Watertight, scene.view(), rays);
    EXPECT_GT(differences(traceSingles(kernels(), Precision::Watertight, view, rays), truth), 0u);
    EXPECT_GT(differences(tracePackets(kernels(), Precision::Watertight, view, rays, Filling::Full),
                          truth),
              0u);
}

} // namespace
} // namespace smart::test
