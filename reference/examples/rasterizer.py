#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""An exact rasterizer in Python's standard library: the rules of OpenGL 4.6 (core), word for word.

Try it:  edgecase run --against "exec:python3 reference/examples/rasterizer.py"

Numbers are fractions, so nothing is rounded before the answer is written. Where the specification
moves things by an infinitesimal e, a number is a tuple (a, b, c) that stands for a + b e + c e^2;
Python orders tuples by their first difference, which is exactly the order of such numbers.

A target with several samples has a plane of pixels for each. One with a single sample is treated
alike, with the sample at the centre, except for lines.

It omits derivatives and levels of detail, as an answer may: OpenGL allows several values, and none
is exact. So it draws textures only if no level has to be chosen.
"""
import json
import math
import sys
from fractions import Fraction

import polygon_offset
from clipping import ClippedTriangle, cut_line, is_outside
from fragment_operations import Buffers, stored
from known_names import refusal

HALF = Fraction(1, 2)
CENTRE = [HALF, HALF]
# Default sample positions, in sixteenths of a pixel from its lower left corner: the patterns of
# Direct3D and Vulkan. Other numbers of samples use the start of the next larger pattern.
PATTERNS = {
    1: [(8, 8)], 2: [(12, 12), (4, 4)], 4: [(6, 2), (14, 6), (2, 10), (10, 14)],
    8: [(9, 5), (7, 11), (13, 9), (5, 3), (3, 13), (1, 7), (11, 15), (15, 1)],
    16: [(9, 9), (7, 5), (5, 10), (12, 7), (3, 6), (10, 13), (13, 11), (11, 3),
         (6, 14), (8, 1), (4, 2), (2, 12), (0, 8), (15, 4), (14, 15), (1, 0)]}


def point(size):
    """14.4.1 and 14.4.3: the sample (a single one is the centre) lies in the square of this size
    round the point. The square owns its right and top sides; OpenGL leaves that open."""
    def rule(a):
        return lambda p: all(n - size / 2 < at <= n + size / 2 for n, at in zip(a, p))
    return rule


def line(a, b):
    """14.5.1, diamond exit: the segment meets the pixel's open diamond and does not end in it.

    Both ends are moved by -(e, e^2). The diamond is |dx| + |dy| < 1/2 round the centre: the four
    conditions sx dx + sy dy - 1/2 < 0, each of which changes linearly along the segment.
    """
    def covers(centre):
        enter, leave, ends_inside = (0, -1, 0), (1, 1, 0), True  # beyond [0, 1] on both sides
        for sx, sy in (1, 1), (1, -1), (-1, 1), (-1, -1):
            at_a, at_b = (sx * (p[0] - centre[0]) + sy * (p[1] - centre[1]) - HALF for p in (a, b))
            ends_inside = ends_inside and (at_b, -sx, -sy) < (0, 0, 0)
            slope = at_b - at_a
            if slope == 0:
                if (at_a, -sx, -sy) >= (0, 0, 0):
                    return False
            else:  # this part of the way from a to b crosses the condition's border
                crossing = (-at_a / slope, sx / slope, sy / slope)
                enter, leave = ((enter, min(leave, crossing)) if slope > 0
                                else (max(enter, crossing), leave))
        return not ends_inside and enter < leave and enter < (1, 0, 0) and leave > (0, 0, 0)
    return covers


def rectangle(width):
    """14.5.4: the sample of a multisampled line lies in the rectangle round the segment, as wide as
    the line. A sample on its border is moved by (e, -e^2), as for triangles."""
    def rule(a, b):
        dx, dy = b[0] - a[0], b[1] - a[1]
        squared = dx ** 2 + dy ** 2

        def covers(p):
            ahead = (p[0] - a[0]) * dx + (p[1] - a[1]) * dy
            aside = dx * (p[1] - a[1]) - dy * (p[0] - a[0])
            left = 1 if aside > 0 else -1
            within = ((ahead, dx, -dy), (squared - ahead, -dx, dy),
                      (squared * width ** 2 - 4 * aside ** 2, left * dy, left * dx))
            return squared > 0 and min(within) > (0, 0, 0)
        return covers
    return rule


def side(p, q, at):
    """Twice the triangle's area, positive if `at` lies to the left of p -> q."""
    return (q[0] - p[0]) * (at[1] - p[1]) - (q[1] - p[1]) * (at[0] - p[0])


