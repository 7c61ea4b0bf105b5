#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the sample programs while the n-th allocation of the library fails, off-screen and small.

    failing_samples.py BUILD PRELOAD [--whole] [--json FILE] [SAMPLE...]

No program may end by a signal, or hang, and a failure has to be recorded (OPENRT_LOG), unless the
picture is right all the same. Without --whole one allocation of each sample fails, alone and with
all that follow; with it the first hundred do, and a hundred spread over the rest, or what
FEWER_POSITIONS says of samples that take long.
"""
import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIZE = "24x24"
CPU_SECONDS = 300
SECONDS = 1200  # for who waits for ever, on a machine that does other work
POSITIONS = 200
# Where all fails a display of overlay, shoal and flight is thousands of errors, and rtut asks for a
# thousand displays before it gives up: minutes. The others make much before their picture.
FEWER_POSITIONS = {"overlay": 6, "flight": 8, "shoal": 8, "02_instances": 60,
                   "05_fixed_shader": 60, "06_shaders": 60, "sheet": 60}


def positions(allocations, wanted):
    """Half of those wanted are the first ones, the others are spread over the rest."""
    first = min(allocations, wanted // 2)
    spread = min(allocations - first, wanted - first)
    return [*range(first), *(first + i * (allocations - first) // spread for i in range(spread))]


def limit_time():
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS))


def is_sample(program):
    """Beside the ports lie programs of the tests."""
    return any(ROOT.glob(f"samples/*/{program.name}.c*"))


def arguments_of(program, folder):
    if program.parent.name in ("ports", "changing"):
        return ["-geometry", SIZE, "--rt-offscreen", "1", "--rt-output", f"{folder}/picture%d.png"]
    return [f"{folder}/picture0.png"]


class Samples:
    def __init__(self, preload, folder):
        self.preload, self.folder = preload, pathlib.Path(folder)

    def run(self, program, failing=None, then=False):
        """(exit status, allocations, failures, lines of the log, picture)"""
        for path in self.folder.iterdir():
            path.unlink()
        environment = dict(os.environ, LD_PRELOAD=str(self.preload), OPENRT_THREADS="1",
                           OPENRT_LOG=str(self.folder / "log"),
                           OPENRT_COUNT_FILE=str(self.folder / "count"))
        if failing is not None:
            environment["OPENRT_FAIL_ALLOCATION"] = str(failing)
        if then:
            environment["OPENRT_FAIL_THEN"] = "1"
        try:
            result = subprocess.run([program, *arguments_of(program, self.folder)],
                                    env=environment, cwd=self.folder, timeout=SECONDS,
                                    preexec_fn=limit_time,
                                    capture_output=True, check=False)
            status = result.returncode
        except subprocess.TimeoutExpired:
            status = "hang"
        read = {path.name: path.read_bytes() for path in self.folder.iterdir()}
        counts = [int(n) for n in read.get("count", b"0 0").split()]
        pictures = [data for name, data in sorted(read.items()) if name.endswith(".png")]
        return status, counts[0], counts[1], read.get("log", b"").count(b"\n"), pictures

    def try_program(self, program, whole):
        status, allocations, _, _, picture = self.run(program)
        entry = {"sample": program.name, "allocations": allocations, "positions": 0,
                 "failures": 0, "recorded": 0, "absorbed": 0, "faults": []}
        if status != 0 or allocations == 0:
            entry["faults"].append(f"does not run as it is: {status}, {allocations} allocations")
            return entry
        wanted = FEWER_POSITIONS.get(program.name, POSITIONS)
        for n in positions(allocations, wanted) if whole else [allocations // 3]:
            entry["positions"] += 1
            for then in (False, True):
                self.judge(entry, n, then, self.run(program, n, then), picture)
        return entry

    @staticmethod
    def judge(entry, n, then, outcome, picture):
        status, _, failures, log, seen = outcome
        told = f"{'from' if then else 'only'} allocation {n}"
        if status == "hang" or status < 0:
            entry["faults"].append(f"{told}: {status}")
            return
        entry["failures"] += failures > 0
        entry["recorded"] += failures > 0 and log > 0
        if failures > 0 and log == 0:
            entry["absorbed"] += 1
            if status == 0 and seen != picture:
                entry["faults"].append(f"{told}: another picture, and no error")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("preload", type=pathlib.Path)
    parser.add_argument("samples", nargs="*")
    parser.add_argument("--whole", action="store_true")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_intermixed_args()
    binaries = arguments.build.resolve() / "bin"
    programs = sorted([*(binaries / "ports").glob("*"), *(binaries / "changing").glob("*"),
                       *binaries.glob("0[0-9]_*")])
    programs = [p for p in programs if os.access(p, os.X_OK) and is_sample(p)]
    if arguments.samples:
        programs = [p for p in programs if p.name in arguments.samples]
    entries = []
    with tempfile.TemporaryDirectory() as folder:
        samples = Samples(arguments.preload.resolve(), folder)
        for program in programs:
            entries.append(samples.try_program(program, arguments.whole))
            print(json.dumps(entries[-1]), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps({"whole": arguments.whole, "samples": entries},
                                             indent=1) + "\n", encoding="utf-8")
    failures = sum(entry["failures"] for entry in entries)
    faults = sum(len(entry["faults"]) for entry in entries)
    tried = sum(entry["positions"] for entry in entries)
    print(f"{len(entries)} samples, {tried} allocations tried, {failures} failures, {faults} faults")
    return 1 if faults or not failures else 0


if __name__ == "__main__":
    sys.exit(main())
