#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The manual, which is made of the comments of the public headers, says of every function what it
does, its errors, the threads that may call it, the release that brought it and what it comes from;
and each page says it in full, as nobody sees the comments beside it.

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
import manual_pages  # noqa: E402
from header_comments import comments, error_items, functions, split_fields  # noqa: E402
from header_filter import convert  # noqa: E402
from manual_pages import pages_of, summary  # noqa: E402

FIELDS = ("Errors", "Threads", "Since", "Source")
ERRORS = re.compile(r"\berrors?\b|\bRT_(INVALID_[EVO]\w+|STACK_\w+|OUT_OF_MEMORY)", re.IGNORECASE)
BESIDE = re.compile(r"^The same\b|\bcalls (above|below)\b|\bas (above|below|of these|of those)\b|"
                    r"\berrors:? +as there\b", re.IGNORECASE)


def pages(text, header):
    return [page for page in pages_of(text, header) if page.calls]


def missing(text, header):
    """What the pages of a header do not say."""
    found, seen = [], set()
    for page in pages(text, header):
        seen.update(page.names)
        found += [f"{page.names[0]}: {field}" for field in FIELDS if field not in page.fields]
        found += [f"{name}: source; is it in compat/own_calls.csv?" for name in page.names
                  if name not in manual_fields.sources()]
        if len(re.sub(r"\W", "", " ".join(page.lines))) < 5:
            found.append(f"{page.names[0]}: what it does")
    declared = [name for _, name, _ in
                api_functions.DECLARATION.findall(api_functions.without_comments(text))]
    return found + [f"{name}: no page" for name in declared if name not in seen]


def not_said(text):
    """Comments that speak of errors and have no field of them, or a field that is not in its form;
    and those that mean comments beside them."""
    found = []
    for part in comments(text):
        if not part.calls:
            continue
        name = functions(part.calls)[0]
        lines, fields = split_fields(part.lines)
        prose, errors = " ".join(lines), fields.get("Errors", [])
        if ERRORS.search(prose) and not errors:
            found.append(f"{name}: speaks of errors without saying which")
        found += [f"{name}: no code and text: {text}" for code, text in error_items(errors)
                  if not code and re.search(r"\bRT_(INVALID|STACK|OUT)_", text)]
        if BESIDE.search(prose + " errors: " + " ".join(errors).strip()):
            found.append(f"{name}: means what stands beside it")
    return found


def bad_summary(page):
    text = summary(page.lines)
    return (not 10 <= len(text) <= 100 or " " not in text or text.count("(") != text.count(")"))


def release(text):
    return tuple(int(part) for part in text.split(".")[:2])


def of_the_future(text, header, version):
    """Functions that a release brought which is not out yet, nor the next one."""
    return [f"{name}: {since.strip()}" for page in pages(text, header) for name in page.names
            for since in page.fields.get("Since", []) if release(since) > release(version)]


