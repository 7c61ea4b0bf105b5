#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the table of the interface's functions for the recording and playing of calls.

usage: generate_stream.py INCLUDE PARAMETERS OUTPUT

INCLUDE is the folder of the public headers, PARAMETERS is parameters.csv: what pointers and ids of
which functions mean. A row's function and parameter are patterns; the first row that fits counts.
An empty parameter stands for the function itself, its kind and what it yields; `return` for its
result. Arrays of functions named like rtVertex3fv, text, and the objects of rtu.h need no row;
every other pointer does.

Written into the folder OUTPUT:
  implementation_names.h  gives the library's own definitions other names for the linker, so that
                          the exported names belong to
  call_entries.cpp        the functions that programs call, which record where there is a sink
  call_table.cpp          the table of call_table.h, and a call of each function
  token_names.cpp         names of tokens
"""
import csv
import fnmatch
import pathlib
import re
import sys
import zlib

LIBRARY_HEADERS = ("rt_*.h", "rtu.h")
DECLARATION = re.compile(
    r"\bRTAPI\b\s*([^;{}()]*?)\bRTAPIENTRY\s+(\w+)\s*"
    r"\(((?:[^()]|\([^()]*\)|\((?:[^()]|\([^()]*\))*\))*)\)\s*;")
KINDS = {
    "RTbyte": "Int8", "RTubyte": "UInt8", "RTboolean": "UInt8", "RTshort": "Int16",
    "RTushort": "UInt16", "RTint": "Int32", "RTsizei": "Int32", "RTuint": "UInt32",
    "RTenum": "UInt32", "RTbitfield": "UInt32", "RTint64": "Int64", "RTuint64": "UInt64",
    "RTintptr": "Int64", "RTsizeiptr": "Int64", "RTfloat": "Float", "RTclampf": "Float",
    "RTdouble": "Double", "RTclampd": "Double", "char": "Int8", "void": "Void"}
BYTES = {"Void": 1, "Int8": 1, "UInt8": 1, "Int16": 2, "UInt16": 2, "Int32": 4, "UInt32": 4,
         "Int64": 8, "UInt64": 8, "Float": 4, "Double": 8}
STRUCTURES = {"RTray": 32, "RThit": 40}
OBJECTS = {"RTcontext": "Context", "RTUquadric": "Quadric", "RTUtesselator": "Tessellator",
           "RTUnurbs": "Nurbs"}
VECTOR = re.compile(r"(\d+)(b|s|i|f|d|ub|us|ui)v$")
RULES = {  # name in the table -> Memory, is output
    "in": ("Counted", False), "out": ("Counted", True), "token": ("Token", False),
    "token-or-one": ("TokenOrOne", False), "arguments": ("Arguments", False),
    "image": ("Image", False), "bitmap": ("Bitmap", False), "stipple": ("Bitmap", False), "packed-stipple": ("PackedImage", True),
    "lists": ("Lists", False), "indices": ("Indices", False),
    "many-indices": ("ManyIndices", False), "array": ("Array", False), "rays": ("Rays", False),
    "hits": ("Hits", True), "packed-image": ("PackedImage", True),
    "scaled-image": ("ScaledImage", True), "scratch": ("Scratch", True),
    "frame-buffer": ("FrameBuffer", True), "aux-buffer": ("AuxBuffer", True),
    "class": ("ShaderDescriptor", False), "callback": ("Callback", False),
    "unread": ("Unread", False)}
NOTE = "// SPDX-License-Identifier: MIT\n// Written by generate_stream.py.\n"


class Parameter:
    def __init__(self, text):
        self.text = text
        callback = re.match(r"void\s*\(\s*RTAPIENTRY\s*\*\s*(\w+)\s*\)", text)
        array = re.match(r"(.*?)(\w+)\s*\[\s*(\d*)\s*\]$", text)
        plain = re.match(r"(.*?)(\w+)$", text)
        self.length = 0
        if callback:
            self.name, self.type = callback.group(1), "callback"
        elif array:
            self.name, self.length = array.group(2), int(array.group(3) or 0)
            self.type = array.group(1).strip() + " *"
        else:
            self.name, self.type = plain.group(2), plain.group(1).strip()
        self.target = re.sub(r"\b(const|struct)\b|\*", "", self.type).strip()
        self.isPointer = "*" in self.type or self.type in ("callback", "RTUfuncptr", "RTcontext")


class Function:
    def __init__(self, result, name, parameters, header):
        self.result, self.name, self.header = " ".join(result.split()), name, header
        text = " ".join(parameters.split())
        pieces = [] if text == "void" else split(text)
        self.parameters = [Parameter(piece) for piece in pieces]
        self.text = text
        self.fingerprint = zlib.crc32(
            f"{self.result} {name}({', '.join(p.type for p in self.parameters)})".encode())


def split(text):
    """Parameters; commas inside of brackets belong to a function's type."""
    depth, start = 0, 0
    for i, character in enumerate(text + ","):
        depth += {"(": 1, ")": -1}.get(character, 0)
        if character == "," and depth == 0:
            yield text[start:i].strip()
            start = i + 1


