# SPDX-License-Identifier: MIT
"""edgecase fuzz: what it finds of a real renderer, what it saves, and bad input."""
import json
import time
import unittest

from support import (AS_EXPECTED, RENDERER, ROOT, UNEXPECTED, USAGE, CommandTest, triangle_case)

SOFTPIPE = "egl:softpipe"
# The command looks for policies and profiles in the folder cases below where it runs.
PROFILE = ("--policy", ROOT / "cases" / "profiles" / "egl-softpipe.json")


class Fuzz(CommandTest):
    def fuzz(self, *arguments, expect=UNEXPECTED):
        path = self.folder / "finds.json"
        path.unlink(missing_ok=True)
        self.command("fuzz", "--against", SOFTPIPE, "--max-asks", 60, *arguments, "--json", path,
                     expect=expect)
        return json.loads(path.read_text(encoding="utf-8"))

    def test_saves_what_it_finds_and_it_runs_as_a_case(self):
        report = self.fuzz(*PROFILE, "--rules", "lines,shared-edges", "--count", 2000,
                           "--verdict", "violation", "--surface", "fbo", "--save", "found")
        self.assertEqual(report["scenes"], 2000)
        self.assertEqual(sorted(report["families"]), ["lines", "shared-edges"])
        self.assertTrue(report["finds"])
        rules = {find["rule"] for find in report["finds"]}
        self.assertIn("triangle.shared-edge", rules)
        for find in report["finds"]:
            self.assertEqual(find["verdict"], "violation")
            case = json.loads((self.folder / find["file"]).read_text(encoding="utf-8"))
            self.assertEqual(case["rules"], [find["rule"]])
            self.assertIn(f"{SOFTPIPE}: violation", case["why"])
            self.assertIn("fuzz", case["tags"])
        self.command("validate", "found")
        run = self.results("found", "--against", SOFTPIPE, *PROFILE, expect=UNEXPECTED)
        verdicts = {case["results"][SOFTPIPE]["verdict"] for case in run["cases"]}
        self.assertEqual(verdicts, {"violation"})

        # Again: what the files show is known.
        again = self.fuzz(*PROFILE, "--rules", "lines,shared-edges", "--count", 2000,
                          "--verdict", "violation", "--surface", "fbo", "--known", "found",
                          expect=AS_EXPECTED)
        self.assertEqual(again["finds"], [])
        self.assertGreater(again["renderers"][0]["known"], 0)

    def test_is_the_same_for_any_number_of_threads(self):
        few = (*PROFILE, "--rules", "shared-edges", "--count", 600, "--verdict", "violation")
        self.assertEqual(self.fuzz(*few, "--jobs", 1), self.fuzz(*few, "--jobs", 3))

    def test_agrees_with_itself(self):
        run = self.command("fuzz", "--against", "exact", "--count", 400, "--seed", 3)
        self.assertIn("400 scenes in ", run.stdout)
        self.assertIn("finds: none", run.stdout)

    def test_searches_all_of_its_time_where_nothing_is_found(self):
        start = time.monotonic()
        self.command("fuzz", "--against", "exact", "--rules", "points", "--seconds", 2)
        self.assertGreaterEqual(time.monotonic() - start, 2)

    def test_mutates_a_corpus(self):
        self.write("corpus/triangle.json", triangle_case())
        run = self.command("fuzz", "--against", "exact", "--rules", "points", "--count", 300,
                           "--corpus", "corpus", "--json", "-")
        self.assertGreater(json.loads(run.stdout)["families"]["mutated"], 30)

    def test_refuses_bad_input(self):
        self.write("broken.json", "{")
        self.write("no-finds.json", '{"finds": [{"renderer": 1}]}')
        self.write("gone/a.json", triangle_case(rules=["triangle.fill-rule"], surprise=1))
        for arguments, words in (
                (["--against", "egl:swrast"], ["egl:swrast", "egl:softpipe"]),
                (["--against", "exact", "--rules", "linse"], ["linse", "shared-edges"]),
                (["--against", "exact", "--seconds", "0"], ["--seconds"]),
                (["--against", "exact", "--exhaustive", "--rules", "points"],
                 ["--exhaustive", "grid-lines"]),
                (["--against", "exact", "--exhaustive", "--corpus", "cases"], ["--corpus"]),
                (["--against", "exact", "--count", "no"], ["--count"]),
                (["--against", "exact", "--corpus", "broken.json"], ["broken.json"]),
                (["--against", "exact", "--corpus", "gone"], ["surprise"]),
                (["--against", "exact", "--known", "no-finds.json"], ["no-finds.json"]),
                (["--against", "exact", "--known", "missing.json"], ["missing.json"]),
                (["--against", "exact", "--policy", "none"], ["none"]),
                (["--against", "exact", "--verdict", "agree"], ["--verdict"])):
            with self.subTest(arguments=arguments):
                run = self.command("fuzz", "--count", "1", *arguments, expect=None) \
                    if "--count" not in arguments else self.command("fuzz", *arguments, expect=None)
                self.assertEqual(run.returncode, USAGE, run.stderr)
                for word in words:
                    self.assertIn(word, run.stderr)

    def test_says_when_a_renderer_draws_nothing(self):
        run = self.command("fuzz", "--against", "exec:/bin/false", "--count", 50, expect=RENDERER)
        self.assertIn("0 drawn", run.stdout)


if __name__ == "__main__":
    unittest.main()
