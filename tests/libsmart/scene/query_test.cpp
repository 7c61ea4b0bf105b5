// SPDX-License-Identifier: MIT
#include "libsmart/scene/query.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <tuple>

#include "tests/support/procedural_meshes.h"
#include "tests/support/ray_sets.h"
#include "tests/support/traced_scene.h"

namespace smart {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr uint32_t kUntouched = 0xABABABABu;

/// All outputs of one ray, as an array of structures.
struct Answer {
    float t, u, v;
    uint32_t primitive, object, instance;
    float normal[3];
    uint32_t flags;
};
constexpr std::ptrdiff_t kAnswerWords = sizeof(Answer) / 4;

RayStream streamOf(const std::vector<Ray>& rays) {
    RayStream stream{};
    if (rays.empty()) return stream;
    for (int k = 0; k < 3; ++k) {
        stream.org[k] = &rays[0].org[k];
        stream.dir[k] = &rays[0].dir[k];
    }
    stream.tNear = &rays[0].tNear;
    stream.tFar = &rays[0].tFar;
    stream.stride = sizeof(Ray) / sizeof(float);
    return stream;
}

HitStream streamOf(std::vector<Answer>& answers) {
    Answer& first = answers[0];
    return {&first.t,
            &first.u,
            &first.v,
            &first.primitive,
            &first.object,
            &first.instance,
            {&first.normal[0], &first.normal[1], &first.normal[2]},
            &first.flags,
            kAnswerWords};
}

std::vector<Answer> ask(const Scene& scene, const std::vector<Ray>& rays, Coherence coherence) {
    std::vector<Answer> answers(rays.size() + 1); // one more, to see that nobody writes there
    std::memset(answers.data(), 0xAB, answers.size() * sizeof(Answer));
    intersect(scene, streamOf(rays), streamOf(answers), rays.size(), coherence);
    EXPECT_EQ(answers.back().primitive, kUntouched);
    EXPECT_EQ(answers.back().flags, kUntouched);
    answers.pop_back();
    return answers;
}

std::vector<uint8_t> askBlocked(const Scene& scene, const std::vector<Ray>& rays,
                                Coherence coherence) {
    std::vector<uint8_t> blocked(rays.size() + 1, 0xAB);
    occluded(scene, streamOf(rays), blocked.data(), rays.size(), coherence);
    EXPECT_EQ(blocked.back(), 0xAB);
    blocked.pop_back();
    return blocked;
}

bool same(const std::vector<Answer>& a, const std::vector<Answer>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Answer)) == 0;
}

Instance place(ModelPtr model, uint32_t objectId, const glm::dmat4x3& matrix) {
    Instance instance = test::place(std::move(model), matrix);
    instance.objectId = objectId;
    return instance;
}

glm::dmat4x3 moved(double x, double y, double z, double scale = 1) {
    glm::dmat4x3 matrix(scale);
    matrix[3] = {x, y, z};
    return matrix;
}

/// The square [0,2]^2 at z = 0 in two triangles, facing +z.
ModelPtr square() {
    return test::makeModel({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}, {{0, 0, 0}, {2, 2, 0}, {0, 2, 0}}});
}

enum class Tree { Wide, Kd };

class QueryTest : public testing::TestWithParam<std::tuple<Coherence, Tree>> {
protected:
    static Coherence coherence() { return std::get<Coherence>(GetParam()); }
    static const Scene& sceneOf(const test::TracedScene& traced) {
        return std::get<Tree>(GetParam()) == Tree::Kd ? traced.scene() : traced.wideScene();
    }
};
std::string nameOf(const testing::TestParamInfo<QueryTest::ParamType>& info) {
    const bool coherent = std::get<Coherence>(info.param) == Coherence::Coherent;
    const bool kd = std::get<Tree>(info.param) == Tree::Kd;
    return std::string(coherent ? "Coherent" : "Incoherent") + (kd ? "InKdTrees" : "");
}
INSTANTIATE_TEST_SUITE_P(Each, QueryTest,
                         testing::Combine(testing::Values(Coherence::Coherent,
                                                          Coherence::Incoherent),
                                          testing::Values(Tree::Wide, Tree::Kd)),
                         nameOf);

