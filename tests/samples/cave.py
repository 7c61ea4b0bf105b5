#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-cave: the pictures of neighbouring walls meet, eyes differ, and wrong input is told.

usage: cave.py OPENRT_CAVE SOURCE_DIR
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

from program_runs import Png

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
SCENE, PATH = SOURCE / "samples/models/courtyard.glb", SOURCE / "samples/vr/walk.path"
SIZE = 96


def column(picture, x):
    return [picture.pixel(x, y) for y in range(picture.height)]


def row(picture, y):
    return [picture.pixel(x, y) for x in range(picture.width)]


def difference(a, b, block=8):
    """Of the colours of two rows of pixels, a few averaged against the grain of the textures: the
    mean, in 1/255."""
    def averages(pixels):
        return [sum(p[k] for p in pixels[i:i + block]) / block
                for i in range(0, len(pixels), block) for k in range(3)]
    return sum(abs(p - q) for p, q in zip(averages(a), averages(b))) / (3 * len(a) / block)


class Cave(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def run_program(self, *arguments, scene=SCENE, path=PATH):
        return subprocess.run([PROGRAM, scene, "--path", path, "--size", f"{SIZE}x{SIZE}",
                               "-o", self.folder / "%s-%d.png", *arguments],
                              capture_output=True, text=True, timeout=200)

    def walls(self, frame):
        return {name: Png((self.folder / f"{name}-{frame}.png").read_bytes())
                for name in ("front", "left", "right", "floor")}

    def test_walls_meet(self):
        result = self.run_program("--mono", "--frames", "2", "--rate", "1", "--samples", "4")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for frame in range(2):
            walls = self.walls(frame)
            seams = [(column(walls["front"], 0), column(walls["left"], -1 % SIZE)),
                     (column(walls["front"], SIZE - 1), column(walls["right"], 0)),
                     (row(walls["front"], SIZE - 1), row(walls["floor"], 0))]
            for a, b in seams:
                self.assertLess(difference(a, b), 25)
            # Edges that do not meet differ, so that the measure means something.
            apart = difference(column(walls["left"], 0), column(walls["right"], 0))
            self.assertGreater(apart, 2 * max(difference(a, b) for a, b in seams))

    def test_eyes_differ(self):
        result = self.run_program("--frames", "1")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for name, picture in self.walls(0).items():
            self.assertEqual((picture.width, picture.height), (2 * SIZE, SIZE))
            left = [c for y in range(SIZE) for c in row(picture, y)[:SIZE]]
            right = [c for y in range(SIZE) for c in row(picture, y)[SIZE:]]
            self.assertNotEqual(left, right, name)
        result = self.run_program("--frames", "1", "--eyes", "0")
        for picture in self.walls(0).values():
            for y in range(SIZE):
                self.assertEqual(row(picture, y)[:SIZE], row(picture, y)[SIZE:])

    def test_latency_is_reported(self):
        for mono, steps in (([], ["left eye rendered", "right eye rendered", "written"]),
                            (["--mono"], ["rendered", "written"])):
            result = self.run_program("--frames", "3", "--report-latency", *mono)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            lines = result.stdout.splitlines()[2:]
            self.assertEqual(len(lines), 4 * len(steps))
            rendered = []
            for i, line in enumerate(lines):
                wall = ("front", "left", "right", "floor")[i // len(steps)]
                self.assertTrue(line.startswith(wall), line)
                self.assertIn(steps[i % len(steps)], line)
                median, worst = map(float, line.split()[-2:])
                self.assertGreaterEqual(worst, median)
                self.assertGreaterEqual(median, 0)
                if "rendered" in line:
                    rendered.append(worst)
                else:  # what is written was rendered
                    self.assertGreaterEqual(worst, max(rendered[-len(steps) + 1:]))
            self.assertEqual(len(rendered), 4 * (len(steps) - 1))

    def test_room_stands_upright(self):
        told = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True)
        self.assertIn("where the room stands", " ".join(told.stdout.split()))
        result = self.run_program("--frames", "1", "--camera", "0,5,0,0,1,0,40")
        self.assertEqual(result.returncode, 1)
        self.assertIn("straight up or down", result.stderr)

    def test_wrong_input(self):
        (self.folder / "bad.path").write_text("0 1 2\n")
        for arguments, more in ((["--side", "0"], {}), (["--scale", "nan"], {}),
                                (["-o", self.folder / "x.png"], {}),
                                (["-o", self.folder / "%s-%d.bmp"], {}),
                                (["-o", self.folder / "%s-%s-%d.png"], {}),
                                (["-o", self.folder / "%s-%d-%d.png"], {}),
                                ([], {"scene": self.folder / "nothing.glb"}),
                                ([], {"path": self.folder / "bad.path"})):
            result = self.run_program("--frames", "1", *arguments, **more)
            self.assertIn(result.returncode, (1, 2), arguments)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["bad.path"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
