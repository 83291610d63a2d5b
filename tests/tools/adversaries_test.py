# SPDX-License-Identifier: MIT
"""Renderers that are legal and as odd as OpenGL's text lets them be (tests/adversaries): over the
whole suite none of them gets a violation. Beside each freedom stands the next thing that the text
forbids, a crime: each is convicted, of the rule that it breaks, and no known fault of a driver
excuses it.
"""
import collections
import json
import re
import subprocess
import unittest

from suite_data import IS_QUICK, NUMBER, in_share, shard
from support import BIN, PROBES, ROOT, SUITE, CommandTest, environment, only_result

PROGRAM = str(BIN / "edgecase-adversary")

# Whose known faults must excuse no crime.
DRIVERS = ["llvmpipe", "softpipe", "zink", "SwiftShader"]
LINES = {"line.diamond-exit", "line.joint"}
DERIVATIVES = {"derivative.plain", "derivative.fine", "derivative.coarse"}
# The crime -> the rules of which it is convicted, where, and one case in so many.
CRIMES = {
    "a step too far": ({"triangle.fill-rule", "triangle.shared-edge", "point.ownership"},
                       ["triangles", "points"], 24),
    "a tie rule for each triangle": ({"triangle.shared-edge"}, ["triangles"], 48),
    "points a step larger": ({"point.ownership"}, ["points"], 12),
    "points on the side dropped": ({"point.ownership"}, ["clipping/points"], 12),
    "lines two units off": (LINES, ["lines"], 256),
    "lines two longer": (LINES, ["lines"], 256),
    "lines two shorter": (LINES, ["lines"], 256),
    "two in a column": ({"line.diamond-exit", "fragment.once"}, ["lines"], 256),
    "joints with a gap": ({"line.joint"}, ["lines/strips"], 32),
    "lines one wider": ({"line.diamond-exit"}, ["lines/wide"], 48),
    "flat by one unit": ({"attribute.flat"}, ["colors/flat"], 4),
    "values a quarter pixel off": ({"attribute.smooth"}, ["values/interpolation"], 96),
    "values beyond the hull": ({"attribute.smooth"}, ["values/interpolation"], 96),
    "units of half the size": ({"offset.unit"}, ["output/offset"], 16),
    "units that differ": ({"offset.unit"}, ["output/offset"], 16),
    "coordinates by one unit": ({"fragment.coordinates"}, ["values"], 96),
    "derivatives two pixels away": (DERIVATIVES, ["values/derivatives"], 16),
    "masks ignored": ({"sample.mask"}, ["samples/masks"], 24),
    "a sample too few": ({"triangle.fill-rule"}, ["samples"], 48),
    "shaded once": ({"sample.shading-rate"}, ["samples/shading"], 24),
    "centroids at the centre": ({"attribute.centroid"}, ["samples/attributes"], 24),
    "attributes beside the pixel": ({"attribute.smooth", "attribute.location"},
                                    ["samples/attributes"], 24),
    "alpha 1 keeps all but one": ({"sample.alpha-to-coverage"}, ["samples/alpha"], 16),
    "scale factors below the least": ({"texture.scale-factor"}, ["textures/level-of-detail"], 48),
    "scale factors beyond the most": ({"texture.scale-factor"}, ["textures/level-of-detail"], 48),
    "levels five 64ths off": ({"texture.scale-factor", "texture.log2"},
                              ["textures/level-of-detail"], 48),
    "texels a 14th off": ({"texture.filter"}, ["textures/filter"], 24),
    "biases clamped at 1": ({"texture.scale-factor", "texture.lod-bias"}, ["textures/levels"], 6),
    "mipmaps darker by two codes": ({"mipmap.filter"}, ["textures/mipmaps"], 4),
    "codes one beyond": ({"framebuffer.unorm8"}, ["colors"], 96),
    "a depth converted in two ways": ({"framebuffer.depth", "depth.test"}, ["output/depth"], 24),
    "blending in 4 bits": ({"blend.equation"}, ["output/blending"], 96),
    "means off by 1 in 10^5": ({"supersample.accumulation"}, ["samples/supersampling"], 48),
}


