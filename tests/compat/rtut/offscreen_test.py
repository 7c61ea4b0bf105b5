#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Programs with rtut windows, off-screen and on a virtual screen: order of calls, clock, files,
wrong arguments."""
import argparse
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PROGRAM = None
LIBRARY = None
HEADER = None


def run(*arguments, folder=None, timeout=60):
    # No display, and no run-time folder of one: nothing may ask for it.
    environment = {k: v for k, v in os.environ.items()
                   if k not in ("DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR")}
    return subprocess.run([PROGRAM, *arguments], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=timeout)


def read_png(path):
    """(width, height, rows of (r, g, b) from the top) of an 8-bit RGB picture."""
    data = path.read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + length]
        header = struct.unpack(">IIBBBBB", body) if kind == b"IHDR" else header
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    width, height, depth, color = header[:4]
    assert (depth, color) == (8, 2)
    raw, rows, stride = zlib.decompress(packed), [], width * 3
    previous = bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        kind, line = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left = line[i - 3] if i >= 3 else 0
            up, corner = previous[i], previous[i - 3] if i >= 3 else 0
            if kind == 1:
                line[i] = (line[i] + left) & 255
            elif kind == 2:
                line[i] = (line[i] + up) & 255
            elif kind == 3:
                line[i] = (line[i] + (left + up) // 2) & 255
            elif kind == 4:
                guess = left + up - corner
                best = min((abs(guess - v), n, v) for n, v in enumerate((left, up, corner)))[2]
                line[i] = (line[i] + best) & 255
        rows.append([tuple(line[i:i + 3]) for i in range(0, stride, 3)])
        previous = bytes(line)
    return width, height, rows


def read_pfm(path):
    """(width, height, rows of floats from the bottom) of a grey little-endian picture."""
    kind, size, scale, data = path.read_bytes().split(b"\n", 3)
    assert (kind, scale) == (b"Pf", b"-1.0")
    width, height = map(int, size.split())
    values = struct.unpack(f"<{width * height}f", data)
    return width, height, [values[y * width:(y + 1) * width] for y in range(height)]


class Offscreen(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def check_frames(self, count, size=16):
        files = sorted(self.folder.iterdir())
        self.assertEqual([f.name for f in files], [f"frame{i:03d}.png" for i in range(count)])
        for number, file in enumerate(files):
            width, height, rows = read_png(file)
            self.assertEqual((width, height), (size, size))
            quarter = size // 4
            for y, row in enumerate(rows):
                for x, pixel in enumerate(row):
                    inside = x // quarter == number % 4 and y >= size - quarter
                    self.assertEqual(pixel != (0, 0, 255), inside, (number, x, y))

    def test_frames_are_written_in_order(self):
        result = run("--rt-offscreen", "3", "--rt-output", "frame%03d.png", folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        self.assertEqual(result.stdout.splitlines(), [
            "arguments 0", "reshape 16 16", "visibility 1", "display 0 at 0 in 1",
            "timer 1 at 30", "display 1 at 40 in 1", "timer 2 at 60", "display 2 at 80 in 1"])
        self.check_frames(3)

    def test_depth(self):
        # The square lies halfway between the near and the far plane.
        result = run("--rt-offscreen", "2", "--rt-depth", "depth%d.pfm", folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(sorted(f.name for f in self.folder.iterdir()),
                         ["depth0.pfm", "depth1.pfm"])
        for number in range(2):
            width, height, rows = read_pfm(self.folder / f"depth{number}.pfm")
            self.assertEqual((width, height), (16, 16))
            for y, row in enumerate(rows):
                for x, depth in enumerate(row):
                    inside = x // 4 == number and y < 4
                    self.assertEqual(depth, 0.5 if inside else 1.0, (number, x, y))

    def test_depth_files_that_can_not_be_written(self):
        result = run("--rt-offscreen", "1", "--rt-depth", "no/such/folder/%d.pfm",
                     folder=self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn("no/such/folder/0.pfm", result.stderr)

    def test_single_buffered(self):
        result = run("single", "--rt-offscreen", "2", "--rt-output", "frame%03d.png",
                     folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.check_frames(2)

    def test_size(self):
        result = run("--rt-size", "32x32", "--rt-offscreen", "1", "--rt-output", "frame%03d.png",
                     folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("reshape 32 32", result.stdout)
        self.check_frames(1, 32)

    def test_idle_comes_between_timers_and_display(self):
        result = run("idle", "--rt-offscreen", "2")
        self.assertEqual(result.stdout.splitlines()[1:], [
            "reshape 16 16", "visibility 1", "idle at 0", "display 0 at 0 in 1", "timer 1 at 30",
            "idle at 40", "display 1 at 40 in 1"])

    def test_a_timer_without_time_comes_once_a_frame(self):
        result = run("restless", "--rt-offscreen", "4")
        self.assertEqual(result.returncode, 0, result.stderr)
        shown = re.findall(r"(display \d|restless -?\d) at (\d+)", result.stdout)
        self.assertEqual(shown, [
            ("display 0", "0"), ("restless 0", "30"), ("restless -1", "40"), ("display 1", "40"),
            ("restless 1", "40"), ("display 2", "80"), ("restless 2", "80"), ("display 3", "120")])

    def test_two_windows(self):
        result = run("two", "--rt-offscreen", "4", "--rt-output", "frame%03d.png",
                     folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        shown = re.findall(r"display \d at (\d+) in (\d)", result.stdout)
        self.assertEqual(shown, [("0", "1"), ("0", "2"), ("40", "1"), ("40", "2")])
        self.assertEqual(len(list(self.folder.iterdir())), 4)

    def test_a_closed_window_delivers_its_frame(self):
        result = run("close", "--rt-offscreen", "9", "--rt-output", "frame%03d.png",
                     folder=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.check_frames(1)

    def test_no_swap_ends_with_a_message(self):
        result = run("silent", "--rt-offscreen", "2")
        self.assertEqual(result.returncode, 1)
        self.assertIn("delivers no frame", result.stderr)

    def test_leaving_the_loop(self):
        result = run("leave", "--rt-offscreen", "50")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stdout.splitlines()[-1], "left the loop")

    def test_what_is_left_out_is_told_once(self):
        result = run("leftout", "--rt-offscreen", "1")
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr.count("rtutCreateMenu: menus are"), 1)
        self.assertEqual(result.stderr.count("rtutAddMenuEntry"), 1)
        self.assertIn("overlays are", result.stderr)
        self.assertIn("colour index is", result.stderr)
        self.assertIn("text rtutGet: an unknown query", result.stdout)

    def test_sizes_beyond_reason_are_refused(self):
        result = run("huge", "--rt-offscreen", "1")
        self.assertEqual(result.returncode, 0)
        self.assertIn("rtutInitWindowSize: not a size", result.stderr)

    def test_wrong_arguments_end_with_2(self):
        for wrong in (["--rt-offscreen"], ["--rt-offscreen", "x"], ["--rt-offscreen", "0"],
                      ["--rt-size", "axb", "--rt-offscreen", "1"], ["--rt-output", "a%d.png"],
                      ["--rt-depth", "a%d.pfm"], ["--rt-offscreen", "2", "--rt-depth", "a.pfm"],
                      ["--rt-offscreen", "2", "--rt-output", "same.png"],
                      ["--rt-offscreen", "1", "--rt-output", "%s.png"], ["-geometry", "q"]):
            result = run(*wrong)
            self.assertEqual(result.returncode, 2, wrong)
            self.assertTrue(result.stderr.startswith("rtut: "), wrong)
            self.assertEqual(result.stdout, "")

    def test_files_that_can_not_be_written(self):
        result = run("--rt-offscreen", "2", "--rt-output", "no/such/folder/%d.png",
                     folder=self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertIn("no/such/folder/0.png", result.stderr)

    def test_without_display_a_window_is_a_message(self):
        result = run()
        self.assertEqual(result.returncode, 1)
        self.assertIn("there is no display", result.stderr)


@unittest.skipUnless(shutil.which("xvfb-run"), "no xvfb-run")
class OnScreen(unittest.TestCase):
    def test_two_frames_in_a_window(self):
        result = subprocess.run(["xvfb-run", "-a", PROGRAM, "leave"], text=True, timeout=120,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(result.returncode, 0, result.stderr)
        shown = [line for line in result.stdout.splitlines() if not line.startswith("timer")]
        self.assertEqual([line.split(" at ")[0] for line in shown],
                         ["arguments 1", "reshape 16 16", "visibility 1", "display 0", "display 1",
                          "left the loop"])


class Exports(unittest.TestCase):
    def test_what_the_header_declares_and_nothing_else(self):
        text = re.sub(r"/\*.*?\*/", "", pathlib.Path(HEADER).read_text(encoding="utf-8"),
                      flags=re.DOTALL)
        declared = set(re.findall(r"\bRTAPI\b[^;{}()]*?\bRTAPIENTRY\s+(\w+)\s*\(", text))
        output = subprocess.run(["nm", "-D", "--defined-only", LIBRARY], text=True, check=True,
                                stdout=subprocess.PIPE).stdout
        symbols = [line.split()[-2:] for line in output.splitlines()]
        exported = {name.partition("@")[0] for kind, name in symbols if kind != "A"}
        self.assertEqual(exported, declared)
        self.assertGreater(len(declared), 110)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True)
    parser.add_argument("--library", required=True)
    parser.add_argument("--header", required=True)
    arguments, rest = parser.parse_known_args()
    PROGRAM, LIBRARY, HEADER = arguments.program, arguments.library, arguments.header
    unittest.main(argv=[sys.argv[0], *rest])