TEST_P(QueryTest, AnswersAsWorkedOutByHand) {
    // Squares at z = 5 (object 70), z = 3 (object 71, twice as large), z = 9 in another group.
    const ModelPtr inner = test::makeModel(
        {}, {place(square(), 8, moved(0, 0, 1)), place(square(), 9, moved(100, 0, 4))});
    const Scene scene({place(square(), 70, moved(0, 0, 5)), place(square(), 71, moved(0, 0, 3, 2)),
                       place(inner, 72, moved(0, 0, 5))},
                      Precision::Watertight, 1);
    const std::vector<Ray> rays = {
        {{1.5f, 0.5f, 0}, {0, 0, 2}, 0, kInf},    // bottom of the large square
        {{1.5f, 0.5f, 8}, {0, 0, -1}, 0, kInf},   // top of the nested one
        {{1.5f, 0.5f, 4}, {0, 0, 0.5f}, 0, kInf}, // bottom of the small one
        {{100.5f, 1.5f, 0}, {0, 0, 1}, 0, kInf},  // nested, second child, second triangle
        {{1.5f, 0.5f, 0}, {0, 0, 1}, 0, 2.5f},    // stops short
    };
    const std::vector<Answer> answers = ask(scene, rays, coherence());
    const Answer expected[] = {
        {1.5f, 0.25f, 0.125f, 0, 71, 1, {0, 0, 16}, 1},   {2, 0.5f, 0.25f, 0, 8, 2, {0, 0, 4}, 0},
        {2, 0.5f, 0.25f, 0, 70, 0, {0, 0, 4}, 1},        {9, 0.25f, 0.5f, 1, 9, 2, {0, 0, 4}, 1},
        {2.5f, 0, 0, kNoId, kNoId, kNoId, {0, 0, 0}, 0},
    };
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(answers[i].t, expected[i].t) << i;
        EXPECT_EQ(answers[i].u, expected[i].u) << i;
        EXPECT_EQ(answers[i].v, expected[i].v) << i;
        EXPECT_EQ(answers[i].primitive, expected[i].primitive) << i;
        EXPECT_EQ(answers[i].object, expected[i].object) << i;
        EXPECT_EQ(answers[i].instance, expected[i].instance) << i;
        for (int k = 0; k < 3; ++k) EXPECT_EQ(answers[i].normal[k], expected[i].normal[k]) << i;
        EXPECT_EQ(answers[i].flags, expected[i].flags) << i;
    }
    EXPECT_EQ(askBlocked(scene, rays, coherence()), (std::vector<uint8_t>{1, 1, 1, 1, 0}));
}

TEST_P(QueryTest, MirroredInstancesTurnTheirNormals) {
    glm::dmat4x3 mirror(1.0);
    mirror[2][2] = -1;
    const Scene scene({place(square(), 1, mirror)}, Precision::Watertight, 1);
    const std::vector<Answer> answers =
        ask(scene, {{{1, 0.5f, -1}, {0, 0, 1}, 0, kInf}, {{1, 0.5f, 1}, {0, 0, -1}, 0, kInf}},
            coherence());
    // The edges lie in the mirror's plane: their product stays, as the definition says.
    for (const Answer& answer : answers) EXPECT_EQ(answer.normal[2], 4);
    EXPECT_EQ(answers[0].flags, 1u);
    EXPECT_EQ(answers[1].flags, 0u);
}

