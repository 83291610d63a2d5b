// SPDX-License-Identifier: MIT
#include "reports/generations_markdown.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "reports/markdown.h"
#include "reports/text.h"

namespace edgecase {
namespace {

// A line of the table: a heading, or a fault.
struct Row {
  std::string name;
  std::vector<std::string> cases;
  std::string seen;
  std::string reason;
};

// A heading, the faults, and what is not known.
std::vector<Row> lines_of(const DriverGenerations& driver) {
  std::vector<Row> rows = {{"fault", {}, "seen", "what"}};
  for (const Release& release : driver.releases) rows[0].cases.push_back(text_of(release));
  for (const GenerationRow& one : rows_of(driver)) {
    Row& row = rows.emplace_back(Row{one.name, {}, one.seen, one.reason});
    for (const std::size_t cases : one.cases) row.cases.push_back(std::to_string(cases));
  }
  return rows;
}

std::string markdown_line(const Row& row) {
  std::string line = fmt::format("| {} |", row.name);
  for (const std::string& cell : row.cases) line += fmt::format(" {} |", cell);
  return line + fmt::format(" {} | {} |\n", row.seen, row.reason);
}

std::string table(const std::string& name, const DriverGenerations& driver) {
  std::vector<Row> rows = lines_of(driver);
  for (std::string& release : rows.front().cases) release = markdown_cell(release);
  std::string text =
      fmt::format("\n## {}\n\n{}|---|", markdown_code(name), markdown_line(rows.front()));
  for (std::size_t i = 0; i < driver.releases.size(); ++i) text += "---:|";
  text += "---|---|\n";
  for (std::size_t i = 1; i < rows.size(); ++i) {
    // The last is no fault.
    if (i + 1 < rows.size()) rows[i].name = markdown_code(rows[i].name);
    if (!rows[i].reason.empty()) rows[i].reason = markdown_cell(rows[i].reason);
    text += markdown_line(rows[i]);
  }
  const auto changed = changed_rules(driver);
  if (!changed.empty()) text += "\nWhat is followed of these rules changed:\n\n";
  for (const std::string& rule : changed) text += fmt::format("- {}\n", markdown_code(rule));
  return text;
}

}  // namespace

std::string generations_markdown(const Generations& generations) {
  std::string text = "# Known faults by release\n";
  for (const auto& [name, driver] : generations) text += table(name, driver);
  return text;
}

std::string generations_text(const Generations& generations) {
  std::string text;
  for (const auto& [name, driver] : generations) {
    const std::vector<Row> rows = lines_of(driver);
    std::size_t widest = 0;
    std::vector<std::size_t> widths(driver.releases.size());
    for (const Row& row : rows) {
      widest = std::max(widest, row.name.size());
      for (std::size_t i = 0; i < widths.size(); ++i)
        widths[i] = std::max(widths[i], row.cases[i].size());
    }
    text += (text.empty() ? "" : "\n") + one_line(name) + "\n";
    for (const Row& row : rows) {
      text += fmt::format("  {:<{}}", one_line(row.name), widest);
      for (std::size_t i = 0; i < widths.size(); ++i)
        text += fmt::format("  {:>{}}", row.cases[i], widths[i]);
      text += "  " + row.seen + "\n";
    }
    for (const std::string& rule : changed_rules(driver)) text += "  " + one_line(rule) + "\n";
  }
  return text;
}

}  // namespace edgecase
