#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-conformance tests the library that it is told to, and refuses what it can not.

usage: command_line.py OPENRT_CONFORMANCE LIBRARY ANOTHER_LIBRARY
"""
import os
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
        # Preloaded, it comes before the run-time library of the address sanitizer.
        sanitizer = os.environ.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"
        result = run("--library", LIBRARY, *ONE_CASE,
                     env={**os.environ, "ASAN_OPTIONS": sanitizer})
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

    def fake_program(self, folder, *lines):
        folder.mkdir()
        program = folder / "state"
        program.write_text("#!/bin/sh\ncat <<'END'\n" + "\n".join(lines) + "\nEND\n")
        program.chmod(0o755)

    def test_list(self):
        listed = run("--list", *ONE_CASE, "--openrt-programs", "/no/programs")
        self.assertEqual(listed.returncode, 0, listed.stderr)
        told = [line.split()[1] for line in run(*ONE_CASE).stdout.splitlines()[:-1]]
        self.assertEqual(listed.stdout.splitlines(), told)
        self.assertGreater(len(told), 100)

    def test_what_is_listed_is_answered_and_nothing_else(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            self.fake_program(folder / "gl", "case same", "1", "case other", "1", "case more")
            self.fake_program(folder / "rt", "case same", "1", "case other", "2")
            (folder / "gl/state.cases").write_text("same\nother\nmissing\n")
            result = run(*ONE_CASE, "--opengl-programs", folder / "gl", "--openrt-programs",
                         folder / "rt")
        self.assertEqual(result.stdout.splitlines(), [
            "FAILED state/missing", "    not answered. ",
            "FAILED state/other", "    OpenGL: 1; the library: 2", "passed state/same",
            "FAILED state/ends", "    answers more, which was not listed",
            "1 of 4 cases passed"])
        self.assertEqual(result.returncode, 3)

    def test_full_disk(self):
        for arguments in (["--list"], ONE_CASE):
            with open("/dev/full", "wb") as full:
                result = run(*arguments, stdout=full)
            self.assertEqual((result.returncode, result.stderr),
                             (1, "openrt-conformance: the output can not be written\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