def named(kind):
    """The program's adversaries of a kind, legal or crime."""
    lines = subprocess.run([PROGRAM], env=environment(), capture_output=True, text=True,
                           check=True).stdout.splitlines()
    return [line.removeprefix(f"{kind} ") for line in lines if line.startswith(f"{kind} ")]


def violations(results):
    """(case, rule, explanation) of all."""
    for case in results:
        for disagreement in only_result(case)["disagreements"]:
            if disagreement["legality"] == "illegal":
                yield case["id"], disagreement["rule"], disagreement["explanation"]


class Adversaries(CommandTest):
    def judged(self, name, *selection, driver="adversary"):
        """The results of the adversary, which goes by the name of a driver."""
        return self.results(*selection, "--no-rerun", "--timeout", "60", "--jobs", "1", "--against",
                            f"{driver}=exec:{PROGRAM} '{name}'", expect=None)["cases"]

    def test_legal_ones_are_never_convicted(self):
        """One of all freedoms at once over all of the suite, the others over a part of it each."""
        names = named("legal")
        others = [name for name in names if name != "everything"]
        parts = [("everything", shard())] + [(name, shard(i % 12 + 1, 12))
                                             for i, name in enumerate(others)
                                             if not IS_QUICK or i % 6 == NUMBER % 6]
        self.assertGreater(len(names), 20)
        for name, part in parts:
            with self.subTest(name):
                cases = self.judged(name, *PROBES, *part)
                verdicts = collections.Counter(only_result(case)["verdict"] for case in cases)
                print(f"{name}: {dict(verdicts)}")
                self.assertEqual(list(violations(cases))[:3], [], name)
                self.assertLessEqual(set(verdicts), {"agree", "convention", "permitted",
                                                     "contested"}, name)
                if name != "plain":  # it makes use of its freedoms
                    self.assertGreater(sum(verdicts.values()) - verdicts["agree"], 0, name)

    def test_crimes_are_convicted(self):
        self.assertEqual(named("crime"), list(CRIMES))
        names = list(CRIMES)[NUMBER % 8::8] if IS_QUICK else in_share(CRIMES)
        for name in names:
            rules, folders, share = CRIMES[name]
            driver = DRIVERS[list(CRIMES).index(name) % len(DRIVERS)]
            with self.subTest(name, driver=driver):
                cases = self.judged(name, *(f"{SUITE}/{folder}" for folder in folders),
                                    "--sample", f"1/{share}", driver=driver)
                new = [case for case in cases if only_result(case)["standing"] == "unexpected"]
                found = collections.Counter(rule for _, rule, _ in violations(new))
                self.assertTrue(rules & set(found), f"{name}: {found}")

    def test_the_core_convicts_each_crime(self):
        names = list(CRIMES)[NUMBER % 8::8] if IS_QUICK else in_share(CRIMES)
        for name in names:
            with self.subTest(name):
                found = [only_result(case)["verdict"]
                         for case in self.judged(name, SUITE, "--suite", "core")]
                self.assertIn("violation", found)

    def test_the_core_shows_each_known_fault(self):
        """Those of which this release's count is known; but for places of samples, which take the
        answers to many more cases (ruling 65)."""
        drivers = DRIVERS[:3]
        against = [word for driver in drivers for word in ("--against", f"egl:{driver}")]
        results = self.results(SUITE, "--suite", "core", *against)
        seen = {(fault["renderer"], fault["id"]) for fault in results["faults"] if fault["cases"]}
        for driver, renderer in zip(drivers, results["renderers"]):
            release = re.search(r"Mesa \S+", renderer["version"])[0]
            known = json.loads((ROOT / f"cases/known/{driver}.json").read_text("utf-8"))["faults"]
            for fault in known:
                takes_more = "sample.positions" in fault.get("rule", "")
                if release in fault.get("cases_on", {}) and not takes_more:
                    self.assertIn((f"egl:{driver}", fault["id"]), seen)


if __name__ == "__main__":
    unittest.main()
