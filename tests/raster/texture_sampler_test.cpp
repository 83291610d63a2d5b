// SPDX-License-Identifier: MIT
//
// The sampler at its limits: constants stay what they are, any number has an answer, and wide
// intervals yield all that narrow ones within them do.
#include "raster/texture_stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/rational.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                           Wrap::clamp_to_border};
constexpr Filter kFilters[] = {Filter::nearest, Filter::linear};
constexpr MipFilter kMipFilters[] = {MipFilter::none, MipFilter::nearest, MipFilter::linear};
constexpr TextureFormat kFormats[] = {TextureFormat::rgba8, TextureFormat::srgb8,
                                      TextureFormat::rgba32f};

template <class Visit>
void for_all_samplers(Visit visit) {
  for (const Wrap wrap : kWraps)
    for (const Filter magnify : kFilters)
      for (const Filter minify : kFilters)
        for (const MipFilter mipmap : kMipFilters) {
          Sampler sampler = sampler_of(minify, mipmap, wrap);
          sampler.magnify = magnify;
          visit(sampler);
        }
}

// Whatever is looked up, wherever, at whatever level: the constant, to the bit.
TEST(TextureSampler, ConstantsStayConstant) {
  RandomNumbers numbers(1);
  for (const TextureFormat format : kFormats) {
    const std::array<float, 4> stored{7, 91, 200, 254};
    const Texture texture = chain_of(7, 5, format, [&](int, int, int) { return stored; });
    const DecodedTexture decoded = decode(texture, {});
    const Texel constant = decoded.levels[0].at(0, 0);
    for_all_samplers([&](Sampler sampler) {
      if (sampler.wrap[0] == Wrap::clamp_to_border) return;
      for (int i = 0; i < 40; ++i) {
        const double lambda = i % 4 == 0 ? 0.5 * i / 4 : numbers.real(-2, 5);
        const TextureSample at{{numbers.real(-2, 3), numbers.real(-2, 3)}, lambda};
        const auto boxes = sample(decoded, texture, sampler, {}, at);
        ASSERT_EQ(boxes.size(), 1U);
        ASSERT_TRUE(same_box(boxes[0], constant));
        // However wide what is permitted is.
        const auto permitted = sample(decoded, texture, sampler, {},
                                      {{Interval(at.point.s.low, at.point.s.low + 0.3), at.point.t},
                                       Interval(lambda, lambda + 0.7)},
                                      {0.25, 0.1, true});
        ASSERT_EQ(permitted.size(), 1U);
        ASSERT_TRUE(same_box(permitted[0], constant));
      }
    });
  }
}

// The same through all stages, anisotropic filters included.
TEST(TextureSampler, ConstantsReachTheFragment) {
  const Texture texture = chain_of(9, 6, TextureFormat::rgba8, [](int, int, int) {
    return std::array<float, 4>{7, 91, 200, 255};
  });
  for_all_samplers([&](Sampler sampler) {
    if (sampler.wrap[0] == Wrap::clamp_to_border) return;
    for (const float anisotropy : {1.0F, 5.0F}) {
      sampler.max_anisotropy = anisotropy;
      Scene scene =
          textured_scene(5, 5, texture, {{0, 0}, {5, 5}, {-1.3F, 0.1F}, {2.1F, 1.7F}}, sampler);
      scene.draws[0].vertices[3].w = 3;
      const RuleChoices choices;
      const TextureStage stage(scene, choices);
      for (const ScenePrimitive& primitive : primitives_of(scene)) {
        const auto attributes = attributes_of(primitive, choices, scene.target);
        for (int x = 0; x < 5; ++x) {
          const ExactLookup lookup = stage.look_up(primitive, attributes, {x, x});
          const Fragment fragment = shade(primitive, attributes, {x, x}, &lookup);
          for (std::size_t c = 0; c < 4; ++c)
            ASSERT_EQ(fragment.color[c], middle(stage.decoded(0).levels[0].at(0, 0)[c]));
        }
      }
    }
  });
}

