# SPDX-License-Identifier: MIT
"""The project's own source files, as the checks of this folder see them."""
import os
import pathlib

SUFFIXES = {".c", ".h", ".cpp", ".hpp", ".py", ".cmake", ".sh"}


def source_files(root):
    """Paths below root, relative to it, build trees and hidden folders left out."""
    root = pathlib.Path(root)
    for folder, subfolders, names in os.walk(root):
        subfolders[:] = sorted(n for n in subfolders
                               if not n.startswith(".") and not n.startswith("build")
                               and n != "__pycache__")
        for name in sorted(names):
            path = pathlib.Path(folder, name)
            if path.suffix in SUFFIXES or name == "CMakeLists.txt":
                yield path.relative_to(root)
