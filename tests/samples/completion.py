#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What bash offers behind the programs' names is what --help tells of.

usage: completion.py FOLDER_OF_PROGRAMS COMPLETION_FILE [unittest arguments]
"""
import os
import pathlib
import re
import subprocess
import sys
import unittest

PROGRAMS = pathlib.Path(sys.argv.pop(1)).resolve()
FILE = pathlib.Path(sys.argv.pop(1)).resolve()
SCRIPT = """source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
_openrt
printf '%s\\n' "${COMPREPLY[@]}"
"""


def offered(*words):
    """For the last word, behind the ones before it."""
    result = subprocess.run(["bash", "-c", SCRIPT, "bash", FILE, *words], text=True,
                            capture_output=True, check=True, env={**os.environ, "HOME": PROGRAMS})
    assert not result.stderr, result.stderr
    return {line for line in result.stdout.split("\n") if line}


def registered():
    result = subprocess.run(["bash", "-c", 'source "$1"; complete -p', "bash", FILE], text=True,
                            capture_output=True, check=True)
    return set(re.findall(r"-F _openrt (\S+)", result.stdout))


def help_of(program, *subcommand):
    return subprocess.run([program, *subcommand, "--help"], text=True, capture_output=True,
                          check=True).stdout


def options_of(text):
    """Every option at the beginning of a line."""
    found = re.findall(r"^  (-\S+)", text, flags=re.MULTILINE)
    return {re.sub(r"\{.*", "", option) for options in found for option in options.split(",")}


def subcommands_of(text):
    part = text.partition("Subcommands:\n")[2].partition("\n\n")[0]
    return set(re.findall(r"^  (\w\S*)", part, flags=re.MULTILINE))


class Completion(unittest.TestCase):
    def test_every_program(self):
        built = [PROGRAMS / name for name in sorted(registered()) if (PROGRAMS / name).exists()]
        self.assertIn(PROGRAMS / "openrt-info", built)
        for program in built:
            text = help_of(program)
            places = [()] + [(name,) for name in sorted(subcommands_of(text))]
            for place in places:
                with self.subTest(program=program.name, place=place):
                    options = options_of(help_of(program, *place))
                    self.assertIn("--help", options)
                    self.assertEqual(offered(program, *place, "-"), options)
            self.assertEqual(offered(program, ""), subcommands_of(text))

    def test_part_of_a_word(self):
        program = PROGRAMS / "openrt-info"
        self.assertEqual(offered(program, "--ver"), {"--version"})
        self.assertEqual(offered(program, "--nothing"), set())
        self.assertEqual(offered(program, "--precision", "w"), {"watertight"})

    def test_words_of_any_kind(self):
        self.assertEqual(offered("~/openrt-info", "--ver"), {"--version"})
        self.assertEqual(offered(PROGRAMS / "openrt-info", "[", "*", "", "--ver"), {"--version"})

    def test_without_a_program(self):
        self.assertEqual(offered("openrt-of-no-such-name", "-"), set())


if __name__ == "__main__":
    unittest.main()
