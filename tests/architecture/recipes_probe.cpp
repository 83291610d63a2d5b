// SPDX-License-Identifier: MIT
//
// What a tree knows, for recipes_test.py, which plants something in a copy of it: the rules and
// their alternatives, what a policy resolves to, a case on all of its ways, what its fragments
// tell, the verdicts, and the columns of the CSV.
//
//     recipes_probe POLICY CASE
#include <fmt/format.h>

#include <iostream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// Sources, since they keep to themselves what is asked here, and since the libraries of results and
// reports would take minutes to build. The linker drops what is not called.
#include "reports/disagreements_csv.cpp"
#include "results/case_results_writer.cpp"

#include "casefile/case_reader.h"
#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "casefile/policy_reader.h"
#include "raster/attributes.h"
#include "reference/drawn_keys.h"
#include "reports/verdict_looks.h"
#include "rules/all_rules.h"
#include "rules/chapters.h"
#include "rules/choices.h"
#include "wire/answer_line.h"
#include "wire/message.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

void print_faults(const std::vector<Diagnostic>& faults) {
  for (const Diagnostic& fault : faults) fmt::print("fault: {}\n", to_string(fault));
}

void print_rules() {
  for (const KnownRule& rule : known_rules())
    for (const std::string& alternative : rule.alternatives)
      fmt::print("alternative: {}={}\n", rule.id, alternative);
  for (const Chapter& chapter : chapters())
    for (const Section& section : chapter.sections)
      for (const RuleId rule : section.rules) fmt::print("chapter: {}\n", name_of(rule));
}

void print_policy(const char* file) {
  const LoadedPolicy policy = load_policy(file, known_rules());
  print_faults(policy.diagnostics);
  if (!policy.value) return;
  const RuleChoices choices = resolve(*policy.value, Surface::fbo);
  for (const Rule& rule : all_rules())
    if (rule.slot.kept != nullptr)
      fmt::print("kept: {}={}\n", name_of(rule.id), rule.slot.kept(choices));
}

void print_case(const char* file) {
  const LoadedCases loaded = load_cases(file, "planted");
  print_faults(loaded.diagnostics);
  if (loaded.cases.empty()) return;
  const Scene& scene = loaded.cases.front().scene;
  fmt::print("scene: {}\nwords: {}\nnot drawn: {}\n", scene_json(scene), scene_text(scene),
             key_not_drawn(scene));
  const auto line = parse_request(request_line("planted", scene_json(scene)));
  if (const auto* request = std::get_if<Request>(&line))
    fmt::print("from a line: {}\n", scene_json(request->scene));
  const auto bytes = parse_request_message(request_message("planted", scene, false).bytes);
  if (const auto* request = std::get_if<IncomingRequest>(&bytes))
    fmt::print("from bytes: {}\n", scene_json(request->scene));
  const CaseText text = case_text(scene, {"", "planted", "", {"window.origin"}, "", "", {}});
  print_faults(text.diagnostics);
  fmt::print("{}{}", text.text, case_schema());
}

// What exact tells of the first fragment of the case's first primitive, as a line, as bytes, and
// with everything that was read from either.
void print_fragment(const char* file) {
  const LoadedCases loaded = load_cases(file, "planted");
  if (loaded.cases.empty()) return;
  const Scene& scene = loaded.cases.front().scene;
  const ScenePrimitive primitive = primitives_of(scene).front();
  const RuleChoices choices;
  const PrimitiveAttributes attributes = attributes_of(primitive, choices, scene.target);
  CentreColors colors(scene.target.width);
  colors.take(attributes.color);
  const QuadPixel at = quad_of({0, 0}, choices.values, scene.target);
  Rendering rendering;
  rendering.width = scene.target.width;
  rendering.height = scene.target.height;
  rendering.pixels.resize(4 * rendering.pixel_index(0, rendering.height));
  rendering.fragments.emplace_back().detail = 0;
  rendering.details = {
      shade_details(attributes, colors, at, choices.values, {.coordinates = true})};
  const std::string line = answer_line("planted", rendering, nullptr);
  fmt::print("answer: {}\n", line);
  const auto print_again = [&](const char* way, const auto& read) {
    if (const auto* answer = std::get_if<Answer>(&read))
      fmt::print("answer from {}: {}\n", way,
                 answer_line("planted", std::get<Rendering>(answer->outcome), nullptr));
  };
  print_again("a line", parse_answer(line, "planted", scene));
  print_again("bytes",
              parse_answer_message(answer_message(1, rendering, false, nullptr), 1, scene, false));
}

void print_verdicts() {
  for (const VerdictLook& look : kVerdictLooks)
    fmt::print("verdict: {}: {}\n", name_of(look.verdict), look.meaning);
  for (const Legality legality : values_of<Legality>())
    for (const Latitude latitude : values_of<Latitude>())
      fmt::print("verdict on {}, latitude {}: {}\n", name_of(legality), name_of(latitude),
                 name_of(verdict_of(legality, false, latitude)));
  std::string text;
  JsonWriter json(text);
  write_pixel_counts(json, {});
  fmt::print("pixel counts: {}\n", text);
}

void print_columns() {
  const std::string name = "planted";
  const Result result;
  const Disagreement disagreement;
  write_line(std::cout, [](const Column& column) { return column.name; });
  write_row(std::cout, {name, name, name, result, disagreement});
}

}  // namespace
}  // namespace edgecase

int main(int count, char** arguments) {
  if (count != 3) return 2;
  edgecase::print_rules();
  edgecase::print_policy(arguments[1]);
  edgecase::print_case(arguments[2]);
  edgecase::print_fragment(arguments[2]);
  edgecase::print_verdicts();
  edgecase::print_columns();
}
