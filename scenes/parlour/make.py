#!/usr/bin/env python3
"""Makes parlour.gltf, parlour.bin and its textures beside this file: a small furnished room, y upward, in metres.

Everything is computed here and nothing is random beyond a fixed hash, so that every run writes the same bytes. Only the
standard library is needed. The room shows what a glTF file may hold: textures of every kind, a normal map, cut-out and
blended surfaces, metal, a plane mirror, thin and solid glass, emissive surfaces and punctual lights, a camera.
"""

import json
import math
import struct
import zlib
from pathlib import Path

HERE = Path(__file__).resolve().parent


# -- Pictures ---------------------------------------------------------------------------------------------------------

def noise(x, y, seed):
    """A fixed number in [0, 1) for a lattice point."""
    h = (x * 374761393 + y * 668265263 + seed * 2147483647) & 0xFFFFFFFF
    h = ((h ^ (h >> 13)) * 1274126177) & 0xFFFFFFFF
    return ((h ^ (h >> 16)) & 0xFFFFFF) / 0x1000000


def smooth(x, y, seed, period):
    """Value noise that repeats after `period` lattice steps."""
    i, j = math.floor(x), math.floor(y)
    u, v = x - i, y - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    at = lambda a, b: noise((i + a) % period, (j + b) % period, seed)
    return (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v


def clouds(x, y, seed, period):
    """Four octaves of it, x and y in periods."""
    total = 0.0
    for k in range(4):
        p = period << k
        total += smooth(x * p, y * p, seed + k, p) / (2 << k)
    return total / 0.9375


def png(name, size, pixel, channels):
    """Writes a square PNG; `pixel` maps (u, v) in [0, 1) to values in [0, 1]."""
    rows = bytearray()
    for j in range(size):
        rows.append(0)
        for i in range(size):
            values = pixel((i + 0.5) / size, (j + 0.5) / size)
            rows.extend(min(255, max(0, round(v * 255))) for v in values[:channels])
    # Prediction from the left neighbour makes smooth pictures small.
    stride = size * channels
    packed = bytearray()
    for j in range(size):
        row = rows[j * (stride + 1) + 1:(j + 1) * (stride + 1)]
        packed.append(1)
        packed.extend((row[k] - (row[k - channels] if k >= channels else 0)) & 255 for k in range(stride))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", size, size, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes(packed), 9)) + chunk(b"IEND", b"")
    (HERE / name).write_bytes(data)


def mix(a, b, t):
    return tuple(p * (1 - t) + q * t for p, q in zip(a, b))


def planks(u, v):
    """Oak boards: eight across, staggered joints, grain along u. Also their height, for roughness."""
    board = int(v * 8)
    shift = noise(board, 7, 3)
    along = (u + shift) % 1.0
    piece = int(along * 2)
    tone = noise(board, piece, 11)
    grain = clouds(along, v * 4 % 1.0, 20 + board * 2 + piece, 4)
    fine = smooth(along * 8, v * 256, 5, 256)
    gap = abs(v * 8 - board - 0.5) > 0.485 or abs((along * 2) % 1.0 - 0.5) > 0.497
    return tone, 0.6 * grain + 0.4 * fine, gap


def oak(u, v):
    tone, grain, gap = planks(u, v)
    color = mix((0.56, 0.37, 0.21), (0.74, 0.54, 0.33), 0.6 * tone + 0.4 * grain)
    return mix(color, (0.16, 0.10, 0.06), 0.8) if gap else color


def oak_roughness(u, v):
    _, grain, gap = planks(u, v)
    return (1.0, 0.9 if gap else 0.34 + 0.16 * grain, 0.0)


def wallpaper(u, v):
    """Broad stripes with a small flower in every second one."""
    stripe = math.sin(2 * math.pi * 4 * u)
    ground = mix((0.80, 0.76, 0.66), (0.72, 0.70, 0.62), 1 / (1 + math.exp(-24 * stripe)))
    x, y = (u * 4 + 0.25) % 1.0 - 0.5, (v * 4 + 0.5 * (int(u * 4 + 0.25) % 2)) % 1.0 - 0.5
    r, angle = math.hypot(x, y), math.atan2(y, x)
    petal = 0.11 * (0.72 + 0.28 * math.cos(5 * angle))
    if r < 0.035:
        return (0.74, 0.58, 0.25)
    if r < petal:
        return (0.52, 0.56, 0.60)
    return mix(ground, (0.6, 0.58, 0.5), 0.12 * clouds(u, v, 40, 8))


def plaster_height(u, v):
    return clouds(u, v, 60, 8) + 0.35 * clouds(u * 4 % 1.0, v * 4 % 1.0, 70, 8)


def normal_map(height, strength):
    def pixel(u, v):
        e = 1 / 256
        dx = (height((u + e) % 1.0, v) - height((u - e) % 1.0, v)) * strength
        dy = (height(u, (v + e) % 1.0) - height(u, (v - e) % 1.0)) * strength
        n = math.sqrt(dx * dx + dy * dy + 1)
        return (0.5 - 0.5 * dx / n, 0.5 + 0.5 * dy / n, 0.5 + 0.5 / n)
    return pixel


def rug(u, v):
    """A woven rug with a fringe that the alpha channel cuts out."""
    x, y = u - 0.5, v - 0.5
    if abs(x) > 0.46:
        thread = (v * 64) % 1.0 < 0.45 + 0.3 * noise(int(v * 64), int(x > 0), 9)
        return (0.86, 0.80, 0.68, 1.0 if thread else 0.0)
    weave = 0.92 + 0.08 * math.cos(2 * math.pi * 64 * u) * math.cos(2 * math.pi * 64 * v)
    d = abs(x) / 0.46 * 0.9 + abs(y) / 0.5 * 0.9
    border = max(abs(x) / 0.46, abs(y) / 0.5)
    if border > 0.9:
        color = (0.32, 0.07, 0.07)
    elif border > 0.84:
        color = (0.82, 0.70, 0.45)
    elif abs(d - 0.75) < 0.06 or d < 0.14:
        color = (0.82, 0.70, 0.45)
    elif d < 0.75:
        color = (0.16, 0.22, 0.38)
    else:
        color = (0.52, 0.12, 0.11)
    return tuple(c * weave for c in color) + (1.0,)


def painting(u, v):
    """Hills under an evening sky."""
    sky = mix((0.30, 0.42, 0.62), (0.95, 0.70, 0.42), min(1.0, v * 1.6))
    sun = math.hypot((u - 0.68) * 1.3, v - 0.42)
    color = mix((1.0, 0.93, 0.75), sky, min(1.0, sun / 0.16)) if sun < 0.16 else sky
    for k, hill in enumerate([(0.22, 0.30, 0.40), (0.20, 0.30, 0.24), (0.12, 0.18, 0.10)]):
        ridge = 0.5 + 0.14 * k + 0.10 * math.sin(2 * math.pi * (u * (1.2 + 0.5 * k) + 0.3 * k)) \
            + 0.05 * clouds(u, 0.3 * k, 90 + k, 4)
        if v > ridge:
            color = mix(hill, color, 0.12 * clouds(u, v, 95 + k, 16))
    return tuple(c * (0.9 + 0.2 * clouds(u, v, 99, 32)) for c in color)


def leaf(u, v):
    """One leaf, its outline in alpha."""
    x = (u - 0.5) * 2
    width = 0.85 * math.sin(math.pi * min(1.0, max(0.0, v))) ** 0.8 * (1 - 0.35 * v)
    inside = abs(x) < width
    vein = abs(x) < 0.03 or abs(((abs(x) * 0.8 + v) * 9) % 1.0 - 0.5) < 0.07
    green = mix((0.10, 0.24, 0.06), (0.30, 0.46, 0.14), clouds(u, v, 33, 8))
    return (mix(green, (0.45, 0.58, 0.28), 0.6) if vein else green) + (1.0 if inside else 0.0,)


def glow(u, v):
    """The shade of the standing lamp: pleats that let more or less light through."""
    pleat = 0.75 + 0.25 * math.cos(2 * math.pi * 24 * u)
    level = pleat * (0.55 + 0.45 * math.exp(-((v - 0.55) / 0.3) ** 2))
    return (level, level * 0.80, level * 0.52)


# -- Geometry ---------------------------------------------------------------------------------------------------------

class Shape:
    """Vertices with normal and texture coordinates, and triangles."""

    def __init__(self):
        self.vertices, self.triangles = [], []

    def vertex(self, p, n, uv):
        self.vertices.append((*p, *n, *uv))
        return len(self.vertices) - 1

    def quad(self, origin, a, b, uv=(1.0, 1.0), at=(0.0, 0.0)):
        """The parallelogram origin + s·a + t·b, seen from the side of a × b; (s, 1 − t) is the texture's place."""
        n = cross(a, b)
        length = math.sqrt(dot(n, n))
        n = tuple(c / length for c in n)
        first = len(self.vertices)
        for s, t in [(0, 0), (1, 0), (1, 1), (0, 1)]:
            p = tuple(o + s * x + t * y for o, x, y in zip(origin, a, b))
            self.vertex(p, n, (at[0] + s * uv[0], at[1] + (1 - t) * uv[1]))
        self.triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
        return self

    def box(self, lo, hi, scale=1.0):
        """A box whose texture repeats every 1/scale metres."""
        (x0, y0, z0), (x1, y1, z1) = lo, hi
        dx, dy, dz = x1 - x0, y1 - y0, z1 - z0
        faces = [
            ((x0, y0, z1), (dx, 0, 0), (0, dy, 0)), ((x1, y0, z0), (-dx, 0, 0), (0, dy, 0)),
            ((x1, y0, z1), (0, 0, -dz), (0, dy, 0)), ((x0, y0, z0), (0, 0, dz), (0, dy, 0)),
            ((x0, y1, z1), (dx, 0, 0), (0, 0, -dz)), ((x0, y0, z0), (dx, 0, 0), (0, 0, dz)),
        ]
        for origin, a, b in faces:
            size = [math.sqrt(dot(e, e)) * scale for e in (a, b)]
            self.quad(origin, a, b, size)
        return self

    def turned(self, profile, center, steps, closed_texture=1.0):
        """A surface of revolution about a vertical axis: `profile` lists (radius, height) from below to above."""
        x0, y0, z0 = center
        lengths = [0.0]
        for (r0, h0), (r1, h1) in zip(profile, profile[1:]):
            lengths.append(lengths[-1] + math.hypot(r1 - r0, h1 - h0))
        columns = []
        for k in range(steps + 1):
            angle = 2 * math.pi * k / steps
            c, s = math.cos(angle), math.sin(angle)
            column = []
            for i, (r, h) in enumerate(profile):
                before, after = profile[max(i - 1, 0)], profile[min(i + 1, len(profile) - 1)]
                dr, dh = after[0] - before[0], after[1] - before[1]
                length = math.hypot(dr, dh) or 1.0
                n = (dh / length * c, -dr / length, dh / length * s)
                uv = (closed_texture * k / steps, 1 - lengths[i] / lengths[-1])
                column.append(self.vertex((x0 + r * c, y0 + h, z0 + r * s), n, uv))
            columns.append(column)
        for left, right in zip(columns, columns[1:]):
            for i in range(len(profile) - 1):
                if profile[i][0] > 0:
                    self.triangles.append((left[i], left[i + 1], right[i]))
                if profile[i + 1][0] > 0:
                    self.triangles.append((left[i + 1], right[i + 1], right[i]))
        return self


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def ball(radius, steps, low=-90, high=90):
    """Profile of a sphere between two latitudes."""
    angles = [math.radians(low + (high - low) * k / steps) for k in range(steps + 1)]
    return [(max(0.0, radius * math.cos(a)) if abs(math.degrees(a)) < 89.99 else 0.0, radius * math.sin(a)) for a in angles]


# -- The file ---------------------------------------------------------------------------------------------------------

class File:
    def __init__(self):
        self.data = bytearray()
        self.gltf = {
            "asset": {"version": "2.0", "generator": "scenes/parlour/make.py"},
            "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior",
                               "KHR_materials_specular", "KHR_materials_transmission", "KHR_materials_volume",
                               "KHR_texture_transform"],
            "scene": 0, "scenes": [{"name": "parlour", "nodes": []}],
            "nodes": [], "meshes": [], "materials": [], "cameras": [],
            "images": [], "samplers": [{}], "textures": [],
            "accessors": [], "bufferViews": [], "extensions": {"KHR_lights_punctual": {"lights": []}},
        }
        self.named = {}

    def view(self, data, target):
        self.data.extend(b"\0" * (-len(self.data) % 4))
        self.gltf["bufferViews"].append(
            {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data), "target": target})
        self.data.extend(data)
        return len(self.gltf["bufferViews"]) - 1

    def accessor(self, data, target, kind, component, count, **more):
        self.gltf["accessors"].append({"bufferView": self.view(data, target), "componentType": component,
                                       "count": count, "type": kind, **more})
        return len(self.gltf["accessors"]) - 1

    def texture(self, uri, **transform):
        if uri not in self.named:
            self.gltf["images"].append({"name": uri, "uri": uri})
            self.gltf["textures"].append({"source": len(self.gltf["images"]) - 1, "sampler": 0})
            self.named[uri] = len(self.gltf["textures"]) - 1
        info = {"index": self.named[uri]}
        if transform:
            info["extensions"] = {"KHR_texture_transform": transform}
        return info

    def material(self, name, color=(1, 1, 1), metallic=0.0, roughness=0.9, base=None, mr=None, **more):
        pbr = {"baseColorFactor": [*color, 1.0] if len(color) == 3 else list(color),
               "metallicFactor": metallic, "roughnessFactor": roughness}
        if base:
            pbr["baseColorTexture"] = base
        if mr:
            pbr["metallicRoughnessTexture"] = mr
        self.gltf["materials"].append({"name": name, "pbrMetallicRoughness": pbr, **more})
        return len(self.gltf["materials"]) - 1

    def mesh(self, name, *parts):
        primitives = []
        for shape, material in parts:
            v = shape.vertices
            floats = lambda lo, hi: b"".join(struct.pack(f"<{hi - lo}f", *p[lo:hi]) for p in v)
            low = [min(p[k] for p in v) for k in range(3)]
            high = [max(p[k] for p in v) for k in range(3)]
            f32 = lambda x: struct.unpack("<f", struct.pack("<f", x))[0]
            indices = b"".join(struct.pack("<3H", *t) for t in shape.triangles)
            primitives.append({
                "attributes": {
                    "POSITION": self.accessor(floats(0, 3), 34962, "VEC3", 5126, len(v),
                                              min=[f32(x) for x in low], max=[f32(x) for x in high]),
                    "NORMAL": self.accessor(floats(3, 6), 34962, "VEC3", 5126, len(v)),
                    "TEXCOORD_0": self.accessor(floats(6, 8), 34962, "VEC2", 5126, len(v)),
                },
                "indices": self.accessor(indices, 34963, "SCALAR", 5123, 3 * len(shape.triangles)),
                "material": material,
            })
        self.gltf["meshes"].append({"name": name, "primitives": primitives})
        return len(self.gltf["meshes"]) - 1

    def node(self, name, **what):
        self.gltf["nodes"].append({"name": name, **what})
        self.gltf["scenes"][0]["nodes"].append(len(self.gltf["nodes"]) - 1)

    def place(self, name, *parts, **where):
        self.node(name, mesh=self.mesh(name, *parts), **where)

    def light(self, name, translation, rotation=None, **light):
        lights = self.gltf["extensions"]["KHR_lights_punctual"]["lights"]
        lights.append({"name": name, **light})
        where = {"translation": translation} | ({"rotation": rotation} if rotation else {})
        self.node(name, extensions={"KHR_lights_punctual": {"light": len(lights) - 1}}, **where)

    def write(self):
        self.gltf["buffers"] = [{"uri": "parlour.bin", "byteLength": len(self.data)}]
        (HERE / "parlour.bin").write_bytes(self.data)
        rounded = json.loads(json.dumps(self.gltf), parse_float=lambda t: float(f"{float(t):.9g}"))
        (HERE / "parlour.gltf").write_text(json.dumps(rounded, separators=(",", ":")) + "\n")


