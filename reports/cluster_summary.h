// SPDX-License-Identifier: MIT
//
// The clusters of a run on the terminal: for each renderer those without a cause, each with the
// command that explains its smallest case, then the causes of the others.
#pragma once

#include <iosfwd>
#include <vector>

#include "reports/painter.h"
#include "results/clusters.h"
#include "results/results.h"

namespace edgecase {

// Writes, for each renderer that differs, at most 5 clusters without a cause and at most 5 causes,
// in the order of results/clusters.h, and the numbers of the others. Text from files and renderers
// is written on one line, with control characters made visible. `clusters`: by renderer.
void write_clusters(const Results& results, const std::vector<std::vector<Cluster>>& clusters,
                    const Painter& paint, std::ostream& out);

}  // namespace edgecase
