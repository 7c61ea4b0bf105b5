#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The program in docs/porting.md, compiled and run as the page says; openrt/gl.h among others.

porting_page_test.py SOURCE_FOLDER C_COMPILER CXX_COMPILER INCLUDE_FOLDER... [-- RTUT OPENRT]

With the libraries the program is linked and renders pictures.
"""
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

SOURCE = pathlib.Path(sys.argv[1])
C_COMPILER, CXX_COMPILER = sys.argv[2:4]
FOLDERS, _, LIBRARIES = " ".join(sys.argv[4:]).partition("--")
INCLUDES = [f"-I{folder}" for folder in FOLDERS.split()]
LIBRARIES = LIBRARIES.split()
STRICT = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Werror"]
OWN_GL = ["-I", str(SOURCE / "include/openrt/gl")]
HEADERS = ["GL/gl.h", "GL/glu.h", "GL/glut.h", "GL/glext.h", "GL/freeglut.h", "GLUT/glut.h",
           "OpenGL/gl.h", "OpenGL/glu.h"]
USE = """
int main(void) {
    GLfloat m[16] = {0};
    GLUquadric *quadric = gluNewQuadric();
    glMultMatrixf(m);
    gluPerspective(60, 1, 1, 2);
    glBegin(GL_TRIANGLES);
    glEnd();
    gluDeleteQuadric(quadric);
    glutInitDisplayMode(GLUT_RGB | GLUT_DOUBLE);
    return GL_TRIANGLES == RT_TRIANGLES ? (int)glGetError() : 1;
}
"""


def page():
    return (SOURCE / "docs/porting.md").read_text(encoding="utf-8")


def program():
    return re.search(r"^```c\n(.*?)^```", page(), re.DOTALL | re.MULTILINE).group(1)


def commands():
    return re.findall(r"^    (\S.*)$", re.sub(r"^```c\n.*?^```", "", page(),
                                             flags=re.DOTALL | re.MULTILINE), re.MULTILINE)


def run(command, text=None, folder=None):
    return subprocess.run(command, input=text, cwd=folder, text=True, timeout=120,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def pixels(path):
    """Size and the rows, unfiltered, of an 8-bit RGB picture."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    return size, zlib.decompress(packed)


class Page(unittest.TestCase):
    def compile(self, language, text, *options):
        compiler = [C_COMPILER, "-std=c99"] if language == "c" else [CXX_COMPILER, "-std=c++11"]
        return run([*compiler, *STRICT, "-fsyntax-only", *INCLUDES, *options, "-x", language, "-"],
                   text)

    def check(self, language, text, *options):
        result = self.compile(language, text, *options)
        self.assertEqual(result.returncode, 0, f"{options}\n{text}\n{result.stdout}")

    def test_other_headers_are_harmless(self):
        system = "".join(f"#if __has_include(<{h}>)\n#include <{h}>\n#endif\n" for h in HEADERS)
        own = "".join(f"#include <{h}>\n" for h in reversed(HEADERS))
        for language in ("c", "c++"):
            self.check(language, system + USE, "-include", "openrt/gl.h")
            self.check(language, f"#include <openrt/gl.h>\n{system}{system}{USE}")
            self.check(language, own + USE, *OWN_GL)

    def test_headers_in_the_wrong_order_are_told(self):
        if run([C_COMPILER, "-fsyntax-only", "-x", "c", "-"], "#include <GL/gl.h>\n").returncode:
            self.skipTest("no OpenGL headers")
        result = self.compile("c", f"#include <GL/gl.h>\n#include <openrt/gl.h>\n{USE}")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("comes before", result.stdout)

    def test_program(self):
        self.check("c", program(), "-include", "openrt/gl.h", *OWN_GL)
        compiling, rendering = commands()[:2]
        self.assertEqual(compiling.split()[:3], ["cc", "-include", "openrt/gl.h"])
        if not LIBRARIES:
            self.skipTest("no rtut")
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for shadows in ("with", "without"):
                other = "RT_SHADOWS" if shadows == "with" else "GL_DEPTH_TEST"
                (folder / "lamp.c").write_text(program().replace("RT_SHADOWS", other))
                paths = [f"-Wl,-rpath,{pathlib.Path(l).parent}" for l in LIBRARIES]
                result = run([C_COMPILER, *compiling.split()[1:-2], *INCLUDES, *OWN_GL,
                              *LIBRARIES, *paths], folder=folder)
                self.assertEqual(result.returncode, 0, result.stdout)
                result = run(rendering.split(), folder=folder)
                self.assertEqual((result.returncode, result.stdout), (0, ""))
                for i in range(3):
                    (folder / f"frame{i:03d}.png").rename(folder / f"{shadows}{i}.png")
            pictures = [pixels(folder / f"with{i}.png") for i in range(3)]
            self.assertEqual([size for size, _ in pictures], [(320, 240)] * 3)
            self.assertEqual(len({rows for _, rows in pictures}), 3)
            self.assertNotEqual(pictures[0], pixels(folder / "without0.png"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
