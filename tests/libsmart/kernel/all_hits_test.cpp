// SPDX-License-Identifier: MIT
// All that rays meet, against each triangle by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "tests/support/kernel_runs.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/traced_scene.h"

namespace smart::test {
namespace {

using Name = std::vector<uint32_t>; ///< path, then triangle

Name nameOf(const Hit& hit) {
    Name name(hit.path, hit.path + hit.levels);
    name.push_back(hit.triangle);
    return name;
}

/// A soup, placed twice and, nested in another object, a third time.
struct SoupScene {
    std::vector<Triangle> triangles = triangleSoup(120, 0.8f, 7);
    glm::dmat4x3 places[3];
    std::vector<Instance> instances;

    SoupScene() {
        const glm::dmat4 one(1.0);
        places[0] = glm::dmat4x3(1.0);
        places[1] = glm::dmat4x3(glm::rotate(one, 0.7, glm::dvec3(0.36, 0.48, 0.8)));
        places[2] = glm::dmat4x3(glm::translate(one, glm::dvec3(0.3, -0.2, 0.1)));
        const ModelPtr soup = makeModel(triangles);
        instances = {place(soup), place(soup, places[1]),
                     place(makeModel({}, {place(soup, places[2])}))};
    }
    Name nameOf(uint32_t copy, uint32_t triangle) const {
        return copy == 2 ? Name{2, 0, triangle} : Name{copy, triangle};
    }
};

/// Packets of rays with much in common, and some with nothing.
std::vector<Ray> rays() {
    std::mt19937 random(3);
    std::normal_distribution<float> normal;
    std::vector<Ray> result(60);
    float along[3] = {};
    for (std::size_t i = 0; i < result.size(); ++i) {
        Ray& ray = result[i];
        for (int k = 0; k < 3; ++k) {
            if (i % kPacketSize == 0) along[k] = i < 3 * kPacketSize ? 4 * normal(random) : 0.0f;
            ray.org[k] = 0.3f * normal(random);
            ray.dir[k] = along[k] + normal(random);
        }
        const float scale = std::hypot(ray.dir[0], ray.dir[1], ray.dir[2]) / 1.7f;
        for (float& d : ray.dir) d /= scale;
        ray.tNear = 0.1f;
        ray.tFar = 1.5f;
    }
    return result;
}

using Hits = std::map<Name, std::array<float, 3>>;

/// Of all rays, sixteen at a time; the last packet has idle lanes.
std::vector<Hits> allHits(const KernelTable& kernels, Precision precision, const ModelView& view,
                          const std::vector<Ray>& rays) {
    std::vector<Hits> found(rays.size());
    for (std::size_t first = 0; first < rays.size(); first += kPacketSize) {
        const std::size_t some = std::min<std::size_t>(rays.size() - first, kPacketSize);
        RayPacket packet{};
        for (std::size_t i = 0; i < some; ++i) {
            const Ray& ray = rays[first + i];
            for (int k = 0; k < 3; ++k) {
                packet.org[k][i] = ray.org[k];
                packet.dir[k][i] = ray.dir[k];
            }
            packet.tNear[i] = ray.tNear;
            packet.tFar[i] = ray.tFar;
            packet.active |= 1u << i;
        }
        std::vector<Hit> memory(1); // too short for most
        std::vector<uint32_t> lanes(1);
        HitList list{memory.data(), lanes.data(), 1, 0};
        kernels.intersectAll[std::size_t(precision)](view, packet, list);
        const uint32_t count = list.count;
        memory.resize(std::max(count, 1u));
        lanes.resize(memory.size());
        list = {memory.data(), lanes.data(), uint32_t(memory.size()), 0};
        kernels.intersectAll[std::size_t(precision)](view, packet, list);
        EXPECT_EQ(list.count, count);
        for (uint32_t i = 0; i < list.count; ++i) {
            EXPECT_LT(lanes[i], some);
            found[first + lanes[i]][nameOf(memory[i])] = {memory[i].t, memory[i].u, memory[i].v};
        }
    }
    return found;
}

TEST(AllHits, EachTriangleThatIsMetAlone) {
    const SoupScene soup;
    for (const Precision precision : {Precision::Fast, Precision::Watertight, Precision::Precise}) {
        const TracedScene scene(soup.instances, precision);
        const ModelView* const views[] = {&scene.view(), &scene.wideView()};
        std::vector<std::unique_ptr<const Scene>> alone; // copy by copy
        for (uint32_t copy = 0; copy < 3; ++copy)
            for (const Triangle& triangle : soup.triangles)
                alone.push_back(std::make_unique<const Scene>(
                    std::vector<Instance>{place(makeModel({triangle}), soup.places[copy])},
                    precision, 1u));
        std::size_t hits = 0, most = 0;
        const std::vector<Ray> tested = rays();
        const std::vector<Ray> apart = {tested[0], tested[1]}; // few rays go one by one
        std::vector<Hits> expected;
        for (const Ray& ray : tested) {
            Hits& of = expected.emplace_back();
            for (uint32_t copy = 0; copy < 3; ++copy)
                for (uint32_t i = 0; i < soup.triangles.size(); ++i) {
                    Hit hit;
                    findKernels("generic")->intersect1[std::size_t(precision)](
                        alone[copy * soup.triangles.size() + i]->view(), ray, hit);
                    if (hit.triangle != kNoHit) of[soup.nameOf(copy, i)] = {hit.t, hit.u, hit.v};
                }
            hits += of.size();
            most = std::max(most, of.size());
        }
        for (const KernelTable* kernels : availableKernels())
            for (const ModelView* const view : views) {
                EXPECT_EQ(allHits(*kernels, precision, *view, tested), expected)
                    << kernels->name << ' ' << int(precision) << ' ' << (view == views[0]);
                EXPECT_EQ(allHits(*kernels, precision, *view, apart),
                          (std::vector<Hits>{expected[0], expected[1]}));
            }
        EXPECT_GT(hits, 200u);
        EXPECT_GT(most, 8u);
    }
}

// Copies of one triangle at one place: the last of them, for scenes that say so.
TEST(AllHits, LastOfEqualDistances) {
    const std::vector<Triangle> stack(5, {{-1, -1, -3}, {1, -1, -3}, {0, 1, -3}});
    const ModelPtr model = makeModel(stack);
    for (const Precision precision : {Precision::Fast, Precision::Watertight, Precision::Precise})
        for (const bool last : {false, true}) {
            const std::vector<Instance> given = {place(model), place(model),
                                                 place(makeModel(stack, {place(model)}))};
            const Scene wide(given, precision, 1, last);
            const Scene kd(withKdTrees(given), precision, 1, last);
            const Ray ray{{0, 0, 0}, {0.0625f, 0, -1}, 0, 100};
            const std::vector<Ray> rays(16, ray);
            for (const KernelTable* kernels : availableKernels())
                for (const Scene* const scene : {&wide, &kd}) {
                    const ModelView& view = scene->view();
                    Hit hit;
                    kernels->intersect1[std::size_t(precision)](view, ray, hit);
                    EXPECT_EQ(nameOf(hit), last ? (Name{2, 0, 4}) : (Name{0, 0})) << kernels->name;
                    for (const Hits& found : allHits(*kernels, precision, view, rays))
                        EXPECT_EQ(found.size(), 20u);
                    const std::vector<Hit> packet =
                        tracePackets(*kernels, precision, view, rays, Filling::Full);
                    EXPECT_EQ(nameOf(packet[7]), nameOf(hit));
                }
        }
}

} // namespace
} // namespace smart::test
