// SPDX-License-Identifier: MIT
#include "rules/samples/sample_placement.h"

#include <gtest/gtest.h>

#include <set>

namespace edgecase {
namespace {

using Kind = SamplePlacement::Kind;

SamplePositions sixteenths(std::initializer_list<std::pair<int, int>> places) {
  SamplePositions positions;
  for (const auto& [x, y] : places)
    positions.push_back(
        {Fixed::from_raw(x * Fixed::kOne / 16), Fixed::from_raw(y * Fixed::kOne / 16)});
  return positions;
}

SamplePositions standard(Kind kind, int first = 0, int second = 0, int samples = 4) {
  return placed({kind, first, second}, standard_pattern(samples));
}

TEST(SamplePlacement, StandardPatterns) {
  EXPECT_EQ(standard_pattern(1), SamplePositions{centre_of_pixel()});
  EXPECT_EQ(standard_pattern(2), sixteenths({{12, 12}, {4, 4}}));
  EXPECT_EQ(standard_pattern(4), sixteenths({{6, 2}, {14, 6}, {2, 10}, {10, 14}}));
  EXPECT_EQ(standard_pattern(3), sixteenths({{6, 2}, {14, 6}, {2, 10}}));
}

// As they are listed, from the pixel's centre.
TEST(SamplePlacement, StandardPatternsOf8And16) {
  const auto from_centre = [](std::initializer_list<std::pair<int, int>> places) {
    SamplePositions positions;
    for (const auto& [x, y] : places) positions.push_back(sixteenths({{8 + x, 8 + y}})[0]);
    return positions;
  };
  EXPECT_EQ(standard_pattern(8),
            from_centre({{1, -3}, {-1, 3}, {5, 1}, {-3, -5}, {-5, 5}, {-7, -1}, {3, 7}, {7, -7}}));
  EXPECT_EQ(standard_pattern(16), from_centre({{1, 1},
                                               {-1, -3},
                                               {-3, 2},
                                               {4, -1},
                                               {-5, -2},
                                               {2, 5},
                                               {5, 3},
                                               {3, -5},
                                               {-2, 6},
                                               {0, -7},
                                               {-4, -6},
                                               {-6, 4},
                                               {-8, 0},
                                               {7, -4},
                                               {6, 7},
                                               {-7, -8}}));
  EXPECT_EQ(standard_pattern(5).size(), 5u);
  EXPECT_EQ(standard_pattern(5)[4], sixteenths({{3, 13}})[0]);
  EXPECT_EQ(standard_pattern(9)[8], sixteenths({{6, 14}})[0]);
}

// No two samples of the patterns share one of n columns or of n rows.
TEST(SamplePlacement, StandardPatternsAreSpreadOverColumnsAndRows) {
  for (int samples : {2, 4, 8, 16}) {
    const SamplePositions positions = standard_pattern(samples);
    std::set<std::int64_t> columns;
    std::set<std::int64_t> rows;
    for (Point p : positions) {
      columns.insert(p.x.raw() * samples / Fixed::kOne);
      rows.insert(p.y.raw() * samples / Fixed::kOne);
      EXPECT_EQ(p.x.raw() % (Fixed::kOne / 16), 0);
      EXPECT_LT(p.x, Fixed::from_integer(1));
    }
    EXPECT_EQ(columns.size(), positions.size());
    EXPECT_EQ(rows.size(), positions.size());
  }
}

TEST(SamplePlacement, Grids) {
  EXPECT_EQ(standard(Kind::ordered_grid), sixteenths({{4, 4}, {12, 4}, {4, 12}, {12, 12}}));
  EXPECT_EQ(standard(Kind::rotated_grid), standard_pattern(4));
  EXPECT_EQ(standard(Kind::ordered_grid, 0, 0, 16)[6], sixteenths({{10, 6}})[0]);
  EXPECT_EQ(standard(Kind::ordered_grid, 0, 0, 8), standard_pattern(8));  // none of 8
  EXPECT_EQ(placed({Kind::ordered_grid, 0, 0}, sixteenths({{1, 1}})), sixteenths({{1, 1}}));
  for (int samples : {9, 16}) {
    std::set<std::int64_t> columns;
    for (Point p : standard(Kind::rotated_grid, 0, 0, samples))
      columns.insert(p.x.raw() * samples / Fixed::kOne);
    EXPECT_EQ(columns.size(), static_cast<std::size_t>(samples));
    EXPECT_NE(standard(Kind::rotated_grid, 0, 0, samples),
              standard(Kind::ordered_grid, 0, 0, samples));
  }
}

// Of 9, in eighteenths of a pixel; what is no multiple of 2^-16 is cut off.
TEST(SamplePlacement, GridsOfNine) {
  const auto eighteenths = [](std::initializer_list<std::pair<int, int>> places) {
    SamplePositions positions;
    for (const auto& [x, y] : places)
      positions.push_back(
          {Fixed::from_raw(x * Fixed::kOne / 18), Fixed::from_raw(y * Fixed::kOne / 18)});
    return positions;
  };
  EXPECT_EQ(
      standard(Kind::ordered_grid, 0, 0, 9),
      eighteenths({{3, 3}, {9, 3}, {15, 3}, {3, 9}, {9, 9}, {15, 9}, {3, 15}, {9, 15}, {15, 15}}));
  EXPECT_EQ(standard(Kind::rotated_grid, 0, 0, 9),
            eighteenths(
                {{5, 1}, {11, 3}, {17, 5}, {3, 7}, {9, 9}, {15, 11}, {1, 13}, {7, 15}, {13, 17}}));
}

TEST(SamplePlacement, MirrorsAndSwaps) {
  EXPECT_EQ(standard(Kind::as_reported), standard_pattern(4));
  EXPECT_EQ(standard(Kind::mirrored_x), sixteenths({{10, 2}, {2, 6}, {14, 10}, {6, 14}}));
  EXPECT_EQ(standard(Kind::mirrored_y), sixteenths({{6, 14}, {14, 10}, {2, 6}, {10, 2}}));
  EXPECT_EQ(standard(Kind::turned), sixteenths({{10, 14}, {2, 10}, {14, 6}, {6, 2}}));
  EXPECT_EQ(standard(Kind::swapped, 1, 3), sixteenths({{6, 2}, {10, 14}, {2, 10}, {14, 6}}));
  for (const auto& [first, second] : {std::pair{1, 4}, {4, 1}, {-1, 1}, {1, -1}})
    EXPECT_EQ(standard(Kind::swapped, first, second), standard_pattern(4));
  EXPECT_EQ(standard(Kind::swapped, 3, 0), sixteenths({{10, 14}, {14, 6}, {2, 10}, {6, 2}}));
  EXPECT_EQ(standard(Kind::centre), SamplePositions(4, centre_of_pixel()));
  EXPECT_EQ(placed({Kind::mirrored_x, 0, 0}, sixteenths({{0, 3}})), sixteenths({{16, 3}}));
  EXPECT_EQ(placed({Kind::standard, 0, 0}, sixteenths({{1, 1}, {2, 2}})), standard_pattern(2));
}

TEST(SamplePlacement, AllThatDifferOnceEach) {
  for (int samples : {2, 4, 8, 9}) {
    const auto placements = placements_of(samples);
    EXPECT_EQ(placements[0], SamplePlacement{});
    // Positions without any symmetry.
    SamplePositions positions = standard_pattern(samples);
    std::int64_t aside = 0;
    for (Point& p : positions) {
      ++aside;
      p.x = p.x + Fixed::from_raw(aside * aside);
    }
    std::set<std::vector<std::int64_t>> seen;
    int swaps = 0;
    for (const SamplePlacement& placement : placements) {
      std::vector<std::int64_t> raw;
      for (Point p : placed(placement, positions)) raw.insert(raw.end(), {p.x.raw(), p.y.raw()});
      EXPECT_TRUE(seen.insert(raw).second) << name_of(placement);
      swaps += name_of(placement) == "swapped" ? 1 : 0;
    }
    EXPECT_EQ(swaps, samples * (samples - 1) / 2);
  }
}

TEST(SamplePlacement, NamesAreReadBack) {
  for (const SamplePlacement& placement : placements_of(2)) {
    SamplePlacement read;
    EXPECT_TRUE(parse_name(name_of(placement), read));
    EXPECT_EQ(read, placement);
  }
  SamplePlacement read{Kind::centre, 0, 0};
  EXPECT_TRUE(parse_name("rotated-grid", read));
  EXPECT_FALSE(parse_name("random", read));
  EXPECT_EQ(read.kind, Kind::rotated_grid);
}

}  // namespace
}  // namespace edgecase
