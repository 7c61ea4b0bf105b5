// SPDX-License-Identifier: MIT
#include "tests/support/ray_sets.h"

#include <algorithm>
#include <cmath>

namespace smart::test {
namespace {

constexpr float kInfinity = INFINITY;
constexpr double kPi = 3.14159265358979323846;

const float* corner(const Triangle& triangle, uint32_t k) {
    return k == 0 ? triangle.v0 : k == 1 ? triangle.v1 : triangle.v2;
}

double toGrid(double x) {
    return std::ldexp(std::nearbyint(std::ldexp(x, 16)), -16);
}

/// A point on a random triangle. Exact targets on edges are a sixteenth step between grid points.
std::array<double, 3> pickTarget(std::span<const Triangle> triangles, Target target, Aim aim,
                                 Random& random) {
    const Triangle& triangle = triangles[random.below(uint32_t(triangles.size()))];
    const uint32_t first = random.below(3);
    const float *a = corner(triangle, first), *b = corner(triangle, (first + 1) % 3),
                *c = corner(triangle, (first + 2) % 3);
    double s = 0, r = 0;
    if (target == Target::Edge) {
        s = aim == Aim::Exact ? (1 + random.below(15)) / 16.0 : random.unit();
    } else if (target == Target::Interior) {
        s = random.between(0.05, 0.9);
        r = random.between(0.05, 0.95 - s);
    }
    std::array<double, 3> point;
    for (std::size_t k = 0; k < 3; ++k) {
        point[k] = a[k] + s * (double(b[k]) - a[k]) + r * (double(c[k]) - a[k]);
    }
    return point;
}

} // namespace

uint64_t Random::bits() {
    uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

double Random::unit() {
    return double(bits() >> 11) * 0x1p-53;
}

std::array<double, 3> Random::onSphere() {
    for (;;) {
        const double p[3] = {between(-1, 1), between(-1, 1), between(-1, 1)};
        const double square = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
        if (square > 1 || square < 0.01) continue;
        const double length = std::sqrt(square);
        return {p[0] / length, p[1] / length, p[2] / length};
    }
}

Ray makeRay(const double origin[3], const double target[3], Aim aim) {
    Ray ray{{}, {}, 0.0f, kInfinity};
    double d[3], square = 0;
    for (int k = 0; k < 3; ++k) {
        ray.org[k] = float(aim == Aim::Exact ? toGrid(origin[k]) : origin[k]);
        d[k] = target[k] - double(ray.org[k]);
        square += d[k] * d[k];
    }
    const double scale = aim == Aim::Normalised ? 1 / std::sqrt(square) : 1;
    for (int k = 0; k < 3; ++k) ray.dir[k] = float(d[k] * scale);
    return ray;
}

std::vector<Triangle> snapped(std::vector<Triangle> triangles, int bits) {
    for (Triangle& triangle : triangles) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) {
                v[k] = float(std::ldexp(std::nearbyint(std::ldexp(double(v[k]), bits)), -bits));
            }
        }
    }
    return triangles;
}

std::vector<Ray> randomRays(std::span<const Triangle> triangles, std::size_t count, uint64_t seed) {
    double lo[3] = {INFINITY, INFINITY, INFINITY}, hi[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (const Triangle& triangle : triangles) {
        for (uint32_t c = 0; c < 3; ++c) {
            for (int k = 0; k < 3; ++k) {
                lo[k] = std::min(lo[k], double(corner(triangle, c)[k]));
                hi[k] = std::max(hi[k], double(corner(triangle, c)[k]));
            }
        }
    }
    Random random(seed);
    std::vector<Ray> rays;
    rays.reserve(count);
    while (rays.size() < count) {
        double from[3], to[3];
        for (int k = 0; k < 3; ++k) {
            const double margin = 0.25 * (hi[k] - lo[k]);
            from[k] = random.between(lo[k] - margin, hi[k] + margin);
            to[k] = random.between(lo[k] - margin, hi[k] + margin);
        }
        rays.push_back(makeRay(from, to, rays.size() % 2 ? Aim::Rounded : Aim::Normalised));
    }
    return rays;
}

std::vector<Ray> raysFromOutside(std::span<const Triangle> triangles, double radius,
                                 std::size_t count, Target target, Aim aim, uint64_t seed) {
    Random random(seed);
    std::vector<Ray> rays;
    rays.reserve(count);
    while (rays.size() < count) {
        const std::array<double, 3> point = pickTarget(triangles, target, aim, random);
        const double distance = random.between(1.5, 3);
        std::array<double, 3> direction = random.onSphere();
        double cosine = 0, square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            cosine += direction[k] * point[k];
            square += point[k] * point[k];
        }
        if (cosine / std::sqrt(square) <= 1 / distance + 0.1) continue; // not in sight
        for (double& x : direction) x *= distance * radius;
        rays.push_back(makeRay(direction.data(), point.data(), aim));
    }
    return rays;
}

