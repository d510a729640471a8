#!/usr/bin/env python3
"""Makes tea_table.glb, the still life that Sheer's documentation renders.

    python3 scenes/make_tea_table.py [scenes/tea_table.glb]

Everything is computed here, from the standard library alone: an opaque table on a floor, glasses
with inner and outer walls and tea in them, coloured acrylic panes behind one another, and a folding
screen whose lattice is cut out of plain panels by vertex alpha (alphaMode MASK). Metres, y up.
"""

import json
import math
import os
import struct
import sys

TAU = 2 * math.pi
FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT = 5126, 5121, 5123


def mix(a, b, t):
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def smooth(t):
    t = min(max(t, 0.0), 1.0)
    return t * t * (3 - 2 * t)


def unit(v):
    length = math.sqrt(sum(c * c for c in v))
    return tuple(c / length for c in v)


def axis_angle(axis, degrees):
    """A quaternion as glTF writes it."""
    half = math.radians(degrees) / 2
    return [round(c * math.sin(half), 7) for c in axis] + [round(math.cos(half), 7)]


class Shape:
    """A triangle mesh that grows. A vertex is a position, a normal and a colour or None."""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def add(self, position, normal, color=None):
        self.vertices.append((position, normal, color))
        return len(self.vertices) - 1

    def quad(self, a, b, c, d):
        self.triangles += [(a, b, c), (a, c, d)]

    def box(self, low, high, color=None):
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, 1):
                normal = [0.0, 0.0, 0.0]
                normal[axis] = 2.0 * side - 1
                corners = []
                for s, t in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = [0.0, 0.0, 0.0]
                    p[axis] = (low, high)[side][axis]
                    p[u], p[v] = (low, high)[s][u], (low, high)[t][v]
                    corners.append(self.add(tuple(p), tuple(normal), color))
                self.quad(*(corners if side else reversed(corners)))

    def turned(self, profile, segments, color=None):
        """A surface of revolution about y. The profile's (radius, height) points run so that the
        outside is on their right; a point that is given twice is a sharp edge. `color` is a
        function of (radius, height, angle)."""
        runs, run = [], [profile[0]]
        for point in profile[1:]:
            if point == run[-1]:
                runs.append(run)
                run = []
            run.append(point)
        for run in runs + [run]:
            self._turn_run(run, segments, color)

    def _turn_run(self, run, segments, color):
        rings = []
        for i, (radius, height) in enumerate(run):
            before, after = run[max(i - 1, 0)], run[min(i + 1, len(run) - 1)]
            across, along = unit((after[1] - before[1], before[0] - after[0]))
            ring = []
            for k in range(segments + 1):
                c, s = math.cos(TAU * k / segments), math.sin(TAU * k / segments)
                ring.append(self.add((radius * c, height, radius * s),
                                     (across * c, along, across * s),
                                     color and color(radius, height, TAU * k / segments)))
            rings.append(ring)
        for (lower, (r0, _)), (upper, (r1, _)) in zip(zip(rings, run), zip(rings[1:], run[1:])):
            for k in range(segments):
                if r0 > 0:
                    self.triangles.append((lower[k], upper[k], lower[k + 1]))
                if r1 > 0:
                    self.triangles.append((lower[k + 1], upper[k], upper[k + 1]))


