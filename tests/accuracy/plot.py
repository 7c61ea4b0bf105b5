#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Pictures and tables of what openrt-accuracy found.

usage: plot.py --out FOLDER [--tables FILE] REPORT.json...

Reports of several runs are joined: a later one replaces cases, scenes and secondary rays of the
same name. Writes pareto-SCENE.svg (speed against lost rays), cost.svg (time relative to the fast
mode), scale.svg, offset.svg and aspect.svg (lost or wrong rays as curves). Needs nothing but
Python.
"""
import argparse
import json
import math
import re
import sys
from pathlib import Path
from xml.sax.saxutils import escape

# Colours that the colour-blind can tell apart (Okabe and Ito), one for each engine.
COLOURS = {
    "openrt-fast": "#E69F00",
    "openrt-watertight": "#0072B2",
    "openrt-precise": "#009E73",
    "embree": "#D55E00",
    "embree-robust": "#CC79A7",
    "moeller-trumbore": "#777777",
    "wald": "#000000",
    "woop": "#56B4E9",
}
PARETO_CASE = "H1-exact-ico5"


class Picture:
    """An SVG with one plotting area; data are mapped by the functions x and y."""

    def __init__(self, title, subtitle, width=720, height=430, left=80, right=190):
        self.width, self.height = width, height
        self.left, self.right, self.top, self.bottom = left, right, 64, 58
        self.parts = []
        self.text(left, 24, title, size=16, weight="bold")
        self.text(left, 44, subtitle, size=12, colour="#555555")

    @property
    def plot_width(self):
        return self.width - self.left - self.right

    @property
    def plot_height(self):
        return self.height - self.top - self.bottom

    def at_x(self, share):
        return self.left + share * self.plot_width

    def at_y(self, share):
        return self.height - self.bottom - share * self.plot_height

    def text(self, x, y, words, size=12, colour="#222222", anchor="start", weight="normal",
             turn=None):
        rotate = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn is not None else ""
        self.parts.append(
            f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}" '
            f'text-anchor="{anchor}" font-weight="{weight}"{rotate}>{escape(words)}</text>')

    def line(self, x1, y1, x2, y2, colour="#cccccc", width=1.0, dash=""):
        dashes = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
                          f'stroke="{colour}" stroke-width="{width}"{dashes}/>')

    def path(self, points, colour):
        places = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        self.parts.append(f'<polyline points="{places}" fill="none" stroke="{colour}" '
                          'stroke-width="2"/>')

    def dot(self, x, y, colour, hollow=False):
        fill = "#ffffff" if hollow else colour
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="{fill}" '
                          f'stroke="{colour}" stroke-width="2"/>')

    def bar(self, x, y, width, height, colour):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" '
                          f'height="{max(height, 0):.1f}" fill="{colour}"/>')

    def axis_x(self, ticks, label):
        """Ticks too near to the one before them get no words."""
        last = -math.inf
        for share, words in ticks:
            self.line(self.at_x(share), self.at_y(0), self.at_x(share), self.at_y(0) + 5, "#444444")
            if self.at_x(share) - last < 40:
                continue
            last = self.at_x(share)
            for row, part in enumerate(words.split("\n")):
                self.text(last, self.at_y(0) + 19 + 14 * row, part, anchor="middle")
        self.line(self.at_x(0), self.at_y(0), self.at_x(1), self.at_y(0), "#444444")
        self.text(self.at_x(0.5), self.height - 14, label, size=13, anchor="middle")

    def axis_y(self, ticks, label):
        for share, words in ticks:
            self.line(self.at_x(0), self.at_y(share), self.at_x(1), self.at_y(share), "#e4e4e4")
            self.text(self.at_x(0) - 8, self.at_y(share) + 4, words, anchor="end")
        self.line(self.at_x(0), self.at_y(0), self.at_x(0), self.at_y(1), "#444444")
        self.text(20, self.at_y(0.5), label, size=13, anchor="middle", turn=-90)

    def legend(self, entries):
        for row, (words, colour, hollow) in enumerate(entries):
            y = self.top + 10 + 22 * row
            self.dot(self.at_x(1) + 22, y, colour, hollow)
            self.text(self.at_x(1) + 34, y + 4, words)

    def save(self, path):
        path.write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
            f'viewBox="0 0 {self.width} {self.height}" font-family="sans-serif">\n'
            f'<rect width="{self.width}" height="{self.height}" fill="#ffffff"/>\n'
            + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")


class Logarithm:
    """Shares of a logarithmic axis whose lowest place is zero itself."""

    def __init__(self, lowest, highest):
        self.low, self.high = math.floor(math.log10(lowest)), math.ceil(math.log10(highest))
        self.high = max(self.high, self.low + 1)

    def __call__(self, value):
        if value <= 0:
            return 0.0
        return 0.12 + 0.88 * (math.log10(value) - self.low) / (self.high - self.low)

    def ticks(self):
        yield 0.0, "0"
        for power in range(self.low, self.high + 1):
            yield self(10.0 ** power), f"{10 ** power:,}" if power >= 0 else f"1e{power}"


def nice_step(largest):
    raw = largest / 5
    power = 10 ** math.floor(math.log10(raw))
    return min((f * power for f in (1, 2, 5, 10) if f * power >= raw))


def joined(files):
    report = {"cases": {}, "secondary": {}, "speed": {}, "isa": "", "embree": ""}
    for name in files:
        one = json.loads(Path(name).read_text(encoding="utf-8"))
        for case in one["cases"]:
            report["cases"][case["case"]] = case
        for entry in one["secondary"]:
            report["secondary"][entry["scene"], entry["engine"]] = entry
        for entry in one["speed"]:
            report["speed"][short(entry["scene"])] = entry
        report["isa"] = one["isa"] or report["isa"]
        report["embree"] = one["embree"] or report["embree"]
    return report


def short(scene):
    return re.sub(r"\.tri$", "", scene.rsplit("/", 1)[-1])


def per_million(engine, *columns):
    return 1e6 * sum(engine[c] for c in columns) / engine["rays"]


def engine_of(case, name):
    return next((e for e in case.get("engines", []) if e["engine"] == name), None)


def pareto(report, scene, out):
    case = report["cases"].get(PARETO_CASE)
    if not case:
        return
    points = []
    for name, nanoseconds in times_of(report["speed"][scene], "primary").items():
        kind, form = name.rsplit(" ", 1)
        errors = engine_of(case, kind)
        if errors:
            points.append((1e3 / nanoseconds, per_million(errors, "miss", "through"), kind, form))
    picture = Picture(f"Speed against lost rays: {scene}",
                      f"right and low is better; primary rays, one thread, {report['isa']}; "
                      "filled: packets and tiles, hollow: single rays")
    step = nice_step(max(p[0] for p in points) * 1.05)
    top = step * math.ceil(max(p[0] for p in points) * 1.05 / step)
    scale = Logarithm(max(1, min([p[1] for p in points if p[1] > 0] or [1])),
                      max([p[1] for p in points] + [10]))
    picture.axis_y(list(scale.ticks()), f"lost of a million rays ({PARETO_CASE})")
    picture.axis_x([(i * step / top, f"{i * step:g}") for i in range(round(top / step) + 1)],
                   "million rays a second of processor time")
    for rate, lost, kind, form in points:
        picture.dot(picture.at_x(rate / top), picture.at_y(scale(lost)), COLOURS[kind],
                    form == "single")
    picture.legend([(kind, COLOURS[kind], False)
                    for kind in dict.fromkeys(p[2] for p in points)])
    picture.save(out / f"pareto-{scene.replace(':', '-')}.svg")


def times_of(scene, kind):
    """Nanoseconds a ray, by engine."""
    return {e["engine"]: e["nanosecondsPerRay"] for e in scene["engines"] if e["kind"] == kind}


def relative_times(scene, kind):
    """Time a ray relative to the fast mode's, packets, by engine."""
    times = times_of(scene, kind)
    return {name.rsplit(" ", 1)[0]: own / times["openrt-fast packet"]
            for name, own in times.items() if name.endswith(" packet")}


