// SPDX-License-Identifier: MIT
// Points, lines, edges and images of a layer, from vertices to fragments: places, depths and
// colours against the equations written out here.
#include "libsmart/render/pixel_primitives.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <vector>

#include "libsmart/geometry/model_builder.h"
#include "libsmart/render/point_raster.h"

namespace smart {
namespace {

constexpr uint32_t kSide = 64;
constexpr float kInf = std::numeric_limits<float>::infinity();
const float kNan = std::nanf("");

/// x and y are pixels, z is from the near plane, 1, to the far plane, -1.
glm::dmat4 flatProjection() {
    glm::dmat4 m(1.0);
    m[0][0] = m[1][1] = 2.0 / kSide;
    m[2][2] = -1.0;
    m[3] = {-1.0, -1.0, 0.0, 1.0};
    return m;
}

/// 90 degrees, planes at distances 1 and 9.
glm::dmat4 deepProjection() {
    glm::dmat4 m(0.0);
    m[0][0] = m[1][1] = 1.0;
    m[2] = {0.0, 0.0, -10.0 / 8.0, -1.0};
    m[3][2] = -18.0 / 8.0;
    return m;
}

struct Vertex {
    glm::vec3 position;
    glm::vec4 color{1.0f};
};

/// A model of runs, all vertices with a colour.
class PixelModel {
public:
    PixelModel& add(PixelRun::Kind kind, const std::vector<Vertex>& vertices) {
        const auto number = uint32_t(builder_.pixels.positions.size());
        builder_.pixels.runs.push_back({kind, uint32_t(builder_.triangles.size()), number,
                                        uint32_t(vertices.size()), number});
        for (const Vertex& vertex : vertices) {
            builder_.pixels.positions.push_back(vertex.position);
            builder_.shading.colors.push_back(vertex.color);
        }
        builder_.shading.firstColor = 0;
        return *this;
    }
    PixelModel& add(const WindowImage& image) {
        builder_.pixels.runs.push_back({PixelRun::Kind::Image, uint32_t(builder_.triangles.size()),
                                        uint32_t(builder_.pixels.images.size()), 1, 0});
        builder_.pixels.images.push_back(std::make_shared<const WindowImage>(image));
        return *this;
    }
    PixelModel& addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                            uint8_t boundary = ShadingData::kAllEdges) {
        builder_.triangles.push_back({{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}});
        builder_.shading.boundary.push_back(boundary);
        return *this;
    }
    ModelPtr build() { return std::move(builder_).build(); }

private:
    ModelBuilder builder_;
};

std::shared_ptr<Frame> layerOf(ModelPtr model, FixedStatePtr state,
                               const glm::dmat4& projection = flatProjection()) {
    Instance instance;
    instance.model = std::move(model);
    instance.state = std::move(state);
    const auto layer = std::make_shared<Frame>();
    layer->scene = std::make_shared<const Scene>(std::vector<Instance>{instance},
                                                 Precision::Watertight, 1);
    layer->matrixCamera.projection = projection;
    layer->viewport = {0, 0, kSide, kSide};
    layer->target.width = layer->target.height = kSide;
    return layer;
}

struct Found {
    uint32_t x, y;
    PixelFragment pixel;
};

std::vector<Found> cover(const Frame& layer) {
    std::vector<Found> all;
    const auto primitives = PixelPrimitives::make(layer);
    if (!primitives) return all;
    for (uint32_t y = 0; y < layer.target.height; y += kTileSize)
        for (uint32_t x = 0; x < layer.target.width; x += kTileSize) {
            std::vector<PixelFragment> fragments;
            primitives->cover({x, y, kTileSize, kTileSize}, fragments);
            for (const PixelFragment& pixel : fragments)
                all.push_back({x + pixel.entry % kTileSize, y + pixel.entry / kTileSize, pixel});
        }
    return all;
}

std::map<std::pair<uint32_t, uint32_t>, int> countsOf(const std::vector<Found>& found) {
    std::map<std::pair<uint32_t, uint32_t>, int> counts;
    for (const Found& one : found) ++counts[{one.x, one.y}];
    return counts;
}

FixedState startState() {
    FixedState state;
    state.ops.depthTest = true;
    return state;
}
FixedStatePtr shared(const FixedState& state) { return std::make_shared<const FixedState>(state); }

TEST(PixelPrimitives, NothingWhereThereIsNothing) {
    PixelModel model;
    model.addTriangle({1, 1, 0}, {9, 1, 0}, {1, 9, 0});
    const ModelPtr built = model.build();
    EXPECT_EQ(PixelPrimitives::make(*layerOf(built, nullptr)), nullptr);
    EXPECT_EQ(PixelPrimitives::make(*layerOf(built, shared(startState()))), nullptr);
    FixedState lines = startState();
    lines.raster.polygonMode[1] = FixedPolygonMode::Line;
    EXPECT_NE(PixelPrimitives::make(*layerOf(built, shared(lines))), nullptr);
}

TEST(PixelPrimitives, LinesArePerspectiveCorrect) {
    // From the near to the far plane; t is the share of the way in the eye's space.
    const glm::dvec3 a(-0.9, -0.7, -1.2), b(6.1, 5.2, -8.0);
    PixelModel model;
    model.add(PixelRun::Kind::Lines, {{glm::vec3(a), {0, 0, 1, 1}}, {glm::vec3(b), {1, 0, 0, 1}}});
    const auto layer = layerOf(model.build(), nullptr, deepProjection());
    const std::vector<Found> found = cover(*layer);
    ASSERT_GT(found.size(), 20u);
    for (const Found& one : found) {
        // The point of the line nearest to the pixel's centre in the window: by bisection.
        const auto window = [&](double t) {
            const glm::dvec3 p = a + (b - a) * t;
            return glm::dvec2(p.x, p.y) / -p.z * 32.0 + 32.0;
        };
        const glm::dvec2 centre(one.x + 0.5, one.y + 0.5), along = window(1.0) - window(0.0);
        double low = 0.0, high = 1.0;
        for (int i = 0; i < 60; ++i) {
            const double t = (low + high) / 2;
            (glm::dot(centre - window(t), along) > 0 ? low : high) = t;
        }
        const double z = a.z + (b.z - a.z) * low;
        const double depth = ((-10.0 / 8.0 * z - 18.0 / 8.0) / -z + 1.0) / 2.0;
        EXPECT_NEAR(one.pixel.fragment.depth, depth, 1e-6);
        EXPECT_NEAR(one.pixel.fragment.color.r, low, 1e-5);
        EXPECT_NEAR(one.pixel.fragment.color.b, 1.0 - low, 1e-5);
    }
}

TEST(PixelPrimitives, TheNearPlaneCuts) {
    // Through the eye's plane; what is left starts at distance 1, x = -0.5 there.
    PixelModel model;
    model.add(PixelRun::Kind::Lines, {{{-1.5f, 0.1f, 1.0f}}, {{2.0f, 0.1f, -6.0f}}});
    const auto found = cover(*layerOf(model.build(), nullptr, deepProjection()));
    ASSERT_FALSE(found.empty());
    float least = 1.0f;
    uint32_t first = kSide;
    for (const Found& one : found) {
        least = std::min(least, one.pixel.fragment.depth);
        first = std::min(first, one.x);
    }
    EXPECT_LT(least, 0.03f);
    EXPECT_EQ(first, 16u); // 32 - 0.5 * 32
}

TEST(PixelPrimitives, ValuesThatAreNoneDrawNothing) {
    for (const float bad : {kNan, kInf, -kInf})
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 p(10.5f, 10.5f, 0.0f);
            p[axis] = bad;
            PixelModel model;
            model.add(PixelRun::Kind::Lines, {{p}, {{20, 20, 0}}, {{5, 30.5f, 0}},
                                              {{9, 30.5f, 0}}})
                .add(PixelRun::Kind::Points, {{p}, {{40.5f, 40.5f, 0}}})
                .add(PixelRun::Kind::LineLoop, {{p}, {p}, {p}})
                .add(PixelRun::Kind::LineStrip, {{p}});
            for (const auto& [pixel, count] : countsOf(cover(*layerOf(model.build(), nullptr)))) {
                EXPECT_EQ(count, 1);
                EXPECT_TRUE(pixel.second == 30 || pixel == std::pair(40u, 40u));
            }
        }
}

