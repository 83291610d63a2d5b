# SPDX-License-Identifier: MIT
"""The example rasterizer with a fault: faulty_rasterizer.py FAULT

FAULT is `none`, or `first-vertex` (which is how a policy may have it: the first vertex provokes,
whatever the scene says), or one of these.
  last-pixel    lines draw the pixel that they end in, too
  leftward      lines that go left lack their first pixel
  top-right     a sample on an edge belongs to top edges, then to right ones; the first vertex provokes
  4-bits        vertices are rounded to 1/16 pixel, and the program says so
  4-bits-for-8  the same, but it says that they are kept to 1/256 pixel
  shared-twice  a sample on an edge belongs to every triangle that has the edge
  mirrored      what is drawn stands upside down in the target

These are the roots that `edgecase backends` tells.
  pixels-mirrored, fragments-mirrored  only these stand upside down
  bgr, bgr-clear   red and blue are exchanged, everywhere or in the clear colour
  nothing          nothing is drawn
  no-pixels, no-fragments              what is drawn is told without these
  no-clockwise, no-counterclockwise    these triangles are culled where no facing is to be culled
  254              colours are stored with 254 in place of 255
  early, early-depth                   what fails a test, or the depth test, is not listed
"""
import functools
import io
import json
import os
import pathlib
import sys
from fractions import Fraction

ROOT = pathlib.Path(os.environ.get("EDGECASE_ROOT", pathlib.Path(__file__).parents[2]))
sys.path.insert(0, str(ROOT / "reference" / "examples"))
requests, sys.stdin = sys.stdin, io.StringIO()  # the example answers what it finds when it starts
import fragment_operations  # noqa: E402
import rasterizer  # noqa: E402

SUBPIXEL_BITS = {"4-bits": 4, "4-bits-for-8": 8}


# What takes the place of a function of the example.

def last_pixel(a, b, right=rasterizer.line):
    """Also the pixel in whose diamond the segment ends: a longer segment would leave it."""
    covers = right(a, b)
    if a[:2] == b[:2]:
        return covers
    beyond = [n + (n - m) * LONGER for m, n in zip(a[:2], b[:2])]
    longer = right(a, beyond)

    def covers_more(centre):
        at_end = sum(abs(n - m) for n, m in zip(centre, b)) < rasterizer.HALF
        return covers(centre) or at_end and longer(centre)
    return covers_more


LONGER = 2 ** 16


def leftward(a, b, right=rasterizer.line):
    covers = right(a, b)
    if b[0] >= a[0]:
        return covers

    def covers_less(centre):
        """Nothing of the line comes before its first pixel: that lies nearest to the start."""
        before = (centre[0] + 1, centre[1]), (centre[0] + 1, centre[1] + 1), (
            centre[0] + 1, centre[1] - 1), (centre[0], centre[1] + 1), (centre[0], centre[1] - 1)
        return covers(centre) and any(covers(p) for p in before if ahead(p) < ahead(centre))

    def ahead(p):
        return sum((p[i] - a[i]) * (b[i] - a[i]) for i in (0, 1))
    return covers_less


def edges(a, b, c, owns):
    """A triangle; `owns` says of which edges, by their direction with the inside to the left, a
    sample belongs to it."""
    area = rasterizer.side(a, b, c)
    turn = 1 if area > 0 else -1

    def covers(p):
        return area != 0 and all(
            (turn * rasterizer.side(q, r, p), owns(turn * (r[0] - q[0]), turn * (r[1] - q[1])))
            >= (0, True) for q, r in ((b, c), (c, a), (a, b)))
    return covers


def top_right(a, b, c):
    return edges(a, b, c, lambda dx, dy: dx < 0 or dx == 0 and dy > 0)


def shared_twice(a, b, c):
    return edges(a, b, c, lambda dx, dy: True)


def snapped(vertex, viewport, right=rasterizer.window):
    x, y, *rest = right(vertex, viewport)
    return [Fraction(round(n * 16), 16) for n in (x, y)] + rest


SPOILT = {"last-pixel": ("line", last_pixel), "leftward": ("line", leftward),
          "top-right": ("triangle", top_right), "shared-twice": ("triangle", shared_twice),
          "4-bits": ("window", snapped), "4-bits-for-8": ("window", snapped)}


