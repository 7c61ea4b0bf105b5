#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes what follows from the tables of the functions and tokens of OpenGL, GLU and GLUT.

gl_calls.csv:  every function of OpenGL 1.0 to 1.5 under its rt name. `core` functions are declared
               by hand in openrt/rt.h; of the `refused` ones declaration and definition are written.
               `how` says where a core function differs from OpenGL's; empty: it does not.
glu_calls.csv, glut_calls.csv: the same of GLU 1.3 and GLUT 3.7, whose headers are written by hand.
gl_tokens.csv: every token whose value is OpenGL's.
gl_extensions.csv: names that core functions and such tokens had in extensions of OpenGL before they
               became core.

Written are the headers and definitions of OpenGL's refused functions and of its tokens, the names
of the three libraries below openrt/gl, and the table in docs/porting.md.

With --check nothing is written: exit status 1 if a committed file differs from what would be.
"""
import argparse
import csv
import difflib
import pathlib
import re
import sys
import textwrap

import generate_names
import generate_porting

WIDTH = 100
CALL_COLUMNS = ["name", "result", "parameters", "version", "chapter", "how", "status"]
EXTENSION_COLUMNS = ["name", "core", "extension"]
NOTE = "Written by compat/generate_calls.py; change the table, not this file."


def read_table(path, columns):
    with open(path, newline="", encoding="utf-8") as file:
        reader = csv.DictReader(file)
        if reader.fieldnames != columns:
            raise SystemExit(f"{path}: expected the columns {','.join(columns)}")
        return list(reader)


def chapters(rows):
    """The rows grouped by their chapter, chapters in order of first appearance."""
    groups = {}
    for row in rows:
        groups.setdefault(row["chapter"], []).append(row)
    return groups.items()


def wrap(head, parameters, tail, indent):
    """head(parameters)tail in lines of WIDTH, broken between parameters only."""
    def glue(text):
        return text.replace(" ", "~")

    text = f"{glue(head)}({', '.join(map(glue, parameters.split(', ')))}){glue(tail)}"
    lines = textwrap.wrap(text, WIDTH, subsequent_indent=" " * indent,
                          break_long_words=False, break_on_hyphens=False)
    return [line.replace("~", " ") for line in lines]


def result_type(row):
    return row["result"] if row["result"].endswith("*") else row["result"] + " "


def token_header(rows, versions, guard, title):
    out = ["/* SPDX-License-Identifier: MIT */", f"/* {NOTE} */", f"/* {title} */",
           f"#ifndef {guard}", f"#define {guard}"]
    for chapter, members in chapters([r for r in rows if r["version"] in versions]):
        out += ["", f"/* {chapter} */"]
        out += [f"#define {r['token']} {r['value']}" for r in members]
    return "\n".join(out + ["", "#endif", ""])


def refused_header(rows):
    out = ["/* SPDX-License-Identifier: MIT */",
           "/* The functions of OpenGL 1.5 which this release declares and does not carry out. Each",
           " * records RT_INVALID_OPERATION with a text that names it, changes nothing and returns 0,",
           " * NULL or RT_FALSE. The others are in openrt/rt.h.",
           f" * {NOTE} */",
           "#ifndef OPENRT_RT_GL_H", "#define OPENRT_RT_GL_H", "",
           '#include "openrt/types.h"', "", "#ifdef __cplusplus", 'extern "C" {', "#endif"]
    for chapter, members in chapters(rows):
        out += ["", f"/* {chapter} */"]
        for row in members:
            head = f"RTAPI {result_type(row)}RTAPIENTRY {row['name']}"
            out += wrap(head, row["parameters"], ";", len(head) + 1)
    return "\n".join(out + ["", "#ifdef __cplusplus", "}", "#endif", "", "#endif", ""])


def unnamed(parameters):
    """Parameter list without the names, as a definition that ignores them has it."""
    if parameters == "void":
        return "void"
    return ", ".join(re.sub(r"\s*\w+$", "", p) for p in parameters.split(", "))


def refused_source(rows):
    out = ["// SPDX-License-Identifier: MIT", f"// {NOTE}",
           '#include "compat/openrt/guard.h"', '#include "openrt/rt_gl.h"', "",
           "using smart::compat::refused;", "using smart::compat::refusedInPrimitive;"]
    for chapter, members in chapters(rows):
        out += ["", f"// {chapter}"]
        for row in members:
            head = f"RTAPI {result_type(row)}RTAPIENTRY {row['name']}"
            legal = re.match(r"rt(Index[a-z]|EvalCoord|EvalPoint)", row["name"])
            call = f'{"refusedInPrimitive" if legal else "refused"}("{row["name"]}");'
            if row["result"].endswith("*"):
                call += " return nullptr;"
            elif row["result"] == "RTboolean":
                call += " return RT_FALSE;"
            elif row["result"] != "void":
                call += " return 0;"
            out += wrap(head, unnamed(row["parameters"]), f" {{ {call} }}", 4)
    return "\n".join(out + [""])


def read_calls(root):
    """The rows of functions of gl, glu and glut."""
    tables = {}
    for library in ("gl", "glu", "glut"):
        path = root / f"compat/{library}_calls.csv"
        tables[library] = read_table(path, CALL_COLUMNS)
        for row in tables[library]:
            if row["status"] not in ("core", "refused"):
                raise SystemExit(f"{path}: {row['name']}: unknown status '{row['status']}'")
    return tables


def generate(root):
    """Path below root -> text, for every generated file."""
    tables = read_calls(root)
    calls = tables["gl"]
    tokens = read_table(root / "compat/gl_tokens.csv", ["token", "value", "version", "chapter"])
    extensions = read_table(root / "compat/gl_extensions.csv", EXTENSION_COLUMNS)
    for rows, key in (*((rows, "name") for rows in tables.values()), (tokens, "token"),
                      (extensions, "name")):
        names = [row[key] for row in rows]
        if len(set(names)) != len(names):
            raise SystemExit(f"a {key} is listed twice")
    refused = [row for row in calls if row["status"] == "refused"]
    return {
        "include/openrt/rt_gl_enums_1_1.h": token_header(
            tokens, {"1.1"}, "OPENRT_RT_GL_ENUMS_1_1_H",
            "The tokens of OpenGL 1.0 and 1.1 that have OpenGL's value."),
        "include/openrt/rt_gl_enums_1_5.h": token_header(
            tokens, {"1.2", "1.3", "1.4", "1.5"}, "OPENRT_RT_GL_ENUMS_1_5_H",
            "The tokens that OpenGL 1.2 to 1.5 added, with OpenGL's value."),
        "include/openrt/rt_gl.h": refused_header(refused),
        "compat/openrt/api_refused.cpp": refused_source(refused),
        **generate_names.generate(root, NOTE, tables, tokens, extensions),
        **generate_porting.generate(root, tables),
    }


def differences(root, files):
    """Unified diffs between the committed files and the generated ones; empty when all is well."""
    out = []
    for path, text in files.items():
        target = root / path
        old = target.read_text(encoding="utf-8") if target.exists() else ""
        if old != text:
            out += difflib.unified_diff(old.splitlines(), text.splitlines(), path, "generated",
                                        lineterm="", n=1)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--root", type=pathlib.Path,
                        default=pathlib.Path(__file__).resolve().parent.parent)
    arguments = parser.parse_args()
    files = generate(arguments.root)
    if arguments.check:
        found = differences(arguments.root, files)
        print("\n".join(found[:40]))
        return 1 if found else 0
    for path, text in files.items():
        (arguments.root / path).parent.mkdir(parents=True, exist_ok=True)
        (arguments.root / path).write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
