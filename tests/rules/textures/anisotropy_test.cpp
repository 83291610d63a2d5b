// SPDX-License-Identifier: MIT
#include "rules/textures/level_selection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// du along x, dv along y.
Footprint along_axes(double x, double y) {
  return {{x, 0}, {0, y}, 2};
}

ProbeRow extension(const Footprint& footprint, float most) {
  return probes(footprint, most, Anisotropy::extension, ScaleFactor::lengths);
}

ProbeRow gaussian(const Footprint& footprint) {
  return probes(footprint, 16, Anisotropy::gaussian_5, ScaleFactor::lengths);
}

void expect_exact(Interval value, double expected) {
  EXPECT_EQ(value.low, expected);
  EXPECT_EQ(value.high, expected);
}

Interval sum_of_weights(const ProbeRow& row) {
  Interval sum = 0;
  for (const Probe& probe : row.probes) sum = sum + probe.weight;
  return sum;
}

// Lengths in whole numbers: N is the smallest whole number with N * shorter >= longer.
TEST(Extension, TakesAsManyProbesAsTheRatioRoundedUp) {
  for (int longer = 1; longer <= 40; ++longer)
    for (int shorter = 1; shorter <= longer; ++shorter)
      for (int most = 2; most <= 16; ++most) {
        std::size_t count = 1;
        while (static_cast<int>(count) * shorter < longer && static_cast<int>(count) < most)
          ++count;
        const ProbeRow row = extension(along_axes(longer, -shorter), static_cast<float>(most));
        ASSERT_EQ(row.probes.size(), count) << longer << " " << shorter << " " << most;
        ASSERT_EQ(row.along_x, longer > shorter);
        const auto n = static_cast<double>(count);
        ASSERT_LE(row.scale_factor.low * n, longer * (1 + 0x1p-51));
        ASSERT_GE(row.scale_factor.high * n, longer * (1 - 0x1p-51));
        ASSERT_LE(width_of(row.scale_factor), 0x1p-45);
      }
}

TEST(Extension, SpreadsProbesEvenly) {
  const ProbeRow row = extension(along_axes(1, 4), 16);
  EXPECT_FALSE(row.along_x);
  expect_exact(row.scale_factor, 1);
  ASSERT_EQ(row.probes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(row.probes[i].offset, -0.3 + 0.2 * static_cast<double>(i), 0x1p-52);
    expect_exact(row.probes[i].weight, 0.25);
  }
  const ProbeRow three = extension(along_axes(3, 1), 16);
  ASSERT_EQ(three.probes.size(), 3u);
  EXPECT_EQ(three.probes[0].offset, -0.25);
  EXPECT_EQ(three.probes[1].offset, 0);
  EXPECT_EQ(three.probes[2].offset, 0.25);
  EXPECT_TRUE(sum_of_weights(three).contains(1));
}

TEST(Extension, OfASquareFootprintIsOneProbe) {
  const ProbeRow row = extension(along_axes(3, 3), 16);
  ASSERT_EQ(row.probes.size(), 1u);
  EXPECT_EQ(row.probes[0].offset, 0);
  expect_exact(row.probes[0].weight, 1);
  expect_exact(row.scale_factor, 3);
}

TEST(Extension, CountsWholeProbesWhereTheMaximumIsNone) {
  EXPECT_EQ(extension(along_axes(9, 1), 2.75F).probes.size(), 2u);
  EXPECT_EQ(extension(along_axes(9, 1), 1.5F).probes.size(), 1u);
  expect_exact(extension(along_axes(9, 1), 1.5F).scale_factor, 9);
}

TEST(Extension, OfAFootprintWithoutWidthTakesAllProbes) {
  EXPECT_EQ(extension(along_axes(2, 0), 8).probes.size(), 8u);
  expect_exact(extension(along_axes(2, 0), 8).scale_factor, 0.25);
  EXPECT_EQ(extension(along_axes(0, 0), 8).probes.size(), 1u);
  expect_exact(extension(along_axes(0, 0), 8).scale_factor, 0);
}

TEST(Extension, MiddlesOfIntervalsDecide) {
  const Footprint wide = {{Interval(1, 4), 0}, {0, Interval(2, 2.5)}, 2};
  EXPECT_TRUE(extension(wide, 16).along_x);
  EXPECT_EQ(extension(wide, 16).probes.size(), 2u);
  EXPECT_EQ(extension(wide, 16).scale_factor.low, 0.5);
  EXPECT_EQ(extension(wide, 16).scale_factor.high, 2);
  EXPECT_FALSE(extension({{Interval(1, 3), 0}, {0, Interval(2.1, 2.2)}, 2}, 16).along_x);
}

