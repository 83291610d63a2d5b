# SPDX-License-Identifier: MIT
"""Renderers in other processes that look textures up wrongly are told so, by exactly the rule and
the cause; one that does neither is not."""
import math
import shlex
import sys
import unittest

from support import AS_EXPECTED, HERE, SUITE, UNEXPECTED, CommandTest, only_result

LINEAR = {"magnify": "linear", "minify": "linear", "mipmap": "linear"}
NEAREST = {"magnify": "nearest", "minify": "nearest", "mipmap": "nearest"}
SIZE = 16


def rounded(value):
    """To what float32 and the window's grid hold."""
    return round(value * 256) / 256


def quad(spans, turn, diagonal):
    """Corners of two triangles: a square turned about the middle, and where it shows the texture.
    `spans`: how much of it along either side; of its diagonals, where that is asked for."""
    corners = []
    for u, v in (0, 0), (1, 0), (1, 1), (0, 1):
        x, y = (u - .5) * SIZE, (v - .5) * SIZE
        at = [rounded(SIZE / 2 + x * math.cos(turn) - y * math.sin(turn)),
              rounded(SIZE / 2 + x * math.sin(turn) + y * math.cos(turn))]
        s, t = u * spans[0], v * spans[1]
        corners.append({"at": at, "uv": [rounded(n) for n in ([s + t, s - t] if diagonal else [s, t])]})
    return [corners[i] for i in (0, 1, 2, 0, 2, 3)]


def case(spans, sampler, turn=0.0, diagonal=False, **texture):
    texture = {"size": [16, 16], "format": "rgba32f", "noise": {"seed": 5}, "mipmaps": "box",
               **texture}
    texture = {key: value for key, value in texture.items() if value is not None}
    return {"title": "Lookups in a quad", "rules": ["texture.filter"],
            "target": {"width": SIZE, "height": SIZE}, "textures": [texture],
            "draws": [{"primitive": "triangles", "vertices": quad(spans, turn, diagonal),
                       "state": {"interpolation": "smooth", "texture": 0, "sampler": sampler}}]}


# Sixteen texels to the texture: so many of them to a pixel.
CASES = {
    "minified": case([3, 3], LINEAR),
    "minified along x": case([3, .125], LINEAR),
    "minified along y": case([.125, 5], LINEAR),
    "magnified": case([.3, .2], LINEAR),
    "nearest": case([3.3, .2], NEAREST),
    "turned": case([3.075, .25], LINEAR, turn=1.1),
    "codes": case([3, .25], LINEAR, format="rgba8"),
    "mirrored": case([3.3, 2.7], {**LINEAR, "wrap": "mirrored-repeat"}),
    # Two texels to a pixel in s and in t: the vector's length is the root of 8, its logarithm 3/2.
    "ties": case([2, .125], LINEAR, diagonal=True),
    "generated": case([2.9, .3], LINEAR, mipmaps="generated"),
    "generated codes": case([2.9, .3], LINEAR, mipmaps="generated", format="rgba8"),
    "generated white": case([2.9, .3], LINEAR, mipmaps="generated", format="rgba8", noise=None,
                            checker={"colors": [[1, 1, 1], [1, 1, 1]]}),
}


