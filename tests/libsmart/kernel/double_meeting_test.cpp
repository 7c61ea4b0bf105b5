// SPDX-License-Identifier: MIT
// The bounds of the double stage: the exact values lie within them, and what it is sure of is so.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "libsmart/kernel/exact_meeting.h"
#include "tests/libsmart/kernel/test_size.h"
#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"
#include "tests/support/traced_scene.h"

namespace smart::test {
namespace {

/// How often estimates were wrong, and how often double was sure.
struct Outcome {
    std::size_t tests = 0, sure = 0, wrongSide = 0, outsideBounds = 0, exactDisagrees = 0;
    double closest = 1e300; ///< least bound over actual error: how much room there is
};

bool contains(const Estimate& estimate, const mpq_class& exact, double tightened, double& room) {
    if (std::isinf(estimate.error)) return true;
    const mpq_class off = abs(mpq_class(estimate.value) - exact);
    if (off != 0) room = std::min(room, estimate.error / off.get_d());
    return off <= mpq_class(estimate.error * tightened);
}

/// `tightened` below 1 makes the bounds too small: a control.
Outcome judge(const TracedScene& scene, const TriangleName& name, uint32_t number, const Ray& ray,
              double tightened) {
    Outcome outcome;
    const WorldRay world = {{ray.org[0], ray.org[1], ray.org[2]},
                            {ray.dir[0], ray.dir[1], ray.dir[2]},
                            0, INFINITY, 1};
    DoubleMeeting meeting;
    meetInDouble(scene.view(), world, name, meeting);
    ExactMeeting exact;
    meetExactly(scene.view(), world, name, exact);
    ExactCrossing crossing;
    const bool crosses = scene.reference().crosses(number, ray, crossing);
    outcome.tests = 1;
    outcome.exactDisagrees = exact.inside != crosses;
    outcome.sure = meeting.side != Side::Unsure;
    outcome.wrongSide = outcome.sure && crosses != (meeting.side == Side::Inside);
    if (crosses) {
        outcome.outsideBounds = !contains(meeting.t, crossing.t, tightened, outcome.closest) ||
                                !contains(meeting.u, crossing.u, tightened, outcome.closest) ||
                                !contains(meeting.v, crossing.v, tightened, outcome.closest);
    }
    return outcome;
}

Outcome judgeMany(const glm::dmat4& matrix, double size, double tightened) {
    Outcome total;
    Random random(70);
    const auto mesh = triangleSoup(200, float(size), 71);
    const TracedScene scene({place(makeModel(mesh), glm::dmat4x3(matrix))});
    for (std::size_t i = 0; i < rayCount(2000); ++i) {
        const uint32_t number = random.below(200);
        const auto& v = scene.reference().corners(number);
        double origin[3], target[3];
        const double u = random.unit(), w = i % 4 ? random.unit() * (1 - u) : i % 8 ? 0 : 1 - u;
        const std::array<double, 3> away = random.onSphere();
        for (std::size_t k = 0; k < 3; ++k) {
            target[k] = v[k] + u * (v[3 + k] - v[k]) + w * (v[6 + k] - v[k]);
            origin[k] = target[k] + away[k] * 3 * scene.reference().extent();
        }
        const TriangleName name = {{0}, 1, number};
        const Outcome one =
            judge(scene, name, number, makeRay(origin, target, Aim::Normalised), tightened);
        total.tests += one.tests;
        total.sure += one.sure;
        total.wrongSide += one.wrongSide;
        total.outsideBounds += one.outsideBounds;
        total.exactDisagrees += one.exactDisagrees;
        total.closest = std::min(total.closest, one.closest);
    }
    return total;
}

TEST(DoubleMeeting, BoundsHold) {
    const glm::dmat4 one(1.0);
    const glm::dmat4 turned = glm::rotate(one, 0.7, glm::dvec3(0.36, 0.48, 0.8));
    const std::pair<glm::dmat4, double> cases[] = { // the last two are badly conditioned
        {one, 0.2},
        {one, 1e-3},
        {turned, 0.2},
        {glm::translate(one, glm::dvec3(1e4, -1e4, 3e3)) * turned, 0.1},
        {turned * glm::scale(one, glm::dvec3(1e-12, -1e-12, 1e-12)), 0.2},
        {turned * glm::scale(one, glm::dvec3(1, 1e-3, 1e3)), 0.2},
        {turned * glm::scale(one, glm::dvec3(1, 1, 1e-6)), 0.2}};
    for (const auto& [matrix, size] : cases) {
        const Outcome outcome = judgeMany(matrix, size, 1);
        EXPECT_EQ(outcome.wrongSide, 0u);
        EXPECT_EQ(outcome.outsideBounds, 0u);
        EXPECT_EQ(outcome.exactDisagrees, 0u);
        EXPECT_GT(outcome.sure, outcome.tests / 100) << "or the bounds say nothing";
        std::cout << "    sure of " << outcome.sure << " of " << outcome.tests
                  << "; bounds at least " << outcome.closest << " times the error\n";
    }
    // The check must find bounds that are too small.
    EXPECT_GT(judgeMany(one, 0.2, 1e-3).outsideBounds, 0u);
}

} // namespace
} // namespace smart::test
