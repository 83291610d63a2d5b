// SPDX-License-Identifier: MIT
//
// The latitude of blending: it holds every result that is rounded at will on the way, and no more
// where the formula uses each number once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/oracles/blend_tables.h"
#include "tests/rules/output/blend_presets.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

using oracle::Fraction;
using Numbers = std::array<double, 4>;

std::array<Interval, 4> points(const Numbers& source) {
  return {source[0], source[1], source[2], source[3]};
}

Rgba8Range point_codes(const Rgba8& codes) {
  Rgba8Range result;
  for (std::size_t i = 0; i < 4; ++i) result[i] = {codes[i], codes[i]};
  return result;
}

Rgba8Range permitted(const Blending& blending, const Numbers& source, const Rgba8& destination) {
  return permitted_color(blending_by(blending), points(source), point_codes(destination));
}

bool holds(const Unorm8Range& range, int code) {
  return range.low <= code && code <= range.high;
}

class BlendingLatitude : public ::testing::Test {
 protected:
  template <class Values>
  auto any(const Values& of) {
    return of[static_cast<std::size_t>(numbers_.integer(0, std::ssize(of) - 1))];
  }
  BlendTerm any_term() {
    const BlendEquation equation = any(kBlendEquations);
    const BlendFactor source = any(kBlendFactors);
    return {equation, source, any(kBlendFactors)};
  }
  Blending any_blending() {
    Blending blending;
    blending.color = any_term();
    blending.alpha = any_term();
    for (float& value : blending.constant) value = static_cast<float>(numbers_.real(0, 1));
    return blending;
  }
  // Codes, numbers between them, and numbers beyond 0 to 1.
  Numbers any_source() {
    Numbers source;
    for (double& value : source)
      value = numbers_.one_in(3)
                  ? static_cast<double>(numbers_.integer(0, 255)) / 255
                  : static_cast<double>(static_cast<float>(numbers_.real(-0.2, 1.2)));
    return source;
  }
  Rgba8 any_codes() {
    Rgba8 codes;
    for (std::uint8_t& code : codes) code = as_code(numbers_.integer(0, 255));
    return codes;
  }

  RandomNumbers numbers_{20261122};
};

TEST_F(BlendingLatitude, HoldsWhatEveryOpenRoundingWrites) {
  for (int i = 0; i < 50000; ++i) {
    const Blending blending = any_blending();
    const Numbers source = any_source();
    const Rgba8 destination = any_codes();
    const Rgba8Range range = permitted(blending, source, destination);
    for (const BlendRounding rounding : values_of<BlendRounding>()) {
      const Rgba8 written =
          written_color(blending_by(blending), source, destination, {.rounding = rounding});
      for (std::size_t k = 0; k < 4; ++k)
        ASSERT_TRUE(holds(range[k], written[k])) << name_of(rounding) << " component " << k;
    }
  }
}

// Wider sources and destinations hold what narrower ones do.
TEST_F(BlendingLatitude, OfRangesHoldsThatOfTheirPoints) {
  for (int i = 0; i < 20000; ++i) {
    FragmentOperations operations = blending_by(any_blending());
    for (bool& written : operations.color_mask) written = !numbers_.one_in(4);
    const Numbers low = any_source(), high = any_source();
    const Rgba8 first = any_codes(), last = any_codes();
    std::array<Interval, 4> source;
    Rgba8Range destination;
    for (std::size_t k = 0; k < 4; ++k) {
      source[k] = {std::min(low[k], high[k]), std::max(low[k], high[k])};
      destination[k] = {std::min(first[k], last[k]), std::max(first[k], last[k])};
    }
    const Rgba8Range range = permitted_color(operations, source, destination);
    for (const Numbers& point : {low, high})
      for (const Rgba8& codes : {first, last}) {
        const Rgba8 written = written_color(operations, point, codes, {});
        for (std::size_t k = 0; k < 4; ++k) ASSERT_TRUE(holds(range[k], written[k]));
      }
  }
}

// A number, and its neighbours among the multiples of 1/255.
std::vector<Fraction> rounded_at_will(const Fraction& value) {
  const Fraction scaled = 255 * value;
  auto below =
      static_cast<int>(boost::multiprecision::cpp_int(numerator(scaled) / denominator(scaled)));
  if (scaled < below) --below;
  if (scaled == below) return {value};
  return {value, Fraction(below, 255), Fraction(below + 1, 255)};
}

// All that the products of a number and a factor may be, each rounded at will; `of`: the number
// that the factor is made of, `complement`: 1 less it.
std::set<Fraction> products(const Fraction& value, const Fraction& of, bool complement) {
  std::set<Fraction> result;
  for (const Fraction& v : rounded_at_will(value))
    for (const Fraction& f : rounded_at_will(of))
      for (const Fraction& product :
           rounded_at_will(complement ? Fraction(v * (1 - f)) : Fraction(v * f)))
        result.insert(product);
  return result;
}

