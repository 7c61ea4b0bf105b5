#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the tables and plots of docs/performance.md from what openrt-bench wrote with --json.

Tables go between lines "<!-- table NAME -->" and "<!-- end -->" of the text, plots to a folder as
SVG. Files are told apart by what is in them; several runs of one scene are averaged by median.
"""
import argparse
import json
import math
import pathlib
import re
import statistics

KINDS = ["primary", "shadow", "ao", "bounce"]
GOALS = {"primary": 2.0, "shadow": 1.5, "ao": 1.1, "bounce": 1.1}
# Read and written by the public query: a ray, and t and the triangle or one flag.
BYTES = {"primary": 40, "shadow": 33, "ao": 33, "bounce": 40}
# Of a node, sixteen boxes of six planes each, and of a triangle: the operations of a ray that meets
# it, divisions among them, and the bytes that are read.
FLOP = {"nodes": 16 * 6 * 2, "triangles": 40}
TREE_BYTES = {"nodes": 448, "triangles": 40}
PACKET = 16  # rays
COLOURS = ["#4477aa", "#ee6677", "#228833", "#ccbb44"]


def scene_name(run):
    return pathlib.Path(run["scene"]).stem


def ours(series, form):
    """The engine of ours whose name has that form; None if there is none."""
    for engine in series.get("engines", []):
        if not engine["peer"] and re.match(rf"openrt {form} \w+$", engine["engine"]):
            return engine
    return None


def public_form(kind):
    return "stream" if kind in ("primary", "shadow") else "stream incoherent"


def series_of(runs, scene, kind, threads, isa=None, precision="watertight"):
    return [series for run in runs for series in run.get("series", [])
            if scene_name(run) == scene and series["kind"] == kind and series["threads"] == threads
            and run["precision"] == precision and (isa is None or run["isa"] == isa)]


def median_of(series_list, form, key):
    values = [engine[key] for series in series_list
              if (engine := ours(series, form)) and key in engine]
    return statistics.median(values) if values else None


def number(value, digits=2):
    return "-" if value is None else f"{value:.{digits}f}"


def spread(series_list, form):
    values = [rate for series in series_list if (engine := ours(series, form))
              for rate in engine.get("repeats", [])]
    return "-" if not values else f"{min(values):.1f} to {max(values):.1f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + " --- |" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


class Runs:
    """What is in the files, by kind of run."""

    def __init__(self, files):
        loaded = [json.loads(file.read_text()) for file in files]
        self.rays = [run for run in loaded if "series" in run]
        self.scales = [run for run in loaded if "byTriangles" in run]
        self.cases = [run for run in loaded if "cases" in run]
        self.builds = [run for run in loaded if "builders" in run]
        self.frames = [run for run in loaded if "frames" in run]
        self.scenes = sorted({scene_name(run) for run in self.rays},
                             key=lambda name: next(run["triangles"] for run in self.rays
                                                   if scene_name(run) == name))
        self.best_isa = max((run["isa"] for run in self.rays), default="",
                            key=["", "generic", "neon", "sse4", "avx2", "avx512"].index)

    def machine(self):
        """One line a machine."""
        lines = []
        for run in self.rays + self.scales + self.cases:
            machine = run["machine"]
            caches = [f"{size // 1024} KiB" for size in machine.get("cacheBytes", []) if size > 0]
            line = (f"{machine['processor']} (family {machine['family']}, model "
                    f"{machine['model']}), {machine['cores']} cores, caches {', '.join(caches)}, "
                    f"compiler {machine['compiler']}")
            if line not in lines:
                lines.append(line)
        loads = [run["machine"]["load"][0] for run in self.rays + self.scales + self.cases
                 if "load" in run["machine"]]
        if loads:
            lines.append(f"Load while measuring: {min(loads):.1f} to {max(loads):.1f}.")
        return "\n".join(lines)

    def ratios(self, form_of):
        rows = []
        for scene in self.scenes:
            for kind in KINDS:
                runs = series_of(self.rays, scene, kind, 1, self.best_isa)
                form = form_of(kind)
                value = median_of(runs, form, "ofBestPeer")
                if not runs or value is None:
                    continue
                peers = {series.get("bestPeer", "-").replace("embree ", "") for series in runs}
                rows.append([scene, kind, number(GOALS[kind], 1), number(value),
                             "yes" if value >= GOALS[kind] else "no",
                             number(median_of(runs, form, "ofBestRobustPeer")),
                             number(median_of(runs, form, "mraysPerSecond"), 1),
                             spread(runs, form), ", ".join(sorted(peers))])
        return table(["scene", "rays", "goal", "of Embree's best", "reached", "of its best ROBUST",
                      "Mrays/s", "spread", "Embree's best form"], rows)

    def forms(self):
        rows = []
        for scene in self.scenes:
            for kind in KINDS:
                runs = series_of(self.rays, scene, kind, 1, self.best_isa)
                if not runs:
                    continue
                tiles = "tile" if kind in ("primary", "shadow") else None
                rows.append([scene, kind] + [
                    number(median_of(runs, form, "ofBestPeer")) if form else "-"
                    for form in (public_form(kind), tiles, "packet", "single")])
        return table(["scene", "rays", "public query", "tiles", "packets", "single"], rows)

    def threads(self):
        rows = []
        for scene in self.scenes:
            for kind in KINDS:
                many = [series for run in self.rays for series in run["series"]
                        if scene_name(run) == scene and series["kind"] == kind
                        and series["threads"] > 1 and run["isa"] == self.best_isa]
                factor = median_of(many, public_form(kind), "ofOneThread")
                if factor is None:
                    continue
                peers = [engine["ofOneThread"] for series in many for engine in series["engines"]
                         if engine["peer"] and engine["engine"] == series.get("bestPeer")
                         and "ofOneThread" in engine]
                rows.append([scene, kind, many[0]["threads"], number(factor),
                             number(statistics.median(peers) if peers else None)])
        return table(["scene", "rays", "threads", "times one thread", "Embree"], rows)

    def isas(self):
        rows = []
        for isa in ("avx2", "sse4", "generic"):
            for scene in self.scenes:
                cells = []
                for kind in KINDS:
                    runs = series_of(self.rays, scene, kind, 1, isa)
                    cells.append(number(median_of(runs, public_form(kind), "ofBestPeer")))
                if isa != self.best_isa and any(cell != "-" for cell in cells):
                    rows.append([isa, scene] + cells)
        return table(["instruction set, Embree limited likewise", "scene"] + KINDS, rows)

    def precisions(self):
        rows = []
        for scene in self.scenes:
            for kind in KINDS:
                rates = [median_of(series_of(self.rays, scene, kind, 1, self.best_isa, precision),
                                   public_form(kind), "mraysPerSecond")
                         for precision in ("fast", "watertight", "precise")]
                if rates[1] and (rates[0] or rates[2]):
                    rows.append([scene, kind] + [
                        number(rate / rates[1]) if rate else "-" for rate in rates])
        return table(["scene", "rays", "fast", "watertight", "precise"], rows)

    def best_limits(self):
        limits = [run["limits"] for run in self.rays if "limits" in run]
        return {key: max(one[key] for one in limits) for key in limits[0]} if limits else None

    def limits(self):
        """What rays do in the tree, and the share of what the machine can do that this is."""
        best = self.best_limits()
        rows = []
        for scene in self.scenes:
            for run in self.rays:
                if (scene_name(run) != scene or run["isa"] != self.best_isa
                        or run["precision"] != "watertight" or "limits" not in run):
                    continue
                for count in run.get("counts", []):
                    kind = count["kind"]
                    series = [one for one in run["series"]
                              if one["kind"] == kind and one["threads"] == 1]
                    rate = median_of(series, public_form(kind), "mraysPerSecond")
                    if not rate:
                        continue
                    alone, packet = count["aRayAlone"], count["aPacket"]
                    flop = sum(FLOP[what] * alone[what] for what in FLOP)
                    tree = sum(TREE_BYTES[what] * packet[what] for what in TREE_BYTES) / PACKET

                    def share(each, limit):
                        return f"{rate * each / (best[limit] * 1e3):.0%}"

                    rows.append([
                        scene, kind, number(best["clockGHz"] * 1e3 / rate, 0),
                        number(alone["nodes"], 1), number(alone["triangles"], 1), number(flop, 0),
                        share(flop, "gigaflops"), number(packet["nodes"], 1),
                        number(packet["triangles"], 1), number(BYTES[kind] + tree, 0),
                        share(BYTES[kind] + tree, "cacheGBs"), share(BYTES[kind], "memoryGBs")])
        return table(["scene", "rays", "cycles a ray", "nodes, a ray alone", "triangles", "FLOP",
                      "of arithmetic's rate", "nodes, a packet", "triangles", "bytes a ray",
                      "of the cache's rate", "rays and hits, of memory's rate"], rows)

    def machine_limits(self):
        best = self.best_limits()
        if not best:
            return "-"
        return (f"One thread: {best['clockGHz']:.2f} GHz, {best['gigaflops']:.0f} GFLOP/s, "
                f"{best['cacheGBs']:.0f} GB/s in the second-level cache, "
                f"{best['memoryGBs']:.1f} GB/s in memory.")

    def growth(self):
        rows = []
        for run in self.scales:
            for name, title in (("frame", "frame"), ("primary", "primary rays"),
                                ("embreePrimary", "Embree, primary rays"),
                                ("shadow", "shadow rays"),
                                ("embreeShadow", "Embree, shadow rays")):
                if run["growth"].get(name):
                    rows.append([title, number(run["growth"][name]["millisecondsADoubling"]),
                                 number(run["growth"][name]["power"])])
        return table(["what", "ms a doubling of the triangles", "power of the triangles"], rows)

    def sizes(self):
        rows = []
        for run in self.scales:
            for point in run["byTriangles"] + run["byPixels"]:
                pixels = point["size"] ** 2
                rows.append([f"{point['triangles']:,}", f"{point['size']}^2"] + [
                    number(point[key] * 1e6 / pixels, 1) if point[key] else "-"
                    for key in ("frameMs", "primaryMs", "embreePrimaryMs", "shadowMs",
                                "embreeShadowMs")])
        return table(["triangles", "pixels", "frame", "primary", "Embree", "shadow", "Embree"],
                     rows)

    def case_table(self):
        rows = []
        for run in self.cases:
            for case in run["cases"]:
                forms = {form["form"]: form for form in case["forms"]}
                cells = [case["case"], case["query"],
                         number(forms["single"]["nanosecondsPerRay"], 0)]
                for name in ("packet", "tile", "query coherent", "query incoherent"):
                    form = forms.get(name)
                    text = number(form["ofSingle"]) if form else "-"
                    cells.append(f"**{text}**" if form and form["tooSlow"] else text)
                rows.append(cells)
        return table(["case", "query", "single, ns a ray", "packets", "tiles", "coherent query",
                      "incoherent query"], rows)

    def build_table(self):
        rows = []
        for run in sorted(self.builds, key=lambda run: run["triangles"]):
            for builder in run["builders"]:
                seconds = [builder["build_seconds"].get(threads) for threads in ("1", "2")]
                rates = builder.get("mrays_per_second", {})
                rows.append([scene_name(run), builder["builder"]] + [
                    number(1e3 * value if value else None, 0) for value in seconds] + [
                    number(run["triangles"] / seconds[0] / 1e6),
                    number(builder["bytes"] / run["triangles"], 0),
                    number(rates.get("primary"), 1), number(rates.get("random"))])
        return table(["scene", "builder", "ms, one thread", "ms, two", "M triangles/s, one thread",
                      "bytes a triangle", "primary, Mrays/s", "random rays, Mrays/s"], rows)

    def build_ratios(self):
        """Our builders beside those of Embree's of the same kind, and beside each other."""
        rows = []
        for run in sorted(self.builds, key=lambda run: run["triangles"]):
            of = {builder["builder"]: builder for builder in run["builders"]}
            if "embree high" not in of:
                continue

            def build(ours, peer):
                return number(of[peer]["build_seconds"]["1"] / of[ours]["build_seconds"]["1"])

            def trace(one, other, rays):
                rates = [of[name].get("mrays_per_second", {}).get(rays) for name in (one, other)]
                return number(rates[0] / rates[1] if all(rates) else None)

            exact, best, binned = "kd-tree, exact", "wide, spatial splits", "wide, binned"
            rows.append([scene_name(run), build(best, "embree high"),
                         build(binned, "embree medium"), build("wide, fast", "embree low"),
                         build("wide, refit", "embree refit")] + [
                             trace(one, other, rays) for one, other in
                             ((best, exact), (binned, exact), (binned, best))
                             for rays in ("primary", "random")])
        return table(["scene", "spatial, speed of HIGH's build", "binned, of MEDIUM's",
                      "fast, of LOW's", "refit, of Embree's", "primary rays: spatial over exact SAH",
                      "random", "primary: binned over exact SAH", "random",
                      "primary: binned over spatial", "random"], rows)

    def frame_table(self):
        rows = []
        for run in self.frames:
            for frame in run["frames"]:
                if "packets, fixed" not in frame["ways"]:
                    continue
                rows.append([scene_name(run), frame["surface"], frame["threads"]] + [
                    number(seconds * 1e9 / frame["pixels"], 1) for seconds in
                    (frame["aloneSeconds"], frame["cameraSeconds"],
                     frame["ways"]["packets, fixed"])] + [
                    number(frame["ways"]["packets, fixed"] / frame["aloneSeconds"])])
        return table(["scene", "surface", "threads", "rays alone, ns a pixel",
                      "camera rays made and traced", "frame", "frame over rays alone"], rows)

    def tables(self):
        return {"machine": self.machine(), "ratios": self.ratios(public_form),
                "forms": self.forms(), "threads": self.threads(), "isas": self.isas(),
                "precisions": self.precisions(), "limits": self.limits(),
                "machine-limits": self.machine_limits(), "growth": self.growth(), "sizes": self.sizes(),
                "cases": self.case_table(), "builds": self.build_table(),
                "build-ratios": self.build_ratios(), "frames": self.frame_table()}