TEST_P(QueryTest, RaysThatAreNoneMiss) {
    const Scene scene({place(square(), 1, moved(0, 0, 5))}, Precision::Watertight, 1);
    std::vector<Ray> rays;
    for (const float bad : {kNan, kInf, -kInf}) {
        for (int k = 0; k < 3; ++k) {
            Ray ray{{1, 0.5f, 0}, {0, 0, 1}, 0, 100};
            ray.org[k] = bad;
            rays.push_back(ray);
            ray = {{1, 0.5f, 0}, {0, 0, 1}, 0, 100};
            ray.dir[k] = bad;
            rays.push_back(ray);
        }
    }
    rays.push_back({{1, 0.5f, 0}, {0, -0.0f, 0}, 0, 100});
    rays.push_back({{1, 0.5f, 0}, {0, 0, 1}, kNan, 100});
    rays.push_back({{1, 0.5f, 0}, {0, 0, 1}, 0, kNan});
    rays.push_back({{1, 0.5f, 0}, {0, 0, 1}, 7, 3});
    rays.push_back({{1, 0.5f, 0}, {0, 0, 1}, 0, -1});
    const std::vector<Answer> answers = ask(scene, rays, coherence());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(answers[i].primitive, kNoId) << i;
        EXPECT_EQ(answers[i].object, kNoId) << i;
        EXPECT_EQ(answers[i].instance, kNoId) << i;
        EXPECT_EQ(std::memcmp(&answers[i].t, &rays[i].tFar, sizeof(float)), 0) << i;
        EXPECT_EQ(answers[i].u, 0) << i;
        EXPECT_EQ(answers[i].v, 0) << i;
        EXPECT_EQ(answers[i].flags, 0u) << i;
    }
    EXPECT_EQ(askBlocked(scene, rays, coherence()), std::vector<uint8_t>(rays.size(), 0));
}

TEST_P(QueryTest, LimitsAreClosedAndMayBeInfiniteOrNegative) {
    const Scene scene({place(square(), 1, moved(0, 0, 5))}, Precision::Watertight, 1);
    const float below = std::nextafter(5.0f, 0.0f), above = std::nextafter(5.0f, 9.0f);
    const std::vector<Ray> rays = {
        {{1, 0.5f, 0}, {0, 0, 1}, 5, 5},        {{1, 0.5f, 0}, {0, 0, 1}, 0, 5},
        {{1, 0.5f, 0}, {0, 0, 1}, 5, kInf},     {{1, 0.5f, 0}, {0, 0, 1}, -kInf, kInf},
        {{1, 0.5f, 0}, {0, 0, 1}, above, kInf}, {{1, 0.5f, 0}, {0, 0, 1}, 0, below},
        {{1, 0.5f, 6}, {0, 0, 1}, -kInf, kInf},
    };
    EXPECT_EQ(askBlocked(scene, rays, coherence()), (std::vector<uint8_t>{1, 1, 1, 1, 0, 0, 0}));
    const std::vector<Answer> answers = ask(scene, rays, coherence());
    for (int i = 0; i < 4; ++i) EXPECT_EQ(answers[i].t, 5) << i;
    for (int i = 4; i < 7; ++i) EXPECT_EQ(answers[i].primitive, kNoId) << i;
}

TEST_P(QueryTest, EqualDistancesGoToTheLowestNumber) {
    const ModelPtr doubled = test::makeModel({{{-9, 0, 0}, {-8, 0, 0}, {-8, 1, 0}},
                                              {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}},
                                              {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}}});
    const Scene scene({place(square(), 5, moved(0, 0, 6)), place(doubled, 6, moved(0, 0, 5)),
                       place(square(), 7, moved(0, 0, 5))},
                      Precision::Watertight, 1);
    const std::vector<Answer> answers =
        ask(scene, {{{1.5f, 0.5f, 0}, {0, 0, 1}, 0, kInf}}, coherence());
    EXPECT_EQ(answers[0].instance, 1u);
    EXPECT_EQ(answers[0].object, 6u);
    EXPECT_EQ(answers[0].primitive, 1u);
}

