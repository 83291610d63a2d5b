# SPDX-License-Identifier: MIT
"""OpenGL ES against OpenGL on the same driver, over a share of the suite: every case that both draw
has the same answer, fragment for fragment, but for points at the viewport's sides, and every case
that OpenGL ES does not draw says what it lacks."""
import json
import re
import subprocess
import unittest

from suite_data import shard
from support import NOTHING_DRAWN, RENDERER, SUITE, UNHURRIED, CommandTest, only_result

# Files in which each thing that OpenGL ES lacks is asked for, and most of what it has.
SHARE = [f"{SUITE}/{name}.json" for name in (
    "points/centres", "points/outside", "lines/short/between-diamonds", "clipping/points/border",
    "clipping/points/beside",
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
            if name.startswith("clipping/points/"):
                continue
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
        self.assertEqual(len(sentences), 5, sentences)

    def test_softpipe_answers_as_through_opengl(self):
        # Without samples, it has none to switch off.
        alike, sentences = self.compare("softpipe")
        self.assertGreater(alike, 80)
        self.assertEqual(len(sentences), 4, sentences)

    def test_nothing_in_the_suite_is_unexpected(self):
        """By the rulings of OpenGL ES, whose sizes of points are exact, for instance."""
        self.results(SUITE, *shard(), *UNHURRIED, "--against", "egl-es:llvmpipe", "--against",
                     "egl-es:softpipe")
        self.assertRegex(self.summary, r"(?m)^[\d,]+ cases, 2 renderers: 0 unexpected")

    def test_what_is_lacking_is_not_run(self):
        results = self.results(f"{SUITE}/values/derivatives/constant.json", "--against",
                               "egl-es:llvmpipe", expect=NOTHING_DRAWN)
        for case in results["cases"]:
            self.assertEqual(only_result(case)["verdict"], "not-run")

    def test_backends_know_the_names(self):
        run = self.command("backends", "egl-es:llvmpipe", "egl-es:softpipe")
        for driver in ("llvmpipe", "softpipe"):
            self.assertRegex(run.stdout, f"egl-es:{driver} +{driver}.*OpenGL ES 3\\.")
    def test_a_library_and_a_device_by_name_are_the_same_driver(self):
        """Mesa's own library, by its file, and its only device, by a part of its description."""
        found = subprocess.run(["ldconfig", "-p"], check=True, capture_output=True, text=True,
                               env={"PATH": "/usr/sbin:/sbin:/usr/bin:/bin"}).stdout
        library = re.search(r"libEGL\.so\.1 .*=> (\S+)", found)[1]
        case = f"{SUITE}/points/centres.json"
        for api in ("egl", "egl-es"):
            for address in (f"lib={library}", "device=mesa_device_Software"):
                with self.subTest(f"{api}:{address}"):
                    results = self.results(case, "--against", f"{api}:{address}", "--against",
                                           f"{api}:llvmpipe", expect=None,
                                           LIBGL_ALWAYS_SOFTWARE="1", GALLIUM_DRIVER="llvmpipe")
                    own, named = results["renderers"]
                    self.assertEqual(own["device"], named["device"])
                    for one in results["cases"]:
                        verdicts = {told["verdict"] for told in one["results"].values()}
                        self.assertEqual(len(verdicts), 1, one)

    def test_what_is_not_there_is_said_with_what_is(self):
        for address, words in (
                ("egl:lib=/nowhere/libEGL.so", "EGL cannot be opened: /nowhere/libEGL.so"),
                ("egl:lib=/usr/lib", "EGL cannot be opened: /usr/lib/libEGL.so"),
                ("egl:device=voodoo", 'no EGL devices have "voodoo" in what EGL says of them: 0 (')):
            with self.subTest(address):
                run = self.command("backends", address, expect=None)
                self.assertIn(words, run.stdout)

    def test_of_contexts_that_no_device_has(self):
        run = self.command("backends", "egl-es:device99", expect=RENDERER)
        self.assertIn("there is no EGL device 99", run.stdout)


if __name__ == "__main__":
    unittest.main()
