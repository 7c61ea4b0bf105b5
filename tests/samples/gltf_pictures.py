#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-render shows what glTF says of a surface: pixels against the specification's formulas.

gltf_pictures.py OPENRT_RENDER
"""
import math
import pathlib
import struct
import sys
import tempfile
import unittest

from gltf_scene import CORNERS, Scene
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

    def test_textures_lie_where_transforms_and_sets_put_them(self):
        texels = [(255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 0)]

        def texel(u, v):
            return texels[2 * (v >= 0.5) + (u >= 0.5)]

        def turned(u, v):
            """By 30 degrees, after a scale by 0.5, before a shift."""
            u, v, c, s = u / 2, v / 2, math.cos(math.pi / 6), math.sin(math.pi / 6)
            return c * u + s * v + 0.1, -s * u + c * v + 0.6

        turn = {"scale": [0.5, 0.5], "rotation": math.pi / 6, "offset": [0.1, 0.6]}
        for transform, expected in (
                ({}, lambda u, v: (u, v)), ({"offset": [0.5, 0]}, lambda u, v: (u + 0.5, v)),
                ({"scale": [0.5, 2]}, lambda u, v: (u / 2, 2 * v)), (turn, turned),
                ({"texCoord": 1}, lambda u, v: (v, u))):
            with self.subTest(transform=transform):
                scene = Scene()
                info = {"index": scene.texture(png(2, 2, texels)),
                        "extensions": {"KHR_texture_transform": transform}}
                scene.document["extensionsRequired"] = ["KHR_texture_transform"]
                # The other set has s and t exchanged.
                scene.square(scene.unlit(texture=info),
                             TEXCOORD_1=scene.accessor("f", "VEC2", [1, 0, 1, 1, 0, 1, 0, 0]))
                picture = self.render(scene)
                half = 3 * math.tan(0.4)  # of what the camera sees in the square's plane
                for y in range(16):
                    for x in range(16):
                        at = [((k + 0.5) / 8 - 1) * half / 2 + 0.5 for k in (x, y)]
                        uv = expected(*at)
                        if min(at) > 0 and max(at) < 1 and min(abs(t - 0.5) for t in uv) > 0.01:
                            self.assertEqual(picture.pixel(x, y), texel(*uv), (x, y))

    def test_an_orthographic_camera_shows_the_same_size_at_any_distance(self):
        for z in (0, -40):
            scene = Scene()
            scene.document["cameras"] = [{"type": "orthographic", "orthographic": {
                "xmag": 2, "ymag": 2, "znear": 0.1, "zfar": 100}}]
            scene.square(scene.unlit((1, 0, 0, 1)), {"translation": [0, 0.5, z]})
            picture = self.render(scene)
            for y in range(16):
                for x in range(16):
                    inside = 4 <= x < 12 and 2 <= y < 10  # four pixels a unit
                    self.assertEqual(picture.pixel(x, y) == (255, 0, 0), inside, (x, y, z))

    def test_sparse_positions(self):
        for base in (True, False):  # over a square far away, and over zeros
            scene = Scene()
            far = scene.accessor("f", "VEC3", [c + 99 for c in CORNERS[:6]] + CORNERS[6:])
            accessor = scene.document["accessors"][far]
            changed = [0, 1] if base else [0, 1, 2, 3]
            accessor["sparse"] = {
                "count": len(changed),
                "indices": {"componentType": 5121, "bufferView": scene.view(bytes(changed))},
                "values": {"bufferView": scene.view(
                    struct.pack(f"<{3 * len(changed)}f", *CORNERS[:3 * len(changed)]))}}
            if not base:
                del accessor["bufferView"]
            scene.square(scene.unlit((1, 0, 0, 1)), POSITION=far)
            picture = self.render(scene)
            for corner in ((4, 4), (11, 4), (4, 11), (11, 11)):
                self.assertEqual(picture.pixel(*corner), (255, 0, 0))

    def test_what_is_left_out_is_told(self):
        scene = Scene()
        scene.document["extensionsUsed"] = ["KHR_materials_unlit", "KHR_materials_sheen",
                                            "EXT_texture_webp"]
        webp = scene.add("textures", {"extensions": {"EXT_texture_webp": {"source": 0}}})
        scene.square(scene.unlit((1, 0, 0, 1), texture=webp))
        path = self.folder / "scene.gltf"
        path.write_text(scene.text())
        result = self.runner.run(path)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(result.stderr.decode().splitlines()), [
            "note: extensions that are left out: KHR_materials_sheen, EXT_texture_webp",
            "note: textures without an image that is PNG or JPEG are left out"])

    def test_lights(self):
        def light_at(x, light):
            """What a light one unit above the middle of a white wall shows there at x, and how
            far it is."""
            scene = Scene()
            scene.square(scene.material(), {"scale": [9, 9, 1]})
            scene.document["extensions"] = {"KHR_lights_punctual": {"lights": [light]}}
            scene.node(translation=[0, 0, 1], extensions={"KHR_lights_punctual": {"light": 0}})
            half = 3 * math.tan(0.4)
            column = round((x / half + 1) * 8 - 0.5)
            x, y = ((k + 0.5) / 8 * half - half for k in (column, 8))
            pixel = self.render(scene, "--environment", "ConstantEnvironment", "--set",
                                "ConstantEnvironment.radiance=0,0,0").pixel(column, 8)
            return linear(pixel[1]), math.sqrt(1 + x * x + y * y)

        def clamp(share):
            return min(max(share, 0), 1)

        inner, outer = 0.3, 0.7
        for x in (0, 0.4, 0.7, 1.0):
            plain, distance = light_at(x, {"type": "point", "intensity": 2})
            # Of a rough dielectric: all but what its smooth layer takes.
            self.assertAlmostEqual(plain, 2 / math.pi / distance ** 3, delta=0.04)
            reach, distance = light_at(x, {"type": "point", "intensity": 2, "range": 1.3})
            self.assertAlmostEqual(reach, plain * clamp(1 - (distance / 1.3) ** 4), delta=0.01)
            cone, distance = light_at(x, {
                "type": "spot", "intensity": 2,
                "spot": {"innerConeAngle": inner, "outerConeAngle": outer}})
            share = clamp((1 / distance - math.cos(outer)) / (math.cos(inner) - math.cos(outer)))
            self.assertAlmostEqual(cone, plain * share ** 2, delta=0.01)

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
