#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes docs/figures/hardening.md of the results of the long runs in docs/figures/results.

    page.py                    makes the page
    page.py --check            exit status 1 if the page is not what the results say
    page.py --take FOLDER      takes the results of ./check --long from there (build/figures) first

What has no result is told as not run.
"""
import argparse
import json
import pathlib
import shutil
import sys
import textwrap
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = ROOT / "docs/figures/results"
PAGE = ROOT / "docs/figures/hardening.md"
NOT_RUN = "not run"
SANITIZERS = {"asan": "address and undefined behaviour", "tsan": "threads"}


def read(name):
    path = RESULTS / name
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def lines_of(name):
    path = RESULTS / name
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines() if line]


def table(head, rows):
    return ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head),
            *("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows), ""]


def thousands(number):
    return f"{number:,}"


def totals_of(name):
    totals = {}
    for entry in lines_of(name):
        total = totals.setdefault(entry["target"], {"executions": 0, "seconds": 0, "faults": 0})
        total["executions"] += entry["executions"] or 0
        total["seconds"] += entry["seconds"]
        total["faults"] += entry["fault"] is not None
    return totals


def random_runs(how, totals):
    if not totals:
        return []
    return ["Random changes of the first inputs, run by the ordinary programs (`fuzz_NAME "
            "--random`) "
            f"{how}, and without looking at what code they reach:", "",
            *table(["target", "executions", "seconds", "runs with a fault"],
                   [[target, thousands(total["executions"]) if total["executions"] else "not told",
                     total["seconds"], total["faults"]]
                    for target, total in sorted(totals.items())])]


def fuzzing():
    totals, random = totals_of("fuzz.jsonl"), totals_of("random_inputs.jsonl")
    found = read("fuzz_findings.json") or {}
    targets = sorted(path.name[:-len("_fuzz.cpp")]
                     for path in (ROOT / "tests/fuzz").glob("*_fuzz.cpp"))
    rows = []
    for target in targets:
        total = totals.get(target)
        if total:
            row = [target, thousands(total["executions"]), f"{total['seconds'] / 3600:.2f}",
                   total["faults"]]
        else:
            row = [target, NOT_RUN, "", ""]
        was_run = total or target in random or target in found
        rows.append([*row, found.get(target, "nothing") if was_run else ""])
    with_random = [
        *random_runs("without sanitizers", random),
        *random_runs("under address and undefined-behaviour sanitizers",
                     totals_of("random_sanitized.jsonl"))]
    return ["## Fuzzing", "",
            "libFuzzer with address and undefined-behaviour sanitizers; `tests/fuzz`. Hours are those of "
            "the clock; other work took most of the machine. Runs that ended with a fault, and what "
            "was the matter.", "",
            *table(["target", "executions", "hours", "runs with a fault", "found and mended"], rows),
            *with_random]


def memory():
    scenes, samples, frames = (read(f"{name}.json") for name in
                               ("failing_scenes", "failing_samples", "many_frames"))
    text = ["## Memory that runs out", "",
            "The n-th allocation fails, alone or with all that follow. A failure counts as absorbed "
            "where no error was recorded and the picture was right all the same; of sample programs also "
            "where there was no context yet to record it in.", ""]
    if scenes:
        kind = "every allocation" if scenes["whole"] else "a selection of allocations"
        text += [f"`failing_scenes`, {kind}:", ""]
        text += table(["scene", "allocations", "failures", "recorded", "absorbed", "faults"],
                      [[s[key] for key in ("scene", "allocations", "failures", "recorded",
                                           "absorbed", "faults")] for s in scenes["scenes"]])
    else:
        text += [f"`failing_scenes`: {NOT_RUN}.", ""]
    if samples:
        entries = samples["samples"]
        count = {key: sum(e[key] for e in entries) for key in ("failures", "recorded", "absorbed")}
        faults = sum(len(e["faults"]) for e in entries)
        kind = "from all over the run" if samples["whole"] else "one allocation each"
        text += [f"`failing_samples`, {kind}: {len(entries)} sample programs, "
                 f"{thousands(count['failures'])} failures, {thousands(count['recorded'])} recorded, "
                 f"{thousands(count['absorbed'])} absorbed, {faults} faults.", ""]
    else:
        text += [f"`failing_samples`: {NOT_RUN}.", ""]
    if frames:
        text += [f"`many_frames`: {thousands(frames['frames'])} frames of changing scenes, "
                 f"{thousands(frames['early_kb'])} kB after a tenth of them, "
                 f"{thousands(frames['late_kb'])} kB at the end. {frames.get('note', '')}".rstrip(), ""]
    else:
        text += [f"`many_frames`: {NOT_RUN}.", ""]
    return text


def calls():
    result = read("every_call.json")
    text = ["## Every call in every state", "",
            "Each function with legal arguments, and with every other value of its kind (for memory "
            "and numbers a chosen list; every token) in one parameter at a time, and with four "
            "values each in each pair of parameters; in a callback, after a fork, on another thread "
            "and after rtExit once, with legal ones. A call that records an error must leave all state that can be asked for, and the scene, as they were; no call may "
            "change the host: floating-point control, signal mask and handlers, locale, affinity, "
            "folder, file mode mask, standard output, environment.", ""]
    if not result:
        return [*text, f"`every_call`: {NOT_RUN}.", "", *rtut_calls()]
    kind = "all values" if result["whole"] else "two values a parameter"
    text += [f"`every_call`, {kind}: {thousands(result['functions'])} functions, "
             f"{thousands(result['calls'])} calls, {thousands(result['errors'])} recorded an error, "
             f"{result['faults']} faults.", ""]
    return text + table(["state", "calls"], [[place, thousands(n)] for place, n in
                                              sorted(result["places"].items())]) + rtut_calls()


def rtut_calls():
    result = read("every_rtut_call.json")
    text = ["The same of librtut, off-screen, one parameter at a time, each call in a process of its "
            "own. A call that tells a message or records an error must leave what can be asked for, "
            "take no memory for good, and the program must go on as if it had not been made.", ""]
    if not result:
        return [*text, f"`every_rtut_call`: {NOT_RUN}.", ""]
    kind = "all values" if result["whole"] else "two values a parameter, each in a third of the states"
    return [*text, f"`every_rtut_call`, {kind}: {thousands(result['functions'])} functions, "
            f"{thousands(result['calls'])} calls in {len(result['places'])} states, "
            f"{thousands(result['recorded'])} told a message or recorded an error, "
            f"{result['faults']} faults.", ""]


def suite(preset):
    path = RESULTS / f"{preset}.xml"
    if not path.exists():
        return None
    suites = xml.etree.ElementTree.parse(path).getroot()
    return {key: int(suites.get(key, 0)) for key in ("tests", "failures", "skipped")}


def suites():
    rows = []
    for preset, name in {"release": "none", **SANITIZERS}.items():
        counts = suite(preset)
        rows.append([name, counts["tests"], counts["failures"], counts["skipped"]] if counts
                    else [name, NOT_RUN, "", ""])
    leave = (ROOT / "tests/process/CMakeLists.txt").read_text(encoding="utf-8")
    ways = len(leave.split("set(ways")[1].split(")")[0].split())
    note = (read("about.json") or {}).get("suites")
    return ["## The test suite", "", *table(["sanitizer", "tests", "failed", "skipped"], rows),
            *([note, ""] if note else []),
            f"Among the tests are {ways} ways to leave a process (`tests/process`): with and without "
            "`rtExit`, from `atexit`, in a callback, by a signal, after a fork; and the library opened "
            "and closed twenty times, and twice in one process.", ""]


def valgrind():
    programs = read("valgrind.json")
    text = ["## Valgrind", "",
            "memcheck, with AVX2, over the fuzz targets' first inputs and the program of one "
            "triangle: wrong accesses, values that were never set, memory that is lost.", ""]
    if not programs:
        return [*text, f"`tests/figures/valgrind.py`: {NOT_RUN}.", ""]
    return text + table(["program", "inputs", "errors"],
                        [[entry["program"], entry["inputs"],
                          f"{entry['errors']} {entry.get('note', '')}".rstrip()]
                         for entry in programs])


def packages():
    made = read("packages.json")
    text = ["## Packages", "",
            "Debian packages by CPack, judged by lintian; `tests/figures/packages.py`.", ""]
    if not made:
        return [*text, f"lintian: {NOT_RUN}.", ""]
    return text + table(["package", "size", "errors", "warnings"],
                        [[entry["package"], f"{entry['bytes'] / 1e6:.2f} MB",
                          ", ".join(entry["errors"]) or "none",
                          ", ".join(entry["warnings"]) or "none"] for entry in made])


def bare_machine():
    bare = read("bare.json")
    if not bare:
        return NOT_RUN
    steps = [bare[name] for name in ("packages", "demo")]
    minutes, work = (sum(step[key] for step in steps) for key in ("minutes", "core_minutes"))
    return (f"{minutes:.1f} minutes, {bare['packages']['minutes']} of them for packages; "
            f"{work:.1f} minutes of one core. {bare.get('note', '')}").rstrip()


def compared(twice):
    """Of two builds, what reproducible.py says."""
    files = f" in all of {thousands(twice['files'])} installed files" if "files" in twice else ""
    different = ", ".join(f"`{name}`" for name in twice.get("different", []))
    told = f"equal{files}" if twice["equal"] else f"different{': ' if different else ''}{different}"
    return f"{told}. {twice['note']}" if "note" in twice else told


def sizes():
    start, coverage = read("start.json"), read("coverage.json")
    rows = [["stripped `libOpenRT.so`",
             f"{start['library_bytes'] / 1e6:.2f} MB" if start else NOT_RUN],
            ["a C program that renders one triangle of 64 x 64 pixels, start to end",
             f"{start['one_triangle_ms']['median']} ms (`/bin/true`: "
             f"{start['true_ms']['median']} ms)" if start else NOT_RUN],
            ["from a bare Debian 12 to the first picture, by `./demo`", bare_machine()]]
    twice = read("reproducible.json")
    rows.append(["two builds in different folders", compared(twice) if twice else NOT_RUN])
    if coverage:
        share = 100 * coverage["covered"] / coverage["lines"]
        which = f", by the tests `{coverage['tests']}` only" if "tests" in coverage else ""
        rows.append([f"lines covered by the test suite{which}",
                     f"{share:.1f} % of {thousands(coverage['lines'])}"])
    else:
        rows.append(["lines covered by the test suite", NOT_RUN])
    text = ["## Size, start, coverage", "", *table(["what", "figure"], rows)]
    if coverage:
        text += table(["folder", "lines", "covered"],
                      [[name, thousands(f["lines"]), f"{100 * f['covered'] / f['lines']:.1f} %"]
                       for name, f in coverage["folders"].items()])
        text += ["Least covered:", "",
                 *table(["file", "covered"], [[f"`{f['source']}`", f"{100 * f['share']:.0f} %"]
                                              for f in coverage["least"]])]
    return text


def page():
    about = read("about.json") or {}
    when = f" Results of {about['date']}, {about['machine']}." if about else ""
    commit = about.get("commit") or (read("commit.json") or {}).get("commit")
    when += f" The sources measured: commit `{commit}`." if commit else ""
    lines = [
        "# Hardening in figures", "",
        "What was done to make the library fail, how often, and what came of it. `./check --long` "
        "makes all of these runs; `tests/figures/page.py` made this page of their results, which are "
        "in `docs/figures/results`. What has no result says so." + when, "",
        *fuzzing(), *memory(), *calls(), *suites(), *valgrind(), *packages(), *sizes()]
    wrapped = (line if line.startswith("|") else textwrap.fill(line, 100, break_on_hyphens=False,
                                                               break_long_words=False)
               for line in lines)
    return "\n".join(wrapped).rstrip() + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--take", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.take:
        RESULTS.mkdir(parents=True, exist_ok=True)
        for path in sorted(arguments.take.iterdir()):
            shutil.copy(path, RESULTS / path.name)
    text = page()
    if not arguments.check:
        PAGE.write_text(text, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != text:
        print("docs/figures/hardening.md is not what the results say; run tests/figures/page.py")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
