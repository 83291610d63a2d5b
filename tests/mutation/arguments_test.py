# SPDX-License-Identifier: MIT
"""Each argument about a mutant is about code that there is."""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from mutation import arguments  # noqa: E402  the path comes first

GOOD = """\
src/exact/a.h in Number::half:
  n / 2  ->  n * 2
  odd(n) (no. 2)  ->  (nothing)
    A sentence of at least five words.
  n > 0  ->  n >= 0
    Another sentence about the same function.
"""
CODE = "int Number::half(int n) { if (odd(n) || odd(n)) return n  // down\n    / 2; return n > 0; }\n"
WHY = "A sentence of at least five words."
PLACE = ("src/exact/a.h", "Number::half")


class Arguments(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        return path

    def test_ours_are_about_code_that_there_is(self):
        ours = arguments.load(ROOT / "tests/mutation/equivalent.txt")
        self.assertGreater(len(ours), 100)
        self.assertEqual(list(arguments.gone(ours, ROOT)), [])

    def test_each_mutant_has_the_sentence_below_it(self):
        self.assertEqual(arguments.load(self.write("good.txt", GOOD)), {
            (*PLACE, "n / 2", "n * 2", 1): WHY,
            (*PLACE, "odd(n)", "", 2): WHY,
            (*PLACE, "n > 0", "n >= 0", 1): "Another sentence about the same function."})

    def test_what_is_gone_is_told(self):
        loaded = arguments.load(self.write("good.txt", GOOD))
        self.assertEqual(len(list(arguments.gone(loaded, self.root))), 3)
        for code, count in ((CODE, 0), (CODE.replace("n > 0", "true"), 1),
                            (CODE.replace("half", "third"), 3)):
            self.write("src/exact/a.h", code)
            self.assertEqual(len(list(arguments.gone(loaded, self.root))), count, code)

    def test_what_is_malformed_is_refused(self):
        for text in ("  n / 2  ->  n * 2\n    " + WHY,                # of which file?
                     "a.h in f:\n  n / 2  ->  n * 2\n",               # why?
                     "a.h in f:\n  n / 2  ->  n * 2\n    So.\n",
                     "a.h in f:\n  n / 2  ->  n * 2\nb.h in g:\n",
                     "a.h in f:\n  n / 2 -> n * 2\n    " + WHY,       # one space
                     "a.h in f:\n    " + WHY,
                     GOOD + GOOD):
            with self.subTest(text=text), self.assertRaises(arguments.ArgumentError):
                arguments.load(self.write("bad.txt", text))


if __name__ == "__main__":
    unittest.main(verbosity=1)
