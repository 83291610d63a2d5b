# SPDX-License-Identifier: MIT
"""The first sentence of a run names what a rasterizer does wrong as a whole, and both faults of most
that have two."""
import shlex
import sys
import unittest

from suite_data import in_share
from support import HERE, ROOT, SUITE, UNEXPECTED, CommandTest
from whole_renderer import FAULTS

CASES = [f"{SUITE}/{folder}" for folder in (
    "triangles/single", "triangles/shared-edges", "triangles/fans", "points", "output/depth",
    "output/stencil", "colors")]
SHARE = 30  # one case in so many
MIXTURES = ["corner+bgr", "whole+bgr", "corner+culled", "whole+upside-down", "culled+254",
            "first-draw+bgr", "off+culled", "quarters+254", "upside-down+bgr"]
MOST_UNNAMED = 2  # of the mixtures


class WholeRenderers(CommandTest):
    def first_lines(self, fault):
        """What is said of all answers together."""
        words = [sys.executable, "-B", str(HERE / "whole_renderer.py"),
                 f"{sys.executable} -B {ROOT}/reference/examples/rasterizer.py", fault]
        finished = self.command("run", *CASES, "--sample", f"1/{SHARE}", "--timeout", "60",
                                     "--against", "exec:" + " ".join(map(shlex.quote, words)),
                                     "--json", "out.json", expect=UNEXPECTED)
        return [line for line in finished.stdout.splitlines() if line.startswith("It ")]

    def check(self, fault):
        lines = self.first_lines(fault)
        self.assertEqual(len(lines), 1, lines)
        self.assertIn(FAULTS[fault][2] + ":", lines[0])

    def headings(self, fault, *paths):
        """(rule, kind) of what is not allowed, of differences in coverage."""
        words = [sys.executable, "-B", str(HERE / "whole_renderer.py"),
                 f"{sys.executable} -B {ROOT}/reference/examples/rasterizer.py", fault]
        results = self.results(*paths, "--sample", "1/12", "--timeout", "60", "--against",
                               "exec:" + " ".join(map(shlex.quote, words)), expect=UNEXPECTED)
        (clusters,) = results["clusters"].values()
        return [(c.get("rule"), c.get("kind"), c.get("cause")) for c in clusters
                if c["legality"] == "illegal" and c.get("kind") != "value"]

    def test_a_small_fault_has_one_heading(self):
        self.assertEqual(self.headings("y-major-extra", f"{SUITE}/lines"),
                         [("line.diamond-exit", "extra", None)])
        self.assertEqual(self.headings("joint-dropped", f"{SUITE}/lines"),
                         [("line.joint", "missing", None)])

    def test_most_mixtures_are_named_whole(self):
        unnamed = []
        asked = in_share(MIXTURES)
        for mixture in asked:
            said = " ".join(self.first_lines(mixture))
            if not all(FAULTS[fault][2] in said for fault in mixture.split("+")):
                unnamed.append((mixture, said))
        self.assertLessEqual(len(unnamed), MOST_UNNAMED * len(asked) // len(MIXTURES), unnamed)


def add_tests():
    for fault in in_share(FAULTS):
        setattr(WholeRenderers, f"test_{fault.replace('-', '_')}",
                lambda self, fault=fault: self.check(fault))


add_tests()
if __name__ == "__main__":
    unittest.main()
