# SPDX-License-Identifier: MIT
"""Bad input and bad renderers: the right exit code, one clear message that names the place and the
remedy, and the other cases are judged all the same."""
import json
import os
import signal
import subprocess
import time
import unittest

import results_file
from support import (AS_EXPECTED, EDGECASE, INTERNAL, NOTHING_SELECTED, PATIENCE, RENDERER, UNEXPECTED, USAGE,
                     CommandTest, environment, only_result, triangle_case, verdicts)

NAMES = ["a", "b", "c", "d", "e"]


def with_first_vertex(x):
    return triangle_case(draws=[{"primitive": "triangles", "vertices": [[x, 1], [6, 1], [1, 6]]}])


# name of the file: its content, and the messages it must give: line, pointer, what, remedy.
BAD_FILES = {
    "broken": ('{"title": "x",\n "rules": [}', [[":2:", "line 2, column 12", "check that"]]),
    "empty": ("", [[":1:", "the file is empty", "write"]]),
    "unknown": (triangle_case(colour="red"), [["/colour", "no key", "allowed are title"]]),
    "tenth": (with_first_vertex(.1),
              [["/draws/0/vertices/0/0", "0.1 is no multiple of 1/65536", "0.0999908447265625",
                "0.100006103515625", '"~0.1"']]),
    "wide": (triangle_case(target={"width": 100000, "height": 8}),
             [["/target/width", "100000", "from 1 to 4096"]]),
    "two-faults": (triangle_case(colour="red", target={"width": 8, "height": "x"}),
                   [["/colour", "allowed"], ["/target/height", "must be a number", "write"]]),
    "no-draws": ({"title": "x", "rules": ["triangle.fill-rule"],
                  "target": {"width": 1, "height": 1}}, [["draws", "add"]]),
    "no-rule": (triangle_case(rules=["triangle.fil-rule"]), [["/rules/0", "triangle.fil-rule"]]),
    "not-finite": ('{"title": NaN}', [[":1:", "column 11"]]),
    "twice": ('{"title": "a",\n"title": "b"}',
              [[":2:", "/title", "twice", "keep one"]] + [[f'"{key}"', "add"]
                                              for key in ("rules", "target", "draws")]),
}


class BadCases(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)

    def check_message(self, text, name, wanted):
        lines = [line for line in text.splitlines() if line.startswith(f"cases/{name}.json:")]
        for words in wanted:
            matching = [line for line in lines if all(word in line for word in words)]
            self.assertEqual(len(matching), 1, f"{words} in\n{text}")
        self.assertEqual(len(lines), len(wanted), text)

    def test_each_bad_file_costs_itself_alone(self):
        for name, (content, wanted) in BAD_FILES.items():
            with self.subTest(name):
                path = self.write(f"cases/{name}.json", content)
                run = self.command("run", "cases", "--against", "exact", "--json", "results.json",
                                   "--junit", "junit.xml", expect=USAGE)
                self.check_message(run.stderr, name, wanted)
                results = results_file.read(self.folder / "results.json")
                self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))
                self.assertEqual(len(results["diagnostics"]), len(wanted))
                for diagnostic in results["diagnostics"]:
                    self.assertTrue(diagnostic["file"].endswith(f"{name}.json"))
                    self.assertTrue(diagnostic["remedy"])
                self.assertIn(f"{name}.json", (self.folder / "junit.xml").read_text("utf-8"))
                path.unlink()

    def test_all_faults_of_all_files_at_once(self):
        for name, (content, _) in BAD_FILES.items():
            self.write(f"cases/{name}.json", content)
        for subcommand in ("run", "validate", "render"):
            options = ["--against", "exact"] if subcommand == "run" else []
            run = self.command(subcommand, "cases", *options, expect=USAGE)
            for name, (_, wanted) in BAD_FILES.items():
                self.check_message(run.stderr, name, wanted)
        # The last one rendered: the good cases are there.
        self.assertEqual([json.loads(line)["id"] for line in run.stdout.splitlines()], NAMES)

    def test_missing_file(self):
        results = self.results("cases", "cases/missing.json", "--against", "exact", expect=USAGE)
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))
        run = self.command("validate", "cases/missing.json", expect=USAGE)
        self.assertIn("cases/missing.json: there is no such file or folder; check", run.stderr)

    def test_a_wrong_drawing_is_unexpected(self):
        self.write("cases/drawn.json", triangle_case(
            expect=[{"policy": "opengl", "coverage": ["........"] * 8}]))
        results = self.results("cases", "--against", "exact", expect=UNEXPECTED)
        self.assertEqual(set(verdicts(results).values()), {"agree"})
        run = self.command("validate", "cases", expect=UNEXPECTED)
        self.assertIn("/expect/0", run.stderr)

    def test_symbolic_link_to_itself(self):
        (self.folder / "cases/loop.json").symlink_to("loop.json")
        results = self.results("cases", "--against", "exact", expect=None)
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))


