# SPDX-License-Identifier: MIT
"""Reads the comments of the public headers: to which functions each belongs, its fields (Errors,
Threads, Source, Since), and the paragraphs, lists and tables that its text consists of."""
import re
import typing

COMMENT = re.compile(r"/\*(?!\*)(.*?)\*/", re.DOTALL)
DIVIDER = re.compile(r"\s*-{4} .* -{4,}\s*")
CALLS = re.compile(r"\n((?:RTAPI [^;]*;\n)+)")
FIELDS = re.compile(r"(?<=[\w.;)]) +(?=Threads: |Since: )")
FIELD = re.compile(r"(Errors|Threads|Source|Since):\s*(?=\S|$)")
COLUMNS = re.compile(r" {2,}")


class Comment(typing.NamedTuple):
    start: int
    end: int
    kind: str    # "header", "calls", "member" (behind it on its line) or "other"
    lines: list  # without the marks of the comment
    calls: str   # the declarations that follow


class Block(typing.NamedTuple):
    kind: str    # "text", "list", "table" or "item": a paragraph whose later lines are indented
    content: list  # lines; of a list (term, text); of an item Blocks


def comments(source):
    """Of a header, after the line of its licence."""
    first = source.index("*/") + 2
    about = True
    for found in COMMENT.finditer(source, first):
        lines = [part for line in found[1].strip().split("\n")
                 for part in FIELDS.split(re.sub(r"^ *\* ?", "", line))]
        calls = CALLS.match(source, found.end())
        if DIVIDER.fullmatch(found[1]):
            kind = "divider"
        elif about:
            kind = "header"
        elif source[source.rfind("\n", 0, found.start()) + 1:found.start()].strip():
            kind = "member"
        else:
            kind = "calls" if calls else "other"
        about = about and kind != "header"
        yield Comment(found.start(), found.end(), kind, lines,
                      calls[1] if calls and kind == "calls" else "")


def functions(calls):
    return re.findall(r"RTAPIENTRY (rt\w+)\(", calls)


def indent(line):
    return len(line) - len(line.lstrip())


def dedent(lines):
    least = min((indent(line) for line in lines if line), default=0)
    return [line[least:] for line in lines]


def split_fields(lines):
    """(lines of the text, {field: its lines}); a field goes on where lines are indented."""
    text, fields, field = [], {}, None
    for line in lines:
        found = FIELD.match(line)
        if found:
            field = fields.setdefault(found[1], [])
            field.append(" " * found.end() + line[found.end():] if line[found.end():] else "")
        elif field is not None and line.startswith("  "):
            field.append(line)
        else:
            field = None
            text.append(line)
    return text, fields


def error_items(lines):
    """(code or "", text) of each line of the field that starts in its first column."""
    items = []
    for line in filter(None, dedent(lines)):
        code, _, text = line.partition("  ")
        if line.startswith(" "):
            items[-1] = (items[-1][0], items[-1][1] + " " + line.strip())
        elif re.fullmatch(r"RT_[A-Z_]+", code):
            items.append((code, text.strip()))
        else:
            items.append(("", line))
    return items


def two_columns(lines):
    """[(term, text)] of lines in two columns; None where they are none."""
    rows, outer = [], indent(lines[0])
    for line in lines:
        cells = COLUMNS.split(line.strip())
        if indent(line) == outer and len(cells) == 2:
            rows.append(tuple(cells))
        elif indent(line) > outer and rows and len(cells) == 1:
            rows[-1] = (rows[-1][0], rows[-1][1] + " " + cells[0])
        else:
            return None
    return rows


def blocks(lines):
    """The Blocks of a text."""
    result, paragraph, position = [], [], 0

    def end_paragraph():
        if paragraph:
            result.append(Block("text", paragraph[:]))
            paragraph.clear()

    while position < len(lines):
        line = lines[position]
        if indent(line) < 2:
            if line.strip():
                paragraph.append(line)
            else:
                end_paragraph()
            position += 1
            continue
        end = position
        while end < len(lines) and (indent(lines[end]) >= 2 or (
                not lines[end].strip() and indent("".join(lines[end + 1:end + 2])) >= 2)):
            end += 1
        run, position = lines[position:end], end
        rows = two_columns(run)
        if rows:
            end_paragraph()
            result.append(Block("list", rows))
        elif paragraph and indent(run[0]) == 2 and not COLUMNS.search(run[0].strip()):
            head = paragraph.pop()
            end_paragraph()
            result.append(Block("item", blocks([head, *dedent(run)])))
        else:
            end_paragraph()
            result.append(Block("table", dedent(run)))
    end_paragraph()
    return result
