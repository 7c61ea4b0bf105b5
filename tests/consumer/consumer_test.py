# SPDX-License-Identifier: MIT
"""Installs the built tree elsewhere and uses it as outside projects would.

usage: consumer_test.py BUILD_DIR GENERATOR C_COMPILER CXX_COMPILER FLAGS
"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "tests/docs"))

from pages import broken_links  # noqa: E402

STRICT = "-Wall -Wextra -Wpedantic -Wshadow -Werror"


def run(*command, **environment):
    print("+", *command, flush=True)
    return subprocess.run(command, check=True, env={**os.environ, **environment},
                          stdout=subprocess.PIPE, text=True).stdout


class Installation:
    """The installed package, and the compilers of its user."""

    def __init__(self, prefix, cc, cxx, flags):
        self.prefix, self.cc, self.cxx, self.flags = prefix, cc, cxx, flags
        self.lib = next(prefix.rglob("openrt.pc")).parent.parent
        self.environment = {"PKG_CONFIG_PATH": str(self.lib / "pkgconfig"),
                            "LD_LIBRARY_PATH": str(self.lib)}

    def pkg_config(self, *arguments):
        return run("pkg-config", *arguments, **self.environment).strip()

    def program(self, source, output):
        """A C program by pkg-config and the plain compiler."""
        run("sh", "-c", f'"{self.cc}" -std=c99 {STRICT} {self.flags} '
            f'{self.pkg_config("--cflags", "openrt")} "{HERE / source}" -o "{output}" '
            f'{self.pkg_config("--libs", "openrt")}')
        return output

    def run(self, program, *arguments, folder=None, **environment):
        print("+", program, *arguments, flush=True)
        return subprocess.run([program, *arguments], check=False, cwd=folder,
                              env={**os.environ, **self.environment, **environment},
                              stdout=subprocess.PIPE, text=True)

    def moved(self, to):
        shutil.move(self.prefix, to)
        return Installation(to, self.cc, self.cxx, self.flags)


def expect(condition, what):
    if not condition:
        sys.exit(f"failed: {what}")


def cmake_projects(work, installation, generator):
    """The shared library, and the static core."""
    source = work / "outside"
    source.mkdir()
    shutil.copy(HERE / "outside.cmake", source / "CMakeLists.txt")
    for name in ("consumer.c", "core_consumer.cpp", "window_consumer.c"):
        shutil.copy(HERE / name, source)
    run("cmake", "-G", generator, "-S", str(source), "-B", str(source / "build"),
        f"-DCMAKE_PREFIX_PATH={installation.prefix}", f"-DCMAKE_C_COMPILER={installation.cc}",
        f"-DCMAKE_CXX_COMPILER={installation.cxx}", f"-DCMAKE_C_FLAGS={installation.flags}",
        f"-DCMAKE_CXX_FLAGS={installation.flags}")
    run("cmake", "--build", str(source / "build"))
    for name in ("consumer", "core_consumer"):
        print(run(str(source / "build" / name)), end="")
    if (installation.lib / "librtut.so").exists():
        run(str(source / "build/window_consumer"), "--rt-offscreen", "1", "--rt-size", "32x32")


def build_shader_libraries(folder, installation):
    """One command each; what it makes needs nothing of OpenRT."""
    folder.mkdir()
    run("sh", "-c", f'"{installation.cxx}" {STRICT} {installation.flags} -shared '
        f'{installation.pkg_config("--cflags", "openrt-shader")} '
        f'"{HERE / "outside_shader.cpp"}" -o "{folder / "flat.so"}"')
    run("sh", "-c", f'"{installation.cc}" -std=c99 {STRICT} {installation.flags} -shared -fPIC '
        f'{installation.pkg_config("--cflags", "openrt")} '
        f'"{HERE / "outside_shader.c"}" -o "{folder / "orchid.so"}" -lm')
    for library in folder.glob("*.so"):
        expect("OpenRT" not in run("readelf", "-dW", str(library)), f"{library} links nothing")
        symbols = run("nm", "-D", str(library))
        expect(not re.search(r" U rt", symbols), f"{library} asks for no symbol of the library")
        expect(re.search(r" [VD] rtsPlugin$", symbols, re.MULTILINE), f"{library} is a plug-in")
        expect("_ZN6openrt" not in symbols, f"{library} shows nothing of openrt")
        expect(not re.search(r" u \S", symbols), f"{library} can be unloaded")


def shader_libraries(work, installation):
    """Built against the installed package, used after that was moved."""
    shaders = work / "shaders"
    build_shader_libraries(shaders, installation)
    program = str(installation.program("shader_consumer.c", work / "shader_consumer"))
    moved = installation.moved(work / "moved prefix")

    def shown(*arguments, **environment):
        result = moved.run(program, *arguments, **environment)
        expect(result.returncode == 0, result.stdout)
        return result.stdout.strip()

    expect(shown("Flat", str(shaders / "flat.so")) == "0.25 0.5 1", "the C++ library's colour")
    expect(shown("Orchid", str(shaders / "orchid")) == "1 0 0.5", "the C library's colour")
    path = {"OPENRT_SHADER_PATH": f"/nowhere:{shaders}"}
    expect(shown("Flat", "flat", **path) == "0.25 0.5 1", "the folders of the environment")
    expect(shown("Flat", "./flat", folder=shaders) == "0.25 0.5 1", "a path to the folder in use")
    result = moved.run(program, "Flat", "flat.so", folder=shaders)
    expect(result.returncode != 0 and str(moved.lib / "openrt/shaders") in result.stdout,
           f"the folder in use is not searched, the moved one is: {result.stdout}")
    if (moved.lib / "openrt/shaders/wood.so").exists():
        expect(shown("Wood", "wood") not in ("", "0 0 0"), "an installed library by its name")


def programs(prefix):
    """They find the library by themselves."""
    environment = {name: value for name, value in os.environ.items() if name != "LD_LIBRARY_PATH"}
    for program in sorted(prefix.glob("bin/*")):
        result = subprocess.run([program, "--version"], env=environment, capture_output=True,
                                text=True, check=False)
        expect(result.returncode == 0, f"{program}: {result.stderr}")


COMPONENTS = {"libopenrt-mpi0": {"libOpenRT-mpi.so.0"},
              "openrt-tools": {"openrt-trace", "openrt-cave", "openrt-xr"}}


def components(work, build):
    """Each package gets what was built of its own, and no other does."""
    def installed(name):
        folder = work / name
        run("cmake", "--install", build, "--prefix", str(folder), "--component", name)
        return {p.name for p in folder.rglob("*") if p.is_file() and "doc" not in p.parts}

    built = {p.name for folder in ("bin", "lib") for p in pathlib.Path(build, folder).iterdir()}
    files = {name: installed(name) for name in
             ("libopenrt0", "libopenrt-dev", "openrt-tools", "libopenrt-mpi0")}
    for component, expected in COMPONENTS.items():
        for name in expected & built:
            owners = [c for c, held in files.items() if name in held]
            expect(owners == [component], f"{name} is in {component}, not in {owners}")


def guides(prefix):
    """Where the manual pages say that they are, with what they link to and show, and nothing of what
    only makes them."""
    folder = prefix / "share/doc/openrt"
    for name in ("README.md", "docs/porting.md", "docs/gallery.md"):
        expect((folder / name).exists(), f"{name} is installed")
    for page in folder.rglob("*.md"):
        broken = broken_links(page, page.read_text(encoding="utf-8"))
        expect(not broken, f"{page} links to {broken}")
    gallery = (folder / "docs/gallery.md").read_text(encoding="utf-8")
    expect(broken_links(folder / "gallery.md", gallery), "a guide in another folder is found out")
    sources = [path for name in ("CMakeLists.txt", "*.h2m", "*.py") for path in folder.rglob(name)]
    expect(not sources, f"{sources} are no guides")
    for page in (ROOT / "docs/man").glob("*.h2m"):
        expect("/usr/share/doc/openrt\n" in page.read_text(), f"{page} names their folder")


def foreign_includes(include, text):
    """What a header includes that is neither installed with it nor of what libopenrt-dev depends on."""
    return [name for name in re.findall(r'^#\s*include\s+[<"]([^>"]*/[^>"]*)', text, re.MULTILINE)
            if name.split("/")[0] not in ("glm", "sys") and not (include / name).exists()]


def headers(installation):
    """Each installed header compiles by itself. Those of the C interface do in project.headers_alone,
    and those that a source of the same name includes first did when that was built."""
    include = installation.prefix / "include"
    alone = []
    for path in sorted(include.rglob("*.h*")):
        foreign = foreign_includes(include, path.read_text(encoding="utf-8"))
        expect(not foreign, f"{path} includes {foreign}")
        name = str(path.relative_to(include))
        source = (ROOT / name).with_suffix(".cpp")
        first = re.search(r'^#include .*', source.read_text(encoding="utf-8"), re.MULTILINE) \
            if source.exists() else None
        if name.startswith("libsmart/") and not (first and f'"{name}"' in first[0]):
            alone.append(name)

    def compiled(text):
        return subprocess.run([installation.cxx, "-std=c++20", "-fsyntax-only", "-I", include,
                               "-x", "c++", "-"], input=text, text=True, capture_output=True)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        sources = [f'#include "{name}"\n' for name in alone]
        for name, result in zip(alone, pool.map(compiled, sources)):
            expect(result.returncode == 0, f"{name} alone: {result.stderr}")
    kernel = (ROOT / "libsmart/kernel/simd.h").read_text(encoding="utf-8")
    expect(foreign_includes(include, kernel) == ["hwy/highway.h"] and compiled(kernel).returncode != 0,
           "a header of the kernels, which is not installed, is found out")
    print(f"{len(alone)} headers compiled by themselves")


def main(build, generator, cc, cxx, flags):
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        prefix = work / "a prefix"
        run("cmake", "--install", build, "--prefix", str(prefix))
        guides(prefix)
        programs(prefix)
        installation = Installation(prefix, cc, cxx, flags)
        headers(installation)
        program = installation.program("consumer.c", work / "by-pkg-config")
        result = installation.run(str(program))
        expect(result.returncode == 0, result.stdout)
        cmake_projects(work, installation, generator)
        shader_libraries(work, installation)
        components(work / "components", build)


if __name__ == "__main__":
    main(*sys.argv[1:6])
