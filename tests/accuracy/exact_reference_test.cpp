// SPDX-License-Identifier: MIT
// The reference is judged before it judges others: by a second exact solver, by cases whose
// answer is known, and by wrong answers that it must find.
#include "tests/support/exact_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "tests/support/exact_scene.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"
#include "tests/support/verdict.h"

namespace smart::test {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kPairs = 4000;
#else
constexpr int kPairs = 300000;
#endif

constexpr float kInf = INFINITY;

Ray line(float ox, float oy, float oz, float dx, float dy, float dz) {
    return {{ox, oy, oz}, {dx, dy, dz}, 0.0f, kInf};
}

/// Coordinates from few values make edges, vertices, planes and lines coincide all the time.
float coordinate(Random& random, uint32_t kind) {
    switch (kind % 4) {
        case 0:
            return float(random.below(5)) - 2.0f;
        case 1:
            return float(random.between(-1, 1));
        case 2:
            return std::ldexp(float(random.below(9)) - 4.0f, int(random.below(41)) - 20);
        default:
            return 1.0f + std::ldexp(float(random.below(4)), -23);
    }
}

// Three solvers written apart: integer determinants, rationals after Moeller and Trumbore, and
// filtered exact sums.
TEST(ExactReference, AgreesWithTheOtherSolvers) {
    Random random(1);
    int hits = 0, touches = 0, missed = 0;
    for (int pair = 0; pair < kPairs; ++pair) {
        const uint32_t kind = uint32_t(pair) % 5;
        Triangle triangle;
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k)
                v[k] = coordinate(random, kind == 4 ? random.below(4) : kind);
        }
        Ray ray = line(0, 0, 0, 0, 0, 0);
        const bool aimed = random.below(2) != 0;
        double weight[3] = {random.unit(), random.unit(), 0};
        if (weight[0] + weight[1] > 1) weight[1] = 1 - weight[0];
        if (random.below(2)) weight[0] = random.below(3) / 2.0, weight[1] = (1 - weight[0]) / 2;
        weight[2] = 1 - weight[0] - weight[1];
        for (int k = 0; k < 3; ++k) {
            ray.org[k] = coordinate(random, kind == 4 ? random.below(4) : kind);
            ray.dir[k] = aimed ? float(weight[0] * triangle.v0[k] + weight[1] * triangle.v1[k] +
                                       weight[2] * triangle.v2[k] - ray.org[k])
                               : coordinate(random, kind);
        }
        ExactReference reference;
        reference.add({&triangle, 1});
        ExactCrossing a, b;
        const bool first = reference.crosses(0, ray, a);
        const bool second = crossesMollerTrumbore(triangle, ray, b);
        ASSERT_EQ(first, second) << "pair " << pair;
        const ExactScene scene(reference);
        Crossing c;
        ASSERT_EQ(first, scene.crosses(0, ray, c)) << "pair " << pair;
        missed += !first;
        if (!first) continue;
        ++hits;
        touches += a.zeros != 0;
        ASSERT_EQ(a.t, b.t);
        ASSERT_EQ(a.u, b.u);
        ASSERT_EQ(a.v, b.v);
        ASSERT_EQ(a.zeros, b.zeros);
        ASSERT_EQ(a.facing, b.facing);
        ASSERT_EQ(a.zeros, c.zeros);
        ASSERT_EQ(a.facing, c.facing);
        ASSERT_LE(abs(mpq_class(c.t) - a.t), c.error);
        if (a.t >= 0) {
            const ExactAnswer answer = reference.nearest(ray); // through the filters
            ASSERT_EQ(answer.nearest.size() + answer.touches.size(), 1u) << "pair " << pair;
            ASSERT_EQ(answer.must, a.zeros == 0 && a.t > 0);
            const Truth truth = scene.nearest(ray);
            ASSERT_EQ(truth.must, answer.must && a.t < FLT_MAX);
            ASSERT_EQ(truth.nearest.size() + truth.touches.size(), 1u);
            const Claim claim = {0, float(a.t.get_d()), float(a.u.get_d()), 0.25f};
            if (!std::isfinite(claim.t)) continue;
            const ClaimErrors errors = scene.errors(ray, claim);
            ASSERT_NEAR(errors.t, ulpError(claim.t, a.t), 2e-3 + 1e-3 * errors.t);
            const double uv = std::max(mpq_class(abs(mpq_class(claim.u) - a.u)).get_d(),
                                       mpq_class(abs(mpq_class(claim.v) - a.v)).get_d());
            ASSERT_NEAR(errors.uv, uv * 0x1p24, 2e-3 + 1e-3 * errors.uv);
        }
    }
    EXPECT_GT(hits, kPairs / 5);
    EXPECT_GT(touches, kPairs / 20);
    EXPECT_GT(missed, kPairs / 5);
}

