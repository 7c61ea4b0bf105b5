#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Copies the files of the project that the site's pages link to into the site.

usage: copy_files.py PROJECT HTML
"""
import pathlib
import re
import shutil
import sys


def main():
    project, site = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    names = {name for page in site.glob("*.html")
             for name in re.findall(r'href="files/([^"#]+)"', page.read_text(encoding="utf-8"))}
    for name in sorted(names):
        copy = site / "files" / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(project / name, copy)


if __name__ == "__main__":
    main()
