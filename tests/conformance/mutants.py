#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Does openrt-conformance notice defects? Plants them one by one and tells which it did not notice.

Works in a copy of the sources: for each mutant it changes one place, builds libOpenRT alone and
runs `openrt-conformance --quick --fail-fast --library` on it. Named mutants are typical mistakes;
mechanical ones change an operator, a sign, an index or a constant somewhere in the code that gives
the calls of OpenGL their meaning, drawn with a fixed seed. A mutant that does not compile is drawn
again. Exit status 1 if a named one survives.

    mutants.py --build BUILD                            the named ones
    mutants.py --build BUILD --mechanical 40 --seed 1   forty others
    mutants.py --build BUILD --only wrong_fog           one by its name
"""
import argparse
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys

from mutations import NAMED, mechanical

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHILD_SECONDS = 60  # for one program; a mutant may never end


def copy_tree(work):
    """The tracked files as they are now, renewed where they differ: only those are built again."""
    tree = work / ROOT.name  # a compiler cache with relative paths knows it by this name
    names = subprocess.run(["git", "ls-files", "-z", "-c", "-o", "--exclude-standard"], cwd=ROOT,
                           check=True, capture_output=True).stdout.decode().split("\0")
    for name in filter(None, names):
        source, target = ROOT / name, tree / name
        if not source.is_file():
            continue
        data = source.read_bytes()
        if not target.is_file() or target.read_bytes() != data:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
            shutil.copymode(source, target)
    return tree


class Laboratory:
    """A build of the copy, and the conformance program of another, sound build."""

    def __init__(self, work, build, jobs):
        self.tree, self.work, self.jobs = copy_tree(work), work / "build", jobs
        self.conformance = build / "bin" / "openrt-conformance"
        self.pictures = work / "opengl-pictures"  # of this run's ports
        shutil.rmtree(self.pictures, ignore_errors=True)
        launcher = [f"-DCMAKE_{language}_COMPILER_LAUNCHER=ccache" for language in ("C", "CXX")
                    if shutil.which("ccache")]
        subprocess.run(["cmake", "-S", self.tree, "-B", self.work, "-G", "Ninja",
                        "-DCMAKE_BUILD_TYPE=Release", "-DOPENRT_BUILD_TESTS=OFF",
                        "-DOPENRT_BUILD_SAMPLES=OFF", *launcher],
                       check=True, stdout=subprocess.DEVNULL)

    def build(self):
        return subprocess.run(["ninja", "-C", self.work, f"-j{self.jobs}", "OpenRT"],
                              stdout=subprocess.DEVNULL).returncode == 0

    def verdict(self):
        """(True, what failed first) if the library fails, (False, "") if it passes."""
        run = subprocess.run([self.conformance, "--quick", "--fail-fast", "--library",
                              self.work / "lib" / "libOpenRT.so", "--seconds", str(CHILD_SECONDS),
                              "--opengl-pictures", self.pictures],
                             capture_output=True, text=True, errors="replace")
        if run.returncode == 0:
            return False, ""
        failed = [line for line in run.stdout.splitlines() if line.startswith("FAILED")]
        return True, failed[0][7:] if failed else run.stderr.strip()[-200:]

    def judge(self, mutant):
        """"caught", "survived" or "does not compile", and by what."""
        path = self.tree / mutant.file
        sound = path.read_text(encoding="utf-8")
        path.write_text(mutant.apply(sound), encoding="utf-8")
        try:
            if not self.build():
                return "does not compile", ""
            caught, by = self.verdict()
            return ("caught" if caught else "survived"), by
        finally:
            path.write_text(sound, encoding="utf-8")


def draw(count, seed, tree):
    """Mechanical mutants without end, for those that do not compile are drawn again."""
    candidates = mechanical(tree)
    random.Random(seed).shuffle(candidates)
    return candidates[:4 * count]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=pathlib.Path, required=True,
                        help="build folder with openrt-conformance and the ports")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("/tmp/openrt-mutants"))
    parser.add_argument("--mechanical", type=int, default=0, metavar="N")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="named mutants whose name matches this expression")
    parser.add_argument("--json", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()

    laboratory = Laboratory(arguments.work, arguments.build.resolve(), arguments.jobs)
    if not laboratory.build():
        sys.exit("the sources as they are do not build")
    sound_fails, by = laboratory.verdict()
    if sound_fails:
        sys.exit(f"the library as it is fails already: {by}")

    named = not arguments.mechanical
    mutants = ([m for m in NAMED if re.search(arguments.only or "", m.name)] if named
               else draw(arguments.mechanical, arguments.seed, laboratory.tree))
    wanted = len(mutants) if named else arguments.mechanical
    results = []
    for mutant in mutants:
        verdict, by = laboratory.judge(mutant)
        if verdict == "does not compile" and not named:
            continue
        results.append({"name": mutant.name, "file": mutant.file, "verdict": verdict, "by": by})
        print(f"{verdict:16} {mutant.name} {by}", flush=True)
        if len(results) == wanted:
            break
    survivors = [r for r in results if r["verdict"] != "caught"]
    print(f"{len(results) - len(survivors)} of {len(results)} caught")
    if arguments.json:
        arguments.json.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")
    return 1 if named and survivors else 0


if __name__ == "__main__":
    sys.exit(main())
