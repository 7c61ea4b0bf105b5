#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Who may include whom.

A layer includes itself and the layers before it:
include/openrt < base < accel < kernel < geometry < scene < shading < render < remote < recorder
< openrt < rtu < rtut < stream < trace < mpi < compat/remote. Besides: the headers of the C API are
for the last seven (but mpi) and applications only; what the kernels see has neither GLM nor
containers; samples see the public headers only; every quoted include is
written from the root, but for programs that build alone.
"""
import pathlib
import re
import sys

from sources import source_files

LAYERS = ["include/openrt", "libsmart/base", "libsmart/accel", "libsmart/kernel",
          "libsmart/geometry", "libsmart/scene", "libsmart/shading", "libsmart/render",
          "libsmart/remote", "compat/recorder", "compat/openrt", "compat/rtu", "compat/rtut",
          "compat/stream", "compat/trace", "compat/mpi", "compat/remote"]
# Those of them that are made of calls of the C API.
ABOVE_THE_API = ("compat/openrt", "compat/rtu", "compat/rtut", "compat/stream", "compat/trace",
                 "compat/remote", "include/openrt")
# What records and starts frames (not its types and tokens); the core has never heard of it.
API_HEADER = re.compile(r"include/openrt/(rt\.h|rt\.hpp|rt_(?!gl_enums)\w+\.h|rtut?\.h|gl\.h)$")
# Samples for C++ programs that use the core instead of the C interface.
SAMPLES_OF_THE_CORE = ("samples/tour/05_fixed_shader.cpp",)
# Programs that see the library as an application does, and nothing else of the tree.
BUILT_ALONE = ("samples/shaders/", "samples/tour/", "tests/api/")
# Of the rest of the tree, what the program of a layer shares with other programs.
SHARED_BY_PROGRAMS = ("compat/trace/openrt_trace.cpp", "samples/common/standard_output.h")
KERNEL_MAY_SEE = {"libsmart/accel/kd_node.h", "libsmart/accel/wide_node.h"}
CONTAINERS = {"vector", "map", "set", "unordered_map", "unordered_set", "deque", "list", "string",
              "memory", "functional", "iostream", "sstream", "fstream"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def includes_of(text):
    """[(quoted, path)] in order; quoted says "..." as opposed to <...>."""
    return [(mark == '"', path) for mark, path in INCLUDE.findall(text)]


def layer_of(path):
    for layer in LAYERS:
        if path.startswith(layer + "/"):
            return layer
    return None


def target_of(path):
    """An include as a path from the root."""
    return "include/" + path if path.startswith("openrt/") else path


class Tree:
    """The sources by path from the root; texts may be given instead of files, for tests."""

    def __init__(self, texts):
        self.includes = {path: includes_of(text) for path, text in texts.items()}

    def project_includes(self, path):
        return [target_of(p) for _, p in self.includes.get(path, [])
                if p.split("/")[0] in ("openrt", "libsmart", "compat", "samples", "tests")]

    def closure(self, path):
        seen, todo = set(), [path]
        while todo:
            current = todo.pop()
            if current not in seen:
                seen.add(current)
                todo += self.project_includes(current)
        return seen

    def problems(self):
        found = []
        for path in sorted(self.includes):
            found += self.direction(path)
            found += self.from_root(path)
            if path.startswith("libsmart/kernel/") and (path.endswith(".h")
                                                        or "kernels_isa" in path):
                found += self.kernel_purity(path)
        return found

    def direction(self, path):
        own = layer_of(path)
        if own is None:
            if path.startswith(("libsmart/", "compat/")) and path.count("/") > 1:
                return [f"{path}: its folder is no layer"]
            if path.startswith("samples/") and path not in SAMPLES_OF_THE_CORE:
                return [f"{path} includes {t}: samples see public headers only"
                        for t in self.project_includes(path)
                        if not t.startswith(("include/openrt/", "samples/"))]
            return []
        found = []
        for target in self.project_includes(path):
            other = layer_of(target)
            if (path, target) == SHARED_BY_PROGRAMS:
                continue
            if other is None:
                found.append(f"{path} includes {target}, which is no layer below it")
            elif LAYERS.index(other) > LAYERS.index(own):
                found.append(f"{path} includes {target}: {own} is below {other}")
            if own not in ABOVE_THE_API and API_HEADER.match(target):
                found.append(f"{path} includes {target}: for the calls and applications only")
            if (own == "libsmart/kernel" and other == "libsmart/accel"
                    and target not in KERNEL_MAY_SEE):
                found.append(f"{path} includes {target}: kernels may see layouts of nodes only")
        return found

    def from_root(self, path):
        if path.startswith(BUILT_ALONE):
            return []
        return [f"{path}: include \"{p}\" is not written from the root"
                for quoted, p in self.includes[path]
                if quoted and p.split("/")[0] not in ("openrt", "libsmart", "compat", "samples",
                                                      "tests")]

    def kernel_purity(self, path):
        found = []
        for seen in sorted(self.closure(path)):
            for _, name in self.includes.get(seen, []):
                if name.startswith("glm/") or name in CONTAINERS:
                    found.append(f"{path} sees <{name}> through {seen}: neither GLM nor "
                                 "containers in kernels")
        return found


def check(root):
    texts = {str(path): pathlib.Path(root, path).read_text(encoding="utf-8")
             for path in source_files(root) if path.suffix in (".c", ".h", ".cpp", ".hpp")}
    return Tree(texts).problems()


if __name__ == "__main__":
    result = check(sys.argv[1])
    print("\n".join(result) or "all includes point the right way")
    sys.exit(1 if result else 0)
