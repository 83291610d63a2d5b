// SPDX-License-Identifier: MIT
//
// Selection: which cases a run is about.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "model/case.h"
#include "results/results.h"
#include "suite/case_store.h"

namespace edgecase {

// Words that select cases on the command line: paths, ids, and globs of ids.
//
// A word that is the path of a file or folder means that. Any other is searched among the ids of a
// suite: "lines/short" is a folder, "lines/short/ends" a file, "lines/*" all files whose id matches
// the shell glob. A colon begins the cases of a file: either the rest of an id, as in
// "lines/ramp:dx=0.5:dy=1", or some parts of ids, each possibly a glob: "lines/ramp:dx=0.5" means
// all of the file's cases with that dx. "lines/ramp.json:dx=0.5" is the same by path.

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

// Does each part of a pattern, "dx=0.5:*", match some part of a case's id (Case::parts)? An empty
// pattern has one part that matches nothing.
bool matches_parts(const std::string& pattern, const std::vector<std::string>& parts);

struct Shard {
  int index = 0;  // 0 to count - 1
  int count = 1;
};

// Some cases, by their ids or by the files that hold them.
struct NamedCases {
  std::set<std::string> ids;
  std::set<std::string> files;  // paths as given
};

struct Selection {
  std::vector<std::filesystem::path> paths;             // files and folders
  std::map<std::filesystem::path, PartPatterns> parts;  // as FoundWords has them
  std::vector<Diagnostic> diagnostics;                  // of words that name nothing
  // Shell globs on ids of cases; one that matches a file's id means all cases of the file.
  std::vector<std::string> filters;  // none: all
  std::vector<std::string> excludes;
  std::vector<std::string> tags;   // a case needs one of them; none: all
  std::optional<NamedCases> only;  // of all that the others select
  Shard sample;                    // every count-th case, by id, of what the others select
  Shard shard;                     // applied last (suite/sharding.h)
};

struct Suite {
  CaseStore cases;                      // sorted by id
  std::vector<Diagnostic> diagnostics;  // what could not be loaded, and two cases of one id
  std::vector<Diagnostic> notes;        // no faults: what "~0.1" was taken as
  // Is nothing there but words that name nothing?
  bool is_misspelt = false;
  std::optional<ShareOfRun> share;  // what `cases` are of all, where a shard was asked for
};

// What the words of a command line select (find_words); ids are those of `suite`.
Selection selection_of(std::span<const std::string> words, const std::filesystem::path& suite);

// Loads what the selection asks for. A file that cannot be loaded is a diagnostic and costs nothing
// else, and so is a word that names nothing; excluded and filtered-out files are not even read. Of
// a shard, only files with some of its cases are loaded: others' faults are told if the first case
// shows them.
Suite load_suite(const Selection& selection);

}  // namespace edgecase
