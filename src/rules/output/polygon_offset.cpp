// SPDX-License-Identifier: MIT
#include "rules/output/polygon_offset.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

// The floating-point clause: relative error that one operation may have.
constexpr double kOperationError = 1e-5;

struct Gradient {
  Interval x;
  Interval y;
};

Interval absolute(Interval value) {
  if (value.low >= 0) return value;
  if (value.high <= 0) return {-value.high, -value.low};
  return {0, value.magnitude()};
}

Interval square_root(Interval value) {
  const double low = std::sqrt(std::max(value.low, 0.0));
  const Interval root = outward(low, std::sqrt(std::max(value.high, 0.0)));
  return {std::max(root.low, 0.0), root.high};
}

// Each operation may err by a relative amount.
Interval length_of(const Gradient& gradient, double relative) {
  const Interval x = absolute(gradient.x);
  const Interval y = absolute(gradient.y);
  const Interval squared = widened(widened(x * x, relative) + widened(y * y, relative), relative);
  return widened(square_root(squared), relative);
}

Interval largest_of(const Gradient& gradient) {
  const Interval x = absolute(gradient.x);
  const Interval y = absolute(gradient.y);
  return {std::max(x.low, y.low), std::max(x.high, y.high)};
}

// 0 times an unknown slope is 0.
Interval product_of(float share, Interval value) {
  return share == 0 ? Interval(0) : Interval(static_cast<double>(share)) * value;
}

Interval clamped(Interval offset, float clamp) {
  const auto limit = static_cast<double>(clamp);
  if (clamp > 0) return {std::min(offset.low, limit), std::min(offset.high, limit)};
  if (clamp < 0) return {std::max(offset.low, limit), std::max(offset.high, limit)};
  return offset;
}

// 2^(e - 23), e the exponent of a depth as a float32 number, at least that of 2^-126.
double float_unit(double depth) {
  const auto stored = static_cast<double>(static_cast<float>(depth));
  const int exponent = stored < 0x1p-126 ? -126 : std::ilogb(stored);
  return std::ldexp(1.0, exponent - 23);
}

// For depths that may be off by a relative amount.
Interval float_unit_of(const Interpolant& depth, double relative) {
  Interval largest = depth.values[0];
  for (const Interval value : depth.values)
    largest = {std::max(largest.low, value.low), std::max(largest.high, value.high)};
  largest = relative == 0 ? largest : widened(largest, relative);
  return {float_unit(std::clamp(largest.low, 0.0, 1.0)),
          float_unit(std::clamp(largest.high, 0.0, 1.0))};
}

// 1/(2^bits - 1).
Interval step_of(int bits) {
  return Interval(1) / (std::ldexp(1.0, bits) - 1);
}

// Without rounding.
Interval doubled(Interval unit) {
  return {2 * unit.low, 2 * unit.high};
}
Interval halved(Interval unit) {
  return {unit.low / 2, unit.high / 2};
}

Interval fixed_unit(int bits, OffsetUnit choice) {
  switch (choice) {
    case OffsetUnit::step:
      return step_of(bits);
    case OffsetUnit::power:
      return std::ldexp(1.0, -bits);
    case OffsetUnit::two_steps:
      return doubled(step_of(bits));
    case OffsetUnit::four_steps:
      return doubled(doubled(step_of(bits)));
    case OffsetUnit::half_step:
      return halved(step_of(bits));
    case OffsetUnit::of_24_bits:
      return 0x1p-24;
    case OffsetUnit::ignored:
      return 0;
  }
  return 0;
}

Interval unit_of(const Interpolant& depth, DepthFormat format, const OffsetChoice& choice) {
  if (format == DepthFormat::none) return 0;
  if (const int bits = bits_of(format); bits > 0) return fixed_unit(bits, choice.unit);
  switch (choice.exponent) {
    case OffsetExponent::largest_depth:
      return float_unit_of(depth, 0);
    case OffsetExponent::doubled:
      return doubled(float_unit_of(depth, 0));
    case OffsetExponent::halved:
      return halved(float_unit_of(depth, 0));
    case OffsetExponent::one:
      return 0x1p-23;
    case OffsetExponent::as_fixed:
      return fixed_unit(24, choice.unit);
  }
  return 0;
}

Interval slope_of(const Gradient& gradient, OffsetSlope choice) {
  switch (choice) {
    case OffsetSlope::length:
      return length_of(gradient, 0);
    case OffsetSlope::largest_partial:
      return largest_of(gradient);
    case OffsetSlope::sum_of_partials:
      return absolute(gradient.x) + absolute(gradient.y);
    case OffsetSlope::ignored:
      return 0;
  }
  return 0;
}

Interval permitted_unit(const Interpolant& depth, DepthFormat format, Interval fixed_unit) {
  if (format == DepthFormat::none) return 0;
  return bits_of(format) == 0 ? float_unit_of(depth, kOperationError) : fixed_unit;
}

// Units that are so large that every depth is clamped, whatever the slope adds, are all alike: none
// larger is needed, and errors stay small beside the rest.
Interval short_of_saturation(Interval unit, float units, double of_slope) {
  if (units == 0 || !std::isfinite(of_slope)) return unit;
  const double enough = (2 + of_slope) / std::fabs(static_cast<double>(units));
  return {unit.low, std::max(unit.low, std::min(unit.high, enough))};
}

