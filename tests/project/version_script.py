#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The linker's version script: every function by name, in the node of the release that added it."""
import argparse
import re
import sys

from exported_symbols import declared_functions, preprocess

NODE = re.compile(r"(OPENRT_\d+\.\d+)\s*\{([^}]*)\}\s*(\w[\w.]*)?\s*;")


def nodes_of(text):
    """[(node, [names], [local patterns], parent)] in order."""
    text = re.sub(r"/\*.*?\*/|#[^\n]*", "", text, flags=re.DOTALL)
    nodes = []
    for name, body, parent in NODE.findall(text):
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


def problems(text, declared, version):
    nodes = nodes_of(text)
    if not nodes:
        return ["no node OPENRT_x.y found"]
    found, seen = [], set()
    newest = "OPENRT_" + ".".join(version.split(".")[:2])
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
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--script", required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--compiler", default="cc")
    parser.add_argument("--include", action="append", required=True)
    arguments = parser.parse_args()
    declared = declared_functions(preprocess(arguments.compiler, arguments.include))
    with open(arguments.script, encoding="utf-8") as file:
        found = problems(file.read(), declared, arguments.version)
    print("\n".join(found) or f"{len(declared)} functions, each by name")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
