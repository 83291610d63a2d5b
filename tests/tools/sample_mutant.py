# SPDX-License-Identifier: MIT
"""The example rasterizer with a fault of multisampling: sample_mutant.py FAULT [OMITTED ...]

FAULT is `none` or one of these. The positions that are told are right all the same.
  swapped-I-J       samples I and J lie where the other one should
  mirrored-x, mirrored-y, turned   all samples lie mirrored or turned by 180 degrees in their pixel
  truncated         the mean of the samples is cut off rather than rounded
  one-more          their sum is divided by one more than there are
  twice-the-first   a mean in which sample 0 counts twice
  centroid-at-centre, mask-ignored, alpha-inverted, once-per-pixel
  depth-at-centre   a depth for each sample, all of the pixel's centre
  four-for-two      twice as many samples as asked for
  one-sample        the scene drawn as for a target of one sample
  refused           targets with several samples are refused
OMITTED are keys of the answer, `sample_pixels` say, or of its fragments that are not told.
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


def misplaced(fault):
    """Positions to others."""
    def mirrored(*axes):
        return lambda positions: [[1 - n if axis in axes else n for axis, n in enumerate(at)]
                                  for at in positions]

    def swapped(positions):
        i, j = map(int, fault.split("-")[1:])
        swap = {i: j, j: i}
        return [positions[swap.get(s, s)] for s in range(len(positions))]

    return {"mirrored-x": mirrored(0), "mirrored-y": mirrored(1), "turned": mirrored(0, 1),
            }.get(fault, swapped if fault.startswith("swapped-") else None)


# What takes the place of a function of the example.

def truncated(values):
    return sum(values) // len(values)


def one_more(values):
    return round(Fraction(sum(values), len(values) + 1))


def twice_the_first(values):
    return round(Fraction(values[0] + sum(values), len(values) + 1))


def at_centre(use, mask, positions, right=rasterizer.invocations):
    return right({**use, "location": "center"}, mask, positions)


def once_per_pixel(use, mask, positions):
    """Attributes at the centre, as of an ordinary shader."""
    return [(mask, rasterizer.CENTRE, rasterizer.CENTRE)] if mask else []


def inverted(alpha, samples, right=rasterizer.kept):
    return right(1 - alpha, samples)


SPOILT = {"truncated": ("resolved", truncated), "one-more": ("resolved", one_more),
          "twice-the-first": ("resolved", twice_the_first),
          "centroid-at-centre": ("invocations", at_centre),
          "once-per-pixel": ("invocations", once_per_pixel), "alpha-inverted": ("kept", inverted)}


def spoil(scene, fault):
    """What is asked for becomes what the faulty renderer draws."""
    target = scene["target"]
    move = misplaced(fault)
    if move:
        target["sample_positions"] = move(rasterizer.sample_positions(target))
    if fault == "four-for-two":
        target["samples"] *= 2
    if fault == "mask-ignored":
        for draw in scene["draws"]:
            draw["multisampling"]["mask"] = 2 ** target["samples"] - 1
    if fault == "one-sample":
        target["samples"] = 1
        for draw in scene["draws"]:
            del draw["multisampling"]


def depths_of_centres(scene):
    """What the example stores if it takes all samples to lie there, whatever they cover."""
    class Drawn(rasterizer.Drawn):
        def depth_at(self, place):
            centre = [int(n) + rasterizer.HALF for n in place]
            return super().depth_at(centre)

    right, rasterizer.Drawn = rasterizer.Drawn, Drawn
    depths = rasterizer.answer(scene)["depths"]
    rasterizer.Drawn = right
    return depths


def answer(scene, fault):
    if fault == "refused" and scene["target"]["samples"] > 1:
        return {"not_run": "one sample per pixel is all there is"}
    positions = [[float(n) for n in at] for at in rasterizer.sample_positions(scene["target"])]
    spoil(scene, fault)
    reply = rasterizer.answer(scene)
    if misplaced(fault):
        reply["sample_positions"] = positions
    if fault == "depth-at-centre":
        reply["depths"] = depths_of_centres(scene)
    return reply


def without(reply, omitted):
    fragments = [{key: value for key, value in fragment.items() if key not in omitted}
                 for fragment in reply.get("fragments", [])]
    told = {key: value for key, value in reply.items() if key not in omitted}
    return {**told, "fragments": fragments} if "fragments" in told else told


def main():
    fault, *omitted = sys.argv[1:]
    if fault in SPOILT:
        setattr(rasterizer, *SPOILT[fault])
    for request in map(json.loads, requests):
        reply = without(answer(request["scene"], fault), omitted)
        reply["digest"] = request["digest"]
        reply["renderer"] = {"device": fault, "subpixel_bits": 8}
        print(json.dumps(reply), flush=True)


main()