class Glb:
    """Collects a glTF document and its one buffer."""

    def __init__(self):
        self.data = bytearray()
        self.json = {
            "asset": {"version": "2.0", "generator": "scenes/make_tea_table.py",
                      "copyright": "Sheer authors, MIT"},
            "scene": 0,
            "scenes": [{"name": "Tea table", "nodes": []}],
            "nodes": [], "meshes": [], "materials": [], "cameras": [],
            "accessors": [], "bufferViews": [],
        }

    def append(self, kind, item):
        self.json[kind].append(item)
        return len(self.json[kind]) - 1

    def accessor(self, rows, component, layout, target):
        kind = "SCALAR" if len(rows[0]) == 1 else "VEC%d" % len(rows[0])
        self.data += b"\0" * (-len(self.data) % 4)
        packed = b"".join(struct.pack("<" + layout * len(row), *row) for row in rows)
        view = self.append("bufferViews", {"buffer": 0, "byteOffset": len(self.data),
                                           "byteLength": len(packed), "target": target})
        self.data += packed
        return self.append("accessors", {"bufferView": view, "componentType": component,
                                         "count": len(rows), "type": kind})

    def geometry(self, shape):
        """The attributes and indices of a primitive; several may share them."""
        positions = [struct.unpack("<3f", struct.pack("<3f", *v[0])) for v in shape.vertices]
        attributes = {"POSITION": self.accessor(positions, FLOAT, "f", 34962),
                      "NORMAL": self.accessor([unit(v[1]) for v in shape.vertices], FLOAT, "f",
                                              34962)}
        bounds = self.json["accessors"][attributes["POSITION"]]
        bounds["min"] = [min(p[k] for p in positions) for k in range(3)]
        bounds["max"] = [max(p[k] for p in positions) for k in range(3)]
        if shape.vertices[0][2]:
            colors = [[round(255 * min(max(c, 0), 1)) for c in (*v[2], 1.0)[:4]]
                      for v in shape.vertices]
            attributes["COLOR_0"] = self.accessor(colors, UNSIGNED_BYTE, "B", 34962)
            self.json["accessors"][attributes["COLOR_0"]]["normalized"] = True
        indices = self.accessor([(i,) for t in shape.triangles for i in t], UNSIGNED_SHORT, "H",
                                34963)
        return {"attributes": attributes, "indices": indices}

    def material(self, name, color=(1, 1, 1, 1), **more):
        return self.append("materials", {
            "name": name, **more,
            "pbrMetallicRoughness": {"baseColorFactor": list(color), "metallicFactor": 0}})

    def mesh(self, name, geometry, material):
        return self.append("meshes", {"name": name,
                                      "primitives": [{**geometry, "material": material}]})

    def node(self, name, parent=None, **more):
        number = self.append("nodes", {"name": name, **more})
        if parent is None:
            self.json["scenes"][0]["nodes"].append(number)
        else:
            self.json["nodes"][parent].setdefault("children", []).append(number)
        return number

    def write(self, path):
        self.data += b"\0" * (-len(self.data) % 4)
        self.json["buffers"] = [{"byteLength": len(self.data)}]
        text = json.dumps(self.json, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        body = (struct.pack("<I4s", len(text), b"JSON") + text +
                struct.pack("<I4s", len(self.data), b"BIN\0") + bytes(self.data))
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 12 + len(body)) + body)


def add_floor(glb):
    def color(radius, _, angle):
        dusk = mix((0.74, 0.66, 0.55), (0.40, 0.45, 0.52), smooth(radius / 2.4))
        return mix(dusk, (0.82, 0.70, 0.56), 0.12 * (1 + math.cos(angle - 1.0)))

    shape = Shape()
    shape.turned([(2.4 * (1 - (i / 12)), 0.0) for i in range(13)], 64, color)
    floor = glb.mesh("Floor", glb.geometry(shape), glb.material("Floor"))
    glb.node("Floor", mesh=floor)


def add_table(glb):
    """A round top on three splayed legs, and the tray on it."""
    def wood(radius, height, angle):
        ring = 0.5 + 0.5 * math.sin(120 * radius + 3 * math.sin(2 * angle))
        return mix((0.22, 0.105, 0.05), (0.34, 0.18, 0.09), 0.65 * ring + 0.35 * (height > 0.4))

    top = Shape()
    edge = [(0.0, 0.39), (0.36, 0.39), (0.36, 0.39), (0.384, 0.394), (0.39, 0.405), (0.384, 0.416),
            (0.375, 0.42), (0.375, 0.42)]
    top.turned(edge + [(0.375 * (1 - i / 20), 0.42) for i in range(1, 21)], 64, wood)
    leg = Shape()
    leg.turned([(0.0, 0.0), (0.014, 0.0), (0.014, 0.0), (0.018, 0.1), (0.026, 0.40)], 16, wood)
    material = glb.material("Walnut")
    table = glb.node("Table")
    glb.node("Table top", table, mesh=glb.mesh("Table top", glb.geometry(top), material))
    leg_mesh = glb.mesh("Table leg", glb.geometry(leg), material)
    for k in range(3):
        angle = TAU * (k / 3 + 0.08)
        lean = axis_angle((-math.sin(angle), 0, math.cos(angle)), 12)
        glb.node("Leg %d" % (k + 1), table, mesh=leg_mesh, rotation=lean,
                 translation=[round(0.32 * math.cos(angle), 4), 0,
                              round(0.32 * math.sin(angle), 4)])

    tray = Shape()
    tray.turned([(0.27, 0.0), (0.29, 0.004), (0.305, 0.026), (0.305, 0.026), (0.298, 0.026),
                 (0.298, 0.026), (0.284, 0.010), (0.27, 0.006), (0.27, 0.006), (0.0, 0.006)], 64)
    lacquer = glb.material("Lacquer", (0.09, 0.10, 0.12, 1))
    return glb.node("Tray", table, translation=[0.02, 0.421, 0.05],
                    mesh=glb.mesh("Tray", glb.geometry(tray), lacquer))


