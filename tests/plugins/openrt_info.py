# SPDX-License-Identifier: MIT
"""Runs openrt-info: what it prints, and its exit status.

usage: openrt_info.py PROGRAM FOLDER_OF_TEST_PLUGINS
"""
import os
import re
import subprocess
import sys
import unittest

PROGRAM, PLUGINS = sys.argv.pop(1), sys.argv.pop(1)


def run(*arguments, **environment):
    result = subprocess.run([PROGRAM, *arguments], text=True, timeout=120, check=False,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            env={**os.environ, **environment})
    return result.returncode, result.stdout, result.stderr


class OpenrtInfo(unittest.TestCase):
    def test_library(self):
        code, out, err = run(OPENRT_SHADER_PATH=PLUGINS, OPENRT_THREADS="3")
        self.assertEqual(code, 0, err)
        for words in ("OpenRT ", "shader interface 1.", "instruction set: ", "OPENRT_THREADS=3",
                      f"  {PLUGINS}\n", "  Phong: surface, shades packets\n",
                      "    shininess: float, per shader\n", "  Pinhole: camera\n",
                      "threads that render: 3", "linked libraries:\n  /",
                      f"{PLUGINS}/kinds.so:\n", "    heat: float, per vertex\n",
                      "    gain: float, per triangle\n"):
            self.assertIn(words, out)
        self.assertRegex(out, r"^OpenRT (\d+\.\d+\.\d+), this program \1,")
        self.assertRegex(out, r"\n  /\S*/libOpenRT\.so\.0\n")
        self.assertEqual(re.findall(r"threads that render: \d+", run(OPENRT_THREADS="1")[1]),
                         ["threads that render: 1"])
        self.assertIn("fault_Version.so: is made for version 77", err)

    def test_variables_that_can_not_be_followed(self):
        for name, value, reason in (("OPENRT_THREADS", "abc", "not a number from 0 to 1024"),
                                    ("OPENRT_ISA", "abc", "unknown; using \\w+"),
                                    ("OPENRT_LOG", "/no/file", "No such file or directory"),
                                    ("OPENRT_TRACE", "/no/file", "No such file or directory")):
            err = run(f"{PLUGINS}/missing.so", **{name: value})[2]
            self.assertRegex(err, rf"(?m)^openrt: {name}={value}: {reason}$")

    def test_files(self):
        code, out, err = run(f"{PLUGINS}/kinds", f"{PLUGINS}/two_halves.so")
        self.assertEqual((code, err), (0, ""))
        for words in ("Beam: light", "Backdrop: environment", "Slide: camera", "Matt: surface",
                      "Dimmer: rendering object", "  Red: surface\n"):
            self.assertIn(words, out)
        self.assertNotIn("Phong", out)

    def test_bad_files(self):
        for name, words in (("fault_Magic.so", "no descriptor"), ("missing.so", "no such file"),
                            ("throwing.so", "out of chalk")):
            code, out, err = run(f"{PLUGINS}/{name}")
            self.assertEqual(code, 1, out)
            self.assertIn(words, err)
        code, out, _ = run(f"{PLUGINS}/throwing.so")
        self.assertIn("Fine: surface", out)

    def test_packets(self):
        code, out, _ = run("--check-packets", f"{PLUGINS}/packets.so")
        self.assertEqual(code, 1, out)
        self.assertIn("packets.so, Honest: both forms agree at ", out)
        for name in ("Ulp", "Silent", "Unstable", "Gambler"):
            self.assertRegex(out, rf", {name}: \d+ of \d+ points differ: ")
        code, out, _ = run("--check-packets", f"{PLUGINS}/kinds.so")
        self.assertEqual(code, 0, out)
        self.assertIn("Matt: shades no packets", out)
        self.assertEqual(run("--check-packets", f"{PLUGINS}/fault_Size.so")[0], 1)

    def test_reads(self):
        code, out, _ = run("--check-reads", f"{PLUGINS}/reads.so")
        self.assertEqual(code, 1, out)
        self.assertIn("reads.so, Truthful: reads nothing but what it says", out)
        self.assertIn("Forgetful: reads what it does not say: shading normal, texture coord", out)
        code, out, _ = run("--check-reads", f"{PLUGINS}/kinds.so")
        self.assertEqual(code, 0, out)
        self.assertIn("Matt: does not say what it reads", out)

    def test_command_line(self):
        code, out, _ = run("--help")
        self.assertEqual(code, 0)
        self.assertIn("--check-packets", out)
        self.assertEqual(run("--nonsense")[0], 2)


if __name__ == "__main__":
    unittest.main()
