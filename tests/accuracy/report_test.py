#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""openrt-accuracy writes a report, and plot.py makes pictures and tables of it."""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree
from pathlib import Path

PLOT = Path(__file__).with_name("plot.py")
CASES = "H1-scale1e0,H1-scale1e6,H1-off1e1,H1-off1e2,H1-needle1e1,H1-needle1e2,H1-exact-ico5,H9"
SVG = "{http://www.w3.org/2000/svg}"


class Report(unittest.TestCase):
    program = ""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = Path(self.folder.name)

    def run_program(self, *arguments):
        return subprocess.run([self.program, *arguments], capture_output=True, text=True,
                              check=False)

    def plot(self, *arguments):
        return subprocess.run([sys.executable, PLOT, "--out", self.path / "pictures",
                               "--tables", self.path / "tables.md", *arguments],
                              capture_output=True, text=True, check=False)

    def test_wrong_options(self):
        for arguments in (["--no"], ["--size", "6"], ["--size", "many"], ["--isa", "none"],
                          ["--threads", "1025"],
                          ["--cases", "H99"], ["--cases", "H1,none-of-these"],
                          ["--engines", "nobody"], ["--engines", "all,nobody"]):
            done = self.run_program(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertRegex(done.stderr, r"\Aopenrt-accuracy: .*\n\Z")

    def test_no_promise_is_kept_that_was_not_tested(self):
        done = self.run_program("--cases", "none", "--scene", "generated:200", "--size", "8",
                                "--repeat", "1", "--threads", "1")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_threads(self):
        for arguments, count in ((["--threads", "0"], len(os.sched_getaffinity(0))),
                                 (["--threads", "1"], 1)):
            report = self.path / "threads.json"
            done = self.run_program("--rays", "10", "--identity", "10", "--cases",
                                    "H1-exact-vert", "--json", str(report), *arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(json.loads(report.read_text(encoding="utf-8"))["threads"], count)

    def test_report_and_pictures(self):
        report = self.path / "report.json"
        done = self.run_program("--rays", "60", "--identity", "32", "--cases", CASES, "--scene",
                                "generated:2000", "--size", "32", "--repeat", "1", "--threads",
                                "1", "--table", "--json", str(report))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("All promises are kept.", done.stdout)
        data = json.loads(report.read_text(encoding="utf-8"))
        self.assertEqual(len(data["cases"]), 7)
        for case in data["cases"]:
            kinds = [engine["engine"] for engine in case["engines"]]
            self.assertEqual(kinds[:3], ["openrt-fast", "openrt-watertight", "openrt-precise"])
            self.assertEqual(case["engines"][2]["lost"], 0)
            self.assertEqual([i["differing"] for i in case["identity"]], [0, 0, 0])
        done = self.plot(report)
        self.assertEqual(done.returncode, 0, done.stderr)
        names = sorted(path.name for path in (self.path / "pictures").iterdir())
        self.assertEqual(names, ["aspect.svg", "cost.svg", "offset.svg",
                                 "pareto-generated-2000.svg", "scale.svg"])
        for path in (self.path / "pictures").iterdir():
            root = xml.etree.ElementTree.parse(path).getroot()
            self.assertGreaterEqual(len(root.findall(SVG + "circle")), 3, path.name)
            width, height = float(root.get("width")), float(root.get("height"))
            for circle in root.findall(SVG + "circle"):
                self.assertTrue(0 <= float(circle.get("cx")) <= width, path.name)
                self.assertTrue(0 <= float(circle.get("cy")) <= height, path.name)
        tables = (self.path / "tables.md").read_text(encoding="utf-8")
        self.assertIn("| H1-exact-ico5 | 60 |", tables)

    def test_what_does_not_exist_is_refused(self):
        for arguments in (["--cases", "none", "--scene", str(self.path / "no.tri")],
                          ["--cases", "none", "--json", "/dev/full"]):
            done = self.run_program(*arguments)
            self.assertEqual(done.returncode, 1, arguments)
            self.assertIn("openrt-accuracy: ", done.stderr)

    def test_what_can_not_be_used_is_told_first(self):
        (self.path / "views").write_text("noise")
        for arguments, line in (
                (["--rays", "1000000000", "--json", "/no/file"], "/no/file: No such file.*"),
                (["--cases", "none", "--scene", "generated:100", "--cameras",
                  str(self.path / "views")], ".*/views: no view named 'generated:100'; see --name")):
            done = self.run_program(*arguments)
            self.assertEqual((done.returncode, done.stdout), (1, ""), arguments)
            self.assertRegex(done.stderr, rf"\Aopenrt-accuracy: {line}\n\Z")

    def test_a_broken_report_makes_no_pictures(self):
        report = self.path / "report.json"
        report.write_text("{}", encoding="utf-8")
        self.assertNotEqual(self.plot(report).returncode, 0)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    known, rest = parser.parse_known_args()
    Report.program = known.program
    unittest.main(argv=[sys.argv[0], *rest])