std::vector<Ray> raysFromInside(std::span<const Triangle> triangles, double radius,
                                std::size_t count, Target target, Aim aim, uint64_t seed) {
    Random random(seed);
    std::vector<Ray> rays;
    rays.reserve(count);
    while (rays.size() < count) {
        const std::array<double, 3> point = pickTarget(triangles, target, aim, random);
        std::array<double, 3> origin = random.onSphere();
        const double distance = 0.5 * radius * random.unit();
        for (double& x : origin) x *= distance;
        rays.push_back(makeRay(origin.data(), point.data(), aim));
    }
    return rays;
}

std::vector<Ray> axisParallelRays(double halfSize, double step, std::size_t count, uint64_t seed) {
    Random random(seed);
    std::vector<Ray> rays;
    rays.reserve(count);
    while (rays.size() < count) {
        Ray ray{{}, {}, 0.0f, kInfinity};
        for (int k = 0; k < 3; ++k) {
            const double x = random.between(-halfSize, halfSize);
            ray.org[k] = float(step > 0 ? step * std::nearbyint(x / step) : x);
            ray.dir[k] = float(random.between(0.25, 1) * (random.below(2) ? 1 : -1));
        }
        const uint32_t axis = random.below(3);
        ray.dir[axis] = random.below(2) ? 0.0f : -0.0f;
        if (random.below(2)) ray.dir[(axis + 1) % 3] = random.below(2) ? 0.0f : -0.0f;
        rays.push_back(ray);
    }
    return rays;
}

std::vector<Ray> cameraRays(const CameraPose& pose, uint32_t width, uint32_t height, double dx,
                            double dy) {
    double forward[3], right[3], up[3];
    const auto normalise = [](double* v) {
        const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        for (int k = 0; k < 3; ++k) v[k] /= length;
    };
    const auto cross = [](const double* a, const double* b, double* c) {
        for (int k = 0; k < 3; ++k) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            c[k] = a[i] * b[j] - a[j] * b[i];
        }
    };
    for (int k = 0; k < 3; ++k) forward[k] = pose.target[k] - pose.eye[k];
    normalise(forward);
    cross(forward, pose.up, right);
    normalise(right);
    cross(right, forward, up);
    const double high = std::tan(pose.fov * kPi / 360), wide = high * width / height;

    std::vector<Ray> rays;
    rays.reserve(std::size_t(width) * height);
    for (uint32_t block = 0; block < width / 4 * (height / 4); ++block) {
        for (uint32_t i = 0; i < 16; ++i) {
            const uint32_t px = block % (width / 4) * 4 + i % 4,
                           py = block / (width / 4) * 4 + i / 4;
            const double x = (2 * (px + 0.5 + dx) / width - 1) * wide;
            const double y = (2 * (py + 0.5 + dy) / height - 1) * high;
            double target[3];
            for (int k = 0; k < 3; ++k) {
                target[k] = pose.eye[k] + forward[k] + x * right[k] + y * up[k];
            }
            rays.push_back(makeRay(pose.eye, target, Aim::Normalised));
        }
    }
    return rays;
}

RayPacket packet(std::span<const Ray> rays, std::size_t first) {
    RayPacket result{};
    for (std::size_t i = 0; i < std::size_t(kPacketSize) && first + i < rays.size(); ++i) {
        const Ray& ray = rays[first + i];
        for (int k = 0; k < 3; ++k) {
            result.org[k][i] = ray.org[k];
            result.dir[k][i] = ray.dir[k];
        }
        result.tNear[i] = ray.tNear;
        result.tFar[i] = ray.tFar;
        result.active |= 1u << i;
    }
    return result;
}

} // namespace smart::test