TEST(PixelPrimitives, HugeLinesAreCutWhereThePictureEnds) {
    for (const float far : {1e6f, 1e12f, 1e30f, 3e38f}) {
        PixelModel model;
        model.add(PixelRun::Kind::Lines, {{{-far, 20.5f, 0}}, {{far, 20.5f, 0}}});
        const auto counts = countsOf(cover(*layerOf(model.build(), nullptr)));
        EXPECT_EQ(counts.size(), kSide) << far;
        for (const auto& [pixel, count] : counts) EXPECT_EQ(pixel.second, 20u);
    }
}

TEST(PixelPrimitives, AViewportFarLargerThanThePicture) {
    PixelModel model;
    model.add(PixelRun::Kind::Lines, {{{-1, -1, 0}}, {{1, 1, 0}}});
    const auto layer = layerOf(model.build(), nullptr, glm::dmat4(1.0));
    layer->viewport = {-(1 << 29), -(1 << 29), 1u << 30, 1u << 30};
    const auto counts = countsOf(cover(*layer));
    EXPECT_EQ(counts.size(), kSide);
    for (const auto& [pixel, count] : counts) EXPECT_EQ(pixel.first, pixel.second);
}

TEST(PixelPrimitives, QuadsHaveNoDiagonal) {
    FixedState state = startState();
    state.raster.polygonMode[0] = FixedPolygonMode::Line;
    PixelModel model;
    model.addTriangle({10.5f, 10.5f, 0}, {50.5f, 10.5f, 0}, {50.5f, 50.5f, 0}, 3)
        .addTriangle({10.5f, 10.5f, 0}, {50.5f, 50.5f, 0}, {10.5f, 50.5f, 0}, 6);
    const ModelPtr built = model.build();
    const auto counts = countsOf(cover(*layerOf(built, shared(state))));
    EXPECT_EQ(counts.size(), 160u);
    for (const auto& [pixel, count] : counts)
        EXPECT_TRUE(pixel.first == 10 || pixel.first == 50 || pixel.second == 10 ||
                    pixel.second == 50);
    // The control: a face that is to be filled, and one that is culled.
    state.raster.frontFaceClockwise = true;
    EXPECT_TRUE(cover(*layerOf(built, shared(state))).empty());
    state.raster.frontFaceClockwise = false;
    state.raster.cull = true;
    EXPECT_EQ(cover(*layerOf(built, shared(state))).size(), 160u);
    state.raster.cullFace = FixedFace::Front;
    EXPECT_TRUE(cover(*layerOf(built, shared(state))).empty());
}

