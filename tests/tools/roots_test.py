# SPDX-License-Identifier: MIT
"""`edgecase backends exec:PROGRAM` tells the mistake that many failed checks come of: the right example
has none, and each that is planted is told alone, with its remedy."""
import json
import shlex
import sys
import textwrap
import unittest

from suite_data import in_share
from support import AS_EXPECTED, HERE, UNEXPECTED, CommandTest

# Name of the fault in faulty_rasterizer.py: how the sentence that tells it begins, and words of its
# remedy.
ROOTS = {
    "mirrored": ("the image is upside down", "let y point up"),
    "pixels-mirrored": ("its pixels are upside down, and its fragments are not", "rows of"),
    "fragments-mirrored": ("its fragments are upside down, and its pixels are not", 'count "y"'),
    "bgr": ("red and blue are exchanged", "red, green, blue, alpha"),
    "bgr-clear": ("red and blue are exchanged in the clear colour", "red, green, blue, alpha"),
    "nothing": ("it draws nothing", 'draw what "draws" holds'),
    "no-pixels": ("all pixels are alike, although it lists fragments", "write the colour"),
    "no-fragments": ("it draws pixels and lists no fragment", "list each pixel"),
    "no-clockwise": ("clockwise triangles are culled", "draw both facings"),
    "no-counterclockwise": ("counterclockwise triangles are culled", "draw both facings"),
    "254": ("a colour of 1 is told as 254", "round(255 * c)"),
    "early": ("fragments that fail the depth or the stencil test are not listed",
              "list every fragment"),
    "early-depth": ("fragments that fail the depth test are not listed", "list every fragment"),
}
LATER = "put the root right first"
# Whatever is asked, nothing is drawn, and points are refused.
VACUOUS = """
    import json, sys
    for request in map(json.loads, sys.stdin):
        target = request["scene"]["target"]
        if any(draw["primitive"] != "triangles" for draw in request["scene"]["draws"]):
            answer = {"not_run": "triangles only"}
        else:
            clear = [round(255 * n) for n in target["clear"]]
            answer = {"pixels": clear * (target["width"] * target["height"]), "fragments": []}
        print(json.dumps({"digest": request["digest"], **answer}), flush=True)
    """


class Roots(CommandTest):
    def examined(self, *words, expect):
        self.renderer = "exec:" + " ".join(map(shlex.quote, [sys.executable, "-B", *words]))
        run = self.command("backends", self.renderer, "--json", "-", "--timeout", "60",
                           expect=expect)
        (told,) = json.loads(run.stdout)["renderers"]
        return told

    def faulty(self, fault, expect):
        return self.examined(str(HERE / "faulty_rasterizer.py"), fault, expect=expect)

    def vacuous(self):
        return str(self.write("vacuous.py", textwrap.dedent(VACUOUS)))

    def test_the_right_one_has_none(self):
        told = self.faulty("none", AS_EXPECTED)
        self.assertEqual(told["roots"], [])
        self.assertEqual(told["refused"], ["wide lines", "supersampling"])
        self.assertEqual(told["summary"], {"pass": 41, "fail": 0, "not_supported": 2,
                                           "not_asked": 0})

    def test_each_is_told_alone(self):
        for fault, (finding, remedy) in in_share(ROOTS.items()):
            with self.subTest(fault):
                told = self.faulty(fault, UNEXPECTED)
                (root,) = told["roots"]
                self.assertEqual(root["finding"][:len(finding)], finding)
                self.assertIn(remedy, root["remedy"])
                if fault == "bgr":
                    self.assertEqual(root["finding"], finding)
                failed = [check for check in told["checks"] if check["outcome"] == "fail"]
                self.assertTrue(failed)
                for check in failed:
                    self.assertTrue(check["remedy"] == root["remedy"] or LATER in check["remedy"],
                                    check)

    def test_nothing_passes_unasked(self):
        told = self.examined(self.vacuous(), expect=UNEXPECTED)
        (root,) = told["roots"]
        self.assertIn("it draws nothing", root["finding"])
        self.assertIn("points", told["refused"])
        outcomes = {check["name"]: check["outcome"] for check in told["checks"]}
        self.assertEqual(len(outcomes), 43)
        for name in list(outcomes)[35:42]:
            self.assertEqual(outcomes[name], "not asked", name)
        drawn = [name for name in outcomes if name.startswith("draws or refuses ")]
        self.assertNotIn("pass", {outcomes[name] for name in drawn})

    def test_roots_come_first(self):
        self.vacuous()
        run = self.command("backends", f"exec:{sys.executable} -B vacuous.py", expect=UNEXPECTED)
        lines = run.stdout.splitlines()
        self.assertTrue(lines[1].startswith("Root: it draws nothing"), run.stdout)
        self.assertTrue(lines[2].startswith("      Remedy: "), run.stdout)
        self.assertTrue(lines[3].startswith("Refused: "), run.stdout)
        self.assertRegex(run.stdout, r"\n43 checks: .* \(\d+ may follow from the root\), 7 not asked\n")


if __name__ == "__main__":
    unittest.main()
