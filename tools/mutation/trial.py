# SPDX-License-Identifier: MIT
"""Runs mutants: each one against the test cases that reach it, the cheapest first, until one
fails. A crash, an endless loop and too much memory are failures too."""

import json
import math
import subprocess
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

QUICK_SECONDS = 0.1  # tests that take less run together, a process a program
MEMORY = 4 << 30     # bytes of address space


@dataclass(frozen=True)
class Outcome:
    mutant: object
    killer: str = ""       # what killed it: program and the tests that ran; empty: it survived
    endless: bool = False  # killed by its time
    reached: bool = True   # does any test reach it?

    @property
    def killed(self):
        return bool(self.killer)


def batches_of(tests, programs):
    """[(program, [test, ...]), ...] in the order in which they run."""
    quick = [test for test in tests if test.seconds < QUICK_SECONDS]
    slow = sorted((test for test in tests if test.seconds >= QUICK_SECONDS),
                  key=lambda test: test.seconds)
    batches = [(program, [test for test in quick if test.program == program])
               for program in programs]
    return [batch for batch in batches if batch[1]] + [(test.program, [test]) for test in slow]


class Trial:
    """Runs mutants of a project; remembers what killed each one and asks that first next time."""

    def __init__(self, project, tests):
        self.project = project
        self.tests = tests
        self.memory = project.build / "killers.json"
        self.hints = {}
        if self.memory.exists():
            self.hints = json.loads(self.memory.read_text(encoding="utf-8"))

    def run(self, mutants, jobs, progress):
        outcomes = []
        with ThreadPoolExecutor(jobs) as pool:
            for outcome in pool.map(self.judge, mutants):
                outcomes.append(outcome)
                self.remember(outcome)
                progress(outcome)
        self.save()
        return outcomes

    def remember(self, outcome):
        hint = hint_of(outcome.mutant)
        self.hints.pop(hint, None)
        if outcome.killed:
            self.hints[hint] = outcome.killer
        if outcome.mutant.number % 100 == 0:
            self.save()

    def save(self):
        self.memory.write_text(json.dumps(self.hints, indent=0), encoding="utf-8")

    def was_killed(self, mutant):
        """By an earlier run in this folder."""
        return hint_of(mutant) in self.hints

    def judge(self, mutant):
        tests = [test for test in self.tests if mutant.number in test.reached]
        batches = batches_of(tests, self.project.programs)
        hint = self.hints.get(hint_of(mutant), "")
        batches.sort(key=lambda batch: name_of(batch) != hint)
        for batch in batches:
            failed, endless = self.fails(mutant, batch)
            if failed:
                return Outcome(mutant, name_of(batch), endless)
        return Outcome(mutant, reached=bool(tests))

    def fails(self, mutant, batch):
        """(does a test of the batch fail?, because of its time?)"""
        program, tests = batch
        seconds = math.ceil(2 + 5 * sum(test.seconds for test in tests))
        command = ["prlimit", f"--cpu={seconds}", f"--as={MEMORY}", "--core=0",
                   str(self.project.program(program)), "--gtest_fail_fast", "--gtest_brief=1",
                   "--gtest_filter=" + ":".join(test.name for test in tests)]
        try:
            done = subprocess.run(command, env=self.project.environment(EDGECASE_MUTANT=str(mutant.number)),
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                  stdin=subprocess.DEVNULL, timeout=60 + 10 * seconds, check=False)
        except subprocess.TimeoutExpired:
            return True, True
        # SIGXCPU, or SIGKILL where that is not heeded.
        return done.returncode != 0, done.returncode in {-24, -9}


def name_of(batch):
    program, tests = batch
    return f"{program}: {tests[0].name if len(tests) == 1 else 'quick tests'}"


def hint_of(mutant):
    return "/".join(map(str, mutant.key))
