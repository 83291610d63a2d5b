# SPDX-License-Identifier: MIT
"""draw --against, and the pictures of the findings: each renderer still draws what they show."""
import re
import unittest
import xml.etree.ElementTree

from support import (NOTHING_SELECTED, ROOT, SUITE, USAGE, CommandTest, mesa_release, only_result,
                     triangle_case)

RELEASE = "22.3.6"  # of Mesa, whose drivers the pictures show
FINDINGS = (ROOT / f"reports/pages/pictures-mesa-{RELEASE}.md").read_text(encoding="utf-8")
FINDING = re.compile(r"^### (?P<fault>.+)\n\n.*?Rulings? (?P<rulings>[\d, ]+) (?P<does>\w+) it: "
                     r"\[[^\]]+\]\(\.\./\.\./(?P<case>cases/[^)]+)\)[^\n]*\n\n"
                     r"!\[exact and (?P<renderer>[^\]]+)\]\(\.\./images/(?P<picture>[^)]+)\)$",
                     re.MULTILINE)
# The worst legality of what a ruling is said to do to a finding.
WORST = {"forbid": "illegal", "contest": "contested", "allow": "legal"}
GALLERY = [match.groupdict() for match in FINDING.finditer(FINDINGS)]
BETWEEN = f"{SUITE}/lines/short/between-diamonds.json"
SOFTPIPE = ("--against", "egl:softpipe")


def is_the_release():
    return unittest.skipUnless(mesa_release() == RELEASE, f"the pictures are of Mesa {RELEASE}")


class Gallery(CommandTest):
    def test_every_picture_is_of_a_finding(self):
        self.assertGreaterEqual(len(GALLERY), 12)
        self.assertEqual(FINDINGS.count("../images/"), len(GALLERY))

    @is_the_release()
    def test_the_pictures_are_what_the_program_draws(self):
        for finding in GALLERY:
            with self.subTest(case=finding["case"]):
                drawn = self.folder / "drawn.svg"
                self.command("draw", ROOT / finding["case"], "--against", finding["renderer"],
                             "--svg", drawn)
                kept = ROOT / "reports/images" / finding["picture"]
                self.assertEqual(drawn.read_bytes(), kept.read_bytes())

    def test_no_picture_shows_two_equal_sides(self):
        for finding in GALLERY:
            with self.subTest(case=finding["case"]):
                picture = xml.etree.ElementTree.parse(ROOT / "reports/images" / finding["picture"])
                exact, _, rendered = [[pixel.get("class") for pixel in pane.findall("{*}rect")]
                                      for pane in picture.findall("{*}g/{*}g")]
                self.assertNotEqual(exact, rendered)

    @is_the_release()
    def test_the_renderers_break_the_rulings_that_are_named(self):
        for finding in GALLERY:
            with self.subTest(case=finding["case"]):
                results = self.results(ROOT / finding["case"], "--against", finding["renderer"],
                                       expect=None)
                told = only_result(results["cases"][0])["disagreements"]
                worst = WORST[finding["does"].rstrip("s")]
                rulings = {d["ruling"] for d in told if d["legality"] == worst}
                self.assertTrue(rulings & {int(n) for n in finding["rulings"].split(",")}, told)
                if worst != "illegal":
                    self.assertNotIn("illegal", {d["legality"] for d in told})


class DrawAgainst(CommandTest):
    def test_as_text(self):
        out = self.command("draw", BETWEEN, *SOFTPIPE).stdout
        exact, rendered = out.split("egl:softpipe\n")
        self.assertEqual(exact.count("#"), 0)
        self.assertEqual(rendered.split("\n")[4], "...#....")

    def test_a_picture_is_xml_with_a_background_of_its_own(self):
        svg = self.folder / "drawn.svg"
        self.command("draw", BETWEEN, *SOFTPIPE, "--svg", svg)
        root = xml.etree.ElementTree.parse(svg).getroot()
        paper = root.find("{*}rect")
        self.assertEqual(paper.get("class"), "paper")
        self.assertEqual((paper.get("width"), paper.get("height")),
                         (root.get("width"), root.get("height")))
        words = "".join(root.itertext())
        self.assertIn("violation: pixel (3, 3) extra, line.diamond-exit, ruling 2", words)

    def test_one_pane_has_no_words_and_needs_a_picture(self):
        svg = self.folder / "pane.svg"
        for pane in ("exact", "difference", "renderer"):
            self.command("draw", BETWEEN, *SOFTPIPE, "--pane", pane, "--svg", svg)
            root = xml.etree.ElementTree.parse(svg).getroot()
            self.assertFalse(root.findall(".//{*}text"), pane)
        self.command("draw", BETWEEN, *SOFTPIPE, "--pane", "exact", expect=USAGE)
        self.command("draw", BETWEEN, "--pane", "exact", "--svg", svg, expect=USAGE)

    def test_filters_choose_one_case_of_a_sweep(self):
        swept = f"{SUITE}/lines/wide/rounded-widths.json"
        drawn = {self.command("draw", swept, "--filter", f"*:width={width}", *SOFTPIPE).stdout
                 for width in (1.5, 4.5)}
        self.assertEqual(len(drawn), 2)
        self.command("draw", swept, "--filter", "no-such-case", *SOFTPIPE,
                     expect=NOTHING_SELECTED)

    def test_mistakes_are_told(self):
        self.command("draw", BETWEEN, "--against", "egl:nonsense", expect=USAGE)
        self.command("draw", BETWEEN, *SOFTPIPE, "--rule", "line.algorithm", expect=USAGE)

    def test_exact_beside_itself_differs_nowhere(self):
        case = self.write("triangle.json", triangle_case())
        svg = self.folder / "drawn.svg"
        self.command("draw", case, "--against", "exact", "--svg", svg)
        self.assertIn("agree: nothing differs.", svg.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
