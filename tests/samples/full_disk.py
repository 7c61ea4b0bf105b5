#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A program whose output is lost, as on a full disk, says so and fails.

usage: full_disk.py FOLDER_OF_PROGRAMS SOURCE_DIR
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAMS, SOURCE = (pathlib.Path(word).resolve() for word in sys.argv[1:])
FAILURES = {"openrt-accuracy": 1, "openrt-bench": 1, "openrt-cave": 1, "openrt-conformance": 1,
            "openrt-info": 1, "openrt-render": 1, "openrt-trace": 1, "openrt-view": 1,
            "openrt-xr": 1}
SCENE, PATH = SOURCE / "samples/models/courtyard.glb", SOURCE / "samples/vr/walk.path"
SMALL = ["--size", "16x16", "--frames", "1"]
FILES = ["-o", "picture.png"]
WALLS = ["--path", PATH, "--mono", "-o", "%s-%d.png"]
FEW = ["--rays", "10", "--identity", "10", "--cases", "H1-exact-vert"]
RESULTS = {"openrt-accuracy": (["--list"], [*FEW, "--table"]),
           "openrt-bench": (["memory", "--triangles", "100", "--objects", "1"],),
           "openrt-cave": ([SCENE, *SMALL, *WALLS, "--report-latency"],),
           "openrt-info": ([],),
           "openrt-render": ([SCENE, *SMALL, *FILES, "--stats"],)}


class FullDisk(unittest.TestCase):
    def check_fails(self, program, *arguments):
        with (self.subTest(program=program, arguments=arguments),
              tempfile.TemporaryDirectory() as folder, open("/dev/full", "wb") as full):
            result = subprocess.run([PROGRAMS / program, *arguments], stdout=full, timeout=200,
                                    stderr=subprocess.PIPE, text=True, cwd=folder)
            self.assertEqual((result.returncode, result.stderr),
                             (FAILURES[program], f"{program}: the output can not be written\n"))

    def test_every_program(self):
        built = [program for program in FAILURES if (PROGRAMS / program).exists()]
        self.assertIn("openrt-info", built)
        for program in built:
            for arguments in (["--help"], ["--version"], *RESULTS.get(program, ())):
                self.check_fails(program, *arguments)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
