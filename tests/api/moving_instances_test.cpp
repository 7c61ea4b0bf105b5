// SPDX-License-Identifier: MIT
// Instances that move: at every step rays meet what a search through all triangles of all
// instances in double finds; few and many, apart and piled up in one place, nested eight deep.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "openrt/rt.h"

namespace {

using Point = std::array<double, 3>;
/// Three columns and the translation.
using Matrix = std::array<Point, 4>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Point apply(const Matrix& m, const Point& p) {
    Point result = m[3];
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t c = 0; c < 3; ++c) result[k] += m[c][k] * p[c];
    return result;
}

Matrix times(const Matrix& a, const Matrix& b) {
    Matrix result;
    for (std::size_t c = 0; c < 3; ++c) {
        const Point origin = apply(a, {0, 0, 0}), tip = apply(a, b[c]);
        for (std::size_t k = 0; k < 3; ++k) result[c][k] = tip[k] - origin[k];
    }
    result[3] = apply(a, b[3]);
    return result;
}

struct PlacedTriangle {
    Point corner[3];
    uint32_t instance, primitive;
};

/// What the application knows of an object: its triangles, and other objects in it.
struct Shape {
    std::vector<std::array<Point, 3>> triangles;
    std::vector<std::pair<const Shape*, Matrix>> children;

    void place(const Matrix& matrix, uint32_t instance, std::vector<PlacedTriangle>& all) const {
        uint32_t number = 0;
        for (const auto& triangle : triangles)
            all.push_back({{apply(matrix, triangle[0]), apply(matrix, triangle[1]),
                            apply(matrix, triangle[2])},
                           instance, number++});
        for (const auto& [child, inThis] : children)
            child->place(times(matrix, inThis), instance, all);
    }
};

struct Answer {
    double t = kInfinity;
    uint32_t instance = RT_INVALID, primitive = RT_INVALID;
    bool isClear = true; ///< no edge near, nothing at nearly the same distance
};