def upside_down(reply, target, pixels=True, fragments=True):
    """What is told of pixels, and of samples, whose places within pixels stay."""
    width, height = target["width"], target["height"]
    if not pixels or not fragments:
        reply.pop("hits", None)
    for key, numbers in (("pixels", 4), ("sample_pixels", 4), ("depths", 1), ("stencils", 1),
                         ("hits", 1)):
        if pixels and key in reply:
            row = numbers * width
            rows = [reply[key][at:at + row] for at in range(0, len(reply[key]), row)]
            planes = [rows[at:at + height] for at in range(0, len(rows), height)]
            reply[key] = [n for plane in planes for line in reversed(plane) for n in line]
    for fragment in reply.get("fragments", []) if fragments else []:
        fragment["y"] = height - 1 - fragment["y"]
        if "coordinates" in fragment:
            fragment["coordinates"][1] = height - fragment["coordinates"][1]


def exchange(numbers):
    """Red and blue of each four numbers."""
    numbers[::4], numbers[2::4] = numbers[2::4], numbers[::4]


# What is done to the scene before it is drawn.

def clear_exchanged(scene):
    exchange(scene["target"]["clear"])


def cull(facing):
    def spoil(scene):
        for draw in scene["draws"]:
            draw.setdefault("cull", facing)
    return spoil


def first_provokes(scene):
    for draw in scene["draws"]:
        draw["provoking_vertex"] = "first"


BEFORE = {"first-vertex": first_provokes, "top-right": first_provokes,
          "bgr-clear": clear_exchanged, "nothing": lambda scene: scene.update(draws=[]),
          "no-clockwise": cull("back"), "no-counterclockwise": cull("front")}


# What is done to the answer, which is no refusal.

def exchanged(reply, target):
    for key in ("pixels", "sample_pixels"):
        exchange(reply.get(key, []))


def without_pixels(reply, target):
    for key in ("pixels", "sample_pixels"):
        if key in reply:
            reply[key] = fragment_operations.unorm(target["clear"]) * (len(reply[key]) // 4)


def without_fragments(reply, target):
    reply.pop("hits", None)
    reply["fragments"] = []


def early(*tests):
    """Whether a fragment passes is seen where it meets a buffer, once if there is one sample."""
    passes = []

    class Watched(fragment_operations.Buffers):
        def __init__(self, *arguments):
            super().__init__(*arguments)
            passes.clear()

        def meet(self, index, *rest):
            before = self.hits[index]
            super().meet(index, *rest)
            passes.append(self.hits[index] > before)

    def spoil(reply, target):
        if target["samples"] == 1 and any(test in target for test in tests):
            reply["fragments"] = [fragment for fragment, passed in zip(reply["fragments"], passes)
                                  if passed]
    spoil.buffers = Watched
    return spoil


AFTER = {"mirrored": upside_down, "bgr": exchanged, "no-pixels": without_pixels,
         "no-fragments": without_fragments, "early": early("depth", "stencil"),
         "early-depth": early("depth"),
         "pixels-mirrored": functools.partial(upside_down, fragments=False),
         "fragments-mirrored": functools.partial(upside_down, pixels=False)}


def main():
    (fault,) = sys.argv[1:]
    before, after = BEFORE.get(fault), AFTER.get(fault)
    if fault in SPOILT:
        setattr(rasterizer, *SPOILT[fault])
    if fault == "254":
        fragment_operations.unorm = lambda color: [
            int(n * 254.99) for n in fragment_operations.clamped(color)]
    rasterizer.Buffers = getattr(after, "buffers", rasterizer.Buffers)
    for request in map(json.loads, requests):
        reply = rasterizer.refusal(request)
        if not reply:
            if before:
                before(request["scene"])
            reply = rasterizer.answer(request["scene"])
        if after and "not_run" not in reply:
            after(reply, request["scene"]["target"])
        reply["digest"] = request["digest"]
        reply["renderer"] = {"device": fault, "subpixel_bits": SUBPIXEL_BITS.get(fault, 16)}
        print(json.dumps(reply), flush=True)


main()