TUMBLER = [(0.0, 0.0), (0.030, 0.0), (0.033, 0.003), (0.036, 0.03), (0.0405, 0.099),
           (0.0398, 0.1005), (0.0390, 0.099), (0.0345, 0.03), (0.0315, 0.012), (0.028, 0.0095),
           (0.0, 0.0095)]
TEA = [(0.0, 0.0105), (0.027, 0.0105), (0.0306, 0.013), (0.0338, 0.03), (0.0358, 0.06),
       (0.0358, 0.06), (0.0, 0.06)]
CARAFE_OUTER = [(0.0, 0.0), (0.050, 0.0), (0.058, 0.004), (0.070, 0.030), (0.076, 0.060),
                (0.074, 0.090), (0.062, 0.125), (0.044, 0.155), (0.032, 0.180), (0.028, 0.205),
                (0.030, 0.230), (0.040, 0.262)]
CARAFE_INNER = [(0.0392, 0.2635), (0.0380, 0.262), (0.0275, 0.230), (0.0255, 0.205),
                (0.0295, 0.180), (0.0415, 0.154), (0.0595, 0.124), (0.0715, 0.089),
                (0.0735, 0.060), (0.0675, 0.031), (0.056, 0.010), (0.048, 0.006), (0.0, 0.006)]
CARAFE_TEA = [(0.0, 0.007), (0.047, 0.007), (0.055, 0.011), (0.0665, 0.031), (0.0725, 0.060),
              (0.0705, 0.089), (0.0625, 0.112), (0.0625, 0.112), (0.0, 0.112)]


def add_glasses(glb, tray):
    tumbler, tea, carafe, carafe_tea = Shape(), Shape(), Shape(), Shape()
    tumbler.turned(TUMBLER, 48)
    tea.turned(TEA, 48)
    carafe.turned(CARAFE_OUTER + CARAFE_INNER, 56)
    carafe_tea.turned(CARAFE_TEA, 56)
    amber = glb.material("Tea", (0.66, 0.20, 0.02, 0.58), alphaMode="BLEND")
    tumbler, tea = glb.geometry(tumbler), glb.geometry(tea)
    tea_mesh = glb.mesh("Tea", tea, amber)
    glasses = [("Rose", (0.84, 0.20, 0.30, 0.24), (-0.125, 0.125), True),
               ("Teal", (0.04, 0.50, 0.52, 0.24), (0.0, 0.185), False),
               ("Violet", (0.36, 0.24, 0.78, 0.24), (0.125, 0.125), True)]
    for name, color, (x, z), full in glasses:
        glass = glb.material(name + " glass", color, alphaMode="BLEND", doubleSided=True)
        node = glb.node(name + " tumbler", tray, translation=[x, 0.0065, z], scale=[1.2, 1.2, 1.2],
                        mesh=glb.mesh(name + " tumbler", tumbler, glass))
        if full:
            glb.node(name + " tumbler's tea", node, mesh=tea_mesh)
    clear = glb.material("Carafe glass", (0.50, 0.76, 0.72, 0.16), alphaMode="BLEND",
                         doubleSided=True)
    node = glb.node("Carafe", tray, translation=[0.02, 0.0065, -0.07], scale=[1.25, 1.25, 1.25],
                    mesh=glb.mesh("Carafe", glb.geometry(carafe), clear))
    glb.node("Carafe's tea", node, mesh=glb.mesh("Carafe's tea", glb.geometry(carafe_tea), amber))


