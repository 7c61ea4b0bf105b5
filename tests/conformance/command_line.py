#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-conformance tests the library that it is told to, and refuses what it can not.

usage: command_line.py OPENRT_CONFORMANCE LIBRARY ANOTHER_LIBRARY
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, LIBRARY, ANOTHER = sys.argv[1:]
ONE_CASE = ["--quick", "--cases", "state/"]


def run(*arguments, **options):
    return subprocess.run([PROGRAM, *arguments], stderr=subprocess.PIPE, text=True, timeout=300,
                          **{"stdout": subprocess.PIPE, **options})


class CommandLine(unittest.TestCase):
    def check_refused(self, *arguments):
        result = run(*arguments)
        self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
        self.assertRegex(result.stderr, r"\Aopenrt-conformance: .*\n\Z")
        return result.stderr

    def test_library(self):
        result = run("--library", LIBRARY, *ONE_CASE)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)

    def test_what_ld_so_passes_over_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            noise = pathlib.Path(folder, "noise.so")
            noise.write_text("noise" * 100)
            spaced = pathlib.Path(folder, "a library.so")
            shutil.copyfile(LIBRARY, spaced)
            self.assertIn("invalid ELF", self.check_refused("--library", noise, *ONE_CASE))
            self.assertIn("a space", self.check_refused("--library", spaced, *ONE_CASE))

    def test_another_library_is_refused(self):
        self.assertIn("rtInit", self.check_refused("--library", ANOTHER, *ONE_CASE))

    def test_unknown_case(self):
        for arguments in (["--cases", "nosuch"], ["--cases", "picture/nosuch", "--list"],
                          ["--cases", "nosuch", "--times"]):
            self.assertIn("none is called so", self.check_refused(*arguments))

    def test_full_disk(self):
        for arguments in (["--list"], ONE_CASE):
            with open("/dev/full", "wb") as full:
                result = run(*arguments, stdout=full)
            self.assertEqual((result.returncode, result.stderr),
                             (3, "openrt-conformance: the output can not be written\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
