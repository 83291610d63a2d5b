// SPDX-License-Identifier: MIT
//
// Coordinates on and beside the borders that filters and grids ask for, against fractions.
#include "raster/texture_level.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge,
                           Wrap::clamp_to_border};
constexpr TexelBorders kWholeTexels{1, false};

// From `first` at x = 1/2 to `last` at x = 1/2 + length: at pixel k it is first + k (last -
// first)/length.
Interpolant along(double first, double last, double length) {
  Interpolant f;
  f.kind = PrimitiveKind::line;
  f.positions = {vertex_at(0.5, 0.5), vertex_at(0.5 + length, 0.5), vertex_at(0, 0)};
  f.values = {first, last, 0};
  return f;
}

// The axis of levels of these sizes.
class SizedAxis {
 public:
  SizedAxis(const Interpolant& coordinate, Wrap wrap, std::vector<int> sizes)
      : axis_(coordinate, wrap), sizes_(std::move(sizes)) {}

  Interval place(Point sample, TexelBorders borders, const Rational& further) {
    return axis_.place(sample, value(sample), borders, sizes_, further);
  }
  // Machine integers decide as quotients of unbounded ones do, to which 0 is added here.
  Interval place(Point sample, TexelBorders borders) {
    const Interval result = axis_.place(sample, value(sample), borders, sizes_);
    const Interval unbounded = place(sample, borders, 0);
    EXPECT_EQ(result.low, unbounded.low);
    EXPECT_EQ(result.high, unbounded.high);
    return result;
  }
  Interval value(Point sample) const { return axis_.value(sample); }

 private:
  TextureAxis axis_;
  std::vector<int> sizes_;
};

Integer texel_of(Interval place, int size) {
  return floor_of(rational_of(place.low) * size);
}

// k/size for all k: the texel that begins there, though hardly any is a double.
TEST(TextureAxis, BordersBelongToTheTexelAbove) {
  for (int size = 1; size <= 30; ++size) {
    SizedAxis axis(along(0, 3, 3.0 * size), Wrap::repeat, {size});
    for (int k = 0; k < 3 * size; ++k) {
      const Interval place = axis.place(pixel_centre(k, 0), kWholeTexels);
      ASSERT_EQ(place.low, place.high);
      ASSERT_EQ(texel_of(place, size), k);
      ASSERT_NEAR(place.low, static_cast<double>(k) / size, 1e-15);
    }
  }
}

// Beside a border by less than doubles know.
TEST(TextureAxis, BesideABorderIsItsOwnSide) {
  SizedAxis axis(along(0, 1, 3), Wrap::repeat, {3});
  for (const int sign : {-1, 1}) {
    const Interval place = axis.place(pixel_centre(1, 0), kWholeTexels, sign * power_of_two(-80));
    EXPECT_EQ(texel_of(place, 3), sign < 0 ? 0 : 1);
    EXPECT_EQ(texel_of({place.high, place.high}, 3), sign < 0 ? 0 : 1);
    EXPECT_NEAR(place.low, 1.0 / 3, 1e-15);
  }
}

// A linear filter's coordinate is the number, whatever lies around it.
TEST(TextureAxis, WithoutBordersTheValueIsHeld) {
  SizedAxis axis(along(0, 1, 7), Wrap::repeat, {7, 3, 1});
  for (int k = 0; k <= 14; ++k) {
    const Rational exact = quotient_of(k, 7);
    for (const TexelBorders borders : {TexelBorders{}, TexelBorders{1, false}}) {
      const Interval place = axis.place(pixel_centre(k, 0), borders);
      const bool on_border = borders.parts > 0;
      EXPECT_EQ(rational_of(place.low) <= exact && exact <= rational_of(place.high),
                !on_border || k % 7 == 0);
    }
  }
}

// Levels of other sizes have borders elsewhere: all are asked for, and none counts twice.
TEST(TextureAxis, AllSizesCount) {
  SizedAxis axis(along(0, 1, 12), Wrap::repeat, {12, 9, 6, 5, 3, 1});
  for (int k = 0; k < 12; ++k) {
    const Interval place = axis.place(pixel_centre(k, 0), kWholeTexels);
    for (const int size : {12, 9, 6, 5, 3, 1}) {
      EXPECT_EQ(texel_of(place, size), floor_of(quotient_of(k * size, 12)));
      EXPECT_EQ(texel_of({place.high, place.high}, size), floor_of(quotient_of(k * size, 12)));
    }
  }
}

