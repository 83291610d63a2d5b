// SPDX-License-Identifier: MIT
//
// Patterns and mip chains against formulas of their own: rational arithmetic for what is exact, and
// long double for the cosine.
#include "casefile/scene/patterns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

namespace edgecase {
namespace {

using Fraction = boost::multiprecision::cpp_rational;

constexpr TextureFormat kFormats[] = {TextureFormat::rgba8, TextureFormat::srgb8,
                                      TextureFormat::rgba32f};

// To the nearest whole number, a tie to even; by halves, not by remainders.
int to_code(const Fraction& value) {
  int below = 0;
  while (Fraction(below + 1) <= value) ++below;
  const Fraction rest = value - below;
  const Fraction half(1, 2);
  if (rest == half) return below % 2 == 0 ? below : below + 1;
  return rest < half ? below : below + 1;
}

// The float32 number nearest to a fraction: of the candidates round its double.
float to_float(const Fraction& value) {
  const auto guess = value.convert_to<float>();
  float best = guess;
  const auto distance = [&](float x) {
    const Fraction error = Fraction(x) - value;
    return error < 0 ? Fraction(-error) : error;
  };
  for (const float other : {std::nextafter(guess, -1e38F), std::nextafter(guess, 1e38F)})
    if (distance(other) < distance(best) ||
        (distance(other) == distance(best) && std::fmod(std::ldexp(other, 149), 2) == 0))
      best = other;
  return best;
}

float stored(const Fraction& value, TextureFormat format) {
  return format == TextureFormat::rgba32f ? to_float(value) : static_cast<float>(to_code(value));
}

float at(const TextureLevel& level, int i, int j, std::size_t c) {
  return level.texels[4 * static_cast<std::size_t>(j * level.width + i) + c];
}

TextureLevel random_level(std::mt19937& random, PatternSize size, TextureFormat format) {
  TextureLevel level{size.width, size.height, {}};
  for (int n = 0; n < 4 * size.width * size.height; ++n) {
    const auto bits = static_cast<float>(random() % (1U << 24));
    level.texels.push_back(format == TextureFormat::rgba32f
                               ? std::ldexp(bits - 8e6F, static_cast<int>(random() % 60) - 40)
                               : static_cast<float>(random() % 256));
  }
  return level;
}

TEST(TexturePatterns, ColoursBecomeTheNearestCodes) {
  const std::array<float, 4> color{0.5F, 0.1F, 1.0F / 255, 0.7F};
  const StoredTexel expected{128, 26, 1, 178};  // 127.5 goes to the even one
  EXPECT_EQ(stored_texel(color, TextureFormat::rgba8), expected);
  EXPECT_EQ(stored_texel(color, TextureFormat::srgb8), expected);
  EXPECT_EQ(stored_texel(color, TextureFormat::rgba32f), color);
  for (int code = 0; code < 256; ++code) {
    const float value = static_cast<float>(code) / 255;
    EXPECT_EQ(stored_texel({value, 0, 0, 0}, TextureFormat::rgba8)[0], static_cast<float>(code));
  }
}

TEST(TexturePatterns, CheckersCountCellsFromTheLowerLeft) {
  const StoredTexel a{1, 2, 3, 4};
  const StoredTexel b{5, 6, 7, 8};
  const TextureLevel level = checker_image({7, 5}, 3, {a, b});
  const char* const rows[] = {"aaabbba", "aaabbba", "aaabbba", "bbbaaab", "bbbaaab"};
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 7; ++i)
      for (std::size_t c = 0; c < 4; ++c)
        EXPECT_EQ(at(level, i, j, c), (rows[j][i] == 'a' ? a : b)[c]) << i << ' ' << j;
}

TEST(TexturePatterns, GradientsAreRoundedOnce) {
  std::mt19937 random(1);
  for (const TextureFormat format : kFormats) {
    for (const PatternSize size : {PatternSize{1, 1}, {2, 2}, {5, 1}, {1, 4}, {7, 6}, {16, 3}}) {
      const TextureLevel two = random_level(random, {2, 2}, format);
      std::array<StoredTexel, 4> corners{};
      for (std::size_t k = 0; k < 4; ++k) std::copy_n(&two.texels[4 * k], 4, corners[k].begin());
      const TextureLevel level = gradient_image(size, corners, format);
      for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
          const Fraction x = size.width == 1 ? Fraction(0) : Fraction(i, size.width - 1);
          const Fraction y = size.height == 1 ? Fraction(0) : Fraction(j, size.height - 1);
          for (std::size_t c = 0; c < 4; ++c) {
            const auto corner = [&](std::size_t k) { return Fraction(corners[k][c]); };
            const Fraction lower = corner(0) + x * (corner(1) - corner(0));
            const Fraction upper = corner(2) + x * (corner(3) - corner(2));
            EXPECT_EQ(at(level, i, j, c), stored(lower + y * (upper - lower), format))
                << name_of(format) << ' ' << i << ' ' << j;
          }
        }
      }
    }
  }
}

