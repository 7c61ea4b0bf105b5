// SPDX-License-Identifier: MIT
// Distances of single triangles (H8), ranges that end on surfaces and bad numbers (H11), grazing
// rays (H12).
#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/hard_case.h"
#include "tests/support/procedural_meshes.h"

namespace smart::test {
namespace {

using Point = std::array<double, 3>;

/// 500 random triangles; origins at about `distance`, targets in the interior.
HardCase scatteredCase(double size, double distance) {
    HardCase result;
    const std::vector<Triangle> mesh = triangleSoup(500, float(size), 80);
    result.geometry = Geometry(mesh);
    result.promise = Promise::None; // triangles with free edges: float may miss their rims
    result.rays = [=](std::size_t count, uint64_t seed) {
        Random random(seed);
        std::vector<Ray> rays;
        while (rays.size() < count) {
            const Triangle& triangle = mesh[random.below(uint32_t(mesh.size()))];
            double s = random.unit(), r = random.unit();
            if (s + r > 1) {
                s = 1 - s;
                r = 1 - r;
            }
            Point origin = random.onSphere(), target;
            const double away = distance * random.between(0.5, 1.5);
            for (std::size_t k = 0; k < 3; ++k) {
                target[k] = triangle.v0[k] + s * (double(triangle.v1[k]) - triangle.v0[k]) +
                            r * (double(triangle.v2[k]) - triangle.v0[k]);
                origin[k] = target[k] + away * origin[k];
            }
            rays.push_back(makeRay(origin.data(), target.data(), Aim::Normalised));
        }
        return rays;
    };
    return result;
}

constexpr float kInf = INFINITY;

/// What the ranges H11-range0.. make of a ray that meets surfaces at t = 1 and t = 2.
void restrict(int kind, Ray& ray, uint32_t axis) {
    const float below = std::nextafter(1.0f, 0.0f), above = std::nextafter(1.0f, 2.0f);
    switch (kind) {
        case 0:
            ray.tFar = 1;
            break;
        case 1:
            ray.tFar = below;
            break;
        case 2:
            ray.tNear = ray.tFar = 1;
            break;
        case 3:
            ray.tNear = 1.25f, ray.tFar = 1.75f;
            break;
        case 4:
            ray.tNear = 1.75f, ray.tFar = 1.25f;
            break;
        case 5:
            ray.tNear = NAN;
            break;
        case 6:
            ray.tFar = NAN;
            break;
        case 7:
            ray.dir[0] = ray.dir[1] = ray.dir[2] = 0;
            break;
        case 8:
            ray.dir[axis] = kInf;
            break;
        case 9:
            ray.dir[axis] = NAN;
            break;
        case 10:
            ray.org[axis] = NAN;
            break;
        case 11:
            ray.org[axis] = -kInf;
            break;
        case 12:
            ray.tNear = -kInf, ray.tFar = 0;
            break;
        case 13:
            ray.tNear = below, ray.tFar = above;
            break;
        default:
            ray.tFar = -1;
            break;
    }
}

HardCase rangeCase(int kind) {
    HardCase result;
    IndexedMesh box;
    addCube(box, 0.5, 1, false);
    result.geometry = Geometry(box.triangles());
    result.promise = Promise::Right;
    result.share = 0.01;
    result.abortsPeers = kind == 5 || kind == 6 || (kind >= 8 && kind <= 12);
    result.rays = [kind](std::size_t count, uint64_t seed) {
        Random random(seed);
        std::vector<Ray> rays;
        while (rays.size() < count) {
            Ray ray{{}, {}, 0, kInf};
            const uint32_t axis = random.below(3);
            const float side = random.below(2) ? 1.0f : -1.0f;
            for (uint32_t k = 0; k < 3; ++k) {
                ray.org[k] = k == axis ? -1.5f * side : float(int(random.below(800)) - 400) / 1024;
                ray.dir[k] = k == axis ? side : 0.0f;
            }
            restrict(kind, ray, axis);
            rays.push_back(ray);
        }
        return rays;
    };
    return result;
}

/// A plane that is parallel to no axis: right, up and normal are orthonormal.
constexpr Point kRight = {0.36, 0.48, 0.8}, kUp = {0.8, -0.6, 0}, kNormal = {0.48, 0.64, -0.6};

Point onPlane(double x, double y, double z) {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = x * kRight[k] + y * kUp[k] + z * kNormal[k];
    return p;
}

/// 64 x 64 quads over [-1,1]^2; closed: a slab between z = 0 and z = -0.01.
std::vector<Triangle> grid(bool closed) {
    constexpr uint32_t kCells = 64;
    IndexedMesh mesh;
    const auto at = [](uint32_t i) { return 2.0 * i / kCells - 1; };
    const auto vertex = [&](double x, double y, double z) {
        const Point p = onPlane(x, y, z);
        return mesh.addVertex(p[0], p[1], p[2]);
    };
    for (const bool lower : {false, true}) {
        if (lower && !closed) break;
        const double z = lower ? -0.01 : 0;
        for (uint32_t i = 0; i < kCells; ++i) {
            for (uint32_t j = 0; j < kCells; ++j) {
                const uint32_t a = vertex(at(j), at(i), z), b = vertex(at(j + 1), at(i), z),
                               c = vertex(at(j + 1), at(i + 1), z), d = vertex(at(j), at(i + 1), z);
                if (lower)
                    mesh.addQuad(a, d, c, b);
                else
                    mesh.addQuad(a, b, c, d);
            }
        }
    }
    for (uint32_t i = 0; i < kCells && closed; ++i) {
        const double ends[4][4] = {{at(i), -1, at(i + 1), -1},
                                   {at(i + 1), 1, at(i), 1},
                                   {-1, at(i + 1), -1, at(i)},
                                   {1, at(i), 1, at(i + 1)}};
        for (const double* e : ends) {
            const uint32_t a = vertex(e[0], e[1], -0.01), b = vertex(e[2], e[3], -0.01),
                           c = vertex(e[2], e[3], 0), d = vertex(e[0], e[1], 0);
            mesh.addQuad(a, b, c, d);
        }
    }
    return mesh.triangles();
}

/// At `angle` radians to the plane; half of the targets on grid lines.
HardCase grazingCase(double angle, bool closed) {
    HardCase result;
    result.geometry = Geometry(grid(closed));
    result.promise = angle < 1e-4 ? Promise::None : Promise::NothingLost;
    result.rays = [angle](std::size_t count, uint64_t seed) {
        Random random(seed);
        std::vector<Ray> rays;
        while (rays.size() < count) {
            double x = random.between(-0.8, 0.8), y = random.between(-0.8, 0.8);
            if (random.below(2)) x = std::nearbyint(x * 32) / 32;
            const Point target = onPlane(x, y, 0);
            const double turn = random.between(0, 6.283185307179586);
            const double distance = random.between(0.5, 2);
            const Point origin = onPlane(x - distance * std::cos(angle) * std::cos(turn),
                                         y - distance * std::cos(angle) * std::sin(turn),
                                         distance * std::sin(angle));
            rays.push_back(makeRay(origin.data(), target.data(), Aim::Normalised));
        }
        return rays;
    };
    return result;
}

} // namespace

std::vector<NamedCase> limitCases() {
    std::vector<NamedCase> cases = {{"H8-near", [] { return scatteredCase(0.2, 1); }},
                                    {"H8-far1e3", [] { return scatteredCase(0.2, 1e3); }},
                                    {"H8-small", [] { return scatteredCase(1e-3, 1); }},
                                    {"H8-small-far1e3", [] { return scatteredCase(1e-3, 1e3); }}};
    for (int kind = 0; kind < 15; ++kind) {
        cases.push_back({"H11-range" + std::to_string(kind), [=] { return rangeCase(kind); }});
    }
    for (const int exponent : {-2, -4, -5, -6}) {
        for (const bool closed : {false, true}) {
            cases.push_back({std::string("H12-") + (closed ? "slab" : "plane") + "-1e" +
                                 std::to_string(exponent),
                             [=] { return grazingCase(std::pow(10.0, exponent), closed); }});
        }
    }
    return cases;
}

} // namespace smart::test