// The colour of `over`: source, alpha and what is stored each occur once in a product, so that the
// extremes of both products meet.
TEST_F(BlendingLatitude, IsAsWideAsRoundingAtWillMakesIt) {
  for (int i = 0; i < 2000; ++i) {
    const Numbers source = {numbers_.real(0, 1), 0, 0, numbers_.real(0, 1)};
    const Rgba8 destination = any_codes();
    const auto above = products(Fraction(source[0]), Fraction(source[3]), false);
    const auto below = products(Fraction(destination[0], 255), Fraction(source[3]), true);
    const Fraction least = 255 * (*above.begin() + *below.begin());
    const Fraction most = 255 * (*above.rbegin() + *below.rbegin());
    const Unorm8Range range = permitted(over(), source, destination)[0];
    ASSERT_EQ(Fraction(range.low), least);
    ASSERT_EQ(Fraction(range.high), std::min(most, Fraction(255)));
  }
}

// The largest width that a preset has, of a colour and of alpha, over all codes that are stored and
// sources beside every code.
TEST_F(BlendingLatitude, OfAPresetIsAFewValuesWide) {
  constexpr int kWidths[][2] = {{5, 3}, {3, 3}, {1, 1}, {2, 2}};
  for (std::size_t preset = 0; preset < std::size(kBlendPresets); ++preset) {
    int color = 0, alpha = 0;
    for (int s = 0; s < 255; s += 6)
      for (int a = 0; a < 255; ++a)
        for (int d = 0; d < 256; d += 3) {
          const Numbers source = {(s + 0.5) / 255, 0, 0, (a + 0.5) / 255};
          const Rgba8 destination = {as_code(d), 0, 0, as_code(d)};
          const Rgba8Range range = permitted(kBlendPresets[preset].blending, source, destination);
          color = std::max(color, range[0].high - range[0].low);
          alpha = std::max(alpha, range[3].high - range[3].low);
        }
    EXPECT_EQ(color, kWidths[preset][0]) << kBlendPresets[preset].name;
    EXPECT_EQ(alpha, kWidths[preset][1]) << kBlendPresets[preset].name;
  }
}

TEST_F(BlendingLatitude, OfZeroAndOneHasNoError) {
  const Rgba8 destination = {0, 77, 255, 128};
  const auto expect_kept = [&](const Blending& blending, const Numbers& source) {
    const Rgba8Range range = permitted(blending, source, destination);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(range[i].low, destination[i]);
      EXPECT_EQ(range[i].high, destination[i]);
    }
  };
  const BlendTerm keep = blend_term(BlendFactor::zero, BlendFactor::one);
  expect_kept({keep, keep}, {0.3, 0.4, 0.5, 0.6});
  expect_kept(over(), {0, 0, 0, 0});
  const Rgba8Range opaque = permitted(over(), {1, 0, 1, 1}, destination);
  EXPECT_EQ(opaque[0].low, 255);
  EXPECT_EQ(opaque[1].high, 0);
  EXPECT_EQ(opaque[3].low, 255);
}

TEST_F(BlendingLatitude, WithoutBlendingIsThatOfTheConversion) {
  FragmentOperations operations;
  operations.color_mask = {true, true, false, true};
  const Rgba8Range destination = {{{1, 2}, {3, 4}, {5, 6}, {7, 8}}};
  const Interval source(0.3, 0.5);
  const Rgba8Range range =
      permitted_color(operations, {source, 0.25, source, Interval::everything()}, destination);
  EXPECT_EQ(range[0].low, unorm8_permitted(source).low);
  EXPECT_EQ(range[0].high, unorm8_permitted(source).high);
  EXPECT_EQ(range[1].low, 63);
  EXPECT_EQ(range[1].high, 64);
  EXPECT_EQ(range[2].low, 5);
  EXPECT_EQ(range[2].high, 6);
  EXPECT_EQ(range[3].low, 0);
  EXPECT_EQ(range[3].high, 255);
}

// The doubles of codes lie beside them: one of the neighbours is the code, and 255 times the double
// rounds to it.
TEST_F(BlendingLatitude, OfASourceBesideACodeHoldsBothNeighbours) {
  int below = 0, above = 0;
  for (int code = 1; code < 255; ++code) {
    const double source = code / 255.0;
    const Unorm8Range range = permitted(Blending{}, {source, 0, 0, 0}, {0, 0, 0, 0})[0];
    // Rounded once, so that the sign is that of the exact number.
    const double rest = std::fma(source, 255.0, -static_cast<double>(code));
    const bool is_less = rest < 0;
    const bool is_more = rest > 0;
    EXPECT_EQ(range.low, is_less ? code - 1 : code);
    EXPECT_EQ(range.high, is_more ? code + 1 : code);
    below += is_less ? 1 : 0;
    above += is_more ? 1 : 0;
  }
  EXPECT_GT(below, 50);
  EXPECT_GT(above, 50);
}

}  // namespace
}  // namespace edgecase
