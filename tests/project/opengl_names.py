#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every function of OpenGL 1.5 is declared with OpenGL's signature, every token has its value.

The truth is the system's <GL/gl.h> and <GL/glext.h>, which a C compiler compares with openrt/rt.h.
"""
import argparse
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent.parent / "compat"))

from generate_calls import CALL_COLUMNS, read_table  # noqa: E402

# Tokens that openrt/enums.h defines itself, with OpenGL's value.
ALSO_OPENGL = ["NO_ERROR", "BYTE", "UNSIGNED_BYTE", "SHORT", "UNSIGNED_SHORT", "INT",
               "UNSIGNED_INT", "FLOAT", "2_BYTES", "3_BYTES", "4_BYTES", "DOUBLE",
               "FRAMEBUFFER_SRGB", "SRGB", "SRGB8", "SRGB_ALPHA", "SRGB8_ALPHA8"]


def comparison(calls, tokens):
    """A C translation unit that compiles if all names are OpenGL's."""
    lines = ["#define GL_GLEXT_PROTOTYPES", "#include <GL/gl.h>", "#include <GL/glext.h>",
             "#include <openrt/rt.h>", "#include <openrt/rt_gl.h>"]
    for row in calls:
        rt, gl = row["name"], "gl" + row["name"][2:]
        lines.append(f"__typeof__(&{gl}) check_{rt} = &{rt};")
    for row in tokens:
        name = row["token"][3:]
        lines += [f"#if !defined(RT_{name}) || !defined(GL_{name}) || RT_{name} != GL_{name}",
                  f"#error RT_{name} is missing or differs from OpenGL", "#endif"]
    return "\n".join(lines) + "\n"


def problems(calls, tokens, compiler, include_dirs):
    command = [compiler, "-std=gnu99", "-Wall", "-Werror", "-fsyntax-only", "-x", "c", "-"]
    command += [f"-I{d}" for d in include_dirs]
    result = subprocess.run(command, input=comparison(calls, tokens), text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return [result.stdout] if result.returncode else []


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=pathlib.Path, required=True)
    parser.add_argument("--compiler", default="cc")
    parser.add_argument("--include", action="append", required=True)
    arguments = parser.parse_args()
    calls = read_table(arguments.root / "compat/gl_calls.csv", CALL_COLUMNS)
    tokens = read_table(arguments.root / "compat/gl_tokens.csv",
                        ["token", "value", "version", "chapter"])
    tokens += [{"token": f"RT_{name}"} for name in ALSO_OPENGL]
    found = problems(calls, tokens, arguments.compiler, arguments.include)
    print("\n".join(found) or f"{len(calls)} functions and {len(tokens)} tokens are OpenGL's")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
