// SPDX-License-Identifier: MIT
#include "casefile/loader.h"

#include <fmt/format.h>

#include <utility>

#include "casefile/expansion.h"
#include "casefile/json_document.h"
#include "casefile/text_file.h"

namespace edgecase {
namespace {

// Faults that are listed; more help nobody.
constexpr std::size_t kMostFaults = 1000;

void shorten(std::vector<Diagnostic>& faults) {
  if (faults.size() <= kMostFaults) return;
  const std::size_t more = faults.size() - kMostFaults;
  faults.resize(kMostFaults);
  faults.push_back({faults.back().file, faults.back().line, "",
                    fmt::format("{} more faults are not listed", more), "put these right first"});
}

}  // namespace

LoadedCases load_cases(const std::filesystem::path& file, const std::string& id,
                       std::span<const std::string> known_rules) {
  TextFile read = read_text_file(file, kMaxFileBytes);
  if (read.text) return load_cases_text(*read.text, file, id, known_rules);
  LoadedCases loaded;
  loaded.diagnostics.push_back(
      {file.generic_string(), 0, "", std::move(read.message), std::move(read.remedy)});
  return loaded;
}

LoadedCases load_cases_text(const std::string& text, const std::filesystem::path& file,
                            const std::string& id, std::span<const std::string> known_rules) {
  Findings findings(file.generic_string());
  JsonDocument document = parse_json(text, findings.file());
  for (Diagnostic& diagnostic : document.diagnostics) findings.add(std::move(diagnostic));
  LoadedCases loaded;
  if (document.root)
    loaded.cases = expand_cases(*document.root, {file, id, text, known_rules}, findings);
  loaded.notes = findings.take_notes();
  loaded.diagnostics = findings.take();
  shorten(loaded.diagnostics);
  if (!loaded.diagnostics.empty()) loaded.cases.clear();
  const SharedText source(text);
  for (Case& one : loaded.cases) one.source = source;
  return loaded;
}

}  // namespace edgecase
