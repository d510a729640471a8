"""Small good files of every format, so that scripts/mutants.py needs none from elsewhere.

A JPEG is the one thing that isn't made here: Python has no encoder for it.
"""

import base64
import json
import struct
import zlib

# 16x16 texels, progressive, by libjpeg.
JPEG = base64.b64decode(
    "/9j/2wBDACgcHiMeGSgjISMtKygwPGRBPDc3PHtYXUlkkYCZlo+AjIqgtObDoKrarYqMyP/L2u71////m8H////6"
    "/+b9//j/2wBDASstLTw1PHZBQXb4pYyl+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4+Pj4"
    "+Pj4+Pj4+Pj/wgARCAAQABADASIAAhEBAxEB/8QAFAABAAAAAAAAAAAAAAAAAAAAA//EABQBAQAAAAAAAAAAAAAA"
    "AAAAAAD/2gAMAwEAAhADEAAAAQREP//EABUQAQEAAAAAAAAAAAAAAAAAAAAR/9oACAEBAAEFAoiI/8QAFREBAQAA"
    "AAAAAAAAAAAAAAAAAgD/2gAIAQMBAT8BCv/EABYRAAMAAAAAAAAAAAAAAAAAAAABAv/aAAgBAgEBPwF0f//EABQQ"
    "AQAAAAAAAAAAAAAAAAAAACD/2gAIAQEABj8CH//EABYQAAMAAAAAAAAAAAAAAAAAAAABEf/aAAgBAQABPyFSKRSK"
    "T//aAAwDAQACAAMAAAAQy//EABQRAQAAAAAAAAAAAAAAAAAAAAD/2gAIAQMBAT8QP//EABgRAAIDAAAAAAAAAAAA"
    "AAAAABGhAGHR/9oACAECAQE/EAUFpU//xAAWEAEBAQAAAAAAAAAAAAAAAAARAFH/2gAIAQEAAT8QyrZVsq2Vb//Z"
)