// Multiples of 1/512 of a texel of 3: the grid's number is that of the fraction. A double on a tie
// is handed on as it is.
TEST(TextureAxis, GridsGetTheSideOfTheFraction) {
  for (const TexelGrid grid :
       {TexelGrid::floor_8, TexelGrid::nearest_8, TexelGrid::linear_even_8}) {
    const bool down = grid == TexelGrid::floor_8;
    const bool to_even = grid == TexelGrid::linear_even_8;
    SizedAxis axis(along(0, 1, 3 * 512), Wrap::repeat, {3});
    for (int k = 0; k < 3 * 512; ++k) {
      const Interval place =
          axis.place(pixel_centre(k, 0), texel_borders(Filter::linear, grid, TextureFormat::rgba8));
      // The coordinate is k/2 steps of 1/256 texel.
      const int step = down ? k / 2 : to_even && k % 4 == 1 ? (k - 1) / 2 : (k + 1) / 2;
      if (rational_of(place.low) == quotient_of(k, 3 * 512)) {
        ASSERT_EQ(place.low, place.high);
        continue;
      }
      for (const double end : {place.low, place.high}) {
        const Rational steps = rational_of(end) * 3 * 256;
        ASSERT_EQ(floor_of(down ? steps : steps + Rational(1, 2)), step) << name_of(grid) << k;
      }
    }
  }
}

// Far away a double is no closer than some texels: an equivalent one near by is.
TEST(TextureAxis, DistantCoordinatesAreBroughtNear) {
  const double far = 0x1p40;
  for (const Wrap wrap : kWraps) {
    for (const double sign : {-1.0, 1.0}) {
      SizedAxis axis(along(sign * far, sign * far + 1, 3), wrap, {3});
      const Interval place = axis.place(pixel_centre(1, 0), kWholeTexels);
      if (wrap == Wrap::repeat || wrap == Wrap::mirrored_repeat) {
        EXPECT_EQ(texel_of(place, 3), 1);
        EXPECT_NEAR(place.low, 1.0 / 3, 1e-15);
      } else {
        EXPECT_EQ(place.low, sign < 0 ? -1 : 2);
      }
    }
  }
}

bool same(Interval a, Interval b) {
  return a.low == b.low && a.high == b.high;
}

// What touches no border is the value, or the sum, as it is.
TEST(TextureAxis, WhatIsNotOpenIsHandedOn) {
  SizedAxis axis(along(0, 1, 7), Wrap::repeat, {5});
  for (int k = 1; k < 7; ++k)
    for (const TexelBorders borders : {TexelBorders{}, kWholeTexels}) {
      const Interval value = axis.value(pixel_centre(k, 0));
      ASSERT_GT(width_of(value), width_of(interval_of(quotient_of(k, 7))));
      EXPECT_TRUE(same(axis.place(pixel_centre(k, 0), borders), value));
      const Interval sum = axis.place(pixel_centre(k, 0), borders, Rational(1, 7));
      EXPECT_GE(sum.low, value.low + 0.14);
      EXPECT_TRUE(holds(sum, static_cast<Wide>(k + 1) / 7));
    }
  EXPECT_EQ(TexelBorders{}.parts, 0);
  EXPECT_FALSE(TexelBorders{}.ties_to_even);
}

// Wider than rounding makes it: as narrow as can be, under linear filters too.
TEST(TextureAxis, WideIntervalsAreAskedAgain) {
  const double far = 0x1p19;
  SizedAxis axis(along(far, far + 1, 3), Wrap::repeat, {4});
  const Rational exact = rational_of(far) + Rational(1, 3);
  ASSERT_GT(width_of(axis.value(pixel_centre(1, 0))), width_of(interval_of(exact)));
  EXPECT_TRUE(same(axis.place(pixel_centre(1, 0), {}), interval_of(exact)));
  // So is one of just 2^-40, and none that is narrower.
  const Rational third(1, 3);
  for (const double base : {0x1p11, 0x1p12}) {
    SizedAxis constant(along(base, base, 3), Wrap::repeat, {4});
    const Interval place = constant.place(pixel_centre(1, 0), {}, -rational_of(base) - third);
    EXPECT_TRUE(base == 0x1p12 ? same(place, interval_of(-third)) : width_of(place) == 0x1p-41);
  }
}

// An interval that reaches the border by the rounding of the product alone.
TEST(TextureAxis, BordersAreTouchedAtTheHighEnd) {
  SizedAxis axis(along(0, 0, 3), Wrap::repeat, {5});
  const Interval fifth = interval_of(Rational(1, 5));
  ASSERT_EQ((Interval(fifth.low) * 5.0).high, 1);
  const Rational between = (rational_of(next_below(fifth.low)) + rational_of(fifth.low)) / 2;
  const Interval place = axis.place(pixel_centre(1, 0), kWholeTexels, between);
  EXPECT_TRUE(same(place, next_below(fifth.low)));
}

