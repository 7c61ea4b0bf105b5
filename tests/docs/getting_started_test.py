#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The programs of docs/getting-started.md, saved, compiled and run as the page says.

usage: getting_started_test.py BUILD_DIR C_COMPILER
"""
import pathlib
import re
import sys
import tempfile
import unittest

from pages import ROOT, blocks, commands
from reader import Reader

BUILD, COMPILER = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
TEXT = (ROOT / "docs/getting-started.md").read_text(encoding="utf-8")

def ppm(data):
    head, body = re.match(rb"P6\n(\d+ \d+)\n255\n(.*)", data, re.DOTALL).groups()
    width, height = map(int, head.split())
    return width, height, [body[i:i + 3] for i in range(0, 3 * width * height, 3)]


class GettingStarted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        names = re.findall(r"[Ss]ave this as `(\w+\.c)`", TEXT)
        programs = blocks(TEXT, "c")
        assert len(names) == len(programs)
        for name, program in zip(names, programs):
            (cls.folder / name).write_text(program)
        cls.reader = Reader(cls.folder, BUILD, {"cc": f"{COMPILER} -std=c99 -Wall -Wextra"})

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_commands(self, name):
        """Those of the page that speak of a program; what the last of them printed."""
        wanted = [c for c in commands(TEXT) if re.search(rf"(^cc {name}\.c |^\./{name}( |$))", c)]
        self.assertEqual(len(wanted), 2)
        return [self.reader.run(command) for command in wanted][-1]

    def test_picture(self):
        self.run_commands("picture")
        width, height, pixels = ppm((self.folder / "picture.ppm").read_bytes())
        self.assertEqual((width, height), (320, 240))
        orange = [p for p in pixels if p[0] > 2 * p[2] and p[0] > 100]
        grey = {p[0] for p in pixels if p[0] == p[1] == p[2] and p[0] > 0}
        self.assertGreater(len(orange), 3000)
        self.assertGreater(max(grey), 3 * min(grey))  # the floor, lit and in shadow

    def test_window(self):
        if not (BUILD / "lib/librtut.so").exists():
            self.skipTest("rtut was not built")
        self.run_commands("window")
        frames = [(self.folder / f"frame{i}.png").read_bytes() for i in range(2)]
        self.assertTrue(all(len(f) > 5000 for f in frames))
        self.assertNotEqual(*frames)

    def test_ray(self):
        printed = self.run_commands("ray").strip()
        self.assertIn(f"It prints `{printed}`", TEXT)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
