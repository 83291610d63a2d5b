# SPDX-License-Identifier: MIT
"""Renderers in other processes that interpolate or differentiate wrongly are told so, by rule and
cause; one that does neither is not."""
import shlex
import sys
import unittest

from support import AS_EXPECTED, HERE, UNEXPECTED, CommandTest, only_result

COLORS = [[0.875, 0.125, 0.25, 1], [0.25, 0.75, 0.5, 0.5], [0.5, 0.25, 1, 0.125],
          [0.125, 0.5, 0.75, 0.75]]
CORNERS = [[1.25, 1.5, -0.75, 1], [14.75, 2.25, 0.5, 4], [4.25, 14.75, 0.75, 16],
           [14.25, 13.75, 0.25, 2]]


def case(primitive, details=("coordinates", "derivatives"), **state):
    """Strong perspective, no sample on an edge, with all details."""
    vertices = [{"at": at, "color": color} for at, color in zip(CORNERS, COLORS)]
    of_kind = {"triangles": 3, "lines": 2}.get(primitive, 4)
    return {
        "title": "Values of a primitive",
        "rules": ["attribute.smooth"],
        "target": {"width": 16, "height": 16, "depth": "depth24"},
        "details": details,
        "draws": [{"primitive": primitive, "vertices": vertices[:of_kind], "state": state}],
    }


class ValueMutants(CommandTest):
    def run_fault(self, fault, expect, **draw):
        """The result of the one case, and the arguments that tell of it."""
        path = self.write("case.json", case(**draw))
        words = [sys.executable, "-B", str(HERE / "value_mutant.py"), fault]
        about = [path, "--against", "exec:" + " ".join(map(shlex.quote, words))]
        (of_case,) = self.results(*about, expect=expect)["cases"]
        return only_result(of_case), about

    def assert_told(self, fault, rule, cause, others=(), **draw):
        """A violation for which rule and cause are named, and nothing but `others` beside it."""
        result, about = self.run_fault(fault, UNEXPECTED, **draw)
        self.assertEqual(result["verdict"], "violation", result.get("failure"))
        found = {(d["rule"], d.get("cause", "")) for d in result["disagreements"]}
        self.assertEqual(found, {(rule, cause), *((other, cause) for other in others)})
        for d in result["disagreements"]:
            self.assertEqual((d["kind"], d["legality"]), ("value", "illegal"))
        self.assertIn(f"not allowed  {cause}", self.summary)
        x, y = next(d["pixel"] for d in result["disagreements"] if d["rule"] == rule)
        explained = self.command("explain", *about, "--pixel", f"{x},{y}", expect=None).stdout
        self.assertIn(f"value, {rule}, NOT allowed, cause {cause}", explained)

    def test_the_unspoilt_program_is_not_blamed(self):
        for draw in ({"primitive": "triangles", "interpolation": "smooth"},
                     {"primitive": "triangles", "interpolation": "noperspective"},
                     {"primitive": "triangle_strip", "interpolation": "flat"},
                     {"primitive": "lines", "interpolation": "smooth"},
                     {"primitive": "line_loop", "provoking_vertex": "first"}):
            with self.subTest(**draw):
                result, _ = self.run_fault("none", AS_EXPECTED, **draw)
                self.assertIn(result["verdict"], ("agree", "permitted"))
                self.assertEqual(result["disagreements"], [])

    def test_noperspective_for_smooth(self):
        for kind in "triangles", "lines":
            with self.subTest(kind):
                self.assert_told("noperspective", "attribute.smooth", "attribute.perspective=never",
                                 primitive=kind, details=["coordinates"], interpolation="smooth")
        # What follows from it is told with the same cause.
        self.assert_told("noperspective", "attribute.smooth", "attribute.perspective=never",
                         ["derivative.plain", "derivative.fine", "derivative.coarse"],
                         primitive="triangles", interpolation="smooth")

    def test_smooth_for_noperspective(self):
        self.assert_told("smooth", "attribute.smooth", "attribute.perspective=always",
                         ["derivative.plain", "derivative.fine", "derivative.coarse"],
                         primitive="triangles", interpolation="noperspective")

    def test_the_wrong_provoking_vertex(self):
        for asked, taken in ("first", "last"), ("last", "first"):
            for kind in ("triangles", "triangle_strip", "triangle_fan", "lines", "line_strip",
                         "line_loop"):
                with self.subTest(kind, asked=asked):
                    self.assert_told("provoking-vertex", "attribute.flat",
                                     f"attribute.provoking-vertex={taken}", primitive=kind,
                                     interpolation="flat", provoking_vertex=asked)

    def test_derivatives_across_the_wrong_row(self):
        self.assert_told("other-row", "derivative.fine", "derivative.fine=quad-other-row",
                         primitive="triangles", interpolation="smooth")

    def test_coarse_derivatives_for_fine_ones(self):
        self.assert_told("coarse", "derivative.fine", "derivative.fine=quad-coarse-bottom-left",
                         primitive="triangles", interpolation="smooth")


if __name__ == "__main__":
    unittest.main()
