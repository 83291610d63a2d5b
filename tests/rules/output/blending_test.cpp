// SPDX-License-Identifier: MIT
#include "rules/output/blending.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/oracles/blend_tables.h"
#include "tests/rules/output/blend_presets.h"
#include "tests/rules/values/interpolants.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using oracle::Fraction;
using oracle::FractionColor;
using oracle::RoundedSteps;
using Numbers = std::array<double, 4>;

Rgba8 nearest_codes(const FractionColor& color) {
  Rgba8 result{};
  for (std::size_t i = 0; i < 4; ++i) result[i] = as_code(oracle::nearest_code(color[i]));
  return result;
}

Rgba8 by_oracle(const Blending& blending, const Numbers& source, const Rgba8& destination,
                RoundedSteps steps) {
  FractionColor s, d;
  for (std::size_t i = 0; i < 4; ++i) {
    s[i] = Fraction(source[i]);
    d[i] = Fraction(destination[i], 255);
  }
  return nearest_codes(oracle::blended_colors(blending, s, d, steps));
}

Rgba8 written(const Blending& blending, const Numbers& source, const Rgba8& destination,
              const BlendChoice& choice = {}) {
  return written_color(blending_by(blending), source, destination, choice);
}

struct Way {
  BlendRounding rounding;
  RoundedSteps steps;
};
constexpr Way kWays[] = {{BlendRounding::once, {false, false}},
                         {BlendRounding::source_first, {true, false}},
                         {BlendRounding::every_product, {true, true}}};

void expect_as_oracle(const Blending& blending, const Numbers& source, const Rgba8& destination) {
  for (const auto& [rounding, steps] : kWays)
    ASSERT_EQ(written(blending, source, destination, {.rounding = rounding}),
              by_oracle(blending, source, destination, steps))
        << name_of(rounding) << " " << name_of(blending.color.equation) << " "
        << name_of(blending.color.source) << " " << name_of(blending.color.destination) << " "
        << ::testing::PrintToString(source) << ::testing::PrintToString(destination);
}

// Colours that tie (halves of codes), that do not (tenths), at the ends, and beyond them.
const std::vector<Numbers> kSources = {{0.5, 0.25, 0.75, 0.5},
                                       {0.1, 0.9, 1.0 / 3, 0.6},
                                       {0, 1, -0.5, 1.5},
                                       {2.0 / 255, 128.5 / 255, 1, 0}};
const std::vector<Rgba8> kDestinations = {{0, 255, 128, 127}, {3, 77, 254, 255}, {1, 200, 51, 0}};

TEST(Blending, OfAllFactorsAndEquationsIsThatOfTheTables) {
  Dealer dealer;
  for (const BlendEquation equation : kBlendEquations)
    for (const BlendFactor source : kBlendFactors)
      for (const BlendFactor destination : kBlendFactors) {
        // Alpha's own term is another one.
        const Blending blending{{equation, source, destination},
                                {equation, destination, source},
                                {0.5F, 0.2F, 1, 0.7F}};
        for (const Numbers& color : kSources)
          for (const Rgba8& stored : kDestinations)
            if (dealer.deal()) expect_as_oracle(blending, color, stored);
      }
}

TEST(Blending, ColourAndAlphaHaveTheirOwnEquations) {
  for (const BlendEquation color : kBlendEquations)
    for (const BlendEquation alpha : kBlendEquations)
      expect_as_oracle({{color, BlendFactor::one, BlendFactor::src_color},
                        {alpha, BlendFactor::dst_alpha, BlendFactor::one}},
                       kSources[1], kDestinations[0]);
}

// Every alpha over every stored value: of three colours at once, and of alpha itself.
TEST(Blending, OverOfEveryAlphaAndEveryStoredValue) {
  Dealer dealer;
  for (int alpha = 0; alpha < 256; ++alpha)
    for (int stored = 0; stored < 256; ++stored) {
      if (!dealer.deal()) continue;
      const Numbers source = {1, alpha / 255.0, static_cast<double>(0.3F), alpha / 255.0};
      const Rgba8 destination = {as_code(stored), as_code(stored), as_code(stored),
                                 as_code(stored)};
      expect_as_oracle(over(), source, destination);
      if (HasFatalFailure()) return;
    }
}