def cost(report, out):
    groups = []
    for scene, entry in report["speed"].items():
        for kind in ("primary", "shadow"):
            groups.append((f"{scene}\n{kind}", relative_times(entry, kind)))
    if not groups:
        return
    picture = Picture("Time a ray relative to the fast mode",
                      f"packets, one thread, {report['isa']}; lower is better",
                      width=max(720, 300 + 105 * len(groups)))
    highest = max(max(times.values()) for _, times in groups)
    step = nice_step(highest)
    top = step * math.ceil(highest / step)
    picture.axis_y([(i * step / top, f"{i * step:g}") for i in range(round(top / step) + 1)],
                   "time relative to fast")
    slot = picture.plot_width / len(groups)
    for number, (name, times) in enumerate(groups):
        width = 0.8 * slot / len(times)
        for place, (kind, time) in enumerate(times.items()):
            x = picture.left + number * slot + 0.1 * slot + place * width
            y = picture.at_y(time / top)
            picture.bar(x, y, width - 1, picture.at_y(0) - y, COLOURS[kind])
    picture.axis_x([((i + 0.5) / len(groups), name) for i, (name, _) in enumerate(groups)], "")
    picture.line(picture.at_x(0), picture.at_y(1 / top), picture.at_x(1), picture.at_y(1 / top),
                 "#222222", 1, "4 3")
    picture.legend([(kind, COLOURS[kind], False) for kind in groups[0][1]])
    picture.save(out / "cost.svg")


