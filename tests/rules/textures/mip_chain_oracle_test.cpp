// SPDX-License-Identifier: MIT
//
// Reductions, held against literal ones: lookups in rationals, and sRGB in 50 digits.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "rules/textures/mip_chain.h"
#include "tests/rules/textures/texels.h"
#include "tests/support/causes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;

// The texels of one axis that make texel i, and their weights.
std::array<LiteralTap, 2> taps_by_definition(int i, int size, MipmapFilter filter) {
  if (size == 1) return {LiteralTap{0, 1}, LiteralTap{0, 0}};
  const int halved = size / 2;
  switch (filter) {
    case MipmapFilter::box:
      return {LiteralTap{2 * i, Rational(1, 2)}, LiteralTap{2 * i + 1, Rational(1, 2)}};
    case MipmapFilter::bilinear_centre:
      return literal_taps(Rational(2 * i + 1, 2 * halved), size, Wrap::clamp_to_edge,
                          Filter::linear);
    case MipmapFilter::nearest:
      return {LiteralTap{2 * i, 1}, LiteralTap{0, 0}};
  }
  return {};
}

struct Weighted {
  float value;
  Rational weight;
};

std::vector<Weighted> weighted(const TextureLevel& level, int i, int j, std::size_t component,
                               MipmapFilter filter) {
  std::vector<Weighted> result;
  for (const LiteralTap& row : taps_by_definition(j, level.height, filter))
    for (const LiteralTap& column : taps_by_definition(i, level.width, filter))
      result.push_back({level.texels[level.index(column.texel, row.texel) + component],
                        row.weight * column.weight});
  return result;
}

Rational mean_of(const std::vector<Weighted>& texels) {
  Rational mean = 0;
  for (const auto& [value, weight] : texels) mean += weight * Rational(static_cast<double>(value));
  return mean;
}

// The same of 8-bit steps, as drivers take it that filter in 8 bits.
float mean_by_rows(const TextureLevel& level, int i, int j, std::size_t component,
                   MipmapFilter filter) {
  const auto columns = taps_by_definition(i, level.width, filter);
  const auto rows = taps_by_definition(j, level.height, filter);
  const auto code = [&](const LiteralTap& column, const LiteralTap& row) {
    return static_cast<int>(level.texels[level.index(column.texel, row.texel) + component]);
  };
  const auto share = [](const LiteralTap& tap) {
    const Rational steps = tap.weight * 256;
    const int below = static_cast<int>(floor_of(steps));
    const Rational rest = steps - below;
    const bool up = rest > Rational(1, 2) || (rest == Rational(1, 2) && below % 2 == 1);
    return below + (up ? 1 : 0);
  };
  const auto mix = [](int a, int b, int f) {
    return static_cast<int>(floor_of(a + Rational((b - a) * f + 128, 256)));
  };
  const int low = mix(code(columns[0], rows[0]), code(columns[1], rows[0]), share(columns[1]));
  const int high = mix(code(columns[0], rows[1]), code(columns[1], rows[1]), share(columns[1]));
  return static_cast<float>(mix(low, high, share(rows[1])));
}

// One of two neighbours in the format; `even` says which of them is.
float choose(const Rational& exact, float below, float above, bool below_is_even,
             MipmapRounding rounding) {
  const Rational middle =
      (Rational(static_cast<double>(below)) + Rational(static_cast<double>(above))) / 2;
  if (rounding == MipmapRounding::down || exact < middle) return below;
  if (exact > middle || rounding == MipmapRounding::half_up) return above;
  return below_is_even ? below : above;
}

float rounded_code(const Rational& exact, MipmapRounding rounding) {
  const int below = static_cast<int>(floor_of(exact));
  return choose(exact, static_cast<float>(below), static_cast<float>(below + 1), below % 2 == 0,
                rounding);
}

float rounded_float(const Rational& exact, MipmapRounding rounding) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  auto below = static_cast<float>(exact.convert_to<double>());
  while (Rational(static_cast<double>(below)) > exact) below = std::nextafter(below, -kInfinity);
  if (Rational(static_cast<double>(below)) == exact) return below;
  const float above = std::nextafter(below, kInfinity);
  int exponent = 0;
  const double significand = std::frexp(static_cast<double>(below), &exponent);
  const bool below_is_even = std::fmod(std::ldexp(significand, 24), 2) == 0;
  return choose(exact, below, above, below_is_even, rounding);
}

Real linear_of(float code) {
  const Real coded = Real(code) / 255;
  if (coded <= Real("0.04045")) return coded / Real("12.92");
  return pow((coded + Real("0.055")) / Real("1.055"), Real("2.4"));
}

// No ties: those are in mip_chain_test.cpp.
float rounded_srgb(const std::vector<Weighted>& texels, MipmapRounding rounding) {
  Real mean = 0;
  for (const auto& [value, weight] : texels) mean += Real(weight) * linear_of(value);
  const Real coded = mean <= Real("0.0031308")
                         ? mean * Real("12.92")
                         : Real("1.055") * pow(mean, 1 / Real("2.4")) - Real("0.055");
  const Real steps = coded * 255;
  const Real nearly = rounding == MipmapRounding::down ? Real("1e-40") : Real("0.5");
  return static_cast<float>(floor(steps + nearly).convert_to<int>());
}

