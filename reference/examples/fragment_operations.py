# SPDX-License-Identifier: MIT
"""Fragment operations for rasterizer.py: stencil test, depth test, blending and colour mask, by
OpenGL 4.6 (core), chapter 17.

Numbers are fractions until they are stored. A stored colour is four codes of 0 to 255.
"""
import operator
import struct
from fractions import Fraction


def stored(depth, kind):
    """A depth as a depth buffer stores it: a multiple of 1/(2^bits - 1), or a float32."""
    depth = min(max(depth, Fraction(0)), Fraction(1))
    if kind == "depth32f":
        return struct.unpack("f", struct.pack("f", depth))[0]
    most = 2 ** {"depth16": 16, "depth24": 24}[kind] - 1
    return round(depth * most) / most


def clamped(color):
    return [min(max(Fraction(n), 0), 1) for n in color]


def unorm(color):
    return [round(255 * n) for n in clamped(color)]


# 17.3.3 and 17.3.4: comparisons of a reference or a depth with the stored value.
COMPARISONS = {"never": lambda a, b: False, "less": operator.lt, "equal": operator.eq,
               "lequal": operator.le, "greater": operator.gt, "notequal": operator.ne,
               "gequal": operator.ge, "always": lambda a, b: True}
# 17.3.3: the new stencil value.
STENCIL_OPERATIONS = {
    "keep": lambda s, reference: s, "zero": lambda s, reference: 0,
    "replace": lambda s, reference: reference, "invert": lambda s, reference: ~s & 255,
    "incr": lambda s, reference: min(s + 1, 255), "incr_wrap": lambda s, reference: s + 1 & 255,
    "decr": lambda s, reference: max(s - 1, 0), "decr_wrap": lambda s, reference: s - 1 & 255}
EQUATIONS = {"add": operator.add, "subtract": operator.sub,
             "reverse_subtract": lambda s, d: d - s, "min": min, "max": max}


def factors(name, source, destination, constant):
    """Table 17.2: the factors for red, green, blue and alpha."""
    if name in ("zero", "one"):
        return [int(name == "one")] * 4
    if name == "src_alpha_saturate":
        return [min(source[3], 1 - destination[3])] * 3 + [1]
    plain = name.removeprefix("one_minus_")
    color = {"src": source, "dst": destination, "constant": constant}[plain.split("_")[0]]
    values = color if plain.endswith("color") else color[3:] * 4
    return values if plain == name else [1 - n for n in values]


def blended(use, source, destination):
    """17.3.6, for colours from 0 to 1."""
    result, colors = [], (source, destination, [Fraction(n) for n in use["constant"]])
    for i in range(4):
        term = use["color" if i < 3 else "alpha"]
        parts = [source[i], destination[i]]
        if term["equation"] not in ("min", "max"):
            parts = [part * factors(term[key], *colors)[i]
                     for key, part in zip(("source", "destination"), parts)]
        result.append(EQUATIONS[term["equation"]](*parts))
    return result


class Buffers:
    """The target's contents: a plane for each sample, one after the other."""

    def __init__(self, target, size):
        self.kind = target.get("depth")
        self.colors, self.hits = [unorm(target["clear"])] * size, [0] * size
        self.stencils = [target.get("clear_stencil", 0)] * size if "stencil" in target else []
        cleared = Fraction(target.get("clear_depth", 1))
        self.depths = [stored(cleared, self.kind)] * size if self.kind else []

    def meet(self, index, drawn, color, depth):
        """17.3: the effect of a fragment on a sample. Without its buffer a test passes."""
        test = drawn.draw.get("depth", {"test": "always", "write": True})
        face = drawn.draw.get("stencil", {}).get(drawn.face) if self.stencils else None
        outcome = "pass"
        if self.depths and not COMPARISONS[test["test"]](depth, self.depths[index]):
            outcome = "depth_fail"
        if face:
            old, new, bits = self.stencils[index], face["reference"], face["read_mask"]
            if not COMPARISONS[face["test"]](new & bits, old & bits):
                outcome = "fail"
            after = STENCIL_OPERATIONS[face[outcome]](old, new)
            self.stencils[index] = old ^ (old ^ after) & face["write_mask"]
        if outcome != "pass":
            return
        self.hits[index] += 1
        if self.depths and test["write"]:
            self.depths[index] = depth
        before = self.colors[index]
        if "blend" in drawn.draw:
            color = blended(drawn.draw["blend"], clamped(color), [Fraction(n, 255) for n in before])
        mask = drawn.draw.get("color_mask", [True] * 4)
        self.colors[index] = [n if kept else b for n, kept, b in zip(unorm(color), mask, before)]
