// SPDX-License-Identifier: MIT
#include "libsmart/render/shading_services.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Shade constant(float r, float g, float b) {
    return [=](RTSstate* s) {
        rtsResultColor(s, r, g, b);
        return 0;
    };
}

/// A floor at z = 0, 20 x 20, and what is put above it; a single ray down the z axis from 10.
struct Stage {
    std::vector<Instance> instances;
    ShaderTable shaders;
    Frame frame;
    TilePixels counts;

    explicit Stage(Shade floor) {
        add(rectangle(-10, -10, 10, 10, 0), makeSurface(std::move(floor)));
    }
    void add(std::vector<Triangle> triangles, std::shared_ptr<const ShaderObject> shader) {
        instances.push_back(
            placeWithShader(makeModel(std::move(triangles)), uint32_t(shaders.size())));
        shaders.push_back(std::move(shader));
    }
    ShadedSample look(glm::vec3 from = {0.5f, 0.25f, 10.0f}, glm::vec3 along = {0, 0, -1}) {
        Frame frozen; // a frame does not change once it is asked: each look is another one
        frozen.scene = makeScene(instances);
        frozen.shaders = std::make_shared<const ShaderTable>(shaders);
        frozen.textures = frame.textures;
        frozen.lights = frame.lights;
        frozen.environment = frame.environment;
        frozen.clearColor = frame.clearColor;
        frozen.recursionLimit = frame.recursionLimit;
        frozen.weightCutoff = frame.weightCutoff;
        ShadingServices services(frozen, counts);
        PixelSample sample(0, 0, 0, 0);
        return services.traceCameraRay(
            {{from.x, from.y, from.z}, {along.x, along.y, along.z}, 0.0f, kInf}, {&sample});
    }
};

TEST(ShadingServices, SurfaceSeesTheHit) {
    RTSstate seen{};
    Stage stage([&](RTSstate* s) {
        seen = *s;
        return constant(1, 2, 3)(s);
    });
    const ShadedSample sample = stage.look();
    EXPECT_EQ(sample.color, glm::vec4(1, 2, 3, 1));
    EXPECT_EQ(sample.distance, 10.0f);
    EXPECT_EQ(sample.normal, glm::vec3(0, 0, 1));
    // The weights are floats: half a unit of them, times the side of 20.
    EXPECT_NEAR(seen.position[0], 0.5f, 2e-6f);
    EXPECT_NEAR(seen.position[1], 0.25f, 2e-6f);
    EXPECT_EQ(seen.position[2], 0.0f);
    EXPECT_EQ(seen.depth, 0u);
    EXPECT_EQ(seen.weight, 1.0f);
    EXPECT_EQ(seen.rayDistance, 10.0f);
    EXPECT_EQ(seen.frontFace, 1u);
    EXPECT_EQ(seen.functions->structSize, sizeof(RTSfunctions));
    EXPECT_EQ(stage.counts.primaryRays, 1u);
}

TEST(ShadingServices, RecursionLimitStopsEndlessMirrors) {
    // Two mirrors face each other; each adds 1 to what it sees.
    const Shade mirror = [](RTSstate* s) {
        float direction[3], radiance[3];
        rtsReflectedDirection(s, direction);
        rtsTraceRay(s, s->position, direction, 1.0f, radiance);
        rtsResultColor(s, radiance[0] + 1.0f, 0, 0);
        return 0;
    };
    for (const uint32_t limit : {0u, 1u, 8u, 50u, 4000000000u}) {
        Stage stage(mirror);
        stage.add(rectangle(-10, -10, 10, 10, 20), makeSurface(mirror));
        stage.frame.recursionLimit = limit;
        const uint32_t generations = std::min(limit, kMaxRecursion);
        EXPECT_EQ(stage.look().color.r, float(generations + 1));
        EXPECT_EQ(stage.counts.secondaryRays, generations);
    }
}

