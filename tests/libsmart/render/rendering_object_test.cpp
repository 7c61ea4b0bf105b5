// SPDX-License-Identifier: MIT
#include "libsmart/render/rendering_object.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/libsmart/render/picture_scene.h"

namespace smart::test {
namespace {

Picture makePicture(RenderPixel renderPixel) {
    Picture picture(
        40, 36,
        makeScene({placeWithShader(makeModel(icosphere(3)), 0,
                                   glm::dmat4x3(glm::translate(glm::dmat4(1.0), {0, 0, -3.0})))}),
        {makeSurface([](RTSstate* s) {
            rtsResultColor(s, s->position[0], s->position[1], s->shadingNormal[2]);
            return 0;
        })});
    picture.frame->clearColor = {0.5f, 0.25f, 0.125f, 0.75f};
    if (renderPixel) picture.frame->renderingObject = makeRenderingObject(std::move(renderPixel));
    return picture;
}

TEST(RenderingObject, OneRayThroughTheCentreIsTheDefaultPicture) {
    const Picture plain = makePicture({});
    const Picture object = makePicture([](RTSpixel* pixel, float* rgba) {
        EXPECT_EQ(pixel->structSize, sizeof(RTSpixel));
        EXPECT_EQ(pixel->samples, 1u);
        float xy[2];
        pixel->samplePosition(pixel, 0, 1, xy);
        pixel->trace(pixel, xy[0], xy[1], rgba);
        return 0;
    });
    const RenderStatistics a = renderHere(plain), b = renderHere(object);
    EXPECT_EQ(a.primaryRays, b.primaryRays);
    EXPECT_EQ(plain.pixels, object.pixels);
    EXPECT_EQ(plain.distance, object.distance);
    EXPECT_EQ(plain.depth, object.depth);
    EXPECT_EQ(plain.normals, object.normals);
    EXPECT_EQ(plain.primitives, object.primitives);
    EXPECT_NE(plain.primitives.front(), plain.primitives[18 * 40 + 20]); // there is a picture
}

TEST(RenderingObject, PixelsAreWhatTheObjectSays) {
    const Picture picture = makePicture([](RTSpixel* pixel, float* rgba) {
        rgba[0] = float(pixel->x);
        rgba[1] = float(pixel->y);
        rgba[2] = rtsLightCount(pixel->state) == 0 ? 1.0f : 0.0f;
        rgba[3] = pixel->state->functions->random(pixel->state);
        return 0;
    });
    picture.frame->viewport = {4, 0, 30, 36};
    EXPECT_EQ(renderHere(picture).primaryRays, 0u);
    EXPECT_EQ(picture.at(3, 5), picture.frame->clearColor);
    EXPECT_EQ(glm::vec3(picture.at(4, 5)), glm::vec3(4, 5, 1));
    EXPECT_NE(picture.at(4, 5).a, picture.at(5, 5).a);
    EXPECT_EQ(picture.instances[18 * 40 + 20], kNoId); // no ray was asked for
}

TEST(RenderingObject, VisitsWhatACameraRayMeetsWithoutShadingIt) {
    const auto look = [](RTSpixel* pixel, float* rgba) {
        RTSstate* state = pixel->visit(pixel, 0.5f, 0.5f);
        if (!state) return rgba[0] = -1.0f, 0;
        // Rays start there as in a surface shader: they leave the sphere.
        RTShitinfo behind;
        EXPECT_EQ(rtsTraceHit(state, state->position, state->geometricNormal, &behind), 1);
        EXPECT_EQ(behind.instance, 0xFFFFFFFFu);
        rgba[0] = state->position[0];
        rgba[1] = state->position[1];
        rgba[2] = state->shadingNormal[2];
        return 0;
    };
    const Picture plain = makePicture({}), visited = makePicture(look);
    EXPECT_EQ(renderHere(plain).primaryRays, renderHere(visited).primaryRays);
    EXPECT_EQ(plain.distance, visited.distance);
    EXPECT_EQ(plain.primitives, visited.primitives);
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
        if (plain.instances[i] == 0xFFFFFFFFu) {
            EXPECT_EQ(visited.pixels[i].r, -1.0f);
        } else {
            EXPECT_EQ(glm::vec3(plain.pixels[i]), glm::vec3(visited.pixels[i]));
        }
    }
}

TEST(RenderingObject, FlagsReachWhatTheRayGivesRiseTo) {
    const auto flagsSeen = [](RTuint flags) {
        Picture picture = makePicture([=](RTSpixel* pixel, float* rgba) {
            pixel->traceWith(pixel, 0.5f, 0.5f, flags, rgba);
            return 0;
        });
        const auto flagsOf = [](RTSstate* s) {
            float away[3] = {-s->rayDirection[0], -s->rayDirection[1], -s->rayDirection[2]};
            float radiance[3];
            rtsTraceRay(s, s->position, away, 1.0f, radiance);
            rtsResultColor(s, float(rtsIndirect(s)), radiance[1], 0);
            return 0;
        };
        picture.frame->shaders = std::make_shared<const ShaderTable>(
            ShaderTable{makeSurface(flagsOf)});
        picture.frame->environment = makeEnvironment([](RTSstate* s) {
            rtsResultColor(s, 0, 1 + float(rtsIndirect(s)), 0);
            return 0;
        });
        renderHere(picture);
        return glm::vec2(picture.at(20, 18));
    };
    EXPECT_EQ(flagsSeen(0), glm::vec2(0, 1));
    EXPECT_EQ(flagsSeen(RTS_INDIRECT), glm::vec2(1, 2));
    EXPECT_EQ(flagsSeen(RTS_STOPPED), glm::vec2(0, 0)); // and no ray goes on
}

TEST(RenderingObject, CamerasDrawNumbersBeforeTheirRays) {
    // The camera's number is the first of its sample, the surface's the second; the neighbours
    // that the cone is taken from draw none.
    Picture picture = makePicture({});
    picture.frame->camera = makeCamera([](float x, float y, RTScameraray* ray) {
        const float number = rtsRandom(ray->state);
        // Of the pixel itself, or of a neighbour's ray that belongs to it.
        EXPECT_NEAR(float(ray->state->pixel[0]) + 1.0f, x * 40, 0.51f);
        EXPECT_NEAR(float(ray->state->pixel[1]) + 1.0f, y * 36, 0.51f);
        EXPECT_EQ(ray->state->instance, 0xFFFFFFFFu);
        ray->origin[2] = number;
        ray->direction[2] = -1.0f;
        return 0;
    });
    picture.frame->shaders = std::make_shared<const ShaderTable>(
        ShaderTable{makeSurface([](RTSstate* s) {
            rtsResultColor(s, s->rayOrigin[2], rtsRandom(s), 0);
            return 0;
        })});
    renderHere(picture);
    for (uint32_t y = 0; y < 36; ++y)
        for (uint32_t x = 0; x < 40; ++x) {
            RandomStream numbers(x, y, 0, 0);
            const float first = numbers.next(), second = numbers.next();
            ASSERT_EQ(glm::vec2(picture.at(x, y)), glm::vec2(first, second));
        }
}

TEST(RenderingObject, FaultsCostOnePixelEach) {
    const auto badPixels = [](RenderPixel object) {
        const Picture picture = makePicture(std::move(object));
        const uint64_t bad = renderHere(picture).badPixels;
        if (bad) {
            EXPECT_EQ(picture.at(0, 0), glm::vec4(0, 0, 0, 1));
        }
        return bad;
    };
    EXPECT_EQ(badPixels([](RTSpixel*, float*) { return 0; }), 0u);
    EXPECT_EQ(badPixels([](RTSpixel*, float*) { return 1; }), 40u * 36u);
    EXPECT_EQ(badPixels([](RTSpixel*, float* rgba) {
                  rgba[1] = std::numeric_limits<float>::infinity();
                  return 0;
              }),
              40u * 36u);
    // A point that is not finite has no ray.
    EXPECT_EQ(badPixels([](RTSpixel* pixel, float* rgba) {
                  pixel->trace(pixel, std::nanf(""), 0.5f, rgba);
                  return 0;
              }),
              40u * 36u);
}

} // namespace
} // namespace smart::test
