// SPDX-License-Identifier: MIT
#include "tools/edgecase/report_files.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <utility>
#include <variant>

#include "model/digest.h"
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

void load_sources(Results& results) {
  std::map<std::string, std::string> texts;
  for (CaseResults& one : results.cases) {
    const auto [found, is_new] = texts.try_emplace(one.file);
    std::error_code error;
    if (is_new && std::filesystem::is_regular_file(one.file, error))
      if (auto text = read_file(one.file)) found->second = std::move(*text);
    const bool is_same = digest_of_text(found->second) == one.file_digest;
    if (is_same) one.source = found->second;
    if (is_new && !is_same && !found->second.empty())
      print_error(
          fmt::format("{} is not what it was in the run; reports leave its text out", one.file));
  }
}

void ReportFiles::add_to(CLI::App& command, const std::string& json_names) {
  command.add_option(json_names, json, "File for the results as JSON, - for standard output");
  command.add_option("--junit", junit, "File for JUnit XML");
  command.add_option("--html", html, "File for the HTML report");
}

std::string ReportFiles::html_path() const {
  return json.empty() && junit.empty() && html.empty() ? "out/report.html" : html;
}

bool ReportFiles::write(const Results& results) const {
  const bool all = json.empty() && junit.empty() && html.empty();
  const bool wrote_json =
      write_one(all ? kDefaultJson : json, [&](std::ostream& out) { write_results(results, out); });
  const bool wrote_junit = write_one(all ? "out/junit.xml" : junit,
                                     [&](std::ostream& out) { write_junit(results, out); });
  const bool wrote_html =
      write_one(html_path(), [&](std::ostream& out) { write_html(results, report_texts(), out); });
  return wrote_json && wrote_junit && wrote_html;
}

}  // namespace edgecase