TEST_P(QueryTest, OnlyWhatIsWantedIsWritten) {
    const test::TracedScene traced(test::icosphere(2));
    const std::vector<Ray> rays = test::randomRays(test::icosphere(2), 200, 4);
    const std::vector<Answer> all = ask(sceneOf(traced), rays, coherence());
    for (int wanted = 0; wanted < 10; ++wanted) {
        std::vector<uint32_t> column(rays.size(), kUntouched);
        HitStream stream{};
        float* asFloat = reinterpret_cast<float*>(column.data());
        float** const floats[] = {&stream.t,         &stream.u,         &stream.v,
                                  &stream.normal[0], &stream.normal[1], &stream.normal[2]};
        uint32_t** const words[] = {&stream.primitive, &stream.object, &stream.instance,
                                    &stream.flags};
        if (wanted < 6)
            *floats[wanted] = asFloat;
        else
            *words[wanted - 6] = column.data();
        intersect(sceneOf(traced), streamOf(rays), stream, rays.size(), coherence());
        const std::size_t place[] = {0, 1, 2, 6, 7, 8, 3, 4, 5, 9}; // word in Answer
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const char* expected = reinterpret_cast<const char*>(&all[i]) + 4 * place[wanted];
            ASSERT_EQ(std::memcmp(&column[i], expected, 4), 0) << wanted << ", ray " << i;
        }
    }
}

TEST_P(QueryTest, AnyCountAndSharedOriginsGiveTheSameAnswers) {
    const test::TracedScene traced(test::bumpySphere(400));
    std::vector<Ray> rays(40);
    test::Random random(3);
    for (Ray& ray : rays) {
        const auto direction = random.onSphere();
        ray = {{0.1f, -0.2f, 0.3f},
               {float(direction[0]), float(direction[1]), float(direction[2])},
               0,
               kInf};
    }
    const std::vector<Answer> all = ask(sceneOf(traced), rays, coherence());
    for (std::size_t count = 0; count <= rays.size(); ++count) {
        std::vector<Answer> some(rays.size() + 1);
        RayStream stream = streamOf(rays);
        stream.commonOrigin = count % 2;
        if (count % 3 == 0) stream.tNear = stream.tFar = nullptr;
        intersect(sceneOf(traced), stream, streamOf(some), count, coherence());
        EXPECT_EQ(std::memcmp(some.data(), all.data(), count * sizeof(Answer)), 0) << count;
        for (std::size_t i = count; i < some.size(); ++i) EXPECT_EQ(some[i].t, 0);
    }
}

TEST_P(QueryTest, AgreesWithExactArithmetic) {
    glm::dmat4x3 sheared(1.0);
    sheared[0] = {0.8, 0.1, -0.3};
    sheared[1] = {-0.2, -1.1, 0.2};
    sheared[3] = {0.5, 0.25, -0.75};
    const std::vector<Triangle> sphere = test::bumpySphere(600);
    const ModelPtr model = test::makeModel(sphere);
    const test::TracedScene traced({test::place(model), test::place(model, sheared),
                                    test::place(test::makeModel(test::triangleSoup(60, 0.4f, 2)))});
    const std::vector<Ray> rays = test::randomRays(sphere, 500, 8);
    const std::vector<test::ExactAnswer> truth = traced.truth(rays);
    const std::vector<Answer> answers = ask(sceneOf(traced), rays, coherence());
    const std::vector<uint8_t> blocked = askBlocked(sceneOf(traced), rays, coherence());
    const auto judged = [&](uint32_t shift) {
        std::vector<Hit> hits(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Answer& answer = answers[i];
            if (answer.primitive == kNoId) {
                hits[i].triangle = kNoHit;
                continue;
            }
            const uint32_t triangle = answer.primitive + shift;
            hits[i] = {answer.t, answer.u, answer.v, triangle, 1, {answer.instance}};
        }
        return traced.judgeAll(rays, truth, hits);
    };
    const test::VerdictCounts counts = judged(0);
    EXPECT_EQ(counts.wrong(), 0u) << counts;
    EXPECT_GT(counts.hits, rays.size() / 5);
    EXPECT_LT(counts.worstT, 16);
    EXPECT_GT(judged(1).wrong(), 0u) << "control: the next triangle is wrong";
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(blocked[i], answers[i].primitive != kNoId) << i;
        if (!blocked[i]) continue;
        // The normal and the side, from the corners in world space.
        const auto& corners = traced.reference().corners(
            traced.claim({0, 0, 0, answers[i].primitive, 1, {answers[i].instance}}).triangle);
        double normal[3], dot = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            const int a = (k + 1) % 3, b = (k + 2) % 3;
            normal[k] = (corners[3 + a] - corners[a]) * (corners[6 + b] - corners[b]) -
                        (corners[3 + b] - corners[b]) * (corners[6 + a] - corners[a]);
            dot += normal[k] * rays[i].dir[k];
            size = std::max(size, std::fabs(normal[k]));
        }
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(answers[i].normal[k], normal[k], 1e-6 * size);
        EXPECT_EQ(answers[i].flags, uint32_t(dot > 0));
    }
}

