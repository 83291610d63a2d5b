# SPDX-License-Identifier: MIT
"""OpenGL ES against OpenGL on the same driver, over a share of the suite: every case that both draw
has the same answer, fragment for fragment, and every case that OpenGL ES does not draw says what it
lacks."""
import json
import re
import unittest

from support import RENDERER, SUITE, CommandTest, only_result

# Files in which each thing that OpenGL ES lacks is asked for, and most of what it has.
SHARE = [f"{SUITE}/{name}.json" for name in (
    "points/centres", "points/outside", "lines/short/between-diamonds", "clipping/points/border",
    "colors/provoking/every-primitive", "surfaces/eighths", "output/depth/at-each-sample",
    "output/stencil/before-depth", "values/derivatives/constant", "samples/enable/triangle-on-and-off",
    "textures/formats/srgb-border", "textures/lookups/gradients-of-one-dimension",
    "textures/levels/sampler-bias", "textures/mipmaps/odd-sizes")]
LACKS = re.compile("|".join((
    "OpenGL ES has no first vertex convention: a primitive's last vertex provokes",
    "OpenGL ES has no fine and no coarse derivatives",
    "OpenGL ES has no one-dimensional textures",
    "OpenGL ES has no bias of a sampler's level of detail",
    "OpenGL ES cannot switch multisampling off",
    "OpenGL ES does not say what is drawn of points and lines beyond the viewport",
)))
REFUSAL = re.compile(r"edgecase: (.+): unsupported: (.+)")


class OpenGlEs(CommandTest):
    def rendered(self, renderer):
        """id -> rendering, and id -> why there is none."""
        run = self.command("render", *SHARE, "--with", renderer, "--timeout", "120", "--json", "-",
                           expect=None)
        refusals = {}
        for line in run.stderr.splitlines():
            match = REFUSAL.fullmatch(line)
            self.assertIsNotNone(match, line)
            refusals[match[1]] = match[2]
        self.assertEqual(run.returncode, RENDERER if refusals else 0, run.stderr)
        renderings = {rendering["id"]: rendering
                      for rendering in map(json.loads, run.stdout.splitlines())}
        return renderings, refusals

    def compare(self, driver):
        """What each of both refuses, and how many cases they drew alike."""
        es, lacking = self.rendered(f"egl-es:{driver}")
        desktop, refused = self.rendered(f"egl:{driver}")
        for name, rendering in es.items():
            self.assertEqual(rendering, desktop.get(name), name)
        new = {name: reason for name, reason in lacking.items() if refused.get(name) != reason}
        for name, reason in new.items():
            self.assertRegex(reason, LACKS, name)
        # Nothing is refused by OpenGL that OpenGL ES draws.
        self.assertLessEqual(set(refused), set(lacking))
        return len(es), set(new.values())

    def test_llvmpipe_answers_as_through_opengl(self):
        alike, sentences = self.compare("llvmpipe")
        self.assertGreater(alike, 100)
        self.assertEqual(len(sentences), 6, sentences)

    def test_softpipe_answers_as_through_opengl(self):
        # Without samples, it has none to switch off.
        alike, sentences = self.compare("softpipe")
        self.assertGreater(alike, 80)
        self.assertEqual(len(sentences), 5, sentences)

    def test_what_is_lacking_is_not_run(self):
        results = self.results(f"{SUITE}/values/derivatives/constant.json", "--against",
                               "egl-es:llvmpipe", expect=None)
        for case in results["cases"]:
            self.assertEqual(only_result(case)["verdict"], "not-run")

    def test_backends_know_the_names(self):
        run = self.command("backends", "egl-es:llvmpipe", "egl-es:softpipe")
        for driver in ("llvmpipe", "softpipe"):
            self.assertRegex(run.stdout, f"egl-es:{driver} +{driver}.*OpenGL ES 3\\.")
        # Of contexts that no device has.
        run = self.command("backends", "egl-es:device99", expect=RENDERER)
        self.assertIn("there is no EGL device 99", run.stdout)


if __name__ == "__main__":
    unittest.main()
