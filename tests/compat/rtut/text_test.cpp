// SPDX-License-Identifier: MIT
// Fonts: sizes, and pictures of a few characters. text.c is compiled into this program.
#include <gtest/gtest.h>
#include <openrt/rt.h>
#include <openrt/rtut.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace {

struct Bitmap {
    int width = 0, height = 0;
    float left = 0, bottom = 0, advance = 0;
    std::vector<RTubyte> rows;

    bool at(int x, int y) const {
        return rows[std::size_t((width + 7) / 8 * y + x / 8)] >> (7 - x % 8) & 1;
    }
    std::string row(int y) const {
        std::string text;
        for (int x = 0; x < width; ++x) text += at(x, y) ? '#' : '.';
        return text;
    }
};
Bitmap bitmap;
int bitmaps = 0;
RTint pixelStore[6] = {1, 1, 3, 4, 5, 8};
std::vector<std::pair<float, float>> points;
int strokes = 0;
float moved = 0;

RTint& stored(RTenum name) {
    switch (name) {
    case RT_UNPACK_SWAP_BYTES: return pixelStore[0];
    case RT_UNPACK_LSB_FIRST: return pixelStore[1];
    case RT_UNPACK_ROW_LENGTH: return pixelStore[2];
    case RT_UNPACK_SKIP_ROWS: return pixelStore[3];
    case RT_UNPACK_SKIP_PIXELS: return pixelStore[4];
    default: return pixelStore[5];
    }
}

} // namespace

extern "C" {
void RTAPIENTRY rtGetIntegerv(RTenum name, RTint* value) { *value = stored(name); }
void RTAPIENTRY rtPixelStorei(RTenum name, RTint value) { stored(name) = value; }
void RTAPIENTRY rtBitmap(RTsizei width, RTsizei height, RTfloat x, RTfloat y, RTfloat moveX,
                         RTfloat moveY, const RTubyte* rows) {
    ++bitmaps;
    EXPECT_EQ(moveY, 0);
    EXPECT_EQ(stored(RT_UNPACK_ALIGNMENT), 1);
    EXPECT_EQ(stored(RT_UNPACK_LSB_FIRST), 0);
    EXPECT_EQ(stored(RT_UNPACK_SKIP_ROWS), 0);
    bitmap = {width, height, -x, -y, moveX, {rows, rows + (width + 7) / 8 * height}};
}
void RTAPIENTRY rtBegin(RTenum mode) {
    EXPECT_EQ(mode, RTenum(RT_LINE_STRIP));
    ++strokes;
}
void RTAPIENTRY rtEnd(void) {}
void RTAPIENTRY rtVertex2f(RTfloat x, RTfloat y) { points.push_back({x, y}); }
void RTAPIENTRY rtTranslatef(RTfloat x, RTfloat, RTfloat) { moved += x; }
}

