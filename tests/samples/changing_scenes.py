#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The samples whose scenes change, off-screen and small: frames differ, and are what they should.

changing_scenes.py FOLDER_OF_PROGRAMS
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from program_runs import Png

PROGRAMS = pathlib.Path(sys.argv[1])
SECONDS = 100
ENVIRONMENT = dict(os.environ, OPENRT_THREADS="2")


class ChangingScenes(unittest.TestCase):
    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name)

    def tearDown(self):
        self._temporary.cleanup()

    def run_program(self, program, *arguments):
        return subprocess.run([str(PROGRAMS / program), *arguments], capture_output=True,
                              timeout=SECONDS, cwd=self.folder, env=ENVIRONMENT)

    def pictures(self, program, frames, *arguments, size="48x36", still=0):
        """The frames as lists of pixels; but for so many each differs from the one before."""
        result = self.run_program(program, "--rt-offscreen", str(frames), "--rt-size", size,
                                  "--rt-output", "frame%d.png", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr.decode())
        self.assertEqual(result.stderr, b"")
        pictures = []
        for frame in range(frames):
            png = Png((self.folder / f"frame{frame}.png").read_bytes())
            width, height = map(int, size.split("x"))
            self.assertEqual((png.width, png.height), (width, height))
            pictures.append([png.pixel(x, y)[:3] for y in range(height) for x in range(width)])
        for before, after in zip(pictures[still:], pictures[still + 1:]):
            self.assertFalse(before == after)
        return pictures

    def test_fish_move_and_are_as_many_as_asked_for(self):
        few = self.pictures("shoal", 2, "--instances", "40")
        many = self.pictures("shoal", 2, "--instances", "3000")
        background = few[0][0]
        self.assertGreater(sum(a != b for a, b in zip(few[0], many[0])), len(few[0]) // 10)
        self.assertGreater(len(set(many[0])), len(set(few[0])))
        self.assertIn(background, many[0])

    def test_updated_and_redefined_sheets_are_the_same(self):
        updated = self.pictures("sheet", 3, "--columns", "40")
        redefined = self.pictures("sheet", 3, "--columns", "40", "--redefine")
        self.assertTrue(updated == redefined)
        self.assertGreater(len(set(updated[0])), 100)

    def test_landscape_is_there_when_frames_wait_for_it(self):
        arguments = ("--cells", "10", "--pieces", "3")
        waited = self.pictures("flight", 3, "--wait", *arguments)
        again = self.pictures("flight", 3, "--wait", *arguments)
        self.assertTrue(waited == again)
        self.assertGreater(len(set(waited[2])), 100)
        # Without, only the first frame is sure to have all of it.
        self.assertTrue(self.pictures("flight", 4, *arguments)[0] == waited[0])

    def test_flight_goes_on_past_what_it_began_with(self):
        # 60 frames are 2.4 seconds, and as many pieces.
        pictures = self.pictures("flight", 60, "--cells", "3", "--pieces", "2", "--wait",
                                 size="16x12")
        self.assertGreater(len(set(pictures[59])), 20)

    def test_day_is_bright_and_night_dark(self):
        # The second frame still shows what was queued for the first.
        for picture in self.pictures("day_and_night", 3, "--trees", "30", size="64x32", still=1):
            rows = [picture[64 * y:64 * (y + 1)] for y in range(32)]
            day = sum(sum(p) for row in rows for p in row[:32])
            night = sum(sum(p) for row in rows for p in row[32:])
            self.assertGreater(day, 2 * night)
            self.assertGreater(len({p for row in rows for p in row[32:]}), 50)

    def test_frame_rate_is_printed_when_asked_for(self):
        for program in ("shoal", "sheet", "flight", "day_and_night"):
            small = {"shoal": ["--instances", "3"], "sheet": ["--columns", "8"],
                     "flight": ["--cells", "2", "--pieces", "1"], "day_and_night": ["--trees", "1"]}
            arguments = ["--rt-offscreen", "2", "--rt-size", "8x8", *small[program]]
            silent = self.run_program(program, *arguments)
            self.assertEqual((silent.returncode, silent.stdout), (0, b""))
            told = self.run_program(program, "--fps", *arguments)
            self.assertRegex(told.stdout.decode(), re.escape(program) +
                             r": 2 frames, [\d.]+ a second, [\d.]+ ms to describe one\n")

    def test_wrong_options_end_the_program(self):
        for arguments in (["--instances", "0"], ["--instances"], ["--fish"], ["--instances", "9x"]):
            result = self.run_program("shoal", "--rt-offscreen", "1", *arguments)
            self.assertEqual(result.returncode, 2)
            self.assertIn(b"--instances 1..10000000", result.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