def png(width=4, height=4):
    """Straight RGBA, a ramp of each."""
    rows = b""
    for y in range(height):
        rows += b"\0" + b"".join(bytes((60 * x, 60 * y, 128, 255 - 40 * x)) for x in range(width))
    text = b"\x89PNG\r\n\x1a\n"
    header = struct.pack(">IIBBBBB", width, height, 8, 6, 0, 0, 0)
    for name, content in ((b"IHDR", header), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")):
        text += struct.pack(">I", len(content)) + name + content
        text += struct.pack(">I", zlib.crc32(name + content))
    return text


class Buffer:
    """Grows by arrays, and keeps the views and accessors to them."""

    SIZES = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}
    TYPES = {"f": 5126, "B": 5121, "H": 5123, "I": 5125}

    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def view(self, content):
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        self.views.append(
            {"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(content)}
        )
        self.bytes += content
        return len(self.views) - 1

    def accessor(self, kind, letter, values):
        view = self.view(struct.pack(f"<{len(values)}{letter}", *values))
        self.accessors.append(
            {
                "bufferView": view,
                "componentType": self.TYPES[letter],
                "count": len(values) // self.SIZES[kind],
                "type": kind,
            }
        )
        return len(self.accessors) - 1


def gltf():
    """A document with one of everything, and its binary buffer."""
    buffer = Buffer()
    positions = buffer.accessor("VEC3", "f", [0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.5])
    uv = buffer.accessor("VEC2", "f", [0, 0, 1, 0, 0, 1, 1, 1])
    attributes = {
        "POSITION": positions,
        "NORMAL": buffer.accessor("VEC3", "f", [0, 0, 1] * 4),
        "TANGENT": buffer.accessor("VEC4", "f", [1, 0, 0, 1] * 4),
        "TEXCOORD_0": uv,
        "TEXCOORD_1": uv,
        "COLOR_0": buffer.accessor("VEC4", "B", [255, 200, 0, 100] * 4),
        "JOINTS_0": buffer.accessor("VEC4", "B", [0, 1, 0, 0] * 4),
        "WEIGHTS_0": buffer.accessor("VEC4", "f", [0.5, 0.5, 0, 0] * 4),
    }
    buffer.accessors[attributes["COLOR_0"]]["normalized"] = True
    indices = buffer.accessor("SCALAR", "H", [0, 1, 2, 2, 1, 3])
    times = buffer.accessor("SCALAR", "f", [0, 1])
    moved = buffer.accessor("VEC3", "f", [0, 0, 0.1] * 4)
    buffer.accessors[moved]["sparse"] = {
        "count": 1,
        "indices": {"bufferView": buffer.view(b"\3"), "componentType": 5121},
        "values": {"bufferView": buffer.view(struct.pack("<3f", 0, 0, 1))},
    }
    unit = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    texture = {"index": 0, "texCoord": 1}
    turned = {"KHR_texture_transform": {"offset": [0.1, 0], "rotation": 1, "scale": [2, 2]}}
    copies = {"attributes": {"TRANSLATION": positions}}
    document = {
        "asset": {"version": "2.0"},
        "extensionsUsed": [
            "KHR_lights_punctual", "KHR_texture_transform", "EXT_mesh_gpu_instancing",
            "KHR_materials_transmission",
        ],
        "scene": 0,
        "scenes": [{"nodes": [0, 1, 5]}],
        "nodes": [
            {"mesh": 0, "skin": 0, "weights": [0.5]},
            {"rotation": [0, 0, 0, 1], "scale": [1, 2, 1], "children": [2, 3, 4]},
            {"mesh": 1, "extensions": {"EXT_mesh_gpu_instancing": copies}},
            {"matrix": unit, "mesh": 2},
            {"translation": [0, 0, 4], "camera": 0},
            {"extensions": {"KHR_lights_punctual": {"light": 0}}, "mesh": 3},
        ],
        "meshes": [
            {
                "weights": [0.25],
                "primitives": [
                    {
                        "attributes": attributes,
                        "indices": indices,
                        "material": 0,
                        "targets": [{"POSITION": moved}],
                    }
                ],
            },
            {"primitives": [{"attributes": {"POSITION": positions, "TEXCOORD_0": uv}, "mode": 5,
                             "material": 1}]},
            {"primitives": [{"attributes": {"POSITION": positions}, "mode": 3, "material": 2}]},
            {"primitives": [{"attributes": {"POSITION": positions}, "mode": 0}]},
        ],
        "skins": [
            {
                "joints": [1, 3],
                "inverseBindMatrices": buffer.accessor("MAT4", "f", unit * 2),
            }
        ],
        "animations": [
            {
                "channels": [
                    {"sampler": i, "target": {"node": node, "path": path}}
                    for i, (node, path) in enumerate(
                        [(4, "translation"), (1, "rotation"), (0, "weights")])
                ],
                "samplers": [
                    {"input": times, "output": buffer.accessor("VEC3", "f", [0, 0, 4, 0, 1, 4])},
                    {
                        "input": times,
                        "output": buffer.accessor("VEC4", "f", [0, 0, 0, 1] * 6),
                        "interpolation": "CUBICSPLINE",
                    },
                    {
                        "input": times,
                        "output": buffer.accessor("SCALAR", "f", [0, 1]),
                        "interpolation": "STEP",
                    },
                ],
            }
        ],
        "cameras": [
            {"type": "perspective", "perspective": {"yfov": 0.6, "znear": 0.1, "zfar": 100}}
        ],
        "materials": [
            {
                "alphaMode": "BLEND",
                "doubleSided": True,
                "pbrMetallicRoughness": {
                    "baseColorFactor": [1, 0.5, 0.5, 0.5],
                    "baseColorTexture": {"index": 0, "extensions": turned},
                    "metallicRoughnessTexture": texture,
                },
                "normalTexture": {"index": 1, "scale": 0.5},
                "emissiveTexture": texture,
                "emissiveFactor": [0.1, 0, 0],
            },
            {
                "alphaMode": "MASK",
                "alphaCutoff": 0.4,
                "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "roughnessFactor": 0.3},
            },
            {"extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.5}}},
        ],
        "samplers": [{"wrapS": 33071, "wrapT": 33648, "minFilter": 9987, "magFilter": 9729}],
        "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
        "images": [
            {"bufferView": buffer.view(png()), "mimeType": "image/png"},
            {"bufferView": buffer.view(JPEG), "mimeType": "image/jpeg"},
        ],
        "extensions": {
            "KHR_lights_punctual": {
                "lights": [
                    {"type": "spot", "intensity": 2, "range": 9, "spot": {"outerConeAngle": 1}},
                ]
            }
        },
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.bytes)}],
    }
    return document, buffer.bytes


