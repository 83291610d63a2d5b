# SPDX-License-Identifier: MIT
"""Our own OpenGL workers when they are killed, stopped, out of memory, or answer what is none: the
case at hand is not-run, with the reason, no other is, and nobody is left behind."""
import shutil
import signal
import subprocess
import time
import unittest

import results_file
from support import (AS_EXPECTED, BIN, EDGECASE, HERE, PATIENCE, RENDERER, UNEXPECTED, CommandTest,
                     environment, only_result, processes_that_mention, triangle_case, verdicts)

NAMES = ["a", "b", "c", "d", "e"]
VICTIM = "victim"
# The fault of faulty_worker.py: the kind of failure, and words of its reason.
FAULTS = {
    "kill": ("crashed", "signal 9"),
    "stop": ("timed-out", "no answer within 2000 ms"),
    "half": ("timed-out", "no answer within 2000 ms"),
    "noise": ("garbage", "its answer is refused"),
    "cut": ("garbage", "its answer is refused"),
    "empty": ("garbage", "its answer is refused"),
    "echo": ("garbage", "its answer is refused"),
    "endless": ("garbage", "goes on"),
}
RENDERER_NAME = "egl:softpipe"


class WorkerFaults(CommandTest):
    def setUp(self):
        super().setUp()
        self.write_cases(*NAMES)
        # The worker is looked for beside the program.
        (self.folder / "bin").mkdir()
        self.program = shutil.copy(BIN / "edgecase", self.folder / "bin")

    def worker(self, *words):
        path = self.write("bin/edgecase-gl", "#!/bin/sh\nexec " + " ".join(words) + ' "$@"\n')
        path.chmod(0o755)

    def faulty_worker(self, fault):
        self.worker("/usr/bin/python3", "-B", str(HERE / "faulty_worker.py"), fault, VICTIM,
                    str(BIN / "edgecase-gl"))

    def run_all(self, expect):
        # Asked once: what comes of the first answer is the question here, not a flake.
        results = self.results("cases", "--against", RENDERER_NAME, "--timeout", "2", "--no-rerun",
                               "--jobs", "1", expect=expect, program=self.program)
        self.assertEqual(processes_that_mention(str(self.folder)), [])
        return results

    def check(self, results, kind, words):
        self.assertEqual(verdicts(results), {**dict.fromkeys(NAMES, "agree"), VICTIM: "not-run"})
        failure = only_result(results["cases"][-1])["failure"]
        self.assertEqual(failure["kind"], kind)
        self.assertIn(words, failure["reason"])

    def test_a_fault_costs_its_case_alone(self):
        self.write_cases(VICTIM)
        for fault, (kind, words) in FAULTS.items():
            with self.subTest(fault):
                self.faulty_worker(fault)
                self.check(self.run_all(RENDERER), kind, words)

    def test_out_of_memory_for_a_case(self):
        self.write(f"cases/{VICTIM}.json", triangle_case(target={"width": 1024, "height": 1024}))
        self.faulty_worker("starve")
        # The driver says that it has no such target, which is no crash.
        self.check(self.run_all(AS_EXPECTED), "unsupported", "no 1024x1024 framebuffer")

    def test_out_of_memory_from_the_start(self):
        self.worker("prlimit", f"--as={8 << 20}", str(BIN / "edgecase-gl"))
        results = self.run_all(RENDERER)
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "not-run"))
        for case in results["cases"]:
            self.assertTrue(only_result(case)["failure"]["reason"])


class Paused(CommandTest):
    def test_the_command_itself(self):
        """By Ctrl-Z, for longer than an answer may take: what came meanwhile came in time."""
        self.write_cases(*NAMES)
        renderer = self.odd_renderer("nap", "", "cases")
        running = subprocess.Popen([EDGECASE, "run", "cases", "--against", renderer, "--json",
                                    "results.json", "--timeout", "1", "--jobs", "1", "--no-rerun"],
                                   cwd=self.folder, env=environment(), stdout=subprocess.DEVNULL)
        self.addCleanup(running.kill)
        deadline = time.monotonic() + PATIENCE
        while not (self.folder / "truth.jsonl.marks").exists():
            self.assertLess(time.monotonic(), deadline, "the renderer does not get going")
            time.sleep(.02)
        running.send_signal(signal.SIGSTOP)
        time.sleep(1.5)
        running.send_signal(signal.SIGCONT)
        self.assertEqual(running.wait(timeout=PATIENCE), AS_EXPECTED)
        results = results_file.read(self.folder / "results.json")
        self.assertEqual(verdicts(results), dict.fromkeys(NAMES, "agree"))


if __name__ == "__main__":
    unittest.main()
