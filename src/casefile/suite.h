// SPDX-License-Identifier: MIT
//
// The suite: the case files that paths refer to, and their ids.
//
// An id must not depend on how a case was reached, since known faults refer to it and colours are
// derived from it. So it is relative to the nearest folder named "cases" at or above the file's
// folder. Only if there is none, it is relative to the given folder or, for a single file, to the
// file's own folder.
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
  std::vector<Diagnostic> diagnostics;  // missing or unreadable paths, equal ids
};

// Expands files and folders. Folders are searched to any depth, without following links to folders,
// for *.json except *.schema.json. Hidden folders and folders named "known", "policies", "profiles"
// or "galleries" are skipped. Never throws.
FoundCases find_cases(std::span<const std::filesystem::path> paths);

}  // namespace edgecase
