#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-trace with whole programs: what is recorded plays to the same bits, also as C."""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

ARGUMENTS = None
OFFSCREEN = ["--rt-offscreen", "2", "--rt-size", "80x60", "--rt-threads", "1"]


def run(*words, **options):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True, timeout=120,
                          **options)


class Trace(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "calls.ort"

    def trace(self, *words):
        return run(ARGUMENTS.trace, *words, cwd=self.folder)

    def record(self, *program):
        result = self.trace("record", "-o", self.file, *program)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(self.file.exists())

    def replayed(self):
        result = self.trace("replay", self.file)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn("as recorded", result.stdout)
        self.assertNotIn(" 0 frames:", result.stdout)

    def compiled(self):
        source = self.folder / "program.c"
        result = self.trace("source", self.file)
        self.assertEqual(result.returncode, 0, result.stderr)
        source.write_text(result.stdout)
        program = self.folder / "program"
        library = pathlib.Path(ARGUMENTS.library)
        result = run(ARGUMENTS.compiler, "-std=c99", "-O0", *ARGUMENTS.flags.split(),
                     *[f"-I{folder}" for folder in ARGUMENTS.include], source, "-o", program,
                     library, f"-Wl,-rpath,{library.parent}", "-lm")
        self.assertEqual(result.returncode, 0, result.stderr)
        return run(program)

    def test_recorded_program(self):
        self.record(ARGUMENTS.program)
        self.replayed()
        result = self.compiled()
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("5 frames, 0 of them", result.stdout)

    def test_threads(self):
        self.record(ARGUMENTS.program, "threads")
        self.replayed()
        result = self.trace("source", self.file)
        self.assertEqual(result.returncode, 1)
        self.assertIn("several threads", result.stderr)

    def test_more_threads_than_there_are_numbers_for_end_the_recording(self):
        result = self.trace("record", "-o", self.file, ARGUMENTS.program, "many threads")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("the recording of calls ends: the program has more threads", result.stderr)
        self.assertIn("threads: 65536\n", self.trace("info", self.file).stdout)

    def test_frames_that_nothing_waits_for_are_not_compared(self):
        self.record(ARGUMENTS.program, "never")
        result = self.trace("replay", self.file)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertIn(" 0 frames: as recorded, but none of the frames that were rendered was compared",
                      result.stdout)

    def test_ports(self):
        for port in ARGUMENTS.ports:
            with self.subTest(pathlib.Path(port).name):
                self.record(port, *OFFSCREEN)
                self.replayed()
                if "gears" in port or "texbind" in port:
                    result = self.compiled()
                    self.assertEqual(result.returncode, 0, result.stdout)
                    self.assertIn(" 0 of them", result.stdout)

    def test_another_colour_in_the_source_is_another_frame(self):
        self.record(ARGUMENTS.program)
        text = self.trace("source", self.file).stdout
        self.assertIn("rtColor3ub(255, 128, 0)", text)
        (self.folder / "program.c").write_text(text)
        original = self.trace

        class Changed:
            returncode, stderr = 0, ""
            stdout = text.replace("rtColor3ub(255, 128, 0)", "rtColor3ub(0, 128, 0)")

        self.trace = lambda *words: Changed if words[0] == "source" else original(*words)
        self.assertEqual(self.compiled().returncode, 1)

    def test_pictures(self):
        self.record(ARGUMENTS.program)
        result = self.trace("replay", self.file, "-o", "frame%03d.png")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        pictures = sorted(p.name for p in self.folder.glob("*.png"))
        self.assertEqual(pictures, [f"frame{i:03d}.png" for i in range(1, 6)])
        for pattern in ("frame.png", "frame%s.png", "frame%d"):
            result = self.trace("replay", self.file, "--output", pattern)
            self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
            self.assertIn(pattern, result.stderr)

    def test_until(self):
        self.record(ARGUMENTS.program)
        result = self.trace("replay", self.file, "--until", "10")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(result.stdout.startswith("10 calls, 0 frames"), result.stdout)

        for wrong in ("0", "-1", "x", "1.5", str(2**64 + 1)):
            result = self.trace("replay", self.file, "--until", wrong)
            self.assertEqual((result.returncode, result.stderr), (
                2, f"openrt-trace: --until: '{wrong}' is not a number from 1\n"))

    def test_full_disk(self):
        self.record(ARGUMENTS.program)
        for command in ("replay", "dump", "info", "source"):
            with open("/dev/full", "wb") as full:
                result = subprocess.run([ARGUMENTS.trace, command, self.file], stdout=full,
                                        stderr=subprocess.PIPE, text=True, timeout=120)
            self.assertEqual((result.returncode, result.stderr),
                             (1, "openrt-trace: the output can not be written\n"), command)

    def test_what_is_no_file_is_neither_replaced_nor_played(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        for name in (pipe, self.folder, self.folder / "nowhere" / "calls.ort"):
            result = self.trace("record", "-o", name, ARGUMENTS.program)
            self.assertEqual((result.returncode, result.stdout), (125, ""), result.stderr)
            self.assertRegex(result.stderr, rf"\Aopenrt-trace: {name}: .*\n\Z")
        self.assertTrue(pipe.is_fifo())
        missing = self.folder / "nowhere"
        for name, reason in ((self.folder, "only a file can be read, not a folder or a device"),
                             (pipe, "only a file can be read, not a folder or a device"),
                             (missing, "No such file or directory")):
            result = self.trace("info", name)
            self.assertEqual((result.returncode, result.stderr),
                             (1, f"openrt-trace: {name}: {reason}\n"))

    def test_info_and_dump(self):
        self.record(ARGUMENTS.program)
        info = self.trace("info", self.file).stdout
        for line in ("frames: 5\n", "threads: 1\n", "contexts: 2\n"):
            self.assertIn(line, info)
        dump = self.trace("dump", self.file).stdout
        self.assertIn("rtColor3ub(255, 128, 0)", dump)
        self.assertIn("RT_INVALID_ENUM", dump)
        calls = int(info.split("calls: ")[1].split("\n")[0])
        self.assertEqual(sum(line[0] != " " for line in dump.splitlines()), calls)

    def test_killed_program_leaves_its_calls(self):
        self.record(ARGUMENTS.program)
        whole = self.file.read_bytes()
        self.file.write_bytes(whole[:len(whole) // 2] + bytes(4096))
        result = self.trace("info", self.file)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("the end is missing", result.stdout)

    def test_damage(self):
        self.record(ARGUMENTS.program)
        data = bytearray(self.file.read_bytes())
        data[len(data) // 2] ^= 1
        self.file.write_bytes(data)
        for command in ("replay", "dump", "info", "source"):
            result = self.trace(command, self.file)
            self.assertIn(result.returncode, (0, 1))
            if command == "replay":
                self.assertEqual(result.returncode, 1)
                self.assertIn("damaged", result.stderr)

    def test_wrong_command_lines(self):
        self.assertEqual(self.trace().returncode, 2)
        self.assertEqual(self.trace("paint").returncode, 2)
        self.assertEqual(self.trace("record").returncode, 125)
        self.assertEqual(self.trace("record", "--paint", ARGUMENTS.program).returncode, 125)
        self.assertEqual(self.trace("replay", "nothing.ort").returncode, 1)
        (self.folder / "text").write_text("no recording" * 10)
        self.assertEqual(self.trace("info", "text").returncode, 1)
        self.assertEqual(self.trace("--version").returncode, 0)
        self.assertEqual(self.trace("--help").returncode, 0)

    def test_status_of_the_program(self):
        for script, status in (("exit 7", 7), ("exit 3", 3), ("kill -KILL $$", 137), ("true", 125)):
            result = self.trace("record", "-o", self.file, "sh", "-c", script)
            self.assertEqual(result.returncode, status, script)
            self.assertIn("called nothing of OpenRT", result.stderr)
        result = self.trace("record", "-o", self.file, "sh", "-c", f"{ARGUMENTS.program}; exit 3")
        self.assertEqual((result.returncode, result.stderr), (3, ""))
        (self.folder / "file").touch(mode=0o644)
        for program, status, reason in ((self.folder / "none", 127, "No such file or directory"),
                                        (self.folder / "file", 126, "Permission denied")):
            result = self.trace("record", "-o", self.file, program)
            self.assertEqual((result.returncode, result.stderr),
                             (status, f"openrt-trace: {program}: {reason}\n"))

    def test_a_frame_that_is_not_as_recorded(self):
        self.record(ARGUMENTS.program, "painted over")
        result = self.trace("replay", self.file)
        self.assertEqual(result.returncode, 3, result.stdout + result.stderr)
        self.assertIn("frame 1 is not as recorded\n", result.stdout)

    def test_existing_files_are_not_overwritten_by_programs(self):
        self.file.write_text("mine")
        result = run(ARGUMENTS.program, env={**os.environ, "OPENRT_TRACE": str(self.file)})
        self.assertEqual(result.returncode, 0)
        self.assertIn("File exists", result.stderr)
        self.assertEqual(self.file.read_text(), "mine")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("--trace", "--compiler", "--library", "--program"):
        parser.add_argument(name, required=True)
    parser.add_argument("--flags", default="", help="those that the library is compiled with")
    parser.add_argument("--include", action="append", default=[])
    parser.add_argument("--ports", nargs="*", default=[])
    global ARGUMENTS
    ARGUMENTS, rest = parser.parse_known_args()
    for name in ("trace", "library", "program"):
        setattr(ARGUMENTS, name, pathlib.Path(getattr(ARGUMENTS, name)).resolve())
    unittest.main(argv=sys.argv[:1] + rest)


if __name__ == "__main__":
    main()
