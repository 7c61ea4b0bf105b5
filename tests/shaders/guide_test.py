#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Every block of code on the pages of the shader guide is compiled and used, every command is run.

guide_test.py SOURCE_FOLDER BUILD_FOLDER LIBRARY LOADER SHADER_FOLDER [sanitized]

Before a block may stand a comment: `<!-- file NAME -->` keeps it as that file; a file that makes
shader classes is compiled as a shader library, and each class is loaded and rendered with.
`<!-- program ... -->` makes it the body of a C program, `<!-- core -->` is compiled against the
headers of the static core. Shell blocks run in the folder with the
files so far.
"""
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

SOURCE, BUILD, LIBRARY, LOADER, SHADERS = map(pathlib.Path, sys.argv[1:6])
# Programs that the guide's commands compile can not run with a sanitized library.
SANITIZED = "sanitized" in sys.argv[6:]
PAGES = [SOURCE / "docs" / name for name in ("shaders.md", "shader-rays.md", "shader-packets.md")]


class Block:
    def __init__(self, line, language, note, text):
        self.line, self.language, self.note, self.text = line, language, note, text

    def __str__(self):
        return f"the {self.language} block in line {self.line}"


def blocks_of(guide):
    blocks, note, block = [], "", None
    for number, line in enumerate(guide.splitlines(), 1):
        if block is not None:
            if line == "```":
                blocks.append(Block(*block[:3], "\n".join(block[3]) + "\n"))
                block, note = None, ""
            else:
                block[3].append(line)
        elif line.startswith("```"):
            block = (number, line[3:], note, [])
        elif line.startswith("<!-- "):
            note = line[5:-4]
        elif line:
            note = ""
    if block is not None:
        raise ValueError(f"the block in line {block[0]} has no end")
    return blocks


PROGRAM = """#include <openrt/rt.h>
#include <stdio.h>

