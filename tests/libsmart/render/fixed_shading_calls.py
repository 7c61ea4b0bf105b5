#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What is compiled for a fixed shader calls nothing through a pointer.

Reads the disassembly of the library. Functions that were made for a fixed shader carry it in
their names; none of them may hold an indirect call or jump, while those of the general tracer,
read in the same way, must show some.
"""
import re
import shutil
import subprocess
import sys

FUNCTION = re.compile(r"^[0-9a-f]+ <(.*)>:$")
# x86: call or jmp through a register or memory; AArch64: blr, br.
INDIRECT = re.compile(r"^\s+[0-9a-f]+:\s+(?:(?:notrack |bnd )*(?:call|jmp)q?\s+\*|blr\b|br\b)")
FIXED = "FixedShading<smart::builtin::{}>"
GENERAL = "ShadingServices<smart::DynamicShading>"
# What has to be there, or the names are read wrongly.
LOOP = ("shadeGroup", "shadePacket", "shadeHit", "packetTrace", "packetShadow", "trace", "shadow")


def functions_of(disassembly):
    """name -> lines with an indirect call"""
    found, lines = {}, None
    for line in disassembly.splitlines():
        start = FUNCTION.match(line)
        if start:
            lines = found.setdefault(start.group(1), [])
        elif lines is not None and INDIRECT.match(line):
            lines.append(line.strip())
    return found


def problems(functions, surfaces):
    found = []
    for surface in surfaces:
        mine = {name: lines for name, lines in functions.items() if FIXED.format(surface) in name}
        if not any(f"::{part}(" in name for name in mine for part in LOOP):
            found.append(f"{surface}: no shading loop was found")
        for name, lines in mine.items():
            found += [f"{surface}: {name} has {line}" for line in lines]
    if not any(lines for name, lines in functions.items() if GENERAL in name):
        found.append("control: no indirect call was found in the general tracer")
    return found


def main():
    archive, *surfaces = sys.argv[1:]
    if not shutil.which("objdump"):
        print("skipped: objdump is not installed")
        return 77
    disassembly = subprocess.run(["objdump", "-d", "-C", "--no-show-raw-insn", archive], text=True,
                                 check=True, stdout=subprocess.PIPE).stdout
    functions = functions_of(disassembly)
    found = problems(functions, surfaces)
    print("\n".join(found) or f"no indirect call in the tracers of {', '.join(surfaces)}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