class Svg:
    """A plot: axes, bars and lines, in plain SVG."""

    def __init__(self, title, width=760, height=360):
        self.width, self.height = width, height
        self.left, self.right, self.top, self.bottom = 60, 20, 60, 50
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'font-family="sans-serif" font-size="12">',
            f'<rect width="{width}" height="{height}" fill="white"/>']
        self.text(width / 2, 22, title, anchor="middle", size=15)

    def text(self, x, y, text, anchor="start", size=12):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" '
                          f'font-size="{size}">{text}</text>')

    def line(self, x1, y1, x2, y2, colour="#bbbbbb", width=1, dash=""):
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" '
                          f'stroke="{colour}" stroke-width="{width}" stroke-dasharray="{dash}"/>')

    def bar(self, x, y, width, height, colour):
        self.parts.append(f'<rect x="{x:.1f}" y="{y:.1f}" width="{width:.1f}" '
                          f'height="{height:.1f}" fill="{colour}"/>')

    def dot(self, x, y, colour):
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>')

    def legend(self, entries):
        x = self.left
        for name, colour in entries:
            self.bar(x, 34, 12, 12, colour)
            self.text(x + 17, 44, name)
            x += 27 + 7 * len(name)

    def y(self, share):
        return self.height - self.bottom - share * (self.height - self.top - self.bottom)

    def write(self, file):
        file.write_text("\n".join(self.parts + ["</svg>"]) + "\n")


