// SPDX-License-Identifier: MIT
#include "libsmart/render/frame_shading.h"

#include <gtest/gtest.h>

#include "libsmart/geometry/model_builder.h"
#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {
namespace {

ModelPtr modelWith(std::vector<uint32_t> shaders, std::vector<Instance> children = {}) {
    ModelBuilder builder;
    if (!shaders.empty()) {
        builder.triangles = rectangle(0, 0, 1, 1, 0);
        builder.shading.slots.assign(builder.triangles.size(), 0);
        builder.shading.slots.back() = uint32_t(shaders.size() - 1);
        builder.shading.shaders = std::move(shaders);
    }
    builder.children = std::move(children);
    return std::move(builder).build();
}

Instance replaced(ModelPtr model, std::vector<std::pair<uint32_t, uint32_t>> pairs) {
    Instance instance = place(std::move(model));
    auto replacement = std::make_shared<ShaderReplacement>();
    replacement->pairs = std::move(pairs);
    instance.replacement = std::move(replacement);
    return instance;
}

using Indices = std::vector<uint32_t>;

TEST(FrameShading, ShadersInUseAreThoseAfterReplacement) {
    EXPECT_EQ(usedShaders(*makeScene({})), Indices());
    EXPECT_EQ(usedShaders(*makeScene({place(makeModel(rectangle(0, 0, 1, 1, 0)))})), Indices{0});
    const ModelPtr leaf = modelWith({5, 2});
    EXPECT_EQ(usedShaders(*makeScene({place(leaf), place(leaf)})), (Indices{2, 5}));
    EXPECT_EQ(usedShaders(*makeScene({placeWithShader(leaf, 9)})), Indices{9});
    EXPECT_EQ(usedShaders(*makeScene({replaced(leaf, {{2, 7}, {7, 8}})})), (Indices{5, 7}));
    // Replaced below and above: from the innermost outward.
    const ModelPtr nest = modelWith({3}, {replaced(leaf, {{5, 6}}), place(leaf)});
    EXPECT_EQ(usedShaders(*makeScene({place(nest)})), (Indices{2, 3, 5, 6}));
    EXPECT_EQ(usedShaders(*makeScene({replaced(nest, {{6, 1}, {3, 2}})})), (Indices{1, 2, 5}));
    // An object of children only has no shader of its own.
    EXPECT_EQ(usedShaders(*makeScene({place(modelWith({}, {placeWithShader(leaf, 4)}))})),
              Indices{4});
}

struct Veil {
    int opaque = -1; ///< -1: does not say
};

std::shared_ptr<const ShaderObject> veil(int opaque) {
    RTshaderclass d{};
    d.kind = RT_SURFACE_SHADER;
    d.shade = [](const void*, RTSstate*) { return 0; };
    d.transparency = [](const void*, RTSstate*, float*) { return 0; };
    if (opaque >= 0) d.opaque = [](const void* b) { return functionOf<Veil>(b).opaque; };
    return makeShader(d, Veil{opaque});
}

TEST(FrameShading, OnlyShadersInUseThatDoNotPromiseOpacityLetLightPass) {
    const auto solid = makeSurface([](RTSstate*) { return 0; });
    const auto transparent = [&](const ShaderTable& shaders, uint32_t used) {
        const ScenePtr scene =
            makeScene({placeWithShader(makeModel(rectangle(0, 0, 1, 1, 0)), used)});
        return findFrameShading(*scene, shaders, {}).transparent;
    };
    const ShaderTable shaders{solid, veil(-1), veil(1), veil(0)};
    EXPECT_FALSE(transparent(shaders, 0));
    EXPECT_TRUE(transparent(shaders, 1));
    EXPECT_FALSE(transparent(shaders, 2));
    EXPECT_TRUE(transparent(shaders, 3));
}

TEST(FrameShading, TrianglesWithoutAShaderAreNoticed) {
    const ScenePtr scene = makeScene({placeWithShader(makeModel(rectangle(0, 0, 1, 1, 0)), 1)});
    EXPECT_TRUE(findFrameShading(*scene, {nullptr, veil(1)}, {}).complete);
    EXPECT_FALSE(findFrameShading(*scene, {veil(1), nullptr}, {}).complete);
    EXPECT_FALSE(findFrameShading(*scene, {}, {}).complete);
}

std::shared_ptr<const ShaderObject> splitLight(uint32_t samples) {
    RTshaderclass d{};
    d.kind = RT_LIGHT_SHADER;
    d.lightSamples = [](const void* b) { return RTuint(functionOf<uint32_t>(b)); };
    d.illuminateSample = [](const void*, RTSstate*, RTuint i, RTuint n, RTSlightsample* sample) {
        *sample = {{0, 0, 5}, 5, {float(i), float(n), 12}};
        return 1;
    };
    return makeShader(d, samples);
}

TEST(FrameShading, LightsAreSplitAndShareTheirRadiance) {
    const auto plain = makeLight([](const float*, RTSlightsample* sample) {
        *sample = {{0, 0, 1}, 1, {1, 1, 1}};
        return 1;
    });
    std::vector<RTSlightsample> seen;
    Picture picture(1, 1, makeScene({placeWithShader(makeModel(rectangle(-9, -9, 9, 9, -1)), 0)}),
                    {makeSurface([&](RTSstate* s) {
                        for (RTuint i = 0; i < rtsLightCount(s); ++i) {
                            RTSlightsample sample;
                            EXPECT_EQ(rtsIlluminate(s, i, &sample), 1);
                            seen.push_back(sample);
                        }
                        return 0;
                    })});
    picture.frame->lights = {splitLight(3), plain, splitLight(0), splitLight(0xFFFFFFFFu)};
    renderHere(picture);
    ASSERT_EQ(seen.size(), 3 + 1 + 1 + kMaxLightSamples);
    for (uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(seen[i].direction[2], 1.0f);
        EXPECT_FLOAT_EQ(seen[i].radiance[0], float(i) / 3);
        EXPECT_FLOAT_EQ(seen[i].radiance[1], 1.0f);
        EXPECT_FLOAT_EQ(seen[i].radiance[2], 4.0f);
    }
    EXPECT_EQ(seen[3].radiance[0], 1.0f);
    EXPECT_EQ(seen[4].radiance[2], 12.0f);
    EXPECT_FLOAT_EQ(seen[5].radiance[2], 12.0f / float(kMaxLightSamples));
}

} // namespace
} // namespace smart::test