def looking(eye, target):
    """The rotation that turns −z toward a target, y kept upward."""
    f = [t - e for e, t in zip(eye, target)]
    length = math.sqrt(dot(f, f))
    z = [-c / length for c in f]
    x = cross((0, 1, 0), z)
    length = math.sqrt(dot(x, x))
    x = [c / length for c in x]
    y = cross(z, x)
    m = [[x[0], y[0], z[0]], [x[1], y[1], z[1]], [x[2], y[2], z[2]]]
    w = math.sqrt(max(0.0, 1 + m[0][0] + m[1][1] + m[2][2])) / 2
    return [(m[2][1] - m[1][2]) / (4 * w), (m[0][2] - m[2][0]) / (4 * w), (m[1][0] - m[0][1]) / (4 * w), w]


def room():
    f = File()
    glass = {"KHR_materials_transmission": {"transmissionFactor": 1.0}, "KHR_materials_ior": {"ior": 1.5}}
    matt = {"extensions": {"KHR_materials_specular": {"specularFactor": 0.0}}}
    floor = f.material("oak floor", base=f.texture("oak.png", scale=[0.5, 0.5]), roughness=1.0,
                       mr=f.texture("oak_roughness.png", scale=[0.5, 0.5]))
    paper = f.material("wallpaper", base=f.texture("wallpaper.png"), **matt)
    plaster = f.material("plaster", (0.83, 0.82, 0.79), normalTexture={**f.texture("plaster_normal.png"), "scale": 0.7}, **matt)
    white = f.material("white paint", (0.82, 0.81, 0.78), roughness=0.5)
    walnut = f.material("walnut", (0.45, 0.33, 0.26), base=f.texture("oak.png"), roughness=0.45)
    rug_cloth = f.material("rug", base=f.texture("rug.png"), alphaMode="MASK", alphaCutoff=0.5, doubleSided=True, **matt)
    canvas = f.material("painting", base=f.texture("painting.png"), roughness=0.6)
    brass = f.material("brass", (0.89, 0.68, 0.33), metallic=1.0, roughness=0.32)
    silver = f.material("mirror", (0.93, 0.93, 0.93), metallic=1.0, roughness=0.0)
    sofa_cloth = f.material("sofa cloth", (0.12, 0.24, 0.27), **matt)
    cushion = f.material("cushion", (0.75, 0.45, 0.12), **matt)
    ceramic = f.material("ceramic", (0.55, 0.12, 0.07), roughness=0.15)
    leaves = f.material("leaves", base=f.texture("leaf.png"), alphaMode="MASK", alphaCutoff=0.5, doubleSided=True, roughness=0.55)
    curtain = f.material("curtain", (0.88, 0.86, 0.80, 0.7), alphaMode="BLEND", doubleSided=True, **matt)
    pane = f.material("thin glass", roughness=0.0, doubleSided=True, extensions=glass)
    table_glass = f.material("table glass", (1, 1, 1), roughness=0.0, extensions={
        **glass, "KHR_materials_volume": {"thicknessFactor": 0.012, "attenuationColor": [0.55, 0.85, 0.72], "attenuationDistance": 0.25}})
    shade = f.material("lamp shade", (0.7, 0.62, 0.5), emissiveFactor=[1, 1, 1], emissiveTexture=f.texture("glow.png"),
                       extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 900.0},
                                   "KHR_materials_specular": {"specularFactor": 0.0}})
    daylight = f.material("daylight", (0, 0, 0), emissiveFactor=[0.80, 0.92, 1.0],
                          extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 1800.0}})

    w, h, d = 5.0, 2.7, 4.0
    shell = Shape().quad((0, 0, d), (w, 0, 0), (0, 0, -d), (w, d))
    f.place("floor", (shell, floor))
    f.place("ceiling", (Shape().quad((0, h, 0), (w, 0, 0), (0, 0, d), (w, d)), plaster))
    # Back wall (z = 0), papered; right wall (x = w) plastered; left wall holds the window; front wall behind the camera.
    f.place("back wall", (Shape().quad((0, 0, 0), (w, 0, 0), (0, h, 0), (w, h)), paper))
    f.place("right wall", (Shape().quad((w, 0, 0), (0, 0, d), (0, h, 0), (d, h)), plaster))
    f.place("front wall", (Shape().quad((w, 0, d), (-w, 0, 0), (0, h, 0), (w, h)), plaster))
    z0, z1, y0, y1 = 0.9, 2.5, 0.85, 2.25
    left = Shape()
    left.quad((0, 0, d), (0, 0, z1 - d), (0, h, 0), (d - z1, h))
    left.quad((0, 0, z0), (0, 0, -z0), (0, h, 0), (z0, h))
    left.quad((0, 0, z1), (0, 0, z0 - z1), (0, y0, 0), (z1 - z0, y0))
    left.quad((0, y1, z1), (0, 0, z0 - z1), (0, h - y1, 0), (z1 - z0, h - y1))
    f.place("left wall", (left, plaster))
    frame = Shape()
    t, depth = 0.05, 0.16
    frame.box((-depth, y0 - t, z0 - t), (0.02, y0, z1 + t)).box((-depth, y1, z0 - t), (0.02, y1 + t, z1 + t))
    frame.box((-depth, y0, z0 - t), (0.02, y1, z0)).box((-depth, y0, z1), (0.02, y1, z1 + t))
    frame.box((-0.09, y0, (z0 + z1) / 2 - 0.025), (-0.05, y1, (z0 + z1) / 2 + 0.025))
    f.place("window frame", (frame, white))
    f.place("daylight", (Shape().quad((-0.155, y0, z1), (0, 0, z0 - z1), (0, y1 - y0, 0)), daylight))
    for k, (a, b) in enumerate([(z0 - 0.25, z0 + 0.22), (z1 - 0.22, z1 + 0.25)]):
        folds = Shape()
        steps = 24
        for i in range(steps):
            s0, s1 = i / steps, (i + 1) / steps
            bend = lambda s: 0.10 + 0.025 * math.sin(2 * math.pi * 5 * s)
            p0, p1 = (bend(s0), 0.25, a + (b - a) * s0), (bend(s1), 0.25, a + (b - a) * s1)
            folds.quad(p1, tuple(p - q for p, q in zip(p0, p1)), (0, 2.12, 0))
        f.place(f"curtain {k + 1}", (folds, curtain))
    rod = Shape().box((0.09, 2.37, z0 - 0.35), (0.11, 2.39, z1 + 0.35))
    skirting = Shape().box((0, 0, 0), (w, 0.09, 0.015)).box((w - 0.015, 0, 0.02), (w, 0.09, d))
    f.place("curtain rod", (rod, brass))
    f.place("skirting", (skirting, white))

    f.place("rug", (Shape().quad((1.35, 0.006, 2.95), (2.5, 0, 0), (0, 0, -1.7)), rug_cloth))
    sofa = Shape()
    sofa.box((1.5, 0.12, 0.15), (3.6, 0.42, 1.0)).box((1.5, 0.42, 0.15), (3.6, 0.86, 0.36))
    sofa.box((1.3, 0.12, 0.15), (1.5, 0.62, 1.0)).box((3.6, 0.12, 0.15), (3.8, 0.62, 1.0))
    seats = Shape().box((1.52, 0.42, 0.37), (2.54, 0.52, 0.99)).box((2.56, 0.42, 0.37), (3.58, 0.52, 0.99))
    feet = Shape()
    for x in (1.34, 3.7):
        for z in (0.2, 0.9):
            feet.box((x, 0, z), (x + 0.06, 0.12, z + 0.06))
    f.place("sofa", (sofa, sofa_cloth), (seats, sofa_cloth), (feet, walnut))
    f.place("cushion", (Shape().box((-0.2, 0, -0.06), (0.2, 0.38, 0.06)), cushion),
            translation=[3.2, 0.53, 0.52], rotation=[-0.17, 0.12, 0.0, math.sqrt(1 - 0.17 ** 2 - 0.12 ** 2)])

    plate = Shape().turned([(0.0, 0.0), (0.45, 0.0), (0.455, 0.006), (0.45, 0.012), (0.0, 0.012)], (2.55, 0.42, 1.95), 48)
    legs = Shape().turned([(0.0, 0.0), (0.2, 0.0), (0.2, 0.015), (0.03, 0.04), (0.025, 0.38), (0.12, 0.415), (0.0, 0.415)],
                          (2.55, 0.007, 1.95), 32)
    f.place("glass table", (plate, table_glass), (legs, brass))
    bowl = [(0.0, 0.0), (0.05, 0.0), (0.06, 0.01), (0.12, 0.05), (0.14, 0.09), (0.135, 0.09), (0.115, 0.055), (0.05, 0.018), (0.0, 0.015)]
    f.place("bowl", (Shape().turned(bowl, (2.42, 0.4325, 1.88), 32), ceramic))
    f.place("glass bell", (Shape().turned([(0.12, 0.0), (0.12, 0.16)] + [(0.12 * math.cos(math.radians(a)) if a < 90 else 0.0,
                                            0.16 + 0.12 * math.sin(math.radians(a))) for a in range(10, 91, 10)],
                                           (4.7, 0.8, 1.3), 32), pane))
    f.place("glass ball", (Shape().turned(ball(0.07, 24), (2.76, 0.503, 2.02), 48), table_glass))

    f.place("sideboard", (Shape().box((4.45, 0.1, 1.0), (4.97, 0.8, 2.7), 0.5), walnut),
            (Shape().box((4.44, 0.13, 1.84), (4.45, 0.77, 1.855)), brass))
    f.place("mirror", (Shape().quad((3.75, 1.15, 0.02), (0.65, 0, 0), (0, 1.0, 0)), silver))
    border = Shape()
    border.box((3.71, 1.11, 0.0), (4.44, 1.15, 0.04)).box((3.71, 2.15, 0.0), (4.44, 2.19, 0.04))
    border.box((3.71, 1.15, 0.0), (3.75, 2.15, 0.04)).box((4.4, 1.15, 0.0), (4.44, 2.15, 0.04))
    f.place("mirror frame", (border, brass))
    picture = Shape().quad((2.05, 1.25, 0.03), (1.0, 0, 0), (0, 0.75, 0))
    moulding = Shape().box((2.0, 1.2, 0.0), (3.1, 1.25, 0.045)).box((2.0, 2.0, 0.0), (3.1, 2.05, 0.045))
    moulding.box((2.0, 1.25, 0.0), (2.05, 2.0, 0.045)).box((3.05, 1.25, 0.0), (3.1, 2.0, 0.045))
    f.place("painting", (picture, canvas), (moulding, walnut))

    stand = Shape().turned([(0.0, 0.0), (0.16, 0.0), (0.16, 0.02), (0.02, 0.04), (0.012, 0.08), (0.012, 1.38), (0.0, 1.39)],
                           (0.75, 0, 0.55), 32)
    cone = Shape().turned([(0.27, 0.0), (0.17, 0.34)], (0.75, 1.32, 0.55), 48)
    f.place("standing lamp", (stand, brass), (cone, shade))
    pot = [(0.0, 0.0), (0.11, 0.0), (0.15, 0.26), (0.16, 0.28), (0.145, 0.28), (0.13, 0.25), (0.0, 0.24)]
    f.place("pot", (Shape().turned(pot, (4.3, 0, 0.6), 32), ceramic))
    plant = Shape()
    for k in range(22):
        angle, tilt, size = 2.4 * k, 0.35 + 0.9 * noise(k, 1, 50), 0.42 + 0.3 * noise(k, 2, 50)
        out = (math.cos(angle), 0.0, math.sin(angle))
        up = tuple(o * math.sin(tilt) for o in out)
        up = (up[0] * size, math.cos(tilt) * size, up[2] * size)
        side = (-out[2] * 0.13 * size / 0.5, 0.0, out[0] * 0.13 * size / 0.5)
        base = (4.3 + 0.03 * out[0] - side[0] / 2, 0.24 + 0.25 * noise(k, 3, 50), 0.6 + 0.03 * out[2] - side[2] / 2)
        plant.quad(base, side, up)
    f.place("plant", (plant, leaves))

    above = math.sqrt(0.5)
    f.light("picture light", [2.55, 2.6, 0.75], looking((2.55, 2.6, 0.75), (2.55, 1.6, 0.0)), type="spot", color=[1.0, 0.86, 0.66],
            intensity=160.0, spot={"innerConeAngle": 0.35, "outerConeAngle": 0.6})
    f.light("table light", [2.55, 2.65, 1.95], [-above, 0.0, 0.0, above], type="spot", color=[1.0, 0.9, 0.75], intensity=220.0,
            spot={"innerConeAngle": 0.3, "outerConeAngle": 0.75})
    f.gltf["cameras"].append({"name": "from the door", "type": "perspective", "perspective": {"yfov": 0.96, "znear": 0.01}})
    eye, target = (3.7, 1.5, 3.85), (2.35, 0.95, 0.6)
    f.node("from the door", camera=0, translation=list(eye), rotation=looking(eye, target))
    f.write()


if __name__ == "__main__":
    png("oak.png", 256, oak, 3)
    png("oak_roughness.png", 128, oak_roughness, 3)
    png("wallpaper.png", 256, wallpaper, 3)
    png("plaster_normal.png", 256, normal_map(plaster_height, 1.6), 3)
    png("rug.png", 256, rug, 4)
    png("painting.png", 192, painting, 3)
    png("leaf.png", 128, leaf, 4)
    png("glow.png", 128, glow, 3)
    room()
