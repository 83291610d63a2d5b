# SPDX-License-Identifier: MIT
"""Policies, and whether the suite tells alternatives apart: --policy, separation, draw."""
import collections
import json
import math
import re
import unittest

from suite_data import COUNT, files_of_share, shard
from support import (PROBES, ROOT, SUITE, UNEXPECTED, USAGE, CommandTest, only_result,
                     triangle_case, verdicts)

POLICIES = sorted(path.stem for path in (ROOT / "cases/policies").glob("*.json"))
CORE = ROOT / "cases/core.txt"
ALL_DIFFER = f"{SUITE}/lines/algorithms/all-differ.json"


class Policies(CommandTest):
    def test_there_are_those_of_the_design(self):
        self.assertEqual(POLICIES, ["cs184", "direct3d-11", "mit-6837", "mit-6837-code", "scotty3d",
                                    "scotty3d-code", "vulkan-strict"])

    def test_exact_under_each_agrees_with_itself(self):
        # A part each, and all of this share of the suite together. Of a share, files: all cases
        # take longer to load than a part to draw.
        files = [file for file in files_of_share() if "scenes" not in file.parts]
        for part, policy in enumerate(POLICIES):
            selected = files[part::len(POLICIES)]
            if COUNT == 1:
                selected = [*PROBES, *shard(part + 1, len(POLICIES))]
            with self.subTest(policy=policy):
                results = self.results(*selected, "--policy", policy, "--against", "exact")
                self.assertEqual(results["policy"], policy)
                self.assertEqual(set(verdicts(results).values()), {"agree"})

    def test_each_draws_its_own_picture(self):
        folders = [f"{SUITE}/{name}" for name in ("lines", "points", "textures/mipmaps",
                                                  "triangles")]
        pictures = {self.command("render", *folders, "--policy", policy, "--json", "-").stdout
                    for policy in ["opengl", *POLICIES]}
        self.assertEqual(len(pictures), 1 + len(POLICIES))

    def test_none_grants_latitude(self):
        self.copy_suite("triangles")
        for policy in POLICIES:
            results = self.results("cases/triangles/ties", "--policy", policy, "--against",
                                   "egl:softpipe", expect=UNEXPECTED)
            self.assertLessEqual(set(verdicts(results).values()), {"agree", "violation"})

    def test_one_that_opengl_judges_does_not_excuse_what_opengl_forbids(self):
        """Two triangles that share an edge through pixel centres, drawn with closed edges by exact
        itself, to a policy that has them closed."""
        case = self.write("quad.json", triangle_case(draws=[
            {"primitive": "triangles",
             "vertices": [[1, 1], [7, 1], [7, 7], [1, 1], [7, 7], [1, 7]]}]))
        policy = {"name": "mine", "latitude": "opengl", "rules": {"triangle.fill-rule": "closed"}}
        path = self.write("mine.json", policy)
        results = self.results(case, "--policy", path, "--against", "exact", expect=UNEXPECTED)
        result = only_result(results["cases"][0])
        self.assertEqual(result["verdict"], "violation")
        told = result["disagreements"]
        self.assertEqual([d["pixel"] for d in told], [[i, i] for i in range(1, 7)])
        for d in told:
            self.assertEqual((d["rule"], d["ruling"], d["cause"]),
                             ("triangle.shared-edge", 5, "triangle.fill-rule=closed"))
            self.assertIn("The policy has it as the renderer does.", d["explanation"])
        # Judged by itself, the policy is kept.
        self.results(case, "--policy", path, "--no-latitude", "--against", "exact")
        self.results(case, "--policy", self.write("mine.json", policy | {"latitude": "none"}),
                     "--against", "exact")
        # For the other surface it says nothing of this case.
        elsewhere = {"name": "mine", "surfaces": {"window": policy["rules"]}}
        self.results(case, "--policy", self.write("window.json", elsewhere), "--against", "exact")

    def test_an_unknown_one_is_told_the_names(self):
        told = self.command("run", SUITE, "--policy", "direct3d", expect=USAGE).stderr
        for policy in ["opengl", *POLICIES]:
            self.assertIn(policy, told)
        self.assertIn('did you mean "direct3d-11"?', told)


