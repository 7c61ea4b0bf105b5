# SPDX-License-Identifier: MIT
"""Pictures in OpenEXR and Radiance's format, written without their libraries, for tests and as first
inputs of fuzzing. Pixels are rows, from the top, of (r, g, b)."""
import math
import struct
import zlib

NONE, RLE, ZIPS, ZIP = 0, 1, 2, 3
ROWS_OF_BLOCK = {NONE: 1, RLE: 1, ZIPS: 1, ZIP: 16}
HALF, FLOAT = 1, 2
LETTER = {HALF: "e", FLOAT: "f"}


def attribute(name, kind, value):
    return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<I", len(value)) + value


def channel(name, kind, sampling=1):
    return name.encode() + b"\0" + struct.pack("<IB3xii", kind, 0, sampling, sampling)


def exr_header(width, height, *more, channels=None, compression=NONE, version=2, at=(0, 0)):
    window = struct.pack("<4i", *at, at[0] + width - 1, at[1] + height - 1)
    channels = channels or [channel(name, FLOAT) for name in "BGR"]
    return (struct.pack("<II", 0x01312f76, version)
            + attribute("channels", "chlist", b"".join(channels) + b"\0")
            + attribute("compression", "compression", bytes([compression]))
            + attribute("dataWindow", "box2i", window)
            + attribute("displayWindow", "box2i", window)
            + attribute("lineOrder", "lineOrder", b"\0")
            + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
            + attribute("screenWindowCenter", "v2f", bytes(8))
            + attribute("screenWindowWidth", "float", struct.pack("<f", 1))
            + b"".join(more) + b"\0")


def rearranged(data):
    """As OpenEXR has bytes before it packs them: every other one, and their differences."""
    split = data[::2] + data[1::2]
    return bytes([split[0]] + [(b - a + 128) & 255 for a, b in zip(split, split[1:])])


def runs(data):
    packed, at = b"", 0
    while at < len(data):
        end = at + 1
        while end < len(data) and data[end] == data[at] and end - at < 127:
            end += 1
        if end - at > 2:
            packed += bytes([end - at - 1, data[at]])
        else:
            end = at + 1
            packed += bytes([255, data[at]])
        at = end
    return packed


def block_of(data, compression):
    if compression == NONE:
        return data
    packed = (runs if compression == RLE else zlib.compress)(rearranged(data))
    return packed if len(packed) < len(data) else data


def exr(rows, kind=FLOAT, compression=NONE, at=(0, 0), grey=False):
    """Lines, as most files have them."""
    width, height = len(rows[0]), len(rows)
    names = "Y" if grey else "BGR"
    header = exr_header(width, height, channels=[channel(name, kind) for name in names],
                        compression=compression, at=at)

    def line(row):
        return b"".join(struct.pack(f"<{width}{LETTER[kind]}",
                                    *(pixel["RGBY".index(name) % 3] for pixel in row))
                        for name in names)
    step = ROWS_OF_BLOCK[compression]
    blocks = []
    for y in range(0, height, step):
        data = block_of(b"".join(line(row) for row in rows[y:y + step]), compression)
        blocks.append(struct.pack("<iI", at[1] + y, len(data)) + data)
    return header + table_and(blocks, len(header))


def tiled_exr(rows, side):
    width, height = len(rows[0]), len(rows)
    header = exr_header(width, height, attribute("tiles", "tiledesc",
                                                 struct.pack("<IIB", side, side, 0)),
                        version=0x202)
    tiles = []
    for y in range(0, height, side):
        for x in range(0, width, side):
            data = b"".join(struct.pack("<f", pixel["RGB".index(name)])
                            for row in rows[y:y + side] for name in "BGR"
                            for pixel in row[x:x + side])
            tiles.append(struct.pack("<4iI", x // side, y // side, 0, 0, len(data)) + data)
    return header + table_and(tiles, len(header))


def table_and(blocks, start):
    at, table = start + 8 * len(blocks), b""
    for block in blocks:
        table += struct.pack("<Q", at)
        at += len(block)
    return table + b"".join(blocks)


def rgbe(pixel):
    brightest = max(pixel)
    if brightest < 1e-32:
        return bytes(4)
    mantissa, exponent = math.frexp(brightest)
    scale = mantissa * 256 / brightest
    return bytes([int(value * scale) for value in pixel] + [exponent + 128])


def hdr(rows, packed=True):
    width, height = len(rows[0]), len(rows)
    data = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + f"-Y {height} +X {width}\n".encode()
    for row in rows:
        pixels = [rgbe(pixel) for pixel in row]
        if not packed:
            data += b"".join(pixels)
            continue
        data += bytes([2, 2, width >> 8, width & 255])
        for component in range(4):
            values, at = bytes(pixel[component] for pixel in pixels), 0
            while at < width:
                same = at + 1
                while same < width and values[same] == values[at] and same - at < 127:
                    same += 1
                if same - at > 2:
                    data += bytes([128 + same - at, values[at]])
                    at = same
                else:
                    part = values[at:at + 2]
                    data += bytes([len(part)]) + part
                    at += len(part)
    return data