TEST(TexturePatterns, ZonePlatesFollowTheCosine) {
  for (const PatternSize size :
       {PatternSize{1, 1}, {9, 9}, {64, 48}, {31, 1}, {6, 6}, {255, 256}}) {
    const TextureLevel wide = zone_plate_image(size, TextureFormat::rgba32f);
    const TextureLevel coded = zone_plate_image(size, TextureFormat::srgb8);
    EXPECT_EQ(coded, zone_plate_image(size, TextureFormat::rgba8));
    for (int j = 0; j < size.height; ++j) {
      for (int i = 0; i < size.width; ++i) {
        const long double x = i - size.width / 2.0L + 0.5L;
        const long double y = j - size.height / 2.0L + 0.5L;
        const long double angle =
            std::numbers::pi_v<long double> * (x * x + y * y) / std::max(size.width, size.height);
        const long double grey = 0.5L + 0.5L * std::cos(angle);
        for (std::size_t c = 0; c < 3; ++c) {
          // Half a unit of the last place of numbers near 1, and of a code.
          EXPECT_NEAR(static_cast<double>(at(wide, i, j, c)), static_cast<double>(grey), 3e-8);
          EXPECT_LE(std::fabs(static_cast<long double>(at(coded, i, j, c)) - 255 * grey),
                    0.5L + 1e-12L);
        }
        EXPECT_EQ(at(wide, i, j, 3), 1);
        EXPECT_EQ(at(coded, i, j, 3), 255);
      }
    }
  }
  EXPECT_EQ(at(zone_plate_image({5, 5}, TextureFormat::rgba32f), 2, 2, 0), 1);
}

// 3/4 and 1/4, of which the codes are no ties; 1/2 does not occur, whatever the size.
TEST(TexturePatterns, ZonePlatesAreExactWhereTheCosineIsRational) {
  int halves = 0;
  int quarters = 0;
  for (int width = 1; width <= 24; ++width) {
    for (int height = 1; height <= 24; ++height) {
      const TextureLevel wide = zone_plate_image({width, height}, TextureFormat::rgba32f);
      const TextureLevel coded = zone_plate_image({width, height}, TextureFormat::rgba8);
      const int side = std::max(width, height);
      for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
          const int x = 2 * i + 1 - width;
          const int y = 2 * j + 1 - height;
          const Fraction turns = Fraction(x * x + y * y, 4 * side);  // times pi
          const Fraction of_pi = turns - 2 * Fraction(numerator(turns) / (2 * denominator(turns)));
          float grey = -1;
          if (of_pi == 0) grey = 1;
          if (of_pi == 1) grey = 0;
          if (of_pi == Fraction(1, 2) || of_pi == Fraction(3, 2)) grey = 0.5F;
          if (of_pi == Fraction(1, 3) || of_pi == Fraction(5, 3)) grey = 0.75F;
          if (of_pi == Fraction(2, 3) || of_pi == Fraction(4, 3)) grey = 0.25F;
          if (grey < 0) continue;
          EXPECT_EQ(at(wide, i, j, 0), grey);
          EXPECT_EQ(at(coded, i, j, 0), static_cast<float>(to_code(Fraction(grey) * 255)));
          halves += grey == 0.5F ? 1 : 0;
          quarters += grey == 0.25F ? 1 : 0;
        }
      }
    }
  }
  EXPECT_EQ(halves, 0);
  EXPECT_GT(quarters, 10);
}

