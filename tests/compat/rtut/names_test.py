#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every function and token of GLU 1.3 and of GLUT 3.7 has its counterpart, with the same number of
parameters and the same value. The truth is the system's <GL/glu.h> and <GL/glut.h>."""
import argparse
import pathlib
import re
import sys

# Of freeglut, which GLUT 3.7 has not, or which are its own.
NOT_GLUT_3_7 = {"glutStrokeWidthf", "glutStrokeLengthf", "GLUT_XLIB_IMPLEMENTATION",
                "GLUT_WINDOW_FORMAT_ID"}
MACROS = {"gluPerspective", "gluLookAt"}


def without_comments(path):
    return re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8", errors="replace"),
                  flags=re.DOTALL)


def functions(text, prefix):
    """name -> number of parameters; functions as parameters count as one."""
    result = {}
    for name, rest in re.findall(rf"\b({prefix}[A-Z]\w*)\s*\(((?:[^();]|\([^()]*\))*)\)\s*;", text):
        flat = re.sub(r"\([^()]*\)", "", rest).strip()
        result[name] = 0 if flat in ("", "void") else flat.count(",") + 1
    return result


def tokens(text, prefix):
    found = re.findall(rf"^#\s*define\s+({prefix}_\w+)\s+(0x[0-9A-Fa-f]+|\d+)\s*$", text, re.M)
    return {name: int(value, 0) for name, value in found}


def problems(theirs, ours, old, new, skipped):
    found = []
    their_functions, our_functions = functions(theirs, old), functions(ours, new)
    for name, parameters in sorted(their_functions.items()):
        if name in skipped:
            continue
        own = new + name[len(old):]
        if own not in our_functions:
            found.append(f"{own} is missing")
        elif our_functions[own] != parameters:
            found.append(f"{own} has {our_functions[own]} parameters, not {parameters}")
    our_tokens = tokens(ours, new.upper())
    their_tokens = tokens(theirs, old.upper())
    for name, value in sorted(their_tokens.items()):
        if name in skipped or re.match(r"GLU_(EXT_|\w+_EXT$)", name):
            continue
        own = new.upper() + name[len(old):]
        if our_tokens.get(own) != value:
            found.append(f"{own} is {our_tokens.get(own)}, not {value}")
    if len(their_functions) < 50 or len(their_tokens) < 100:
        found.append(f"only {len(their_functions)} functions, {len(their_tokens)} tokens of {old}")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--include", type=pathlib.Path, required=True)
    parser.add_argument("--glu", type=pathlib.Path, required=True)
    parser.add_argument("--glut", type=pathlib.Path)
    arguments = parser.parse_args()

    def ours(name):
        return "".join(without_comments(arguments.include / "openrt" / f"{name}{suffix}.h")
                       for suffix in ("", "_enums"))

    found = problems(without_comments(arguments.glu), ours("rtu"), "glu", "rtu", MACROS)
    if arguments.glut:
        found += problems(without_comments(arguments.glut), ours("rtut"), "glut", "rtut",
                          NOT_GLUT_3_7)
    control = problems(without_comments(arguments.glu),
                       ours("rtu").replace("RTdouble radius, ", "", 1)
                       .replace("RTU_FILL 100012", "RTU_FILL 100013"), "glu", "rtu", MACROS)
    if len(control) != 2:
        found.append("the control, one parameter less and a wrong value, was not seen")
    print("\n".join(found) or "all names are those of GLU and GLUT")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