def plot_ratios(runs, file):
    plot = Svg("Rays a second, times Embree's best (public query, one thread)")
    values = {(scene, kind): median_of(series_of(runs.rays, scene, kind, 1, runs.best_isa),
                                       public_form(kind), "ofBestPeer")
              for scene in runs.scenes for kind in KINDS}
    top = max([2.2] + [value for value in values.values() if value]) * 1.05
    for tick in range(0, int(top / 0.5) + 1):
        y = plot.y(tick * 0.5 / top)
        plot.line(plot.left, y, plot.width - plot.right, y,
                  "#444444" if tick == 2 else "#dddddd")
        plot.text(plot.left - 8, y + 4, f"{tick * 0.5:.1f}", "end")
    group = (plot.width - plot.left - plot.right) / max(len(runs.scenes), 1)
    for i, scene in enumerate(runs.scenes):
        for j, kind in enumerate(KINDS):
            x = plot.left + group * (i + 0.1 + 0.2 * j)
            value = values[scene, kind]
            if value:
                y = plot.y(value / top)
                plot.bar(x, y, group * 0.17, plot.height - plot.bottom - y, COLOURS[j])
            goal = plot.y(GOALS[kind] / top)
            plot.line(x, goal, x + group * 0.17, goal, "#000000", 2)
        plot.text(plot.left + group * (i + 0.5), plot.height - plot.bottom + 18, scene, "middle")
    plot.legend([(kind, COLOURS[j]) for j, kind in enumerate(KINDS)] + [("goal", "#000000")])
    plot.write(file)


