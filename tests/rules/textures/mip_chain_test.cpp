// SPDX-License-Identifier: MIT
//
// Mip chains: their sizes, and examples small enough to draw.
#include "rules/textures/mip_chain.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/rules/textures/texels.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

constexpr MipmapRounding kEven = MipmapRounding::nearest_even;
constexpr MipmapRounding kHalfUp = MipmapRounding::half_up;
constexpr MipmapRounding kDown = MipmapRounding::down;

TextureLevel flat(int width, int height) {
  return {width, height, std::vector<float>(4 * static_cast<std::size_t>(width * height), 7)};
}

TEST(Chain, HalvesBothSidesDownToOneTexel) {
  for (int width = 1; width <= 64; ++width)
    for (int height = 1; height <= 64; ++height) {
      const auto chain = mip_chain(flat(width, height), TextureFormat::rgba8,
                                   LevelCount::larger_side, {.filter = MipmapFilter::nearest});
      int w = width;
      int h = height;
      std::size_t count = 0;
      for (;; w = std::max(1, w / 2), h = std::max(1, h / 2)) {
        ASSERT_LT(count, chain.size());
        EXPECT_EQ(chain[count].width, w);
        EXPECT_EQ(chain[count].height, h);
        EXPECT_EQ(chain[count], flat(w, h));
        ++count;
        if (w == 1 && h == 1) break;
      }
      EXPECT_EQ(chain.size(), count);
      // 2^k <= the smaller side < 2^(k+1) makes k + 1 levels.
      const int small = levels_of_chain(width, height, LevelCount::smaller_side);
      EXPECT_LE(1 << (small - 1), std::min(width, height));
      EXPECT_GT(1 << small, std::min(width, height));
    }
}

TEST(Chain, EndsAtTheSmallerSideWhereACourseSaysSo) {
  const auto chain = mip_chain(flat(8, 2), TextureFormat::rgba8, LevelCount::smaller_side, {});
  ASSERT_EQ(chain.size(), 2U);
  EXPECT_EQ(chain[1], flat(4, 1));
}

// The reds of a row of texels, by a filter.
std::vector<float> halved(const std::vector<float>& reds, MipmapFilter filter) {
  const TextureLevel level = red_level(static_cast<int>(reds.size()), 1, reds);
  const TextureLevel next = reduced(level, TextureFormat::rgba32f, {.filter = filter});
  std::vector<float> result;
  for (int i = 0; i < next.width; ++i) result.push_back(next.texels[next.index(i, 0)]);
  return result;
}

using Reds = std::vector<float>;

TEST(Filters, OfEvenSizes) {
  EXPECT_EQ(halved({1, 3, 10, 20}, MipmapFilter::box), (Reds{2, 15}));
  EXPECT_EQ(halved({1, 3, 10, 20}, MipmapFilter::bilinear_centre), (Reds{2, 15}));
  EXPECT_EQ(halved({1, 3, 10, 20}, MipmapFilter::nearest), (Reds{1, 10}));
}

TEST(Filters, OfOddSizes) {
  // The box leaves out the last texel. Five texels onto two: centres at 5/4 and 15/4, a quarter
  // before texel 1's own and a quarter beyond texel 3's.
  EXPECT_EQ(halved({0, 4, 8, 16, 64}, MipmapFilter::box), (Reds{2, 12}));
  EXPECT_EQ(halved({0, 4, 8, 16, 64}, MipmapFilter::bilinear_centre), (Reds{3, 28}));
  EXPECT_EQ(halved({0, 4, 8, 16, 64}, MipmapFilter::nearest), (Reds{0, 8}));
  // Three onto one: the middle texel.
  EXPECT_EQ(halved({1, 2, 64}, MipmapFilter::box), (Reds{1.5F}));
  EXPECT_EQ(halved({1, 2, 64}, MipmapFilter::bilinear_centre), (Reds{2}));
}

TEST(Filters, OfOneRowKeepIt) {
  const TextureLevel column = red_level(1, 4, {1, 3, 10, 20});
  for (const MipmapFilter filter : {MipmapFilter::box, MipmapFilter::bilinear_centre}) {
    const TextureLevel next = reduced(column, TextureFormat::rgba32f, {.filter = filter});
    EXPECT_EQ(next, red_level(1, 2, {2, 15}));
  }
}

TEST(Filters, LeaveOutWhatHasNoWeight) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const TextureLevel column = red_level(1, 2, {kInfinity, 1});
  EXPECT_EQ(reduced(column, TextureFormat::rgba32f, {}), red_level(1, 1, {kInfinity}));
}

