#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-xr where there is no runtime: it says so and ends. Frames need a real one.

usage: xr.py OPENRT_XR SOURCE_DIR
"""
import os
import pathlib
import subprocess
import sys
import unittest

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])


def run(*arguments, display=True):
    environment = dict(os.environ, XR_RUNTIME_JSON="/nonexistent/runtime.json")
    if not display:
        environment.pop("DISPLAY", None)
        environment.pop("WAYLAND_DISPLAY", None)
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60,
                          env=environment)


class WithoutRuntime(unittest.TestCase):
    def check_refused(self, result, status):
        self.assertEqual(result.returncode, status, result.stderr)
        self.assertEqual(result.stdout, "")
        # The loader has lines of its own to say.
        last = result.stderr.splitlines()[-1]
        self.assertTrue(last.startswith("openrt-xr: "), result.stderr)

    def test_says_what_is_missing(self):
        scene = SOURCE / "samples/models/courtyard.glb"
        self.check_refused(run(scene, display=False), 1)
        self.check_refused(run(scene), 1)

    def test_wrong_command_line(self):
        self.assertEqual(run("--no-such-option").returncode, 2)
        self.check_refused(run(SOURCE / "samples/models/courtyard.glb", "--size", "64x64"), 2)
        self.check_refused(run(SOURCE / "samples/models/courtyard.glb", "--scale", "0"), 2)

    def test_help(self):
        result = run("--help")
        self.assertEqual(result.returncode, 0)
        self.assertIn("--scale", result.stdout)
        self.assertNotIn("--size", result.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