// Coordinates and levels that are no numbers, or endless: some colour of the image, or its border.
TEST(TextureSampler, AnyNumberHasAnAnswer) {
  const Texture texture = chain_of(4, 3, TextureFormat::rgba8, distinct);
  const DecodedTexture decoded = decode(texture, {});
  const double numbers[] = {kNaN, kInfinity, -kInfinity, 1e300, -1e300, 0x1p-1074, 0.3};
  const double levels[] = {kNaN, kInfinity, -kInfinity, 1e300, 0.6};
  for_all_samplers([&](const Sampler& sampler) {
    for (const double s : numbers)
      for (const double t : numbers)
        for (const double lambda : levels) {
          const auto boxes = sample(decoded, texture, sampler, {}, {{s, t}, lambda});
          ASSERT_EQ(boxes.size(), 1U);
          for (const Interval& component : boxes[0]) {
            ASSERT_GE(component.low, 0);
            ASSERT_LE(component.high, 1);
          }
          // As if they were 0.
          const auto finite = [](double value) { return std::isfinite(value) ? value : 0; };
          const auto zero = sample(decoded, texture, sampler, {},
                                   {{finite(s), finite(t)}, std::isnan(lambda) ? 0 : lambda});
          ASSERT_TRUE(same_box(boxes[0], zero[0]));
        }
  });
}

// Everything is permitted where nothing is known: each texel of each level is in a box.
TEST(TextureSampler, NothingKnownIsEverything) {
  const Texture texture = chain_of(4, 3, TextureFormat::rgba8, distinct);
  const DecodedTexture decoded = decode(texture, {});
  const TextureSample unknown{{Interval::everything(), Interval::everything()},
                              Interval::everything()};
  const auto boxes =
      sample(decoded, texture, sampler_of(Filter::nearest, MipFilter::nearest), {}, unknown);
  EXPECT_EQ(boxes.size(), 4U * 3 + 2 * 1 + 1);
  for (const DecodedLevel& level : decoded.levels)
    for (const Texel& texel : level.texels)
      EXPECT_TRUE(std::any_of(boxes.begin(), boxes.end(),
                              [&](const Texel& box) { return same_box(box, texel); }));
}

bool holds(const Texels& boxes, const Texel& color) {
  return std::any_of(boxes.begin(), boxes.end(), [&](const Texel& box) {
    for (std::size_t c = 0; c < 4; ++c)
      if (!edgecase::holds(box[c], color[c])) return false;
    return true;
  });
}

// What any point and lambda within wide intervals yields is among what these yield.
TEST(TextureSampler, WideIntervalsHoldNarrowOnes) {
  RandomNumbers numbers(2);
  for (int i = 0; i < 3'000; ++i) {
    const TextureFormat format = kFormats[i % 3];
    const Texture texture =
        chain_of(static_cast<int>(numbers.integer(1, 9)), static_cast<int>(numbers.integer(1, 9)),
                 format, random_texels(numbers, format));
    const DecodedTexture decoded = decode(texture, {});
    Sampler sampler = sampler_of(kFilters[numbers.integer(0, 1)],
                                 kMipFilters[numbers.integer(0, 2)], kWraps[numbers.integer(0, 3)]);
    sampler.magnify = kFilters[numbers.integer(0, 1)];
    const double s = numbers.real(-2, 2), t = numbers.real(-2, 2), lambda = numbers.real(-1, 3);
    const double width = numbers.real(0, 0.4);
    const auto boxes = sample(
        decoded, texture, sampler, {},
        {{Interval(s, s + width), Interval(t, t + width)}, Interval(lambda, lambda + width)});
    for (int k = 0; k < 5; ++k) {
      const auto within = [&](double low) { return low + numbers.real(0, width); };
      const auto one =
          sample(decoded, texture, sampler, {}, {{within(s), within(t)}, within(lambda)});
      ASSERT_EQ(one.size(), 1U);
      ASSERT_TRUE(holds(boxes, one[0]));
    }
  }
}