# Behaviour of odd_renderer.py at one case: the kind of failure, and words of its reason.
FAILING = {
    "hang": ("timed-out", "no answer within"),
    "die": ("crashed", "exit status 7"),
    "die-by-signal": ("crashed", "signal 9"),
    "crash": ("crashed", "signal 6"),
    "stop": ("timed-out", "no answer within"),
    "out-of-memory": ("crashed", "MemoryError"),
    "late": ("timed-out", "no answer within"),
    "half-an-answer": ("timed-out", "no answer within"),
    "garbage": ("garbage", "JSON"),
    "bytes-of-no-text": ("garbage", "JSON"),
    "number-that-is-none": ("garbage", "JSON"),
    "close-output": ("crashed", "closed its output"),
    "refuse": ("unsupported", "not today"),
    "another-digest": ("garbage", "digest"),
    "wrong-size": ("garbage", "/pixels"),
    "far-fragment": ("garbage", "/fragments/0"),
    "wrong-hits": ("garbage", "hit counts and fragments contradict"),
}


class BadRenderers(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)

    def run_against(self, *renderers, expect):
        options = [word for renderer in renderers for word in ("--against", renderer)]
        # Asked once: what comes of the first answer is the question here, not a flake.
        return self.results("cases", *options, "--timeout", "1", "--no-rerun", expect=expect)

    def test_a_failure_costs_its_case_alone(self):
        for behaviour, (kind, words) in FAILING.items():
            with self.subTest(behaviour):
                # A renderer that says what it cannot do has not failed.
                code = AS_EXPECTED if kind == "unsupported" else RENDERER
                results = self.run_against(self.odd_renderer(behaviour, "c", "cases"), expect=code)
                expected = dict.fromkeys(NAMES, "agree")
                expected["c"] = "not-run"
                self.assertEqual(verdicts(results), expected)
                failure = only_result(results["cases"][2])["failure"]
                self.assertEqual(failure["kind"], kind)
                self.assertIn(words, failure["reason"])

    def test_killed_by_others(self):
        """While it draws c: only that is lost."""
        renderer = self.odd_renderer("await-death", "c", "cases")
        running = subprocess.Popen([EDGECASE, "run", "cases", "--against", renderer, "--json",
                                    "results.json", "--timeout", "300", "--no-rerun"],
                                   cwd=self.folder,
                                   env=environment(), stdout=subprocess.DEVNULL)
        self.addCleanup(running.kill)
        path = self.folder / "truth.jsonl.pid"
        deadline = time.monotonic() + PATIENCE
        while not path.exists():
            self.assertLess(time.monotonic(), deadline, "the renderer does not get going")
            time.sleep(.02)
        os.kill(int(path.read_text(encoding="utf-8")), signal.SIGKILL)
        self.assertEqual(running.wait(timeout=PATIENCE), RENDERER)
        results = results_file.read(self.folder / "results.json")
        self.assertEqual(verdicts(results), {**dict.fromkeys(NAMES, "agree"), "c": "not-run"})
        failure = only_result(results["cases"][2])["failure"]
        self.assertEqual(failure["kind"], "crashed")
        self.assertIn("signal 9", failure["reason"])

    def test_a_line_without_end(self):
        renderer = self.odd_renderer("endless-line", "c", "cases")
        results = self.results("cases", "--against", renderer, "--timeout", "120", expect=RENDERER)
        self.assertEqual(verdicts(results), {**dict.fromkeys(NAMES, "agree"), "c": "not-run"})
        failure = only_result(results["cases"][2])["failure"]
        self.assertEqual(failure["kind"], "garbage")
        self.assertIn("goes on without a line break", failure["reason"])

    def test_an_answer_given_twice_costs_nothing(self):
        """The second one is not taken for an answer to the next case."""
        for victim in "c", "":
            with self.subTest(victim):
                results = self.run_against(self.odd_renderer("twice", victim, "cases"),
                                           expect=AS_EXPECTED)
                self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))

    def test_known_failures_are_as_expected(self):
        """A crash that is expected leaves nothing unexpected, and one that is not there does."""
        renderer = self.odd_renderer("die", "c", "cases")
        known = {"driver": renderer, "faults": [
            {"id": "dies", "kind": "crashed", "cases": ["c"], "reason": "dies of it"}]}
        path = self.write("known.json", known)
        self.command("run", "cases", "--against", renderer, "--known", path)
        known["faults"][0]["cases"] = ["d"]
        path = self.write("known.json", known)
        self.command("run", "cases", "--against", renderer, "--known", path,
                     expect=RENDERER)

    def test_infinite_depths_are_a_violation(self):
        results = self.run_against(self.odd_renderer("infinite-depths", "c", "cases"),
                                   expect=UNEXPECTED)
        self.assertEqual(verdicts(results), {**dict.fromkeys(NAMES, "agree"), "c": "violation"})

    def test_nan_colours_are_a_violation(self):
        results = self.run_against(self.odd_renderer("nan-colors", "c", "cases"),
                                   expect=UNEXPECTED)
        self.assertEqual(verdicts(results), {**dict.fromkeys(NAMES, "agree"), "c": "violation"})
        told = only_result(results["cases"][2])["disagreements"]
        self.assertEqual(len(told), results["cases"][2]["fragments"])
        self.assertEqual(told[0]["rendered"], ["nan"] * 4)

    def test_dying_on_every_third_scene(self):
        renderer = self.odd_renderer("third", "", "cases")
        results = self.run_against(renderer, expect=RENDERER)
        self.assertEqual(list(verdicts(results).values()),
                         ["agree", "agree", "not-run", "agree", "agree"])

    def test_dying_at_once(self):
        results = self.run_against(self.odd_renderer("die", "", "cases"), expect=RENDERER)
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "not-run"))
        failure = only_result(results["cases"][4])["failure"]
        self.assertEqual(failure["kind"], "unavailable")
        self.assertIn("without ever answering", failure["reason"])
        self.assertIn("exit status 7", failure["reason"])

    def test_a_missing_program_costs_no_other_renderer(self):
        results = self.run_against("exec:/no/such/program", "exact", expect=RENDERER)
        for case in results["cases"]:
            self.assertEqual(case["results"]["exact"]["verdict"], "agree")
            failure = case["results"]["exec:/no/such/program"]["failure"]
            self.assertEqual(failure["kind"], "unavailable")
            self.assertIn("'/no/such/program' cannot be started: No such file", failure["reason"])
        run = self.command("run", "cases", "--against", "exec:/no/such/program", expect=RENDERER)
        self.assertIn("cannot be started", run.stdout)

    def test_failures_in_junit_and_render(self):
        renderer = self.odd_renderer("die", "c", "cases")
        self.command("run", "cases", "--against", renderer, "--junit", "junit.xml",
                     expect=RENDERER)
        junit = (self.folder / "junit.xml").read_text(encoding="utf-8")
        self.assertIn('tests="5" failures="0" errors="1" skipped="0"', junit)
        run = self.command("render", "cases", "--with", renderer, expect=RENDERER)
        self.assertEqual(len(run.stdout.splitlines()), 4)
        self.assertIn("c: crashed: the program ended with exit status 7", run.stderr)

    def test_names_that_are_no_renderer(self):
        for name, words in (("nope", "there is no renderer 'nope'; known are exact, egl:"),
                            ("osmesa:zink", "there is no renderer 'osmesa:zink'; did you mean egl:zink? "
                                            "Known are exact, egl:"),
                            ("exec:", "write exec:PROGRAM"),
                            ("exec:'open", "a quote that is not closed")):
            for arguments in (["run", "cases", "--against", name],
                              ["render", "cases", "--with", name], ["backends", name],
                              ["explain", "cases/a.json", "--against", name]):
                with self.subTest(" ".join(arguments)):
                    run = self.command(*arguments, expect=USAGE)
                    self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
                    self.assertIn(words, run.stderr)

    def test_a_renderer_named_twice(self):
        run = self.command("run", "cases", "--against", "exact", "--against", "exact",
                           expect=USAGE)
        self.assertIn("exact is named twice", run.stderr)


