#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What coverage.py counts, of which files, and when it is not enough."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest
from unittest import mock

import coverage

PROGRAM = """#include "{header}"
int main(int argc, char**) {{
    if (argc > 1) {{
        return half(argc);
    }}
    return 0;
}}
"""
HEADER = "inline int half(int n) { return n / 2; }\n"


class Files(unittest.TestCase):
    def test_counted(self):
        for source in ("libsmart/base/a.h", "compat/openrt/a.cpp", "compat/stream/a.cpp",
                       "compat/trace/a.cpp", "compat/mpi/a.cpp", "compat/remote/a.cpp",
                       "compat/rtut/shapes.cpp"):
            self.assertTrue(coverage.COUNTED.match(source), source)

    def test_not_counted(self):
        for source in ("compat/rtut/fonts/a.cpp", "compat/python/a.c", "tests/libsmart/a.cpp",
                       "samples/compat/a.c", "build/libsmart/a.cpp"):
            self.assertFalse(coverage.COUNTED.match(source), source)

    def test_every_source_has_a_folder(self):
        """Sources of the library lie where they are counted."""
        sources = [path.relative_to(coverage.ROOT).as_posix() for folder in ("libsmart", "compat")
                   for path in (coverage.ROOT / folder).rglob("*.cpp")]
        left_out = {coverage.folder_of(s) for s in sources if not coverage.COUNTED.match(s)}
        self.assertGreater(len(sources), 200)
        self.assertLessEqual(left_out, {"compat/rtut"})


class Report(unittest.TestCase):
    LINES = {"libsmart/base/a.cpp": {n: 1 for n in range(1, 96)},
             "compat/stream/b.cpp": {n: 0 for n in range(1, 6)}}

    def test_sums(self):
        figures = coverage.report(self.LINES)
        self.assertEqual((figures["covered"], figures["lines"]), (95, 100))
        self.assertEqual(figures["folders"]["compat/stream"], {"covered": 0, "lines": 5})
        self.assertEqual([f["source"] for f in figures["least"]], ["libsmart/base/a.cpp"])

    def test_what_is_enough(self):
        self.assertTrue(coverage.is_enough(coverage.report(self.LINES)))
        fewer = {**self.LINES, "compat/trace/c.cpp": {1: 0}}
        self.assertFalse(coverage.is_enough(coverage.report(fewer)))


class Results(unittest.TestCase):
    def test_failed_tests(self):
        with tempfile.TemporaryDirectory() as folder:
            results = pathlib.Path(folder, "tests.xml")
            results.write_text('<testsuite><testcase name="a" status="run"/>'
                               '<testcase name="b" status="fail"><failure/></testcase>'
                               '<testcase name="c" status="disabled"/></testsuite>')
            self.assertEqual(coverage.failed_tests(results), ["b"])


@unittest.skipUnless(shutil.which("g++") and shutil.which("gcov"), "no g++ and gcov")
class Counts(unittest.TestCase):
    def test_of_two_programs(self):
        """A header's line counts where one of the programs ran it."""
        with tempfile.TemporaryDirectory() as folder, \
                mock.patch.object(coverage, "ROOT", pathlib.Path(folder).resolve()):
            build = coverage.ROOT / "build"
            build.mkdir()
            header = coverage.ROOT / "libsmart/half.h"
            header.parent.mkdir()
            header.write_text(HEADER)
            for name, arguments in (("compat/rtu/one", []), ("compat/mpi/two", ["x"]),
                                    ("tests/three", [])):
                source = coverage.ROOT / f"{name}.cpp"
                source.parent.mkdir(parents=True)
                source.write_text(PROGRAM.format(header=header))
                program = build / source.stem
                subprocess.run(["g++", *coverage.FLAGS.split(), source, "-o", program], cwd=build,
                               check=True)
                subprocess.run([program, *arguments], check=False)
            self.assertEqual(coverage.counted_lines(build), {
                "libsmart/half.h": {1: 1},
                "compat/rtu/one.cpp": {2: 1, 3: 1, 4: 0, 6: 1},
                "compat/mpi/two.cpp": {2: 1, 3: 1, 4: 1, 6: 0}})


if __name__ == "__main__":
    unittest.main()
