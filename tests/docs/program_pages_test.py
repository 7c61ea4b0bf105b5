#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Section 1 of the manual: each program has a page, with every option of it and of its subcommands, and
with the variables of the environment that it honours.

usage: program_pages_test.py BUILD [unittest arguments]
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(ROOT / "docs/site"))

from program_page import entries, parts, subcommand  # noqa: E402

ABOUT = {path.stem: path.read_text(encoding="utf-8")
         for path in sorted((ROOT / "docs/man").glob("*.h2m"))}
# They do not use the library: what they compare is linked otherwise, or are other programs.
WITHOUT_LIBRARY = {"openrt-accuracy", "openrt-conformance"}
HELP2MAN = shutil.which("help2man")


def helps(program):
    """What the program prints about itself, then about each of its subcommands."""
    def print_of(*words):
        return subprocess.run([program, *words, "--help"], capture_output=True, text=True,
                              check=True).stdout
    yield print_of()
    for line in print_of().partition("Subcommands:\n")[2].splitlines():
        if re.match(r"  \w", line):
            yield print_of(line.split()[0])


def missing_options(text, page):
    """Options at the start of a line of what --help prints which a page does not have."""
    plain = re.sub(r"\\f[BIRP]", "", page).replace("\\-", "-")
    names = re.findall(r"^  (-[^\s=:{]+)", text, re.MULTILINE)
    return [name for option in names for name in option.split(",")
            if not re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", plain)]


def variables_of_library():
    found = set()
    for folder in ("libsmart", "compat"):
        for path in (ROOT / folder).rglob("*.cpp"):
            found |= set(re.findall(r'getenv\("(OPENRT_\w+)"\)', path.read_text(encoding="utf-8")))
    return found


class Pages(unittest.TestCase):
    def test_every_program(self):
        text = (ROOT / "docs/CMakeLists.txt").read_text(encoding="utf-8")
        named = set(re.search(r"foreach\(program ([^)]*)\)", text)[1].split())
        self.assertEqual(set(ABOUT), named)
        completion = (ROOT / "samples/tools/completion.bash").read_text(encoding="utf-8")
        self.assertEqual(set(re.findall(r"openrt-\w+", completion.split("complete -o")[1])), named)

    def test_what_pages_say(self):
        for name, text in ABOUT.items():
            with self.subTest(page=name):
                self.assertRegex(text, rf"\[NAME\]\n{name} - \w")
                status = text.partition("[EXIT STATUS]\n")[2].partition("\n[")[0]
                self.assertEqual(re.findall(r"^\.TP\n(\d)$", status, re.MULTILINE)[:3],
                                 ["0", "1", "2"])
                for part in ("[EXAMPLES]", "[SEE ALSO]", "[ENVIRONMENT]"):
                    self.assertIn(part, text)
                self.assertNotIn(f"{name} (1)", text.partition("[SEE ALSO]")[2])
                self.assertEqual("[ENVIRONMENT]\n@ENVIRONMENT@\n" in text,
                                 name not in WITHOUT_LIBRARY)

    def test_environment(self):
        text = (ROOT / "docs/man/environment.roff").read_text(encoding="utf-8")
        self.assertEqual(set(re.findall(r"^\.TP\n(OPENRT_\w+)$", text, re.MULTILINE)),
                         variables_of_library())
        self.assertIn("OPENRT_THREADS", variables_of_library())

    @unittest.skipUnless(HELP2MAN, "no help2man")
    def test_made_pages(self):
        count = 0
        for name in ABOUT:
            program = BUILD / "bin" / name
            if not program.exists():
                continue
            with self.subTest(page=name), tempfile.TemporaryDirectory() as folder:
                page = pathlib.Path(folder, f"{name}.1")
                subprocess.run([sys.executable, "-B", ROOT / "docs/site/program_page.py", HELP2MAN,
                                program, ROOT / f"docs/man/{name}.h2m", page], check=True)
                made = page.read_text(encoding="utf-8")
                for text in helps(program):
                    self.assertEqual(missing_options(text, made), [])
                self.assertNotIn("@ENVIRONMENT@", made)
                if shutil.which("groff"):
                    found = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z", page],
                                           capture_output=True, text=True, check=True)
                    self.assertEqual(found.stderr, "")
                count += 1
        self.assertGreater(count, 0)


class Parts(unittest.TestCase):
    HELP = ("plays it\nUsage: player play [OPTIONS] FILE\n\nPositionals:\n"
            "  FILE TEXT REQUIRED          a file\n\nOptions:\n"
            "  -h,--help                   Print this\n"
            "  --only-some UINT:INT in [1 - 16384]=1\n"
            "                              of them,\n"
            "                              one by one\n\n")

    def test_subcommand(self):
        self.assertEqual(subcommand("play", self.HELP), "[SUBCOMMAND PLAY]\n"
                         ".B player play [OPTIONS] FILE\n.PP\nplays it\n"
                         ".TP\n\\fBFILE TEXT REQUIRED\\fR\na file\n"
                         ".TP\n\\fB\\-h,\\-\\-help\\fR\nPrint this\n"
                         ".TP\n\\fB\\-\\-only\\-some UINT:INT in [1 \\- 16384]=1\\fR\n"
                         "of them, one by one\n\n")
        self.assertEqual(entries(parts(self.HELP)["Positionals"]), [("FILE TEXT REQUIRED", "a file")])

    def test_missing_options(self):
        page = subcommand("play", self.HELP)
        self.assertEqual(missing_options(self.HELP, page), [])
        self.assertEqual(missing_options(self.HELP, page.replace("some", "few")), ["--only-some"])
        self.assertEqual(missing_options(self.HELP, page.replace("only", "if\\-only")),
                         ["--only-some"])


if __name__ == "__main__":
    unittest.main()
