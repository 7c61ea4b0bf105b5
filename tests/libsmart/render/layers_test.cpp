// SPDX-License-Identifier: MIT
// Pictures of layers and of state blocks that are not opaque.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "libsmart/render/layered_tile.h"
#include "tests/libsmart/render/layered_scenes.h"

namespace smart::test {
namespace {

void expectColor(const glm::vec4& color, const glm::vec4& expected, const char* what = "") {
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(color[k], expected[k], 1e-6) << what << k;
}

// Seams through pixel centres: a square as two triangles, a fan around a centre, a strip.
TEST(Layers, BlendedSurfacesCoverEachPixelOnce) {
    const auto state = stateWith(blendOver);
    const auto at = [](float x, float y) { return std::array<float, 3>{x, y, 0.0f}; };
    const auto triangle = [](const auto& a, const auto& b, const auto& c) {
        Triangle t;
        std::copy_n(a.data(), 3, t.v0);
        std::copy_n(b.data(), 3, t.v1);
        std::copy_n(c.data(), 3, t.v2);
        return t;
    };
    std::vector<Triangle> fan, strip;
    const float ring[][2] = {{0.5f, 0.5f},   {10.5f, 0.5f},  {20.5f, 0.5f}, {20.5f, 10.5f},
                             {20.5f, 20.5f}, {10.5f, 20.5f}, {0.5f, 20.5f}, {0.5f, 10.5f}};
    for (int i = 0; i < 8; ++i) {
        const float* a = ring[i];
        const float* b = ring[(i + 1) % 8];
        fan.push_back(triangle(at(10.5f, 10.5f), at(a[0], a[1]), at(b[0], b[1])));
    }
    for (int i = 0; i < 4; ++i) {
        const float x = 0.5f + 5.0f * float(i);
        strip.push_back(triangle(at(x, 0.5f), at(x + 5, 0.5f), at(x, 20.5f)));
        strip.push_back(triangle(at(x, 20.5f), at(x + 5, 0.5f), at(x + 5, 20.5f)));
    }
    for (const std::vector<Triangle>& mesh :
         {rectangle(0.5f, 0.5f, 20.5f, 20.5f, 0), rectangle(0, 0, 20, 20, 0), fan, strip}) {
        FlatScene scene;
        scene.add(mesh, {1.0f, 0.5f, 0.25f, 0.5f}, state);
        Picture picture = scene.picture(24, 24);
        picture.frame->clearColor = {0.0f, 0.0f, 1.0f, 1.0f};
        renderHere(picture);
        for (uint32_t y = 0; y < 24; ++y)
            for (uint32_t x = 0; x < 24; ++x)
                expectColor(picture.at(x, y), x < 20 && y < 20
                                                  ? glm::vec4(0.5f, 0.25f, 0.625f, 0.75f)
                                                  : glm::vec4(0.0f, 0.0f, 1.0f, 1.0f));
    }
}

// The same under perspective, where rays meet edges by rounding only: no pixel is lost or doubled.
TEST(Layers, BlendedSurfacesInPerspective) {
    FlatScene scene;
    scene.add(rectangle(-1, -1, 1, 1, -3), {1, 1, 1, 0.5f}, stateWith(blendOver));
    scene.add(rectangle(-1, -1, 1, 1, -4), {1, 1, 1, 0.5f}, stateWith(blendOver));
    Picture picture = scene.picture(64, 64);
    picture.frame->matrixCamera = cameraOf(glm::frustum(-0.2, 0.2, -0.2, 0.2, 1.0, 10.0));
    renderHere(picture);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            EXPECT_FLOAT_EQ(picture.at(x, y).r, 0.75f) << x << ' ' << y;
}

// Rectangles with states of all kinds, against each pixel's list of them put together here.
TEST(Layers, RandomRectanglesInOrder) {
    std::mt19937 random(11);
    const auto below = [&](uint32_t n) { return random() % n; };
    for (int round = 0; round < 24; ++round) {
        const bool byDepth = round % 2 == 1; // opaque ones hide what is behind them
        constexpr uint32_t kSize = 40;
        struct Given {
            float x0, y0, x1, y1, z;
            glm::vec4 color;
            std::shared_ptr<const FixedState> state;
        };
        std::vector<Given> given;
        FlatScene scene;
        for (int i = 0; i < 14; ++i) {
            Given g;
            g.x0 = float(below(30)), g.y0 = float(below(30));
            g.x1 = g.x0 + 1 + float(below(25)), g.y1 = g.y0 + 1 + float(below(25));
            g.z = float(below(8)) * 10 - 35;
            for (int k = 0; k < 4; ++k) g.color[k] = float(below(9)) / 8.0f;
            g.state = stateWith([&](FixedState& s) {
                s.ops.depthTest = byDepth || below(4) != 0;
                s.ops.depthFunction = below(2)  ? CompareFunction::Less
                                      : byDepth ? CompareFunction::LessEqual
                                                : CompareFunction(below(8));
                s.ops.depthMask = below(4) != 0;
                s.ops.alphaTest = below(4) == 0;
                s.ops.alphaFunction = CompareFunction::Greater;
                s.ops.alphaReference = 0.5f;
                if (below(2)) blendOver(s);
                if (below(6) == 0) s.ops.colorMask[below(4)] = false;
            });
            if (below(5) == 0) g.state = nullptr;
            scene.add(rectangle(g.x0, g.y0, g.x1, g.y1, g.z), g.color, g.state);
            given.push_back(g);
        }
        Picture picture = scene.picture(kSize, kSize);
        picture.frame->clearColor = {0.2f, 0.4f, 0.6f, 0.8f};
        renderHere(picture);
        for (uint32_t y = 0; y < kSize; ++y)
            for (uint32_t x = 0; x < kSize; ++x) {
                PixelValue pixel{picture.frame->clearColor, 1.0f};
                const float px = float(x) + 0.5f, py = float(y) + 0.5f;
                for (uint32_t i = 0; i < given.size(); ++i) {
                    const Given& g = given[i];
                    if (px < g.x0 || px > g.x1 || py < g.y0 || py > g.y1) continue;
                    Fragment fragment;
                    fragment.state = g.state.get();
                    fragment.color = g.color;
                    fragment.depth = float(depthOf(g.z));
                    fragment.source = i;
                    replay({&fragment, 1}, pixel);
                }
                const std::size_t entry = y * kSize + x;
                expectColor(picture.pixels[entry], pixel.color);
                EXPECT_FLOAT_EQ(picture.depth[entry], pixel.depth);
                EXPECT_EQ(picture.instances[entry], pixel.source) << round;
            }
    }
}

// A scene that a layer's scissor makes go the layered way looks as before, to the bit.
TEST(Layers, OpaqueFramesAreThoseOfThePlainWay) {
    const auto shaded = makeSurface([](RTSstate* s) {
        rtsResultColor(s, s->shadingNormal[0], s->position[1], rtsRandom(s));
        return 0;
    });
    std::vector<Instance> instances;
    for (int i = 0; i < 5; ++i)
        instances.push_back(placeWithShader(makeModel(icosphere(2)), uint32_t(i % 2),
                                            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                             {i - 2.0, 0.3 * i - 0.5, -6.0 - i}}));
    for (const uint32_t samples : {1u, 3u}) {
        Picture plain(70, 50, makeScene(instances), {shaded, flat({2, 3, 4, 1})});
        plain.frame->samples = samples;
        plain.frame->clearColor = {0.1f, 0.2f, 0.3f, 0.4f};
        renderHere(plain);
        Picture layered(70, 50, plain.frame->scene, {shaded, flat({2, 3, 4, 1})});
        layered.frame->samples = samples;
        layered.frame->clearColor = plain.frame->clearColor;
        layered.frame->shaders = plain.frame->shaders;
        layered.frame->scissor = Viewport{0, 0, 70, 50};
        ASSERT_TRUE(layered.frame->isLayered());
        ASSERT_FALSE(plain.frame->isLayered());
        renderHere(layered);
        EXPECT_EQ(std::memcmp(plain.pixels.data(), layered.pixels.data(),
                              plain.pixels.size() * sizeof(glm::vec4)),
                  0);
        EXPECT_EQ(plain.distance, layered.distance);
        EXPECT_EQ(plain.objects, layered.objects);
        EXPECT_EQ(plain.instances, layered.instances);
        EXPECT_EQ(plain.primitives, layered.primitives);
        EXPECT_EQ(std::memcmp(plain.normals.data(), layered.normals.data(),
                              plain.normals.size() * sizeof(glm::vec3)),
                  0);
        for (std::size_t i = 0; i < plain.depth.size(); ++i)
            EXPECT_NEAR(plain.depth[i], layered.depth[i], 1e-6);
    }
}

TEST(Layers, CullingAlsoMirroredAndTwoSided) {
    const glm::dmat4x3 mirror({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {16, 0, 0});
    for (const bool mirrored : {false, true})
        for (const bool clockwise : {false, true})
            for (const FixedFace face : {FixedFace::Front, FixedFace::Back,
                                         FixedFace::FrontAndBack})
                for (const bool blended : {false, true}) {
                    FlatScene scene;
                    scene.add(rectangle(0, 0, 16, 16, -5), {0, 1, 0, 1});
                    scene.add(rectangle(0, 0, 16, 16, 5), {1, 0, 0, 1},
                              stateWith([&](FixedState& s) {
                                  s.ops.depthTest = true;
                                  s.raster.cull = true;
                                  s.raster.cullFace = face;
                                  s.raster.frontFaceClockwise = clockwise;
                                  s.ops.alphaTest = blended; // passes, but collects
                              }),
                              mirrored ? mirror : glm::dmat4x3(1.0));
                    Picture picture = scene.picture(16, 16);
                    renderHere(picture);
                    const bool front = mirrored == clockwise;
                    const bool culled = face == FixedFace::FrontAndBack ||
                                        (face == FixedFace::Front) == front;
                    expectColor(picture.at(8, 3), culled ? glm::vec4(0, 1, 0, 1)
                                                         : glm::vec4(1, 0, 0, 1));
                }
}

TEST(Layers, MirroredProjectionsTurnTheWinding) {
    FlatScene scene;
    scene.add(rectangle(0, 0, 16, 16, 5), {1, 0, 0, 1}, stateWith([](FixedState& s) {
                  s.ops.depthTest = true;
                  s.raster.cull = true;
              }));
    Picture picture = scene.picture(16, 16);
    renderHere(picture);
    EXPECT_EQ(picture.at(3, 3).r, 1.0f);
    picture.frame->matrixCamera = cameraOf(glm::ortho(16.0, 0.0, 0.0, 16.0, -100.0, 100.0));
    renderHere(picture);
    EXPECT_EQ(picture.at(3, 3).r, 0.0f);
}

TEST(Layers, ClipPlanesAndStipple) {
    FlatScene scene;
    scene.add(rectangle(0, 0, 64, 64, -5), {0, 1, 0, 1});
    scene.add(rectangle(0, 0, 64, 64, 5), {1, 0, 0, 1}, stateWith([](FixedState& s) {
                  s.ops.depthTest = true;
                  s.raster.clip[2] = true;
                  s.raster.clipPlane[2] = {1, 0, 0, -20}; // x >= 20
                  s.raster.clip[5] = true;
                  s.raster.clipPlane[5] = {0, -1, 0, 40}; // y <= 40
              }));
    scene.add(rectangle(0, 0, 64, 64, 6), {0, 0, 1, 1}, stateWith([](FixedState& s) {
                  s.ops.depthTest = true;
                  s.raster.polygonStippled = true;
                  for (uint32_t& row : s.raster.polygonStipple) row = 0;
                  s.raster.polygonStipple[3] = 0x80000001u;
              }));
    Picture picture = scene.picture(64, 64);
    renderHere(picture);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const bool dotted = y % 32 == 3 && (x % 32 == 0 || x % 32 == 31);
            const bool red = x >= 20 && y < 40;
            expectColor(picture.at(x, y), dotted ? glm::vec4(0, 0, 1, 1)
                                          : red  ? glm::vec4(1, 0, 0, 1)
                                                 : glm::vec4(0, 1, 0, 1));
        }
}

TEST(Layers, PolygonsThatAreNotFilledLetRaysPass) {
    FlatScene scene;
    scene.add(rectangle(0, 0, 16, 16, -5), {0, 1, 0, 1});
    scene.add(rectangle(0, 0, 16, 16, 5), {1, 0, 0, 1}, stateWith([](FixedState& s) {
                  s.ops.depthTest = true;
                  s.raster.polygonMode[0] = FixedPolygonMode::Line;
              }));
    Picture picture = scene.picture(16, 16);
    renderHere(picture);
    expectColor(picture.at(8, 3), {0, 1, 0, 1});
}

TEST(Layers, OfEqualDepthsTheFirstOrTheLast) {
    const auto with = [](CompareFunction function) {
        return stateWith([function](FixedState& s) {
            s.ops.depthTest = true;
            s.ops.depthFunction = function;
        });
    };
    const auto colorOf = [&](CompareFunction first, CompareFunction second, bool lastOfEqual) {
        FlatScene scene;
        scene.add(rectangle(0, 0, 16, 16, 0), {1, 0, 0, 1}, with(first));
        scene.add(rectangle(0, 0, 16, 16, 0), {0, 1, 0, 1}, with(second));
        Picture picture = scene.picture(16, 16);
        picture.frame->scene = scene.scene(lastOfEqual);
        renderHere(picture);
        return picture.at(5, 9);
    };
    constexpr auto kLess = CompareFunction::Less, kLessEqual = CompareFunction::LessEqual;
    expectColor(colorOf(kLess, kLess, false), {1, 0, 0, 1});
    expectColor(colorOf(kLessEqual, kLess, false), {1, 0, 0, 1});
    expectColor(colorOf(kLess, kLessEqual, false), {0, 1, 0, 1});
    expectColor(colorOf(kLessEqual, kLessEqual, false), {0, 1, 0, 1});
    expectColor(colorOf(kLessEqual, kLessEqual, true), {0, 1, 0, 1}); // by the traversal
}

TEST(Layers, PolygonOffsetOfDecals) {
    const auto colorOf = [](float factor, float units) {
        FlatScene scene;
        scene.add({{{0, 0, 0}, {16, 0, 4}, {16, 16, 20}}, {{0, 0, 0}, {16, 16, 20}, {0, 16, 16}}},
                  {1, 0, 0, 1});
        scene.add({{{4, 4, 5}, {12, 4, 7}, {12, 12, 15}}, {{4, 4, 5}, {12, 12, 15}, {4, 12, 13}}},
                  {0, 1, 0, 1}, stateWith([&](FixedState& s) {
                      s.ops.depthTest = true;
                      s.raster.offsetFill = true;
                      s.raster.offsetFactor = factor;
                      s.raster.offsetUnits = units;
                  }));
        Picture picture = scene.picture(16, 16);
        renderHere(picture);
        int green = 0;
        for (const glm::vec4& pixel : picture.pixels) green += pixel.g > 0.5f;
        EXPECT_EQ(picture.at(1, 1).g, 0.0f);
        // The slope is 1 along y, of 200 units of depth range.
        const double plain = depthOf(8.5 * 0.25 + 8.5), there = picture.depth[8 * 16 + 8];
        if (green > 0) {
            EXPECT_NEAR(there, plain + factor / 200.0 + units * 0x1p-24, 1e-7);
        }
        return green;
    };
    EXPECT_EQ(colorOf(-1.0f, 0.0f), 64);
    EXPECT_EQ(colorOf(0.0f, -8.0f), 64);
    EXPECT_EQ(colorOf(1.0f, 1.0f), 0);
}

TEST(Layers, DepthIsExact) {
    // Perspective: window depth of a tilted plane, computed here by cutting it with the rays.
    FlatScene scene;
    scene.add({{{-50, -50, -3}, {50, -50, -3}, {0, 80, -90}}}, {1, 1, 1, 1},
              stateWith([](FixedState& s) {
                  s.ops.depthTest = true;
                  s.ops.depthFunction = CompareFunction::LessEqual;
              }));
    Picture picture = scene.picture(64, 64);
    const double n = 0.5, f = 200.0;
    picture.frame->matrixCamera = cameraOf(glm::frustum(-0.4, 0.4, -0.4, 0.4, n, f));
    renderHere(picture);
    const glm::dvec3 a(-50, -50, -3), normal = glm::cross(glm::dvec3(100, 0, 0),
                                                          glm::dvec3(50, 130, -87));
    int hits = 0;
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const float depth = picture.depth[y * 64 + x];
            if (depth == 1.0f) continue;
            const glm::dvec3 d(((x + 0.5) / 32 - 1) * 0.8, ((y + 0.5) / 32 - 1) * 0.8, -1.0);
            const double z = glm::dot(a, normal) / glm::dot(d, normal);
            EXPECT_NEAR(depth, (f + n) / (f - n) / 2 + 0.5 - f * n / (f - n) / z, 1e-7);
            ++hits;
        }
    EXPECT_GT(hits, 1000);
}

