// SPDX-License-Identifier: MIT
//
// Reads a whole text file of bounded size. Only regular files are read: a pipe or a device could
// block a run for ever.
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
  std::string message;  // why there is no text
  std::string remedy;
};

// Never throws. Refuses a file of more than `limit` bytes.
TextFile read_text_file(const std::filesystem::path& file, std::size_t limit);

// Paths in a case file: meshes and images must lie in the suite, so that it opens nothing else.

// The file that a string names, relative to `case_file`. It must lie inside the suite: the nearest
// folder named "cases" round the case file or, if there is none, its own folder. Otherwise nothing,
// and a finding. `kind` describes the file: "an OBJ file".
std::optional<std::filesystem::path> find_in_suite(const std::filesystem::path& case_file,
                                                   const Place& place, std::string_view kind,
                                                   Findings& findings);

}  // namespace edgecase