// The first words of SplitMix64 from the seed 1234567, as its authors' program prints them.
TEST(TexturePatterns, NoiseIsSplitMix64) {
  const std::uint64_t words[] = {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                 4593380528125082431U, 16408922859458223821U};
  const TextureLevel coded = noise_image({2, 1}, TextureFormat::rgba8, 1234567);
  const TextureLevel wide = noise_image({2, 1}, TextureFormat::rgba32f, 1234567);
  for (std::size_t n = 0; n < 5; ++n) {
    EXPECT_EQ(coded.texels[n], static_cast<float>(words[n] / (std::uint64_t{1} << 56)));
    EXPECT_EQ(static_cast<double>(wide.texels[n]) * 16777216,
              static_cast<double>(words[n] / (std::uint64_t{1} << 40)));
  }
  EXPECT_NE(noise_image({2, 2}, TextureFormat::srgb8, 0),
            noise_image({2, 2}, TextureFormat::srgb8, 1));
}

TEST(TexturePatterns, FlatLevelsMakeAWholeChain) {
  const std::vector<StoredTexel> colors = level_colors(4, TextureFormat::rgba32f);
  EXPECT_EQ(colors[3], (StoredTexel{3, 1.5F, 0.25F, 1}));
  const auto levels = flat_levels({5, 11}, colors);
  ASSERT_EQ(levels.size(), 4U);
  const int sizes[][2] = {{5, 11}, {2, 5}, {1, 2}, {1, 1}};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(levels[k].width, sizes[k][0]);
    EXPECT_EQ(levels[k].height, sizes[k][1]);
    ASSERT_EQ(levels[k].texels.size(), static_cast<std::size_t>(4 * sizes[k][0] * sizes[k][1]));
    for (std::size_t n = 0; n < levels[k].texels.size(); ++n)
      EXPECT_EQ(levels[k].texels[n], colors[k][n % 4]);
  }
  const auto codes = level_colors(level_count(kMaxTextureSize, 1), TextureFormat::rgba8);
  EXPECT_EQ(std::set<StoredTexel>(codes.begin(), codes.end()).size(), 11U);
}

TEST(TexturePatterns, BoxesAreMeansRoundedOncePerLevel) {
  std::mt19937 random(2);
  for (const TextureFormat format : kFormats) {
    for (const PatternSize size :
         {PatternSize{1, 1}, {2, 2}, {1, 7}, {6, 1}, {5, 3}, {8, 8}, {9, 2}, {13, 21}}) {
      const TextureLevel base = random_level(random, size, format);
      const auto chain = box_chain(base, format);
      ASSERT_EQ(static_cast<int>(chain.size()), level_count(size.width, size.height));
      EXPECT_EQ(chain[0], base);
      for (std::size_t k = 1; k < chain.size(); ++k) {
        const TextureLevel& from = chain[k - 1];
        const TextureLevel& level = chain[k];
        ASSERT_EQ(level.width, std::max(1, from.width / 2));
        ASSERT_EQ(level.height, std::max(1, from.height / 2));
        for (int j = 0; j < level.height; ++j) {
          for (int i = 0; i < level.width; ++i) {
            for (std::size_t c = 0; c < 4; ++c) {
              Fraction sum;  // a single row or column counts twice, which changes no mean
              for (int n = 0; n < 4; ++n)
                sum += Fraction(at(from, std::min(2 * i + n % 2, from.width - 1),
                                   std::min(2 * j + n / 2, from.height - 1), c));
              EXPECT_EQ(at(level, i, j, c), stored(sum / 4, format)) << name_of(format) << ' ' << k;
            }
          }
        }
      }
    }
  }
}

// Every mean of two and of four codes whose sums differ: all ties, both ways.
TEST(TexturePatterns, TiesOfBoxesGoToEven) {
  for (int sum = 0; sum <= 4 * 255; ++sum) {
    TextureLevel level{2, 2, std::vector<float>(16, 0.0F)};
    int rest = sum;
    for (std::size_t n = 0; n < 4; ++n) {
      const int part = std::min(rest, 255);
      level.texels[4 * n] = static_cast<float>(part);
      rest -= part;
    }
    const float found = box_level(level, TextureFormat::rgba8).texels[0];
    EXPECT_EQ(found, std::nearbyint(static_cast<float>(sum) / 4)) << sum;
  }
  TextureLevel pair{2, 1, {0, 1, 2, 3, 1, 2, 3, 4}};
  EXPECT_EQ(box_level(pair, TextureFormat::rgba8).texels, (std::vector<float>{0, 2, 2, 4}));
}

}  // namespace
}  // namespace edgecase