TEST(Layers, AboveEachOtherByDepthUnlessCleared) {
    FlatScene scene, overlay;
    scene.add(rectangle(0, 0, 20, 32, 5), {1, 0, 0, 1});
    overlay.add(rectangle(10, 0, 32, 32, 0), {0, 1, 0, 1});
    Picture picture = overlay.picture(32, 32);
    picture.frame->clearColor = {0, 0, 1, 1};
    picture.frame->firstInstance = 1;
    picture.frame->below = {scene.layer(picture)};
    const auto check = [&](const glm::vec4& middle, uint32_t instance) {
        renderHere(picture);
        expectColor(picture.at(5, 7), {1, 0, 0, 1});
        expectColor(picture.at(15, 7), middle);
        expectColor(picture.at(25, 7), {0, 1, 0, 1});
        EXPECT_EQ(picture.instances[7 * 32 + 5], 0u);
        EXPECT_EQ(picture.instances[7 * 32 + 15], instance);
        EXPECT_EQ(picture.instances[7 * 32 + 25], 1u);
    };
    check({1, 0, 0, 1}, 0);
    BufferClear clear;
    clear.depth = 1.0f;
    picture.frame->clears = {clear};
    renderHere(picture);
    expectColor(picture.at(15, 7), {0, 1, 0, 1});
    expectColor(picture.at(5, 7), {1, 0, 0, 1}); // the colour stays,
    EXPECT_EQ(picture.depth[7 * 32 + 5], 1.0f);  // the depth does not

    // The upper layer may be moved to the front by its depth range.
    picture.frame->clears.clear();
    auto range = scene.layer(picture);
    range->depthNear = range->depthFar = 0.75f;
    picture.frame->below = {range};
    check({0, 1, 0, 1}, 1);
    EXPECT_EQ(picture.depth[7 * 32 + 5], 0.75f);
}

