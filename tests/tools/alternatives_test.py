# SPDX-License-Identifier: MIT
"""Policies, and whether the suite tells alternatives apart: --policy, separation, draw."""
import re
import unittest

from suite_data import COUNT, shard
from support import (PROBES, ROOT, SUITE, UNEXPECTED, USAGE, CommandTest, only_result,
                     triangle_case, verdicts)

POLICIES = sorted(path.stem for path in (ROOT / "cases/policies").glob("*.json"))
ALL_DIFFER = f"{SUITE}/lines/algorithms/all-differ.json"


class Policies(CommandTest):
    def test_there_are_those_of_the_design(self):
        self.assertEqual(POLICIES, ["cs184", "direct3d-11", "mit-6837", "scotty3d",
                                    "vulkan-strict"])

    def test_exact_under_each_agrees_with_itself(self):
        # A fifth each, and all of this share of the suite together.
        for part, policy in enumerate(POLICIES, 1):
            with self.subTest(policy=policy):
                results = self.results(*PROBES, "--policy", policy, "--against", "exact",
                                       *shard(part, len(POLICIES)))
                self.assertEqual(results["policy"], policy)
                self.assertEqual(set(verdicts(results).values()), {"agree"})

    def test_each_draws_its_own_picture(self):
        folders = [f"{SUITE}/{name}" for name in ("lines", "points", "triangles")]
        pictures = {self.command("render", *folders, "--policy", policy, "--json", "-").stdout
                    for policy in ["opengl", *POLICIES]}
        self.assertEqual(len(pictures), 1 + len(POLICIES))

    def test_none_grants_latitude(self):
        for policy in POLICIES:
            results = self.results(f"{SUITE}/triangles/ties", "--policy", policy, "--against",
                                   "osmesa:softpipe", expect=UNEXPECTED)
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


class Alternatives(CommandTest):
    def least_of_rules(self, out):
        """rule -> how many cases at least tell a pair of its alternatives apart."""
        return {rule: int(least.replace(",", "")) for rule, least in re.findall(
            r"^(\S+): \d+ alternatives, every pair told apart by at least ([\d,]+) case", out,
            re.MULTILINE)}

    def test_cases_of_points_tell_alternatives_of_points_apart(self):
        out = self.command("separation", f"{SUITE}/points", "--least", 10, expect=UNEXPECTED).stdout
        found = {rule: least for rule, least in self.least_of_rules(out).items()
                 if rule.startswith("point.")}
        self.assertGreaterEqual(len(found), 4)
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
