#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The binary interface against that of each release (compat/interface/LIBRARY-VERSION.abi.gz): what
abidiff says of a library of empty functions that is made of the public C headers, the version
script and the soname. That the real libraries export just these and have that soname is what
exported_symbols.py shows.

    binary_interface.py ROOT --include DIR... --compiler CC            what a program would meet
    binary_interface.py ROOT --include DIR... --compiler CC --write VERSION

Functions and tokens may come; all else is a break. Until a release is out its file may be written
anew, which a change on purpose asks for.
"""
import argparse
import gzip
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "calls"))

import api_functions  # noqa: E402
from exported_symbols import SOVERSION  # noqa: E402

# Library: its headers, or all others; version script.
LIBRARIES = {"libOpenRT": (None, "compat/libOpenRT.map"),
             "librtut": ({"rtut.h"}, "compat/librtut.map")}
OTHERS = {"rtut.h", "gl.h"}
# What abidiff exits with where the difference is an addition only.
CHANGED, INCOMPATIBLE, FAULT = 4, 8, 3


def headers_of(folder, wanted):
    return sorted(path for path in (folder / "openrt").glob("*.h")
                  if (path.name in wanted if wanted else path.name not in OTHERS))


def empty_functions(headers):
    """A C file that defines what the headers declare."""
    lines = [f"#include <openrt/{path.name}>" for path in headers]
    for path in headers:
        text = api_functions.without_comments(path.read_text(encoding="utf-8"))
        lines += [f"RTAPI {result} RTAPIENTRY {name}({parameters}) {{ __builtin_trap(); }}"
                  for result, name, parameters in api_functions.DECLARATION.findall(text)]
    return "\n".join(lines) + "\n"


def interface(library, source, script, include, compiler, folder):
    """The file in which abidw tells of a library made of the source, without places in files."""
    made = folder / f"{library}.so"
    (folder / f"{library}.c").write_text(source, encoding="utf-8")
    subprocess.run([compiler, "-std=c99", "-g", "-O0", "-shared", "-fPIC", "-fvisibility=hidden",
                    *(f"-I{path}" for path in include), f"{library}.c", "-o", made,
                    f"-Wl,-soname,{library}.so.{SOVERSION}", f"-Wl,--version-script={script}"],
                   cwd=folder, check=True)
    told = folder / f"{library}.abi"
    subprocess.run(["abidw", "--no-show-locs", "--no-corpus-path", "--no-comp-dir-path",
                    "--out-file", told, made], check=True)
    return told


def differences(before, now):
    """What abidiff reports of two files; "" where programs need not care."""
    result = subprocess.run(["abidiff", "--no-added-syms", before, now], capture_output=True,
                            text=True, check=False)
    if result.returncode & FAULT:
        raise RuntimeError(f"abidiff: {result.stderr}")
    return result.stdout if result.returncode & (CHANGED | INCOMPATIBLE) else ""


def release_order(path):
    return [int(part) for part in re.findall(r"\d+", path.name.split("-")[1])]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("--include", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--compiler", required=True)
    parser.add_argument("--write", metavar="VERSION")
    arguments = parser.parse_args()
    kept = arguments.root.resolve() / "compat/interface"
    include = [path.resolve() for path in arguments.include]
    found = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for library, (wanted, script) in LIBRARIES.items():
            source = empty_functions(headers_of(include[0], wanted))
            now = interface(library, source, arguments.root.resolve() / script, include,
                            arguments.compiler, folder)
            if arguments.write:
                (kept / f"{library}-{arguments.write}.abi.gz").write_bytes(
                    gzip.compress(now.read_bytes(), 9, mtime=0))
                continue
            releases = sorted(kept.glob(f"{library}-*.abi.gz"), key=release_order)
            if not releases:
                print(f"{library}: no release to compare with")
                found += 1
            for release in releases:
                before = folder / "before.abi"
                before.write_bytes(gzip.decompress(release.read_bytes()))
                text = differences(before, now)
                found += bool(text)
                print(f"{release.name}: {text or 'nothing that a program would notice'}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
