# SPDX-License-Identifier: MIT
"""The example rasterizer with derivatives, and with one fault: value_mutant.py FAULT

FAULT is `none`, `noperspective` (for smooth), `smooth` (for noperspective), `provoking-vertex` (the
other convention's), `other-row` (differences in the row or column of the quad that the pixel is not
in) or `coarse` (one difference for the quad where the fine form is asked for, too).
"""
import io
import json
import os
import pathlib
import sys
from fractions import Fraction

ROOT = pathlib.Path(os.environ.get("EDGECASE_ROOT", pathlib.Path(__file__).parents[2]))
sys.path.insert(0, str(ROOT / "reference" / "examples"))
requests, sys.stdin = sys.stdin, io.StringIO()  # the example answers what it finds when it starts
import rasterizer  # noqa: E402

HALF = Fraction(1, 2)


def twice_area(a, b, c):
    return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])


def window_weights(corners, x, y):
    """As the example's, but for any pixel: a quad's other pixels need not be covered."""
    p = (x + HALF, y + HALF)
    if len(corners) == 1:
        return [Fraction(1)]
    if len(corners) == 2:
        a, b = corners
        along = [b[i] - a[i] for i in (0, 1)]
        t = (sum((p[i] - a[i]) * along[i] for i in (0, 1))
             / sum(length ** 2 for length in along))
        return [1 - t, t]
    a, b, c = corners
    whole = twice_area(a, b, c)
    return [twice_area(*pair, p) / whole for pair in ((b, c), (c, a), (a, b))]


def primitives_of(scene):
    """Draw, corners and colours of each primitive, in drawing order."""
    for draw in scene["draws"]:
        for numbers in rasterizer.primitives(draw["primitive"], len(draw["vertices"])):
            vertices = [draw["vertices"][n] for n in numbers]
            yield (draw, [rasterizer.window(v, scene["viewport"]) for v in vertices],
                   [[Fraction(n) for n in v["color"]] for v in vertices])


def color_at(primitive, x, y):
    draw, corners, colors = primitive
    if draw["interpolation"] == "flat":
        return colors[0 if draw["provoking_vertex"] == "first" else -1]
    weights = window_weights(corners, x, y)
    if draw["interpolation"] == "smooth":
        weights, _ = rasterizer.perspective(weights, corners)
    return [sum(w * n for w, n in zip(weights, values)) for values in zip(*colors)]


def derivatives(primitive, x, y, fault):
    """Of 2x2 quads that begin at even columns and rows."""
    left, bottom = x - x % 2, y - y % 2

    def along_x(row):
        return difference((left + 1, row), (left, row))

    def along_y(column):
        return difference((column, bottom + 1), (column, bottom))

    def difference(second, first):
        return [float(b - a) for a, b in zip(color_at(primitive, *first),
                                             color_at(primitive, *second))]

    row, column = {"other-row": (2 * bottom + 1 - y, 2 * left + 1 - x),
                   "coarse": (bottom, left)}.get(fault, (y, x))
    return {"dFdx": along_x(y), "dFdy": along_y(x),
            "dFdxFine": along_x(row), "dFdyFine": along_y(column),
            "dFdxCoarse": along_x(bottom), "dFdyCoarse": along_y(left)}


def spoil(draw, fault):
    if fault == "provoking-vertex":
        draw["provoking_vertex"] = {"first": "last", "last": "first"}[draw["provoking_vertex"]]
    if (fault, draw["interpolation"]) in (("noperspective", "smooth"), ("smooth", "noperspective")):
        draw["interpolation"] = fault


def answer(scene, fault):
    for draw in scene["draws"]:
        spoil(draw, fault)
    reply = rasterizer.answer(scene)
    if "derivatives" in scene.get("details", []):
        primitives = list(primitives_of(scene))
        for f in reply.get("fragments", []):
            f["derivatives"] = derivatives(primitives[f["primitive"]], f["x"], f["y"], fault)
    return reply


def main():
    (fault,) = sys.argv[1:]
    for request in map(json.loads, requests):
        reply = answer(request["scene"], fault)
        reply["digest"] = request["digest"]
        reply["renderer"] = {"device": fault, "subpixel_bits": 8}
        print(json.dumps(reply), flush=True)


main()
