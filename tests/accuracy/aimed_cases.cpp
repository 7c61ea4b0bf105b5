// SPDX-License-Identifier: MIT
// Rays at the vertices and edges of closed meshes, from outside (H1), from inside (H2), and with
// directions of any length (H11).
#include <algorithm>
#include <cmath>
#include <memory>

#include "tests/accuracy/hard_case.h"
#include "tests/support/procedural_meshes.h"

namespace smart::test {
namespace {

using Point = std::array<double, 3>;

struct Affine {
    Matrix34 m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

    Point operator()(const Point& p) const {
        Point result;
        for (std::size_t k = 0; k < 3; ++k) {
            const double* row = &m[4 * k];
            result[k] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
        }
        return result;
    }
    static Affine scale(double s, const Point& offset = {0, 0, 0}) {
        return {{s, 0, 0, offset[0], 0, s, 0, offset[1], 0, 0, s, offset[2]}};
    }
    /// Along an axis that is parallel to no coordinate axis.
    static Affine stretch(double s) {
        const double a[3] = {0.36, 0.48, 0.8};
        Affine result;
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                result.m[4 * i + j] = (i == j ? 1.0 : 0.0) + (s - 1) * a[i] * a[j];
            }
        }
        return result;
    }
};

/// A mesh around the origin and what is traced: the same moved, rounded to float.
struct Mapped {
    std::vector<Triangle> shape, mesh;
    Affine map;

    Mapped(std::vector<Triangle> around, const Affine& affine, int snapBits = 0)
        : shape(std::move(around)), mesh(shape), map(affine) {
        for (Triangle& triangle : mesh) {
            for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
                const Point p = map({v[0], v[1], v[2]});
                for (std::size_t k = 0; k < 3; ++k) v[k] = float(p[k]);
            }
        }
        if (snapBits) mesh = snapped(std::move(mesh), snapBits);
    }
};

struct Aimed {
    std::vector<Target> targets;
    Aim aim = Aim::Rounded;
    bool inside = false;
    int gridBits = 16;
    int directionExponent = 0; ///< directions are multiplied by 2 to this
    double radius = 1;         ///< of the shape
};

const float* corner(const Triangle& triangle, uint32_t k) {
    return k == 0 ? triangle.v0 : k == 1 ? triangle.v1 : triangle.v2;
}

/// Origins and what is in sight are chosen in the shape's space, targets on the mesh as traced.
std::vector<Ray> aimedRays(const Mapped& mapped, const Aimed& how, std::size_t count,
                           uint64_t seed) {
    Random random(seed);
    std::vector<Ray> rays;
    rays.reserve(count);
    while (rays.size() < count) {
        const uint32_t number = random.below(uint32_t(mapped.mesh.size()));
        const uint32_t first = random.below(3);
        const Target target = how.targets[random.below(uint32_t(how.targets.size()))];
        double s = 0, r = 0;
        if (target == Target::Edge) {
            s = how.aim == Aim::Exact ? (1 + random.below(15)) / 16.0 : random.unit();
        } else if (target == Target::Interior) {
            s = random.between(0.05, 0.9);
            r = random.between(0.05, 0.95 - s);
        }
        const auto onTriangle = [&](const Triangle& triangle) {
            const float *a = corner(triangle, first), *b = corner(triangle, (first + 1) % 3),
                        *c = corner(triangle, (first + 2) % 3);
            Point p;
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = a[k] + s * (double(b[k]) - a[k]) + r * (double(c[k]) - a[k]);
            }
            return p;
        };
        const double distance = how.inside ? 0.5 * random.unit() : random.between(1.5, 3);
        Point origin = random.onSphere();
        if (!how.inside) {
            const Point sight = onTriangle(mapped.shape[number]);
            double cosine = 0, square = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                cosine += origin[k] * sight[k];
                square += sight[k] * sight[k];
            }
            if (cosine / std::sqrt(square) <= 1 / distance + 0.1) continue; // not in sight
        }
        for (double& x : origin) x *= distance * how.radius;
        origin = mapped.map(origin);
        if (how.aim == Aim::Exact) {
            for (double& x : origin)
                x = std::ldexp(std::nearbyint(std::ldexp(x, how.gridBits)), -how.gridBits);
        }
        const Point point = onTriangle(mapped.mesh[number]);
        Ray ray =
            makeRay(origin.data(), point.data(), how.aim == Aim::Exact ? Aim::Rounded : how.aim);
        for (float& x : ray.dir) x = std::ldexp(x, how.directionExponent);
        rays.push_back(ray);
    }
    return rays;
}

