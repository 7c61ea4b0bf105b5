#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the page of a program in section 1 of the manual: help2man's, of what `--help` prints, with
what `SUBCOMMAND --help` prints, and with the text about the program. `@ENVIRONMENT@` there stands for
the variables that all programs of the library honour (environment.roff beside it).

usage: program_page.py HELP2MAN PROGRAM ABOUT PAGE
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from manual_pages import roff

ENTRY = re.compile(r"  (\S.*?)(?: {2,}(\S.*))?$")


def help_of(*command):
    return subprocess.run([*command, "--help"], capture_output=True, text=True, check=True).stdout


def parts(text):
    """{title: lines} of what CLI11 prints; "" has what comes before the first title."""
    found, title = {"": []}, ""
    for line in text.splitlines():
        if re.fullmatch(r"\w+:", line):
            title = line[:-1]
            found[title] = []
        elif line.strip():
            found[title].append(line)
    return found


def entries(lines):
    """[(name, text)] of lines in two columns; where a name is long the text is on the next line."""
    found = []
    for line in lines:
        entry = ENTRY.match(line)
        if entry:
            found.append((entry[1], entry[2] or ""))
        else:
            found[-1] = (found[-1][0], f"{found[-1][1]} {line.strip()}".strip())
    return found


def subcommand(name, text):
    """A section, as help2man's files of additions have it."""
    found = parts(text)
    usage = [line.removeprefix("Usage: ") for line in found[""] if line.startswith("Usage: ")]
    out = [f"[SUBCOMMAND {name.upper()}]", f".B {roff(usage[0])}", ".PP",
           *(roff(line) for line in found[""] if not line.startswith("Usage: "))]
    for title in ("Positionals", "Options"):
        for term, words in entries(found.get(title, [])):
            out += [".TP", f"\\fB{roff(term)}\\fR", roff(words)]
    return "\n".join(out) + "\n\n"


def main():
    help2man, program, about, page = sys.argv[1:]
    about = pathlib.Path(about)
    text = about.read_text(encoding="utf-8").replace(
        "@ENVIRONMENT@\n", (about.parent / "environment.roff").read_text(encoding="utf-8"))
    names = [name for name, _ in entries(parts(help_of(program)).get("Subcommands", []))]
    text += "\n" + "".join(subcommand(name, help_of(program, name)) for name in names)
    with tempfile.NamedTemporaryFile("w", suffix=".h2m", encoding="utf-8") as additions:
        additions.write(text)
        additions.flush()
        subprocess.run([help2man, "--no-info", "--include", additions.name, "--output", page,
                        program], check=True)


if __name__ == "__main__":
    main()
