// SPDX-License-Identifier: MIT
//
// Paths in a case file: meshes and images lie in the suite, so that a case file opens nothing else.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "casefile/fields.h"

namespace edgecase {

// The file that a string names, relative to `case_file`. It must stay inside the suite: the nearest
// folder named "cases" round the case file, or, where there is none, its own folder; else none, and
// a finding. `kind` names what is looked for: "an OBJ file".
std::optional<std::filesystem::path> find_in_suite(const std::filesystem::path& case_file,
                                                   const Place& place, std::string_view kind,
                                                   Findings& findings);

}  // namespace edgecase
