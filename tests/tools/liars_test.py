# SPDX-License-Identifier: MIT
"""Renderers that lie about the whole suite: none gets `agree` for an answer that is not right."""
import re
import unittest

from support import RENDERER, SUITE, UNEXPECTED, CommandTest, component_bits, rendered_suite

# The line of a case that one renderer ran: its id, and the verdict.
CASE = re.compile(r'{"id":"([^"\\]*)".*?"verdict":"([a-z-]+)"')


def picture(rendering):
    return (rendering["width"], rendering["height"], tuple(rendering["pixels"]),
            tuple(rendering.get("depths", ())))


def rows_of(rendering, key, components):
    values, length = rendering.get(key, []), components * rendering["width"]
    return [values[start:start + length] for start in range(0, len(values), length)]


def told_of(fragment):
    """All that a renderer tells of a fragment, but for where it is."""
    details = {key: fragment[key] for key in ("coordinates", "derivatives") if key in fragment}
    return component_bits(fragment), details


def upside_down_is_the_same(rendering):
    """Is the rendering its own mirror image, float32 value by float32 value?"""
    height = rendering["height"]
    fragments = {(f["x"], f["y"], f["primitive"]): told_of(f) for f in rendering["fragments"]}
    mirrored = {(x, height - 1 - y, primitive): value
                for (x, y, primitive), value in fragments.items()}
    tables = rows_of(rendering, "pixels", 4), rows_of(rendering, "depths", 1)
    return all(rows == rows[::-1] for rows in tables) and fragments == mirrored


class Liars(CommandTest):
    def verdicts(self, behaviour, expect):
        """id -> verdict. A lie about everything makes some 300 MB of results, a case to a line:
        what is not asked for is not parsed."""
        path = self.folder / "results.json"
        self.command("run", SUITE, "--against", self.odd_renderer(behaviour), "--json", path,
                     expect=expect)
        with path.open(encoding="utf-8") as lines:
            found = dict(match.groups() for match in map(CASE.match, lines) if match)
        self.assertEqual(set(found), set(rendered_suite()))
        return found

    def judge(self, behaviour):
        found = self.verdicts(behaviour, UNEXPECTED)
        self.assertNotIn("not-run", found.values(), "a liar answers everything")
        return found

    def test_constant_images_never_agree(self):
        for behaviour in ("black", "white", "grey", "transparent"):
            with self.subTest(behaviour):
                self.assertNotIn("agree", self.judge(behaviour).values())

    def test_right_fragments_do_not_make_up_for_a_constant_image(self):
        self.assertNotIn("agree", self.judge("painted").values())

    def test_fragments_of_the_first_case_do_not_either(self):
        self.assertNotIn("agree", self.verdicts("first-fragments", RENDERER).values())

    def test_the_previous_answer_never_agrees(self):
        found = self.verdicts("echo", RENDERER)
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
