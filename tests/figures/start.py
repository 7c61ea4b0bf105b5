#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Size of the stripped library, and the time from start to end of a program that renders a triangle.

    start.py BUILD [--json FILE] [--runs N]
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile
import time


def stripped_size(library):
    with tempfile.TemporaryDirectory() as folder:
        stripped = pathlib.Path(folder, "stripped.so")
        subprocess.run(["strip", "--strip-unneeded", "-o", stripped, library], check=True)
        return stripped.stat().st_size


def milliseconds(program, runs):
    times = []
    for _ in range(runs):
        started = time.perf_counter()
        subprocess.run([program], check=True)
        times.append(1000 * (time.perf_counter() - started))
    return {"median": round(statistics.median(times), 2), "least": round(min(times), 2)}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=40)
    arguments = parser.parse_args()
    library = (arguments.build / "lib/libOpenRT.so").resolve()
    figures = {"library_bytes": stripped_size(library), "runs": arguments.runs,
               "one_triangle_ms": milliseconds(arguments.build / "bin/one_triangle",
                                               arguments.runs),
               "true_ms": milliseconds("/bin/true", arguments.runs)}
    print(json.dumps(figures))
    if arguments.json:
        arguments.json.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
