# SPDX-License-Identifier: MIT
"""`edgecase bench`: everything is measured, on scenes that both sides draw; how fast is for nobody to assert."""
import json
import unittest

from support import SUITE, USAGE, CommandTest

RENDERER = "egl:llvmpipe"
QUICK = ["--rounds", "2", "--seconds", "0", "--side", "64", "--cases", "64"]


class Bench(CommandTest):
    def check_spread(self, spread):
        self.assertGreater(spread["low"], 0)
        self.assertLessEqual(spread["low"], spread["median"])
        self.assertLessEqual(spread["median"], spread["high"])

    def bench(self, *parts):
        arguments = [word for part in parts for word in ("--part", part)]
        run = self.command("bench", "--against", RENDERER, *QUICK, *arguments, "--json", "-")
        return json.loads(run.stdout)

    def test_scenes_are_drawn_by_both_sides(self):
        scenes = {scene["name"]: scene for scene in self.bench("scenes")["scenes"]}
        self.assertEqual(len(scenes), 9)
        for name, scene in scenes.items():
            with self.subTest(name):
                self.check_spread(scene["exact"]["seconds"])
                drawn = scene["renderers"][RENDERER]
                self.assertNotIn("problem", drawn)
                self.check_spread(drawn["seconds"])
                self.check_spread(drawn["ratio"])
        self.assertEqual(scenes["flat fill, 20 layers"]["renderers"][RENDERER]["same_pixels"], 64 * 64)
        # Ties, ends of lines and rounding may be otherwise, and no more than that.
        for name, scene in scenes.items():
            if "fill" not in name and "texture" not in name:
                self.assertGreater(scene["renderers"][RENDERER]["same_pixels"], 64 * 64 * 9 / 10, name)

    def test_the_pipeline_and_pictures(self):
        report = self.bench("pipeline", "diff")
        rates, = report["pipelines"]
        self.assertEqual((rates["renderer"], rates["cases"]), (RENDERER, 64))
        for key in ("worker", "one_core", "one_job", "two_jobs", "fuzz", "one_job_to_worker",
                    "two_jobs_to_worker", "two_jobs_to_one", "two_jobs_to_one_core"):
            self.check_spread(rates[key])
        for key in ("memcmp", "identical", "different", "identical_to_memcmp", "different_to_memcmp"):
            self.check_spread(report["diff"][key])
        self.assertEqual(report["scenes"], [])

    def test_stages_of_named_cases(self):
        run = self.command("bench", f"{SUITE}/triangles/ties", "--against", RENDERER, *QUICK, "--part",
                           "stages", "--json", "bench.json")
        self.assertIn("where time goes", run.stdout)
        stages, = json.loads((self.folder / "bench.json").read_text(encoding="utf-8"))["stages"]
        self.assertGreater(stages["cases"], 10)
        self.assertEqual(len(stages["seconds"]), 6)
        self.assertTrue(all(seconds > 0 for seconds in stages["seconds"].values()), stages)

    def test_only_our_own_workers_are_timed(self):
        run = self.command("bench", "--against", "exact", *QUICK, "--part", "scenes")
        self.assertIn("there is no renderer", run.stdout)
        self.command("bench", "--against", "egl:nothing", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
