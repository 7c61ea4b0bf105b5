#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Frames a second of the samples of changing scenes, without a window.

usage: sample_rates.py --programs FOLDER [--frames N] [--size WxH] --json FILE.json

FOLDER is where the build puts them: BUILD/bin/changing. Each runs three times, by turns; the best
counts. `dynamic_plot.py --samples` makes a table of the file.
"""
import argparse
import json
import pathlib
import re
import subprocess

SAMPLES = {
    "shoal": ["--instances", "10000"],
    "sheet": [],
    "sheet, defined anew": ["--redefine"],
    "flight": [],
    "day_and_night": [],
}
RATE = re.compile(r": (\d+) frames, ([0-9.]+) a second, ([0-9.]+) ms to describe one")


def run(programs, sample, frames, size):
    program = pathlib.Path(programs, sample.partition(",")[0]).resolve()
    told = subprocess.run([program, *SAMPLES[sample], "--fps", "--rt-offscreen", str(frames),
                           "--rt-size", size], check=True, capture_output=True, text=True,
                          timeout=600).stdout
    found = RATE.search(told)
    if not found:
        raise SystemExit(f"{program} did not say how fast it was: {told}")
    return {"sample": sample, "frames": int(found[1]), "rate": float(found[2]),
            "describe": 1e-3 * float(found[3])}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--frames", type=int, default=40)
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--json", type=pathlib.Path, required=True)
    options = parser.parse_args()
    best = {}
    for _ in range(3):
        for sample in SAMPLES:
            result = run(options.programs, sample, options.frames, options.size)
            if sample not in best or result["rate"] > best[sample]["rate"]:
                best[sample] = result
    report = {"size": options.size, "samples": list(best.values())}
    options.json.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    for result in best.values():
        print(f"{result['sample']:22} {result['rate']:8.2f} frames a second")


if __name__ == "__main__":
    main()
