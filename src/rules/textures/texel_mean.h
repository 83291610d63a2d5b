// SPDX-License-Identifier: MIT
//
// Means of stored numbers with whole weights: computed exactly, rounded once to the stored format.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rules/textures/mip_chain.h"

namespace edgecase {

// A number in a texture's format, and its weight, more than 0. The weights of a mean sum to at most
// 2^20, so its sums are exact in 64 bits, and its products of float32 numbers in doubles.
struct WeightedNumber {
  float value;
  std::int64_t weight;
};
using WeightedNumbers = std::span<const WeightedNumber>;

// For codes, which are clamped to 0 to 255: the rounded code.
float mean_of_codes(WeightedNumbers numbers, MipmapRounding rounding);

// The weights of two neighbours, 0 or more.
using TwoWeights = std::array<int, 2>;

// For the four codes of two rows, by a filter of 8 bits: weights are rounded to the nearest
// multiple of 1/256, a tie to the even one; each row's mean is rounded to a code and then the mean
// of both, a tie upwards.
float mean_of_rows(const std::array<float, 4>& codes, TwoWeights columns, TwoWeights rows);

// For sRGB codes: the code of the mean of their linear numbers. "To the nearest" refers to codes:
// the mean is compared with the middle of two neighbours in the code.
float mean_of_srgb(WeightedNumbers numbers, MipmapRounding rounding);

// For at most 9 float32 numbers, rounded to one. `down` is towards minus infinity. Infinities and
// NaN follow IEEE 754.
float mean_of_floats(WeightedNumbers numbers, MipmapRounding rounding);

}  // namespace edgecase
