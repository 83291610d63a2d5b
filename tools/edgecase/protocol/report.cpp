// SPDX-License-Identifier: MIT
#include "tools/edgecase/protocol/report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "model/text.h"

namespace edgecase {

std::string examination_text(const std::string& renderer, const ProtocolExamination& examination) {
  std::string text = fmt::format("{}, by reference/PROTOCOL.md:\n", renderer);
  for (const ProtocolCheck& check : examination.checks) {
    text += fmt::format("{:>4}  {:<13}  {}", check.number, name_of(check.outcome), check.name);
    if (check.outcome == CheckOutcome::not_supported) text += ": " + check.finding;
    text += '\n';
    if (check.outcome == CheckOutcome::fail)
      text += fmt::format("      {}.\n      Remedy: {}.\n", check.finding, check.remedy);
  }
  return text + fmt::format("{}: {} pass, {} not supported, {} fail\n",
                            counted(examination.checks.size(), "check", "checks"),
                            examination.count(CheckOutcome::pass),
                            examination.count(CheckOutcome::not_supported),
                            examination.count(CheckOutcome::fail));
}

std::string examinations_json(
    const std::vector<std::pair<std::string, ProtocolExamination>>& examinations) {
  using Json = nlohmann::ordered_json;
  Json renderers = Json::array();
  for (const auto& [name, examination] : examinations) {
    Json checks = Json::array();
    for (const ProtocolCheck& check : examination.checks)
      checks.push_back({{"number", check.number},
                        {"name", check.name},
                        {"outcome", name_of(check.outcome)},
                        {"finding", check.finding},
                        {"remedy", check.remedy}});
    renderers.push_back({{"name", name},
                         {"started", examination.started},
                         {"checks", checks},
                         {"summary",
                          {{"pass", examination.count(CheckOutcome::pass)},
                           {"fail", examination.count(CheckOutcome::fail)},
                           {"not_supported", examination.count(CheckOutcome::not_supported)}}}});
  }
  const Json document = {{"renderers", renderers}};
  // A program's output need not be UTF-8.
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace edgecase
