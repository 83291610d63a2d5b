// SPDX-License-Identifier: MIT
//
// Blessing: what would change in a driver's known faults so that results are as known.
//
// Differences for which nothing accounts become one new fault for each cause, and for each rule
// where there is none; or they widen the versions of a fault that is the same but for them. Of
// whole results every fault is counted, and one that shows nowhere is closed: its versions end
// before this release, or, where no earlier release has it, it goes.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "results/known_faults.h"

namespace edgecase {

struct FaultChange {
  std::optional<KnownFault> before;  // nothing: the fault is new
  std::optional<KnownFault> after;   // nothing: it goes

  const KnownFault& newest() const { return after ? *after : *before; }
};

// Answers that are to become known: all where it is empty. Flakes never are.
using WantedCase = std::function<bool(const std::string& id)>;

struct BlessingOptions {
  WantedCase is_wanted;
  std::string reason;  // of new faults; empty: made of what was found
  std::string link;    // of new faults, or empty
};

// For the renderer at `index`, in the order of the file; new faults come last, those of most cases
// first. `current` are its driver's. Standings must have been set by them.
std::vector<FaultChange> plan_blessing(const Results& results, std::size_t index,
                                       const KnownFaults& current, const BlessingOptions& options);

// The file with the changes made.
KnownFaults with_changes(const KnownFaults& current, std::span<const FaultChange> changes);

}  // namespace edgecase
