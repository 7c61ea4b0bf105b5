#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The first commands of compat/python/README.md as they stand, with ordinary tools: a wheel is made
and installed into an environment of its own, and the example runs with it.

usage: wheel.py SOURCE_DIR LIBRARY
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE, LIBRARY = pathlib.Path(sys.argv[1]), sys.argv[2]


def documented():
    """The packages that the page installs, and its other commands."""
    page = (SOURCE / "compat/python/README.md").read_text(encoding="utf-8")
    install, *others = re.search(r"```sh\n(.*?)```", page, re.DOTALL)[1].splitlines()
    return re.fullmatch(r"apt-get install (.*)", install)[1].split(), others


def project_packages():
    return subprocess.run(["bash", "-c", 'source .ci/packages.sh; echo "${packages[@]}"'],
                          cwd=SOURCE, capture_output=True, text=True, check=True).stdout.split()


def copied(folder):
    """What a wheel is made of; a copy, for setuptools writes beside what it builds."""
    shutil.copytree(SOURCE / "compat/python", folder / "compat/python",
                    ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
    shutil.copy(SOURCE / "CMakeLists.txt", folder)
    shutil.copytree(SOURCE / "include", folder / "include")


def main():
    packages, commands = documented()
    assert set(packages) <= set(project_packages()), "continuous integration installs others"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        copied(folder)
        (folder / "tools").mkdir()
        python = folder / "tools/python3"
        python.write_text(f'#!/bin/sh\nexec {sys.executable} "$@"\n')
        python.chmod(0o755)
        picture = folder / "picture.ppm"
        script = "\n".join(["set -ex", *commands,
                            f"python3 compat/python/examples/first_picture.py {picture}"])
        environment = {**os.environ, "HOME": str(folder), "OPENRT_LIBRARY": LIBRARY,
                       "PATH": f"{folder / 'tools'}:{os.environ['PATH']}",
                       "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_INDEX": "1"}
        subprocess.run(["bash", "-c", script], cwd=folder, env=environment, check=True)
        for file in ("_declarations.py", "py.typed"):
            assert list(folder.glob(f"openrt-python/lib/python*/site-packages/openrt/{file}")), file
        assert picture.read_bytes().startswith(b"P6"), picture


if __name__ == "__main__":
    main()
