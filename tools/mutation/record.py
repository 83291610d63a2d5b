# SPDX-License-Identifier: MIT
"""Which mutants does each test case reach, and how long does it take? One unmutated run of each
test case in a process of its own, so that what a program computes once counts for every test."""

import hashlib
import json
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path


class UnmutatedFailure(Exception):
    """A test fails without any mutant: nothing can be judged."""


@dataclass(frozen=True)
class TestCase:
    program: str
    name: str
    seconds: float
    reached: frozenset


def test_names(program):
    """The names of all test cases of a GoogleTest program."""
    listing = subprocess.run([program, "--gtest_list_tests"], capture_output=True, text=True,
                             check=True).stdout
    names, suite = [], ""
    for line in listing.splitlines():
        word = line.split("#")[0].strip()
        if line.startswith("  "):
            names.append(suite + word)
        elif word.endswith("."):
            suite = word
    return names


def run_unmutated(project, program, name):
    with tempfile.TemporaryDirectory() as folder:
        reached = Path(folder) / "reached"
        environment = project.environment(EDGECASE_MUTANT="-1",
                                          EDGECASE_MUTANTS_REACHED=str(reached))
        with subprocess.Popen([project.program(program), f"--gtest_filter={name}"],
                              env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True) as process:
            output = process.stdout.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0 or "1 test from" not in output:
            raise UnmutatedFailure(f"{name} of test_{program} fails without any mutant; mend that "
                                   f"first:\n{output[-2000:]}")
        numbers = reached.read_text().split() if reached.exists() else []
    # Processor time: the machine may be busy with other things.
    return TestCase(program, name, usage.ru_utime + usage.ru_stime, frozenset(map(int, numbers)))


def digest_of(project):
    digest = hashlib.sha256()
    for program in project.programs:
        digest.update(project.program(program).read_bytes())
    digest.update(project.share.encode())
    return digest.hexdigest()


def record(project, jobs):
    """All test cases. Remembered beside the build for as long as the programs stay the same."""
    memory = project.build / "reached.json"
    digest = digest_of(project)
    if memory.exists():
        known = json.loads(memory.read_text(encoding="utf-8"))
        if known["digest"] == digest:
            return [TestCase(p, n, s, frozenset(r)) for p, n, s, r in known["tests"]]
    wanted = [(program, name) for program in project.programs
              for name in test_names(project.program(program))]
    with ThreadPoolExecutor(jobs) as pool:
        tests = list(pool.map(lambda pair: run_unmutated(project, *pair), wanted))
    memory.write_text(json.dumps({"digest": digest, "tests": [
        [t.program, t.name, t.seconds, sorted(t.reached)] for t in tests]}), encoding="utf-8")
    return tests
