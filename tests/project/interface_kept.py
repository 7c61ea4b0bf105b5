#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The C interface against that of each release (compat/interface/VERSION.txt): what programs were
compiled with keeps its meaning.

    interface_kept.py ROOT                  prints what a program compiled before would meet
    interface_kept.py ROOT --write VERSION  keeps the interface as that of a release

A function keeps its signature, a token its value, a structure its members. New functions and tokens
may come; structures of the shader interface may grow at their ends (rts.h says how). Until a release
is out its text may be written anew, which a change on purpose asks for.
"""
import argparse
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "calls"))

import api_functions  # noqa: E402

CHANGING = {"token RTS_INTERFACE_REVISION"}  # it counts how often structures grew
STRUCT = re.compile(r"(?:typedef\s+)?struct\s+(\w+)\s*\{((?:[^{}]|\{[^{}]*\})*)\}", re.DOTALL)


def structures(text):
    for name, body in STRUCT.findall(text):
        members = [" ".join(member.split()) for member in body.split(";") if member.strip()]
        yield f"struct {name}", "; ".join(members)


def interface_of(root):
    """{what: how it is} of the public C headers."""
    found = {}
    for path in sorted((root / "include/openrt").glob("*.h")):
        text = api_functions.without_comments(path.read_text(encoding="utf-8"))
        for result, name, parameters in api_functions.DECLARATION.findall(text):
            given = [] if parameters.strip() == "void" else [
                api_functions.parameter(p).type for p in api_functions.split_parameters(parameters)]
            found[f"function {name}"] = f"{' '.join(result.split())} ({', '.join(given)})"
        for name, value in re.findall(r"^#\s*define\s+(RT\w+)\s+([\w]+)\s*$", text, re.MULTILINE):
            found[f"token {name}"] = value
        found.update(structures(re.sub(r"^#.*$", "", text, flags=re.MULTILINE)))
    return found


def may_grow(what, how):
    """Structures that say their size, and one that only the library makes."""
    return "structSize" in how or what == "struct RTSstate"


def problems(before, now):
    found = []
    for what, how in before.items():
        if what not in now:
            found.append(f"{what}: gone")
        elif now[what] != how and what not in CHANGING and not (
                may_grow(what, how) and now[what].startswith(how + ";")):
            found.append(f"{what}: was {how}, is {now[what]}")
    return found


def read(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    return dict(line.split(" = ", 1) for line in lines if " = " in line)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--write", metavar="VERSION")
    arguments = parser.parse_args()
    folder = arguments.root / "compat/interface"
    now = interface_of(arguments.root)
    if arguments.write:
        folder.mkdir(exist_ok=True)
        text = "".join(f"{what} = {how}\n" for what, how in sorted(now.items()))
        (folder / f"{arguments.write}.txt").write_text(text, encoding="utf-8")
        return 0
    releases = sorted(folder.glob("*.txt"))
    found = [f"{path.stem}: {problem}" for path in releases for problem in problems(read(path), now)]
    print("\n".join(found) or f"the interface is that of {len(releases)} releases, and more")
    return 1 if found or not releases else 0


if __name__ == "__main__":
    sys.exit(main())