def read_functions(include):
    functions = []
    for pattern in LIBRARY_HEADERS:
        for path in sorted(include.glob(pattern)):
            text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
            text = re.sub(r"^\s*#[^\n]*", "", text, flags=re.MULTILINE)
            functions += [Function(*match, path.name) for match in DECLARATION.findall(text)]
    return sorted(functions, key=lambda f: f.name)


class Rules:
    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            self.rows = [(r["function"], r["parameter"], r["rule"])
                         for r in csv.DictReader(file)]
        self.used = set()

    def find(self, function, parameter):
        for i, (f, p, rule) in enumerate(self.rows):
            if (p == "") == (parameter == "") and (p == "return") == (parameter == "return") \
                    and fnmatch.fnmatchcase(function, f) and fnmatch.fnmatchcase(parameter, p):
                self.used.add(i)
                return rule.split()
        return None

    def unused(self):
        return [row for i, row in enumerate(self.rows) if i not in self.used]


def element_of(parameter):
    """Kind and size of what a pointer points to."""
    kind = KINDS.get(parameter.target, "Void")
    if parameter.target in STRUCTURES:
        return "Void", STRUCTURES[parameter.target]
    return kind, BYTES[kind]


def counted(function, parameter, expression):
    """(amount, counter) of `16`, `n` or `count*3`."""
    if expression.isdigit():
        return "Constant", int(expression), -1
    name, _, factor = expression.partition("*")
    names = [p.name for p in function.parameters]
    if name not in names:
        raise SystemExit(f"{function.name}: {parameter.name}: no parameter {name}")
    return "Counted", int(factor or 1), names.index(name)


def pointer_entry(function, parameter, rules):
    if parameter.type == "RTcontext":
        return "UInt64", "Void", "Context", "None", False, 0, -1, 0
    kind, size = element_of(parameter)
    meaning, memory, output, amount, counter = "Plain", None, False, 0, -1
    rule = rules.find(function.name, parameter.name)
    vector = VECTOR.search(function.name)
    if parameter.target in OBJECTS:
        return "Pointer", "Void", OBJECTS[parameter.target], "None", False, 0, -1, 0
    if rule is None and parameter.target == "char" or parameter.target == "RTubyte" and \
            function.name == "rtuCheckExtension":
        memory = "String"
    elif rule is None and parameter.length:
        memory, amount = "Constant", parameter.length
    elif rule is None and vector and "const" in parameter.type:
        memory, amount = "Constant", int(vector.group(1))
    elif rule is None:
        raise SystemExit(f"{function.name}: parameters.csv says nothing of {parameter.name}")
    else:
        memory, output = RULES[rule[0]]
        if rule[0] in ("in", "out"):
            memory, amount, counter = counted(function, parameter, rule[1])
        elif rule[0] in ("token", "token-or-one", "lists", "indices", "many-indices", "rays",
                         "hits"):
            _, _, counter = counted(function, parameter, rule[1])
        elif rule[0] == "image":
            amount = int(rule[1])
        elif rule[0].endswith("stipple"):
            amount = 32
        if rule[-2:-1] == ["id"]:
            meaning = rule[-1]
    return "Pointer", kind, meaning, memory, output, amount, counter, size


def scalar_entry(function, parameter, rules):
    if parameter.type not in KINDS:
        raise SystemExit(f"{function.name}: type {parameter.type} is not known")
    rule = rules.find(function.name, parameter.name)
    meaning = "Token" if parameter.type == "RTenum" else "Plain"
    if rule and rule[0] == "id":
        meaning = rule[1]
    return KINDS[parameter.type], "Void", meaning, "None", False, 0, -1, 0


def result_entry(function, rules):
    """(kind, meaning, is compared)"""
    rule = rules.find(function.name, "return") or ["same"]
    text = re.sub(r"\b(const|struct)\b|\*", "", function.result).strip()
    if text in OBJECTS:
        return ("UInt64" if text == "RTcontext" else "Pointer"), OBJECTS[text], False
    if rule[0] == "pointer":
        return "Pointer", "Plain", False
    kind = KINDS[function.result]
    if rule[0] == "id":
        return kind, rule[1], False
    return kind, "Plain", kind != "Void" and rule[0] == "same"


