// SPDX-License-Identifier: MIT
#include "tests/accuracy/secondary.h"

#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "tests/support/procedural_meshes.h"

namespace smart::test {
namespace {

using Point = std::array<double, 3>;

constexpr std::size_t kBatch = 1024;

/// Spheres of radius 1, then mapped: p -> scale * p + offset. A shell's inner sphere follows in
/// the same mesh.
struct SphereScene {
    const char* name;
    double scale, offset, shell; ///< shell 0: one sphere
    bool instanced;              ///< the map is the instance's matrix, not the mesh's
};

constexpr SphereScene kScenes[] = {{"unit sphere", 1, 0, 0, false},
                                   {"scale 1e-3", 1e-3, 0, 0, false},
                                   {"scale 1e3", 1e3, 0, 0, false},
                                   {"offset 1e3", 1, 1e3, 0, false},
                                   {"offset 1e4", 1, 1e4, 0, false},
                                   {"shell 1e-3", 1, 0, 1e-3, false},
                                   {"shell 1e-4", 1, 0, 1e-4, false},
                                   {"shell 1e-5", 1, 0, 1e-5, false},
                                   {"shell 1e-5, offset 10", 1, 10, 1e-5, false},
                                   {"instance, scale 1e-3", 1e-3, 0, 0, true},
                                   {"instance, scale 1e3", 1e3, 0, 0, true},
                                   {"instance, offset 1e3", 1, 1e3, 0, true},
                                   {"instance, shell 1e-4", 3, 7, 1e-4, true}};

Geometry build(const SphereScene& scene) {
    std::vector<Triangle> mesh = icosphere(4);
    if (scene.shell > 0) {
        const std::vector<Triangle> outer = mesh;
        for (Triangle triangle : outer) {
            for (float* v : {triangle.v0, triangle.v1, triangle.v2})
                for (int k = 0; k < 3; ++k) v[k] = float(v[k] * (1 - scene.shell));
            mesh.push_back(triangle);
        }
    }
    const Matrix34 matrix = {scene.scale, 0,           0,           0.577 * scene.offset,
                             0,           scene.scale, 0,           -0.59 * scene.offset,
                             0,           0,           scene.scale, 0.565 * scene.offset};
    if (scene.instanced) {
        Geometry result;
        result.meshes.push_back(std::move(mesh));
        Matrix34 rounded = matrix; // what every engine can hold
        for (double& x : rounded) x = float(x);
        result.placements.push_back({0, rounded});
        return result;
    }
    for (Triangle& triangle : mesh) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2})
            for (std::size_t k = 0; k < 3; ++k)
                v[k] = float(v[k] * matrix[4 * k + k] + matrix[4 * k + 3]);
    }
    return Geometry(std::move(mesh));
}

