// SPDX-License-Identifier: MIT
#include "diff/value_diff.h"

#include <cmath>
#include <utility>

#include "rules/coverage/explain.h"

namespace edgecase {

Disagreement value_disagreement(PixelPosition pixel, int primitive, std::string rule, int ruling) {
  Disagreement d;
  d.x = pixel.x;
  d.y = pixel.y;
  d.primitive = primitive;
  d.kind = DisagreementKind::value;
  d.rule = std::move(rule);
  d.ruling = ruling;
  d.legal = false;
  d.figure.marks = {sample_mark(pixel_centre(pixel.x, pixel.y))};
  return d;
}

ValueAggregator::ValueAggregator(std::string attribute, std::string rule, int ruling) {
  aggregate_.attribute = std::move(attribute);
  aggregate_.rule = std::move(rule);
  aggregate_.ruling = ruling;
}

void ValueAggregator::add_error(ValueAggregate::Place place, int component,
                                std::array<double, 2> exact_rendered, double ulp) {
  // log2 of the least double stands for an error of zero: told apart by rounding alone.
  const int bucket = ulp > 0 ? static_cast<int>(std::floor(std::log2(ulp))) : -1074;
  ++aggregate_.ulp_histogram[bucket];
  if (ulp <= aggregate_.worst_ulp && !aggregate_.differing.empty()) return;
  aggregate_.worst = place;
  aggregate_.worst_component = component;
  aggregate_.worst_exact = exact_rendered[0];
  aggregate_.worst_rendered = exact_rendered[1];
  aggregate_.worst_ulp = ulp;
}

void ValueAggregator::flush(Result& result) {
  if (!aggregate_.differing.empty()) result.values.push_back(std::move(aggregate_));
}

}  // namespace edgecase
