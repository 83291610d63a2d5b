// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "rules/coverage/window.h"

namespace edgecase {
namespace {

Fixed sixteenths_of_step(int bits, int count) {
  return Fixed::from_raw((Fixed::kOne >> bits) / 16 * count);
}

TEST(Snap, NoneChangesNothing) {
  const Fixed value = Fixed::from_raw(12345);
  EXPECT_EQ(Snap{}(value), value);
}

TEST(Snap, RoundingsDifferExactlyWhereTheyShould) {
  const Snap even = *find_snap("8-half-even");
  const Snap up = *find_snap("8-half-up");
  const Snap truncate = *find_snap("8-truncate");
  const auto at = [](int sixteenths) { return sixteenths_of_step(8, sixteenths); };
  // Sixteenths of a grid step: value, half-even, half-up, truncate, in whole steps.
  const int rows[][4] = {{0, 0, 0, 0},   {7, 0, 0, 0},     {8, 0, 1, 0},     {9, 1, 1, 0},
                         {16, 1, 1, 1},  {24, 2, 2, 1},    {40, 2, 3, 2},    {-1, 0, 0, -1},
                         {-8, 0, 0, -1}, {-9, -1, -1, -1}, {-24, -2, -1, -2}};
  for (const auto& row : rows) {
    EXPECT_EQ(even(at(row[0])), at(16 * row[1])) << row[0];
    EXPECT_EQ(up(at(row[0])), at(16 * row[2])) << row[0];
    EXPECT_EQ(truncate(at(row[0])), at(16 * row[3])) << row[0];
  }
}

// -1/3 pixel is -85 1/3 steps of 1/256.
TEST(Snap, QuotientsBelowZeroRoundDownAsThoseAbove) {
  const auto steps = [](const char* name) {
    return (*find_snap(name))(HomogeneousPoint{-1, 1, 3}).x.raw() / (Fixed::kOne / 256);
  };
  EXPECT_EQ(steps("8-truncate"), -86);
  EXPECT_EQ(steps("8-half-up"), -85);
}

TEST(Snap, NamesReadBack) {
  EXPECT_EQ(all_snaps().size(), 28u);
  for (Snap snap : all_snaps()) {
    const Snap* found = find_snap(name_of(snap));
    ASSERT_NE(found, nullptr) << name_of(snap);
    EXPECT_EQ(*found, snap);
  }
  EXPECT_EQ(find_snap("3-half-even"), nullptr);
}

TEST(Snap, ResultLiesOnTheGridAndWithinAStep) {
  for (Snap snap : all_snaps())
    for (std::int64_t raw = -70000; raw <= 70000; raw += 37) {
      const Fixed value = Fixed::from_raw(raw);
      const std::int64_t step = Fixed::kOne >> snap.bits;
      EXPECT_EQ(snap(value).raw() % step, 0);
      EXPECT_LT(std::abs(snap(value).raw() - raw), step);
    }
}

}  // namespace
}  // namespace edgecase
