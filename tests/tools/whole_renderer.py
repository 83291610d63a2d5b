# SPDX-License-Identifier: MIT
"""A right rasterizer behind a fault of the kind that people's own rasterizers have, in all that it
draws: whole_renderer.py RASTERIZER FAULT[+FAULT]

RASTERIZER is a program that answers requests in lines. The fault changes what it is asked or what
it answers: FAULTS has them all."""
import json
import math
import subprocess
import sys


def moved(change):
    """A change of each vertex's place in the window; `change` gets and returns x and y."""
    def ask(scene):
        x0, y0, width, height = scene["viewport"]
        for vertex in (v for draw in scene["draws"] for v in draw["vertices"]):
            if "clip" in vertex:
                x, y, z, w = vertex["clip"]
                if w > 0:
                    x, y = change(x0 + width * (x / w + 1) / 2, y0 + height * (y / w + 1) / 2)
                    vertex["clip"] = [((x - x0) * 2 / width - 1) * w,
                                      ((y - y0) * 2 / height - 1) * w, z, w]
            if "position" in vertex:
                x, y, *z = vertex["position"]
                vertex["position"] = [*change(x, y), *z]
    return ask


def fragments_where(keeps):
    """Leaves out fragments; `keeps` gets the scene's primitives and a fragment."""
    def answer(scene, found):
        all_primitives = primitives(scene)
        found["fragments"] = [f for f in found["fragments"]
                              if keeps(scene, all_primitives[f["primitive"]], f)]
    return answer


def primitives(scene):
    """(draw, vertices) of each primitive, in drawing order."""
    found = []
    for number, draw in enumerate(scene["draws"]):
        v = draw["vertices"]
        kind = draw["primitive"]
        if kind == "points":
            groups = [[p] for p in v]
        elif kind == "lines":
            groups = [v[i:i + 2] for i in range(0, len(v), 2)]
        elif kind in ("line_strip", "line_loop"):
            groups = [v[i:i + 2] for i in range(len(v) - 1)]
            if kind == "line_loop":
                groups.append([v[-1], v[0]])
        elif kind == "triangles":
            groups = [v[i:i + 3] for i in range(0, len(v), 3)]
        elif kind == "triangle_strip":
            groups = [[v[i], v[i + 1], v[i + 2]] if i % 2 == 0 else [v[i + 1], v[i], v[i + 2]]
                      for i in range(len(v) - 2)]
        else:
            groups = [[v[0], v[i], v[i + 1]] for i in range(1, len(v) - 1)]
        found += [(number, group) for group in groups]
    return found


def turn(group):
    if len(group) < 3 or any("position" not in v for v in group):
        return 0
    (ax, ay), (bx, by), (cx, cy) = (v["position"][:2] for v in group)
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def turned_over(scene, found):
    width, height = scene["target"]["width"], scene["target"]["height"]

    def rows_reversed(plane, numbers):
        row = width * numbers
        return [n for start in range(0, len(plane), row * height)
                for y in reversed(range(height)) for n in plane[start + y * row:start + (y + 1) * row]]
    for key, numbers in (("pixels", 4), ("sample_pixels", 4), ("hits", 1), ("depths", 1),
                         ("stencils", 1)):
        if key in found:
            found[key] = rows_reversed(found[key], numbers)
    for fragment in found["fragments"]:
        fragment["y"] = height - 1 - fragment["y"]


def recoloured(change):
    """Another picture; `change` gets and returns the four codes of a pixel."""
    def answer(_, found):
        for key in ("pixels", "sample_pixels"):
            if key in found:
                codes = found[key]
                found[key] = [n for i in range(0, len(codes), 4) for n in change(*codes[i:i + 4])]
    return answer