double inner(const double* a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The work of one thread for one engine.
class Walk {
public:
    Walk(const Geometry& geometry, const ExactReference& reference, const Engine& engine,
         bool shell)
        : reference_(reference),
          engine_(engine),
          outerCount_(uint32_t(geometry.meshes[0].size()) / (shell ? 2 : 1)),
          shell_(shell) {
        for (uint32_t i = 0; i < outerCount_; ++i) {
            const auto& v = reference.corners(i);
            for (std::size_t k = 0; k < 9; ++k) centre_[k % 3] += v[k] / (3.0 * outerCount_);
        }
        const auto& v = reference.corners(0);
        double out[3];
        for (std::size_t k = 0; k < 3; ++k) out[k] = v[k] - centre_[k];
        radius_ = std::sqrt(inner(out, out));
    }

    /// Half of the first rays come from outside, half from the middle.
    void trace(std::size_t count, uint64_t seed, SecondaryResult& result) const {
        Random random(seed);
        std::vector<Ray> first;
        while (first.size() < count) {
            Point origin = random.onSphere(), target = random.onSphere();
            const double distance = first.size() % 2 ? 0.5 * random.unit() : random.between(1.5, 3);
            if (first.size() % 2 == 0 && inner(origin.data(), target.data()) < 1 / distance + 0.1)
                continue;
            for (std::size_t k = 0; k < 3; ++k) {
                origin[k] = centre_[k] + radius_ * distance * origin[k];
                target[k] = centre_[k] + 0.9 * radius_ * target[k];
            }
            first.push_back(makeRay(origin.data(), target.data(), Aim::Normalised));
        }
        std::vector<Claim> hits(count);
        engine_.trace(first, hits.data());
        std::vector<Ray> outward, inward;
        std::vector<uint32_t> from;
        for (std::size_t i = 0; i < count; ++i) {
            if (hits[i].triangle == kNoHit || reference_.degenerate(hits[i].triangle)) continue;
            from.push_back(hits[i].triangle);
            outward.push_back(leave(first[i], hits[i], 1, random));
            inward.push_back(leave(first[i], hits[i], -1, random));
        }
        hits.resize(from.size());
        result.rays += from.size();
        engine_.trace(outward, hits.data());
        for (std::size_t i = 0; i < from.size(); ++i) {
            const bool toOuter = shell_ && from[i] >= outerCount_;
            if (toOuter)
                result.leaks += !outer(hits[i]);
            else
                result.acne += hits[i].triangle != kNoHit;
        }
        engine_.trace(inward, hits.data());
        for (std::size_t i = 0; i < from.size(); ++i) {
            const bool toInner = shell_ && from[i] < outerCount_;
            if (hits[i].triangle == from[i])
                ++result.acne;
            else
                result.leaks += hits[i].triangle == kNoHit || (toInner && outer(hits[i]));
        }
    }

private:
    bool outer(const Claim& claim) const { return claim.triangle < outerCount_; }

    /// A ray in a random direction at most 84 degrees off the normal (side 1) or its opposite.
    Ray leave(const Ray& incoming, const Claim& hit, double side, Random& random) const {
        const auto& v = reference_.corners(hit.triangle);
        double point[3], normal[3], e1[3], e2[3];
        for (std::size_t k = 0; k < 3; ++k) {
            e1[k] = v[3 + k] - v[k];
            e2[k] = v[6 + k] - v[k];
            point[k] = v[k] + double(hit.u) * e1[k] + double(hit.v) * e2[k];
        }
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            normal[k] = e1[i] * e2[j] - e1[j] * e2[i];
        }
        const double length = std::sqrt(inner(normal, normal));
        for (double& x : normal) x /= length;
        Point direction;
        do direction = random.onSphere();
        while (side * inner(direction.data(), normal) < 0.1);
        Ray ray{{}, {}, 0, INFINITY};
        for (std::size_t k = 0; k < 3; ++k) ray.dir[k] = float(direction[k]);
        engine_.leaveSurface(incoming, hit, point, normal, ray);
        return ray;
    }

    const ExactReference& reference_;
    const Engine& engine_;
    const uint32_t outerCount_;
    const bool shell_;
    Point centre_{};
    double radius_ = 0;
};

} // namespace

void Engine::leaveSurface(const Ray&, const Claim&, const double point[3], const double normal[3],
                          Ray& ray) const {
    double along = 0, largest = 0;
    for (int k = 0; k < 3; ++k) {
        along += normal[k] * ray.dir[k];
        largest = std::max(largest, std::abs(point[k]));
    }
    const double step = std::copysign(4 * 0x1p-23 * largest, along);
    for (int k = 0; k < 3; ++k) ray.org[k] = float(point[k] + step * normal[k]);
}

std::vector<SecondaryResult> runSecondary(const std::vector<EngineKind>& kinds, std::size_t rays,
                                          unsigned threads, uint64_t seed) {
    std::vector<SecondaryResult> results;
    for (const SphereScene& scene : kScenes) {
        const Geometry geometry = build(scene);
        ExactReference reference;
        geometry.addTo(reference);
        for (const EngineKind& kind : kinds) {
            if (kind.bruteForce) continue;
            const EnginePtr engine = kind.make(geometry);
            if (!engine) continue;
            SecondaryResult result{scene.name, kind.name, kind.mode, 0, 0, 0};
            const Walk walk(geometry, reference, *engine, scene.shell > 0);
            std::atomic<std::size_t> next{0};
            std::mutex mutex;
            std::vector<std::thread> workers;
            for (unsigned i = 0; i < threads; ++i) {
                workers.emplace_back([&] {
                    SecondaryResult own;
                    for (;;) {
                        const std::size_t first = next.fetch_add(kBatch);
                        if (first >= rays) break;
                        walk.trace(std::min(kBatch, rays - first),
                                   seed * 0x9E3779B97F4A7C15u + first, own);
                    }
                    const std::lock_guard lock(mutex);
                    result.rays += own.rays;
                    result.acne += own.acne;
                    result.leaks += own.leaks;
                });
            }
            for (std::thread& worker : workers) worker.join();
            results.push_back(std::move(result));
        }
    }
    return results;
}

} // namespace smart::test
