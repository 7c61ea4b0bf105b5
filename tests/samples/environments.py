#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-render with pictures around the scene: what is seen in a direction is what the file has
there.

environments.py OPENRT_RENDER
"""
import math
import pathlib
import sys
import tempfile
import unittest

import environment_files as files
from gltf_documents import document, glb
from program_runs import Runner

PROGRAM = sys.argv[1]
WIDTH, HEIGHT = 64, 32


def direction(column, row):
    """Of a texel's middle, by the rule in docs/builtin-shaders.md: +y above, -z in the middle, +x
    to the right of it."""
    longitude = ((column + 0.5) / WIDTH - 0.5) * 2 * math.pi
    latitude = (0.5 - (row + 0.5) / HEIGHT) * math.pi
    level = math.cos(latitude)
    return (level * math.sin(longitude), math.sin(latitude), -level * math.cos(longitude))


def light_from(d):
    """Another colour in every direction."""
    return tuple(0.5 + 0.45 * value for value in d)


ROWS = [[light_from(direction(x, y)) for x in range(WIDTH)] for y in range(HEIGHT)]
SEEN_DIRECTIONS = [(0, 0, -1), (1, 0, 0), (0, 0, 1), (-1, 0, 0), (0.6, 0.64, -0.48),
                   (-0.48, -0.6, 0.64), (0.36, 0.8, 0.48), (-0.64, 0.48, -0.6)]


def linear(code):
    value = code / 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


class Environments(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.runner = Runner(PROGRAM, self.folder)
        self.scene = self.folder / "a.glb"
        self.scene.write_bytes(glb(document()))

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content)
        return str(path)

    def seen(self, environment, d, *arguments):
        """The light in a direction, far from the scene's only triangle."""
        eye = [1000.0, 1000.0, 1000.0]
        camera = ",".join(f"{value:.6f}" for value in
                          [*eye, *(e + 10 * k for e, k in zip(eye, d)), 0.5])
        picture = self.runner.picture(self.scene, "--environment", environment, "--camera", camera,
                                      *arguments, size="3x3")
        return [linear(code) for code in picture.pixel(1, 1)]

    def check_directions(self, environment, directions=SEEN_DIRECTIONS):
        for d in directions:
            for got, expected in zip(self.seen(environment, d), light_from(d)):
                self.assertAlmostEqual(got, expected, delta=0.02, msg=(environment, d))

    def test_control_a_picture_turned_over_is_seen_to_be(self):
        for name, rows in (("upside_down.exr", ROWS[::-1]), ("mirrored.exr", [r[::-1] for r in ROWS]),
                           ("turned.exr", [r[8:] + r[:8] for r in ROWS])):
            environment = self.write(name, files.exr(rows))
            with self.subTest(name), self.assertRaises(AssertionError):
                self.check_directions(environment, SEEN_DIRECTIONS[4:5])

    def test_every_kind_of_file_shows_the_same(self):
        self.check_directions(self.write("float.exr", files.exr(ROWS)))
        for name, content in (
                ("half.exr", files.exr(ROWS, files.HALF)),
                ("rle.exr", files.exr(ROWS, files.HALF, files.RLE)),
                ("zips.EXR", files.exr(ROWS, compression=files.ZIPS)),
                ("zip.exr", files.exr(ROWS, compression=files.ZIP)),
                ("window.exr", files.exr(ROWS, at=(-7, 1000))),
                ("tiles.exr", files.tiled_exr(ROWS, 24)),
                ("packed.hdr", files.hdr(ROWS)), ("plain.hdr", files.hdr(ROWS, packed=False))):
            with self.subTest(name):
                self.check_directions(self.write(name, content), SEEN_DIRECTIONS[4:6])

    def test_one_channel_is_grey(self):
        environment = self.write("grey.exr", files.exr(ROWS, grey=True))
        for d in SEEN_DIRECTIONS[4:6]:
            for got in self.seen(environment, d):
                self.assertAlmostEqual(got, light_from(d)[0], delta=0.02)

    def test_exposure_and_bright_light(self):
        rows = [[(3.0, 0.25, 40.0)] * 4] * 2
        for name, content in (("a.exr", files.exr(rows)), ("a.hdr", files.hdr(rows))):
            environment = self.write(name, content)
            got = self.seen(environment, (1, 0, 0), "--exposure", "-2")
            self.assertAlmostEqual(got[0], 0.75, delta=0.01)
            self.assertEqual(got[2], 1.0)
        self.assertAlmostEqual(self.seen(self.folder / "a.exr", (1, 0, 0))[1], 0.25, delta=0.01)

    def test_what_is_no_light_is_dark(self):
        for value in (math.nan, -math.inf, -5.0):
            got = self.seen(self.write("a.exr", files.exr([[(value, 0.5, 0.5)] * 4] * 2)), (0, 0, 1))
            self.assertEqual(got[0], 0)
            self.assertAlmostEqual(got[1], 0.5, delta=0.01)
        rows = [[(math.inf, 0.5, 0.5)] * 4] * 2
        self.assertEqual(self.seen(self.write("a.exr", files.exr(rows)), (0, 0, 1))[0], 1)

    def test_the_renderer_s_own_pictures(self):
        result = self.runner.run(self.scene, "--surface", "ConstantShader", "--environment",
                                 "ConstantEnvironment", "--set",
                                 "ConstantEnvironment.radiance=0.5,0.25,0.125", output="own.exr")
        self.assertEqual(result.returncode, 0, result.stderr)
        got = self.seen(self.folder / "own.exr", (1, 0, 0))
        for value, expected in zip(got, (0.5, 0.25, 0.125)):
            self.assertAlmostEqual(value, expected, delta=0.01)

    def test_a_shader_is_still_one(self):
        got = self.seen("ConstantEnvironment", (1, 0, 0), "--set",
                        "ConstantEnvironment.radiance=1,0,0")
        self.assertEqual(got, [1, 0, 0])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
