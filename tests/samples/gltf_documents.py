# SPDX-License-Identifier: MIT
"""Small glTF files, to be spoilt one detail at a time."""
import base64
import copy
import json
import struct

NAN, INF = float("nan"), float("inf")


def triangle_positions(*extra):
    return [-1, -1, 0, 1, -1, 0, 0, 1, 0, *extra]


def document(positions=None, indices=(0, 1, 2)):
    """One red, unlit triangle in front of a camera; its buffer as a data URI."""
    positions = positions if positions is not None else triangle_positions()
    data = struct.pack(f"<{len(positions)}f", *positions)
    offset = len(data)
    data += struct.pack(f"<{len(indices)}H", *indices) + b"\0\0" * (len(indices) % 2)
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 3]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "materials": [{"doubleSided": True, "extensions": {"KHR_materials_unlit": {}},
                       "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1,
                                    "material": 0}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(positions) // 3,
             "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": offset},
                        {"buffer": 0, "byteOffset": offset, "byteLength": 2 * len(indices)}],
        "buffers": [{"byteLength": len(data),
                     "uri": "data:application/octet-stream;base64,"
                            + base64.b64encode(data).decode()}],
    }


def spoilt(path, value, **more):
    """The document with the entry at `path` replaced; value None removes it."""
    changed = copy.deepcopy(document(**more))
    at = changed
    for key in path[:-1]:
        at = at[key]
    if value is None:
        del at[path[-1]]
    elif isinstance(at, list) and path[-1] == len(at):
        at.append(value)
    else:
        at[path[-1]] = value
    return changed


def glb(doc):
    """The document as a binary file, its buffer as the second chunk."""
    doc = copy.deepcopy(doc)
    data = base64.b64decode(doc["buffers"][0].pop("uri").split(",")[1])
    data += b"\0" * (-len(data) % 4)
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    return (struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data))
            + struct.pack("<I4s", len(text), b"JSON") + text
            + struct.pack("<I4s", len(data), b"BIN\0") + data)
