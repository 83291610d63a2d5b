# SPDX-License-Identifier: MIT
"""Ctrl-C and SIGTERM: the command ends soon, keeps what was finished and leaves nobody behind.
Progress is told on a terminal, and only there."""
import json
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree

import results_file
from support import (EDGECASE, PATIENCE, SUITE, UNEXPECTED, CommandTest, environment,
                     processes_that_mention, verdicts)
from terminal import run_on_a_terminal

SOON = 10  # seconds
# Thousands of cases, far more than a nap each lets finish; all of the suite take seconds to load.
MANY = f"{SUITE}/lines"


def living_of_group(group):
    """The numbers of processes of a group that have not ended."""
    living = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            # The name of the program stands in brackets, and may hold anything.
            fields = (entry / "stat").read_text("utf-8").rpartition(")")[2].split()
        except OSError:
            continue  # no process, or it ended meanwhile
        if entry.name.isdigit() and int(fields[2]) == group and fields[0] not in "ZX":
            living.append(int(entry.name))
    return living


def kill_group(group):
    try:
        os.killpg(group, signal.SIGKILL)
    except ProcessLookupError:
        pass


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

    def test_kill_takes_a_program_that_never_reads(self):
        """What cannot be handled: nobody is left to end the program and what it started."""
        script = self.write("deaf.py", """import os, pathlib, select, subprocess, time
child = subprocess.Popen(["sleep", "1000"])
select.select([0], [], [])  # the run asks: it is past the start
pathlib.Path("deaf").write_text(f"{os.getpid()}\\n", "utf-8")
time.sleep(1000)
""")
        running = subprocess.Popen([EDGECASE, "run", f"{SUITE}/triangles/ties", "--against",
                                    f"exec:{sys.executable} {script}", "--jobs", "1"], cwd=self.folder,
                                   env=environment(), stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        self.addCleanup(running.kill)
        deaf = self.folder / "deaf"
        deadline = time.monotonic() + PATIENCE
        while not deaf.exists() or not deaf.read_text("utf-8").endswith("\n"):
            self.assertLess(time.monotonic(), deadline, "the renderer does not get going")
            time.sleep(.02)
        group = int(deaf.read_text("utf-8"))
        self.addCleanup(kill_group, group)
        self.assertEqual(len(living_of_group(group)), 2)
        running.kill()
        running.wait()
        deadline = time.monotonic() + SOON
        while living_of_group(group):
            self.assertLess(time.monotonic(), deadline, "the renderer outlives the run")
            time.sleep(.02)

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
        code, text = run_on_a_terminal(
            [EDGECASE, "run", "cases", "--against", self.odd_renderer("nap", "", "cases"),
             *arguments], "stderr", cwd=self.folder, env=environment(), stdout=subprocess.DEVNULL)
        self.assertEqual(code, 0)
        return text

    def test_progress_on_a_terminal_only(self):
        self.write_cases("a", "b", "c")
        told = self.errors_on_a_terminal()
        self.assertRegex(told, r"2 of 3 cases, \d+ per second, \d+ s left")
        self.assertTrue(told.endswith("\r\x1b[K"), "the line is cleared at the end")
        self.assertEqual(self.errors_on_a_terminal("--progress", "never"), "")
        self.assertEqual(self.command("run", "cases", "--against", "exact").stderr, "")


if __name__ == "__main__":
    unittest.main()
