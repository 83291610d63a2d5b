# SPDX-License-Identifier: MIT
"""Polygon offset for rasterizer.py, as OpenGL 4.6 (core) has it in 14.6.5."""
import math
from fractions import Fraction

from fragment_operations import stored


def slope(across, up):
    """m: how steep a depth is that grows so much by a pixel in x and in y. A root is no fraction:
    this one is nearer to it than any answer tells."""
    return Fraction(math.hypot(across, up))


def unit(kind, largest):
    """r: of an unsigned buffer the difference of neighbouring values; of floats by the exponent of
    a triangle's largest depth."""
    if kind == "depth32f":
        return Fraction(2) ** (max(math.frexp(stored(largest, kind))[1] - 1, -126) - 23)
    return Fraction(1, 2 ** {"depth16": 16, "depth24": 24}[kind] - 1) if kind else Fraction(0)


def offset(use, depth_at, corners, kind):
    """What is added to the depth of a triangle's fragments. `depth_at` knows the depth of any place
    of the window in the triangle's plane, `kind` is the depth buffer's."""
    start, right, above = map(depth_at, ((0, 0), (1, 0), (0, 1)))
    largest = max(depth_at(corner[:2]) for corner in corners)
    added = (Fraction(use["factor"]) * slope(right - start, above - start)
             + Fraction(use["units"]) * unit(kind, largest))
    clamp = Fraction(use["clamp"])
    return added if clamp == 0 else min(added, clamp) if clamp > 0 else max(added, clamp)
