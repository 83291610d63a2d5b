// SPDX-License-Identifier: MIT
#include "rules/output/exact_blend.h"

#include <algorithm>
#include <cmath>

#include "exact/interval.h"
#include "exact/rational.h"
#include "rules/output/blend_formula.h"

namespace edgecase {
namespace {

double unit_clamped(double value) {
  return std::clamp(value, 0.0, 1.0);
}

// `number`: makes one of a double, `code`: one of an 8-bit value.
template <class Number, class FromDouble, class FromCode>
BlendOperands<Number> operands_of(const std::array<double, 4>& source,
                                  const std::array<std::uint8_t, 4>& destination,
                                  const std::array<float, 4>& constant, FromDouble number,
                                  FromCode code) {
  BlendOperands<Number> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result.source[i] = number(unit_clamped(source[i]));
    result.destination[i] = code(destination[i]);
    result.constant[i] = number(unit_clamped(static_cast<double>(constant[i])));
  }
  result.one = 1;
  return result;
}

// Of a number close to a border between two codes, so that nothing is left to be clamped.
std::uint8_t nearest_code(const Rational& value) {
  const Rational scaled = value * 255;
  const Integer below = floor_of(scaled);
  const Rational rest = scaled - below;
  const Rational half(1, 2);
  const bool is_odd = (below & 1) != 0;
  const bool is_up = rest > half || (rest == half && is_odd);
  return static_cast<std::uint8_t>(static_cast<int>(below) + (is_up ? 1 : 0));
}

}  // namespace

std::uint8_t exactly_blended(const BlendTerm& term, const std::array<double, 4>& source,
                             const std::array<std::uint8_t, 4>& destination,
                             const std::array<float, 4>& constant, std::size_t component) {
  const Interval result =
      blended(term,
              operands_of<Interval>(
                  source, destination, constant, [](double value) { return Interval(value); },
                  [](int code) { return Interval(code) / 255; }),
              component) *
      255;
  const double low = std::nearbyint(std::clamp(result.low, 0.0, 255.0));
  const double high = std::nearbyint(std::clamp(result.high, 0.0, 255.0));
  if (low == high) return static_cast<std::uint8_t>(low);
  return nearest_code(
      blended(term,
              operands_of<Rational>(
                  source, destination, constant, [](double value) { return rational_of(value); },
                  [](int code) { return Rational(code, 255); }),
              component));
}

}  // namespace edgecase
