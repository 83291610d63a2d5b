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
        self.assertEqual(len(stages["us_a_case"]), 6)
        self.assertTrue(all(time > 0 for time in stages["us_a_case"].values()), stages)
        (subject,) = stages["subjects"]
        self.assertEqual((subject["name"], subject["cases"]), ("coverage", stages["cases"]))
        self.assertEqual(sorted(subject["us_a_case"]), ["compare", "exact", "worker"])

    def test_one_is_held_against_another(self):
        words = ["bench", f"{SUITE}/triangles/ties", f"{SUITE}/samples/counts", "--against",
                 RENDERER, *QUICK, "--part", "stages", "--json", "bench.json"]
        self.command(*words)
        path = self.folder / "bench.json"
        other = json.loads(path.read_text(encoding="utf-8"))
        stages = other["stages"][0]
        self.assertEqual([one["name"] for one in stages["subjects"]], ["coverage", "samples"])
        stages["us_a_case"]["judge"] = 1e9
        stages["subjects"][0]["us_a_case"]["exact"] = 1e9
        del stages["us_a_case"]["write results"]
        self.write("other.json", json.dumps(other))
        out = self.command(*words, "--compare", "other.json").stdout
        for path in ("judge", "subjects / coverage / exact"):
            self.assertRegex(out, rf"1e\+09 +0\.00x  stages / {RENDERER} / {path}\n")
        self.assertIn(f"stages / {RENDERER} / subjects / samples / compare\n", out)
        self.assertNotIn("/ write results\n", out)
        self.write("none.json", "[]")
        run = self.command(*words, "--compare", "none.json", expect=USAGE)
        self.assertIn("none.json: it is no file that `edgecase bench --json` wrote", run.stderr)

    def test_only_our_own_workers_are_timed(self):
        run = self.command("bench", "--against", "exact", *QUICK, "--part", "scenes")
        self.assertIn("there is no renderer", run.stdout)
        self.command("bench", "--against", "egl:nothing", expect=USAGE)


if __name__ == "__main__":
    unittest.main()
