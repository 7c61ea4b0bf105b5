// SPDX-License-Identifier: MIT
// Pictures made in tiles against those whose rays are made, traced and shaded one by one: pictures
// of awkward sizes, scenes with next to nothing in them, eyes in awkward places.
#include "libsmart/render/tile_tracer.h"

#include <gtest/gtest.h>

#include "libsmart/render/tracers.h"
#include "tests/libsmart/render/shaded_scenes.h"

namespace smart::test {
namespace {

/// Shadows of all lights, and a question about half the way to each.
struct HalfWay {
    static constexpr bool shadesPackets = true;
    template <class Context>
    void shade(Context& c) const {
        typename Context::Color sum;
        for (RTuint i = 0; i < c.lightCount(); ++i) {
            typename Context::LightSample light{};
            const auto lit = c.illuminate(i, light);
            const auto half = c.shadow(c.position(), light.direction, light.distance * 0.5f, lit);
            const auto whole = c.shadow(c.position(), light.direction, light.distance, lit);
            sum = select(lit, sum + light.radiance * (half * 0.25f + whole), sum);
        }
        c.setRadiance(sum);
    }
};

std::shared_ptr<const ShaderObject> halfWay() {
    return MadeShader(std::make_shared<const ShaderClass>(
                          *openrt::shaderClass<HalfWay>("HalfWay"), nullptr))
        .make();
}

struct Case {
    const char* name;
    std::vector<Triangle> triangles;
    glm::dvec3 eye{0.0, 0.0, 3.0};
    glm::dvec3 target{0.0};
};

std::vector<Case> cases() {
    std::vector<Case> found;
    found.push_back({"nothing", {}});
    found.push_back({"one triangle", {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}}});
    found.push_back({"all rays miss", {{{-1, -1, 9}, {1, -1, 9}, {0, 1, 9}}}});
    found.push_back({"horizon", rectangle(-500, -500, 500, 500, 0), {0, -400, 1}, {0, 0, 1}});
    found.push_back({"eye on a plane", icosphere(2), {0, 0, 0}, {0, 0, -1}});
    found.back().triangles.push_back({{-9, 0, -9}, {9, 0, -9}, {0, 0, 9}});
    const std::vector<Triangle> ball = icosphere(2);
    const float* v = ball[7].v1;
    found.push_back({"eye on a vertex", ball, {v[0], v[1], v[2]}, {0, 0, 0}});
    return found;
}

Picture pictureOf(const Case& one, uint32_t width, uint32_t height) {
    std::vector<Instance> instances;
    if (!one.triangles.empty()) instances.push_back(placeWithShader(makeModel(one.triangles), 0));
    Picture picture(width, height, makeScene(std::move(instances)), {halfWay()});
    picture.frame->lights = {
        MadeShader("PointLight").set("position", openrt::Vec3(2, 4, 2)).make(),
        MadeShader("DirectionalLight").set("direction", openrt::Vec3(1, -2, -1)).make(),
        MadeShader("PointLight").set("position", openrt::Vec3(-3, 4, -2)).make()};
    picture.frame->clearColor = {0.25f, 0.5f, 0.75f, 0.125f};
    picture.frame->matrixCamera = cameraOf(
        glm::perspective(1.0, double(width) / height, 1e-3, 1e4) *
        glm::lookAt(one.eye, one.target, glm::dvec3(0.1, 1.0, 0.2)));
    return picture;
}

TEST(TileTracer, PicturesOfAnySizeAreThoseOfSingleRays) {
    const uint32_t sizes[][2] = {{1, 1}, {1, 37}, {37, 1}, {5, 3}, {64, 33}};
    const auto tracer = [](ShadingForm form) { return PacketTracer<>(form); };
    for (const Case& one : cases())
        for (const auto& [width, height] : sizes) {
            const Picture tiles = pictureOf(one, width, height);
            const Picture single = pictureOf(one, width, height);
            single.frame->renderingObject = makeRenderingObject([](RTSpixel* pixel, float* rgba) {
                pixel->trace(pixel, 0.5f, 0.5f, rgba);
                return 0;
            });
            // The first picture teaches which shadows are asked for.
            renderWith(tracer(ShadingForm::Packets), pictureOf(one, width, height));
            const RenderStatistics a = renderWith(tracer(ShadingForm::Packets), tiles);
            const RenderStatistics b = renderWith(tracer(ShadingForm::Points), single);
            EXPECT_EQ(differingPixels(tiles, single), 0u) << one.name << ' ' << width;
            EXPECT_EQ(a.primaryRays, b.primaryRays) << one.name;
            EXPECT_EQ(a.shadowRays, b.shadowRays) << one.name;
            EXPECT_EQ(a.badPixels, b.badPixels) << one.name;
        }
}

TEST(TileTracer, ColoursDoNotDependOnWhatElseIsKept) {
    const Case one = cases()[1];
    const Picture all = pictureOf(one, 50, 41), colours = pictureOf(one, 50, 41);
    colours.frame->target.aux = {};
    for (const Picture* picture : {&all, &colours}) {
        picture->frame->viewport = {-3, 2, 40, 60};
        picture->frame->samples = 3;
        renderWith(PacketTracer<>(), *picture);
    }
    EXPECT_EQ(all.pixels, colours.pixels);
    EXPECT_NE(all.at(20, 20), all.frame->clearColor); // something is there
}

} // namespace
} // namespace smart::test
