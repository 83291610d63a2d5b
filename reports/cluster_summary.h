// SPDX-License-Identifier: MIT
//
// The clusters of a run on the terminal: per renderer what no alternative accounts for, each with
// the command that explains its smallest case, then the causes of the rest.
#pragma once

#include <iosfwd>

#include "reports/painter.h"
#include "results/results.h"

namespace edgecase {

// For each renderer that differs at all: at most 5 clusters without cause (results/clusters.h has
// the order) and at most 5 causes, and how many more of each there are. Text from files and
// renderers stands on one line, its control characters visible.
void write_clusters(const Results& results, const Painter& paint, std::ostream& out);

}  // namespace edgecase