class TextureMutants(CommandTest):
    def against(self, fault):
        words = [sys.executable, "-B", str(HERE / "texture_mutant.py"), fault]
        return "exec:" + " ".join(map(shlex.quote, words))

    def run_fault(self, fault, name, expect):
        path = self.write("case.json", CASES[name])
        (of_case,) = self.results(path, "--against", self.against(fault), expect=expect)["cases"]
        return only_result(of_case)

    def assert_told(self, fault, name, rule, cause):
        """A violation, and every disagreement that is one names this rule and this cause."""
        result = self.run_fault(fault, name, UNEXPECTED)
        self.assertEqual(result["verdict"], "violation", result.get("failure"))
        found = {(d["rule"], d.get("cause", "")) for d in result["disagreements"]}
        self.assertEqual(found, {(rule, cause)}, name)
        for d in result["disagreements"]:
            self.assertEqual(d["kind"], "value")
            # What is off by less is contested.
            self.assertIn((d["legality"], d["ruling"] == 50), (("illegal", False), ("contested", True)))
        self.assertIn(f"not allowed  {cause or rule}", self.summary)

    def test_the_unspoilt_program_is_not_blamed(self):
        for name, case_of_name in CASES.items():
            self.write(f"cases/{name.replace(' ', '-')}.json", case_of_name)
        results = self.results("cases", "--against", self.against("none"), expect=AS_EXPECTED)
        self.assertEqual(len(results["cases"]), len(CASES))
        for of_case in results["cases"]:
            with self.subTest(of_case["id"]):
                result = only_result(of_case)
                self.assertIn(result["verdict"], ("agree", "permitted"))
                self.assertEqual(result["disagreements"], [])

    def test_a_level_of_detail_from_dx_alone(self):
        for name in "minified along y", "turned":
            with self.subTest(name):
                self.assert_told("x-only", name, "texture.scale-factor",
                                 "texture.scale-factor=x-only")

    def test_half_a_level_of_bias(self):
        """By 8.14.1 the scale factor may be the root of 2 times the longer vector, as long as that is
        along an axis of the texture: half a level more shows where none of that is left."""
        for name in "minified along x", "codes":
            with self.subTest(name):
                self.assertEqual(self.rulings_on("half-bias", name), set())
                self.assertEqual(self.rulings_on("most-bias", name), {50})
                self.assertIn(19, self.rulings_on("more-bias", name))

    def test_half_a_level_off_at_every_tie(self):
        self.assert_told("ties", "ties", "texture.level-weight", "texture.level-weight=one-at-ties")

    def test_weights_between_levels_in_eighths(self):
        for name in "minified", "minified along y", "turned":
            with self.subTest(name):
                self.assert_told("floor-3", name, "texture.level-weight",
                                 "texture.level-weight=floor-3")
                # To the nearest eighth is never off by more than a 16th, as 4 bits are.
                self.assertEqual(self.rulings_on("nearest-3", name), {50})

    def test_mirrored_repetition_that_repeats(self):
        self.assert_told("repeat", "mirrored", "texture.wrap", "texture.wrap=mirrored-as-repeat")

    def rulings_on(self, fault, name):
        path = self.write("case.json", CASES[name])
        (of_case,) = self.results(path, "--against", self.against(fault), expect=None)["cases"]
        return {d["ruling"] for d in only_result(of_case)["disagreements"] if d["legality"] != "legal"}

    def test_no_fault_is_found_within_the_bounds(self):
        for fault in "floor-6", "nearest-6", "length-of-both", "short-logarithm":
            for name in "minified", "minified along x", "minified along y", "turned", "codes":
                with self.subTest(name, fault=fault):
                    self.assertEqual(self.rulings_on(fault, name), set())

    def test_what_is_coarser_is_contested(self):
        for fault in "floor-5", "shorter-logarithm":
            with self.subTest(fault=fault):
                self.assertEqual(self.rulings_on(fault, "minified along x"), {50})

    def test_generated_levels_of_a_white_image_that_are_black(self):
        self.assertEqual(self.rulings_on("black-levels", "generated white"), {25})

    def test_a_coordinate_of_exactly_one_where_the_edge_is_clamped(self):
        cases = self.results(f"{SUITE}/textures/wrap/edge-at-one.json", "--against",
                             self.against("one-is-zero"), expect=UNEXPECTED)["cases"]
        convicted = sum(only_result(case)["verdict"] == "violation" for case in cases)
        self.assertGreaterEqual(convicted, 40)

    def test_a_chain_with_one_level_too_few(self):
        for name in "generated", "generated codes":
            with self.subTest(name):
                self.assert_told("short-chain", name, "mipmap.level-count", "")


if __name__ == "__main__":
    unittest.main()
