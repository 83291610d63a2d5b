// SPDX-License-Identifier: MIT
//
// Generations: which releases of a driver show which known fault, from runs of the whole suite.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

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
  std::map<std::string, CasesOn> faults;        // by id; 0: the release was run without it
  std::map<std::string, std::string> reasons;   // by id: those of the newest release
  std::map<std::string, std::string> smallest;  // by id: a case of the newest release with it
  CasesOn unexpected;                           // cases that no known fault accounts for
  // "line.snap, fbo" -> release -> the alternatives that its answers leave (rules/rule_answers.h).
  std::map<std::string, std::map<std::string, std::string>> rules;
};

// A row of the table of a driver: one fault, or last, without a reason, what is not known.
struct GenerationRow {
  std::string name;                // id of the fault; "not known"
  std::vector<std::size_t> cases;  // by release
  // "all", "until Mesa 22.3.6", "since Mesa 26.2.6", "Mesa 25.0.7 alone": where the first and the
  // last release that showed it stand among those that were run.
  std::string seen;
  std::string reason;
  std::string smallest;  // id of a case that shows it, or empty
};

std::vector<GenerationRow> rows_of(const DriverGenerations& driver);

// Of each rule that releases follow differently what each of those that were asked about it
// follows: "line.snap, fbo: none on Mesa 22.3.6, 8-half-up on Mesa 26.2.6".
std::vector<std::string> changed_rules(const DriverGenerations& driver);

using Generations = std::map<std::string, DriverGenerations>;  // by driver

// Adds a run. Results that are not whole are refused with a sentence, because a fault that they do
// not show need not be gone.
std::optional<std::string> add_generation(Generations& generations, const Results& results);

}  // namespace edgecase
