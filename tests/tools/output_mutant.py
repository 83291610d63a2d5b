# SPDX-License-Identifier: MIT
"""The example rasterizer with a fault in what becomes of fragments: output_mutant.py FAULT

FAULT is `none` or one of these.
  less-for-lequal    equal depths fail where they should pass
  depth-inverted     less is taken for greater, lequal for gequal, and the other way round
  depth-write-on     depths are stored whether they are to be written or not
  clear-depth-1      the depth buffer is cleared to 1, whatever the scene says
  straight-alpha     colours that are multiplied by alpha already are multiplied by it again
  truncated          blended colours are cut off rather than rounded
  wrap, saturate     incr and decr wrap where they should stop, or stop where they should wrap
  unmasked           the stencil comparison does without its mask
  reference-unmasked the mask is held before the stored value alone
  red-for-blue       the colour mask has its channels in the order blue, green, red, alpha
  front-for-back     the other faces are culled
  face-inverted      triangles face the other way
  sum-of-partials    polygon offset has |dz/dx| + |dz/dy| for the slope
  colourless         draws that write no colour pass the depth test
  back-wraps         decr and incr wrap of back faces alone
  replace-masked     replace stores the reference under the read mask
  mask-darkens       fragments of a draw that writes no colour have half of it
  box-drops          the last fragment of a scissor box that is not the whole target is lost
  second-drops       the last fragment is lost where all is drawn twice
  blend-drops        the last fragment is lost where colours are added
  far-drops          pixels from the 32nd column on miss the last fragment
  forgetful          every second drawing has another colour in a pixel
  float-unit         a unit of polygon offset grows with the depth, as in a buffer of floats
"""
import io
import json
import math
import os
import pathlib
import sys
from fractions import Fraction

ROOT = pathlib.Path(os.environ.get("EDGECASE_ROOT", pathlib.Path(__file__).parents[2]))
sys.path.insert(0, str(ROOT / "reference" / "examples"))
requests, sys.stdin = sys.stdin, io.StringIO()  # the example answers what it finds when it starts
import fragment_operations  # noqa: E402
import polygon_offset  # noqa: E402
import rasterizer  # noqa: E402

OPPOSITE = {"less": "greater", "lequal": "gequal", "greater": "less", "gequal": "lequal",
            "front": "back", "back": "front", "cw": "ccw", "ccw": "cw"}


# What takes the place of a function of the example.

def cut_off(use, source, destination, right=fragment_operations.blended):
    """Of 8-bit codes."""
    return [Fraction(math.floor(255 * n), 255)
            for n in fragment_operations.clamped(right(use, source, destination))]


def sum_of_partials(across, up):
    return abs(across) + abs(up)


def float_unit(kind, largest, right=polygon_offset.unit):
    """2^(e - n) of a buffer of n bits, e the exponent of the largest depth, at least a step."""
    if not kind.startswith("depth") or kind.endswith("f"):
        return right(kind, largest)
    bits = int(kind.removeprefix("depth"))
    exponent = math.frexp(max(largest, Fraction(1, 2**30)))[1] - 1
    return max(Fraction(2) ** (exponent + 2 - bits), Fraction(1, 2**bits))


def spoil_program(fault):
    operations = fragment_operations.STENCIL_OPERATIONS
    if fault == "float-unit":
        polygon_offset.unit = float_unit
    if fault == "truncated":
        fragment_operations.blended = cut_off
    if fault == "sum-of-partials":
        polygon_offset.slope = sum_of_partials
    for name in "incr", "decr":
        if fault == "wrap":
            operations[name] = operations[f"{name}_wrap"]
        if fault == "saturate":
            operations[f"{name}_wrap"] = operations[name]


def spoil_face(face, fault):
    """The stencil state of one face."""
    if fault == "unmasked":
        face["read_mask"] = 255
    if fault == "replace-masked":  # the comparison masks it anyway
        face["reference"] &= face["read_mask"]
    if fault == "reference-unmasked" and face["reference"] & ~face["read_mask"]:
        # The masked value never has such a bit: it is less, and never equal.
        face["test"] = {"equal": "never", "lequal": "never", "less": "never",
                        "gequal": "always", "greater": "always", "notequal": "always"
                        }.get(face["test"], face["test"])


def spoil(draw, fault):
    """What is asked for becomes what the faulty renderer draws."""
    depth, cull = draw.get("depth"), draw.get("cull")
    if depth and fault == "less-for-lequal" and depth["test"] == "lequal":
        depth["test"] = "less"
    if depth and fault == "depth-inverted":
        depth["test"] = OPPOSITE.get(depth["test"], depth["test"])
    if depth and fault == "depth-write-on":
        depth["write"] = True
    if depth and fault == "colourless" and not any(draw.get("color_mask", [True])):
        depth["test"] = "always"
    if fault == "back-wraps" and "stencil" in draw:
        back = draw["stencil"]["back"]
        for outcome in "fail", "depth_fail", "pass":
            if back[outcome] in ("incr", "decr"):
                back[outcome] += "_wrap"
    if cull and fault == "front-for-back":
        draw["cull"] = OPPOSITE.get(cull, cull)
    if fault == "face-inverted":
        draw["front_face"] = OPPOSITE[draw.get("front_face", "ccw")]
    if fault == "red-for-blue" and "color_mask" in draw:
        red, green, blue, alpha = draw["color_mask"]
        draw["color_mask"] = [blue, green, red, alpha]
    if fault == "straight-alpha" and "blend" in draw:
        color = draw["blend"]["color"]
        if (color["source"], color["destination"]) == ("one", "one_minus_src_alpha"):
            color["source"] = "src_alpha"
    for face in draw.get("stencil", {}).values():
        spoil_face(face, fault)


def drops_last(scene, fault):
    """Whether a fault of a scene's state is asked for by it."""
    draws, target = scene["draws"], scene["target"]
    whole = [0, 0, target["width"], target["height"]]
    return (fault == "box-drops" and draws[0].get("scissor", whole) != whole
            or fault == "second-drops" and len(draws) > 1 and draws[0] == draws[-1]
            or fault == "blend-drops" and draws[0].get("blend", {}).get("color", {}).get(
                "destination") == "one")


def answer(scene, fault):
    if fault == "clear-depth-1":
        scene["target"].pop("clear_depth", None)
    for draw in scene["draws"]:
        spoil(draw, fault)
    reply = rasterizer.answer(scene)
    fragments = reply.get("fragments", [])
    if fault == "mask-darkens" and not any(scene["draws"][0].get("color_mask", [True])):
        for fragment in fragments:
            fragment["color"] = [n / 2 for n in fragment["color"]]
    for lost in [f for f in fragments if f["x"] >= 32][-1:] if fault == "far-drops" else []:
        fragments.remove(lost)
        reply["hits"][lost["y"] * scene["target"]["width"] + lost["x"]] -= 1
    if fragments and drops_last(scene, fault):
        fragments.pop()
        del reply["hits"]
    if fault == "forgetful":
        answer.times = getattr(answer, "times", 0) + 1
        if answer.times % 2 == 0:
            reply["pixels"][0] ^= 255
    return reply


def main():
    (fault,) = sys.argv[1:]
    spoil_program(fault)
    for request in map(json.loads, requests):
        reply = answer(request["scene"], fault)
        reply["digest"] = request["digest"]
        reply["renderer"] = {"device": fault, "subpixel_bits": 16}
        print(json.dumps(reply), flush=True)


main()
