// SPDX-License-Identifier: MIT
//
// Generations: which releases of a driver show which known fault, from runs of the whole suite.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>

#include "results/known_faults.h"
#include "results/results.h"

namespace edgecase {

// The number of cases in which a release showed one fault: that of the driver's renderer with the
// most.
using CasesOn = std::map<std::string, std::size_t>;  // by text_of(Release)

// The driver's releases that were run, oldest first, and its faults that at least one of them
// showed.
struct DriverGenerations {
  std::vector<Release> releases;
  std::map<std::string, CasesOn> faults;       // by id; 0: the release was run without it
  std::map<std::string, std::string> reasons;  // by id: those of the newest release
  CasesOn unexpected;                          // cases that no known fault accounts for
};

using Generations = std::map<std::string, DriverGenerations>;  // by driver

// Adds a run. Results that are not whole are refused with a sentence, because a fault that they do
// not show need not be gone.
std::optional<std::string> add_generation(Generations& generations, const Results& results);

}  // namespace edgecase
