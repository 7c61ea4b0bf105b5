// SPDX-License-Identifier: MIT
// Pictures of state blocks against OpenGL's equations at the vertices, interpolated by hand.
#include "libsmart/render/fixed_function_shader.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_inverse.hpp>
#include <random>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/render/tracers.h"
#include "tests/libsmart/render/shaded_scenes.h"
#include "tests/libsmart/shading/fixed_reference.h"

namespace smart::test {
namespace {

constexpr uint32_t kSide = 48;

FixedState litState() {
    FixedState state;
    state.ops.depthTest = true;
    FixedLighting& lighting = state.lighting;
    lighting.enabled = lighting.normalize = true;
    lighting.modelAmbient = {0.1f, 0.05f, 0.1f, 1.0f};
    FixedLight& sun = lighting.lights[0];
    sun.enabled = true;
    sun.position = {0.3f, 0.5f, 1.0f, 0.0f};
    sun.diffuse = {0.6f, 0.5f, 0.4f, 1.0f};
    FixedLight& lamp = lighting.lights[1];
    lamp.enabled = true;
    lamp.position = {1.0f, -1.0f, -1.0f, 1.0f};
    lamp.diffuse = lamp.specular = {0.3f, 0.4f, 0.5f, 1.0f};
    lamp.linearAttenuation = 0.2f;
    return state;
}

std::shared_ptr<const FixedMaterials> shiny() {
    auto materials = std::make_shared<FixedMaterials>();
    materials->front.specular = {0.5f, 0.5f, 0.5f, 1.0f};
    materials->front.shininess = 20.0f;
    materials->back.diffuse = {0.1f, 0.9f, 0.2f, 0.5f};
    materials->back.ambient = {0.9f, 0.1f, 0.1f, 1.0f};
    return materials;
}

/// Two triangles with a normal and a texture coordinate at each vertex, as a quad of OpenGL's is:
/// far from parallel to the picture.
ModelPtr quad() {
    ModelBuilder builder;
    const glm::vec3 corners[4] = {{-1, -1, 1}, {1, -1, 0.5f}, {1.2f, 1, -2}, {-1, 1.1f, -1}};
    const uint32_t numbers[2][3] = {{0, 1, 2}, {0, 2, 3}};
    for (const auto& triangle : numbers) {
        Triangle& t = builder.triangles.emplace_back();
        for (int k = 0; k < 3; ++k) {
            t.v0[k] = corners[triangle[0]][k];
            t.v1[k] = corners[triangle[1]][k];
            t.v2[k] = corners[triangle[2]][k];
        }
        builder.shading.corners.push_back({triangle[0], triangle[1], triangle[2]});
    }
    builder.shading.firstNormal = builder.shading.firstTexCoord = 0;
    builder.shading.normals = {{-0.5f, -0.3f, 1}, {0.6f, -0.2f, 1}, {0.5f, 0.5f, 2}, {0, 0.9f, 1}};
    builder.shading.texCoords = {{0, 0, 0, 1}, {4, 0, 0, 1}, {4, 4, 0, 1}, {0, 4, 0, 1}};
    builder.shading.provoking = {ShadingData::kOfNext + ShadingData::kLastCorner,
                                 ShadingData::kLastCorner};
    return std::move(builder).build();
}

glm::dmat4x3 pose(double turn = 0.4) {
    glm::dmat4 m = glm::translate(glm::dmat4(1.0), glm::dvec3(0.1, 0.0, -3.5));
    m = glm::rotate(m, turn, glm::dvec3(0.2, 1.0, 0.1));
    return glm::dmat4x3(glm::scale(m, glm::dvec3(1.0, 1.2, 0.8)));
}

Instance instanceOf(ModelPtr model, const FixedState& state,
                    const glm::dmat4x3& matrix = pose()) {
    Instance instance = place(std::move(model), matrix);
    instance.inherited.materials = shiny();
    instance.state = std::make_shared<const FixedState>(state);
    return instance;
}

Picture pictureOf(std::vector<Instance> instances) {
    return Picture(kSide, kSide, makeScene(std::move(instances)),
                   {MadeShader("FixedFunction").make()});
}

FixedVertex vertexOf(const Instance& instance, uint32_t triangle, int corner) {
    const Model& model = *instance.model;
    const Triangle& t = model.triangles[triangle];
    const auto& at = corner == 0 ? t.v0 : corner == 1 ? t.v1 : t.v2;
    const uint32_t number = model.shading.corners[triangle][std::size_t(corner)];
    FixedVertex vertex;
    vertex.position = instance.toParent * glm::dvec4(at[0], at[1], at[2], 1.0);
    vertex.normal = glm::inverseTranspose(glm::dmat3(instance.toParent)) *
                    glm::dvec3(model.shading.normals[number]);
    vertex.texCoord = model.shading.texCoords[number];
    vertex.materials = instance.inherited.materials.get();
    return vertex;
}

/// Through the pixel's centre, in double.
glm::dvec3 directionThrough(const Picture& picture, uint32_t x, uint32_t y) {
    const glm::dvec4 far = picture.frame->matrixCamera.inverse *
                           glm::dvec4(2 * (x + 0.5) / kSide - 1, 2 * (y + 0.5) / kSide - 1, 1, 1);
    return glm::dvec3(far) / far.w;
}

glm::dvec3 weightsAt(const FixedVertex (&v)[3], const glm::dvec3& direction) {
    const glm::dmat3 corners(v[0].position, v[1].position, v[2].position);
    const glm::dvec3 w = glm::inverse(corners) * direction;
    return w / (w.x + w.y + w.z);
}

using Expect = std::function<Vec4(const FixedVertex (&)[3], const glm::dvec3& weights,
                                  uint32_t triangle)>;

/// Largest difference between a picture's pixels on the first instance, and what they should be.
double errorOf(const Picture& picture, const Instance& instance, const Expect& expect) {
    double worst = 0;
    int pixels = 0;
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const std::size_t i = std::size_t(y) * kSide + x;
            if (picture.instances[i] != 0) continue;
            ++pixels;
            const uint32_t triangle = picture.primitives[i];
            const FixedVertex vertices[3] = {vertexOf(instance, triangle, 0),
                                             vertexOf(instance, triangle, 1),
                                             vertexOf(instance, triangle, 2)};
            const Vec4 truth =
                expect(vertices, weightsAt(vertices, directionThrough(picture, x, y)), triangle);
            for (int k = 0; k < 4; ++k)
                worst = std::max(worst, std::fabs(picture.pixels[i][k] - truth[std::size_t(k)]));
        }
    EXPECT_GT(pixels, 200);
    return worst;
}

Vec4 mixed(const Vec4 (&c)[3], const glm::dvec3& w) {
    Vec4 sum{};
    for (std::size_t k = 0; k < 4; ++k) sum[k] = w[0] * c[0][k] + w[1] * c[1][k] + w[2] * c[2][k];
    return sum;
}

Vec4 litColor(const FixedState& state, const FixedVertex& v, bool back) {
    const ReferenceColors colors = referenceLighting(state, v, back);
    Vec4 sum = colors.primary;
    for (std::size_t k = 0; k < 3; ++k) sum[k] = clamp01(sum[k] + colors.secondary[k]);
    return sum;
}

Expect gouraud(const FixedState& state, bool back) {
    return [=](const FixedVertex (&v)[3], const glm::dvec3& w, uint32_t) {
        return mixed({litColor(state, v[0], back), litColor(state, v[1], back),
                      litColor(state, v[2], back)},
                     w);
    };
}

TEST(FixedFunctionShader, SmoothIsTheEquationAtTheVertices) {
    const FixedState state = litState();
    const Instance instance = instanceOf(quad(), state);
    const Picture picture = pictureOf({instance});
    renderHere(picture);
    EXPECT_LT(errorOf(picture, instance, gouraud(state, false)), 2e-5);
    // The check sees weights that are not perspective-correct, and another side.
    EXPECT_GT(errorOf(picture, instance, [&](const auto& v, const glm::dvec3& w, uint32_t n) {
                  glm::dvec3 flat(w[0] * v[0].position.z, w[1] * v[1].position.z,
                                  w[2] * v[2].position.z);
                  flat /= flat.x + flat.y + flat.z;
                  return gouraud(state, false)(v, flat, n);
              }), 1e-3);
}

TEST(FixedFunctionShader, FlatTakesTheProvokingVertex) {
    FixedState state = litState();
    state.lighting.shadeModel = ShadeModel::Flat;
    const Instance instance = instanceOf(quad(), state);
    const Picture picture = pictureOf({instance});
    renderHere(picture);
    const auto flat = [&](uint32_t ofTriangle, int corner) {
        return errorOf(picture, instance, [&](const auto&, const glm::dvec3&, uint32_t) {
            return litColor(state, vertexOf(instance, ofTriangle, corner), false);
        });
    };
    EXPECT_LT(flat(1, 2), 1e-6); // both of the quad's triangles have its last vertex
    EXPECT_GT(flat(0, 2), 1e-3);
}

TEST(FixedFunctionShader, PhongIsTheEquationAtTheHit) {
    FixedState state = litState();
    state.lighting.shadeModel = ShadeModel::Phong;
    const Instance instance = instanceOf(quad(), state);
    const Picture picture = pictureOf({instance});
    renderHere(picture);
    const Expect perPixel = [&](const FixedVertex (&v)[3], const glm::dvec3& w, uint32_t) {
        FixedVertex at = v[0];
        at.position = w[0] * v[0].position + w[1] * v[1].position + w[2] * v[2].position;
        at.normal = glm::dvec3(0.0);
        for (int i = 0; i < 3; ++i) at.normal += w[i] * glm::normalize(v[i].normal);
        return litColor(state, at, false);
    };
    EXPECT_LT(errorOf(picture, instance, perPixel), 2e-5);
    EXPECT_GT(errorOf(picture, instance, gouraud(state, false)), 1e-3);
}

TEST(FixedFunctionShader, SidesAreThoseOnTheScreen) {
    FixedState state = litState();
    state.lighting.twoSided = true;
    for (const bool clockwise : {false, true})
        for (const bool turned : {false, true})
            for (const bool mirrored : {false, true}) {
                state.raster.frontFaceClockwise = clockwise;
                const Instance instance = instanceOf(quad(), state, pose(turned ? 3.3 : 0.4));
                const Picture picture = pictureOf({instance});
                if (mirrored)
                    picture.frame->matrixCamera =
                        cameraOf(glm::scale(glm::dmat4(1.0), glm::dvec3(-1, 1, 1)) *
                                 picture.frame->matrixCamera.projection);
                renderHere(picture);
                const bool back = (clockwise != turned) != mirrored;
                EXPECT_LT(errorOf(picture, instance, gouraud(state, back)), 2e-5);
                EXPECT_GT(errorOf(picture, instance, gouraud(state, !back)), 1e-2);
            }
}

TEST(FixedFunctionShader, ShadowsTakeWhatIsHiddenAndNothingElse) {
    FixedState state = litState();
    const Instance lit = instanceOf(quad(), state);
    const Picture plain = pictureOf({lit});
    renderHere(plain);
    state.lighting.shadows = true;
    const Instance shadowed = instanceOf(quad(), state);
    FixedState noSun = state;
    noSun.lighting.lights[0].enabled = false;
    // A pane behind the eye, in the sun's way; seen by no camera ray.
    Instance pane = instanceOf(makeModel(rectangle(1.4f, -9, 9, 9, 1.5f)), litState(),
                               glm::dmat4x3(1.0));
    const Picture picture = pictureOf({shadowed, pane});
    renderHere(picture);
    int hidden = 0, seen = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (picture.instances[i] != 0) continue;
        if (picture.pixels[i] == plain.pixels[i]) {
            ++seen;
        } else {
            ++hidden;
        }
    }
    EXPECT_GT(hidden, 30);
    EXPECT_GT(seen, 30);
    // Every pixel is either as without shadows or as without the sun.
    const Picture dark = pictureOf({instanceOf(quad(), noSun), pane});
    renderHere(dark);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        if (picture.pixels[i] == plain.pixels[i]) continue;
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(picture.pixels[i][k], dark.pixels[i][k], 1e-6f);
    }
}

