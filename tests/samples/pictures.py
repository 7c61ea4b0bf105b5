#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-render's options show in its pictures as they should.

pictures.py OPENRT_RENDER
"""
import base64
import json
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest

from gltf_documents import document, glb, spoilt
from program_runs import Runner, png

PROGRAM = sys.argv[1]
TRACE = pathlib.Path(PROGRAM).with_name("openrt-trace")


class Pictures(unittest.TestCase):
    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name)
        self.runner = Runner(PROGRAM, self.folder)

    def tearDown(self):
        self._temporary.cleanup()

    def write(self, name, content):
        path = self.folder / name
        if isinstance(content, dict):
            content = json.dumps(content).encode()
        path.write_bytes(content)
        return path

    def test_triangle_lies_where_the_camera_puts_it(self):
        scene = self.write("a.glb", glb(document()))
        picture = self.runner.picture(scene, size="64x48")
        height = 0.4228  # tan(0.4): half of what is seen at distance 1
        for y in range(48):
            for x in range(64):
                # The pixel's centre on the triangle's plane, three units away.
                px = ((x + 0.5) / 64 * 2 - 1) * height * 64 / 48 * 3
                py = (1 - (y + 0.5) / 48 * 2) * height * 3
                inside = py > -1 and py < 1 - 2 * abs(px)
                edge = min(abs(py + 1), abs(py - 1 + 2 * abs(px)))
                if edge > 0.05:
                    self.assertEqual(picture.pixel(x, y) == (255, 0, 0), inside, (x, y))

    def test_textures_stand_upright_and_are_srgb(self):
        doc = document([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], (0, 1, 2, 0, 2, 3))
        uvs = struct.pack("<8f", 0, 1, 1, 1, 1, 0, 0, 0)
        colours = [(200, 10, 20), (30, 210, 40), (50, 60, 220), (128, 128, 128)]
        image = base64.b64encode(png(2, 2, colours)).decode()
        doc["buffers"].append({"byteLength": 32, "uri": "data:application/octet-stream;base64,"
                               + base64.b64encode(uvs).decode()})
        doc["bufferViews"].append({"buffer": 1, "byteLength": 32})
        doc["accessors"].append({"bufferView": 2, "componentType": 5126, "count": 4,
                                 "type": "VEC2"})
        doc["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 2
        doc["images"] = [{"uri": "data:image/png;base64," + image}]
        doc["samplers"] = [{"magFilter": 9728, "wrapS": 33071, "wrapT": 33071}]
        doc["textures"] = [{"source": 0, "sampler": 0}]
        material = doc["materials"][0]["pbrMetallicRoughness"]
        material["baseColorFactor"] = [1, 1, 1, 1]
        material["baseColorTexture"] = {"index": 0}
        picture = self.runner.picture(self.write("a.gltf", doc), size="64x64")
        for k, (x, y) in enumerate(((20, 20), (44, 20), (20, 44), (44, 44))):
            self.assertEqual(picture.pixel(x, y), colours[k])

    def test_camera_option_replaces_the_files_camera(self):
        scene = self.write("a.glb", glb(document()))
        away = self.runner.picture(scene, "--camera", "0,0,3,0,0,9,45")
        self.assertNotIn((255, 0, 0), away.colours())
        near = self.runner.picture(scene, "--camera", "0,-0.5,0.2,0,-0.5,0,45")
        self.assertEqual(near.colours(), {(255, 0, 0)})

    def test_lights_light(self):
        doc = spoilt(("materials", 0), {"pbrMetallicRoughness": {
            "baseColorFactor": [1, 1, 1, 1], "metallicFactor": 0}, "doubleSided": True})
        scene = self.write("a.glb", glb(doc))
        front = self.runner.picture(scene, "--light", "0,0,3").pixel(8, 7)
        behind = self.runner.picture(scene, "--light", "0,0,-3").pixel(8, 7)
        self.assertGreater(min(front), max(behind) + 20)
        darker = self.runner.picture(scene, "--light", "0,0,3", "--exposure", "-2").pixel(8, 7)
        self.assertLess(max(darker), min(front) - 40)

    def test_samples_soften_edges(self):
        scene = self.write("a.glb", glb(document()))
        sharp = self.runner.picture(scene).colours()
        soft = self.runner.picture(scene, "--samples", "16").colours()
        self.assertGreater(len(soft), len(sharp))

    def test_any_number_of_threads_makes_the_same_picture(self):
        scene = self.write("a.glb", glb(document()))
        files = []
        for threads in ("1", "2", "5"):
            self.runner.picture(scene, "--threads", threads, size="97x61")
            files.append((self.folder / "out.png").read_bytes())
        self.assertTrue(files[0] == files[1] == files[2])

    def test_threads_are_the_environments_unless_told(self):
        scene = self.write("a.glb", glb(document()))
        recording = self.folder / "calls.ort"
        for arguments, said in (((), []), (("--threads", "0"), ["rtThreads(0u)"]),
                                (("--threads", "3"), ["rtThreads(3u)"])):
            subprocess.run([TRACE, "record", "-o", recording, PROGRAM, scene, "-o",
                            self.folder / "out.png", "--size", "4x4", *arguments], check=True)
            calls = subprocess.run([TRACE, "dump", recording], capture_output=True, text=True,
                                   check=True).stdout
            self.assertEqual(re.findall(r"rtThreads\([^)]*\)", calls), said)
            recording.unlink()

    def test_statistics(self):
        scene = self.write("a.glb", glb(document()))
        numbers = self.runner.statistics(scene, "--frames", "3", "--samples", "2")
        self.assertEqual(numbers["triangles"], 1)
        self.assertEqual(numbers["instances"], 1)
        self.assertEqual(numbers["primary_rays"], 16 * 12 * 2)
        self.assertEqual(len(numbers["all_frame_seconds"]), 3)
        self.assertEqual(numbers["frame_seconds"], min(numbers["all_frame_seconds"]))
        self.assertGreaterEqual(numbers["duplication"], 1.0)
        text = self.runner.run("--stats", scene)
        self.assertEqual(text.returncode, 0)
        for name in (b"triangles", b"instances", b"tree nodes", b"leaves", b"duplication",
                     b"bytes a triangle", b"build seconds", b"primary rays", b"shadow rays",
                     b"secondary rays", b"Mrays/s", b"frame seconds"):
            self.assertIn(name, text.stdout)

    def test_a_wrong_option_is_a_wrong_command_line(self):
        scene = self.write("a.glb", glb(document()))
        for wrong in (("--size", "16"), ("--size", "0x4"), ("--samples", "0"),
                      ("--samples", "4097"), ("--threads", "1025"), ("--precision", "none"),
                      ("--camera", "1,2"), ("--camera", "0,0,0,0,0,0,45"), ("--light", "1"),
                      ("--exposure", "1e9"), ("--frames", "0"), ("--set", "nothing")):
            with self.subTest(wrong=wrong):
                self.assertEqual(self.runner.run(scene, *wrong).returncode, 2)
        self.assertEqual(self.runner.run(scene, output="out.jpg").returncode, 2)
        self.assertEqual(self.runner.run(scene, output="none/out.png").returncode, 1)
        self.assertEqual(self.runner.run(scene, output="OUT.PNG").returncode, 0)

    def test_an_interrupted_program_leaves_no_file(self):
        scene = self.write("a.glb", glb(document()))
        program = subprocess.Popen([PROGRAM, scene, "-o", self.folder / "out.png", "--frames",
                                    "100000"])
        time.sleep(0.5)
        program.terminate()
        self.assertEqual(program.wait(), -signal.SIGTERM)
        self.assertFalse((self.folder / "out.png").exists())

    def test_exr(self):
        scene = self.write("a.glb", glb(document()))
        result = self.runner.run(scene, output="out.exr")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual((self.folder / "out.exr").read_bytes()[:4], b"\x76\x2f\x31\x01")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