TEST(Blending, RandomNumbersRoundAsFractionsDo) {
  RandomNumbers numbers(share_seed(37));
  const auto any = [&](const auto& of) {
    return of[static_cast<std::size_t>(numbers.integer(0, std::ssize(of) - 1))];
  };
  const auto any_term = [&] {
    const BlendEquation equation = any(kBlendEquations);
    const BlendFactor source = any(kBlendFactors);
    return BlendTerm{equation, source, any(kBlendFactors)};
  };
  const auto any_number = [&] {
    // Half of them halves of codes, so near to a border that only fractions tell.
    return numbers.one_in(2) ? static_cast<double>(numbers.integer(0, 510)) / 510
                             : numbers.attribute(1);
  };
  for (int i = 0; i < share_of(5000, 500); ++i) {
    Blending blending;
    blending.color = any_term();
    blending.alpha = any_term();
    Numbers source;
    Rgba8 destination;
    for (std::size_t k = 0; k < 4; ++k) {
      blending.constant[k] = static_cast<float>(numbers.real(0, 1));
      source[k] = any_number();
      destination[k] = as_code(numbers.integer(0, 255));
    }
    expect_as_oracle(blending, source, destination);
    if (HasFatalFailure()) return;
  }
}

// A tie that is exact, and numbers one unit in the last place beside it.
// The doubles around the middle between each code and the next; 1/2, a tie, is among them.
TEST(Blending, SourcesBetweenCodesAreRoundedFirst) {
  const Blending replace;
  for (int code = 0; code < 255; ++code) {
    double source = (code + 0.5) / 255;
    for (int i = 0; i < 4; ++i) source = std::nextafter(source, 0);
    for (int i = 0; i < 9; ++i, source = std::nextafter(source, 1))
      expect_as_oracle(replace, {source, 1, 0, source}, {1, 2, 3, 4});
  }
}

TEST(Blending, RoundsTiesToTheEvenValue) {
  const Blending replace;
  const auto red = [&](double value) { return int{written(replace, {value, 0, 0, 0}, {})[0]}; };
  EXPECT_EQ(red(0.5), 128);
  EXPECT_EQ(red(std::nextafter(0.5, 0)), 127);
  EXPECT_EQ(red(0.1), 26);  // the double above 25.5/255
  EXPECT_EQ(red(std::nextafter(0.1, 0)), 25);
  EXPECT_EQ(red(0.3), 76);  // the double below 76.5/255
  // 0.5 + 1/255 and + 2/255: 128.5 and 129.5.
  const Blending& add = kBlendPresets[2].blending;
  EXPECT_EQ(written(add, {0.5, 0.5, 0.5, 0.5}, {1, 2, 3, 4}), (Rgba8{128, 130, 130, 132}));
}

TEST(Blending, WithoutBlendingTheSourceIsStored) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const FragmentOperations none;
  EXPECT_EQ(written_color(none, {0.5, nan, infinity, -infinity}, {9, 9, 9, 9}, {}),
            (Rgba8{128, 0, 255, 0}));
  EXPECT_EQ(written_color(blending_by(over()), {nan, infinity, 0.5, nan}, {9, 8, 7, 6}, {}),
            (Rgba8{9, 8, 7, 6}));
}

TEST(Blending, MaskedComponentsKeepWhatIsStored) {
  for (int mask = 0; mask < 16; ++mask)
    for (const bool blends : {false, true}) {
      FragmentOperations operations = blends ? blending_by(over()) : FragmentOperations{};
      const Numbers source = {1, 0.5, 0.25, 0.75};
      const Rgba8 destination = {10, 20, 30, 40};
      const Rgba8 all = written_color(operations, source, destination, {});
      Rgba8 expected = destination;
      for (std::size_t i = 0; i < 4; ++i) {
        operations.color_mask[i] = (mask >> i & 1) != 0;
        if (operations.color_mask[i]) expected[i] = all[i];
      }
      EXPECT_EQ(written_color(operations, source, destination, {}), expected) << mask;
      EXPECT_EQ(written_color(operations, source, destination, {.mask = ColorMaskMethod::ignored}),
                all);
    }
}