TEST(FixedFunctionShader, ReflectionsAreMixedIn) {
    FixedState state; // unlit, white
    state.ops.depthTest = true;
    state.lighting.reflections = true;
    // A floor as a mirror, seen from above; the sky is the clear colour.
    Instance floor = instanceOf(makeModel(rectangle(-9, -9, 9, 9, -5)), state, glm::dmat4x3(1.0));
    auto materials = std::make_shared<FixedMaterials>();
    materials->front.reflection = 0.25f;
    floor.inherited.materials = materials;
    floor.inherited.color = {0.8f, 0.4f, 0.0f, 0.5f};
    Picture picture = pictureOf({floor});
    picture.frame->clearColor = {0.0f, 0.0f, 1.0f, 0.0f};
    const RenderStatistics counts = renderHere(picture);
    EXPECT_EQ(counts.secondaryRays, uint64_t(kSide) * kSide);
    for (const glm::vec4& pixel : picture.pixels) {
        EXPECT_NEAR(pixel.r, 0.6f, 1e-6f);
        EXPECT_NEAR(pixel.g, 0.3f, 1e-6f);
        EXPECT_NEAR(pixel.b, 0.25f, 1e-6f);
        EXPECT_EQ(pixel.a, 0.5f);
    }
}

TEST(FixedFunctionShader, RaysOfShadersSeeThroughBlendedSurfaces) {
    FixedState glass;
    glass.ops.depthTest = glass.ops.blend = true;
    glass.ops.sourceRgb = glass.ops.sourceAlpha = BlendFactor::SourceAlpha;
    glass.ops.destinationRgb = glass.ops.destinationAlpha = BlendFactor::OneMinusSourceAlpha;
    const glm::dmat4x3 one(1.0);
    Instance red = instanceOf(makeModel(rectangle(-90, -90, 90, 90, 2)), glass, one);
    Instance green = instanceOf(makeModel(rectangle(-90, -90, 90, 90, 3)), glass, one);
    red.inherited.color = {1, 0, 0, 0.25f};
    green.inherited.color = {0, 1, 0, 0.5f};
    // A programmed mirror at z = -4 looks back, past the eye at 0, into both panes and the sky.
    const auto mirror = makeSurface([](RTSstate* s) {
        float direction[3], radiance[3], left[3];
        rtsReflectedDirection(s, direction);
        rtsTraceRay(s, s->position, direction, 1.0f, radiance);
        rtsShadow(s, s->position, direction, 1e6f, left);
        rtsResultColor(s, radiance[0], radiance[1], radiance[2]);
        s->result[3] = left[0];
        return 0;
    });
    Instance wall = placeWithShader(makeModel(rectangle(-9, -9, 9, 9, -4)), 1);
    Picture picture(kSide, kSide, makeScene({green, red, wall}),
                    {MadeShader("FixedFunction").make(), mirror});
    picture.frame->clearColor = {0, 0, 1, 1};
    renderWith(PacketTracer(), picture);
    for (const glm::vec4& pixel : picture.pixels) {
        EXPECT_NEAR(pixel.r, 0.25f, 1e-6f);
        EXPECT_NEAR(pixel.g, 0.75f * 0.5f, 1e-6f);
        EXPECT_NEAR(pixel.b, 0.75f * 0.5f, 1e-6f);
        EXPECT_NEAR(pixel.a, 0.75f * 0.5f, 1e-6f);
    }
}