OBJ = b"""# a square of two materials, a line, points
mtllib square.mtl
v 0 0 0
v 1 0 0 0.5 0.5 1
v 1 1 0
v 0 1 0.5
vt 0 0
vt 1 0
vt 1 1
vn 0 0 1
o square
g first
usemtl pane
s 1
f 1/1/1 2/2/1 3/3/1
usemtl wall
f -4//-1 -2//-1 -1//-1
l 1 2 3 \\
 4
p 1 2
"""
MTL = b"""newmtl pane
Kd 0.8 0.2 0.1
Ks 0.5 0.5 0.5
Ns 100
d 0.5
map_Kd -s 2 2 1 -o 0.5 0 0 texture.png
map_d texture.png
newmtl wall
Kd 0.5
Ke 0.1 0 0
illum 2
map_Kd picture.jpg
bump -bm 0.5 texture.png
"""
PLY = """ply
format {} 1.0
comment a square
element vertex 4
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
property uchar alpha
element face 2
property list uchar int vertex_indices
end_header
"""
CORNERS = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0.5))
FACES = ((0, 1, 2), (0, 2, 3))


def ply(order):
    """`order` is struct's sign of the order of bytes, or empty for text."""
    name = {"": "ascii", "<": "binary_little_endian", ">": "binary_big_endian"}[order]
    body = b""
    for corner in CORNERS:
        if order:
            body += struct.pack(order + "3f4B", *corner, 200, 100, 50, 128)
        else:
            body += b"%g %g %g 200 100 50 128\n" % corner
    for face in FACES:
        body += struct.pack(order + "B3i", 3, *face) if order else b"3 %d %d %d\n" % face
    return PLY.format(name).encode() + body


def stl_text():
    text = "solid square\n"
    for face in FACES:
        text += "facet normal 0 0 1\nouter loop\n"
        text += "".join("vertex %g %g %g\n" % CORNERS[i] for i in face) + "endloop\nendfacet\n"
    return (text + "endsolid square\n").encode()


def stl_binary():
    body = b"".join(
        struct.pack("<12fH", 0, 0, 1, *(c for i in face for c in CORNERS[i]), 0) for face in FACES
    )
    return bytes(80) + struct.pack("<I", len(FACES)) + body


def tfx():
    strands = b"".join(struct.pack("<4f", x, -x * x, 0.5, 1) for x in range(6))
    return struct.pack("<f3I", 4, 2, 3, 160) + bytes(144) + strands


def write_sources(folder):
    """Writes them all; `folder` is there."""
    document, binary = gltf()
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(binary), b"BIN\0") + binary
    document["buffers"][0]["uri"] = "data:;base64," + base64.b64encode(binary).decode()
    files = {
        "all.glb": struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks,
        "all.gltf": json.dumps(document, indent=1).encode(),
        "square.obj": OBJ,
        "square.mtl": MTL,
        "texture.png": png(),
        "picture.jpg": JPEG,
        "text.ply": ply(""),
        "little.ply": ply("<"),
        "big.ply": ply(">"),
        "text.stl": stl_text(),
        "binary.stl": stl_binary(),
        "hair.tfx": tfx(),
    }
    document["buffers"][0]["uri"] = "apart.bin"
    files["apart.bin"] = binary
    document["images"][0] = {"uri": "texture.png"}
    files["apart.gltf"] = json.dumps(document, indent=1).encode()
    for name, content in files.items():
        (folder / name).write_bytes(content)
