#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a program that makes every call of OpenGL with every kind of illegal argument.

compat/gl_calls.csv says which functions and parameters there are; the table below what a legal call
looks like. Each function becomes one case: the legal call, then one call for each parameter and
each illegal value of its type, the call between glBegin and glEnd, and with names that were
deleted. The library makes it inside an object definition too. Told are the error and every value
of state that has changed.

Where OpenGL says nothing (NULL, NaN, infinity) only the library makes the call: it must survive,
and a call that records an error must change nothing.
"""
import argparse
import csv
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Arguments of a legal call, where those of DEFAULTS will not do.
LEGAL = {
    "Enable": "GL_FOG", "Disable": "GL_DITHER", "IsEnabled": "GL_FOG",
    "GetBooleanv": "GL_FOG_DENSITY, memory", "GetDoublev": "GL_FOG_DENSITY, memory",
    "GetFloatv": "GL_FOG_DENSITY, memory", "GetIntegerv": "GL_FOG_MODE, memory",
    "PushAttrib": "GL_CURRENT_BIT", "PushClientAttrib": "GL_CLIENT_PIXEL_STORE_BIT",
    "GetString": "GL_VERSION", "Hint": "GL_FOG_HINT, GL_NICEST", "Begin": "GL_POINTS",
    "MatrixMode": "GL_TEXTURE", "Viewport": "1, 2, 3, 4", "Scissor": "1, 2, 3, 4",
    "EnableClientState": "GL_VERTEX_ARRAY", "DisableClientState": "GL_VERTEX_ARRAY",
    "VertexPointer": "3, GL_FLOAT, 12, memory", "NormalPointer": "GL_FLOAT, 12, memory",
    "ColorPointer": "4, GL_UNSIGNED_BYTE, 4, memory", "IndexPointer": "GL_FLOAT, 4, memory",
    "TexCoordPointer": "2, GL_FLOAT, 8, memory", "EdgeFlagPointer": "1, memory",
    "FogCoordPointer": "GL_FLOAT, 4, memory", "GetPointerv": "GL_VERTEX_ARRAY_POINTER, memory",
    "SecondaryColorPointer": "3, GL_FLOAT, 12, memory", "DrawArrays": "GL_TRIANGLES, 0, 3",
    "DrawElements": "GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, memory",
    "DrawRangeElements": "GL_TRIANGLES, 0, 3, 3, GL_UNSIGNED_BYTE, memory",
    "InterleavedArrays": "GL_V3F, 0, memory", "ClientActiveTexture": "GL_TEXTURE0",
    "MultiDrawArrays": "GL_TRIANGLES, ints, ints, 1",
    "MultiDrawElements": "GL_TRIANGLES, ints, GL_UNSIGNED_BYTE, pointers, 1",
    "BindBuffer": "GL_ARRAY_BUFFER, 0", "BufferData": "GL_ARRAY_BUFFER, 8, memory, GL_STATIC_DRAW",
    "BufferSubData": "GL_ARRAY_BUFFER, 0, 4, memory",
    "GetBufferSubData": "GL_ARRAY_BUFFER, 0, 4, memory",
    "MapBuffer": "GL_ARRAY_BUFFER, GL_READ_ONLY", "UnmapBuffer": "GL_ARRAY_BUFFER",
    "GetBufferParameteriv": "GL_ARRAY_BUFFER, GL_BUFFER_SIZE, memory",
    "GetBufferPointerv": "GL_ARRAY_BUFFER, GL_BUFFER_MAP_POINTER, memory",
    "NewList": "list, GL_COMPILE", "CallLists": "1, GL_UNSIGNED_BYTE, memory",
    "DeleteLists": "list, 1", "CallList": "list", "ShadeModel": "GL_FLAT",
    "Lightf": "GL_LIGHT0, GL_SPOT_CUTOFF, 20", "Lighti": "GL_LIGHT0, GL_SPOT_CUTOFF, 20",
    "Lightfv": "GL_LIGHT0, GL_DIFFUSE, floats", "Lightiv": "GL_LIGHT0, GL_POSITION, ints",
    "GetLightfv": "GL_LIGHT0, GL_DIFFUSE, memory", "GetLightiv": "GL_LIGHT0, GL_POSITION, memory",
    "LightModelf": "GL_LIGHT_MODEL_TWO_SIDE, 1", "LightModeli": "GL_LIGHT_MODEL_TWO_SIDE, 1",
    "LightModelfv": "GL_LIGHT_MODEL_AMBIENT, floats",
    "LightModeliv": "GL_LIGHT_MODEL_AMBIENT, ints",
    "Materialf": "GL_FRONT, GL_SHININESS, 3", "Materiali": "GL_FRONT, GL_SHININESS, 3",
    "Materialfv": "GL_FRONT, GL_DIFFUSE, floats", "Materialiv": "GL_BACK, GL_SPECULAR, ints",
    "GetMaterialfv": "GL_FRONT, GL_DIFFUSE, memory",
    "GetMaterialiv": "GL_FRONT, GL_DIFFUSE, memory", "ColorMaterial": "GL_FRONT, GL_SPECULAR",
    "Fogf": "GL_FOG_DENSITY, 0.25f", "Fogi": "GL_FOG_START, 3", "Fogfv": "GL_FOG_COLOR, floats",
    "Fogiv": "GL_FOG_MODE, fogModes", "AlphaFunc": "GL_LESS, 0.5f",
    "BlendFunc": "GL_ONE, GL_SRC_ALPHA", "LogicOp": "GL_XOR", "CullFace": "GL_FRONT",
    "FrontFace": "GL_CW", "PolygonMode": "GL_FRONT, GL_LINE",
    "ClipPlane": "GL_CLIP_PLANE0, doubles", "GetClipPlane": "GL_CLIP_PLANE0, memory",
    "DepthFunc": "GL_GREATER", "StencilFunc": "GL_EQUAL, 1, 255",
    "StencilOp": "GL_ZERO, GL_INCR, GL_REPLACE", "BlendEquation": "GL_FUNC_SUBTRACT",
    "BlendFuncSeparate": "GL_ONE, GL_ZERO, GL_SRC_ALPHA, GL_ONE", "Clear": "GL_COLOR_BUFFER_BIT",
    "DrawBuffer": "GL_FRONT", "ReadBuffer": "GL_FRONT",
    "TexGend": "GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP",
    "TexGenf": "GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP",
    "TexGeni": "GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP",
    "TexGendv": "GL_S, GL_OBJECT_PLANE, doubles", "TexGenfv": "GL_T, GL_EYE_PLANE, floats",
    "TexGeniv": "GL_S, GL_OBJECT_PLANE, ints",
    "GetTexGendv": "GL_S, GL_OBJECT_PLANE, memory", "GetTexGenfv": "GL_S, GL_OBJECT_PLANE, memory",
    "GetTexGeniv": "GL_S, GL_TEXTURE_GEN_MODE, memory",
    "TexEnvf": "GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL",
    "TexEnvi": "GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL",
    "TexEnvfv": "GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, floats",
    "TexEnviv": "GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, ints",
    "GetTexEnvfv": "GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, memory",
    "GetTexEnviv": "GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, memory",
    "TexParameterf": "GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 5",
    "TexParameteri": "GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP",
    "TexParameterfv": "GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, floats",
    "TexParameteriv": "GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, ints",
    "GetTexParameterfv": "GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, memory",
    "GetTexParameteriv": "GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, memory",
    "GetTexImage": "GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, memory",
    "GetTexLevelParameterfv": "GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, memory",
    "GetTexLevelParameteriv": "GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, memory",
    "TexImage1D": "GL_TEXTURE_1D, 0, GL_RGB, 4, 0, GL_RGB, GL_UNSIGNED_BYTE, memory",
    "TexImage2D": "GL_TEXTURE_2D, 0, GL_RGB, 4, 8, 0, GL_RGB, GL_UNSIGNED_BYTE, memory",
    "BindTexture": "GL_TEXTURE_2D, 0",
    "TexSubImage1D": "GL_TEXTURE_1D, 0, 0, 2, GL_RGB, GL_UNSIGNED_BYTE, memory",
    "TexSubImage2D": "GL_TEXTURE_2D, 0, 0, 0, 2, 2, GL_RGB, GL_UNSIGNED_BYTE, memory",
    "CopyTexImage1D": "GL_TEXTURE_1D, 0, GL_RGB, 0, 0, 4, 0",
    "CopyTexImage2D": "GL_TEXTURE_2D, 0, GL_RGB, 0, 0, 4, 8, 0",
    "CopyTexSubImage1D": "GL_TEXTURE_1D, 0, 0, 0, 0, 2",
    "CopyTexSubImage2D": "GL_TEXTURE_2D, 0, 0, 0, 0, 0, 2, 2",
    "ActiveTexture": "GL_TEXTURE0", "PixelStoref": "GL_UNPACK_ROW_LENGTH, 3",
    "PixelStorei": "GL_PACK_ALIGNMENT, 2", "PixelTransferf": "GL_RED_SCALE, 0.5f",
    "PixelTransferi": "GL_RED_BIAS, 1", "Bitmap": "8, 2, 0, 0, 1, 2, memory",
    "PixelZoom": "2, 3", "ReadPixels": "0, 0, 2, 2, GL_RGB, GL_UNSIGNED_BYTE, memory",
    "DrawPixels": "2, 2, GL_RGB, GL_UNSIGNED_BYTE, memory",
    "CopyPixels": "0, 0, 2, 2, GL_COLOR", "RenderMode": "GL_RENDER",
    "Frustum": "-1, 1, -2, 2, 1, 10", "Ortho": "-1, 1, -2, 2, 1, 10",
    "LineStipple": "2, 0xF0F0", "PointSize": "3", "LineWidth": "3", "DepthRange": "0.25, 0.75",
    "Rotatef": "30, 0, 0, 1", "Rotated": "30, 0, 0, 1", "PushName": "1", "LoadName": "1",
    "PointParameterf": "GL_POINT_SIZE_MIN, 0.5f", "PointParameteri": "GL_POINT_SIZE_MAX, 5",
    "PointParameterfv": "GL_POINT_DISTANCE_ATTENUATION, floats",
    "PointParameteriv": "GL_POINT_SIZE_MAX, ints",
    "PixelMapfv": "GL_PIXEL_MAP_R_TO_R, 2, floats", "PixelMapuiv": "GL_PIXEL_MAP_R_TO_R, 2, uints",
    "PixelMapusv": "GL_PIXEL_MAP_R_TO_R, 2, ushorts",
    "GetPixelMapfv": "GL_PIXEL_MAP_R_TO_R, memory", "GetPixelMapuiv": "GL_PIXEL_MAP_R_TO_R, memory",
    "GetPixelMapusv": "GL_PIXEL_MAP_R_TO_R, memory",
}
for size in "1234":
    for kind, array in (("d", "doubles"), ("f", "floats"), ("i", "ints"), ("s", "shorts")):
        LEGAL[f"MultiTexCoord{size}{kind}v"] = f"GL_TEXTURE0, {array}"

# RTenum: of functions that are refused whatever it is.
SCALARS = {"RTenum": "GL_NONE", "RTfloat": "0.5f", "RTdouble": "0.5", "RTclampf": "0.5f", "RTclampd": "0.5",
           "RTint": "1", "RTuint": "1", "RTsizei": "1", "RTshort": "1", "RTushort": "1",
           "RTbyte": "1", "RTubyte": "1", "RTboolean": "GL_TRUE"}
NAMES = {"list": "list", "texture": "texture", "buffer": "buffer"}
ARRAYS = {"RTfloat": "floats", "RTdouble": "doubles", "RTint": "ints", "RTuint": "names",
          "RTshort": "shorts", "RTushort": "ushorts", "RTbyte": "bytes", "RTubyte": "ubytes",
          "RTboolean": "booleans", "RTclampf": "floats"}

FLOATS = ("RTfloat", "RTdouble", "RTclampf", "RTclampd")
INTEGERS = ("RTint", "RTsizei", "RTshort", "RTbyte", "RTintptr", "RTsizeiptr")

# A count of what the caller's memory does not hold: as undefined as memory that is not there.
COUNTS = {"count", "n", "drawcount", "size", "range"}
READS_OR_WRITES_IMAGES = {"ReadPixels", "DrawPixels", "CopyPixels", "Bitmap", "TexImage1D",
                          "TexImage2D", "TexSubImage1D", "TexSubImage2D"}

OF_BOUND_BUFFER = {"BufferData", "BufferSubData", "GetBufferSubData", "MapBuffer", "UnmapBuffer",
                   "GetBufferParameteriv", "GetBufferPointerv"}

# Not made: they end the program's primitive, list or frame, or wait.
LEFT_OUT = {"GetError"}
# Nesting that the frame of a trial can not be put around.
NOT_INSIDE_BEGIN = {"Begin", "End", "NewList", "EndList", "ArrayElement"}
NOT_INSIDE_OBJECT = {"Begin", "NewList", "EndList"}

# Trials of which OpenGL leaves the error, or what changes, open; what is allowed besides Mesa's
# answer. The state that changed is not compared then.
ALSO = [
    # A vertex outside of a primitive, a texture unit that does not exist, elements before the
    # first: undefined.
    ("Vertex..*", "(legal|[xyzw]_.*)", "invalid_operation"),
    ("MultiTexCoord.*", "target_.*", "invalid_enum"),
    ("ArrayElement", "i_.*negative", "invalid_value"),
    ("DrawArrays", "first_.*negative", "invalid_value"),
    # Each implementation clamps to its own limits: of windows, and of as many bits of stencil as
    # it has.
    ("Viewport", ".*_(huge|most_negative)", "no_error"),
    ("StencilFunc", "(legal|ref_huge)", "no_error"),
    # Sums of offset and size, and strides, that an int of Mesa does not hold.
    ("CopyTexSubImage.*", ".offset_huge", "invalid_value"),
    ("InterleavedArrays", "stride_huge", "no_error"),
    # An image without texels has no sides here.
    ("(Copy)?TexImage2D", "(width|height)_zero", "no_error"),
    # OpenGL 1.5 does not say which.
    ("CopyTexImage.D", "internalformat_.*", "invalid_value"),
]


def also_allowed(name, what):
    for functions, of_trials, error in ALSO:
        if re.fullmatch(functions, name) and re.fullmatch(of_trials, what):
            return error
    return ""


def parameters_of(row):
    """[(type, name, the stars of a pointer, is constant)]"""
    if row["parameters"] == "void":
        return []
    found = []
    for text in row["parameters"].split(", "):
        kind, name = re.match(r"(.*?)(\w+)$", text).groups()
        found.append((kind.replace("const", "").replace("*", "").strip(), name,
                      "*" * kind.count("*"), "const" in kind))
    return found


def legal_arguments(name, parameters):
    if name in LEGAL:
        return LEGAL[name].split(", ")
    unit = ["GL_TEXTURE0"] if name.startswith("MultiTexCoord") else []
    rest = parameters[len(unit):]
    return unit + [ARRAYS.get(kind, "memory") if pointer and constant else "memory" if pointer
                   else NAMES.get(word, SCALARS[kind]) for kind, word, pointer, constant in rest]


def call(name, parameters, arguments):
    cast = [f"({kind.replace('RT', 'GL')}{pointer})memory" if value == "memory" else value
            for (kind, _, pointer, _), value in zip(parameters, arguments)]
    text = f"gl{name}({', '.join(cast)})"
    return f"({text}, glEnd())" if name == "Begin" else text


def illegal_values(name, kind, word, pointer):
    """[(what it is called, value, macro)]"""
    if pointer:
        return [("NULL", "NULL", "SURVIVE")]
    if kind == "RTenum":
        return [("unknown", "0x9999", "TRY"), ("all_bits", "0xFFFFFFFFu", "TRY")]
    if kind == "RTbitfield":
        return [("all_bits", "0xFFFFFFFFu", "TRY")]
    if kind in FLOATS:
        end = "f" if kind.endswith("f") or kind == "RTfloat" else ""
        huge = f"1e30{end}"
        return [("nan", f"(GL{kind[2:]})NAN", "SURVIVE"),
                ("infinity", f"(GL{kind[2:]})INFINITY", "SURVIVE"),
                ("minus_infinity", f"-(GL{kind[2:]})INFINITY", "SURVIVE"),
                ("negative", f"-1.0{end}", "TRY"), ("zero", f"0.0{end}", "TRY"),
                ("huge", huge, "SURVIVE")]
    if kind in INTEGERS:
        values = [("negative", "-1", "TRY"), ("zero", "0", "TRY")]
        if kind in ("RTint", "RTsizei"):
            values.append(("most_negative", "INT_MIN", "TRY"))
            if word not in COUNTS and name not in READS_OR_WRITES_IMAGES and \
                    not (name.endswith("Pointer") or name.startswith("Draw")):
                values.append(("huge", "INT_MAX", "TRY"))
        return values
    return []


def trials(name, row):
    parameters = parameters_of(row)
    arguments = legal_arguments(name, parameters)
    assert len(arguments) == len(parameters), name
    found = [("TRY", "legal", call(name, parameters, arguments))]
    for i, (kind, word, pointer, _) in enumerate(parameters):
        for what, value, macro in illegal_values(name, kind, word, pointer):
            changed = arguments[:i] + [value] + arguments[i + 1:]
            found.append((macro, f"{word}_{what}", call(name, parameters, changed)))
        if word in NAMES and not pointer:
            changed = arguments[:i] + ["deleted" + word.capitalize()] + arguments[i + 1:]
            found.append(("TRY", f"{word}_deleted", call(name, parameters, changed)))
    if name not in NOT_INSIDE_BEGIN:
        found.append(("INSIDE_BEGIN", "inside_begin", call(name, parameters, arguments)))
    if name not in NOT_INSIDE_OBJECT:
        found.append(("INSIDE_OBJECT", "inside_object", call(name, parameters, arguments)))
    return found


def section(row):
    name = row["name"][2:]
    refused = row["status"] == "refused"
    lines = [f"static void call{name}(void) {{", f'    beginCase("gl{name}");',
             f"    wantsBuffer = {int(name in OF_BOUND_BUFFER)};"]
    for macro, what, text in trials(name, row):
        if refused:
            macro = "INSIDE_OBJECT" if macro == "INSIDE_OBJECT" else "SURVIVE"
        if row["result"] != "void":
            text = f"(void){text}"
        more = f', "{also_allowed(name, what)}"' if macro in ("TRY", "INSIDE_BEGIN") else ""
        lines.append(f'    {macro}("{what}", {text}{more});')
    return "\n".join(lines + ["}"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("output", type=pathlib.Path)
    arguments = parser.parse_args()
    with open(ROOT / "compat" / "gl_calls.csv", newline="", encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["name"][2:] not in LEFT_OUT]
    text = ['#include "tests/conformance/trial.h"', ""]
    text += [section(row) + "\n" for row in rows]
    text += ["static void askQuestions(void) {", "    prepareTrials();"]
    text += [f"    call{row['name'][2:]}();" for row in rows] + ["}", ""]
    arguments.output.write_text("\n".join(text), encoding="utf-8")


if __name__ == "__main__":
    main()
