# SPDX-License-Identifier: MIT
"""Laws between two answers: renderers that break one are told so by its ruling, and by both answers;
one that keeps them is not, and nobody is asked for images that nothing wants."""
import json
import shlex
import sys
import unittest

from support import AS_EXPECTED, HERE, SUITE, UNEXPECTED, CommandTest, only_result

MOVABLE = [f"{SUITE}/triangles/single/clockwise.json"]
VALUES = [f"{SUITE}/output/offset/units.json", "--sample", "1/100"]  # the example is slow


def mutant(fault):
    words = [sys.executable, "-B", str(HERE / "output_mutant.py"), fault]
    return "exec:" + " ".join(map(shlex.quote, words))


class Invariance(CommandTest):
    def broken(self, fault, cases, rule, expect=UNEXPECTED, options=("--invariance",)):
        """The explanations of what breaks the rule, and how many cases do."""
        found = self.results(*cases, "--against", mutant(fault), *options, expect=expect)["cases"]
        told = [[d["explanation"] for d in only_result(case)["disagreements"] if d["rule"] == rule]
                for case in found]
        for case, own in zip(found, told):
            if own:
                self.assertEqual(only_result(case)["verdict"], "violation", case["id"])
        return [text for own in told for text in own], sum(map(bool, told))

    def test_who_keeps_the_laws_is_not_told(self):
        for cases in MOVABLE, VALUES:
            self.assertEqual(self.broken("none", cases, "fragment.invariant", AS_EXPECTED)[1], 0)

    def test_a_fragment_that_is_lost_far_from_the_origin(self):
        told, cases = self.broken("far-drops", MOVABLE, "fragment.invariant")
        self.assertGreater(cases, 0)
        for text in told:
            self.assertRegex(text, r"is in the scene and not in its image; the image is moved by \d+ pixels")

    def test_fragments_that_depend_on_the_colour_mask(self):
        told, cases = self.broken("mask-darkens", VALUES, "fragment.invariant")
        self.assertGreater(cases, 0)
        self.assertIn("has all colours masked", told[0])

    def test_fragments_that_depend_on_other_state(self):
        for fault, words in (("box-drops", "has a scissor box"),
                             ("second-drops", "follows a first drawing of the same")):
            with self.subTest(fault):
                told, cases = self.broken(fault, MOVABLE, "fragment.invariant")
                self.assertGreater(cases, 0)
                for text in told:
                    self.assertIn(words, text)

    def test_fragments_that_depend_on_blending_are_contested(self):
        found = self.results(*MOVABLE, "--against", mutant("blend-drops"), "--invariance",
                             expect=AS_EXPECTED)["cases"]
        told = [only_result(case) for case in found]
        self.assertIn("contested", [result["verdict"] for result in told])
        for result in told:
            self.assertEqual([d["ruling"] for d in result.get("disagreements", [])],
                             [70] * len(result.get("disagreements", [])))

    def test_a_find_of_an_image_is_minimized_with_its_images(self):
        written = self.command("minimize", *MOVABLE[:1], "--against", mutant("box-drops"))
        case = json.loads(written.stdout)
        self.assertTrue(case["invariant"])
        self.assertEqual(case["rules"], ["fragment.invariant"])

    def test_a_scene_that_has_two_pictures(self):
        told, _ = self.broken("forgetful", VALUES, "fragment.invariant")
        self.assertIn("the pixel has two colours in two drawings", told[0])

    def test_images_are_drawn_where_they_are_asked_for(self):
        told, _ = self.broken("mask-darkens", VALUES, "fragment.invariant", AS_EXPECTED, ())
        self.assertEqual(told, [])

    def test_a_unit_of_offset_that_grows_with_the_depth(self):
        """Each case alone is right: a unit may have any size, but one."""
        cases = [f"{SUITE}/output/offset/one-unit-at-every-depth.json"]
        told, count = self.broken("float-unit", cases, "offset.unit", options=())
        self.assertGreater(count, 2)
        self.assertRegex(told[0], r"a unit of polygon offset in a depth buffer of \d+ bits is at "
                                  r"(most|least) \S+ by this answer, and at (most|least) \S+ by "
                                  r"that to output/offset/one-unit-at-every-depth:")
        alone = self.results(*cases, "--filter", "*:z=0:units=64:format=depth16", "--against",
                             mutant("float-unit"), expect=AS_EXPECTED)["cases"]
        self.assertEqual(len(alone), 1)
        self.broken("none", cases, "offset.unit", AS_EXPECTED, ())


if __name__ == "__main__":
    unittest.main()
