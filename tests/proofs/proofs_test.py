# SPDX-License-Identifier: MIT
"""All claims are proven, of the sources as they are; wrong claims are not, and neither are right
ones of sources with a fault in them."""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
CLAIMS = re.compile(r"^void (claim_\w+)\(", re.MULTILINE)

# file, what stands there, what is planted, a claim that must then fail
FAULTS = [
    ("triangle_algorithm", "right * Fixed::kOne, up", "right * Fixed::kOne + 1, up",
     "claim_walk_goes_on_as_it_began"),
    ("triangle_algorithm", "ties.positive(0, right, up)", "ties.positive(0, up, right)",
     "claim_walk_begins_as_the_plain_decision"),
    ("homogeneous_triangle", "Int128{b.x} * a.w", "Int128{b.x * a.w}",
     "claim_walk_by_quotients"),
    ("diamond_exit", "* d.radius;", "* (d.radius - 1);",
     "claim_meeting_by_fixed_point_and_quotients_agree"),
    ("diamond_exit", "d.centre.v + d.radius, -1, 1)", "d.centre.v + d.radius, 1, -1)",
     "claim_sides_by_fixed_point_and_quotients_agree"),
    ("homogeneous_line", "u_high(u_low + 2)", "u_high(u_low + 1)",
     "claim_sides_by_fixed_point_and_quotients_agree"),
]


def prove(name, *arguments, sources=()):
    """claim -> what is said of it"""
    includes = [*sources, ROOT / "src", ROOT]
    run = subprocess.run(
        [sys.executable, "-B", HERE / "prove.py", HERE / f"{name}.cpp", *arguments,
         *(word for path in includes for word in ("--include", path))],
        capture_output=True, text=True, timeout=900)
    if run.stderr:
        raise AssertionError(run.stderr)
    outcomes = dict(re.findall(r"^(claim_\w+): (.*)$", run.stdout, re.MULTILINE))
    proven = all(outcome.startswith("proven") for outcome in outcomes.values())
    assert run.returncode == (0 if proven else 1), run.stdout
    return outcomes


def claims(name):
    return set(CLAIMS.findall((HERE / f"{name}.cpp").read_text(encoding="utf-8")))


class Proofs(unittest.TestCase):
    def test_claims_are_proven(self):
        for name in ("edges", "diamonds"):
            outcomes = prove(name)
            print(*(f"{claim}: {said}" for claim, said in outcomes.items()), sep="\n")
            self.assertEqual(set(outcomes), claims(name))
            for claim, said in outcomes.items():
                self.assertRegex(said, r"^proven, [1-9]\d* inputs, [1-9]\d* operations", claim)

    def test_wrong_claims_are_not(self):
        outcomes = prove("wrong")
        self.assertEqual(set(outcomes), claims("wrong"))
        self.assertGreater(len(outcomes), 5)
        for claim, said in outcomes.items():
            self.assertRegex(said, r"^NOT PROVEN at .*: \[n\d+ = ", claim)

    def test_faults_in_the_sources_are_found(self):
        for file, before, after, claim in FAULTS:
            with self.subTest(f"{file}: {after}"), tempfile.TemporaryDirectory() as folder:
                path = pathlib.Path("rules/coverage") / f"{file}.cpp"
                text = (ROOT / "src" / path).read_text(encoding="utf-8")
                self.assertIn(before, text)
                changed = pathlib.Path(folder) / path
                changed.parent.mkdir(parents=True)
                changed.write_text(text.replace(before, after), encoding="utf-8")
                harness = "edges" if "triangle" in file else "diamonds"
                # Six times the steps of the hardest proof: the search for a model may take minutes.
                (said,) = prove(harness, "--only", claim, "--steps", "30000000",
                                sources=[folder]).values()
                self.assertRegex(said, "^NOT PROVEN")


if __name__ == "__main__":
    unittest.main()
