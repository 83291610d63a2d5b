# SPDX-License-Identifier: MIT
"""The whole suite: as expected on the four Mesa renderers, the same bytes each time and whoever
else is judged; exact agrees with itself; a new case needs no build; no disagreement is lost."""
import collections
import fractions
import itertools
import json
import math
import operator
import re
import struct
import unittest
import xml.etree.ElementTree

from results_file import cases_of, head_of, places_of
import results_file
from suite_data import (AGAINST_MESA, exact_lines, lines_of, mesa, run_share,
                        shard)
from support import (MESA, PROBES, REPORTS, UNHURRIED, CommandTest, component_bits, drawings,
                     float32, known_not_run, only_result, places, triangle_case, verdicts)

SAMPLES = re.compile(r'"samples":(\d+)')


def known_of_share(renderer):
    """id -> why one of MESA does not render a case of this share, or none."""
    return {name: known_not_run(renderer, name, int(SAMPLES.search(line)[1]))
            for name, line in exact_lines()}


class WholeSuite(CommandTest):
    def test_mesa_is_as_expected(self):
        path = mesa() / "reports.json"
        self.assertEqual(head_of(path)["diagnostics"], [])
        known = {renderer: known_of_share(renderer) for renderer in MESA}
        count = 0
        for case in cases_of(path):
            count += 1
            self.assertEqual(list(case["results"]), MESA)
            for renderer, result in case["results"].items():
                self.assertIn(result["standing"], ("expected", "known", "tolerated"), case["id"])
                reason = known[renderer][case["id"]]
                self.assertEqual(result["verdict"] == "not-run", reason is not None, case["id"])
                if reason:
                    self.assertIn(reason, result["failure"]["reason"])
        self.assertGreaterEqual(count, 50)
        for renderer in MESA:
            self.check_renderings(renderer, known[renderer])

    def check_renderings(self, renderer, known):
        """There are those of the cases that it has to render, and of the others it is told why not."""
        lines = lines_of(renderer)
        self.assertEqual(set(lines), {name for name, reason in known.items() if reason is None})
        told = (mesa() / f"{renderer}.errors").read_text(encoding="utf-8").splitlines()
        self.assertEqual(len(told), len(known) - len(lines))

    def test_one_thread_and_several_make_the_same_bytes(self):
        run_share(self.folder, 1, *AGAINST_MESA)
        several = {path.name: path for path in mesa().glob("reports.*")}
        single = {path.name: path for path in self.folder.iterdir()}
        self.assertLessEqual({f"reports.{kind}" for kind in REPORTS}, set(single))
        self.assertEqual(single.keys(), several.keys())
        for name, path in single.items():
            self.assertTrue(path.read_bytes() == several[name].read_bytes(), f"{name} differs")

    def test_causes_are_the_same_whichever_are_asked_first(self):
        """Those that the profile has are asked first; --ask-all asks all."""
        for name, words in (("first", []), ("all", ["--ask-all"])):
            self.command("run", *PROBES, *shard(), "--against", "egl:llvmpipe", *UNHURRIED, *words,
                         "--json", self.folder / f"{name}.json")
        self.assertEqual((self.folder / "first.json").read_bytes(),
                         (self.folder / "all.json").read_bytes())

    def test_each_is_judged_alone(self):
        path = self.folder / "alone.json"
        self.command("run", *PROBES, *shard(), "--against", "egl:softpipe", *UNHURRIED, "--json",
                     path)
        for one, many in itertools.zip_longest(cases_of(path), cases_of(mesa() / "reports.json")):
            alone, beside = (case["results"]["egl:softpipe"] for case in (one, many))
            # A picture that agrees is kept where another renderer's differs.
            if alone["verdict"] == "agree" and "pixels" not in alone:
                beside.pop("pixels", None)
            self.assertEqual(alone, beside)

    def test_exact_agrees_with_itself(self):
        results = self.results(*PROBES, *shard(), "--against", "exact")
        self.assertEqual(set(verdicts(results).values()), {"agree"})
        for case in results["cases"]:
            self.assertEqual(case["expect_failures"], [])
            self.assertEqual(only_result(case)["values"], [])

    def test_a_run_without_arguments(self):
        self.copy_suite("points")
        run = self.command("run", expect=None)
        self.assertIn("\nReport: out/report.html\n", run.stdout)
        results = results_file.read(self.folder / "out/results.zst")
        self.assertEqual(results["renderers"][0]["name"], "egl:llvmpipe")
        self.assertTrue((self.folder / "out/junit.xml").read_bytes().startswith(b"<?xml"))
        self.assertTrue((self.folder / "out/report.html").read_bytes().startswith(b"<!"))


