// SPDX-License-Identifier: MIT
//
// How many operations a lookup takes, counted by hand: errors of texture colours are multiples of
// it.
#include "rules/textures/texel_filter.h"

#include <gtest/gtest.h>

namespace edgecase {
namespace {

Sampler sampler_of(Filter magnify, Filter minify, MipFilter mipmap, float anisotropy = 1) {
  Sampler sampler;
  sampler.magnify = magnify;
  sampler.minify = minify;
  sampler.mipmap = mipmap;
  sampler.max_anisotropy = anisotropy;
  return sampler;
}

Texture texture_of(int dimensions) {
  Texture texture;
  texture.dimensions = dimensions;
  return texture;
}

constexpr Filter kNearest = Filter::nearest;
constexpr Filter kLinear = Filter::linear;

TEST(LookupPrecision, EitherFilterTakesMeans) {
  EXPECT_FALSE(has_linear_filter(sampler_of(kNearest, kNearest, MipFilter::linear)));
  EXPECT_TRUE(has_linear_filter(sampler_of(kLinear, kNearest, MipFilter::none)));
  EXPECT_TRUE(has_linear_filter(sampler_of(kNearest, kLinear, MipFilter::none)));
  EXPECT_TRUE(has_linear_filter(sampler_of(kLinear, kLinear, MipFilter::none)));
}

TEST(LookupPrecision, AMeanOfEachAxisAndOneOfLevels) {
  const auto means = [](Filter filter, MipFilter mipmap, int dimensions) {
    return means_of(sampler_of(kNearest, filter, mipmap), texture_of(dimensions));
  };
  for (const MipFilter one_level : {MipFilter::none, MipFilter::nearest}) {
    EXPECT_EQ(means(kNearest, one_level, 1), 0);
    EXPECT_EQ(means(kNearest, one_level, 2), 0);
    EXPECT_EQ(means(kLinear, one_level, 1), 1);
    EXPECT_EQ(means(kLinear, one_level, 2), 2);
  }
  EXPECT_EQ(means(kNearest, MipFilter::linear, 2), 1);
  EXPECT_EQ(means(kLinear, MipFilter::linear, 1), 2);
  EXPECT_EQ(means(kLinear, MipFilter::linear, 2), 3);
}

TEST(LookupPrecision, ThreeOperationsAMeanAndOneAProbe) {
  const auto operations = [](Filter filter, MipFilter mipmap, float anisotropy) {
    return operations_of(sampler_of(kNearest, filter, mipmap, anisotropy), texture_of(2));
  };
  EXPECT_EQ(operations(kNearest, MipFilter::none, 1), 1);
  EXPECT_EQ(operations(kLinear, MipFilter::none, 1), 7);
  EXPECT_EQ(operations(kLinear, MipFilter::linear, 1), 10);
  EXPECT_EQ(operations(kNearest, MipFilter::none, 1.5F), 3);
  EXPECT_EQ(operations(kLinear, MipFilter::linear, 2), 12);
  EXPECT_EQ(operations(kLinear, MipFilter::linear, 16), 26);
}

}  // namespace
}  // namespace edgecase
