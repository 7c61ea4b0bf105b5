// SPDX-License-Identifier: MIT
// Rays in planes, along axes, at coplanar and broken triangles (H3, H4, H5).
#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/accuracy/hard_case.h"
#include "tests/support/procedural_meshes.h"

namespace smart::test {
namespace {

HardCase roomCase(double halfSize, double step) {
    HardCase result;
    result.geometry = Geometry(closedRoom());
    result.promise = Promise::Right;
    result.rays = [=](std::size_t count, uint64_t seed) {
        return axisParallelRays(halfSize, step, count, seed);
    };
    return result;
}

/// Origins on the outer walls, directions into the room, one or two components zero.
HardCase wallCase() {
    HardCase result = roomCase(0, 0);
    result.rays = [](std::size_t count, uint64_t seed) {
        std::vector<Ray> rays = axisParallelRays(8, 0.25, count, seed);
        Random random(seed + 1);
        for (Ray& ray : rays) {
            const uint32_t axis = random.below(3);
            const float side = random.below(2) ? 8.0f : -8.0f;
            ray.org[axis] = side;
            const float into = std::abs(ray.dir[axis]);
            ray.dir[axis] = std::copysign(into == 0 ? 0.75f : into, -side);
        }
        return rays;
    };
    return result;
}

/// From outside in the planes of walls and of the inner box's faces.
HardCase facePlaneCase() {
    HardCase result = roomCase(0, 0);
    result.rays = [](std::size_t count, uint64_t seed) {
        Random random(seed);
        std::vector<Ray> rays;
        while (rays.size() < count) {
            Ray ray{{}, {}, 0, INFINITY};
            const uint32_t along = random.below(3), in = (along + 1 + random.below(2)) % 3;
            const float planes[] = {-8, -4, 4, 8};
            for (uint32_t k = 0; k < 3; ++k) {
                ray.org[k] = float(random.below(2) ? random.between(-8, 8)
                                                   : std::nearbyint(random.between(-8, 8)));
                ray.dir[k] = random.below(2) ? 0.0f : -0.0f;
            }
            const float side = random.below(2) ? 1.0f : -1.0f;
            ray.org[along] = side * float(random.between(9, 20));
            ray.dir[along] = -side * float(random.between(0.25, 1));
            ray.org[in] = planes[random.below(4)];
            if (random.below(2)) { // across the plane's other axis
                const uint32_t other = 3 - along - in;
                ray.dir[other] = float(random.between(-0.5, 0.5));
            }
            rays.push_back(ray);
        }
        return rays;
    };
    return result;
}

enum class Broken { Repeated, Collinear, Nan, Infinite, All };

/// A broken triangle after every other one.
HardCase brokenCase(Broken kind) {
    const std::vector<Triangle> clean = snapped(icosphere(4), 16);
    std::vector<Triangle> mesh;
    Random random(40);
    for (std::size_t i = 0; i < clean.size(); ++i) {
        mesh.push_back(clean[i]);
        if (i % 2) continue;
        Triangle bad = clean[i];
        const Broken how = kind == Broken::All ? Broken(random.below(4)) : kind;
        const uint32_t k = random.below(3);
        const bool beyond = random.below(2) != 0;
        switch (how) {
            case Broken::Repeated:
                std::copy_n(bad.v0, 3, bad.v1);
                break;
            case Broken::Collinear: // the edge's middle, or the first corner's mirror image
                for (int c = 0; c < 3; ++c)
                    bad.v2[c] = beyond ? 2 * bad.v0[c] - bad.v1[c] : 0.5f * (bad.v0[c] + bad.v1[c]);
                break;
            case Broken::Nan:
                bad.v1[k] = NAN;
                break;
            default:
                bad.v2[k] = beyond ? INFINITY : -INFINITY;
                break;
        }
        mesh.push_back(bad);
    }
    HardCase result;
    result.geometry = Geometry(std::move(mesh));
    result.promise = Promise::Right;
    result.share = 0.2;
    result.rays = [clean](std::size_t count, uint64_t seed) {
        std::vector<Ray> rays =
            raysFromOutside(clean, 1, count / 2, Target::Vertex, Aim::Exact, seed);
        const auto edges =
            raysFromOutside(clean, 1, count - rays.size(), Target::Edge, Aim::Exact, seed + 1);
        rays.insert(rays.end(), edges.begin(), edges.end());
        return rays;
    };
    return result;
}

/// A room of 12 triangles, and rectangles on half-integer planes that overlap.
std::vector<Triangle> rectangles() {
    IndexedMesh mesh;
    addCube(mesh, 8, 1, true);
    Random random(50);
    for (int i = 0; i < 2000; ++i) {
        const std::size_t axis = random.below(3), s = (axis + 1) % 3, t = (axis + 2) % 3;
        const double plane = random.below(31) / 2.0 - 7.5;
        double lo[2], hi[2];
        for (int k = 0; k < 2; ++k) {
            lo[k] = random.below(28) / 2.0 - 7.5;
            hi[k] = std::min(7.5, lo[k] + 0.5 * (1 + random.below(6)));
        }
        const double ends[4][2] = {{lo[0], lo[1]}, {hi[0], lo[1]}, {hi[0], hi[1]}, {lo[0], hi[1]}};
        uint32_t corners[4];
        for (int c = 0; c < 4; ++c) {
            double p[3];
            p[axis] = plane;
            p[s] = ends[c][0];
            p[t] = ends[c][1];
            corners[c] = mesh.addVertex(p[0], p[1], p[2]);
        }
        mesh.addQuad(corners[0], corners[1], corners[2], corners[3]);
    }
    return mesh.triangles();
}

HardCase overlapCase(bool parallel) {
    HardCase result;
    result.geometry = Geometry(rectangles());
    result.promise = Promise::Right;
    result.rays = [parallel, mesh = result.geometry.meshes[0]](std::size_t count, uint64_t seed) {
        return parallel ? axisParallelRays(8, 0.25, count, seed) : randomRays(mesh, count, seed);
    };
    return result;
}

} // namespace

std::vector<NamedCase> alignedCases() {
    return {{"H3-anywhere", [] { return roomCase(7.9, 0); }},
            {"H3-half-integer", [] { return roomCase(7.5, 0.5); }},
            {"H3-integer", [] { return roomCase(7, 1); }},
            {"H3-on-walls", wallCase},
            {"H3-onface", facePlaneCase},
            {"H4-zero", [] { return brokenCase(Broken::Repeated); }},
            {"H4-collinear", [] { return brokenCase(Broken::Collinear); }},
            {"H4-nan", [] { return brokenCase(Broken::Nan); }},
            {"H4-inf", [] { return brokenCase(Broken::Infinite); }},
            {"H4-all", [] { return brokenCase(Broken::All); }},
            {"H5-random", [] { return overlapCase(false); }},
            {"H5-parallel", [] { return overlapCase(true); }}};
}

} // namespace smart::test
