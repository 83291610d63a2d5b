# SPDX-License-Identifier: MIT
"""draw --against, and the README's gallery: each row's renderer still does what the row shows."""
import re
import unittest
import xml.etree.ElementTree

from support import NOTHING_SELECTED, ROOT, SUITE, USAGE, CommandTest, only_result, triangle_case

README = (ROOT / "README.md").read_text(encoding="utf-8")
ROW = re.compile(r"^\| (?P<fault>[^|]+) \| (?P<who>[^|]+) \| (?P<rulings>[\d, ]+): (?P<allowed>\w+)"
                 r"[^|]* \| \[[^\]]+\]\((?P<case>cases/[^)]+)\) \| <img src=\"(?P<picture>[^\"]+)\""
                 r" width=\"\d+\" alt=\"exact and (?P<renderer>[^\"]+)\"> \|$", re.MULTILINE)
GALLERY = [match.groupdict() for match in ROW.finditer(README)]
BETWEEN = f"{SUITE}/lines/short/between-diamonds.json"
SOFTPIPE = ("--against", "osmesa:softpipe")


class Gallery(CommandTest):
    def test_every_picture_is_of_a_row(self):
        self.assertGreaterEqual(len(GALLERY), 12)
        others = ("disputed-pixel", "overview.png", "block-walk", "policy-gallery", "images/knot")
        self.assertEqual(README.count("reports/images/") - sum(map(README.count, others)),
                         len(GALLERY))

    def test_the_pictures_are_what_the_program_draws(self):
        for row in GALLERY:
            with self.subTest(case=row["case"]):
                drawn = self.folder / "drawn.svg"
                self.command("draw", ROOT / row["case"], "--against", row["renderer"],
                             "--svg", drawn)
                self.assertEqual(drawn.read_bytes(), (ROOT / row["picture"]).read_bytes())

    def test_the_renderers_break_the_rulings_that_are_named(self):
        for row in GALLERY:
            with self.subTest(case=row["case"]):
                results = self.results(ROOT / row["case"], "--against", row["renderer"],
                                       expect=None)
                told = only_result(results["cases"][0])["disagreements"]
                rulings = {d["ruling"] for d in told if (d["legality"] == "legal") == (row["allowed"] == "yes")}
                self.assertTrue(rulings & {int(n) for n in row["rulings"].split(",")}, told)
                if row["allowed"] == "yes":
                    self.assertTrue(all(d["legality"] == "legal" for d in told))


class DrawAgainst(CommandTest):
    def test_as_text(self):
        out = self.command("draw", BETWEEN, *SOFTPIPE).stdout
        exact, rendered = out.split("osmesa:softpipe\n")
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

    def test_filters_choose_one_case_of_a_sweep(self):
        swept = f"{SUITE}/lines/wide/rounded-widths.json"
        drawn = {self.command("draw", swept, "--filter", f"*:width={width}", *SOFTPIPE).stdout
                 for width in (1.5, 4.5)}
        self.assertEqual(len(drawn), 2)
        self.command("draw", swept, "--filter", "no-such-case", *SOFTPIPE,
                     expect=NOTHING_SELECTED)

    def test_mistakes_are_told(self):
        self.command("draw", BETWEEN, "--against", "osmesa:nonsense", expect=USAGE)
        self.command("draw", BETWEEN, *SOFTPIPE, "--rule", "line.algorithm", expect=USAGE)

    def test_exact_beside_itself_differs_nowhere(self):
        case = self.write("triangle.json", triangle_case())
        svg = self.folder / "drawn.svg"
        self.command("draw", case, "--against", "exact", "--svg", svg)
        self.assertIn("agree: nothing differs.", svg.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
