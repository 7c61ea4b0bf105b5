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
    """Run in one shell as they stand, but for words that are replaced, in a folder of the test's
    that is also the home. build/release is the build tree there."""
    replaced: dict = dataclasses.field(default_factory=dict)
    instead: dict = dataclasses.field(default_factory=dict)  # whole command: what is run for it
    without: dict = dataclasses.field(default_factory=dict)  # expression: why those are not run
    files: dict = dataclasses.field(default_factory=dict)  # name: file or folder of the project
    afterwards: str = ""  # what shows that they did something
    needs: tuple = ()  # without these tools nothing is run


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


SCENE = {"scene.glb": "samples/models/courtyard.glb"}
# Here the packages are installed and the project is built.
DEMO = ("(cmake() { :; }; dpkg-query() { printf installed; }; export -f cmake dpkg-query; "
        "DISPLAY= WAYLAND_DISPLAY= ./demo) && test -s build/demo/courtyard.png")
SMALL = "--scene generated:2000 --size 32 --repeat 1"
MPIRUN = "mpirun --allow-run-as-root --oversubscribe "

BLOCKS = {
    "README.md": {
        "rtBegin(RT_TRIANGLES);": Fragment(),
        "./demo ": Commands(instead={"./demo": DEMO},
                            files={name: name for name in ("demo", ".ci", "samples")},
                            without={r"\./check": "this test is a part of it"},
                            needs=("openrt-render",)),
        "build/release/bin/openrt-render": Elsewhere("docs.pages"),
        "cmake -S . -B build": Commands(
            {"install build": "install build/release", "/usr/local": "usr"},
            without={"cmake -S .*": "continuous integration does, by the preset release"},
            afterwards="test -e usr/lib*/libOpenRT.so || test -e usr/lib/*/libOpenRT.so"),
    },
    "compat/python/README.md": {
        "apt-get install": Elsewhere("python.wheel"),
        "PYTHONPATH=": Elsewhere("python.readme"),
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
        "openrt-bench dynamic": Commands(
            {"100,1000,10000,100000,1000000": "9 --sheet 800 --size 32 --repeat 1",
             "--queue 100 --decay 100 --peers embree": "--queue 3 --decay 2",
             "memory --json": "memory --triangles 2000 --objects 10 --json"},
            without={"tests/bench/.*": "openrt-bench.peers-see-the-same and samples.* run what they "
                                       "run; this would change the page"}),
    },
    "docs/cluster.md": {
        "mpirun -n 4 openrt-render": Commands({"mpirun ": MPIRUN, "out.exr": "out.exr --size 32x24"},
                                              files=SCENE, needs=("mpirun",)),
        "mpirun --host": Commands(
            {"mpirun ": MPIRUN, "node1:1,node2:1,node3:1": "localhost:3",
             "program ...": "openrt-render scene.glb -o out.exr --size 32x24"},
            files=SCENE, needs=("mpirun",)),
        "#SBATCH": NotRun("needs Slurm"),
    },
    "docs/conformance.md": {
        "openrt-conformance ": Commands(
            {"/elsewhere/": "build/release/lib/", "--html report": "--html report --quick --cases picture/gears"},
            instead={"openrt-conformance": "openrt-conformance --quick --cases picture/gears",
                     "openrt-conformance --times": "openrt-conformance --times --cases gears"},
            afterwards="test -s report/index.html"),
    },
    "docs/gallery.md": {"bin/": Commands({"320x240": "32x24"})},
    "docs/compatibility.md": {"python3 -B tests/project/interface_kept.py": Commands(
        {"python3 -B tests/project/interface_kept.py": "mkdir compat/interface && "
                                                       "python3 -B tests/project/interface_kept.py"},
        files={"tests": "tests", "include": "include", "kept.txt": "compat/interface/0.1.0.txt",
               "compat/libOpenRT.map": "compat/libOpenRT.map",
               "compat/librtut.map": "compat/librtut.map"},
        afterwards="cmp kept.txt compat/interface/0.1.0.txt && "
                   "test -s compat/interface/libOpenRT-0.1.0.abi.gz",
        needs=("abidw",))},
    "docs/getting-started.md": {
        "./demo ": Commands(
            without={r"\./demo": "README.md has it too"},
            afterwards="unset CPATH LIBRARY_PATH; echo 'int main(void) { rtInit(0, 0); rtExit(); }' | "
                       "cc -include openrt/rt.h -x c - $(pkg-config --cflags --libs openrt) "
                       "-o program && ./program && ldd program | grep $HOME/openrt"),
        "#include <openrt/rt.h>": Elsewhere("docs.getting_started"),
        "cc ": Elsewhere("docs.getting_started"),
    },
    "docs/performance.md": {"openrt-bench rays": Commands(
        {"--scene NAME.tri --cameras FILE --name NAME": SMALL, "rays ...": f"rays {SMALL}",
         "--isa avx2": "--isa generic --kinds primary", "--peers embree ": "",
         "scale --json": "scale --fewest 100 --most 2000 --size 32 --largest 128 --repeat 1 --json",
         "cases --json": "cases --size 32 --repeat 1 --json"}, files={"tests": "tests"})},
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
        "OPENRT_LOG=stderr ./lamp": Commands({"./lamp": "./lamp --rt-offscreen 1"},
                                             files={"lamp": "docs/porting.md"}),
    },
    "docs/precision.md": {
        "rtHint(": Fragment(),
        "openrt-accuracy --table": Commands(
            {"H1-exact --rays 10000000": "H6-one-triangle --rays 100",
             "1000000": "100 --cases H9 --engines openrt-precise", "--scene sponza.tri --cameras cameras.txt": "--scene generated:2000 --size 32"},
            instead={"openrt-accuracy --table":
                     "openrt-accuracy --table --cases H9 --rays 100 --engines openrt-precise"},
            without={"tests/accuracy/plot.py .*": "openrt-accuracy.report does, on a whole report"}),
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
            instead={"openrt-cave scene.glb --path samples/vr/walk.path":
                     "xvfb-run -a openrt-cave scene.glb --path walk.path --frames 1 --size 16x16"},
            files={**SCENE, "walk.path": "samples/vr/walk.path"}),
    },
}


def fate(page, text, blocks=None):
    """What becomes of a block; None: nobody said. The longest beginning decides."""
    first = text.split("\n", 1)[0]
    fitting = [start for start in (blocks or BLOCKS).get(page, {}) if first.startswith(start)]
    return (blocks or BLOCKS)[page][max(fitting, key=len)] if fitting else None