TEST_P(QueryTest, EmptyScenesAnswerToo) {
    for (const Precision precision : {Precision::Fast, Precision::Watertight}) {
        const Scene nothing({}, precision, 1);
        const Scene flat({place(square(), 1, glm::dmat4x3(0.0))}, precision, 1);
        const std::vector<Ray> rays(20, Ray{{1, 1, -1}, {0, 0, 1}, 0, 7});
        for (const Scene* scene : {&nothing, &flat}) {
            for (const Answer& answer : ask(*scene, rays, coherence())) {
                EXPECT_EQ(answer.instance, kNoId);
                EXPECT_EQ(answer.t, 7);
            }
            EXPECT_EQ(askBlocked(*scene, rays, coherence()), std::vector<uint8_t>(20, 0));
        }
    }
}

TEST_P(QueryTest, FastModeAnswersInTheMiddleOfTriangles) {
    const Scene scene({place(square(), 4, moved(0, 0, 5)), place(square(), 5, moved(1, 0, 8))},
                      Precision::Fast, 1);
    const std::vector<Answer> answers =
        ask(scene, {{{1.5f, 0.5f, 0}, {0, 0, 1}, 0, kInf}, {{2.5f, 0.25f, 0}, {0, 0, 2}, 0, kInf}},
            coherence());
    EXPECT_EQ(answers[0].object, 4u);
    EXPECT_FLOAT_EQ(answers[0].t, 5);
    EXPECT_EQ(answers[1].object, 5u);
    EXPECT_FLOAT_EQ(answers[1].t, 4);
    EXPECT_EQ(answers[1].flags, 1u);
}

TEST_P(QueryTest, FloatingPointStateNeitherMattersNorChanges) {
    const test::TracedScene traced(test::bumpySphere(300));
    const std::vector<Ray> rays = test::randomRays(test::bumpySphere(300), 100, 6);
    const std::vector<Answer> expected = ask(sceneOf(traced), rays, coherence());
    std::fenv_t found;
    std::fegetenv(&found);
    for (const int mode : {FE_UPWARD, FE_TOWARDZERO}) {
        std::fesetround(mode);
        std::feclearexcept(FE_ALL_EXCEPT);
        const std::vector<Answer> answers = ask(sceneOf(traced), rays, coherence());
        const int raised = std::fetestexcept(FE_ALL_EXCEPT), after = std::fegetround();
        std::fesetenv(&found);
        EXPECT_TRUE(same(answers, expected));
        EXPECT_EQ(raised, 0);
        EXPECT_EQ(after, mode);
    }
}

TEST(QueryCoherenceTest, AllWaysGiveTheSameBits) {
    const std::vector<Triangle> soup = test::triangleSoup(800, 0.3f, 3);
    for (const Precision precision : {Precision::Fast, Precision::Watertight}) {
        const test::TracedScene traced(soup, precision);
        const std::vector<Ray> rays = test::randomRays(soup, 1000, 12);
        const std::vector<Answer> answers = ask(traced.scene(), rays, Coherence::Incoherent);
        const std::vector<uint8_t> blocked =
            askBlocked(traced.scene(), rays, Coherence::Incoherent);
        for (const Scene* scene : {&traced.scene(), &traced.wideScene()})
            for (const Coherence coherence : {Coherence::Coherent, Coherence::Incoherent}) {
                EXPECT_TRUE(same(ask(*scene, rays, coherence), answers));
                EXPECT_EQ(askBlocked(*scene, rays, coherence), blocked);
            }
    }
}

} // namespace
} // namespace smart