TEST(Filters, OfEvenSizesAgree) {
  std::mt19937 random(1);
  for (const TextureFormat format :
       {TextureFormat::rgba8, TextureFormat::srgb8, TextureFormat::rgba32f})
    for (const int width : {1, 2, 4, 10, 16})
      for (const int height : {1, 2, 6, 8}) {
        const TextureLevel level = random_level(random, width, height, format);
        for (const MipmapRounding rounding : values_of<MipmapRounding>()) {
          const MipmapMethod box{MipmapFilter::box, rounding, MipmapSrgb::linear};
          const MipmapMethod centre{MipmapFilter::bilinear_centre, rounding, MipmapSrgb::linear};
          EXPECT_EQ(reduced(level, format, box), reduced(level, format, centre));
        }
      }
}

float mean_of(const std::vector<float>& values, MipmapRounding rounding,
              float (*mean)(WeightedNumbers, MipmapRounding)) {
  std::vector<WeightedNumber> numbers;
  for (const float value : values) numbers.push_back({value, 1});
  return mean(numbers, rounding);
}

TEST(Roundings, OfCodesAreDistinguished) {
  const auto mean = [](const std::vector<float>& codes, MipmapRounding rounding) {
    return mean_of(codes, rounding, mean_of_codes);
  };
  // 2.5, 3.5, 2.75, 2.25.
  EXPECT_EQ(mean({2, 3}, kEven), 2);
  EXPECT_EQ(mean({2, 3}, kHalfUp), 3);
  EXPECT_EQ(mean({2, 3}, kDown), 2);
  EXPECT_EQ(mean({3, 4}, kEven), 4);
  EXPECT_EQ(mean({3, 4}, kHalfUp), 4);
  EXPECT_EQ(mean({3, 4}, kDown), 3);
  EXPECT_EQ(mean({2, 3, 3, 3}, kEven), 3);
  EXPECT_EQ(mean({2, 3, 3, 3}, kDown), 2);
  EXPECT_EQ(mean({2, 2, 2, 3}, kEven), 2);
  EXPECT_EQ(mean({2, 2, 2, 3}, kHalfUp), 2);
}

TEST(Roundings, ByRowsRoundTwice) {
  const auto mean = [](const std::array<float, 4>& codes, TwoWeights columns, TwoWeights rows) {
    return mean_of_rows(codes, columns, rows);
  };
  // 0.5 and 0 make 1 and 0, and these 1; the mean is 0.25.
  EXPECT_EQ(mean({0, 1, 0, 0}, {1, 1}, {1, 1}), 1);
  EXPECT_EQ(mean({1, 0, 0, 0}, {1, 1}, {1, 1}), 1);
  EXPECT_EQ(mean({0, 0, 7, 9}, {1, 0}, {0, 1}), 7);
  // A third is 85/256: 84.67 and 170.33.
  EXPECT_EQ(mean({0, 255, 0, 255}, {2, 1}, {1, 1}), 85);
  EXPECT_EQ(mean({255, 0, 255, 0}, {2, 1}, {1, 1}), 170);
  // 127/256 and 1/2 of a code.
  EXPECT_EQ(mean({0, 127, 0, 127}, {255, 1}, {1, 1}), 0);
  EXPECT_EQ(mean({0, 128, 0, 128}, {255, 1}, {1, 1}), 1);
  // 1/512 and 3/512 are ties, to 0 and to 2/256.
  EXPECT_EQ(mean({0, 255, 0, 255}, {511, 1}, {1, 1}), 0);
  EXPECT_EQ(mean({0, 255, 0, 255}, {509, 3}, {1, 1}), 2);
  // Of floats, and of light, they are the nearest.
  std::mt19937 random(1);
  const MipmapMethod by_rows{MipmapFilter::bilinear_centre, MipmapRounding::half_up_by_rows,
                             MipmapSrgb::linear};
  const MipmapMethod nearest{MipmapFilter::bilinear_centre, kEven, MipmapSrgb::linear};
  for (const TextureFormat format : {TextureFormat::srgb8, TextureFormat::rgba32f}) {
    const TextureLevel level = random_level(random, 7, 5, format);
    EXPECT_EQ(reduced(level, format, by_rows), reduced(level, format, nearest));
  }
}