def curves(report, out, name, pattern, title, label, columns, what):
    found = []
    for case in report["cases"].values():
        match = re.fullmatch(pattern, case["case"])
        if match:
            found.append((float(match.group(1)), case))
    found.sort(key=lambda pair: pair[0])
    if len(found) < 2:
        return
    low, high = math.log10(found[0][0]), math.log10(found[-1][0])
    kinds = [e["engine"] for e in found[0][1]["engines"] if e["engine"] in COLOURS]
    values = [per_million(engine_of(c, k), *columns) for _, c in found for k in kinds
              if engine_of(c, k)]
    scale = Logarithm(max(1, min([v for v in values if v > 0] or [1])), max(values + [10]))
    counts = sorted({engine_of(c, k)["rays"] for _, c in found for k in kinds if engine_of(c, k)})
    picture = Picture(title, f"{what}; {counts[0]:,} to {counts[-1]:,} rays a point"
                      if counts[0] != counts[-1] else f"{what}; {counts[0]:,} rays a point")
    picture.axis_y(list(scale.ticks()), "of a million rays")
    picture.axis_x([((math.log10(x) - low) / (high - low), f"1e{round(math.log10(x))}")
                    for x, _ in found], label)
    for kind in kinds:
        places = []
        for x, case in found:
            engine = engine_of(case, kind)
            if engine:
                value = per_million(engine, *columns)
                places.append((picture.at_x((math.log10(x) - low) / (high - low)),
                               picture.at_y(scale(value)), value))
        # Curves at zero lie on each other: they are drawn a little apart.
        shift = -2.5 * (len(kinds) - 1 - kinds.index(kind))
        places = [(x, y + (shift if value == 0 else 0), value) for x, y, value in places]
        picture.path([p[:2] for p in places], COLOURS[kind])
        for x, y, _ in places:
            picture.dot(x, y, COLOURS[kind])
    picture.legend([(kind, COLOURS[kind], False) for kind in kinds])
    picture.save(out / f"{name}.svg")


def number(value):
    if value == 0:
        return "0"
    return f"{value:,.0f}" if value >= 10 else f"{value:.3g}"


def case_order(name):
    family, rest = re.fullmatch(r"H(\d+)-(.*)", name).groups()
    return int(family), "" if family == "1" else rest