HardCase aimedCase(Mapped mapped, Aimed how, Promise promise) {
    const auto shared = std::make_shared<const Mapped>(std::move(mapped));
    HardCase result;
    result.geometry = Geometry(shared->mesh);
    result.rays = [shared, how](std::size_t count, uint64_t seed) {
        return aimedRays(*shared, how, count, seed);
    };
    result.promise = promise;
    result.share = 1;
    return result;
}

const std::vector<Target> kEdges = {Target::Vertex, Target::Edge};

/// The prism's sides are long thin triangles; targets lie on their long edges, or, at the rim, on
/// the ends of these, which are silhouettes as often as not.
HardCase prismCase(bool rim) {
    constexpr uint32_t kSides = 16384;
    HardCase result;
    const std::vector<Triangle> mesh = prism(kSides, 1, 64);
    result.geometry = Geometry(mesh);
    result.promise = rim ? Promise::None : Promise::NothingLost;
    result.rays = [mesh, rim](std::size_t count, uint64_t seed) {
        Random random(seed);
        std::vector<Ray> rays;
        while (rays.size() < count) {
            // Four triangles a side; the second and third corner of the first: a long edge.
            const Triangle& side = mesh[4 * random.below(kSides)];
            const double along = rim ? random.below(2) : random.between(0.01, 0.99);
            const double edge = std::atan2(side.v1[2], side.v1[0]);
            const double angle = edge + random.between(-0.9, 0.9);
            const double distance = random.between(1.5, 3);
            if (std::cos(angle - edge) <= 1 / distance + 0.1) continue;
            const Point origin = {distance * std::cos(angle), random.between(-64, 64),
                                  distance * std::sin(angle)};
            Point target;
            for (std::size_t k = 0; k < 3; ++k)
                target[k] = side.v1[k] + along * (double(side.v2[k]) - side.v1[k]);
            rays.push_back(makeRay(origin.data(), target.data(), Aim::Rounded));
        }
        return rays;
    };
    return result;
}

/// Star-shaped; gentle bumps are all in sight of the middle, steep ones hide each other.
std::vector<Triangle> bumps(double height) {
    std::vector<Triangle> mesh = bumpySphere(5000);
    for (Triangle& triangle : mesh) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            const double radius =
                std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
            const double wanted = 1 + height * (radius - 1);
            for (int k = 0; k < 3; ++k) v[k] = float(v[k] * wanted / radius);
        }
    }
    return mesh;
}

/// From within half the radius in random directions.
HardCase escapeCase() {
    const Affine place = Affine::scale(2, {148376, 1234, -223423});
    const auto shared = std::make_shared<const Mapped>(icosphere(5), place);
    HardCase result;
    result.geometry = Geometry(shared->mesh);
    result.share = 0.5;
    result.rays = [shared](std::size_t count, uint64_t seed) {
        Random random(seed);
        std::vector<Ray> rays;
        while (rays.size() < count) {
            Point origin = random.onSphere(), target = random.onSphere();
            const double distance = 0.5 * random.unit();
            for (double& x : origin) x *= distance;
            for (std::size_t k = 0; k < 3; ++k) target[k] += origin[k];
            origin = shared->map(origin);
            target = shared->map(target);
            rays.push_back(makeRay(origin.data(), target.data(), Aim::Rounded));
        }
        return rays;
    };
    return result;
}

/// 1e-6 as text.
std::string power(int exponent) {
    return "1e" + std::to_string(exponent);
}

} // namespace

