// SPDX-License-Identifier: MIT
//
// Text and marks that the coverage rules share in their explanations.
#pragma once

#include <string>
#include <utility>

#include "exact/fixed.h"
#include "exact/numeral.h"
#include "model/figure.h"

namespace edgecase {

// A sentence and the geometry that belongs to it.
struct Explanation {
  std::string text;
  Figure figure;
};

// "(2.5, 3.5)".
inline std::string format_point(Point point) {
  return "(" + to_decimal(point.x) + ", " + to_decimal(point.y) + ")";
}

inline std::pair<double, double> position_of(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

inline Mark sample_mark(Point sample) {
  return {MarkRole::sample, false, {position_of(sample)}, ""};
}

inline Mark segment_mark(MarkRole role, Point from, Point to, std::string label = "") {
  return {role, false, {position_of(from), position_of(to)}, std::move(label)};
}

}  // namespace edgecase
