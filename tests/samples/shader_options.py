#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-render with shaders of shader libraries.

shader_options.py OPENRT_RENDER SHADER_FOLDER
"""
import os
import pathlib
import sys
import tempfile
import unittest

from gltf_documents import document, glb
from program_runs import Runner

PROGRAM = sys.argv[1]
os.environ["OPENRT_SHADER_PATH"] = sys.argv[2]
MIDDLE, CORNER = (32, 24), (1, 1)


class ShaderOptions(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        folder = pathlib.Path(temporary.name)
        self.runner = Runner(PROGRAM, folder)
        self.scene = folder / "a.glb"
        self.scene.write_bytes(glb(document()))

    def picture(self, *arguments):
        return self.runner.picture(self.scene, *arguments, size="64x48")

    def test_a_surface_shows_everything(self):
        picture = self.picture("--surface", "ConstantShader", "--set",
                               "ConstantShader.value=0,1,0")
        self.assertEqual(picture.pixel(*MIDDLE), (0, 255, 0))
        plain = self.picture()
        self.assertEqual(plain.pixel(*MIDDLE), (255, 0, 0))
        self.assertEqual(plain.pixel(*CORNER), picture.pixel(*CORNER))

    def test_parameters_reach_a_library_s_shader(self):
        coarse = self.picture("--surface", "marble:Marble", "--set", "Marble.veins=1")
        fine = self.picture("--surface", "marble:Marble", "--set", "Marble.veins=30")
        self.assertNotEqual(coarse.colours(), fine.colours())
        # Of another type than float, and a file with its ending and path.
        toon = f"{sys.argv[2]}/toon.so:Toon"
        flat = self.picture("--surface", toon, "--set", "Toon.steps=1", "--set", "Toon.outline=0",
                            "--set", "Toon.color=1,1,1")
        steps = {flat.pixel(x, 24) for x in range(28, 36)}
        self.assertEqual(len(steps), 1)

    def test_environment_camera_and_rendering_object(self):
        plain = self.picture()
        sky = self.picture("--environment", "sky:Sky", "--set", "Sky.sunRadius=0")
        self.assertNotEqual(sky.pixel(*CORNER), plain.pixel(*CORNER))
        black = self.picture("--environment", "ConstantEnvironment")
        self.assertEqual(black.pixel(*CORNER), (0, 0, 0))
        fisheye = self.picture("--camera-shader", "fisheye:Fisheye")
        self.assertEqual(fisheye.pixel(*MIDDLE), (255, 0, 0))
        self.assertNotEqual(fisheye.pixel(40, 24), plain.pixel(40, 24))
        open_ = self.picture("--rendering-object", "ambient_occlusion:AmbientOcclusion")
        self.assertEqual(open_.colours(), {(255, 255, 255)})

    def test_what_can_not_be_is_one_line(self):
        for arguments, word in (
                (("--surface", "none:Marble"), "none"),
                (("--surface", "marble:Granite"), "Granite"),
                (("--surface", "Granite"), "Granite"),
                (("--surface", "marble:"), "LIBRARY:CLASS"),
                (("--surface", ":Marble"), "LIBRARY:CLASS"),
                (("--surface", "sky:Sky"), "surface"),
                (("--environment", "marble:Marble"), "environment"),
                (("--camera-shader", "marble:Marble"), "camera"),
                (("--light-shader", "marble:Marble"), "light"),
                (("--rendering-object", "marble:Marble"), "rendering object"),
                (("--set", "Marble.veins=8"), "Marble"),
                (("--surface", "marble:Marble", "--set", "Marble.veins"), "PARAMETER"),
                (("--surface", "marble:Marble", "--set", "veins=8"), "PARAMETER"),
                (("--surface", "marble:Marble", "--set", "Marble.color=1,1,1"), "color"),
                (("--surface", "marble:Marble", "--set", "Marble.veins=1,2"), "type"),
                (("--surface", "marble:Marble", "--set", "Marble.veins=many"), "type"),
                (("--surface", "marble:Marble", "--set", "Marble.veins="), "type"),
                (("--surface", "toon:Toon", "--set", "Toon.steps=1.5"), "type")):
            with self.subTest(arguments):
                self.assertIn(word, self.runner.refusal(self.scene, *arguments))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
