#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The programs of docs/getting-started.md, saved, compiled and run as the page says.

usage: getting_started_test.py BUILD_DIR C_COMPILER
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from pages import ROOT, blocks, commands

BUILD, COMPILER = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
TEXT = (ROOT / "docs/getting-started.md").read_text(encoding="utf-8")

PC = """Name: {name}
Description: the build tree
Version: 0
Cflags: -I{root}/include -I{build}/include
Libs: -L{build}/lib {libraries}
"""


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
        for name, libraries in (("openrt", "-lOpenRT"), ("rtut", "-lrtut -lOpenRT")):
            (cls.folder / f"{name}.pc").write_text(
                PC.format(name=name, root=ROOT, build=BUILD, libraries=libraries))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def run_commands(self, name):
        """Those of the page that speak of a program; what the last of them printed."""
        environment = {**os.environ, "PKG_CONFIG_PATH": str(self.folder),
                       "LD_LIBRARY_PATH": str(BUILD / "lib")}
        wanted = [c for c in commands(TEXT) if re.search(rf"(^cc {name}\.c |^\./{name}( |$))", c)]
        self.assertEqual(len(wanted), 2)
        for command in wanted:
            command = re.sub(r"^cc ", f"{COMPILER} -Wall -Wextra -Werror -std=c99 ", command)
            result = subprocess.run(["bash", "-c", command], cwd=self.folder, env=environment,
                                    capture_output=True, text=True, timeout=120)
            self.assertEqual((result.returncode, result.stderr), (0, ""), command)
        return result.stdout

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