TEST(ShadingServices, WeightCutOffStopsRaysThatDoNotCount) {
    std::vector<float> weights;
    const Shade mirror = [&](RTSstate* s) {
        weights.push_back(s->weight);
        float up[3] = {0, 0, s->position[2] < 10.0f ? 1.0f : -1.0f}, radiance[3];
        const int traced = rtsTraceRay(s, s->position, up, s->weight * 0.25f, radiance);
        rtsResultColor(s, 1.0f + radiance[0], float(traced), 0);
        return 0;
    };
    Stage stage(mirror);
    stage.add(rectangle(-10, -10, 10, 10, 20), makeSurface(mirror));
    stage.frame.weightCutoff = 1.0f / 100.0f;
    EXPECT_EQ(stage.look().color.r, 4.0f); // 1, 1/4, 1/16, 1/64; 1/256 is too little
    EXPECT_EQ(weights, (std::vector<float>{1.0f, 0.25f, 0.0625f, 0.015625f}));

    // A share grows never: a mirror that claims all of the pixel gets what its own ray had.
    Stage lazy([](RTSstate* s) {
        float up[3] = {0, 0, 1}, radiance[3];
        EXPECT_EQ(rtsTraceRay(s, s->position, up, kNan, radiance), 0);
        EXPECT_EQ(rtsTraceRay(s, s->position, up, -1.0f, radiance), 0);
        EXPECT_EQ(rtsTraceRay(s, s->position, up, 5.0f, radiance), 1);
        return 0;
    });
    lazy.add(rectangle(-10, -10, 10, 10, 20), makeSurface([](RTSstate* s) {
                 EXPECT_EQ(s->weight, 1.0f);
                 return 0;
             }));
    lazy.look();
    EXPECT_EQ(lazy.counts.secondaryRays, 1u);
}

TEST(ShadingServices, FaultsMakeThePixelBlackAndBad) {
    const struct {
        Shade shade;
        bool bad, badInMirror;
    } cases[] = {
        {constant(1, 1, 1), false, false},
        {constant(1, kNan, 1), true, true},
        {constant(kInf, 1, 1), true, true},
        {[](RTSstate* s) { return constant(1, 1, 1)(s), 5; }, true, true},
        {[](RTSstate* s) { return s->result[3] = kNan, 0; }, true, false}, // alpha is not traced
        {[](RTSstate*) { return 0; }, false, false}, // nothing set: black, and fine
    };
    for (const auto& [shade, bad, badInMirror] : cases) {
        const ShadedSample direct = Stage(shade).look();
        EXPECT_EQ(direct.bad, bad);
        if (bad) {
            EXPECT_EQ(direct.color, glm::vec4(0, 0, 0, 1));
        }
        // Seen through a mirror as well.
        Stage stage([](RTSstate* s) {
            float up[3] = {0, 0, 1}, radiance[3];
            rtsTraceRay(s, s->position, up, 1.0f, radiance);
            rtsResultColor(s, radiance[0], radiance[1], radiance[2]);
            return 0;
        });
        stage.add(rectangle(-10, -10, 10, 10, 20), makeSurface(shade));
        EXPECT_EQ(stage.look().bad, badInMirror);
    }
    Stage none(constant(1, 1, 1));
    none.shaders[0] = nullptr;
    EXPECT_TRUE(none.look().bad);
    Stage other(constant(1, 1, 1));
    other.shaders[0] = makeEnvironment(constant(1, 1, 1)); // no surface
    EXPECT_TRUE(other.look().bad);
}

/// The floor's shadow towards a light straight above at a distance.
Shade shadowUp(float distance) {
    return [=](RTSstate* s) {
        const float up[3] = {0, 0, 1};
        float left[3];
        EXPECT_EQ(rtsShadow(s, s->position, up, distance, left), 1);
        rtsResultColor(s, left[0], left[1], left[2]);
        return 0;
    };
}

TEST(ShadingServices, OpaqueShadowsEndAtTheLight) {
    for (const float distance : {1.0f, 2.99f, 3.0f, 3.01f, 100.0f, kInf}) {
        Stage stage(shadowUp(distance));
        stage.add(rectangle(-1, -1, 1, 1, 3), makeSurface(constant(9, 9, 9)));
        const bool lit = distance <= 3.0f; // the light may lie in a surface of its own
        EXPECT_EQ(stage.look({0.5f, 0.25f, 2.0f}).color.r, lit ? 1.0f : 0.0f) << distance;
        EXPECT_EQ(stage.counts.shadowRays, 1u);
    }
    EXPECT_EQ(Stage(shadowUp(0.0f)).look().color.r, 1.0f);
    EXPECT_EQ(Stage(shadowUp(-1.0f)).look().color.r, 1.0f);
    EXPECT_EQ(Stage(shadowUp(kNan)).look().color.r, 1.0f);
}