TEST(Layers, ViewportsScissorsAndScissoredClears) {
    FlatScene scene;
    scene.add(rectangle(0, 0, 16, 16, 0), {1, 0, 0, 1});
    Picture picture = scene.picture(70, 40);
    picture.frame->clearColor = {0, 0, 1, 1};
    picture.frame->matrixCamera = FlatScene::pixelCamera(16, 16);
    picture.frame->viewport = {40, 10, 20, 20};
    picture.frame->scissor = Viewport{45, 0, 100, 100};
    BufferClear clear;
    clear.scissor = Viewport{30, 5, 40, 4};
    clear.colorMask[1] = clear.colorMask[2] = true;
    clear.color = {1, 1, 0.5f, 0};
    picture.frame->clears = {clear};
    auto first = scene.layer(picture);
    first->viewport = {3, 2, 10, 30};
    picture.frame->below = {first};
    renderHere(picture);
    for (uint32_t y = 0; y < 40; ++y)
        for (uint32_t x = 0; x < 70; ++x) {
            const bool lower = x >= 3 && x < 13 && y >= 2 && y < 32;
            const bool upper = x >= 45 && x < 60 && y >= 10 && y < 30;
            const bool cleared = x >= 30 && x < 70 && y >= 5 && y < 9;
            expectColor(picture.at(x, y), lower || upper ? glm::vec4(1, 0, 0, 1)
                                          : cleared      ? glm::vec4(0, 1, 0.5f, 1)
                                                         : glm::vec4(0, 0, 1, 1));
        }
}

