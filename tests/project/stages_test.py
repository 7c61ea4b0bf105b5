#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The stages of ./check: what fails or is missing is told at the end, and so is too long a time."""
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(commands, folder=ROOT, **environment):
    return subprocess.run(
        ["bash", "-uo", "pipefail", "-c", f"source {ROOT}/.ci/stages.sh\n{commands}"], cwd=folder,
        env={"PATH": "/usr/bin:/bin", **environment}, capture_output=True, text=True, check=False)


class Stages(unittest.TestCase):
    def test_all_is_well(self):
        result = run("stage one true; is_here bash two && stage two true; end_stages 1")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"== one\n== two\n +\d+ s  one\n +\d+ s  two\n +\d+ s  all")

    def test_goes_on_after_a_failure_and_tells_it(self):
        result = run("stage one false; stage two true; stage three false; end_stages")
        self.assertEqual((result.returncode, result.stderr), (1, "failed: one\nfailed: three\n"))
        self.assertIn("== two\n", result.stdout)

    def test_returns_what_the_command_did(self):
        self.assertEqual(run("stage one bash -c 'exit 7'").returncode, 7)

    def test_missing_tool_fails_unless_excused(self):
        commands = "is_here no-such-tool one && stage one true; end_stages"
        for excused, status in (("", 1), ("other", 1), ("other no-such-tool", 0)):
            with self.subTest(excused=excused):
                result = run(commands, OPENRT_WITHOUT=excused)
                self.assertEqual(result.returncode, status)
                self.assertIn("== one: not run without no-such-tool\n", result.stdout)

    def test_time_is_bounded(self):
        for seconds, status in ((59, 0), (120, 1)):
            result = run(f"SECONDS={seconds}; end_stages 1")
            self.assertEqual(result.returncode, status)
        self.assertEqual(result.stderr, "failed: more than 1 minutes\n")


class LongRuns(unittest.TestCase):
    def test_every_run_is_made(self):
        """Where there are no programs, of this project either: none of what fails ends the rest."""
        with tempfile.TemporaryDirectory() as empty:
            result = run(f"source {ROOT}/.ci/long.sh; PATH=/nowhere; run_long none; end_stages",
                         folder=empty)
        self.assertEqual(result.returncode, 1)
        self.assertIn("failed: coverage\n", result.stderr)
        self.assertIn("failed: fuzzing, not run without clang\n", result.stderr)
        stages = re.findall(r'stage ("[^"]+"|\w+)', (ROOT / ".ci/long.sh").read_text("utf-8"))
        for name in (name.strip('"') for name in stages):
            if name != "fuzz targets":  # they are made where there is clang
                self.assertRegex(result.stderr, f"failed: {name}[,\n]")


if __name__ == "__main__":
    unittest.main()
