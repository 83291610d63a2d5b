# SPDX-License-Identifier: MIT
"""Answers that change, runs that end early, and running again what failed."""
import re
import unittest
import xml.etree.ElementTree

import results_file
from support import (AS_EXPECTED, NOTHING_SELECTED, RENDERER, UNEXPECTED, USAGE, CommandTest,
                     only_result)

NAMES = ["a", "b", "c", "d"]


class Waverer(CommandTest):
    """Of four cases, a renderer answers one wrongly (or not at all) the first time."""

    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)

    def run_small(self, renderer, *options, expect, jobs=1):
        (self.folder / "truth.jsonl.asked").unlink(missing_ok=True)
        run = self.command("run", "cases", "--against", renderer, "--jobs", jobs, "--json",
                           "results.json", "--junit", "junit.xml", "--html", "report.html",
                           *options, expect=expect)
        results = results_file.read(self.folder / "results.json")
        # How long it took, and how much an earlier run has compared, differs from run to run.
        summary = re.sub(r"(, \d+ answers? as before)?, [\d.]+ s\n(\d+ answers? .* as in .*\n)?",
                         "\n", run.stdout, count=1)
        return {case["id"]: only_result(case) for case in results["cases"]}, summary, results


class Flakes(Waverer):
    def test_both_answers_are_told(self):
        results, out, _ = self.run_small(self.odd_renderer("waver", "b", "cases"),
                                         expect=UNEXPECTED)
        self.assertEqual(results["b"]["standing"], "flake")
        self.assertEqual(results["b"]["verdict"], "violation")
        self.assertEqual(results["b"]["again"], {"verdict": "agree", "fingerprint": ""})
        self.assertEqual({results[name]["standing"] for name in "acd"}, {"expected"})
        words = f"it answered violation {results['b']['fingerprint']}, and when asked again agree"
        self.assertIn(words, out)
        self.assertIn(words, results["b"]["standing_reason"])
        self.assertIn("flake", (self.folder / "report.html").read_text("utf-8"))
        failure = xml.etree.ElementTree.parse(self.folder / "junit.xml").getroot().find(
            ".//testcase[@name='b']/failure")
        self.assertIn("flake", failure.get("message"))
        self.assertIn(words, failure.text)

    def test_a_failure_that_does_not_come_again_is_one(self):
        results, _, _ = self.run_small(self.odd_renderer("die-once", "c", "cases"),
                                       expect=UNEXPECTED)
        self.assertEqual((results["c"]["fingerprint"], results["c"]["standing"]),
                         ("crashed", "flake"))

    def test_who_is_silent_is_started_once(self):
        """A case that comes too late is asked again only of who has answered another: each start
        has its own patience."""
        script = self.write("silent.sh", "echo started >> starts\nexec sleep 1000\n")
        self.command("run", "cases/a.json", "--against", f"exec:sh {script}", "--timeout", "0.05",
                     "--json", "results.json", expect=RENDERER)
        self.assertEqual((self.folder / "starts").read_text("utf-8"), "started\n")
        (case,) = results_file.read(self.folder / "results.json")["cases"]
        self.assertEqual(only_result(case)["failure"]["kind"], "timed-out")

    def test_what_comes_again_leaves_no_trace(self):
        liar = self.odd_renderer("mirror", "", "cases")
        with_reruns = self.run_small(liar, expect=UNEXPECTED)
        files = [(self.folder / name).read_bytes()
                 for name in ("results.json", "junit.xml", "report.html")]
        self.assertEqual(with_reruns, self.run_small(liar, "--no-rerun", expect=UNEXPECTED))
        self.assertEqual(files, [(self.folder / name).read_bytes()
                                 for name in ("results.json", "junit.xml", "report.html")])

    def test_no_rerun(self):
        waverer = self.odd_renderer("waver", "b", "cases")
        results, _, _ = self.run_small(waverer, "--no-rerun", expect=UNEXPECTED)
        self.assertEqual(results["b"]["standing"], "unexpected")
        self.assertNotIn("again", results["b"])

    def test_neither_answer_can_be_blessed(self):
        waverer = self.odd_renderer("waver", "b", "cases")
        self.run_small(waverer, expect=UNEXPECTED)
        out = self.command("bless", "results.json", "--apply").stdout
        self.assertIn(": 0 changes", out)
        self.assertIn("! b: it answered", out)

    def test_an_expected_answer_is_not_asked_for_again(self):
        waverer = self.odd_renderer("waver", "b", "cases")
        self.run_small(waverer, "--no-rerun", expect=UNEXPECTED)
        self.command("bless", "results.json", "--apply")
        self.run_small(waverer, expect=AS_EXPECTED)

    def test_flakes_of_shards_are_merged_as_they_are(self):
        waverer = self.odd_renderer("waver", "b", "cases")
        _, _, whole = self.run_small(waverer, expect=UNEXPECTED)
        (self.folder / "truth.jsonl.asked").unlink()
        for i in (1, 2):
            self.command("run", "cases", "--against", waverer, "--shard", f"{i}/2", "--json",
                         f"{i}.json", expect=None)
        self.command("merge", "1.json", "2.json", "--json", "merged.json", expect=UNEXPECTED)
        self.assertEqual(results_file.read(self.folder / "merged.json"), whole)


