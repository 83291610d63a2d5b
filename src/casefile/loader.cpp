// SPDX-License-Identifier: MIT
#include "casefile/loader.h"

#include <utility>

#include "casefile/expansion.h"
#include "casefile/json_document.h"
#include "casefile/text_file.h"

namespace edgecase {

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
  if (!loaded.diagnostics.empty()) loaded.cases.clear();
  for (Case& one : loaded.cases) one.source = text;
  return loaded;
}

}  // namespace edgecase
