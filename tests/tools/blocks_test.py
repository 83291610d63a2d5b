# SPDX-License-Identifier: MIT
"""explain --blocks: what is said of each block, held against what exact draws."""
import re
import unittest
import xml.etree.ElementTree

from support import ROOT, SUITE, USAGE, CommandTest, triangle_case

ACROSS = f"{SUITE}/triangles/single/across-blocks.json"
WALK = re.compile(r"^primitive (?P<index>\d+), the triangle [^\n]*:\n(?P<drawing>(?:[-#+.012]+\n)+)"
                  r"(?P<words>(?:  [^\n]*\n)+)", re.MULTILINE)
SIZE = re.compile(r"  blocks of (\d+) x \1: (\d+) accepted, (\d+) (divided|tested)"
                  r"(?:, (\d+) of them for nothing)?, (\d+) rejected\.")
EDGE = re.compile(r"  edge ([012]) from [^\n]* rejects (\d+) blocks?\.")
COUNTS = re.compile(r"  (\d+) samples are covered, (\d+) of them by accepted blocks\. (\d+) edge "
                    r"functions are evaluated; to ask the (\d+) samples of the bounding box one by "
                    r"one takes (\d+)\.")


def numbers(found):
    return [int(n) for n in found.groups(0) if str(n).isdigit()]


