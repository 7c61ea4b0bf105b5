#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The pages of section 3 name every error that their functions record: those that every_call, which
calls all functions with right and wrong arguments in every state, has in its log.

usage: recorded_errors.py BUILD
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))

from header_comments import error_items  # noqa: E402
from manual_pages import Page, pages  # noqa: E402

LINE = re.compile(r"openrt: (\w+): ([A-Z_]+): (.*)")
# What openrt/rt.h and rtSetFrameCallback say of all functions.
OF_ALL = re.compile(r"not legal between begin and end|was called by a frame callback")
IN_OBJECTS = "not legal while an object is defined"


def documented(page, known):
    """The codes of a page, with those of the functions that it refers to."""
    codes = set()
    for code, text in error_items(page.fields["Errors"]):
        codes.add(code)
        if text.startswith("those of "):
            for name in re.findall(r"\brt\w+", text):
                codes |= documented(known[name], known)
    return codes


def not_documented(lines, known):
    found = set()
    for line in lines:
        function, code, text = LINE.match(line).groups()
        if OF_ALL.search(text):
            continue
        page = known[function]
        codes = documented(page, known)
        told = (re.search(r"\bin (an object|objects)\b", " ".join(page.lines))
                if text == IN_OBJECTS else None)
        if f"RT_{code}" not in codes and not told:
            found.add(f"{function}: RT_{code}: {text}")
    return sorted(found)


def control():
    """What is not on a page is found, and so is what is on it only by reference."""
    def page(name, *errors):
        return Page([name], "rt.h", ["Does it."], {"Errors": list(errors)}, "")
    known = {"rtA": page("rtA", "RT_INVALID_VALUE  negative"), "rtB": page("rtB", "those of rtA")}
    lines = [f"openrt: {name}: {code}: {text}" for name in known for code, text in (
        ("INVALID_VALUE", "negative"), ("INVALID_ENUM", "unknown"),
        ("INVALID_OPERATION", "not legal between begin and end"), ("INVALID_OPERATION", IN_OBJECTS))]
    assert not_documented(lines, known) == [
        f"{name}: {error}" for name in known
        for error in ("RT_INVALID_ENUM: unknown", f"RT_INVALID_OPERATION: {IN_OBJECTS}")]


def main():
    control()
    known = {name: page for page in pages(ROOT / "include/openrt") for name in page.names}
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder, "errors")
        subprocess.run([pathlib.Path(sys.argv[1], "bin/every_call")], check=True,
                       stdout=subprocess.DEVNULL, env={**os.environ, "OPENRT_LOG": str(log)})
        lines = set(log.read_text(encoding="utf-8", errors="replace").splitlines())
    found = not_documented(lines, known)
    functions = {LINE.match(line)[1] for line in lines}
    print("\n".join(found + [f"{len(lines)} errors of {len(functions)} functions, {len(found)} of "
                             "them on no page"]))
    sys.exit(1 if found or len(functions) < 500 else 0)


if __name__ == "__main__":
    main()
