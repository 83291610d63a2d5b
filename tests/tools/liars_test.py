# SPDX-License-Identifier: MIT
"""Renderers that lie about the whole suite: none gets `agree` for an answer that is not right."""
import unittest

from support import SUITE, CommandTest, component_bits, rendered_suite, verdicts


def picture(rendering):
    return rendering["width"], rendering["height"], tuple(rendering["pixels"])


def upside_down_is_the_same(rendering):
    """Is the rendering its own mirror image, float32 value by float32 value?"""
    width, height, pixels = rendering["width"], rendering["height"], rendering["pixels"]
    rows = [pixels[4 * width * y:4 * width * (y + 1)] for y in range(height)]
    fragments = {(f["x"], f["y"], f["primitive"]): component_bits(f)
                 for f in rendering["fragments"]}
    mirrored = {(x, height - 1 - y, primitive): value
                for (x, y, primitive), value in fragments.items()}
    return rows == rows[::-1] and fragments == mirrored


class Liars(CommandTest):
    def judge(self, behaviour):
        results = self.results(SUITE, "--against", self.odd_renderer(behaviour), expect=1)
        found = verdicts(results)
        self.assertEqual(set(found), set(rendered_suite()))
        self.assertNotIn("not-run", found.values(), "a liar answers everything")
        return found

    def test_constant_images_never_agree(self):
        for behaviour in ("black", "white", "grey", "transparent"):
            with self.subTest(behaviour):
                self.assertNotIn("agree", self.judge(behaviour).values())

    def test_right_fragments_do_not_make_up_for_a_constant_image(self):
        self.assertNotIn("agree", self.judge("painted").values())

    def test_fragments_of_the_first_case_do_not_either(self):
        results = self.results(SUITE, "--against", self.odd_renderer("first-fragments"), expect=4)
        self.assertNotIn("agree", verdicts(results).values())

    def test_the_previous_answer_never_agrees(self):
        results = self.results(SUITE, "--against", self.odd_renderer("echo"), expect=4)
        found = verdicts(results)
        self.assertEqual(set(found), set(rendered_suite()))
        self.assertNotIn("agree", found.values())
        # Where two neighbours have one size, the echo is a rendering and is judged as one.
        self.assertGreater(list(found.values()).count("violation"), len(found) // 2)

    def test_a_mirrored_answer_agrees_only_where_it_is_right(self):
        found = self.judge("mirror")
        symmetric = {name for name, truth in rendered_suite().items()
                     if upside_down_is_the_same(truth)}
        agreeing = {name for name, verdict in found.items() if verdict == "agree"}
        self.assertEqual(agreeing - symmetric, set())
        # A suite of symmetric cases would prove nothing.
        self.assertLess(len(symmetric), len(found) // 3)

    def test_no_two_cases_have_one_picture(self):
        """So no constant and no other case's image is ever right, whichever it is."""
        pictures = {}
        for name, rendering in rendered_suite().items():
            other = pictures.setdefault(picture(rendering), name)
            self.assertEqual(other, name)


if __name__ == "__main__":
    unittest.main()
