#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every public header compiles alone and twice: the C ones as C99 and C++11, .hpp as C++20."""
import argparse
import pathlib
import subprocess
import sys

WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror"]


def compilations(name, c_compiler, cxx_compiler):
    if name.endswith(".hpp"):
        return [[cxx_compiler, "-std=c++20", "-x", "c++"]]
    return [[c_compiler, "-std=c99", "-x", "c"],
            [cxx_compiler, "-std=c++11", "-x", "c++"]]


def problems(include_dirs, c_compiler, cxx_compiler):
    found, count = [], 0
    headers = sorted(p for d in include_dirs for s in ("*.h", "*.hpp")
                     for p in pathlib.Path(d, "openrt").glob(s))
    for header in headers:
        # The declaration keeps a header of macros alone from being an empty C translation unit.
        source = f"#include <openrt/{header.name}>\n" * 2 + "typedef int notEmpty;\n"
        for command in compilations(header.name, c_compiler, cxx_compiler):
            full = command + WARNINGS + ["-fsyntax-only", "-"] + [f"-I{d}" for d in include_dirs]
            result = subprocess.run(full, input=source, text=True, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT)
            count += 1
            if result.returncode != 0:
                found.append(f"{header.name} with {' '.join(command)}:\n{result.stdout}")
    if count == 0:
        found.append("no header found")
    return found, count


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--c-compiler", default="cc")
    parser.add_argument("--cxx-compiler", default="c++")
    parser.add_argument("--include", action="append", required=True)
    arguments = parser.parse_args()
    found, count = problems(arguments.include, arguments.c_compiler, arguments.cxx_compiler)
    print("\n".join(found) or f"{count} compilations without a warning")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
