#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes porting_table_calls.inc: what the tables say of each function, as rows that call it.

Each function gets zeros and null pointers. REFUSED, CARRIED_OUT and the like are macros of the
program that includes the file; GLUT's functions that are carried out may open windows or not come
back, and only their names are given.
"""
import pathlib
import re
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent.parent / "compat"))

from generate_calls import read_calls  # noqa: E402

# What a call makes has to go again.
DELETED_BY = {"rtuNewQuadric": "rtuDeleteQuadric", "rtuNewTess": "rtuDeleteTess"}


def arguments(parameters):
    return "" if parameters == "void" else ", ".join("0" for _ in split(parameters))


def split(parameters):
    """Parameters one by one; those of a function pointer stay together."""
    flat = re.sub(r"\([^()]*\)", lambda m: m.group().replace(",", ";"), parameters)
    return flat.split(",")


def call(row):
    text = f"{row['name']}({arguments(row['parameters'])})"
    if row["name"] in DELETED_BY:
        return f"{DELETED_BY[row['name']]}({text})"
    return f"(void){text}"


def main():
    root, target = map(pathlib.Path, sys.argv[1:])
    tables = read_calls(root)
    lines = []
    for library in ("gl", "glu"):
        for row in tables[library]:
            kind = "REFUSED" if row["status"] == "refused" else "CARRIED_OUT"
            lines.append(f'{kind}("{row["name"]}", {call(row)})')
    for row in tables["glut"]:
        if row["status"] == "refused":
            lines.append(f'GLUT_REFUSED("{row["name"]}", {call(row)})')
        else:
            lines.append(f"GLUT_NAME({row['name']})")
    target.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
