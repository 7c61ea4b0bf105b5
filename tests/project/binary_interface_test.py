#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""abidiff notices what breaks programs, and nothing else.

usage: binary_interface_test.py C_COMPILER [unittest arguments]
"""
import pathlib
import sys
import tempfile
import unittest

import binary_interface

COMPILER = sys.argv.pop(1)
MAP = "A_0.1 { global: rtA; rtB; rtC; local: *; };\n"
SOURCE = """#define SHOWN __attribute__((visibility("default")))
typedef struct RTx { float a; int b; } RTx;
SHOWN int rtA(const RTx *x, int n) { return n + x->b; }
SHOWN void rtB(void) {}
"""


class Differences(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def told(self, name, source):
        folder = self.folder / name
        folder.mkdir()
        (folder / "map").write_text(MAP)
        return binary_interface.interface("libx", source, folder / "map", [], COMPILER, folder)

    def test_differences(self):
        before = self.told("before", SOURCE)
        more = SOURCE + "SHOWN void rtC(int n) { (void)n; }\n"
        for name, source in (("same", SOURCE), ("one more function", more),
                             ("names", SOURCE.replace("int n)", "int m)").replace("n +", "m +"))):
            with self.subTest(name):
                self.assertEqual(binary_interface.differences(before, self.told(name, source)), "")
        for name, old, new in (("gone", "SHOWN void rtB(void) {}\n", ""),
                               ("member", "float a;", "double a;"),
                               ("order", "float a; int b;", "int b; float a;"),
                               ("parameter", "int n)", "long n)"),
                               ("result", "int rtA", "char rtA")):
            with self.subTest(name):
                self.assertIn(old, SOURCE)
                now = self.told(name, SOURCE.replace(old, new))
                self.assertNotEqual(binary_interface.differences(before, now), "")


if __name__ == "__main__":
    unittest.main()
