#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Keeps of the manual pages that Doxygen made those of functions that the libraries export, and of
the headers these are links to, compressed as Debian wants them. The synopsis has the header that programs include.

usage: tidy_manual.py FOLDER MAP...
"""
import fnmatch
import gzip
import pathlib
import re
import sys


def with_synopsis(text, header):
    """The page of a header, which Doxygen gives what that header includes itself."""
    whole = "rt.h" if header.startswith("rt_") else header
    return re.sub(r"(?:\\fC#include '[^']*'\\fP\n\.br\n)+",
                  lambda _: f"\\fC#include <openrt/{whole}>\\fP\n.br\n", text, count=1)


def main():
    folder = pathlib.Path(sys.argv[1])
    names = {name for path in sys.argv[2:]
             for name in re.findall(r"\b(rt[\w*]+);", pathlib.Path(path).read_text(encoding="utf-8"))}
    pages = {path: path.read_text(encoding="utf-8") for path in folder.glob("*.3")}
    keep = {path for path in pages for name in names
            if "_" not in path.stem and fnmatch.fnmatchcase(path.stem, name)}
    wanted = {target for path in keep
              for target in re.findall(r"^\.so man3/(\S+)", pages[path], flags=re.MULTILINE)}
    keep |= {folder / name for name in wanted}
    for path, text in pages.items():
        if path in keep:
            text = re.sub(r"^(\.so man3/\S+)", r"\1.gz", text, flags=re.MULTILINE)
            text = with_synopsis(text, path.stem)
            packed = gzip.compress(text.encode(), 9, mtime=0)
            path.with_suffix(".3.gz").write_bytes(packed)
        path.unlink()
    if not keep:
        sys.exit("no manual page was kept")
    missing = sorted(n for n in names if "*" not in n and folder / f"{n}.3" not in keep)
    print(f"{len(keep)} pages of section 3" + (f"; none for {', '.join(missing)}" if missing else ""))


if __name__ == "__main__":
    main()
