// SPDX-License-Identifier: MIT
#include "rules/coverage/explain.h"

#include <utility>

#include "exact/numeral.h"

namespace edgecase {

std::string format_point(Point point) {
  return "(" + to_decimal(point.x) + ", " + to_decimal(point.y) + ")";
}

std::pair<double, double> position_of(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

Mark sample_mark(Point sample) {
  return {MarkRole::sample, false, {position_of(sample)}, ""};
}

Mark segment_mark(MarkRole role, Point from, Point to, std::string label) {
  return {role, false, {position_of(from), position_of(to)}, std::move(label)};
}

}  // namespace edgecase