TEST(ShadingServices, TransparentShadowsMultiply) {
    const auto glass = [](float r, float g, float b) {
        return makeTransparentSurface(constant(0, 0, 0), [=](RTSstate* s, float* rgb) {
            // Nothing may be traced from here: it could go on for ever.
            float radiance[3], left[3];
            RTShitinfo hit;
            const float up[3] = {0, 0, 1};
            EXPECT_EQ(rtsTraceRay(s, s->position, up, 1.0f, radiance), 0);
            EXPECT_EQ(rtsShadow(s, s->position, up, 1.0f, left), 0);
            EXPECT_EQ(rtsTraceHit(s, s->position, up, &hit), 0);
            EXPECT_EQ(s->depth, 1u);
            rgb[0] = r, rgb[1] = g, rgb[2] = b;
            return 0;
        });
    };
    Stage stage(shadowUp(100.0f));
    stage.add(rectangle(-1, -1, 1, 1, 3), glass(0.5f, 0.25f, 1.0f));
    EXPECT_EQ(stage.look({0.5f, 0.25f, 2.0f}).color, glm::vec4(0.5f, 0.25f, 1.0f, 1));
    stage.add(rectangle(-1, -1, 1, 1, 4), glass(0.5f, 3.0f, -1.0f)); // clamped to 0..1
    EXPECT_EQ(stage.look({0.5f, 0.25f, 2.0f}).color, glm::vec4(0.25f, 0.25f, 0.0f, 1));
    stage.add(rectangle(-1, -1, 1, 1, 5), makeSurface(constant(1, 1, 1))); // opaque
    EXPECT_EQ(stage.look({0.5f, 0.25f, 2.0f}).color, glm::vec4(0, 0, 0, 1));

    // Behind the light nothing counts.
    Stage near(shadowUp(3.5f));
    near.add(rectangle(-1, -1, 1, 1, 3), glass(0.5f, 0.25f, 1.0f));
    near.add(rectangle(-1, -1, 1, 1, 4), makeSurface(constant(1, 1, 1)));
    EXPECT_EQ(near.look({0.5f, 0.25f, 2.0f}).color, glm::vec4(0.5f, 0.25f, 1.0f, 1));

    Stage broken(shadowUp(100.0f));
    broken.add(rectangle(-1, -1, 1, 1, 3),
               makeTransparentSurface(constant(0, 0, 0), [](RTSstate*, float*) { return 1; }));
    EXPECT_TRUE(broken.look({0.5f, 0.25f, 2.0f}).bad);
}

TEST(ShadingServices, TransparentShadowsPassABoundedNumberOfSurfaces) {
    Stage stage(shadowUp(kInf));
    std::vector<Triangle> many;
    for (int i = 0; i < 1000; ++i)
        for (const Triangle& triangle : rectangle(-1, -1, 1, 1, 3.0f + float(i)))
            many.push_back(triangle);
    stage.add(many, makeTransparentSurface(constant(0, 0, 0), [](RTSstate*, float* rgb) {
                  rgb[0] = rgb[1] = rgb[2] = 1.0f;
                  return 0;
              }));
    EXPECT_EQ(stage.look({0.5f, 0.25f, 2.0f}).color.r, 0.0f);
    EXPECT_LE(stage.counts.shadowRays, 256u);
}

TEST(ShadingServices, HitsWithoutShading) {
    RTShitinfo up{}, down{};
    Stage stage([&](RTSstate* s) {
        const float above[3] = {0, 0, 2}, below[3] = {0, 0, -2}; // need not have length 1
        EXPECT_EQ(rtsTraceHit(s, s->position, above, &up), 1);
        EXPECT_EQ(rtsTraceHit(s, s->position, below, &down), 1);
        return 0;
    });
    stage.frame.recursionLimit = 0;
    stage.add(rectangle(-1, -1, 1, 1, 3), makeSurface([](RTSstate*) -> int {
                  ADD_FAILURE() << "shaded";
                  return 0;
              }));
    stage.instances[1].objectId = 42;
    stage.look({0.5f, 0.25f, 2.0f});
    EXPECT_NEAR(up.distance, 3.0f, 1e-5f);
    EXPECT_NEAR(up.position[2], 3.0f, 1e-6f);
    EXPECT_EQ(up.normal[2], 1.0f);
    EXPECT_EQ(up.object, 42u);
    EXPECT_EQ(up.instance, 1u);
    EXPECT_EQ(down.distance, kInf);
    EXPECT_EQ(down.object, kNoId);
    EXPECT_EQ(stage.counts.secondaryRays, 2u);
}