def add_sweets(glb, tray):
    """Sugar cubes and a lemon: something opaque among the glasses."""
    cube = Shape()
    cube.box((-0.0085, 0.0, -0.0085), (0.0085, 0.017, 0.0085))
    sugar = glb.mesh("Sugar", glb.geometry(cube), glb.material("Sugar", (0.90, 0.88, 0.84, 1)))
    for k, (x, y, z, turn) in enumerate([(-0.195, 0, 0.045, 20), (-0.219, 0, 0.052, 65),
                                         (-0.205, 0, 0.070, 5), (-0.206, 0.017, 0.056, 40)]):
        glb.node("Sugar %d" % (k + 1), tray, mesh=sugar, translation=[x, 0.0065 + y, z],
                 rotation=axis_angle((0, 1, 0), turn))
    lemon = Shape()
    profile = []
    for i in range(17):
        along = math.cos(math.pi * (1 - i / 16))
        tip = 0.008 * smooth((abs(along) - 0.9) / 0.1) * (1 if along > 0 else -1)
        profile.append((0.029 * math.sqrt(max(0.0, 1 - along * along)), 0.037 * along + tip))
    profile[0], profile[-1] = (0.0, profile[0][1]), (0.0, profile[-1][1])
    lemon.turned(profile, 32)
    yellow = glb.material("Lemon", (0.90, 0.70, 0.10, 1))
    glb.node("Lemon", tray, mesh=glb.mesh("Lemon", glb.geometry(lemon), yellow),
             translation=[0.19, 0.035, 0.02], rotation=axis_angle(unit((1, 0.25, -0.5)), 82))


def rounded_pane(width, height, corner):
    """A flat pane that stands on y = 0 and faces +z, as a fan about its middle."""
    shape = Shape()
    middle = shape.add((0, height / 2, 0), (0, 0, 1))
    rim = []
    for quarter in range(4):
        x = (width / 2 - corner) * (1, -1, -1, 1)[quarter]
        y = height / 2 + (height / 2 - corner) * (1, 1, -1, -1)[quarter]
        for step in range(9):
            angle = TAU * (quarter + step / 8) / 4
            rim.append(shape.add((x + corner * math.cos(angle), y + corner * math.sin(angle), 0),
                                 (0, 0, 1)))
    for k, vertex in enumerate(rim):
        shape.triangles.append((middle, vertex, rim[(k + 1) % len(rim)]))
    return shape


def add_panes(glb):
    """Five panes in a slotted block, each a little to the side of the one before it."""
    stand = glb.node("Panes", translation=[-0.56, 0, -0.30], rotation=axis_angle((0, 1, 0), 24))
    block = Shape()
    block.box((-0.26, 0.0, -0.20), (0.26, 0.035, 0.20))
    oak = glb.material("Oak", (0.56, 0.42, 0.27, 1))
    glb.node("Stand", stand, mesh=glb.mesh("Stand", glb.geometry(block), oak))
    pane = glb.geometry(rounded_pane(0.34, 0.66, 0.045))
    tints = [("Yellow", (0.95, 0.68, 0.03, 0.46)), ("Orange", (0.92, 0.26, 0.03, 0.46)),
             ("Magenta", (0.74, 0.04, 0.30, 0.46)), ("Blue", (0.06, 0.12, 0.66, 0.46)),
             ("Cyan", (0.02, 0.48, 0.66, 0.46))]
    for k, (name, color) in enumerate(tints):
        acrylic = glb.material(name + " acrylic", color, alphaMode="BLEND", doubleSided=True)
        glb.node(name + " pane", stand, mesh=glb.mesh(name + " pane", pane, acrylic),
                 translation=[round(0.04 * (k - 2), 3), 0.03, round(0.16 - 0.08 * k, 3)],
                 scale=[1, round(1 + 0.06 * k, 2), 1])


LATTICE_CELLS = 28  # along one edge of a tile; the file grows with its square


def strip_at(distance, half_width):
    """How far inside a strip of the lattice a point is, in half widths: 1 at its middle."""
    return 1 - abs(distance) / half_width


