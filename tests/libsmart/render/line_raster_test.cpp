// SPDX-License-Identifier: MIT
// The rule of diamonds, written out in rational numbers with ends that are really moved, against
// the integers that decide it; points and images against their definitions pixel by pixel.
#include "libsmart/render/line_raster.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "libsmart/render/image_raster.h"
#include "libsmart/render/point_raster.h"

namespace smart {
namespace {

using Pixels = std::set<std::pair<int, int>>;
constexpr int kSide = 24;
constexpr Tile kTile{0, 0, kSide, kSide};

struct RationalPoint {
    mpq_class x, y;
};

/// Moved by (-e, -e * e) with e = 2^-60: small beside all that coordinates in 256ths of a few
/// pixels can differ by.
RationalPoint moved(int x256, int y256) {
    mpq_class e(1, 1);
    e /= mpq_class(mpz_class(1) << 60);
    return {mpq_class(x256, 256) - e, mpq_class(y256, 256) - e * e};
}

bool isInDiamond(const RationalPoint& p, int i, int j) {
    const mpq_class x = abs(p.x - mpq_class(2 * i + 1, 2)), y = abs(p.y - mpq_class(2 * j + 1, 2));
    return x + y < mpq_class(1, 2);
}

/// Whether some point of the segment lies in the open diamond: it is the meeting of four open
/// half-planes.
bool meetsDiamond(const RationalPoint& a, const RationalPoint& b, int i, int j) {
    mpq_class low = 0, high = 1; // of the parameter; the ends count only if they are inside
    for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) {
            const auto at = [&](const RationalPoint& p) -> mpq_class {
                return sx * (p.x - mpq_class(2 * i + 1, 2)) + sy * (p.y - mpq_class(2 * j + 1, 2)) -
                       mpq_class(1, 2);
            };
            const mpq_class fa = at(a), fb = at(b);
            if (fa >= 0 && fb >= 0) return false;
            const mpq_class t = fa == fb ? mpq_class(0) : mpq_class(fa / (fa - fb));
            if (fa >= 0 && t > low) low = t;
            if (fb >= 0 && t < high) high = t;
        }
    return low < high;
}

Pixels byDiamonds(int ax, int ay, int bx, int by, bool lastToo = false) {
    const RationalPoint a = moved(ax, ay), b = moved(bx, by);
    Pixels pixels;
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i)
            if (meetsDiamond(a, b, i, j) && (lastToo || !isInDiamond(b, i, j)))
                pixels.insert({i, j});
    return pixels;
}

Pixels coverageOf(int ax, int ay, int bx, int by, uint32_t width = 1) {
    Pixels pixels;
    LineCoverage({ax / 256.0, ay / 256.0}, {bx / 256.0, by / 256.0}, width)
        .forEach(kTile, [&](uint32_t x, uint32_t y, uint32_t) {
            EXPECT_TRUE(pixels.insert({int(x), int(y)}).second);
        });
    return pixels;
}

/// Ends on a grid of so many subpixels: a coarse one has all the ties.
template <class Check>
void forLines(int grid, int count, Check&& check) {
    std::mt19937 random(unsigned(grid) + 7);
    const int steps = (kSide - 2) * 256 / grid;
    const auto coordinate = [&] { return 256 + int(random() % unsigned(steps + 1)) * grid; };
    for (int n = 0; n < count; ++n) {
        const int ax = coordinate(), ay = coordinate(), bx = coordinate(), by = coordinate();
        check(ax, ay, bx, by);
    }
}

TEST(LineRaster, CoversDiamondsThatAreLeft) {
    for (const int grid : {1, 64, 128, 256})
        forLines(grid, 40, [](int ax, int ay, int bx, int by) {
            EXPECT_EQ(coverageOf(ax, ay, bx, by), byDiamonds(ax, ay, bx, by))
                << ax << ',' << ay << " to " << bx << ',' << by;
        });
}