TEST(ExactReference, FiltersLoseNothing) {
    const std::vector<Triangle> mesh = snapped(icosphere(3), 16);
    ExactReference reference;
    reference.add(mesh);
    for (Target target : {Target::Vertex, Target::Edge, Target::Interior}) {
        for (const Ray& ray : raysFromOutside(mesh, 1, 50, target, Aim::Exact, 2)) {
            std::size_t crossed = 0;
            ExactCrossing crossing;
            mpq_class first = 1000;
            for (uint32_t i = 0; i < reference.count(); ++i) {
                if (!reference.crosses(i, ray, crossing)) continue;
                ++crossed;
                first = std::min(first, crossing.t);
            }
            EXPECT_GE(crossed, 2u);
            const ExactAnswer answer = reference.nearest(ray);
            ASSERT_TRUE(answer.must);
            EXPECT_EQ(answer.nearest[0].t, first);
            const std::size_t ties = answer.nearest.size();
            switch (target) {
                case Target::Vertex:
                    EXPECT_TRUE(first == 1 && (ties == 5 || ties == 6));
                    break;
                case Target::Edge:
                    EXPECT_TRUE(first == 1 && ties == 2);
                    break;
                case Target::Interior:
                    EXPECT_EQ(ties, 1u);
                    break;
            }
        }
    }
}

TEST(ExactReference, TellsMustFromMay) {
    // The square [0,1]^2 at z = 0 in two triangles, and a third that folds away below.
    const std::vector<Triangle> mesh = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                                        {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                                        {{1, 0, 0}, {0.5f, 0.5f, -1}, {1, 1, 0}}};
    ExactReference reference;
    reference.add(mesh);
    const auto answer = [&](float x, float y) {
        return reference.nearest(line(x, y, 2, 0, 0, -1));
    };
    EXPECT_TRUE(answer(0.75f, 0.25f).must);
    const ExactAnswer diagonal = answer(0.25f, 0.25f);
    EXPECT_TRUE(diagonal.must);
    EXPECT_EQ(diagonal.nearest.size(), 2u);
    EXPECT_EQ(diagonal.nearest[0].t, 2);
    EXPECT_FALSE(answer(0.0f, 0.5f).must); // boundary
    EXPECT_EQ(answer(0.0f, 0.5f).touches.size(), 1u);
    EXPECT_FALSE(answer(0.0f, 0.0f).must); // boundary vertex, two triangles
    EXPECT_EQ(answer(0.0f, 0.0f).touches.size(), 2u);
    EXPECT_FALSE(answer(1.0f, 0.5f).must); // fold: the edge's triangles face apart
    EXPECT_EQ(answer(1.0f, 0.5f).touches.size(), 2u);
    EXPECT_TRUE(answer(1.5f, 0.5f).touches.empty());

    Ray atLimit = line(0.75f, 0.25f, 2, 0, 0, -1);
    atLimit.tFar = 2;
    EXPECT_FALSE(reference.nearest(atLimit).must);
    EXPECT_EQ(reference.nearest(atLimit).touches.size(), 1u);
    atLimit.tFar = std::nextafter(2.0f, 3.0f);
    EXPECT_TRUE(reference.nearest(atLimit).must);
}

