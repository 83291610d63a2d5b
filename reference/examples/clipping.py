# SPDX-License-Identifier: MIT
"""Lines and triangles that leave the clip volume, for rasterizer.py, by OpenGL 4.6 (core), 13.7.
Lines are cut, and triangles are drawn without cutting them.

A vertex outside need not have a position in the window, since its w may be 0 or less. But every
point (x, y) is a sum of shares b of the three vertices, (x, y, 1) = sum of b (X, Y, W), with X = w
times the vertex's x in the window. The triangle covers it if all shares are positive.
"""
from fractions import Fraction


def is_outside(vertex):
    """13.7: whether -w <= x, y, z <= w does not hold."""
    x, y, z, w = vertex.get("clip", (0, 0, 0, 1))
    return not (w > 0 and max(map(abs, (x, y, z))) <= w)


def clip_of(vertex, viewport):
    """The clip coordinates x, y, z and w of a vertex in either form."""
    if "clip" in vertex:
        return [Fraction(n) for n in vertex["clip"]]
    x, y, z = map(Fraction, vertex["position"])
    w, (left, bottom, wide, high) = Fraction(vertex.get("w", 1)), viewport
    return [(2 * (x - left) / wide - 1) * w, (2 * (y - bottom) / high - 1) * w, z * w, w]


def cut_line(vertices, viewport):
    """The two ends of the part inside the volume, each with its fraction of the way to the second
    vertex and its clip coordinates; none if nothing is inside."""
    a, b = (clip_of(vertex, viewport) for vertex in vertices)
    enter, leave = Fraction(0), Fraction(1)
    for i in range(3):
        for sign in 1, -1:
            start, end = (n[3] + sign * n[i] for n in (a, b))
            if start < 0 and end < 0:
                return None
            if start < 0:
                enter = max(enter, start / (start - end))
            elif end < 0:
                leave = min(leave, start / (start - end))
    if enter >= leave:
        return None
    ends = [(t, [m + (n - m) * t for m, n in zip(a, b)]) for t in (enter, leave)]
    return ends if all(clip[3] > 0 for _, clip in ends) else None


class ClippedTriangle:
    def __init__(self, vertices, viewport):
        self.rows = [self.row(vertex, viewport) for vertex in vertices]
        a, b, c = self.rows
        self.planes = [[q[1] * r[3] - q[3] * r[1], q[3] * r[0] - q[0] * r[3],
                        q[0] * r[1] - q[1] * r[0]] for q, r in ((b, c), (c, a), (a, b))]
        nx, ny, nw = self.planes[0]
        self.area = nx * a[0] + ny * a[1] + nw * a[3]

    @staticmethod
    def row(vertex, viewport):
        """Window x, y and z, each times w, and w."""
        left, bottom, wide, high = viewport
        if "clip" not in vertex:
            w = Fraction(vertex.get("w", 1))
            return [Fraction(n) * w for n in vertex["position"]] + [w]
        x, y, z, w = map(Fraction, vertex["clip"])
        return [left * w + wide * (x + w) / 2, bottom * w + high * (y + w) / 2, z, w]

    def shares(self, p):
        return [(nx * p[0] + ny * p[1] + nw) / self.area for nx, ny, nw in self.planes]

    def covers(self, p):
        """As for triangles in rasterizer.py: a point on an edge is moved by (e, -e^2)."""
        if self.area == 0:
            return False
        shares = self.shares(p)
        inside = all((share, nx / self.area, -ny / self.area) > (0, 0, 0)
                     for share, (nx, ny, _) in zip(shares, self.planes))
        return inside and -1 <= sum(b * row[2] for b, row in zip(shares, self.rows)) <= 1

    def window_weights(self, p):
        """The weights of values that are linear in the window."""
        return [b * row[3] for b, row in zip(self.shares(p), self.rows)]

    def depth(self, p):
        """z/w, and 1/w."""
        shares = self.shares(p)
        return sum(b * row[2] for b, row in zip(shares, self.rows)), sum(shares)

    def perspective_weights(self, p):
        shares = self.shares(p)
        return [b / sum(shares) for b in shares]
