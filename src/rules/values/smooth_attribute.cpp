// SPDX-License-Identifier: MIT
#include "rules/values/smooth_attribute.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace edgecase {
namespace {

// The floating-point clause: relative error that one operation may have.
constexpr double kOperationError = 1e-5;

using Positions = std::array<std::array<Interval, 2>, 3>;

// Arithmetic in which every result may be off by a relative amount.
struct Inexact {
  double relative;
  Interval add(Interval a, Interval b) const { return widened(a + b, relative); }
  Interval subtract(Interval a, Interval b) const { return widened(a - b, relative); }
  Interval multiply(Interval a, Interval b) const { return widened(a * b, relative); }
  Interval divide(Interval a, Interval b) const { return widened(a / b, relative); }
};

Interval from_integer(std::int64_t value) {
  const auto nearest = static_cast<double>(value);
  if (std::fabs(nearest) <= 0x1p53) return nearest;
  return {std::nextafter(nearest, -HUGE_VAL), std::nextafter(nearest, HUGE_VAL)};
}

Interval exact_on_triangle(const Interpolant& f, Point p) {
  const auto& v = f.positions;
  const std::int64_t area = cross(v[0], v[1], v[2]);
  if (area == 0) return Interval::everything();
  const Interval sum = from_integer(cross(v[1], v[2], p)) * f.values[0] +
                       from_integer(cross(v[2], v[0], p)) * f.values[1] +
                       from_integer(cross(v[0], v[1], p)) * f.values[2];
  return sum / from_integer(area);
}

Interval exact_on_line(const Interpolant& f, Point p) {
  const std::int64_t dx = f.positions[1].x.raw() - f.positions[0].x.raw();
  const std::int64_t dy = f.positions[1].y.raw() - f.positions[0].y.raw();
  if (dx == 0 && dy == 0) return Interval::everything();
  const std::int64_t px = p.x.raw() - f.positions[0].x.raw();
  const std::int64_t py = p.y.raw() - f.positions[0].y.raw();
  const bool x_major = std::abs(dx) >= std::abs(dy);
  const Interval t = f.line_parameter == LineParameter::projection
                         ? from_integer(px * dx + py * dy) / from_integer(dx * dx + dy * dy)
                         : from_integer(x_major ? px : py) / from_integer(x_major ? dx : dy);
  return Interval(f.values[0]) + t * (Interval(f.values[1]) - f.values[0]);
}

Interval area_of(const Inexact& op, const Positions& v, std::size_t i, std::size_t j,
                 const std::array<Interval, 2>& p) {
  const Interval ax = op.subtract(v[i][0], p[0]);
  const Interval ay = op.subtract(v[i][1], p[1]);
  const Interval bx = op.subtract(v[j][0], p[0]);
  const Interval by = op.subtract(v[j][1], p[1]);
  return op.subtract(op.multiply(ax, by), op.multiply(ay, bx));
}

Interval inexact_on_triangle(const Inexact& op, const Interpolant& f, const Positions& v,
                             const std::array<Interval, 2>& p) {
  const Interval w[3] = {area_of(op, v, 1, 2, p), area_of(op, v, 2, 0, p), area_of(op, v, 0, 1, p)};
  const Interval area = area_of(op, v, 1, 2, v[0]);
  Interval sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    sum = op.add(sum, op.multiply(op.divide(w[i], area), f.values[i]));
  return sum;
}

Interval inexact_on_line(const Inexact& op, const Interpolant& f, const Positions& v,
                         const std::array<Interval, 2>& p) {
  const Interval dx = op.subtract(v[1][0], v[0][0]);
  const Interval dy = op.subtract(v[1][1], v[0][1]);
  if (f.line_parameter == LineParameter::major_axis) {
    const std::size_t major = dx.magnitude() >= dy.magnitude() ? 0 : 1;
    const Interval t = op.divide(op.subtract(p[major], v[0][major]), major == 0 ? dx : dy);
    return op.add(f.values[0], op.multiply(t, op.subtract(f.values[1], f.values[0])));
  }
  const Interval along = op.add(op.multiply(op.subtract(p[0], v[0][0]), dx),
                                op.multiply(op.subtract(p[1], v[0][1]), dy));
  const Interval length = op.add(op.multiply(dx, dx), op.multiply(dy, dy));
  const Interval t = op.divide(along, length);
  return op.add(f.values[0], op.multiply(t, op.subtract(f.values[1], f.values[0])));
}

// The value with every vertex moved to one corner of its square of moves: each weight is monotonic
// in each coordinate while the area keeps its sign, so the extremes lie at corners.
Interval over_corners(const Inexact& op, const Interpolant& f, Point sample, double step) {
  const std::array<Interval, 2> p{sample.x.to_double(), sample.y.to_double()};
  Interval result = inexact_on_triangle(
      op, f,
      [&] {
        Positions v;
        for (std::size_t i = 0; i < 3; ++i)
          v[i] = {f.positions[i].x.to_double(), f.positions[i].y.to_double()};
        return v;
      }(),
      p);
  const std::int64_t area = cross(f.positions[0], f.positions[1], f.positions[2]);
  for (unsigned corner = 0; corner < 64; ++corner) {
    Positions v;
    for (unsigned i = 0; i < 3; ++i) {
      v[i][0] = f.positions[i].x.to_double() + ((corner >> (2 * i) & 1u) != 0 ? step : -step);
      v[i][1] = f.positions[i].y.to_double() + ((corner >> (2 * i + 1) & 1u) != 0 ? step : -step);
    }
    const Interval moved = area_of({0}, v, 1, 2, v[0]);
    if (moved.low <= 0 && area > 0) return Interval::everything();
    if (moved.high >= 0 && area < 0) return Interval::everything();
    result = hull(result, inexact_on_triangle(op, f, v, p));
  }
  return result;
}

Positions grown(const Interpolant& f, double step) {
  Positions v;
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = f.positions[i].x.to_double();
    const double y = f.positions[i].y.to_double();
    v[i] = {Interval(x - step, x + step), Interval(y - step, y + step)};
  }
  return v;
}

}  // namespace