TEST(ShadingServices, StoppedPointsSendNoRays) {
    Stage stage([](RTSstate* s) {
        const float up[3] = {0, 0, 1};
        float before[3], after[3], left[3];
        RTShitinfo hit;
        EXPECT_EQ(rtsTraceRay(s, s->position, up, 1.0f, before), 1);
        EXPECT_EQ(before[0], 7.0f);
        rtsStopRayRecursion(s);
        EXPECT_EQ(rtsTraceRay(s, s->position, up, 1.0f, after), 0);
        EXPECT_EQ(after[0], 0.0f);
        EXPECT_EQ(rtsTraceHit(s, s->position, up, &hit), 0);
        EXPECT_EQ(hit.distance, kInf);
        EXPECT_EQ(rtsShadow(s, s->position, up, 1.0f, left), 0);
        EXPECT_EQ(left[0], 0.0f);
        return 0;
    });
    stage.add(rectangle(-1, -1, 1, 1, 3), makeSurface([](RTSstate* s) {
                  EXPECT_EQ(s->flags, 0u);
                  return constant(7, 7, 7)(s);
              }));
    EXPECT_FALSE(stage.look({0.5f, 0.25f, 2.0f}).bad);
    EXPECT_EQ(stage.counts.secondaryRays, 1u);
}

TEST(ShadingServices, LightsAnswerWithAUnitDirectionOrNotAtAll) {
    RTSlightsample samples[5];
    int answers[5];
    Stage stage([&](RTSstate* s) {
        EXPECT_EQ(rtsLightCount(s), 4u);
        for (RTuint i = 0; i < 5; ++i) answers[i] = rtsIlluminate(s, i, &samples[i]);
        return 0;
    });
    const auto light = [](float z, int answer) {
        return makeLight([=](const float position[3], RTSlightsample* sample) {
            *sample = {{0, 0, z - position[2]}, z, {1, 2, 3}};
            return answer;
        });
    };
    stage.frame.lights = {light(4, 1), light(4, 0), light(0, 1), light(-2, 1)};
    EXPECT_FALSE(stage.look().bad);
    EXPECT_EQ(answers[0], 1);
    EXPECT_EQ(samples[0].direction[2], 1.0f);
    EXPECT_EQ(samples[0].distance, 4.0f);
    EXPECT_EQ(samples[0].radiance[2], 3.0f);
    EXPECT_EQ(answers[1], 0);
    EXPECT_EQ(answers[2], 0); // the light is at the point
    EXPECT_EQ(answers[3], 1);
    EXPECT_EQ(samples[3].direction[2], -1.0f);
    EXPECT_EQ(answers[4], 0); // there is none
    stage.frame.lights[1] = light(4, -1);
    EXPECT_TRUE(stage.look().bad);
}

TEST(ShadingServices, MissesSeeTheEnvironment) {
    Stage stage(constant(1, 1, 1));
    stage.frame.clearColor = {0.1f, 0.2f, 0.3f, 0.4f};
    const glm::vec3 from(0, 0, 5), up(0, 0, 1);
    EXPECT_EQ(stage.look(from, up).color, glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(stage.look(from, up).instance, kNoId);
    EXPECT_EQ(stage.look(from, up).distance, kInf);
    stage.frame.environment = makeEnvironment([](RTSstate* s) {
        EXPECT_EQ(s->rayDistance, kInf);
        rtsResultColor(s, s->rayDirection[2], 7, 8);
        s->result[3] = 0.5f;
        return 0;
    });
    EXPECT_EQ(stage.look(from, up).color, glm::vec4(1, 7, 8, 1));
    stage.frame.environment = makeEnvironment([](RTSstate*) { return 1; });
    EXPECT_TRUE(stage.look(from, up).bad);
    // One that asks the environment comes to an end.
    int calls = 0;
    stage.frame.environment = makeEnvironment([&](RTSstate* s) {
        ++calls;
        float radiance[3];
        s->functions->environment(s, s->rayDirection, radiance);
        rtsResultColor(s, radiance[0] + 1, 0, 0);
        return 0;
    });
    const float counted = stage.look(from, up).color.r;
    EXPECT_EQ(counted, float(calls));
    EXPECT_EQ(calls, 10); // the recursion limit of 8, and one each for the ray and the last
}

TEST(ShadingServices, UnknownTexturesAreWhite) {
    std::vector<std::byte> texels(4, std::byte{51});
    auto table = std::make_shared<TextureTable>(2);
    (*table)[1] =
        std::make_shared<const Texture>(1, 1, 4, TexelType::Byte, texels, TextureOptions{});
    Stage stage([](RTSstate* s) {
        float rgba[4];
        for (const RTuint unknown : {0u, 2u, 0xFFFFFFFFu}) {
            rtsTexture(s, unknown, 0.5f, 0.5f, rgba);
            EXPECT_EQ(rgba[0] + rgba[1] + rgba[2] + rgba[3], 4.0f);
        }
        rtsTexture(s, 1, 0.5f, 0.5f, rgba);
        rtsResultColor(s, rgba[0], rgba[1], rgba[2]);
        return 0;
    });
    stage.frame.textures = table;
    EXPECT_FLOAT_EQ(stage.look().color.r, 0.2f);
}

} // namespace
} // namespace smart::test
