# SPDX-License-Identifier: MIT
"""Takes the version and the declarations of the package from the C library's sources.

OPENRT_INCLUDE names another folder that holds openrt/rt.h, such as an installed one.
"""
import os
import pathlib
import re
import sys

from setuptools import setup
from setuptools.command.build_py import build_py

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import declarations  # noqa: E402

SOURCE = HERE.parent.parent
INCLUDE = pathlib.Path(os.environ.get("OPENRT_INCLUDE", SOURCE / "include"))


def version():
    made = INCLUDE / "openrt" / "version.h"
    if made.exists():
        return re.search(r'OPENRT_VERSION_STRING\s+"([^"]+)"', made.read_text()).group(1)
    return re.search(r"project\(OpenRT VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)


class BuildWithDeclarations(build_py):
    def run(self):
        super().run()
        target = pathlib.Path(self.build_lib) / "openrt" / "_declarations.py"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(declarations.generate(INCLUDE, version()), encoding="utf-8")


setup(version=version(), cmdclass={"build_py": BuildWithDeclarations})