// Depth is linear in the window, and its gradient is the same everywhere.
Interpolant linear(Interpolant depth) {
  depth.perspective = false;
  return depth;
}

// The depth less that of the first vertex, near which it needs no rounding.
Interpolant from_first_vertex(Interpolant depth) {
  const Interval first = depth.values[0];
  for (Interval& value : depth.values) {
    const bool is_same = value.low == first.low && value.high == first.high;
    value = is_same ? Interval(0) : value - first;
  }
  return depth;
}

Gradient exact_gradient(const Interpolant& depth) {
  const Interpolant rise = from_first_vertex(depth);
  const Point place = nearest_point(depth.positions[0]);
  return {differentiate_exact(rise, place, Axis::x), differentiate_exact(rise, place, Axis::y)};
}

}  // namespace

Interval offset_exact(const PolygonOffset& offset, const Interpolant& depth, DepthFormat format,
                      const OffsetChoice& choice) {
  const auto& v = depth.positions;
  if (depth.kind != PrimitiveKind::triangle || cross(v[0], v[1], v[2]) == 0) return 0;
  const Interpolant f = linear(depth);
  const Interval slope = slope_of(exact_gradient(f), choice.slope);
  const Interval unit = unit_of(f, format, choice);
  return clamped(product_of(offset.factor, slope) + product_of(offset.units, unit), offset.clamp);
}

Interval permitted_fixed_unit(DepthFormat format) {
  return {std::ldexp(1.0, -bits_of(format)), 1};
}

Interval offset_permitted(const PolygonOffset& offset, const Interpolant& depth, DepthFormat format,
                          double reach, Interval fixed_unit) {
  if (depth.kind != PrimitiveKind::triangle) return 0;
  const Interpolant f = linear(depth);
  const Point place = nearest_point(depth.positions[0]);
  const Gradient gradient{differentiate_permitted(f, place, Axis::x, reach),
                          differentiate_permitted(f, place, Axis::y, reach)};
  const Interval slope = hull(largest_of(gradient), length_of(gradient, kOperationError));
  const auto inexact_product = [](float share, Interval value) {
    return widened(product_of(share, value), kOperationError);
  };
  const Interval of_slope = inexact_product(offset.factor, slope);
  const Interval unit = short_of_saturation(permitted_unit(f, format, fixed_unit), offset.units,
                                            of_slope.magnitude());
  const Interval sum = of_slope + inexact_product(offset.units, unit);
  return clamped(widened(sum, kOperationError), offset.clamp);
}

Rule offset_slope_rule() {
  return {RuleId::offset_slope,
          "The factor of a polygon's offset multiplies the slope of its depth in the window",
          "14.6.5 (depth offset)",
          "the length of the gradient, or its larger component instead (ruling 38)",
          "length",
          alternatives_of<OffsetSlope>(),
          {}};
}

Rule offset_unit_rule() {
  return {
      RuleId::offset_unit,
      "A unit of polygon offset is the smallest difference of depths that a fixed-point buffer "
      "keeps",
      "14.6.5 (depth offset)",
      "any constant of at least 2^-n, a difference that a buffer of n bits keeps (ruling 38)",
      "step",
      alternatives_of<OffsetUnit>(),
      {{38,
        "Polygon offset: permitted is clamp(factor m + units r) with any m from the larger "
        "partial derivative of depth to the length of the gradient (14.6.5). Of a "
        "fixed-point buffer of n bits r is the implementation's: any number from 2^-n, which "
        "is no more than one step, since depths that differ by r have distinct values; but "
        "it is one constant. If a renderer reports its depths, we take the r that fits as "
        "many of a case's fragments as possible, and judge all of them by it. Of a buffer of "
        "float32, r is 2^(e - 23), with e the exponent of the largest depth among the "
        "vertices. Vertices may have moved, and each operation may err, as in ruling 9. The "
        "sum of depth and offset is clamped to 0 to 1. All fragments of a triangle have one "
        "offset."},
       {kRulingOnUnclampedDepth,
        "Contested: after a polygon offset gl_FragCoord.z lies beyond 0 to 1, and would be right "
        "if it were clamped. 14.6.5 clamps depths once the offset is added, whatever the buffer, "
        "and so does OpenGL ES 3.2 (13.7.2). But 15.2.2 says of gl_FragCoord.z only that the "
        "offset is added, and drivers clamp where depths are tested. No Khronos test reads "
        "gl_FragCoord.z after an offset. What is stored is clamped."},
       {kRulingOnOneUnit,
        "In all answers of a renderer on a surface r of a fixed-point depth buffer of n bits is "
        "one constant, throughout the range of depths: what two answers show of it must have "
        "a number in common. Which number that is remains open (ruling 38)."}}};
}

Rule offset_exponent_rule() {
  return {
      RuleId::offset_exponent,
      "In a floating-point buffer a unit of polygon offset depends on the polygon's largest depth",
      "14.6.5 (depth offset)",
      "none beyond that of the vertices' depths (ruling 38)",
      "largest-depth",
      alternatives_of<OffsetExponent>(),
      {}};
}

}  // namespace edgecase
