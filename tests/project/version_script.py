#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The linker's version scripts of libOpenRT and librtut: every function by name, in the node of the
release that added it."""
import argparse
import pathlib
import re
import sys

from exported_symbols import LIBRARIES, declared_functions, preprocess


def nodes_of(text, prefix):
    """[(node, [names], [local patterns], parent)] in order."""
    text = re.sub(r"/\*.*?\*/|#[^\n]*", "", text, flags=re.DOTALL)
    nodes = []
    for name, body, parent in re.findall(
            rf"({prefix}_\d+\.\d+)\s*\{{([^}}]*)\}}\s*(\w[\w.]*)?\s*;", text):
        scope, names = "global", {"global": [], "local": []}
        for word in re.findall(r"(global|local)\s*:|([^\s;:]+)\s*;", body):
            if word[0]:
                scope = word[0]
            else:
                names[scope].append(word[1])
        nodes.append((name, names["global"], names["local"], parent or None))
    return nodes


def release_order(node):
    return [int(part) for part in node.split("_")[1].split(".")]


def problems(library, text, declared, version):
    prefix = LIBRARIES[library].node
    nodes = nodes_of(text, prefix)
    if not nodes:
        return [f"{library}: no node {prefix}_x.y found"]
    found, seen = [], set()
    newest = f"{prefix}_" + ".".join(version.split(".")[:2])
    for index, (node, names, hidden, parent) in enumerate(nodes):
        if release_order(node) > release_order(newest):
            found.append(f"{node} is later than this release, {newest}")
        if parent != (nodes[index - 1][0] if index else None):
            found.append(f"{node} does not continue the node before it")
        for name in names:
            if re.search(r"[*?\[]", name):
                found.append(f"{node}: pattern '{name}'; functions are listed by name")
            elif name in seen:
                found.append(f"{node}: {name} is listed twice")
            elif name not in declared:
                found.append(f"{node}: {name} is declared nowhere")
            seen.add(name)
        if hidden != (["*"] if index == 0 else []):
            found.append(f"{node}: 'local: *;' belongs in the first node, and only there")
    found += [f"not listed: {name}" for name in sorted(declared - seen)]
    return [f"{library}: {problem}" for problem in found]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--script", type=pathlib.Path, action="append", required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--compiler", default="cc")
    parser.add_argument("--include", action="append", required=True)
    arguments = parser.parse_args()
    found = []
    for path in arguments.script:
        declared = declared_functions(preprocess(arguments.compiler, arguments.include, path.stem))
        found += problems(path.stem, path.read_text(encoding="utf-8"), declared, arguments.version)
        print(f"{path.stem}: {len(declared)} functions")
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
