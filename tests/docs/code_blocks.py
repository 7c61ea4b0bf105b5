# SPDX-License-Identifier: MIT
"""What becomes of each block of code in the pages: by page, and in it by the block's first line or
how that begins. A block that is not here fails the tests."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Fragment:
    """A part of a program in C: compiled with these declarations and statements before it, and
    run."""
    declarations: str = ""
    before: str = ""


@dataclasses.dataclass(frozen=True)
class Source:
    """A file, for the commands behind it."""
    name: str


@dataclasses.dataclass(frozen=True)
class Commands:
    """Run as they stand, but for words that are replaced, in a folder of the test's."""
    replaced: dict = dataclasses.field(default_factory=dict)
    without: dict = dataclasses.field(default_factory=dict)  # expression: why those are not run
    files: dict = dataclasses.field(default_factory=dict)  # name: file of the project
    afterwards: str = ""  # what shows that they did something


@dataclasses.dataclass(frozen=True)
class Elsewhere:
    """Run by this test of ctest, where it is part of the build."""
    test: str


@dataclasses.dataclass(frozen=True)
class NotRun:
    """Options of the project's programs are checked all the same."""
    reason: str


@dataclasses.dataclass(frozen=True)
class NoCode:
    """A formula or a diagram."""


HOURS = NotRun("measures for hours on a machine without other work")
SCENE = {"scene.glb": "samples/models/courtyard.glb"}

BLOCKS = {
    "README.md": {
        "rtBegin(RT_TRIANGLES);": Fragment(),
        "./demo ": NotRun("continuous integration runs ./check, and ./demo installs packages"),
        "build/release/bin/openrt-render": Elsewhere("docs.pages"),
        "cmake -S . -B build": NotRun("continuous integration builds and tests; "
                                      "consumer.installed_tree installs"),
    },
    "compat/python/README.md": {
        "apt-get install": Elsewhere("python.wheel"),
        "PYTHONPATH=": Elsewhere("python.first_picture"),
        "import numpy": Elsewhere("python.readme"),
    },
    "docs/architecture.md": {" rt* calls": NoCode()},
    "docs/builtin-shaders.md": {"": NoCode()},
    "docs/changing-scenes.md": {
        "shoal --instances": Commands({"10000": "100", "--rt-offscreen 20": "--rt-offscreen 2",
                                         "--fps": "--fps --rt-size 64x48"}),
        "for (;;) {": Fragment(
            "static int i, round;\n"
            "static void removeWhatIsBehind(void) {\n"
            "    if (round++ == 3) rtFinish(), exit(rtGetError() != RT_NO_ERROR);\n"
            "}\n"
            "static int ready(void) { return 1; }\n"
            "static void makeObject(void) { rtNewObject(RT_DEFINE), rtEndObject(); }\n"
            "static void describe(void) { rtInstantiateObject(1); }\n"),
        "for (i = 0; i < 2; ++i) {": Fragment(
            "enum { width = 4, height = 4 };\n"
            "static RTubyte pixels[2][width * height * 4];\n"
            "static RTuint scenes[2], frames[2];\n"
            "static int i;\n"
            "static void describe(int n) { rtTranslatef(0, 0, (float)n); }\n",
            "scenes[0] = rtGenScene(), scenes[1] = rtGenScene();"),
        "openrt-bench dynamic": HOURS,
    },
    "docs/cluster.md": {
        "mpirun -n 4 openrt-render": Elsewhere("mpi.jobs"),
        "mpirun --host": NotRun("needs several machines"),
        "#SBATCH": NotRun("needs a cluster"),
    },
    "docs/conformance.md": {
        "openrt-conformance ": Commands(without={
            "openrt-conformance": "takes an hour; conformance.quick runs all cases in small",
            "openrt-conformance --library .*": "needs a library elsewhere",
            "openrt-conformance --times": "measures on a machine without other work"}),
    },
    "docs/gallery.md": {"bin/": Commands({"320x240": "32x24"})},
    "docs/compatibility.md": {"python3 -B tests/project/interface_kept.py": NotRun(
        "writes files of the project, which project.interface_kept and binary_interface compare with")},
    "docs/getting-started.md": {
        "./demo ": NotRun("./demo installs packages; consumer.installed_tree installs and uses"),
        "#include <openrt/rt.h>": Elsewhere("docs.getting_started"),
        "cc ": Elsewhere("docs.getting_started"),
    },
    "docs/performance.md": {"openrt-bench rays": HOURS},
    "docs/plugins.md": {
        "#include <openrt/plugin.hpp>": Source("flat.cpp"),
        "c++ ": Commands({"-O2": "-O0"}, afterwards="openrt-info ./flat.so | grep Flat"),
        "cc ": Commands(files={"flat.c": "tests/consumer/outside_shader.c"},
                        afterwards="openrt-info ./flat.so | grep Orchid"),
    },
    "docs/porting.md": {
        "#include <GL/glut.h>": Elsewhere("api.porting_page_test"),
        "cc -include": Elsewhere("api.porting_page_test"),
        "./lamp": Elsewhere("api.porting_page_test"),
        "OPENRT_LOG=stderr ./lamp": NotRun("opens a window"),
    },
    "docs/precision.md": {
        "rtHint(": Fragment(),
        "openrt-accuracy --table": NotRun("takes its time; the tests of accuracy run all cases "
                                          "with few rays"),
    },
    "docs/shader-packets.md": {"": Elsewhere("shaders.guide")},
    "docs/shader-rays.md": {"": Elsewhere("shaders.guide")},
    "docs/shaders.md": {"": Elsewhere("shaders.guide")},
    "docs/textures.md": {
        "RTuint id;": Fragment(
            "enum { w = 2, h = 2 };\nstatic const RTubyte pixels[w * h * 3];\n",
            'rtGenNewShaderClass("TextureShader", NULL), rtGenNewShader();'),
        "width  =": NoCode(),
        "footprint =": NoCode(),
    },
    "docs/tracing.md": {
        "openrt-trace record": Commands(
            {"320x240": "32x24 --rt-offscreen 2 --rt-output lamp%d.png", "| less": "> calls.txt"},
            files={"lamp": "docs/porting.md"}),
    },
    "docs/virtual-reality.md": {
        "rtSetFrameBuffer(wall[0]": Fragment(
            "enum { width = 4, height = 4 };\n"
            "static RTubyte wall[2][width * height * 4];\n"
            "static const RTdouble lowerLeft[3] = {-1, -1, -1}, lowerRight[3] = {1, -1, -1},\n"
            "                     upperLeft[3] = {-1, 1, -1}, leftEye[3] = {0, 0, 0},\n"
            "                     rightEye[3] = {0.1, 0, 0};\n"
            "static RTuint frame[2];\n"
            "static void describeScene(void) {}\n"),
        "openrt-cave scene.glb": Commands(
            {"samples/vr/walk.path": "walk.path", "--frames 4": "--frames 1 --size 16x16"},
            without={"openrt-cave scene.glb --path samples/vr/walk.path": "opens windows"},
            files={**SCENE, "walk.path": "samples/vr/walk.path"}),
    },
}


def fate(page, text, blocks=None):
    """What becomes of a block; None: nobody said. The longest beginning decides."""
    first = text.split("\n", 1)[0]
    fitting = [start for start in (blocks or BLOCKS).get(page, {}) if first.startswith(start)]
    return (blocks or BLOCKS)[page][max(fitting, key=len)] if fitting else None
