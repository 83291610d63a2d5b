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
#include "run/case_store.h"
#include "run/named_cases.h"

namespace edgecase {

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
  Shard shard;                     // applied last, round robin over sorted ids
};

struct Suite {
  CaseStore cases;                      // sorted by id
  std::vector<Diagnostic> diagnostics;  // what could not be loaded, and two cases of one id
  std::vector<Diagnostic> notes;        // no faults: what "~0.1" was taken as
  // Is nothing there but words that name nothing?
  bool is_misspelt = false;
  std::optional<ShareOfRun> share;  // what `cases` are of all, where a shard was asked for
};

// What the words of a command line select (run/named_cases.h); ids are those of `suite`.
Selection selection_of(std::span<const std::string> words, const std::filesystem::path& suite);

// Loads what the selection asks for. A file that cannot be loaded is a diagnostic and costs nothing
// else, and so is a word that names nothing; excluded and filtered-out files are not even read.
Suite load_suite(const Selection& selection);

}  // namespace edgecase
