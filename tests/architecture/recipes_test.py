# SPDX-License-Identifier: MIT
"""The recipes of CONTRIBUTING.md are enough: what each says is planted in a copy of the tree, in the
files that it names and in no other, and the copy is built and asked.

An alternative of a rule must be listed and be what a policy chooses; a rule too, and stand in the
rule book; a key of case files, be it of a draw, of its fragment operations, or of its texture, must
be read, written, told by the schema and in words, go to renderers as a line and as bytes, and be
refused by the one that does not draw it yet.
"""
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(os.environ["EDGECASE_ROOT"])
FOLDERS = ("cases", "reference", "reports", "src", "tools")
CONTRIBUTING = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")


def behind(text, more):
    return text, text + more


def before(text, more):
    return text, more + text


# Of each recipe: a file of the product, and the text of a new one, or what is put beside which text.
ALTERNATIVE = {
    "src/rules/textures/texture_image.h": [
        before("  mirrored_as_repeat,  //", "  border_as_edge,\n"),
        before('     {WrapChoice::mirrored_as_repeat, "mirrored-as-repeat"',
               '     {WrapChoice::border_as_edge, "border-as-edge", Openness::illegal,\n'
               '      "the edge texels stand where the border should"},\n')],
    "src/rules/textures/texture_image.cpp": [
        behind("Wrap effective(Wrap wrap, WrapChoice choice) {\n",
               "  if (choice == WrapChoice::border_as_edge && wrap == Wrap::clamp_to_border)\n"
               "    return Wrap::clamp_to_edge;\n")],
}

RULE = {
    "src/rules/output/dithering.h": """// SPDX-License-Identifier: MIT
//
// A colour that lies between two codes may become either.
#pragma once

#include "rules/rule.h"

namespace edgecase {

Rule dithering_rule();  // framebuffer.dithering

enum class Dithering { off, ordered };
template <>
inline constexpr auto kNames<Dithering> = std::to_array<TabledAlternative<Dithering>>(
    {{Dithering::off, "off", Openness::mandated, "the nearest code"},
     {Dithering::ordered, "ordered", Openness::illegal, "either, by the pixel's place"}});

}  // namespace edgecase
""",
    "src/rules/output/dithering.cpp": """// SPDX-License-Identifier: MIT
#include "rules/output/dithering.h"

namespace edgecase {

Rule dithering_rule() {
  return {RuleId::framebuffer_dithering,
          "A colour between two codes becomes the nearest one",
          "17.3.9 (dithering)",
          "none",
          "off",
          alternatives_of<Dithering>(),
          {}};
}

}  // namespace edgecase
""",
    "src/model/rule_id.h": [
        behind("  blend_rounding,\n", "  framebuffer_dithering,\n"),
        behind('     {RuleId::blend_rounding, "blend.rounding"},\n',
               '     {RuleId::framebuffer_dithering, "framebuffer.dithering"},\n')],
    "src/rules/choices.h": [
        behind('#include "rules/output/fragment_tests.h"\n', '#include "rules/output/dithering.h"\n'),
        behind("  DepthTestMethod depth = DepthTestMethod::as_set;\n",
               "  Dithering dithering = Dithering::off;\n")],
    "src/rules/catalogue.cpp": [
        before("      unorm8_rule(),\n",
               "      with(dithering_rule(), of_output<&O::dithering>()),\n")],
    "src/rules/CMakeLists.txt": [behind("output/polygon_offset.cpp", " output/dithering.cpp")],
    "src/rules/chapters.cpp": [
        before('        {"Pixels", "values/framebuffer"',
               '        {"Dithering", "output/dithering", {RuleId::framebuffer_dithering}},\n')],
}

KEY_OF_DRAWS = {
    "src/model/scene.h": [
        before("  std::vector<Vertex> vertices;", "  bool dithers = false;\n")],
    "src/model/scene_fields.h": [
        before('field("line_width", &Draw::line_width',
               'field("dithers", &Draw::dithers).left_out().about("Dithering", "Is it on?"),\n')],
}

KEY_OF_OPERATIONS = {
    "src/model/fragment_operations.h": [
        before("  std::array<bool, 4> color_mask", "  std::uint8_t logic_op = 3;\n")],
    "src/model/scene_fields.h": [
        before('field("color_mask", &FragmentOperations::color_mask',
               'field("logic_op", &FragmentOperations::logic_op, kByte).left_out()\n'
               '.told("logic {}").about("Logic", "Which one, {low} to {high}."),\n')],
}

KEY_OF_TEXTURES = {
    "src/model/texture.h": [
        before("  std::array<Wrap, 2> wrap", "  bool seamless = false;\n")],
    "src/model/scene_fields.h": [
        before('field("lod_bias", &Sampler::lod_bias',
               'field("seamless", &Sampler::seamless).left_out().about("Seams", "Are there none?"),'
               '\n')],
}

KEYS = (KEY_OF_DRAWS, KEY_OF_OPERATIONS, KEY_OF_TEXTURES)

