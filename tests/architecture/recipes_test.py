# SPDX-License-Identifier: MIT
"""The recipes of CONTRIBUTING.md are enough: what each says is planted in a copy of the tree, in the
files that it names and in no other, and the copy is built and asked.

An alternative of a rule must be listed and be what a policy chooses; a rule too, and stand in the
rule book; a key of case files, be it of a draw, of its fragment operations, or of its texture, must
be read, written, told by the schema and in words, go to renderers as a line and as bytes, and be
refused by the one that does not draw it yet. What a fragment tells must be told by exact, and be
read from an answer of either form; a verdict must be given, counted and shown; a column of the CSV
stand in its header; a subcommand run, and have its help.
"""
import json
import os
import re
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

OUTPUT = {
    "src/model/rendering.h": [
        before("  // Of the colour's four components. For a textured draw",
               "  // gl_SamplePosition, within the pixel.\n"
               "  std::optional<std::array<double, 2>> sample_position;\n")],
    "src/model/rendering_fields.h": [
        before('    detail_field("derivatives", &FragmentDetail::derivatives',
               '    detail_field("sample_position", &FragmentDetail::sample_position,\n'
               '                 &Details::coordinates),\n')],
    "src/raster/attributes.cpp": [
        before("  if (asked.texture && lookup) {\n",
               "  if (asked.coordinates) detail.sample_position = {0.5, 0.5};\n")],
    "reference/capture.cpp": [
        behind("  float derivatives[kDerivatives][4];\n", "  float sample_position[4];\n"),
        ("static_assert(sizeof(DetailedRecord) == 144);",
         "static_assert(sizeof(DetailedRecord) == 160);"),
        ("static_assert(sizeof(TexturedRecord) == 160);",
         "static_assert(sizeof(TexturedRecord) == 176);"),
        behind("  detail.coordinates = to_doubles(record.coordinates);\n",
               "  const auto position = to_doubles(record.sample_position);\n"
               "  detail.sample_position = {position[0], position[1]};\n"),
        behind("  pass(sizeof(DetailedRecord::derivatives), asked.derivatives);\n",
               "  pass(sizeof(DetailedRecord::sample_position), asked.coordinates);\n")],
    "reference/shaders.h": [
        behind("  vec4 dy_coarse;\n", "  vec4 sample_position;\n"),
        behind("    records[slot].dy_coarse = dy_coarse;\n",
               "    records[slot].sample_position = vec4(gl_SamplePosition, 0.0, 0.0);\n"),
        ("uint words[39];", "uint words[43];"),
        behind("  put(30, dy_coarse);\n", "  put(34, vec4(gl_SamplePosition, 0.0, 0.0));\n"),
        ("  put(34, vec4(texture_coordinates,", "  put(38, vec4(texture_coordinates,"),
        ("  words[38] = uint(gl_SampleMaskIn[0]);", "  words[42] = uint(gl_SampleMaskIn[0]);")],
    "src/diff/values/fragment_values.cpp": [
        before("// gl_FragCoord.xy elsewhere in the pixel than exact has it.\n",
               """// gl_SamplePosition on a target of one sample.
void compare_sample_position(const ValueContext& context, const Fragment& f,
                             const FragmentDetail& detail, Result& result) {
  const std::array<double, 2> exact{0.5, 0.5};
  const auto& rendered = detail.sample_position;
  if (context.scene.target.samples > 1 || !rendered || *rendered == exact) return;
  Disagreement d = value_disagreement({f.x, f.y}, f.primitive, RuleId::fragment_coordinates);
  d.exact = {exact[0], exact[1]};
  d.rendered = {(*rendered)[0], (*rendered)[1]};
  add_disagreement(result, std::move(d));
}

"""),
        before("    if (!detail.coordinates) continue;\n",
               "    compare_sample_position(context, f, detail, result);\n")],
    "reference/PROTOCOL.md": [
        before('| `derivatives` | `"derivatives"` |',
               '| `sample_position` | `"coordinates"` | gl_SamplePosition, two numbers |\n')],
}