def triangle(a, b, c):
    """14.6.1: the sample (a single one is the centre) lies inside. One on an edge is moved by
    (e, -e^2), so that left edges and then top edges own it. OpenGL leaves that choice open."""
    area = side(a, b, c)
    turn = 1 if area > 0 else -1

    def covers(p):
        return area != 0 and all(
            (turn * side(q, r, p), turn * (q[1] - r[1]), turn * (q[0] - r[0])) > (0, 0, 0)
            for q, r in ((b, c), (c, a), (a, b)))
    return covers


def window_weights(corners, p):
    """14.5.1 and 14.6.1: the weights of the vertices at a point, which need not be covered."""
    if len(corners) == 1:
        return [Fraction(1)]
    a, b = corners[:2]
    if len(corners) == 2:
        along = [b[i] - a[i] for i in (0, 1)]
        t = sum((p[i] - a[i]) * along[i] for i in (0, 1)) / sum(n ** 2 for n in along)
        return [1 - t, t]
    c = corners[2]
    return [side(q, r, p) / side(a, b, c) for q, r in ((b, c), (c, a), (a, b))]


def primitives(kind, n):
    """10.1: the primitives of n vertices, as the numbers of their vertices. These are rotated so
    that the first one provokes under the `first` convention, and the last one under `last`."""
    return {"points": [[i] for i in range(n)],
            "lines": [[i, i + 1] for i in range(0, n - 1, 2)],
            "line_strip": [[i, i + 1] for i in range(n - 1)],
            "line_loop": [[i, (i + 1) % n] for i in range(n)],
            "triangles": [[i, i + 1, i + 2] for i in range(0, n - 2, 3)],
            "triangle_strip": [[i, i + 1, i + 2] for i in range(n - 2)],
            "triangle_fan": [[i, 0, i + 1] for i in range(1, n - 1)]}[kind]


def front_facing(draw, numbers, area):
    """14.6.1: by the winding in the window. The numbers above have the opposite winding for every
    second triangle of a strip, and for every one of a fan."""
    turned = {"triangle_fan": 1, "triangle_strip": numbers[0] % 2}.get(draw["primitive"], 0)
    return ((area > 0) != turned) == (draw.get("front_face", "ccw") == "ccw")


def window(vertex, viewport):
    """13.8.1: x, y and depth (-1 to 1) after the division by w, and w. Clip coordinates are used
    instead of the position, which only has the multiples of 2^-16 nearest to their quotients."""
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


# 8.14.2: the index of the texel for index i in a row of n texels; none for the border.
WRAPS = {"repeat": lambda i, n: i % n,
         "mirrored-repeat": lambda i, n: min(i % (2 * n), 2 * n - 1 - i % (2 * n)),
         "clamp-to-edge": lambda i, n: min(max(i, 0), n - 1),
         "clamp-to-border": lambda i, n: i if 0 <= i < n else None}


def nearest(texture, use, coordinates):
    """8.14.2: the colour of the texel at these coordinates; a border's is clamped if the format is
    fixed-point. A one-dimensional texture has one row, whatever t is."""
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


def common(boxes):
    """The pixels that lie in all of these rectangles [x, y, width, height]."""
    left, bottom = (max(box[i] for box in boxes) for i in (0, 1))
    right, top = (min(box[i] + box[i + 2] for box in boxes) for i in (0, 1))
    return [(x, y) for y in range(bottom, top) for x in range(left, right)]


def sample_positions(target):
    """Positions within a pixel; a single sample is at the centre."""
    if "sample_positions" in target:
        return [[Fraction(n) for n in at] for at in target["sample_positions"]]
    pattern = PATTERNS[min(n for n in PATTERNS if n >= target["samples"])]
    return [[Fraction(n, 16) for n in at] for at in pattern[:target["samples"]]]


def invocations(use, mask, positions):
    """14.3.1.1: the fragments of a pixel: for each the samples that it stands for, where in the
    pixel its attributes are evaluated, which is partly left open, and its gl_FragCoord."""
    covered = [s for s in range(len(positions)) if mask >> s & 1]
    share = Fraction(use.get("min_sample_shading", 0))
    if use["location"] == "sample" or share * len(positions) > 1:
        return [(1 << s, positions[s], positions[s]) for s in covered]
    off_centre = use["location"] == "centroid" and len(covered) < len(positions)
    return [(mask, positions[covered[0]] if off_centre else CENTRE, CENTRE)] if covered else []


def kept(alpha, samples):
    """17.3.1, alpha to coverage: alpha gives the number of samples; OpenGL leaves open which."""
    return (1 << math.floor(min(max(alpha, 0), 1) * samples + HALF)) - 1


