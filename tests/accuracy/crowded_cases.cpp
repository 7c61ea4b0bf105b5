// SPDX-License-Identifier: MIT
// Many triangles in one place (H6), layers a few units in the last place apart (H7).
#include <cmath>
#include <numeric>

#include "tests/accuracy/hard_case.h"
#include "tests/support/procedural_meshes.h"

namespace smart::test {
namespace {

using Rays = std::vector<Ray>;

Ray between(const double from[3], const double to[3]) {
    return makeRay(from, to, Aim::Rounded);
}

/// From a sphere of radius 4 to points in [-size,size]^3.
Rays raysAtCube(double size, std::size_t count, uint64_t seed) {
    Random random(seed);
    Rays rays;
    while (rays.size() < count) {
        std::array<double, 3> from = random.onSphere();
        double to[3];
        for (std::size_t k = 0; k < 3; ++k) {
            from[k] *= 4;
            to[k] = random.between(-size, size);
        }
        rays.push_back(between(from.data(), to));
    }
    return rays;
}

void addQuadAt(IndexedMesh& mesh, double z, double half) {
    const uint32_t a = mesh.addVertex(-half, -half, z), b = mesh.addVertex(half, -half, z),
                   c = mesh.addVertex(half, half, z), d = mesh.addVertex(-half, half, z);
    mesh.addQuad(a, b, c, d);
}

std::vector<Triangle> identicalQuads(uint32_t many) {
    IndexedMesh mesh;
    for (uint32_t i = 0; i < many / 2; ++i) addQuadAt(mesh, 0, 1);
    return mesh.triangles();
}

std::vector<Triangle> oneTriangle(uint32_t many) {
    return std::vector<Triangle>(many, {{-1, -1, 0.5f}, {1.5f, -0.5f, 0.25f}, {0, 1.25f, -0.5f}});
}

/// All through the origin.
std::vector<Triangle> aboutOneCentre(uint32_t many) {
    Random random(60);
    std::vector<Triangle> mesh;
    while (mesh.size() < many) {
        const auto p = random.onSphere(), q = random.onSphere();
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.v0[k] = float(p[k]);
            triangle.v1[k] = float(q[k]);
            triangle.v2[k] = -float(p[k] + q[k]);
        }
        mesh.push_back(triangle);
    }
    return mesh;
}

std::vector<Triangle> fan(uint32_t many) {
    IndexedMesh mesh;
    const uint32_t centre = mesh.addVertex(0, 0, 0.25);
    const double turn = 2 * 3.14159265358979323846 / many;
    for (uint32_t i = 0; i < many; ++i) {
        mesh.addVertex(std::cos(i * turn), std::sin(i * turn), 0);
    }
    for (uint32_t i = 0; i < many; ++i) {
        mesh.addTriangle(centre, 1 + i, 1 + (i + 1) % many);
    }
    return mesh.triangles();
}

std::vector<Triangle> layers(uint32_t many) {
    IndexedMesh mesh;
    for (uint32_t i = 0; i < many / 2; ++i) addQuadAt(mesh, 2.0 * i / (many / 2) - 1, 1);
    return mesh.triangles();
}

std::vector<Triangle> crossingSlivers(uint32_t many) {
    Random random(61);
    std::vector<Triangle> mesh;
    while (mesh.size() < many) {
        const auto p = random.onSphere(), q = random.onSphere();
        Triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.v0[k] = float(p[k]);
            triangle.v1[k] = float(q[k]);
            triangle.v2[k] = float(q[k] + random.between(-1e-4, 1e-4));
        }
        mesh.push_back(triangle);
    }
    return mesh;
}

NamedCase crowd(const char* name, std::vector<Triangle> (*mesh)(uint32_t), uint32_t many,
                std::size_t most) {
    return {name, [=] {
                HardCase result;
                result.geometry = Geometry(mesh(many));
                result.rays = [](std::size_t count, uint64_t seed) {
                    return raysAtCube(0.6, count, seed);
                };
                result.most = most;
                return result;
            }};
}

/// 64 quads, `step` units in the last place of 3 apart, their order shuffled.
HardCase layerCase(int step, bool tilted) {
    constexpr uint32_t kLayers = 64;
    uint32_t order[kLayers];
    std::iota(order, order + kLayers, 0u);
    Random random(70);
    for (uint32_t i = kLayers - 1; i > 0; --i) std::swap(order[i], order[random.below(i + 1)]);
    std::vector<Triangle> mesh;
    for (const uint32_t layer : order) {
        const auto vertex = [&](float x, float y, float* v) {
            const double slope = tilted ? 0.25 * x - 0.125 * y : 0.0;
            v[0] = x;
            v[1] = y;
            v[2] = float(2.75 + slope + layer * step * 0x1p-22); // exact: below 4
        };
        Triangle a, b;
        vertex(-2, -2, a.v0);
        vertex(2, -2, a.v1);
        vertex(2, 2, a.v2);
        b = a;
        vertex(2, 2, b.v1);
        vertex(-2, 2, b.v2);
        mesh.push_back(a);
        mesh.push_back(b);
    }
    HardCase result;
    result.geometry = Geometry(std::move(mesh));
    result.rays = [](std::size_t count, uint64_t seed) {
        Random rayRandom(seed);
        Rays rays;
        while (rays.size() < count) {
            double from[3], to[3] = {0, 0, 2.75};
            for (int k = 0; k < 2; ++k) {
                to[k] = rayRandom.between(-1.5, 1.5);
                from[k] = to[k] + rayRandom.between(-3, 3);
            }
            to[2] = 2.75;
            from[2] = 2.75 + (rayRandom.below(2) ? 1 : -1) * rayRandom.between(2, 5);
            rays.push_back(between(from, to));
        }
        return rays;
    };
    return result;
}

} // namespace

std::vector<NamedCase> crowdedCases(uint32_t many) {
    std::vector<NamedCase> cases = {crowd("H6-identical-quads", identicalQuads, many, 10),
                                    crowd("H6-one-triangle", oneTriangle, many, 10),
                                    crowd("H6-one-centre", aboutOneCentre, many, 200),
                                    crowd("H6-fan", fan, many, 200),
                                    crowd("H6-layers", layers, many, 200),
                                    crowd("H6-crossing-slivers", crossingSlivers, many, 200)};
    for (const int step : {1, 2, 4, 16, 64}) {
        for (const bool tilted : {false, true}) {
            cases.push_back({"H7-" + std::to_string(step) + "ulp" + (tilted ? "-tilted" : "-flat"),
                             [=] { return layerCase(step, tilted); }});
        }
    }
    return cases;
}

} // namespace smart::test