class NewCase(CommandTest):
    def test_one_file_more_is_judged_by_the_next_run(self):
        self.copy_suite("triangles")
        before = self.results("cases", expect=None)
        self.write("cases/mine/common-edge.json", triangle_case(
            title="My own shared edge", draws=[
                {"primitive": "triangles", "vertices": [["2+1/2", 1], [6, 1], ["2+1/2", 6]]},
                {"primitive": "triangles", "vertices": [["2+1/2", 1], ["2+1/2", 6], [0, 1]]}],
            expect=[{"policy": "opengl", "coverage": ["........", "........", "..##....",
                                                      "..###...", ".####...", "######..",
                                                      "#####...", "........"]}]))
        arguments = [word for kind in REPORTS for word in (f"--{kind}", f"out.{kind}")]
        run = self.command("run", "cases", *arguments, expect=None)
        results = results_file.read(self.folder / "out.json")
        ids = [case["id"] for case in results["cases"]]
        self.assertEqual(set(ids) - {c["id"] for c in before["cases"]}, {"mine/common-edge"})
        mine = results["cases"][ids.index("mine/common-edge")]
        self.assertEqual(only_result(mine)["verdict"], "agree")
        # The drawing is wrong on purpose in one pixel: the author is told where.
        self.assertEqual(run.returncode, 1)
        self.assertEqual(len(mine["expect_failures"]), 1)
        self.assertIn("/expect/0", mine["expect_failures"][0])
        junit = xml.etree.ElementTree.parse(self.folder / "out.junit")
        names = [test.get("name") for test in junit.iter("testcase")]
        self.assertIn("mine/common-edge", names)
        self.assertIn("My own shared edge", (self.folder / "out.html").read_text(encoding="utf-8"))


def conversions(fragment):
    """The pixel that a fragment's float32 colour is nearest to, and its depth in each format.
    What is infinite is clamped like any number; what is no number stays none."""
    def nearest(value, largest):
        number = struct.unpack("<f", float32(value))[0]
        if math.isnan(number):
            return number
        return round(fractions.Fraction(min(max(number, 0.0), 1.0)) * largest)

    depth = fragment["depth"]
    return {"pixel": [nearest(c, 255) for c in fragment["color"]],
            "depths": [depth] + [nearest(depth, n) / n for n in (2 ** 16 - 1, 2 ** 24 - 1)]}


def detail_numbers(fragment):
    """gl_FragCoord, the derivatives and the texture lookup of a fragment, as float32 numbers, by
    what results call them; x and y of gl_FragCoord are told with z."""
    def nearest(value):
        return struct.unpack("<f", float32(value))[0]

    numbers = {}
    if "coordinates" in fragment:
        x, y, z, w = map(nearest, fragment["coordinates"])
        numbers = {"gl_FragCoord.z": (x, y, z), "gl_FragCoord.w": w}
    for name, components in fragment.get("derivatives", {}).items():
        numbers[name] = tuple(map(nearest, components))
    for name, key in (("texture coordinates", "texture_coordinates"),
                      ("level of detail", "level_of_detail")):
        if key in fragment:
            numbers[name] = tuple(map(nearest, fragment[key]))
    return numbers


def colors_by_pixel(rendering):
    """The float32 colours of each pixel's fragments, by the pixel's index."""
    colors = collections.defaultdict(tuple)
    for f in rendering["fragments"]:
        colors[f["y"] * rendering["width"] + f["x"]] += (tuple(component_bits(f)[0]),)
    return colors


# Mixtures of texels lie on the middle of two steps once they are blended: of fragments that are one
# and the same float32 number, exact rounds the number behind it, and the step may be the other one.
BLENDED_TEXELS = re.compile("output/blending/textured-over:filter=linear:")


def places_told(result):
    """The pixels of which something is told."""
    return ({tuple(d["pixel"]) for d in result["disagreements"]}
            | {place for values in result["values"] for place in places_of(values)})


