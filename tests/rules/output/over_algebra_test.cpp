// SPDX-License-Identifier: MIT
//
// The algebra of `over`: what is put together of three layers does not depend on which two are put
// together first, but on their order it does.
//
// The formula is the one that the rules evaluate, of fractions. Layers are premultiplied: colours
// that cover as much of a pixel as their alpha says.
#include <gtest/gtest.h>

#include "exact/rational.h"
#include "rules/output/blending.h"
#include "tests/rules/output/blend_presets.h"
#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

using Layer = std::array<Rational, 4>;

Layer blended_layers(const Blending& blending, const Layer& source, const Layer& destination) {
  const BlendOperands<Rational> operands{source, destination, {}, 1};
  Layer result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = blended(i == kAlpha ? blending.alpha : blending.color, operands, i);
  return result;
}

Layer put_over(const Layer& source, const Layer& destination) {
  return blended_layers(kBlendPresets[1].blending, source, destination);
}

class OverAlgebra : public ::testing::Test {
 protected:
  Rational share() {
    const std::int64_t below = numbers_.integer(1, 1000);
    return {numbers_.integer(0, below), below};
  }
  // A colour that is not premultiplied.
  Layer color() { return {share(), share(), share(), share()}; }
  Layer layer() { return premultiplied(color()); }
  static Layer premultiplied(const Layer& color) {
    return {color[0] * color[3], color[1] * color[3], color[2] * color[3], color[3]};
  }

  RandomNumbers numbers_{17};
};

TEST_F(OverAlgebra, IsAssociative) {
  for (int i = 0; i < 2000; ++i) {
    const Layer a = layer(), b = layer(), c = layer();
    ASSERT_EQ(put_over(a, put_over(b, c)), put_over(put_over(a, b), c));
  }
}

TEST_F(OverAlgebra, IsNotCommutative) {
  const Layer red = {Rational(1, 2), 0, 0, Rational(1, 2)};
  const Layer blue = {0, 0, Rational(1, 2), Rational(1, 2)};
  const Rational half(1, 2), quarter(1, 4), alpha(3, 4);
  EXPECT_EQ(put_over(red, blue), (Layer{half, 0, quarter, alpha}));
  EXPECT_EQ(put_over(blue, red), (Layer{quarter, 0, half, alpha}));
  int differing = 0;
  for (int i = 0; i < 1000; ++i) {
    const Layer a = layer(), b = layer();
    // Coverage alone does commute: 1 - (1 - a)(1 - b).
    EXPECT_EQ(put_over(a, b)[3], put_over(b, a)[3]);
    differing += put_over(a, b) != put_over(b, a) ? 1 : 0;
  }
  EXPECT_GT(differing, 900);
}

TEST_F(OverAlgebra, NothingChangesNothing) {
  const Layer nothing{};
  for (int i = 0; i < 100; ++i) {
    const Layer a = layer();
    EXPECT_EQ(put_over(a, nothing), a);
    EXPECT_EQ(put_over(nothing, a), a);
  }
}

// Colours over a layer, and their premultiplied forms by the premultiplied equation: the same.
TEST_F(OverAlgebra, HasTwoFormsThatAgree) {
  for (int i = 0; i < 1000; ++i) {
    const Layer above = color(), below = layer();
    ASSERT_EQ(blended_layers(over(), above, below), put_over(premultiplied(above), below));
  }
}

// Taken for premultiplied, colours yield something else; and `over` of colours that are not
// premultiplied is not associative: it multiplies what is stored as if it were.
TEST_F(OverAlgebra, NeedsPremultipliedLayersToBeAssociative) {
  const auto plain = [](const Layer& a, const Layer& b) { return blended_layers(over(), a, b); };
  int differing = 0;
  for (int i = 0; i < 100; ++i) {
    const Layer a = color(), b = color(), c = color();
    differing += plain(a, plain(b, c)) != plain(plain(a, b), c) ? 1 : 0;
  }
  EXPECT_GT(differing, 90);
}

// What is stored shows it too: half red drawn before or after half blue, on black.
TEST_F(OverAlgebra, StoredColoursShowTheOrder) {
  const auto drawn = [](const std::array<double, 4>& first, const std::array<double, 4>& second) {
    const FragmentOperations operations = blending_by(over());
    return written_color(operations, second, written_color(operations, first, {0, 0, 0, 255}, {}),
                         {});
  };
  const std::array<double, 4> red = {1, 0, 0, 0.5};
  const std::array<double, 4> blue = {0, 0, 1, 0.5};
  EXPECT_EQ(drawn(red, blue), (Rgba8{64, 0, 128, 255}));
  EXPECT_EQ(drawn(blue, red), (Rgba8{128, 0, 64, 255}));
}

// Rounded to 8 bits after each layer, it is associative no more.
TEST_F(OverAlgebra, RoundingBreaksAssociativity) {
  const FragmentOperations operations = blending_by(kBlendPresets[1].blending);
  const auto put = [&](const Rgba8& source, const Rgba8& destination) {
    std::array<double, 4> numbers;
    for (std::size_t i = 0; i < 4; ++i) numbers[i] = source[i] / 255.0;
    return written_color(operations, numbers, destination, {});
  };
  const auto any_layer = [&] {
    Rgba8 codes;
    codes[3] = as_code(numbers_.integer(0, 255));
    for (std::size_t i = 0; i < 3; ++i) codes[i] = as_code(numbers_.integer(0, codes[3]));
    return codes;
  };
  int differing = 0;
  for (int i = 0; i < 1000; ++i) {
    const Rgba8 a = any_layer(), b = any_layer(), c = any_layer();
    const Rgba8 one = put(a, put(b, c)), other = put(put(a, b), c);
    for (std::size_t k = 0; k < 4; ++k) ASSERT_LE(std::abs(one[k] - other[k]), 2);
    differing += one != other ? 1 : 0;
  }
  EXPECT_GT(differing, 100);
}

}  // namespace
}  // namespace edgecase
