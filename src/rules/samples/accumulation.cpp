// SPDX-License-Identifier: MIT
#include "rules/samples/accumulation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "exact/rational.h"
#include "model/rendering.h"

namespace edgecase {
namespace {

// The terms of the sum, their weights, and the divisor.
struct Terms {
  std::vector<double> values;
  std::vector<std::int64_t> weights;
  std::int64_t divisor = 0;

  std::size_t size() const { return values.size(); }
};

double clamped(double value) {
  return std::clamp(value, 0.0, 1.0);
}

Terms terms_of(std::span<const double> shown, const Supersampling& passes, Accumulation choice) {
  Terms terms;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const double value = shown[k];
    terms.values.push_back(choice == Accumulation::clamped ? clamped(value)
                           : choice == Accumulation::bytes ? to_unorm8(value) / 255.0
                                                           : value);
    terms.weights.push_back(choice == Accumulation::unweighted ? 1 : passes[k].weight);
    terms.divisor += terms.weights.back();
  }
  if (choice == Accumulation::sum) terms.divisor = 1;
  return terms;
}

// The finite number digits * 2^exponent.
struct Dyadic {
  std::int64_t digits = 0;
  int exponent = std::numeric_limits<int>::max();  // for 0: it needs no digits
};

Dyadic dyadic(double value) {
  if (value == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return {static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53};
}

double nearest_double(const Rational& value) {
  const Interval around = interval_of(value);
  if (around.low == around.high) return around.low + 0.0;
  const Rational below = value - rational_of(around.low);
  const Rational above = rational_of(around.high) - value;
  if (below != above) return (below < above ? around.low : around.high) + 0.0;
  const bool low_is_even = std::bit_cast<std::uint64_t>(around.low) % 2 == 0;
  return (low_is_even ? around.low : around.high) + 0.0;
}

double quotient_of_not_finite(const Terms& terms) {
  double sum = 0;
  for (std::size_t k = 0; k < terms.size(); ++k)
    sum += static_cast<double>(terms.weights[k]) * terms.values[k];
  return sum / static_cast<double>(terms.divisor);
}

double exact_quotient(const Terms& terms) {
  // All terms as multiples of one power of two.
  int exponent = 0;
  for (const double value : terms.values) exponent = std::min(exponent, dyadic(value).exponent);
  Integer sum = 0;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const Dyadic term = dyadic(terms.values[k]);
    if (term.digits == 0) continue;
    const Int128 weighted = Int128{term.digits} * terms.weights[k];
    sum += Integer(integer_of(weighted) << (term.exponent - exponent));
  }
  Integer divisor = terms.divisor;
  divisor <<= -exponent;
  return nearest_double(Rational(sum, divisor));
}

// In single precision throughout; a weight is at most 2^20.
double in_single_precision(std::span<const double> shown, const Supersampling& passes) {
  float sum = 0;
  std::int64_t total = 0;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const float product = static_cast<float>(shown[k]) * static_cast<float>(passes[k].weight);
    sum += product;
    total += passes[k].weight;
  }
  return static_cast<double>(sum / static_cast<float>(total));
}

}  // namespace

double accumulated(std::span<const double> shown, const Supersampling& passes,
                   Accumulation choice) {
  if (choice == Accumulation::float32_sum) return in_single_precision(shown, passes);
  // Most pixels lie within one primitive.
  const bool alike = std::ranges::count(shown, shown.front()) == std::ssize(shown);
  if (alike && choice == Accumulation::exact_mean) return shown.front() + 0.0;
  const Terms terms = terms_of(shown, passes, choice);
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(terms.values, is_finite)) return quotient_of_not_finite(terms);
  return exact_quotient(terms);
}

Interval accumulation_permitted(std::span<const double> shown, const Supersampling& passes,
                                Accumulation choice) {
  constexpr double kUnit = 0x1p-23;
  constexpr double kSmallest = 0x1p-126;
  const auto is_finite = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(shown, is_finite)) return Interval::everything();
  const Terms terms = terms_of(shown, passes, choice);
  Interval sum;
  Interval magnitude;
  Interval weights;
  for (std::size_t k = 0; k < terms.size(); ++k) {
    const Interval weight = static_cast<double>(terms.weights[k]);
    sum = sum + weight * terms.values[k];
    magnitude = magnitude + weight * std::fabs(terms.values[k]);
    weights = weights + weight;
  }
  const auto count = static_cast<double>(terms.size());
  const Interval roundings = Interval((count + 5) * kUnit);
  const Interval growth = roundings / (Interval(1) - roundings);
  const Interval divisor = static_cast<double>(terms.divisor);
  if ((magnitude * (growth + 1)).high > static_cast<double>(std::numeric_limits<float>::max()))
    return Interval::everything();
  const Interval flushed =
      Interval(2 * kSmallest) * (weights + Interval(2 * count) + divisor) / divisor;
  const double margin = (growth * magnitude / divisor + flushed).high;
  return sum / divisor + Interval(-margin, margin);
}

Rule accumulation_rule() {
  return {RuleId::supersample_accumulation,
          "A supersampled pixel is the weighted mean of its passes",
          "17.3.6 (blending); that a pixel is such a mean is our own definition, "
          "src/model/sampling.h",
          "the rounding of single precision (ruling 36); the exact mean is preferred",
          "exact-mean",
          alternatives_of<Accumulation>(),
          {{36,
            "The accumulated image of a supersampled scene, before conversion to 8 bits: the "
            "mean of what the renderer's own passes show at a pixel, each times its weight, if "
            "the renderer reports those colours, or else of any colours that ruling 9 permits. "
            "With n passes, each term may be off by n + 5 roundings of one unit in the last "
            "place of float32: one multiplication, n additions, the sum of weights, and a "
            "division of at most 2.5 units (GLSL 4.60, 4.7.1; GL 4.6 core, 17.3.6); and numbers "
            "below 2^-126 may be flushed to 0. Where a colour is not finite, or a sum overflows, "
            "any number is permitted."}}};
}

}  // namespace edgecase