TEST(Roundings, OfFloatsAreDistinguished) {
  constexpr float kStep = 0x1p-23F;
  const auto mean = [](const std::vector<float>& values, MipmapRounding rounding) {
    return mean_of(values, rounding, mean_of_floats);
  };
  EXPECT_EQ(mean({1, 1 + kStep}, kEven), 1);
  EXPECT_EQ(mean({1, 1 + kStep}, kHalfUp), 1 + kStep);
  EXPECT_EQ(mean({1, 1 + kStep}, kDown), 1);
  EXPECT_EQ(mean({1 + kStep, 1 + 2 * kStep}, kEven), 1 + 2 * kStep);
  EXPECT_EQ(mean({1, 1 + kStep, 1 + kStep, 1 + kStep}, kEven), 1 + kStep);
  EXPECT_EQ(mean({1, 1 + kStep, 1 + kStep, 1 + kStep}, kDown), 1);
  EXPECT_EQ(mean({-1, -1 - kStep}, kHalfUp), -1);
  EXPECT_EQ(mean({-1, -1 - kStep}, kDown), -1 - kStep);
}

TEST(MeanOfFloats, LosesNothingToCancellation) {
  const auto mean = [](const std::vector<float>& values) {
    return mean_of(values, kEven, mean_of_floats);
  };
  EXPECT_EQ(mean({1e38F, 0x1p-140F, -1e38F, 0}), 0x1p-142F);
  EXPECT_EQ(mean({1e38F, 0x1p-30F, -1e38F, 0x1p-60F}), 0x1p-32F + 0x1p-62F);
  EXPECT_EQ(mean({1, -1, 1, -1}), 0);
  EXPECT_EQ(mean({1e30F, 1, -1e30F}), 1 / 3.0F);
  EXPECT_EQ(mean({1, 2, 3, 4, 5, 6, 7, 8, 9}), 5);
  constexpr float kMost = std::numeric_limits<float>::max();
  EXPECT_EQ(mean({kMost, kMost, kMost, kMost}), kMost);
  EXPECT_EQ(mean({kMost, -kMost, kMost, kMost}), kMost / 2);
  // Halfway between two numbers, and the least bit more or less.
  EXPECT_EQ(mean({1, 1 + 0x1p-23F, 0, 0}), 0.5F);
  EXPECT_EQ(mean({1, 1 + 0x1p-23F, 0x1p-149F, 0}), 0.5F + 0x1p-24F);
  EXPECT_EQ(mean({1, 1 + 0x1p-23F, -0x1p-149F, 0}), 0.5F);
}

TEST(MeanOfFloats, IsThatOfIeee754WhereNumbersAreNot) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const auto mean = [](const std::vector<float>& values) {
    return mean_of(values, kEven, mean_of_floats);
  };
  EXPECT_EQ(mean({1, kInfinity}), kInfinity);
  EXPECT_EQ(mean({1, -kInfinity}), -kInfinity);
  EXPECT_TRUE(std::isnan(mean({-kInfinity, kInfinity})));
  EXPECT_TRUE(std::isnan(mean({kNaN, 1})));
  EXPECT_TRUE(std::isnan(mean({kNaN, kNaN})));
}

TEST(MeanOfSrgb, IsThatOfLinearNumbers) {
  const auto mean = [](const std::vector<float>& codes, MipmapRounding rounding) {
    return mean_of(codes, rounding, mean_of_srgb);
  };
  // Half of the light is code 187.516.
  EXPECT_EQ(mean({0, 0, 255, 255}, kEven), 188);
  EXPECT_EQ(mean({0, 0, 255, 255}, kDown), 187);
  for (int code = 0; code < 256; ++code)
    for (const MipmapRounding rounding : values_of<MipmapRounding>()) {
      const auto c = static_cast<float>(code);
      EXPECT_EQ(mean({c, c, c, c}, rounding), c);
    }
}

TEST(MeanOfSrgb, OfEqualCodesIsThatCodeWhateverTheWeights) {
  for (int code = 0; code < 256; ++code)
    for (int weight = 1; weight < 50; weight += 2) {
      const auto c = static_cast<float>(code);
      const WeightedNumber numbers[] = {{c, weight}, {c, 7}, {c, 3 * weight}};
      ASSERT_EQ(mean_of_srgb(numbers, kDown), c);
    }
}

TEST(MeanOfSrgb, OfBlackAndWhiteIsRoundedInTheCode) {
  // Codes 10 and 10.49, and what the straight piece would make 10.5007 of if it went on.
  const auto mean = [](int white, int black, MipmapRounding rounding) {
    const WeightedNumber numbers[] = {{255, white}, {0, black}};
    return mean_of_srgb(numbers, rounding);
  };
  EXPECT_EQ(mean(50, 16423, kDown), 10);
  EXPECT_EQ(mean(1, 313, kEven), 10);
  EXPECT_EQ(mean(4, 1251, kEven), 10);
}

