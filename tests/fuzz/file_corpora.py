# SPDX-License-Identifier: MIT
"""First inputs of the fuzz targets that read files: a small file for each thing that a loader tells
from others, and for each that it refuses."""
import base64
import copy
import json
import pathlib
import struct
import sys
import zlib

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "samples"))

import environment_files  # noqa: E402
import gltf_documents  # noqa: E402


def pictures(target):
    """Files that other programs wrote."""
    return {path.name: path.read_bytes() for path in (HERE / "pictures" / target).iterdir()}


# PNG

def png(width, height, kind, row, *chunks, depth=8, interlace=0):
    def chunk(name, data):
        body = name + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    header = struct.pack(">IIBBBBB", width, height, depth, kind, 0, 0, interlace)
    data = b"".join(bytes([y % 5]) + row for y in range(min(height, 9)))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + b"".join(chunk(name, data) for name, data in chunks)
            + chunk(b"IDAT", zlib.compress(data)) + chunk(b"IEND", b""))


def image():
    palette = (b"PLTE", bytes(range(12)))
    found = {f"grey-{depth}.png": png(8, 5, 0, bytes(range(depth)), depth=depth)
             for depth in (1, 2, 4, 8, 16)}
    found |= {f"palette-{depth}.png": png(8, 5, 3, bytes(depth), palette, depth=depth)
              for depth in (1, 2, 4, 8)}
    for name, kind, channels in (("rgb", 2, 3), ("grey-alpha", 4, 2), ("rgba", 6, 4)):
        for depth in (8, 16):
            found[f"{name}-{depth}.png"] = png(3, 5, kind, bytes(range(3 * channels * depth // 8)),
                                               depth=depth)
    found |= {
        "transparent.png": png(8, 5, 3, bytes(8), palette, (b"tRNS", b"\0\x80")),
        "transparent-grey.png": png(8, 5, 0, bytes(8), (b"tRNS", b"\0\1")),
        "transparent-rgb.png": png(2, 5, 2, bytes(6), (b"tRNS", bytes(6))),
        "colours.png": png(1, 1, 2, bytes(3), (b"gAMA", struct.pack(">I", 45455)), (b"sRGB", b"\0"),
                           (b"cHRM", bytes(32)), (b"iCCP", b"a\0\0" + zlib.compress(b"b")),
                           (b"tEXt", b"a\0b")),
        "interlaced.png": png(1, 1, 2, bytes(3), interlace=1),
        "no-palette.png": png(8, 1, 3, bytes(8)), "wrong-depth.png": png(1, 1, 2, bytes(1), depth=4),
        "no-picture.png": png(0, 1, 2, b""), "cut.png": png(3, 5, 2, bytes(9))[:50],
        "huge.png": png(2 ** 30, 2 ** 30, 2, bytes(3)), "short-row.png": png(99, 9, 6, b"a"),
        "gif": b"GIF89a", "empty": b""}
    return found | pictures("image")


# glTF

PICTURE = png(2, 2, 2, bytes([255, 0, 0, 0, 0, 255]))


def data_uri(data, kind="application/octet-stream"):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


def with_data(doc, data, component, kind, count, **accessor):
    """The number of an accessor of this data, which the document gets."""
    doc["buffers"].append({"byteLength": len(data), "uri": data_uri(data)})
    doc["bufferViews"].append({"buffer": len(doc["buffers"]) - 1, "byteLength": len(data)})
    doc["accessors"].append({"bufferView": len(doc["bufferViews"]) - 1, "componentType": component,
                             "type": kind, "count": count, **accessor})
    return len(doc["accessors"]) - 1


def documents():
    """Pairs of a name and a document."""
    made = {}

    def new(name, *arguments, **keywords):
        made[name] = gltf_documents.document(*arguments, **keywords)
        doc = made[name]
        return doc, doc["meshes"][0]["primitives"][0], doc["materials"][0]

    new("plain")
    for mode in (1, 4, 5, 6, 9):
        new(f"mode-{mode}", [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], (0, 1, 2, 3))[1]["mode"] = mode
    del new("without-indices")[1]["indices"]
    doc, primitive, _ = new("attributes")
    attributes = primitive["attributes"]
    attributes["NORMAL"] = with_data(doc, bytes([0, 0, 127, 0] * 3)[:11], 5120, "VEC3", 3,
                                     normalized=True)
    doc["bufferViews"][-1]["byteStride"] = 4
    attributes["TEXCOORD_0"] = with_data(doc, bytes(range(12)), 5123, "VEC2", 3, normalized=True)
    attributes["COLOR_0"] = with_data(doc, bytes(range(12)), 5121, "VEC4", 3, normalized=True)
    for component, size, name in ((5122, 2, "short"), (5123, 2, "ushort"), (5120, 1, "byte"),
                                  (5125, 4, "uint"), (5126, 4, "float"), (5124, 4, "int"),
                                  (5130, 8, "double")):
        doc, primitive, _ = new(f"positions-{name}")
        primitive["attributes"]["POSITION"] = with_data(doc, bytes(range(9 * size)), component,
                                                        "VEC3", 3)
    for component, size in ((5121, 1), (5125, 4), (5126, 4)):
        doc, primitive, _ = new(f"indices-{component}")
        primitive["indices"] = with_data(doc, b"".join(i.to_bytes(size, "little") for i in range(3)),
                                         component, "SCALAR", 3)
    for component, size in ((5121, 1), (5123, 2), (5125, 4)):
        doc, _, _ = new(f"sparse-{component}")
        with_data(doc, b"".join(i.to_bytes(size, "little") for i in (0, 2)), component, "SCALAR", 2)
        doc["accessors"][0]["sparse"] = {"count": 2, "values": {"bufferView": 0}, "indices": {
            "bufferView": 2, "componentType": component}}
    doc = copy.deepcopy(made["sparse-5123"])
    del doc["accessors"][0]["bufferView"]
    made["sparse-of-zeros"] = doc
    doc = copy.deepcopy(made["sparse-5121"])
    doc["accessors"][0]["sparse"]["count"] = 9
    made["sparse-too-long"] = doc

    for name, picture in (("png", PICTURE), ("jpeg", pictures("image")["grey.jpg"]), ("none", b"a")):
        doc, primitive, material = new(f"picture-{name}")
        primitive["attributes"]["TEXCOORD_0"] = with_data(doc, struct.pack("<6f", *range(6)), 5126,
                                                          "VEC2", 3)
        doc["images"] = [{"uri": data_uri(picture, "image/png")}]
        doc["samplers"] = [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728}]
        doc["textures"] = [{"source": 0, "sampler": 0}, {"source": 0}, {}]
        material["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
    textured = made["picture-png"]
    doc = made["file"] = copy.deepcopy(textured)
    doc["images"] = [{"uri": "t.png"}]
    doc = made["escaped-file"] = copy.deepcopy(textured)
    doc["images"] = [{"uri": "%74.png"}]
    doc = made["picture-in-buffer"] = copy.deepcopy(textured)
    with_data(doc, PICTURE, 5121, "SCALAR", 1)
    doc["images"] = [{"bufferView": len(doc["bufferViews"]) - 1, "mimeType": "image/png"}]
    doc = made["transformed"] = copy.deepcopy(textured)
    doc["extensionsUsed"] = doc["extensionsRequired"] = ["KHR_texture_transform"]
    doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
        "KHR_texture_transform": {"offset": [0.5, 1], "scale": [2, -1], "rotation": 1, "texCoord": 0}}
    doc = made["all-textures"] = copy.deepcopy(textured)
    doc["materials"][0] |= {"normalTexture": {"index": 0}, "occlusionTexture": {"index": 0},
                            "emissiveTexture": {"index": 1}, "emissiveFactor": [1, 0, 1],
                            "alphaMode": "MASK", "alphaCutoff": 0.3, "extensions": {
                                "KHR_materials_emissive_strength": {"emissiveStrength": 4}}}
    doc["materials"][0]["pbrMetallicRoughness"] |= {
        "metallicRoughnessTexture": {"index": 1, "texCoord": 1}, "metallicFactor": 0.5,
        "roughnessFactor": 0.1}
    doc["materials"].append({"alphaMode": "BLEND", "pbrMetallicRoughness": {
        "baseColorTexture": {"index": 2}}})

    doc = new("lights")[0]
    doc["extensionsUsed"] = ["KHR_lights_punctual", "EXT_of_nobody"]
    doc["extensions"] = {"KHR_lights_punctual": {"lights": [
        {"type": "spot", "color": [1, 1, 1], "intensity": 3, "range": 9,
         "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}, {"type": "directional"},
        {"type": "point"}]}}
    doc["nodes"] += [{"extensions": {"KHR_lights_punctual": {"light": 0}}, "children": [0, 1],
                      "rotation": [0, 0, 0, 1], "scale": [1, 2, 1]},
                     {"extensions": {"KHR_lights_punctual": {"light": 1}},
                      "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]},
                     {"extensions": {"KHR_lights_punctual": {"light": 2}}}]
    doc["scenes"][0]["nodes"] = [2, 3, 4]
    doc = new("orthographic")[0]
    doc["cameras"] = [{"type": "orthographic",
                       "orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9}}]
    doc = new("left-out")[0]
    doc["skins"] = [{"joints": [0], "skeleton": 0}]
    doc["animations"] = [{"samplers": [{"input": 0, "output": 0}], "channels": [
        {"sampler": 0, "target": {"node": 0, "path": "translation"}}]}]
    doc["meshes"][0]["primitives"][0]["targets"] = [{"POSITION": 0}]
    doc["meshes"][0]["weights"] = [0.5]
    doc = new("no-scene")[0]
    del doc["scenes"], doc["scene"]
    doc = new("infinite")[0]
    doc["nodes"][0]["scale"] = [1e300, 1, 1]
    doc = new("twice")[0]
    doc["nodes"][0]["children"] = [1]
    doc = new("required")[0]
    doc["extensionsRequired"] = ["KHR_draco_mesh_compression"]
    doc = new("outside")[0]
    doc["buffers"][0]["uri"] = "../a.bin"
    doc = new("broken-escape")[0]
    doc["buffers"][0]["uri"] = "a%2"
    return made


def gltf():
    made = documents()
    found = {f"{name}.gltf": json.dumps(doc, separators=(",", ":")).encode()
             for name, doc in made.items()}
    for name in ("plain", "lights"):
        found[f"{name}.glb"] = gltf_documents.glb(made[name])
    whole = found["plain.glb"]
    later = struct.pack("<I4s", 4, b"next") + bytes(4)
    found["more-chunks.glb"] = (whole[:8] + struct.pack("<I", len(whole) + len(later)) + whole[12:]
                                + later)
    found |= {"version-1.glb": whole[:4] + b"\1" + whole[5:], "cut.glb": whole[:300],
              "header.glb": whole[:12], "no-json.glb": whole[:16] + b"BIN\0" + whole[20:],
              "deep.gltf": b'{"a":' + b"[" * 99 + b"]" * 99 + b"}", "list.gltf": b"[]",
              "text.gltf": b"glTF", "strings.gltf": b'{"a":"\\"[","asset":{"version":"2.0"}}'}
    return found


# Meshes and triangles

def ply(kind, vertices, properties, faces="", lists=()):
    """`vertices`: tuples of numbers; properties: pairs of type and name; lists: of indices."""
    header = [f"ply\nformat {kind} 1.0", "comment a", f"element vertex {len(vertices)}"]
    header += [f"property {of} {name}" for of, name in properties]
    if faces:
        header += [f"element face {len(lists)}", f"property list {faces} vertex_indices"]
    text = "\n".join([*header, "end_header", ""]).encode()
    if kind == "ascii":
        rows = [*vertices, *((len(indices), *indices) for indices in lists)]
        return text + "".join(" ".join(map(str, row)) + "\n" for row in rows).encode()
    order = "<" if "little" in kind else ">"
    letters = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
               "float": "f", "double": "d", "uint8": "B", "int32": "i", "float32": "f"}
    data = b"".join(struct.pack(order + "".join(letters[of] for of, _ in properties), *row)
                    for row in vertices)
    if faces:
        size, index = (letters[of] for of in faces.split())
        data += b"".join(struct.pack(f"{order}{size}{len(indices)}{index}", len(indices), *indices)
                         for indices in lists)
    return text + data


def mesh():
    corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    place = [("float", name) for name in "xyz"]
    colour = [("uchar", name) for name in ("red", "green", "blue", "alpha")]
    found = {}
    for kind in ("ascii", "binary_little_endian", "binary_big_endian"):
        found |= {
            f"triangles-{kind}.ply": ply(kind, corners, place, "uchar int", [(0, 1, 2), (0, 2, 3)]),
            f"quad-{kind}.ply": ply(kind, corners, place, "uint8 int32", [(0, 1, 2, 3)]),
            f"colours-{kind}.ply": ply(kind, [(*c, 255, i, 9, 200) for i, c in enumerate(corners)],
                                       place + colour, "uchar uint", [(0, 1, 2)]),
            f"normals-{kind}.ply": ply(
                kind, [(*c, 0, 0, 1, 0.5, i) for i, c in enumerate(corners)],
                place + [("float", name) for name in ("nx", "ny", "nz", "s", "t")], "char ushort",
                [(0, 1, 2)]),
            f"doubles-{kind}.ply": ply(kind, [(*c, 7) for c in corners],
                                       [("double", name) for name in "xyz"] + [("short", "other")],
                                       "ushort short", [(0, 1, 2)]),
            f"points-{kind}.ply": ply(kind, corners, place),
            f"outside-{kind}.ply": ply(kind, corners, place, "uchar int", [(0, 1, 99)]),
            f"empty-face-{kind}.ply": ply(kind, corners, place, "uchar int", [(), (0, 1)])}
    whole = found["triangles-binary_little_endian.ply"]
    found |= {
        "cut.ply": whole[:-9], "many.ply": whole.replace(b"vertex 4", b"vertex 4000000000"),
        "no-end.ply": whole[:60], "no-number.ply": whole.replace(b"vertex 4", b"vertex a"),
        "twice.ply": whole.replace(b"element face", b"element vertex"),
        "lines.ply": whole.replace(b"\n", b"\r\n", 7)}
    vertices = "".join(f"v {x} {y} {z}\n" for x, y, z in corners)
    obj = {
        "triangle": vertices + "f 1 2 3\n", "quad": vertices + "f 1 2 3 4\n",
        "negative": "o a\ng b\ns 1\n" + vertices + "f -4 -3 -2 -1\nl 1 2\np 1\n",
        "attributes": vertices + "vt 0 0\nvt 1 0 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf 1//1 2//1 3//1\n"
                                 "f 1/1 2/2 3/1\n",
        "material": "mtllib a.mtl\n" + vertices + "usemtl m\nf 1 2 3\nusemtl none\nf 1 3 4\n",
        "no-library": "mtllib none.mtl\n" + vertices + "usemtl m\nf 1 2 3\n",
        "outside": "mtllib ../a.mtl\n" + vertices + "f 1 2 3\n",
        "colours": "".join(f"v {x} {y} {z} 1 .5 0\n" for x, y, z in corners) + "f 1 2 3\n",
        "weights": "".join(f"v {x} {y} {z} 1\n" for x, y, z in corners) + "f 1 2 3\n",
        "points": "v .5 -.5 .1\nv 1e3 2 3\nv\t.1 .2 .3\nf 1 2 3\n",
        "several": vertices + "o a\nf 1 2 3\no b\ng c d\ns off\nf 1 3 4\n",
        "concave": "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 1 0\nv 0 2 0\nf 1 2 3 4 5\n",
        "continued": vertices + "f 1 2 \\\n3\n", "nan": "v nan 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n",
        "beyond": vertices + "f 1 2 9\n", "zero": vertices + "f 0 1 2\n", "none": "# nothing\n"}
    found |= {f"{name}.obj": text.encode() for name, text in obj.items()}
    found["windows.obj"] = obj["material"].replace("\n", "\r\n").encode()
    return found


def tri():
    corners = gltf_documents.triangle_positions()
    one = struct.pack("<I9f", 1, *corners)
    numbers = [gltf_documents.NAN, gltf_documents.INF, 3e38, -3e38, 1e-45, 0.0, 1.0, 2.0, 3.0]
    return {"one.tri": one, "three.tri": struct.pack("<I27f", 3, *corners, *corners, *[0.0] * 9),
            "none.tri": struct.pack("<I", 0), "numbers.tri": struct.pack("<I9f", 1, *numbers),
            "two.tri": struct.pack("<I18f", 2, *corners, *numbers), "cut.tri": one[:-1],
            "long.tri": one + b"\0", "short.tri": one[:3],
            "many.tri": struct.pack("<I9f", 2 ** 32 - 1, *corners)}


# Shader libraries

def library(table="gnu", symbol=b"rtsPlugin", version=1, revision=0, size=48, magic=b"OpenRTS\0",
            kind=1, section=1, segments=2, of_type=3, machine=None, words=2):
    """A shared library of one segment, all of whose addresses are offsets: headers, the dynamic
    section, symbols, names, a hash table of one bucket, and a shader library's descriptor."""
    if machine is None:
        machine = {"x86_64": 62, "aarch64": 183}.get(pathlib.os.uname().machine, 62)
    names = b"\0" + symbol + b"\0"
    names += bytes(-len(names) % 8)
    dynamic, symbols = 64 + 56 * 2, 64 + 56 * 2 + 16 * 4
    strings = symbols + 24 * 2
    hashes = strings + len(names)
    if table == "gnu":
        value = 5381
        for byte in symbol:
            value = (value * 33 + byte) & 0xFFFFFFFF
        hashing = struct.pack("<4I", 1, 1, 1, 0) + bytes(8) + struct.pack("<II", 1, value | 1)
    else:
        hashing = struct.pack("<6I", 1, 2, 1, 0, 0, 0)
    descriptor = hashes + len(hashing)
    plugin = magic + struct.pack("<4I", size, version, revision, 64) + bytes(16)
    whole = descriptor + len(plugin)
    header = struct.pack("<4sBBBB8xHHIQQQIHHHHHH", b"\x7fELF", words, 1, 1, 0, of_type, machine, 1, 0,
                         64, 0, 0, 64, 56, segments, 0, 0, 0)
    load = struct.pack("<IIQQQQQQ", 1, 4, 0, 0, 0, whole, whole, 4096)
    moving = struct.pack("<IIQQQQQQ", 2, 4, dynamic, dynamic, dynamic, 64, 64, 8)
    entries = struct.pack("<8Q", 6, symbols, 5, strings, 0x6ffffef5 if table == "gnu" else 4, hashes,
                          0, 0)
    table_of_symbols = bytes(24) + struct.pack("<IBBHQQ", 1, kind, 0, section, descriptor, size)
    return header + load + moving + entries + table_of_symbols + names + hashing + plugin


def plugin_file():
    whole = library()
    found = {"gnu": whole, "system-v": library("sysv"), "other-name": library(symbol=b"rtsNothing"),
             "other-name-v": library("sysv", symbol=b"rtsNothing"), "function": library(kind=2),
             "undefined": library(section=0), "version": library(version=9),
             "revision": library(revision=99), "magic": library(magic=b"nothing\0"),
             "small": library(size=8), "program": library(of_type=2), "no-segments": library(segments=0),
             "many-segments": library(segments=0xFFFF), "words-of-32-bits": library(words=1),
             "cut": whole[:200], "header-only": whole[:64], "start": whole[:10], "text": b"\x7fELFtext",
             "byte-order": whole[:5] + b"\2" + whole[6:]}
    found |= {f"machine-{machine}": library(machine=machine) for machine in (3, 21, 40, 62, 183, 243, 9)}
    return found | {"good": b"\0", "changed-header": b"\0\x05\x00\x01", "half": b"\x01\x00\x80",
                    "changed-middle": b"\0" + struct.pack("<HB", 0x9000, 0xFF) * 4}


# Environments and heads

def environment():
    rows = [[(x / 8, y / 4, 0.5) for x in range(12)] for y in range(5)]
    files = environment_files
    found = {f"{name}.exr": files.exr(rows, files.HALF, kind)
             for name, kind in (("none", files.NONE), ("rle", files.RLE), ("zips", files.ZIPS),
                                ("zip", files.ZIP))}
    found |= {
        "float.exr": files.exr(rows), "grey.exr": files.exr(rows, files.HALF, grey=True),
        "window.exr": files.exr(rows, files.HALF, at=(-5, 9)), "tiles.exr": files.tiled_exr(rows, 4),
        "cut.exr": files.exr(rows, files.HALF)[:-40],
        "huge.exr": files.exr_header(2 ** 31 - 1, 9), "large.exr": files.exr_header(1024, 1024),
        "parts.exr": files.exr_header(4, 4, version=0x1002) + bytes(64),
        "cube.exr": files.exr_header(4, 4, files.attribute("envmap", "envmap", b"\1")),
        "few-channels.exr": files.exr_header(4, 4, channels=[files.channel("R", files.HALF)]),
        "coarse.exr": files.exr_header(4, 4, channels=[files.channel("Y", files.HALF, 2)]) + bytes(99),
        "tiny-tiles.exr": files.exr_header(1024, 1024, files.attribute(
            "tiles", "tiledesc", struct.pack("<IIB", 1, 1, 0)), version=0x202),
        "packed.hdr": files.hdr(rows), "plain.hdr": files.hdr(rows, packed=False),
        "small.hdr": files.hdr([row[:3] for row in rows], packed=False),
        "cut.hdr": files.hdr(rows)[:-9], "bare.hdr": b"#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n",
        "turned.hdr": b"#?RADIANCE\nEXPOSURE=1\nFORMAT=32-bit_rle_rgbe\n\n+X 1 -Y 1\nabcd"}
    return found | pictures("environment")


def head_path():
    lines = {"walk": "# seconds x y z yaw pitch roll\n0 0 1.7 0.4 0 0 0\n\n0.5 0 1.7 0.3 15 2 1 # a\n",
             "one": "1 2 3 4 5 6 7", "turns": "-1 0 0 0 350 0 0\r\n2 0 0 0 10 -1e9 720\n",
             "large": "-1.7e308 1e150 0 0 0 0 0\n1.7e308 0 0 0 0 0 0\n", "short": "1 2 3\n",
             "long": "1 2 3 4 5 6 7 8\n", "words": "a b c d e f g\n", "nan": "nan 0 0 0 0 0 0\n",
             "backwards": "1 0 0 0 0 0 0\n0 0 0 0 0 0 0\n", "nothing": "# nothing\n",
             "hex": "0x1p3 0 0 0 0 0 0\n"}
    return {name: text.encode() for name, text in lines.items()}


TARGETS = {"gltf": gltf, "mesh": mesh, "tri": tri, "image": image, "plugin_file": plugin_file,
           "environment": environment, "head_path": head_path}
