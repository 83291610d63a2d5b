// SPDX-License-Identifier: MIT
//
// A find as a case file, which anybody can run again: its scene, and in words what it shows, what
// each renderer answers, and where it comes from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/case.h"
#include "search/find.h"

namespace edgecase {

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

}  // namespace edgecase