namespace {

void* const kBitmapFonts[] = {RTUT_BITMAP_9_BY_15,        RTUT_BITMAP_8_BY_13,
                              RTUT_BITMAP_TIMES_ROMAN_10, RTUT_BITMAP_TIMES_ROMAN_24,
                              RTUT_BITMAP_HELVETICA_10,   RTUT_BITMAP_HELVETICA_12,
                              RTUT_BITMAP_HELVETICA_18};

TEST(Bitmaps, anLIsAnL) {
    rtutBitmapCharacter(RTUT_BITMAP_8_BY_13, 'L');
    EXPECT_EQ(bitmap.width, 8);
    EXPECT_EQ(bitmap.height, 13);
    EXPECT_EQ(bitmap.advance, 8);
    EXPECT_EQ(bitmap.bottom, -2);
    EXPECT_EQ(bitmap.row(1), "........");
    EXPECT_EQ(bitmap.row(2), ".######.") << "on the base line";
    for (int y = 3; y < 11; ++y) EXPECT_EQ(bitmap.row(y), ".#......") << y;
    EXPECT_EQ(bitmap.row(11), "........");
}

TEST(Bitmaps, fixedFontsAreFixedAndOthersAreNot) {
    for (int c = 32; c < 127; ++c) {
        EXPECT_EQ(rtutBitmapWidth(RTUT_BITMAP_8_BY_13, c), 8);
        EXPECT_EQ(rtutBitmapWidth(RTUT_BITMAP_9_BY_15, c), 9);
    }
    EXPECT_LT(rtutBitmapWidth(RTUT_BITMAP_HELVETICA_18, 'i'),
              rtutBitmapWidth(RTUT_BITMAP_HELVETICA_18, 'M'));
    EXPECT_LT(rtutBitmapWidth(RTUT_BITMAP_TIMES_ROMAN_10, 'M'),
              rtutBitmapWidth(RTUT_BITMAP_TIMES_ROMAN_24, 'M'));
    const auto* text = reinterpret_cast<const unsigned char*>("A quick fox");
    for (void* font : kBitmapFonts) {
        int sum = 0;
        for (const unsigned char* c = text; *c; ++c) sum += rtutBitmapWidth(font, *c);
        EXPECT_EQ(rtutBitmapLength(font, text), sum);
    }
    EXPECT_EQ(rtutBitmapLength(RTUT_BITMAP_8_BY_13, nullptr), 0);
}

TEST(Bitmaps, everyCharacterIsSoundAndThePixelStoreIsKept) {
    const std::vector<RTint> before(pixelStore, pixelStore + 6);
    for (void* font : kBitmapFonts)
        for (int c = 33; c < 256; ++c) {
            if (c > 126 && c < 161) continue;
            const int count = bitmaps;
            rtutBitmapCharacter(font, c);
            ASSERT_EQ(bitmaps, count + 1);
            EXPECT_EQ(bitmap.advance, rtutBitmapWidth(font, c));
            EXPECT_GT(bitmap.advance, 0);
            const bool ink = std::any_of(bitmap.rows.begin(), bitmap.rows.end(),
                                         [](RTubyte byte) { return byte != 0; });
            EXPECT_TRUE(ink || c == 173) << c; // 173: a hyphen that may be seen or not
        }
    EXPECT_EQ(std::vector<RTint>(pixelStore, pixelStore + 6), before);
}

TEST(Strokes, capitalsAre100High) {
    points.clear();
    moved = 0;
    strokes = 0;
    rtutStrokeCharacter(RTUT_STROKE_ROMAN, 'H');
    EXPECT_EQ(strokes, 3);
    float low = 1e9f, high = -1e9f;
    for (const auto& [x, y] : points) low = std::min(low, y), high = std::max(high, y);
    EXPECT_NEAR(low, 0, 1e-4);
    EXPECT_NEAR(high, 100, 1e-4);
    EXPECT_NEAR(moved, float(rtutStrokeWidth(RTUT_STROKE_ROMAN, 'H')), 0.5001f);
}

TEST(Strokes, allCharactersStayInTheFont) {
    for (void* font : {RTUT_STROKE_ROMAN, RTUT_STROKE_MONO_ROMAN})
        for (int c = 32; c < 128; ++c) {
            points.clear();
            moved = 0;
            rtutStrokeCharacter(font, c);
            EXPECT_GT(moved, 0);
            if (font == RTUT_STROKE_MONO_ROMAN) {
                EXPECT_NEAR(moved, 104.762f, 1e-2f);
            }
            for (const auto& [x, y] : points) {
                EXPECT_GE(y, -33.34f) << c;
                EXPECT_LE(y, 119.06f) << c;
                EXPECT_GE(x, -5.0f) << c;
                EXPECT_LE(x, moved + 5.0f) << c;
            }
        }
    const auto* text = reinterpret_cast<const unsigned char*>("MiM");
    EXPECT_EQ(rtutStrokeLength(RTUT_STROKE_MONO_ROMAN, text), 314);
}

TEST(Fonts, unknownOnesDrawNothing) {
    const int before = bitmaps;
    strokes = 0;
    moved = 0;
    for (const int c : {-1, 0, 31, 127, 159, 256, std::numeric_limits<int>::max(),
                        std::numeric_limits<int>::min()}) {
        rtutBitmapCharacter(RTUT_BITMAP_HELVETICA_12, c);
        EXPECT_EQ(rtutBitmapWidth(RTUT_BITMAP_HELVETICA_12, c), 0);
        if (c != 127) rtutStrokeCharacter(RTUT_STROKE_ROMAN, c);
    }
    int local = 0;
    for (void* font : {static_cast<void*>(&local), reinterpret_cast<void*>(std::size_t(9))}) {
        rtutBitmapCharacter(font, 'A');
        rtutStrokeCharacter(font, 'A');
        EXPECT_EQ(rtutStrokeWidth(font, 'A'), 0);
    }
    rtutBitmapCharacter(RTUT_STROKE_ROMAN, 'A');
    rtutStrokeCharacter(RTUT_BITMAP_8_BY_13, 'A');
    EXPECT_EQ(bitmaps, before);
    EXPECT_EQ(strokes, 0);
    EXPECT_EQ(moved, 0);
}

} // namespace
