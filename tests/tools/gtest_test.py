# SPDX-License-Identifier: MIT
"""edgecase-gtest: the suite as a GoogleTest program, driven as deqp-runner, ctest and Bazel do it.

The renderer is the README's example, which is wrong on shared edges and refuses lines. Around it a
shell keeps every request, and says when it is started."""
import json
import pathlib
import re
import sys
import tomllib
import unittest
import xml.etree.ElementTree as ET

from support import (AS_EXPECTED, BIN, NOTHING_SELECTED, ROOT, UNEXPECTED, USAGE, CommandTest,
                     triangle_case)

GTEST = str(BIN / "edgecase-gtest")
RESULT = re.compile(r"^\[ +(OK|FAILED|SKIPPED) +\] (\S+) \(\d+ ms\)$", re.MULTILINE)

PLAIN, SHARED, LINE = "plain", "edges/shared", "some-lines/one"
# The names of their tests.
NAMES = {PLAIN: "cases.plain", SHARED: "edges.shared", LINE: "some_lines.one",
         "swept:dx=-0.5": "cases.swept/dx=_0_5", "swept:dx=1": "cases.swept/dx=1"}


class GoogleTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write(f"cases/{PLAIN}.json", triangle_case())
        self.write("cases/swept.json", triangle_case(
            sweep={"dx": {"add_to": ["/draws/0/vertices/1/x"], "values": [-0.5, 1]}}))
        self.write(f"cases/{SHARED}.json", triangle_case(draws=[{
            "primitive": "triangles",
            "vertices": [[1, 1], [6, 1], [1, 6], [6, 1], [6, 6], [1, 6]]}]))
        self.write(f"cases/{LINE}.json", triangle_case(rules=["line.diamond-exit"], draws=[
            {"primitive": "lines", "vertices": [[0.5, 1.5], [4.5, 1.5]]}]))
        example = ROOT / "reference/examples/triangles.py"
        script = self.write("asked.sh", "echo started >> starts\ntee -a requests | "
                                        f"{sys.executable} {example}\n")
        self.renderer = f"exec:sh {script}"

    def gtest(self, *arguments, expect=AS_EXPECTED, **variables):
        """Runs the program; test -> OK, FAILED or SKIPPED, and what it printed."""
        told = self.command("--against", self.renderer, *arguments, program=GTEST, expect=expect,
                            **variables)
        found = RESULT.findall(told.stdout.split("Global test environment tear-down")[0])
        return {test: result for result, test in found}, told.stdout

    def listed(self, *arguments, expect=AS_EXPECTED, **variables):
        """The tests as deqp-runner reads them: suites end in a dot, their tests are set in."""
        suite, tests = "", []
        told = self.command(*arguments, "--gtest_list_tests", program=GTEST, expect=expect,
                            **variables)
        for line in told.stdout.splitlines():
            if line.startswith("  "):
                tests.append(suite + line.strip())
            else:
                self.assertRegex(line, r"^\S+\.$")
                suite = line
        return tests

    def asked(self):
        """The ids of the cases that the renderer was asked for, and how often it was started;
        both are forgotten."""
        requests, starts = self.folder / "requests", self.folder / "starts"
        if not starts.exists():
            return set(), 0
        ids = {json.loads(line)["id"] for line in requests.read_text("utf-8").splitlines()}
        count = len(starts.read_text("utf-8").splitlines())
        requests.unlink()
        starts.unlink()
        return ids, count

    def test_a_list_names_every_case_and_draws_none(self):
        tests = self.listed("--against", self.renderer)
        self.assertEqual(sorted(tests), sorted(NAMES.values()))
        self.assertEqual(self.asked(), (set(), 0))

    def test_the_suite_has_names_that_are_names(self):
        tests = self.listed(ROOT / "cases/lines", ROOT / "cases/points")
        ids = self.command("run", "--list", ROOT / "cases/lines", ROOT / "cases/points")
        self.assertEqual(len(set(tests)), len(ids.stdout.splitlines()))
        for test in tests:
            self.assertRegex(test, r"^[A-Za-z0-9_/=]+\.[A-Za-z0-9_/=]+$")

    def test_two_ids_of_one_name_are_two_tests(self):
        self.write_cases("a-b", "a_b")
        self.assertLessEqual({"cases.a_b", "cases.a_b_2"}, set(self.listed()))
        told, _ = self.gtest("--gtest_filter=cases.a_b:cases.a_b_2")
        self.assertEqual(told, {"cases.a_b": "OK", "cases.a_b_2": "OK"})

    def test_all_run_as_one_run(self):
        told, text = self.gtest("--gtest_output=xml:told.xml", "--jobs", "1", expect=UNEXPECTED)
        self.assertEqual(told, {NAMES[PLAIN]: "OK", NAMES["swept:dx=-0.5"]: "OK",
                                NAMES["swept:dx=1"]: "OK", NAMES[SHARED]: "FAILED",
                                NAMES[LINE]: "SKIPPED"})
        self.assertIn("one sample, flat triangles, last vertex", text)
        self.assertIn("lies exactly on", text)
        self.assertIn("triangle.fill-rule=closed", text)
        self.assertRegex(text, rf"cases/{SHARED}.json:1: Failure\nFailed\n{SHARED}, ")
        ids, starts = self.asked()
        self.assertEqual(ids, set(NAMES))
        # The unexpected answer is asked for again, as in a run: of another process.
        self.assertEqual(starts, 2)
        properties = {test.get("classname") + "." + test.get("name"):
                      test.find("properties/property").get("value")
                      for test in ET.parse(self.folder / "told.xml").iter("testcase")}
        self.assertEqual(properties, {name: id for id, name in NAMES.items()})

    def test_a_filter_asks_for_what_it_selects(self):
        """As deqp-runner has it, a group by whole names, and as a person has it."""
        group = [PLAIN, "swept:dx=1"]
        told, _ = self.gtest("--gtest_filter=" + ":".join(NAMES[id] for id in group))
        self.assertEqual(told, {NAMES[id]: "OK" for id in group})
        self.assertEqual(self.asked(), (set(group), 1))
        told, _ = self.gtest("--gtest_filter=cases.*-*dx=1")
        self.assertEqual(set(told), {NAMES[PLAIN], NAMES["swept:dx=-0.5"]})
        self.assertEqual(self.asked()[0], {PLAIN, "swept:dx=-0.5"})
        self.assertEqual(self.gtest("--gtest_filter=no.such")[0], {})
        self.assertEqual(self.asked(), (set(), 0))

    def test_shards_ask_for_each_case_once(self):
        told = {}
        for index in range(2):
            part, _ = self.gtest(expect=None, GTEST_TOTAL_SHARDS="2", GTEST_SHARD_INDEX=str(index),
                                 TEST_TOTAL_SHARDS="2", TEST_SHARD_INDEX=str(index))
            self.assertFalse(told.keys() & part.keys())
            self.assertEqual(self.asked()[0], {id for id, name in NAMES.items() if name in part})
            self.assertGreater(len(part), 0)
            told |= part
        self.assertEqual(set(told), set(NAMES.values()))

    def test_several_renderers_have_suites_of_their_own(self):
        told, _ = self.gtest("--against", "exact", expect=UNEXPECTED)
        ours = "exec_sh_" + re.sub(r"[^A-Za-z0-9/=]", "_", str(self.folder / "asked.sh"))
        self.assertEqual(told["exact/" + NAMES[SHARED]], "OK")
        self.assertEqual(told[f"{ours}/{NAMES[SHARED]}"], "FAILED")
        self.asked()
        told, _ = self.gtest("--against", "exact", f"--gtest_filter=exact/{NAMES[SHARED]}")
        self.assertEqual(told, {"exact/" + NAMES[SHARED]: "OK"})
        self.assertEqual(self.asked(), (set(), 0))

    def test_a_known_fault_passes_and_is_told(self):
        self.write("known.json", {"driver": self.renderer, "faults": [
            {"id": "closed", "rule": "triangle.shared-edge", "cases": ["edges"],
             "reason": "Both triangles draw what lies on their edge."}]})
        told, text = self.gtest("--known", "known.json", f"--gtest_filter={NAMES[SHARED]}")
        self.assertEqual(told, {NAMES[SHARED]: "OK"})
        self.assertIn("known fault: Both triangles draw what lies on their edge. (closed)", text)

    def test_a_renderer_that_does_not_answer_fails(self):
        self.renderer = "exec:false"
        told, text = self.gtest(expect=UNEXPECTED)
        self.assertEqual(set(told.values()), {"FAILED"})
        self.assertIn("without ever answering", text)

    def test_a_file_that_cannot_be_loaded_is_a_test_that_fails(self):
        self.write("cases/broken.json", '{\n"title": "Broken"\n')
        test = "case_files.cases/broken_json"
        self.assertIn(test, self.listed())
        told, text = self.gtest(f"--gtest_filter={test}:{NAMES[PLAIN]}", expect=UNEXPECTED)
        self.assertEqual(told, {test: "FAILED", NAMES[PLAIN]: "OK"})
        self.assertRegex(text, r"cases/broken.json:\d+: Failure")

    def test_mistakes(self):
        for arguments, code, words in (
                (["--agianst", "exact"], USAGE, "did you mean --against? `edgecase-gtest --help`"),
                (["--against", "exat"], USAGE, "did you mean exact?"),
                (["nosuch"], USAGE, "there is no such file, folder or case"),
                (["--filter", "no*such"], NOTHING_SELECTED, "no case is selected")):
            told = self.command(*arguments, program=GTEST, expect=code)
            self.assertIn(words, told.stderr)

    def test_ctest_discovers_the_tests(self):
        self.write("CMakeLists.txt", f"""cmake_minimum_required(VERSION 3.25)
project(mine LANGUAGES CXX)
enable_testing()
include(GoogleTest)
add_executable(edgecase-gtest IMPORTED)
set_target_properties(edgecase-gtest PROPERTIES IMPORTED_LOCATION {GTEST})
gtest_discover_tests(edgecase-gtest DISCOVERY_MODE PRE_TEST
  WORKING_DIRECTORY ${{CMAKE_SOURCE_DIR}} EXTRA_ARGS --against "{self.renderer}")
""")
        self.command("-S", ".", "-B", "build", "-G", "Ninja", program="cmake")
        told = self.command("--test-dir", "build", program="ctest", expect=8).stdout
        self.assertIn("80% tests passed, 1 tests failed out of 5", told)
        for id, result in ((PLAIN, "Passed"), (SHARED, "Failed"), (LINE, "Skipped")):
            self.assertRegex(told, rf"{re.escape(NAMES[id])} \.+[* ]*{result}")

    def test_the_suite_for_deqp_runner(self):
        """What tools/ci/mesa gives to deqp-runner: the program, and its options by variables."""
        with open(ROOT / "tools/ci/mesa/deqp-llvmpipe-edgecase.toml", "rb") as file:
            (suite,) = tomllib.load(file)["gtest"]
        self.assertEqual(pathlib.Path(suite["gtest"]).name, "edgecase-gtest")
        self.assertIn("llvmpipe", suite["env"]["EDGECASE_AGAINST"])
        variables = suite["env"] | {"EDGECASE_AGAINST": self.renderer}
        group = self.listed(**variables)[:3]
        told = self.command("--gtest_filter=" + ":".join(group), program=GTEST, expect=None,
                            **variables)
        self.assertEqual({test for _, test in RESULT.findall(told.stdout)} & set(group), set(group))
        self.assertEqual(self.asked()[0], {id for id, name in NAMES.items() if name in group})


if __name__ == "__main__":
    unittest.main()
