# SPDX-License-Identifier: MIT
"""The sample models' images, each a palette picture that repeats without a seam."""

import math

from glb_writer import png_palette
from mesh_shapes import fractal_noise, value_noise


def ramp(stops, count=64):
    """A palette that runs through the given colours (0..255)."""
    palette = []
    for k in range(count):
        t = k / (count - 1) * (len(stops) - 1)
        i = min(int(t), len(stops) - 2)
        f = t - i
        palette.append(tuple(round(a + (b - a) * f) for a, b in zip(stops[i], stops[i + 1])))
    return palette


def shade(size, palette, value):
    """value(x, y) in 0..1 picks from the palette; x, y in 0..1, y down."""
    last = len(palette) - 1
    pixels = [min(last, max(0, round(value((i + 0.5) / size, (j + 0.5) / size) * last)))
              for j in range(size) for i in range(size)]
    return png_palette(size, size, pixels, palette)


def marble(size, stops, seed):
    """Cloudy stone with thin veins where a noise crosses its middle."""
    def value(x, y):
        warp = fractal_noise(x * 4, y * 4, 4, seed, 4)
        vein = fractal_noise(x * 3 + warp, y * 3 + warp, 3, seed + 20, 5)
        sharp = max(0.0, 1 - abs(vein - 0.5) * 22)
        return 0.25 + 0.55 * warp - 0.75 * sharp * (0.4 + warp)
    return shade(size, ramp(stops, 48), value)


def stone(size, stops, seed, grain=0.35):
    """Plain sandstone or plaster: soft patches and grain."""
    def value(x, y):
        patch = fractal_noise(x * 3, y * 3, 3, seed, 4)
        return patch * (1 - grain) + grain * value_noise(x * 64, y * 64, 64, seed + 9)
    return shade(size, ramp(stops, 32), value)


def wood(size, seed):
    """Boards seen along the grain, which runs in x."""
    stops = [(58, 34, 18), (104, 64, 34), (146, 96, 54), (172, 120, 72)]

    def value(x, y):
        bend = fractal_noise(x * 2, y * 4, 4, seed, 3)
        ring = 0.5 + 0.5 * math.sin(2 * math.pi * (y * 9 + 1.6 * bend))
        fibre = value_noise(x * 6, y * 128, 128, seed + 5)
        return 0.15 + 0.55 * ring + 0.3 * fibre
    return shade(size, ramp(stops, 32), value)


def meadow(size, seed):
    stops = [(58, 74, 34), (92, 104, 48), (128, 128, 66), (158, 146, 88)]

    def value(x, y):
        return fractal_noise(x * 4, y * 4, 4, seed, 6)
    return shade(size, ramp(stops, 32), value)


def foliage(size, seed):
    stops = [(14, 30, 14), (30, 58, 24), (54, 88, 36), (84, 116, 50)]

    def value(x, y):
        return (0.6 * value_noise(x * 48, y * 48, 48, seed)
                + 0.4 * value_noise(x * 16, y * 16, 16, seed + 1))
    return shade(size, ramp(stops, 24), value)


def patina(size, seed):
    """Bronze with green where water ran; pairs with patina_roughness."""
    stops = [(206, 138, 68), (190, 122, 60), (164, 108, 58), (126, 112, 74), (86, 128, 104)]
    return shade(size, ramp(stops, 40), lambda x, y: _patina_amount(x, y, seed))


def patina_roughness(size, seed):
    """glTF's packing: roughness in green, metalness in blue."""
    palette = []
    for k in range(32):
        t = k / 31
        palette.append((0, round(255 * (0.16 + 0.6 * t)), round(255 * (1 - 0.85 * t * t))))
    return shade(size, palette, lambda x, y: _patina_amount(x, y, seed))


def _patina_amount(x, y, seed):
    n = fractal_noise(x * 8, y * 4, 8, seed, 4)
    return max(0.0, min(1.0, (n - 0.42) * 3.2))


def amphora(width, height):
    """Black-figure decoration: meander bands, rays, waves and a dotted band on clay. x runs once
    around the vase, y from its rim (0) to its foot (1)."""
    clay, black, cream, brick = 0, 1, 2, 3
    base = [(196, 104, 52), (28, 22, 20), (226, 196, 150), (146, 58, 34)]
    shades = [tuple(round(c * (0.86 + 0.14 * k / 7)) for c in colour)
              for colour in base for k in range(8)]
    key = ["##########", "#........#", "#.######.#", "#.#....#.#", "#.#.##.#.#",
           "#.#..#.#.#", "#.####.#.#", "#......#.#", "########.#", ".........#"]

    def paint(x, y):
        if y < 0.10 or y > 0.965:
            return black
        if 0.10 <= y < 0.12 or 0.285 <= y < 0.30 or 0.60 <= y < 0.612 or 0.73 <= y < 0.742:
            return cream
        if 0.12 <= y < 0.22:  # tongues on the neck
            t = (x * 36) % 1.0
            return black if abs(t - 0.5) < 0.34 * (1 - (y - 0.12) / 0.13) else clay
        if 0.22 <= y < 0.285:
            return brick
        if 0.31 <= y < 0.39:  # meander
            row = int((y - 0.31) / 0.08 * 10)
            return black if key[min(row, 9)][int(x * 24 * 10) % 10] == "#" else clay
        if 0.39 <= y < 0.60:  # rolling waves
            phase = x * 12
            crest = 0.50 + 0.045 * math.sin(2 * math.pi * phase)
            curl = math.hypot((phase % 1.0 - 0.25) * 0.9, (y - 0.465) * 9)
            if curl < 0.12 or 0.22 < curl < 0.30:
                return cream if curl < 0.12 else black
            return black if y > crest + 0.03 else clay
        if 0.612 <= y < 0.73:  # dots and meander on black
            if 0.64 <= y < 0.70:
                dx, dy = (x * 48) % 1.0 - 0.5, (y - 0.67) * 26
                return cream if dx * dx + dy * dy < 0.10 else black
            return black
        if 0.742 <= y < 0.93:  # rays from the foot
            t = abs((x * 20) % 1.0 - 0.5) * 2
            return black if t < (y - 0.742) / 0.19 else clay
        return clay

    pixels = []
    for j in range(height):
        for i in range(width):
            x, y = (i + 0.5) / width, (j + 0.5) / height
            tone = (0.8 * value_noise(x * 12, y * 12, 12, 71)
                    + 0.2 * value_noise(x * 96, y * 96, 96, 5))
            pixels.append(paint(x, y) * 8 + min(7, int(tone * 8)))
    return png_palette(width, height, pixels, shades)
