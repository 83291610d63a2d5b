# SPDX-License-Identifier: MIT
"""Whole scenes: what is told of their pixels, in how much room, and what they show."""
import json
import pathlib
import subprocess
import sys
import unittest
import zlib

from results_file import picture_of, places_of
from suite_data import COUNT, in_share
from support import ROOT, SUITE, CommandTest, contents, only_result

SCENES = f"{SUITE}/scenes"
VERDICTS = ["agree", "convention", "permitted", "contested", "violation"]
MOST_BYTES = 200_000  # of one renderer's result, packed

# Refuses each scene after a while, and notes by which process.
REFUSING = """import json, os, sys, time
for line in sys.stdin:
    open(sys.argv[1], "a").write(f"{os.getpid()}\\n")
    time.sleep(.05)
    answer = {"digest": json.loads(line)["digest"], "not_run": "nothing is drawn here"}
    print(json.dumps(answer), flush=True)
"""


class WholeScenes(CommandTest):
    def test_every_pixel_is_counted_in_little_room(self):
        for name in ("run", "again"):
            (self.folder / name).mkdir()
        # More than fifty cases, from files of which each has at least one large scene.
        files = in_share(sorted(pathlib.Path(SCENES).glob("*.json")))
        results = self.results(*files, "--against", "egl:llvmpipe", "--html", "run/report.html")
        self.assertGreater(len(results["cases"]), 50 // COUNT)
        large = 0
        for case in results["cases"]:
            with self.subTest(case=case["id"]):
                self.check_case(case, only_result(case))
                large += case["width"] == 512
        self.assertGreater(large, 20 // COUNT)
        page = contents(self.folder / "run")
        self.assertLess(sum(map(len, page.values())), 1_000_000 * large * 2)
        # What was folded is read back: the report of the file is that of the run.
        self.command("report", "results.json", "--html", "again/report.html")
        self.assertTrue(contents(self.folder / "again") == page)

    def check_case(self, case, result):
        self.assertIn(result["standing"], ("expected", "known", "tolerated"))
        self.assertLess(len(zlib.compress(json.dumps(result).encode())), MOST_BYTES)
        counts = result["pixel_counts"]
        area = case["width"] * case["height"]
        self.assertEqual(sum(counts[verdict] for verdict in VERDICTS), area)
        self.assertEqual([v for v in VERDICTS if counts[v]][-1], result["verdict"])
        exact = picture_of(case, {})
        same = [a == b for a, b in zip(exact, picture_of(case, result), strict=True)]
        self.assertEqual(sum(same), counts["same"])
        differing = {tuple(d["pixel"]) for d in result["disagreements"]}
        for values in result["values"]:
            differing.update(places_of(values))
        self.assertEqual(area - len(differing), counts["agree"])

    def test_glass_in_the_right_order_shows_all_panes_and_in_the_wrong_one_the_nearest(self):
        lines = self.command("render", f"{SCENES}/glass-sorted.json",
                             f"{SCENES}/glass-unsorted.json", "--filter", "*:size=512",
                             "--json", "-").stdout.splitlines()
        panes = [(.9, .15, .1), (.1, .75, .2), (.1, .3, .95)]
        # All three panes and a white square of the wall lie behind this pixel.
        place = 512 * 240 + 250
        for line, seen in zip(lines, (panes, panes[2:]), strict=True):
            color = (1, 1, 1)
            for pane in seen:
                color = [(a + b) / 2 for a, b in zip(pane, color)]
            shown = json.loads(line)["pixels"][4 * place:4 * place + 4]
            for code, component in zip(shown, color):
                # Each pane's mean is rounded.
                self.assertAlmostEqual(code, 255 * component, delta=1)

    def test_both_jobs_draw_where_there_are_only_large_scenes(self):
        """They take much memory, so that a single one is drawn at a time beside smaller ones."""
        program = self.folder / "slow.py"
        program.write_text(REFUSING, encoding="utf-8")
        self.command("run", f"{SCENES}/knot.json", "--jobs", "2", "--no-rerun",
                     "--against", f"exec:{sys.executable} {program} marks", expect=None)
        asked = (self.folder / "marks").read_text(encoding="utf-8").split()
        self.assertGreater(len(asked), 5)
        self.assertEqual(len(set(asked)), 2)

    def test_the_knot_is_what_its_script_writes(self):
        meshes = ROOT / "cases" / "meshes"
        written = subprocess.run([sys.executable, "-B", str(meshes / "torus_knot.py")],
                                 capture_output=True, text=True, check=True).stdout
        self.assertEqual((meshes / "torus-knot.obj").read_text(encoding="utf-8"), written)


if __name__ == "__main__":
    unittest.main()
