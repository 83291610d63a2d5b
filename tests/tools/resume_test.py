# SPDX-License-Identifier: MIT
"""A run that ended early, and --resume: what was finished is taken over, only the rest is asked
for, and what comes of it equals, to the byte, what one run writes. Nothing is taken over from
another policy, renderer, version or case, and nothing that was found is lost."""
import re
import signal
import subprocess
import time
import unittest

import results_file
from support import (AS_EXPECTED, EDGECASE, PATIENCE, RENDERER, REPORTS, UNEXPECTED,
                     USAGE, CommandTest, environment, report_options, triangle_case, verdicts)

NAMES = [f"case-{n}" for n in range(8)]


class ResumeTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)
        self.marks = self.folder / "truth.jsonl.marks"

    def asked(self):
        """How many answers a napping renderer has begun since somebody asked last."""
        count = self.marks.stat().st_size if self.marks.exists() else 0
        self.marks.unlink(missing_ok=True)
        return count

    def read(self, name="results.json"):
        return results_file.read(self.folder / name)

    def edit(self, change, name="results.json"):
        """The results with something changed, as a run long ago may have left them."""
        results = self.read(name)
        change(results)
        return self.write_results(name, results)

    def keep(self, *names):
        """Only these cases are left, as if the run had ended then."""
        def change(results):
            results["cases"] = [case for case in results["cases"] if case["id"] in names]
            results.update(interrupted=True, left_out=len(NAMES) - len(names))
        return self.edit(change)

    def resume(self, *arguments, expect=AS_EXPECTED):
        return self.command("run", "cases", *arguments, "--json", "results.json", "--resume",
                            expect=expect).stderr

    def interrupt(self, renderer, stop, *options):
        """A run that is stopped when it has asked for three answers; its standard error."""
        running = subprocess.Popen([EDGECASE, "run", "cases", "--against", renderer, "--jobs", "1",
                                    *options], cwd=self.folder, env=environment(), text=True,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.addCleanup(running.kill)
        deadline = time.monotonic() + PATIENCE
        while not self.marks.exists() or self.marks.stat().st_size < 3:
            self.assertLess(time.monotonic(), deadline, "the renderer does not get going")
            time.sleep(.02)
        running.send_signal(stop)
        _, errors = running.communicate(timeout=PATIENCE)
        return running.returncode, errors


class Interrupted(ResumeTest):
    def reports(self, name):
        return {kind: (self.folder / name / f"reports.{kind}").read_bytes() for kind in REPORTS}

    def test_equals_a_run_without_an_end_in_between(self):
        renderer = self.odd_renderer("nap", "", "cases")
        self.command("run", "cases", "--against", renderer, *report_options("whole"))
        for stop in signal.SIGINT, signal.SIGTERM, signal.SIGHUP:
            with self.subTest(stop.name):
                self.asked()
                code, errors = self.interrupt(renderer, stop, *report_options(stop.name))
                self.assertEqual(code, UNEXPECTED)
                path = f"{stop.name}/reports.json"
                self.assertIn(f"{path} has what was finished; the same command with --resume goes "
                              "on with the rest", errors)
                results = self.read(path)
                held = len(results["cases"])
                self.assertTrue(results["interrupted"])
                self.assertEqual(held + results["left_out"], len(NAMES))
                self.assertGreaterEqual(held, 2)
                self.asked()
                run = self.command("run", "cases", "--against", renderer, "--resume",
                                   *report_options(stop.name))
                self.assertIn(f"{held} of 8 cases are taken over from {path}", run.stderr)
                # One of them also to learn what the renderer is.
                self.assertEqual(self.asked(), len(NAMES) - held + 1)
                self.assertEqual(self.reports(stop.name), self.reports("whole"))

    def test_killed_outright(self):
        """What an earlier run wrote is still there, whole, and what this one had finished beside it:
        that is gone on with."""
        renderer = self.odd_renderer("nap", "", "cases")
        self.command("run", "cases", "--against", renderer, "--json", "results.json")
        whole = (self.folder / "results.json").read_bytes()
        self.keep(*NAMES[3:])
        before = self.read()
        self.asked()
        code, _ = self.interrupt(renderer, signal.SIGKILL, "--json", "results.json")
        self.assertEqual(code, -signal.SIGKILL)
        self.assertEqual(self.read(), before)
        told = self.resume("--against", renderer)
        self.assertRegex(told, "^edgecase: [23] of 8 cases are taken over from "
                               "results.json.unfinished\n$")
        self.assertEqual((self.folder / "results.json").read_bytes(), whole)
        self.assertFalse((self.folder / "results.json.unfinished").exists())

    def test_interrupted_twice(self):
        renderer = self.odd_renderer("nap", "", "cases")
        self.command("run", "cases", "--against", renderer, "--json", "results.json")
        whole = (self.folder / "results.json").read_bytes()
        self.keep(*NAMES[:2])
        self.asked()
        code, _ = self.interrupt(renderer, signal.SIGINT, "--json", "results.json", "--resume")
        self.assertEqual(code, UNEXPECTED)
        held = len(self.read()["cases"])
        self.assertGreater(held, 2)
        self.assertLess(held, len(NAMES))
        self.resume("--against", renderer)
        self.assertEqual((self.folder / "results.json").read_bytes(), whole)


class TakenOver(ResumeTest):
    def setUp(self):
        super().setUp()
        self.command("run", "cases", "--against", "exact", "--json", "results.json")
        self.whole = self.read()

    def taken_over(self, *arguments, expect=AS_EXPECTED):
        told = self.resume("--against", "exact", *arguments, expect=expect)
        return int(re.search(r"edgecase: (\d+) of \d+ cases are taken over", told)[1])

    def test_without_a_file_all_is_run(self):
        (self.folder / "results.json").unlink()
        self.assertEqual(self.resume("--against", "exact"), "")
        self.assertEqual(self.read(), self.whole)

    def test_of_a_whole_run_nothing_is_asked(self):
        for _ in range(2):
            self.assertEqual(self.taken_over(), 8)
            self.assertEqual(self.read(), self.whole)

    def test_the_file_that_is_meant_without_a_name(self):
        for _ in range(2):
            run = self.command("run", "cases", "--against", "exact", "--resume")
        self.assertIn("8 of 8 cases are taken over from out/results.zst", run.stderr)

    def test_what_was_changed_is_run_again(self):
        self.write("cases/case-3.json", triangle_case(title="Another"))
        (self.folder / "cases/case-4.json").unlink()
        self.write_cases("new")
        self.assertEqual(self.taken_over(), 6)
        results = self.read()
        self.assertEqual([case["id"] for case in results["cases"]],
                         [name for name in NAMES if name != "case-4"] + ["new"])
        self.assertEqual(results["cases"][3]["title"], "Another")

    def test_what_lies_in_other_files_is_run_again(self):
        mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        self.write("cases/triangle.obj", mesh)
        self.write("cases/mesh.json", triangle_case(
            draws=[{"primitive": "triangles", "mesh": "triangle.obj"}]))
        self.command("run", "cases", "--against", "exact", "--json", "results.json")
        self.write("cases/triangle.obj", mesh.replace("v 1 0 0", "v 0.5 0 0"))
        self.assertEqual(self.taken_over(), 8)
        resumed = self.read()
        self.command("run", "cases", "--against", "exact", "--json", "results.json")
        self.assertEqual(resumed, self.read())

    def test_broken_case_files(self):
        self.keep(*NAMES[:4])
        self.write("cases/case-1.json", "{")
        self.assertEqual(self.taken_over(expect=USAGE), 3)
        results = self.read()
        self.assertEqual(len(results["cases"]), 7)
        self.assertEqual(len(results["diagnostics"]), 1)

    def test_shards(self):
        for number in "1", "2":
            self.command("run", "cases", "--against", "exact", "--shard", f"{number}/2", "--json",
                         f"{number}.json")
        written = (self.folder / "2.json").read_bytes()
        self.edit(lambda results: results["cases"].pop(), "2.json")
        run = self.command("run", "cases", "--against", "exact", "--shard", "2/2", "--json",
                           "2.json", "--resume")
        self.assertIn("3 of 4 cases are taken over", run.stderr)
        self.assertEqual((self.folder / "2.json").read_bytes(), written)
        self.command("merge", "1.json", "2.json", "--json", "results.json")
        self.assertEqual(self.read(), self.whole)

    def test_ended_by_failures(self):
        renderer = self.odd_renderer("mirror", "", "cases")
        self.results("cases", "--against", renderer, expect=UNEXPECTED)
        whole = (self.folder / "results.json").read_bytes()
        self.results("cases", "--against", renderer, "--max-failures", "1", "--jobs", "1",
                     expect=UNEXPECTED)
        self.assertLess(len(self.read()["cases"]), 8)
        self.resume("--against", renderer, expect=UNEXPECTED)
        self.assertEqual((self.folder / "results.json").read_bytes(), whole)

    def test_failures_are_answers_unless_nobody_was_there(self):
        dies = self.odd_renderer("die", "case-2", "cases")
        self.results("cases", "--against", dies, "--no-rerun", expect=RENDERER)
        self.assertIn("8 of 8", self.resume("--against", dies, "--no-rerun", expect=RENDERER))
        self.assertEqual(verdicts(self.read())["case-2"], "not-run")
        program = self.folder / "program"
        renderer = f"exec:{program}"
        self.results("cases", "--against", renderer, expect=RENDERER)
        words = self.odd_renderer("honest", "", "cases").removeprefix("exec:")
        program.write_text(f"#!/bin/sh\nexec {words}\n", "utf-8")
        program.chmod(0o755)
        self.assertIn("0 of 8", self.resume("--against", renderer))
        self.assertEqual(verdicts(self.read()), dict.fromkeys(NAMES, "agree"))


class Refused(ResumeTest):
    def setUp(self):
        super().setUp()
        self.command("run", "cases", "--against", "exact", "--json", "results.json")

    def check(self, words, *arguments):
        before = (self.folder / "results.json").read_bytes()
        told = self.resume(*(arguments or ["--against", "exact"]), expect=USAGE)
        self.assertEqual(told.count("\n"), 1, told)
        for word in words:
            self.assertIn(word, told)
        self.assertEqual((self.folder / "results.json").read_bytes(), before)

    def test_another_policy_or_renderer(self):
        remedy = "run as then, or without --resume"
        self.check(["results.json was judged by policy opengl, this run by policy opengl without "
                    "latitude", remedy], "--against", "exact", "--no-latitude")
        renderer = self.odd_renderer("mirror", "", "cases")
        self.check(["results.json holds results of exact, this run of exec:", remedy],
                   "--against", renderer)

    def test_another_version(self):
        self.keep(*NAMES[:3])
        def older(results):
            results["renderers"][0]["version"] = "0.0"
        self.edit(older)
        self.check(["the renderer exact is not the same", "version 0.0"])
        def much_older(results):
            results["tool"] = "edgecase 0"
        self.edit(much_older)
        self.check(["results.json was written by edgecase 0, this run by edgecase "])

    def test_cases_that_would_be_lost(self):
        self.check(["results.json holds the case case-0, which is not selected now",
                    "or run without --resume"], "--against", "exact", "--exclude", "case-0")

    def test_files_that_are_no_results(self):
        self.write("results.json", '{"tool": "edgecase')
        self.check(["results.json", "no results file"])

    def test_nothing_to_go_on_with(self):
        for arguments in (["--json", "-"], ["--junit", "junit.xml"]):
            run = self.command("run", "cases", "--against", "exact", "--resume", *arguments,
                               expect=USAGE)
            self.assertIn("--resume goes on with a file and writes it anew; name it with --json",
                          run.stderr)
        run = self.command("run", "cases", "--resume", "--last-failed", expect=USAGE)
        self.assertIn("--last-failed", run.stderr)


if __name__ == "__main__":
    unittest.main()
