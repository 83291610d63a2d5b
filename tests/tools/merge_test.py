# SPDX-License-Identifier: MIT
"""Shards, merged, are the whole run to the byte; what does not belong together is refused; CI
systems' variables ask for shards."""
import unittest

import results_file
from suite_data import IS_QUICK
from support import (AS_EXPECTED, INTERNAL, NOTHING_SELECTED, SUITE, UNEXPECTED, USAGE,
                     CommandTest, only_result, triangle_case)

RENDERERS = ["--against", "egl:llvmpipe", "--against", "egl:softpipe"]
# Lines and joints, both surfaces, samples, ramps, and pictures large enough to be folded.
FOLDERS = ["lines/joints", "lines/directions", "lines/ends", "samples/shading",
           "surfaces/lines.json", "textures/scenes", "colors/smooth", "scenes/floor.json"]
if IS_QUICK:
    FOLDERS = ["lines/joints", "samples/shading", "surfaces/lines.json"]
PATHS = [f"{SUITE}/{folder}" for folder in FOLDERS]
SHARDS = 4


class Merge(CommandTest):
    def run_to(self, name, *arguments, expect=AS_EXPECTED, **variables):
        self.command("run", *arguments, "--json", f"{name}.json", "--junit", f"{name}.xml",
                     "--html", f"{name}.html", expect=expect, **variables)

    def shards(self, *arguments, expect=None):
        for i in range(1, SHARDS + 1):
            self.run_to(f"part{i}", *arguments, "--shard", f"{i}/{SHARDS}", expect=expect)
        return [f"part{i}.json" for i in range(1, SHARDS + 1)]

    def merge_to(self, name, *arguments, expect=AS_EXPECTED):
        return self.command("merge", *arguments, "-o", f"{name}.json", "--junit", f"{name}.xml",
                            "--html", f"{name}.html", expect=expect)

    def assert_same_files(self, a, b):
        for suffix in ("json", "xml", "html"):
            one, other = ((self.folder / f"{name}.{suffix}").read_bytes() for name in (a, b))
            self.assertTrue(one == other, f"{a}.{suffix} and {b}.{suffix} differ")

    def complaint(self, *arguments, expect=USAGE):
        run = self.command("merge", *arguments, "--json", "never.json", expect=expect)
        self.assertFalse((self.folder / "never.json").exists())
        self.assertEqual(len(run.stderr.splitlines()), 1, run.stderr)
        return run.stderr

    def small_suite(self):
        """Cases that differ in a way that is not expected, some of them."""
        self.write_cases("a", "b", "c", "d", "e")
        return self.odd_renderer("mirror", "", "cases")

    def test_four_shards_are_the_whole_run(self):
        self.run_to("whole", *PATHS, *RENDERERS)
        parts = self.shards(*PATHS, *RENDERERS)
        shard = results_file.head_of(self.folder / parts[1])["shard"]
        self.assertEqual((shard["index"], shard["count"]), (2, SHARDS))
        self.merge_to("merged", *reversed(parts))
        self.assert_same_files("whole", "merged")
        self.assertNotIn("shard", results_file.head_of(self.folder / "merged.json"))

    def test_what_is_unexpected_and_strict_is_merged_too(self):
        renderer = self.small_suite()
        self.write("cases/bad.json", "{")
        arguments = ["cases", "--against", renderer, "--no-latitude"]
        self.run_to("whole", *arguments, expect=USAGE)
        parts = self.shards(*arguments)
        run = self.merge_to("merged", *parts, expect=USAGE)
        self.assert_same_files("whole", "merged")
        self.assertEqual(run.stderr.count("bad.json"), 1, "told once")
        (self.folder / "cases/bad.json").unlink()
        parts = self.shards(*arguments)
        self.merge_to("merged", *parts, expect=UNEXPECTED)

    def test_a_fault_of_a_later_case_is_told_by_shards_with_cases_of_its_file(self):
        renderer = self.small_suite()
        width = {"set": ["/target/width"], "values": [8, 9, 0]}
        self.write("cases/bad.json", triangle_case(sweep={"width": width}))
        arguments = ["cases", "--against", renderer]
        self.run_to("whole", *arguments, expect=USAGE)
        parts = self.shards(*arguments)
        runs = [self.command("run", *arguments, "--shard", f"{i}/{SHARDS}", "--list", expect=None)
                for i in range(1, SHARDS + 1)]
        telling = ["bad.json" in run.stderr for run in runs]
        self.assertTrue(any(telling) and not all(telling), telling)
        self.assertEqual([run.returncode == USAGE for run in runs], telling)
        self.merge_to("merged", *parts, expect=USAGE)
        self.assert_same_files("whole", "merged")

    def test_known_faults_are_those_of_the_suite(self):
        renderer = self.small_suite()
        parts = self.shards("cases", "--against", renderer)
        self.merge_to("merged", *parts, expect=UNEXPECTED)
        self.command("bless", "merged.json", "--apply")
        self.merge_to("merged", *parts)
        self.run_to("whole", "cases", "--against", renderer)
        self.assert_same_files("whole", "merged")

    def test_missing_shards(self):
        parts = self.shards("cases", "--against", self.small_suite())
        self.assertIn("shard 3/4 is missing", self.complaint(parts[0], parts[1], parts[3]))
        run = self.merge_to("some", parts[0], parts[1], "--partial", expect=UNEXPECTED)
        self.assertIn("3 cases are missing", run.stdout)
        some = results_file.read(self.folder / "some.json")
        self.assertEqual((some["interrupted"], some["left_out"]), (True, 3))

    def test_refusals(self):
        self.small_suite()
        parts = self.shards("cases", "--against", "exact")
        for arguments, said in (((parts[0], parts[0]), "both hold shard 1 of 4"),
                                ((parts[0], "cases/a.json"), "no results file")):
            self.assertIn(said, self.complaint(*arguments))
        self.assertIn("cannot read gone.json",
                      self.complaint(parts[0], "gone.json", expect=INTERNAL))
        first = results_file.read(self.folder / parts[0])

        def refused(said, **changes):
            self.write_results(
                "other.json", {**first, "shard": {**first["shard"], "index": 2}, **changes})
            self.assertIn(said, self.complaint(parts[0], "other.json"))
        refused("other.json by edgecase 9", tool="edgecase 9")
        refused("by policy cs184", policy="cs184")
        refused("without latitude", latitude="none")
        refused("policies or profiles that differ", policy_digest="0" * 16)
        refused("is in", whole_suite=True)

    def test_suites_that_differ(self):
        self.write_cases("a", "b", "c", "d")
        self.run_to("one", "cases", "--against", "exact", "--shard", "1/2")
        text = (self.folder / "cases/d.json").read_text("utf-8")
        self.write("cases/d.json", text.replace("6.25", "6.5"))
        self.run_to("two", "cases", "--against", "exact", "--shard", "2/2")
        self.assertIn("different selections or suites", self.complaint("one.json", "two.json"))

    def test_parts_of_a_suite_that_are_no_shards(self):
        self.write_cases("x/a", "y/b")
        for name in ("x", "y"):
            self.run_to(name, f"cases/{name}", "--against", "exact")
        self.run_to("whole", "cases/x", "cases/y", "--against", "exact")
        self.merge_to("merged", "y.json", "x.json")
        self.assert_same_files("whole", "merged")
        self.assertIn("the case x/a is in", self.complaint("x.json", "whole.json"))


