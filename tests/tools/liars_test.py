# SPDX-License-Identifier: MIT
"""Renderers that lie about the whole suite: none gets `agree` for an answer that is not right."""
import collections
import json
import re
import unittest

import results_file
from suite_data import ID, exact_lines, shard
from support import PROBES, RENDERER, UNEXPECTED, CommandTest, component_bits, drawings

# The line of a case that one renderer ran: its id, and the verdict.
CASE = re.compile(r'{"case":"([^"\\]*)".*?"verdict":"([a-z-]+)"')


# All that is drawn, in one colour's order; of samples, each of them. The text of a rendering is made
# of its values alone, so that equal ones read alike.
DRAWN = re.compile(r'"(?:width|height|pixels|depths|stencils|sample_pixels)":(?:\d+|\[[^][]*\])')


def picture(line):
    return tuple(DRAWN.findall(line))


def planes_of(rendering, key, components):
    """Planes of rows; of a sample each, where there are several."""
    values, length = rendering.get(key, []), components * rendering["width"]
    rows = [values[start:start + length] for start in range(0, len(values), length)]
    height = rendering["height"]
    return [rows[start:start + height] for start in range(0, len(rows), height)]


def told_of(fragment):
    """All that a renderer tells of a fragment, but for where it is."""
    details = {key: fragment[key] for key in ("coordinates", "derivatives") if key in fragment}
    return component_bits(fragment), details


def upside_down_is_the_same(line):
    """Is the rendering its own mirror image, float32 value by float32 value? Pixel by pixel: a
    mirror image leaves samples where they are in their pixels."""
    rendering = json.loads(line)
    return (all(rows == rows[::-1] for key in ("pixels", "accumulated")
                for rows in planes_of(rendering, key, 4))
            and all(is_symmetric(drawn) for drawn in drawings(rendering)))


def is_symmetric(drawn):
    height = drawn["height"]
    lengths = (("pixels", 4), ("sample_pixels", 4), ("depths", 1), ("stencils", 1))
    planes = [plane for key, length in lengths for plane in planes_of(drawn, key, length)]
    if not all(rows == rows[::-1] for rows in planes):
        return False
    fragments = {(f["x"], f["y"], f["primitive"], f["coverage"]): told_of(f)
                 for f in drawn["fragments"]}
    mirrored = {(x, height - 1 - y, *which): value
                for (x, y, *which), value in fragments.items()}
    return fragments == mirrored


def with_a_twin():
    """The cases of which another one is rendered just the same, fragment by fragment."""
    twins = collections.defaultdict(list)
    for name, line in exact_lines():
        twins[line[ID.match(line).end():]].append(name)
    return {name for names in twins.values() for name in names if len(names) > 1}


class Liars(CommandTest):
    def verdicts(self, behaviour, expect, part):
        """id -> verdict, of an eighth of this share of the suite. A lie about everything makes some 300 MB of
        results, a case to a line: what is not asked for is not parsed."""
        path = self.folder / "results.json"
        self.command("run", *PROBES, "--against", self.odd_renderer(behaviour), "--json", path,
                     "--no-rerun", *shard(part, 8), expect=expect)
        lines = results_file.lines_of(path)
        found = dict(match.groups() for match in map(CASE.match, lines) if match)
        self.assertEqual(list(found), [name for name, _ in exact_lines()][part - 1::8])
        return found

    def judge(self, behaviour, part):
        found = self.verdicts(behaviour, UNEXPECTED, part)
        self.assertNotIn("not-run", found.values(), "a liar answers everything")
        return found

    def test_constant_images_never_agree(self):
        # An eighth each, and another one.
        for part, behaviour in enumerate(("black", "white", "grey", "transparent"), 1):
            with self.subTest(behaviour):
                self.assertNotIn("agree", self.judge(behaviour, part).values())

    def test_right_fragments_do_not_make_up_for_a_constant_image(self):
        self.assertNotIn("agree", self.judge("painted", 5).values())

    def test_fragments_of_the_first_case_do_not_either(self):
        self.assertNotIn("agree", self.verdicts("first-fragments", RENDERER, 6).values())

    def test_the_previous_answer_agrees_only_where_it_is_right(self):
        found = self.verdicts("echo", RENDERER, 7)
        agreeing = {name for name, verdict in found.items() if verdict == "agree"}
        self.assertEqual(agreeing - with_a_twin(), set())
        # Where two neighbours have one size, the echo is a rendering and is judged as one.
        self.assertGreater(list(found.values()).count("violation"), len(found) // 2)

    def test_a_mirrored_answer_agrees_only_where_it_is_right(self):
        found = self.judge("mirror", 8)
        lines = dict(exact_lines())
        symmetric = {name for name, line in lines.items() if upside_down_is_the_same(line)}
        agreeing = {name for name, verdict in found.items() if verdict == "agree"}
        self.assertEqual(agreeing - symmetric, set())
        # A suite of symmetric cases would prove nothing.
        self.assertLess(len(symmetric), len(lines) // 3)

    def test_no_two_files_have_one_picture(self):
        """So no constant and no other file's image is ever right, whichever it is. Samples lie so
        far apart that a sweep across them may leave a picture as it was: hardly any does. Tests of
        fragments have two outcomes, whatever the sweep."""
        pictures = {}
        count = again = 0
        for name, line in exact_lines(of_all=True):
            count += 1
            other = pictures.setdefault(picture(line), name)
            again += other != name and name.startswith("samples/")
            self.assertEqual(other.split(":")[0], name.split(":")[0])
            self.assertTrue(other == name or name.startswith(("samples/", "output/")), name)
        self.assertLess(again, count / 50)


if __name__ == "__main__":
    unittest.main()
