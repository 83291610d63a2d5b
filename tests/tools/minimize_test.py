# SPDX-License-Identifier: MIT
"""edgecase minimize: what comes out is a case that shows the same, and as small as it gets."""
import json
import shlex
import sys
import unittest

from support import (NOTHING_SELECTED, RENDERER, ROOT, SUITE, USAGE, CommandTest, only_result,
                     triangle_case)

LLVMPIPE = "egl:llvmpipe"
# Where llvmpipe of every release differs, with the rule that the case is about.
KNOWN = [f"{SUITE}/lines/joints/gap-on-a-boundary.json",
         f"{SUITE}/lines/wide/ends-before-they-move.json",
         f"{SUITE}/triangles/fans/eight-within-a-pixel.json:dx=0.125:dy=0:reverse"]
# The example rasterizer, which ends wherever a draw is a fan.
CRASHING = """
import os, runpy, sys
sys.path.insert(0, os.path.dirname({path!r}))
class Lines:
    def __iter__(self):
        return self
    def __next__(self):
        line = sys.stdin_.readline()
        if not line:
            raise StopIteration
        if '"triangle_fan"' in line:
            sys.exit(1)
        return line
sys.stdin_, sys.stdin = sys.stdin, Lines()
runpy.run_path({path!r}, run_name="__main__")
"""


class Minimize(CommandTest):
    def minimized(self, *arguments):
        return json.loads(self.command("minimize", *arguments, "--json").stdout)

    def crashing_renderer(self):
        program = self.write("crashing.py", CRASHING.format(
            path=str(ROOT / "reference" / "examples" / "rasterizer.py")))
        return "exec:" + " ".join(map(shlex.quote, (sys.executable, str(program))))

    def test_known_finds_come_down_and_stay_what_they_are(self):
        for name in KNOWN:
            with self.subTest(name):
                told = self.minimized(name, "--against", LLVMPIPE)
                self.assertTrue(told["finished"])
                self.assertLessEqual(told["to"]["primitives"], 2)
                self.assertLessEqual(told["to"]["fraction_bits"], 4)
                self.assertLessEqual(told["to"]["width"] * told["to"]["height"],
                                     told["from"]["width"] * told["from"]["height"])
                # What a renderer is known to do is read from the suite that a case is of.
                profile = ROOT / "cases" / "profiles" / "egl-llvmpipe.json"
                self.write("cases/profiles/egl-llvmpipe.json", profile.read_text("utf-8"))
                case = self.write("cases/small.json", told["minimized"])
                self.command("validate", case)
                again = self.minimized(case, "--against", LLVMPIPE)
                self.assertEqual(again["signature"], told["signature"])
                self.assertEqual(again["to"], told["to"], "it can be made smaller still")

    def test_the_case_and_the_summary(self):
        run = self.command("minimize", KNOWN[0], "--against", LLVMPIPE, "-o", "new/small.json")
        self.assertEqual(run.stdout, "")
        self.assertRegex(run.stderr, r"^lines/joints/gap-on-a-boundary: line\.joint missing by .*, "
                                     r"not allowed, fbo\n"
                                     r"  from 2 primitives, 4x4, 1 fraction bit, .*\n"
                                     r"  to 2 primitives, .*: line .*\n  \d+ scenes asked\n$")
        case = json.loads((self.folder / "new/small.json").read_text(encoding="utf-8"))
        self.assertIn("Minimised from lines/joints/gap-on-a-boundary. egl:llvmpipe",
                      case["why"])
        self.assertEqual(case["rules"], ["line.joint"])
        self.assertIn("line.joint missing", case["title"])
        results = self.results("new/small.json", "--against", LLVMPIPE, expect=1)
        found = only_result(results["cases"][0])["disagreements"]
        self.assertEqual([(d["rule"], d["kind"]) for d in found], [("line.joint", "missing")])
        # The same text on standard output, each time.
        text = (self.folder / "new/small.json").read_text(encoding="utf-8")
        self.assertEqual(self.command("minimize", KNOWN[0], "--against", LLVMPIPE).stdout, text)

    def test_a_crash_is_a_find(self):
        fan = {"primitive": "triangle_fan", "color": [1, 1, 1],
               "vertices": [[3.25, 3.5], [6, 1], [7, 5], [1, 6]]}
        case = self.write("cases/fan.json", triangle_case(
            draws=[*triangle_case()["draws"], fan]))
        told = self.minimized(case, "--against", self.crashing_renderer())
        self.assertEqual(told["signature"]["failure"], "crashed")
        (draw,) = told["minimized"]["draws"]
        self.assertEqual(draw["primitive"], "triangle_fan")
        self.assertEqual(len(draw["vertices"]), 3)
        self.assertIn("fails here: crashed", told["minimized"]["why"])

    def test_rule_and_pixel_choose(self):
        everything = self.results(KNOWN[0], "--against", LLVMPIPE)
        d = only_result(everything["cases"][0])["disagreements"][0]
        place = f"{d['pixel'][0]},{d['pixel'][1]}"
        for arguments in (["--rule", d["rule"]], ["--pixel", place],
                          ["--rule", d["rule"], "--pixel", place]):
            self.minimized(KNOWN[0], "--against", LLVMPIPE, *arguments)
        for arguments in (["--rule", "triangle.fill-rule"], ["--pixel", "0,3"]):
            run = self.command("minimize", KNOWN[0], "--against", LLVMPIPE, *arguments,
                               expect=NOTHING_SELECTED)
            self.assertIn("nothing to minimise", run.stderr)
            self.assertIn("line.joint missing", run.stderr)

    def test_few_asks(self):
        run = self.command("minimize", KNOWN[1], "--against", LLVMPIPE, "--max-asks", "3")
        self.assertIn("3 scenes asked; not finished, --max-asks is reached", run.stderr)

    def test_nothing_differs(self):
        run = self.command("minimize", KNOWN[0], "--against", "exact", expect=NOTHING_SELECTED)
        self.assertEqual(run.stdout, "")
        self.assertIn("nothing to minimise: exact agrees with exact on "
                      "lines/joints/gap-on-a-boundary under this policy", run.stderr)

    def test_a_renderer_that_does_not_work(self):
        run = self.command("minimize", KNOWN[0], "--against", "exec:/bin/false", expect=RENDERER)
        self.assertIn("exec:/bin/false does not render lines/joints/gap-on-a-boundary: "
                      "crashed", run.stderr)

    def test_mistakes(self):
        sweep = f"{SUITE}/triangles/fans/eight-within-a-pixel.json"
        for arguments, message in [
                (["nowhere.json"], "nowhere.json"),
                ([sweep], "cases; name one of them, for example"),
                ([f"{sweep}:dx=9:dy=0"], 'dx=9:dy=0: there is no such case; `edgecase run'),
                ([KNOWN[0], "--pixel", "4,0"], "X from 0 to 3 and Y from 0 (bottom) to 3"),
                ([KNOWN[0], "--pixel", "one"], '"one" is no pixel'),
                ([KNOWN[0], "--rule", "line.diamonds"], "there is no rule"),
                ([KNOWN[0], "--max-asks", "0"], "--max-asks"),
                ([KNOWN[0], "--policy", "nobody"], "there is no policy"),
        ]:
            with self.subTest(arguments):
                run = self.command("minimize", *arguments, "--against", LLVMPIPE, expect=USAGE)
                self.assertIn(message, run.stderr)
                self.assertEqual(run.stdout, "")
        run = self.command("minimize", KNOWN[0], "--against", "egl:pipe", expect=USAGE)
        self.assertIn("egl:pipe", run.stderr)


if __name__ == "__main__":
    unittest.main()
