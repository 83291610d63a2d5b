// SPDX-License-Identifier: MIT
#include "rules/values/rational_interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace edgecase {
namespace {

using boost::multiprecision::abs;
using boost::multiprecision::gcd;
using boost::multiprecision::lcm;

// The coefficients of a linear form in the homogeneous coordinates x, y and w of the sample.
using Coefficients = std::array<Rational, 3>;

std::size_t count_of(const Interpolant& f) {
  return static_cast<std::size_t>(vertices_of(f.kind));
}

bool are_single(const Interpolant& f, const std::array<Interval, 3>& numbers) {
  return std::all_of(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count_of(f)),
                     [](Interval v) { return v.low == v.high && std::isfinite(v.low); });
}

// The determinant of the rows a, b and the sample: positive to the left of a -> b.
Coefficients side_of(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  return {rational_of(cross(a, b, {1, 0, 0})), rational_of(cross(a, b, {0, 1, 0})),
          rational_of(cross(a, b, {0, 0, 1}))};
}

using Weights = std::array<Coefficients, 3>;
using SixIntegers = std::array<Integer, 6>;

Weights triangle_weights(const Interpolant& f) {
  const auto& v = f.positions;
  Weights weights;
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = side_of(v[(i + 1) % 3], v[(i + 2) % 3]);
    for (Rational& coefficient : weights[i]) coefficient *= v[i].w;
  }
  return weights;
}

// t = (p - a).(b - a), or its like along the major axis alone, and |b - a|^2 - t.
Weights line_weights(const Interpolant& f) {
  const auto divided = [](std::int64_t coordinate, std::int64_t w) {
    return Rational(Integer(coordinate), Integer(w));
  };
  const HomogeneousPoint& a = f.positions[0];
  const HomogeneousPoint& b = f.positions[1];
  Rational run_x = divided(b.x, b.w) - divided(a.x, a.w);
  Rational run_y = divided(b.y, b.w) - divided(a.y, a.w);
  const Rational whole_x = run_x, whole_y = run_y;
  if (f.line_parameter != LineParameter::projection) (goes_by_x(f) ? run_y : run_x) = 0;
  const Rational length = run_x * whole_x + run_y * whole_y;
  const Rational start = divided(a.x, a.w) * run_x + divided(a.y, a.w) * run_y;
  return {Coefficients{-run_x, -run_y, length + start}, Coefficients{run_x, run_y, -start},
          Coefficients{}};
}

// Six coefficients, scaled to integers without a common factor.
SixIntegers reduced(const std::array<Rational, 6>& given) {
  Integer multiple = 1;
  for (const Rational& value : given) multiple = lcm(multiple, denominator(value));
  std::array<Integer, 6> result;
  Integer divisor = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    result[i] = numerator(given[i]) * (multiple / denominator(given[i]));
    divisor = gcd(divisor, result[i]);
  }
  for (Integer& value : result) value /= divisor;
  return result;
}

Point centre_of(PixelPosition pixel) {
  return pixel_centre(pixel.x, pixel.y);
}

}  // namespace

std::optional<RationalInterpolation> RationalInterpolation::of(const Interpolant& f) {
  if (!are_single(f, f.values) || !are_single(f, f.w)) return std::nullopt;
  std::array<Rational, 6> sums{};  // of the numerator's x, y, w and the denominator's
  if (f.kind == PrimitiveKind::point || is_constant(f)) {
    sums[2] = rational_of(f.values[0].low);
    sums[5] = 1;
  } else {
    if (!has_extent(f)) return std::nullopt;
    const auto weights = f.kind == PrimitiveKind::line ? line_weights(f) : triangle_weights(f);
    const bool divides = has_perspective(f);
    for (std::size_t i = 0; i < count_of(f); ++i) {
      const Rational value = rational_of(f.values[i].low);
      for (std::size_t c = 0; c < 3; ++c) {
        const Rational weight =
            divides ? Rational(weights[i][c] / rational_of(f.w[i].low)) : weights[i][c];
        sums[c] += weight * value;
        sums[3 + c] += weight;
      }
    }
  }
  // The sample's w is 2^16.
  sums[2] *= Fixed::kOne;
  sums[5] *= Fixed::kOne;
  std::array<Integer, 6> whole = reduced(sums);
  RationalInterpolation result;
  result.above_ = {whole[0], whole[1], whole[2]};
  result.below_ = {whole[3], whole[4], whole[5]};
  result.machine_above_ = MachineForm::of(result.above_);
  result.machine_below_ = MachineForm::of(result.below_);
  return result;
}

std::optional<RationalInterpolation::MachineForm> RationalInterpolation::MachineForm::of(
    const Form& form) {
  const Integer most =
      std::max({Integer(abs(form.x)), Integer(abs(form.y)), Integer(abs(form.one))});
  if (most != 0 && msb(most) >= 62) return std::nullopt;
  return MachineForm{static_cast<Int128>(form.x), static_cast<Int128>(form.y),
                     static_cast<Int128>(form.one)};
}

std::optional<MachineQuotient> RationalInterpolation::quotient_at(Point sample) const {
  if (!machine_above_ || !machine_below_) return std::nullopt;
  const Int128 below = machine_below_->at(sample);
  if (below == 0) return std::nullopt;
  const Int128 above = machine_above_->at(sample);
  const MachineQuotient result{below < 0 ? -above : above, below < 0 ? -below : below};
  return result.is_small() ? std::optional(result) : std::nullopt;
}

std::optional<Rational> RationalInterpolation::at(Point sample) const {
  const Integer below = below_.at(sample);
  if (below == 0) return std::nullopt;
  return quotient_of(above_.at(sample), below);
}

// For the quotient N / D, with N and D linear: (N' D - N D') / D^2.
Rational RationalInterpolation::slope(Point sample, Axis axis, const Integer& below) const {
  const bool along_x = axis == Axis::x;
  const Integer rise = along_x ? above_.x : above_.y;
  const Integer growth = along_x ? below_.x : below_.y;
  return Rational((rise * below - above_.at(sample) * growth) * Fixed::kOne, below * below);
}

std::optional<Rational> RationalInterpolation::derivative(const QuadPixel& pixel, Axis axis,
                                                          DerivativeMethod method) const {
  // For a value that is linear in the window, all methods yield one number.
  const bool is_linear = below_.x == 0 && below_.y == 0;
  if (method == DerivativeMethod::analytic || is_linear) {
    const Point sample = centre_of(pixel.pixel);
    const Integer below = below_.at(sample);
    if (below == 0) return std::nullopt;
    return slope(sample, axis, below);
  }
  const Neighbours of = neighbours_of(pixel, axis, method);
  const auto first = at(centre_of(of.first));
  const auto second = at(centre_of(of.second));
  if (!first || !second) return std::nullopt;
  return Rational(*second - *first);
}

std::optional<Rational> interpolate_rational(const Interpolant& interpolant, Point sample) {
  const auto rational = RationalInterpolation::of(interpolant);
  return rational ? rational->at(sample) : std::nullopt;
}

std::optional<Rational> derivative_rational(const Interpolant& interpolant, const QuadPixel& at,
                                            Axis axis, DerivativeMethod method) {
  const auto rational = RationalInterpolation::of(interpolant);
  return rational ? rational->derivative(at, axis, method) : std::nullopt;
}

}  // namespace edgecase