def tables(report, file):
    """Markdown: lost rays of all engines, all errors engine by engine, H9, speeds."""
    cases = sorted(report["cases"].values(), key=lambda case: case_order(case["case"]))
    kinds = list(dict.fromkeys(e["engine"] for c in cases for e in c["engines"]
                               if not e["engine"].startswith("defect-")))

    def out(*cells):
        print("| " + " | ".join(str(cell) for cell in cells) + " |", file=file)

    def head(*cells, words=1):
        out(*cells)
        print("|" + " --- |" * words + " ---: |" * (len(cells) - words), file=file)

    def title(words):
        print(f"\n## {words}\n", file=file)

    print(f"# Figures behind precision.md\n\nMade by `tests/accuracy/plot.py`; {report['isa']}"
          + (f", Embree {report['embree']}" if report["embree"] else "") + ".", file=file)
    if cases:
        title("Lost (miss + through) of a million rays")
        head("case", "rays", *kinds)
        idle = []
        for case in cases:
            engines = [engine_of(case, kind) for kind in kinds]
            if not any(e and e["lost"] for e in engines):
                idle.append(case["case"])
                continue
            out(case["case"], f"{max(e['rays'] for e in case['engines']):,}",
                *[number(per_million(e, "lost")) if e else "" for e in engines])
        print("\nEngines that ask every triangle got fewer rays. Nobody lost a ray in: "
              + ", ".join(idle) + ".", file=file)
    columns = ("slide", "early", "order", "false", "gross", "wrongPrim")
    for kind in kinds:
        title(f"{kind}: other verdicts of a million rays, and errors")
        head("case", *columns, "t max ulp", "t mean ulp", "u, v max 2^-24")
        for case in cases:
            engine = engine_of(case, kind)
            if engine and (any(engine[c] for c in columns) or engine["tMaxUlp"] > 0.5):
                out(case["case"], *[number(per_million(engine, c)) for c in columns],
                    f"{engine['tMaxUlp']:.4g}", f"{engine['tMeanUlp']:.3g}",
                    f"{engine['uvMax2e-24']:.4g}")
    if cases:
        title("The same bits in all instruction sets, packets and single rays")
        head("mode", "variants", "rays", "rays that differ")
        sums = {}
        for case in cases:
            for entry in case.get("identity", []):
                total = sums.setdefault((entry["mode"], entry["variants"]), [0, 0])
                total[0] += entry["rays"]
                total[1] += entry["differing"]
        for (mode, variants), (rays, differing) in sums.items():
            out(mode, variants, f"{rays:,}", differing)
    if report["secondary"]:
        title("H9: rays that leave a surface")
        head("scene", "engine", "rays a side", "own surface", "leaks", words=2)
        for entry in report["secondary"].values():
            if not entry["engine"].startswith("defect-"):
                out(entry["scene"], entry["engine"], f"{entry['rays']:,}", entry["acne"],
                    entry["leaks"])
    for scene, entry in report["speed"].items():
        title(f"Speed: {scene}, {entry['triangles']:,} triangles, {entry['primaryRays']:,} primary "
              f"and {entry['shadowRays']:,} shadow rays, one thread")
        head("rays", "engine", "ns a ray", "relative to openrt-fast packet", words=2)
        for kind in ("primary", "shadow"):
            times = times_of(entry, kind)
            for name, own in times.items():
                out(kind, name, f"{own:.0f}", f"{own / times['openrt-fast packet']:.2f}")
        rays = entry["primaryRays"]
        share = entry["doubleTests"] / max(16 * entry["triangleTestsOfPackets"], 1)
        print(f"\nPrecise mode, primary rays: {entry['doubleTests'] / rays:.5f} tests a ray are "
              f"repeated in double ({share:.1e} of all lanes of all tests), "
              f"{entry['exactTests'] / rays:.7f} a ray reach exact arithmetic.", file=file)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("reports", nargs="+")
    parser.add_argument("--out", type=Path, required=True, help="folder for the pictures")
    parser.add_argument("--tables", type=Path, help="also write Markdown tables to this file")
    arguments = parser.parse_args()
    report = joined(arguments.reports)
    arguments.out.mkdir(parents=True, exist_ok=True)
    for scene in report["speed"]:
        pareto(report, scene, arguments.out)
    cost(report, arguments.out)
    lost = ("miss", "through")
    wrong = ("miss", "through", "slide", "early", "order", "false", "gross")
    curves(report, arguments.out, "scale", r"H1-scale(1e-?\d+)", "Lost rays against scale",
           "scale of the sphere", lost, "rays at vertices and edges of a sphere")
    curves(report, arguments.out, "offset", r"H1-off(1e\d+)", "Lost rays against offset",
           "distance from the origin, in radii", lost, "rays at vertices and edges of a sphere")
    curves(report, arguments.out, "aspect", r"H1-needle(1e\d+)", "Wrong answers against aspect",
           "length of the stretched sphere, in widths", wrong,
           "lost, slid, early, behind, false or gross")
    if arguments.tables:
        with arguments.tables.open("w", encoding="utf-8") as file:
            tables(report, file)
    return 0


if __name__ == "__main__":
    sys.exit(main())