std::vector<NamedCase> aimedCases() {
    std::vector<NamedCase> cases;
    const auto add = [&](const std::string& name, int level, const Affine& map, const Aimed& how,
                         int snapBits = 0, Promise promise = Promise::NothingLost,
                         double share = 1) {
        cases.push_back({name, [=] {
                             HardCase made =
                                 aimedCase(Mapped(icosphere(level), map, snapBits), how, promise);
                             made.share = share;
                             return made;
                         }});
    };
    const Affine same;
    const Aimed exact{kEdges, Aim::Exact}, rounded{kEdges, Aim::Rounded},
        normalised{kEdges, Aim::Normalised};
    for (const int level : {3, 5, 6})
        add("H1-exact-ico" + std::to_string(level), level, same, exact, 16, Promise::Right);
    add("H1-exact-vert", 3, same, {{Target::Vertex}, Aim::Exact}, 16, Promise::Right);
    add("H1-exact-edge", 3, same, {{Target::Edge}, Aim::Exact}, 16, Promise::Right);
    add("H1-round-ico3", 3, same, rounded, 0, Promise::Right);
    add("H1-round-ico6", 6, same, rounded);
    add("H1-norm-ico3", 3, same, normalised, 0, Promise::Right);
    for (int k = 0; k <= 6; ++k) {
        const double offset = std::pow(10.0, k);
        add("H1-off" + power(k), 3,
            Affine::scale(1, {0.577 * offset, -0.59 * offset, 0.565 * offset}), rounded, 0,
            k > 5 ? Promise::None : Promise::NothingLost, 0.3);
    }
    Aimed coarse = exact;
    coarse.gridBits = 9;
    add("H1-off1024-exact", 3, Affine::scale(1, {1024, -512, 768}), coarse, 9);
    for (const int k : {-12, -9, -6, -3, 0, 3, 6, 9, 12}) {
        add("H1-scale" + power(k), 3, Affine::scale(std::pow(10.0, k)), rounded, 0, Promise::Right,
            0.3);
    }
    for (const int k : {-40, -30}) // products vanish in float, or coordinates are denormal
        add("H1-scale" + power(k), 3, Affine::scale(std::pow(10.0, k)), rounded, 0,
            Promise::NothingLost, 0.03);
    for (const int k : {13, 30, 37}) // products overflow in float
        add("H1-scale" + power(k), 3, Affine::scale(std::pow(10.0, k)), rounded, 0, Promise::Right,
            0.1);
    for (const int k : {1, 2, 3, 4, 5, 6}) {
        add("H1-needle" + power(k), 4, Affine::stretch(std::pow(10.0, k)), rounded, 0,
            k > 4 ? Promise::None : Promise::NothingLost, 0.1);
    }
    add("H1-pancake1e-4", 4, Affine::stretch(1e-4), rounded, 0, Promise::NothingLost, 0.1);
    cases.push_back({"H1-prism", [] { return prismCase(false); }});
    cases.push_back({"H1-prism-rim", [] { return prismCase(true); }});

    const auto inner = [](Aimed how) {
        how.inside = true;
        return how;
    };
    add("H2-exact-ico5", 5, same, inner(exact), 16, Promise::Right);
    add("H2-round-ico5", 5, same, inner(rounded));
    cases.push_back({"H2-embree-pos", escapeCase});
    add("H2-embree-pos-aim", 5, Affine::scale(2, {148376, 1234, -223423}), inner(rounded), 0,
        Promise::NothingLost, 0.5);
    add("H2-needle1e4", 4, Affine::stretch(1e4), inner(rounded), 0, Promise::NothingLost, 0.1);
    for (const bool steep : {false, true}) {
        cases.push_back({steep ? "H2-bumpy-steep" : "H2-bumpy", [=] {
                             HardCase made =
                                 aimedCase(Mapped(bumps(steep ? 1 : 0.3), same), inner(rounded),
                                           steep ? Promise::None : Promise::NothingLost);
                             made.share = steep ? 0.1 : 0.5;
                             return made;
                         }});
    }

    for (const int k : {-145, -126, -100, -60, -30, 0, 30, 60, 100, 126}) {
        Aimed how = inner(normalised);
        how.targets = {Target::Edge};
        how.directionExponent = k;
        cases.push_back({"H11-dir2^" + std::to_string(k), [=] {
                             HardCase made =
                                 aimedCase(Mapped(icosphere(3), same), how, Promise::Right);
                             made.share = 0.03;
                             made.abortsPeers = k >= 100;
                             return made;
                         }});
    }
    return cases;
}

} // namespace smart::test
