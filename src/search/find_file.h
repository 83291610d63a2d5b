// SPDX-License-Identifier: MIT
//
// A find as a case file, a search's report as JSON, and finds that are known.
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

constexpr std::size_t kMostTitle = 200;  // bytes of the title of a case that was found

// What a renderer is called or says, as a case file may hold it: a line, 500 bytes of it at most.
std::string text_for_file(const std::string& words);

struct FindFile {
  std::string name;  // "line.diamond-exit-1f2e3d4c.json": the rule, and a hash of title and scene
  std::string text;  // empty exactly when there are diagnostics
  std::vector<Diagnostic> diagnostics;  // what a case file cannot say
};

// The find with its title, why it is one, what every renderer that was asked draws of it, where it
// came from, and its family as a tag. `schema`: relative path from the file to case.schema.json, or
// empty. The same find gives the same file.
FindFile find_file(const Find& find, std::uint64_t seed, const std::string& schema);

// ----------------------------------------------------------------------------------------- reports

// A search's report as JSON, and what it says of finds that are known.

// Words round the report.
struct FuzzWords {
  std::string tool;
  std::string policy;
  std::uint64_t seed = 1;
  std::vector<std::string> renderers;  // as the command line names them
  std::vector<std::string> files;      // of the finds, by index; empty: not saved
};

// {"tool", "policy", "seed", "scenes", "families": {NAME: scenes}, "renderers": [{"name",
// "version", "drawn", "not_drawn", "known"}], "finds": [{"renderer", "verdict", "title",
// "signature", "geometry", "primitives", "target", "bits", "scenes", "asks", "minimized", "origin",
// "answers", "file", "case"}]}, indented; the same bytes for the same report. "case" is the text of
// a case file where a case file can say the scene.
std::string fuzz_json(const FuzzReport& report, const FuzzWords& words);

// The finds of such a text, by renderer; or what is wrong with it.
using KnownKeys = std::map<std::string, std::vector<FindKey>>;
std::variant<KnownKeys, std::string> read_known_finds(const std::string& text);

}  // namespace edgecase
