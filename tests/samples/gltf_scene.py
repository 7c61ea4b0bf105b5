# SPDX-License-Identifier: MIT
"""Builds glTF files of squares in front of a camera at (0, 0, 3), piece by piece."""
import base64
import json
import struct

COMPONENT_TYPES = {"b": 5120, "B": 5121, "h": 5122, "H": 5123, "I": 5125, "f": 5126}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
CORNERS = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]


def data_uri(kind, data):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


class Scene:
    def __init__(self):
        self._data = b""
        self.document = {
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [],
            "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
            "meshes": [], "materials": [], "accessors": [], "bufferViews": []}
        self.node(camera=0, translation=[0, 0, 3])

    def add(self, kind, value):
        """Appends to one of the document's lists; the index."""
        self.document.setdefault(kind, []).append(value)
        return len(self.document[kind]) - 1

    def node(self, **node):
        self.document["scenes"][0]["nodes"].append(self.add("nodes", node))

    def view(self, data):
        self._data += b"\0" * (-len(self._data) % 4)
        offset = len(self._data)
        self._data += data
        return self.add("bufferViews",
                        {"buffer": 0, "byteOffset": offset, "byteLength": len(data)})

    def accessor(self, letter, kind, values, **more):
        return self.add("accessors", {
            "bufferView": self.view(struct.pack(f"<{len(values)}{letter}", *values)),
            "componentType": COMPONENT_TYPES[letter], "type": kind,
            "count": len(values) // COMPONENTS[kind], **more})

    def texture(self, image):
        """A texture with sharp texels that do not repeat."""
        self.add("images", {"uri": data_uri("image/png", image)})
        sampler = self.add("samplers", {"magFilter": 9728, "wrapS": 33071, "wrapT": 33071})
        return self.add("textures", {"source": len(self.document["images"]) - 1,
                                     "sampler": sampler})

    def material(self, colour=(1, 1, 1, 1), texture=None, **more):
        reflection = {"baseColorFactor": list(colour), "metallicFactor": 0}
        if texture is not None:
            reflection["baseColorTexture"] = (texture if isinstance(texture, dict)
                                              else {"index": texture})
        return self.add("materials", {"pbrMetallicRoughness": reflection, **more})

    def unlit(self, colour=(1, 1, 1, 1), texture=None, **more):
        return self.material(colour, texture, extensions={"KHR_materials_unlit": {}}, **more)

    def square(self, material, node=None, turned=False, corners=None, **attributes):
        """Two units wide around the origin; its attributes by name, as indices of accessors."""
        attributes.setdefault("POSITION", self.accessor("f", "VEC3", corners or CORNERS))
        attributes.setdefault("TEXCOORD_0",
                              self.accessor("f", "VEC2", [0, 1, 1, 1, 1, 0, 0, 0]))
        indices = [0, 2, 1, 0, 3, 2] if turned else [0, 1, 2, 0, 2, 3]
        primitive = {"attributes": attributes, "material": material,
                     "indices": self.accessor("H", "SCALAR", indices)}
        mesh = self.add("meshes", {"primitives": [primitive]})
        self.node(mesh=mesh, **(node or {}))
        return primitive

    def wall(self, material):
        """All that is seen behind the squares."""
        self.square(material, {"translation": [0, 0, -1], "scale": [9, 9, 1]})

    def text(self):
        document = dict(self.document)
        document["buffers"] = [{"byteLength": len(self._data),
                                "uri": data_uri("application/octet-stream", self._data)}]
        return json.dumps(document)
