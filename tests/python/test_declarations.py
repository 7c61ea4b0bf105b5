# SPDX-License-Identifier: MIT
"""The module has all that the C headers declare, and what it has is what the compiler sees."""
import inspect
import os
import pathlib
import re
import subprocess

import openrt
from openrt.binding import (_UTILITIES_WITHOUT_CONTEXT, _WITHOUT_CONTEXT, TOKENS,
                            _library, ffi)

INCLUDE = pathlib.Path(os.environ["OPENRT_INCLUDE"])


def declared():
    names = set()
    for header in [INCLUDE / "openrt" / "rtu.h", *(INCLUDE / "openrt").glob("rt_*.h")]:
        names |= set(re.findall(r"\bRTAPIENTRY\s+(rt\w+)\(", header.read_text()))
    return names


def test_every_function_is_there():
    missing = [name for name in declared() if not hasattr(_library, name)]
    assert len(declared()) > 500
    assert missing == []


def test_tokens_are_those_of_the_compiler(tmp_path):
    source = tmp_path / "tokens.c"
    lines = "".join(f'    printf("{name} %llu\\n", (unsigned long long){name});\n' for name in TOKENS)
    source.write_text('#include <stdio.h>\n#include "openrt/enums.h"\n'
                      f"int main(void) {{\n{lines}    return 0;\n}}\n")
    program = tmp_path / "tokens"
    subprocess.run(["cc", f"-I{INCLUDE}", str(source), "-o", str(program)], check=True)
    seen = dict(line.split() for line in
                subprocess.run([str(program)], check=True, capture_output=True,
                               text=True).stdout.splitlines())
    assert {name: int(value) for name, value in seen.items()} == TOKENS


def test_calls_without_a_context_are_those_that_say_so():
    said = {"rtGetError", "rtGetErrorText", "rtOccluded", "rtOccludedStream"}  # in other words
    for header in (INCLUDE / "openrt").glob("rt_*.h"):
        for functions in re.findall(r"Threads: any(?:(?!\*/).)*\*/\n((?:RTAPI[^;]+;\n)+)",
                                    header.read_text(), flags=re.S):
            said |= set(re.findall(r"\bRTAPIENTRY\s+(rt\w+)\(", functions))
    assert said == _WITHOUT_CONTEXT
    assert _UTILITIES_WITHOUT_CONTEXT <= set(
        re.findall(r"\bRTAPIENTRY\s+(rtu\w+)\(", (INCLUDE / "openrt/rtu.h").read_text()))


def test_help_tells_of_everything():
    things = {name: getattr(openrt, name) for name in openrt.__all__ if callable(getattr(openrt, name))}
    for name, thing in list(things.items()):
        if inspect.isclass(thing):
            things.update({f"{name}.{part}": member for part, member in vars(thing).items()
                           if part[0] != "_" and (callable(member) or isinstance(member, property))})
    assert "Shader.bind" in things and "Hits.hit" in things
    assert [name for name, thing in things.items() if not thing.__doc__] == []


def test_structures_have_the_compilers_layout():
    assert ffi.sizeof("RTray") == 32 and ffi.sizeof("RThit") == 40
    assert openrt.raw.rtIntersect.__doc__.startswith("void")