TEST(Layers, WithoutADrawBufferOnlyDepthIsWritten) {
    FlatScene hidden, scene;
    hidden.add(rectangle(0, 0, 8, 16, 5), {1, 0, 0, 1});
    scene.add(rectangle(0, 0, 16, 16, 0), {0, 1, 0, 1});
    Picture picture = scene.picture(16, 16);
    auto first = hidden.layer(picture);
    first->drawsColor = false;
    picture.frame->below = {first};
    renderHere(picture);
    expectColor(picture.at(3, 3), {0, 0, 0, 0});
    expectColor(picture.at(12, 3), {0, 1, 0, 1});
}

TEST(Layers, TheEnvironmentStandsForTheClearColourOfTheLowest) {
    FlatScene scene, overlay;
    scene.add(rectangle(0, 0, 8, 16, 0), {1, 0, 0, 1});
    overlay.add(rectangle(0, 0, 16, 8, 5), {0, 1, 0, 1});
    Picture picture = overlay.picture(16, 16);
    const auto sky = makeEnvironment([](RTSstate* s) {
        rtsResultColor(s, 0.25f, 0.5f, 0.75f);
        return 0;
    });
    auto first = scene.layer(picture);
    first->environment = picture.frame->environment = sky;
    picture.frame->below = {first};
    renderHere(picture);
    expectColor(picture.at(3, 12), {1, 0, 0, 1});
    expectColor(picture.at(12, 12), {0.25f, 0.5f, 0.75f, 1});
    expectColor(picture.at(3, 3), {0, 1, 0, 1});
}

