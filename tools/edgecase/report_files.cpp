// SPDX-License-Identifier: MIT
#include "tools/edgecase/report_files.h"

#include <fmt/format.h>

#include <functional>
#include <sstream>
#include <utility>
#include <variant>

#include "reports/html.h"
#include "reports/junit.h"
#include "results/results_json.h"
#include "rules/all_rules.h"
#include "tools/edgecase/options.h"

namespace edgecase {
namespace {

ReportTexts report_texts() {
  ReportTexts texts;
  for (const Rule& rule : all_rules()) {
    texts.rules.push_back({rule.id, rule.title, rule.spec, rule.latitude});
    for (const Ruling& ruling : rule.rulings) texts.rulings.push_back({ruling.number, ruling.text});
  }
  return texts;
}

bool write_one(const std::string& path, const std::function<void(std::ostream&)>& write) {
  if (path.empty()) return true;
  std::ostringstream text;
  write(text);
  if (path != "-") return write_file(path, text.str());
  fmt::print("{}", text.str());
  return true;
}

}  // namespace

std::optional<Results> load_results(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return std::nullopt;
  auto read = read_results(*text);
  if (auto* results = std::get_if<Results>(&read)) return std::move(*results);
  print_error(fmt::format("{}: {}; name a file that `edgecase run --json` wrote", path,
                          std::get<std::string>(read)));
  return std::nullopt;
}

void ReportFiles::add_to(CLI::App& command) {
  command.add_option("--json", json, "File for the results as JSON, - for standard output");
  command.add_option("--junit", junit, "File for JUnit XML");
  command.add_option("--html", html, "File for the HTML report");
}

std::string ReportFiles::html_path() const {
  return json.empty() && junit.empty() && html.empty() ? "out/report.html" : html;
}

bool ReportFiles::write(const Results& results) const {
  const bool all = json.empty() && junit.empty() && html.empty();
  const bool wrote_json = write_one(all ? "out/results.json" : json,
                                    [&](std::ostream& out) { write_results(results, out); });
  const bool wrote_junit = write_one(all ? "out/junit.xml" : junit,
                                     [&](std::ostream& out) { write_junit(results, out); });
  const bool wrote_html =
      write_one(html_path(), [&](std::ostream& out) { write_html(results, report_texts(), out); });
  return wrote_json && wrote_junit && wrote_html;
}

}  // namespace edgecase
