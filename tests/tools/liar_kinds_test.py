# SPDX-License-Identifier: MIT
"""Renderers that tell one lie about everything (liar_kinds.py), each made of the honest answers of
a Mesa driver to the core suite: no answer that a lie made another one agrees."""
import pathlib
import shlex
import sys
import unittest

import results_file
from suite_data import in_share
from support import HERE, SUITE, UNHURRIED, CommandTest

sys.path.insert(0, str(HERE))
import liar_kinds  # noqa: E402

DRIVERS = ("egl:llvmpipe", "egl:softpipe", "egl:zink")
CORE = (SUITE, "--suite", "core")
# Liars of one run: exact draws each case once for all of them.
AT_A_TIME = 12


class LiarKinds(CommandTest):
    def truth_of(self, driver):
        """The driver's honest answers, by way of a recording."""
        self.command("record", *CORE, "--against", driver, *UNHURRIED, "-o", "honest.rec",
                     expect=None)
        truth = self.folder / "truth.jsonl"
        self.command("render", *CORE, "--with", "recording:honest.rec", "--json", truth,
                     expect=None)
        return truth

    def verdicts_of(self, kinds, truth):
        """kind -> id -> verdict"""
        words = []
        for kind in kinds:
            pathlib.Path(f"{truth}.{kind}").unlink(missing_ok=True)
            program = [sys.executable, str(HERE / "liar_kinds.py"), kind, str(truth)]
            words += ["--against", f"{kind}=exec:{shlex.join(program)}"]
        results = self.results(*CORE, *words, "--no-rerun", *UNHURRIED, expect=None)
        return {kind: {case["id"]: case["results"][kind]["verdict"] for case in results["cases"]
                       if kind in case["results"]} for kind in kinds}

    def agreeing(self, kinds, truth):
        """(kind, id) of answers that say something else than the honest ones and agree, and how
        many say something else."""
        wrong, spoilt = [], 0
        for start in range(0, len(kinds), AT_A_TIME):
            for kind, found in self.verdicts_of(kinds[start:start + AT_A_TIME], truth).items():
                others = pathlib.Path(f"{truth}.{kind}").read_text("utf-8").split("\n")[:-1]
                spoilt += len(others)
                wrong += [(kind, name) for name in others if found[name] == "agree"]
        return wrong, spoilt

    def test_no_lie_agrees(self):
        """Honest answers do, to a third of the cases at least; the others differ legally."""
        for driver in DRIVERS:
            with self.subTest(driver):
                truth = self.truth_of(driver)
                honest = self.verdicts_of(["honest"], truth)["honest"]
                self.assertGreater(list(honest.values()).count("agree"), 60)
                self.assertEqual(self.agreeing(["honest"], truth), ([], 0))
                kinds = [kind for kind in in_share(liar_kinds.KINDS) if kind != "honest"]
                wrong, spoilt = self.agreeing(kinds, truth)
                self.assertEqual(wrong, [])
                self.assertGreater(spoilt, 10 * len(kinds))


if __name__ == "__main__":
    unittest.main()
