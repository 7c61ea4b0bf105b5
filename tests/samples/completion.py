#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What bash offers behind the programs' names is what --help tells of, and that is all explained.

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


def unexplained(text):
    """Lines of options without a text, which begins in the thirtieth column or on the next line."""
    lines = text.split("\n")
    return [line for line, after in zip(lines, lines[1:] + [""]) if line.startswith("  -")
            and not after.startswith(" " * 30) and not re.match(r" \S", line[29:])]


def values_of(text):
    """Of the options that take some words only."""
    found = re.findall(r"^  (--\S+) TEXT:\{(.*?)\}", text, flags=re.MULTILINE)
    return {option: set(values.split(",")) for option, values in found}


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
                    text = help_of(program, *place)
                    options = options_of(text)
                    self.assertIn("--help", options)
                    self.assertEqual(unexplained(text), [])
                    self.assertEqual(offered(program, *place, "-"), options)
                    for option, values in values_of(text).items():
                        self.assertEqual(offered(program, *place, option, ""), values)
            self.assertEqual(offered(program, ""), subcommands_of(help_of(program)))

    def test_control(self):
        told = "  -o,--output FILE            picture\n"
        plain, long = "  --size UINT\n", "  --threads UINT:INT in [1 - 1024]=2\n"
        self.assertEqual(unexplained(told + long + " " * 30 + "of all\n"), [])
        self.assertEqual(unexplained(plain + told + long), [plain[:-1], long[:-1]])

    def test_values(self):
        program = PROGRAMS / "openrt-bench"
        if not program.exists():
            self.skipTest("openrt-bench is not built")
        text = help_of(program, "rays")
        self.assertLessEqual({"--isa", "--kinds", "--precision"}, set(values_of(text)))
        self.assertIn("--peers", options_of(text))
        rays = (program, "rays", "--kinds")
        self.assertEqual(offered(*rays, ""), {"primary", "shadow", "ao", "bounce"})
        self.assertEqual(offered(*rays, "b"), {"bounce"})
        self.assertEqual(offered(*rays, "primary,ao,s"), {"primary,ao,shadow"})

    def test_part_of_a_word(self):
        program = PROGRAMS / "openrt-info"
        self.assertEqual(offered(program, "--ver"), {"--version"})
        self.assertEqual(offered(program, "--nothing"), set())

    def test_words_of_any_kind(self):
        self.assertEqual(offered("~/openrt-info", "--ver"), {"--version"})
        self.assertEqual(offered(PROGRAMS / "openrt-info", "[", "*", "", "--ver"), {"--version"})

    def test_without_a_program(self):
        self.assertEqual(offered("openrt-of-no-such-name", "-"), set())


if __name__ == "__main__":
    unittest.main()
