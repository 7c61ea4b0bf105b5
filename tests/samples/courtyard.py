#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The demo's scene: its generator makes the committed file again, byte for byte, and the program
finds in it what a reader of our own finds.

courtyard.py MODELS_FOLDER [OPENRT_RENDER]
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

MODELS = pathlib.Path(sys.argv[1])
PROGRAM = sys.argv[2] if len(sys.argv) > 2 else None


class Courtyard(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.bytes = (MODELS / "courtyard.glb").read_bytes()
        length, = struct.unpack_from("<I", cls.bytes, 12)
        cls.json = json.loads(cls.bytes[20:20 + length])
        cls.triangles = [sum(cls.json["accessors"][part["indices"]]["count"] // 3
                             for part in mesh["primitives"]) for mesh in cls.json["meshes"]]

    def test_generator_makes_the_same_file(self):
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(folder, "made.glb")
            subprocess.run([sys.executable, "-B", MODELS / "make_courtyard.py", made], check=True)
            self.assertTrue(made.read_bytes() == self.bytes,
                            "the generator makes another file than the committed one")

    def test_it_is_a_scene_worth_rendering(self):
        self.assertGreaterEqual(sum(self.triangles), 50000)
        self.assertLess(len(self.bytes), 1500000)
        used = [node["mesh"] for node in self.json["nodes"] if "mesh" in node]
        self.assertGreater(max(map(used.count, used)), 10, "no mesh is used many times")
        lights = self.json["extensions"]["KHR_lights_punctual"]["lights"]
        self.assertEqual({light["type"] for light in lights}, {"point", "directional", "spot"})
        textured = [m for m in self.json["materials"]
                    if "baseColorTexture" in m["pbrMetallicRoughness"]]
        self.assertGreater(len(textured), 4)
        self.assertEqual(self.json["cameras"][0]["type"], "perspective")

    @unittest.skipUnless(PROGRAM, "no program to run")
    def test_program_counts_the_same(self):
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder, "picture.png")
            out = subprocess.run([PROGRAM, MODELS / "courtyard.glb", "-o", picture, "--size",
                                  "48x32", "--stats=json"], check=True, capture_output=True)
            statistics = json.loads(out.stdout)
            self.assertEqual(statistics["triangles"], sum(self.triangles))
            self.assertEqual(statistics["instances"],
                             sum("mesh" in node for node in self.json["nodes"]))
            self.assertEqual(statistics["dropped_triangles"], 0)
            self.assertEqual(statistics["primary_rays"], 48 * 32)
            self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
