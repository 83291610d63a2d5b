// SPDX-License-Identifier: MIT
//
// Words and marks that the coverage rules share when they explain a decision.
#pragma once

#include <string>

#include "exact/fixed.h"
#include "model/figure.h"

namespace edgecase {

// A sentence and the geometry that belongs to it.
struct Explanation {
  std::string text;
  Figure figure;
};

// "(2.5, 3.5)".
std::string format_point(Point point);

std::pair<double, double> position_of(Point point);

Mark sample_mark(Point sample);
Mark segment_mark(MarkRole role, Point from, Point to, std::string label = "");

}  // namespace edgecase
