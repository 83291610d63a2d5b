// SPDX-License-Identifier: MIT
#include "diff/coverage/size_latitude.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "diff/coverage/vertex_latitude.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "rules/samples/multisampled_line.h"

namespace edgecase {
namespace {

Fixed rounded_out(double size, bool upwards) {
  const double raw = size * static_cast<double>(Fixed::kOne);
  return Fixed::from_raw(static_cast<std::int64_t>(upwards ? std::ceil(raw) : std::floor(raw)));
}

}  // namespace

SizeRange permitted_sizes(Fixed asked, const SizeSteps& supported) {
  const double size = asked.to_double();
  // Steps finer than coordinates leave every size as it is.
  if (supported.step * Fixed::kOne < 1) return {asked, asked};
  const double steps = std::max(0.0, std::round((size - supported.least) / supported.step));
  const double away =
      std::min(std::fabs(size - 1), std::fabs(size - (supported.least + steps * supported.step)));
  // Ranges and steps are reported as float32 numbers; this is as accurate as those.
  if (away <= 1e-5 * size) return {asked, asked};
  const Fixed least = Fixed::from_raw(1);
  return {std::max(least, rounded_out(size - away, false)), rounded_out(size + away, true)};
}

namespace {

Triangle nearest_positions(const ScenePrimitive& primitive) {
  Triangle positions{};
  if (primitive.is_clipped) return positions;
  for (std::size_t i = 0; i < static_cast<std::size_t>(vertices_of(primitive.kind)); ++i)
    positions[i] = nearest_point(primitive.positions[i]);
  return positions;
}

// The permitted size of a point or width of a multisampled line. A multisampled point smaller than
// the fade threshold, which is 1, may be as large as the threshold (14.4, equation 14.1).
SizeRange sizes_of(const ScenePrimitive& primitive, const SupportedSizes& supported) {
  const Draw& state = *primitive.state;
  if (primitive.kind == PrimitiveKind::line)
    return permitted_sizes(state.line_width, supported.lines);
  SizeRange range = permitted_sizes(state.point_size, supported.points);
  if (state.multisampling.enabled && state.point_size < Fixed::from_integer(1))
    range.high = std::max(range.high, Fixed::from_integer(1));
  return range;
}

}  // namespace

Latitudes latitudes_of(const ScenePrimitive& primitive, int bits, const SupportedSizes& supported) {
  return {nearest_positions(primitive), reach_of(primitive, bits), sizes_of(primitive, supported)};
}

bool possibly_covered(const ScenePrimitive& primitive, Point sample, const Latitudes& latitudes) {
  const auto& [positions, reach, sizes] = latitudes;
  const auto& [a, b, c] = positions;
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_possibly_covered({a, sizes.high}, sample, reach);
    case PrimitiveKind::line:
      return multisampled_line_possibly_covered({a, b}, sizes.high, sample, reach);
    case PrimitiveKind::triangle:
      return triangle_possibly_covered(positions, sample, reach);
  }
  return true;
}

bool possibly_uncovered(const ScenePrimitive& primitive, Point sample, const Latitudes& latitudes) {
  const auto& [positions, reach, sizes] = latitudes;
  const auto& [a, b, c] = positions;
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_possibly_uncovered({a, sizes.low}, sample, reach);
    case PrimitiveKind::line:
      return multisampled_line_possibly_uncovered({a, b}, sizes.low, sample, reach);
    case PrimitiveKind::triangle:
      return triangle_possibly_uncovered(positions, sample, reach);
  }
  return true;
}

namespace {

// A primitive with its coverage, where sizes are searched for one that explains it.
struct SizeQuestion {
  const ScenePrimitive& primitive;
  const PrimitiveCoverage& coverage;
  Latitudes latitudes;
  SamplePositions positions;  // of the coverage's lists
};

Latitudes with_size(Latitudes latitudes, Fixed size) {
  latitudes.sizes = {size, size};
  return latitudes;
}

// True of every sample in the lists and `test` of its position in the window.
template <class Test>
bool holds_for_all(const SampleCoverage& samples, const SamplePositions& positions,
                   const Test& test) {
  for (std::size_t s = 0; s < samples.size(); ++s)
    for (const PixelPosition pixel : samples[s])
      if (!test(place_in(pixel, positions[s]))) return false;
  return true;
}

bool may_cover_drawn(const SizeQuestion& question, Fixed size) {
  const Latitudes latitudes = with_size(question.latitudes, size);
  return holds_for_all(question.coverage.drawn, question.positions, [&](Point sample) {
    return possibly_covered(question.primitive, sample, latitudes);
  });
}

// The least size of the range, whose high end may cover all that was drawn, that may, too. It
// leaves out the most.
Fixed least_size(const SizeQuestion& question, SizeRange range) {
  while (range.low < range.high) {
    const std::int64_t middle = range.low.raw() + (range.high.raw() - range.low.raw()) / 2;
    if (may_cover_drawn(question, Fixed::from_raw(middle)))
      range.high = Fixed::from_raw(middle);
    else
      range.low = Fixed::from_raw(middle + 1);
  }
  return range.low;
}

ScenePrimitive resized(const ScenePrimitive& primitive, Fixed size, Draw& state) {
  state = *primitive.state;
  (primitive.kind == PrimitiveKind::point ? state.point_size : state.line_width) = size;
  ScenePrimitive other = primitive;
  other.state = &state;
  return other;
}

}  // namespace

SupportedSizes sizes_that_excuse(const ScenePrimitive& primitive, const PrimitiveCoverage& coverage,
                                 const CoverageContext& context) {
  const SupportedSizes& supported = context.sizes;
  if (primitive.kind == PrimitiveKind::triangle || primitive.is_clipped) return supported;
  const Latitudes latitudes = latitudes_of(primitive, context.bits, supported);
  const SizeRange range = latitudes.sizes;
  if (range.low == range.high || coverage.drawn == coverage.exact) return supported;
  const Target& target = context.scene.target;
  const CoverageChoice& choice = standard_choices().of(primitive.kind);
  SizeQuestion question{primitive, coverage, latitudes,
                        positions_of(target, choice, context.reported)};
  if (!is_multisampled(*primitive.state, target))
    question.positions.assign(question.positions.size(), centre_of_pixel());
  if (!may_cover_drawn(question, range.high)) return {};
  const Fixed size = least_size(question, range);
  Draw state;
  const ScenePrimitive of_that_size = resized(primitive, size, state);
  const auto found = differences(
      {covered_samples(of_that_size, target, choice, context.reported), coverage.drawn});
  const bool is_explained = std::ranges::all_of(found, [&](const CoverageDifference& difference) {
    const Point sample =
        place_in(difference.pixel, question.positions[static_cast<std::size_t>(difference.sample)]);
    return difference.drawn > 0 ||
           possibly_uncovered(primitive, sample, with_size(latitudes, size));
  });
  return is_explained ? supported : SupportedSizes{};
}

}  // namespace edgecase
