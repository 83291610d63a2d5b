# SPDX-License-Identifier: MIT
"""Kinds of lies, each about everything: what liar.py does to honest answers.

A lie changes an answer (reference/PROTOCOL.md) in place. `scene` is the request's, `before` the
previous answer, or None.
"""

# All numbers for each pixel or texel that an answer has.
PLANES = ("pixels", "sample_pixels", "depths", "stencils", "hits", "accumulated", "mip_chains")


def drawings(answer):
    return answer.get("passes", [answer])


def pictures(answer):
    """Each drawing with the name of each of its pictures in 8 bits."""
    for drawn in {id(d): d for d in [answer, *drawings(answer)]}.values():
        for key in ("pixels", "sample_pixels"):
            if drawn.get(key):
                yield drawn, key


def fragments(answer):
    return [f for drawn in drawings(answer) for f in drawn["fragments"]]


def of_pixels(change):
    """A lie about each pixel of each picture: four numbers become four others."""
    def lie(answer, scene, before):
        for drawn, key in pictures(answer):
            values = drawn[key]
            drawn[key] = [n for at in range(0, len(values), 4) for n in change(values[at:at + 4])]
        if "accumulated" in answer:
            values = answer["accumulated"]
            answer["accumulated"] = [n / 255 for at in range(0, len(values), 4) for n in change(
                [round(255 * float(n)) for n in values[at:at + 4]])]
    return lie


def of_pictures(change):
    """A lie about where pixels are: a list of rows of pixels becomes another of the same size."""
    def lie(answer, scene, before):
        width, height = scene["target"]["width"], scene["target"]["height"]
        for drawn, key in pictures(answer):
            values, told = drawn[key], []
            for start in range(0, len(values), 4 * width * height):
                pixels = [tuple(values[at:at + 4])
                          for at in range(start, start + 4 * width * height, 4)]
                rows = change([pixels[at:at + width] for at in range(0, len(pixels), width)])
                told += [n for row in rows for pixel in row for n in pixel]
            drawn[key] = told
    return lie


def transposed(rows):
    return [list(row) for row in zip(*rows)] if len(rows) == len(rows[0]) else rows[1:] + rows[:1]


def byte_off(by):
    """In the middle of each picture."""
    def lie(answer, scene, before):
        for drawn, key in pictures(answer):
            values = drawn[key]
            at = len(values) // 8 * 4
            values[at] = values[at] - by if values[at] >= by else values[at] + by
    return lie


def one_pixel(answer, scene, before):
    for drawn, key in pictures(answer):
        values = drawn[key]
        at = len(values) // 8 * 4
        values[at:at + 4] = [255 - n for n in values[at:at + 4]]


def previous(answer, scene, before):
    if before is not None and all(len(before.get(key, [])) == len(answer.get(key, []))
                                  for key in PLANES + ("passes",)):
        answer.clear()
        answer.update(before)


def first_samples(answer, scene, before):
    samples = scene["target"]["samples"]
    for key, length in (("sample_pixels", 4), ("depths", 1), ("stencils", 1)):
        if samples > 1 and answer.get(key):
            plane = len(answer[key]) // samples
            answer[key] = samples * answer[key][:plane]


