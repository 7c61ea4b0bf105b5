#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What can not be rendered is refused: an exit code, one line, no crash, little time and memory.

hostile_inputs.py OPENRT_RENDER
"""
import base64
import json
import os
import pathlib
import random
import struct
import sys
import tempfile
import unittest

import environment_files as files
from gltf_documents import INF, NAN, document, glb, spoilt, triangle_positions
from program_runs import Runner, largest_child_bytes

PROGRAM = sys.argv[1]
SANITIZED = len(sys.argv) > 2 and sys.argv[2] == "sanitized"
MEMORY = (8 if SANITIZED else 1) << 30


def sparse(**change):
    """Replaces each position by itself."""
    return {"count": 3, "indices": {"bufferView": 1, "componentType": 5123},
            "values": {"bufferView": 0}, **change}


class HostileInputs(unittest.TestCase):
    def setUp(self):
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name)
        self.runner = Runner(PROGRAM, self.folder)

    def tearDown(self):
        self._temporary.cleanup()
        self.assertLess(largest_child_bytes(), MEMORY)

    def write(self, name, content):
        path = self.folder / name
        if isinstance(content, dict):
            content = json.dumps(content)
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return path

    def refused(self, name, content, *words):
        line = self.runner.refusal(self.write(name, content))
        for word in words:
            self.assertIn(word, line)
        self.assertFalse((self.folder / "out.png").exists(), "a picture was left behind")

    # Control: the documents that are spoilt below are rendered when they are not.
    def test_good_files_are_rendered(self):
        for name, content in (("good.gltf", document()), ("good.glb", glb(document())),
                              ("sparse.gltf", spoilt(("accessors", 0, "sparse"), sparse()))):
            picture = self.runner.picture(self.write(name, content))
            self.assertEqual(picture.pixel(8, 6), (255, 0, 0))
            self.assertNotEqual(picture.pixel(0, 0), (255, 0, 0))

    def test_truncated_at_every_kind_of_place(self):
        whole = glb(document())
        places = sorted({*range(0, 40), *range(40, len(whole), 61),
                         *range(len(whole) - 8, len(whole))})
        for size in places:
            with self.subTest(size=size):
                self.refused("cut.glb", whole[:size])
        text = json.dumps(document())
        for size in range(0, len(text), 97):
            with self.subTest(text=size):
                self.refused("cut.gltf", text[:size])

    def test_lengths_in_the_container(self):
        whole = glb(document())
        json_length, = struct.unpack_from("<I", whole, 12)
        for offset in (8, 12, 20 + json_length):
            for value in (0, 1, 3, 12, 0x7FFFFFFF, 0xFFFFFFF0, 0xFFFFFFFF):
                with self.subTest(offset=offset, value=value):
                    broken = bytearray(whole)
                    struct.pack_into("<I", broken, offset, value)
                    self.refused("length.glb", bytes(broken))
        # A last chunk that reaches as far beyond the end as its header is long.
        broken = bytearray(whole)
        last, = struct.unpack_from("<I", whole, 20 + json_length)
        struct.pack_into("<I", broken, 20 + json_length, last + 8)
        self.refused("length.glb", bytes(broken), "chunk")
        self.refused("version.glb", whole[:4] + b"\1\0\0\0" + whole[8:], "version")

    def test_ranges_types_and_counts(self):
        a, v, b = "accessors", "bufferViews", "buffers"
        for path, value in [
                ((a, 0, "count"), 4), ((a, 0, "count"), 2 ** 31), ((a, 0, "count"), 2 ** 62),
                ((a, 0, "count"), -1), ((a, 0, "count"), None), ((a, 0, "count"), 1e300),
                ((a, 0, "byteOffset"), 4), ((a, 0, "byteOffset"), 2 ** 63),
                ((a, 0, "byteOffset"), 2 ** 64 - 4), ((a, 0, "bufferView"), 7),
                ((a, 0, "bufferView"), -3), ((a, 0, "bufferView"), None),
                ((a, 0, "componentType"), 5124), ((a, 0, "componentType"), 99),
                ((a, 0, "componentType"), 5130), ((a, 0, "componentType"), "float"),
                ((a, 0, "type"), "VEC2"), ((a, 0, "type"), "MAT4"), ((a, 0, "type"), "VEC9"),
                *(((a, 0, "sparse"), sparse(**change)) for change in (
                    {"count": 4}, {"count": 2 ** 31 - 1}, {"count": -1},
                    {"indices": {"bufferView": 1, "componentType": 5126}},
                    {"indices": {"bufferView": 1, "componentType": 5125, "byteOffset": -4}},
                    {"indices": {"bufferView": 9, "componentType": 5125}},
                    {"indices": {"bufferView": 0, "componentType": 5123, "byteOffset": 2}},
                    {"values": {"bufferView": 1}}, {"values": {"bufferView": -1}},
                    {"values": {"bufferView": 0, "byteOffset": 28}},
                    {"values": {"bufferView": 0, "byteOffset": -12}})),
                ((a, 1, "componentType"), 5126), ((a, 1, "count"), 4000000000),
                ((a, 1, "type"), "VEC3"), ((a, 1, "bufferView"), 2),
                ((v, 0, "byteLength"), 2 ** 40), ((v, 0, "byteOffset"), 2 ** 64 - 16),
                ((v, 0, "byteOffset"), 1000), ((v, 0, "buffer"), 3), ((v, 0, "buffer"), -1),
                ((v, 0, "byteStride"), 4), ((v, 0, "byteStride"), 252),
                ((v, 0, "byteStride"), 2 ** 63), ((v, 0, "byteLength"), 0),
                ((b, 0, "byteLength"), 2 ** 40), ((b, 0, "byteLength"), 0),
                ((b, 0, "byteLength"), -5), ((b, 0, "byteLength"), 41),
                (("meshes", 0, "primitives", 0, "attributes", "POSITION"), 5),
                (("meshes", 0, "primitives", 0, "attributes", "POSITION"), -1),
                (("meshes", 0, "primitives", 0, "attributes", "NORMAL"), 1),
                (("meshes", 0, "primitives", 0, "attributes", "TEXCOORD_0"), 0),
                (("meshes", 0, "primitives", 0, "indices"), 9),
                (("meshes", 0, "primitives", 0, "indices"), 0),
                (("meshes", 0, "primitives", 0, "material"), 5),
                (("meshes", 0, "primitives", 0, "material"), -5),
                (("nodes", 0, "mesh"), 5), (("nodes", 1, "camera"), 5),
                (("nodes", 0, "children"), [99]), (("nodes", 0, "children"), [-2]),
                (("scenes", 0, "nodes"), [5]), (("scene",), 4),
                (("cameras", 0, "perspective", "yfov"), 0),
                (("cameras", 0, "perspective", "yfov"), 4),
                *((("cameras", 0), {"type": "orthographic", "orthographic": {
                    "xmag": 1, "ymag": ymag, "znear": 0.1, "zfar": 9}}) for ymag in (0, -1, 1e300)),
                (("extensionsRequired",), ["KHR_draco_mesh_compression"]),
                (("asset",), None), (("nodes",), "none"), (("buffers",), {"a": 1}),
                (("materials", 0, "pbrMetallicRoughness", "baseColorTexture"), {"index": 3})]:
            with self.subTest(path=path, value=value):
                self.refused("range.gltf", spoilt(path, value))

    def test_indices_beyond_the_vertices(self):
        self.refused("index.gltf", document(indices=(0, 1, 3)), "index 3")

    def test_lights_that_are_not_there(self):
        doc = document()
        doc["nodes"][0]["extensions"] = {"KHR_lights_punctual": {"light": 3}}
        self.refused("light.gltf", doc, "light")
        doc["nodes"][0]["extensions"] = {"KHR_lights_punctual": {"light": -1e300}}
        self.refused("light.gltf", doc, "light")

    def test_nodes_that_form_no_trees(self):
        cycle = document()
        cycle["nodes"][0]["children"] = [0]
        self.refused("self.gltf", cycle, "node 0")
        cycle["nodes"][0]["children"] = [2]
        cycle["nodes"].append({"children": [0]})
        self.refused("cycle.gltf", cycle, "twice")
        # Each node refers twice to the next: 2^60 paths.
        doubling = document()
        doubling["nodes"] = [{"children": [i + 1, i + 1]} for i in range(60)] + [{"mesh": 0}]
        doubling["scenes"][0]["nodes"] = [0]
        self.refused("doubling.gltf", doubling, "twice")
        # Without a scene and with nothing but a cycle there is no root.
        ring = document()
        del ring["scene"], ring["scenes"]
        ring["nodes"] = [{"mesh": 0, "children": [1]}, {"children": [0]}]
        self.refused("ring.gltf", ring, "no triangle")

    def test_json_nested_without_end(self):
        for depth in (100, 100000):
            deep = document()
            text = json.dumps(deep)[:-1] + ',"extras":' + "[" * depth + "]" * depth + "}"
            self.refused("deep.gltf", text, "nested")
            self.refused("open.gltf", '{"extras":' + '{"a":' * depth)
        flat = document()  # control: many brackets, none deep, some in strings
        flat["extras"] = [[], {}, "[[[[{{{{\\\""] * 2000
        self.runner.picture(self.write("flat.gltf", flat))

    def test_uris_that_lead_out(self):
        (self.folder / "scene").mkdir()
        good = document()
        data = base64.b64decode(good["buffers"][0]["uri"].split(",")[1])
        secret = self.write("secret.bin", data)
        self.write("scene/inside.bin", data)
        os.symlink(secret, self.folder / "scene/link.bin")
        os.mkfifo(self.folder / "scene/pipe.bin")

        def with_uri(uri):
            return self.write("scene/scene.gltf", spoilt(("buffers", 0, "uri"), uri))

        self.runner.picture(with_uri("inside.bin"))  # control: the data are good
        self.runner.picture(with_uri("%69nside.bin"))
        (self.folder / "out.png").unlink()
        for uri in ("../secret.bin", "%2e%2e/secret.bin", "%2E%2E%2Fsecret.bin",
                    "./../secret.bin", "x/../../secret.bin", str(secret), "/etc/passwd",
                    "%2Fetc%2Fpasswd", f"file://{secret}", "http://127.0.0.1/a.bin",
                    "link.bin", "..\\secret.bin", "~/secret.bin", "inside.bin%00.png",
                    "missing.bin", "pipe.bin", ".", "", "%", "inside%2", "inside.bin%zz",
                    "/dev/zero", "data:;base64,", "data:application/octet-stream;base64,@@@@"):
            with self.subTest(uri=uri):
                self.runner.refusal(with_uri(uri))
        for uri in ("../picture.png", "/etc/hostname", "missing.png", "scene.gltf"):
            with self.subTest(image=uri):
                doc = document()
                doc["images"] = [{"uri": uri}]
                doc["textures"] = [{"source": 0}]
                doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
                self.runner.refusal(self.write("scene/image.gltf", doc))

    def test_images_in_buffers(self):
        for view in ({"buffer": 0, "byteOffset": 2 ** 40, "byteLength": 100},
                     {"buffer": 0, "byteOffset": 0, "byteLength": 2 ** 40},
                     {"buffer": 0, "byteOffset": 40, "byteLength": 1000},
                     {"buffer": 5, "byteOffset": 0, "byteLength": 10},
                     {"buffer": 0, "byteOffset": 0, "byteLength": 20}):
            with self.subTest(view=view):
                doc = document()
                doc["bufferViews"].append(view)
                doc["images"] = [{"bufferView": 2, "mimeType": "image/png"}]
                doc["textures"] = [{"source": 0}]
                doc["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {"index": 0}
                self.refused("image.glb", glb(doc))

    def test_small_files_that_ask_for_much(self):
        many = document()
        many["buffers"] += [{"byteLength": 40} for _ in range(10000)]
        self.refused("buffers.glb", glb(many), "URI")
        repeated = document(indices=tuple([0, 1, 2] * 20000))
        primitive = repeated["meshes"][0]["primitives"][0]
        repeated["meshes"] = [{"primitives": [primitive] * 20000}]
        self.refused("repeated.glb", glb(repeated), "too often")

    def test_nothing_to_see(self):
        empty = {"asset": {"version": "2.0"}, "scenes": [{"nodes": []}]}
        self.refused("empty.gltf", empty, "no triangle")
        self.refused("zero.gltf", spoilt(("accessors", 1, "count"), 0), "no triangle")
        self.refused("lines.gltf", spoilt(("meshes", 0, "primitives", 0, "mode"), 1),
                     "no triangle")
        self.refused("nan.gltf", document([NAN] * 9), "no triangle")
        huge = document()
        huge["nodes"][0]["scale"] = [1e300, 1e300, 1e300]
        self.refused("huge.gltf", huge, "no triangle")
        self.refused("empty.tri", struct.pack("<I", 0), "no triangle")
        self.refused("empty.obj", "# nothing\n")
        self.refused("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")

    def test_triangles_without_numbers_leave_their_neighbours_alone(self):
        without_numbers, without_area = [NAN, 0, 0, 1, INF, 0, 0, 0, 0], [0.25] * 9
        positions = triangle_positions(*without_numbers, *without_area)
        doc = document(positions, (0, 1, 2, 3, 4, 5, 6, 7, 8))
        picture = self.runner.picture(self.write("nan.glb", glb(doc)))
        alone = self.runner.picture(self.write("good.glb", glb(document())), output="good.png")
        for y in range(12):
            for x in range(16):
                self.assertEqual(picture.pixel(x, y), alone.pixel(x, y))
        dropped = self.runner.statistics(self.folder / "nan.glb")["dropped_triangles"]
        self.assertEqual(dropped, 2)

    def test_bare_triangles(self):
        good = struct.pack("<I9f", 1, *triangle_positions())
        self.runner.picture(self.write("good.tri", good))
        (self.folder / "out.png").unlink()
        for size in range(len(good)):
            self.refused("cut.tri", good[:size])
        for count in (0, 2, 0x7FFFFFFF, 0xFFFFFFFF, 0x71C71C73):
            self.refused("lie.tri", struct.pack("<I9f", count, *triangle_positions()))
        self.refused("long.tri", good + b"\0")

    def test_meshes_as_text(self):
        header = ("ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
                  "property float z\nelement face {}\nproperty list uchar int vertex_indices\n"
                  "end_header\n")
        body = "-1 -1 0\n1 -1 0\n0 1 0\n3 0 1 2\n"
        self.runner.picture(self.write("good.ply", header.format(3, 1) + body))
        self.runner.picture(self.write("good.obj", "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n"))
        (self.folder / "out.png").unlink()
        for vertices, faces in ((3000000000, 1), (3, 3000000000), (30, 1), ("x", 1)):
            self.refused("lie.ply", header.format(vertices, faces) + body)
        self.refused("index.ply", header.format(3, 1) + body.replace("3 0 1 2", "3 0 1 9"))
        self.refused("noise.ply", "ply\n" + "\0\1\2" * 500)
        self.refused("noise.obj", bytes(range(256)) * 20)
        self.refused("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999\n")
        self.refused("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -99999999\n")
        self.refused("mtl.obj", "mtllib ../../etc/passwd\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                     "refused")
        # A property before any material, which assimp does not survive.
        self.write("early.mtl", "map_Kd a.png\nd 0.5\nnewmtl m\nKd 1 0 0\n")
        self.runner.picture(self.write("early.obj", "mtllib early.mtl\nv -1 -1 0\nv 1 -1 0\n"
                                                    "v 0 1 0\nusemtl m\nf 1 2 3\n"))

    def test_random_damage_never_crashes(self):
        """Whatever comes of it: a picture or a refusal."""
        generator = random.Random(20090)
        obj = b"v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\n"
        ply = (b"ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\n"
               b"property float y\nproperty float z\nelement face 1\n"
               b"property list uchar int vertex_indices\nend_header\n"
               + struct.pack("<9fB3i", *triangle_positions(), 3, 0, 1, 2))
        mtl = b"newmtl m\nKd 1 0 0\nNs 20\nmap_Kd -s 1 1 1 t.png\nillum 2\nd 0.5\n"
        self.write("b.obj", b"mtllib a.mtl\nusemtl m\n" + obj)
        for name, good in (("a.glb", glb(document())), ("a.obj", obj), ("a.ply", ply),
                           ("a.mtl", mtl)):
            for _ in range(10 if SANITIZED else 40):
                broken = bytearray(good)
                for _ in range(generator.randint(1, 4)):
                    broken[generator.randrange(len(broken))] = generator.randrange(256)
                path = self.write(name, bytes(broken))
                if name == "a.mtl":
                    path = self.folder / "b.obj"
                with self.subTest(name=name, content=bytes(broken)):
                    result = self.runner.run(path)
                    self.assertIn(result.returncode, (0, 1), result.stderr[-2000:])

    def test_environments_that_are_spoilt(self):
        scene = self.write("good.glb", glb(document()))
        rows = [[(0.25, 0.5, 0.75 + x / 64) for x in range(40)]] * 20
        exr, hdr = files.exr(rows), files.hdr(rows)
        path = self.write("good.exr", exr)
        if b"built without OpenEXR" in self.runner.run(scene, "--environment", path).stderr:
            self.skipTest("the program reads no OpenEXR")
        (self.folder / "out.png").unlink()

        def refused(name, content, word=""):
            line = self.runner.refusal(scene, "--environment", self.write(name, content))
            self.assertIn(word, line)
            self.assertFalse((self.folder / "out.png").exists(), "a picture was left behind")

        for name, good in (("a.exr", exr), ("zip.exr", files.exr(rows, compression=files.ZIP)),
                           ("tiles.exr", files.tiled_exr(rows, 16)), ("a.hdr", hdr)):
            self.runner.picture(scene, "--environment", self.write(name, good))  # control
            (self.folder / "out.png").unlink()
            for size in [*range(0, 60, 7), *range(60, len(good), max(len(good) // 9, 1)),
                         len(good) - 1]:
                with self.subTest(name=name, size=size):
                    refused(f"cut{name[-4:]}", good[:size])

        def header(width, height, *more, **change):
            return files.exr_header(width, height, *more, **change) + bytes(4096)

        tiles = files.attribute("tiles", "tiledesc", struct.pack("<IIB", 1, 1, 0))
        huge_tiles = files.attribute("tiles", "tiledesc", struct.pack("<IIB", 2 ** 31, 2 ** 31, 0))
        cube = files.attribute("envmap", "envmap", b"\1")
        many = [files.channel(f"c{i}", files.FLOAT) for i in range(3000)]
        for content, word in (
                (header(2 ** 31 - 1, 1), "pixels"), (header(1, 2 ** 31 - 1), "pixels"),
                (header(16385, 8), "pixels"), (header(0, 1), "pixels"), (header(1, -7), "pixels"),
                (header(16384, 16384), "too large"), (header(16384, 8192), ""),
                (header(16384, 8192, tiles, version=0x202), "tiles"),
                (header(64, 64, huge_tiles, version=0x202), "tiles"),
                (header(64, 64, version=0x202), "tiles"), (header(64, 64, cube), "cube"),
                (header(16384, 8, channels=many), "channels"),
                (header(4, 4, channels=many[:2]), "channels"),
                (header(4, 4, channels=[files.channel("Y", files.HALF, 2)]), ""),
                (header(4, 4, compression=200), ""), (header(4, 4, version=0x802), "parts"),
                (header(4, 4, version=0x1002), "parts"), (header(4, 4, version=3), "version"),
                (header(4, 4, files.attribute("dataWindow", "box2i", bytes(16))), "repeats"),
                (exr[:8] + files.attribute("channels", "chlist", b"R"), "beyond"),
                (exr[:8] + b"a\0b\0" + b"\xff" * 4, "beyond"), (exr[:8] + bytes(64), "channels"),
                (exr.replace(struct.pack("<iI", 0, 480), struct.pack("<iI", 7, 480)), ""),
                (exr.replace(struct.pack("<iI", 0, 480), struct.pack("<iI", 0, 2 ** 31 - 1)), ""),
                (b"", ""), (bytes(300), "begin")):
            with self.subTest(size=len(content), word=word):
                refused("header.exr", content, word)
        start = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"
        for content, word in (
                (start + b"-Y 99999999999 +X 8\n", "pixels"), (start + b"-Y 8 +X 16385\n", "pixels"),
                (start + b"-Y 0 +X 8\n", "pixels"), (start + b"-Y 16384 +X 8192\n", "cut off"),
                (start + b"+Y 8 +X 8\n" + bytes(300), "rows"), (start + b"-Y 8\n", "rows"),
                (start[:11] + b"\n-Y 1 +X 1\n" + bytes(4), "format"), (start * 100, ""),
                (start + b"-Y 1 +X 8\n" + bytes([2, 2, 0, 8, 0]) + bytes(99), "runs"),
                (start + b"-Y 1 +X 8\n" + bytes([2, 2, 0, 8, 137]) + bytes(99), "runs"),
                (b"#?", "cut off"), (hdr.replace(b"32-bit_rle_rgbe", b"32-bit_rle_xyze"), "format")):
            with self.subTest(content=content[:80]):
                refused("header.hdr", content, word)
        for name in ("missing.exr", "folder.exr", "pipe.hdr"):
            path = self.folder / name
            if name[0] == "f":
                path.mkdir()
            if name[0] == "p":
                os.mkfifo(path)
            self.assertIn(name, self.runner.refusal(scene, "--environment", path))
        generator = random.Random(20091)
        for good in (exr, files.exr(rows, compression=files.ZIP), files.tiled_exr(rows, 16), hdr):
            for _ in range(10 if SANITIZED else 40):
                broken = bytearray(good)
                for _ in range(generator.randint(1, 4)):
                    broken[generator.randrange(min(len(broken), 700))] = generator.randrange(256)
                path = self.write("damaged.exr", bytes(broken))
                with self.subTest(content=bytes(broken)):
                    result = self.runner.run(scene, "--environment", path)
                    self.assertIn(result.returncode, (0, 1), result.stderr[-2000:])

    def test_files_that_are_none(self):
        self.runner.refusal(self.folder / "missing.glb")
        for name in ("folder.glb", "folder.obj", "folder.tri"):
            (self.folder / name).mkdir()
            self.runner.refusal(self.folder / name)
        os.mkfifo(self.folder / "pipe.glb")
        self.runner.refusal(self.folder / "pipe.glb")
        for name in ("a.glb", "a.gltf", "a.obj", "a.ply", "a.tri", "a.xyz", "a"):
            self.refused(name, b"")

    def test_command_lines(self):
        scene = self.write("good.glb", glb(document()))
        for size in ("0x0", "0x10", "10x0", "-1x5", "10", "10x", "x10", "axb", "10x10x10",
                     "99999999999x1", "40000x40000", "1e3x10", ""):
            with self.subTest(size=size):
                self.runner.refusal(scene, size=size)
        for arguments in (["--camera", "0,0,0"], ["--camera", "0,0,0,0,0,0,45"],
                          ["--camera", "0,0,nan,0,0,0,45"], ["--camera", "0,0,1,0,0,0,180"],
                          ["--light", "1,2"], ["--light", "a,b,c"], ["--light", "1,2,3,4"],
                          ["--samples", "0"], ["--samples", "100000"], ["--samples", "-1"],
                          ["--threads", "-3"], ["--threads", "100000"], ["--frames", "0"],
                          ["--precision", "exact"], ["--stats=xml"], ["--unknown"],
                          ["--exposure", "1e9"]):
            with self.subTest(arguments=arguments):
                self.runner.refusal(scene, *arguments)
        self.assertIn("precise", self.runner.refusal(scene, "--precision", "exact"))
        for output in ("out.jpg", "out", "missing/out.png", "."):
            with self.subTest(output=output):
                self.runner.refusal(scene, output=output)
        (self.folder / "folder.png").mkdir()
        self.runner.refusal(scene, output="folder.png")
        if os.geteuid() != 0:
            self.write("locked.png", b"old").chmod(0o400)
            self.runner.refusal(scene, output="locked.png")

    def test_an_output_that_can_not_be_written_is_known_before_rendering(self):
        scene = self.write("good.glb", glb(document()))
        # Rendering this would take minutes.
        self.runner.refusal(scene, "--samples", "4096", output="missing/out.png",
                            size="16000x16000")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
