// SPDX-License-Identifier: MIT
//
// Reads a whole text file of bounded size. Only regular files: a pipe or a device could keep a run
// waiting for ever.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "casefile/json/fields.h"

namespace edgecase {

struct TextFile {
  std::optional<std::string> text;
  std::string message;  // why there is none
  std::string remedy;
};

// Never throws. A file of more than `limit` bytes is refused.
TextFile read_text_file(const std::filesystem::path& file, std::size_t limit);

// Paths in a case file: meshes and images lie in the suite, so that a case file opens nothing else.

// The file that a string names, relative to `case_file`. It must stay inside the suite: the nearest
// folder named "cases" round the case file, or, where there is none, its own folder; else none, and
// a finding. `kind` names what is looked for: "an OBJ file".
std::optional<std::filesystem::path> find_in_suite(const std::filesystem::path& case_file,
                                                   const Place& place, std::string_view kind,
                                                   Findings& findings);

}  // namespace edgecase
