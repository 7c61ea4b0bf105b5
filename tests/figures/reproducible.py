#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds the libraries and programs twice, from copies of the sources in two folders with names of
different length, without a compiler cache, installs them, and compares the two trees byte by byte.

    reproducible.py [--json FILE]
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def installed(folder):
    """The folder of an installation that was built in this one."""
    folder.mkdir(parents=True)
    for source in ROOT.iterdir():
        if source.is_dir() and not re.match(r"build|\.git$|\.cache$", source.name):
            shutil.copytree(source, folder / source.name, symlinks=True)
        elif source.is_file():
            shutil.copy(source, folder)
    environment = {**os.environ, "CCACHE_DISABLE": "1"}
    for command in (["cmake", "-S", ".", "-B", "build", "-G", "Ninja",
                     "-DCMAKE_BUILD_TYPE=Release", "-DOPENRT_BUILD_TESTS=OFF"],
                    ["cmake", "--build", "build"],
                    ["cmake", "--install", "build", "--prefix", "installed"]):
        subprocess.run(command, cwd=folder, check=True, env=environment)
    return folder / "installed"


def contents(tree):
    """{path in the tree: what is there}"""
    return {str(path.relative_to(tree)):
            os.readlink(path).encode() if path.is_symlink() else path.read_bytes()
            for path in tree.rglob("*") if path.is_symlink() or path.is_file()}


def differences(first, second):
    """The files that differ or that one tree lacks."""
    one, other = contents(first), contents(second)
    return sorted(name for name in one.keys() | other.keys() if one.get(name) != other.get(name))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        trees = [installed(folder / where) for where in ("a", "another/and/a/longer/one")]
        different = differences(*trees)
        files = len(contents(trees[0]))
    print(f"of {files} installed files differ: {', '.join(different) or 'none'}")
    if arguments.json:
        result = {"equal": not different, "files": files, "different": different}
        arguments.json.write_text(json.dumps(result) + "\n", encoding="utf-8")
    return 1 if different or not files else 0


if __name__ == "__main__":
    sys.exit(main())
