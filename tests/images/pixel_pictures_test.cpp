// SPDX-License-Identifier: MIT
// Points, lines, edges and images against Mesa's, pixel by pixel.
//
// Where a line ends OpenGL lets implementations differ by a pixel: Mesa draws the last pixel of
// some lines that end in its middle, cuts lines of even width elsewhere, and draws each piece of a
// stippled line as a line. Two pictures agree if every pixel has the other one's value, or a value
// of the other one's next to it; and if no more than a small part of the pixels needs that.
#include <GL/gl.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "openrt/rt.h"
#include "tests/images/pixel_scenes.h"

namespace {

constexpr int kWidth = PIXEL_SCENE_WIDTH, kHeight = PIXEL_SCENE_HEIGHT;
using Rgb = std::array<int, 3>;
using Picture = std::vector<Rgb>;

Picture fromBytes(const std::vector<unsigned char>& bytes) {
    Picture picture(bytes.size() / 4);
    for (std::size_t i = 0; i < picture.size(); ++i)
        picture[i] = {bytes[4 * i], bytes[4 * i + 1], bytes[4 * i + 2]};
    return picture;
}

Picture mesaPicture(PixelScene scene, int parameter) {
    std::vector<unsigned char> bytes(std::size_t(kWidth) * kHeight * 4);
    const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    EXPECT_TRUE(OSMesaMakeCurrent(context, bytes.data(), GL_UNSIGNED_BYTE, kWidth, kHeight));
    drawPixelSceneOpenGl(scene, parameter);
    glFinish();
    OSMesaDestroyContext(context);
    return fromBytes(bytes);
}

Picture ourPicture(PixelScene scene, int parameter) {
    std::vector<unsigned char> bytes(std::size_t(kWidth) * kHeight * 4);
    const RTcontext context = rtCreateContext();
    rtMakeCurrent(context);
    rtSetFrameBuffer(bytes.data(), kWidth, kHeight, RT_RGBA_8);
    drawPixelSceneOpenRt(scene, parameter);
    rtRender();
    const RTenum error = rtGetError();
    EXPECT_EQ(error, RTenum(RT_NO_ERROR)) << rtGetErrorText();
    rtDestroyContext(context);
    return fromBytes(bytes);
}

struct Difference {
    int drawn = 0;    ///< pixels that are not black in one picture or the other
    int exact = 0;    ///< of all, pixels that differ
    int beside = 0;   ///< of these, those that have no like in the neighbourhood either
    double meanOfSame = 0; ///< of the channels, in 1/255, where both have drawn
};

bool isNear(const Rgb& a, const Rgb& b, int tolerance) {
    for (int k = 0; k < 3; ++k)
        if (std::abs(a[k] - b[k]) > tolerance) return false;
    return true;
}

Difference compare(const Picture& a, const Picture& b, int tolerance) {
    Difference result;
    constexpr Rgb kBlack{};
    int same = 0;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const std::size_t at = std::size_t(y) * kWidth + x;
            if (a[at] == kBlack && b[at] == kBlack) continue;
            ++result.drawn;
            if (a[at] != kBlack && b[at] != kBlack) {
                ++same;
                for (int k = 0; k < 3; ++k)
                    result.meanOfSame += std::abs(a[at][k] - b[at][k]) / 3.0;
            }
            if (isNear(a[at], b[at], tolerance)) continue;
            ++result.exact;
            const auto hasLike = [&](const Picture& from, const Picture& in) {
                for (int j = std::max(y - 1, 0); j <= std::min(y + 1, kHeight - 1); ++j)
                    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, kWidth - 1); ++i)
                        if (isNear(from[at], in[std::size_t(j) * kWidth + i], tolerance))
                            return true;
                return false;
            };
            result.beside += !hasLike(a, b) || !hasLike(b, a);
        }
    if (same > 0) result.meanOfSame /= same;
    return result;
}

