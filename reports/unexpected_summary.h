// SPDX-License-Identifier: MIT
//
// The unexpected answers of a run on the terminal: those of one renderer that share cause and
// verdict are one entry, with the command that reproduces its simplest case.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "reports/painter.h"
#include "results/clusters.h"
#include "results/results.h"

namespace edgecase {

struct UnexpectedGroup {
  std::size_t renderer = 0;  // index
  Standing standing = Standing::unexpected;
  Verdict verdict = Verdict::violation;
  bool is_partly_known = false;  // known faults account for some of its differences
  // Of a failure its kind; else what title_of(Cluster) says of the worst difference; empty where
  // nothing differs.
  std::string cause;
  std::size_t cases = 0;
  std::size_t simplest = 0;  // the least CaseSize: index in Results::cases
};

// Violations first, then answers that did not come, then the rest by verdict; within each the
// groups of most cases first, ties by cause and renderer. `clusters`: by renderer.
std::vector<UnexpectedGroup> unexpected_groups(const Results& results,
                                               const std::vector<std::vector<Cluster>>& clusters);

// At most 10 groups, and how many more there are; nothing where all is expected. Text from files
// and renderers stands on one line, its control characters visible.
void write_unexpected(const Results& results, const std::vector<std::vector<Cluster>>& clusters,
                      const Painter& paint, std::ostream& out);

}  // namespace edgecase
