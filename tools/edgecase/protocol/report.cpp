// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "model/text.h"

namespace edgecase {

namespace {

std::vector<std::string> features(const ProtocolExamination& examination, bool refused) {
  std::vector<std::string> names;
  for (const ProtocolCheck& check : examination.checks)
    if (!check.feature.empty() && (!refused || check.outcome == CheckOutcome::not_supported))
      names.push_back(check.feature);
  return names;
}

// What is to be known before the checks: the roots, and what is refused.
std::string summary_text(const ProtocolExamination& examination) {
  std::string text;
  const auto tell = [&](const char* heading, const Fault& fault) {
    text += fmt::format("{}: {}.\n      Remedy: {}.\n", heading, fault.finding, fault.remedy);
  };
  for (const Fault& root : examination.roots) tell("Root", root);
  const auto refused = features(examination, true);
  const std::size_t all = features(examination, false).size();
  if (!refused.empty())
    tell("Refused",
         {fmt::format("{} ({} of {} features)", fmt::join(refused, ", "), refused.size(), all),
          refused.size() == all
              ? "draw flat triangles first, as reference/examples/triangles.py does"
              : "none is needed; cases that ask for one are not run until it is drawn"});
  return text;
}

}  // namespace

std::string examination_text(const std::string& renderer, const ProtocolExamination& examination) {
  std::string text = fmt::format("{}, by reference/PROTOCOL.md:\n", renderer);
  text += summary_text(examination);
  std::size_t following = 0;
  for (const ProtocolCheck& check : examination.checks) {
    text += fmt::format("{:>4}  {:<13}  {}", check.number, name_of(check.outcome), check.name);
    const bool alone = check.outcome == CheckOutcome::fail && !check.follows;
    if (!check.finding.empty() && !alone) text += ": " + check.finding;
    text += '\n';
    if (alone) text += fmt::format("      {}.\n      Remedy: {}.\n", check.finding, check.remedy);
    following += check.follows ? 1 : 0;
  }
  text += fmt::format(
      "{}: {} pass, {} not supported, {} fail",
      counted(examination.checks.size(), "check", "checks"), examination.count(CheckOutcome::pass),
      examination.count(CheckOutcome::not_supported), examination.count(CheckOutcome::fail));
  if (following > 0) text += fmt::format(" ({} may follow from the root)", following);
  const std::size_t not_asked = examination.count(CheckOutcome::not_asked);
  if (not_asked > 0) text += fmt::format(", {} not asked", not_asked);
  return text + '\n';
}

std::string examinations_json(
    const std::vector<std::pair<std::string, ProtocolExamination>>& examinations) {
  using Json = nlohmann::ordered_json;
  Json renderers = Json::array();
  for (const auto& [name, examination] : examinations) {
    Json roots = Json::array();
    for (const Fault& root : examination.roots)
      roots.push_back({{"finding", root.finding}, {"remedy", root.remedy}});
    Json checks = Json::array();
    for (const ProtocolCheck& check : examination.checks)
      checks.push_back({{"number", check.number},
                        {"name", check.name},
                        {"outcome", name_of(check.outcome)},
                        {"finding", check.finding},
                        {"remedy", check.remedy}});
    renderers.push_back({{"name", name},
                         {"started", examination.started},
                         {"roots", roots},
                         {"refused", features(examination, true)},
                         {"checks", checks},
                         {"summary",
                          {{"pass", examination.count(CheckOutcome::pass)},
                           {"fail", examination.count(CheckOutcome::fail)},
                           {"not_supported", examination.count(CheckOutcome::not_supported)},
                           {"not_asked", examination.count(CheckOutcome::not_asked)}}}});
  }
  const Json document = {{"renderers", renderers}};
  // A program's output need not be UTF-8.
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace edgecase
