// SPDX-License-Identifier: MIT
//
// Means of stored numbers with whole weights: computed exactly, rounded once to what the format
// stores.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "rules/textures/mip_chain.h"

namespace edgecase {

// A number as a texture stores it, and its weight, more than 0. The weights of a mean sum to at
// most 2^20, so that its sums are exact in 64 bits, and its products of float32 numbers in doubles.
struct WeightedNumber {
  float value;
  std::int64_t weight;
};
using WeightedNumbers = std::span<const WeightedNumber>;

// Of codes, which are clamped to 0 to 255: the rounded code.
float mean_of_codes(WeightedNumbers numbers, MipmapRounding rounding);

// The weights of two neighbours, 0 or more.
using TwoWeights = std::array<int, 2>;

// Of the four codes of two rows, as a filter of 8 bits takes it: weights are put on the nearest
// multiple of 1/256, a tie on the even one; each row's mean is rounded to a code and then the mean
// of both, a tie upwards.
float mean_of_rows(const std::array<float, 4>& codes, TwoWeights columns, TwoWeights rows);

// Of sRGB codes: the code of the mean of their linear numbers. "To the nearest" is meant of codes:
// the mean is compared with what lies halfway between two of them in the code.
float mean_of_srgb(WeightedNumbers numbers, MipmapRounding rounding);

// Of float32 numbers, rounded to one; at most 9. `down` is towards minus infinity. With infinite
// numbers, or such that are none: as IEEE 754 has it.
float mean_of_floats(WeightedNumbers numbers, MipmapRounding rounding);

}  // namespace edgecase
