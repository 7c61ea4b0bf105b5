# SPDX-License-Identifier: MIT
"""Installs the built tree elsewhere and uses it as three outside projects would.

usage: consumer_test.py BUILD_DIR GENERATOR C_COMPILER CXX_COMPILER FLAGS
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent


def run(*command, **environment):
    print("+", *command, flush=True)
    return subprocess.run(command, check=True, env={**os.environ, **environment},
                          stdout=subprocess.PIPE, text=True).stdout


def main(build, generator, cc, cxx, flags):
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        installed = work / "a prefix"
        run("cmake", "--install", build, "--prefix", str(installed))

        # pkg-config and a plain C compiler; the folder that the library went to is asked for
        lib = next(installed.rglob("openrt.pc")).parent.parent
        environment = {"PKG_CONFIG_PATH": str(lib / "pkgconfig"),
                       "LD_LIBRARY_PATH": str(lib)}
        program = str(work / "by-pkg-config")
        cflags = run("pkg-config", "--cflags", "openrt", **environment)
        libs = run("pkg-config", "--libs", "openrt", **environment)
        command = (f'"{cc}" -std=c99 -Wall -Wextra -Wpedantic -Werror {flags} {cflags.strip()} '
                   f'"{HERE / "consumer.c"}" -o "{program}" {libs.strip()}')
        run("sh", "-c", command)
        print(run(program, **environment), end="")

        # CMake: the shared library, and the static core
        source = work / "outside"
        source.mkdir()
        shutil.copy(HERE / "outside.cmake", source / "CMakeLists.txt")
        for name in ("consumer.c", "core_consumer.cpp"):
            shutil.copy(HERE / name, source)
        run("cmake", "-G", generator, "-S", str(source), "-B", str(source / "build"),
            f"-DCMAKE_PREFIX_PATH={installed}", f"-DCMAKE_C_COMPILER={cc}",
            f"-DCMAKE_CXX_COMPILER={cxx}", f"-DCMAKE_C_FLAGS={flags}",
            f"-DCMAKE_CXX_FLAGS={flags}")
        run("cmake", "--build", str(source / "build"))
        for name in ("consumer", "core_consumer"):
            print(run(str(source / "build" / name)), end="")


if __name__ == "__main__":
    main(*sys.argv[1:6])
