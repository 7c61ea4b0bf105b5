#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the fonts of rtut as C tables, from files of the X window system and Hershey's.

    make_fonts.py --x11 /usr/share/fonts/X11 --hershey /usr/share/hershey-fonts

Debian has them in xfonts-base, xfonts-75dpi and hershey-fonts-data. The tables are kept with the
sources: this is run again only when they shall change. Their licences are in NOTICE.
"""
import argparse
import gzip
import pathlib
import struct

HERE = pathlib.Path(__file__).resolve().parent
PUBLIC_DOMAIN = "the fixed font of the X window system: public domain"
ADOBE = "a font of the X window system, by Adobe Systems and Digital Equipment: see NOTICE"
BITMAP_FONTS = [
    ("9_by_15", "misc/9x15-ISO8859-1.pcf.gz", PUBLIC_DOMAIN),
    ("8_by_13", "misc/8x13-ISO8859-1.pcf.gz", PUBLIC_DOMAIN),
    ("times_roman_10", "75dpi/timR10-ISO8859-1.pcf.gz", ADOBE),
    ("times_roman_24", "75dpi/timR24-ISO8859-1.pcf.gz", ADOBE),
    ("helvetica_10", "75dpi/helvR10-ISO8859-1.pcf.gz", ADOBE),
    ("helvetica_12", "75dpi/helvR12-ISO8859-1.pcf.gz", ADOBE),
    ("helvetica_18", "75dpi/helvR18-ISO8859-1.pcf.gz", ADOBE),
]
CODES = [*range(32, 127), *range(160, 256)]


class Pcf:
    """The glyphs of a compiled X11 font by their code: (width, height, left, bottom, advance,
    rows from the bottom up as bytes)."""

    METRICS, BITMAPS, ENCODINGS = 4, 8, 32

    def __init__(self, data):
        self.data = data
        count = struct.unpack_from("<I", data, 4)[0]
        self.tables = {}
        for i in range(count):
            kind, form, _, offset = struct.unpack_from("<4I", data, 8 + 16 * i)
            self.tables[kind] = (form, offset)
        self.metrics = self.read_metrics()
        self.bitmaps = self.read_bitmaps()
        self.codes = self.read_encodings()

    def start(self, kind):
        form, offset = self.tables[kind]
        return form, ">" if form & 4 else "<", offset + 4

    def read_metrics(self):
        form, order, at = self.start(self.METRICS)
        if form & 0x100:
            count = struct.unpack_from(order + "H", self.data, at)[0]
            return [tuple(b - 0x80 for b in self.data[at + 2 + 5 * i:at + 7 + 5 * i])
                    for i in range(count)]
        count = struct.unpack_from(order + "I", self.data, at)[0]
        return [struct.unpack_from(order + "5h", self.data, at + 4 + 12 * i) for i in range(count)]

    def read_bitmaps(self):
        form, order, at = self.start(self.BITMAPS)
        count = struct.unpack_from(order + "I", self.data, at)[0]
        offsets = struct.unpack_from(f"{order}{count}I", self.data, at + 4)
        base = at + 4 + 4 * count + 16
        pad, msb_first, unit = 1 << (form & 3), bool(form & 8), 1 << (form >> 4 & 3)
        if not msb_first or (unit > 1 and not form & 4):
            raise ValueError("bits of this font are in another order")
        result = []
        for (left, right, _, ascent, descent), offset in zip(self.metrics, offsets):
            stride = ((right - left + 7) // 8 + pad - 1) // pad * pad
            used = (right - left + 7) // 8
            rows = [self.data[base + offset + r * stride:base + offset + r * stride + used]
                    for r in range(ascent + descent)]
            result.append(rows[::-1])
        return result

    def read_encodings(self):
        _, order, at = self.start(self.ENCODINGS)
        low, high, low_row, high_row, _ = struct.unpack_from(order + "5H", self.data, at)
        codes = {}
        for row in range(low_row, high_row + 1):
            for column in range(low, high + 1):
                place = (row - low_row) * (high - low + 1) + column - low
                glyph = struct.unpack_from(order + "H", self.data, at + 10 + 2 * place)[0]
                if glyph != 0xFFFF:
                    codes[row * 256 + column] = glyph
        return codes

    def glyph(self, code):
        left, right, advance, ascent, descent = self.metrics[self.codes[code]]
        return right - left, ascent + descent, left, -descent, advance, \
            self.bitmaps[self.codes[code]]


def literal(text):
    """C string literals of at most 92 characters each, one a line."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    lines, at = [], 0
    while at < len(escaped) or not lines:
        end = min(at + 90, len(escaped))
        while end < len(escaped) and escaped[end - 1] == "\\":
            end -= 1
        lines.append(f'     "{escaped[at:end]}"')
        at = end
    lines[0] = "    " + lines[0][5:]
    return "\n".join(lines)


def write_bitmap_font(name, source, origin, x11):
    font = Pcf(gzip.decompress((x11 / source).read_bytes()))
    lines = ["/* SPDX-License-Identifier: MIT */",
             "/* Written by make_fonts.py. */",
             f"/* {origin[0].upper()}{origin[1:]}. */",
             '#include "compat/rtut/fonts/fonts.h"', "",
             f"const char *const rtutBitmapGlyphs_{name}[{len(CODES)}] = {{"]
    for code in CODES:
        if code in font.codes:
            width, height, left, bottom, advance, rows = font.glyph(code)
            head = bytes(v & 0xFF for v in (width, height, left, bottom, advance))
            lines.append(literal((head + b"".join(rows)).hex()) + ",")
        else:
            lines.append('    "0000000000",')
    lines.append("};")
    (HERE / f"bitmap_{name}.c").write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_stroke_font(hershey):
    glyphs = []
    for line in (hershey / "rowmans.jhf").read_text(encoding="ascii").splitlines():
        if len(line) > 5 and line[:8].strip()[:1].isdigit() and line[5:8].strip().isdigit():
            glyphs.append(line[8:])
        else:
            glyphs[-1] += line
    if len(glyphs) != 96:
        raise ValueError(f"{len(glyphs)} glyphs, not 96")
    lines = ["/* SPDX-License-Identifier: MIT */",
             "/* Written by make_fonts.py. */",
             "/* Roman Simplex, created by Dr. A. V. Hershey while working at the U. S. National",
             " * Bureau of Standards, in the format of James Hurt, Cognition, Inc.: see NOTICE. */",
             '#include "compat/rtut/fonts/fonts.h"', "",
             f"const char *const rtutStrokeGlyphs[{len(glyphs)}] = {{"]
    lines += [literal(glyph) + "," for glyph in glyphs] + ["};"]
    (HERE / "stroke_roman.c").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--x11", type=pathlib.Path, required=True)
    parser.add_argument("--hershey", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    for name, source, origin in BITMAP_FONTS:
        write_bitmap_font(name, source, origin, arguments.x11)
    write_stroke_font(arguments.hershey)


if __name__ == "__main__":
    main()
