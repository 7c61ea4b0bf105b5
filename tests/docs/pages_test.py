#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the pages say of files and programs is so: links lead somewhere, every option shown exists,
and the commands of the first page work.

usage: pages_test.py BUILD_DIR [unittest arguments]
"""
import functools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from pages import PAGES, ROOT, broken_links, commands

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()


def program(name):
    found = BUILD / "bin" / name
    return found if found.exists() else None


@functools.cache
def help_of(name, *subcommand):
    return subprocess.run([program(name), *subcommand, "--help"], capture_output=True,
                          text=True).stdout


def options(name, arguments):
    """The options that --help tells of, those of the subcommand included."""
    text = help_of(name)
    words = [a for a in arguments if not a.startswith("-")]
    if words and re.search(rf"^  {re.escape(words[0])}\b", text, flags=re.MULTILINE):
        text += help_of(name, words[0])
    return set(re.findall(r"(?<![\w-])(--?[a-zA-Z][\w-]*)", text))


def calls(text):
    """(program, arguments) of each of the project's programs in the commands of a page."""
    for command in commands(text):
        for part in re.split(r"&&|\||;", command):
            words = part.split()
            while words and ("=" in words[0] or words[0] in ("env", "time")):
                words.pop(0)
            if words and pathlib.Path(words[0]).name.startswith("openrt-"):
                yield pathlib.Path(words[0]).name, words[1:]


def unknown_options(text):
    return [f"{name} {word}" for name, arguments in calls(text) if program(name)
            for word in arguments
            if word.startswith("--") and word.split("=")[0] not in options(name, arguments)]


class Pages(unittest.TestCase):
    def test_links_lead_somewhere(self):
        for page in PAGES:
            with self.subTest(page=str(page.relative_to(ROOT))):
                self.assertEqual(broken_links(page, page.read_text(encoding="utf-8")), [])

    def test_options_exist(self):
        for page in PAGES:
            with self.subTest(page=str(page.relative_to(ROOT))):
                self.assertEqual(unknown_options(page.read_text(encoding="utf-8")), [])

    def test_programs_exist(self):
        names = {name for page in PAGES for name, _ in calls(page.read_text(encoding="utf-8"))}
        self.assertIn("openrt-render", names)
        built = (BUILD / "bin/openrt-render").exists()
        if not built:
            self.skipTest("the programs were not built")
        self.assertEqual([name for name in sorted(names) if not program(name)], [])


def samples_without_a_place(gallery):
    """Sample programs that the gallery does not show with picture, source and command."""
    sources = [path for folder in ("ports", "tour", "changing")
               for path in sorted((ROOT / "samples" / folder).glob("*.c*"))
               if path.suffix in (".c", ".cpp")]
    found = []
    for path in sources:
        section = re.search(rf"^## {path.stem}\n(.*?)(?=^## |\Z)", gallery,
                            re.DOTALL | re.MULTILINE)
        shown = section and f"({path.stem}.png)" in section[1].replace("pictures/gallery/", "")
        if not shown or f"(../{path.relative_to(ROOT)})" not in section[1] or \
                "```sh\nbin/" not in section[1]:
            found.append(path.stem)
    return found


class Gallery(unittest.TestCase):
    def test_every_sample(self):
        text = (ROOT / "docs/gallery.md").read_text(encoding="utf-8")
        self.assertEqual(samples_without_a_place(text), [])

    def test_control(self):
        text = (ROOT / "docs/gallery.md").read_text(encoding="utf-8")
        self.assertEqual(samples_without_a_place(text.replace("## gears\n", "## wheels\n")),
                         ["gears"])
        self.assertEqual(samples_without_a_place(text.replace("gears.png", "nothing.png")),
                         ["gears"])


class FirstPage(unittest.TestCase):
    """The commands of README.md, in a folder that looks like a checkout with a scene in it."""

    # What continuous integration itself does, and what needs a display.
    ELSEWHERE = (r"\./demo$", r"\./check( --\w+)?$", r"cmake ", r".*openrt-view ")

    def test_commands_work(self):
        if not program("openrt-render"):
            self.skipTest("the programs were not built")
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "build").mkdir()
            (folder / "build/release").symlink_to(BUILD)
            shutil.copy(ROOT / "samples/models/courtyard.glb", folder / "scene.glb")
            ran = 0
            for command in commands((ROOT / "README.md").read_text(encoding="utf-8")):
                if any(re.match(pattern, command) for pattern in self.ELSEWHERE):
                    continue
                with self.subTest(command=command):
                    result = subprocess.run(["bash", "-c", command], cwd=folder, text=True,
                                            capture_output=True, env={**os.environ})
                    self.assertEqual(result.returncode, 0, result.stderr)
                    ran += 1
            self.assertGreater(ran, 0)
            self.assertTrue((folder / "picture.png").stat().st_size > 10000)


class Controls(unittest.TestCase):
    """The checks find what is planted."""

    def test_links(self):
        page = ROOT / "README.md"
        self.assertEqual(broken_links(page, "[a](docs/nothing.md) [b](#here)\n# Here\n[c](docs)"),
                         ["docs/nothing.md"])
        self.assertEqual(broken_links(page, "# Here\n[a](#there) [b](docs/porting.md#nothing)"),
                         ["#there", "docs/porting.md#nothing"])
        self.assertEqual(broken_links(page, "```\n[a](nothing)\n```\n`[b](nothing)`"), [])

    @unittest.skipUnless(program("openrt-render"), "the programs were not built")
    def test_options(self):
        text = "```sh\nopenrt-render a.glb --siez 3 && X=1 openrt-render b --size 1x1\n```"
        self.assertEqual(unknown_options(text), ["openrt-render --siez"])


if __name__ == "__main__":
    unittest.main()