TEST(LineRaster, ShortLinesToo) {
    std::mt19937 random(11);
    for (int n = 0; n < 200; ++n) {
        const auto near = [&] { return 512 + int(random() % 9) * 64; };
        const int ax = near(), ay = near(), bx = near(), by = near();
        EXPECT_EQ(coverageOf(ax, ay, bx, by), byDiamonds(ax, ay, bx, by))
            << ax << ',' << ay << " to " << bx << ',' << by;
    }
}

TEST(LineRaster, TheCheckSeesAPixelTooMany) {
    int differing = 0;
    forLines(64, 20, [&](int ax, int ay, int bx, int by) {
        differing += coverageOf(ax, ay, bx, by) != byDiamonds(ax, ay, bx, by, true);
    });
    EXPECT_GT(differing, 5);
}

TEST(LineRaster, WideLinesAreColumnsOfAThinOne) {
    forLines(32, 12, [](int ax, int ay, int bx, int by) {
        for (const int width : {2, 3, 7}) {
            const bool steep = std::abs(by - ay) > std::abs(bx - ax);
            const int shift = (width - 1) * 128;
            const Pixels thin = steep ? byDiamonds(ax - shift, ay, bx - shift, by)
                                      : byDiamonds(ax, ay - shift, bx, by - shift);
            Pixels wide;
            for (const auto& [x, y] : thin)
                for (int k = 0; k < width; ++k) {
                    const std::pair at = steep ? std::pair(x + k, y) : std::pair(x, y + k);
                    if (at.first < kSide && at.second < kSide) wide.insert(at);
                }
            // What the shift takes out of the picture is not in `thin`.
            const Pixels found = coverageOf(ax, ay, bx, by, uint32_t(width));
            const int margin = width;
            for (int j = margin; j < kSide - margin; ++j)
                for (int i = margin; i < kSide - margin; ++i)
                    EXPECT_EQ(found.count({i, j}), wide.count({i, j})) << i << ' ' << j;
        }
    });
}

TEST(LineRaster, TilesShareALine) {
    const LineCoverage line({-5.3, 2.25}, {130.7, 91.4}, 3);
    std::multiset<std::pair<uint32_t, uint32_t>> apart, whole;
    std::set<uint32_t> steps;
    line.forEach({0, 0, 128, 96}, [&](uint32_t x, uint32_t y, uint32_t step) {
        whole.insert({x, y});
        steps.insert(step);
    });
    for (uint32_t y = 0; y < 96; y += 32)
        for (uint32_t x = 0; x < 128; x += 32)
            line.forEach({x, y, 32, 32},
                         [&](uint32_t i, uint32_t j, uint32_t) { apart.insert({i, j}); });
    EXPECT_EQ(apart, whole);
    EXPECT_EQ(steps.size(), 128u);
    EXPECT_EQ(line.length(), 136u);
}

TEST(LineRaster, FarEndsStayExact) {
    // From limit to limit: y = x / 2 through pixel 10.
    const LineCoverage line({kWindowMin, kWindowMin / 2 + 0.25},
                            {kWindowMax, kWindowMax / 2 + 0.25}, 1);
    int count = 0;
    line.forEach(kTile, [&](uint32_t x, uint32_t y, uint32_t) {
        EXPECT_EQ(y, uint32_t(std::floor((x + 0.5) / 2 + 0.25)));
        ++count;
    });
    EXPECT_EQ(count, kSide);
}

TEST(LineRaster, RectangleCoverageIsItsArea) {
    std::mt19937 random(5);
    const auto coordinate = [&] { return 4.0 + 16.0 * (random() >> 8) / double(1 << 24); };
    for (int n = 0; n < 12; ++n) {
        const glm::dvec2 a(coordinate(), coordinate()), b(coordinate(), coordinate());
        const LineRectangle rectangle(a, b, 2.5);
        double sum = 0.0;
        for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i) {
                const double share = rectangle.coverage(i, j);
                sum += share;
                int inside = 0; // of 400 points
                for (int k = 0; k < 400; ++k)
                    inside += rectangle.contains(
                        {i + (k % 20 + 0.5) / 20, j + (int(k / 20) + 0.5) / 20});
                EXPECT_NEAR(share, inside / 400.0, 0.06);
            }
        EXPECT_NEAR(sum, 2.5 * std::hypot(b.x - a.x, b.y - a.y), 1e-9);
        Pixels visited;
        rectangle.forEach(kTile, [&](uint32_t x, uint32_t y) { visited.insert({x, y}); });
        for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i)
                EXPECT_LE(rectangle.coverage(i, j) > 0, visited.count({i, j}) > 0);
    }
}