def table(functions, rules):
    parameters, calls, first = [], [], 0
    for number, f in enumerate(functions):
        for p in f.parameters:
            make = pointer_entry if p.isPointer else scalar_entry
            kind, element, meaning, memory, output, amount, counter, size = make(f, p, rules)
            parameters.append(
                f'    {{"{p.name}", "{p.type}", ValueKind::{kind}, ValueKind::{element}, '
                f"Meaning::{meaning}, Memory::{memory}, {str(output).lower()}, {amount}, "
                f"{counter}, {size}}},")
        kind, meaning, compared = result_entry(f, rules)
        what, gives = ((rules.find(f.name, "") or ["state"]) + ["nothing"])[:2]
        calls.append(
            f'    {{"{f.name}", {number}, CallKind::{what.capitalize()}, '
            f"Yield::{gives.capitalize()}, ValueKind::{kind}, "
            f"Meaning::{meaning}, {str(compared).lower()}, {first}, {len(f.parameters)}, "
            f"0x{f.fingerprint:08x}u}},")
        first += len(f.parameters)
    makers = "\n".join(f"    invoke<&{f.name}>," for f in functions)
    lines = "\n".join
    return f"""{NOTE}#include "compat/stream/call_table.h"
#include "compat/stream/call_invocation.h"

#include "openrt/rt.h"
#include "openrt/rtu.h"

namespace smart::compat {{

namespace {{

constexpr CallParameter kParameters[] = {{
{lines(parameters)}
}};

constexpr CallSignature kCalls[] = {{
{lines(calls)}
}};

constexpr Invocation kInvocations[] = {{
{makers}
}};

}} // namespace

std::span<const CallSignature> callTable() {{
    return kCalls;
}}

std::span<const CallParameter> parametersOf(const CallSignature& call) {{
    return std::span(kParameters).subspan(call.firstParameter, call.parameters);
}}

void invokeCall(const CallSignature& call, const CallValue* arguments, CallValue& result) {{
    kInvocations[call.number](arguments, result);
}}

}} // namespace smart::compat
"""


def names_header(functions):
    def lines(is_rtu):
        return "\n".join(f'extern "C" decltype({f.name}) {f.name} __asm__("openrt_{f.name}");'
                         for f in functions if f.name.startswith("rtu") == is_rtu)
    return f"""{NOTE}// Included before all else of the library: its definitions get other names
// for the linker, and calls from inside of the library go to them. __func__ stays as it is.
// With OPENRT_RTU_ALONE only those of rtu.h do, so that a test sees what rtu calls.
#pragma once

#include "openrt/rt.h"
#include "openrt/rtu.h"

{lines(True)}
#ifndef OPENRT_RTU_ALONE
{lines(False)}
#endif
"""


def entries(functions):
    out = [NOTE + '#include "compat/stream/call_recording.h"\n#include "openrt/rt.h"\n'
           '#include "openrt/rtu.h"\n\nusing smart::compat::isRecording;\n'
           "using smart::compat::recordedCall;\n\nextern \"C\" {\n"]
    for number, f in enumerate(functions):
        names = ", ".join(p.name for p in f.parameters)
        entry = f"RTAPIENTRY entry_{f.name}({f.text})"
        arguments = f"{number}, {names}" if names else f"{number}"
        out.append(f'RTAPI {f.result} {entry} __asm__("{f.name}");\n'
                   f"{f.result} {entry} {{\n"
                   f"    if (!isRecording()) [[likely]] return {f.name}({names});\n"
                   f"    return recordedCall<&{f.name}>({arguments});\n}}\n")
    return "".join(out) + '} // extern "C"\n'


def token_names(include):
    """The first name of each value that is large enough to be of one thing only."""
    names = {}
    for header in ("enums.h", "rt_gl_enums_1_1.h", "rt_gl_enums_1_5.h", "rtu_enums.h"):
        text = (include / header).read_text(encoding="utf-8")
        for name, value in re.findall(r"^#define (RTU?_\w+) (0x[0-9A-Fa-f]+|\d+)u?$", text, re.M):
            if 0x100 <= int(value, 0) < 0xFFFFFFFF:
                names.setdefault(int(value, 0), name)
    rows = "\n".join(f'    {{0x{value:x}, "{name}"}},' for value, name in sorted(names.items()))
    return f"""{NOTE}#include "compat/trace/token_names.h"

#include <algorithm>
#include <iterator>

namespace smart::compat {{

namespace {{

struct TokenName {{
    uint32_t value;
    const char* name;
}};
constexpr TokenName kNames[] = {{
{rows}
}};

}} // namespace

const char* tokenName(uint32_t value) {{
    const TokenName* const found =
        std::lower_bound(std::begin(kNames), std::end(kNames), value,
                         [](const TokenName& t, uint32_t v) {{ return t.value < v; }});
    return found != std::end(kNames) && found->value == value ? found->name : nullptr;
}}

}} // namespace smart::compat
"""


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    include, parameters, output = map(pathlib.Path, sys.argv[1:])
    functions, rules = read_functions(include), Rules(parameters)
    files = {"call_table.cpp": table(functions, rules),
             "implementation_names.h": names_header(functions),
             "call_entries.cpp": entries(functions),
             "token_names.cpp": token_names(include)}
    if rules.unused():
        sys.exit(f"{parameters}: no function has {rules.unused()}")
    output.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        (output / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