TEST(PixelPrimitives, PolygonOffsetMovesEdges) {
    FixedState state = startState();
    state.raster.polygonMode[0] = FixedPolygonMode::Line;
    PixelModel model; // depth falls by 1/128 for a pixel to the right
    model.addTriangle({10.5f, 10.5f, 0}, {42.5f, 10.5f, 0.5f}, {10.5f, 42.5f, 0});
    const ModelPtr built = model.build();
    const auto plain = cover(*layerOf(built, shared(state)));
    state.raster.offsetLine = true;
    state.raster.offsetFactor = 2.0f;
    state.raster.offsetUnits = 1000.0f;
    const auto moved = cover(*layerOf(built, shared(state)));
    ASSERT_EQ(plain.size(), moved.size());
    for (std::size_t i = 0; i < plain.size(); ++i)
        EXPECT_NEAR(moved[i].pixel.fragment.depth - plain[i].pixel.fragment.depth,
                    2.0 / 128 + 1000 * 0x1p-24, 1e-6);
}

TEST(PixelPrimitives, SmoothLinesAndPointsHaveCoverageInAlpha) {
    FixedState state = startState();
    state.raster.lineSmooth = state.raster.pointSmooth = true;
    state.raster.lineWidth = 2.0f;
    state.raster.pointSize = 6.0f;
    double sum = 0.0;
    PixelModel lines, points;
    lines.add(PixelRun::Kind::Lines, {{{10.2f, 11.1f, 0}}, {{40.7f, 29.3f, 0}}});
    for (const Found& one : cover(*layerOf(lines.build(), shared(state))))
        sum += one.pixel.fragment.color.a;
    EXPECT_NEAR(sum, 2.0 * std::hypot(30.5, 18.2), 0.01);
    sum = 0.0;
    points.add(PixelRun::Kind::Points, {{{30.3f, 31.6f, 0}}});
    for (const Found& one : cover(*layerOf(points.build(), shared(state))))
        sum += one.pixel.fragment.color.a;
    EXPECT_NEAR(sum, 9 * 3.14159265, 0.3);
}