TEST(ExactReference, LeavesDegenerateTrianglesOut) {
    const std::vector<Triangle> mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                                        {{0, 0, 1}, {0, 0, 1}, {0, 1, 1}},
                                        {{0, 0, 1}, {0.5f, 0, 1}, {1, 0, 1}},
                                        {{0, 0, NAN}, {1, 0, 1}, {0, 1, 1}},
                                        {{0, 0, 1}, {kInf, 0, 1}, {0, 1, 1}}};
    ExactReference reference;
    reference.add(mesh);
    for (uint32_t i = 0; i < 5; ++i) EXPECT_EQ(reference.degenerate(i), i != 0);
    const ExactAnswer answer = reference.nearest(line(0.25f, 0.25f, 2, 0, 0, -1));
    ASSERT_TRUE(answer.must);
    EXPECT_EQ(answer.nearest[0].triangle, 0u);
}

TEST(ExactReference, MultipliesMatricesExactly) {
    const std::vector<Triangle> mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    const Matrix34 scale = {0.1, 0, 0, 0, 0, 3, 0, 0, 0, 0, 1, 0};
    const Matrix34 shift = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1.0 / 3};
    const Matrix34 chain[] = {shift, scale};
    ExactReference reference;
    reference.add(mesh, chain);
    const ExactAnswer answer = reference.nearest(line(0.0625f, 0.5f, 1, 0, 0, -1));
    ASSERT_TRUE(answer.must);
    EXPECT_EQ(answer.nearest[0].t, mpq_class(1) - mpq_class(1.0 / 3));
    EXPECT_EQ(answer.nearest[0].u, mpq_class(0.0625) / mpq_class(0.1));
    EXPECT_EQ(answer.nearest[0].v, mpq_class(0.5) / 3);
}

TEST(ExactReference, CountsUnitsInTheLastPlace) {
    EXPECT_EQ(ulpError(1.0f, mpq_class(1)), 0);
    EXPECT_EQ(ulpError(std::nextafter(1.5f, 2.0f), mpq_class(1.5)), 1);
    EXPECT_NEAR(ulpError(1.0f / 3, mpq_class(1, 3)), 1.0 / 3, 0.2);
    EXPECT_EQ(ulpError(3.0f, mpq_class(2)), 0x1p22);
}

/// Controls: each kind of wrong answer about two nested spheres must be called by its name.
TEST(Verdict, NamesEachWrongAnswer) {
    const std::vector<Triangle> outer = icosphere(3);
    std::vector<Triangle> mesh = outer;
    for (Triangle triangle : outer) {
        for (float* v : {triangle.v0, triangle.v1, triangle.v2}) {
            for (int k = 0; k < 3; ++k) v[k] *= 1 - 0x1p-20f;
        }
        mesh.push_back(triangle);
    }
    ExactReference reference;
    reference.add(mesh);
    const auto size = uint32_t(outer.size());
    int orders = 0;
    for (const Ray& ray : raysFromOutside(outer, 1, 40, Target::Interior, Aim::Normalised, 3)) {
        const ExactAnswer truth = reference.nearest(ray);
        ASSERT_TRUE(truth.must);
        const ExactCrossing& nearest = truth.nearest[0];
        const Claim right = {nearest.triangle, float(nearest.t.get_d()), 0, 0};
        const auto verdict = [&](const Claim& claim) {
            return judge(reference, truth, ray, claim);
        };
        EXPECT_EQ(verdict(right), Verdict::Right);
        EXPECT_EQ(verdict(Claim{}), Verdict::Miss);
        EXPECT_EQ(verdict({(nearest.triangle + size / 2) % size, right.t, 0, 0}), Verdict::Gross);
        EXPECT_EQ(verdict({nearest.triangle, right.t * 1.1f, 0, 0}), Verdict::Gross);
        EXPECT_EQ(verdict({nearest.triangle, NAN, 0, 0}), Verdict::Gross);
        ExactCrossing other;
        for (uint32_t i = 0; i < reference.count(); ++i) {
            if (!reference.crosses(i, ray, other) || other.t == nearest.t) continue;
            const Claim farther = {i, float(other.t.get_d()), 0, 0};
            const bool close = i == nearest.triangle + size;
            orders += close;
            EXPECT_EQ(verdict(farther), close ? Verdict::Order : Verdict::Through);
        }
        ExactAnswer nothing;
        EXPECT_EQ(judge(reference, nothing, ray, right), Verdict::False);
    }
    EXPECT_GT(orders, 20);
}

