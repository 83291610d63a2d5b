# SPDX-License-Identifier: MIT
"""What a renderer says of itself and of its asked cases: claims excuse no more than the
specification grants, and who draws nothing is red."""
import json
import shlex
import sys
import unittest
import xml.etree.ElementTree as ET

from support import (NOTHING_DRAWN, UNEXPECTED, CommandTest, only_result, triangle_case,
                     verdicts)

# Draws a point of any size as one of so many pixels, and claims what it is told to.
POINTS = """
import json, sys
size, claims = int(sys.argv[1]), json.loads(sys.argv[2])
for line in sys.stdin:
    request = json.loads(line)
    width, height = (request["scene"]["target"][side] for side in ("width", "height"))
    pixels, fragments = [0, 0, 0, 255] * (width * height), []
    for y in range(height):
        for x in range(width):
            if abs(2 * x + 1 - width) < size and abs(2 * y + 1 - height) < size:
                at = 4 * (y * width + x)
                pixels[at:at + 4] = [255] * 4
                fragments.append({"x": x, "y": y, "primitive": 0})
    print(json.dumps({"digest": request["digest"], "pixels": pixels, "fragments": fragments,
                      "renderer": claims}), flush=True)
"""
# Draws these pixels of a white point, and claims what it is told to.
BESIDE = """
import json, sys
drawn, claims = map(json.loads, sys.argv[1:])
for line in sys.stdin:
    request = json.loads(line)
    pixels = [0, 0, 0, 255] * 64
    for x, y in drawn:
        pixels[4 * (8 * y + x):4 * (8 * y + x) + 4] = [255] * 4
    print(json.dumps({"digest": request["digest"], "pixels": pixels, "renderer": claims,
                      "fragments": [{"x": x, "y": y, "primitive": 0} for x, y in drawn]}),
          flush=True)
"""
LEFT = [(x, y) for y in range(2, 7) for x in range(2)]
REFUSES = """
import json, sys
for line in sys.stdin:
    request = json.loads(line)
    name = request["id"].rpartition("/")[2]
    print(json.dumps({"digest": request["digest"], "not_run": sys.argv[1] + name[:1]}), flush=True)
"""


class Program(CommandTest):
    def program(self, text, *arguments):
        script = self.write("program.py", text)
        return "exec:" + shlex.join([sys.executable, str(script), *arguments])


class Claims(Program):
    def verdict(self, size, **claims):
        """Of a point of 2.5 pixels drawn so many pixels wide."""
        self.write("cases/point.json", triangle_case(
            title="A point", rules=["point.ownership"],
            target={"width": 9, "height": 9, "clear": [0, 0, 0, 1]},
            draws=[{"primitive": "points", "vertices": [[4.5, 4.5]], "color": [1, 1, 1, 1],
                    "state": {"point_size": 2.5}}]))
        program = self.program(POINTS, str(size), json.dumps(claims))
        self.found = self.results("cases", "--no-rerun", "--against", program, expect=None)
        return verdicts(self.found)["point"]

    def test_steps_excuse_the_nearest_size_alone(self):
        steps = {"traits": {"point_size_steps": "1 by 1000"}}
        self.assertEqual(self.verdict(9, **steps), "violation")
        self.assertEqual(self.verdict(7, **steps), "violation")
        self.assertEqual(self.verdict(1, **steps), "permitted", "1 is the nearest")
        self.assertIn("with a size of 1 to 4, puts the sample outside", json.dumps(self.found))
        self.assertEqual(self.verdict(1), "violation", "all sizes are supported")
        self.assertNotIn("Not believed", self.summary)

    def test_what_no_implementation_may_claim_excuses_nothing(self):
        for claim in ("9 by 9", "1 by 0", "1 by -8", "nan by 1", "1 by inf", "1 by many"):
            with self.subTest(claim):
                steps = {"traits": {"point_size_steps": claim}}
                self.assertEqual(self.verdict(9, **steps), "violation")
                self.assertEqual(self.verdict(1, **steps), "violation")
                self.assertIn(f'point_size_steps "{claim}": ', self.summary)
        self.command("report", "results.json", "--markdown", "page.md")
        self.assertIn("Claims that are not believed", (self.folder / "page.md").read_text("utf-8"))

    def test_few_bits_excuse_no_more_than_four(self):
        for bits in (0, 1, 24):
            self.assertEqual(self.verdict(9, subpixel_bits=bits), "violation")
        self.verdict(9, subpixel_bits=1)
        self.assertIn("subpixel_bits 1: at least 4 are required", self.summary)


