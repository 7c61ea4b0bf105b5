#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the tables of all functions of libOpenRT and of librtut: for each a function that calls it
with arguments from an array, the kinds of its parameters, and arguments of a legal call; and all
tokens of each.

Those of OpenGL's functions are those of tests/conformance/generate_wrong_calls.py.
"""
import argparse
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "conformance"))

import api_functions  # noqa: E402
import generate_wrong_calls  # noqa: E402

# Arguments of a legal call where the first value of a parameter's kind will not do. Ids are those
# that prepareContext() makes.
LEGAL = {
    "rtMakeCurrent": "current", "rtDestroyContext": "", "rtHint": "RT_PRECISION_HINT, RT_NICEST",
    "rtGetString": "RT_VERSION", "rtThreads": "2", "rtNewObject": "RT_DEFINE",
    "rtReplaceObject": "1", "rtUpdateObject": "1, 0, 1, floats", "rtRemoveObject": "1",
    "rtInstantiateObject": "1", "rtInstantiateObjectShader": "1, 1",
    "rtInstantiateObjectShaders": "1, 1, ids", "rtObjectHint": "RT_BUILD_QUALITY, RT_FASTEST",
    "rtGetObjectiv": "1, RT_OBJECT_SHADER_COUNT, scratch",
    "rtGenNewShaderClass": "surfaceClass, none", "rtGetShaderClassNames": "none",
    "rtGetShaderClassDescriptor": "1", "rtRegisterShaderClass": "descriptor",
    "rtBindShaderClass": "1", "rtRemoveShaderClass": "1", "rtBindShader": "1",
    "rtRemoveShader": "1", "rtParameterHandle": "color", "rtParameter3f": "1, 1, 1, 1",
    "rtParameter3fv": "1, floats", "rtParameterString": "1, color",
    "rtSetFrameBuffer": "scratch, 16, 16, RT_RGBA_8", "rtFrameBufferStride": "0",
    "rtSetAuxBuffer": "RT_DEPTH, scratch, RT_FLOAT", "rtSamples": "2", "rtSeed": "3",
    "rtRecursionLimit": "3", "rtWeightCutoff": "0.25", "rtUseLight": "2", "rtUseLightFast": "2",
    "rtUseCamera": "3", "rtUseEnvironmentShader": "4", "rtBindScene": "0", "rtDeleteScene": "0",
    "rtFrameDepth": "3", "rtReleaseScene": "1",
    "rtIntersect": "scene, rays, scratch, 4, RT_INCOHERENT",
    "rtIntersectStream": "scene, rayStream, hitStream, 4, RT_COHERENT",
    "rtOccluded": "scene, rays, scratch, 4, RT_COHERENT",
    "rtOccludedStream": "scene, rayStream, scratch, 4, RT_INCOHERENT",
    "rtGetInteger64v": "RT_STAT_BYTES, scratch",
    "rtPerspective": "60, 1, 0.1, 100", "rtLookAt": "0, 0, 5, 0, 0, 0, 0, 1, 0",
    "rtuPerspective": "60, 1, 0.1, 100", "rtuLookAt": "0, 0, 5, 0, 0, 0, 0, 1, 0",
    "rtuErrorString": "RT_INVALID_VALUE", "rtuGetString": "RTU_VERSION",
    "rtuOrtho2D": "-1, 1, -1, 1", "rtuPickMatrix": "8, 8, 4, 4, ints",
    "rtuQuadricDrawStyle": "quadric, RTU_LINE", "rtuQuadricNormals": "quadric, RTU_FLAT",
    "rtuQuadricOrientation": "quadric, RTU_INSIDE", "rtuSphere": "quadric, 1, 4, 3",
    "rtuCylinder": "quadric, 1, 1, 1, 4, 3", "rtuDisk": "quadric, 0.5, 1, 4, 3",
    "rtuPartialDisk": "quadric, 0.5, 1, 4, 3, 0, 90",
    "rtuQuadricCallback": "quadric, RTU_ERROR, function",
    "rtuScaleImage": "RT_RGB, 2, 2, RT_UNSIGNED_BYTE, zeros, 4, 4, RT_UNSIGNED_BYTE, scratch",
    "rtuBuild1DMipmaps": "RT_TEXTURE_1D, RT_RGB, 4, RT_RGB, RT_UNSIGNED_BYTE, zeros",
    "rtuBuild2DMipmaps": "RT_TEXTURE_2D, RT_RGB, 4, 4, RT_RGB, RT_UNSIGNED_BYTE, zeros",
    "rtuTessCallback": "tess, RTU_TESS_BEGIN, function",
    "rtuTessProperty": "tess, RTU_TESS_BOUNDARY_ONLY, 1",
    "rtuGetTessProperty": "tess, RTU_TESS_BOUNDARY_ONLY, scratch",
    "rtuTessVertex": "tess, doubles, scratch", "rtuNextContour": "tess, RTU_EXTERIOR",
    "rtutInitDisplayMode": "RTUT_DOUBLE", "rtutGet": "RTUT_WINDOW_WIDTH",
    "rtutDeviceGet": "RTUT_HAS_MOUSE", "rtutLayerGet": "RTUT_LAYER_IN_USE",
    "rtutSetCursor": "RTUT_CURSOR_WAIT", "rtutSetKeyRepeat": "RTUT_KEY_REPEAT_OFF",
    "rtutBitmapCharacter": "bitmapFont, 65", "rtutBitmapWidth": "bitmapFont, 65",
    "rtutBitmapLength": "bitmapFont, color", "rtutStrokeCharacter": "strokeFont, 65",
    **{f"rtut{style}{shape}": legal for style in ("Wire", "Solid")
       for shape, legal in {"Sphere": "1, 4, 3", "Cone": "1, 1, 4, 3", "Torus": "1, 2, 3, 4"}.items()},
    "rtutStrokeWidth": "strokeFont, 65", "rtutStrokeLength": "strokeFont, color",
}

# A count, a size, a stride: what the memory passed with it has to hold.
COUNTS = {"n", "count", "drawcount", "size", "width", "height", "depth", "stride", "first", "i",
          "slices", "stacks", "loops", "wIn", "hIn", "wOut", "hOut", "level", "base", "max",
          "bufSize", "start", "end", "imageSize", "mapsize", "knotCount", "bytes"}
COUNTING = {"rtPixelStorei": "param", "rtPixelStoref": "param"}
# Parameters with values of their own.
OWN = {("rtSamples", "n"): "Samples", ("rtThreads", "n"): "Threads", ("rtFrameDepth", "n"): "Depth",
       ("rtRecursionLimit", "n"): "Recursion", ("rtSetFrameBuffer", "width"): "Side",
       ("rtFrameBufferStride", "bytes"): "Stride",
       ("rtSetFrameBuffer", "height"): "Side", ("rtBufferData", "data"): "Indices",
       ("rtBufferSubData", "data"): "Indices", ("rtuCheckExtension", "extName"): "Text",
       ("rtuCheckExtension", "extString"): "Text", ("rtGenNewShaderClass", "fileName"): "FileName",
       ("rtGetShaderClassNames", "fileName"): "FileName", ("rtMultiDrawArrays", "first"): "Counts",
       ("rtDeleteBuffers", "buffers"): "Ids", ("rtutInit", "argcp"): "ArgumentCount",
       ("rtutInit", "argv"): "Arguments", ("rtutInitDisplayString", "string"): "DisplayString"}
# Of librtut, by name; callbacks by type.
OF_RTUT = {"query": "ToolkitToken", "cursor": "ToolkitToken", "repeatMode": "ToolkitToken",
           "layer": "ToolkitToken", "component": "ToolkitToken", "mode": "Bits", "window": "Id",
           "menu": "Id", "submenu": "Id", "item": "Id", "width": "Pixels", "height": "Pixels",
           "font": "Font", "callback": "Callback", "slices": "Integer", "stacks": "Integer",
           "sides": "Integer", "rings": "Integer"}
HANDLES = {"RTUquadric": "Quadric", "RTUtesselator": "Tess", "RTUnurbs": "Nurbs"}
BY_TYPE = {"RTray": "Rays", "RTraystream": "RayStream", "RThitstream": "HitStream",
           "RTshaderclass": "Descriptor", "char": "Text", "unsigned char": "Text"}
ARRAYS = {"RTfloat": "Floats", "RTdouble": "Doubles", "RTint": "Ints", "RTuint": "Ids",
          "RTsizei": "Counts", "RTclampf": "Floats"}
FLOATING = {"RTfloat", "RTdouble", "RTclampf", "RTclampd"}
NAMED = {  # expressions of legal arguments -> kind whose memory it is
    "floats": "Floats", "doubles": "Doubles", "ints": "Ints", "uints": "Ids", "ids": "Ids",
    "names": "Ids", "zeros": "Image", "shorts": "Image", "ushorts": "Image", "bytes": "Image",
    "ubytes": "Image", "booleans": "Image", "pointers": "Pointers", "scratch": "Out",
    "rays": "Rays", "rayStream": "RayStream", "hitStream": "HitStream", "tess": "Tess",
    "quadric": "Quadric", "descriptor": "Descriptor", "function": "Function", "current": "Context",
}


def kind_of(function, parameter):
    own = OWN.get((function.name, parameter.name))
    if own:
        return own
    if (function.name.startswith("rtut") and parameter.name in OF_RTUT
            and parameter.base not in FLOATING):
        return OF_RTUT[parameter.name]
    if parameter.type.startswith("void(RTAPIENTRY"):
        return "ErrorCallback" if "code" in parameter.type else "FrameCallback"
    if parameter.base == "RTUfuncptr":
        return "Function"
    if parameter.base == "RTcontext":
        return "Context"
    if parameter.base in HANDLES:
        return HANDLES[parameter.base]
    if parameter.pointer:
        if parameter.base in BY_TYPE:
            return BY_TYPE[parameter.base]
        if parameter.type.count("*") == 2 and parameter.constant:
            return "Pointers"
        if not parameter.constant:
            return "Out"
        if parameter.name == "indices":
            return "Indices"
        return ARRAYS.get(parameter.base, "Image")
    if parameter.base in ("RTenum", "RTbitfield"):
        return "Token" if parameter.base == "RTenum" else "Bits"
    if parameter.base in FLOATING:
        return "Number"
    points = any(p.pointer for p in function.parameters)
    if COUNTING.get(function.name) == parameter.name:
        return "Count"
    if parameter.name in COUNTS and (points or function.name.startswith(("rtu", "rtArray", "rtDraw"))):
        return "Size" if parameter.base == "RTuint" else "Count"
    if parameter.base == "RTuint":
        return "Token" if parameter.name in ("format", "what") else "Id"
    return "Count" if points and parameter.base in ("RTsizei", "RTsizeiptr", "RTintptr") else "Integer"


def legal_of(function):
    """Expressions, one a parameter; None: the first value of its kind."""
    if function.name in LEGAL:
        text = LEGAL[function.name]
    else:
        text = generate_wrong_calls.LEGAL.get(function.name[2:], "")
    parts = [part.strip() for part in text.split(",")] if text else []
    if len(parts) != len(function.parameters):
        assert not parts, function.name
        parts = [None] * len(function.parameters)
    return parts


def value(expression, parameter, kind):
    """What initialises a Value."""
    if expression is None:
        return "first(Kind::%s)" % kind
    if expression == "none" or expression == "NULL":
        return "Value::of(nullptr)"
    if expression in ("list", "texture", "buffer"):
        return "Value::of(1)"
    if expression == "scene":
        return "Value::of(Made::Scene)"
    if expression == "surfaceClass":
        return 'Value::of("DiffuseShader")'
    if expression == "color":
        return 'Value::of("color")'
    if expression in ("bitmapFont", "strokeFont"):
        name = "RTUT_BITMAP_9_BY_15" if expression == "bitmapFont" else "RTUT_STROKE_ROMAN"
        return f"Value::of(static_cast<const void*>({name}))"
    if parameter.pointer or kind in ("Function", "Context"):
        if expression == "memory":
            return "first(Kind::%s)" % ("Out" if kind == "Out" else kind)
        if expression == "fogModes":
            return "first(Kind::Ints)"
        return "first(Kind::%s)" % ("Out" if kind == "Out" else NAMED[expression])
    expression = re.sub(r"\bGL_", "RT_", expression)
    if kind == "Number":
        return f"Value::of(double({expression}))"
    return f"Value::of(int64_t({expression}))"


def argument(function, i, parameter, kind):
    if function.name == "rtuDeleteQuadric":
        return "args[0].as<RTUquadric *>() ? rtuNewQuadric() : nullptr"
    if function.name == "rtuDeleteTess":
        return "args[0].as<RTUtesselator *>() ? rtuNewTess() : nullptr"
    kinds = kind
    if kinds in ("ErrorCallback", "FrameCallback"):
        return f"args[{i}].p ? {kind[0].lower() + kind[1:]} : nullptr"
    if kinds == "Callback":
        return f"Callback{{args[{i}].p != nullptr}}"
    if kinds == "Function":
        return f"args[{i}].p ? callBack : nullptr"
    if parameter.type == "char *" and function.name == "rtInit":
        return f"args[{i}].as<char**>()"
    if parameter.pointer or kinds == "Context":
        return f"args[{i}].as<{parameter.type}>()"
    return f"args[{i}].to<{parameter.type}>()"


def section(function):
    kinds = [kind_of(function, p) for p in function.parameters]
    arguments = ", ".join(argument(function, i, p, kind)
                          for i, (p, kind) in enumerate(zip(function.parameters, kinds)))
    if function.name == "rtInit":
        arguments = "args[0].p ? startArguments(args[0]) : nullptr, args[0].p ? startNames : nullptr"
    made = f"{function.name}({arguments})"
    if function.result != "void":
        made = f"given({made})"
    unused = "" if function.parameters else "[[maybe_unused]] "
    return (f"void call_{function.name}({unused}const Value* args) {{\n"
            f"    {made};\n}}\n")


def entry(function):
    kinds = [kind_of(function, p) for p in function.parameters]
    parameters = ", ".join(
        f'{{"{p.name}", Kind::{kind}, {value(expression, p, kind)}}}'
        for p, kind, expression in zip(function.parameters, kinds, legal_of(function)))
    left_out = ", true" if function.left_out else ""
    return f'        {{"{function.name}", call_{function.name}, {{{parameters}}}{left_out}}},'


def table(functions, name, header):
    text = ["// SPDX-License-Identifier: MIT", "// Made by generate_calls.py.",
            f'#include "{header}"', "", "namespace openrt::test {", "namespace {", ""]
    text += [section(function) for function in functions]
    text += ["} // namespace", "", f"const std::vector<ApiFunction>& {name}() {{",
             "    static const std::vector<ApiFunction> all = {"]
    text += [entry(function) for function in functions]
    return text + ["    };", "    return all;", "}", "", "} // namespace openrt::test", ""]


def token_list(tokens):
    values = sorted(set(tokens.values()))
    rows = [", ".join(f"{token:#x}u" for token in values[i:i + 8])
            for i in range(0, len(values), 8)]
    return "// SPDX-License-Identifier: MIT\n" + ",\n".join(rows) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    folder = parser.parse_args().folder
    for library, header in (("api", "tests/calls/values.h"), ("rtut", "tests/calls/rtut_calls.h")):
        rtut = library == "rtut"
        calls = table(api_functions.functions(rtut), f"{library}Functions", header)
        (folder / f"{library}_calls.cpp").write_text("\n".join(calls), encoding="utf-8")
        (folder / f"{library}_tokens.inc").write_text(token_list(api_functions.tokens(rtut)),
                                                      encoding="utf-8")


if __name__ == "__main__":
    main()
