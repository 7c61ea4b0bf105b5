// SPDX-License-Identifier: MIT
// Edges that run through pixel centres, some but for rounding. Colours are added up, so that a
// picture tells how often each pixel was drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "libsmart/render/layered_tile.h"
#include "tests/libsmart/render/layered_scenes.h"

namespace smart::test {
namespace {

constexpr uint32_t kWidth = 160, kHeight = 120;
constexpr double kAspect = double(kWidth) / kHeight;
constexpr float kOnce = 0.25f;

std::shared_ptr<const FixedState> added() {
    return stateWith([](FixedState& s) {
        s.ops.blend = true;
        s.ops.sourceRgb = s.ops.destinationRgb = BlendFactor::One;
    });
}

glm::dmat4 orthographic() {
    return glm::ortho(-2 * kAspect, 2 * kAspect, -2.0, 2.0, -10.0, 10.0);
}

/// A square from -1 to 1 in n x n cells of two triangles each, with the one or the other diagonal.
std::vector<Triangle> cells(int n, bool falling) {
    std::vector<Triangle> mesh;
    const auto at = [n](int i) { return 2.0f * float(i) / float(n) - 1.0f; };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const float x0 = at(i), x1 = at(i + 1), y0 = at(j), y1 = at(j + 1);
            const float y = falling ? y1 : y0, other = falling ? y0 : y1;
            mesh.push_back({{x1, y, 0}, {x0, y, 0}, {x1, other, 0}});
            mesh.push_back({{x0, other, 0}, {x1, other, 0}, {x0, y, 0}});
        }
    return mesh;
}

std::vector<Triangle> moved(std::vector<Triangle> mesh, const glm::dmat4& by) {
    for (Triangle& triangle : mesh)
        for (float* const v : {triangle.v0, triangle.v1, triangle.v2}) {
            const glm::dvec4 to = by * glm::dvec4(v[0], v[1], v[2], 1.0);
            for (int k = 0; k < 3; ++k) v[k] = float(to[k]);
        }
    return mesh;
}

struct Counts {
    int inside = 0, lost = 0, doubled = 0;
};

Counts countPixels(const FlatScene& scene, const glm::dmat4& view, const glm::dmat4& place) {
    Picture picture = scene.picture(kWidth, kHeight);
    picture.frame->matrixCamera = cameraOf(view);
    renderHere(picture);
    const glm::dmat4 m = view * place;
    const auto column = [&m](int k) { return glm::dvec3(m[k].x, m[k].y, m[k].w); };
    const glm::dmat3 toSquare = glm::inverse(glm::dmat3(column(0), column(1), column(3)));
    Counts counts;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const glm::dvec3 at = toSquare * glm::dvec3((x + 0.5) * 2 / kWidth - 1,
                                                        (y + 0.5) * 2 / kHeight - 1, 1.0);
            const double farthest = std::max(std::fabs(at.x), std::fabs(at.y));
            if (farthest > 0.9999 * std::fabs(at.z)) continue;
            ++counts.inside;
            counts.lost += picture.at(x, y).r < kOnce;
            counts.doubled += picture.at(x, y).r > kOnce;
        }
    return counts;
}

// The float test often meets only the triangle that does not own the pixel.
TEST(LayerEdges, PixelsInsideAreDrawnOnce) {
    for (const bool perspective : {false, true})
        for (const glm::dvec3& axis : {glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 0)})
            for (const double angle : {0.0, 20.0, 45.0, 50.0})
                for (const int n : {1, 8})
                    for (const bool falling : {false, true})
                        for (const bool instance : {false, true}) {
                            const glm::dmat4 view =
                                perspective
                                    ? glm::perspective(glm::radians(45.0), kAspect, 1.0, 20.0)
                                    : orthographic();
                            const glm::dmat4 place =
                                glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -5)),
                                            glm::radians(angle), axis);
                            const std::vector<Triangle> mesh = cells(n, falling);
                            FlatScene scene;
                            scene.add(instance ? mesh : moved(mesh, place), {kOnce, 0, 0, 1},
                                      added(),
                                      glm::dmat4x3(instance ? place : glm::dmat4(1.0)));
                            const Counts counts = countPixels(scene, view, place);
                            EXPECT_GT(counts.inside, 1000);
                            EXPECT_TRUE(counts.lost == 0 && counts.doubled == 0)
                                << counts.lost << " lost, " << counts.doubled << " doubled: "
                                << (perspective ? "perspective " : "") << axis.x << axis.y
                                << axis.z << " by " << angle << ", " << n << " cells"
                                << (falling ? ", falling" : "") << (instance ? ", moved" : "");
                        }
}

