# SPDX-License-Identifier: MIT
"""Writes binary glTF 2.0: quantised vertices (KHR_mesh_quantization), palette PNG images."""

import json
import struct
import zlib


def png_palette(width, height, indices, palette):
    """An 8-bit palette PNG; rows from the top. Palette noise compresses best unfiltered."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data
                + struct.pack(">I", zlib.crc32(kind + data)))

    rows = b"".join(b"\0" + bytes(indices[y * width:(y + 1) * width]) for y in range(height))
    return (b"\x89PNG\r\n\x1a\n"
            + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 3, 0, 0, 0))
            + chunk(b"PLTE", b"".join(bytes(colour) for colour in palette))
            + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


class GlbWriter:
    """Collects a scene; ids are glTF's indices."""

    def __init__(self, generator):
        self._json = {
            "asset": {"version": "2.0", "generator": generator},
            "extensionsUsed": ["KHR_mesh_quantization", "KHR_lights_punctual"],
            "extensionsRequired": ["KHR_mesh_quantization"],
            "scene": 0, "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "accessors": [],
            "bufferViews": [], "materials": [], "textures": [], "images": [], "samplers": [{}],
            "cameras": [], "extensions": {"KHR_lights_punctual": {"lights": []}},
        }
        self._binary = bytearray()
        self._mesh_scales = []

    def _view(self, data, **more):
        while len(self._binary) % 4:
            self._binary.append(0)
        view = {"buffer": 0, "byteOffset": len(self._binary), "byteLength": len(data), **more}
        self._binary += data
        return self._append("bufferViews", view)

    def _append(self, key, value):
        self._json[key].append(value)
        return len(self._json[key]) - 1

    def texture(self, name, png):
        image = self._append("images", {"name": name, "mimeType": "image/png",
                                        "bufferView": self._view(png)})
        return self._append("textures", {"source": image, "sampler": 0})

    def material(self, name, colour=(1, 1, 1), texture=None, metallic=0.0, roughness=1.0,
                 roughness_texture=None, emissive=None):
        pbr = {"baseColorFactor": [*colour, 1], "metallicFactor": metallic,
               "roughnessFactor": roughness}
        if texture is not None:
            pbr["baseColorTexture"] = {"index": texture}
        if roughness_texture is not None:
            pbr["metallicRoughnessTexture"] = {"index": roughness_texture}
        material = {"name": name, "pbrMetallicRoughness": pbr}
        if emissive is not None:
            material["emissiveFactor"] = list(emissive)
        return self._append("materials", material)

    def mesh(self, name, parts, fine_normals=False):
        """parts: (Mesh, material) pairs. Positions become 16-bit steps of one size for the whole
        mesh, which the nodes that use it scale back; normals 8-bit, or 16-bit for what mirrors."""
        normal_format, normal_type, unit = ("bbbb", 5120, 127)
        if fine_normals:
            normal_format, normal_type, unit = ("hhhh", 5122, 32767)
        layout = struct.Struct("<hhhh" + normal_format + "ff")
        largest = max(abs(c) for mesh, _ in parts for p in mesh.positions for c in p)
        step = largest / 32767
        primitives = []
        for mesh, material in parts:
            vertices, low, high = bytearray(), [32767] * 3, [-32767] * 3
            for p, n, uv in zip(mesh.positions, mesh.normals, mesh.uvs):
                q = [round(c / step) for c in p]
                low = [min(a, b) for a, b in zip(low, q)]
                high = [max(a, b) for a, b in zip(high, q)]
                # Texture coordinates in steps of 1/1024: enough, and it compresses.
                vertices += layout.pack(*q, 0, *(round(c * unit) for c in n), 0,
                                        *(round(c * 1024) / 1024 for c in uv))
            view = self._view(bytes(vertices), byteStride=layout.size, target=34962)
            count = len(mesh.positions)
            wide = count > 65535
            flat = [k for triangle in mesh.triangles for k in triangle]
            indices = struct.pack("<%d%s" % (len(flat), "I" if wide else "H"), *flat)
            attributes = {
                "POSITION": self._append("accessors", {
                    "bufferView": view, "componentType": 5122, "count": count, "type": "VEC3",
                    "min": low, "max": high}),
                "NORMAL": self._append("accessors", {
                    "bufferView": view, "byteOffset": 8, "componentType": normal_type,
                    "normalized": True, "count": count, "type": "VEC3"}),
                "TEXCOORD_0": self._append("accessors", {
                    "bufferView": view, "byteOffset": layout.size - 8, "componentType": 5126,
                    "count": count, "type": "VEC2"}),
            }
            primitives.append({"attributes": attributes, "material": material,
                               "indices": self._append("accessors", {
                                   "bufferView": self._view(indices, target=34963),
                                   "componentType": 5125 if wide else 5123,
                                   "count": len(flat), "type": "SCALAR"})})
        self._mesh_scales.append(step)
        return self._append("meshes", {"name": name, "primitives": primitives})

    def node(self, parent=None, mesh=None, translation=None, rotation=None, scale=(1, 1, 1),
             name=None, **more):
        """rotation: a quaternion. Returns the node's index; a node without parent is a root."""
        node = dict(more)
        if name is not None:
            node["name"] = name
        if mesh is not None:
            node["mesh"] = mesh
            scale = tuple(c * self._mesh_scales[mesh] for c in scale)
        if translation is not None:
            node["translation"] = [round(c, 4) for c in translation]
        if rotation is not None:
            node["rotation"] = [round(c, 5) for c in rotation]
        if tuple(scale) != (1, 1, 1):
            node["scale"] = [float("%.9g" % c) for c in scale]
        index = self._append("nodes", node)
        siblings = (self._json["scenes"][0]["nodes"] if parent is None
                    else self._json["nodes"][parent].setdefault("children", []))
        siblings.append(index)
        return index

    def camera(self, fov, near, far, **node):
        index = self._append("cameras", {"type": "perspective", "perspective": {
            "yfov": round(fov, 5), "znear": near, "zfar": far}})
        return self.node(camera=index, **node)

    def light(self, kind, colour, intensity, spot=None, **node):
        light = {"type": kind, "color": list(colour), "intensity": intensity}
        if spot is not None:
            light["spot"] = spot
        lights = self._json["extensions"]["KHR_lights_punctual"]["lights"]
        lights.append(light)
        return self.node(extensions={"KHR_lights_punctual": {"light": len(lights) - 1}}, **node)

    def write(self, path):
        while len(self._binary) % 4:
            self._binary.append(0)
        self._json["buffers"] = [{"byteLength": len(self._binary)}]
        text = json.dumps(self._json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(path, "wb") as out:
            out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(self._binary)))
            out.write(struct.pack("<I4s", len(text), b"JSON") + text)
            out.write(struct.pack("<I4s", len(self._binary), b"BIN\0") + self._binary)
