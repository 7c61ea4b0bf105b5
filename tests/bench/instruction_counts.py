#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Counts the instructions of fixed small workloads under callgrind and compares them with the
stored counts: a workload that takes more than 3 % more, or less, fails. Counts hold for one
compiler; with another, or without valgrind, the check is skipped and says so.

To store new counts, when a change is meant: cmake --build BUILD --target update-instruction-counts
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
TOLERANCE = 0.03
ISA = "sse4"
WORKLOADS = ["Build", "KdBuild", "Primary", "Shadow", "Ao", "Bounce", "Precise", "Frame"]


def count(program, again):
    """Instructions of each workload: of the function counted<Workload>."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "callgrind.out"
        run = subprocess.run(
            ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--toggle-collect=counted*",
             *[f"--dump-after=counted{name}" for name in WORKLOADS],
             f"--callgrind-out-file={out}", program, ISA, str(again)],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if run.returncode == 2:
            print(f"Skipped: no {ISA} here.")
            sys.exit(SKIPPED)
        if run.returncode != 0:
            sys.exit(run.stderr)
        counts = {}
        for dump in pathlib.Path(folder).iterdir():
            text = dump.read_text()
            trigger = re.search(r"^desc: Trigger: --dump-after=counted(\w+)", text, re.M)
            totals = re.search(r"^(?:totals|summary): (\d+)", text, re.M)
            if trigger and totals:
                counts[trigger[1]] = counts.get(trigger[1], 0) + int(totals[1])
        return counts


def differences(counts, stored):
    """Lines about workloads whose counts are off."""
    lines = []
    for name in sorted(counts.keys() | stored.keys()):
        if name not in counts or name not in stored:
            lines.append(f"{name}: {'not counted' if name in stored else 'not stored'}")
            continue
        change = counts[name] / stored[name] - 1
        print(f"{name:12} {counts[name]:12,} stored {stored[name]:12,} {change:+7.2%}")
        if abs(change) > TOLERANCE:
            lines.append(f"{name}: {change:+.2%}")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--program", required=True)
    parser.add_argument("--counts", required=True, type=pathlib.Path)
    parser.add_argument("--compiler", required=True, help="name and version")
    parser.add_argument("--build-type", required=True)
    parser.add_argument("--update", action="store_true", help="store what is counted now")
    parser.add_argument("--control", action="store_true",
                        help="do a sixteenth of the work again: all workloads must be noticed")
    options = parser.parse_args()

    if not shutil.which("valgrind"):
        print("Skipped: there is no valgrind.")
        return SKIPPED
    if options.build_type != "Release":
        print(f"Skipped: counts are of Release builds, this is {options.build_type}.")
        return SKIPPED
    if options.update:
        counts = count(options.program, 0)
        options.counts.write_text(json.dumps(
            {"compiler": options.compiler, "isa": ISA, "instructions": dict(sorted(counts.items()))},
            indent=2) + "\n")
        print(options.counts.read_text())
        return 0
    stored = json.loads(options.counts.read_text())
    if stored["compiler"] != options.compiler:
        print(f"Skipped: the counts are of {stored['compiler']}, this is {options.compiler}.")
        return SKIPPED
    if stored["isa"] != ISA:
        sys.exit(f"The counts are of {stored['isa']}.")

    wrong = differences(count(options.program, 1 if options.control else 0),
                        stored["instructions"])
    if options.control:
        missed = stored["instructions"].keys() - {line.split(":")[0] for line in wrong}
        print("Noticed." if not missed else f"Not noticed: {sorted(missed)}")
        return 1 if missed else 0
    if wrong:
        print("Off by more than {:.0%}: {}\nIf that is meant: cmake --build BUILD --target "
              "update-instruction-counts".format(TOLERANCE, ", ".join(wrong)))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
