#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Turns the comments of the public headers, which are written for readers of the headers, into what
Doxygen understands; prints the header given. Doxygen calls it as its INPUT_FILTER. Those in C++ are
in Doxygen's form but for the lines at their beginning, which are about the file.

usage: header_filter.py HEADER
"""
import pathlib
import re
import sys

from header_comments import blocks, comments, error_items, functions, split_fields
from manual_fields import fields_of


def literal(text):
    """Options as they are, not with the dashes of a printed book."""
    return text.replace("--", "\\--")


def item(term, text):
    return f"- `{term}`: {literal(text)}" if term else f"- {literal(text)}"


def paragraphs(parts):
    """As lines, with an empty one between the Blocks."""
    lines = []
    for kind, content in parts:
        lines += [""] if lines else []
        if kind == "list":
            lines += [item(*row) for row in content]
        elif kind == "table":
            lines += ["@verbatim", *content, "@endverbatim"]
        else:
            lines += map(literal, content) if kind == "text" else paragraphs(content)
    return lines


def field(title, lines):
    if title == "Errors":
        items = error_items(lines)
        return ["@par Errors", *(item(*row) if items[0][0] else literal(row[1]) for row in items)]
    text = " ".join(line.strip() for line in lines)
    return [f"@since {text}"] if title == "Since" else [f"@par {title}", text]


def documentation(lines, fields):
    result = paragraphs(blocks(lines))
    for title, text in fields.items():
        result += field(title, text)
    return result


def comment(lines):
    """Without a star before each line, which Doxygen would show in tables."""
    return "/** " + "\n".join(lines) + " */"


def member(source, found):
    """Behind a value, a macro or a member; what lies within a line is none of Doxygen's."""
    line = source[source.rfind("\n", 0, found.start) + 1:found.start].lstrip()
    if source[found.end:found.end + 1] != "\n" or re.match("#if|#e", line):
        return source[found.start:found.end]
    return "/**< " + " ".join(line.strip() for line in found.lines) + " */"


def convert(source, header):
    out, position = [], 0
    for found in comments(source):
        out.append(source[position:found.start])
        position = found.end
        names = functions(found.calls)
        lines, fields = split_fields(found.lines)
        if found.kind == "divider":
            continue
        if found.kind == "member":
            out.append(member(source, found))
        elif found.kind == "header":
            out.append(comment(["@file", *documentation(lines, fields)]))
        else:
            if names:
                lines, fields = fields_of(header, lines, fields, found.calls)
            out.append(comment(documentation(lines, fields)))
        if len(names) > 1:
            position += 1 + len(found.calls)
            out[-1:] = ["/** @{ */\n", out[-1], "\n", found.calls, "/** @} */\n"]
    out.append(source[position:])
    return "".join(out)


def convert_cpp(source):
    about = re.search(r"(?<=SPDX-License-Identifier: MIT\n)(//(?!/).*\n)+", source)
    lines = [re.sub("^// ?", "", line) for line in about[0].splitlines()]
    return source[:about.start()] + comment(["@file", *paragraphs(blocks(lines))]) + "\n" + source[about.end():]


if __name__ == "__main__":
    path = pathlib.Path(sys.argv[1])
    text = path.read_text(encoding="utf-8")
    sys.stdout.write(convert_cpp(text) if path.suffix == ".hpp" else convert(text, path.name))