def resolved(values):
    """18.3.1: one 8-bit value from a pixel's samples. round() sends ties to even."""
    return round(Fraction(sum(values), len(values)))


class Drawn:
    """One primitive: the samples that it covers, and its values anywhere in the window."""

    def __init__(self, scene, draw, numbers):
        vertices = [draw["vertices"][n] for n in numbers]
        self.scene, self.draw, self.vertices = scene, draw, vertices
        self.clipped = None
        self.corners = []  # empty: nothing of it is visible
        key = "texture_coordinates" if "texture" in draw else "color"
        self.values = [[Fraction(n) for n in v[key]] for v in vertices]
        if not any(map(is_outside, vertices)):
            self.corners = [window(v, scene["viewport"]) for v in vertices]
        elif len(vertices) == 3:
            self.corners = [None] * 3
            self.clipped = ClippedTriangle(vertices, scene["viewport"])
        elif len(vertices) == 2:
            self.cut(cut_line(vertices, scene["viewport"]))
        use = draw.get("multisampling")
        self.use = use if use and use["enabled"] else None
        lines = rectangle(Fraction(draw["line_width"])) if self.use else line
        rules = {0: lambda: None, 1: point(Fraction(draw["point_size"])), 2: lines, 3: triangle}
        self.covers = (self.clipped.covers if self.clipped
                       else rules[len(self.corners)](*self.corners))
        self.face = "front" if self.faces_front(numbers) else "back"
        self.offset = None
        if "polygon_offset" in draw and len(self.corners) == 3 and side(*self.corners) != 0:
            self.offset = polygon_offset.offset(
                draw["polygon_offset"], lambda place: self.plain_depth_at(place)[0], self.corners,
                scene["target"].get("depth"))

    def cut(self, ends):
        """13.7.1: replaces the ends of a line by those of its visible part."""
        if ends is None:
            return
        self.corners = [window({"clip": clip}, self.scene["viewport"]) for _, clip in ends]
        way, (a, b) = self.draw["interpolation"], self.values
        if way == "flat":
            return
        whole = [Fraction(vertex["clip"][3] if "clip" in vertex else vertex.get("w", 1))
                 for vertex in self.vertices]
        parts = [t if way == "smooth" else t * whole[1] / clip[3] for t, clip in ends]
        self.values = [[m + (n - m) * t for m, n in zip(a, b)] for t in parts]

    def faces_front(self, numbers):
        if len(self.corners) < 3:
            return True
        area = self.clipped.area if self.clipped else side(*self.corners)
        return front_facing(self.draw, numbers, area)

    def pixels(self):
        """The pixels that it may cover; none for a point outside the clip volume."""
        if not self.corners:
            return []
        if len(self.corners) == 3 and self.face in self.draw.get("cull", "none").split("_and_"):
            return []
        width, height = self.scene["target"]["width"], self.scene["target"]["height"]
        left, bottom, wide, high = viewport = self.scene["viewport"]
        target = [0, 0, width, height]
        boxes = [target, self.draw.get("scissor", target)]
        # 13.7: triangles are cut at the viewport. For lines and points only vertices are clipped,
        # so wide ones may extend beyond it.
        if len(self.corners) == 3:
            return common([*boxes, viewport])
        if len(self.corners) == 2:
            return common(boxes)
        x, y = self.corners[0][:2]
        if not (0 <= x - left <= wide and 0 <= y - bottom <= high):
            return []
        return common(boxes)

    def fragments(self, x, y, positions):
        """A pixel's fragments, as from invocations(). 14.3.1: without samples, at its centre."""
        if self.use is None:
            return [(1, CENTRE, CENTRE)] if self.covers((x + HALF, y + HALF)) else []
        mask = sum(1 << s for s, at in enumerate(positions)
                   if self.use["mask"] >> s & 1 and self.covers((x + at[0], y + at[1])))
        return invocations(self.use, mask, positions)

    def written(self, mask, color, samples):
        """The samples that a fragment writes."""
        if self.use is None:
            return range(samples)
        if self.use["alpha_to_coverage"]:
            mask &= kept(color[3], samples)
        return [s for s in range(samples) if mask >> s & 1]

    def values_at(self, place):
        way = self.draw["interpolation"]
        if way == "flat":
            return self.values[0 if self.draw["provoking_vertex"] == "first" else -1]
        if self.clipped:
            weights = (self.clipped.perspective_weights(place) if way == "smooth"
                       else self.clipped.window_weights(place))
        else:
            weights = window_weights(self.corners, place)
            if way == "smooth":
                weights, _ = perspective(weights, self.corners)
        return [sum(w * n for w, n in zip(weights, values)) for values in zip(*self.values)]

    def depth_at(self, place):
        """Window depth, with the polygon offset, and 1/w."""
        depth, inverse_w = self.plain_depth_at(place)
        if self.offset is not None:
            depth = min(max(depth + self.offset, Fraction(0)), Fraction(1))
        return depth, inverse_w

    def plain_depth_at(self, place):
        if self.clipped:
            depth, inverse_w = self.clipped.depth(place)
        else:
            weights = window_weights(self.corners, place)
            depth = sum(w * corner[2] for w, corner in zip(weights, self.corners))
            _, inverse_w = perspective(weights, self.corners)
        near, far = map(Fraction, self.scene.get("depth_range", (0, 1)))
        return near + (far - near) * (depth + 1) / 2, inverse_w


