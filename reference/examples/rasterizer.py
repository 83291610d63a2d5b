#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An exact rasterizer in Python's standard library: the rules of OpenGL 4.6 (core), word for word.

Try it:  edgecase run --against "exec:python3 reference/examples/rasterizer.py"

Numbers are fractions, so nothing is rounded before the answer is written. Where the specification
moves things by an infinitesimal e, a number is a tuple (a, b, c) that stands for a + b e + c e^2;
Python orders tuples by their first difference, which is just the order of such numbers.

It leaves out derivatives and levels of detail, which an answer may: OpenGL allows several, and no
exact one. So it draws only those textures of which no level has to be chosen.
"""
import json
import math
import struct
import sys
from fractions import Fraction

HALF = Fraction(1, 2)


def point(size):
    """14.4.1: the pixel's centre lies in the square of this size round the point. The square owns
    its right and top sides; OpenGL leaves that open."""
    def rule(a):
        return lambda x, y: ([1] if all(n - size / 2 < pixel + HALF <= n + size / 2
                                        for n, pixel in zip(a, (x, y))) else None)
    return rule


def line(a, b):
    """14.5.1, diamond exit: the segment meets the pixel's open diamond and does not end in it.

    Both ends are moved by -(e, e^2). The diamond is |dx| + |dy| < 1/2 round the centre: the four
    conditions sx dx + sy dy - 1/2 < 0, each of which changes linearly along the segment.
    """
    def covers(x, y):
        enter, leave, ends_inside = (0, -1, 0), (1, 1, 0), True  # beyond [0, 1] on both sides
        for sx, sy in (1, 1), (1, -1), (-1, 1), (-1, -1):
            at_a, at_b = (sx * (p[0] - x - HALF) + sy * (p[1] - y - HALF) - HALF for p in (a, b))
            ends_inside = ends_inside and (at_b, -sx, -sy) < (0, 0, 0)
            slope = at_b - at_a
            if slope == 0:
                if (at_a, -sx, -sy) >= (0, 0, 0):
                    return None
            else:  # the condition's border is crossed at this part of the way from a to b
                crossing = (-at_a / slope, sx / slope, sy / slope)
                enter, leave = ((enter, min(leave, crossing)) if slope > 0
                                else (max(enter, crossing), leave))
        if ends_inside or not (enter < leave and enter < (1, 0, 0) and leave > (0, 0, 0)):
            return None
        along = [q - p for p, q in zip(a[:2], b[:2])]
        t = (((x + HALF - a[0]) * along[0] + (y + HALF - a[1]) * along[1])
             / (along[0] ** 2 + along[1] ** 2))
        return [1 - t, t]
    return covers


def triangle(a, b, c):
    """14.6.1: the pixel's centre lies inside; one on an edge is moved by (e, -e^2), so that left
    edges and then top edges own it. OpenGL leaves that choice open."""
    def side(p, q, x, y):  # twice the area of p, q and the centre, positive to the left of p -> q
        dx, dy = q[0] - p[0], q[1] - p[1]
        return (dx * (y + HALF - p[1]) - dy * (x + HALF - p[0]), -dy, -dx)
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    def covers(x, y):
        sides = [[n if area > 0 else -n for n in side(p, q, x, y)]
                 for p, q in ((b, c), (c, a), (a, b))]
        if area == 0 or min(sides) <= [0, 0, 0]:
            return None
        return [s[0] / abs(area) for s in sides]
    return covers


def primitives(kind, n):
    """10.1: the primitives that n vertices make. Each is the numbers of its vertices, turned so
    that under the `first` convention the first one provokes, and under `last` the last one."""
    return {"points": [[i] for i in range(n)],
            "lines": [[i, i + 1] for i in range(0, n - 1, 2)],
            "line_strip": [[i, i + 1] for i in range(n - 1)],
            "line_loop": [[i, (i + 1) % n] for i in range(n)],
            "triangles": [[i, i + 1, i + 2] for i in range(0, n - 2, 3)],
            "triangle_strip": [[i, i + 1, i + 2] for i in range(n - 2)],  # winding plays no part
            "triangle_fan": [[i, 0, i + 1] for i in range(1, n - 1)]}[kind]


def window(vertex, viewport):
    """13.8.1: x, y and depth (-1 to 1) after the division by w, and w. Clip coordinates are taken
    rather than the position, which is only the nearest multiple of 2^-16 to their quotients."""
    if "clip" not in vertex:
        return [Fraction(n) for n in (*vertex["position"], vertex.get("w", 1))]
    x, y, z, w = map(Fraction, vertex["clip"])
    left, bottom, wide, high = viewport
    return [left + wide * (x / w + 1) / 2, bottom + high * (y / w + 1) / 2, z / w, w]


def perspective(weights, corners):
    """14.6.1: the weights of attributes that are linear in clip space, from those in the window.
    Returns 1/w of the fragment, too."""
    parts = [weight / corner[3] for weight, corner in zip(weights, corners)]
    return [part / sum(parts) for part in parts], sum(parts)


# 8.14.2: the texel i of n in a row that stands at a coordinate; none where the border does.
WRAPS = {"repeat": lambda i, n: i % n,
         "mirrored-repeat": lambda i, n: min(i % (2 * n), 2 * n - 1 - i % (2 * n)),
         "clamp-to-edge": lambda i, n: min(max(i, 0), n - 1),
         "clamp-to-border": lambda i, n: i if 0 <= i < n else None}


def nearest(texture, use, coordinates):
    """8.14.2: the colour of the texel that these coordinates lie in, a border's clamped where the
    format is fixed-point. A texture of one dimension has one row, wherever t is."""
    level, most = texture["levels"][use["base_level"]], {"rgba8": 255}.get(texture["format"])
    sizes = [level["width"], level["height"]]
    i, j = (WRAPS[wrap](math.floor(c * n), n)
            for wrap, c, n in zip(use["wrap"], coordinates, sizes))
    if texture["dimensions"] == 1:
        j = 0
    if i is None or j is None:
        return [min(max(Fraction(n), 0), 1) if most else Fraction(n) for n in use["border"]]
    start = 4 * (j * sizes[0] + i)
    texel = level.get("texel") or level["texels"][start:start + 4]
    return [Fraction(n) / (most or 1) for n in texel]


def stored(depth, kind):
    """What a depth buffer makes of a depth: a multiple of 1/(2^bits - 1), or a float32."""
    depth = min(max(depth, Fraction(0)), Fraction(1))
    if kind == "depth32f":
        return struct.unpack("f", struct.pack("f", depth))[0]
    most = 2 ** {"depth16": 16, "depth24": 24}[kind] - 1
    return round(depth * most) / most


def common(boxes):
    """The pixels that lie in all of these rectangles [x, y, width, height]."""
    left, bottom = (max(box[i] for box in boxes) for i in (0, 1))
    right, top = (min(box[i] + box[i + 2] for box in boxes) for i in (0, 1))
    return [(x, y) for y in range(bottom, top) for x in range(left, right)]


def render(scene):
    width, height = scene["target"]["width"], scene["target"]["height"]
    left, bottom, wide, high = viewport = scene["viewport"]
    target, kind = [0, 0, width, height], scene["target"].get("depth")
    pixels = [scene["target"]["clear"]] * (width * height)
    depths = [Fraction(1)] * (width * height)
    fragments, primitive = [], 0
    for draw in scene["draws"]:
        rules = {1: point(Fraction(draw["point_size"])), 2: line, 3: triangle}
        way, provoking = draw["interpolation"], draw["provoking_vertex"]
        for numbers in primitives(draw["primitive"], len(draw["vertices"])):
            vertices = [draw["vertices"][n] for n in numbers]
            corners = [window(v, viewport) for v in vertices]
            key = "texture_coordinates" if "texture" in draw else "color"
            colors = [[Fraction(n) for n in v[key]] for v in vertices]
            covers = rules[len(corners)](*corners)
            boxes = [target, draw.get("scissor", target)]
            # 13.7: lines and triangles are cut at the viewport. Of a point only the vertex is
            # clipped: its square may reach beyond.
            if len(corners) > 1:
                boxes.append(viewport)
            elif not (0 <= corners[0][0] - left <= wide and 0 <= corners[0][1] - bottom <= high):
                boxes.append([0, 0, 0, 0])
            for x, y in common(boxes):
                weights = covers(x, y)
                if weights is None:
                    continue
                mix = lambda parts, values: sum(w * v for w, v in zip(parts, values))
                in_clip_space, inverse_w = perspective(weights, corners)
                if way == "flat":
                    color = colors[0 if provoking == "first" else -1]
                else:
                    parts = in_clip_space if way == "smooth" else weights
                    color = [mix(parts, values) for values in zip(*colors)]
                if "texture" in draw:
                    use, coordinates = draw["texture"], color
                    color = nearest(scene["textures"][use["texture"]], use, coordinates)
                depth = (mix(weights, [c[2] for c in corners]) + 1) / 2
                pixels[y * width + x], depths[y * width + x] = color, depth
                fragments.append({"x": x, "y": y, "primitive": primitive,
                                  "depth": float(depth), "color": [float(n) for n in color]})
                if "coordinates" in scene.get("details", []):
                    fragments[-1]["coordinates"] = [x + 0.5, y + 0.5, float(depth),
                                                    float(inverse_w)]
                if "texture" in draw and "texture" in scene.get("details", []):
                    fragments[-1]["texture_coordinates"] = [float(n) for n in coordinates]
            primitive += 1
    # round() takes the nearest integer, and the even one of two.
    unorm = [round(255 * min(max(Fraction(n), 0), 1)) for pixel in pixels for n in pixel]
    result = {"pixels": unorm, "fragments": fragments}
    if kind:
        result["depths"] = [stored(depth, kind) for depth in depths]
    return result


def answer(scene):
    if scene["target"]["samples"] != 1:
        return {"not_run": "this example draws one sample per pixel"}
    # 14.5.2.1: a width is rounded to a whole number of pixels.
    if any(d["primitive"].startswith("line") and d["line_width"] >= 1.5 for d in scene["draws"]):
        return {"not_run": "this example draws lines of width 1"}
    if scene["target"].get("depth") not in (None, "depth16", "depth24", "depth32f"):
        return {"not_run": "this example has no such depth buffer"}
    for use in (draw["texture"] for draw in scene["draws"] if "texture" in draw):
        texture = scene["textures"][use["texture"]]
        if (use["magnify"], use["minify"], use["mipmap"]) != ("nearest", "nearest", "none"):
            return {"not_run": "this example looks up the nearest texel of one level"}
        if texture["format"] not in ("rgba8", "rgba32f") or not WRAPS.keys() >= {*use["wrap"]}:
            return {"not_run": "this example has no such texture"}
        if use["base_level"] >= len(texture["levels"]):
            return {"not_run": "this example generates no levels"}
    return render(scene)


for request in map(json.loads, sys.stdin):
    reply = answer(request["scene"])
    reply["digest"] = request["digest"]
    reply["renderer"] = {"vendor": "Edgecase", "device": "rasterizer.py", "subpixel_bits": 16}
    print(json.dumps(reply), flush=True)
