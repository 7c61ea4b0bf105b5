#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Programs whose arguments are names of files take no option for one.

usage: file_arguments.py FOLDER_OF_PROGRAMS
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = pathlib.Path(sys.argv.pop(1)).resolve()
TOUR = ("01_triangle", "02_instances", "03_sphere", "04_floor", "05_fixed_shader", "06_shaders",
        "07_frame_queue")


class FileArguments(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, program, *arguments):
        return subprocess.run([PROGRAMS / program, *arguments], capture_output=True, text=True,
                              timeout=200, cwd=self.folder)

    def check_refused(self, program, *arguments, line):
        result = self.run_program(program, *arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""), (program, arguments))
        self.assertRegex(result.stderr, rf"\A{line}\n\Z")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_options(self):
        for program in (*TOUR, "openrt-texture-floor", "openrt-gallery"):
            self.check_refused(program, "--help", line=f"usage: {program} .*")
        self.check_refused("openrt-gallery", ".", "--help", line="usage: .*")
        for program in ("openrt-texture-floor", "openrt-gallery"):
            self.check_refused(program, line=f"usage: {program} .*")

    def test_files_are_written(self):
        self.assertEqual(self.run_program("01_triangle", "a.png").returncode, 0)
        self.assertEqual(self.run_program("openrt-texture-floor", "b.png").returncode, 0)
        self.assertEqual(self.run_program("openrt-gallery", ".", "Phong").returncode, 0)
        self.assertEqual({path.name for path in self.folder.iterdir()},
                         {"a.png", "b.png", "Phong.png"})

    def test_gallery_refuses_unknown_classes(self):
        self.check_refused("openrt-gallery", ".", "Phong", "Nothing",
                           line="openrt-gallery: there is no class Nothing")

    def test_gallery_stops_where_nothing_can_be_written(self):
        result = self.run_program("openrt-gallery", "no/folder")
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