Interval interpolate_exact(const Interpolant& f, Point sample) {
  // A constant stays constant to the bit, wherever the sample lies.
  const auto count = static_cast<std::size_t>(vertices_of(f.kind));
  if (std::all_of(f.values.begin(), f.values.begin() + static_cast<std::ptrdiff_t>(count),
                  [&](double value) { return value == f.values[0]; }))
    return f.values[0];
  switch (f.kind) {
    case PrimitiveKind::point:
      return f.values[0];
    case PrimitiveKind::line:
      return exact_on_line(f, sample);
    case PrimitiveKind::triangle:
      return exact_on_triangle(f, sample);
  }
  return Interval::everything();
}

Interval interpolate_permitted(const Interpolant& f, Point sample, int bits) {
  const Inexact op{kOperationError};
  const double step = std::ldexp(1.0, -bits);
  switch (f.kind) {
    case PrimitiveKind::point:
      return f.values[0];
    case PrimitiveKind::line:
      return inexact_on_line(op, f, grown(f, step), {sample.x.to_double(), sample.y.to_double()});
    case PrimitiveKind::triangle:
      return over_corners(op, f, sample, step);
  }
  return Interval::everything();
}

Rule smooth_attribute_rule() {
  Rule rule;
  rule.id = "attribute.smooth";
  rule.title = "A smooth attribute is interpolated linearly between the vertices";
  rule.spec = "14.5.1 and 14.6.1, with the floating-point clause of 2.3";
  rule.latitude =
      "about 1 part in 10^5 per operation; vertices may have been moved to the sub-pixel grid";
  rule.standard = "projection";
  rule.alternatives = {
      {"projection", Openness::mandated,
       "along a line by the sample's projection onto it, t = (p - a).(b - a) / |b - a|^2"},
      {"major-axis", Openness::illegal,
       "along a line by the sample's coordinate on the major axis alone; Vulkan allows it, "
       "OpenGL's text does not"}};
  rule.rulings = {
      {9,
       "Smooth attributes and depth: permitted is what the interpolation formula yields when every "
       "operation may err by 1 part in 10^5 and every vertex may have moved by less than 2^-b (b "
       "as "
       "in ruling 4). Equal to the correctly rounded exact value is agreement."},
      {13,
       "Attributes across a wide line: the text does not say whether the fragments of a column "
       "share "
       "the value of the fragment that they replicate or have that of their own centres. Exact "
       "takes "
       "their own; permitted is what any fragment of such a column may have."}};
  return rule;
}

Rule depth_rule() {
  return {"fragment.depth",
          "A fragment's depth is interpolated linearly in window space",
          "14.5.1 and 14.6.1, with the floating-point clause of 2.3",
          "as for smooth attributes (ruling 9)",
          "",
          {},
          {}};
}

}  // namespace edgecase
