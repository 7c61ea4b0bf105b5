#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the shared libraries offer and need.

libOpenRT and librtut export the functions that the public C headers declare, each in a version node
of the release; libOpenRT-mpi the symbols that its header names, without a version, as it is of one
build with libOpenRT. None exports anything else. Each needs the C and C++ run-time, and no library
that is not listed here. All have the soname whose meaning docs/compatibility.md tells.
"""
import argparse
import dataclasses
import pathlib
import re
import subprocess
import sys

SOVERSION = 0
MPI_HEADER = pathlib.Path(__file__).resolve().parents[2] / "compat/mpi/mpi_component.h"
RTUT_HEADERS = {"rtut.h"}
RENAMING_HEADERS = {"gl.h"}
DECLARATION = re.compile(
    r'__attribute__\s*\(\(\s*visibility\s*\(\s*"default"\s*\)\s*\)\)\s*([^;{}()]*?)\b(\w+)\s*\(')
RUNTIME = r"libstdc\+\+|libc\+\+|libc\+\+abi|libm|libgcc_s|libc|libpthread|libdl|ld-linux[-\w]*"


@dataclasses.dataclass(frozen=True)
class Library:
    node: str | None  # of its symbols; None where they have no version
    needs: str        # beside the run-time


LIBRARIES = {"libOpenRT": Library("OPENRT", ""),
             "librtut": Library("RTUT", "libOpenRT|libglfw|libOpenGL|libGL|libpng16"),
             "libOpenRT-mpi": Library(None, "libmpi|libmpich|liblz4")}


def declared_functions(preprocessed):
    return {name for _, name in DECLARATION.findall(preprocessed)}


def preprocess(compiler, include_dirs, library):
    """The public C headers of libOpenRT or of librtut."""
    headers = sorted(p.name for d in include_dirs for p in pathlib.Path(d, "openrt").glob("*.h")
                     if p.name not in RENAMING_HEADERS
                     and (p.name in RTUT_HEADERS) == (library == "librtut"))
    source = "".join(f"#include <openrt/{name}>\n" for name in headers)
    command = [compiler, "-std=c99", "-E", "-P", "-x", "c", "-"]
    command += [f"-I{d}" for d in include_dirs]
    return subprocess.run(command, input=source, text=True, check=True,
                          stdout=subprocess.PIPE).stdout


def declared_symbols(compiler, include_dirs, library):
    if library == "libOpenRT-mpi":
        return set(re.findall(r"\bopenrtMpi\w+", MPI_HEADER.read_text(encoding="utf-8")))
    return declared_functions(preprocess(compiler, include_dirs, library))


def exported_symbols(nm_output):
    """name -> version node, or None where the symbol carries none."""
    symbols = {}
    for line in nm_output.splitlines():
        kind, name = line.split()[-2:]
        if kind != "A":
            base, _, version = name.partition("@")
            symbols[base] = version.lstrip("@") or None
    return symbols


def dynamic_entries(readelf_output, tag):
    return re.findall(rf"\({tag}\).*\[(.*)\]", readelf_output)


def problems(library, declared, exported, needed, sonames):
    node = LIBRARIES[library].node
    found = [f"declared, but not exported: {n}" for n in sorted(declared - exported.keys())]
    found += [f"exported, but not declared: {n}" for n in sorted(exported.keys() - declared)]
    found += [f"exported in {version}, not in {node and node + '_x.y'}: {n}"
              for n, version in sorted(exported.items()) if n in declared and not
              (re.fullmatch(node + r"_\d+\.\d+", version or "") if node else version is None)]
    found += [f"needs {name}, which is no part of the run-time and not listed" for name in needed
              if not re.match(rf"({RUNTIME}|{LIBRARIES[library].needs})\.so(\.\d+)*$", name)]
    if sonames != [f"{library}.so.{SOVERSION}"]:
        found.append(f"has the soname {sonames}")
    if not declared:
        found.append("no declaration found in the headers")
    return [f"{library}: {problem}" for problem in found]


def output_of(*command):
    return subprocess.run(command, text=True, check=True, stdout=subprocess.PIPE).stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--library", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--compiler", default="cc")
    parser.add_argument("--include", action="append", required=True)
    arguments = parser.parse_args()
    found = []
    for path in arguments.library:
        library = path.name.split(".")[0]
        declared = declared_symbols(arguments.compiler, arguments.include, library)
        exported = exported_symbols(output_of("nm", "-D", "--defined-only", path))
        dynamic = output_of("readelf", "-dW", path)
        needed = dynamic_entries(dynamic, "NEEDED")
        found += problems(library, declared, exported, needed, dynamic_entries(dynamic, "SONAME"))
        print(f"{library}: {len(declared)} symbols declared; needs {' '.join(needed)}")
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
