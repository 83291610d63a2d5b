# SPDX-License-Identifier: MIT
"""Renderers that tell one lie about everything (liar.py), each made of the honest answers of
a Mesa driver to the core suite: no answer that a lie made another one agrees."""
import json
import pathlib
import shlex
import sys
import unittest

import results_file
from suite_data import in_share
from support import HERE, SUITE, UNHURRIED, CommandTest

sys.path.insert(0, str(HERE))
import liar  # noqa: E402

DRIVERS = ("egl:llvmpipe", "egl:softpipe", "egl:zink")
CORE = (SUITE, "--suite", "core")
# Liars of one run: exact draws each case once for all of them.
AT_A_TIME = 12


class LiarKinds(CommandTest):
    def setUp(self):
        super().setUp()
        self.exact = self.folder / "exact.jsonl"
        self.command("render", *CORE, "--json", self.exact)
        with self.exact.open(encoding="utf-8") as lines:
            self.drawn = {rendering["id"]: liar.digest_of_drawn(rendering)
                          for rendering in map(json.loads, lines)}

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
            program = [sys.executable, str(HERE / "liar.py"), kind, str(truth)]
            words += ["--against", f"{kind}=exec:{shlex.join(program)}"]
        results = self.results(*CORE, *words, "--no-rerun", *UNHURRIED, expect=None)
        return {kind: {case["id"]: case["results"][kind]["verdict"] for case in results["cases"]}
                for kind in kinds}

    def judge(self, truth):
        """(kind, id) of answers that a lie made other ones and that agree, and how many others
        there are. Only if the honest answer differs, a lie may happen to be what exact draws."""
        honest = self.verdicts_of(["honest"], truth)["honest"]
        self.assertGreater(list(honest.values()).count("agree"), 60, "most others differ legally")
        kinds = [kind for kind in in_share(liar.KINDS) if kind != "honest"]
        wrong, others = [], 0
        for start in range(0, len(kinds), AT_A_TIME):
            for kind, found in self.verdicts_of(kinds[start:start + AT_A_TIME], truth).items():
                told = pathlib.Path(f"{truth}.{kind}").read_text("utf-8")
                for name, drawn in map(str.split, told.splitlines()):
                    others += 1
                    if found[name] == "agree" and (honest[name] == "agree" or
                                                   drawn != self.drawn[name]):
                        wrong.append((kind, name))
        self.assertEqual(wrong, [])
        self.assertGreater(others, 10 * len(kinds))

    def test_no_lie_about_what_drivers_draw_agrees(self):
        for driver in DRIVERS:
            with self.subTest(driver):
                self.judge(self.truth_of(driver))

    def test_no_lie_about_what_exact_draws_agrees(self):
        """It supports all cases, places of samples among them, and agrees with itself."""
        self.judge(self.exact)


if __name__ == "__main__":
    unittest.main()
