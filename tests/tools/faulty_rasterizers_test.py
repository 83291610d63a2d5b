# SPDX-License-Identifier: MIT
"""Twelve rasterizers behind exec:, each with one fault: `edgecase run` convicts each of the rule that
it breaks, over all that the suite has about it, and the same programs without it of nothing.

Where OpenGL leaves the rule open (whether a line's last pixel is drawn, who owns an edge), the policy
says it: `--no-latitude`, or that of a course.
"""
import collections
import shlex
import sys
import typing
import unittest

from suite_data import in_share
from support import AS_EXPECTED, HERE, SUITE, UNEXPECTED, CommandTest, only_result


class Fault(typing.NamedTuple):
    program: str  # the one that has it, and its name there
    name: str
    folders: list  # of the suite: all that is about it
    share: int  # one case in so many: all would take minutes
    verdict: str  # the worst
    rules: set  # every disagreement names one of these
    cause: str  # what most of those that have a cause are said to come of; empty: see below
    causes: typing.Optional[set] = None  # all that are named; none: any
    options: tuple = ()
    correct: str = "none"  # the same program without its fault


LINE = {"line.diamond-exit", "line.joint"}
FILL = {"triangle.fill-rule", "triangle.shared-edge"}
PERSPECTIVE = {"attribute.smooth", "derivative.plain", "derivative.fine", "derivative.coarse"}
FAULTS = {
    "the last pixel of lines is drawn": Fault(
        "faulty_rasterizer", "last-pixel", ["lines/ends", "lines/diamonds", "lines/strips"], 60,
        "violation", LINE, "line.algorithm=walk-floor-to-floor", options=("--no-latitude",)),
    "the first pixel of lines that go left is not": Fault(
        "faulty_rasterizer", "leftward", ["lines/ends", "lines/directions", "lines/slopes"], 40,
        "violation", LINE, "", options=("--no-latitude",)),
    "top edges come before right ones": Fault(
        "faulty_rasterizer", "top-right", ["triangles"], 40, "violation", {"triangle.fill-rule"},
        "triangle.fill-rule=top-right", {"triangle.fill-rule=top-right"},
        ("--policy", "scotty3d"), "first-vertex"),
    "vertices are kept to 4 bits, which is the least": Fault(
        "faulty_rasterizer", "4-bits", ["triangles/snapping", "triangles/ties", "points"], 20,
        "convention", {"triangle.fill-rule", "point.ownership"}, "",
        {"triangle.snap=4-half-even", "point.snap=4-half-even"}),
    "vertices are kept to 4 bits where 8 are told": Fault(
        "faulty_rasterizer", "4-bits-for-8", ["triangles/snapping", "triangles/ties", "points"], 20,
        "violation", {"triangle.fill-rule", "point.ownership"}, "",
        {"triangle.snap=4-half-even", "point.snap=4-half-even"}),
    "colours are interpolated without perspective": Fault(
        "value_mutant", "noperspective", ["values/perspective"], 20, "violation", PERSPECTIVE,
        "attribute.perspective=never", {"attribute.perspective=never"}),
    "the other vertex provokes": Fault(
        "value_mutant", "provoking-vertex", ["colors/provoking", "colors/flat"], 1, "violation",
        {"attribute.flat"}, "attribute.provoking-vertex=first",
        {"attribute.provoking-vertex=first", "attribute.provoking-vertex=last"}),
    "two samples have changed places": Fault(
        "sample_mutant", "swapped-0-1", ["samples/patterns"], 20, "contested",
        {"triangle.fill-rule"}, "sample.positions=swapped", {"sample.positions=swapped"}),
    "levels of detail come from dx alone": Fault(
        "texture_mutant", "x-only", ["textures/level-of-detail/longer-side.json",
                                     "textures/level-of-detail/odd-images.json",
                                     "textures/level-of-detail/within-a-quad.json"], 4, "violation",
        {"texture.scale-factor"}, "texture.scale-factor=x-only", {"texture.scale-factor=x-only"}),
    "premultiplied colours are taken for straight ones": Fault(
        "output_mutant", "straight-alpha", ["output/blending"], 60, "violation",
        {"blend.equation"}, "blend.equation=over-as-straight"),
    "equal depths fail": Fault(
        "output_mutant", "less-for-lequal", ["output/depth"], 20, "violation", {"depth.test"},
        "depth.test=ties-fail"),
    "shared edges are drawn twice": Fault(
        "faulty_rasterizer", "shared-twice", ["triangles/shared-edges", "triangles/fans"], 20,
        "violation", FILL, "triangle.fill-rule=closed", {"triangle.fill-rule=closed"}),
    "y points down": Fault(
        "faulty_rasterizer", "mirrored", ["points", "lines/directions", "triangles/single"], 40,
        "violation", {"window.origin"}, "window.origin", {"window.origin"}),
}


class FaultyRasterizers(CommandTest):
    def judged(self, fault, name, share, expect):
        """The results of one case in so many."""
        words = [sys.executable, "-B", str(HERE / f"{fault.program}.py"), name]
        paths = [f"{SUITE}/{folder}" for folder in fault.folders]
        cases = self.results(*paths, "--sample", f"1/{share}", *fault.options, "--timeout",
                             "60", "--against", "exec:" + " ".join(map(shlex.quote, words)),
                             expect=expect)["cases"]
        return [only_result(case) for case in cases]

    def check(self, title):
        fault = FAULTS[title]
        results = self.judged(fault, fault.name, fault.share,
                              UNEXPECTED if fault.verdict == "violation" else AS_EXPECTED)
        found = collections.Counter((d["rule"], d["cause"]) for result in results
                                    for d in result["disagreements"])
        self.assertLessEqual({rule for rule, _ in found}, fault.rules, found)
        causes = collections.Counter()
        for (_, cause), count in found.items():
            causes[cause] += count
        if fault.cause:
            causes.pop("", None)
            self.assertEqual(causes.most_common(1)[0][0], fault.cause, found)
        if fault.causes is not None:
            self.assertLessEqual({cause for _, cause in found}, fault.causes, found)
        verdicts = {result["verdict"] for result in results}
        order = ["not-run", "agree", "convention", "permitted", "contested", "violation"]
        self.assertEqual(max(verdicts, key=order.index), fault.verdict)
        # What is drawn right agrees, and the fault is seen more often than once.
        self.assertIn("agree", verdicts)
        told = [result for result in results if result["disagreements"]]
        self.assertGreaterEqual(len(told), 3, found)
        for result in told:
            self.assertNotEqual(result["verdict"], "agree")

    def check_correct(self, title):
        fault = FAULTS[title]
        results = self.judged(fault, fault.correct, 3 * fault.share, None)
        verdicts = collections.Counter(result["verdict"] for result in results)
        self.assertEqual([result["disagreements"] for result in results], [[]] * len(results))
        self.assertLessEqual(set(verdicts), {"agree", "permitted", "convention", "not-run"})
        self.assertGreaterEqual(verdicts["agree"], sum(verdicts.values()) / 2)
        for result in results:
            if result["verdict"] == "not-run":
                self.assertEqual(result["failure"]["kind"], "unsupported")


def add_tests():
    for title in FAULTS:
        setattr(FaultyRasterizers, test_name("test", title),
                lambda self, title=title: self.check(title))
    for title in in_share(FAULTS):
        setattr(FaultyRasterizers, test_name("test_without", title),
                lambda self, title=title: self.check_correct(title))


def test_name(prefix, title):
    return f"{prefix}_{title.replace(' ', '_').replace(',', '').replace('-', '_')}"


add_tests()

if __name__ == "__main__":
    unittest.main()
