#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables and pictures of what `openrt-bench dynamic` and `memory`, and sample_rates.py, found.

usage: dynamic_plot.py [--dynamic FILE.json] [--memory FILE.json] [--samples FILE.json]
                       --page PAGE.md --out FOLDER

Fills the tables of PAGE.md, between lines <!-- NAME --> and <!-- end of NAME -->, and writes
instances.svg (time of a step against the number of instances), sheet.svg (what an update of a
deforming sheet costs, by the way it is made) and decay.svg (rays after many updates) to FOLDER.
Needs nothing but Python.
"""
import argparse
import json
import math
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "accuracy"))
import plot  # noqa: E402

PARTS = {"update": "#56B4E9", "build": "#E69F00", "trace": "#777777"}
ENGINES = {"openrt": "#0072B2", "embree low": "#D55E00", "embree medium": "#CC79A7"}


def milliseconds(seconds):
    return f"{1e3 * seconds:.3g}" if seconds < 0.1 else f"{1e3 * seconds:,.0f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "| " + " | ".join("---" for _ in head) + " |"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def best_peer(series):
    return min((r["step"] for r in series["results"] if r["engine"].startswith("embree")),
               default=None)


def step_rows(series, each):
    peer = best_peer(series)
    for result in series["results"]:
        speed = f"{peer / result['step']:.2f}" if peer else "-"
        if result["refused"]:
            yield [result["engine"], "refused: wrong answers", "", "", "", "", ""]
            continue
        yield [result["engine"], *(milliseconds(result[part]) for part in PARTS),
               f"{1 / result['step']:.3g}", speed, f"{result['bytes'] / series[each]:.0f}"]


HEAD = ["way", "update, ms", "build, ms", "trace, ms", "steps a second", "to the best peer"]


def instance_table(report):
    rows = []
    for series in moving(report):
        for row in step_rows(series, "instances"):
            rows.append([f"{series['instances']:,}"] + row)
    return table(["instances"] + HEAD + ["bytes an instance"], rows)


def frame_table(report):
    rows, first = [], {}
    for frame in report.get("frames", []):
        base = first.setdefault(frame["lit"], frame["whole"])
        rows.append([f"{frame['instances']:,}", "lit" if frame["lit"] else "flat",
                     *(milliseconds(frame[part]) for part in ("describe", "freeze", "render")),
                     f"{100 * frame['freeze'] / frame['whole']:.1f} %",
                     f"{1 / frame['whole']:.3g}", f"{frame['whole'] / base:.2f}"])
    return table(["instances", "shading", "describe, ms", "freeze, ms", "render, ms",
                  "share of freezing", "frames a second", "time, to the first row of its kind"],
                 rows)


def sheet_table(report):
    return table(HEAD + ["bytes a triangle"], step_rows(sheet(report), "triangles"))


def queue_table(report):
    q = report["queue"]
    system = (q["processor"] + q["ready"]) / (q["busy"] + q["idle"])
    return table(["figure", "value"], [
        ["threads idle between tiles and frames",
         f"{100 * q['idle'] / (q['idle'] + q['busy']):.2f} %"],
        ["time on or ready for a processor by the system, to busy and idle by the library",
         f"{100 * system:.1f} %"],
        ["a cancelled frame ends after, median", f"{1e3 * q['cancel']:.2f} ms"],
        ["the same, longest", f"{1e3 * q['longestCancel']:.2f} ms"],
        ["a tile takes, mean", f"{1e3 * q['tile']:.2f} ms"],
        ["the same, longest", f"{1e3 * q['longestTile']:.2f} ms"]])


def sample_table(report):
    peers = {peer["sample"]: peer for peer in report.get("peers", [])}
    rows = []
    for s in report["samples"]:
        row = [s["sample"], f"{s['rate']:.3g}", milliseconds(s["describe"])]
        peer = peers.get(s["sample"])
        if peer:
            own = 1 / peer["rate"] - peer["commit"] - peer["trace"]
            best = 1 / (peer["commit"] + peer["trace"] + max(own, 0) / 2)
            row += [f"{peer['rate']:.3g}", f"{best:.3g}", peer["way"],
                    milliseconds(max(own, 0)), milliseconds(peer["commit"]),
                    milliseconds(peer["trace"]), f"{1e-3 * peer['rays']:,.0f}"]
        else:
            row += ["-"] * 7
        rows.append(row)
    return table(["sample", "frames a second", "describe, ms", "Embree without shading",
                  "the same, no thread idle", "way", "program, ms", "commit, ms", "trace, ms",
                  "thousand rays a frame"], rows)


def memory_table(rows):
    return table(["what", "counted", "by the allocator", "peak while it is made", "seconds"],
                 [[row["what"], *(f"{row[column] / row['per']:.1f}"
                                  for column in ("counted", "heap", "peak")),
                   f"{row['seconds']:.2f}"] for row in rows])


def moving(report):
    return [s for s in report.get("series", []) if s["scene"] != "sheet"]


def sheet(report):
    return next(s for s in report["series"] if s["scene"] == "sheet")


def instances_picture(report, out):
    picture = plot.Picture("Time of a step against the number of moving instances",
                           f"update, build and {report['size']} x {report['size']} camera rays, "
                           f"{report['threads']} threads; hollow: update and build alone")
    series = moving(report)
    values = [r[part] for s in series for r in s["results"] for part in ("step", "build")]
    scale = plot.Logarithm(1e3 * min(values), 1e3 * max(values))
    low, high = (math.log10(pick(s["instances"] for s in series)) for pick in (min, max))

    def place(count):
        return (math.log10(count) - low) / max(high - low, 1e-9)

    picture.axis_y([tick for tick in scale.ticks() if tick[0] > 0], "milliseconds")
    picture.axis_x([(place(s["instances"]), f"{s['instances']:,}") for s in series], "instances")
    legend = []
    for engine, colour in ENGINES.items():
        for hollow, parts in ((False, ("step",)), (True, ("update", "build"))):
            points = [(picture.at_x(place(s["instances"])),
                       picture.at_y(scale(1e3 * sum(r[part] for part in parts))))
                      for s in series for r in s["results"] if r["engine"] == engine]
            if not points:
                continue
            picture.path(points, colour)
            for x, y in points:
                picture.dot(x, y, colour, hollow)
            if not hollow:
                legend.append((engine, colour, False))
    picture.legend(legend)
    picture.save(out / "instances.svg")


def sheet_picture(report, out):
    series = sheet(report)
    results = [r for r in series["results"] if not r["refused"]]
    picture = plot.Picture(f"A sheet of {series['triangles']:,} triangles, new positions each step",
                           f"{report['size']} x {report['size']} camera rays, "
                           f"{report['threads']} threads", width=860)
    largest = 1e3 * max(r["update"] + r["build"] + r["trace"] for r in results)
    step = plot.nice_step(largest)
    top = step * math.ceil(largest / step)
    picture.axis_y([(i * step / top, f"{i * step:g}") for i in range(round(top / step) + 1)],
                   "milliseconds")
    width = 1 / len(results)
    picture.axis_x([((i + 0.5) * width, r["engine"].replace(" ", "\n"))
                    for i, r in enumerate(results)], "")
    for i, result in enumerate(results):
        below = 0.0
        for part, colour in PARTS.items():
            share = 1e3 * result[part] / top
            picture.bar(picture.at_x((i + 0.2) * width), picture.at_y(below + share),
                        0.6 * width * picture.plot_width, share * picture.plot_height, colour)
            below += share
    picture.legend([(part, colour, False) for part, colour in PARTS.items()])
    picture.save(out / "sheet.svg")


MOTIONS = {"waves": "#0072B2", "twist": "#D55E00", "crumple": "#009E73"}


def decay_table(report):
    rows = []
    for series in report["decay"]:
        ratios = [step["updated"] / step["fresh"] for step in series["steps"]]
        rows.append([series["motion"], milliseconds(series["update"]),
                     milliseconds(series["longest"]), f"{max(ratios):.2f}", f"{ratios[-1]:.2f}"])
    return table(["motion", "an update, ms", "the longest, ms", "rays, the worst",
                  "rays, after the last"], rows)


def decay_picture(report, out):
    picture = plot.Picture("Camera rays through an object that is updated again and again",
                           "time, in times of that through an object defined anew")
    steps = [(s["motion"], step["number"], step["updated"] / step["fresh"])
             for s in report["decay"] for step in s["steps"]]
    last, top = max(number for _, number, _ in steps), max(1.5, *(r for _, _, r in steps)) + 0.1
    picture.axis_y([(tick / 4 / top, f"{tick / 4:g}") for tick in range(int(4 * top) + 1)], "times")
    picture.axis_x([(part / 5, f"{round(last * part / 5)}") for part in range(6)], "updates")
    for motion, colour in MOTIONS.items():
        points = [(picture.at_x(number / last), picture.at_y(ratio / top))
                  for name, number, ratio in steps if name == motion]
        picture.path(points, colour)
        for x, y in points:
            picture.dot(x, y, colour, False)
    picture.legend([(motion, colour, False) for motion, colour in MOTIONS.items()])
    picture.save(out / "decay.svg")


def fill(text, name, content):
    begin, end = f"<!-- {name} -->\n", f"<!-- end of {name} -->"
    before, found, rest = text.partition(begin)
    _, found_end, after = rest.partition(end)
    if not found or not found_end:
        raise SystemExit(f"the page has no place for {name}")
    return before + begin + "\n" + content + "\n\n" + end + after


def shown(words, picture, options):
    folder = os.path.relpath(options.out, options.page.parent)
    return f"\n\n![{words}]({pathlib.Path(folder, picture).as_posix()})"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--dynamic", type=pathlib.Path)
    parser.add_argument("--memory", type=pathlib.Path)
    parser.add_argument("--samples", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path, required=True)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    options = parser.parse_args()
    text = options.page.read_text(encoding="utf-8")
    options.out.mkdir(parents=True, exist_ok=True)
    if options.dynamic:
        report = json.loads(options.dynamic.read_text(encoding="utf-8"))
        if moving(report):
            text = fill(text, "instances", instance_table(report) + shown(
                "Time of a step against the number of instances", "instances.svg", options))
            text = fill(text, "frames", frame_table(report))
            instances_picture(report, options.out)
        if any(s["scene"] == "sheet" for s in report.get("series", [])):
            text = fill(text, "sheet", sheet_table(report) + shown(
                "What an update of a sheet costs", "sheet.svg", options))
            sheet_picture(report, options.out)
        if "decay" in report:
            text = fill(text, "decay", decay_table(report) + shown(
                "Rays through an updated object", "decay.svg", options))
            decay_picture(report, options.out)
        if "queue" in report:
            text = fill(text, "queue", queue_table(report))
    if options.samples:
        report = json.loads(options.samples.read_text(encoding="utf-8"))
        text = fill(text, "samples", sample_table(report))
    if options.memory:
        report = json.loads(options.memory.read_text(encoding="utf-8"))
        text = fill(text, "memory of objects", memory_table(report["objectRows"]))
        text = fill(text, "memory of instances", memory_table(report["instanceRows"]))
        text = fill(text, "first pictures", memory_table(report["firstPictures"]))
    options.page.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
