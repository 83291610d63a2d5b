# SPDX-License-Identifier: MIT
"""Ctrl-C and SIGTERM: the command ends soon, keeps what was finished and leaves nobody behind.
Progress is told on a terminal, and only there."""
import json
import os
import pty
import signal
import subprocess
import time
import unittest
import xml.etree.ElementTree

import results_file
from support import (EDGECASE, PATIENCE, SUITE, UNEXPECTED, CommandTest, environment,
                     processes_that_mention, verdicts)

SOON = 10  # seconds
# Thousands of cases, far more than a nap each lets finish; all of the suite take seconds to load.
MANY = f"{SUITE}/lines"


class Interruption(CommandTest):
    def start_and_stop(self, behaviour, marks, stop, arguments):
        """Starts the command with an odd renderer, waits until that has left so many marks, stops
        the command; its exit code and its standard error."""
        renderer = self.odd_renderer(behaviour)
        running = subprocess.Popen([EDGECASE, *arguments(renderer)], cwd=self.folder,
                                   env=environment(), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True)
        self.addCleanup(running.kill)
        path = self.folder / "truth.jsonl.marks"
        deadline = time.monotonic() + PATIENCE
        while not path.exists() or path.stat().st_size < marks:
            self.assertLess(time.monotonic(), deadline, "the renderer does not get going")
            time.sleep(.02)
        running.send_signal(stop)
        begin = time.monotonic()
        _, errors = running.communicate(timeout=PATIENCE)
        self.assertLess(time.monotonic() - begin, SOON)
        left_behind = processes_that_mention(str(self.folder))
        for process in left_behind:
            os.kill(process, signal.SIGKILL)
        self.assertEqual(left_behind, [])
        return running.returncode, errors

    def run_arguments(self, renderer):
        return ["run", MANY, "--against", renderer, "--jobs", "1", "--json", "results.json",
                "--junit", "junit.xml", "--html", "report.html"]

    def check_partial_results(self, least):
        results = results_file.read(self.folder / "results.json")
        self.assertTrue(results["interrupted"])
        self.assertGreaterEqual(len(results["cases"]), least)
        self.assertLess(len(results["cases"]), 100)
        self.assertLessEqual(set(verdicts(results).values()), {"agree"})
        junit = xml.etree.ElementTree.parse(self.folder / "junit.xml").getroot()
        self.assertEqual(junit.get("errors"), "1")
        self.assertIn("</html>", (self.folder / "report.html").read_text(encoding="utf-8"))

    def test_a_slow_renderer(self):
        for stop in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(stop.name):
                (self.folder / "truth.jsonl.marks").unlink(missing_ok=True)
                code, _ = self.start_and_stop("nap", 3, stop, self.run_arguments)
                self.assertEqual(code, UNEXPECTED)
                self.check_partial_results(least=2)

    def test_a_renderer_that_hangs(self):
        code, _ = self.start_and_stop("hang", 1, signal.SIGINT, self.run_arguments)
        self.assertEqual(code, UNEXPECTED)
        self.check_partial_results(least=0)

    def test_other_subcommands(self):
        case = f"{SUITE}/triangles/ties/flat-top.json"
        for arguments in (lambda renderer: ["render", MANY, "--with", renderer],
                          lambda renderer: ["explain", case, "--against", renderer],
                          lambda renderer: ["backends", renderer],
                          lambda renderer: ["backends", renderer, "--json", "-"]):
            (self.folder / "truth.jsonl.marks").unlink(missing_ok=True)
            with self.subTest(arguments("")[0]):
                code, errors = self.start_and_stop("hang", 1, signal.SIGINT, arguments)
                self.assertEqual(code, UNEXPECTED, errors)
                self.assertIn("interrupted", errors)

    def test_render_keeps_what_was_finished(self):
        code, errors = self.start_and_stop(
            "nap", 3, signal.SIGINT,
            lambda renderer: ["render", MANY, "--with", renderer, "--json", "some.jsonl"])
        self.assertEqual(code, UNEXPECTED)
        self.assertIn("interrupted", errors)
        lines = (self.folder / "some.jsonl").read_text(encoding="utf-8").splitlines()
        self.assertGreaterEqual(len(lines), 2)
        for line in lines:
            json.loads(line)


class Progress(CommandTest):
    def errors_on_a_terminal(self, *arguments):
        ours, theirs = pty.openpty()
        running = subprocess.Popen([EDGECASE, "run", "cases", "--against",
                                    self.odd_renderer("nap", "", "cases"), *arguments],
                                   cwd=self.folder, env=environment(), stdout=subprocess.DEVNULL,
                                   stderr=theirs)
        os.close(theirs)
        text = b""
        try:
            while chunk := os.read(ours, 4096):
                text += chunk
        except OSError:
            pass  # the other end is closed
        os.close(ours)
        self.assertEqual(running.wait(timeout=PATIENCE), 0)
        return text.decode()

    def test_progress_on_a_terminal_only(self):
        self.write_cases("a", "b", "c")
        told = self.errors_on_a_terminal()
        self.assertRegex(told, r"2 of 3 cases, \d+ per second, \d+ s left")
        self.assertTrue(told.endswith("\r\x1b[K"), "the line is cleared at the end")
        self.assertEqual(self.errors_on_a_terminal("--progress", "never"), "")
        self.assertEqual(self.command("run", "cases", "--against", "exact").stderr, "")


if __name__ == "__main__":
    unittest.main()
