# SPDX-License-Identifier: MIT
"""tools/mutate tried on the toy project: which mutants there are, and what becomes of each."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests/support")]

from mutation import arguments, command, operators, score  # noqa: E402  the path comes first
from mutation.project import Project  # noqa: E402
from mutation.record import UnmutatedFailure, record  # noqa: E402
from mutation.trial import Trial  # noqa: E402


class Toy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.project = Project(ROOT / "tests/mutation/toy", Path(cls.folder.name), ("src",),
                              ("CMakeLists.txt", "src", "toy_test.cpp"), ("toy",))
        cls.mutants, texts = cls.project.mutate()
        cls.project.make(texts, 2)
        cls.tests = record(cls.project, 2)
        outcomes = Trial(cls.project, cls.tests).run(cls.mutants, 2, lambda outcome: None)
        cls.outcomes = {outcome.mutant.key[1:4]: outcome for outcome in outcomes}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def outcome(self, *key):
        self.assertIn(key, self.outcomes)
        return self.outcomes[key]

    def test_every_operator_makes_mutants(self):
        named = {line.split()[0] for line in operators.__doc__.splitlines()
                 if line.startswith("    ")}
        self.assertEqual({mutant.operator for mutant in self.mutants}, named)

    def test_a_sample_stays_when_other_code_changes(self):
        options = command.parser().parse_args(["--sample", "7", "--seed", "5"])
        sample = command.selected(self.mutants, options)
        self.assertEqual(len(sample), 7)
        rest = [mutant for mutant in self.mutants if mutant not in sample]
        self.assertEqual(command.selected(rest[::2] + sample, options), sample)
        self.assertEqual([m.number for m in sample], sorted(m.number for m in sample))
        other = command.parser().parse_args(["--sample", "7", "--seed", "6"])
        self.assertNotEqual(command.selected(self.mutants, other), sample)

    def test_what_serves_the_compiler_is_left_alone(self):
        text = "\n".join(map(str, self.mutants))
        for absent in ("== 4", "even = ", "odd = ", "table[5]", "kHigh = ", "kLength", "2 + 1",
                       "operator==", "Limits::Limits", "hello"):
            self.assertNotIn(absent, text)

    def test_a_fault_is_killed(self):
        for key in [("clamped_sum", "a + b", "a - b"),
                    ("doubled", "n + n", "n - n"),
                    ("Limits::low", "-1", "1"),
                    ("kFirst", "constexpr int kFirst = 3", "constexpr int kFirst = 4"),
                    ("count_down", "steps += 2", ""),
                    ("multiples", "n * i", "n + i"),
                    ("every_operator", "continue", "")]:
            outcome = self.outcome(*key)
            self.assertTrue(outcome.killed, key)
            self.assertFalse(outcome.endless, key)

    def test_an_endless_loop_is_killed(self):
        outcome = self.outcome("count_down", "--n", "")
        self.assertTrue(outcome.killed)
        self.assertTrue(outcome.endless)

    def test_what_changes_nothing_survives(self):
        outcome = self.outcome("clamped_sum", "sum > Limits::kHigh", "sum >= Limits::kHigh")
        self.assertFalse(outcome.killed)
        self.assertTrue(outcome.reached)

    def test_what_no_test_calls_is_said_to_be_so(self):
        outcome = self.outcome("never_called", "n * 7", "n + 7")
        self.assertFalse(outcome.killed)
        self.assertFalse(outcome.reached)

    def test_survivors_need_an_argument_and_arguments_a_survivor(self):
        outcomes = list(self.outcomes.values())
        survivor = self.outcome("clamped_sum", "sum > Limits::kHigh", "sum >= Limits::kHigh")
        victim = self.outcome("clamped_sum", "a + b", "a - b")
        without = list(arguments.faults({}, self.mutants, outcomes))
        self.assertTrue(any("sum >= Limits" in fault for fault in without))
        self.assertTrue(any("reached by no test" in fault for fault in without))
        argued = {survivor.mutant.key: "both branches give the same"}
        left = list(arguments.faults(argued, self.mutants, outcomes))
        self.assertEqual(len(left), len(without) - 1)
        stale = {victim.mutant.key: "it is killed", ("no", "such", "mutant", "", 1): "gone"}
        found = set(arguments.faults(stale, self.mutants, outcomes)) - set(without)
        self.assertEqual(len(found), 2)
        self.assertTrue(all(fault.startswith("stale") for fault in found), found)

    def test_the_score_leaves_out_what_is_argued(self):
        survivor = self.outcome("clamped_sum", "sum > Limits::kHigh", "sum >= Limits::kHigh")
        outcomes = [survivor, self.outcome("clamped_sum", "a + b", "a - b")]
        total = score.rows_by(outcomes, {}, lambda mutant: mutant.file)[-1]
        self.assertEqual(total.cells(), ["total", "2", "1", "1", "0", "50.0 %"])
        argued = {survivor.mutant.key: "both branches give the same"}
        total = score.rows_by(outcomes, argued, lambda mutant: mutant.file)[-1]
        self.assertEqual(total.cells(), ["total", "2", "1", "0", "1", "100.0 %"])

    def test_a_failure_without_a_mutant_stops_everything(self):
        (self.project.build / "reached.json").unlink()
        os.environ["TOY_FAILS"] = "1"
        try:
            with self.assertRaisesRegex(UnmutatedFailure, "Toy.FailsOnRequest"):
                record(self.project, 2)
        finally:
            del os.environ["TOY_FAILS"]


if __name__ == "__main__":
    unittest.main(verbosity=1)