TEST(PixelPrimitives, PointsGetSmallerWithTheirDistance) {
    FixedRaster raster;
    raster.pointSize = 12.0f;
    raster.pointAttenuation = {0.5f, 0.25f, 0.125f};
    const glm::dvec3 eye(2.0, -3.0, -6.0); // at distance 7
    EXPECT_NEAR(pointSizeAt(raster, eye), 12.0 / std::sqrt(0.5 + 0.25 * 7 + 0.125 * 49), 1e-5);
    raster.pointSizeMin = 9.0f;
    EXPECT_EQ(pointSizeAt(raster, eye), 9.0f);
    raster.pointSizeMin = 0.0f;
    raster.pointSizeMax = 2.5f;
    EXPECT_EQ(pointSizeAt(raster, eye), 2.5f);
    for (const float wrong : {0.0f, -1.0f, kNan, kInf, -kInf}) {
        raster.pointAttenuation = {wrong, wrong, wrong};
        const float size = pointSizeAt(raster, eye);
        EXPECT_TRUE(size >= raster.pointSizeMin && size <= raster.pointSizeMax) << wrong;
    }
    FixedState state = startState();
    state.raster.pointSize = 8.0f;
    state.raster.pointAttenuation = {0.0f, 0.0f, 0.25f};
    PixelModel model;
    model.add(PixelRun::Kind::Points, {{{0.1f, 0.1f, -2.0f}}, {{-2.1f, 0.2f, -8.0f}}});
    const auto found = cover(*layerOf(model.build(), shared(state), deepProjection()));
    EXPECT_EQ(found.size(), 64u + 4u); // at distances of 2 and a little more than 8
}

TEST(PixelPrimitives, SmallPointsFadeWithSeveralSamples) {
    FixedState state = startState();
    state.raster.pointSize = 3.0f;
    state.raster.pointFadeThreshold = 6.0f;
    PixelModel model;
    model.add(PixelRun::Kind::Points, {{{32.0f, 32.0f, 0.0f}}});
    const ModelPtr built = model.build();
    for (const uint32_t samples : {1u, 4u}) {
        const auto layer = layerOf(built, shared(state));
        layer->samples = samples;
        float widest = 0.0f;
        for (const Found& one : cover(*layer)) {
            EXPECT_FLOAT_EQ(one.pixel.fragment.color.a, samples == 1 ? 1.0f : 0.25f);
            widest = std::max(widest, std::fabs(float(one.x) + 0.5f - 32.0f));
        }
        EXPECT_EQ(widest, samples == 1 ? 1.5f : 2.5f);
    }
}