TEST(Blending, AlternativesOfTheEquation) {
  const Numbers source = {1, 0.4, 0, 0.2};
  const Rgba8 destination = {0, 100, 255, 50};
  const auto by = [&](BlendMethod method) {
    return written(over(), source, destination, {.method = method});
  };
  // 1/5 of the source and 4/5 of what is stored; alpha 1/5 + 4/5 of 50/255.
  EXPECT_EQ(by(BlendMethod::as_set), (Rgba8{51, 100, 204, 91}));
  EXPECT_EQ(by(BlendMethod::ignored), (Rgba8{255, 102, 0, 51}));
  // 1/25 + 4/5 of 50/255.
  EXPECT_EQ(by(BlendMethod::color_for_alpha), (Rgba8{51, 100, 204, 50}));
  // 4/5 of the source and 1/5 of what is stored; alpha 4/25 + 50/255.
  EXPECT_EQ(by(BlendMethod::swapped), (Rgba8{204, 102, 51, 91}));
  // The whole source and 4/5 of what is stored.
  EXPECT_EQ(by(BlendMethod::over_as_premultiplied), (Rgba8{255, 182, 204, 91}));
  EXPECT_EQ(by(BlendMethod::over_as_straight), by(BlendMethod::as_set));
}

// The factors and alphas are powers of two, so that products are exact.
TEST(Blending, MinAndMaxIgnoreFactorsUnlessAnAlternativeAppliesThem) {
  const Numbers source = {1, 0.6, 0.2, 0.5};
  const Rgba8 destination = {100, 100, 100, 100};
  const auto by = [&](BlendEquation equation, BlendMethod method) {
    const BlendTerm term{equation, BlendFactor::one, BlendFactor::zero};
    return written({term, term, {}}, source, destination, {.method = method});
  };
  using enum BlendMethod;
  EXPECT_EQ(by(BlendEquation::min, as_set), (Rgba8{100, 100, 51, 100}));
  EXPECT_EQ(by(BlendEquation::max, as_set), (Rgba8{255, 153, 100, 128}));
  EXPECT_EQ(by(BlendEquation::min, factors_in_min_and_max), (Rgba8{0, 0, 0, 0}));
  EXPECT_EQ(by(BlendEquation::max, factors_in_min_and_max), (Rgba8{255, 153, 51, 128}));
  // Half of 1, 0.6 and 0.2; alpha as it is.
  EXPECT_EQ(by(BlendEquation::min, source_alpha_in_min_and_max), (Rgba8{100, 76, 26, 100}));
  EXPECT_EQ(by(BlendEquation::max, source_alpha_in_min_and_max), (Rgba8{128, 100, 100, 128}));
  for (const BlendMethod method : {factors_in_min_and_max, source_alpha_in_min_and_max})
    EXPECT_EQ(by(BlendEquation::add, method), by(BlendEquation::add, as_set));
}

// A difference below 0 is 0, or as much below 1.
TEST(Blending, DifferencesAreClampedUnlessAnAlternativeWrapsThem) {
  const Numbers source = {1, 0.6, 0.2, 0.5};
  const Rgba8 destination = {100, 100, 100, 100};
  const auto by = [&](BlendEquation equation, BlendMethod method) {
    const BlendTerm term{equation, BlendFactor::one, BlendFactor::one};
    return written({term, term, {}}, source, destination, {.method = method});
  };
  using enum BlendMethod;
  EXPECT_EQ(by(BlendEquation::subtract, as_set), (Rgba8{155, 53, 0, 28}));
  EXPECT_EQ(by(BlendEquation::subtract, differences_wrapped), (Rgba8{155, 53, 206, 28}));
  EXPECT_EQ(by(BlendEquation::reverse_subtract, as_set), (Rgba8{0, 0, 49, 0}));
  EXPECT_EQ(by(BlendEquation::reverse_subtract, differences_wrapped), (Rgba8{100, 202, 49, 228}));
  EXPECT_EQ(by(BlendEquation::add, differences_wrapped), by(BlendEquation::add, as_set));
  for (const BlendRounding rounding : values_of<BlendRounding>()) {
    const BlendTerm term{BlendEquation::subtract, BlendFactor::one, BlendFactor::one};
    EXPECT_EQ(written({term, term, {}}, {0, 0, 0, 0}, {255, 51, 1, 0},
                      {.method = differences_wrapped, .rounding = rounding}),
              (Rgba8{0, 204, 254, 0}));
  }
}

