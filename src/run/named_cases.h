// SPDX-License-Identifier: MIT
//
// What people write to say which cases they mean: paths, ids, and globs of ids.
//
// A word that is the path of a file or folder means that. Any other is looked up among the ids of a
// suite: "lines/short" is a folder, "lines/short/ends" a file, "lines/*" all files whose id matches
// the shell glob. Behind a colon stands which cases of a file are meant, as ids say it:
// "lines/ramp:dx=0.5:dy=1"; where that is no id, some of the parts of ids, each perhaps a glob:
// "lines/ramp:dx=0.5" means all of the file's cases with that dx.
// "lines/ramp.json:dx=0.5" is the same by path.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/case.h"

namespace edgecase {

// Which cases of a file are meant.
struct PartPattern {
  std::string parts;  // "dx=0.5:reverse"
  std::string word;   // of the command line, for messages
};
using PartPatterns = std::vector<PartPattern>;  // one for each time the file was named

struct FoundWords {
  std::vector<std::filesystem::path> paths;  // files and folders that are there
  // Of files in `paths` of which not all cases are meant: which are. A case is meant if it matches
  // one of the patterns.
  std::map<std::filesystem::path, PartPatterns> parts;
  std::vector<Diagnostic> diagnostics;  // words that name nothing, with the nearest id
};

// `suite`: the folder in which ids are looked up; need not exist. Never throws.
FoundWords find_words(std::span<const std::string> words, const std::filesystem::path& suite);

// Does each part of a pattern, "dx=0.5:*", match some part of the case's id? An empty pattern has
// one part that matches nothing.
bool matches_parts(const std::string& pattern, const Case& one);

}  // namespace edgecase
