#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Looks at the built site (target `docs`): each link within it leads to a page and a place there,
and no page loads anything from elsewhere.

    site_links.py BUILD/docs/html
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

LOADED = {"img": "src", "script": "src", "link": "href", "iframe": "src", "source": "src"}
LINKS = {**LOADED, "a": "href", "area": "href"}


class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.places, self.links, self.loaded = set(), set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places |= {attributes[key] for key in ("id", "name") if attributes.get(key)}
        target = attributes.get(LINKS.get(tag, ""))
        if target:
            self.links.add(target)
            if tag in LOADED:
                self.loaded.add(target)


def is_elsewhere(link):
    return re.match(r"[a-z]+:|//", link)


def problems(site):
    pages = {path: Page(path.read_text(encoding="utf-8", errors="replace"))
             for path in sorted(site.rglob("*.html"))}
    for path, page in pages.items():
        name = path.relative_to(site)
        for link in sorted(page.loaded):
            if is_elsewhere(link) and not link.startswith(("data:", "javascript:")):
                yield f"{name}: loads {link}"
        for link in sorted(page.links):
            if is_elsewhere(link):
                continue
            file, _, place = urllib.parse.unquote(link).partition("#")
            target = (path.parent / file).resolve() if file else path
            if not target.exists():
                yield f"{name}: {link}: no such file"
            elif place and target in pages and place not in pages[target].places:
                yield f"{name}: {link}: no such place"


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    if not (site / "index.html").exists():
        sys.exit(f"{site}: no site")
    found = list(problems(site))
    print("\n".join(found) or "every link of the site leads somewhere")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
