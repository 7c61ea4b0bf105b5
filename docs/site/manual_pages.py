#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes section 3 of the manual from the public headers: a page for each comment on functions, under
the first one's name and with links from the others', and one for each header with what it says
of all its functions. Compressed as Debian wants them.

usage: manual_pages.py INCLUDE FOLDER VERSION
"""
import gzip
import pathlib
import re
import sys
import typing

from header_comments import blocks, comments, error_items, functions, split_fields
from manual_fields import fields_of

WIDTH = 76  # of a declaration
SECTIONS = {"Errors": "ERRORS", "Threads": "THREADS", "Since": "SINCE", "Source": "SOURCE"}


class Page(typing.NamedTuple):
    names: list    # the functions, or the header
    header: str
    lines: list    # of the text
    fields: dict
    calls: str


def roff(text):
    """Text that groff prints as it is, names in backticks bold."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("~", "\\(ti").replace("^", "\\(ha")
    text = re.sub(r"(?<!\w)`([^`]+)`", r"\\fB\1\\fP", text)
    return "\\&" + text if text[:1] in (".", "'") else text


def summary(lines):
    """The first sentence, or what of it comes before a colon or semicolon."""
    text = " ".join(line.strip() for line in blocks(lines)[0].content)
    first = re.split(r"(?<![. ])[.:;](?: |$)", text)[0]
    return first if first[1:2].isupper() or not first[0].isupper() else first[0].lower() + first[1:]


def body(parts):
    out = []
    for kind, content in parts:
        if kind == "list":
            for term, text in content:
                out += [".TP", f"\\fB{roff(term)}\\fP", roff(text)]
            out.append(".PP")
        elif kind == "table":
            out += [".PP", ".in +4n", ".nf", *map(roff, content), ".fi", ".in", ".PP"]
        elif kind == "item":
            out += [".PP", *body(content)]
        else:
            out += [".PP", *(roff(line.strip()) for line in content)]
    return out


def tidy(lines):
    """Without paragraphs that groff would call empty."""
    out = []
    for line in lines:
        if line == ".PP" and (not out or out[-1] == ".PP" or out[-1].startswith(".SH")):
            continue
        if line.startswith(".SH") and out and out[-1] == ".PP":
            out.pop()
        out.append(line)
    return out if out[-1] != ".PP" else out[:-1]


def declaration(text):
    """A declaration as a program sees it, in lines that fit."""
    text = re.sub(r"\s+", " ", re.sub(r"RTAPI\s|RTAPIENTRY\s", "", text.replace(
        "(RTAPIENTRY *", "(*"))).strip()
    lines, margin = [""], " " * (text.index("(") + 1)
    for word in re.findall(r"[^,]+,? ?", text):
        if lines[-1].strip() and len(lines[-1]) + len(word.rstrip()) > WIDTH:
            lines.append(margin)
        lines[-1] += word
    return [line.rstrip() for line in lines]


def included(header):
    return "rt.h" if header.startswith("rt_") else header


def synopsis(page):
    out = [".SH SYNOPSIS", ".nf", f".B #include <openrt/{included(page.header)}>", ".PP"]
    for call in re.findall(r"RTAPI [^;]*;", page.calls):
        out += [f"\\fB{roff(line)}\\fP" for line in declaration(call)]
    return out + [".fi"]


def field(title, lines):
    if title != "Errors":
        return [f".SH {SECTIONS[title]}", roff(" ".join(line.strip() for line in lines))]
    out = [".SH ERRORS"]
    for code, text in error_items(lines):
        out += ([".TP", f".B {code}"] if code else [".PP"]) + [roff(text)]
    return out


def see_also(page, known):
    """The pages whose functions the text names, and the header's."""
    text = " ".join([*page.lines, *sum(page.fields.values(), [])])
    named = set(re.findall(r"\brt(?:u|ut)?[A-Z]\w*", text)) - set(page.names)
    found = {known[name] for name in named if name in known} - {page.names[0]}
    headers = {page.header, included(page.header)} - set(page.names)
    return sorted(found, key=str.lower) + sorted(headers)


def functions_of(header, found):
    """What a header's page says of the others."""
    out = [".SH FUNCTIONS"]
    for page in found:
        if page.header == header and page.calls:
            out += [".TP", f".BR {page.names[0]} (3)", roff(summary(page.lines))]
    return out if len(out) > 1 else []


def page_text(page, found, version):
    known = {name: other.names[0] for other in found for name in other.names}
    out = [f".TH {page.names[0]} 3 \"\" \"OpenRT {version}\" OpenRT", ".nh", ".ad l", ".SH NAME",
           f"{', '.join(page.names)} \\- {roff(summary(page.lines))}"]
    out += synopsis(page) + [".SH DESCRIPTION"] + body(blocks(page.lines))
    for name, lines in page.fields.items():
        out += field(name, lines)
    if not page.calls:
        out += functions_of(page.header, found)
    others = see_also(page, known)
    if others:
        out += [".SH SEE ALSO", *(f".BR {name} (3)," for name in others[:-1]),
                f".BR {others[-1]} (3)"]
    return "\n".join(tidy(out)) + "\n"


def pages_of(source, header):
    """The header's own, then those of its functions."""
    for part in comments(source):
        lines, fields = split_fields(part.lines)
        names = functions(part.calls)
        if part.kind == "header":
            yield Page([header], header, lines, fields, "")
        elif names:
            yield Page(names, header, *fields_of(header, lines, fields, part.calls), part.calls)


def pages(include):
    """Of the headers that have functions, and of rt.h, which has the rules for all."""
    for path in sorted(include.glob("*.h")):
        found = list(pages_of(path.read_text(encoding="utf-8"), path.name))
        if len(found) > 1 or path.name == "rt.h":
            yield from found


def write(path, text):
    path.write_bytes(gzip.compress(text.encode(), 9, mtime=0))


def main():
    include, folder, version = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3]
    found = list(pages(include))
    folder.mkdir(parents=True)
    for page in found:
        write(folder / f"{page.names[0]}.3.gz", page_text(page, found, version))
        for name in page.names[1:]:
            write(folder / f"{name}.3.gz", f".so man3/{page.names[0]}.3\n")
    print(f"{len(found)} pages of section 3")


if __name__ == "__main__":
    main()
