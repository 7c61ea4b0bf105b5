#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Frames a second of the samples of changing scenes, without a window.

usage: sample_rates.py --programs FOLDER [--peers FOLDER] [--frames N] [--size WxH]
                       --json FILE.json

FOLDER is where the build puts them: BUILD/bin/changing; BUILD/bin/embree has the same programs with
their scenes and rays in Embree, without shading. Each runs three times, by turns; the best counts,
of Embree's that of the best way to bring the scene up to date. `dynamic_plot.py --samples` makes a
table of the file.
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
WAYS = ("refit", "low", "medium")
RATE = re.compile(r": (\d+) frames, ([0-9.]+) a second, ([0-9.]+) ms to describe one")
PEER = re.compile(r"embree: ([0-9.]+) ms committing, ([0-9.]+) ms tracing; "
                  r"rays: (\d+) primary, (\d+) shadow, (\d+) reflected")


def run(programs, sample, options, more=()):
    program = pathlib.Path(programs, sample.partition(",")[0]).resolve()
    told = subprocess.run([program, *SAMPLES[sample], *more, "--fps", "--rt-offscreen",
                           str(options.frames), "--rt-size", options.size], check=True,
                          capture_output=True, text=True, timeout=600).stdout
    found = RATE.search(told)
    if not found:
        raise SystemExit(f"{program} did not say how fast it was: {told}")
    return {"sample": sample, "frames": int(found[1]), "rate": float(found[2]),
            "describe": 1e-3 * float(found[3])}, told


def run_peer(programs, sample, way, options):
    result, told = run(programs, sample, options, ("--embree", way))
    found = PEER.search(told)
    if not found:
        raise SystemExit(f"the peer of {sample} did not say what it did: {told}")
    result.update(way=way, commit=1e-3 * float(found[1]), trace=1e-3 * float(found[2]),
                  rays=sum(int(found[i]) for i in (3, 4, 5)))
    return result


def keep(best, key, result):
    if key not in best or result["rate"] > best[key]["rate"]:
        best[key] = result


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--programs", type=pathlib.Path, required=True)
    parser.add_argument("--peers", type=pathlib.Path)
    parser.add_argument("--frames", type=int, default=40)
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--json", type=pathlib.Path, required=True)
    options = parser.parse_args()
    best, peers = {}, {}
    for _ in range(3):
        for sample in SAMPLES:
            keep(best, sample, run(options.programs, sample, options)[0])
            if not options.peers:
                continue
            for way in WAYS:
                keep(peers, sample, run_peer(options.peers, sample, way, options))
    report = {"size": options.size, "samples": list(best.values()), "peers": list(peers.values())}
    options.json.write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    for sample, result in best.items():
        peer = f", Embree {peers[sample]['rate']:8.2f}" if sample in peers else ""
        print(f"{sample:22} {result['rate']:8.2f} frames a second{peer}")


if __name__ == "__main__":
    main()
