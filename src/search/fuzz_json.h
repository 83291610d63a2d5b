// SPDX-License-Identifier: MIT
//
// A search's report as JSON, and what it says of finds that are known.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "search/fuzz.h"

namespace edgecase {

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