def resolved_to(color):
    def lie(answer, scene, before):
        if scene["target"]["samples"] > 1:
            answer["pixels"] = color * (len(answer["pixels"]) // 4)
    return lie


def resolved_halved(answer, scene, before):
    if scene["target"]["samples"] > 1:
        answer["pixels"] = [n // 2 for n in answer["pixels"]]


def placed(positions):
    def lie(answer, scene, before):
        samples = scene["target"]["samples"]
        if samples > 1:
            answer["sample_positions"] = positions(samples, answer.get("sample_positions"))
    return lie


def two_equal(samples, told):
    told = told or [[(s + 0.5) / samples, 0.25] for s in range(samples)]
    return [told[1], *told[1:]]


def of_fragments(change):
    """A lie about each fragment: it is changed in place."""
    def lie(answer, scene, before):
        for fragment in fragments(answer):
            change(fragment, scene)
    return lie


def with_value(key, value):
    def change(fragment, scene):
        if key in fragment:
            fragment[key] = value(fragment[key])
    return of_fragments(change)


def full_coverage(fragment, scene):
    fragment["coverage"] = 2 ** scene["target"]["samples"] - 1


def one_bit(fragment, scene):
    fragment["coverage"] = fragment["coverage"] & -fragment["coverage"]


def without(*keys):
    def change(fragment, scene):
        for key in keys:
            fragment.pop(key, None)
    return of_fragments(change)


def of_values(key, change):
    """A lie about each number of a plane of the answer or of its passes."""
    def lie(answer, scene, before):
        for drawn in [answer, *answer.get("passes", [])]:
            if drawn.get(key):
                drawn[key] = [change(n) for n in drawn[key]]
    return lie


def exchanged_passes(answer, scene, before):
    if "passes" in answer:
        answer["passes"].reverse()


def equal_passes(answer, scene, before):
    if "passes" in answer:
        answer["passes"] = len(answer["passes"]) * answer["passes"][:1]


def of_levels(change):
    """A lie about the texels of generated levels: a list becomes another."""
    def lie(answer, scene, before):
        for drawn in drawings(answer):
            for chain in drawn.get("mip_chains", {}).values():
                for level in chain:
                    level["texels"] = change(level["texels"])
    return lie


def texel_off(texels):
    return [texels[0] - 9 if texels[0] > 9 else texels[0] + 9, *texels[1:]]


def reversed_texels(texels):
    return [n for at in range(len(texels) - 4, -1, -4) for n in texels[at:at + 4]]


def grown(answer, scene, before):
    """Each fragment of one sample is drawn to the eight pixels round it, too."""
    width, height = scene["target"]["width"], scene["target"]["height"]
    if scene["target"]["samples"] > 1:
        return
    for drawn in drawings(answer):
        have = {(f["x"], f["y"], f["primitive"]) for f in drawn["fragments"]}
        for f in list(drawn["fragments"]):
            for x in range(max(0, f["x"] - 1), min(width, f["x"] + 2)):
                for y in range(max(0, f["y"] - 1), min(height, f["y"] + 2)):
                    if (x, y, f["primitive"]) in have:
                        continue
                    have.add((x, y, f["primitive"]))
                    drawn["fragments"].append(dict(f, x=x, y=y))
                    start, own = 4 * (y * width + x), 4 * (f["y"] * width + f["x"])
                    drawn["pixels"][start:start + 4] = drawn["pixels"][own:own + 4]
                    if drawn.get("hits"):
                        drawn["hits"][y * width + x] += 1


def doubled(answer, scene, before):
    for drawn in drawings(answer):
        drawn["fragments"] *= 2
        if drawn.get("hits"):
            drawn["hits"] = [2 * n for n in drawn["hits"]]


def one_lost(answer, scene, before):
    for drawn in drawings(answer):
        if drawn["fragments"]:
            del drawn["fragments"][len(drawn["fragments"]) // 2]
            drawn.pop("hits", None)


def one_added(answer, scene, before):
    width, height = scene["target"]["width"], scene["target"]["height"]
    for drawn in drawings(answer):
        if not drawn["fragments"]:
            continue
        have = {(f["x"], f["y"], f["primitive"]) for f in drawn["fragments"]}
        f = drawn["fragments"][0]
        place = next(((x, y) for y in range(height) for x in range(width)
                      if (x, y, f["primitive"]) not in have), None)
        if place:
            drawn["fragments"].append(dict(f, x=place[0], y=place[1]))
            drawn.pop("hits", None)


def covered(color):
    """What is covered gets one colour in each picture, and the rest stays right."""
    def lie(answer, scene, before):
        width, samples = scene["target"]["width"], scene["target"]["samples"]
        area = width * scene["target"]["height"]
        for drawn, key in pictures(answer):
            for f in fragments(drawn if "fragments" in drawn else answer):
                for s in range(samples if key == "sample_pixels" else 1):
                    at = 4 * (s * area + f["y"] * width + f["x"])
                    if key == "pixels" or f["coverage"] >> s & 1:
                        drawn[key][at:at + 4] = color
        if "accumulated" in answer:
            answer["accumulated"] = [n / 255 for n in answer["pixels"]]
    return lie


def of_another(answer, scene, before):
    for drawn in drawings(answer):
        numbers = sorted({f["primitive"] for f in drawn["fragments"]})
        other = dict(zip(numbers, numbers[1:] + numbers[:1]))
        for f in drawn["fragments"]:
            f["primitive"] = other[f["primitive"]]


def colors_exchanged(answer, scene, before):
    """Each fragment tells the colour, and shows the pixel, of another one of its drawing."""
    for drawn in drawings(answer):
        colors = [f["color"] for f in drawn["fragments"] if "color" in f]
        for f in drawn["fragments"]:
            if "color" in f:
                f["color"] = colors.pop()


def claiming(lie, bits=8, **traits):
    def both(answer, scene, before):
        if lie:
            lie(answer, scene, before)
        answer["renderer"] = {"subpixel_bits": bits, "traits": traits}
    return both


def together(*lies):
    def lie(answer, scene, before):
        for one in lies:
            one(answer, scene, before)
    return lie


def blank(answer, scene, before):
    clear = [min(255, max(0, round(255 * n))) for n in scene["target"]["clear"]]
    for drawn, key in pictures(answer):
        drawn[key] = clear * (len(drawn[key]) // 4)
    for drawn in drawings(answer):
        drawn["fragments"] = []
        if drawn.get("hits"):
            drawn["hits"] = [0] * len(drawn["hits"])
        for key in ("depths", "stencils"):
            if drawn.get(key):
                start = scene["target"]["clear_" + key[:-1]]
                drawn[key] = [start] * len(drawn[key])


STEPS = {"point_size_steps": "1 by 1000", "sampled_line_width_steps": "1 by 1000"}
black = of_pixels(lambda _: [0, 0, 0, 255])
no_color = without("color")
nothing_told = without("color", "depth", "coordinates", "derivatives", "texture_coordinates",
                       "level_of_detail")
other_depths = of_values("depths", lambda n: 1 - n)

KINDS = {
    "honest": lambda *_: None,
    # The picture.
    "one-colour": of_pixels(lambda _: [10, 200, 30, 255]),
    "black": black,
    "inverted": of_pixels(lambda p: [255 - n for n in p[:3]] + p[3:]),
    "red-for-blue": of_pixels(lambda p: [p[2], p[1], p[0], p[3]]),
    "channels-turned": of_pixels(lambda p: [p[1], p[2], p[0], p[3]]),
    "alpha-zero": of_pixels(lambda p: p[:3] + [0]),
    "halved": of_pixels(lambda p: [n // 2 for n in p]),
    "254-for-255": of_pixels(lambda p: [min(254, n) for n in p]),
    "253-for-255": of_pixels(lambda p: [min(253, n) for n in p]),
    "shifted": of_pictures(lambda rows: [row[-1:] + row[:-1] for row in rows]),
    "upside-down": of_pictures(lambda rows: rows[::-1]),
    "mirrored": of_pictures(lambda rows: [row[::-1] for row in rows]),
    "transposed": of_pictures(transposed),
    "one-pixel": one_pixel,
    "byte-off-by-1": byte_off(1),
    "byte-off-by-2": byte_off(2),
    "byte-off-by-128": byte_off(128),
    "previous": previous,
    "blank": blank,
    # The picture, with nothing told that says what it should be.
    "no-colours-black": together(no_color, black),
    "no-colours-inverted": together(no_color, of_pixels(lambda p: [255 - n for n in p[:3]] + p[3:])),
    "no-colours-one-pixel": together(no_color, one_pixel),
    "no-colours-off-by-2": together(no_color, byte_off(2)),
    "nothing-told-black": together(nothing_told, black),
    "nothing-told-covered-black": together(nothing_told, covered([0, 0, 0, 255])),
    "nothing-told-covered-0": together(nothing_told, covered([0, 0, 0, 0])),
    "nothing-told-covered-green": together(nothing_told, covered([0, 255, 0, 255])),
    "covered-green": covered([0, 255, 0, 255]),
    # Samples.
    "first-samples": first_samples,
    "resolved-black": resolved_to([0, 0, 0, 255]),
    "resolved-green": resolved_to([0, 255, 0, 255]),
    "resolved-halved": resolved_halved,
    "places-at-0": placed(lambda samples, _: samples * [[0, 0]]),
    "places-at-centres": placed(lambda samples, _: samples * [[0.5, 0.5]]),
    "places-two-equal": placed(two_equal),
    "places-elsewhere": placed(lambda samples, _: [[(s + 0.25) / samples, 0.75]
                                                   for s in range(samples)]),
    "full-coverage": of_fragments(full_coverage),
    "one-bit": of_fragments(one_bit),
    # Depths and stencils.
    "no-depths-told": together(without("depth"), other_depths),
    "depths-turned": other_depths,
    "depths-0": of_values("depths", lambda _: 0),
    "depths-1": of_values("depths", lambda _: 1),
    "depths-half": of_values("depths", lambda _: 0.5),
    "stencils-0": of_values("stencils", lambda _: 0),
    "stencils-255": of_values("stencils", lambda _: 255),
    "stencil-bits": of_values("stencils", lambda n: n >> 1 | (n & 1) << 7),
    # Counts and means.
    "hits-0": of_values("hits", lambda _: 0),
    "hits-1": of_values("hits", lambda _: 1),
    "hits-doubled": of_values("hits", lambda n: 2 * n),
    "accumulated-black": of_values("accumulated", lambda _: 0),
    "accumulated-7": of_values("accumulated", lambda _: 7),
    "accumulated-halved": of_values("accumulated", lambda n: float(n) / 2),
    "passes-exchanged": exchanged_passes,
    "passes-equal": equal_passes,
    # Textures.
    "levels-black": of_levels(lambda texels: [0] * len(texels)),
    "levels-reversed": of_levels(reversed_texels),
    "texel-off": of_levels(texel_off),
    "lod-0": with_value("level_of_detail", lambda n: [0] * len(n) if isinstance(n, list) else 0),
    # Fragments.
    "doubled": doubled,
    "one-lost": one_lost,
    "one-added": one_added,
    "of-another": of_another,
    "colours-exchanged": colors_exchanged,
    "colours-0": with_value("color", lambda _: [0, 0, 0, 0]),
    "colours-nan": with_value("color", lambda _: ["nan"] * 4),
    "colours-doubled": with_value("color", lambda c: [2 * float(n) for n in c]),
    "depth-told-turned": with_value("depth", lambda n: 1 - float(n)),
    "derivatives-0": with_value("derivatives", lambda d: {
        key: [0] * len(value) for key, value in d.items()} if isinstance(d, dict) else d),
    # What is claimed.
    "grown": grown,
    "grown-steps": claiming(grown, **STEPS),
    "grown-1-bit": claiming(grown, bits=1),
    "grown-24-bits": claiming(grown, bits=24),
    "grown-es": claiming(grown, api="OpenGL ES"),
    "black-bias": claiming(together(no_color, black), max_texture_lod_bias="1e9"),
    "steps": claiming(black, point_size_steps="9 by 9", sampled_line_width_steps="nan by 0"),
}
