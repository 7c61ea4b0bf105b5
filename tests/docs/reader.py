# SPDX-License-Identifier: MIT
"""A folder in which a reader of the pages works, as if the build tree were installed."""
import os
import pathlib
import shutil
import subprocess

from pages import ROOT

PC = """Name: {name}
Description: the build tree
Version: 0
Cflags: {flags} -I{root}/include -I{build}/include
Libs: -L{build}/lib {libraries}
"""
PACKAGES = {"openrt": ("", "-lOpenRT"), "rtut": ("", "-lrtut -lOpenRT"),
            "openrt-shader": ("-std=c++20 -fPIC -fvisibility=hidden -ffp-contract=off", "")}


class Reader:
    def __init__(self, folder, build, compilers):
        """compilers: what `cc` and `c++` are."""
        self.folder = pathlib.Path(folder)
        tools = self.folder / ".tools"
        tools.mkdir()
        for name, compiler in compilers.items():
            program, *options = compiler.split()
            words = " ".join([shutil.which(program), *options]) # not itself
            (tools / name).write_text(f'#!/bin/sh\nexec {words} "$@"\n')
            (tools / name).chmod(0o755)
        for name, (flags, libraries) in PACKAGES.items():
            (tools / f"{name}.pc").write_text(
                PC.format(name=name, flags=flags, root=ROOT, build=build, libraries=libraries))
        headers = [f"{ROOT}/include", f"{build}/include"]
        programs = [tools, build / "bin", build / "bin/changing", os.environ["PATH"]]
        self.environment = {
            **os.environ, "PKG_CONFIG_PATH": str(tools), "LD_LIBRARY_PATH": str(build / "lib"),
            "LIBRARY_PATH": str(build / "lib"), "CPATH": ":".join(headers),
            "HOME": str(self.folder),
            "PATH": ":".join(map(str, programs))}

    def run(self, command):
        """What the command printed. A warning of a compiler is an error too."""
        result = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", command], cwd=self.folder,
                                env=self.environment, capture_output=True, text=True, timeout=240,
                                check=False)
        if result.returncode != 0 or "warning:" in result.stderr:
            raise AssertionError(f"{command}: {result.returncode}\n{result.stdout}{result.stderr}")
        return result.stdout