def draw_nothing(scene, found):
    found["fragments"] = []
    clear = [round(255 * c) for c in scene["target"]["clear"]]
    found["pixels"] = clear * (len(found["pixels"]) // 4)


def untested(scene, found):
    """Tells as many fragments of a pixel as were written there."""
    if "hits" in found and scene["target"].get("samples", 1) == 1:
        left = list(found["hits"])
        kept = []
        for fragment in reversed(found["fragments"]):
            at = fragment["y"] * scene["target"]["width"] + fragment["x"]
            if left[at] > 0:
                left[at] -= 1
                kept.append(fragment)
        found["fragments"] = kept[::-1]


def is_y_major(group):
    (ax, ay), (bx, by) = (v["position"][:2] for v in group)
    return abs(by - ay) > abs(bx - ax)


def extra_beside_y_major_lines(scene, found):
    """The first fragment of each y-major line has a second one on its right."""
    width = scene["target"]["width"]
    all_primitives, doubled, more = primitives(scene), set(), []
    drawn = {(f["x"], f["y"]) for f in found["fragments"]}
    for f in found["fragments"]:
        number, x, y = f["primitive"], f["x"] + 1, f["y"]
        _, group = all_primitives[number]
        if number in doubled or len(group) != 2 or not is_y_major(group):
            continue
        doubled.add(number)
        if x < width and (x, y) not in drawn:
            more.append({**f, "x": x})
            at = 4 * (y * width + x)
            found["pixels"][at:at + 4] = found["pixels"][at - 4:at]
    found["fragments"] += more


def dropped_at_joints(scene, found):
    """A segment that goes on from another one lacks its first fragment."""
    ends = [group[1]["position"] if len(group) == 2 else None for _, group in primitives(scene)]
    starts = [group[0]["position"] if len(group) == 2 else None for _, group in primitives(scene)]
    width, seen, kept = scene["target"]["width"], set(), []
    clear = [round(255 * c) for c in scene["target"]["clear"]]
    for f in found["fragments"]:
        number = f["primitive"]
        is_joint = number > 0 and starts[number] and starts[number] == ends[number - 1]
        if not is_joint or number in seen:
            kept.append(f)
        seen.add(number)
    drawn = {(f["x"], f["y"]) for f in kept}
    for f in found["fragments"]:
        if (f["x"], f["y"]) not in drawn:
            at = 4 * (f["y"] * width + f["x"])
            found["pixels"][at:at + 4] = clear
    found["fragments"] = kept


# What changes the request, and what changes the answer; and what the run is to say.
FAULTS = {
    "corner": (moved(lambda x, y: (x + 0.5, y + 0.5)), None,
               "samples pixels at their lower left corner"),
    "whole": (moved(lambda x, y: (math.floor(x), math.floor(y))), None,
              "cuts vertices to whole pixels"),
    "quarters": (moved(lambda x, y: (math.floor(4 * x + 0.5) / 4, math.floor(4 * y + 0.5) / 4)),
                 None, "rounds vertices to quarters of a pixel"),
    "off": (moved(lambda x, y: (x - 1, y)), None, "draws everything a pixel too far left"),
    "culled": (None, fragments_where(lambda _, p, f: turn(p[1]) >= 0),
               "draws no triangle that runs clockwise"),
    "first-draw": (None, fragments_where(lambda _, p, f: p[0] == 0),
                   "draws nothing after a scene's first draw"),
    "upside-down": (None, turned_over, "draws its pictures upside down"),
    "first-row": (None, fragments_where(lambda _, p, f: f["y"] > 0),
                  "loses the lowest row of the target"),
    "blank": (None, draw_nothing, "draws nothing"),
    "early": (None, untested, "does not tell the fragments that fail a depth or stencil test"),
    "bgr": (None, recoloured(lambda r, g, b, a: (b, g, r, a)), "exchanges red and blue"),
    "254": (None, recoloured(lambda *codes: [min(c, 254) for c in codes]), "stores 254 for 255"),
}


# Faults that have no word of their own: differences of a rule and kind are one heading.
SMALL_FAULTS = {"y-major-extra": (None, extra_beside_y_major_lines),
                "joint-dropped": (None, dropped_at_joints)}


def main():
    names = sys.argv[2].split("+")
    rasterizer = subprocess.Popen(sys.argv[1].split(), stdin=subprocess.PIPE,
                                  stdout=subprocess.PIPE, text=True)
    for line in sys.stdin:
        request = json.loads(line)
        scene = json.loads(json.dumps(request["scene"]))
        faults = [(FAULTS | SMALL_FAULTS)[name] for name in names]
        for ask, *_ in faults:
            if ask:
                ask(request["scene"])
        rasterizer.stdin.write(json.dumps(request) + "\n")
        rasterizer.stdin.flush()
        found = json.loads(rasterizer.stdout.readline())
        for _, answer, *_ in faults:
            if "pixels" in found and "fragments" in found and answer:
                answer(scene, found)
        found.pop("hits", None)
        print(json.dumps(found), flush=True)


if __name__ == "__main__":
    main()