/// Covers a rectangle with fragments between two instances.
class Cover final : public FragmentSource {
public:
    Cover(Viewport area, Fragment fragment) : area_(area), fragment_(fragment) {}
    void cover(const Tile& tile, std::vector<PixelFragment>& fragments) const override {
        for (uint32_t j = 0; j < tile.height; ++j)
            for (uint32_t i = 0; i < tile.width; ++i)
                if (area_.contains(tile.x + i, tile.y + j)) {
                    PixelFragment& pixel = fragments.emplace_back();
                    pixel.entry = uint16_t(j * kTileSize + i);
                    pixel.fragment = fragment_;
                }
    }

private:
    Viewport area_;
    Fragment fragment_;
};

TEST(Layers, PixelPrimitivesLieInOrderAmongTheHits) {
    const auto depthTested = [](FixedState& s) {
        s.ops.depthTest = true;
        blendOver(s);
    };
    const auto state = stateWith(depthTested);
    for (const uint32_t place : {0u, 1u, 2u}) {
        FlatScene scene; // far, near, both opaque
        scene.add(rectangle(0, 0, 40, 40, -5), {1, 0, 0, 1});
        scene.add(rectangle(0, 0, 40, 40, 5), {0, 1, 0, 1});
        Picture picture = scene.picture(40, 40);
        Fragment fragment;
        fragment.order = orderBeforeInstance(place, 0);
        fragment.state = state.get();
        fragment.color = {0, 0, 1, 0.5f};
        fragment.depth = float(depthOf(10)); // in front of both
        picture.frame->primitives =
            std::make_shared<const Cover>(Viewport{8, 8, 30, 5}, fragment);
        picture.frame->viewport = {0, 0, 36, 36}; // they reach beyond it
        picture.frame->matrixCamera = FlatScene::pixelCamera(36, 36);
        renderHere(picture);
        const glm::vec4 expected = place == 0   ? glm::vec4(0, 0, 0.5f, 0.25f)
                                   : place == 1 ? glm::vec4(0.5f, 0, 0.5f, 0.75f)
                                                : glm::vec4(0, 0.5f, 0.5f, 0.75f);
        expectColor(picture.at(20, 10), expected, "over the hits");
        expectColor(picture.at(20, 20), {0, 1, 0, 1}, "beside it");
        expectColor(picture.at(37, 10), {0, 0, 0.5f, 0.25f}, "outside of the viewport");
        EXPECT_EQ(picture.instances[10 * 40 + 20], kNoId);
        EXPECT_EQ(picture.instances[20 * 40 + 20], 1u);
    }
}

