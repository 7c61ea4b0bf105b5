// SPDX-License-Identifier: MIT
// Shadows of fixed function, which are found for several packets at once: against geometry worked
// out in double, and against the same points one by one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "libsmart/render/tracers.h"
#include "tests/libsmart/render/shaded_scenes.h"
#include "tests/libsmart/shading/fixed_reference.h"

namespace smart::test {
namespace {

FixedState shadowedState() {
    FixedState state;
    state.ops.depthTest = true;
    FixedLighting& lighting = state.lighting;
    lighting.enabled = lighting.normalize = lighting.shadows = true;
    lighting.lights[0].enabled = true;
    lighting.lights[0].position = {0.3f, 0.2f, 1.0f, 0.0f};
    lighting.lights[0].diffuse = {0.6f, 0.5f, 0.1f, 1.0f};
    lighting.lights[3].enabled = true;
    lighting.lights[3].position = {0.0f, -0.2f, 4.0f, 1.0f};
    lighting.lights[3].diffuse = lighting.lights[3].specular = {0.2f, 0.3f, 0.8f, 1.0f};
    return state;
}

Instance stated(Instance instance, const FixedState& state) {
    instance.state = std::make_shared<const FixedState>(state);
    return instance;
}

TEST(FixedPackets, EachLightIsHiddenByItself) {
    constexpr uint32_t kSide = 64;
    const FixedState state = shadowedState();
    const double floor = -5.0, pane = 1.0, side = 0.6;
    const ModelPtr ground = makeModel(rectangle(-9, -9, 9, 9, float(floor)));
    const Instance instance = stated(place(ground), state);
    // Behind the eye: no camera ray sees it.
    const Instance blocker =
        place(makeModel(rectangle(-float(side), -float(side), float(side), float(side), 1.0f)));
    const Picture picture(kSide, kSide, makeScene({instance, blocker}),
                          {MadeShader("FixedFunction").make()});
    renderWith(tracerFor(picture.frame->shading()), picture);

    // How far a coordinate of the line from the floor to the light lies within the pane.
    const auto inside = [&](const FixedLight& light, const glm::dvec3& from) {
        const glm::dvec4 at(light.position);
        const glm::dvec3 way = glm::dvec3(at) - from * at.w;
        const glm::dvec3 crossing = from + way * ((pane - floor) / way.z);
        return side - std::max(std::fabs(crossing.x), std::fabs(crossing.y));
    };
    std::array<int, 4> seen{};
    double worst = 0, worstOfOther = 0;
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const std::size_t i = std::size_t(y) * kSide + x;
            ASSERT_EQ(picture.instances[i], 0u);
            const glm::dvec4 far =
                picture.frame->matrixCamera.inverse *
                glm::dvec4(2 * (x + 0.5) / kSide - 1, 2 * (y + 0.5) / kSide - 1, 1, 1);
            const glm::dvec3 point = glm::dvec3(far) * (floor / far.z);
            const double first = inside(state.lighting.lights[0], point);
            const double second = inside(state.lighting.lights[3], point);
            if (std::min(std::fabs(first), std::fabs(second)) < 1e-4) continue;
            ++seen[(first > 0 ? 1u : 0u) + (second > 0 ? 2u : 0u)];
            const Triangle& t = ground->triangles[picture.primitives[i]];
            const auto colorWith = [&](bool sun, bool lamp) {
                FixedState left = state;
                left.lighting.lights[0].enabled = sun;
                left.lighting.lights[3].enabled = lamp;
                glm::dmat3 corners;
                Vec4 colors[3];
                for (int k = 0; k < 3; ++k) {
                    const auto& corner = k == 0 ? t.v0 : k == 1 ? t.v1 : t.v2;
                    FixedVertex vertex;
                    vertex.position = corners[k] = {corner[0], corner[1], corner[2]};
                    colors[k] = referenceLighting(left, vertex, false).primary;
                }
                const glm::dvec3 w = glm::inverse(corners) * point;
                glm::dvec3 color(0.0);
                for (int k = 0; k < 3; ++k)
                    for (int c = 0; c < 3; ++c) color[c] += w[k] * colors[k][std::size_t(c)];
                return color;
            };
            const glm::dvec3 found(picture.pixels[i]);
            const auto errorOf = [&](const glm::dvec3& truth) {
                const glm::dvec3 off = glm::abs(found - truth);
                return std::max({off.x, off.y, off.z});
            };
            worst = std::max(worst, errorOf(colorWith(first < 0, second < 0)));
            worstOfOther = std::max(worstOfOther, errorOf(colorWith(second < 0, first < 0)));
        }
    for (const int pixels : seen) EXPECT_GT(pixels, 30);
    EXPECT_LT(worst, 2e-5);
    EXPECT_GT(worstOfOther, 1e-2); // lights mixed up are seen
}

/// Spheres with a state each, one nested in another, small triangles and large ones.
Picture spheres(const std::function<void(FixedState&, int)>& change) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place01(-1.0, 1.0);
    const auto state = [&](int i) {
        FixedState made = shadowedState();
        if (i % 2 == 1) made.lighting.lights[3].position = {-2.0f, 3.0f, 0.0f, 1.0f};
        change(made, i);
        return made;
    };
    const ModelPtr ball = makeModel(icosphere(3));
    const ModelPtr pair = makeModel(
        icosphere(1), {place(ball, glm::dmat4x3(glm::scale(
                                       glm::translate(glm::dmat4(1.0), glm::dvec3(0.9, 0.7, 0.8)),
                                       glm::dvec3(0.4))))});
    auto materials = std::make_shared<FixedMaterials>();
    materials->front.specular = {0.5f, 0.4f, 0.3f, 1.0f};
    materials->front.shininess = 12.0f;
    materials->front.reflection = 0.3f;
    std::vector<Instance> instances{
        stated(place(makeModel(rectangle(-9, -9, 9, 9, -9))), state(0))};
    for (int i = 1; i < 9; ++i) {
        glm::dmat4 m = glm::translate(glm::dmat4(1.0), glm::dvec3(2.5 * place01(random),
                                                                  2.5 * place01(random),
                                                                  -6.0 + place01(random)));
        m = glm::rotate(m, 1.0 * i, glm::dvec3(1, 2, i));
        m = glm::scale(m, glm::dvec3(0.7, 0.5 + 0.1 * i, 0.6));
        instances.push_back(stated(place(i % 3 == 0 ? pair : ball, glm::dmat4x3(m)), state(i)));
        instances.back().inherited.materials = materials;
        instances.back().inherited.color = {0.8f, 0.4f, 0.2f, 0.6f};
    }
    Picture picture(61, 43, makeScene(std::move(instances)),
                    {MadeShader("FixedFunction").make()});
    picture.frame->clearColor = {0.1f, 0.2f, 0.3f, 1.0f};
    return picture;
}

