// SPDX-License-Identifier: MIT
#include "diff/values/value_diff.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <tuple>
#include <utility>

#include "diff/coverage/vertex_latitude.h"
#include "model/rendering.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/clip_polygon.h"
#include "rules/output/polygon_offset.h"
#include "rules/values/permitted_interpolation.h"

namespace edgecase {

RuleChoices lawful_choices(const RuleChoices& chosen) {
  RuleChoices result = chosen;
  result.values = ValueChoice{};
  return result;
}

namespace {

// A triangle clipped only at near and far, as by an implementation with a guard band.
std::vector<ClipPolygonVertex> polygon_between_near_and_far(const ScenePrimitive& triangle) {
  return clip_polygon({triangle.positions, triangle.z}, guard_band(), 1);
}

// True if clipping gives a triangle more than three edges, at near and far alone or at all planes.
bool is_polygon(const ScenePrimitive& primitive) {
  if (!primitive.is_clipped || primitive.kind != PrimitiveKind::triangle) return false;
  return seen_polygon(primitive).size() > 3 || polygon_between_near_and_far(primitive).size() > 3;
}

bool interpolates_lawfully(const ValueChoice& choice) {
  const ValueChoice lawful;
  return choice.provoking == lawful.provoking && choice.line_parameter == lawful.line_parameter &&
         choice.perspective == lawful.perspective && choice.positions == lawful.positions &&
         choice.offset == lawful.offset;
}

}  // namespace

ValueContext::ValueContext(const Scene& of, std::span<const ScenePrimitive> all,
                           const RuleChoices& under, int bits, Latitude granted,
                           const SamplePositions& reported)
    : scene(of),
      primitives(all),
      choices(under),
      latitude(granted),
      bits_(bits),
      fixed_unit_(permitted_fixed_unit(of.target.depth)),
      positions_(positions_of(of.target, CoverageChoice{}, reported)),
      values_(all.size()) {}

void ValueContext::leave_strays_open(const Rendering& exact, const Rendering& rendered) {
  const auto place_of = [](const Fragment& f) { return std::tuple(f.y, f.x, f.primitive); };
  strays_.clear();
  auto own = exact.fragments.begin();
  for (const Fragment& fragment : rendered.fragments) {
    while (own != exact.fragments.end() && place_of(*own) < place_of(fragment)) ++own;
    const bool is_drawn = own != exact.fragments.end() && place_of(*own) == place_of(fragment);
    if (!is_drawn) strays_.push_back(&fragment);
  }
}

bool ValueContext::is_open_stray(const Fragment& fragment) const {
  return std::ranges::binary_search(strays_, &fragment, std::less<>());
}

PixelTruth ValueContext::looked_up(const Fragment& fragment) const {
  if (looked_up_) return looked_up_(fragment);
  PixelTruth unknown;
  unknown.permitted.fill(Interval::everything());
  return unknown;
}

const ScenePrimitive& ValueContext::primitive_of(const Fragment& fragment) const {
  return primitives[static_cast<std::size_t>(fragment.primitive)];
}

// None if the draw is not multisampled, or the renderer reports a fragment without samples.
std::optional<Invocation> ValueContext::invocation_of(const Fragment& fragment) const {
  if (scene.target.samples == 1) return std::nullopt;
  const ScenePrimitive& primitive = primitive_of(fragment);
  if (!is_multisampled(*primitive.state, scene.target) || fragment.coverage == 0)
    return std::nullopt;
  const bool per_sample =
      std::has_single_bit(fragment.coverage) &&
      runs_per_sample(primitive.state->multisampling, scene.target.samples, rate_);
  return Invocation{primitive.kind, fragment.coverage, per_sample};
}

Point ValueContext::place_of(const Fragment& fragment, const LocationChoice& choice) const {
  const auto invocation = invocation_of(fragment);
  if (!invocation) {
    const ScenePrimitive& primitive = primitive_of(fragment);
    return attribute_place(primitive, scene.target, choices.of(primitive.kind),
                           {fragment.x, fragment.y});
  }
  const AttributeLocation qualifier = primitive_of(fragment).state->multisampling.location;
  return place_in({fragment.x, fragment.y},
                  attribute_location(qualifier, *invocation, positions_, choice));
}

Point ValueContext::depth_place_of(const Fragment& fragment, const LocationChoice& choice) const {
  const auto invocation = invocation_of(fragment);
  if (!invocation) return pixel_centre(fragment.x, fragment.y);
  return place_in({fragment.x, fragment.y},
                  fragment_depth_location(*invocation, positions_, choice));
}

Point ValueContext::coordinates_of(const Fragment& fragment) const {
  const auto invocation = invocation_of(fragment);
  if (!invocation) return pixel_centre(fragment.x, fragment.y);
  return place_in({fragment.x, fragment.y}, coordinates_location(*invocation, positions_));
}

std::vector<Point> ValueContext::permitted_places(const Fragment& fragment) const {
  if (scene.target.samples == 1 || fragment.coverage == 0) return {};
  const ScenePrimitive& primitive = primitive_of(fragment);
  const auto sample = static_cast<std::size_t>(std::countr_zero(fragment.coverage));
  return permitted_locations(primitive, {fragment.x, fragment.y}, positions_.at(sample),
                             reach_of(primitive, bits_));
}

std::vector<Point> ValueContext::permitted_coordinates(const Fragment& fragment) const {
  if (scene.target.samples == 1 || fragment.coverage == 0) return {};
  const auto sample = static_cast<std::size_t>(std::countr_zero(fragment.coverage));
  return permitted_coordinate_locations(primitive_of(fragment).state->multisampling,
                                        {fragment.x, fragment.y}, positions_.at(sample));
}

const PrimitiveValues& ValueContext::values_of(const Fragment& fragment) const {
  std::unique_ptr<PrimitiveValues>& values = values_[static_cast<std::size_t>(fragment.primitive)];
  if (values == nullptr) {
    const ScenePrimitive& primitive = primitive_of(fragment);
    const double reach = reach_of(primitive, bits_).to_double();
    const auto [lawful, depth, inverse_w] = permitted_attributes_of(
        primitive, lawful_choices(choices), scene.target, reach, fixed_unit_);
    const bool differ = !interpolates_lawfully(choices.values);
    values = std::make_unique<PrimitiveValues>(
        PrimitiveValues{differ ? attributes_of(primitive, choices, scene.target) : lawful,
                        lawful,
                        depth,
                        inverse_w,
                        differ,
                        reach,
                        is_polygon(primitive),
                        std::nullopt,
                        {}});
  }
  return *values;
}

Interval with_means(Interval permitted, const ScenePrimitive& primitive,
                    const PrimitiveValues& values, const Interpolant& datum) {
  if (!values.is_polygon) return permitted;
  if (values.corners.empty())
    for (const ClipPolygonVertex& vertex : seen_polygon(primitive))
      values.corners.emplace_back(values.moved(), vertex.position);
  // The polygon's vertices lie on the triangle, and what they carry between what its own do: except
  // that without perspective a value behind the eye does not.
  const bool is_between =
      datum.perspective ||
      std::ranges::all_of(primitive.positions, [](const HomogeneousPoint& p) { return p.w > 0; });
  const Interval all = hull(hull(datum.values[0], datum.values[1]), datum.values[2]);
  for (const PermittedPlace& corner : values.corners) {
    Interval carried = corner.value(datum);
    if (is_between)
      carried = {std::clamp(carried.low, all.low, all.high),
                 std::clamp(carried.high, all.low, all.high)};
    // Each product and sum of a mean may err.
    permitted = hull(permitted, widened(carried, 8 * kInexact.relative));
  }
  return permitted;
}

const MovedVertices& PrimitiveValues::moved() const {
  if (!known_moved) known_moved.emplace(lawful.depth, reach);
  return *known_moved;
}

Interval depth_permitted_at(const PrimitiveValues& values, Point place) {
  return clamped_depth(values.lawful,
                       PermittedPlace(values.moved(), place).value(values.permitted_depth));
}

Interval holding(Interval permitted, double exact) {
  const double number = to_float(exact);
  return std::isnan(number) ? permitted : hull(permitted, number);
}

Interval permitted_within(const Interpolant& interpolant, const Interpolant& inverse_w,
                          std::span<const PermittedPlace> corners) {
  Interval result = corners.front().value(interpolant);
  for (const PermittedPlace& corner : corners.subspan(1))
    result = hull(result, corner.value(interpolant));
  if (!interpolant.perspective) return result;
  for (const PermittedPlace& corner : corners)
    if (corner.value(inverse_w).low <= 0) return Interval::everything();
  return result;
}

DisagreementClass value_class(int primitive, RuleId rule, int ruling) {
  DisagreementClass of;
  of.sample = -1;
  of.primitive = primitive;
  of.kind = DisagreementKind::value;
  of.rule = rule;
  of.ruling = ruling != 0 ? ruling : rule_of(rule).ruling;
  of.legality = Legality::illegal;
  return of;
}

void put_under(RuleId rule, DisagreementClass& of) {
  of.rule = rule;
  of.ruling = rule_of(rule).ruling;
}

Figure value_figure(PixelPosition pixel) {
  return {{sample_mark(pixel_centre(pixel.x, pixel.y))}};
}

Disagreement value_disagreement(PixelPosition pixel, int primitive, RuleId rule, int ruling) {
  Disagreement d;
  static_cast<DisagreementClass&>(d) = value_class(primitive, rule, ruling);
  d.x = pixel.x;
  d.y = pixel.y;
  d.figure = value_figure(pixel);
  return d;
}

double float_ulp(double value) {
  constexpr float kLargest = std::numeric_limits<float>::max();
  const float at = std::fabs(static_cast<float>(value));
  if (at >= kLargest) return static_cast<double>(kLargest - std::nextafterf(kLargest, 0));
  return static_cast<double>(std::nextafterf(at, HUGE_VALF)) - static_cast<double>(at);
}

double error_in_ulp(double exact, double rendered) {
  // A number in place of an infinity counts like two numbers of different signs.
  if (std::isinf(exact) != std::isinf(rendered)) return 0x1p24;
  return std::fabs(rendered - exact) / float_ulp(std::max(std::fabs(exact), std::fabs(rendered)));
}

double largest_value(const Interpolant& interpolant) {
  double largest = 0;
  for (int v = 0; v < vertices_of(interpolant.kind); ++v)
    largest = std::max(largest, interpolant.values[static_cast<std::size_t>(v)].magnitude());
  return largest;
}

double range_of(const Interpolant& interpolant) {
  const auto count = vertices_of(interpolant.kind);
  const auto [least, largest] =
      std::minmax_element(interpolant.values.begin(), interpolant.values.begin() + count,
                          [](Interval a, Interval b) { return a.low < b.low; });
  const double range = largest->high - least->low;
  return range > float_ulp(hull(*least, *largest).magnitude()) ? range : 0;
}

ValueAggregator::ValueAggregator(std::string attribute, RuleId rule, int ruling, Cause cause) {
  aggregate_.attribute = std::move(attribute);
  aggregate_.rule = rule;
  aggregate_.ruling = ruling != 0 ? ruling : rule_of(rule).ruling;
  aggregate_.cause = std::move(cause);
}

void ValueAggregator::count_compared(std::size_t components, std::size_t places) {
  aggregate_.compared += places;
  aggregate_.components += components * places;
}

void ValueAggregator::count_as(const ValueAggregator& whole) {
  aggregate_.compared = whole.aggregate_.compared;
  aggregate_.components = whole.aggregate_.components;
}

void ValueAggregator::add_error(ValueAggregate::Place place, const Error& error) {
  // log2 of the least double stands for an error of zero: the values differ only by rounding.
  const int bucket = error.ulp > 0 ? std::ilogb(error.ulp) : -1074;
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
  const Interval unknown = std::numeric_limits<double>::quiet_NaN();
  aggregate_.worst_low = error.permitted.value_or(unknown).low;
  aggregate_.worst_high = error.permitted.value_or(unknown).high;
}

void ValueAggregator::flush(Result& result) {
  if (aggregate_.compared == 0) return;
  if (ulp_sum_ > 0) aggregate_.mean_ulp = ulp_sum_ / static_cast<double>(aggregate_.components);
  aggregate_.differing.shrink_to_fit();
  result.values.push_back(std::move(aggregate_));
}

namespace {

bool are_equal(const Fragment& a, const Fragment& b) {
  return cover_alike(a, b) && have_equal_values(a, b) && a.has_depth == b.has_depth &&
         a.has_color == b.has_color && a.detail < 0 && b.detail < 0;
}

bool has_offset(const Draw& draw) {
  return draw.polygon_offset.has_value();
}

}  // namespace

bool has_exact_values(const Scene& scene, const ResolvedPolicy& policy, const Rendering& exact,
                      const Rendering& rendered) {
  const bool is_plain = scene.target.samples == 1 && scene.supersampling.empty() &&
                        scene.textures.empty() && !has_fragment_operations(scene) &&
                        std::ranges::none_of(scene.draws, &has_offset);
  return is_plain && policy.is_standard() && exact.pixels == rendered.pixels &&
         std::ranges::equal(exact.depths, rendered.depths, {}, bit_pattern, bit_pattern) &&
         std::ranges::equal(exact.fragments, rendered.fragments, are_equal);
}

}  // namespace edgecase
