// SPDX-License-Identifier: MIT
//
// Ruling 4 against moves that are really made: random triangles, every vertex moved at random and
// to the corners of what is allowed.
#include <gtest/gtest.h>

#include <random>

#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr int kBits = 6;  // coarse, so that moves matter
constexpr std::int64_t kStep = Fixed::kOne >> kBits;

Point moved(Point p, std::int64_t x, std::int64_t y) {
  return {Fixed::from_raw(p.x.raw() + x), Fixed::from_raw(p.y.raw() + y)};
}

bool closed_covers(const Triangle& t, Point sample) {
  const Triangle ccw = counter_clockwise(t);
  return doubled_area(ccw) != 0 && cross(ccw[0], ccw[1], sample) >= 0 &&
         cross(ccw[1], ccw[2], sample) >= 0 && cross(ccw[2], ccw[0], sample) >= 0;
}

bool open_covers(const Triangle& t, Point sample) {
  const Triangle ccw = counter_clockwise(t);
  return doubled_area(ccw) != 0 && cross(ccw[0], ccw[1], sample) > 0 &&
         cross(ccw[1], ccw[2], sample) > 0 && cross(ccw[2], ccw[0], sample) > 0;
}

class RandomMoves : public ::testing::Test {
 protected:
  // A triangle with a sample close to one of its edges more often than not.
  Triangle triangle() {
    const auto coordinate = [&] { return Fixed::from_raw(range(0, 2 * Fixed::kOne / 512) * 512); };
    return {Point{coordinate(), coordinate()}, Point{coordinate(), coordinate()},
            Point{coordinate(), coordinate()}};
  }
  Triangle move(const Triangle& t) {
    Triangle result;
    const bool corners = range(0, 1) == 0;
    const auto amount = [&] {
      return corners ? (range(0, 1) == 0 ? kStep - 1 : 1 - kStep) : range(1 - kStep, kStep - 1);
    };
    for (std::size_t i = 0; i < 3; ++i) result[i] = moved(t[i], amount(), amount());
    return result;
  }
  std::int64_t range(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  std::mt19937_64 engine_{20260101};
};

TEST_F(RandomMoves, WhatAMoveDrawsIsPossiblyCovered) {
  int found = 0;
  for (int i = 0; i < 20000; ++i) {
    const Triangle t = triangle();
    const Point sample = pixel_centre(static_cast<int>(range(0, 1)), static_cast<int>(range(0, 1)));
    const Triangle after = move(t);
    if (closed_covers(after, sample)) {
      ASSERT_TRUE(triangle_possibly_covered(t, sample, grid_step(kBits)));
      found += closed_covers(t, sample) ? 0 : 1;
    }
    if (!open_covers(after, sample)) {
      ASSERT_TRUE(triangle_possibly_uncovered(t, sample, grid_step(kBits)));
      found += open_covers(t, sample) ? 1 : 0;
    }
  }
  EXPECT_GT(found, 100) << "moves must change coverage, or this proves nothing";
}

// Tightness: where the latitude claims that a sample may go either way, some move shows it.
TEST_F(RandomMoves, WhatIsPossibleIsReachedByAMove) {
  int reached = 0;
  int claimed = 0;
  for (int i = 0; i < 4000; ++i) {
    const Triangle t = triangle();
    const Point sample = pixel_centre(0, 0);
    if (doubled_area(t) == 0 || open_covers(t, sample) ||
        !triangle_possibly_covered(t, sample, grid_step(kBits)) || closed_covers(t, sample))
      continue;
    ++claimed;
    bool hit = false;
    for (int corner = 0; corner < 64 && !hit; ++corner) {
      Triangle after;
      for (std::size_t v = 0; v < 3; ++v) {
        const auto to = [&](int bit) { return (corner >> bit & 1) != 0 ? kStep - 1 : 1 - kStep; };
        after[v] = moved(t[v], to(static_cast<int>(2 * v)), to(static_cast<int>(2 * v + 1)));
      }
      hit = closed_covers(after, sample);
    }
    // Where a triangle would pass beyond the sample, less than the whole step reaches it; moving
    // all three vertices alike is then enough.
    for (std::int64_t y = 1 - kStep; y < kStep && !hit; ++y)
      for (std::int64_t x = 1 - kStep; x < kStep && !hit; ++x)
        hit = closed_covers({moved(t[0], x, y), moved(t[1], x, y), moved(t[2], x, y)}, sample);
    reached += hit ? 1 : 0;
  }
  ASSERT_GT(claimed, 20);
  EXPECT_EQ(reached, claimed);
}

TEST(TriangleLatitude, FarSamplesAreNotOpen) {
  const Triangle t{at(1, 1), at(9, 1), at(1, 9)};
  EXPECT_FALSE(triangle_possibly_uncovered(t, at(2.5, 2.5), grid_step(8)));
  EXPECT_FALSE(triangle_possibly_covered(t, at(0.5, 0.5), grid_step(8)));
  EXPECT_FALSE(triangle_possibly_covered(t, at(9.5, 9.5), grid_step(8)));
}

TEST(TriangleLatitude, ASampleOnAnEdgeMayGoEitherWay) {
  const Triangle t{at(0.5, 0.5), at(4.5, 0.5), at(0.5, 4.5)};
  for (const Point sample : {at(2.5, 0.5), at(0.5, 2.5), at(2.5, 2.5), at(0.5, 0.5)}) {
    EXPECT_TRUE(triangle_possibly_covered(t, sample, grid_step(8)));
    EXPECT_TRUE(triangle_possibly_uncovered(t, sample, grid_step(8)));
  }
}

TEST(TriangleLatitude, ExactlyOneStepAwayIsNotReached) {
  const double step = 1.0 / 256;
  const Triangle t{at(0.5 + step, 0), at(4, 0), at(0.5 + step, 4)};
  EXPECT_FALSE(triangle_possibly_covered(t, at(0.5, 1.5), grid_step(8)));
  const Triangle nearer{at(0.5 + step - 1.0 / 65536, 0), at(4, 0), at(0.5 + step - 1.0 / 65536, 4)};
  EXPECT_TRUE(triangle_possibly_covered(nearer, at(0.5, 1.5), grid_step(8)));
}

}  // namespace
}  // namespace edgecase