int main(void) {{
    static float pixels[8 * 8 * 3];
    rtInit(NULL, NULL);
    rtSetFrameBuffer((RTubyte *)pixels, 8, 8, RT_RGB_32F);
{}
    if (rtGetError() != RT_NO_ERROR) {{
        fprintf(stderr, "%s\\n", rtGetErrorText());
        return 1;
    }}
    rtExit();
    return 0;
}}
"""


class Workshop:
    """A folder in which a reader of the guide works."""

    def __init__(self, folder):
        self.folder = folder
        prefix = folder / "prefix"
        headers = prefix / "include" / "openrt"
        packages = prefix / "lib" / "pkgconfig"
        headers.mkdir(parents=True)
        packages.mkdir(parents=True)
        for source in (SOURCE, BUILD):
            for header in (source / "include" / "openrt").iterdir():
                if header.suffix in (".h", ".hpp"):
                    (headers / header.name).symlink_to(header)
        for name in (LIBRARY.name, "libOpenRT.so.0", "libOpenRT.so"):
            if not (prefix / "lib" / name).exists():
                (prefix / "lib" / name).symlink_to(LIBRARY)
        for package in ("openrt", "openrt-shader"):
            text = (SOURCE / "compat" / f"{package}.pc.in").read_text()
            for variable, value in (("openrt_prefix_from_pc", "../.."),
                                    ("CMAKE_INSTALL_LIBDIR", "lib"),
                                    ("CMAKE_INSTALL_INCLUDEDIR", "include"),
                                    ("PROJECT_VERSION", "0")):
                text = text.replace(f"@{variable}@", value)
            (packages / f"{package}.pc").write_text(text)
        # Two walls and a floor.
        triangles = []
        for a, b in (((1, 0, 0), (0, 0, 1)), ((1, 0, 0), (0, 1, 0)), ((0, 1, 0), (0, 0, 1))):
            corner = [tuple(x + y for x, y in zip(p, q)) for p, q in ((a, (0, 0, 0)), (a, b),
                                                                     (b, (0, 0, 0)))]
            triangles += [(0, 0, 0), corner[0], corner[1], (0, 0, 0), corner[1], corner[2]]
        (folder / "room.tri").write_bytes(
            struct.pack("<I", len(triangles) // 3)
            + b"".join(struct.pack("<3f", *vertex) for vertex in triangles))
        self.environment = dict(
            os.environ, PKG_CONFIG_PATH=str(packages), LD_LIBRARY_PATH=str(prefix / "lib"),
            OPENRT_SHADER_PATH=str(SHADERS),
            PATH=f"{BUILD / 'bin'}:{os.environ['PATH']}")

    def shell(self, text):
        result = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", text], cwd=self.folder,
                                env=self.environment, capture_output=True, text=True, timeout=240)
        if result.returncode != 0 or "warning" in result.stderr:
            raise AssertionError(f"{text}\n{result.stdout}{result.stderr}")

    def take(self, block):
        note = block.note.split()
        if note[:1] == ["file"]:
            self.file(note[1], block.text)
        elif note[:1] == ["program"]:
            self.program(block.text)
        elif note[:1] == ["core"]:
            self.core(block.text)
        elif block.language == "sh":
            if not (SANITIZED and ("--libs openrt" in block.text or "./" in block.text)):
                self.commands(block.text)
        else:
            raise AssertionError("nothing says what the block is for")

    def file(self, name, text):
        (self.folder / name).write_text(text)
        stem = name.rsplit(".", 1)[0]
        classes = re.findall(r'^OPENRT_PLUGIN\(\w+, "(\w+)"\)', text, re.M)
        classes += re.findall(r'\.name = "(\w+)"', text)
        if not classes:
            return
        strict = "-Wall -Wextra -Wpedantic -Wshadow -Werror"
        compiler = (f"c++ -O0 -shared {strict} $(pkg-config --cflags openrt-shader)"
                    if name.endswith(".cpp") else
                    f"cc -std=c99 -O2 -shared -fPIC {strict} $(pkg-config --cflags openrt)")
        self.shell(f"{compiler} {name} -o {stem}.so\n"
                   f"'{LOADER}' ./{stem}.so {' '.join(classes)}")

    def program(self, body):
        (self.folder / "program.c").write_text(
            PROGRAM.format("".join("    " + line + "\n" for line in body.splitlines())))
        compiler = "cc -Wall -Wextra -Werror program.c $(pkg-config --cflags openrt)"
        if SANITIZED:
            self.shell(f"{compiler} -fsyntax-only")
        else:
            self.shell(f"{compiler} $(pkg-config --libs openrt) -o program && ./program")

    def core(self, text):
        (self.folder / "core.cpp").write_text(text)
        self.shell("c++ -std=c++20 -Wall -Wextra -Werror -fsyntax-only "
                   f"-I'{SOURCE}' $(pkg-config --cflags openrt) core.cpp")

    def commands(self, text):
        for command in text.replace("\\\n", " ").splitlines():
            program = command.split()[0]
            if program.startswith("openrt-") and not (BUILD / "bin" / program).exists():
                continue # built where its libraries are
            self.shell(command)


class Guide(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.workshop = Workshop(pathlib.Path(temporary.name))

    def test_every_block_works(self):
        blocks = [(page.name, block) for page in PAGES for block in blocks_of(page.read_text())]
        self.assertGreater(len(blocks), 20)
        for page, block in blocks:
            with self.subTest(f"{page}, {block}"):
                self.workshop.take(block)

    def test_links_lead_somewhere(self):
        for page in PAGES:
            guide = page.read_text()
            headings = {re.sub(r"[^a-z0-9 -]", "", h.lower()).replace(" ", "-")
                        for h in re.findall(r"^#+ (.*)$", guide, re.M)}
            for target in re.findall(r"\]\(([^)]*)\)", guide):
                with self.subTest(f"{page.name}, {target}"):
                    path, _, anchor = target.partition("#")
                    if path:
                        self.assertTrue((SOURCE / "docs" / path).exists())
                    else:
                        self.assertIn(anchor, headings)
            for named in re.findall(r"`(samples/[\w/.]+)`", guide):
                self.assertTrue((SOURCE / named).exists(), named)

    def test_a_broken_block_is_found(self):
        good = next(b for b in blocks_of(PAGES[0].read_text())
                    if b.note == "file dusk.cpp")
        self.workshop.take(good)
        broken = [
            Block(1, "cpp", good.note, good.text.replace("setRadiance", "setRadiant")),
            Block(2, "cpp", good.note, good.text.replace("c.setRad", "throw 1; c.setRad")),
            Block(3, "sh", "", "false\n"),
            Block(4, "sh", "", "c++ -shared none.cpp -o none.so\n"),
            Block(5, "c", "program", "rtBegin(RT_QUADS);\nrtRender();\nrtEnd();\n"),
            Block(6, "cpp", "", "int x;\n"),
        ]
        for block in broken:
            if SANITIZED and block.line == 5:
                continue
            with self.subTest(str(block)), self.assertRaises(AssertionError):
                self.workshop.take(block)
        with self.assertRaises(ValueError):
            blocks_of("```cpp\nint x;\n")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
