// SPDX-License-Identifier: MIT
#include "libsmart/render/packet_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "libsmart/render/sampling.h"
#include "libsmart/scene/query.h"
#include "tests/libsmart/render/picture_scene.h"
#include "tests/support/kernel_runs.h"

namespace smart::test {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();

std::shared_ptr<const ShaderObject> positionShader() {
    return makeSurface([](RTSstate* s) {
        rtsResultColor(s, s->position[0], s->position[1], s->position[2]);
        return 0;
    });
}

TEST(PacketTracer, WallAgainstItsProjection) {
    // A wall of 4 x 3 at distance 5, seen in part; the picture no multiple of a packet.
    constexpr uint32_t kWidth = 75, kHeight = 53;
    Instance wall = placeWithShader(makeModel(rectangle(-2, -1, 2, 2, -5)), 0);
    wall.objectId = 17;
    Picture picture(kWidth, kHeight, makeScene({wall}), {positionShader()});
    const double near = 0.5, far = 20.0;
    picture.frame->matrixCamera = cameraOf(glm::frustum(-0.4, 0.4, -0.3, 0.3, near, far));
    picture.frame->clearColor = {0.1f, 0.2f, 0.3f, 0.4f};
    const RenderStatistics counted = renderHere(picture);
    EXPECT_EQ(counted.primaryRays, uint64_t(kWidth) * kHeight);
    EXPECT_EQ(counted.badPixels, 0u);
    int hits = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const glm::dvec3 d(-0.4 + 0.8 * (x + 0.5) / kWidth, -0.3 + 0.6 * (y + 0.5) / kHeight,
                               -near);
            const glm::dvec3 p = d * (5.0 / near);
            const std::size_t i = std::size_t(y) * kWidth + x;
            if (std::abs(p.x) < 2 && p.y > -1 && p.y < 2) {
                ++hits;
                EXPECT_NEAR(picture.at(x, y).r, p.x, 1e-5);
                EXPECT_NEAR(picture.at(x, y).g, p.y, 1e-5);
                EXPECT_EQ(picture.at(x, y).b, -5.0f);
                EXPECT_EQ(picture.at(x, y).a, 1.0f);
                EXPECT_NEAR(picture.distance[i], glm::length(p), 1e-5);
                EXPECT_NEAR(picture.depth[i], far * (5 - near) / (5 * (far - near)), 1e-6);
                EXPECT_EQ(picture.normals[i], glm::vec3(0, 0, 1));
                EXPECT_EQ(picture.objects[i], 17u);
                EXPECT_EQ(picture.instances[i], 0u);
                // The wall's diagonal from (-2, -1) to (2, 2) parts its triangles.
                if (std::abs((p.y + 1) - (p.x + 2) * 0.75) > 1e-4) {
                    EXPECT_EQ(picture.primitives[i], (p.y + 1) < (p.x + 2) * 0.75 ? 0u : 1u);
                }
            } else {
                EXPECT_EQ(picture.at(x, y), glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
                EXPECT_EQ(picture.distance[i], kInf);
                EXPECT_EQ(picture.depth[i], 1.0f);
                EXPECT_EQ(picture.normals[i], glm::vec3(0));
                EXPECT_EQ(picture.objects[i], kNoId);
                EXPECT_EQ(picture.instances[i], kNoId);
                EXPECT_EQ(picture.primitives[i], kNoId);
            }
        }
    EXPECT_GT(hits, 900);
    EXPECT_LT(hits, int(kWidth * kHeight));
}

TEST(PacketTracer, OutsideTheViewportIsTheClearColour) {
    Picture picture(64, 40, makeScene({placeWithShader(makeModel(rectangle(-9, -9, 9, 9, -2)), 0)}),
                    {makeSurface([](RTSstate* s) {
                        rtsResultColor(s, 1, 1, 1);
                        return 0;
                    })});
    picture.frame->clearColor = {0.0f, 0.5f, 0.0f, 0.0f};
    picture.frame->environment = makeEnvironment([](RTSstate*) { return 0; });
    picture.frame->viewport = {-5, 7, 26, 18};
    EXPECT_EQ(renderHere(picture).primaryRays, 21u * 18u);
    for (uint32_t y = 0; y < 40; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const bool inside = x < 21 && y >= 7 && y < 25;
            EXPECT_EQ(picture.at(x, y), inside ? glm::vec4(1) : picture.frame->clearColor);
        }
    picture.frame->viewport = {0, 0, 0, 0};
    EXPECT_EQ(renderHere(picture).primaryRays, 0u);
    EXPECT_EQ(picture.at(3, 10), picture.frame->clearColor);
}

TEST(PacketTracer, BadPixelsAreBlackAndCountedOnceEach) {
    for (const uint32_t samples : {1u, 4u}) {
        Picture picture(48, 48,
                        makeScene({placeWithShader(makeModel(rectangle(-9, -9, 9, 9, -2)), 0)}),
                        {makeSurface([](RTSstate* s) {
                            const bool bad = s->pixel[0] < 10 && s->pixel[1] < 20;
                            rtsResultColor(s, bad ? std::nanf("") : 0.5f, 0.5f, 0.5f);
                            return 0;
                        })});
        picture.frame->samples = samples;
        const RenderStatistics counted = renderHere(picture);
        EXPECT_EQ(counted.badPixels, 200u);
        EXPECT_EQ(counted.primaryRays, 48u * 48u * samples);
        for (uint32_t y = 0; y < 48; ++y)
            for (uint32_t x = 0; x < 48; ++x)
                EXPECT_EQ(picture.at(x, y), x < 10 && y < 20 ? glm::vec4(0, 0, 0, 1)
                                                             : glm::vec4(0.5f, 0.5f, 0.5f, 1));
    }
}

TEST(PacketTracer, FailingCameraShaderCostsItsPixels) {
    Picture picture(40, 40, makeScene({}), {});
    picture.frame->clearColor = glm::vec4(0.25f);
    picture.frame->camera = makeCamera([](float x, float y, RTScameraray* ray) {
        *ray = {{x, y, 0}, {0, 0, -1}, 0, kInf, nullptr};
        return x < 0.5f ? 0 : 1;
    });
    EXPECT_EQ(renderHere(picture).badPixels, 800u);
    EXPECT_EQ(picture.at(19, 5), glm::vec4(0.25f));
    EXPECT_EQ(picture.at(20, 5), glm::vec4(0, 0, 0, 1));
}

TEST(PacketTracer, SamplesAreAveragedOverThePixel) {
    // Colour is linear in the position: the mean is that of the sample positions.
    constexpr uint32_t kSamples = 16;
    Picture picture(24, 24, makeScene({placeWithShader(makeModel(rectangle(-9, -9, 9, 9, -1)), 0)}),
                    {positionShader()});
    picture.frame->matrixCamera = cameraOf(glm::ortho(0.0, 24.0, 0.0, 24.0, 0.5, 2.0));
    picture.frame->scene =
        makeScene({placeWithShader(makeModel(rectangle(-1, -1, 25, 25, -1)), 0)});
    picture.frame->samples = kSamples;
    picture.frame->seed = 5;
    renderHere(picture);
    for (uint32_t y = 0; y < 24; ++y)
        for (uint32_t x = 0; x < 24; ++x) {
            glm::dvec2 mean(0.0);
            for (uint32_t i = 0; i < kSamples; ++i)
                mean += glm::dvec2(samplePosition(x, y, 5, i, kSamples)) / double(kSamples);
            EXPECT_NEAR(picture.at(x, y).r, x + mean.x, 1e-4);
            EXPECT_NEAR(picture.at(x, y).g, y + mean.y, 1e-4);
        }
}

/// Shadows, mirrors and random numbers over a body with many triangles.
Picture busyPicture(Precision precision) {
    const auto shade = [](RTSstate* s) {
        float direction[3], radiance[3], left[3];
        rtsReflectedDirection(s, direction);
        rtsTraceRay(s, s->position, direction, s->weight * 0.5f, radiance);
        const float light[3] = {0.5f, 1.0f, 0.25f};
        rtsShadow(s, s->position, light, 100.0f, left);
        const float noise = s->functions->random(s);
        rtsResultColor(s, 0.5f * radiance[0] + left[0], s->shadingNormal[1] + noise, noise);
        return 0;
    };
    const ModelPtr body = makeModel(icosphere(4)), floor = makeModel(rectangle(-6, -6, 6, 6, 0));
    const glm::dmat4 one(1.0);
    std::vector<Instance> instances;
    for (int i = -1; i <= 1; ++i) {
        glm::dmat4 m = glm::translate(one, glm::dvec3(1.7 * i, 0.3 * i, -6.0));
        m = glm::rotate(m, 0.3 + i, glm::dvec3(1, 2, i));
        m = glm::scale(m, glm::dvec3(1.0, 0.7 + 0.2 * i, 0.9));
        instances.push_back(placeWithShader(body, uint32_t(i + 1) % 2, glm::dmat4x3(m)));
    }
    const glm::dmat4 flat =
        glm::rotate(glm::translate(one, glm::dvec3(0, -1.2, -6)), -1.5707, glm::dvec3(1, 0, 0));
    instances.push_back(placeWithShader(floor, 1, glm::dmat4x3(flat)));
    Picture picture(150, 90, makeScene(std::move(instances), precision),
                    {makeSurface(shade), makeSurface(shade)});
    picture.frame->environment = makeEnvironment([](RTSstate* s) {
        rtsResultColor(s, s->rayDirection[0], s->rayDirection[1], 1);
        return 0;
    });
    picture.frame->samples = 2;
    return picture;
}

TEST(PacketTracer, TheSameBitsOnEveryInstructionSet) {
    const std::string before = kernels().name;
    for (const Precision precision : {Precision::Fast, Precision::Watertight}) {
        std::vector<glm::vec4> first;
        for (const KernelTable* table : availableKernels()) {
            ASSERT_TRUE(selectKernels(table->name));
            const Picture picture = busyPicture(precision);
            const RenderStatistics counted = renderHere(picture);
            EXPECT_GT(counted.secondaryRays, 1000u);
            EXPECT_GT(counted.shadowRays, 1000u);
            EXPECT_EQ(counted.badPixels, 0u);
            if (first.empty()) first = picture.pixels;
            EXPECT_EQ(
                std::memcmp(first.data(), picture.pixels.data(), first.size() * sizeof first[0]), 0)
                << table->name;
        }
    }
    selectKernels(before.c_str());
}

TEST(PacketTracer, TheSeedChangesThePicture) {
    const Picture a = busyPicture(Precision::Watertight), b = busyPicture(Precision::Watertight);
    b.frame->seed = 1;
    renderHere(a);
    renderHere(b);
    EXPECT_NE(a.pixels, b.pixels);
}

} // namespace
} // namespace smart::test
