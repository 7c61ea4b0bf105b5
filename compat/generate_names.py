# SPDX-License-Identifier: MIT
"""The headers below openrt/gl that give the library's names those of OpenGL, GLU and GLUT."""
import re

# Tokens of OpenGL 1.5 whose value is the library's own; openrt/enums.h defines them by hand.
OWN_TOKENS = ["NO_ERROR", "INVALID_ENUM", "INVALID_VALUE", "INVALID_OPERATION", "STACK_OVERFLOW",
              "STACK_UNDERFLOW", "OUT_OF_MEMORY", "TRIANGLES", "TRIANGLE_STRIP", "TRIANGLE_FAN",
              "QUADS", "QUAD_STRIP", "POLYGON", "COMPILE", "COMPILE_AND_EXECUTE", "BYTE",
              "UNSIGNED_BYTE", "SHORT", "UNSIGNED_SHORT", "INT", "UNSIGNED_INT", "FLOAT",
              "2_BYTES", "3_BYTES", "4_BYTES", "DOUBLE"]
VERSIONS = ["1_1", "1_2", "1_3", "1_4", "1_5"]
DEFINITION = re.compile(r"^#\s*define\s+(\w+)\b", re.MULTILINE)


def header(name, note, title, names, more=()):
    """`names`: pairs (name elsewhere, name here)."""
    guard = f"OPENRT_GL_{name.upper()}_H"
    out = ["/* SPDX-License-Identifier: MIT */", f"/* {note} */", f"/* {title} */",
           f"#ifndef {guard}", f"#define {guard}", ""]
    out += [f"#define {old} {new}" for old, new in names]
    return "\n".join([*out, *more, "", "#endif", ""])


def functions(rows, ours, theirs):
    return [(theirs + row["name"][len(ours):], row["name"]) for row in rows]


def tokens_defined(text, ours, theirs):
    """The tokens that a header of ours defines, as pairs."""
    return [(theirs + name[len(ours):], name) for name in DEFINITION.findall(text)
            if name.startswith(ours)]


def extension_names(extensions, calls, gl_tokens):
    """Lines that define the names of extensions. Tokens are defined as numbers, as in glext.h, so
    that programs that define them themselves say the same."""
    known = {row["token"]: row["value"] for row in gl_tokens}
    known |= {row["name"]: row["name"] for row in calls if row["status"] == "core"}
    out, extension = [], None
    for row in extensions:
        if row["core"] not in known:
            raise SystemExit(f"{row['name']}: {row['core']} is no core function, nor a token that "
                             "has OpenGL's value")
        if row["extension"] != extension:
            extension = row["extension"]
            out += ["", f"/* {extension} */"]
        out.append(f"#define {row['name']} {known[row['core']]}")
    return out[1:]


def generate(root, note, tables, gl_tokens, extensions):
    """Path -> text; `tables`: the rows of functions of gl, glu and glut."""
    def path(name):
        return f"include/openrt/gl/{name}.h"

    def text(name):
        return (root / "include/openrt" / name).read_text(encoding="utf-8")

    own = [(f"GL_{name}", f"RT_{name}") for name in OWN_TOKENS]
    versions = [""] + [f"#define GL_VERSION_{v} 1" for v in VERSIONS]

    def tokens_of(*wanted):
        return [("GL_" + row["token"][3:], row["token"]) for row in gl_tokens
                if row["version"] in wanted]

    return {
        path("extensions"): header("extensions", note,
                                   "Names of OpenGL's extensions for what became core in 1.1 to "
                                   "1.5.", [],
                                   extension_names(extensions, tables["gl"], gl_tokens)),
        path("functions"): header("functions", note, "The functions of OpenGL 1.5.",
                                  functions(tables["gl"], "rt", "gl")),
        path("tokens_1_1"): header("tokens_1_1", note, "The tokens of OpenGL 1.0 and 1.1.",
                                   own + tokens_of("1.1"), versions),
        path("tokens_1_5"): header("tokens_1_5", note, "The tokens of OpenGL 1.2 to 1.5.",
                                   tokens_of("1.2", "1.3", "1.4", "1.5")),
        path("glu_names"): header("glu_names", note, "The functions and tokens of GLU 1.3.",
                                  functions(tables["glu"], "rtu", "glu") +
                                  tokens_defined(text("rtu_enums.h"), "RTU_", "GLU_")),
        path("glut_names"): header("glut_names", note, "The functions and tokens of GLUT 3.7.",
                                   functions(tables["glut"], "rtut", "glut") +
                                   tokens_defined(text("rtut_enums.h"), "RTUT_", "GLUT_")),
    }
