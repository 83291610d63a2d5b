// SPDX-License-Identifier: MIT
//
// The suite: which case files some paths mean, and what their ids are.
//
// An id must not depend on how a case was reached, since known name it and colours are
// salted with it. So it is counted from the nearest folder named "cases" above the file (or that is
// the given folder itself); only where there is none, from the given folder, or, for a single file,
// from the file's own folder.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/case.h"

namespace edgecase {

struct CaseFile {
  std::filesystem::path file;  // as reached from the given path
  std::string id;              // path without suffix, with '/'
};

struct FoundCases {
  std::vector<CaseFile> cases;          // sorted by id, each file once
  std::vector<Diagnostic> diagnostics;  // paths that are missing or cannot be read, equal ids
};

// Expands files and folders. Folders are searched to any depth, without following links to folders,
// for *.json except *.schema.json; hidden folders and folders named "known", "policies",
// "profiles" or "galleries" are skipped. Never throws.
FoundCases find_cases(std::span<const std::filesystem::path> paths);

}  // namespace edgecase