VERDICT = {
    "src/model/verdict.h": [
        before("violation, not_run };", "deviation, "),
        before('{Verdict::violation, "violation"},', '{Verdict::deviation, "deviation"},\n'),
        before("  if (latitude == Latitude::none || legality == Legality::illegal)",
               "  if (latitude == Latitude::none && legality == Legality::legal)\n"
               "    return Verdict::deviation;\n")],
    "src/results/results_json.h": [behind("constexpr int kResultsFormat = ", "1 + ")],
    "reports/verdict_looks.h": [
        before("    {.verdict = Verdict::contested,\n",
               """    {.verdict = Verdict::deviation,
     .meaning = "All is allowed, and is not what the policy draws.",
     .icon = "M3.5 8h9",
     .sign = "2260",
     .ink = {"#b3123c", "#ff7b98"},
     .ground = {"#b3123c", "#d42a57"},
     .heat = {"#d8123f", "#ff3b64"},
     .terminal = fmt::fg(fmt::terminal_color::red)},
""")],
}

COLUMN = {
    "reports/disagreements_csv.cpp": [
        behind('    {"file", [](const Row& row) { return row.file; }},\n',
               '    {"open", [](const Row& row) {\n'
               '       return std::string(is_open_choice(row.d.cause) ? "yes" : "no");\n'
               '     }},\n')],
    "reports/disagreements_csv.h": [
        behind("//   file         path of the case file, as given\n",
               "//   open         yes: the specification leaves the cause open; no\n")],
}

COMMAND = {
    "tools/edgecase/commands/answer.cpp": """// SPDX-License-Identifier: MIT
//
// edgecase answer: a number.
#include <fmt/format.h>

#include "tools/edgecase/commands/commands.h"

namespace edgecase {

void add_answer_command(CLI::App& app, ExitCode& exit) {
  CLI::App* command = app.add_subcommand("answer", "Print a number");
  command->callback([&exit] {
    fmt::print("42\\n");
    exit = ExitCode::as_expected;
  });
}

}  // namespace edgecase
""",
    "tools/edgecase/commands/commands.h": [
        before("void add_manual_command(",
               "void add_answer_command(CLI::App& app, ExitCode& exit);\n")],
    "tools/edgecase/main.cpp": [
        before("  edgecase::add_manual_command(app, exit);",
               "  edgecase::add_answer_command(app, exit);\n")],
    "tools/edgecase/help/help_pages.cpp": [
        before('    {"manual", kMaintain,\n',
               '    {"answer", kMaintain, "It is the same number each time.", "0", nullptr,\n'
               '     "edgecase answer"},\n')],
    "tools/CMakeLists.txt": [
        before("edgecase/commands/backends.cpp", "edgecase/commands/answer.cpp ")],
}

KEYS = (KEY_OF_DRAWS, KEY_OF_OPERATIONS, KEY_OF_TEXTURES)

# How many files of the product, those beside a rule's own; what draws a key is not planted.
AIMS = [(ALTERNATIVE, 3), (RULE, 5), *((key, 2) for key in KEYS), (OUTPUT, 7), (VERDICT, 3),
        (COLUMN, 2), (COMMAND, 4)]

