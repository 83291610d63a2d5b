# SPDX-License-Identifier: MIT
"""Polygon offset for rasterizer.py, by OpenGL 4.6 (core), 14.6.5."""
import math
from fractions import Fraction

from fragment_operations import stored


def slope(across, up):
    """m: the steepness of a depth that grows by these amounts per pixel in x and in y. The root is
    not a fraction, but the error is smaller than any answer can show."""
    return Fraction(math.hypot(across, up))


def unit(kind, largest):
    """r: for an unsigned buffer the difference of neighbouring values; for floats it depends on the
    exponent of the triangle's largest depth."""
    if kind == "depth32f":
        return Fraction(2) ** (max(math.frexp(stored(largest, kind))[1] - 1, -126) - 23)
    return Fraction(1, 2 ** {"depth16": 16, "depth24": 24}[kind] - 1) if kind else Fraction(0)


def offset(use, depth_at, corners, kind):
    """The offset of the depth of a triangle's fragments. `depth_at` gives the depth of the
    triangle's plane at any point of the window; `kind` is the depth buffer's format."""
    start, right, above = map(depth_at, ((0, 0), (1, 0), (0, 1)))
    largest = max(depth_at(corner[:2]) for corner in corners)
    added = (Fraction(use["factor"]) * slope(right - start, above - start)
             + Fraction(use["units"]) * unit(kind, largest))
    clamp = Fraction(use["clamp"])
    return added if clamp == 0 else min(added, clamp) if clamp > 0 else max(added, clamp)
