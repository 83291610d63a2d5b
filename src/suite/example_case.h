// SPDX-License-Identifier: MIT
//
// Example cases: a suite's simplest case about a rule, as a start for a new one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "model/case.h"

namespace edgecase {

struct ExampleCase {
  std::string rule;  // that the case is about: the one asked for, or one near it
  Case example;      // the base case of its file
};

// The case about `rule` with the fewest vertices, then the smallest target, then the first id. If
// the suite has none, a case about a rule that shares the first or the last part of the id
// ("triangle.snap" with "subpixel.snap"); nothing if there is none either. Skips files with faults.
std::optional<ExampleCase> simplest_case(const std::filesystem::path& suite,
                                         const std::string& rule);

}  // namespace edgecase
