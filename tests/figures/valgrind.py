#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs programs of a build under valgrind's memcheck: wrong accesses, values that were never set,
memory that is lost.

    valgrind.py BUILD [--json FILE] [PROGRAM...]

Without names: the program of one triangle, and the fuzz targets with their first inputs, which are
calls of every kind, recordings, messages and files. Exit status 1 if there is an error.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Kernels beyond AVX2 are unknown to it.
SETTINGS = {"OPENRT_ISA": "avx2", "OPENRT_THREADS": "2"}
COMMAND = ["valgrind", "--leak-check=full", "--errors-for-leak-kinds=definite,indirect",
           "--show-leak-kinds=definite,indirect", "--error-exitcode=99", "--num-callers=30"]


def programs(build):
    yield "one_triangle", []
    for path in sorted((build / "bin").glob("fuzz_*")):
        corpus = build / "tests/fuzz/corpus" / path.name.removeprefix("fuzz_")
        if corpus.is_dir():
            yield path.name, [corpus]


def judge(build, name, arguments):
    result = subprocess.run([*COMMAND, build / "bin" / name, *arguments], text=True, check=False,
                            capture_output=True, errors="replace",
                            env={**os.environ, **SETTINGS})
    errors = re.findall(r"ERROR SUMMARY: ([\d,]+) errors", result.stderr)
    entry = {"program": name, "inputs": sum(len(list(folder.iterdir())) for folder in arguments),
             "errors": int(errors[-1].replace(",", "")) if errors else None,
             "status": result.returncode}
    if result.returncode != 0:
        print(result.stderr[-8000:], file=sys.stderr)
    return entry


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("names", nargs="*", metavar="PROGRAM")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("there is no valgrind")
    build = arguments.build.resolve()
    entries = []
    for name, given in programs(build):
        if arguments.names and name not in arguments.names:
            continue
        entries.append(judge(build, name, given))
        print(json.dumps(entries[-1]), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(entries, indent=1) + "\n", encoding="utf-8")
    return 1 if not entries or any(entry["status"] for entry in entries) else 0


if __name__ == "__main__":
    sys.exit(main())