TEST(Layers, SamplesAreMergedEachByItself) {
    FlatScene scene;
    scene.add(rectangle(0, 0, 7.5f, 16, 0), {1, 1, 1, 0.5f}, stateWith(blendOver));
    Picture picture = scene.picture(16, 16);
    picture.frame->samples = 64;
    renderHere(picture);
    EXPECT_FLOAT_EQ(picture.at(3, 3).r, 0.5f);
    EXPECT_NEAR(picture.at(7, 3).r, 0.25f, 0.02f);
    EXPECT_EQ(picture.at(9, 3).r, 0.0f);
}

TEST(Layers, FaultsCostTheirPixelsOnly) {
    FlatScene scene;
    scene.add(rectangle(0, 0, 16, 16, 0), {1, 1, 1, 0.5f}, stateWith(blendOver));
    scene.add(rectangle(0, 0, 4, 4, 0), {NAN, 1, 1, 0.5f}, stateWith(blendOver));
    Picture picture = scene.picture(16, 16);
    const RenderStatistics counted = renderHere(picture);
    EXPECT_EQ(counted.badPixels, 16u);
    expectColor(picture.at(1, 1), {0, 0, 0, 1});
    expectColor(picture.at(8, 8), {0.5f, 0.5f, 0.5f, 0.25f});
}

} // namespace
} // namespace smart::test