TEST(TextureSampler, MixedStaysBetween) {
  const Texel a{Interval(0.25), Interval(0, 0.5), Interval(-1), Interval(kInfinity)};
  const Texel b{Interval(0.75), Interval(0.25, 1), Interval(-1), Interval(1)};
  const Texel half = mixed(a, b, 0.5);
  EXPECT_EQ(half[0].low, 0.5);
  EXPECT_EQ(half[0].high, 0.5);
  EXPECT_EQ(half[1].low, 0.125);
  EXPECT_EQ(half[1].high, 0.75);
  EXPECT_EQ(half[2].low, -1);
  EXPECT_EQ(half[2].high, -1);
  EXPECT_EQ(half[3].low, kInfinity);
  const Texel some = mixed(a, b, Interval(0.25, 0.5));
  EXPECT_EQ(some[0].low, 0.375);
  EXPECT_EQ(some[0].high, 0.5);
  EXPECT_TRUE(same_box(mixed(a, b, 0), a));
  EXPECT_TRUE(same_box(mixed(a, b, 1), b));
}

// (1 - weight) a + weight b lies in what is mixed, of numbers of either sign.
TEST(TextureSampler, MixedHoldsTheMean) {
  RandomNumbers numbers(3);
  for (int i = 0; i < 20'000; ++i) {
    const double a = numbers.real(-1, 1), b = numbers.real(-1, 1);
    const double weight = std::ldexp(numbers.real(0, 1), -static_cast<int>(numbers.integer(0, 8)));
    const Interval found = mixed(Texel{a, a, a, a}, Texel{b, b, b, b}, weight)[0];
    const Rational mean =
        (1 - rational_of(weight)) * rational_of(a) + rational_of(weight) * rational_of(b);
    ASSERT_LE(rational_of(found.low), mean);
    ASSERT_GE(rational_of(found.high), mean);
    ASSERT_LT(width_of(found), 1e-15);
  }
}

// Any number lies between endless ones of opposite signs.
TEST(TextureSampler, OppositeInfinitiesHaveNoMean) {
  const Texel a{Interval(-kInfinity), Interval(kInfinity), Interval(-kInfinity, 1), Interval(0)};
  const Texel b{Interval(kInfinity), Interval(-kInfinity), Interval(kInfinity), Interval(1)};
  for (const Interval weight : {Interval(0.5), Interval(0, 0.5), Interval(0.5, 1)}) {
    const Texel found = mixed(a, b, weight);
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(found[c].low, -kInfinity) << c;
      EXPECT_EQ(found[c].high, kInfinity) << c;
    }
    EXPECT_EQ(found[3].low, weight.low);
    EXPECT_EQ(found[3].high, weight.high);
  }
  EXPECT_TRUE(same_box(mixed(a, b, 0), a));
  EXPECT_TRUE(same_box(mixed(a, b, 1), b));
}

TEST(TextureSampler, HullsHoldEveryComponentOfEveryBox) {
  const Texel a{Interval(1, 2), Interval(3), Interval(-1, 0), Interval(5)};
  const Texel b{Interval(0), Interval(4, 5), Interval(-0.5), Interval(7)};
  const Texel c{Interval(3), Interval(3.5), Interval(-2), Interval(6)};
  const Texel hull{Interval(0, 3), Interval(3, 5), Interval(-2, 0), Interval(5, 7)};
  EXPECT_TRUE(same_box(hull_of({a, b, c}), hull));
  EXPECT_TRUE(same_box(hull_of({b}), b));
}

// Levels of so many texels, each unlike all others, halfway between both levels.
Texels pairs_of(int first, int second) {
  const auto texel = [&](int i, int, int level) {
    const int value = level == 0 ? i : first * i;
    return std::array<float, 4>{static_cast<float>(value), 0, 0, 0};
  };
  Texture texture = chain_of(first, 1, TextureFormat::rgba32f, texel);
  texture.dimensions = 1;
  const DecodedTexture decoded =
      decode(texture, {texture.levels[0], level_of(second, 1, 1, texel)});
  const TextureSample unknown{{Interval::everything(), Interval::everything()}, Interval(0.5)};
  return sample(decoded, texture, sampler_of(Filter::nearest, MipFilter::linear), {}, unknown);
}