class NothingIsLost(CommandTest):
    """Results against a comparison of two `render` outputs that is written here."""

    def independent_coverage(self, exact, rendered):
        """(x, y, primitive, sample, kind) of all that one covers and the other does not."""
        wanted = collections.Counter(places(exact["fragments"]))
        drawn = collections.Counter(places(rendered["fragments"]))
        found = [(*place, "missing") for place in wanted if drawn[place] == 0]
        found += [(*place, "extra") for place in drawn if wanted[place] == 0]
        found += [(*place, "duplicate") for place, n in drawn.items() if n > 1]
        return sorted(found)

    def check_coverage(self, exact, rendered, result):
        """How many disagreements there are. Those of a pass have its number instead of a sample."""
        told = collections.Counter((*d["pixel"], d["primitive"], d.get("sample", 0), d["kind"])
                                   for d in result["disagreements"] if d["kind"] != "value")
        found = collections.Counter()
        for number, pair in enumerate(zip(drawings(exact), drawings(rendered))):
            for x, y, primitive, sample, kind in self.independent_coverage(*pair):
                which = number if "passes" in exact else sample
                found[x, y, primitive, which, kind] += 1
        self.assertEqual(told, found)
        return found.total()

    def check_values(self, exact, rendered, result):
        """Every fragment with another float32 colour or depth than exact's is told; returns how
        many there are."""
        told = collections.defaultdict(set)
        for values in result["values"]:
            told[values["attribute"]] |= set(places_of(values))
        beyond = {tuple(d["pixel"]) for d in result["disagreements"] if d["kind"] == "value"}
        key = operator.itemgetter("x", "y", "primitive", "coverage")
        truth = {key(f): component_bits(f) for f in exact["fragments"]}
        own_levels = rendered.get("mip_chains") != exact.get("mip_chains")
        if own_levels:
            # Colours are looked up in the renderer's own levels, and those are told.
            told_levels = [d for d in result["disagreements"] if d["rule"].startswith("mipmap.")]
            told_levels += [v for v in result["values"] if v["rule"].startswith("mipmap.")]
            self.assertNotEqual(told_levels, [])
        details = {key(f): detail_numbers(f) for f in exact["fragments"]}
        told["gl_FragCoord.z"] |= told["gl_FragCoord.xy"]
        count = 0
        for fragment in rendered["fragments"]:
            if key(fragment) not in truth:
                continue
            place = key(fragment)[:2]
            for attribute, wanted, drawn in zip(("color", "depth"), truth[key(fragment)],
                                                component_bits(fragment)):
                if wanted != drawn and not (own_levels and attribute == "color"):
                    count += 1
                    # A textured draw's colour is looked up.
                    either = told[attribute] | told["texture " + attribute]
                    self.assertIn(place, either | beyond, attribute)
            for attribute, drawn in detail_numbers(fragment).items():
                if drawn != details[key(fragment)][attribute]:
                    count += 1
                    self.assertIn(place, told[attribute] | beyond, attribute)
        return count

    def check_pixels(self, exact, rendered, result):
        """Every pixel of another colour or depth has something that is told of it, unless it is
        what the renderer's own last fragment converts to, or where tests drop fragments, any of its
        own: check_values holds that against exact's, which may round otherwise where it lies beside
        the middle of two steps."""
        told, name = places_told(result), rendered.get("id", "")
        own = collections.defaultdict(list)
        for f in rendered["fragments"]:
            own[f["y"] * exact["width"] + f["x"]].append(conversions(f))
        if name.startswith("clipping/meshes/"):
            # What is nearest stands, and its depth with it.
            own = {index: [f for f in fragments if rendered["depths"][index] in f["depths"]]
                   for index, fragments in own.items()}
        elif not name.startswith("output/"):
            own = {index: fragments[-1:] for index, fragments in own.items()}
        same = colors_by_pixel(exact).items() & colors_by_pixel(rendered).items()
        rounded = dict(same) if BLENDED_TEXELS.match(name) else {}
        for index in range(exact["width"] * exact["height"]):
            part = slice(4 * index, 4 * index + 4)
            if exact["pixels"][part] != rendered["pixels"][part]:
                if rendered["pixels"][part] in (f["pixel"] for f in own.get(index, [])):
                    continue
                steps = map(operator.sub, exact["pixels"][part], rendered["pixels"][part])
                if index in rounded and all(abs(step) <= 1 for step in steps):
                    continue
                self.assertIn((index % exact["width"], index // exact["width"]), told)
        for index, pair in enumerate(zip(exact.get("depths", []), rendered.get("depths", []))):
            if pair[0] != pair[1] and not any(pair[1] in f["depths"] for f in own.get(index, [])):
                self.assertIn((index % exact["width"], index // exact["width"]), told)
        for index, pair in enumerate(zip(exact.get("stencils", []), rendered.get("stencils", []))):
            if pair[0] != pair[1]:
                self.assertIn((index % exact["width"], index // exact["width"]), told)

    def check_samples(self, exact, rendered, result):
        """The same of samples, which hold the colour of any of the pixel's own fragments, and of
        their mean. Each has a depth of its own, which is told where it differs."""
        told, width = places_told(result), exact["width"]
        area = width * exact["height"]
        own = collections.defaultdict(list)
        for f in rendered["fragments"]:
            own[f["y"] * width + f["x"]].append(conversions(f)["pixel"])
        for index in range(area):
            if (index % width, index // width) in told:
                continue
            planes = [range(4 * (index + s * area), 4 * (index + s * area) + 4)
                      for s in range(exact["samples"])]
            drawn, wanted = ([[of["sample_pixels"][i] for i in plane] for plane in planes]
                             for of in (rendered, exact))
            for sample, (one, other) in enumerate(zip(drawn, wanted)):
                self.assertIn(one, [other, *own[index]], (index, sample))
            mean = [round(fractions.Fraction(sum(n), len(n))) for n in zip(*drawn)]
            self.assertEqual(rendered["pixels"][4 * index:4 * index + 4], mean, index)
            for key in {"depths", "stencils"} & exact.keys():
                self.assertEqual(rendered[key][index::area], exact[key][index::area], index)

    def check_all(self, exact, rendered, result):
        """How much disagrees in coverage and in values."""
        coverage, values = self.check_coverage(exact, rendered, result), 0
        for pair in zip(drawings(exact), drawings(rendered)):
            values += self.check_values(*pair, result)
            check = self.check_samples if exact["samples"] > 1 else self.check_pixels
            check(*pair, result)
        self.check_accumulation(exact, rendered, result)
        return coverage, values

    def check_accumulation(self, exact, rendered, result):
        """Of a pixel of which nothing is told, all passes have exact's colours, to the float32
        number. The numbers behind those lie half a unit off at most, and so do their means, which
        are rounded once more: one unit of what is no larger than the largest colour."""
        told, width = places_told(result), exact["width"]
        numbers = exact.get("accumulated", [])
        largest = max([1.0, *map(abs, (n for drawn in drawings(exact) for f in drawn["fragments"]
                                       for n in f["color"]))]) if numbers else 1
        for index, wanted in enumerate(numbers):
            if (index // 4 % width, index // 4 // width) not in told:
                self.assertLessEqual(abs(rendered["accumulated"][index] - wanted),
                                     largest * 2 ** -23)

    def test_of_all_renderers(self):
        lines = {renderer: lines_of(renderer) for renderer in MESA}
        coverage = values = 0
        # Of each case: the one line of the truth, and the one of the results.
        pairs = itertools.zip_longest(exact_lines(), cases_of(mesa() / "reports.json"))
        for (name, truth), case in pairs:
            self.assertEqual(case["id"], name)
            exact, checked = json.loads(truth), []
            for renderer in MESA:
                if known_not_run(renderer, name, exact["samples"]):
                    continue
                # Two that answer the same and of which the same is told need one check.
                line, result = lines[renderer][name], case["results"][renderer]
                if (line, result) in checked:
                    continue
                checked.append((line, result))
                with self.subTest(case=name, renderer=renderer):
                    found = self.check_all(exact, json.loads(line), result)
                    coverage += found[0]
                    values += found[1]
                    if result["verdict"] == "agree":
                        self.assertEqual(found[0], 0)
        # The comparison has found something to compare.
        self.assertGreater(coverage, 100)
        self.assertGreater(values, 20)


if __name__ == "__main__":
    unittest.main()
