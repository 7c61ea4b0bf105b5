#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Brings libOpenRT.map and librtut.map up to date: every function of the public C headers in a
version node.

A function that no node lists yet goes into the node of the release under way, the version in the
top CMakeLists.txt; nodes of earlier releases stay as they are. With --check nothing is written:
exit status 1 if a function is missing.
"""
import argparse
import pathlib
import re
import sys

DECLARATION = re.compile(r"\bRTAPI\b[^;{}()]*?\bRTAPIENTRY\s+(\w+)\s*\(")
RTUT_HEADERS = {"rtut.h"}
NODE = re.compile(r"^([A-Z]+_[\d.]+) \{\n    global:\n(.*?)(    local: \*;\n)?\}( [A-Z]+_[\d.]+)?;\n",
                  re.DOTALL | re.MULTILINE)


def declared(headers):
    names = set()
    for header in headers:
        text = re.sub(r"/\*.*?\*/", "", header.read_text(encoding="utf-8"), flags=re.DOTALL)
        names.update(DECLARATION.findall(text))
    return names


def release(root):
    text = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(OpenRT VERSION (\d+\.\d+)", text).group(1)


def updated(text, library, names, newest):
    """The map with the unlisted names in node `newest`, and names gone since removed from it."""
    nodes = {node: set(re.findall(r"(\w+);", body)) for node, body, _, _ in NODE.findall(text)}
    released = set().union(*(listed for node, listed in nodes.items() if node != newest))
    lines = ["/* SPDX-License-Identifier: MIT */",
             f"/* What {library}.so exports, each function in the node of the release that added it.",
             " * Kept by compat/generate_map.py; the node of a released version never changes. */"]
    parent = ""
    for node in [n for n in nodes if n != newest] + [newest]:
        members = names - released if node == newest else nodes[node]
        lines += [f"{node} {{", "    global:"]
        lines += [f"        {name};" for name in sorted(members)]
        lines += ["    local: *;"] * (not parent) + [f"}}{parent};"]
        parent = f" {node}"
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    arguments = parser.parse_args()
    root = pathlib.Path(__file__).resolve().parent.parent
    headers = sorted((root / "include/openrt").glob("*.h"))
    stale = 0
    for library, node, own in (
            ("libOpenRT", "OPENRT", [h for h in headers if h.name not in RTUT_HEADERS]),
            ("librtut", "RTUT", [h for h in headers if h.name in RTUT_HEADERS])):
        path = root / f"compat/{library}.map"
        old = path.read_text(encoding="utf-8") if path.exists() else ""
        new = updated(old, library, declared(own), f"{node}_{release(root)}")
        if not arguments.check:
            path.write_text(new, encoding="utf-8")
        elif old != new:
            print(f"compat/{library}.map is not up to date; run compat/generate_map.py")
            stale += 1
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
