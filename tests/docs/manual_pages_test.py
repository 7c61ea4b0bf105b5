#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Section 3 of the manual: a page for each comment on functions, found under the name of each of them,
with its parts in order; the formatter and the list of all pages take it as it is.

usage: manual_pages_test.py [unittest arguments]
"""
import gzip
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))

from manual_pages import declaration, page_text, pages, pages_of, roff  # noqa: E402

PARTS = ["NAME", "SYNOPSIS", "DESCRIPTION", "ERRORS", "THREADS", "SINCE", "SOURCE", "SEE ALSO"]
WARNINGS = ["groff", "-man", "-Tutf8", "-ww", "-z"]


def warnings(*files):
    return subprocess.run([*WARNINGS, *files], capture_output=True, text=True, check=False).stderr


class ManualPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.man = pathlib.Path(cls.folder.name, "man3")
        subprocess.run([sys.executable, "-B", ROOT / "docs/site/manual_pages.py",
                        ROOT / "include/openrt", cls.man, "1.2.3"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.texts = {path.name.removesuffix(".3.gz"): gzip.decompress(path.read_bytes()).decode()
                     for path in cls.man.glob("*.gz")}
        cls.whole = {name: text for name, text in cls.texts.items() if text.startswith(".TH")}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_function(self):
        for page in pages(ROOT / "include/openrt"):
            text = self.whole[page.names[0]]
            with self.subTest(page=page.names[0]):
                self.assertIn(f".SH NAME\n{', '.join(page.names)} \\- ", text)
                for name in page.names[1:]:
                    self.assertEqual(self.texts[name], f".so man3/{page.names[0]}.3\n")
                if page.calls:
                    synopsis = text.partition(".SH SYNOPSIS")[2].partition(".SH")[0]
                    self.assertEqual(re.findall(r"\b(rt\w+)\(", synopsis), page.names)
                    found = re.findall(r"^\.SH (.*)", text, re.MULTILINE)
                    self.assertEqual(found, PARTS)

    def test_whole_pages(self):
        """No page but those that are linked to, and each link leads to a page."""
        links = {name: text.split("/")[1].strip()[:-2] for name, text in self.texts.items()
                 if name not in self.whole}
        self.assertEqual([name for name, target in links.items() if target not in self.whole], [])
        for text in self.whole.values():
            others = re.findall(r"^\.BR (\S+) \(3\)", text, re.MULTILINE)
            self.assertEqual([name for name in others if name not in self.whole], [])

    def test_lists_and_tables(self):
        self.assertIn(".TP\n\\fB\\-\\-rt\\-threads N\\fP\nthreads that render", self.whole["rtInit"])
        self.assertRegex(self.whole["rtSetAuxBuffer"], r"\n\.nf\nwhat +format +a miss\n(RT_.*\n)+")
        self.assertIn(".TP\n.B RT_INVALID_ENUM\nunknown format\n.TP\n",
                      self.whole["rtSetFrameBuffer"])

    @unittest.skipUnless(shutil.which("groff"), "no groff")
    def test_formatter(self):
        files = []
        for name, text in self.whole.items():
            files.append(pathlib.Path(self.folder.name, name))
            files[-1].write_text(text, encoding="utf-8")
        self.assertEqual(warnings(*files), "")
        files[0].write_text(".NOSUCH\n", encoding="utf-8")
        self.assertIn("NOSUCH", warnings(files[0]))

    @unittest.skipUnless(shutil.which("lexgrog"), "no lexgrog")
    def test_list_of_pages(self):
        files = [self.man / f"{name}.3.gz" for name in self.whole]
        found = subprocess.run(["lexgrog", *files], capture_output=True, text=True, check=True).stdout
        listed = set(re.findall(r': "(\S+) - \S.*"$', found, re.MULTILINE))
        self.assertEqual({name for page in pages(ROOT / "include/openrt") for name in page.names},
                         listed)


class Parts(unittest.TestCase):
    SOURCE = ("/* SPDX-License-Identifier: MIT */\n/* A header. */\n"
              "/* Makes `one` - or two: a\\b\n *   --all  of them\n *   one two  three\n *\n"
              " * .so it is.\n * Errors:  RT_INVALID_ENUM  another\n *            one\n"
              " *          what went wrong\n * Threads: any. Since: 0.1 */\n"
              "RTAPI void RTAPIENTRY rtInit(int *argcp, char *argv[]);\n")

    def test_page(self):
        found = list(pages_of(self.SOURCE, "rt_core.h"))
        self.assertEqual([page.names for page in found], [["rt_core.h"], ["rtInit"]])
        text = page_text(found[1], found, "1.2.3")
        for part in (
                '.TH rtInit 3 "" "OpenRT 1.2.3" OpenRT\n',
                ".SH NAME\nrtInit \\- makes \\fBone\\fP \\- or two\n",
                ".B #include <openrt/rt.h>\n.PP\n\\fBvoid rtInit(int *argcp, char *argv[]);\\fP\n",
                ".SH DESCRIPTION\nMakes \\fBone\\fP \\- or two: a\\eb\n.TP\n",
                ".TP\n\\fB\\-\\-all\\fP\nof them\n.TP\n\\fBone two\\fP\nthree\n.PP\n\\&.so it is.\n",
                ".SH ERRORS\n.TP\n.B RT_INVALID_ENUM\nanother one\n.PP\nwhat went wrong\n",
                ".SH THREADS\nany.\n.SH SINCE\n0.1\n",
                ".SH SEE ALSO\n.BR rt.h (3),\n.BR rt_core.h (3)\n"):
            self.assertIn(part, text)
        self.assertIn(".SH FUNCTIONS\n.TP\n.BR rtInit (3)\n", page_text(found[0], found, "1.2.3"))

    def test_declaration(self):
        self.assertEqual(declaration("RTAPI void RTAPIENTRY rtA(RTuint a,\n    RTuint b);"),
                         ["void rtA(RTuint a, RTuint b);"])
        self.assertEqual(
            declaration("RTAPI void RTAPIENTRY rtA(void(RTAPIENTRY *cb)(void *user), void *user);"),
            ["void rtA(void(*cb)(void *user), void *user);"])
        long = declaration(f"RTAPI void RTAPIENTRY rtA({', '.join(['RTuint number'] * 9)});")
        self.assertEqual([line[:10] for line in long[1:]], [" " * 9 + "R"] * (len(long) - 1))
        self.assertLessEqual(max(map(len, long)), 76)

    def test_roff(self):
        self.assertEqual(roff("'a ~ ^ \\"), "\\&'a \\(ti \\(ha \\e")


if __name__ == "__main__":
    unittest.main()
