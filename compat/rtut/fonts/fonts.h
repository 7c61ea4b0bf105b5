/* SPDX-License-Identifier: MIT */
/* The tables that make_fonts.py writes. */
#pragma once

enum {
    kFirstCode = 32,
    kLastAscii = 126, /* then come the codes from 160 to 255 */
    kFirstLatin = 160,
    kBitmapGlyphs = 191,
    kStrokeGlyphs = 96, /* codes 32 to 127 */
    kGlyphHead = 5
};

/* A glyph in hexadecimal: width, height, left and bottom of its box from the origin, advance (a
 * byte each, two's complement), then its rows from the bottom up, leftmost pixel in the highest
 * bit, each in whole bytes. */
extern const char *const rtutBitmapGlyphs_9_by_15[kBitmapGlyphs];
extern const char *const rtutBitmapGlyphs_8_by_13[kBitmapGlyphs];
extern const char *const rtutBitmapGlyphs_times_roman_10[kBitmapGlyphs];
extern const char *const rtutBitmapGlyphs_times_roman_24[kBitmapGlyphs];
extern const char *const rtutBitmapGlyphs_helvetica_10[kBitmapGlyphs];
extern const char *const rtutBitmapGlyphs_helvetica_12[kBitmapGlyphs];
extern const char *const rtutBitmapGlyphs_helvetica_18[kBitmapGlyphs];

/* A glyph as pairs of characters, each a number counted from 'R': left and right side, then the
 * points of its lines, x to the right and y downwards; the pair " R" lifts the pen. */
extern const char *const rtutStrokeGlyphs[kStrokeGlyphs];