def render(scene):
    target, details = scene["target"], scene.get("details", [])
    width, area, kind = target["width"], target["width"] * target["height"], target.get("depth")
    positions = sample_positions(target)
    buffers, fragments = Buffers(target, area * len(positions)), []
    every = (Drawn(scene, draw, numbers) for draw in scene["draws"]
             for numbers in primitives(draw["primitive"], len(draw["vertices"])))
    for number, drawn in enumerate(every):
        for x, y in drawn.pixels():
            for mask, place, coordinates in drawn.fragments(x, y, positions):
                values = color = drawn.values_at((x + place[0], y + place[1]))
                if "texture" in drawn.draw:
                    use = drawn.draw["texture"]
                    color = nearest(scene["textures"][use["texture"]], use, values)
                at = x + coordinates[0], y + coordinates[1]
                depth, inverse_w = drawn.depth_at(at)
                fragments.append({"x": x, "y": y, "primitive": number, "coverage": mask,
                                  "depth": float(depth), "color": [float(n) for n in color]})
                if "coordinates" in details:
                    fragments[-1]["coordinates"] = [float(n) for n in (*at, depth, inverse_w)]
                if "texture" in drawn.draw and "texture" in details:
                    fragments[-1]["texture_coordinates"] = [float(n) for n in values]
                for s in drawn.written(mask, color, len(positions)):
                    within = positions[s] if drawn.use else CENTRE
                    if kind:  # each sample has its own depth, even in a shared fragment
                        depth, _ = drawn.depth_at((x + within[0], y + within[1]))
                        depth = stored(depth, kind)
                    buffers.meet(s * area + y * width + x, drawn, color, depth)
    planes = [n for color in buffers.colors for n in color]
    result = {"pixels": [resolved(planes[i::4 * area]) for i in range(4 * area)],
              "fragments": fragments, "hits": buffers.hits}
    result.update({key: plane for key, plane in
                   (("depths", buffers.depths), ("stencils", buffers.stencils)) if plane})
    if len(positions) > 1:
        result["sample_pixels"] = planes
        result["sample_positions"] = [[float(n) for n in at] for at in positions]
    return result


def answer(scene):
    if "supersampling" in scene["target"]:
        return {"not_run": "this example draws one pass"}
    # 14.5.2.2: without multisampling a width is rounded to a whole number of pixels.
    if any(d["primitive"].startswith("line") and d["line_width"] >= 1.5
           and not d.get("multisampling", {}).get("enabled") for d in scene["draws"]):
        return {"not_run": "this example draws lines of width 1"}
    if scene["target"].get("depth") not in (None, "depth16", "depth24", "depth32f"):
        return {"not_run": "this example has no such depth buffer"}
    if scene["target"].get("stencil") not in (None, "stencil8"):
        return {"not_run": "this example has no such stencil buffer"}
    # 14.6.5: for float depths, an offset's unit depends on the deepest point of a primitive, which
    # need not be a vertex if the primitive is clipped.
    if any("polygon_offset" in draw and any(map(is_outside, draw["vertices"]))
           for draw in scene["draws"]):
        return {"not_run": "this example offsets no depths of clipped triangles"}
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
    reply = refusal(request) or answer(request["scene"])
    reply["digest"] = request["digest"]
    reply["renderer"] = {"vendor": "Edgecase", "device": "rasterizer.py", "subpixel_bits": 16}
    print(json.dumps(reply), flush=True)
