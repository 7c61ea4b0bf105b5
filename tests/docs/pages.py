# SPDX-License-Identifier: MIT
"""The project's pages in Markdown, taken apart: links, anchors and blocks of code."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), ROOT / "compat/python/README.md"])


def without_code(text):
    text = re.sub(r"^```.*?^```", "", text, flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(text):
    """Those that a web page of the repository has: one for each heading, and `id`s."""
    found, used = set(), {}
    code = False
    for line in text.split("\n"):
        if line.startswith("```"):
            code = not code
        heading = re.match(r"#{1,6} (.*)", line)
        if code or not heading:
            continue
        plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading[1]).lower()
        name = re.sub(r"[^\w\- ]", "", plain).strip().replace(" ", "-")
        count = used.get(name, 0)
        used[name] = count + 1
        found.add(f"{name}-{count}" if count else name)
    return found | set(re.findall(r'\b(?:id|name)="([^"]+)"', text))


def links(text):
    return re.findall(r"!?\[[^]]*\]\(([^)\s]+)(?:\s[^)]*)?\)", without_code(text))


def broken_links(page, text):
    """The links of a page within the repository that lead nowhere."""
    broken = []
    for link in links(text):
        if re.match(r"[a-z]+:", link):
            continue
        target, _, anchor = link.partition("#")
        path = (page.parent / target).resolve() if target else page
        if not path.exists():
            broken.append(link)
        elif anchor and path.suffix == ".md":
            where = text if path == page else path.read_text(encoding="utf-8")
            if anchor not in anchors(where):
                broken.append(link)
    return broken


def blocks(text, language):
    return re.findall(rf"^```{language}\n(.*?)^```", text, flags=re.DOTALL | re.MULTILINE)


def commands(text):
    """The lines of shell blocks, continued ones joined, without comments."""
    for block in blocks(text, "sh"):
        for line in block.replace("\\\n", " ").split("\n"):
            line = re.sub(r"(^|\s)#.*", "", line).strip()
            if line:
                yield line
    for line in re.findall(r"^ {4}(openrt-.*)$", text, flags=re.MULTILINE):
        yield line


def code_blocks(text):
    """(language, text) of every block of code, fenced or indented by four columns."""
    found, fence, indented, blank = [], None, [], True
    for line in [*text.split("\n"), ""]:
        if fence is not None:
            if line.startswith("```"):
                found.append((fence[0], "".join(fence[1:])))
                fence = None
            else:
                fence.append(line + "\n")
        elif line.startswith("    ") and (blank or indented):
            indented.append(line[4:] + "\n")
        elif indented and not line:
            indented.append("\n")
        else:
            if indented:
                found.append(("", "".join(indented).rstrip("\n") + "\n"))
            indented = []
            if line.startswith("```"):
                fence = [line[3:].strip()]
        blank = not line
    return found
