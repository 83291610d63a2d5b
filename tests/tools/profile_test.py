# SPDX-License-Identifier: MIT
"""edgecase profile: what it finds of real renderers, and what it does with bad input."""
import json
import unittest

from suite_data import in_full_tier
from support import (AS_EXPECTED, RENDERER, ROOT, SUITE, UNEXPECTED, USAGE, CommandTest,
                     triangle_case, verdicts)

PROFILES = ROOT / "cases" / "profiles"
CORE = (SUITE, "--suite", "core")

# What the core's cases say of llvmpipe otherwise than the random scenes of which the kept profile is.
OTHERWISE = {
    "attribute.smooth": "projection",  # with several samples, lines are interpolated along themselves
    "point.snap": "8-half-up",  # draws what 9-truncate draws, and more
    "texture.level-weight": "exact",  # levels of floats are weighted exactly
    "texture.nearest-level": "even-at-ties",  # levels that a bias makes are rounded to even
    "texture.texel-grid": "none",  # texels of floats are found exactly
}


class Profile(CommandTest):
    def profile(self, *arguments, expect=AS_EXPECTED):
        path = self.folder / "profile.json"
        path.unlink(missing_ok=True)
        self.command("profile", *arguments, "--json", path, expect=expect)
        return json.loads(path.read_text(encoding="utf-8"))

    def assert_is_committed(self, renderer):
        """Of each rule that the core asks, what the suite keeps of the renderer remains, or nothing
        is known."""
        kept = json.loads((PROFILES / (renderer.replace(":", "-") + ".json")).read_text("utf-8"))
        found = self.profile(*CORE, "--against", renderer)
        agreed = 0
        for surface in found["surfaces"]:
            rules = {**kept["rules"], **kept.get("surfaces", {}).get(surface["surface"], {})}
            if renderer != "egl:softpipe":
                rules |= OTHERWISE
            for told in surface["rules"]:
                if told["rule"] not in rules or told["remain"] == "none known":
                    continue
                with self.subTest(renderer=renderer, surface=surface["surface"], rule=told["rule"]):
                    self.assertIn(rules[told["rule"]], told["remain"].split(" or "))
                    agreed += 1
        self.assertGreater(agreed, 25)

    def test_softpipe_is_as_kept(self):
        self.assert_is_committed("egl:softpipe")

    @in_full_tier
    def test_llvmpipe_and_zink_are_as_kept(self):
        for renderer in "egl:llvmpipe", "egl:zink":
            self.assert_is_committed(renderer)

    def test_the_policy_file_is_a_policy(self):
        path = self.folder / "policy.json"
        self.command("profile", f"{SUITE}/triangles/ties", "--against", "exact", "--policy",
                     ROOT / "cases/policies/cs184.json", "--policy-file", path)
        results = self.results(f"{SUITE}/triangles", "--policy", path, "--against",
                               "exact", expect=UNEXPECTED)
        # Closed edges are found, and remain what OpenGL forbids.
        self.assertIn("violation", verdicts(results).values())
        self.assertEqual(json.loads(path.read_text())["rules"]["triangle.fill-rule"], "closed")

    def test_a_summary_of_ten_lines_ends_it(self):
        measure = ("profile", f"{SUITE}/points", f"{SUITE}/triangles/ties", "--against", "exact")
        short = self.command(*measure).stdout.splitlines()
        self.assertLessEqual(len(short), 10)
        self.assertRegex(short[0], r"^exact: ")
        self.assertRegex(short[2], r"^fbo: \d+ rules were asked; (\d+) of \1 drawings are as")
        self.assertEqual(short[3], "  no alternative known: for no rule")
        self.assertTrue(short[-1].startswith("--full prints the tables"))
        full = self.command(*measure, "--full").stdout.splitlines()
        self.assertGreater(len(full), 15)
        self.assertEqual(full[-len(short) + 1:], short[:-1])

    def test_an_absent_renderer(self):
        run = self.command("profile", f"{SUITE}/points", "--against", "exec:false", expect=RENDERER)
        self.assertIn("not measured: crashed", run.stdout)

    def test_bad_arguments(self):
        for arguments, words in (
                (("--against", "egl:nothing"), "there is no renderer"),
                (("--against", "exact", "nowhere/at-all"), "nowhere/at-all"),
                (("--against", "exact", "--scenes", "100"), "--scenes"),
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
