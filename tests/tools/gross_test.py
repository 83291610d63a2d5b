# SPDX-License-Identifier: MIT
"""Gross faults: answers that are wrong nearly everywhere cost little memory, are red, and what is
only counted of them is told wherever their disagreements are."""
import csv
import os
import shlex
import subprocess
import sys
import unittest

from support import EDGECASE, UNEXPECTED, CommandTest, environment, only_result

# Most that the command may take of memory, bytes; a disagreement in full takes some kilobytes.
MOST = 300 << 20
SIZE = 512  # pixels along a side: 1.7 GB if each disagreement were in full
SHOWN = 4096  # disagreements in full

# Draws nothing, in lines of which each is short-lived.
BLANK = """import json, sys
for line in sys.stdin:
    request = json.loads(line)
    target = request["scene"]["target"]
    clear = ",".join(str(round(255 * c)) for c in target["clear"])
    pixels = ",".join([clear] * (target["width"] * target["height"]))
    print('{"digest": "%s", "pixels": [%s], "fragments": []}' % (request["digest"], pixels),
          flush=True)
"""

# So many fragments anywhere, of any draw and any samples.
STRAY = """import json, random, sys
chance = random.Random(1)
for line in sys.stdin:
    request = json.loads(line)
    target, draws = request["scene"]["target"], len(request["scene"]["draws"])
    width, height, samples = target["width"], target["height"], target["samples"]
    fragments = ",".join('{"x":%d,"y":%d,"primitive":%d,"coverage":%d}' % (
        chance.randrange(width), chance.randrange(height), chance.randrange(draws),
        chance.randrange(1, 1 << samples)) for _ in range(100000))
    pixels = ",".join(["9"] * (4 * width * height))
    print('{"digest": "%s", "pixels": [%s], "fragments": [%s]}' % (
        request["digest"], pixels, fragments), flush=True)
"""


def covering_triangle():
    return {"title": "One triangle over all of a target", "rules": ["triangle.fill-rule"],
            "target": {"width": SIZE, "height": SIZE},
            "draws": [{"primitive": "triangles", "color": [1, 0, 0, 1],
                       "vertices": [[-1, -1], [3 * SIZE, -1], [-1, 3 * SIZE]]}]}


def many_triangles():
    corners = [(x, y) for x in range(0, 128, 16) for y in range(0, 128, 16)]
    return {"title": "64 triangles", "rules": ["triangle.fill-rule"],
            "target": {"width": 128, "height": 128, "samples": 16},
            "draws": [{"primitive": "triangles", "color": [1, 0, 0, 1],
                       "vertices": [[x, y], [x + 40.5, y + 3], [x + 2, y + 37.25]]}
                      for x, y in corners]}


class GrossFaults(CommandTest):
    def renderer(self, program):
        path = self.write("renderer.py", program)
        return f"exec:{shlex.quote(sys.executable)} {shlex.quote(str(path))}"

    def memory_of(self, *arguments):
        """The largest memory of the command and its programs, bytes."""
        running = subprocess.Popen([EDGECASE, *map(str, arguments)], cwd=self.folder,
                                   env=environment(), stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        _, status, used = os.wait4(running.pid, 0)
        running.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(running.returncode, UNEXPECTED)
        return used.ru_maxrss * 1024

    def test_a_blank_answer_takes_little_memory(self):
        self.write("cases/full.json", covering_triangle())
        used = self.memory_of("run", "cases", "--against", self.renderer(BLANK),
                              "--json", "out.json", "--html", "out.html", "--csv", "out.csv")
        self.assertLess(used, MOST)

    def test_stray_fragments_take_little_memory(self):
        self.write("cases/many.json", many_triangles())
        used = self.memory_of("run", "cases", "--against", self.renderer(STRAY),
                              "--json", "out.json")
        self.assertLess(used, MOST)

    def test_what_is_only_counted_is_told(self):
        self.write("cases/full.json", covering_triangle())
        left = f"{SIZE * SIZE - SHOWN:,}"
        results = self.results("cases", "--against", self.renderer(BLANK), "--junit", "out.xml",
                               "--html", "out.html", "--csv", "out.csv", "--markdown", "out.md",
                               expect=UNEXPECTED)
        result = only_result(results["cases"][0])
        self.assertEqual(result["verdict"], "violation")
        self.assertEqual(result["pixel_counts"]["agree"], 0)
        self.assertEqual(len(result["disagreements"]), SHOWN)
        self.assertEqual([one["count"] for one in result["counted"]], [SIZE * SIZE - SHOWN])
        self.assertIn(f"triangle.fill-rule missing, fbo: {SIZE * SIZE} in 1 case", self.summary)
        (clusters,) = results["clusters"].values()
        missing = [cluster for cluster in clusters if cluster["kind"] == "missing"]
        self.assertEqual([cluster["disagreements"] for cluster in missing], [SIZE * SIZE])
        self.assertIn(["of a gross fault, only counted", SIZE * SIZE - SHOWN, 1],
                      missing[0]["situations"])
        read = lambda name: (self.folder / name).read_text(encoding="utf-8")
        self.assertIn(f"and {SIZE * SIZE - 20} more, see results", read("out.xml"))
        self.assertIn(f"{SIZE * SIZE:,} disagreements", read("out.md"))
        with (self.folder / "out.csv").open(encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), SHOWN + 1)
        self.assertTrue(rows[-1]["explanation"].startswith(f"{left} of this kind"), rows[-1])
        told = self.command("explain", "cases/full.json", "--against", self.renderer(BLANK),
                            expect=None).stdout
        self.assertIn(f"and {left} more, missing, triangle.fill-rule, not allowed by ruling 4", told)


if __name__ == "__main__":
    unittest.main()