class Blocks(CommandTest):
    def walks(self, case, *arguments):
        out = self.command("explain", case, "--blocks", *arguments).stdout
        return [walk.groupdict() for walk in WALK.finditer(out)], out

    def test_drawing_and_counts_agree(self):
        (walk,), _ = self.walks(ACROSS, "4")
        drawing = walk["drawing"]
        self.assertEqual([len(row) for row in drawing.splitlines()], [8] * 6)
        ((side, accepted, tested, in_vain, rejected),) = [
            numbers(found) for found in SIZE.finditer(walk["words"])]
        self.assertEqual(side, 4)
        self.assertEqual(accepted, drawing.count("#"))
        self.assertEqual(tested, drawing.count("+") + drawing.count("-"))
        self.assertEqual(in_vain, drawing.count("-"))
        self.assertEqual(rejected, sum(map(drawing.count, "012")))
        for edge, count in map(numbers, EDGE.finditer(walk["words"])):
            self.assertEqual(count, drawing.count(str(edge)))
            self.assertGreater(count, 0)

    def test_blocks_are_what_exact_draws_in_them(self):
        """Of every size: the drawing over the coverage that the same command prints."""
        for side in (2, 4, 8, 16, 32):
            (walk,), out = self.walks(ACROSS, side)
            rows = [line for line in out.splitlines() if re.fullmatch(r"[.#]{32}", line)][::-1]
            self.assertEqual(len(rows), 24)
            drawing = walk["drawing"].splitlines()[::-1]
            self.assertEqual((len(drawing), len(drawing[0])), (-(-24 // side), 32 // side))
            by_accepted = 0
            for j, signs in enumerate(drawing):
                for i, sign in enumerate(signs):
                    block = "".join(row[i * side:(i + 1) * side]
                                    for row in rows[j * side:(j + 1) * side])
                    kinds = {"#": {"#"}, "+": {".", "#"}}.get(sign, {"."})
                    self.assertEqual(set(block), kinds, (side, i, j, sign))
                    by_accepted += len(block) if sign == "#" else 0
            covered, accepted, asked, box, plain = numbers(COUNTS.search(walk["words"]))
            self.assertEqual(covered, "".join(rows).count("#"))
            self.assertEqual(accepted, by_accepted)
            self.assertTrue(box < plain <= 3 * box)
            self.assertEqual(asked < plain, side < 32, "one block of 32 is asked for nothing")

    def test_two_levels_draw_the_same_and_ask_less(self):
        (one,), _ = self.walks(ACROSS, "4")
        (two,), _ = self.walks(ACROSS, "16,4")
        self.assertEqual(one["drawing"], two["drawing"])
        outer, inner = SIZE.finditer(two["words"])
        self.assertEqual(outer.group(4), "divided")
        self.assertEqual(inner.group(4), "tested")
        self.assertLess(numbers(COUNTS.search(two["words"]))[2],
                        numbers(COUNTS.search(one["words"]))[2])

    def test_sides_are_8_where_none_are_named(self):
        self.assertEqual(self.walks(ACROSS)[1], self.walks(ACROSS, "8")[1])

    def test_the_tie_rule_of_the_policy_decides(self):
        """A right triangle whose slanted edge runs through centres: of the block in its upper
        corner, one centre lies on the edge and all others beyond it."""
        case = self.write("half.json", triangle_case(draws=[
            {"primitive": "triangles", "vertices": [[0, 0], [7, 0], [0, 7]]}]))
        for ties, sign in (("left-bottom", "1"), ("right-top", "+")):
            policy = self.write("policy.json", {"name": "mine",
                                                "rules": {"triangle.fill-rule": ties}})
            (walk,), out = self.walks(case, "2", "--policy", policy)
            self.assertIn("by policy mine", out)
            self.assertEqual(walk["drawing"].splitlines()[0], f"{sign}111")

    def test_every_sample_of_a_pixel_counts(self):
        case = self.write("samples.json", triangle_case(
            target={"width": 8, "height": 8, "samples": 4}))
        (one,), _ = self.walks(self.write("one.json", triangle_case()), "2")
        (four,), _ = self.walks(case, "2")
        self.assertGreater(numbers(COUNTS.search(four["words"]))[0],
                           3 * numbers(COUNTS.search(one["words"]))[0])
        self.assertEqual(numbers(COUNTS.search(four["words"]))[3] % 4, 0)

    def test_what_is_not_walked_is_said_why(self):
        triangle = [[1, 1], [6.25, 1], [1, 6]]
        case = self.write("others.json", triangle_case(draws=[
            {"primitive": "points", "vertices": [[1, 1]]},
            {"primitive": "lines", "vertices": [[1, 1], [3, 3]]},
            {"primitive": "triangles", "vertices": triangle, "state": {"cull": "front"}},
            {"primitive": "triangles", "vertices": [[1, 1], [2, 2], [3, 3]]},
            {"primitive": "triangles", "vertices": [[1, 1], [1.25, 1], [1, 1.25]]},
            {"primitive": "triangles", "vertices": triangle}]))
        walks, out = self.walks(case, "4")
        self.assertEqual([walk["index"] for walk in walks], ["5"])
        for words in ("0 is not walked: it is a point", "1 is not walked: it is a line",
                      "2 is not walked: the triangle", "3 is not walked: it has no area", "4 is not walked: no sample lies"):
            self.assertIn(f"primitive {words}", out)
        policy = self.write("scan.json", {"name": "scan", "rules": {"triangle.algorithm": "scan"}})
        self.assertIn("primitive 5 is not walked: as triangle.algorithm=scan has it",
                      self.walks(case, "4", "--policy", policy)[1])

    def test_what_reaches_out_of_the_clip_volume_is_not_walked(self):
        cut = f"{SUITE}/clipping/near/one-vertex.json"
        _, out = self.walks(cut, "4", "--filter", "clipping/near/one-vertex:z=-4")
        self.assertIn("0 is not walked: it reaches out of the clip volume", out)

    def test_passes_of_a_supersampled_scene_are_walked_one_by_one(self):
        case = self.write("passes.json", triangle_case(
            target={"width": 8, "height": 8, "supersample": {"grid": 2}}))
        walks, out = self.walks(case, "4")
        self.assertEqual(len(walks), 4)
        self.assertEqual(out.count("In pass "), 4)

    def test_mistakes_are_told(self):
        for sides in ("0", "3", "64", "x", "8,8", "4,8", "8,", ",8", "-8", "8.0"):
            told = self.command("explain", ACROSS, f"--blocks={sides}", expect=USAGE).stderr
            self.assertIn(f'"{sides}" names no sides of blocks; write 2, 4, 8, 16 or 32', told)
        self.command("explain", ACROSS, "--svg", "blocks.svg", expect=USAGE)
        lines = f"{SUITE}/lines/short/between-diamonds.json"
        told = self.command("explain", lines, "--blocks", "--svg", "blocks.svg", expect=USAGE)
        self.assertIn("no triangle that is walked", told.stderr)
        self.assertIn("--blocks", self.command("explain", "--help").stdout)


class Picture(CommandTest):
    def test_the_one_in_the_documents_is_what_the_program_draws(self):
        drawn = self.folder / "drawn.svg"
        self.command("explain", ACROSS, "--blocks", 4, "--svg", drawn)
        self.assertEqual(drawn.read_bytes(),
                         (ROOT / "reports/images/block-walk.svg").read_bytes())

    def test_it_shows_each_block_and_each_sample_that_is_tested(self):
        svg = self.folder / "drawn.svg"
        out = self.command("explain", ACROSS, "--blocks", "16,4", "--svg", svg).stdout
        (walk,) = WALK.finditer(out)
        root = xml.etree.ElementTree.parse(svg).getroot()
        panel = root.find("{*}g")
        shown = [rect.get("class") for rect in panel.findall("{*}rect")]
        drawing = walk["drawing"]
        self.assertEqual(shown.count("accepted"), drawing.count("#"))
        self.assertEqual(shown.count("tested"), drawing.count("+"))
        self.assertEqual(shown.count("rejected"), sum(map(drawing.count, "012")))
        self.assertEqual(shown.count("divided"), 4)
        covered, accepted = numbers(COUNTS.search(walk["words"]))[:2]
        dots = [dot.get("class") for dot in panel.findall("{*}circle")]
        self.assertEqual(dots.count("covered"), covered - accepted)


if __name__ == "__main__":
    unittest.main()