def plot_limits(runs, file):
    """Cycles a ray over what a ray alone would do, both logarithmic."""
    best, points = runs.best_limits(), []
    for run in runs.rays:
        if run["isa"] != runs.best_isa or run["precision"] != "watertight":
            continue
        for count in run.get("counts", []):
            series = [one for one in run["series"]
                      if one["kind"] == count["kind"] and one["threads"] == 1]
            rate = median_of(series, public_form(count["kind"]), "mraysPerSecond")
            if rate:
                alone = count["aRayAlone"]
                points.append((alone["nodes"] + alone["triangles"],
                               best["clockGHz"] * 1e3 / rate, count["kind"],
                               scene_name(run)))
    if not points:
        return
    plot = Svg("Cycles a ray (public query) over what a ray alone looks at")
    x0, x1 = (math.log2(f(p[0] for p in points)) + d for f, d in ((min, -0.3), (max, 0.7)))
    y0, y1 = (math.log2(f(p[1] for p in points)) + d for f, d in ((min, -0.5), (max, 0.5)))
    right = plot.width - plot.right - plot.left

    def place(steps, cycles):
        return (plot.left + right * (math.log2(steps) - x0) / (x1 - x0),
                plot.y((math.log2(cycles) - y0) / (y1 - y0)))

    for power in range(math.ceil(y0), math.floor(y1) + 1):
        y = place(2 ** x0, 2 ** power)[1]
        plot.line(plot.left, y, plot.width - plot.right, y, "#dddddd")
        plot.text(plot.left - 8, y + 4, f"{2 ** power}", "end")
    for power in range(math.ceil(x0), math.floor(x1) + 1):
        plot.text(place(2 ** power, 2 ** y0)[0], plot.height - plot.bottom + 18, f"{2 ** power}",
                  "middle")
    for cycles, name in ((8, "8 cycles a node or triangle"),
                         (1, "1 cycle a node or triangle")):
        low, high = (max(2 ** x0, 2 ** y0 / cycles), min(2 ** x1, 2 ** y1 / cycles))
        if low < high:
            plot.line(*place(low, low * cycles), *place(high, high * cycles), "#888888", 1, "5 4")
            x, y = place(high, high * cycles)
            plot.text(x - 6, y + 14, name, "end", 11)
    for steps, cycles, kind, scene in points:
        x, y = place(steps, cycles)
        plot.dot(x, y, COLOURS[KINDS.index(kind)])
        plot.text(x + 6, y + 4, scene, size=10)
    plot.text(plot.width / 2, plot.height - 10, "nodes and triangles of a ray alone", "middle")
    plot.legend([(kind, COLOURS[j]) for j, kind in enumerate(KINDS)])
    plot.write(file)


