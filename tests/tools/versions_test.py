# SPDX-License-Identifier: MIT
"""Contexts without storage blocks against those that have them, on the same driver and over a share
of the suite: what both draw has the same answer, fragment for fragment, and what the older version
does not draw says what it lacks.

Versions are Mesa's overrides, and reach the worker as a device is asked in the user's environment.
"""
import re
import tempfile
import unittest

from suite_data import ID, files_of_share
from support import RENDERER, SUITE, CommandTest, mesa_release, only_result

REFUSAL = re.compile(r"edgecase: (.+): unsupported: (.+)")
# Files of each kind of pass: windows, operations, details, textures, samples, passes.
ALWAYS = [f"{SUITE}/{name}.json" for name in (
    "points/centres", "surfaces/snapping", "output/depth/at-each-sample",
    "output/stencil/before-depth", "values/derivatives/constant", "samples/alpha/for-each-sample",
    "textures/lookups/gradients-of-one-dimension", "textures/level-of-detail/halfway")]
OPENGL = {"LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_DRIVER": "llvmpipe"}
LACKS_STORAGE = "GL_ARB_shader_storage_buffer_object"
NO_SAMPLES = "OpenGL ES 3.0 has no multisampled textures, of which samples are read"
# Mesa 25.0 reads 0 from stencil buffers beside 32-bit depths in OpenGL ES 3.0.
NO_STENCIL = "this driver makes another framebuffer: its stencil buffer, cleared to 165, holds 0"
IS_OLDEST = mesa_release() == "22.3.6"


def version(number):
    return {"MESA_GL_VERSION_OVERRIDE": number,
            "MESA_GLSL_VERSION_OVERRIDE": number.replace(".", "") + "0"}


class OfVersions(CommandTest):
    """With caches of their own: Mesa 25.0 crashes where one has another version's programs."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        folder = tempfile.TemporaryDirectory(prefix="edgecase-versions-")
        cls.addClassCleanup(folder.cleanup)
        cls.caches = folder.name

    def command(self, *arguments, **options):
        overrides = [str(value) for name, value in sorted(options.items()) if "OVERRIDE" in name]
        if overrides:
            options["MESA_SHADER_CACHE_DIR"] = "-".join([f"{self.caches}/cache", *overrides])
        return super().command(*arguments, **options)


class Versions(OfVersions):
    def rendered(self, renderer, **variables):
        """id -> rendering, a line of JSON, and id -> why there is none."""
        run = self.command("render", *sorted({*ALWAYS, *map(str, files_of_share())}), "--exclude",
                           "scenes/*", "--with", renderer, "--timeout", "120", "--json", "-",
                           expect=None, **{**OPENGL, **variables})
        self.assertIn(run.returncode, (0, RENDERER), run.stderr)
        refusals = dict(match.groups() for match in map(REFUSAL.fullmatch, run.stderr.splitlines())
                        if match)
        return {ID.match(line)[1]: line for line in run.stdout.splitlines()}, refusals

    def compare(self, renderer, new_reasons, *olds):
        """The least share that an old version draws of what the new one draws."""
        whole, refused = self.rendered(renderer)
        shares = []
        for old in olds:
            drawn, lacking = self.rendered(renderer, **old)
            different = [name for name, line in drawn.items() if line != whole.get(name)]
            self.assertEqual(different, [])
            for name in set(lacking) - set(refused):
                self.assertRegex(lacking[name], new_reasons)
            self.assertEqual(set(whole) - set(drawn), set(lacking) & set(whole))
            shares.append(len(drawn) / len(whole))
        return min(shares)

    def test_opengl_3_3_and_4_2_draw_as_the_newest(self):
        self.assertGreater(self.compare("egl:device0", LACKS_STORAGE, version("3.3"),
                                        version("4.2")), 0.95)

    def test_opengl_es_3_0_draws_as_the_newest(self):
        share = self.compare("egl-es:device0", NO_SAMPLES if IS_OLDEST else f"{NO_SAMPLES}|{NO_STENCIL}",
                             {"MESA_GLES_VERSION_OVERRIDE": "3.0"})
        self.assertGreater(share, 0.6)


class WhatOldVersionsShow(OfVersions):
    def results_of(self, case, renderer="egl:device0", **variables):
        return self.results(f"{SUITE}/{case}.json", "--against", renderer, expect=None,
                            **{**OPENGL, **variables})

    def test_a_violation_is_convicted_alike(self):
        """One of coverage, by rule, kind and pixel."""
        told = []
        for variables in ({}, version("3.3")):
            results = self.results_of("triangles/single/legs-of-thousands-of-pixels", **variables)
            told.append(only_result(results["cases"][0]))
            self.assertEqual(told[-1]["verdict"], "violation")
            self.assertTrue(any(d["rule"] == "triangle.fill-rule" and d["kind"] == "missing"
                                for d in told[-1]["disagreements"]))
        self.assertEqual(*(one["fingerprint"] for one in told))

    def test_a_window_is_set_up_alike_in_all_passes(self):
        """llvmpipe snaps vertices there by the inputs of the fragment shader: where the passes had
        different ones, a hit was without its fragment."""
        told = []
        for variables in ({}, version("3.3")):
            results = self.results_of("surfaces/snapping", **variables)
            told.append({case["id"]: (only_result(case)["verdict"], only_result(case)["fingerprint"])
                         for case in results["cases"] if "surface=window" in case["id"]})
            self.assertNotIn("not-run", {verdict for verdict, _ in told[-1].values()})
        self.assertGreater(len(told[0]), 5)
        self.assertEqual(*told)

    def test_backends_say_which_capture(self):
        for capture, variables in (("ssbo", {}), ("words", version("3.3"))):
            run = self.command("backends", "egl:device0", **{**OPENGL, **variables})
            self.assertRegex(run.stdout, rf"yes \+ hits, {capture} ")

    def test_a_missing_extension_is_named(self):
        lacking = "-GL_ARB_gpu_shader5 -GL_ARB_texture_query_lod -GL_ARB_derivative_control"
        for case, extension in (("samples/patterns/left-edge", "GL_ARB_gpu_shader5"),
                                ("textures/level-of-detail/halfway", "GL_ARB_texture_query_lod"),
                                ("values/derivatives/constant", "GL_ARB_derivative_control")):
            with self.subTest(case):
                results = self.results_of(case, MESA_EXTENSION_OVERRIDE=lacking, **version("3.3"))
                reasons = {only_result(one)["failure"]["reason"] for one in results["cases"]
                           if "failure" in only_result(one)}
                self.assertTrue(any(f"it lacks {extension}" in reason for reason in reasons), reasons)


if __name__ == "__main__":
    unittest.main()