class Courses(CommandTest):
    """What courses say, in drawings small enough to be made by hand."""

    def fragments(self, policy, **changes):
        case = self.write("drawn.json", triangle_case(**changes))
        out = self.command("render", case, "--policy", f"{SUITE}/policies/{policy}.json", "--json",
                           "-").stdout
        return json.loads(out)["fragments"]

    def test_edges_of_triangles(self):
        """A square whose outline and diagonal run through centres."""
        for policy, drawing in (("mit-6837", ["00000", "01100", "01010", "00110", "00000"]),
                                ("mit-6837-code", ["11112", "11121", "11211", "12111", "21111"]),
                                ("cs184", ["11112", "11121", "11211", "12111", "21111"]),
                                ("scotty3d", ["11110", "11110", "11110", "11110", "00000"]),
                                ("scotty3d-code", ["11110", "11110", "11110", "11110", "00000"])):
            times = collections.Counter((f["x"], f["y"]) for f in self.fragments(policy, draws=[
                {"primitive": "triangles", "vertices": [[1.5, 1.5], [5.5, 1.5], [5.5, 5.5],
                                                        [1.5, 1.5], [5.5, 5.5], [1.5, 5.5]]}]))
            with self.subTest(policy=policy):
                self.assertEqual(["".join(str(times[x, y]) for x in range(1, 6))
                                  for y in range(5, 0, -1)], drawing)
                self.assertEqual(sum(times.values()), sum(map(int, "".join(drawing))))

    def reds(self, policy, row, level):
        """The lowest row of a generated level, of an image of two equal rows."""
        across = len(row) >> level or 1
        fragments = self.fragments(
            policy, target={"width": across, "height": 1},
            textures=[{"mipmaps": "generated",
                       "texels": [[[red / 255, 0, 0] for red in row]] * 2}],
            draws=[{"primitive": "triangles",
                    "vertices": [{"at": [0, 0], "uv": [0, 0]}, {"at": [0, 2], "uv": [0, 2]},
                                 {"at": [2 * across, 0], "uv": [2, 0]}],
                    "state": {"interpolation": "smooth", "texture": 0, "lookup": {"lod": level},
                              "sampler": {"minify": "nearest", "mipmap": "nearest"}}}])
        return [round(255 * f["color"][0]) for f in sorted(fragments, key=lambda f: f["x"])]

    def test_levels_of_chains(self):
        """log2(min(8, 2)) + 1 = 2 levels, or log2(max(8, 2)) + 1 = 4."""
        row = [0, 8, 16, 24, 32, 40, 48, 56]
        for policy in ("scotty3d", "scotty3d-code"):
            self.assertEqual(self.reds(policy, row, 1), [4, 20, 36, 52])
        self.assertEqual(self.reds("scotty3d", row, 3), [36])
        self.assertEqual(self.reds("scotty3d", row, 2), [20, 52])
        self.assertEqual(self.reds("scotty3d-code", row, 3), [28])
        self.assertEqual(self.reds("scotty3d-code", row, 2), [12, 44])

    def test_texels_of_generated_levels(self):
        """Five texels onto two: centres at 5/4 and 15/4, or boxes that leave out the last one."""
        self.assertEqual(self.reds("scotty3d", [0, 4, 8, 16, 64], 1), [3, 28])
        self.assertEqual(self.reds("scotty3d-code", [0, 4, 8, 16, 64], 1), [2, 12])

    def test_differences_that_make_levels_of_detail(self):
        """In perspective, along x or y: u = 2 x/(64 - 3 x), 64 texels across; v is 1/2."""
        def u(pixel):
            return 2 * (pixel + 0.5) / (64 - 3 * (pixel + 0.5))
        for policy, first in (("scotty3d", lambda x: x), ("scotty3d-code", lambda x: x - x % 2)):
            for along, across in ("xy", "yx"):
                far, near = [16, 0, 0, 4], [0, 16]
                if along == "y":
                    far, near = [0, 16, 0, 4], [16, 0]
                fragments = self.fragments(
                    policy, target={"width": 16, "height": 16},
                    textures=[{"size": [64, 1], "noise": {"seed": 1}, "mipmaps": "box"}],
                    draws=[{"primitive": "triangles",
                            "vertices": [{"at": [0, 0], "uv": [0, 0.5]},
                                         {"at": far, "uv": [2, 0.5]},
                                         {"at": near, "uv": [0, 0.5]}],
                            "state": {"interpolation": "smooth", "texture": 0}}])
                levels = {f[along]: f["level_of_detail"][1] for f in fragments if f[across] == 0}
                with self.subTest(policy=policy, along=along):
                    self.assertGreaterEqual(len(levels), 15)
                    for x, level in levels.items():
                        texels = 64 * (u(first(x) + 1) - u(first(x)))
                        self.assertAlmostEqual(level, math.log2(texels), places=6)


