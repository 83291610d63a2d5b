# SPDX-License-Identifier: MIT
"""A texture sampler in Python's standard library, with one fault or none: texture_mutant.py FAULT

Coverage is the example rasterizer's; everything that has to do with textures is done here: the
quad's differences, the scale factor, levels, filters, wrap modes and mip chains. Numbers are
fractions but for the logarithm, which is decided exactly where it is a multiple of 1/2.

FAULT is `none`, `x-only` (the scale factor of the vector along x alone), `half-bias`, `most-bias` and
`more-bias` (half a level more, 1/20 and 1/8 beyond that), `ties` (half a level more where the level lies halfway between two: the second image alone),
`floor-3` or `nearest-3` (weights between levels in eighths), `repeat` (for mirrored repetition),
`short-chain` (generated levels end one too early), `black-levels` (they are black) or `one-is-zero`
(a coordinate of exactly 1 is taken as 0). No faults are `floor-6` and `nearest-6` (weights of 6
bits), `length-of-both` (the scale factor of both vectors together) and `short-logarithm` (1/70 of a
level too small); `floor-5` and `shorter-logarithm` (1/20) are contested.
"""
import io
import json
import math
import os
import pathlib
import struct
import sys
from fractions import Fraction

ROOT = pathlib.Path(os.environ.get("EDGECASE_ROOT", pathlib.Path(__file__).parents[2]))
sys.path.insert(0, str(ROOT / "reference" / "examples"))
requests, sys.stdin = sys.stdin, io.StringIO()  # the example answers what it finds when it starts
import rasterizer  # noqa: E402

HALF = Fraction(1, 2)


def twice_area(a, b, c):
    return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])


def coordinates_at(primitive, x, y):
    """s and t at a pixel's centre, which may lie outside the triangle."""
    corners, values = primitive
    p = (x + HALF, y + HALF)
    a, b, c = corners
    whole = twice_area(a, b, c)
    weights = [twice_area(*pair, p) / whole / corner[3]
               for pair, corner in zip(((b, c), (c, a), (a, b)), corners)]
    return [sum(w * v[i] for w, v in zip(weights, values)) / sum(weights) for i in (0, 1)]


def primitives_of(scene):
    """Draw, and corners with their s and t, of each triangle in drawing order."""
    for draw in scene["draws"]:
        for numbers in rasterizer.primitives(draw["primitive"], len(draw["vertices"])):
            vertices = [draw["vertices"][n] for n in numbers]
            told = vertices[-1:] * 3 if draw["interpolation"] == "flat" else vertices
            yield draw, ([rasterizer.window(v, scene["viewport"]) for v in vertices],
                         [[Fraction(n) for n in v["texture_coordinates"]] for v in told])


