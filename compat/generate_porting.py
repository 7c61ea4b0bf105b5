# SPDX-License-Identifier: MIT
"""The table of functions in docs/porting.md: what each of OpenGL, GLU and GLUT is here."""

BEGIN = "<!-- table: written by compat/generate_calls.py -->"
END = "<!-- end of table -->"
LIBRARIES = [("gl", "OpenGL 1.5", "rt", "gl"), ("glu", "GLU 1.3", "rtu", "glu"),
             ("glut", "GLUT 3.7", "rtut", "glut")]


def support(row):
    """same, approximated or refused."""
    if row["status"] == "refused":
        return "refused"
    return "approximated" if row["how"] else "same"


def explanation(row, library):
    if row["status"] != "refused":
        return row["how"]
    error = "a message, once" if library == "glut" else "`RT_INVALID_OPERATION`, once"
    return f"{error}; {row['how']}" if row["how"] else error


def counts(rows):
    kinds = [support(row) for row in rows]
    return ", ".join(f"{kinds.count(kind)} {kind}" for kind in ("same", "approximated", "refused"))


def table(tables):
    out = []
    for library, title, ours, theirs in LIBRARIES:
        rows = tables[library]
        out += [f"### {title}", "", f"{len(rows)} functions: {counts(rows)}.", "",
                f"| {title.split()[0]} | here | support | how, or which error |", "|-|-|-|-|"]
        for row in rows:
            name = row["name"]
            out.append(f"| `{theirs}{name[len(ours):]}` | `{name}` | {support(row)} | "
                       f"{explanation(row, library)} |")
        out.append("")
    return "\n".join(out)


def generate(root, tables):
    """The page with its table made anew."""
    path = "docs/porting.md"
    text = (root / path).read_text(encoding="utf-8")
    head, found, rest = text.partition(BEGIN)
    _, ended, tail = rest.partition(END)
    if not found or not ended:
        raise SystemExit(f"{path}: the marks around the table are missing")
    return {path: f"{head}{BEGIN}\n\n{table(tables)}\n{END}{tail}"}