def plot_lines(title, file, points, x_key, lines, per_pixel, x_title):
    """Nanoseconds a pixel over a logarithmic axis."""
    plot = Svg(title)
    xs = [math.log2(point[x_key]) for point in points]
    values = {name: [point[key] * 1e6 / point["size"] ** 2 for point in points]
              for name, key in lines if all(point[key] > 0 for point in points)}
    if not values or max(xs) == min(xs):
        return
    top = max(max(line) for line in values.values()) * 1.1
    right = plot.width - plot.right - plot.left
    for tick in range(6):
        y = plot.y(tick / 5)
        plot.line(plot.left, y, plot.width - plot.right, y, "#dddddd")
        plot.text(plot.left - 8, y + 4, f"{top * tick / 5:.0f}", "end")
    for point, x in zip(points, xs):
        at = plot.left + right * (x - min(xs)) / (max(xs) - min(xs))
        label = f"{point[x_key]:,}"
        plot.text(at, plot.height - plot.bottom + 18, label, "middle", 10)
    plot.text(plot.width / 2, plot.height - 10, x_title + "; " + per_pixel, "middle")
    for (name, line), colour in zip(values.items(), COLOURS):
        places = [(plot.left + right * (x - min(xs)) / (max(xs) - min(xs)), plot.y(value / top))
                  for x, value in zip(xs, line)]
        for (x1, y1), (x2, y2) in zip(places, places[1:]):
            plot.line(x1, y1, x2, y2, colour, 2)
        for x, y in places:
            plot.dot(x, y, colour)
    plot.legend(list(zip(values, COLOURS)))
    plot.write(file)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("files", nargs="+", type=pathlib.Path, help="from openrt-bench --json")
    parser.add_argument("--text", type=pathlib.Path, help="the text whose tables are replaced")
    parser.add_argument("--plots", type=pathlib.Path, help="the folder for plots")
    options = parser.parse_args()

    runs = Runs(options.files)
    tables = runs.tables()
    if options.text:
        text = options.text.read_text()
        for name, body in tables.items():
            told = body.count("\n") >= 2 if body.startswith("|") else len(body) > 1
            if not told:  # these files do not tell, and the text keeps its own
                continue
            text = re.sub(rf"(<!-- table {name} -->\n).*?(<!-- end -->)",
                          lambda match, body=body: match[1] + body + "\n" + match[2], text,
                          flags=re.S)
        options.text.write_text(text)
    else:
        for name, body in tables.items():
            print(f"{name}\n\n{body}\n")
    if options.plots:
        options.plots.mkdir(parents=True, exist_ok=True)
        if runs.scenes:
            plot_ratios(runs, options.plots / "ratios.svg")
            plot_limits(runs, options.plots / "limits.svg")
        lines = [("frame", "frameMs"), ("primary", "primaryMs"),
                 ("Embree, primary", "embreePrimaryMs"), ("shadow", "shadowMs")]
        for run in runs.scales:
            plot_lines("Time against triangles", options.plots / "triangles.svg",
                       run["byTriangles"], "triangles", lines, "nanoseconds a pixel", "triangles")
            plot_lines("Time against pixels", options.plots / "pixels.svg", run["byPixels"],
                       "size", lines, "nanoseconds a pixel", "width and height in pixels")


if __name__ == "__main__":
    main()