class BadSurroundings(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)

    def complaint(self, *arguments, expect=USAGE, **variables):
        return self.command(*arguments, expect=expect, **variables).stderr

    def test_usage(self):
        run = ["run", "cases", "--against", "exact"]
        for arguments, words in (
                ([*run, "--bogus"], "--bogus"),
                ([*run, "--jobs", "0"], "1 to 256"),
                ([*run, "--timeout", "soon"], "--timeout"),
                ([*run, "--color", "pink"], "--color"),
                ([*run, "--shard", "0/3"], "write I/N with I from 1 to N"),
                ([*run, "--shard", "4/3"], "write I/N"),
                ([*run, "--shard", "x"], "write I/N"),
                (["frobnicate"], "frobnicate"),
                ([], "ubcommand"),
                (["explain"], "case is required"),
                (["explain", "cases/a.json", "--pixel", "9,9"], "X from 0 to 7"),
                (["explain", "cases/a.json", "--pixel", "1"], "write X,Y"),
                (["run", "cases", "--policy", "nope"], "the path of a policy file")):
            with self.subTest(" ".join(arguments)):
                self.assertIn(words, self.complaint(*arguments))

    def test_broken_policy_file(self):
        for text, words in (("{", ["policy.json:1"]),
                            ('{"name": "x", "latitude": "some"}', ["/latitude", "opengl, none"]),
                            ('{"name": "x", "rules": {"no.rule": "x"}}', ["no.rule"])):
            self.write("policy.json", text)
            told = self.complaint("run", "cases", "--policy", "policy.json")
            for word in words:
                self.assertIn(word, told)

    def test_broken_file_of_known_faults(self):
        fault = {"id": "a", "rule": "fine", "cases": ["a"], "reason": "because"}
        for content, words in (("{", ["known.json", "edgecase bless"]),
                               ({"driver": "exact", "faults": [fault]},
                                ['fault "a"', 'there is no rule "fine"']),
                               ({"faults": []}, ["driver"])):
            self.write("known.json", content)
            told = self.complaint("run", "cases", "--known", "known.json")
            for word in words:
                self.assertIn(word, told)
        self.assertIn("cannot read none.json: there is no such file",
                      self.complaint("run", "cases", "--known", "none.json"))

    def test_results_files(self):
        self.write("other.json", "{}")
        for subcommand in ("report", "bless"):
            self.assertIn("cannot read none.json",
                          self.complaint(subcommand, "none.json", expect=INTERNAL))
            self.assertIn("no results file", self.complaint(subcommand, "other.json"))

    def test_files_without_end(self):
        """A device as input is an error soon, in bounded memory."""
        for words, arguments in (
                ("a line is longer than 268435456 bytes", ["report", "/dev/zero"]),
                ("a line is longer than 268435456 bytes", ["bless", "/dev/zero"]),
                ("cannot read /dev/zero: this is no regular file",
                 ["run", "cases", "--against", "exact", "--known", "/dev/zero"])):
            self.assertIn(words, self.complaint(*arguments))
        self.assertIn("cannot read the recording /dev/zero: it is a pipe or a device",
                      self.complaint("run", "cases", "--against", "recording:/dev/zero"))

    def test_results_from_a_pipe(self):
        results = self.folder / "r.json"
        self.command("run", "cases", "--against", "exact", "--json", results, expect=None)
        run = subprocess.run(["sh", "-c", f"{EDGECASE} report /dev/stdin --csv - < r.json"],
                             cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        run = subprocess.run(["sh", "-c", f"cat r.json | {EDGECASE} report /dev/stdin --csv -"],
                             cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_unwritable_output(self):
        # A folder stands where the file should; "/proc/none" cannot be made, not even by root.
        for option in ("--json", "--junit", "--html"):
            for path in ("cases", "/proc/none/out"):
                with self.subTest(f"{option} {path}"):
                    told = self.complaint("run", "cases", "--against", "exact", option, path,
                                          expect=INTERNAL)
                    self.assertIn(f"cannot write {path}: ", told)
        told = self.complaint("render", "cases", "--json", "/proc/none/out", expect=INTERNAL)
        self.assertIn("cannot write /proc/none/out", told)
        told = self.complaint("render", "cases", "--png", "/proc/none", expect=INTERNAL)
        self.assertIn("/proc/none/", told)

    def test_one_unwritable_output_costs_no_other(self):
        self.command("run", "cases", "--against", "exact", "--html", "/proc/none/out", "--json",
                     "results.json", expect=INTERNAL)
        results = results_file.read(self.folder / "results.json")
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))

    def test_standard_output_that_is_full(self):
        for arguments in (["rules"], ["validate", "cases"], ["render", "cases"], ["--version"]):
            with self.subTest(arguments[0]), open("/dev/full", "w") as full:
                run = subprocess.run([EDGECASE, *arguments], cwd=self.folder, env=environment(),
                                     stdout=full, stderr=subprocess.PIPE, timeout=PATIENCE)
                self.assertEqual(run.returncode, INTERNAL)
                self.assertIn(b"No space left", run.stderr)

    def test_nothing_selected(self):
        for subcommand in ("run", "render", "validate"):
            with self.subTest(subcommand):
                told = self.complaint(subcommand, "cases", "--filter", "zzz",
                                      expect=NOTHING_SELECTED)
                self.assertIn("no case is selected", told)
        self.assertIn("no case", self.complaint("run", "cases", "--tag", "zzz", "--list",
                                                expect=NOTHING_SELECTED))
        self.assertIn("no case", self.complaint("run", "cases", "--shard", "6/6",
                                                expect=NOTHING_SELECTED))
        (self.folder / "bare").mkdir()
        self.complaint("run", "bare", expect=NOTHING_SELECTED)

    def test_precedence(self):
        """3 before 2, 4, 1 and 5."""
        def code(*renderers, bad_file, more=()):
            bad = ["cases/missing.json"] if bad_file else []
            options = [word for renderer in renderers for word in ("--against", renderer)]
            return self.command("run", "cases", *bad, *options, *more, expect=None).returncode
        dies = self.odd_renderer("die", "c", "cases")
        lies = self.odd_renderer("black", "", "cases")
        unwritable = ["--json", "/proc/none/out"]
        self.assertEqual(code("exact", bad_file=False), 0)
        self.assertEqual(code(lies, bad_file=False), UNEXPECTED)
        self.assertEqual(code(lies, dies, bad_file=False), RENDERER)
        self.assertEqual(code(lies, dies, bad_file=True), USAGE)
        self.assertEqual(code(lies, dies, bad_file=True, more=unwritable), INTERNAL)
        self.assertEqual(code("exact", bad_file=True, more=["--filter", "zzz"]), USAGE)


if __name__ == "__main__":
    unittest.main()