# How many files of the product, those beside a rule's own; what draws a key is not planted.
AIMS = [(ALTERNATIVE, 3), (RULE, 5), *((key, 2) for key in KEYS)]

STATE = {"dithers": True, "logic_op": 6, "texture": 0, "sampler": {"seamless": True}}
CASE = {"title": "planted", "rules": ["window.origin"], "target": {"width": 4, "height": 4},
        "textures": [{"size": [2, 2], "checker": {}}],
        "draws": [{"primitive": "points", "vertices": [{"at": [1, 1], "uv": [0, 0]}],
                   "state": STATE}]}
POLICY = {"name": "planted", "latitude": "none",
          "rules": {"texture.wrap": "border-as-edge", "framebuffer.dithering": "ordered"}}


def plant(tree, recipe):
    for name, change in recipe.items():
        path = tree / name
        if isinstance(change, str):
            path.write_text(change, encoding="utf-8")
            continue
        text = path.read_text(encoding="utf-8")
        for old, new in change:
            assert text.count(old) == 1, f"{name} has not once: {old}"
            text = text.replace(old, new)
        path.write_text(text, encoding="utf-8")


def built(tree, build):
    """The program that tells what a tree knows."""
    with (tree / "CMakeLists.txt").open("a", encoding="utf-8") as lists:
        lists.write(f"""
add_executable(recipes_probe {ROOT}/tests/architecture/recipes_probe.cpp)
target_sources(recipes_probe PRIVATE reference/drawn_keys.cpp)
target_include_directories(recipes_probe PRIVATE {tree})
target_link_libraries(recipes_probe edgecase_rules edgecase_casefile edgecase_wire fmt::fmt)
""")
    for command in (["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                     "-DCMAKE_CXX_FLAGS=-O0 -g0", "-DEDGECASE_INSTALL=OFF"],
                    ["cmake", "--build", build, "--target", "recipes_probe"]):
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stdout[-4000:] + run.stderr[-4000:]
    return build / "bin" / "recipes_probe"


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            tree = Path(folder, "tree")
            for name in FOLDERS:
                shutil.copytree(ROOT / name, tree / name)
            shutil.copy(ROOT / "CMakeLists.txt", tree)
            for recipe in (ALTERNATIVE, RULE, *KEYS):
                plant(tree, recipe)
            Path(folder, "policy.json").write_text(json.dumps(POLICY), encoding="utf-8")
            Path(folder, "case.json").write_text(json.dumps(CASE), encoding="utf-8")
            run = subprocess.run([built(tree, Path(folder, "build")), "policy.json", "case.json"],
                                 cwd=folder, capture_output=True, text=True, check=True)
        cls.told = run.stdout
        cls.lines = run.stdout.splitlines()

    def line_after(self, start):
        found = [line.removeprefix(start) for line in self.lines if line.startswith(start)]
        self.assertEqual(len(found), 1, start)
        return found[0]

    def test_nothing_is_refused(self):
        self.assertEqual([line for line in self.lines if line.startswith("fault: ")], [])

    def test_an_alternative_is_listed_and_chosen(self):
        self.assertIn("alternative: texture.wrap=border-as-edge", self.lines)
        self.assertIn("kept: texture.wrap=border-as-edge", self.lines)

    def test_a_rule_is_listed_chosen_and_in_the_book(self):
        self.assertIn("alternative: framebuffer.dithering=ordered", self.lines)
        self.assertIn("kept: framebuffer.dithering=ordered", self.lines)
        self.assertIn("chapter: framebuffer.dithering", self.lines)

    def test_a_key_is_read_written_and_sent(self):
        scene = self.line_after("scene: ")
        self.assertEqual(self.line_after("from a line: "), scene)
        self.assertEqual(self.line_after("from bytes: "), scene)
        for key, value in (("dithers", "true"), ("logic_op", "6"), ("seamless", "true")):
            self.assertIn(f'"{key}":{value}', scene)
            self.assertIn(f'"{key}": {value}', self.told)
        self.assertRegex(self.told, r'"title": "Dithering",\s*"description": "Is it on\?"')
        self.assertRegex(self.told, r'"title": "Seams",\s*"description": "Are there none\?"')
        self.assertRegex(self.told, r'"description": "Which one, 0 to 255\.",\s*"type": "integer"')

    def test_a_key_is_told_and_refused_by_who_does_not_draw_it(self):
        words = self.line_after("words: ")
        self.assertIn(", dithers on", words)
        self.assertIn(", logic 6", words)
        self.assertIn(self.line_after("not drawn: "), ("dithers", "logic_op", "seamless"))

    def test_the_recipes_name_each_file(self):
        for recipe, most in AIMS:
            beside = [name for name, change in recipe.items() if isinstance(change, list)]
            self.assertLessEqual(len(beside), most)
            for name in beside:
                self.assertTrue(name in CONTRIBUTING or recipe is ALTERNATIVE, name)


if __name__ == "__main__":
    unittest.main()