class Api(Program):
    """A point of 5 pixels whose vertex lies half a pixel to the left of the viewport: OpenGL may
    discard it, OpenGL ES must draw what reaches in."""

    def result(self, drawn, **claims):
        self.write("cases/point.json", triangle_case(
            title="A point beside the viewport", rules=["point.clip"],
            target={"width": 8, "height": 8, "clear": [0, 0, 0, 1]},
            draws=[{"primitive": "points", "vertices": [{"clip": [-1.125, 0.125, 0, 1]}],
                    "color": [1, 1, 1, 1], "state": {"point_size": 5}}]))
        program = self.program(BESIDE, json.dumps(drawn), json.dumps(claims))
        self.found = self.results("cases", "--no-rerun", "--against", program, expect=None)
        return only_result(self.found["cases"][0])

    def test_opengl_may_do_either(self):
        for claims in ({}, {"traits": {"api": "OpenGL"}}):
            self.assertEqual(self.result([], **claims)["verdict"], "agree")
            self.assertEqual(self.result(LEFT, **claims)["verdict"], "convention")

    def test_opengl_es_draws_it(self):
        claims = {"traits": {"api": "OpenGL ES"}}
        self.assertEqual(self.result(LEFT, **claims)["verdict"], "agree")
        lost = self.result([], **claims)
        self.assertEqual(lost["verdict"], "violation")
        self.assertIn("Ruling 68: ", json.dumps(lost))
        self.assertIn("point.clip=of-other-api", json.dumps(lost))
        # Without its last column it is no picture of either.
        less = self.result([pixel for pixel in LEFT if pixel[0] == 0], **claims)
        self.assertEqual(less["verdict"], "violation")


class NothingDrawn(Program):
    def setUp(self):
        super().setUp()
        self.write_cases("a", "b", "c")
        self.write("cases/b2.json", triangle_case(title="Another"))
        self.renderer = self.program(REFUSES, "too hard, ")
        self.told = (f'{self.renderer} drew none of 4 cases: 2 x "too hard, b", '
                     '1 x "too hard, a", 1 x "too hard, c"')

    def test_it_is_red_with_the_reasons_in_the_first_lines(self):
        self.results("cases", "--against", self.renderer, "--markdown", "page.md", "--junit",
                     "junit.xml", "--annotations", "annotations.txt", expect=NOTHING_DRAWN)
        first, second = self.summary.splitlines()[:2]
        self.assertIn("1 renderer drew nothing", first)
        self.assertEqual(second, self.told)
        self.assertIn("`" + self.told + "`", (self.folder / "page.md").read_text("utf-8"))
        suites = ET.parse(self.folder / "junit.xml").getroot()
        self.assertIn(self.told, [e.get("message") for e in suites.iter("error")])
        self.assertIn("::error ", (self.folder / "annotations.txt").read_text("utf-8"))

    def test_one_case_that_it_was_asked_for_is_enough(self):
        self.command("run", "cases/a.json", "--against", self.renderer, expect=NOTHING_DRAWN)
        self.command("run", "cases/a.json", "--against", self.renderer, "--fail-on", "nothing")

    def test_others_do_not_draw_for_it(self):
        honest = self.odd_renderer("garbage", "nobody", "cases")
        self.command("run", "cases", "--against", honest)
        self.command("run", "cases", "--against", honest, "--against", self.renderer,
                     expect=NOTHING_DRAWN)
        wrong = self.odd_renderer("black", "", "cases")
        self.command("run", "cases", "--against", wrong, "--against", self.renderer,
                     expect=UNEXPECTED)

    def test_shards_tell_it_and_the_merged_run_is_red(self):
        for shard in (1, 2):
            run = self.command("run", "cases", "--against", self.renderer, "--shard", f"{shard}/2",
                               "--json", f"{shard}.json")
            self.assertIn("drew none of 2 cases: ", run.stdout)
            self.assertIn("`edgecase merge` tells", run.stdout)
        merged = self.command("merge", "1.json", "2.json", "-o", "all.json", expect=NOTHING_DRAWN)
        self.assertEqual(merged.stdout.splitlines()[1], self.told)

    def test_one_drawing_is_something(self):
        """The renderer that supports one case of many is what most are at first."""
        text = REFUSES.replace('"not_run": sys.argv[1] + name[:1]}', """**(
            {"not_run": "no"} if name != "a" else
            {"pixels": [0, 0, 0, 255] * 64, "fragments": []})}""")
        self.results("cases", "--against", self.program(text, ""), expect=UNEXPECTED)
        self.assertNotIn("drew n", self.summary)
        self.assertIn("Not supported by", self.summary)


if __name__ == "__main__":
    unittest.main()
