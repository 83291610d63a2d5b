// SPDX-License-Identifier: MIT
#include "diff/value_diff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diff/vertex_latitude.h"
#include "rules/coverage/explain.h"

namespace edgecase {
namespace {

// What OpenGL's own rules say about attributes.
RuleChoices lawful_choices(const RuleChoices& chosen) {
  RuleChoices result = chosen;
  result.values = ValueChoice{};
  return result;
}

bool interpolates_lawfully(const ValueChoice& choice) {
  const ValueChoice lawful;
  return choice.provoking == lawful.provoking && choice.line_parameter == lawful.line_parameter &&
         choice.perspective == lawful.perspective && choice.positions == lawful.positions;
}

}  // namespace

ValueContext::ValueContext(const Scene& of, std::span<const ScenePrimitive> all,
                           const RuleChoices& under, int bits, Latitude granted)
    : scene(of),
      primitives(all),
      choices(under),
      latitude(granted),
      bits_(bits),
      values_(all.size()) {}

const ScenePrimitive& ValueContext::primitive_of(const Fragment& fragment) const {
  return primitives[static_cast<std::size_t>(fragment.primitive)];
}

const PrimitiveValues& ValueContext::values_of(const Fragment& fragment) const {
  std::optional<PrimitiveValues>& values = values_[static_cast<std::size_t>(fragment.primitive)];
  if (!values) {
    const ScenePrimitive& primitive = primitive_of(fragment);
    values = {attributes_of(primitive, choices, scene.target),
              attributes_of(primitive, lawful_choices(choices), scene.target),
              !interpolates_lawfully(choices.values),
              reach_of(primitive, scene.viewport, bits_).to_double()};
  }
  return *values;
}

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

double float_ulp(double value) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  const float at = std::fabs(static_cast<float>(value));
  if (at >= kLargest) return static_cast<double>(kLargest - std::nextafterf(kLargest, 0));
  return static_cast<double>(std::nextafterf(at, HUGE_VALF)) - static_cast<double>(at);
}

double error_in_ulp(double exact, double rendered) {
  // A number for an infinity: as far off as any two numbers of different signs.
  if (std::isinf(exact) != std::isinf(rendered)) return 0x1p24;
  return std::fabs(rendered - exact) / float_ulp(std::max(std::fabs(exact), std::fabs(rendered)));
}

double to_float(double value) {
  return static_cast<double>(static_cast<float>(value));
}

Interval rounded_to_float(Interval value) {
  return {to_float(value.low), to_float(value.high)};
}

double range_of(const Interpolant& interpolant) {
  const auto count = vertices_of(interpolant.kind);
  const auto [least, largest] =
      std::minmax_element(interpolant.values.begin(), interpolant.values.begin() + count,
                          [](Interval a, Interval b) { return a.low < b.low; });
  const double range = largest->high - least->low;
  return range > float_ulp(hull(*least, *largest).magnitude()) ? range : 0;
}

ValueAggregator::ValueAggregator(std::string attribute, std::string rule, int ruling,
                                 std::string cause) {
  aggregate_.attribute = std::move(attribute);
  aggregate_.rule = std::move(rule);
  aggregate_.ruling = ruling;
  aggregate_.cause = std::move(cause);
}

void ValueAggregator::count_compared(std::size_t components) {
  ++aggregate_.compared;
  aggregate_.components += components;
}

void ValueAggregator::count_as(const ValueAggregator& whole) {
  aggregate_.compared = whole.aggregate_.compared;
  aggregate_.components = whole.aggregate_.components;
}

void ValueAggregator::add_error(ValueAggregate::Place place, const Error& error) {
  // log2 of the least double stands for an error of zero: told apart by rounding alone.
  const int bucket = error.ulp > 0 ? static_cast<int>(std::floor(std::log2(error.ulp))) : -1074;
  const bool first = aggregate_.ulp_histogram.empty();
  ++aggregate_.ulp_histogram[bucket];
  ulp_sum_ += error.ulp;
  if (error.range > 0)
    aggregate_.worst_relative =
        std::max(aggregate_.worst_relative, std::fabs(error.rendered - error.exact) / error.range);
  if (error.ulp <= aggregate_.worst_ulp && !first) return;
  aggregate_.worst = place;
  aggregate_.worst_component = error.component;
  aggregate_.worst_exact = error.exact;
  aggregate_.worst_rendered = error.rendered;
  aggregate_.worst_ulp = error.ulp;
}

void ValueAggregator::flush(Result& result) {
  if (aggregate_.differing.empty()) return;
  aggregate_.mean_ulp = ulp_sum_ / static_cast<double>(aggregate_.components);
  result.values.push_back(std::move(aggregate_));
}

}  // namespace edgecase