TEST(FixedFunctionShader, TexturesTakeTheLevelOfOpenGL) {
    // A checker of 64 x 64 with levels of single colours: what is seen is the level of detail.
    std::vector<TextureImagePtr> images;
    for (uint32_t level = 0; level < 7; ++level) {
        const uint32_t side = 64u >> level;
        const std::vector<float> values(side * side, float(level) / 8);
        std::vector<std::byte> bytes(values.size() * sizeof(float));
        std::memcpy(bytes.data(), values.data(), bytes.size());
        images.push_back(std::make_shared<const TextureImage>(side, side, 1, TexelType::Float,
                                                              false, std::move(bytes)));
    }
    FixedState state;
    state.ops.depthTest = true;
    state.texture.enabled2D = true;
    state.texture.mode = TexEnvMode::Replace;
    state.texture.image = std::make_shared<const Texture>(
        std::make_shared<const TextureLevels>(std::move(images), 7), TextureOptions{});
    const Instance instance = instanceOf(quad(), state);
    const Picture picture = pictureOf({instance});
    renderHere(picture);
    int minified = 0;
    for (uint32_t y = 0; y < kSide; ++y)
        for (uint32_t x = 0; x < kSide; ++x) {
            const std::size_t i = std::size_t(y) * kSide + x;
            if (picture.instances[i] != 0) continue;
            const uint32_t n = picture.primitives[i];
            const FixedVertex v[3] = {vertexOf(instance, n, 0), vertexOf(instance, n, 1),
                                      vertexOf(instance, n, 2)};
            const auto coordinate = [&](uint32_t column, uint32_t row) {
                const glm::dvec3 w = weightsAt(v, directionThrough(picture, column, row));
                return 64.0 * (w[0] * glm::dvec2(v[0].texCoord) + w[1] * glm::dvec2(v[1].texCoord) +
                               w[2] * glm::dvec2(v[2].texCoord));
            };
            const glm::dvec2 here = coordinate(x, y);
            const double rho = std::max(glm::length(coordinate(x + 1, y) - here),
                                        glm::length(coordinate(x, y + 1) - here));
            const double level = std::clamp(std::log2(rho), 0.0, 6.0);
            minified += level > 0.5;
            EXPECT_NEAR(picture.pixels[i].r, level / 8, 1e-4);
        }
    EXPECT_GT(minified, 200);
}