class ShardVariables(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases("a", "b", "c", "d")

    def listed(self, *arguments, **variables):
        run = self.command("run", "cases", "--list", *arguments, **variables)
        return run.stdout.split(), run.stderr

    def test_they_are_obeyed_and_said(self):
        cases, told = self.listed(TEST_TOTAL_SHARDS="2", TEST_SHARD_INDEX="1")
        self.assertEqual(cases, ["c", "d"])
        self.assertIn("TEST_TOTAL_SHARDS and TEST_SHARD_INDEX ask for shard 2/2", told)
        cases, told = self.listed(CI_NODE_TOTAL="2", CI_NODE_INDEX="1")
        self.assertEqual(cases, ["a", "b"])
        self.assertIn("CI_NODE_TOTAL and CI_NODE_INDEX ask for shard 1/2", told)
        self.assertEqual(self.listed("--shard", "1/4", CI_NODE_TOTAL="2", CI_NODE_INDEX="x"),
                         (["a"], ""))
        self.assertEqual(self.listed(CI_NODE_TOTAL="1"), (["a", "b", "c", "d"], ""))

    def test_what_is_wrong_with_them(self):
        for variables, said in (
                ({"TEST_TOTAL_SHARDS": "2"}, "TEST_SHARD_INDEX is not"),
                ({"CI_NODE_INDEX": "2"}, "CI_NODE_TOTAL is not"),
                ({"CI_NODE_TOTAL": "2", "CI_NODE_INDEX": "0"}, "CI_NODE_INDEX is \"0\""),
                ({"TEST_TOTAL_SHARDS": "2", "TEST_SHARD_INDEX": "0", "CI_NODE_TOTAL": "2",
                  "CI_NODE_INDEX": "2"}, "unset one pair, or say --shard")):
            run = self.command("run", "cases", "--list", expect=USAGE, **variables)
            self.assertIn(said, run.stderr)

    def test_other_commands_do_not_obey(self):
        run = self.command("render", "cases", "--json", "-", TEST_TOTAL_SHARDS="2",
                           TEST_SHARD_INDEX="0")
        self.assertEqual(len(run.stdout.splitlines()), 4)

    def test_bazels_status_file(self):
        self.listed(TEST_TOTAL_SHARDS="2", TEST_SHARD_INDEX="0",
                    TEST_SHARD_STATUS_FILE=str(self.folder / "status"))
        self.assertTrue((self.folder / "status").exists())

    def test_a_run_says_which_shard_it_is(self):
        results = self.results("cases", "--against", "exact", CI_NODE_TOTAL="4", CI_NODE_INDEX="3")
        self.assertEqual([case["id"] for case in results["cases"]], ["c"])
        self.assertEqual({k: results["shard"][k] for k in ("index", "count", "cases")},
                         {"index": 3, "count": 4, "cases": 4})
        self.assertEqual(only_result(results["cases"][0])["verdict"], "agree")
        self.assertNotIn("shard", self.results("cases", "--against", "exact"))
        self.command("run", "cases", expect=NOTHING_SELECTED, CI_NODE_TOTAL="9", CI_NODE_INDEX="9")


if __name__ == "__main__":
    unittest.main()
