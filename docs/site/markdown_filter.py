#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Gives the headings of a guide the anchors that its links expect, the same as on the web page of a
repository, and prints it. Doxygen, which calls it as a filter, wants names that are unique in the
whole site: the guide's name goes before each. Links to other files of the project lead to copies of
them in the site's folder `files`, which copy_files.py makes.

usage: markdown_filter.py GUIDE
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def slug(heading):
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
    return re.sub(r"[^\w\- ]", "", text).strip().replace(" ", "-")


def file_link(guide, found):
    """What a link becomes that leads to a file of the project which is no guide and no picture."""
    target = (guide.parent / found[2]).resolve()
    if not target.is_file() or not target.is_relative_to(ROOT):
        return f"]({found[2]})"
    return f"](files/{target.relative_to(ROOT)})"


def convert(text, stem, guide):
    out, code, used = [], False, {}
    for line in text.split("\n"):
        if line.startswith("```"):
            code = not code
        heading = re.match(r"(#{1,6}) (.*)", line)
        if not code and heading:
            name = slug(heading[2])
            used[name] = used.get(name, -1) + 1
            name += f"-{used[name]}" if used[name] else ""
            page = len(heading[1]) == 1
            line += f" {{#{stem}}}" if page else f" {{#{stem}-{name}}}"
        elif not code:
            line = re.sub(r"\]\(#([\w-]+)\)", rf"](#{stem}-\1)", line)
            line = re.sub(r"\]\((?:[\w./-]*/)?([\w-]+)\.md#([\w-]+)\)",
                          lambda m: f"](#{page_name(m[1])}-{m[2]})", line)
            line = re.sub(r"\]\((?:[\w./-]*/)?([\w-]+)\.md\)",
                          lambda m: f"](#{page_name(m[1])})", line)
            line = re.sub(r"(?<!!)(\[[^]]*)\]\(([\w./-]+)\)",
                          lambda m: m[1] + file_link(guide, m), line)
        out.append(line)
    return "\n".join(out)


def page_name(stem):
    return "guide-" + stem.lower()


if __name__ == "__main__":
    path = pathlib.Path(sys.argv[1])
    stem = path.parent.name if path.stem == "README" and path.parent.name == "python" else path.stem
    text = path.read_text(encoding="utf-8")
    sys.stdout.write(convert(text, page_name(stem), path))
