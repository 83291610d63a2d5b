# SPDX-License-Identifier: MIT
"""Renderers in other processes that do something else with their fragments than is asked for are
told so, over cases of the suite, by the rule; one that does not is not."""
import collections
import shlex
import sys
import unittest

from support import AS_EXPECTED, HERE, SUITE, UNEXPECTED, CommandTest, only_result

FOLDER = f"{SUITE}/output"
# What each fault is held against.
CASES = {
    "less-for-lequal": ["depth/every-function", "depth/the-same-triangle-twice"],
    "depth-inverted": ["depth/every-function", "depth/the-same-triangle-twice"],
    "depth-write-on": ["depth/write-off", "depth/a-state-in-one-word"],
    "clear-depth-1": ["depth/clear-value"],
    "straight-alpha": ["order/premultiplied-is-associative", "blending/equations"],
    "truncated": ["blending/half-of-every-code", "blending/constant-colour"],
    "wrap": ["stencil/saturate-and-wrap"],
    "saturate": ["stencil/saturate-and-wrap"],
    "unmasked": ["stencil/read-mask"],
    "reference-unmasked": ["stencil/read-mask"],
    "red-for-blue": ["blending/colour-mask"],
    "front-for-back": ["culling/strip", "culling/at-samples"],
    "face-inverted": ["culling/strip", "culling/at-samples", "stencil/each-face"],
    "sum-of-partials": ["offset/slope-diagonal"],
    "colourless": ["depth/without-colour"],
    "back-wraps": ["stencil/back-faces-stop"],
    "replace-masked": ["stencil/replace-whole-reference"],
    "mask-drops": ["order/premultiplied-is-associative"],
    "float-unit": ["offset/units"],
}
MOST = 60  # cases for a fault


class OutputMutants(CommandTest):
    def against(self, fault):
        words = [sys.executable, "-B", str(HERE / "output_mutant.py"), fault]
        return "exec:" + " ".join(map(shlex.quote, words))

    def selection(self, names):
        """Some of the cases of these files, spread over all of them."""
        paths = [f"{FOLDER}/{name}.json" for name in names]
        listed = self.command("run", *paths, "--list").stdout.split()
        return [*paths, "--sample", f"1/{-(-len(listed) // MOST)}"]

    def judged(self, fault, expect=UNEXPECTED):
        cases = self.results(*self.selection(CASES[fault]), "--against", self.against(fault),
                             expect=expect)["cases"]
        return [only_result(case) for case in cases]

    def assert_convicted(self, fault, least, *rules, causes):
        """Of so many cases at least, whatever is not allowed breaks one of the rules, and most of
        it is said to be by one of the causes."""
        found = collections.Counter()
        results = self.judged(fault)
        for result in results:
            broken = {(d["rule"], d["cause"]) for d in result["disagreements"] if d["legality"] != "legal"}
            self.assertEqual(bool(broken), result["verdict"] == "violation")
            found.update(broken)
        self.assertEqual({rule for rule, _ in found}, set(rules), found)
        self.assertIn(found.most_common(1)[0][0][1], causes, found)
        convicted = sum(result["verdict"] == "violation" for result in results)
        self.assertGreaterEqual(convicted, least, found)
        return found

    def test_the_unspoilt_program_is_not_blamed(self):
        names = sorted({name for names in CASES.values() for name in names})
        cases = self.results(*self.selection(names), "--against", self.against("none"),
                             expect=AS_EXPECTED)["cases"]
        self.assertGreaterEqual(len(cases), MOST - len(CASES))
        for case in cases:
            self.assertEqual(only_result(case)["verdict"], "agree", case["id"])

    def test_depth_tests(self):
        found = self.assert_convicted("less-for-lequal", 3, "depth.test",
                                      causes={"depth.test=ties-fail"})
        self.assertEqual({cause for _, cause in found}, {"depth.test=ties-fail"})
        self.assert_convicted("depth-inverted", 10, "depth.test",
                              causes={"", "depth.test=ignored"})

    def test_depths_that_are_written_or_not(self):
        found = self.assert_convicted("depth-write-on", 3, "depth.mask",
                                      causes={"depth.mask=ignored"})
        self.assertEqual({cause for _, cause in found}, {"depth.mask=ignored"})
        # Where something is drawn, the fragments meet another depth.
        self.assert_convicted("clear-depth-1", 10, "framebuffer.depth", "depth.test",
                              causes={"", "depth.test=ignored"})

    def test_factors_of_blending(self):
        self.assert_convicted("straight-alpha", 5, "blend.equation",
                              causes={"blend.equation=over-as-straight"})

    def test_a_blended_colour_that_is_cut_off_is_permitted(self):
        """By ruling 37: with a precision of 8 bits it may come out so."""
        results = self.judged("truncated", expect=AS_EXPECTED)
        verdicts = collections.Counter(result["verdict"] for result in results)
        self.assertGreater(verdicts["permitted"] + verdicts["convention"], 10)
        self.assertNotIn("violation", verdicts)
        self.assertEqual({values["rule"] for result in results for values in result["values"]},
                         {"blend.rounding"})

    def test_stencil_operations(self):
        for fault, cause in ("wrap", "wrapping"), ("saturate", "saturating"):
            self.assert_convicted(fault, 3, "stencil.test", causes={f"stencil.test={cause}"})

    def test_a_depth_test_that_is_skipped_where_no_colour_is_written(self):
        self.assert_convicted("colourless", 10, "depth.test", causes={"", "depth.test=ignored"})

    def test_back_faces_that_wrap(self):
        self.assert_convicted("back-wraps", 2, "stencil.test", causes={"stencil.test=wrapping"})

    def test_a_reference_that_is_masked_before_it_is_stored(self):
        self.assert_convicted("replace-masked", 20, "stencil.test", causes={""})

    def test_a_stencil_reference_without_its_mask(self):
        unmasked = "stencil.test=unmasked"
        self.assert_convicted("unmasked", 5, "stencil.test", causes={unmasked})
        self.assert_convicted("reference-unmasked", 5, "stencil.test", causes={unmasked, ""})

    def test_a_colour_mask_in_another_order(self):
        self.assert_convicted("red-for-blue", 5, "color.mask", causes={"", "color.mask=ignored"})

    def test_facing(self):
        reversed_facing = {"polygon.facing=reversed"}
        self.assert_convicted("front-for-back", 10, "polygon.facing", causes=reversed_facing)
        # One case alone does not always tell the wrong face from a test of one face or of none.
        self.assert_convicted("face-inverted", 10, "polygon.facing", "stencil.test",
                              causes=reversed_facing)

    def test_the_slope_of_a_polygon_offset(self):
        self.assert_convicted("sum-of-partials", 15, "offset.slope",
                              causes={"offset.slope=sum-of-partials"})


if __name__ == "__main__":
    unittest.main()