TEST(FixedFunctionShader, PacketsAndPointsGiveTheSameBits) {
    FixedState state = litState();
    state.lighting.shadows = state.lighting.reflections = true;
    auto materials = std::make_shared<FixedMaterials>(*shiny());
    materials->front.reflection = 0.4f;
    FixedState blended = litState();
    blended.ops.blend = true;
    blended.ops.sourceRgb = BlendFactor::SourceAlpha;
    blended.ops.destinationRgb = BlendFactor::OneMinusSourceAlpha;
    const auto make = [&] {
        Instance a = instanceOf(quad(), state), b = instanceOf(quad(), litState(), pose(2.0));
        Instance c = instanceOf(quad(), blended, pose(1.5)), d = place(quad(), pose(1.0));
        a.inherited.materials = b.inherited.materials = materials;
        return pictureOf({a, b, c, d});
    };
    const Picture packets = make(), points = make(), fixed = make();
    renderWith(PacketTracer(ShadingForm::Packets), packets);
    renderWith(PacketTracer(ShadingForm::Points), points);
    renderWith(tracerFor(fixed.frame->shading()), fixed);
    EXPECT_EQ(packets.pixels, points.pixels);
    EXPECT_EQ(packets.pixels, fixed.pixels);
}

} // namespace
} // namespace smart::test
