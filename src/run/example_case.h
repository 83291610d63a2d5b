// SPDX-License-Identifier: MIT
//
// Example cases: the simplest that a suite has about a rule, for people who begin another.
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

// The case about `rule` with the fewest vertices, then the smallest target, then the first id.
// Where the suite has none, of the rules that share the first or the last part of the id
// ("triangle.snap" of "subpixel.snap"); nothing where there is none of these either. Files with
// faults are passed over.
std::optional<ExampleCase> simplest_case(const std::filesystem::path& suite,
                                         const std::string& rule);

}  // namespace edgecase
