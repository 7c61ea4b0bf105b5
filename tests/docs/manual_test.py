#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The manual, which the site's filter makes of the public headers, says of every function what it
does, its errors, the threads that may call it, the release that brought it and what it comes from.

usage: manual_test.py [unittest arguments]
"""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "docs/site"), str(ROOT / "tests/calls")]

import api_functions  # noqa: E402
import manual_fields  # noqa: E402
from header_filter import convert  # noqa: E402
from tidy_manual import with_synopsis  # noqa: E402

FIELDS = {"errors": "@par Errors", "threads": "@par Threads", "since": "@since ",
          "source": "@par Source"}
PAGE = re.compile(r"/\*\* ((?:[^*]|\*(?!/))*) \*/\n((?:RTAPI [^;]*;\n)+)")


def pages(text, header):
    """(function, the text of its page) of a header."""
    for page, calls in PAGE.findall(convert(text, header)):
        for name in re.findall(r"RTAPIENTRY (rt\w+)\(", calls):
            yield name, page


def missing(text, header):
    """What the pages of a header do not say."""
    found, seen = [], set()
    for name, page in pages(text, header):
        seen.add(name)
        found += [f"{name}: {field}" for field, mark in FIELDS.items() if mark not in page]
        if re.search(r"@par Source\n \* *$", page):
            found.append(f"{name}: source; is it in compat/own_calls.csv?")
        what = re.split(r"\n \* @", page)[0]
        if len(re.sub(r"\W", "", what)) < 5:
            found.append(f"{name}: what it does")
    declared = [name for _, name, _ in
                api_functions.DECLARATION.findall(api_functions.without_comments(text))]
    return found + [f"{name}: no page" for name in declared if name not in seen]


def release(text):
    return tuple(int(part) for part in text.split(".")[:2])


def of_the_future(text, header, version):
    """Functions that a release brought which is not out yet, nor the next one."""
    return [f"{name}: {since}" for name, page in pages(text, header)
            for since in re.findall(r"@since ([\d.]+)", page) if release(since) > release(version)]


class Manual(unittest.TestCase):
    def test_every_function(self):
        count = 0
        version = re.search(r"project\(OpenRT VERSION ([\d.]+)",
                            (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        for path in sorted((ROOT / "include/openrt").glob("*.h")):
            text = path.read_text(encoding="utf-8")
            with self.subTest(header=path.name):
                self.assertEqual(missing(text, path.name), [])
                self.assertEqual(of_the_future(text, path.name, version), [])
            count += len(list(pages(text, path.name)))
        self.assertGreater(count, 700)

    def test_sources_are_of_functions(self):
        """No row is of the past, but for names that are macros."""
        declared = {name for path in (ROOT / "include/openrt").glob("*.h")
                    for name in re.findall(r"\b(rt\w+)\b", path.read_text(encoding="utf-8"))}
        self.assertEqual(sorted(set(manual_fields.sources()) - declared), [])

    def test_synopsis(self):
        """Each header names what programs include."""
        made = r"\fC#include 'openrt/{}\&.h'\fP" + "\n.br\n"
        page = ".PP\n" + made.format("rtu_enums") + made.format("types") + "\n.SS Functions\n"
        for header, whole in (("rt_queue.h", "rt.h"), ("rtu.h", "rtu.h"), ("rtut.h", "rtut.h")):
            self.assertEqual(with_synopsis(page, header), ".PP\n" rf"\fC#include <openrt/{whole}>\fP"
                             "\n.br\n\n.SS Functions\n")
        self.assertEqual(with_synopsis(".so man3/rt_queue.h.3.gz\n", "rtQueueView"),
                         ".so man3/rt_queue.h.3.gz\n")

    def test_controls(self):
        call = "RTAPI void RTAPIENTRY rtInit(int *argcp, char *argv[]);\n"
        begin = "/* SPDX-License-Identifier: MIT */\n/* A header. */\n"
        good = begin + "/* Starts it.\n * Threads: any. Since: 0.1 */\n" + call
        self.assertEqual(missing(good, "rt_core.h"), [])
        self.assertEqual(missing(good.replace(" Since: 0.1", ""), "rt_core.h"), ["rtInit: since"])
        self.assertEqual(missing(good.replace("rtInit", "rtOfNoTable"), "rt_core.h"),
                         ["rtOfNoTable: source; is it in compat/own_calls.csv?"])
        self.assertEqual(of_the_future(good, "rt_core.h", "0.1.0"), [])
        self.assertEqual(of_the_future(good.replace("0.1 ", "0.2 "), "rt_core.h", "0.1.0"),
                         ["rtInit: 0.2"])
        self.assertEqual(missing(good.replace("Threads: any. ", ""), "rt_core.h"),
                         ["rtInit: threads"])
        self.assertEqual(missing(good.replace("Starts it.", "-"), "rt_core.h"),
                         ["rtInit: what it does"])
        self.assertEqual(missing(good.replace(call, "\n" + call), "rt_core.h"), ["rtInit: no page"])


class Programs(unittest.TestCase):
    """Section 1, of the texts that are put around what --help prints."""

    def test_every_program(self):
        text = (ROOT / "docs/CMakeLists.txt").read_text(encoding="utf-8")
        named = set(re.search(r"foreach\(program ([^)]*)\)", text)[1].split())
        self.assertEqual({path.stem for path in (ROOT / "docs/man").glob("*.h2m")}, named)
        completion = (ROOT / "samples/tools/completion.bash").read_text(encoding="utf-8")
        self.assertEqual(set(re.findall(r"openrt-\w+", completion.split("complete -o")[1])), named)

    def test_what_pages_say(self):
        for path in sorted((ROOT / "docs/man").glob("*.h2m")):
            text = path.read_text(encoding="utf-8")
            with self.subTest(page=path.name):
                self.assertRegex(text, rf"\[NAME\]\n{path.stem} - \w")
                status = text.partition("[EXIT STATUS]\n")[2].partition("\n[")[0]
                self.assertEqual(re.findall(r"^\.TP\n(\d)$", status, re.MULTILINE)[:3],
                                 ["0", "1", "2"])
                for part in ("[EXAMPLES]", "[SEE ALSO]", "[ENVIRONMENT]"):
                    self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main()