// Of up to 1,000 pairs each is a colour; of more, each colour of the first level is a box.
TEST(TextureSampler, ManyPairsShareBoxes) {
  const auto points = pairs_of(40, 25);
  EXPECT_EQ(points.size(), 1000U);
  for (const Texel& point : points) EXPECT_EQ(point[0].low, point[0].high);
  for (const auto& [first, second] : {std::pair{77, 13}, std::pair{500, 3}}) {
    const auto boxes = pairs_of(first, second);
    EXPECT_EQ(boxes.size(), static_cast<std::size_t>(first));
    for (const Texel& box : boxes) EXPECT_EQ(width_of(box[0]), first * (second - 1) / 2.0);
  }
}

// A lambda with one end that is no number is endless there; with two it is 0, on the crossover.
TEST(TextureSampler, HalfKnownLevels) {
  const Texture texture = chain_of(8, 8, TextureFormat::rgba32f, [](int, int, int level) {
    return std::array<float, 4>{static_cast<float>(level), 0, 0, 0};
  });
  const DecodedTexture decoded = decode(texture, {});
  const auto levels = [&](const Sampler& sampler, Interval lambda, const SampleLatitude& latitude) {
    std::vector<double> found;
    for (const Texel& box : sample(decoded, texture, sampler, {}, {{0.5, 0.5}, lambda}, latitude))
      found.push_back(box[0].low);
    return found;
  };
  const Sampler sampler = sampler_of(Filter::nearest, MipFilter::nearest);
  EXPECT_EQ(levels(sampler, {1.75, kNaN}, {}), (std::vector<double>{2, 3}));
  EXPECT_EQ(levels(sampler, {kNaN, 1.25}, {}), (std::vector<double>{0, 1}));
  EXPECT_EQ(levels(sampler, {kNaN, kNaN}, {}), (std::vector<double>{0}));
  EXPECT_EQ(SampleLatitude{}.texel, 0);
  EXPECT_EQ(SampleLatitude{}.weight, 0);
  // At 0 a latitude of ties takes both filters.
  const Texture two = single_of(2, 1, TextureFormat::rgba32f, distinct);
  Sampler filters = sampler_of(Filter::linear, MipFilter::none);
  filters.magnify = Filter::nearest;
  const auto boxes =
      sample(decode(two, {}), two, filters, {}, {{0.5, 0.5}, {kNaN, kNaN}}, {0, 0, true});
  EXPECT_EQ(boxes.size(), 2U);
}

// A chain that ends early is used up to its end.
TEST(TextureSampler, ShortChainsEndEarly) {
  const Texture texture = chain_of(8, 2, TextureFormat::rgba8, distinct);
  const DecodedTexture decoded = decode(texture, {texture.levels[0], texture.levels[1]});
  const Sampler sampler = sampler_of(Filter::nearest, MipFilter::nearest);
  EXPECT_EQ(last_level_of(decoded, sampler, texture), 1);
  EXPECT_EQ(last_level_of(decode(texture, {}), sampler, texture), 3);
  const auto boxes = sample(decoded, texture, sampler, {}, {{0, 0}, 9});
  ASSERT_EQ(boxes.size(), 1U);
  EXPECT_TRUE(same_box(boxes[0], decoded.levels[1].at(0, 0)));
  // Also where the base level lies beyond it.
  Sampler beyond = sampler;
  beyond.base_level = 3;
  for (const double lambda : {-1.0, 1.0}) {
    const auto found = sample(decoded, texture, beyond, {}, {{0, 0}, lambda});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(same_box(found[0], decoded.levels[1].at(0, 0)));
  }
}

}  // namespace
}  // namespace edgecase