// Weights exp(-2 (2x)^2) over their sum, from the exponential's series.
TEST(Gaussian, WeighsFiveProbes) {
  const auto exponential = [](Wide power) {
    Wide sum = 1, term = 1;
    for (int k = 1; k < 60; ++k) {
      term *= power / k;
      sum += term;
    }
    return sum;
  };
  const Wide outer = exponential(static_cast<Wide>(-128) / 100);
  const Wide inner = exponential(static_cast<Wide>(-32) / 100);
  const Wide sum = 1 + 2 * inner + 2 * outer;
  const Wide expected[] = {outer / sum, inner / sum, 1 / sum, inner / sum, outer / sum};
  const ProbeRow row = gaussian(along_axes(5, 1));
  ASSERT_EQ(row.probes.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(holds(row.probes[i].weight, expected[i])) << i;
    EXPECT_LE(width_of(row.probes[i].weight), 0x1p-48) << i;
    EXPECT_NEAR(row.probes[i].offset, 0.2 * static_cast<double>(i) - 0.4, 0x1p-52);
  }
  EXPECT_TRUE(sum_of_weights(row).contains(1));
}

TEST(Gaussian, TakesTheShorterVectorOrAFifthOfTheLonger) {
  expect_exact(gaussian(along_axes(10, 1)).scale_factor, 2);
  expect_exact(gaussian(along_axes(1, 4)).scale_factor, 1);
  EXPECT_TRUE(gaussian(along_axes(10, 1)).along_x);
  EXPECT_FALSE(gaussian(along_axes(1, 4)).along_x);
}

TEST(Anisotropies, WithoutOneThereIsOneProbeOfTheIsotropicScaleFactor) {
  const Footprint skewed = {{3, 4}, {1, 0}, 2};
  const auto expect_isotropic = [&](float most, Anisotropy choice) {
    const ProbeRow row = probes(skewed, most, choice, ScaleFactor::sum_of_partials);
    expect_exact(row.scale_factor, 7);
    ASSERT_EQ(row.probes.size(), 1u);
    EXPECT_EQ(row.probes[0].offset, 0);
    expect_exact(row.probes[0].weight, 1);
  };
  expect_isotropic(1, Anisotropy::extension);
  expect_isotropic(1, Anisotropy::gaussian_5);
  expect_isotropic(16, Anisotropy::none);
  expect_isotropic(static_cast<float>(kNone), Anisotropy::extension);
}

TEST(Anisotropies, DifferOnOneFootprint) {
  const Footprint f = along_axes(8, 2);
  EXPECT_EQ(extension(f, 16).probes.size(), 4u);
  EXPECT_EQ(gaussian(f).probes.size(), 5u);
  EXPECT_EQ(probes(f, 16, Anisotropy::none, ScaleFactor::lengths).probes.size(), 1u);
}

TEST(Anisotropies, AreDefinedForEverything) {
  for (const double x : {0.0, 1.0, kInfinity, kNone})
    for (const double y : {0.0, 1.0, kInfinity, kNone})
      for (const Anisotropy choice :
           {Anisotropy::extension, Anisotropy::gaussian_5, Anisotropy::none}) {
        const ProbeRow row = probes(along_axes(x, y), 16, choice, ScaleFactor::lengths);
        EXPECT_GE(row.probes.size(), 1u);
        EXPECT_LE(row.probes.size(), 16u);
        EXPECT_GE(row.scale_factor.low, 0);
        EXPECT_LE(row.scale_factor.low, row.scale_factor.high);
      }
}

TEST(AnisotropyRule, IsNeverAViolation) {
  EXPECT_EQ(anisotropy_rule().alternatives.size(), 3u);
  for (const Alternative& alternative : anisotropy_rule().alternatives) {
    EXPECT_EQ(alternative.openness, Openness::open);
    Anisotropy parsed{};
    EXPECT_TRUE(parse_name(alternative.name, parsed));
    EXPECT_EQ(name_of(parsed), alternative.name);
  }
  Anisotropy parsed{};
  EXPECT_FALSE(parse_name("?", parsed));
}

}  // namespace
}  // namespace edgecase
