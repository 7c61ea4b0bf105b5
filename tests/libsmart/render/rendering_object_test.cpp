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
