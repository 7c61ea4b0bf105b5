#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Turns the comments of the public headers, which are written for readers of the headers, into what
Doxygen understands; prints the header given. Doxygen calls it as its INPUT_FILTER.

usage: header_filter.py HEADER
"""
import pathlib
import re
import sys

from manual_fields import missing_fields

COMMENT = re.compile(r"/\*(?!\*)(.*?)\*/", re.DOTALL)
FIELDS = re.compile(r"(?<=[\w.;)]) +(?=Threads: |Since: )")
ERROR = re.compile(r"(\s+)(RT_[A-Z_]+)\s+(\S.*)")


def error_list(lines):
    """`Errors:  RT_X  text`, with lines that go on, as a list."""
    items = []
    for line in lines:
        found = ERROR.match(line)
        if found:
            items.append(f"- {found[2]}: {found[3]}")
        elif items:
            items[-1] += " " + line.strip()
        else:
            items.append(line.strip())
    return ["@par Errors", *items]


def documentation(text):
    """The lines of a comment, with the fields at its end as Doxygen's commands."""
    lines = [part for line in text.strip().split("\n")
             for part in FIELDS.split(re.sub(r"^ ?\* ?", "", line))]
    result, errors = [], None
    for line in lines:
        field = re.match(r"(Errors|Threads|Source|Sources|Since):\s*(.*)", line)
        if errors is not None and (field or not line.startswith("  ")):
            result += error_list(errors)
            errors = None
        if field and field[1] == "Errors":
            errors = [" " + field[2]]
        elif errors is not None:
            errors.append(line)
        elif field:
            result += ([f"@since {field[2]}"] if field[1] == "Since" else
                       [f"@par {field[1]}", field[2]])
        else:
            result.append(line)
    if errors is not None:
        result += error_list(errors)
    return result


def comment(lines):
    return "/** " + "\n * ".join(lines) + " */"


def convert(source, header):
    first, *rest = source.split("*/", 1)
    body = rest[0] if rest else first
    about = COMMENT.search(body)
    out, position = [], 0
    for found in COMMENT.finditer(body):
        before = body[position:found.start()]
        out.append(before)
        position = found.end()
        line_start = before.rsplit("\n", 1)[-1]
        if found is about or found.start() == about.start():
            out.append(comment(["@file", *documentation(found[1])]))
        elif line_start.strip():
            after = body[found.end():found.end() + 1]
            out.append("/**< " + " ".join(documentation(found[1])) + " */"
                       if after == "\n" and not line_start.lstrip().startswith("#if")
                       and not line_start.lstrip().startswith("#e") else found[0])
        else:
            calls = re.match(r"\n((?:RTAPI [^;]*;\n)+)", body[found.end():])
            functions = re.findall(r"RTAPIENTRY (rt\w+)\(", calls[1]) if calls else []
            several = len(functions) > 1
            lines = documentation(found[1])
            text = comment(lines + (missing_fields(header, lines, functions) if functions else []))
            if several:
                end = found.end() + calls.end()
                out += ["/** @{ */\n", text, body[found.end():end], "/** @} */\n"]
                position = end
            else:
                out.append(text)
    out.append(body[position:])
    return "".join(out)


if __name__ == "__main__":
    path = pathlib.Path(sys.argv[1])
    text = path.read_text(encoding="utf-8")
    sys.stdout.write(convert(text, path.name) if path.suffix in (".h", ".in") else text)