/// `allowed`: share of the drawn pixels that may differ; `apart`: that may have no like beside.
void expectAlike(PixelScene scene, int parameter, double allowed, int tolerance = 1,
                 double apart = 0.0) {
    const Picture mesa = mesaPicture(scene, parameter), ours = ourPicture(scene, parameter);
    const Difference found = compare(mesa, ours, tolerance);
    EXPECT_GT(found.drawn, 20);
    EXPECT_LE(found.exact, allowed * found.drawn) << "of " << found.drawn;
    EXPECT_LE(found.beside, apart * found.drawn) << "of " << found.drawn;
    testing::Test::RecordProperty("differing", found.exact);
    testing::Test::RecordProperty("drawn", found.drawn);
}

TEST(PixelPictures, TheComparisonSeesShiftsAndColours) {
    const Picture lines = mesaPicture(SCENE_STAR, 1);
    Picture shifted = lines, colored = lines;
    for (std::size_t i = shifted.size() - 1; i >= 2; --i) shifted[i] = shifted[i - 2];
    for (Rgb& pixel : colored) pixel[0] = pixel[0] * 9 / 10;
    EXPECT_GT(compare(lines, shifted, 1).exact, compare(lines, lines, 1).drawn / 2);
    EXPECT_GT(compare(lines, colored, 1).beside, 0);
}

TEST(PixelPictures, Points) {
    for (int size = 1; size <= 8; ++size) expectAlike(SCENE_POINTS, size, 0.0);
}
TEST(PixelPictures, PointsAtBorders) { expectAlike(SCENE_POINTS_AT_BORDERS, 0, 0.0); }
TEST(PixelPictures, LinesOfAllDirections) {
    // Where ends overlap other lines, their colours meet.
    for (int width = 1; width <= 6; ++width)
        width % 2 ? expectAlike(SCENE_STAR, width, 0.01)
                  : expectAlike(SCENE_STAR, width, 0.03, 1, 0.002);
}
TEST(PixelPictures, LinesAcrossBorders) {
    for (int width = 1; width <= 4; ++width)
        expectAlike(SCENE_RANDOM_LINES, width, 0.015, 1, 0.001);
}
TEST(PixelPictures, Stipple) {
    for (int factor = 1; factor <= 3; ++factor) expectAlike(SCENE_STIPPLE, factor, 0.11, 1, 0.06);
}
TEST(PixelPictures, StripAndLoop) { expectAlike(SCENE_STRIP_AND_LOOP, 0, 0.01); }
TEST(PixelPictures, ShadedLines) { expectAlike(SCENE_SHADED_LINES, 0, 0.02, 3); }
TEST(PixelPictures, CubeWithHiddenLines) { expectAlike(SCENE_CUBE_EDGES, 0, 0.02); }
TEST(PixelPictures, SphereEdges) { expectAlike(SCENE_SPHERE_EDGES, 0, 0.02); }
TEST(PixelPictures, EdgeFlags) { expectAlike(SCENE_EDGE_FLAGS, 0, 0.015); }
TEST(PixelPictures, FaceModes) { expectAlike(SCENE_FACE_MODES, 0, 0.01); }
TEST(PixelPictures, PolygonPoints) { expectAlike(SCENE_POLYGON_POINTS, 0, 0.0); }
TEST(PixelPictures, ClipPlane) { expectAlike(SCENE_CLIP_PLANE, 0, 0.02); }
TEST(PixelPictures, NearPlane) { expectAlike(SCENE_NEAR_PLANE, 0, 0.02); }
TEST(PixelPictures, Bitmaps) { expectAlike(SCENE_BITMAPS, 0, 0.0); }
TEST(PixelPictures, DrawPixels) {
    for (int zoom = 0; zoom < 4; ++zoom) expectAlike(SCENE_DRAW_PIXELS, zoom, zoom == 0 ? 0 : 0.1);
}
TEST(PixelPictures, FoggedLitLines) { expectAlike(SCENE_FOGGED_LIT_LINES, 0, 0.02, 3); }
TEST(PixelPictures, Order) { expectAlike(SCENE_ORDER, 0, 0.01); }
TEST(PixelPictures, Lists) { expectAlike(SCENE_LISTS, 0, 0.01); }

} // namespace