TEST(PixelPrimitives, SamplesAreCoveredOneByOne) {
    PixelModel model;
    model.add(PixelRun::Kind::Lines, {{{10.2f, 11.1f, 0}}, {{40.7f, 29.3f, 0}}});
    FixedState state = startState();
    state.raster.lineWidth = 3.0f;
    const auto layer = layerOf(model.build(), shared(state));
    layer->samples = 16;
    double samples = 0.0;
    bool partly = false;
    for (const Found& one : cover(*layer)) {
        int count = 0;
        for (int i = 0; i < 16; ++i) count += one.pixel.samples >> i & 1u;
        partly |= count > 0 && count < 16;
        samples += count;
    }
    EXPECT_TRUE(partly);
    EXPECT_NEAR(samples / 16, 3.0 * std::hypot(30.5, 18.2), 3.0);
}

TEST(PixelPrimitives, ImagesKeepTheirPlaceAmongTheRest) {
    const auto pixels = std::make_shared<ImagePixels>();
    pixels->width = 3;
    pixels->height = 2;
    pixels->bitmap = true;
    pixels->data = {std::byte(0xA0), std::byte(0x40)};
    WindowImage image;
    image.pixels = pixels;
    image.corner = {20, 30};
    image.depth = 0.25f;
    image.lit.primary = {0.5f, 1.0f, 0.0f, 1.0f};
    PixelModel model;
    model.add(image)
        .addTriangle({1, 1, 0}, {9, 1, 0}, {1, 9, 0})
        .add(PixelRun::Kind::Points, {{{20.5f, 30.5f, 0}}})
        .add(image)
        .addTriangle({1, 1, 0}, {9, 1, 0}, {1, 9, 0})
        .add(PixelRun::Kind::Points, {{{20.5f, 30.5f, 0}}});
    const auto found = cover(*layerOf(model.build(), shared(startState())));
    ASSERT_EQ(found.size(), 8u);
    std::vector<uint64_t> orders;
    for (const Found& one : found) {
        if (one.x == 20 && one.y == 30) orders.push_back(one.pixel.fragment.order);
        const bool set = (one.y == 30 && one.x != 21) || (one.y == 31 && one.x == 21);
        EXPECT_TRUE(set);
    }
    // Image, triangle 0, point, image, triangle 1, point; of equal order the hit comes first.
    ASSERT_EQ(orders.size(), 4u);
    EXPECT_LT(orders[0], orderOfInstance(0, 0));
    EXPECT_EQ(orders[1], orderOfInstance(0, 0));
    EXPECT_EQ(orders[2], orderOfInstance(0, 0));
    EXPECT_EQ(orders[3], orderOfInstance(0, 1));
    EXPECT_FLOAT_EQ(found[0].pixel.fragment.depth, 0.25f);
}

// No time is asserted: what is seen is that work follows the pixels, not lines times tiles.
TEST(PixelPrimitives, AHundredThousandLines) {
    std::vector<Vertex> vertices;
    uint32_t state = 1;
    const auto next = [&] { return float((state = state * 1664525u + 1013904223u) >> 8); };
    for (int i = 0; i < 100000; ++i) {
        const glm::vec3 from(next() * 0x1p-18f, next() * 0x1p-18f, 0.0f);
        vertices.push_back({from});
        vertices.push_back({from + glm::vec3(next() * 0x1p-22f, next() * 0x1p-22f, 0.0f)});
    }
    PixelModel model;
    model.add(PixelRun::Kind::Lines, vertices);
    const auto layer = layerOf(model.build(), nullptr);
    const auto start = std::chrono::steady_clock::now();
    const std::size_t fragments = cover(*layer).size();
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    RecordProperty("seconds", std::to_string(time.count()));
    EXPECT_GT(fragments, 150000u);
    EXPECT_LT(fragments, 400000u);
}

} // namespace
} // namespace smart
