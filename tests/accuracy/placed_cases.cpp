// SPDX-License-Identifier: MIT
// Instances (H10). Matrix entries have 11 bits, so that corners in world space are exact doubles.
#include <algorithm>
#include <cmath>

#include "tests/accuracy/hard_case.h"
#include "tests/support/procedural_meshes.h"

namespace smart::test {
namespace {

using Point = std::array<double, 3>;

double elevenBits(double x) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    return std::ldexp(std::nearbyint(std::ldexp(fraction, 11)), exponent - 11);
}

/// Rotation about (1,2,2)/3 by `angle`, columns scaled, then moved.
Matrix34 placed(double angle, const Point& scale, const Point& offset) {
    const double c = std::cos(angle), s = std::sin(angle);
    const double a[3] = {1.0 / 3, 2.0 / 3, 2.0 / 3};
    Matrix34 m;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t k = 3 - i - j;
            double r = (1 - c) * a[i] * a[j];
            if (i == j)
                r += c;
            else
                r += ((j + 3 - i) % 3 == 1 ? -s : s) * a[k];
            m[4 * i + j] = elevenBits(r * scale[j]);
        }
        m[4 * i + 3] = elevenBits(offset[i]);
    }
    return m;
}

Point moved(const Matrix34& m, const Point& p) {
    Point result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[k] = m[4 * k] * p[0] + m[4 * k + 1] * p[1] + m[4 * k + 2] * p[2] + m[4 * k + 3];
    }
    return result;
}

/// A third of the rays at vertices, edges and centroids each. Origins 1.5 to 3 radii away in the
/// sphere's space, or, for flat instances, in the world.
HardCase twoInstances(const Matrix34& first, const Matrix34& second, bool flat, Promise promise) {
    HardCase result;
    const std::vector<Triangle> mesh = snapped(icosphere(3), 16);
    result.geometry.meshes = {mesh};
    result.geometry.placements = {{0, first}, {0, second}};
    result.promise = promise;
    result.rays = [=](std::size_t count, uint64_t seed) {
        Random random(seed);
        std::vector<Ray> rays;
        while (rays.size() < count) {
            const Matrix34& m = random.below(2) ? first : second;
            const Triangle& triangle = mesh[random.below(uint32_t(mesh.size()))];
            double s = 0, r = 0;
            switch (rays.size() % 3) {
                case 0:
                    break;
                case 1:
                    s = random.unit();
                    break;
                default:
                    s = r = 1.0 / 3;
                    break;
            }
            Point local, origin = random.onSphere();
            double cosine = 0;
            const double distance = random.between(1.5, 3);
            for (std::size_t k = 0; k < 3; ++k) {
                local[k] = triangle.v0[k] + s * (double(triangle.v1[k]) - triangle.v0[k]) +
                           r * (double(triangle.v2[k]) - triangle.v0[k]);
                cosine += local[k] * origin[k];
            }
            if (cosine <= 1 / distance + 0.1) continue;
            for (double& x : origin) x *= distance;
            if (flat)
                for (std::size_t k = 0; k < 3; ++k) origin[k] += m[4 * k + 3];
            else
                origin = moved(m, origin);
            const Point target = moved(m, local);
            rays.push_back(makeRay(origin.data(), target.data(), Aim::Rounded));
        }
        return rays;
    };
    return result;
}

} // namespace

std::vector<NamedCase> placedCases() {
    const Matrix34 here = placed(0.7, {1, 1, 1}, {-2, 0.5, 0}),
                   there = placed(2.1, {1, 1, 1}, {2, 0, -1});
    const auto add = [](std::vector<NamedCase>& cases, const char* name, const Matrix34& a,
                        const Matrix34& b, bool flat, Promise promise) {
        cases.push_back({name, [=] { return twoInstances(a, b, flat, promise); }});
    };
    std::vector<NamedCase> cases;
    add(cases, "H10-rigid", here, there, false, Promise::NothingLost);
    add(cases, "H10-nonuni", placed(0.7, {1, 1e-3, 1e3}, {-2, 0.5, 0}),
        placed(2.1, {1, 1e-3, 1e3}, {2, 0, -1}), false, Promise::None);
    add(cases, "H10-mirror", placed(0.7, {-1, 1, 1}, {-2, 0.5, 0}),
        placed(2.1, {1, 1, -1}, {2, 0, -1}), false, Promise::NothingLost);
    add(cases, "H10-offset1e4", placed(0.7, {1, 1, 1}, {1e4, -1e4, 1e4}),
        placed(2.1, {1, 1, 1}, {1e4 + 8, -1e4, 1e4}), false, Promise::NothingLost);
    add(cases, "H10-near-sing", placed(0, {1, 1e-6, 1}, {-2, 0.5, 0}),
        placed(0, {1e-6, 1, 1}, {2, 0, -1}), true, Promise::None);
    add(cases, "H10-near-sing12", placed(0, {1, 1e-12, 1}, {-2, 0, 0}),
        placed(0, {1e-12, 1, 1}, {0, 3, -1}), true, Promise::None);
    cases.push_back({"H10-singular", [=] { // an instance that has no inverse is left out
                         HardCase made = twoInstances(placed(0, {1, 0, 1}, {-2, 0.5, 0}), there,
                                                      true, Promise::None);
                         made.geometry.placements[0].dropped = true;
                         made.abortsPeers = true;
                         return made;
                     }});
    return cases;
}

} // namespace smart::test
