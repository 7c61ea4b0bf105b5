// SPDX-License-Identifier: MIT
// Levels of detail against closed forms, and what they are for: a picture of a floor.
#include "libsmart/render/ray_cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>
#include <random>
#include <string>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/shading/texture.h"
#include "openrt/shader.hpp"
#include "tests/libsmart/render/picture_scene.h"
#include "tests/libsmart/shading/fake_tracer.h"

namespace smart::test {
namespace {

constexpr uint32_t kSide = 33;    ///< of pictures: odd, so that a pixel's centre is the picture's
constexpr double kFovy = 0.9;     ///< radians
constexpr uint32_t kTexels = 1024; ///< of a side of the texture

/// What a pixel's side is at distance 1.
double pixelSide(double fovy, uint32_t rows) {
    return 2 * std::tan(fovy / 2) / rows;
}

/// A texture that shows its level of detail, from 0 to 10.
std::shared_ptr<const Texture> levelTexture() {
    std::vector<TextureImagePtr> images;
    for (uint32_t n = 0, side = kTexels; n <= 10; ++n, side = nextLevelSide(side)) {
        std::vector<std::byte> texels(std::size_t(side) * side, std::byte(n * 20));
        images.push_back(std::make_shared<const TextureImage>(side, side, 1, TexelType::Byte, false,
                                                              std::move(texels)));
    }
    return std::make_shared<const Texture>(
        std::make_shared<const TextureLevels>(std::move(images), 11), TextureOptions{});
}

double levelOf(const glm::vec4& pixel) {
    return double(pixel.r) * 255 / 20;
}

/// A rectangle of the plane through `center` that `right` and `up` span, each from -1 to 1, with
/// texture coordinates 0 to `copies`.
ModelPtr texturedRectangle(glm::vec3 center, glm::vec3 right, glm::vec3 up, float copies) {
    ModelBuilder builder;
    const auto corner = [&](float x, float y) {
        const glm::vec3 p = center + x * right + y * up;
        return std::array<float, 3>{p.x, p.y, p.z};
    };
    const std::array<float, 3> p[4] = {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)};
    for (const auto& [a, b] : {std::pair{1, 2}, {2, 3}})
        builder.triangles.push_back({{p[0][0], p[0][1], p[0][2]},
                                     {p[a][0], p[a][1], p[a][2]},
                                     {p[b][0], p[b][1], p[b][2]}});
    builder.shading.corners = {{0, 1, 2}, {0, 2, 3}};
    builder.shading.firstTexCoord = 0;
    builder.shading.texCoords = {
        {0, 0, 0, 1}, {copies, 0, 0, 1}, {copies, copies, 0, 1}, {0, copies, 0, 1}};
    return std::move(builder).build();
}

int showTexture(RTSstate* s) {
    rtsTexture(s, 1, s->texCoord[0], s->texCoord[1], s->result);
    return 0;
}

Picture pictureOf(ModelPtr model, std::shared_ptr<const Texture> texture) {
    Picture picture(kSide, kSide, makeScene({placeWithShader(std::move(model), 0)}),
                    {makeSurface(showTexture)});
    picture.frame->textures = std::make_shared<const TextureTable>(
        TextureTable{nullptr, std::move(texture)});
    picture.frame->matrixCamera = cameraOf(glm::perspective(kFovy, 1.0, 0.01, 1e6));
    return picture;
}

/// Copies of the texture that give `level` where a pixel is `width` wide, on a plane from -1 to 1
/// times `half`.
double expectedLevel(double width, double copies, double half) {
    return std::log2(width * copies / (2 * half) * kTexels);
}

TEST(RayConeTest, PlaneFacingAPinholeCamera) {
    for (const float distance : {1.0f, 2.5f, 40.0f, 1000.0f}) {
        const float half = distance * 2;
        const Picture picture = pictureOf(
            texturedRectangle({0, 0, -distance}, {half, 0, 0}, {0, half, 0}, 1.7f), levelTexture());
        renderHere(picture);
        EXPECT_NEAR(levelOf(picture.at(16, 16)),
                    expectedLevel(distance * pixelSide(kFovy, kSide), 1.7, half), 0.01)
            << distance;
        // Off the middle a pixel's solid angle shrinks with cos^3, so the cone's width with
        // cos^1.5; the way is longer by 1/cos, and 1/cos comes from the oblique surface.
        const double x = 14 * pixelSide(kFovy, kSide), cosine = 1 / std::sqrt(1 + x * x);
        EXPECT_NEAR(levelOf(picture.at(30, 16)),
                    expectedLevel(distance * pixelSide(kFovy, kSide), 1.7, half) -
                        0.5 * std::log2(cosine),
                    0.01);
    }
}

TEST(RayConeTest, CameraShadersAndFewerOrMoreSamples) {
    Picture picture =
        pictureOf(texturedRectangle({0, 0, -3}, {9, 0, 0}, {0, 9, 0}, 8), levelTexture());
    const auto half = float(std::tan(kFovy / 2));
    picture.frame->camera = makeCamera([half](float x, float y, RTScameraray* ray) {
        const float direction[3] = {(2 * x - 1) * half * 5, (2 * y - 1) * half * 5, -5};
        std::copy_n(direction, 3, ray->direction); // not of length 1
        return 0;
    });
    renderHere(picture);
    const double expected = expectedLevel(3 * pixelSide(kFovy, kSide), 8, 9);
    EXPECT_NEAR(levelOf(picture.at(16, 16)), expected, 0.01);
    picture.frame->samples = 4;
    renderHere(picture);
    EXPECT_NEAR(levelOf(picture.at(16, 16)), expected - 1, 0.02);
}

TEST(RayConeTest, ParallelRaysSeeAsMuchAtAnyDistance) {
    for (const float distance : {1.0f, 50.0f}) {
        Picture picture =
            pictureOf(texturedRectangle({0, 0, -distance}, {3, 0, 0}, {0, 3, 0}, 1),
                      levelTexture());
        picture.frame->matrixCamera = cameraOf(glm::ortho(-3.0, 3.0, -3.0, 3.0, -100.0, 100.0));
        renderHere(picture);
        for (const uint32_t x : {2u, 16u, 30u})
            EXPECT_NEAR(levelOf(picture.at(x, 16)), expectedLevel(6.0 / kSide, 1, 3), 0.01);
    }
}

TEST(RayConeTest, ObliquePlanesByTheirLongSide) {
    for (const double degrees : {20.0, 60.0, 85.0}) {
        const double angle = glm::radians(degrees);
        const glm::vec3 up(0, std::cos(angle), -std::sin(angle));
        const Picture picture =
            pictureOf(texturedRectangle({0, 0, -5}, {40, 0, 0}, 40.0f * up, 8), levelTexture());
        renderHere(picture);
        const double width = 5 * pixelSide(kFovy, kSide) / std::cos(angle);
        EXPECT_NEAR(levelOf(picture.at(16, 16)), expectedLevel(width, 8, 40), 0.02) << degrees;
    }
}

TEST(RayConeTest, ScaledInstancesAndMirrorsCount) {
    // A mirror at z = -4 shows a plane at z = 6, behind the camera: the way is 14 long. The
    // plane is an instance, twice as large as its model.
    Picture picture = pictureOf(makeModel(rectangle(-9, -9, 9, 9, -4)), levelTexture());
    const glm::dmat4x3 twice(glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
    picture.frame->scene = makeScene(
        {placeWithShader(makeModel(rectangle(-9, -9, 9, 9, -4)), 1),
         placeWithShader(texturedRectangle({0, 0, 3}, {10, 0, 0}, {0, 10, 0}, 4), 0, twice)});
    picture.frame->shaders = std::make_shared<const ShaderTable>(
        ShaderTable{makeSurface(showTexture), makeSurface([](RTSstate* s) {
                        float direction[3];
                        rtsReflectedDirection(s, direction);
                        rtsTraceRay(s, s->position, direction, 1, s->result);
                        return 0;
                    })});
    renderHere(picture);
    EXPECT_NEAR(levelOf(picture.at(16, 16)),
                expectedLevel(14 * pixelSide(kFovy, kSide), 4, 20), 0.01);
}

TEST(RayConeTest, TheEnvironmentIsToldTheAngle) {
    Picture picture = pictureOf(texturedRectangle({0, 50, 0}, {1, 0, 0}, {0, 1, 0}, 1), nullptr);
    picture.frame->environment = makeEnvironment([](RTSstate* s) {
        rtsResultColor(s, s->footprint, s->texCoordDensity, 0);
        return 0;
    });
    renderHere(picture);
    EXPECT_NEAR(double(picture.at(16, 16).r), pixelSide(kFovy, kSide), 1e-6);
    EXPECT_EQ(picture.at(16, 16).g, 0);
}

TEST(RayConeTest, FootprintsOnSurfaces) {
    RTSstate state{};
    state.geometricNormal[2] = 1;
    state.rayDirection[2] = -0.5f;
    state.footprint = 0.25f;
    EXPECT_EQ(textureFootprint(state), 0) << "no texture coordinates";
    state.texCoordDensity = 4;
    EXPECT_EQ(textureFootprint(state), 2);
    state.rayDirection[2] = 0;
    EXPECT_EQ(textureFootprint(state), std::numeric_limits<float>::infinity());
    state.footprint = std::nanf("");
    EXPECT_EQ(textureFootprint(state), 0);
}

TEST(RayConeTest, PacketsLookUpTheSameBits) {
    std::mt19937 random(31);
    std::vector<std::byte> texels(61 * 37 * 4);
    for (std::byte& b : texels) b = std::byte(random() % 256);
    const auto image = std::make_shared<const TextureImage>(61, 37, 4, TexelType::Byte, true,
                                                            std::move(texels));
    const auto texture = std::make_shared<const Texture>(
        std::make_shared<const TextureLevels>(std::vector<TextureImagePtr>{image},
                                              levelCount(61, 37)),
        TextureOptions{});
    const ModelPtr floor =
        texturedRectangle({0, -1, 0}, {200, 0, 0}, {0, 0, -200}, 100);
    Picture points = pictureOf(floor, texture), packets = pictureOf(floor, texture);
    packets.frame->shaders = std::make_shared<const ShaderTable>(ShaderTable{
        MadeShader("TextureShader").set("texture", openrt::TextureId{1}).make()});
    ASSERT_NE((*packets.frame->shaders)[0]->functions().shadePacket, nullptr);
    renderHere(points);
    renderHere(packets);
    EXPECT_EQ(points.pixels, packets.pixels);
    EXPECT_GT(texture->bytes(), image->bytes()) << "mipmaps were needed";
}

// A checker floor to the horizon: error of one sample a pixel against very many.
class FloorTest : public testing::Test {
protected:
    static constexpr uint32_t kChecks = 64;

    static std::shared_ptr<const Texture> checker(const TextureOptions& options) {
        std::vector<std::byte> texels(kChecks * kChecks);
        for (uint32_t y = 0; y < kChecks; ++y)
            for (uint32_t x = 0; x < kChecks; ++x)
                texels[y * kChecks + x] = std::byte((x / 8 + y / 8) % 2 ? 230 : 20);
        const auto image = std::make_shared<const TextureImage>(
            kChecks, kChecks, 1, TexelType::Byte, true, std::move(texels));
        return std::make_shared<const Texture>(
            std::make_shared<const TextureLevels>(std::vector<TextureImagePtr>{image},
                                                  levelCount(kChecks, kChecks)),
            options);
    }
    static std::vector<glm::vec4> floorWith(const MinificationFilter& filter, uint32_t samples) {
        Picture picture = pictureOf(
            texturedRectangle({0, -1, 0}, {2000, 0, 0}, {0, 0, -2000}, 1000), // 0.5 per unit
            checker({.minification = filter}));
        picture.frame->samples = samples;
        renderHere(picture);
        return picture.pixels;
    }
    static double errorOf(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
        double sum = 0;
        uint32_t count = 0;
        for (uint32_t i = 0; i < kSide / 2 * kSide; ++i, ++count) // below the horizon
            sum += std::pow(double(a[i].r) - double(b[i].r), 2);
        return std::sqrt(sum / count);
    }
};

TEST_F(FloorTest, OneTrilinearSampleIsNearerToManySamplesThanABilinearOne) {
    constexpr MinificationFilter kBilinear{TextureFilter::Linear, LevelChoice::First};
    constexpr MinificationFilter kTrilinear{TextureFilter::Linear, LevelChoice::Linear};
    const std::vector<glm::vec4> truth = floorWith(kBilinear, 256);
    const double bilinear = errorOf(floorWith(kBilinear, 1), truth);
    const double trilinear = errorOf(floorWith(kTrilinear, 1), truth);
    RecordProperty("bilinear", std::to_string(bilinear));
    RecordProperty("trilinear", std::to_string(trilinear));
    EXPECT_LT(trilinear, bilinear * 0.6) << "bilinear " << bilinear;
    // The control: another converged picture of the same floor is nearer still.
    EXPECT_LT(errorOf(floorWith(kTrilinear, 256), truth), trilinear * 0.5);
}

} // namespace
} // namespace smart::test
