#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What libOpenRT.so offers and needs.

It exports the functions that the public C headers declare, each in a version node of the release,
and nothing else; it needs the C and C++ run-time and nothing else.
"""
import argparse
import pathlib
import re
import subprocess
import sys

# Headers whose functions are in another library or that only rename.
OTHER_HEADERS = {"rtut.h", "gl.h"}
DECLARATION = re.compile(
    r'__attribute__\s*\(\(\s*visibility\s*\(\s*"default"\s*\)\s*\)\)\s*([^;{}()]*?)\b(\w+)\s*\(')
RUNTIME = re.compile(r"(libstdc\+\+|libc\+\+|libc\+\+abi|libm|libgcc_s|libc|libpthread|libdl|"
                     r"ld-linux[-\w]*)\.so(\.\d+)*$")


def declared_functions(preprocessed):
    return {name for _, name in DECLARATION.findall(preprocessed)}


def preprocess(compiler, include_dirs):
    headers = sorted(p.name for d in include_dirs for p in pathlib.Path(d, "openrt").glob("*.h")
                     if p.name not in OTHER_HEADERS)
    source = "".join(f"#include <openrt/{name}>\n" for name in headers)
    command = [compiler, "-std=c99", "-E", "-P", "-x", "c", "-"]
    command += [f"-I{d}" for d in include_dirs]
    return subprocess.run(command, input=source, text=True, check=True,
                          stdout=subprocess.PIPE).stdout


def exported_symbols(nm_output):
    """name -> version node, or None where the symbol carries none."""
    symbols = {}
    for line in nm_output.splitlines():
        kind, name = line.split()[-2:]
        if kind != "A":
            base, _, version = name.partition("@")
            symbols[base] = version.lstrip("@") or None
    return symbols


def needed_libraries(readelf_output):
    return re.findall(r"\(NEEDED\).*\[(.*)\]", readelf_output)


def problems(declared, exported, needed):
    found = [f"declared, but not exported: {n}" for n in sorted(declared - exported.keys())]
    found += [f"exported, but not declared: {n}" for n in sorted(exported.keys() - declared)]
    found += [f"exported outside a version node OPENRT_x.y: {n}"
              for n, version in sorted(exported.items())
              if n in declared and not re.fullmatch(r"OPENRT_\d+\.\d+", version or "")]
    found += [f"needs {name}, which is no part of the run-time" for name in needed
              if not RUNTIME.match(name)]
    if not declared:
        found.append("no declaration found in the headers")
    return found


def output_of(*command):
    return subprocess.run(command, text=True, check=True, stdout=subprocess.PIPE).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--library", required=True)
    parser.add_argument("--compiler", default="cc")
    parser.add_argument("--include", action="append", required=True)
    arguments = parser.parse_args()
    declared = declared_functions(preprocess(arguments.compiler, arguments.include))
    exported = exported_symbols(output_of("nm", "-D", "--defined-only", arguments.library))
    needed = needed_libraries(output_of("readelf", "-dW", arguments.library))
    found = problems(declared, exported, needed)
    print("\n".join(found) or f"{len(declared)} functions declared and exported; needs "
          + " ".join(needed))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