/// The fast truth gives the reference's answers and verdicts, for right and for wrong claims.
TEST(ExactScene, AnswersAndJudgesAsTheReference) {
    const std::pair<const char*, std::vector<Triangle>> meshes[] = {
        {"sphere", snapped(icosphere(2), 16)},
        {"soup", triangleSoup(300, 0.5f, 1)},
        {"room", closedRoom()}};
    Random random(4);
    std::size_t all = 0, musts = 0, ties = 0, mays = 0;
    for (const auto& [name, mesh] : meshes) {
        SCOPED_TRACE(name);
        ExactReference reference;
        reference.add(mesh);
        const ExactScene scene(reference);
        std::vector<Ray> rays = randomRays(mesh, 300, 5);
        for (const double step : {0.0, 0.5, 1.0}) {
            const auto parallel = axisParallelRays(8, step, 150, 6);
            rays.insert(rays.end(), parallel.begin(), parallel.end());
        }
        for (const Target target : {Target::Vertex, Target::Edge, Target::Interior}) {
            const auto aimed = raysFromInside(mesh, 1, 150, target, Aim::Exact, 7);
            rays.insert(rays.end(), aimed.begin(), aimed.end());
        }
        all += rays.size();
        for (const Ray& ray : rays) {
            const ExactAnswer answer = reference.nearest(ray);
            const Truth truth = scene.nearest(ray);
            ASSERT_EQ(truth.must, answer.must);
            const auto numbers = [](const auto& crossings) {
                std::vector<uint32_t> result;
                for (const auto& crossing : crossings) result.push_back(crossing.triangle);
                std::sort(result.begin(), result.end());
                return result;
            };
            ASSERT_EQ(numbers(truth.nearest), numbers(answer.nearest));
            ASSERT_EQ(numbers(truth.touches), numbers(answer.touches));
            musts += truth.must;
            ties += truth.nearest.size() > 1;
            mays += !truth.touches.empty();
            std::vector<Claim> claims = {Claim{}};
            for (const auto* crossings : {&answer.nearest, &answer.touches}) {
                for (const ExactCrossing& crossing : *crossings) {
                    const float t = float(crossing.t.get_d());
                    claims.push_back({crossing.triangle, t, 0, 0});
                    claims.push_back({crossing.triangle, t * (1 + 0x1p-14f), 0, 0});
                    claims.push_back({crossing.triangle, t * (1 - 0x1p-18f), 0, 0});
                    for (uint32_t other : reference.topology().neighbours(crossing.triangle)) {
                        claims.push_back({other, t, 0, 0});
                    }
                }
            }
            claims.push_back({random.below(reference.count()), float(random.between(0, 9)), 0, 0});
            claims.push_back({0, NAN, 0, 0});
            for (const Claim& claim : claims) {
                ASSERT_EQ(scene.judge(truth, ray, claim), judge(reference, answer, ray, claim));
            }
        }
    }
    EXPECT_GT(musts, all / 4);
    EXPECT_GT(ties, all / 10);
    EXPECT_GT(mays, all / 50);
}

} // namespace
} // namespace smart::test
