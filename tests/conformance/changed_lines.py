#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How many lines of each sample port are for OpenRT alone: those between #ifdef OPENRT and #endif.

At most 10 in any, none in at least 15."""
import pathlib
import sys

MOST = 10
UNCHANGED = 15


def changed_lines(text):
    """Lines inside conditionals on OPENRT; other conditionals are not counted."""
    count = 0
    depths = []  # of open conditionals: whether they are about OPENRT
    for line in text.splitlines():
        words = line.replace("#", "# ", 1).split()
        if words[:1] == ["#"] and len(words) > 1:
            if words[1] in ("if", "ifdef", "ifndef"):
                depths.append("OPENRT" in line)
                continue
            if words[1] == "endif":
                depths.pop()
                continue
            if words[1] in ("else", "elif"):
                continue
        count += any(depths) and bool(line.strip())
    return count


def self_test():
    text = "a\n#ifdef OPENRT\nb\n#else\nc\n\n#endif\n#if X\nd\n#endif\n"
    assert changed_lines(text) == 2, changed_lines(text)


def main(folder):
    self_test()
    counts = {path.name: changed_lines(path.read_text(encoding="utf-8"))
              for path in sorted(pathlib.Path(folder).glob("*.c"))
              if not path.name.startswith("rt_")}
    for name, count in counts.items():
        print(f"{count:3} {name}")
    unchanged = sum(count == 0 for count in counts.values())
    print(f"{unchanged} of {len(counts)} without a changed line")
    return 0 if unchanged >= UNCHANGED and max(counts.values()) <= MOST else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
