#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes openrt/_declarations.py from the C headers, which are the one source of the interface.

usage: declarations.py INCLUDE VERSION OUTPUT

INCLUDE is the folder that holds openrt/rt.h and openrt/rtu.h. The output has four values: VERSION,
of the headers; CDEF, what cffi takes as declarations; WRITTEN, by function the numbers of the
parameters that point to what is not const, which cffi forgets; and TOKENS, a dictionary of the RT_
constants.
"""
import pathlib
import re
import sys


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.S)


def included(header, folder, seen):
    """The header and what it includes of the interface, in the order of a compiler."""
    if header in seen:
        return ""
    seen.add(header)
    path = folder / header
    if not path.exists():
        return ""  # made when the library is configured: the version
    parts = []
    for line in without_comments(path.read_text(encoding="utf-8")).splitlines():
        match = re.match(r'\s*#\s*include\s+"(openrt/[^"]+)"', line)
        parts.append(included(match.group(1), folder, seen) if match else line)
    return "\n".join(parts)


def tokens_of(text):
    """Constants; one may be defined as another."""
    tokens = {}
    for name, value in re.findall(r"^\s*#\s*define\s+(RT_\w+)\s+(\w+)\s*$", text, flags=re.M):
        tokens[name] = tokens[value] if value in tokens else int(value, 0)
    return tokens


def declarations_of(text):
    text = re.sub(r"\\\n", " ", text)
    text = re.sub(r"#\s*ifdef\s+__cplusplus.*?#\s*endif", " ", text, flags=re.S)
    text = re.sub(r"^\s*#[^\n]*", "", text, flags=re.M)
    text = re.sub(r"\bRTAPI(ENTRY)?\b", "", text)
    statements = [re.sub(r"\s+", " ", statement).strip() for statement in split(text)]
    return "\n".join(statement + ";" for statement in statements if statement)


def split(text):
    """Statements at the outermost level, without their semicolons."""
    depth, start = 0, 0
    for i, character in enumerate(text):
        depth += {"{": 1, "}": -1}.get(character, 0)
        if character == ";" and depth == 0:
            yield text[start:i]
            start = i + 1


def written_of(cdef):
    written = {}
    for name, parameters in re.findall(r"\b(rt\w+)\((.*)\);$", cdef, flags=re.M):
        pieces = re.split(r",\s*(?![^()]*\))", parameters)  # not within a function's type
        numbers = tuple(i for i, parameter in enumerate(pieces)
                        if re.match(r"(?!const\b)[^(]*[*[]", parameter))
        if numbers:
            written[name] = numbers
    return written


def generate(include, version):
    seen = set()
    text = "\n".join(included(header, pathlib.Path(include), seen)
                     for header in ("openrt/rt.h", "openrt/rtu.h"))
    text = re.sub(r"\bargv\s*\[\s*\]", "*argv", text)
    cdef = declarations_of(text)
    tokens = "".join(f"    {name!r}: {value:#x},\n" for name, value in tokens_of(text).items())
    written = "".join(f"    {name!r}: {numbers},\n" for name, numbers in written_of(cdef).items())
    return ("# SPDX-License-Identifier: MIT\n"
            "# Made by declarations.py from the C headers.\n"
            f'VERSION = {version!r}\n\nCDEF = """\n{cdef}\n"""\n\nWRITTEN = {{\n{written}}}\n\nTOKENS = {{\n{tokens}}}\n')


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    include, version, output = sys.argv[1:]
    pathlib.Path(output).write_text(generate(include, version), encoding="utf-8")


if __name__ == "__main__":
    main()
