// SPDX-License-Identifier: MIT
#include "casefile/loader.h"

#include <utility>

#include "casefile/case_reader.h"
#include "casefile/json_document.h"
#include "casefile/text_file.h"

namespace edgecase {

LoadedCase load_case(const std::filesystem::path& file, const std::string& id,
                     std::span<const std::string> known_rules) {
  TextFile read = read_text_file(file, kMaxFileBytes);
  if (read.text) return load_case_text(*read.text, file, id, known_rules);
  LoadedCase loaded;
  loaded.diagnostics.push_back(
      {file.generic_string(), 0, "", std::move(read.message), std::move(read.remedy)});
  return loaded;
}

LoadedCase load_case_text(const std::string& text, const std::filesystem::path& file,
                          const std::string& id, std::span<const std::string> known_rules) {
  Findings findings(file.generic_string());
  JsonDocument document = parse_json(text, findings.file());
  for (Diagnostic& diagnostic : document.diagnostics) findings.add(std::move(diagnostic));
  Case result;
  result.id = id;
  result.file = file;
  if (document.root) read_case(*document.root, known_rules, findings, result);
  LoadedCase loaded;
  loaded.notes = findings.take_notes();
  loaded.diagnostics = findings.take();
  if (!loaded.diagnostics.empty()) return loaded;
  result.source = text;
  loaded.value = std::move(result);
  return loaded;
}

}  // namespace edgecase