TEST(MeanOfSrgb, OfCode10IsExactHoweverItIsMade) {
  // 16473 parts of white and 5 c of code c: on the border between codes 9 and 10.
  for (int code = 0; code < 10; ++code) {
    const WeightedNumber numbers[] = {{static_cast<float>(code), 16423}, {255, 5 * (10 - code)}};
    EXPECT_EQ(mean_of_srgb(numbers, kDown), 10) << code;
  }
  // In long double this sum falls below the border.
  const WeightedNumber rounded_down[] = {{6, 12067}, {9, 1001}, {255, 15}};
  EXPECT_EQ(mean_of_srgb(rounded_down, kDown), 10);
}

TEST(MeanOfSrgb, DecidesTiesOfTheStraightPieceExactly) {
  const auto mean = [](const std::vector<float>& codes, MipmapRounding rounding) {
    return mean_of(codes, rounding, mean_of_srgb);
  };
  for (const float code : {0.0F, 1.0F, 4.0F, 7.0F, 9.0F}) {
    const float even = static_cast<int>(code) % 2 == 0 ? code : code + 1;
    EXPECT_EQ(mean({code, code + 1}, kEven), even);
    EXPECT_EQ(mean({code, code + 1}, kHalfUp), code + 1);
    EXPECT_EQ(mean({code, code + 1}, kDown), code);
  }
  // Light of one part in 6589.2 is half a code: 5/32946 of code 255 and the rest of code 0.
  const WeightedNumber half_a_code[] = {{255, 5}, {0, 32941}};
  EXPECT_EQ(mean_of_srgb(half_a_code, kEven), 0);
  EXPECT_EQ(mean_of_srgb(half_a_code, kHalfUp), 1);
  EXPECT_EQ(mean_of_srgb(half_a_code, kDown), 0);
  const WeightedNumber two_codes[] = {{255, 10}, {0, 16463}};
  EXPECT_EQ(mean_of_srgb(two_codes, kDown), 2);
}

TEST(Reduced, StaysWithinTheCodesWhateverIsStored) {
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const TextureLevel level{2, 1, {-9, 300, kNaN, 255, -8, 1e30F, kNaN, 999}};
  for (const MipmapRounding rounding : values_of<MipmapRounding>())
    for (const TextureFormat format : {TextureFormat::rgba8, TextureFormat::srgb8}) {
      const MipmapMethod method{MipmapFilter::box, rounding, MipmapSrgb::linear};
      EXPECT_EQ(reduced(level, format, method).texels, (Reds{0, 255, 0, 255}));
    }
}

TEST(Reduced, DecodesColoursButNotAlpha) {
  const TextureLevel level{2, 1, {0, 0, 0, 0, 255, 255, 255, 255}};
  const MipmapMethod linear{MipmapFilter::box, kEven, MipmapSrgb::linear};
  const MipmapMethod of_codes{MipmapFilter::box, kEven, MipmapSrgb::codes};
  EXPECT_EQ(reduced(level, TextureFormat::srgb8, linear).texels, (Reds{188, 188, 188, 128}));
  EXPECT_EQ(reduced(level, TextureFormat::srgb8, {}), reduced(level, TextureFormat::srgb8, linear));
  EXPECT_EQ(reduced(level, TextureFormat::srgb8, of_codes).texels, (Reds{128, 128, 128, 128}));
  EXPECT_EQ(reduced(level, TextureFormat::rgba8, linear).texels, (Reds{128, 128, 128, 128}));
}

template <class Choice>
void expect_names(const Rule& rule) {
  for (const Alternative& alternative : rule.alternatives) {
    Choice choice{};
    ASSERT_TRUE(parse_name(alternative.name, choice)) << name_of(rule.id);
    EXPECT_EQ(name_of(choice), alternative.name);
  }
  Choice choice{};
  EXPECT_FALSE(parse_name("?", choice));
}

TEST(MipChainNames, AreThoseOfTheCatalogue) {
  expect_names<LevelCount>(level_count_rule());
  expect_names<MipmapFilter>(mipmap_filter_rule());
  expect_names<MipmapRounding>(mipmap_rounding_rule());
  EXPECT_EQ(mipmap_srgb_rule().alternatives[0].name, mipmap_srgb_rule().standard);
  EXPECT_EQ(values_of<MipmapFilter>().size(), mipmap_filter_rule().alternatives.size());
  EXPECT_EQ(values_of<MipmapRounding>().size(), mipmap_rounding_rule().alternatives.size());
}

}  // namespace
}  // namespace edgecase