void expect_reduction(const TextureLevel& level, TextureFormat format, const MipmapMethod& method) {
  const TextureLevel next = reduced(level, format, method);
  for (int j = 0; j < next.height; ++j)
    for (int i = 0; i < next.width; ++i)
      for (std::size_t k = 0; k < 4; ++k) {
        const auto texels = weighted(level, i, j, k, method.filter);
        const float found = next.texels[next.index(i, j) + k];
        if (format == TextureFormat::rgba32f)
          ASSERT_EQ(found, rounded_float(mean_of(texels), method.rounding));
        else if (format == TextureFormat::srgb8 && method.srgb == MipmapSrgb::linear && k < 3)
          ASSERT_EQ(found, rounded_srgb(texels, method.rounding));
        else if (method.rounding == MipmapRounding::half_up_by_rows &&
                 !(format == TextureFormat::srgb8 && method.srgb == MipmapSrgb::linear))
          ASSERT_EQ(found, mean_by_rows(level, i, j, k, method.filter));
        else
          ASSERT_EQ(found, rounded_code(mean_of(texels), method.rounding));
      }
}

template <class Check>
void for_sizes_and_methods(const Check& check) {
  constexpr std::array<int, 2> kSizes[] = {{1, 1}, {2, 2},  {3, 3},  {5, 4},
                                           {1, 7}, {13, 1}, {9, 11}, {16, 6}};
  for (const auto& [width, height] : kSizes)
    for (const MipmapFilter filter : values_of<MipmapFilter>())
      for (const MipmapRounding rounding : values_of<MipmapRounding>())
        check(width, height, MipmapMethod{filter, rounding, MipmapSrgb::linear});
}

TEST(Reductions, OfCodesAreTheRoundedMeans) {
  std::mt19937 random(1);
  for_sizes_and_methods([&](int width, int height, MipmapMethod method) {
    for (int i = 0; i < 5; ++i) {
      const TextureLevel level = random_level(random, width, height, TextureFormat::rgba8);
      expect_reduction(level, TextureFormat::rgba8, method);
      method.srgb = MipmapSrgb::codes;
      expect_reduction(level, TextureFormat::srgb8, method);
    }
  });
}

TEST(Reductions, OfSrgbAreTheRoundedMeansOfLight) {
  std::mt19937 random(2);
  for_sizes_and_methods([&](int width, int height, const MipmapMethod& method) {
    const TextureLevel level = random_level(random, width, height, TextureFormat::srgb8);
    expect_reduction(level, TextureFormat::srgb8, method);
  });
}

// One code of the straight piece and one beyond it: no mean of the two is a tie.
TEST(Means, OfDarkSrgbCodesAreTheRoundedMeansOfLight) {
  std::mt19937 random(static_cast<std::uint32_t>(share_seed(4)));
  std::uniform_int_distribution<int> straight(0, 10);
  std::uniform_int_distribution<int> curved(11, 40);
  std::uniform_int_distribution<int> weight(1, 1 << 18);
  for (int i = 0; i < share_of(3000, 500); ++i) {
    const auto a = static_cast<float>(straight(random));
    const auto b = static_cast<float>(i % 2 == 0 ? 11 : curved(random));
    const int of_a = weight(random);
    const int of_b = weight(random);
    const Rational total = of_a + of_b;
    const WeightedNumber numbers[] = {{a, of_a}, {b, of_b}};
    for (const MipmapRounding rounding : {MipmapRounding::nearest_even, MipmapRounding::down})
      ASSERT_EQ(mean_of_srgb(numbers, rounding),
                rounded_srgb({{a, of_a / total}, {b, of_b / total}}, rounding))
          << a << " " << b << " " << of_a << " " << of_b;
  }
}

TEST(Reductions, OfFloatsAreTheRoundedMeans) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> exponent(-140, 120);
  std::uniform_int_distribution<int> few(0, 3);
  for_sizes_and_methods([&](int width, int height, const MipmapMethod& method) {
    TextureLevel level = random_level(random, width, height, TextureFormat::rgba32f);
    expect_reduction(level, TextureFormat::rgba32f, method);
    // Neighbouring numbers, whose means are ties.
    for (float& texel : level.texels) texel = 1 + static_cast<float>(few(random)) * 0x1p-23F;
    expect_reduction(level, TextureFormat::rgba32f, method);
    // Very large beside very small ones, some of which cancel.
    for (float& texel : level.texels)
      texel = std::ldexp(few(random) < 2 ? 1.0F : -1.0F, few(random) < 2 ? 100 : exponent(random));
    expect_reduction(level, TextureFormat::rgba32f, method);
  });
}

}  // namespace
}  // namespace edgecase
