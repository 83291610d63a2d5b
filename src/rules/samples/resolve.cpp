// SPDX-License-Identifier: MIT
#include "rules/samples/resolve.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "exact/rational.h"
#include "model/rendering.h"

namespace edgecase {
namespace {

int sum_of(std::span<const std::uint8_t> samples) {
  int sum = 0;
  for (const int value : samples) sum += value;
  return sum;
}

int nearest_even(int sum, int count) {
  const int below = sum / count;
  const int twice_rest = 2 * (sum % count);
  if (twice_rest == count) return below + below % 2;
  return below + (twice_rest > count ? 1 : 0);
}

// A last sample without a partner stays as it is.
int by_pairs(std::span<const std::uint8_t> samples) {
  std::vector<int> values(samples.begin(), samples.end());
  while (values.size() > 1) {
    std::vector<int> means;
    for (std::size_t i = 0; i + 1 < values.size(); i += 2)
      means.push_back((values[i] + values[i + 1] + 1) / 2);
    if (values.size() % 2 == 1) means.push_back(values.back());
    values = std::move(means);
  }
  return values[0];
}

int in_single_precision(std::span<const std::uint8_t> samples) {
  constexpr float kStep = 1.0F / 255;
  float sum = 0;
  for (const int value : samples) sum += static_cast<float>(value) * kStep;
  const float mean = sum * (1.0F / static_cast<float>(samples.size()));
  return static_cast<int>(std::nearbyint(mean * 255.0F));
}

}  // namespace

std::uint8_t resolved(std::span<const std::uint8_t> samples, ResolveMethod method) {
  const int count = static_cast<int>(samples.size());
  const int sum = sum_of(samples);
  const auto value = [&] {
    switch (method) {
      case ResolveMethod::nearest_even:
        return nearest_even(sum, count);
      case ResolveMethod::half_up:
        return (2 * sum + count) / (2 * count);
      case ResolveMethod::truncated:
        return sum / count;
      case ResolveMethod::half_up_by_pairs:
        return by_pairs(samples);
      case ResolveMethod::float32_sum:
        return in_single_precision(samples);
      case ResolveMethod::first_sample:
        return static_cast<int>(samples[0]);
    }
    return 0;
  };
  return static_cast<std::uint8_t>(value());
}

ResolvedRange resolve_permitted(std::span<const std::uint8_t> samples) {
  const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
  return {*low - kResolveMargin, *high + kResolveMargin};
}

Rule resolve_rule() {
  return {
      RuleId::sample_resolve,
      "A resolved pixel is the mean of its samples",
      "18.3.1 (blitting pixel rectangles)",
      "any way to make one value of the samples (ruling 31)",
      "nearest-even",
      alternatives_of<ResolveMethod>(),
      {{31,
        "The specification leaves it to the implementation how the colours of samples become one "
        "(18.3.1). Each component may have a value from the least to the greatest of the samples "
        "of the pixel and its neighbours, since filters wider than a pixel exist, and 12 codes "
        "beyond, which the Khronos tests accept. The samples are those that the renderer "
        "reports, or else those that rulings 27 to 33 permit."},
       {kRulingBeyondSamples,
        "A resolved colour more than 12 codes below the least or above the greatest of the samples "
        "of the pixel and its neighbours is not made of the samples: 18.3.1 leaves open how they "
        "are resolved, and not that they are. The Khronos tests (dEQP-GLES3.functional.fbo.msaa.*) "
        "accept 12 codes, and nobody accepts more."}}};
}

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
    assert(0 < passes[k].weight && passes[k].weight <= 1 << 20);
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
