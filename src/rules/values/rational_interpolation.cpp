// SPDX-License-Identifier: MIT
#include "rules/values/rational_interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rules/values/weighted_mean.h"

namespace edgecase {
namespace {

using boost::multiprecision::abs;
using boost::multiprecision::gcd;
using boost::multiprecision::lcm;

// A linear form in the homogeneous coordinates x, y and w of the sample.
struct LinearForm {
  std::array<Rational, 3> coefficients{};

  LinearForm() = default;
  LinearForm(const Rational& constant) : LinearForm(0, 0, constant) {}  // NOLINT: a number is one
  LinearForm(const Rational& x, const Rational& y, const Rational& w) : coefficients{x, y, w} {}

  friend LinearForm operator+(LinearForm a, const LinearForm& b) {
    for (std::size_t i = 0; i < 3; ++i) a.coefficients[i] += b.coefficients[i];
    return a;
  }
  friend LinearForm operator-(LinearForm a, const LinearForm& b) {
    for (std::size_t i = 0; i < 3; ++i) a.coefficients[i] -= b.coefficients[i];
    return a;
  }
  friend LinearForm operator*(LinearForm a, const Rational& factor) {
    for (Rational& coefficient : a.coefficients) coefficient *= factor;
    return a;
  }
  friend LinearForm operator/(LinearForm a, const Rational& divisor) {
    for (Rational& coefficient : a.coefficients) coefficient /= divisor;
    return a;
  }
};

bool are_single(const Interpolant& f, const std::array<Interval, 3>& numbers) {
  return std::all_of(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count_of(f)),
                     [](Interval v) { return v.low == v.high && std::isfinite(v.low); });
}

using SixIntegers = std::array<Integer, 6>;

std::array<Rational, 3> rationals_of(const Interpolant& f, const std::array<Interval, 3>& numbers) {
  std::array<Rational, 3> rationals;
  for (std::size_t i = 0; i < count_of(f); ++i) rationals[i] = rational_of(numbers[i].low);
  return rationals;
}

// Of the rows a, b and the sample: positive to the left of a -> b.
LinearForm determinant(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  return {rational_of(cross(a, b, {1, 0, 0})), rational_of(cross(a, b, {0, 1, 0})),
          rational_of(cross(a, b, {0, 0, 1}))};
}

WeightsOf<LinearForm> weights_of(const Interpolant& f) {
  if (f.kind == PrimitiveKind::triangle)
    return triangle_weights<Rational>(f.positions, determinant);
  const auto place_of = [](const HomogeneousPoint& p) {
    return std::array{Rational(Integer(p.x), Integer(p.w)), Rational(Integer(p.y), Integer(p.w))};
  };
  return line_weights(
      kOwnOperators, f,
      std::array{place_of(f.positions[0]), place_of(f.positions[1]), std::array<Rational, 2>{}},
      std::array{LinearForm(1, 0, 0), LinearForm(0, 1, 0)});
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
  LinearForm above, below;
  if (f.kind == PrimitiveKind::point || is_constant(f)) {
    above = rational_of(f.values[0].low);
    below = Rational(1);
  } else {
    if (!has_extent(f)) return std::nullopt;
    WeightsOf<LinearForm> weights = weights_of(f);
    if (has_perspective(f))
      weights = divided_by_w(kOwnOperators, weights, rationals_of(f, f.w), count_of(f));
    above = weighted_sum(kOwnOperators, weights, rationals_of(f, f.values), count_of(f));
    below = add_weights(kOwnOperators, weights[0], weights, 1, count_of(f));
  }
  const auto& a = above.coefficients;
  const auto& b = below.coefficients;
  // The sample's w is 2^16.
  const SixIntegers whole =
      reduced({a[0], a[1], a[2] * Fixed::kOne, b[0], b[1], b[2] * Fixed::kOne});
  RationalInterpolation result;
  result.above_ = {whole[0], whole[1], whole[2]};
  result.below_ = {whole[3], whole[4], whole[5]};
  result.machine_above_ = small(result.above_);
  result.machine_below_ = small(result.below_);
  return result;
}

std::optional<RationalInterpolation::MachineForm> RationalInterpolation::small(
    const Form<Integer>& form) {
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
