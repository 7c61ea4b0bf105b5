#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds libOpenRT twice, from copies of the sources in two folders with names of different length,
without a compiler cache, and compares the two files byte by byte.

    reproducible.py [--json FILE]
"""
import argparse
import filecmp
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
NEEDED = ["CMakeLists.txt", "include", "libsmart", "compat", "docs"]


def build(folder):
    folder.mkdir(parents=True)
    for name in NEEDED:
        source = ROOT / name
        copy = shutil.copytree if source.is_dir() else shutil.copy
        copy(source, folder / name)
    environment = {**os.environ, "CCACHE_DISABLE": "1"}
    for command in (["cmake", "-S", ".", "-B", "build", "-G", "Ninja",
                     "-DCMAKE_BUILD_TYPE=Release", "-DOPENRT_BUILD_TESTS=OFF",
                     "-DOPENRT_BUILD_SAMPLES=OFF"],
                    ["cmake", "--build", "build", "--target", "OpenRT"]):
        subprocess.run(command, cwd=folder, check=True, env=environment)
    return (folder / "build/lib/libOpenRT.so").resolve()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        libraries = [build(folder / where) for where in ("a", "another/and/a/longer/one")]
        equal = filecmp.cmp(*libraries, shallow=False)
    print("the two libraries are " + ("equal" if equal else "different"))
    if arguments.json:
        arguments.json.write_text(json.dumps({"equal": equal}) + "\n", encoding="utf-8")
    return 0 if equal else 1


if __name__ == "__main__":
    sys.exit(main())
