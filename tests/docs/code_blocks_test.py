#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every block of code in the pages is run, here or by the test that code_blocks.py names, or says
there why not.

usage: code_blocks_test.py BUILD_DIR C_COMPILER CXX_COMPILER [unittest arguments]
"""
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import code_blocks
from code_blocks import Commands, Elsewhere, Fragment, NoCode, NotRun, Source
from pages import PAGES, ROOT, blocks, code_blocks as blocks_of, commands
from reader import Reader

BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
COMPILERS = {"cc": sys.argv.pop(1), "c++": sys.argv.pop(1)}

PROGRAM = """#include <openrt/rt.h>
#include <openrt/rtu.h>
#include <stdio.h>
#include <stdlib.h>

static RTubyte frameBuffer[16 * 16 * 4];
{declarations}
int main(void) {{
    rtInit(NULL, NULL);
    rtSetFrameBuffer(frameBuffer, 16, 16, RT_RGBA_8);
    {before}
    {{
{fragment}    }}
    rtFinish();
    if (rtGetError() != RT_NO_ERROR) {{
        fprintf(stderr, "%s\\n", rtGetErrorText());
        return 1;
    }}
    rtExit();
    return 0;
}}
"""


def name_of(page):
    return str(page.relative_to(ROOT))


def is_built(command):
    """Whether the project's program that it calls is part of the build."""
    program = command.split()[0]
    if program == "xvfb-run":
        return bool(shutil.which(program))
    if program.startswith("bin/"):
        return (BUILD / program).exists()
    own = program.startswith("openrt-") or program == "shoal"
    return not own or any((BUILD / folder / program).exists() for folder in ("bin", "bin/changing"))


def commands_to_run(text, what):
    for command in commands(f"```sh\n{text}```\n"):
        if any(re.fullmatch(pattern, command) for pattern in what.without):
            continue
        if command in what.instead:
            command = what.instead[command]
        else:
            for old, new in what.replaced.items():
                command = command.replace(old, new)
        if is_built(command):
            yield command


class Works(unittest.TestCase):
    def setUp(self):
        self.open_page()

    def open_page(self):
        """A reader with a folder of its own."""
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.reader = Reader(temporary.name, BUILD, COMPILERS)
        (self.reader.folder / "bin").symlink_to(BUILD / "bin")
        (self.reader.folder / "build").mkdir()
        (self.reader.folder / "build/release").symlink_to(BUILD)

    def provide(self, name, path):
        if path != "docs/porting.md":
            target = self.reader.folder / name
            target.parent.mkdir(exist_ok=True)
            if not target.exists():
                target.symlink_to(ROOT / path)
            return
        source = blocks((ROOT / path).read_text(encoding="utf-8"), "c")[0]
        (self.reader.folder / f"{name}.c").write_text(source)
        self.reader.run(f"cc -I{ROOT}/include/openrt/gl -include openrt/gl.h {name}.c -o {name} "
                        "-lrtut -lOpenRT")

    def take(self, text, what):
        """How many programs and commands were run."""
        if isinstance(what, Source):
            (self.reader.folder / what.name).write_text(text)
        elif isinstance(what, Fragment):
            (self.reader.folder / "fragment.c").write_text(
                PROGRAM.format(declarations=what.declarations, before=what.before, fragment=text))
            self.reader.run("cc -std=c99 -Wall -Wextra fragment.c -o fragment -lOpenRT")
            self.reader.run("./fragment")
            return 1
        elif isinstance(what, Commands):
            found = list(commands_to_run(text, what))
            places = self.reader.environment["PATH"]
            if not found or not all(shutil.which(tool, path=places) for tool in what.needs):
                return 0
            for name, path in what.files.items():
                self.provide(name, path)
            shown = [what.afterwards] if what.afterwards and is_built(what.afterwards) else []
            self.reader.run("\n".join(found + shown))
            return len(found)
        return 0

    def test_pages(self):
        ran = 0
        for page in PAGES:
            self.open_page()
            for _, text in blocks_of(page.read_text(encoding="utf-8")):
                what = code_blocks.fate(name_of(page), text)
                with self.subTest(page=name_of(page), block=text.split("\n")[0]):
                    self.assertIsNotNone(what, "nobody says what runs this block")
                    ran += self.take(text, what)
        print(f"{ran} programs and commands")
        self.assertGreater(ran, 7)

    def test_controls(self):
        broken = [("rtBegin(RT_QUADS);\nrtRender();\nrtEnd();\n", Fragment()),
                  ("int unused;\n", Fragment()), ("false\n", Commands()),
                  ("true\n", Commands(afterwards="false")),
                  ("true\n", Commands(instead={"true": "false"})),
                  ("cc none.c -o none\n", Commands())]
        for text, what in broken:
            with self.subTest(text), self.assertRaises(AssertionError):
                self.take(text, what)
        self.assertIsNone(code_blocks.fate("docs/x.md", "a\n", {"docs/x.md": {"b": NoCode()}}))
        gone = Commands(instead={"./demo": "true", "./demos": "true"}, without={"cmake": "", "x": ""})
        self.assertEqual(without_command("README.md", gone), ["./demos", "cmake", "x"])


def without_command(page, what):
    """What is said of commands that the page does not have."""
    shown = [command for _, text in blocks_of((ROOT / page).read_text(encoding="utf-8"))
             for command in commands(f"```sh\n{text}```\n")]
    return [command for command in what.instead if command not in shown] + [
        pattern for pattern in what.without
        if not any(re.fullmatch(pattern, command) for command in shown)]


class Table(unittest.TestCase):
    """Nothing in it is of the past."""

    def test_blocks_exist(self):
        for page, entries in code_blocks.BLOCKS.items():
            found = [text for _, text in blocks_of((ROOT / page).read_text(encoding="utf-8"))]
            for start, what in entries.items():
                with self.subTest(page=page, start=start):
                    self.assertTrue(any(text.startswith(start) for text in found))
                    if isinstance(what, Commands):
                        self.assertEqual(without_command(page, what), [])
                    if isinstance(what, NotRun):
                        self.assertGreater(len(what.reason), 10)

    def test_other_tests_exist(self):
        """In the project, though perhaps not in this build."""
        lists = "".join(path.read_text(encoding="utf-8")
                        for path in (ROOT / "tests").rglob("CMakeLists.txt"))
        for entries in code_blocks.BLOCKS.values():
            for what in entries.values():
                if isinstance(what, Elsewhere):
                    group, name = what.test.split(".")
                    self.assertTrue(
                        f"NAME {what.test} " in lists or f"NAME {group}.${{name}}" in lists
                        and re.search(rf"\b{name.removesuffix('_test')}\b", lists), what.test)


if __name__ == "__main__":
    unittest.main()
