#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The commands of compat/python/README.md, with ordinary tools: a wheel is made, installed into a
folder of its own, and the example runs with it.

usage: wheel.py SOURCE_DIR LIBRARY
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SOURCE, LIBRARY = pathlib.Path(sys.argv[1]), sys.argv[2]


def run(*command, folder, **environment):
    print("+", *command, flush=True)
    subprocess.run([str(word) for word in command], check=True, cwd=folder,
                   env={**os.environ, "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_INDEX": "1",
                        **environment})


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        # A copy: setuptools writes beside what it builds.
        module = folder / "compat/python"
        shutil.copytree(SOURCE / "compat/python", module,
                        ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
        shutil.copy(SOURCE / "CMakeLists.txt", folder)
        shutil.copytree(SOURCE / "include", folder / "include")
        pip = [sys.executable, "-m", "pip"]
        run(*pip, "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", folder, module,
            folder=folder)
        wheels = list(folder.glob("openrt-*.whl"))
        assert len(wheels) == 1, wheels
        installed = folder / "installed"
        run(*pip, "install", "--no-deps", "--target", installed, wheels[0], folder=folder)
        assert (installed / "openrt/_declarations.py").exists()
        picture = folder / "picture.ppm"
        run(sys.executable, module / "examples/first_picture.py", picture, folder=folder,
            PYTHONPATH=str(installed), OPENRT_LIBRARY=LIBRARY)
        assert picture.read_bytes().startswith(b"P6"), picture


if __name__ == "__main__":
    main()
