# SPDX-License-Identifier: MIT
"""Made-up results of any size, as results_file.py in tests/tools has them.

What they hold is like what a run of the suite finds: sweeps of fifty cases a file, three renderers,
half of the cases without any difference, sentences with numbers and a figure at each differing
pixel. All of it follows from the numbers given, so that the same call makes the same results.
"""
RENDERERS = ["osmesa:llvmpipe", "osmesa:softpipe", "exec:./card"]
RULES = ["line.diamond-exit", "line.snap", "triangle.fill-rule", "point.ownership", "line.width"]
FAMILIES = ["lines", "triangles", "points", "textures", "samples"]
CAUSES = ["line.snap=8-half-even", "triangle.fill-rule=left-bottom", ""]
PER_FILE = 50
SIZE = 16


def figure(*marks):
    """As src/results/findings_json.h has figures, of marks: role, points, closed, label."""
    points = []
    for _, places, *_ in marks:
        points += [place for place in places if place not in points]
    return {"points": [float(number) for point in points for number in point],
            "marks": [[role, [points.index(place) for place in places], *more]
                      for role, places, *more in marks]}


def figure_at(x, y):
    """A diamond with its owned corner, and the segment that is decided."""
    cx, cy = x + 0.5, y + 0.5
    return figure(
        ("region", [[cx - 0.5, cy], [cx, cy - 0.5], [cx + 0.5, cy], [cx, cy + 0.5]], True),
        ("owned", [[cx, cy - 0.5]], False, "owns its lower corner"),
        ("edge", [[1.25, 2.0], [13.5 + x / 256, 11.25 + y / 256]]),
        ("sample", [[cx, cy]]))


def disagreement(number, place):
    """The one at the given place of a case's pixels, numbered over all cases."""
    x, y = place % SIZE, place // SIZE % SIZE
    kind = ["missing", "extra", "value", "duplicate"][number % 4]
    legal = number % 3 != 0
    values = {"missing": ([1], [0]), "extra": ([0], [1]), "duplicate": ([1], [2]),
              "value": ([0.25, 0.5, number / 65536, 1], [0.25, 0.5, (number + 1) / 65536, 1])}
    exact, rendered = values[kind]
    return {
        "pixel": [x, y], "sample": 0, "primitive": number % 7, "kind": kind,
        "rule": RULES[number % len(RULES)], "legality": "legal" if legal else "contested" if number % 9 == 0 else "illegal",
        "cause": CAUSES[number % 3] if legal else "",
        "situation": "line, y-major right and down, last pixel", "ruling": 1 + number % 9,
        "exact": exact, "rendered": rendered,
        "explanation": (
            f"line {number % 7}: the segment (1.25, 2) to ({13.5 + x / 256}, {11.25 + y / 256}) "
            f"comes within {number % 256}/256 of the centre ({x + 0.5}, {y + 0.5}) and leaves its "
            f"diamond {number % 19}/65536 before its end; exact draws the pixel, the renderer "
            f"does not. Ruling {1 + number % 9} decides for the segment as given."),
        "figure": figure_at(x, y),
    }


def fragments_of(found, side):
    """What "exact" or "rendered" makes at the pixels of disagreements."""
    made = []
    for d in found:
        value = d["kind"] == "value"
        color = d[side] if value else [0.25, 0.5, d["primitive"] / 8, 1]
        depth = 0.5 + d["pixel"][0] / 4096 + (value and side == "rendered") / 16777216
        one = [*d["pixel"], d["primitive"], 1, depth, color]
        made += [one] * (1 if value else d[side][0])
    return made


def packed(words):
    """As src/results/packed_text.h has words."""
    return " ".join(word.hex().lstrip("0") or "0" for word in words)


def picture(number):
    """RGBA8, bottom row first."""
    pixels = bytearray(b"\x10\x10\x18\xff" * SIZE * SIZE)
    for x in range(SIZE):
        at = 4 * (x + SIZE * ((x * (1 + number % 3) + number) % SIZE))
        pixels[at:at + 3] = bytes([250, 200 - number % 100, 40])
    return pixels


