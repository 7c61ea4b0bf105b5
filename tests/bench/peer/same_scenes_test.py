#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The samples of changing scenes see the same with the library and with Embree.

same_scenes_test.py SAMPLES PEERS: the folders of the programs
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "samples"))
from program_runs import Png  # noqa: E402

SAMPLES, PEERS = map(pathlib.Path, sys.argv[1:3])
ENVIRONMENT = dict(os.environ, OPENRT_THREADS="2")
WIDTH, HEIGHT = 96, 64


class SameScenes(unittest.TestCase):
    def run_both(self, sample, *arguments, way="low"):
        """Of the third frame: colours by OpenRT, and what Embree saw, by number of picture."""
        with tempfile.TemporaryDirectory() as folder:
            for programs, more in ((SAMPLES, ["%d.png"]), (PEERS, ["%d.pgm", "--embree", way])):
                subprocess.run([programs.resolve() / sample, *arguments, "--rt-offscreen", "3",
                                "--rt-size", f"{WIDTH}x{HEIGHT}", "--rt-output", *more],
                               check=True, cwd=folder, env=ENVIRONMENT, timeout=100,
                               stdout=subprocess.DEVNULL)
            png = Png(pathlib.Path(folder, "2.png").read_bytes())
            colours = [[png.pixel(x, y)[:3] for x in range(WIDTH)] for y in range(HEIGHT)]
            seen = {}
            for path in pathlib.Path(folder).glob("*.pgm"):
                _, size, _, pixels = path.read_bytes().split(b"\n", 3)
                width, height = map(int, size.split())
                seen[int(path.stem)] = [list(pixels[width * y:width * (y + 1)])
                                        for y in range(height)]
            return colours, seen

    def differing(self, colours, seen, background):
        """Shares of the pixels: only OpenRT sees something there, only Embree does."""
        pairs = [(colour != background, what > 0)
                 for row, of_row in zip(colours, seen) for colour, what in zip(row, of_row)]
        return (sum(a and not b for a, b in pairs) / len(pairs),
                sum(b and not a for a, b in pairs) / len(pairs))

    def check(self, colours, seen, least=0.2):
        empty = [c for row, of_row in zip(colours, seen) for c, what in zip(row, of_row)
                 if what == 0]
        background = max(set(empty), key=empty.count)
        share = 1 - len(empty) / (len(seen) * len(seen[0]))
        self.assertGreater(share, least)
        self.assertLess(share, 0.98)
        more, less = self.differing(colours, seen, background)
        self.assertLess(more, 0.01)
        self.assertLess(less, 0.01)
        # A picture that is upside down is found out.
        self.assertGreater(sum(self.differing(colours, seen[::-1], background)), 0.02)

    def test_shoal(self):
        colours, seen = self.run_both("shoal", "--instances", "500")
        self.check(colours, seen[2])
        self.assertGreater(sum(row.count(128) for row in seen[2]), 50)
        self.assertGreater(sum(row.count(255) for row in seen[2]), 500)

    def test_sheet_updated_and_defined_anew(self):
        for way, more in (("low", []), ("low", ["--redefine"]), ("refit", []), ("medium", [])):
            colours, seen = self.run_both("sheet", "--columns", "64", *more, way=way)
            self.check(colours, seen[2])

    def test_flight(self):
        # Fog hides nothing near: what is far has its colour.
        colours, seen = self.run_both("flight", "--cells", "12", "--pieces", "3", "--wait")
        empty = {c for row, of_row in zip(colours, seen[2]) for c, what in zip(row, of_row)
                 if what == 0}
        self.assertLess(len(empty), 12)

    def test_day_and_night(self):
        colours, seen = self.run_both("day_and_night", "--trees", "60")
        # The window shows in its third frame what was queued for the second.
        half = WIDTH // 2
        self.check([row[:half] for row in colours], seen[2])
        self.check([row[half:] for row in colours], seen[3])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