// Each of several levels has its borders: a number beside one is not on the side of the others.
TEST(TextureAxis, EachSizeDecidesItsOwnBorders) {
  const std::vector<std::vector<int>> orders = {{5, 3}, {3, 5}, {7, 5, 3}, {1, 3}};
  for (const std::vector<int>& sizes : orders) {
    SizedAxis axis(along(0, 1, 3), Wrap::repeat, sizes);
    for (int k = 1; k < 3; ++k) {
      const Interval place = axis.place(pixel_centre(k, 0), kWholeTexels);
      for (const int size : sizes)
        EXPECT_EQ(texel_of(place, size), floor_of(quotient_of(k * size, 3)));
    }
  }
}

// A tie of the smaller level lies on the grid of the larger one. It goes to the even step, on
// either side of 0.
TEST(TextureAxis, TiesGoToTheEvenStepOfTheirOwnLevel) {
  const std::vector<std::vector<int>> orders = {{6, 3}, {3, 6}, {3}};
  for (const std::vector<int>& sizes : orders) {
    SizedAxis axis(along(-1, 1, 2 * 3 * 512), Wrap::repeat, sizes);
    for (int k = 0; k < 2 * 3 * 512; ++k) {
      const int halves = k - 3 * 512;  // of a step of 1/256 texel, of 3
      if (halves % 2 == 0 || halves % 3 == 0) continue;
      const Interval place = axis.place(pixel_centre(k, 0), {512, true});
      ASSERT_EQ(place.low, place.high);
      const Rational steps = rational_of(place.low) * 3 * 256;
      const Integer nearest = floor_of(steps + Rational(1, 2));
      ASSERT_TRUE(is_whole(Rational(nearest) / 2)) << halves;
      ASSERT_EQ(abs(2 * nearest - halves), 1) << halves;
    }
  }
}

// From 2^20 on a number is brought near, and not before.
TEST(TextureAxis, NumbersAreFarFromTwoToTheTwentieth) {
  for (const double sign : {-1.0, 1.0})
    for (const double beside : {-1.0, 1.0}) {
      const double base = sign * 0x1p20;
      SizedAxis axis(along(base, base + sign * beside, 3), Wrap::repeat, {4});
      const Interval place = axis.place(pixel_centre(1, 0), {});
      const Rational exact = rational_of(base) + rational_of(sign * beside) / 3;
      if (beside < 0)
        EXPECT_TRUE(same(place, interval_of(exact)));
      else
        EXPECT_TRUE(same(place, interval_of(exact - 2 * floor_of(exact / 2))));
    }
}

TEST(TextureAxis, FiltersAndGridsHaveTheirBorders) {
  const auto borders = [](Filter filter, TexelGrid grid, TextureFormat format) {
    const TexelBorders found = texel_borders(filter, grid, format);
    return std::pair{found.parts, found.ties_to_even};
  };
  using Pair = std::pair<int, bool>;
  const auto rgba8 = TextureFormat::rgba8, floats = TextureFormat::rgba32f;
  EXPECT_EQ(borders(Filter::nearest, TexelGrid::none, rgba8), Pair(1, false));
  EXPECT_EQ(borders(Filter::linear, TexelGrid::none, rgba8), Pair(0, false));
  EXPECT_EQ(borders(Filter::linear, TexelGrid::floor_8, floats), Pair(256, false));
  EXPECT_EQ(borders(Filter::nearest, TexelGrid::nearest_8, floats), Pair(512, false));
  EXPECT_EQ(borders(Filter::linear, TexelGrid::linear_even_8, rgba8), Pair(512, true));
  EXPECT_EQ(borders(Filter::linear, TexelGrid::linear_even_8, floats), Pair(0, false));
  EXPECT_EQ(borders(Filter::nearest, TexelGrid::linear_even_8, rgba8), Pair(1, false));
}

// Nothing is known of a primitive without extent.
TEST(TextureAxis, WithoutExtent) {
  Interpolant f = along(0, 1, 3);
  f.positions[1] = f.positions[0];
  TextureAxis axis(f, Wrap::repeat);
  const std::vector<int> sizes = {3};
  for (const Rational& further : {Rational(0), Rational(1, 3)})
    EXPECT_TRUE(is_everything(axis.place(pixel_centre(1, 0), axis.value(pixel_centre(1, 0)),
                                         kWholeTexels, sizes, further)));
  EXPECT_FALSE(axis.derivative({}, Axis::x, DerivativeMethod::fine));
}

}  // namespace
}  // namespace edgecase