// Each triangle an instance by itself: the neighbour may be of another one, or share no corner.
TEST(LayerEdges, NeighboursMayBeOtherInstances) {
    const glm::dmat4 place = glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -5));
    for (const int fewer : {8, 4}) {
        FlatScene scene;
        const std::vector<Triangle> many = cells(8, true), few = cells(fewer, true);
        for (const Triangle& triangle : moved(many, place))
            if (std::max({triangle.v0[1], triangle.v1[1], triangle.v2[1]}) <= 0)
                scene.add({triangle}, {kOnce, 0, 0, 1}, added());
        for (const Triangle& triangle : moved(few, place))
            if (std::min({triangle.v0[1], triangle.v1[1], triangle.v2[1]}) >= 0)
                scene.add({triangle}, {kOnce, 0, 0, 1}, added());
        const Counts counts = countPixels(scene, orthographic(), place);
        EXPECT_GT(counts.inside, 3000);
        EXPECT_EQ(counts.lost, 0);
        EXPECT_EQ(counts.doubled, 0);
    }
}

// What has no neighbour there is not drawn on its upper and right edges, a neighbour elsewhere or
// a culled one notwithstanding.
TEST(LayerEdges, OuterEdgesAreOpenGLs) {
    const glm::dmat4 place =
        glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(20.5, 20.5, 0)), glm::dvec3(10.0));
    for (const bool instance : {false, true})
        for (const int n : {1, 4})
            for (const bool falling : {false, true})
                for (const bool culled : {false, true}) {
                    std::vector<Triangle> mesh = cells(n, falling);
                    if (!falling) // clockwise so far
                        for (Triangle& triangle : mesh) std::swap(triangle.v0, triangle.v1);
                    if (culled) mesh.push_back({{1, -1, 0}, {1, 1, 0}, {2, 1, 0}});
                    auto state = std::make_shared<FixedState>(*added());
                    state->raster.cull = culled;
                    FlatScene scene;
                    scene.add(instance ? mesh : moved(mesh, place), {kOnce, 0, 0, 1}, state,
                              glm::dmat4x3(instance ? place : glm::dmat4(1.0)));
                    Picture picture = scene.picture(40, 40);
                    renderHere(picture);
                    for (uint32_t y = 0; y < 40; ++y)
                        for (uint32_t x = 0; x < 40; ++x)
                            EXPECT_EQ(picture.at(x, y).r,
                                      x >= 10 && x < 30 && y >= 10 && y < 30 ? kOnce : 0.0f)
                                << x << ' ' << y << ' ' << n << falling << culled << instance;
                }
}

// The same in front of an opaque surface, whose own edges are elsewhere.
TEST(LayerEdges, OuterEdgesShowWhatIsBehind) {
    for (const bool blended : {false, true}) {
        const auto tested = stateWith([](FixedState& s) { s.ops.depthTest = true; });
        FlatScene scene;
        scene.add(rectangle(0, 0, 60, 50, -5), {0, 1, 0, 1}, tested);
        scene.add(rectangle(10.5f, 10.5f, 30.5f, 30.5f, 5), {1, 0, 0, 1}, tested);
        if (blended) // behind both, in a box around them
            scene.add({{{0, 0, -20}, {40, 0, -20}, {0, 40, -20}},
                       {{41, 0, 20}, {42, 1, 20}, {41, 1, 20}}},
                      {0, 0, 1, 0.5f}, stateWith([](FixedState& s) {
                          s.ops.depthTest = true;
                          blendOver(s);
                      }));
        Picture picture = scene.picture(40, 40);
        picture.frame->scissor = Viewport{0, 0, 40, 40};
        renderHere(picture);
        for (uint32_t y = 0; y < 40; ++y)
            for (uint32_t x = 0; x < 40; ++x)
                EXPECT_EQ(picture.at(x, y).r,
                          x >= 10 && x < 30 && y >= 10 && y < 30 ? 1.0f : 0.0f)
                    << x << ' ' << y << ' ' << blended;
    }
}

} // namespace
} // namespace smart::test
