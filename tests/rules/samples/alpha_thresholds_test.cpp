// SPDX-License-Identifier: MIT
#include "rules/samples/alpha_thresholds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace edgecase {
namespace {

constexpr int kSamples = 4;
constexpr int kRow = 16;

using Function = std::function<int(double alpha, int pixel)>;

// A ramp of 16 alphas between 0 and 1, over so many rows of pixels.
std::vector<KeptByAlpha> ramp_by(const Function& kept, int rows) {
  std::vector<KeptByAlpha> pixels;
  for (int pixel = 0; pixel < rows * kRow; ++pixel) {
    const double alpha = (pixel % kRow + 0.5) / kRow;
    pixels.push_back({alpha, kept(alpha, pixel)});
  }
  return pixels;
}
AlphaTrend trend_by(const Function& kept, int rows) {
  return trend_of(ramp_by(kept, rows), kSamples);
}

int rounded(double alpha) {
  return static_cast<int>(std::lround(alpha * kSamples));
}

// 14.9.3: pseudo-random, and different at different pixels. Of 2,000 such renderers none is
// accused.
TEST(AlphaThresholds, DrawnForEachSampleOfEachPixelAreProportional) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> threshold(0, 1);
  const Function drawn = [&](double alpha, int) {
    int kept = 0;
    for (int sample = 0; sample < kSamples; ++sample) kept += alpha > threshold(random) ? 1 : 0;
    return kept;
  };
  for (int round = 0; round < 2000; ++round)
    ASSERT_EQ(trend_by(drawn, 1 + round % 8), AlphaTrend::proportional) << round;
}

TEST(AlphaThresholds, OfOnePixelNothingIsKnown) {
  for (int kept = 0; kept <= kSamples; ++kept)
    EXPECT_EQ(trend_of(std::vector<KeptByAlpha>{{0.5, kept}}, kSamples), AlphaTrend::proportional);
}

TEST(AlphaThresholds, OneFunctionForAllPixelsIsTakenAtItsWord) {
  EXPECT_EQ(trend_by([](double alpha, int) { return rounded(alpha); }, 8),
            AlphaTrend::disproportionate);
  // One step of the ramp keeps a sample less than the one before.
  const Function with_a_dip = [](double alpha, int) {
    return alpha > 0.5 && alpha < 0.55 ? 1 : rounded(alpha);
  };
  EXPECT_EQ(trend_by(with_a_dip, 8), AlphaTrend::falling);
}

TEST(AlphaThresholds, FarTooManyOrFewOrSteepAreFound) {
  // The first row differs, so that no one function holds for all pixels.
  const auto some = [](int pixel) { return pixel < kRow ? 1 : 0; };
  const Function all = [&](double, int pixel) { return kSamples - some(pixel); };
  const Function none = [&](double, int pixel) { return some(pixel); };
  const Function inverted = [&](double alpha, int pixel) {
    return std::min(kSamples, rounded(1 - alpha) + some(pixel));
  };
  // All or nothing, at one threshold.
  const Function steep = [&](double alpha, int pixel) {
    return alpha < 0.5 ? some(pixel) : kSamples - some(pixel);
  };
  // All or nothing, by a threshold for each pixel: proportional on average, and no pixel is.
  const Function whole_pixels = [](double alpha, int pixel) {
    return alpha * 8 > (pixel * 5 / kRow + pixel * 3) % 8 ? kSamples : 0;
  };
  EXPECT_EQ(trend_by(all, 8), AlphaTrend::disproportionate);
  EXPECT_EQ(trend_by(none, 8), AlphaTrend::disproportionate);
  EXPECT_EQ(trend_by(inverted, 8), AlphaTrend::falling);
  EXPECT_EQ(trend_by(steep, 8), AlphaTrend::disproportionate);
  EXPECT_EQ(trend_by(whole_pixels, 8), AlphaTrend::disproportionate);
}

}  // namespace
}  // namespace edgecase