def lattice_vertex(u, v):
    """Bamboo strips on the diagonals of a tile and a ring round its middle. The alpha is 0.5 on
    their edges and linear across them, so that the cutoff's contour is smooth."""
    half = 0.052
    strips = []
    for distance, across in (((u - v) / math.sqrt(2), (1, -1)),
                             ((u + v - 1) / math.sqrt(2), (1, 1))):
        strips.append((strip_at(distance, half), distance, across))
    for edge in (0.0, 1.0):
        strips.append((strip_at(u - edge, 0.6 * half), u - edge, (1, 0)))
        strips.append((strip_at(v - edge, 0.6 * half), v - edge, (0, 1)))
    radius = math.hypot(u - 0.5, v - 0.5)
    outward = ((u - 0.5) / radius, (v - 0.5) / radius) if radius > 0 else (0, 0)
    strips.append((strip_at(radius - 0.27, half), radius - 0.27, outward))
    inside, distance, across = max(strips)
    # Turned sideways across a strip, the normals make it look round.
    tilt = 0.7 * max(-1.0, min(1.0, distance / half)) / (math.hypot(*across) or 1.0)
    color = mix((0.30, 0.18, 0.075), (0.58, 0.40, 0.20), smooth(inside))
    alpha = 0.5 + 0.5 * max(-1.0, min(1.0, inside))
    return (tilt * across[0], tilt * across[1], 1.0), (*color, alpha)


def lattice_tile(size):
    shape = Shape()
    n = LATTICE_CELLS
    for j in range(n + 1):
        for i in range(n + 1):
            normal, color = lattice_vertex(i / n, j / n)
            shape.add((size * i / n, size * j / n, 0.0), normal, color)
    for j in range(n):
        for i in range(n):
            a, b = j * (n + 1) + i, (j + 1) * (n + 1) + i
            # Diagonals that run along the strips keep their edges straight.
            if (i < n / 2) == (j < n / 2):
                shape.quad(a, a + 1, b + 1, b)
            else:
                shape.quad(a + 1, b + 1, b, a)
    return shape


def add_screen(glb):
    """Three leaves, hinged: each leaf is a child of the one before it."""
    tile, columns, rows, bar = 0.16, 3, 6, 0.020
    width, height, foot = tile * columns, tile * rows, 0.06
    frame = Shape()
    for x in (-bar, width):
        frame.box((x, 0.0, -bar / 2), (x + bar, foot + height + bar, bar / 2))
    for y in (foot - bar, foot + height):
        frame.box((0.0, y, -bar / 2), (width, y + bar, bar / 2))
    ebony = glb.material("Ebony", (0.13, 0.085, 0.065, 1))
    bamboo = glb.material("Bamboo", alphaMode="MASK", alphaCutoff=0.5, doubleSided=True)
    frame_mesh = glb.mesh("Screen frame", glb.geometry(frame), ebony)
    tile_mesh = glb.mesh("Lattice", glb.geometry(lattice_tile(tile)), bamboo)
    parent, at, turn = None, [-0.62, 0, -0.70], 14
    for leaf in range(3):
        node = glb.node("Leaf %d" % (leaf + 1), parent, translation=at, mesh=frame_mesh,
                        rotation=axis_angle((0, 1, 0), turn))
        for k in range(columns * rows):
            glb.node("Lattice %d.%d" % (leaf + 1, k + 1), node, mesh=tile_mesh,
                     translation=[round(tile * (k % columns), 3),
                                  round(foot + tile * (k // columns), 3), 0])
        parent, at, turn = node, [width + 2 * bar, 0, 0], (-34, 44)[leaf % 2]


def add_camera(glb, eye, target):
    z = unit([e - t for e, t in zip(eye, target)])
    x = unit((z[2], 0.0, -z[0]))
    y = (z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0])
    camera = glb.append("cameras", {"name": "Guest", "type": "perspective", "perspective": {
        "yfov": 0.55, "aspectRatio": 1.5, "znear": 0.05}})
    glb.node("Guest", camera=camera,
             matrix=[round(c, 7) for c in (*x, 0, *y, 0, *z, 0, *eye, 1)])


def main():
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "tea_table.glb")
    glb = Glb()
    add_floor(glb)
    tray = add_table(glb)
    add_sweets(glb, tray)
    add_screen(glb)
    add_panes(glb)
    add_glasses(glb, tray)
    add_camera(glb, (0.39, 1.00, 1.86), (-0.08, 0.43, -0.10))
    glb.write(sys.argv[1] if len(sys.argv) > 1 else beside)


if __name__ == "__main__":
    main()
