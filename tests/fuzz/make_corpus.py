#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the inputs that fuzzing starts from, a folder for each target.

usage: make_corpus.py FOLDER

Inputs that once were a fault are in tests/fuzz/found.
"""
import pathlib
import random
import struct
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "calls"))

import api_functions  # noqa: E402
import file_corpora  # noqa: E402

PROGRAMS = {
    "triangle": "rtBegin rtColor3f rtVertex3f rtNormal3f rtVertex3f rtVertex3f rtEnd rtRender",
    "object": "rtNewObject rtBegin rtVertex3f rtVertex3f rtVertex3f rtEnd rtEndObject "
              "rtInstantiateObject rtPushMatrix rtTranslatef rtInstantiateObjectShader rtPopMatrix "
              "rtQueueFrame rtReplaceObject rtBegin rtVertex3f rtVertex3f rtVertex3f rtEnd "
              "rtEndObject rtInstantiateObject rtQueueFrame rtRemoveObject rtFinish",
    "lists": "rtGenLists rtNewList rtColor3f rtBegin rtVertex3f rtVertex3f rtVertex3f rtEnd "
             "rtEndList rtCallList rtCallLists rtDeleteLists rtRender",
    "arrays": "rtVertexPointer rtEnableClientState rtDrawArrays rtColorPointer rtDrawElements "
              "rtGenBuffers rtBindBuffer rtBufferData rtVertexPointer rtMapBuffer rtUnmapBuffer "
              "rtDrawRangeElements rtMultiDrawArrays rtDeleteBuffers rtRender",
    "state": "rtPushAttrib rtEnable rtLightfv rtMaterialfv rtFogf rtTexEnvi rtTexGeni rtClipPlane "
             "rtBlendFunc rtDepthFunc rtPolygonMode rtBegin rtVertex3f rtVertex3f rtVertex3f rtEnd "
             "rtClear rtRender rtPopAttrib rtGetDoublev rtIsEnabled",
    "pixels": "rtPixelStorei rtPixelTransferf rtTexImage2D rtTexSubImage2D rtCopyTexImage2D "
              "rtRasterPos3f rtDrawPixels rtBitmap rtCopyPixels rtRender rtReadPixels "
              "rtuBuild2DMipmaps rtuScaleImage rtGetTexImage",
    "shaders": "rtGenNewShaderClass rtGenNewShader rtParameterHandle rtParameter3f rtUseLight "
               "rtUseCamera rtUseEnvironmentShader rtBegin rtVertex3f rtVertex3f rtVertex3f rtEnd "
               "rtRender rtRemoveShader rtRemoveShaderClass",
    "queries": "rtCompileScene rtIntersect rtIntersectStream rtOccluded rtOccludedStream "
               "rtReleaseScene",
    "frames": "rtFrameDepth rtSetFrameCallback rtQueueFrame rtQueueFrame rtFrameStatus "
              "rtFrameProgress rtCancelFrame rtWaitFrame rtQueueView rtStartRendering "
              "rtUpdateObject rtEndRendering",
    "utilities": "rtuSphere rtuCylinder rtuDisk rtuPartialDisk rtuTessBeginPolygon "
                 "rtuTessBeginContour rtuTessVertex rtuTessVertex rtuTessVertex rtuTessEndContour "
                 "rtuTessEndPolygon rtuCameraFromWall rtRender",
    "objects": "rtuNewQuadric rtuNewTess rtuNewTess rtuDeleteTess rtRender",  # two are left
    "selection": "rtSelectBuffer rtRenderMode rtInitNames rtPushName rtLoadName rtBegin rtVertex3f "
                 "rtVertex3f rtVertex3f rtEnd rtPopName rtRenderMode rtFeedbackBuffer rtPassThrough",
    "contexts": "rtCreateContext rtMakeCurrent rtDestroyContext rtInit rtBegin rtExit rtInit "
                "rtVertex3f rtGetError rtGetErrorText",
}


def name_hash(name):
    """As api_program.h has it."""
    value = 2166136261
    for byte in name.encode():
        value = ((value ^ byte) * 16777619) & 0xFFFFFFFF
    return (value ^ value >> 16) & 0xFFFF


def calls(names, functions, generator=None):
    """The calls with legal arguments, or with any."""
    data = b""
    for name in names:
        data += struct.pack("<H", name_hash(name))
        for _ in functions[name].parameters:
            legal = generator is None or generator.random() < 0.7
            data += bytes([0 if legal else generator.randrange(112, 256)])
    return data


def api_calls():
    functions = {function.name: function for function in api_functions.functions()}
    generator = random.Random(2009)
    found = {name: calls(text.split(), functions) for name, text in PROGRAMS.items()}
    found |= {f"{name}-wrong": calls(text.split(), functions, generator)
              for name, text in PROGRAMS.items()}
    names = sorted(functions)
    for i in range(0, len(names), 32):  # every function once
        found[f"all-{i:03}"] = calls(names[i:i + 32], functions)
    return found


def forged_calls(names, functions, generator=None):
    """Calls as forged_stream.cpp has them: kind of record, function, place, arguments, attachments
    and damage."""
    data = b""
    for name in names:
        function = functions[name]
        data += b"\0" + struct.pack("<H", name_hash(name)) + b"\0"
        for _ in function.parameters:
            legal = generator is None or generator.random() < 0.8
            data += bytes([generator.randrange(112) if generator and legal else 0 if legal
                           else generator.randrange(112, 256)])
        data += bytes(2)
    return data


def trace():
    functions = {function.name: function for function in api_functions.functions()}
    generator = random.Random(2010)
    start = "rtInit rtSetFrameBuffer rtViewport "
    programs = {name: (start + text).split() for name, text in PROGRAMS.items()}
    programs["names"] = (start + "rtuNewQuadric rtuSphere rtuQuadricCallback rtuNewTess "
                         "rtuTessCallback rtuTessBeginPolygon rtuTessEndPolygon rtGenTextures "
                         "rtGenBuffers rtReadPixels rtuDeleteTess rtuDeleteQuadric").split()
    found = {name: forged_calls(words, functions) for name, words in programs.items()}
    found |= {f"{name}-wrong": forged_calls(words, functions, generator)
              for name, words in programs.items()}
    names = sorted(functions)
    for i in range(0, len(names), 48):  # every function once
        found[f"all-{i:03}"] = forged_calls(["rtInit", *names[i:i + 48]], functions)
    arrays = bytes([232, 0x20, 0, 0, 3, 7]) + b"\0"  # three vertices
    draw = b"\0" + struct.pack("<H", name_hash("rtDrawArrays")) + bytes(4)
    found["drawn-arrays"] = forged_calls(start.split(), functions) + draw + arrays
    return found | {f"random-{i}": generator.randbytes(300) for i in range(12)} | {
        "file": b"\xff" + struct.pack("<IIBBHI", 16, 0, 1, 0, 0, 0)}


def messages():
    generator = random.Random(2011)
    # Peers of a master: greet, are ready for a frame, answer. Of a worker: call, tile, end.
    greeting = bytes([0, 0, 2, 0, 1, 0, 2, 0])
    answers = bytes([0, 1, 0, 0, 0, 1, 1, 0, 0, 0]) + bytes([0, 2, 1, 0, 1, 2, 1, 0]) * 4
    served = b"".join(bytes([0, 5, i, 0, 0, 6, i, 0, 0]) for i in (1, 2, 200)) + bytes(
        [0, 7, 0, 0, 0, 0, 8, 1, 0, 0])
    found = {"master": b"\1" + greeting + answers, "worker": b"\2" + served,
             "leave": bytes([2, 0, 9, 200, 0]), "calls": bytes([0, 5, 3]) + bytes(7) + b"abc"}
    found |= {f"parser-{kind}": bytes([0, kind]) + generator.randbytes(60) for kind in range(12)}
    return found | {f"random-{i}": generator.randbytes(120) for i in range(12)}


def shader_parameters():
    generator = random.Random(7)
    found = {f"random-{i}": generator.randbytes(120) for i in range(12)}
    return found | {f"class-{i}": bytes([i]) + bytes(60) for i in range(16)}


def shader_class():
    generator = random.Random(8)
    fields = b"".join(struct.pack("<5B", 1 + i % 4, i % 3, 4 + i % 5, 16 * i, 4 * (i % 4 + 1))
                      for i in range(12))
    found = {f"kind-{kind}": fields + bytes([1, 1, kind, 1, 64, 16, 16, 1, 0, 3, 0])
             for kind in range(6)}
    return found | {f"random-{i}": generator.randbytes(71) for i in range(6)}


TARGETS = {"api_calls": api_calls, "shader_parameters": shader_parameters,
           "shader_class": shader_class, "trace": trace, "messages": messages,
           **file_corpora.TARGETS}


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    for target, make in TARGETS.items():
        folder = pathlib.Path(sys.argv[1]) / target
        folder.mkdir(parents=True, exist_ok=True)
        for name, data in make().items():
            (folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
