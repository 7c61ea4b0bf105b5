#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The form of every source file: its length, its licence line, one guard against inclusion."""
import pathlib
import re
import sys

from sources import source_files

MAX_LINES = 600
CXX_FOLDERS = ("libsmart", "compat")  # elsewhere a .h may be for C
LICENCE = "SPDX-License-Identifier: MIT"


def problems_of(path, text):
    lines = text.splitlines()
    found = []
    if len(lines) > MAX_LINES:
        found.append(f"{path}: {len(lines)} lines, more than {MAX_LINES}")
    if not any(LICENCE in line for line in lines[:2]):
        found.append(f"{path}: no licence line ({LICENCE}) at the top")
    own_cxx = path.suffix == ".hpp" or path.suffix == ".h" and path.parts[0] in CXX_FOLDERS
    if own_cxx and "#pragma once" not in lines:
        found.append(f"{path}: no #pragma once")
    if path.suffix == ".h" and not re.search(r"^#(pragma once|ifndef \w+_H\n#define)", text, re.M):
        found.append(f"{path}: no guard against a second inclusion")
    return found


def check(root):
    found = []
    for path in source_files(root):
        text = pathlib.Path(root, path).read_text(encoding="utf-8")
        found += problems_of(path, text)
    return found


if __name__ == "__main__":
    result = check(sys.argv[1])
    print("\n".join(result) or "the form of all sources is in order")
    sys.exit(1 if result else 0)
