#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the Debian packages and asks lintian about them.

    packages.py BUILD [--json FILE]

Configures BUILD as the preset `package` does, builds it, and runs cpack. Exit status 1 if lintian
finds an error, a package or something in it is missing, or two are described by the same words.
"""
import argparse
import collections
import fnmatch
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = ["cave", "info", "render", "trace", "view", "xr"]
CALLS = ["rtInit", "rtVertex3f", "rtuLookAt", "rtutInit"]
# What at least is in each package.
EXPECTED = {
    "libopenrt0": ["usr/lib/*/libOpenRT.so.0"],
    "librtut0": ["usr/lib/*/librtut.so.0"],
    "libopenrt-mpi0": ["usr/lib/*/libOpenRT-mpi.so.0"],
    "libopenrt-dev": ["usr/include/openrt/rt.h", "usr/lib/*/libOpenRT.so", "usr/lib/*/libsmart.a",
                      "usr/lib/*/pkgconfig/openrt.pc", "usr/lib/*/cmake/OpenRT/OpenRTConfig.cmake"],
    "openrt-tools": [f"usr/{place.format(program)}" for program in PROGRAMS
                     for place in ("bin/openrt-{}", "share/man/man1/openrt-{}.1.gz")],
    "openrt-doc": ["usr/share/doc/openrt/README.md", "usr/share/doc/openrt/docs/porting.md",
                   "usr/share/doc/openrt/html/index.html",
                   *(f"usr/share/man/man3/{name}.3.gz" for name in CALLS)]}


def preset():
    """-D of the preset `package`, without those that only name compilers."""
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
    found = {}
    named = {entry["name"]: entry for entry in presets["configurePresets"]}
    for name in ("base", "release", "package"):
        found.update(named[name].get("cacheVariables", {}))
    return [f"-D{name}={value}" for name, value in found.items()]


def make(build):
    launchers = [f"-D{name}={os.environ[name]}" for name in
                 ("CMAKE_C_COMPILER_LAUNCHER", "CMAKE_CXX_COMPILER_LAUNCHER") if name in os.environ]
    subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *preset(), *launchers],
                   check=True)
    for old in build.glob("*.deb"):
        old.unlink()
    subprocess.run(["cmake", "--build", build], check=True)
    subprocess.run(["cpack"], cwd=build, check=True)
    return sorted(build.glob("*.deb"))


def findings(package):
    """{severity: [tag]} of lintian, E: and W: lines."""
    result = subprocess.run(["lintian", "--allow-root", "--no-cfg", package], capture_output=True,
                            text=True, check=False)
    found = collections.defaultdict(list)
    for severity, tag in re.findall(r"^([EW]): \S+: (\S+)", result.stdout, re.MULTILINE):
        found[severity].append(tag)
    print(result.stdout + result.stderr, end="")
    return found


def synopsis(package):
    return subprocess.run(["dpkg-deb", "-f", package, "Description"], capture_output=True, text=True,
                          check=True).stdout.splitlines()[0]


def missing_files(package, listing):
    """What is expected of a package and is not in the list of its files."""
    return [pattern for pattern in EXPECTED.get(package, []) if not fnmatch.filter(listing, pattern)]


def files(package):
    tar = subprocess.run(["dpkg-deb", "--fsys-tarfile", package], capture_output=True, check=True)
    with tarfile.open(fileobj=io.BytesIO(tar.stdout)) as held:
        return [name.removeprefix("./") for name in held.getnames()]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    arguments = parser.parse_args()
    if not shutil.which("lintian"):
        print("lintian is not installed: the packages are not judged")
        return 1
    packages, synopses, missing = [], set(), []
    for path in make(arguments.build.resolve()):
        found = findings(path)
        synopses.add(synopsis(path))
        package = path.name.split("_")[0]
        missing += [f"{package}: {file}" for file in missing_files(package, files(path))]
        packages.append({"package": package, "bytes": path.stat().st_size,
                         "errors": sorted(set(found["E"])), "warnings": sorted(set(found["W"]))})
        print(json.dumps(packages[-1]))
    if arguments.json:
        arguments.json.write_text(json.dumps(packages, indent=1) + "\n", encoding="utf-8")
    missing += sorted(EXPECTED.keys() - {entry["package"] for entry in packages})
    if missing:
        print("missing:", *missing, sep="\n  ")
    if len(synopses) < len(packages):
        print("packages have the same synopsis")
    return 1 if missing or len(synopses) < len(packages) or any(entry["errors"] for entry in packages) else 0


if __name__ == "__main__":
    sys.exit(main())