class Manual(unittest.TestCase):
    def test_every_function(self):
        count = 0
        version = re.search(r"project\(OpenRT VERSION ([\d.]+)",
                            (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
        for path in sorted((ROOT / "include/openrt").glob("*.h")):
            text = path.read_text(encoding="utf-8")
            with self.subTest(header=path.name):
                self.assertEqual(missing(text, path.name), [])
                self.assertEqual(not_said(text), [])
                self.assertEqual(of_the_future(text, path.name, version), [])
            count += sum(len(page.names) for page in pages(text, path.name))
        self.assertGreater(count, 700)

    def test_summaries(self):
        """What the list of all pages says of each, of those of headers too."""
        found = list(manual_pages.pages(ROOT / "include/openrt"))
        self.assertEqual([page.names[0] for page in found if bad_summary(page)], [])
        self.assertGreater(len(found), 150)

    def test_sources_are_of_functions(self):
        """No row is of the past, but for names that are macros."""
        declared = {name for path in (ROOT / "include/openrt").glob("*.h")
                    for name in re.findall(r"\b(rt\w+)\b", path.read_text(encoding="utf-8"))}
        self.assertEqual(sorted(set(manual_fields.sources()) - declared), [])

    def test_errors_of_all(self):
        """What a header says of all its functions stands where their parameters allow it."""
        text = (ROOT / "include/openrt/rt_fixed.h").read_text(encoding="utf-8")
        codes = {page.names[0]: [code for code, _ in error_items(page.fields["Errors"])]
                 for page in pages(text, "rt_fixed.h")}
        enum, value, operation = ("RT_INVALID_ENUM", "RT_INVALID_VALUE", "RT_INVALID_OPERATION")
        self.assertEqual(codes["rtLightf"], [enum, value, operation])
        self.assertEqual(codes["rtShadeModel"], [enum, operation])
        self.assertEqual(codes["rtEdgeFlag"], [value, operation])
        self.assertEqual(codes["rtFogf"], [operation, enum, value, operation])

    def test_site(self):
        """What Doxygen gets: fields, lists and tables."""
        core, frame = (convert((ROOT / "include/openrt" / name).read_text(encoding="utf-8"), name)
                       for name in ("rt_core.h", "rt_frame.h"))
        self.assertIn("\n- `--rt-threads N`: threads that render", core)
        self.assertIn(": for rtut windows, as \\--rt-size WxH", core)
        self.assertIn("\n@par Threads\nany.\n@since 0.1\n@par Source\n", core)
        self.assertRegex(frame, r"\n@verbatim\nwhat +format +a miss\n(RT_.*\n)+@endverbatim\n")
        self.assertIn("\n@par Errors\n- `RT_INVALID_ENUM`: unknown format\n", frame)


class Controls(unittest.TestCase):
    CALL = "RTAPI void RTAPIENTRY rtInit(int *argcp, char *argv[]);\n"
    BEGIN = "/* SPDX-License-Identifier: MIT */\n/* A header. */\n"
    GOOD = BEGIN + "/* Starts the library.\n * Threads: any. Since: 0.1 */\n" + CALL

    def test_missing(self):
        self.assertEqual(missing(self.GOOD, "rt_core.h"), [])
        for old, new, found in (
                (" Since: 0.1", "", "rtInit: Since"),
                ("Threads: any. ", "", "rtInit: Threads"),
                ("Starts the library.", "-", "rtInit: what it does"),
                (self.CALL, "\n" + self.CALL, "rtInit: no page"),
                ("rtInit", "rtOfNoTable", "rtOfNoTable: source; is it in compat/own_calls.csv?")):
            with self.subTest(found=found):
                self.assertEqual(missing(self.GOOD.replace(old, new), "rt_core.h"), [found])

    def test_future(self):
        self.assertEqual(of_the_future(self.GOOD, "rt_core.h", "0.1.0"), [])
        self.assertEqual(of_the_future(self.GOOD.replace("0.1 ", "0.2 "), "rt_core.h", "0.1.0"),
                         ["rtInit: 0.2"])

    def said(self, text):
        return not_said(self.GOOD.replace("Starts the library.", text))

    def test_errors_in_prose(self):
        silent, beside = ("rtInit: speaks of errors without saying which",
                          "rtInit: means what stands beside it")
        self.assertEqual(self.said("Starts it."), [])
        self.assertEqual(self.said("Starts it. NULL on error.\n * Errors:  None."), [])
        self.assertEqual(self.said("Starts it (RT_INVALID_VALUE if it can not)."), [silent])
        self.assertEqual(self.said("Starts it. Errors and threads as in the call before."), [silent])
        self.assertEqual(self.said("Starts it.\n * Errors (in the context):\n"
                                   " *          RT_INVALID_ENUM  another"), [silent])
        self.assertEqual(self.said("The same for a string."), [beside])
        self.assertEqual(self.said("Starts it.\n * Errors:  as above"), [beside])
        self.assertEqual(self.said("Starts it. Errors as there."), [silent, beside])
        self.assertEqual(self.said("Starts it.\n * Errors:  RT_INVALID_ENUM another; none"),
                         ["rtInit: no code and text: RT_INVALID_ENUM another; none"])

    def test_summary(self):
        def judged(text):
            return [bad_summary(page) for page in
                    pages(self.GOOD.replace("Starts the library", text), "rt_core.h")]
        self.assertEqual(judged("Starts the library"), [False])
        self.assertEqual(judged("RT_SMOOTH: where colours are computed"), [True])
        self.assertEqual(judged("Samples of it (start: of the pixel) and more"), [True])
        self.assertEqual(judged("Starts " + "very " * 20 + "slowly"), [True])


if __name__ == "__main__":
    unittest.main()
