# SPDX-License-Identifier: MIT
"""edgecase profile: what it finds of real renderers, and what it does with bad input."""
import json
import unittest

from suite_data import IS_QUICK, in_full_tier, in_share
from support import (AS_EXPECTED, RENDERER, ROOT, SUITE, UNEXPECTED, USAGE, CommandTest,
                     triangle_case, verdicts)

PROFILES = ROOT / "cases" / "profiles"
FEW = ("--scenes", "600")
FEWEST = ("--scenes", "100" if IS_QUICK else "200")


class Profile(CommandTest):
    def profile(self, renderer, *arguments, expect=AS_EXPECTED):
        path = self.folder / "profile.json"
        path.unlink(missing_ok=True)
        self.command("profile", "--against", renderer, *arguments, "--json", path, expect=expect)
        return json.loads(path.read_text(encoding="utf-8"))

    def traits(self, profile, surface):
        [found] = [s for s in profile["surfaces"] if s["surface"] == surface]
        return {trait["id"]: trait for trait in found["traits"]}

    def decided(self, profile, expected, surface):
        """The rules that some scene asks, and every such scene agrees with: windows of EGL have no
        depths to offset, for instance. What is followed must be what the committed profile says, or
        as good on these few scenes. Where nothing in the catalogue draws all scenes, which
        alternative comes closest takes more scenes to say than a test has."""
        rules = {**expected["rules"], **expected.get("surfaces", {}).get(surface, {})}
        found = set()
        for rule, trait in self.traits(profile, surface).items():
            rate = trait["agreement"]
            if rule not in rules or not rate["of"] or rate["agreeing"] < rate["of"]:
                continue
            follows = {trait["follows"]}
            if trait.get("runner_up_agreement") == rate:
                follows.add(trait["runner_up"])
            self.assertIn(rules[rule], follows, f"{surface} {rule}")
            found.add(rule)
        return found

    @unittest.skipIf(IS_QUICK, "the full tier asks this")
    def test_two_seeds_find_what_is_committed(self):
        """Each seed in a part of its own."""
        triangles = {"triangle.algorithm", "triangle.row-order", "triangle.snap"}
        for renderer, known in (
                ("egl:softpipe",
                 triangles | {"point.offset", "point.ownership", "point.row-order", "point.snap",
                              "line.algorithm", "line.row-order", "line.snap"}),
                ("egl:llvmpipe", triangles | {"triangle.fill-rule"})):
            file = PROFILES / (renderer.replace(":", "-") + ".json")
            expected = json.loads(file.read_text(encoding="utf-8"))
            for seed in in_share(("11", "12")):
                with self.subTest(renderer=renderer, seed=seed):
                    profile = self.profile(renderer, *FEW, "--seed", seed)
                    for surface in ("fbo", "window"):
                        self.assertLessEqual(known, self.decided(profile, expected, surface))

    @in_full_tier
    def test_softpipe_tears_shared_edges(self):
        traits = self.traits(self.profile("egl:softpipe", *FEW, "--surface", "fbo"), "fbo")
        shared = traits["triangle.shared-edge"]
        self.assertLess(shared["agreement"]["agreeing"], shared["agreement"]["of"])
        self.assertRegex(shared["remark"],
                         r"^violation of ruling 5: \d+ holes and \d+ double hits; triangles \d+ "
                         r"and \d+ hit pixel \(\d+, \d+\) [02] times in triangle")

    def test_is_the_same_every_time(self):
        outputs = {self.command("profile", "--against", "egl:softpipe", *FEWEST,
                                "--jobs", jobs, "--json", "-").stdout for jobs in ("1", "2")}
        self.assertEqual(len(outputs), 1)

    def test_the_policy_file_is_a_policy(self):
        path = self.folder / "policy.json"
        self.command("profile", "--against", "exact", "--policy",
                     ROOT / "cases/policies/cs184.json", *FEWEST, "--policy-file", path)
        results = self.results(f"{SUITE}/triangles", "--policy", path, "--against",
                               "exact", expect=UNEXPECTED)
        # Closed edges are found, and remain what OpenGL forbids.
        self.assertIn("violation", verdicts(results).values())
        self.assertEqual(json.loads(path.read_text())["rules"]["triangle.fill-rule"], "closed")

    @in_full_tier
    def test_every_smallest_scene_is_a_case(self):
        profile = self.profile("egl:softpipe", *FEW, "--surface", "fbo")
        clusters = profile["surfaces"][0]["clusters"]
        self.assertGreater(len(clusters), 3)
        for i, cluster in enumerate(clusters):
            self.write(f"cases/found-{i}.json", cluster["case"])
        self.command("validate", "cases")
        results = self.results("cases", "--against", "egl:softpipe", expect=UNEXPECTED)
        found = verdicts(results)
        for i, cluster in enumerate(clusters):
            if cluster["legality"] == "legal":
                continue
            # How lines are read depends on the whole run, so that a line alone may be allowed.
            about_a_line = "line." in cluster["title"]
            allowed = {"violation", "permitted", "convention"} if about_a_line else {"violation"}
            self.assertIn(found[f"found-{i}"], allowed, cluster["title"])

    def test_a_summary_of_ten_lines_ends_it(self):
        measure = ("profile", "--against", "exact", *FEWEST)
        short = self.command(*measure).stdout.splitlines()
        self.assertEqual(len(short), 10)
        self.assertRegex(short[0], r"^exact: ")
        self.assertRegex(short[2], r"^fbo: \d+ of \d+ traits that were asked hold in every scene")
        self.assertEqual(short[4], "  outside the specification: nothing")
        self.assertTrue(short[-1].startswith("--full prints the tables"))
        full = self.command(*measure, "--full").stdout.splitlines()
        self.assertGreater(len(full), 50)
        self.assertEqual(full[-9:], short[:-1])
        self.assertIn("--full", self.command(*measure, "--clusters", "3", expect=USAGE).stderr)

    def test_an_absent_renderer(self):
        run = self.command("profile", "--against", "exec:false", "--scenes", "100",
                           expect=RENDERER)
        self.assertIn("not measured: unavailable", run.stdout)

    def test_bad_arguments(self):
        for arguments, words in (
                (("--against", "egl:nothing"), "there is no renderer"),
                (("--against", "exact", "--scenes", "1"), "--scenes"),
                (("--against", "exact", "--surface", "moon"), "--surface"),
                ((), "--against is required")):
            with self.subTest(arguments=arguments):
                run = self.command("profile", *arguments, expect=USAGE)
                self.assertIn(words, run.stderr)


class ProfilePolicy(CommandTest):
    def test_is_that_of_the_one_renderer(self):
        """softpipe agrees with its own profile wherever that is legal, and is not excused else."""
        results = self.results(f"{SUITE}/triangles", "--against", "egl:softpipe",
                               "--policy", "profile", expect=None)
        found = set(verdicts(results).values())
        self.assertIn("agree", found)
        self.assertNotIn("convention", found)

    def test_needs_one_renderer_with_a_profile(self):
        run = self.command("run", f"{SUITE}/points", "--policy", "profile", "--against",
                           "egl:softpipe", "--against", "egl:llvmpipe", expect=USAGE)
        self.assertIn("name one with --against", run.stderr)
        self.write("cases/one.json", triangle_case())
        run = self.command("run", "cases", "--policy", "profile", "--against", "exact",
                           expect=USAGE)
        self.assertIn("edgecase profile --against exact --policy-file", run.stderr)


if __name__ == "__main__":
    unittest.main()