// Each form of over taken for the other is the other; no other blending is touched.
TEST(Blending, FormsOfOverAreTakenForEachOther) {
  const Blending& premultiplied = kBlendPresets[1].blending;
  ASSERT_EQ(premultiplied.color.source, BlendFactor::one);
  const auto taken = [](BlendMethod method) { return BlendChoice{.method = method}; };
  const BlendChoice as_premultiplied = taken(BlendMethod::over_as_premultiplied);
  const BlendChoice as_straight = taken(BlendMethod::over_as_straight);
  const auto is_form = [](const BlendTerm& term, BlendFactor source) {
    return term.equation == BlendEquation::add && term.source == source &&
           term.destination == BlendFactor::one_minus_src_alpha;
  };
  for (const Numbers& source : kSources)
    for (const Rgba8& stored : kDestinations) {
      EXPECT_EQ(written(over(), source, stored, as_premultiplied),
                by_oracle(premultiplied, source, stored, {false, false}));
      EXPECT_EQ(written(premultiplied, source, stored, as_straight),
                by_oracle(over(), source, stored, {false, false}));
      for (const BlendEquation equation : kBlendEquations)
        for (const BlendFactor of_source : kBlendFactors)
          for (const BlendFactor of_stored : kBlendFactors) {
            const BlendTerm term{equation, of_source, of_stored};
            // Alpha's own term stays, even where it has the form.
            const Blending blending{
                term,
                {BlendEquation::add, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha},
                {}};
            const Rgba8 plain = written(blending, source, stored);
            const Rgba8 first = written(blending, source, stored, as_premultiplied);
            const Rgba8 second = written(blending, source, stored, as_straight);
            EXPECT_EQ(first[3], plain[3]);
            EXPECT_EQ(second[3], plain[3]);
            EXPECT_TRUE(first == plain || is_form(term, BlendFactor::src_alpha));
            EXPECT_TRUE(second == plain || is_form(term, BlendFactor::one));
          }
    }
}

// For every pair of roundings, over of some alpha and stored value tells them apart.
TEST(Blending, AlternativesOfRoundingDiffer) {
  const Rgba8 stored = {180, 180, 180, 180};
  const auto by = [&](const Numbers& source, BlendRounding rounding) {
    return int{written(over(), source, stored, {.rounding = rounding})[0]};
  };
  std::array<int, 3> differing{};
  for (int alpha = 0; alpha < 256; ++alpha) {
    const Numbers source = {static_cast<double>(0.3F), 0, 0, alpha / 255.0};
    const int once = by(source, BlendRounding::once);
    const int source_first = by(source, BlendRounding::source_first);
    const int every_product = by(source, BlendRounding::every_product);
    differing[0] += once != source_first ? 1 : 0;
    differing[1] += once != every_product ? 1 : 0;
    differing[2] += source_first != every_product ? 1 : 0;
  }
  for (const int count : differing) EXPECT_GT(count, 10);
}

// Shifting takes one of the two codes next to the quotient, and not always the nearest.
TEST(Blending, ShiftedProductsOfAllCodes) {
  const BlendTerm product{BlendEquation::add, BlendFactor::dst_color, BlendFactor::zero};
  const BlendChoice shifted{.rounding = BlendRounding::shifted};
  int other_than_nearest = 0;
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; ++b) {
      const int p = a * b;
      const int expected = (p + p / 256 + 128) / 256;
      const Numbers source = {a / 255.0, 0, 0, 0};
      const Rgba8 stored = {as_code(b), 0, 0, 0};
      ASSERT_EQ(written({product, product, {}}, source, stored, shifted)[0], expected);
      ASSERT_TRUE(expected == p / 255 || expected == (p + 254) / 255) << a << " " << b;
      other_than_nearest += expected != oracle::nearest_code(Fraction(p) / (255 * 255)) ? 1 : 0;
    }
  EXPECT_EQ(other_than_nearest, 24);
}

}  // namespace
}  // namespace edgecase
