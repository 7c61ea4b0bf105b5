#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-bench tells what is wrong with a file before it measures anything, as openrt-render does,
and writes its figures.

usage: files_test.py OPENRT_BENCH
"""
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM = sys.argv.pop(1)
RAYS = ["rays", "--size", "16", "--repeat", "1", "--threads", "1", "--scene"]
MEMORY = ["memory", "--triangles", "100", "--objects", "1", "--json"]


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=200,
                              cwd=self.folder)

    def check_refused(self, *arguments, line):
        result = self.run_program(*arguments)
        self.assertEqual((result.returncode, result.stdout), (1, ""), arguments)
        self.assertRegex(result.stderr, rf"\Aopenrt-bench: {line}\n\Z")

    def test_json(self):
        self.check_refused(*MEMORY, "no/file", line="no/file: No such file or directory")
        self.check_refused(*MEMORY, ".", line=".*: Is a directory")
        self.check_refused(*RAYS, "generated:100", "--json", "no/file",
                           line="no/file: No such file or directory")
        result = self.run_program(*MEMORY, "figures.json")
        self.assertEqual(result.returncode, 0, result.stderr)
        json.loads((self.folder / "figures.json").read_text(encoding="utf-8"))

    def test_threads(self):
        def measured(*arguments):
            self.assertEqual(self.run_program("build", "--scene", "generated:100", "--size", "16",
                                              "--repeat", "1", "--json", "figures.json",
                                              *arguments).returncode, 0)
            text = (self.folder / "figures.json").read_text(encoding="utf-8")
            return {int(n) for n in json.loads(text)["builders"][0]["build_seconds"]}
        all_cores = {1, len(os.sched_getaffinity(0))}
        self.assertEqual([measured(), measured("--threads", "0"), measured("--threads", "1")],
                         [all_cores, all_cores, {1}])
        for wrong in ("-1", "1025"):
            result = self.run_program(*RAYS, "generated:100", "--threads", wrong)
            self.assertEqual((result.returncode, result.stdout), (2, ""))

    def test_scene(self):
        def tri(count):
            return struct.pack("<I9f", count, 0, 0, 0, 1, 0, 0, 0, 1, 0)
        for name, content in (("one.tri", tri(1)), ("two.tri", tri(2)),
                              ("none.tri", struct.pack("<I", 0)), ("empty.tri", b"")):
            (self.folder / name).write_bytes(content)
        for scene, line in ((".", ".*: this is a folder, not a file"),
                            ("no.tri", "no.tri: there is no such file"),
                            ("two.tri", "two.tri: it says that it has 2 triangles, .*"),
                            ("none.tri", "none.tri: it shows no triangle"),
                            ("empty.tri", "empty.tri: it is too short .*")):
            self.check_refused(*RAYS, scene, line=line)
        self.assertEqual(self.run_program(*RAYS, "one.tri").returncode, 0)


if __name__ == "__main__":
    unittest.main()