TEST(PointRaster, SquaresByTheDefinition) {
    std::mt19937 random(3);
    for (int n = 0; n < 300; ++n) {
        const double x = 256 / 64.0 + double(random() % 64) / 4, y = 4 + double(random() % 64) / 4;
        const int size = 1 + int(random() % 8);
        const PixelBox box = pointSquare({x, y}, float(size) + (n % 3 - 1) * 0.3f);
        const bool odd = size % 2 != 0;
        const double cx = odd ? std::floor(x) + 0.5 : std::floor(x + 0.5);
        const double cy = odd ? std::floor(y) + 0.5 : std::floor(y + 0.5);
        for (int j = -8; j < 32; ++j)
            for (int i = -8; i < 32; ++i) {
                const bool inside = std::abs(i + 0.5 - cx) < size / 2.0 &&
                                    std::abs(j + 0.5 - cy) < size / 2.0;
                const bool found =
                    i >= box.xLow && i < box.xHigh && j >= box.yLow && j < box.yHigh;
                EXPECT_EQ(found, inside) << x << ' ' << y << ' ' << size;
            }
    }
}

TEST(PointRaster, DiscsHaveTheirArea) {
    for (const float size : {1.0f, 2.5f, 5.0f, 10.0f}) {
        const PointDisc disc({12.3, 11.8}, size);
        double sum = 0.0;
        disc.box().forEach(kTile, [&](uint32_t x, uint32_t y) { sum += disc.coverage(x, y); });
        const double area = 3.14159265358979 * double(size) * double(size) / 4;
        EXPECT_NEAR(sum, area, 0.02 * area);
    }
}

TEST(PointRaster, SizesThatAreNone) {
    for (const float size : {0.0f, -3.0f, std::nanf(""), 0.4f}) EXPECT_EQ(wholePixels(size), 1u);
    EXPECT_EQ(wholePixels(1e30f), uint32_t(kMaxPixelSize));
}

TEST(ImageRaster, EachPixelsCentreChooses) {
    const auto pixels = std::make_shared<ImagePixels>();
    pixels->width = 5;
    pixels->height = 4;
    std::mt19937 random(9);
    for (int n = 0; n < 200; ++n) {
        WindowImage image;
        image.pixels = pixels;
        const auto zoom = [&] { return (int(random() % 17) - 8) / 4.0; };
        image.corner = {8 + double(random() % 16) / 4, 8 + double(random() % 16) / 4};
        image.zoom = {zoom(), zoom()};
        std::set<std::array<uint32_t, 4>> found, wanted;
        ImageCoverage(image).forEach(kTile, [&](uint32_t x, uint32_t y, uint32_t i, uint32_t j) {
            found.insert({x, y, i, j});
        });
        // Pixel i is the window from corner + zoom * i to corner + zoom * (i + 1); its lower and
        // left sides belong to it.
        const auto holds = [](double corner, double factor, uint32_t number, uint32_t pixel) {
            const double a = corner + factor * number, b = corner + factor * (number + 1);
            return pixel + 0.5 >= std::min(a, b) && pixel + 0.5 < std::max(a, b);
        };
        for (uint32_t y = 0; y < kSide; ++y)
            for (uint32_t x = 0; x < kSide; ++x)
                for (uint32_t j = 0; j < 4; ++j)
                    for (uint32_t i = 0; i < 5; ++i)
                        if (holds(image.corner.x, image.zoom.x, i, x) &&
                            holds(image.corner.y, image.zoom.y, j, y))
                            wanted.insert({x, y, i, j});
        EXPECT_EQ(found, wanted) << image.corner.x << ' ' << image.zoom.x << ' ' << image.zoom.y;
    }
}

} // namespace
} // namespace smart
