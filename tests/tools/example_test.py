# SPDX-License-Identifier: MIT
"""The example rasterizer in Python, judged over a fifth of what the suite has of what it draws."""
import unittest

from suite_data import COUNT, least_of, shard
from support import PATIENCE, PROBES, ROOT, CommandTest, only_result

PROGRAM = f"exec:/usr/bin/env python3 {ROOT / 'reference/examples/rasterizer.py'}"
# Python draws slowly, and on a busy machine an answer may take longer than the command waits.
PATIENT = ["--timeout", str(PATIENCE // 20)]


class PythonExample(CommandTest):
    def check(self, refusal, *selection):
        """(cases that it draws, cases that it says it does not)"""
        results = self.results(*selection, "--against", PROGRAM, *PATIENT, expect=None)
        drawn = refused = 0
        for case in results["cases"]:
            result = only_result(case)
            self.assertEqual(result["disagreements"], [], case["id"])
            if result["verdict"] == "not-run":
                refused += 1
                self.assertEqual(result["failure"]["kind"], "unsupported")
                self.assertRegex(result["failure"]["reason"], refusal)
            else:
                drawn += 1
                self.assertIn(result["verdict"], ("agree", "permitted"), case["id"])
        return drawn, refused

    def test_it_agrees(self):
        others = [word for folder in ("textures", "samples", "output", "clipping", "gallery")
                  for word in ("--exclude", f"{folder}/*")]
        drawn, refused = self.check("draws lines of width 1", *PROBES, *others,
                                                        *shard(2, 5))
        self.assertGreater(drawn, 1000 / COUNT)
        self.assertLess(refused, drawn / 9)

    def test_it_agrees_on_samples(self):
        drawn, _ = self.check("draws lines of width 1|draws one pass",
                                                 ROOT / "cases/samples", *shard(1, 5))
        self.assertGreater(drawn, 1000 / COUNT)

    def test_it_agrees_on_what_becomes_of_fragments(self):
        folders = [ROOT / "cases/output" / name
                   for name in ("depth", "stencil", "blending", "culling", "order", "offset")]
        folders.append(ROOT / "cases/gallery")
        drawn, refused = self.check("this example ", *folders, *shard(1, 5))
        self.assertGreater(drawn, 1000 / COUNT)
        self.assertLess(refused, drawn / 100)

    def test_it_agrees_on_what_leaves_the_clip_volume(self):
        drawn, refused = self.check("this example ", ROOT / "cases/clipping", "--exclude",
                                    "clipping/lines/wide-*", *shard(1, 5))
        self.assertGreater(drawn, 500 / COUNT)
        self.assertLess(refused, drawn / 20)

    def test_it_agrees_on_nearest_texels(self):
        folders = [ROOT / "cases/textures" / name for name in ("wrap", "filter", "formats")]
        # Its sweeps deal their filters unevenly to four shares.
        drawn, _ = self.check("this example ", *folders, *shard())
        self.assertGreater(drawn, least_of(200))


if __name__ == "__main__":
    unittest.main()