class Alternatives(CommandTest):
    def least_of_rules(self, out):
        """rule -> how many cases at least tell a pair of its alternatives apart."""
        return {rule: int(least.replace(",", "")) for rule, least in re.findall(
            r"^(\S+): \d+ alternatives, every pair told apart by at least ([\d,]+) case", out,
            re.MULTILINE)}

    def test_cases_of_points_tell_alternatives_of_points_apart(self):
        # What the other API clips is told apart beyond the viewport, where clipping's points lie.
        out = self.command("separation", f"{SUITE}/points", f"{SUITE}/clipping/points", "--least",
                           10, expect=UNEXPECTED).stdout
        found = {rule: least for rule, least in self.least_of_rules(out).items()
                 if rule.startswith("point.")}
        self.assertGreaterEqual(len(found), 5)
        self.assertGreaterEqual(min(found.values()), 10, found)

    @unittest.skipIf(COUNT > 1, "a share of the suite has too few cases for this")
    def test_every_pair_is_told_apart_by_ten_cases_and_ties_abound(self):
        out = self.command("separation", *PROBES, "--least", 10).stdout
        cases, share = re.match(r"([\d,]+) cases, \d+ of them \(([\d.]+) %\) with a tie", out).groups()
        self.assertGreaterEqual(int(cases.replace(",", "")), 5000)
        self.assertGreaterEqual(float(share), 30)
        rules = self.least_of_rules(out)
        self.assertGreaterEqual(len(rules), 9)
        for rule, least in rules.items():
            self.assertGreaterEqual(least, 10, rule)

    def test_too_few_cases_are_said_to_be(self):
        out = self.command("separation", ALL_DIFFER, "--least", 1, expect=UNEXPECTED).stdout
        self.assertIn("bresenham and bresenham-toward-zero: 0 cases", out)

    def test_the_core_tells_apart_whatever_the_suite_does(self):
        """The list's head says how much that is; the core, on its own, must reach as much."""
        head = CORE.read_text(encoding="utf-8").splitlines()[1]
        self.command("separation", SUITE, "--suite", "core", "--least", 3)
        out = self.command("separation", SUITE, "--suite", "core", "--cover").stdout
        pairs, rules = re.match(r"# ([\d,]+) pairs of alternatives, the rulings of (\d+) rules",
                                head).groups()
        self.assertGreaterEqual(int(pairs.replace(",", "")), 1800)
        self.assertIn(f"tell apart the {pairs} pairs of alternatives that all tell apart, and touch "
                      f"the rulings of {rules} rules", out)

    def test_a_core_without_one_of_its_cases_is_too_small(self):
        out = self.command("separation", SUITE, "--suite", "core", "--exclude", "lines/*", "--least", 1,
                           expect=UNEXPECTED).stdout
        self.assertIn("bresenham and bresenham-toward-zero: 0 cases", out)

    def test_every_case_of_the_core_is_there(self):
        listed = [line for line in CORE.read_text(encoding="utf-8").splitlines()
                  if not line.startswith("#")]
        self.assertEqual(self.command("run", SUITE, "--suite", "core", "--list").stdout.splitlines(), listed)

    def test_a_suite_without_a_list_is_told(self):
        self.write("cases/one.json", triangle_case())
        run = self.command("run", "cases", "--suite", "core", expect=USAGE)
        self.assertIn("lists no case", run.stderr)

    def test_the_picture_in_the_documents_is_what_the_program_draws(self):
        drawn = self.folder / "drawn.svg"
        self.command("draw", ALL_DIFFER, "--svg", drawn)
        self.assertEqual(drawn.read_bytes(),
                         (ROOT / "reports/images/line-algorithms.svg").read_bytes())

    def test_as_text(self):
        out = self.command("draw", ALL_DIFFER).stdout
        self.assertIn("diamond-exit\n..........\n..........\n...####...\n..........\n", out)
        self.command("draw", ALL_DIFFER, "--rule", "no.rule", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
