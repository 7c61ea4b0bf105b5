# SPDX-License-Identifier: MIT
"""What the page of a function says where the header says it once for all its functions: errors,
threads, since when, and what the function comes from."""
import csv
import functools
import pathlib
import re

from header_comments import dedent, functions

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Tables of the functions of other interfaces: the prefix here, there, and the interface's name.
TABLES = {"glut_calls.csv": ("rtut", "glut", "GLUT"), "glu_calls.csv": ("rtu", "glu", "GLU"),
          "gl_calls.csv": ("rt", "gl", "OpenGL")}
ORDER = ["Errors", "Threads", "Since", "Source"]
NO_ERRORS = "None but those that every call can record: see the rules in openrt/rt.h."
OF_ALL = "Errors of all"  # come behind a function's own; "Errors" stands where it has none
# Parameters without which an error of all can not be.
NEEDED = {"RT_INVALID_ENUM": r"\bRTenum\b", "RT_INVALID_VALUE": r"\*|\bRT(float|double|clamp.|int)\b"}
COMMON = {
    "rt_fixed.h": {
        OF_ALL: ["RT_INVALID_ENUM  a token that OpenGL does not know there, or a call with one value "
                 "for what takes several",
                 "RT_INVALID_VALUE  a number out of OpenGL's range or not a number, NULL",
                 "RT_INVALID_OPERATION  between rtBegin and rtEnd, or in an object, but for materials "
                 "and current values"]},
    "rt_frame.h": {"Threads": ["the context's."]},
    "rt_gl.h": {
        "What": ", not carried out in this release: declared so that programs compile.",
        "Errors": ["RT_INVALID_OPERATION  always, with a text that names the function; nothing "
                   "changes, and 0, NULL or RT_FALSE is returned"],
        "Threads": ["the context's."], "Since": ["0.1"]},
    "rt_pixels.h": {OF_ALL: ["RT_INVALID_OPERATION  between rtBegin and rtEnd, or in an object"]},
    "rt_query.h": {"Threads": ["any, with any context or none."]},
    "rt_shaders.h": {"Threads": ["the context's."]},
    "rtu.h": {
        "Errors": ["None but what GLU reports, and RT_INVALID_VALUE for an object that is NULL: see "
                   "the rules in openrt/rtu.h."],
        "Threads": ["the context's for calls that draw or set matrices or cameras, any for all "
                    "others; one object is used by one thread at a time."]},
    "rtut.h": {
        "Errors": ["A wrong argument has no effect but a message, which rtutGetErrorText gives."],
        "Threads": ["the one that called rtutInit."]},
}


@functools.cache
def sources():
    """{function: (the interface it comes from, its name there or "")}"""
    found = {}
    for name, (prefix, theirs, interface) in TABLES.items():
        with open(ROOT / "compat" / name, encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                found[row["name"]] = (f"{interface} {row['version']}",
                                      theirs + row["name"][len(prefix):])
    with open(ROOT / "compat/own_calls.csv", encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            interface, _, theirs = row["source"].partition(": ")
            found[row["name"]] = (interface, theirs)
    return found


def source_of(group):
    """Of a group that shares a page each interface once, with the names there."""
    names = {}
    for function in group:
        interface, theirs = sources().get(function, ("", ""))
        names.setdefault(interface, []).append(theirs)
    return "; ".join(interface + (": " if any(theirs) else "") + ", ".join(filter(None, theirs))
                     for interface, theirs in names.items())


def fields_of(header, lines, fields, calls):
    """The text and all fields of functions: of their comment, and what is said once for the header."""
    common = COMMON.get(header, {})
    errors = fields.get("Errors") or common.get("Errors", [] if OF_ALL in common else [NO_ERRORS])
    of_all = [line for line in common.get(OF_ALL, [])
              if re.search(NEEDED.get(line.split()[0], ""), calls)]
    found = {**common, **fields, "Errors": [*dedent(errors), *of_all],
             "Source": [source_of(functions(calls))]}
    return ([lines[0] + common["What"]] if "What" in common else lines,
            {title: found[title] for title in ORDER if title in found})
