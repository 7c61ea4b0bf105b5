#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Line coverage of the library's sources by the whole test suite, with g++ and gcov.

    coverage.py BUILD [--json FILE] [--report-only] [--tests REGEX]

Configures and builds BUILD, runs ctest there, and reads what gcov counted. Counted are the lines of
libsmart and compat (without the Python module and the fonts, which are data) that g++ made code of.
Exit status 1 if less than 95 % of them ran. Tests that fail are told; their lines count all the same.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
COUNTED = re.compile(r"(libsmart|compat(?!/python/|/rtut/fonts/))/")
LEAST = 0.95
FLAGS = "--coverage -O0 -g1 -fprofile-update=atomic"


def failed_tests(results):
    """Names, of ctest's results in JUnit's form."""
    cases = xml.etree.ElementTree.parse(results).getroot().iter("testcase")
    return [case.get("name") for case in cases if case.get("status") == "fail"]


def build_and_test(build, tests):
    """The names of the tests that failed."""
    subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                    "-DCMAKE_C_COMPILER=gcc", "-DCMAKE_CXX_COMPILER=g++",
                    f"-DCMAKE_C_FLAGS={FLAGS}", f"-DCMAKE_CXX_FLAGS={FLAGS}"], check=True)
    subprocess.run(["cmake", "--build", build], check=True)
    results = build / "tests.xml"
    results.unlink(missing_ok=True)
    command = ["ctest", "--test-dir", build, "--parallel", str(os.cpu_count()),
               "--output-junit", results]
    subprocess.run(command + (["-R", tests] if tests else []), check=False)
    return failed_tests(results)


def counted_lines(build):
    """{source: {line: how often it ran}}"""
    lines = collections.defaultdict(dict)
    for data in sorted(build.rglob("*.gcda")):
        result = subprocess.run(["gcov", "--json-format", "--stdout", data], cwd=build,
                                capture_output=True, text=True, check=False)
        for text in result.stdout.splitlines():
            for file in json.loads(text)["files"]:
                path = pathlib.Path(build, file["file"]).resolve()
                if not path.is_relative_to(ROOT):
                    continue
                source = str(path.relative_to(ROOT))
                if not COUNTED.match(source):
                    continue
                for line in file["lines"]:
                    number = line["line_number"]
                    lines[source][number] = max(lines[source].get(number, 0), line["count"])
    return lines


def folder_of(source):
    return "/".join(source.split("/")[:2])


def report(lines):
    folders = collections.defaultdict(lambda: [0, 0])
    for source, counts in lines.items():
        folder = folders[folder_of(source)]
        folder[0] += sum(count > 0 for count in counts.values())
        folder[1] += len(counts)
    least = sorted((sum(c > 0 for c in counts.values()) / len(counts), source)
                   for source, counts in lines.items() if len(counts) >= 20)
    return {"covered": sum(f[0] for f in folders.values()),
            "lines": sum(f[1] for f in folders.values()),
            "folders": {name: {"covered": f[0], "lines": f[1]}
                        for name, f in sorted(folders.items())},
            "least": [{"source": source, "share": round(share, 3)} for share, source in least[:10]]}


def is_enough(figures):
    return figures["covered"] >= LEAST * figures["lines"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--report-only", action="store_true")
    parser.add_argument("--tests", help="only those whose names match")
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    failed = [] if arguments.report_only else build_and_test(build, arguments.tests)
    figures = report(counted_lines(build))
    if not figures["lines"]:
        raise SystemExit(f"nothing was counted in {build}")
    if arguments.tests:
        figures["tests"] = arguments.tests
    if failed:
        figures["failed"] = failed
    if arguments.json:
        arguments.json.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    for name, folder in figures["folders"].items():
        print(f"{name:24} {100 * folder['covered'] / folder['lines']:6.1f} %")
    print(f"{'all':24} {100 * figures['covered'] / figures['lines']:6.1f} %")
    for name in failed:
        print(f"failed: {name}")
    if not is_enough(figures):
        print(f"less than {100 * LEAST:.0f} % of the lines ran")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
