#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The kernels' object files: each uses its instruction set, and no other machine meets it.

A function that the linker may merge (a weak symbol) or take from an object compiled for a newer
machine would run everywhere; so kernel objects define nothing outside their namespace
smart::<isa>, run nothing at start, and the rest of libsmart.a has no AVX instruction. A fused
multiply-add would break the antisymmetry of the edge functions; none may appear.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

FUSED = re.compile(r"^vf(n?m)(add|sub)")
# Instructions that SSE3 to SSE4.2 brought and compilers use for packed floats and integers.
SSE4 = re.compile(r"^(blendv?p[sd]|pblendvb|pblendw|pminsd|pmaxsd|pminud|pmaxud|pmulld|ptest|"
                  r"roundp[sd]|rounds[sd]|insertps|extractps|pextr[dqb]|pinsr[dqb]|packusdw|"
                  r"pmov[sz]x\w+|pcmpeqq|pcmpgtq|dpps|movntdqa|crc32\w*)$")
# What a symbol of namespace smart::NAME looks like: run-time type data, guards and what is local
# to its functions (Z) included.
OWN_SYMBOL = r"^_Z(TV|TI|TS|TT|GV|GR)?Z*N[KVrRO]*5smart{length}{name}"
HARMLESS = {"DW.ref.__gxx_personality_v0"}


class Code:
    """What the disassembly of one object shows."""

    def __init__(self, disassembly):
        self.vex = self.ymm = self.zmm = self.sse4 = 0
        self.fused = []
        for line in disassembly.splitlines():
            fields = line.split("\t")
            if len(fields) < 2 or not fields[0].strip().endswith(":"):
                continue
            instruction = fields[1].split("#")[0]
            mnemonic = instruction.split()[0] if instruction.split() else ""
            self.vex += mnemonic.startswith("v") and not mnemonic.startswith(("verr", "verw"))
            self.sse4 += bool(SSE4.match(mnemonic))
            self.ymm += "%ymm" in instruction
            self.zmm += "%zmm" in instruction
            if FUSED.match(mnemonic):
                self.fused.append(mnemonic)


def code_problems(isa, code):
    """isa is generic, sse4, avx2, avx512, or '' for code that every machine runs."""
    label = isa or "common code"
    found = []
    if code.fused:
        found.append(f"{label}: fused multiply-add ({code.fused[0]}, {len(code.fused)} in all)")
    if isa in ("", "generic", "sse4") and (code.vex or code.ymm or code.zmm):
        found.append(f"{label}: {code.vex} AVX instructions")
    if isa in ("", "generic") and code.sse4:
        found.append(f"{label}: {code.sse4} SSE4 instructions")
    if isa == "sse4" and not code.sse4:
        found.append("sse4: no SSE4 instruction")
    if isa == "avx2" and not code.ymm:
        found.append("avx2: no 256-bit register")
    if isa == "avx2" and code.zmm:
        found.append("avx2: 512-bit registers")
    if isa == "avx512" and not code.zmm:
        found.append("avx512: no 512-bit register")
    return found


def symbol_problems(isa, nm_output):
    """nm without demangling: whatever another object can see lies in smart::<isa>."""
    own = re.compile(OWN_SYMBOL.format(length=len(isa), name=isa))
    found = []
    for line in nm_output.splitlines():
        fields = line.split()
        if len(fields) < 2 or not re.fullmatch(r"[A-Za-z]", fields[-2]):
            continue
        kind, name = fields[-2:]
        visible = kind.isupper() and kind not in "UN" or kind in "uvw"
        if kind in "vw" and len(fields) == 2:
            continue  # an undefined weak reference defines nothing
        if visible and name not in HARMLESS and not own.match(name):
            found.append(f"{isa}: symbol {name} ({kind}) is outside smart::{isa}")
    return found


def start_problems(isa, section_headers):
    return [f"{isa}: runs code at start ({name})"
            for name in (".init_array", ".ctors", ".preinit_array")
            if re.search(rf"\s{re.escape(name)}\b", section_headers)]


def archive_members(data):
    """[(name, bytes)] of a static library in the common (GNU) format."""
    if not data.startswith(b"!<arch>\n"):
        raise SystemExit("not a static library")
    members, names, at = [], b"", 8
    while at + 60 <= len(data):
        name = data[at:at + 16].decode().rstrip()
        size = int(data[at + 48:at + 58])
        body = data[at + 60:at + 60 + size]
        at += 60 + size + size % 2
        if name == "//":
            names = body
        elif name.startswith("/") and name[1:].isdigit():
            start = int(name[1:])
            members.append((names[start:names.index(b"\n", start)].decode().rstrip("/"), body))
        elif name not in ("/", "/SYM64/"):
            members.append((name.rstrip("/"), body))
    return members


def output_of(*command):
    return subprocess.run(command, text=True, check=True, stdout=subprocess.PIPE).stdout


def code_of(path):
    return Code(output_of("objdump", "-d", "--no-show-raw-insn", str(path)))


def check(objects, archive):
    """objects: isa -> [object files]; archive: the static library that holds them all."""
    found, kernel_bytes = [], {}
    for isa, paths in objects.items():
        if not paths:
            found.append(f"{isa}: no object file")
        codes = [code_of(path) for path in paths]
        total = Code("")
        for code in codes:
            for count in ("vex", "ymm", "zmm", "sse4", "fused"):
                setattr(total, count, getattr(total, count) + getattr(code, count))
        found += code_problems(isa, total)
        for path in paths:
            found += symbol_problems(isa, output_of("nm", str(path)))
            found += start_problems(isa, output_of("objdump", "-h", str(path)))
            kernel_bytes[pathlib.Path(path).read_bytes()] = isa
    members = archive_members(pathlib.Path(archive).read_bytes())
    inside = {kernel_bytes[body] for _, body in members if body in kernel_bytes}
    found += [f"{isa}: its objects are not in {archive}" for isa in objects if isa not in inside]
    with tempfile.TemporaryDirectory() as folder:
        for name, body in members:
            if body not in kernel_bytes:
                path = pathlib.Path(folder, "member.o")
                path.write_bytes(body)
                found += [f"{name}: {p}" for p in code_problems("", code_of(path))]
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--archive", required=True)
    parser.add_argument("--isa", nargs="+", action="append", required=True,
                        metavar=("NAME", "OBJECT"))
    arguments = parser.parse_args()
    objects = {name: paths for name, *paths in arguments.isa}
    found = check(objects, arguments.archive)
    print("\n".join(found) or "each instruction set keeps to its objects: " + " ".join(objects))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