void expectSame(const std::function<void(FixedState&, int)>& change,
                const std::function<void(Frame&)>& alter = [](Frame&) {}) {
    Picture points = spheres(change);
    alter(*points.frame);
    const RenderStatistics counts = renderWith(PacketTracer(ShadingForm::Points), points);
    EXPECT_GT(counts.shadowRays, 500u);
    for (const bool compiled : {false, true}) {
        Picture packets = spheres(change);
        alter(*packets.frame);
        const RenderStatistics found =
            compiled ? renderWith(tracerFor(packets.frame->shading()), packets)
                     : renderWith(PacketTracer(ShadingForm::Packets), packets);
        EXPECT_EQ(differingPixels(points, packets), 0u);
        EXPECT_EQ(found.shadowRays, counts.shadowRays);
        EXPECT_EQ(found.secondaryRays, counts.secondaryRays);
    }
    Picture other = spheres([&](FixedState& state, int i) {
        change(state, i);
        if (i == 4) state.lighting.lights[3].position.x += 0.5f;
    });
    alter(*other.frame);
    renderWith(PacketTracer(ShadingForm::Packets), other);
    EXPECT_GT(differingPixels(points, other), 0u);
}

TEST(FixedPackets, SmoothIsAsPointByPoint) {
    expectSame([](FixedState&, int) {});
}
TEST(FixedPackets, SamplesWithoutNormalsAreAsPointByPoint) {
    expectSame([](FixedState&, int) {},
               [](Frame& frame) {
                   frame.samples = 3;
                   frame.target.aux.normal = nullptr;
               });
}
TEST(FixedPackets, ShadeModelsAreAsPointByPoint) {
    expectSame([](FixedState& state, int i) {
        state.lighting.shadeModel = i % 2 == 0 ? ShadeModel::Flat : ShadeModel::Phong;
    });
}
TEST(FixedPackets, SidesFogAndSecondaryColoursAreAsPointByPoint) {
    expectSame([](FixedState& state, int i) {
        state.lighting.twoSided = i % 2 == 0;
        state.raster.frontFaceClockwise = i % 3 == 0;
        state.lighting.separateSpecular = state.lighting.localViewer = true;
        state.lighting.lights[0].spotCutoff = 180.0f;
        state.lighting.lights[3].spotCutoff = 60.0f;
        state.lighting.lights[3].spotDirection = {0.0f, 0.1f, -1.0f};
        state.lighting.lights[3].quadraticAttenuation = 0.05f;
        state.fog.enabled = true;
        state.fog.color = {0.5f, 0.6f, 0.7f, 1.0f};
        state.fog.density = 0.05f;
    });
}
TEST(FixedPackets, WhatIsBlendedLetsLightPassAsPointByPoint) {
    expectSame([](FixedState& state, int i) {
        if (i % 3 != 1) return;
        state.ops.blend = true;
        state.ops.sourceRgb = BlendFactor::SourceAlpha;
        state.ops.destinationRgb = BlendFactor::OneMinusSourceAlpha;
    });
}
TEST(FixedPackets, MirrorsAndWhatCastsNoShadowsAreAsPointByPoint) {
    expectSame([](FixedState& state, int i) {
        state.lighting.reflections = i % 4 == 1;
        state.lighting.shadows = i % 4 != 2;
    });
}

} // namespace
} // namespace smart::test