def packed_picture(pixels, width):
    """Each byte without what its neighbours foretell (src/results/packed_text.h)."""
    row = 4 * width
    left = bytearray(pixels)
    for i, byte in enumerate(pixels):
        beside, below = i % row >= 4, i >= row
        left[i] = (byte - (pixels[i - 4] if beside else 0) - (pixels[i - row] if below else 0)
                   + (pixels[i - row - 4] if beside and below else 0)) % 256
    return packed(left[i:i + 4] for i in range(0, len(left), 4))


def difference(differing):
    """Of a picture that is another one in red at these pixels."""
    return packed(bytes([0xff if (i % SIZE, i // SIZE) in differing else 0, 0, 0, 0])
                  for i in range(SIZE * SIZE))


def result_of(number, count, first):
    """The answer of one renderer with so many disagreements, numbered from `first`."""
    found = [disagreement(first + i, (number * 7 + i * 5) % (SIZE * SIZE)) for i in range(count)]
    found.sort(key=lambda d: (d["pixel"][1], d["pixel"][0]))
    verdict = "agree"
    if found:
        legalities = {d["legality"] for d in found}
        verdict = ("violation" if "illegal" in legalities
                   else "contested" if "contested" in legalities
                   else "permitted" if not all(d["cause"] for d in found) else "convention")
    places = {tuple(d["pixel"]) for d in found}
    result = {
        "verdict": verdict, "fingerprint": f"{number * 2654435761 % 2**64:016x}" if found else "",
        "standing": ("expected" if not found else "known" if number % 10
                     else "tolerated" if verdict == "contested" else "unexpected"),
        "standing_reason": "known since 22.3" if found and number % 10 else "",
        "pixel_counts": {"agree": SIZE * SIZE - len(places), "convention": 0, "permitted": 0,
                         "contested": len(places) if verdict == "contested" else 0,
                         "violation": 0 if verdict == "contested" else len(places),
                         "same": SIZE * SIZE - len(places)},
        "disagreements": found, "values": [], "evidence": [], "illegal_line_snaps": [],
        "refuted": "",
    }
    if found:
        result["pixels"] = difference(places)
    for side in ("exact", "rendered"):
        made = fragments_of(found, side)
        if made:
            result[side + "_fragments"] = made
    return result


def case_of(number, counts, first, **words):
    family = FAMILIES[number // PER_FILE % len(FAMILIES)]
    stem = f"{family}/file-{number // PER_FILE:04}"
    agreeing = result_of(number, 0, 0)
    results = [result_of(number, count, first) if count else agreeing for count in counts]
    return {
        "id": f"{stem}:step={number % PER_FILE:02}/256", "title": f"A sweep over steps, {stem}",
        "why": "Each step moves the end by 1/256: it leaves the diamond or it does not.",
        "rules": [RULES[number // PER_FILE % len(RULES)]], "spec": "GL 4.6 core, 14.5.1",
        "origin": "", "tags": ["tie"], "file": f"cases/{stem}.json", "file_digest": "",
        "surface": "fbo", "width": SIZE, "height": SIZE, "fragments": SIZE,
        "pixels": packed_picture(picture(number), SIZE),
        "figure": figure(("primitive", [[1.25, 2], [13.5, 11.25]], False, "0"),
                         ("vertex", [[1.25, 2]], False, "v0"),
                         ("snapped-vertex", [[1.25, 2.00390625]])),
        "expect_failures": [], "results": dict(zip(RENDERERS, results)), **words,
    }


def results_with(cases):
    return {
        "tool": "edgecase 0.1.0", "policy": "opengl", "latitude": "opengl", "policy_digest": "",
        "interrupted": False, "whole_suite": False,
        "renderers": [{"name": name, "vendor": "Mesa", "version": "4.5", "device": name,
                       "subpixel_bits": 8, "traits": {}} for name in RENDERERS],
        "diagnostics": [], "faults": [], "cases": sorted(cases, key=lambda case: case["id"]),
    }


def make(cases, pixels):
    """So many cases, of which half have all of the differing pixels, for one renderer or two."""
    differing = max(1, cases // 2)
    made, first = [], 0
    for number in range(cases):
        count = 0
        if number % 2 == 0:
            share = number // 2
            count = pixels * (share + 1) // differing - pixels * share // differing
        counts = [0, count, count if number % 8 == 0 else 0]
        made.append(case_of(number, counts, first))
        first += count
    return results_with(made)
