// SPDX-License-Identifier: MIT
//
// A search's report as JSON for programs, and the reading of known finds from one.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "search/find.h"
#include "search/fuzz.h"

namespace edgecase {

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
