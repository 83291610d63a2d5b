// SPDX-License-Identifier: MIT
//
// A find as a case file, a search's report as JSON, and known finds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "model/case.h"
#include "search/find.h"
#include "search/fuzz.h"

namespace edgecase {

// -------------------------------------------------------------------------------------- case files

constexpr std::size_t kMostTitle = 200;  // bytes of the title of a found case

// A renderer's name or message in the form for a case file: one line of at most 500 bytes.
std::string text_for_file(const std::string& words);

struct FindFile {
  std::string name;  // "line.diamond-exit-1f2e3d4c.json": the rule, and a hash of title and scene
  std::string text;  // empty exactly if there are diagnostics
  std::vector<Diagnostic> diagnostics;  // why a case file cannot express it
};

// A case file of the find, with its title, the reason, the answers of all renderers, its origin,
// and its family as a tag. `schema`: relative path from the file to case.schema.json, or empty.
// Equal finds give equal files.
FindFile find_file(const Find& find, std::uint64_t seed, const std::string& schema);

// ----------------------------------------------------------------------------------------- reports

// A search's report as JSON, and the reading of known finds from one.

// The context of the report.
struct FuzzWords {
  std::string tool;
  std::string policy;
  std::uint64_t seed = 1;
  std::vector<std::string> renderers;  // as on the command line
  std::vector<std::string> files;      // of the finds, by index; empty: not saved
};

// {"tool", "policy", "seed", "scenes", "families": {NAME: scenes}, "renderers": [{"name",
// "version", "drawn", "not_drawn", "known"}], "finds": [{"renderer", "verdict", "title",
// "signature", "geometry", "primitives", "target", "bits", "scenes", "asks", "minimized", "origin",
// "answers", "file", "case"}]}, indented; equal reports give equal bytes. "case" is the text of a
// case file if one can express the scene.
std::string fuzz_json(const FuzzReport& report, const FuzzWords& words);

// The finds in such a text, by renderer; or the fault of the text.
using KnownKeys = std::map<std::string, std::vector<FindKey>>;
std::variant<KnownKeys, std::string> read_known_finds(const std::string& text);

}  // namespace edgecase
