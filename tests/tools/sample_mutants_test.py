# SPDX-License-Identifier: MIT
"""Renderers in other processes that multisample wrongly are told so, by exactly the rule and the
cause, however little they tell; one that does not is not; and what is no answer for the samples
that were asked for is never agreement."""
import itertools
import random
import shlex
import sys
import unittest

from suite_data import in_share
from support import (AS_EXPECTED, HERE, NOTHING_DRAWN, RENDERER, UNEXPECTED, CommandTest,
                     only_result)

SIZE = 16
# What a renderer need not tell; its resolved pixels are judged by the rest.
UNTOLD = ([], ["sample_pixels"], ["hits"], ["sample_pixels", "hits"])


def case(samples=4, alphas=(1, 1), target=(), **state):
    """Four triangles that cover pixels in part, on all sides, and no sample on an edge; every other
    one has the second alpha."""
    chance = random.Random(20)
    vertices = [{"at": [chance.randrange(32, 32 * (SIZE - 1)) / 32 for _ in "xy"]
                 + [(i % 5 - 2) * 0.375, 1],
                 "color": [float(i % 3 == 0), float(i % 3 == 1), i / 16, alphas[i // 3 % 2]]}
                for i in range(12)]
    return {"title": "Four triangles", "rules": ["sample.positions"],
            "target": {"width": SIZE, "height": SIZE, "samples": samples, **dict(target)},
            "draws": [{"primitive": "triangles", "vertices": vertices,
                       "state": {"interpolation": "smooth", **state}}]}


CENTROID = case(attribute_location="centroid")
THINNED = case(alpha_to_coverage=True)
PER_SAMPLE = {"by share": case(min_sample_shading=1),
              "by qualifier": case(attribute_location="sample")}


class SampleMutants(CommandTest):
    def against(self, fault, *omitted):
        words = [sys.executable, "-B", str(HERE / "sample_mutant.py"), fault, *omitted]
        return "exec:" + " ".join(map(shlex.quote, words))

    def run_fault(self, fault, of_case, expect, *omitted):
        about = [self.write("case.json", of_case), "--against", self.against(fault, *omitted)]
        (found,) = self.results(*about, expect=expect)["cases"]
        return only_result(found)

    def assert_told(self, fault, of_case, told, *omitted):
        """A violation, and every disagreement that is one is one of `told`: (rule, cause)."""
        result = self.run_fault(fault, of_case, UNEXPECTED, *omitted)
        self.assertEqual(result["verdict"], "violation", result.get("failure"))
        self.assertEqual({(d["rule"], d["cause"]) for d in result["disagreements"]}, told)
        return result

    def results_of_unspoilt(self, cases, *omitted):
        """Of the unspoilt program, each of the cases with each of UNTOLD left out, too: one run, a
        renderer for each."""
        for number, of_case in enumerate(cases):
            self.write(f"cases/{number}.json", of_case)
        words = [w for untold in UNTOLD
                 for w in ("--against", self.against("none", *omitted, *untold))]
        found = self.results("cases", *words, expect=None)["cases"]
        results = [result for of_case in found for result in of_case["results"].values()]
        self.assertEqual(len(results), len(cases) * len(UNTOLD))
        return results

    def test_the_unspoilt_program_is_not_blamed(self):
        cases = [CENTROID, THINNED, case(sample_mask=5), case(target={"depth": "depth32f"}),
                 case(multisample=False), *PER_SAMPLE.values(), *map(case, (2, 3, 8, 16))]
        for result in self.results_of_unspoilt(in_share(cases)):
            self.assertEqual(result["disagreements"], [])
            self.assertEqual(result["verdict"], "agree")

    def test_a_renderer_that_tells_no_colours_is_not_blamed(self):
        for result in self.results_of_unspoilt([CENTROID, THINNED, *PER_SAMPLE.values()], "color"):
            self.assertEqual(result["disagreements"], [])

    def check_swaps(self, samples, pairs):
        """All in one run, a renderer for each pair."""
        swaps = [f"swapped-{i}-{j}" for i, j in pairs]
        words = [w for swap in swaps for w in ("--against", self.against(swap))]
        path = self.write("case.json", case(samples))
        (found,) = self.results(path, *words)["cases"]
        self.assertEqual(len(found["results"]), len(swaps))
        for swap, result in zip(swaps, found["results"].values()):
            with self.subTest(swap):
                self.assertEqual(result["verdict"], "contested", result.get("failure"))
                self.assertEqual({(d["rule"], d["cause"]) for d in result["disagreements"]},
                                 {("triangle.fill-rule", "sample.positions=swapped")})

    def test_a_swapped_pair_of_four(self):
        self.check_swaps(4, itertools.combinations(range(4), 2))

    def test_a_swapped_pair_of_eight(self):
        self.check_swaps(8, in_share(itertools.combinations(range(8), 2)))

    def test_a_mirrored_pattern(self):
        for fault in "mirrored-x", "mirrored-y", "turned":
            for samples in 4, *in_share((8, 16)):
                with self.subTest(fault, samples=samples):
                    result = self.run_fault(fault, case(samples), None)
                    self.assertIn(result["verdict"], {"contested", "violation"})
                    self.assertEqual({(d["rule"], d["cause"]) for d in result["disagreements"]},
                                     {("triangle.fill-rule", f"sample.positions={fault}")})

    def test_a_resolve_that_truncates(self):
        """Which the specification leaves open: a convention, told by name."""
        for omitted in UNTOLD:
            with self.subTest(omitted=omitted):
                result = self.run_fault("truncated", case(), AS_EXPECTED, *omitted)
                self.assertEqual(result["verdict"], "convention")
                self.assertEqual(result["disagreements"], [])
                self.assertEqual({(v["rule"], v["cause"]) for v in result["values"]},
                                 {("sample.resolve", "sample.resolve=truncated")})

    def test_a_resolve_with_a_wrong_weight(self):
        for omitted in (*UNTOLD, ["sample_pixels", "hits", "color"]):
            with self.subTest(omitted=omitted):
                # Beyond its samples, by more than anybody accepts (ruling 51).
                result = self.run_fault("one-more", case(), UNEXPECTED, *omitted)
                self.assertEqual(result["verdict"], "violation", result.get("failure"))
                self.assertEqual({(d["rule"], d["cause"]) for d in result["disagreements"]},
                                 {("sample.resolve", "")})
                # Between the samples, but nobody's mean.
                result = self.run_fault("twice-the-first", case(), AS_EXPECTED, *omitted)
                self.assertEqual(result["verdict"], "permitted")
                self.assertEqual({(v["rule"], v.get("cause", "")) for v in result["values"]},
                                 {("sample.resolve", "")})

    def test_a_centroid_at_the_centre(self):
        cause = "attribute.centroid=centre"
        result = self.assert_told("centroid-at-centre", CENTROID, {("attribute.centroid", cause)})
        self.assertEqual({v["cause"] for v in result["values"]}, {cause})

    def test_an_ignored_mask(self):
        self.assert_told("mask-ignored", case(sample_mask=5),
                         {("sample.mask", "sample.mask=ignored")})

    def test_inverted_alpha_to_coverage(self):
        for omitted in UNTOLD:
            with self.subTest(omitted=omitted):
                self.assert_told("alpha-inverted", case(alphas=(0, 1), alpha_to_coverage=True),
                                 {("sample.alpha-to-coverage", "")}, *omitted)

    def test_one_invocation_where_each_sample_needs_one(self):
        for name, of_case in PER_SAMPLE.items():
            with self.subTest(name):
                rule = "sample.shading-rate"
                self.assert_told("once-per-pixel", of_case, {(rule, f"{rule}=per-pixel")})

    def test_depths_of_the_centre(self):
        self.assert_told("depth-at-centre", case(target={"depth": "depth32f"}),
                         {("sample.depth", "sample.depth=centre")})

    def assert_refused(self, fault, of_case, reason, *omitted):
        result = self.run_fault(fault, of_case, RENDERER, *omitted)
        self.assertEqual((result["verdict"], result["failure"]["kind"]), ("not-run", "garbage"))
        self.assertIn(reason, result["failure"]["reason"])

    def test_four_samples_where_two_were_asked_for(self):
        for told, untold in (("hits", []), ("sample_positions", ["hits"]),
                             ("sample_pixels", ["hits", "sample_positions"])):
            self.assert_refused("four-for-two", case(2), f"/{told} must have ", *untold)
        # One that tells nothing of all that draws something else.
        everything = ["hits", "sample_positions", "sample_pixels"]
        # Nor how many points decide on coverage (14.3.1, ruling 47).
        result = self.run_fault("four-for-two", case(2), AS_EXPECTED, *everything)
        self.assertEqual(result["verdict"], "contested", result.get("failure"))

    def test_samples_that_are_ignored(self):
        self.assert_refused("one-sample", case(), "/hits must have 1024 elements, but it has 256")
        self.assert_refused("one-sample", case(), "no \"coverage\", and the target has several",
                            "hits", "coverage")
        # How many points decide on coverage is not told (14.3.1).
        result = self.run_fault("one-sample", case(), AS_EXPECTED, "hits")
        self.assertEqual(result["verdict"], "contested", result.get("failure"))

    def test_samples_that_are_refused(self):
        result = self.run_fault("refused", case(), NOTHING_DRAWN)
        self.assertEqual(result["verdict"], "not-run")
        self.assertEqual(result["failure"], {"kind": "unsupported",
                                             "reason": "one sample per pixel is all there is"})
        # Of one sample it draws.
        self.assertEqual(self.run_fault("refused", case(1), AS_EXPECTED)["verdict"], "agree")


if __name__ == "__main__":
    unittest.main()