STATE = {"dithers": True, "logic_op": 6, "texture": 0, "sampler": {"seamless": True}}
CASE = {"title": "planted", "rules": ["window.origin"], "target": {"width": 4, "height": 4},
        "details": ["coordinates"], "textures": [{"size": [2, 2], "checker": {}}],
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


# The program with the planted subcommand; of the others it has the names, and of the libraries
# nothing. Its own list of sources says where the planted one is.
COMMAND_TARGET = """
get_target_property(sources edgecase SOURCES)
list(FILTER sources INCLUDE REGEX "/commands/answer\\\\.cpp$")
list(TRANSFORM sources PREPEND ${PROJECT_SOURCE_DIR}/tools/)
add_executable(recipes_command stubs.cpp tools/edgecase/main.cpp ${sources}
  tools/edgecase/help/help_pages.cpp tools/edgecase/help/wrapped_formatter.cpp)
target_compile_definitions(recipes_command PRIVATE EDGECASE_VERSION="0")
target_include_directories(recipes_command PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(recipes_command PRIVATE edgecase_options CLI11::CLI11 fmt::fmt)
"""
STUBS = """#include "tools/edgecase/commands/commands.h"
#include "tools/edgecase/program.h"

namespace edgecase {

bool begin_program() { return true; }

ExitCode run_program(CLI::App& app, int count, char** arguments,
                     const std::function<ExitCode()>& run) {
  try {
    app.parse(count, arguments);
    return run();
  } catch (const CLI::ParseError& error) {
    return static_cast<ExitCode>(app.exit(error));
  }
}
"""
# What is planted in sources that are compiled, and not asked: they would take many more to link.
COMPILED_TARGET = """
add_library(recipes_compiled OBJECT reference/capture.cpp src/diff/values/fragment_values.cpp)
target_include_directories(recipes_compiled PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(recipes_compiled PRIVATE edgecase_options edgecase_glad fmt::fmt)
"""
TARGETS = ("recipes_probe", "recipes_command", "recipes_compiled", "reports/page.cpp")


def stubs(tree):
    declared = re.findall(r"void add_(\w+)_command\(",
                          (tree / "tools/edgecase/commands/commands.h").read_text(encoding="utf-8"))
    assert len(declared) > 20, declared
    return STUBS + "".join(
        f'void add_{name}_command(CLI::App& app, ExitCode&) {{ app.add_subcommand("{name}"); }}\n'
        for name in declared if name != "answer") + "}  // namespace edgecase\n"


def built(tree, build):
    """The folder of the programs that tell what a tree knows."""
    (tree / "stubs.cpp").write_text(stubs(tree), encoding="utf-8")
    with (tree / "CMakeLists.txt").open("a", encoding="utf-8") as lists:
        lists.write(f"include({ROOT}/tests/architecture/recipes_probe.cmake)\n"
                    f"{COMMAND_TARGET}{COMPILED_TARGET}")
    for command in (["cmake", "-S", tree, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug",
                     "-DCMAKE_CXX_FLAGS=-O0 -g0", "-DEDGECASE_INSTALL=OFF"],
                    ["cmake", "--build", build, "--target", *TARGETS]):
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stdout[-4000:] + run.stderr[-4000:]
    return build / "bin"


class Recipes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            tree = Path(folder, "tree")
            for name in FOLDERS:
                shutil.copytree(ROOT / name, tree / name)
            shutil.copy(ROOT / "CMakeLists.txt", tree)
            for recipe, _ in AIMS:
                plant(tree, recipe)
            Path(folder, "policy.json").write_text(json.dumps(POLICY), encoding="utf-8")
            Path(folder, "case.json").write_text(json.dumps(CASE), encoding="utf-8")
            programs = built(tree, Path(folder, "build"))

            def told_by(*command):
                return subprocess.run([programs / command[0], *command[1:]], cwd=folder,
                                      capture_output=True, text=True, check=True).stdout
            cls.told = told_by("recipes_probe", "policy.json", "case.json")
            cls.help = told_by("recipes_command", "--help")
            cls.help_of_answer = told_by("recipes_command", "answer", "--help")
            cls.answer = told_by("recipes_command", "answer")
            cls.page = Path(folder, "build/reports/page.cpp").read_text(encoding="utf-8")
        cls.lines = cls.told.splitlines()

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

    def test_what_a_fragment_tells_is_told_and_read(self):
        answer = self.line_after("answer: ")
        self.assertIn('"sample_position":[0.5,0.5]', answer)
        for way in ("a line", "bytes"):
            self.assertEqual(self.line_after(f"answer from {way}: "), answer)

    def test_a_verdict_is_given_counted_and_shown(self):
        self.assertEqual(self.line_after("verdict on legal, latitude none: "), "deviation")
        self.assertEqual(self.line_after("verdict on legal, latitude opengl: "), "permitted")
        self.assertEqual(self.line_after("verdict: deviation: "),
                         "All is allowed, and is not what the policy draws.")
        self.assertIn("deviation", json.loads(self.line_after("pixel counts: ")))
        # The page is written as the numbers of its bytes.
        style = ",".join(str(byte) for byte in b"--deviation: #b3123c;")
        self.assertIn(style, re.sub(r"\s", "", self.page))

    def test_a_column_stands_in_header_and_rows(self):
        header, row = (line.split(",") for line in self.lines[-2:])
        self.assertEqual((header[0], header[-1], row[-1]), ("case", "open", "no"))
        self.assertEqual(len(row), len(header))

    def test_a_command_runs_and_has_its_help(self):
        self.assertEqual(self.answer, "42\n")
        self.assertRegex(self.help, r"\nMaintain:\n(  .*\n)*  answer +Print a number\n")
        for told in ("It is the same number each time.", "Exit codes: 0 as expected.",
                     "Examples:\n  edgecase answer"):
            self.assertIn(told, self.help_of_answer)

    def test_the_recipes_name_each_file(self):
        for recipe, most in AIMS:
            beside = [name for name, change in recipe.items() if isinstance(change, list)]
            self.assertLessEqual(len(beside), most)
            for name in beside:
                self.assertTrue(name in CONTRIBUTING or recipe is ALTERNATIVE, name)


if __name__ == "__main__":
    unittest.main()