/// Moeller and Trumbore, "Fast, minimum storage ray/triangle intersection", 1997.
Answer search(const std::vector<PlacedTriangle>& all, const Point& origin, const Point& direction) {
    constexpr double kNear = 1e-4;
    Answer best;
    double second = kInfinity, nearEdge = kInfinity;
    for (const PlacedTriangle& triangle : all) {
        Point e1, e2, s;
        for (std::size_t k = 0; k < 3; ++k) {
            e1[k] = triangle.corner[1][k] - triangle.corner[0][k];
            e2[k] = triangle.corner[2][k] - triangle.corner[0][k];
            s[k] = origin[k] - triangle.corner[0][k];
        }
        const auto cross = [](const Point& a, const Point& b) {
            return Point{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
        };
        const auto dot = [](const Point& a, const Point& b) {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        };
        const Point p = cross(direction, e2), q = cross(s, e1);
        const double determinant = dot(e1, p);
        if (determinant == 0) continue;
        const double u = dot(s, p) / determinant, v = dot(direction, q) / determinant;
        const double t = dot(e2, q) / determinant, inside = std::min({u, v, 1 - u - v});
        if (t < 0 || inside < -kNear) continue;
        if (inside < kNear) nearEdge = std::min(nearEdge, t);
        if (inside < 0) continue;
        if (t < best.t) {
            second = best.t;
            best = {t, triangle.instance, triangle.primitive, true};
        } else {
            second = std::min(second, t);
        }
    }
    const double margin = 1e-4 * (best.t < kInfinity ? best.t : 1);
    best.isClear = nearEdge > best.t + margin && !(second - best.t < margin);
    return best;
}

void multiply(const Matrix& m) {
    double column[16] = {};
    for (std::size_t c = 0; c < 4; ++c)
        for (std::size_t k = 0; k < 3; ++k) column[4 * c + k] = m[c][k];
    column[15] = 1;
    rtMultMatrixd(column);
}

struct Randomness {
    std::mt19937 generator{11};
    double operator()(double low, double high) {
        return low + (high - low) * double(generator() >> 8) / double(1u << 24);
    }
    Point point(double size) {
        return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
    }
    /// A rotation, stretched by up to half.
    Matrix matrix(double size, const Point& where) {
        const double a = (*this)(0, 6.283), b = (*this)(0, 6.283);
        const double x = size * (*this)(1, 1.5), y = size * (*this)(1, 1.5), z = size;
        const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
        return {{{x * ca * cb, x * sa * cb, -x * sb},
                 {-y * sa, y * ca, 0},
                 {z * ca * sb, z * sa * sb, z * cb},
                 where}};
    }
};

/// A shape and the object of the library that is the same.
struct Thing {
    Shape shape;
    RTuint object = 0;

    void define(const std::vector<const Thing*>& children) {
        object = rtNewObject(RT_DEFINE);
        rtBegin(RT_TRIANGLES);
        for (const auto& triangle : shape.triangles)
            for (const Point& corner : triangle) rtVertex3dv(corner.data());
        rtEnd();
        for (std::size_t i = 0; i < children.size(); ++i) {
            rtPushMatrix();
            multiply(shape.children[i].second);
            rtInstantiateObject(children[i]->object);
            rtPopMatrix();
        }
        rtEndObject();
    }
};

class MovingInstances : public testing::Test {
protected:
    void SetUp() override {
        rtInit(nullptr, nullptr);
        rtThreads(2);
    }
    void TearDown() override { rtExit(); }

    Thing makeThing(int triangles) {
        Thing thing;
        for (int i = 0; i < triangles; ++i) {
            const Point centre = random.point(1);
            std::array<Point, 3> triangle;
            for (Point& corner : triangle) {
                corner = random.point(0.5);
                for (std::size_t k = 0; k < 3; ++k) corner[k] = float(corner[k] + centre[k]);
            }
            thing.shape.triangles.push_back(triangle);
        }
        return thing;
    }

    /// Instantiates, asks, compares; returns how many rays met something.
    int compare(const std::vector<std::pair<const Thing*, Matrix>>& instances, double size) {
        std::vector<PlacedTriangle> all;
        const RTuint scene = rtGenScene();
        rtBindScene(scene);
        for (uint32_t i = 0; i < instances.size(); ++i) {
            rtPushMatrix();
            multiply(instances[i].second);
            rtInstantiateObject(instances[i].first->object);
            rtPopMatrix();
            instances[i].first->shape.place(instances[i].second, i, all);
        }
        const RTuint compiled = rtCompileScene();
        EXPECT_EQ(rtGetError(), RTenum(RT_NO_ERROR));
        constexpr int kRays = 320;
        std::vector<RTray> rays(kRays);
        std::vector<RThit> hits(kRays);
        const Point eye = random.point(2 * size);
        for (int i = 0; i < kRays; ++i) { // half of them from one point, through a grid
            const Point from = i < kRays / 2 ? eye : random.point(2 * size);
            const Point to = random.point(size);
            for (std::size_t k = 0; k < 3; ++k) {
                rays[i].origin[k] = float(from[k]);
                rays[i].direction[k] = float(to[k] - from[k]);
            }
            rays[i].tnear = 0;
            rays[i].tfar = std::numeric_limits<float>::infinity();
        }
        int met = 0;
        for (const RTenum coherence : {RT_COHERENT, RT_INCOHERENT}) {
            rtIntersect(compiled, rays.data(), hits.data(), kRays, coherence);
            for (std::size_t i = 0; i < kRays; ++i) {
                const RTray& ray = rays[i];
                const Answer answer =
                    search(all, {ray.origin[0], ray.origin[1], ray.origin[2]},
                           {ray.direction[0], ray.direction[1], ray.direction[2]});
                if (!answer.isClear) continue;
                EXPECT_EQ(hits[i].instance, answer.instance) << i;
                EXPECT_EQ(hits[i].primitive, answer.primitive) << i;
                if (answer.instance == RT_INVALID) continue;
                EXPECT_NEAR(hits[i].t, answer.t, 1e-4 * answer.t) << i;
                ++met;
            }
        }
        rtReleaseScene(compiled);
        rtDeleteScene(scene);
        return met;
    }

    Randomness random;
};

TEST_F(MovingInstances, FewAndManyAtEveryStep) {
    Thing a = makeThing(12), b = makeThing(3);
    a.define({});
    b.define({});
    for (const int count : {1, 2, 17, 150}) {
        const double size = 4;
        std::vector<Point> places, ways;
        for (int i = 0; i < count; ++i) {
            places.push_back(random.point(size));
            ways.push_back(random.point(0.7));
        }
        int met = 0;
        for (int step = 0; step < 4; ++step) {
            std::vector<std::pair<const Thing*, Matrix>> instances;
            for (int i = 0; i < count + step; ++i) { // they become more, too
                Point place = i < count ? places[std::size_t(i)] : Point{0, 0, 0};
                for (std::size_t k = 0; i < count && k < 3; ++k)
                    place[k] += step * ways[std::size_t(i)][k];
                instances.emplace_back(i % 3 ? &a : &b, random.matrix(0.8, place));
            }
            met += compare(instances, size);
        }
        EXPECT_GT(met, 0) << count; // the control: the rays do meet something
    }
}

TEST_F(MovingInstances, SoManyThatTheirTreeIsBuiltInLinearTime) {
    Thing a = makeThing(3), b = makeThing(1);
    a.define({});
    b.define({});
    for (int step = 0; step < 2; ++step) {
        std::vector<std::pair<const Thing*, Matrix>> instances;
        for (int i = 0; i < 4500; ++i)
            instances.emplace_back(i % 2 ? &a : &b, random.matrix(0.5, random.point(6)));
        EXPECT_GT(compare(instances, 6), 0);
    }
}

TEST_F(MovingInstances, PiledUpInOnePlace) {
    Thing thing = makeThing(8);
    thing.define({});
    for (int step = 0; step < 3; ++step) {
        std::vector<std::pair<const Thing*, Matrix>> instances;
        for (int i = 0; i < 200; ++i)
            instances.emplace_back(&thing, random.matrix(1, random.point(0.05 * step)));
        EXPECT_GT(compare(instances, 1.5), 100);
    }
}

TEST_F(MovingInstances, FromTinyToHuge) {
    Thing thing = makeThing(8);
    thing.define({});
    std::vector<std::pair<const Thing*, Matrix>> instances;
    for (int i = 0; i < 60; ++i)
        instances.emplace_back(&thing, random.matrix(std::pow(10.0, i / 15 - 2), random.point(8)));
    EXPECT_GT(compare(instances, 6), 100);
}

TEST_F(MovingInstances, NestedEightDeep) {
    constexpr std::size_t kDepth = 8;
    std::vector<Thing> things(kDepth); // the last is the outermost
    for (std::size_t level = 0; level < kDepth; ++level) {
        things[level] = makeThing(2);
        std::vector<const Thing*> children;
        for (int copy = 0; level > 0 && copy < 2; ++copy) {
            children.push_back(&things[level - 1]);
            things[level].shape.children.emplace_back(&things[level - 1].shape,
                                                      random.matrix(0.7, random.point(1)));
        }
        things[level].define(children);
        ASSERT_EQ(rtGetError(), RTenum(RT_NO_ERROR)) << level;
    }
    int met = 0;
    for (int step = 0; step < 3; ++step) {
        std::vector<std::pair<const Thing*, Matrix>> instances;
        for (int i = 0; i < 3; ++i)
            instances.emplace_back(&things.back(), random.matrix(1, random.point(3)));
        met += compare(instances, 3);
    }
    EXPECT_GT(met, 50);
}

/// The control of the comparison: a search among instances that have not moved finds otherwise.
TEST_F(MovingInstances, TheSearchDependsOnThePlaces) {
    Thing thing = makeThing(8);
    std::vector<PlacedTriangle> before, after;
    thing.shape.place(random.matrix(1, {0, 0, 0}), 0, before);
    thing.shape.place(random.matrix(1, {0.3, 0, 0}), 0, after);
    int different = 0;
    for (int i = 0; i < 100; ++i) {
        const Point from = random.point(3), to = random.point(0.5);
        const Point direction = {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
        different += search(before, from, direction).t != search(after, from, direction).t;
    }
    EXPECT_GT(different, 5);
}

} // namespace
