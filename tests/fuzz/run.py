#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the fuzz targets of a build with the preset `fuzz`, one after the other.

    tests/fuzz/run.py BUILD [--minutes N] [--targets NAME...] [--json FILE]

Corpora grow in BUILD/fuzz/NAME. A fault is kept in BUILD/fuzz/faults and ends its target's run; once
it is mended the input goes into tests/fuzz/found/NAME. FILE gets one entry a run appended.
"""
import argparse
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
SEED_FOLDER = "tests/fuzz/corpus"
MAX_LENGTH = {"api_calls": 512, "shader_parameters": 256, "shader_class": 96, "plugin_file": 256,
              "tri": 512, "gltf": 4096, "mesh": 1024, "image": 2048, "trace": 768,
              "messages": 256, "environment": 1024, "head_path": 256}
DEFAULT_LENGTH = 4096


def targets_of(build):
    return sorted(path.name[len("fuzz_"):] for path in (build / "bin").glob("fuzz_*")
                  if os.access(path, os.X_OK))


def command(build, target, seconds):
    work = build / "fuzz" / target
    work.mkdir(parents=True, exist_ok=True)
    faults = build / "fuzz" / "faults"
    faults.mkdir(exist_ok=True)
    folders = [work, build / SEED_FOLDER / target, HERE / "found" / target]
    words = [build / "bin" / f"fuzz_{target}", f"-max_total_time={seconds}", "-timeout=20",
             "-rss_limit_mb=4096", "-malloc_limit_mb=2048", "-print_final_stats=1",
             f"-max_len={MAX_LENGTH.get(target, DEFAULT_LENGTH)}",
             f"-artifact_prefix={faults}/{target}-"]
    dictionary = HERE / f"{target}.dict"
    if dictionary.exists():
        words.append(f"-dict={dictionary}")
    return [str(word) for word in words + [f for f in folders if f.is_dir()]]


def number(text, pattern):
    found = re.findall(pattern, text)
    return int(found[-1]) if found else 0


def run(build, target, seconds):
    environment = dict(os.environ)
    environment.setdefault("ASAN_OPTIONS", "allocator_may_return_null=1:detect_leaks=1")
    environment.setdefault("UBSAN_OPTIONS", "print_stacktrace=1")
    before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    result = subprocess.run(command(build, target, seconds), capture_output=True,
                            errors="replace", env=environment, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    entry = {"target": target, "seconds": round(time.monotonic() - started),
             "core_seconds": round(after.ru_utime + after.ru_stime - before.ru_utime -
                                   before.ru_stime),
             "executions": number(result.stderr, r"stat::number_of_executed_units:\s*(\d+)")
             or number(result.stderr, r"#(\d+)"),
             "edges": number(result.stderr, r"cov: (\d+)"),
             "fault": None}
    if result.returncode != 0:
        summary = re.findall(r"SUMMARY: (.*)", result.stderr)
        entry["fault"] = summary[-1] if summary else f"exit status {result.returncode}"
        print(result.stderr[-6000:], file=sys.stderr)
    return entry


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--targets", nargs="+")
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    build = arguments.build.resolve()
    targets = arguments.targets or targets_of(build)
    if not targets:
        sys.exit(f"no fuzz targets in {build}/bin: cmake --preset fuzz, then build `fuzzers`")
    faults = 0
    for target in targets:
        entry = run(build, target, int(arguments.minutes * 60))
        faults += entry["fault"] is not None
        print(json.dumps(entry), flush=True)
        if arguments.json:
            with open(arguments.json, "a", encoding="utf-8") as file:
                file.write(json.dumps(entry) + "\n")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