class MaxFailures(Waverer):
    def test_ends_after_so_many(self):
        liar = self.odd_renderer("mirror", "", "cases")
        results, out, whole = self.run_small(liar, "--max-failures", "3", expect=UNEXPECTED)
        self.assertEqual(sorted(results), ["a", "b", "c"])
        self.assertEqual((whole["interrupted"], whole["left_out"]), (True, 1))
        self.assertIn("The run was interrupted; 1 case is missing.", out)
        junit = xml.etree.ElementTree.parse(self.folder / "junit.xml").getroot()
        self.assertIn("1 case is missing", junit.find(".//testcase[@name='complete']/error")
                      .get("message"))
        self.assertIn('"left_out":1', (self.folder / "report.html").read_text("utf-8"))

    def test_counts_what_is_unexpected_only(self):
        once = self.odd_renderer("mirror-of", "c", "cases")
        results, _, whole = self.run_small(once, "--max-failures", "2", expect=UNEXPECTED)
        self.assertEqual((sorted(results), whole["interrupted"]), (NAMES, False))
        self.command("bless", "results.json", "--apply")
        _, _, whole = self.run_small(once, "--max-failures", "1", expect=AS_EXPECTED)
        self.assertFalse(whole["interrupted"])

    def test_all_renderers_finish_what_was_begun(self):
        liar = self.odd_renderer("mirror", "", "cases")
        results = self.results("cases", "--against", "exact", "--against", liar, "--jobs", "1",
                               "--max-failures", "1", expect=UNEXPECTED)
        self.assertEqual([len(case["results"]) for case in results["cases"]], [2] * 4)
        results = self.results("cases", "--against", liar, "--against", "exact", "--jobs", "1",
                               "--max-failures", "1", expect=UNEXPECTED)
        self.assertEqual([case["id"] for case in results["cases"]], ["a"])
        self.assertEqual(len(results["cases"][0]["results"]), 2)

    def test_bad_numbers(self):
        for number in ("0", "-1", "x"):
            self.command("run", "cases", "--max-failures", number, expect=USAGE)


class LastFailed(Waverer):
    def failed_again(self, *options, expect):
        run = self.command("run", "cases", "--against", self.renderer, "--last-failed", "--json",
                           "results.json", *options, expect=expect)
        results = results_file.read(self.folder / "results.json")
        return [case["id"] for case in results["cases"]], run.stderr

    def test_only_what_was_not_as_expected(self):
        self.renderer = self.odd_renderer("mirror-of", "c", "cases")
        self.run_small(self.renderer, expect=UNEXPECTED)
        self.assertEqual(self.failed_again(expect=UNEXPECTED), (["c"], ""))
        self.renderer = "exact"
        self.assertEqual(self.failed_again(expect=AS_EXPECTED), (["c"], ""))
        cases, told = self.failed_again(expect=NOTHING_SELECTED)
        self.assertEqual(cases, ["c"], "what an earlier run wrote stays")
        self.assertIn("nothing failed: in results.json all is as expected, 1 case; run without", told)

    def test_without_last_results(self):
        run = self.command("run", "cases", "--last-failed", expect=USAGE)
        self.assertIn("there is no out/results.zst", run.stderr)
        run = self.command("run", "cases", "--last-failed", "--json", "mine.json", expect=USAGE)
        self.assertIn("there is no mine.json", run.stderr)

    def test_a_file_that_could_not_be_loaded_is_tried_again(self):
        self.renderer = "exact"
        good = (self.folder / "cases/b.json").read_text("utf-8")
        self.write("cases/b.json", "{")
        self.run_small("exact", expect=USAGE)
        self.write("cases/b.json", good)
        self.assertEqual(self.failed_again(expect=AS_EXPECTED)[0], ["b"])

    def test_it_lists_and_narrows(self):
        self.renderer = self.odd_renderer("mirror", "", "cases")
        self.run_small(self.renderer, expect=UNEXPECTED)
        run = self.command("run", "cases", "--last-failed", "--json", "results.json", "--list",
                           "--filter", "[bd]")
        self.assertEqual(run.stdout.split(), ["b", "d"])


if __name__ == "__main__":
    unittest.main()
