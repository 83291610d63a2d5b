#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes torus-knot.obj: a tube round the (2, 3) torus knot, in a ball of radius 1.

The tube's centre runs at angle t through R(t) (cos 2t, sin 2t, 0) + (0, 0, -sin 3t), with
R(t) = 2 + cos 3t. Its sections are circles across that curve, so a section's spokes are the
surface's normals. These are baked into the vertices' colours, as (normal + 1) / 2.

Texture coordinates run from 0 to 24 along the knot and from 0 to 2 round the tube, in quarters and
eighths, so that repeated images are nearly square on it and meet without a seam. Triangles wind
counterclockwise as seen from outside.

  python3 cases/meshes/torus_knot.py > cases/meshes/torus-knot.obj
"""
import math

ALONG = 96         # sections
ROUND = 16         # corners of a section
TUBE = 0.45        # radius of the tube, before all is made smaller
SCALE = 1 / (3 + TUBE)


def normalized(v):
    length = math.sqrt(sum(c * c for c in v))
    return [c / length for c in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def centre(t):
    radius = 2 + math.cos(3 * t)
    return [radius * math.cos(2 * t), radius * math.sin(2 * t), -math.sin(3 * t)]


def direction(t):
    radius = 2 + math.cos(3 * t)
    grows = -3 * math.sin(3 * t)
    return normalized([grows * math.cos(2 * t) - 2 * radius * math.sin(2 * t),
                       grows * math.sin(2 * t) + 2 * radius * math.cos(2 * t),
                       -3 * math.cos(3 * t)])


def corner(i, j):
    """Position and outward normal of corner j of section i."""
    t = 2 * math.pi * i / ALONG
    angle = 2 * math.pi * j / ROUND
    middle = centre(t)
    binormal = normalized(cross(direction(t), middle))
    spoke = cross(binormal, direction(t))
    normal = [math.cos(angle) * s + math.sin(angle) * b for s, b in zip(spoke, binormal)]
    return [SCALE * (m + TUBE * n) for m, n in zip(middle, normal)], normal


def numbers(values, digits):
    # Zero is written without its sign, which differs between libraries of mathematics.
    return " ".join(f"{round(v, digits) + 0.0:.{digits}f}".rstrip("0").rstrip(".") for v in values)


def main():
    print(f"# A tube of {ALONG} sections of {ROUND} corners round the (2, 3) torus knot, with its normals as\n"
          "# colours and texture coordinates; torus_knot.py writes it.\n"
          f"# {2 * ALONG * ROUND:,} triangles.\n"
          "# SPDX-License-Identifier: MIT\n"
          "o torus-knot")
    for i in range(ALONG):
        for j in range(ROUND):
            position, normal = corner(i, j)
            print("v", numbers(position, 5), numbers([(n + 1) / 2 for n in normal], 3))
    for i in range(ALONG + 1):
        for j in range(ROUND + 1):
            print("vt", numbers([i / 4, j / 8], 3))
    for i in range(ALONG):
        for j in range(ROUND):
            def index(di, dj):
                place = (i + di) % ALONG * ROUND + (j + dj) % ROUND
                coordinates = (i + di) * (ROUND + 1) + j + dj
                return f"{place + 1}/{coordinates + 1}"
            print("f", index(0, 0), index(0, 1), index(1, 1))
            print("f", index(0, 0), index(1, 1), index(1, 0))


if __name__ == "__main__":
    main()
