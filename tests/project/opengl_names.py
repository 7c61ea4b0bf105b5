#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every function of OpenGL 1.5 is declared with OpenGL's signature, every token has its value.

The truth is the system's <GL/gl.h> and <GL/glext.h>, which a C compiler compares with openrt/rt.h.
So are the names of extensions for what became core, which openrt/gl.h then is to define.
"""
import argparse
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent.parent / "compat"))

from generate_calls import CALL_COLUMNS, EXTENSION_COLUMNS, read_table  # noqa: E402

# Tokens that openrt/enums.h defines itself, with OpenGL's value.
ALSO_OPENGL = ["NO_ERROR", "BYTE", "UNSIGNED_BYTE", "SHORT", "UNSIGNED_SHORT", "INT",
               "UNSIGNED_INT", "FLOAT", "2_BYTES", "3_BYTES", "4_BYTES", "DOUBLE",
               "FRAMEBUFFER_SRGB", "SRGB", "SRGB8", "SRGB_ALPHA", "SRGB8_ALPHA8"]

# Names of extensions that Mesa's headers leave out.
NOT_IN_HEADERS = ["GL_CLAMP_TO_EDGE_EXT"]


def comparison(calls, tokens, extensions=()):
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
    for row in extensions:
        name, core = row["name"], row["core"]
        if not name.startswith("GL_"):
            lines.append(f"__typeof__(&{name}) check_{name} = &{core};")
        elif name not in NOT_IN_HEADERS:
            lines += [f"#if !defined({name}) || !defined({core}) || {name} != {core}",
                      f"#error {name} is unknown to OpenGL or differs from {core}", "#endif"]
    return "\n".join(lines) + "\n"


def names_of_extensions(extensions):
    """A C translation unit that compiles if openrt/gl.h has the names of the extensions."""
    lines = ["#include <openrt/gl.h>"]
    for row in extensions:
        name, core = row["name"], row["core"]
        if name.startswith("GL_"):
            lines += [f"#if !defined({name}) || {name} != {core}",
                      f"#error {name} is missing or differs from {core}", "#endif"]
        else:
            lines.append(f"__typeof__(&{core}) check_{name} = &{name};")
    return "\n".join(lines) + "\n"


def compile_text(text, compiler, include_dirs):
    """What the compiler says where it refuses the text."""
    command = [compiler, "-std=gnu99", "-Wall", "-Werror", "-fsyntax-only", "-x", "c", "-"]
    command += [f"-I{d}" for d in include_dirs]
    result = subprocess.run(command, input=text, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT)
    return [result.stdout] if result.returncode else []


def problems(calls, tokens, compiler, include_dirs, extensions=()):
    found = compile_text(comparison(calls, tokens, extensions), compiler, include_dirs)
    # Functions of one type differ by their names only.
    found += [f"{row['name']} is another function than {row['core']}" for row in extensions
              if row["name"].startswith("gl") and not row["name"].startswith("gl" + row["core"][2:])]
    if extensions:
        found += compile_text(names_of_extensions(extensions), compiler, include_dirs)
    return found


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
    extensions = read_table(arguments.root / "compat/gl_extensions.csv", EXTENSION_COLUMNS)
    found = problems(calls, tokens, arguments.compiler, arguments.include, extensions)
    print("\n".join(found) or f"{len(calls)} functions, {len(tokens)} tokens and "
                              f"{len(extensions)} names of extensions are OpenGL's")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
