#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the tables of docs/conformance.md from what was measured; what is not given stays.

    write_tables.py --results result.json               of openrt-conformance --json: pictures
    write_tables.py --times times.txt                   what openrt-conformance --times printed
    write_tables.py --mutants named.json mechanical.json ...    of mutants.py --json
    write_tables.py --explanations FILE                 survivors' reasons: JSON, by mutants' names
"""
import argparse
import json
import pathlib
import re
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "conformance.md"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join(["---"] * len(head)) + " |"]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def between(text, name, lines):
    """The text with what is between the marks of that name replaced."""
    first, last = f"<!-- {name}: written by write_tables.py -->", f"<!-- end of {name} -->"
    if text.count(first) != 1 or text.count(last) != 1:
        sys.exit(f"{PAGE}: the marks of {name} are not there once each")
    start, end = text.index(first) + len(first), text.index(last)
    return text[:start] + "\n\n" + "\n".join(lines) + "\n\n" + text[end:]


def pictures(report):
    worst, others = {}, {}
    for result in report["results"]:
        match = re.fullmatch(r"picture/(\w+)/(\d+)x(\d+)", result["name"])
        if not match or "numbers" not in result:
            continue
        of_port = worst.setdefault(match[1], {})
        others[match[1]] = others.get(match[1], 0) + (result.get("reference") == "softpipe")
        for name, value in result["numbers"].items():
            of_port[name] = max(of_port.get(name, 0.0), value)
    rows = [[f"`{port}`", f"{n['colorMean']:.3f}", f"{n['color999']:.0f}", f"{n['depthMax']:.0e}",
             f"{n['flip']:.4f}", f"{100 * n['open']:.1f} %", f"{others[port] or ''}"] for port, n in sorted(worst.items())]
    return [f"{report['passed']} of {report['cases']} cases passed.", ""] + table(
        ["port", "colour inside, mean", "99.9 percentile", "depth inside", "FLIP", "open pixels", "by softpipe"],
        rows)


def times(text):
    lines = text.splitlines()
    rows = []
    for line in lines[2:]:
        match = re.fullmatch(r"(\w+)(?: (\d+))? +([-\d.]+) +([-\d.]+) +([-\d.]+) +([-\d.]+)", line)
        if not match:
            continue
        name = f"`{match[1]}`" + (f", {match[2]} cells" if match[2] else "")
        passed_gl, passed_rt, worked_gl, worked_rt = (float(match[i]) for i in range(3, 7))
        ratio = f"{worked_rt / worked_gl:.1f}" if worked_gl > 0 else ""
        rows.append([name, f"{passed_gl:.1f}", f"{passed_rt:.1f}", f"{worked_gl:.1f}",
                     f"{worked_rt:.1f}", ratio])
    return [lines[0] + ".", ""] + table(
        ["port", "passed, OSMesa", "passed, OpenRT", "worked, OSMesa", "worked, OpenRT", "ratio"],
        rows)


def mutants(files, explanations):
    lines = []
    for name in files:
        results = json.loads(pathlib.Path(name).read_text(encoding="utf-8"))
        survivors = [r for r in results if r["verdict"] != "caught"]
        kind = "mechanical" if any(":" in r["name"] for r in results) else "named"
        lines += [f"{len(results) - len(survivors)} of {len(results)} {kind} ones were caught.", ""]
        if survivors:
            lines += table(["survivor", "why"],
                           [["`" + r["name"].replace("|", "\\|") + "`",
                             explanations.get(r["name"], "")] for r in survivors]) + [""]
    return lines[:-1]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--results", type=pathlib.Path)
    parser.add_argument("--times", type=pathlib.Path)
    parser.add_argument("--mutants", nargs="+", default=[])
    parser.add_argument("--explanations", type=pathlib.Path)
    arguments = parser.parse_args()
    text = PAGE.read_text(encoding="utf-8")
    if arguments.results:
        report = json.loads(arguments.results.read_text(encoding="utf-8"))
        text = between(text, "pictures", pictures(report))
    if arguments.times:
        text = between(text, "times", times(arguments.times.read_text(encoding="utf-8")))
    if arguments.mutants:
        explanations = {}
        if arguments.explanations:
            explanations = json.loads(arguments.explanations.read_text(encoding="utf-8"))
        text = between(text, "mutants", mutants(arguments.mutants, explanations))
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
