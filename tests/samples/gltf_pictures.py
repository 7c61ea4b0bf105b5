#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-render shows what glTF says of a surface: pixels against the specification's formulas.

gltf_pictures.py OPENRT_RENDER
"""
import pathlib
import struct
import sys
import tempfile
import unittest

from gltf_scene import Scene
from program_runs import Runner, png

PROGRAM = sys.argv[1]
GREEN = (0, 255, 0)


def linear(byte):
    share = byte / 255
    return share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4


def srgb(share):
    share = 12.92 * share if share <= 0.0031308 else 1.055 * share ** (1 / 2.4) - 0.055
    return round(255 * share)


class GltfPictures(unittest.TestCase):
    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name)
        self.runner = Runner(PROGRAM, self.folder)

    def tearDown(self):
        self._temporary.cleanup()

    def render(self, scene, *arguments):
        path = self.folder / "scene.gltf"
        path.write_text(scene.text())
        return self.runner.picture(path, *arguments, size="16x16")

    def expect(self, scene, colour, *arguments, at=(8, 8)):
        pixel = self.render(scene, *arguments).pixel(*at)
        for got, wanted in zip(pixel, colour):
            self.assertLessEqual(abs(got - wanted), 1, (pixel, colour))

    def test_colour_spaces_that_a_texture_claims_are_ignored(self):
        texel = (200, 100, 50)
        for image in (png(1, 1, [texel]),
                      png(1, 1, [texel], (b"gAMA", struct.pack(">I", 100000))),
                      png(1, 1, [tuple(257 * c for c in texel)], depth=16)):
            scene = Scene()
            scene.square(scene.unlit(texture=scene.texture(image)))
            self.expect(scene, texel)

    def test_unlit_materials(self):
        scene = Scene()
        texture = scene.texture(png(1, 1, [(200, 100, 50)]))
        colours = scene.accessor("B", "VEC4", [255, 128, 255, 255] * 4, normalized=True)
        scene.square(scene.unlit((0.5, 1, 1, 1), texture=texture), COLOR_0=colours)
        shares = linear(200) / 2, linear(100) * 128 / 255, linear(50)
        self.expect(scene, [srgb(s) for s in shares])
        self.expect(scene, [srgb(s / 2) for s in shares], "--exposure", "-1")

        def before_green(alpha, **material):
            scene = Scene()
            scene.square(scene.unlit((1, 0, 0, alpha), **material))
            scene.wall(scene.unlit((0, 1, 0, 1)))
            return scene

        self.expect(before_green(0.25), (255, 0, 0))
        self.expect(before_green(0.25, alphaMode="MASK"), GREEN)
        self.expect(before_green(0.25, alphaMode="MASK", alphaCutoff=0.2), (255, 0, 0))
        self.expect(before_green(0.25, alphaMode="BLEND"), (srgb(0.25), srgb(0.75), 0))

    def test_the_determinant_of_a_node_decides_which_side_is_the_front(self):
        for scale, turned, shown in (((1, 1, 1), False, True), ((1, 1, 1), True, False),
                                     ((-1, 1, 1), False, True), ((-1, 1, 1), True, False),
                                     ((1, 1, -1), False, False), ((1, 1, -1), True, True),
                                     ((-1, 1, -1), False, False)):
            with self.subTest(scale=scale, turned=turned):
                scene = Scene()
                scene.square(scene.unlit((1, 0, 0, 1)), {"scale": scale}, turned=turned)
                scene.wall(scene.unlit((0, 1, 0, 1)))
                self.expect(scene, (255, 0, 0) if shown else GREEN)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
