// SPDX-License-Identifier: MIT
#include "rules/samples/resolve.h"

#include <algorithm>
#include <cmath>
#include <vector>

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
       {51,
        "A resolved colour beyond that is contested: the letter allows it, and the Khronos tests "
        "do not."}}};
}

}  // namespace edgecase
