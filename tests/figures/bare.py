#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How long it takes from a bare Debian 12 to the first picture: ./demo in a fresh chroot, as root.

    bare.py FOLDER [--json FILE] [--library FILE]

FOLDER/root gets a minimal Debian 12 by debootstrap, unless it is there, and the files that git
knows. --library: a libOpenRT.so that was built elsewhere with the preset `release`, to compare the
one that ./demo built with, byte by byte.
"""
import argparse
import filecmp
import json
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
MOUNTS = "mount --bind /proc {0}/proc && mount --bind /dev {0}/dev"
STEPS = {"packages": 'source .ci/packages.sh && install_packages "${packages[@]}"',
         "demo": "./demo"}


def make_root(root):
    if not (root / "etc/debian_version").exists():
        subprocess.run(["debootstrap", "--variant=minbase", "bookworm", root], check=True)
    shutil.copy("/etc/resolv.conf", root / "etc/resolv.conf")
    project = root / "openrt"
    shutil.rmtree(project, ignore_errors=True)
    for name in subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True,
                               check=True).stdout.split("\0")[:-1]:
        (project / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, project / name)


def run(root, command):
    """(seconds of a clock, seconds of all cores) of a command in the project's folder there."""
    before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    inside = f"{MOUNTS.format(root)} && exec chroot {root} bash -c 'cd /openrt && {command}'"
    environment = {key: value for key, value in os.environ.items()
                   if key.lower().endswith("_proxy")}
    environment.update(PATH="/usr/sbin:/usr/bin:/sbin:/bin", HOME="/root", LANG="C.UTF-8")
    subprocess.run(["unshare", "--mount", "bash", "-c", inside], check=True, env=environment)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (time.monotonic() - started,
            after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--library", type=pathlib.Path)
    arguments = parser.parse_args()
    root = arguments.folder.resolve() / "root"
    make_root(root)
    figures = {"cores": os.cpu_count()}
    for name, command in STEPS.items():
        wall, processor = run(root, command)
        figures[name] = {"minutes": round(wall / 60, 1), "core_minutes": round(processor / 60, 1)}
    pictures = sorted(path.name for path in (root / "openrt/build/demo").glob("*.png"))
    figures["pictures"] = pictures
    if arguments.library:
        built = (root / "openrt/build/release/lib/libOpenRT.so.0").resolve()
        figures["equal"] = filecmp.cmp(built, arguments.library.resolve(), shallow=False)
    print(json.dumps(figures))
    if arguments.json:
        arguments.json.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
    return 0 if pictures and figures.get("equal", True) else 1


if __name__ == "__main__":
    sys.exit(main())
