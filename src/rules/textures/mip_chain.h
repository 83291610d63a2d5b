// SPDX-License-Identifier: MIT
//
// Mip chains: images of half the size, each made from the one before (GL 4.6 core, 8.14.3 and
// 8.14.4). OpenGL fixes the number of levels and their sizes. It leaves the filter open.
//
//   levels     floor(log2(larger side of level 0)) + 1
//   level k    each side is max(1, floor(side of level 0 / 2^k))
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "model/texture.h"
#include "rules/rule.h"

namespace edgecase {

Rule level_count_rule();      // mipmap.level-count
Rule mipmap_filter_rule();    // mipmap.filter
Rule mipmap_rounding_rule();  // mipmap.rounding
Rule mipmap_srgb_rule();      // mipmap.srgb: linear or codes, see MipmapMethod
inline constexpr int kRulingOnMipHull = 48;

enum class LevelCount {
  larger_side,   // down to 1x1: OpenGL
  smaller_side,  // until the smaller side is 1: from a course
};
template <>
inline constexpr auto kNames<LevelCount> = std::to_array<TabledAlternative<LevelCount>>(
    {{LevelCount::larger_side, "larger-side", Openness::mandated,
      "each level halves both sides, rounded down and at least 1, until both are 1"},
     {LevelCount::smaller_side, "smaller-side", Openness::illegal,
      "the chain ends where the smaller side is 1"}});

enum class MipmapFilter {
  box,              // texels 2i and 2i + 1 along each axis; the last of an odd size is left out
  bilinear_centre,  // a linear lookup at the destination texel's centre, which is the box of even
                    // sizes; of odd ones it lies between
  nearest,          // texel 2i
};
template <>
inline constexpr auto kNames<MipmapFilter> = std::to_array<TabledAlternative<MipmapFilter>>(
    {{MipmapFilter::box, "box", Openness::open,
      "the mean of texels 2i and 2i + 1 along each axis; the last of an odd size is left out"},
     {MipmapFilter::bilinear_centre, "bilinear-centre", Openness::open,
      "a linear lookup at the smaller texel's centre; for even sizes it is the box"},
     {MipmapFilter::nearest, "nearest", Openness::open, "texel 2i along each axis"}});

enum class MipmapRounding {
  nearest_even,
  half_up,
  down,
  half_up_by_rows,  // of codes: each row's mean by itself, then the mean of both, with weights of 8
                    // bits; sRGB texels in linear light, and floats, as nearest_even
};
template <>
inline constexpr auto kNames<MipmapRounding> = std::to_array<TabledAlternative<MipmapRounding>>(
    {{MipmapRounding::nearest_even, "nearest-even", Openness::open,
      "to the nearest value, a tie to the even one"},
     {MipmapRounding::half_up, "half-up", Openness::open,
      "to the nearest value, a tie to the larger one"},
     {MipmapRounding::down, "down", Openness::open, "to the largest value that is not above"},
     {MipmapRounding::half_up_by_rows, "half-up-by-rows", Openness::open,
      "for codes of 8 bits, each row's mean with weights in multiples of 1/256, then the mean of "
      "both rows, a tie to the larger value; for others, nearest-even"}});

int levels_of_chain(int width, int height, LevelCount choice);

enum class MipmapSrgb { linear, codes };
template <>
inline constexpr auto kNames<MipmapSrgb> = std::to_array<TabledAlternative<MipmapSrgb>>(
    {{MipmapSrgb::linear, "linear", Openness::open, "decoded, averaged and encoded again"},
     {MipmapSrgb::codes, "codes", Openness::open, "averaged as they are stored"}});

// The next smaller image.
struct MipmapMethod {
  MipmapFilter filter = MipmapFilter::box;
  MipmapRounding rounding = MipmapRounding::nearest_even;
  MipmapSrgb srgb = MipmapSrgb::linear;  // texels of that format

  friend bool operator==(const MipmapMethod&, const MipmapMethod&) = default;
};
TextureLevel reduced(const TextureLevel& level, TextureFormat format, const MipmapMethod& method);

// Level 0 and all levels that follow.
std::vector<TextureLevel> mip_chain(const TextureLevel& base, TextureFormat format,
                                    LevelCount count, const MipmapMethod& method);

// Means of stored numbers with whole weights: computed exactly, rounded once to the stored format.

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
