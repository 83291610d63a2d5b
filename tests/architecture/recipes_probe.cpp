// SPDX-License-Identifier: MIT
//
// What a tree knows, for recipes_test.py, which plants something in a copy of it: the rules and
// their alternatives, what a policy resolves to, and a case on all of its ways.
//
//     recipes_probe POLICY CASE
#include <fmt/format.h>

#include <string>
#include <variant>
#include <vector>

#include "casefile/case_reader.h"
#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "casefile/policy_reader.h"
#include "reference/drawn_keys.h"
#include "rules/all_rules.h"
#include "rules/chapters.h"
#include "rules/choices.h"
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

}  // namespace
}  // namespace edgecase

int main(int count, char** arguments) {
  if (count != 3) return 2;
  edgecase::print_rules();
  edgecase::print_policy(arguments[1]);
  edgecase::print_case(arguments[2]);
}
