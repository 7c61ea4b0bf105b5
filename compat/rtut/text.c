/* SPDX-License-Identifier: MIT */
/* Text in bitmaps and in lines. */
#include <stddef.h>

#include "compat/rtut/drawing_names.h"
#include "compat/rtut/drawing_state.h"
#include "compat/rtut/fonts/fonts.h"

enum { kStrokeRoman, kStrokeMonoRoman, kFirstBitmapFont, kFonts = 9, kMaxGlyphBytes = 128 };

static int fontNumber(void *font) {
    const size_t number = (size_t)font;
    return number < kFonts ? (int)number : -1;
}

static const char *bitmapGlyph(void *font, int character) {
    static const char *const *const fonts[kFonts - kFirstBitmapFont] = {
        rtutBitmapGlyphs_9_by_15,        rtutBitmapGlyphs_8_by_13,
        rtutBitmapGlyphs_times_roman_10, rtutBitmapGlyphs_times_roman_24,
        rtutBitmapGlyphs_helvetica_10,   rtutBitmapGlyphs_helvetica_12,
        rtutBitmapGlyphs_helvetica_18,
    };
    const int number = fontNumber(font);
    if (number < kFirstBitmapFont) return NULL;
    if (character >= kFirstCode && character <= kLastAscii)
        return fonts[number - kFirstBitmapFont][character - kFirstCode];
    if (character >= kFirstLatin && character <= 255)
        return fonts[number - kFirstBitmapFont]
                    [character - kFirstLatin + kLastAscii - kFirstCode + 1];
    return NULL;
}

static int hexDigit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }
static int hexByte(const char *glyph, int index) {
    return 16 * hexDigit(glyph[2 * index]) + hexDigit(glyph[2 * index + 1]);
}
static int signedByte(const char *glyph, int index) {
    const int byte = hexByte(glyph, index);
    return byte < 128 ? byte : byte - 256;
}

RTAPI int RTAPIENTRY rtutBitmapWidth(void *font, int character) {
    const char *glyph = bitmapGlyph(font, character);
    return glyph != NULL ? signedByte(glyph, 4) : 0;
}

RTAPI int RTAPIENTRY rtutBitmapLength(void *font, const unsigned char *string) {
    int length = 0;
    while (string != NULL && *string != 0) length += rtutBitmapWidth(font, *string++);
    return length;
}

RTAPI void RTAPIENTRY rtutBitmapCharacter(void *font, int character) {
    static const RTenum names[6] = {RT_UNPACK_SWAP_BYTES, RT_UNPACK_LSB_FIRST,
                                    RT_UNPACK_ROW_LENGTH, RT_UNPACK_SKIP_ROWS,
                                    RT_UNPACK_SKIP_PIXELS, RT_UNPACK_ALIGNMENT};
    const char *glyph = bitmapGlyph(font, character);
    RTint saved[6] = {0, 0, 0, 0, 0, 4};
    RTubyte rows[kMaxGlyphBytes];
    int width, height, bytes, i;
    if (glyph == NULL) return;
    width = hexByte(glyph, 0);
    height = hexByte(glyph, 1);
    bytes = (width + 7) / 8 * height;
    for (i = 0; i < bytes && i < kMaxGlyphBytes; ++i)
        rows[i] = (RTubyte)hexByte(glyph, kGlyphHead + i);
    for (i = 0; i < 6; ++i) {
        rtGetIntegerv(names[i], &saved[i]);
        rtPixelStorei(names[i], i == 5 ? 1 : 0);
    }
    rtBitmap(width, height, (RTfloat)-signedByte(glyph, 2), (RTfloat)-signedByte(glyph, 3),
             (RTfloat)signedByte(glyph, 4), 0.0f, rows);
    for (i = 0; i < 6; ++i) rtPixelStorei(names[i], saved[i]);
}

/* ---- Strokes --------------------------------------------------------------------------------- */

/* Hershey's units in those of GLUT, which makes capital letters 100 high. */
static const float kUnit = 100.0f / 21.0f;
static const float kBaseline = 9.0f;   /* downwards from the middle */
static const float kMonoWidth = 22.0f; /* of each character of the mono-spaced font */

typedef struct {
    const char *points; /* NULL: no such character */
    float left, scale;  /* x of a point: (x - left) * scale */
    float width;
} StrokeGlyph;

static float coordinate(char c) { return (float)(c - 'R'); }

static StrokeGlyph strokeGlyph(void *font, int character) {
    StrokeGlyph glyph = {NULL, 0, 0, 0};
    const int number = fontNumber(font);
    const char *text;
    float natural;
    if (number != kStrokeRoman && number != kStrokeMonoRoman) return glyph;
    if (character < kFirstCode || character >= kFirstCode + kStrokeGlyphs) return glyph;
    text = rtutStrokeGlyphs[character - kFirstCode];
    natural = coordinate(text[1]) - coordinate(text[0]);
    glyph.points = text + 2;
    glyph.left = coordinate(text[0]);
    glyph.scale = kUnit;
    glyph.width = natural * kUnit;
    if (number == kStrokeMonoRoman) {
        /* Wide characters are narrowed, others stand in the middle. */
        if (natural > kMonoWidth)
            glyph.scale = kUnit * kMonoWidth / natural;
        else
            glyph.left -= (kMonoWidth - natural) / 2;
        glyph.width = kMonoWidth * kUnit;
    }
    return glyph;
}

RTAPI int RTAPIENTRY rtutStrokeWidth(void *font, int character) {
    return (int)(strokeGlyph(font, character).width + 0.5f);
}

RTAPI int RTAPIENTRY rtutStrokeLength(void *font, const unsigned char *string) {
    float length = 0;
    while (string != NULL && *string != 0) length += strokeGlyph(font, *string++).width;
    return (int)(length + 0.5f);
}

RTAPI void RTAPIENTRY rtutStrokeCharacter(void *font, int character) {
    const StrokeGlyph glyph = strokeGlyph(font, character);
    const char *point = glyph.points;
    int drawing = 0;
    if (point == NULL || !isOutsidePrimitive()) return;
    for (; point[0] != 0 && point[1] != 0; point += 2) {
        if (point[0] == ' ' && point[1] == 'R') {
            if (drawing) rtEnd();
            drawing = 0;
            continue;
        }
        if (!drawing) rtBegin(RT_LINE_STRIP);
        drawing = 1;
        rtVertex2f((coordinate(point[0]) - glyph.left) * glyph.scale,
                   (kBaseline - coordinate(point[1])) * kUnit);
    }
    if (drawing) rtEnd();
    rtTranslatef(glyph.width, 0.0f, 0.0f);
}
