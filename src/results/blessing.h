// SPDX-License-Identifier: MIT
//
// Blessing: the changes to a driver's known faults that make results expected.
//
// Differences without a known fault become one new fault for each cause, or for each rule if there
// is no cause. If an existing fault differs in its versions only, these are widened instead. In
// whole results every fault is counted, and one that does not show is closed: its versions end
// before this release. It is removed if no earlier release has it.
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
  std::optional<KnownFault> after;   // nothing: it is removed

  const KnownFault& newest() const { return after ? *after : *before; }
};

// Selects the answers to bless; empty: all. Flakes are never blessed.
using WantedCase = std::function<bool(const std::string& id)>;

struct BlessingOptions {
  WantedCase is_wanted;
  std::string reason;  // of new faults; empty: reason_from() makes one
  std::string link;    // of new faults, or empty
};

// For the renderer at `index`, in the order of the file; new faults come last, those of most cases
// first. `current` are its driver's known faults, by which standings must have been set.
std::vector<FaultChange> plan_blessing(const Results& results, std::size_t index,
                                       const KnownFaults& current, const BlessingOptions& options);

// The file with the changes made.
KnownFaults with_changes(const KnownFaults& current, std::span<const FaultChange> changes);

}  // namespace edgecase
