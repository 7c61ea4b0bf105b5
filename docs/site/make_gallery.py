#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes docs/gallery.md and its pictures: each sample program with what it says of itself, the command
that made the picture, and how long that took.

    docs/site/make_gallery.py BUILD
"""
import pathlib
import re
import resource
import shlex
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE, PICTURES = ROOT / "docs/gallery.md", ROOT / "docs/pictures/gallery"
SIZE = "320x240"


def about(source):
    """The first comment behind the licence, without the program's name."""
    text = source.read_text(encoding="utf-8").split("\n", 1)[1]
    comment = re.match(r"(?:/\*(.*?)\*/|((?://[^\n]*\n)+))", text, re.DOTALL)
    words = re.sub(r"\s*\n\s*(\*|//)?\s*", " ", (comment.group(1) or comment.group(2))).strip(" /")
    words = re.sub(rf"^{source.stem}: ", "", words)
    words = words.split(" Usage:")[0]
    return words[0].upper() + words[1:]


def samples():
    """(source, words of the command)"""
    for source in sorted((ROOT / "samples/ports").glob("*.c")):
        size = ["--rt-size", SIZE] if source.stem.startswith("rt_") else ["-geometry", SIZE]
        yield source, [f"bin/ports/{source.stem}", *size, "--rt-offscreen", "1", "--rt-output",
                       f"{source.stem}%d.png"]
    for source in sorted((ROOT / "samples/tour").glob("0[1-9]_*.c*")):
        yield source, [f"bin/{source.stem}", f"{source.stem}.png"]
    for source in sorted((ROOT / "samples/changing").glob("*.c")):
        yield source, [f"bin/changing/{source.stem}", "--rt-size", SIZE, "--rt-offscreen", "1",
                       "--rt-output", f"{source.stem}%d.png"]


def picture_of(build, source, words, folder):
    """(the picture, or None, and the seconds of processor time that it took)"""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    result = subprocess.run([str(build / words[0]), *words[1:]], cwd=folder, capture_output=True,
                            timeout=120, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    made = sorted(folder.glob(f"{source.stem}*.png"))
    if result.returncode != 0 or not made:
        print(f"{source.stem}: no picture", file=sys.stderr)
        return None, seconds
    return made[0], seconds


def section(source, words, seconds):
    path = source.relative_to(ROOT)
    lines = len(source.read_text(encoding="utf-8").splitlines())
    return [f"## {source.stem}", "", f"![{source.stem}](pictures/gallery/{source.stem}.png)", "",
            f"{about(source)}", "",
            f"[{path}](../{path}), {lines} lines; the whole program takes {seconds:.2f} s of "
            "processor time.", "",
            "```sh", shlex.join(words), "```", ""]


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    PICTURES.mkdir(parents=True, exist_ok=True)
    text = ["# Gallery", "",
            "The sample programs, each with its source and the command, in a build tree, that makes "
            "the picture. Seconds are those of all cores of the machine on which this page was made, "
            "by `docs/site/make_gallery.py`; they include the start of the process and writing the "
            "file.", "",
            "Built-in and sample shaders have pictures in [built-in shaders](builtin-shaders.md) and "
            "[shaders](shaders.md), scenes that move in [changing scenes](changing-scenes.md).", ""]
    with tempfile.TemporaryDirectory() as name:
        for source, words in samples():
            picture, seconds = picture_of(build, source, words, pathlib.Path(name))
            if picture:
                (PICTURES / f"{source.stem}.png").write_bytes(picture.read_bytes())
                text += section(source, words, seconds)
    wrapped = (textwrap.fill(line, 100, break_on_hyphens=False, break_long_words=False)
               if line and line[0] not in "!#`[b" else line for line in text)
    PAGE.write_text("\n".join(wrapped).rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
