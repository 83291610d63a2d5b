// SPDX-License-Identifier: MIT
#include "reports/generations_markdown.h"

#include <fmt/format.h>

#include <vector>

#include "reports/markdown.h"

namespace edgecase {
namespace {

std::size_t cases_of(const CasesOn& cases, const Release& release) {
  const auto found = cases.find(text_of(release));
  return found == cases.end() ? 0 : found->second;
}

// "all", "until Mesa 22.3.6", "since Mesa 26.2.6", "Mesa 25.0.7 alone": where the first
// and the last release that showed a fault stand among those that were run.
std::string words_of_span(const std::vector<Release>& releases, const CasesOn& cases) {
  std::size_t first = releases.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < releases.size(); ++i) {
    if (cases_of(cases, releases[i]) == 0) continue;
    first = std::min(first, i);
    last = i;
  }
  if (first == releases.size()) return "none";
  const bool from_first = first == 0;
  const bool to_last = last + 1 == releases.size();
  if (from_first && to_last) return "all";
  if (from_first) return "until " + text_of(releases[last]);
  if (to_last) return "since " + text_of(releases[first]);
  if (first == last) return text_of(releases[first]) + " alone";
  return text_of(releases[first]) + " to " + text_of(releases[last]);
}

std::string row(const std::string& name, const std::vector<Release>& releases, const CasesOn& cases,
                const std::string& reason) {
  std::string cells;
  for (const Release& release : releases) cells += fmt::format(" {} |", cases_of(cases, release));
  return fmt::format("| {} |{} {} | {} |\n", name, cells, words_of_span(releases, cases),
                     reason.empty() ? "" : markdown_cell(reason));
}

std::string table(const std::string& name, const DriverGenerations& driver) {
  std::string head = "| fault |";
  std::string line = "|---|";
  for (const Release& release : driver.releases) {
    head += " " + markdown_cell(text_of(release)) + " |";
    line += "---:|";
  }
  std::string rows;
  for (const auto& [id, cases] : driver.faults)
    rows += row(markdown_code(id), driver.releases, cases, driver.reasons.at(id));
  rows += row("not known", driver.releases, driver.unexpected, "");
  return fmt::format("\n## {}\n\n{} seen | what |\n{}---|---|\n{}", markdown_code(name), head, line,
                     rows);
}

}  // namespace

std::string generations_markdown(const Generations& generations) {
  std::string text = "# Known faults by release\n";
  for (const auto& [name, driver] : generations) text += table(name, driver);
  return text;
}

}  // namespace edgecase