def float32(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def halved(level, rgba8):
    """The mean of two by two texels; an odd size's last is left out."""
    width, height = (max(level[side] // 2, 1) for side in ("width", "height"))
    step = [1 if level["width"] == 1 else 2, 1 if level["height"] == 1 else 2]
    texels = []
    for j in range(height):
        for i in range(width):
            of = [4 * ((step[1] * j + v) * level["width"] + step[0] * i + u)
                  for v in range(step[1]) for u in range(step[0])]
            for c in range(4):
                mean = sum(Fraction(level["texels"][at + c]) for at in of) / len(of)
                texels.append(round(mean) if rgba8 else float32(mean))
    return {"width": width, "height": height, "texels": texels}


def spelt_out(level):
    """A level with all of its texels, where they are all alike, too."""
    if "texels" in level:
        return level
    size = {side: level[side] for side in ("width", "height")}
    return {**size, "texels": level["texel"] * (level["width"] * level["height"])}


def chain_of(texture, fault):
    levels = [spelt_out(level) for level in texture["levels"]]
    if texture["generated"]:
        while levels[-1]["width"] > 1 or levels[-1]["height"] > 1:
            levels.append(halved(levels[-1], texture["format"] == "rgba8"))
        if fault == "short-chain":
            levels.pop()
        if fault == "black-levels":
            for level in levels[1:]:
                level["texels"] = [0, 0, 0, 1 if texture["format"] == "rgba32f" else 255] * (
                    level["width"] * level["height"])
    return levels


def logarithm(squared):
    """Half of log2, exactly where it is whole."""
    if squared == 0:
        return -math.inf
    number = math.log2(squared)
    whole = round(number)
    exact = Fraction(2) ** whole == squared
    return Fraction(whole, 2) if exact else number / 2


def level_of_detail(primitive, x, y, size, fault):
    """log2 of the longer vector by which the pixel spans the base level, of the quad's differences
    in the pixel's own row and column."""
    left, bottom = x - x % 2, y - y % 2

    def squared(first, second):
        return sum(((b - a) * n) ** 2 for a, b, n in zip(coordinates_at(primitive, *first),
                                                         coordinates_at(primitive, *second), size))
    along_x = squared((left, y), (left + 1, y))
    along_y = squared((x, bottom), (x, bottom + 1))
    if fault == "length-of-both":
        return logarithm(along_x + along_y)
    level = logarithm(along_x if fault == "x-only" else max(along_x, along_y))
    return level - {"short-logarithm": 1 / 70, "shorter-logarithm": 1 / 20}.get(fault, 0)


def weight_of(fraction, fault):
    if fault == "ties" and fraction == HALF:
        return 1
    kind, _, bits = fault.partition("-")
    if kind in ("floor", "nearest"):
        steps = 2 ** int(bits)
        return math.floor(fraction * steps + (0.5 if kind == "nearest" else 0)) / steps
    return fraction


def wrapped(index, size, mode, fault):
    if mode == "mirrored-repeat" and fault == "repeat":
        mode = "repeat"
    return rasterizer.WRAPS[mode](index, size)


class Lookup:
    """The lookups of one draw."""

    def __init__(self, scene, draw, fault):
        self.use, self.fault = draw["texture"], fault
        self.texture = scene["textures"][self.use["texture"]]
        self.levels = chain_of(self.texture, fault)
        base = self.levels[self.use["base_level"]]
        self.size = (base["width"], base["height"])
        self.last = min(len(self.levels) - 1, self.use["max_level"])

    def texel(self, level, i, j):
        sizes = (level["width"], level["height"])
        i, j = (wrapped(n, size, mode, self.fault)
                for n, size, mode in zip((i, j), sizes, self.use["wrap"]))
        most = 255 if self.texture["format"] == "rgba8" else 1
        if i is None or j is None:
            return [Fraction(n) for n in self.use["border"]]
        start = 4 * (j * sizes[0] + i)
        return [Fraction(n) / most for n in level["texels"][start:start + 4]]

    def filtered(self, number, kind, point):
        level = self.levels[number]
        if self.fault == "one-is-zero":
            point = [0 if n == 1 else n for n in point]
        u, v = point[0] * level["width"], point[1] * level["height"]
        if kind == "nearest":
            return self.texel(level, math.floor(u), math.floor(v))
        i, j = math.floor(u - HALF), math.floor(v - HALF)
        a, b = u - HALF - i, v - HALF - j
        corners = [((1 - a) * (1 - b), i, j), (a * (1 - b), i + 1, j),
                   ((1 - a) * b, i, j + 1), (a * b, i + 1, j + 1)]
        colors = [(weight, self.texel(level, *at)) for weight, *at in corners]
        return [sum(weight * color[c] for weight, color in colors) for c in range(4)]

    def answer(self, primitive, x, y):
        """Coordinates, the level accessed and lambda' before clamping, and the colour."""
        use, fault = self.use, self.fault
        point = coordinates_at(primitive, x, y)
        prime = level_of_detail(primitive, x, y, self.size, fault) + Fraction(use["lod_bias"])
        prime += {"half-bias": HALF, "most-bias": HALF + Fraction(1, 20),
                  "more-bias": HALF + Fraction(1, 8)}.get(fault, 0)
        level = min(max(prime, use["min_lod"]), use["max_lod"])
        most = self.last - use["base_level"]
        within = min(max(level, 0), most)
        below = math.floor(within)
        accessed = {"none": 0, "nearest": min(math.ceil(within + HALF) - 1, most) if within else 0,
                    "linear": below + weight_of(within - below, fault)}[use["mipmap"]]
        if level <= 0:
            return point, accessed, prime, self.filtered(use["base_level"], use["magnify"], point)
        first = use["base_level"] + (below if use["mipmap"] == "linear" else accessed)
        color = self.filtered(first, use["minify"], point)
        if use["mipmap"] == "linear" and first < self.last:
            second = self.filtered(first + 1, use["minify"], point)
            weight = Fraction(weight_of(within - below, fault))
            color = [(1 - weight) * a + weight * b for a, b in zip(color, second)]
        return point, accessed, prime, color


def number(value):
    return {math.inf: "inf", -math.inf: "-inf"}.get(value, float(value))


def refusal(scene):
    """Why the scene is not drawn, or none."""
    for draw in scene["draws"]:
        use = draw.get("texture")
        if not use or not draw["primitive"].startswith("triangle"):
            return "this program draws textured triangles"
        if use["lookup"]["kind"] != "implicit" or use["max_anisotropy"] > 1:
            return "this program has no such lookup"
        if scene["textures"][use["texture"]]["dimensions"] != 2:
            return "this program has textures of two dimensions"
    many = scene["target"]["samples"] > 1 or "supersampling" in scene["target"]
    return "this program draws one sample" if many else None


def answer(scene, fault):
    reason = refusal(scene)
    if reason:
        return {"not_run": reason}
    plain = json.loads(json.dumps(scene))  # the example looks up nearest texels, and those go unused
    for draw in plain["draws"]:
        draw["texture"].update(magnify="nearest", minify="nearest", mipmap="none", base_level=0)
    reply = rasterizer.answer(plain)
    if "not_run" in reply:
        return reply
    triangles = list(primitives_of(scene))
    lookups = [Lookup(scene, draw, fault) for draw, _ in triangles]
    width = scene["target"]["width"]
    for f in reply["fragments"]:
        triangle = triangles[f["primitive"]][1]
        point, accessed, prime, color = lookups[f["primitive"]].answer(triangle, f["x"], f["y"])
        f["color"] = [float(n) for n in color]
        if "texture" in scene.get("details", []):
            f["texture_coordinates"] = [float(n) for n in point]
            f["level_of_detail"] = [number(accessed), number(prime)]
        at = 4 * (f["y"] * width + f["x"])
        reply["pixels"][at:at + 4] = [round(255 * min(max(n, 0), 1)) for n in color]
    chains = {str(n): chain_of(texture, fault) for n, texture in enumerate(scene["textures"])
              if texture["generated"]}
    return {**reply, "mip_chains": chains} if chains else reply


def main():
    (fault,) = sys.argv[1:]
    for request in map(json.loads, requests):
        reply = answer(request["scene"], fault)
        reply["digest"] = request["digest"]
        reply["renderer"] = {"device": fault, "subpixel_bits": 8}
        print(json.dumps(reply), flush=True)


main()
