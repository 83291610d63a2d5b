// SPDX-License-Identifier: MIT
//
// Parallelograms with tested ends: against the same written down for either axis in the machine's
// own float32, and drawn examples.
#include "rules/coverage/line_areas.h"
#include "rules/coverage/tested_ends.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "tests/rules/values/interpolants.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr PixelBounds kWindow{-2, -2, 12, 12};

struct Vector {
  float x, y;
};

Vector vector_of(Point p) {
  return {static_cast<float>(p.x.to_double()), static_cast<float>(p.y.to_double())};
}

float from_centre(float v) {
  return v - std::floor(v) - 0.5F;
}

bool is_within(float v) {
  return 0 < v && v < 1;
}

long snapped(float v) {
  return std::lround(256 * v);
}

struct Moves {
  Vector start{0, 0}, end{0, 0};
};

Moves moves_if_x_major(Vector a, Vector b) {
  const float dx = a.x - b.x, dy = a.y - b.y, slope = dy / dx;
  const float ax = from_centre(a.x), ay = from_centre(a.y), bx = from_centre(b.x);
  const float by = from_centre(b.y) == -0.5F && dy < 0 ? 0.5F : from_centre(b.y);
  const bool right = dx < 0;
  bool wants_start, wants_end;
  if (std::fabs(ax) + std::fabs(ay) < 0.5F)
    wants_start = true;
  else if (right ? ax >= 0 : ax < 0)
    wants_start = false;
  else
    wants_start = (ay <= 0) != (dy >= 0) || is_within(a.y - std::floor(a.y) + ax * slope);
  if (std::fabs(bx) + std::fabs(by) < 0.5F || (right ? bx < 0 : bx >= 0))
    wants_end = false;
  else
    wants_end = (by <= 0) == (dy >= 0) || is_within(b.y - std::floor(b.y) + bx * slope);
  const bool has_start = right ? ax <= 0 : ax > 0;
  const bool has_end = right ? bx >= 0 : bx <= 0;
  const float border = right ? -0.5F : 0.5F;
  Moves moves;
  if (wants_start != has_start) moves.start = {border - ax, (border - ax) * slope};
  if (wants_end != has_end) moves.end = {border - bx, (border - bx) * slope};
  return moves;
}

Moves moves_if_y_major(Vector a, Vector b) {
  const float dx = a.x - b.x, dy = a.y - b.y, slope = dx / dy;
  const float ax = from_centre(a.x), ay = from_centre(a.y), by = from_centre(b.y);
  const float bx = from_centre(b.x) == -0.5F && dx < 0 ? 0.5F : from_centre(b.x);
  const bool up = dy < 0;
  bool wants_start, wants_end;
  if (std::fabs(ax) + std::fabs(ay) < 0.5F)
    wants_start = true;
  else if (up ? ay > 0 : ay <= 0)
    wants_start = false;
  else
    wants_start = (ax >= 0) != (dx <= 0) || is_within(a.x - std::floor(a.x) + ay * slope);
  if (std::fabs(bx) + std::fabs(by) < 0.5F || (up ? by <= 0 : by > 0))
    wants_end = false;
  else
    wants_end = (bx <= 0) == (dx >= 0) || is_within(b.x - std::floor(b.x) + by * slope);
  const bool has_start = up ? ay < 0 : ay >= 0;
  const bool has_end = up ? by >= 0 : by <= 0;
  const float border = up ? -0.5F : 0.5F;
  Moves moves;
  if (wants_start != has_start) moves.start = {(border - ay) * slope, border - ay};
  if (wants_end != has_end) moves.end = {(border - by) * slope, border - by};
  return moves;
}

// Left and lower sides are in, as left-bottom has them: a column or row at a time.
bool literally_covers(const Segment& segment, int width, PixelPosition pixel) {
  const Vector a = vector_of(segment.a), b = vector_of(segment.b);
  if (a.x == b.x && a.y == b.y) return false;
  const bool x_major = std::fabs(a.x - b.x) >= std::fabs(a.y - b.y);
  const Moves moves = x_major ? moves_if_x_major(a, b) : moves_if_y_major(a, b);
  const long half = 128L * width;
  const auto major = [&](Vector v, Vector by) {
    return x_major ? snapped(v.x + by.x - 0.5F) : snapped(v.y + by.y - 0.5F);
  };
  const auto minor = [&](Vector v, Vector by, long side) {
    return side + (x_major ? snapped(v.y + by.y - 0.5F) : snapped(v.x + by.x - 0.5F));
  };
  long m0 = major(a, moves.start), m1 = major(b, moves.end);
  long low0 = minor(a, moves.start, -half), low1 = minor(b, moves.end, -half);
  long high0 = minor(a, moves.start, half), high1 = minor(b, moves.end, half);
  const bool runs_up = x_major ? a.x < b.x : a.y < b.y;
  if (!runs_up) std::swap(m0, m1), std::swap(low0, low1), std::swap(high0, high1);
  const long m = 256L * (x_major ? pixel.x : pixel.y), n = 256L * (x_major ? pixel.y : pixel.x);
  if (m0 >= m1 || m < m0 || m >= m1) return false;
  // Of the row (column) through the centre: below it low0 + (low1 - low0) t, t = (m - m0) / (m1 -
  // m0).
  const long run = m1 - m0;
  const long low = (n - low0) * run - (low1 - low0) * (m - m0);
  const long high = (high0 - n) * run + (high1 - high0) * (m - m0);
  if (low < 0 || high < 0) return false;
  // On a side: in where left of the interior, or below it if the side is horizontal.
  const auto owns = [&](long rise, bool is_low) {
    if (!x_major) return is_low;  // a left side
    if (rise == 0) return is_low;
    return is_low ? rise < 0 : rise > 0;
  };
  return (low != 0 || owns(low1 - low0, true)) && (high != 0 || owns(high1 - high0, false));
}

std::vector<PixelPosition> literal_pixels(const Segment& segment, int width) {
  std::vector<PixelPosition> pixels;
  for (int x = kWindow.x_min; x <= kWindow.x_max; ++x)
    for (int y = kWindow.y_min; y <= kWindow.y_max; ++y)
      if (literally_covers(segment, width, {x, y})) pixels.push_back({x, y});
  return pixels;
}

std::vector<PixelPosition> drawn(const Segment& segment, int width = 1) {
  auto pixels = tested_ends_pixels(segment, width, kWindow, *find_tie_rule("left-bottom"));
  std::sort(pixels.begin(), pixels.end());
  return pixels;
}

TEST(LineTestedEnds, EverySegmentOnAQuarterGrid) {
  constexpr int kQuarters = 10;
  long moved = 0, compared = 0;
  for (int ax = 0; ax <= kQuarters; ++ax)
    for (int ay = 0; ay <= kQuarters; ++ay)
      for (int bx = 0; bx <= kQuarters; ++bx)
        for (int by = 0; by <= kQuarters; ++by) {
          const Segment segment{at(ax / 4., ay / 4.), at(bx / 4., by / 4.)};
          const auto ours = drawn(segment);
          ASSERT_EQ(ours, literal_pixels(segment, 1)) << ax << " " << ay << " " << bx << " " << by;
          auto plain = line_area_pixels(segment, Fixed::from_integer(1), LineArea::parallelogram,
                                        kWindow, *find_tie_rule("left-bottom"));
          std::sort(plain.begin(), plain.end());
          moved += ours != plain;
          ++compared;
        }
  EXPECT_EQ(compared, 14641);
  EXPECT_GT(moved, 3000);
}

TEST(LineTestedEnds, RandomSegmentsOfAllWidths) {
  RandomNumbers random(4);
  for (int trial = 0; trial < 20000; ++trial) {
    const std::int64_t step = Fixed::kOne >> random.integer(1, 16);
    const auto coordinate = [&] {
      return Fixed::from_raw(random.integer(0, 10 * Fixed::kOne / step) * step);
    };
    const Fixed x = coordinate(), y = coordinate();
    const Segment segment{
        {x, y}, {random.one_in(6) ? x : coordinate(), random.one_in(6) ? y : coordinate()}};
    const int width = random.one_in(2) ? 1 : static_cast<int>(random.integer(2, 7));
    ASSERT_EQ(drawn(segment, width), literal_pixels(segment, width))
        << trial << ": " << segment.a.x.to_double() << ", " << segment.a.y.to_double() << " to "
        << segment.b.x.to_double() << ", " << segment.b.y.to_double() << ", width " << width;
  }
}

using Pixels = std::vector<PixelPosition>;

TEST(LineTestedEnds, DrawnExamples) {
  // From inside a diamond past its centre, to before the centre of another: both pixels are the
  // diamond-exit rule's to decide, and it draws the first and leaves out the last.
  EXPECT_EQ(drawn({at(2.75, 2.5), at(5.25, 2.5)}), (Pixels{{2, 2}, {3, 2}, {4, 2}}));
  // To behind the centre of the last, inside of its diamond: left out, too.
  EXPECT_EQ(drawn({at(2.5, 2.5), at(5.75, 2.5)}), (Pixels{{2, 2}, {3, 2}, {4, 2}}));
  // And beyond the diamond: drawn.
  EXPECT_EQ(drawn({at(2.5, 2.5), at(6, 2.5)}), (Pixels{{2, 2}, {3, 2}, {4, 2}, {5, 2}}));
  EXPECT_EQ(drawn({at(3, 3), at(3, 3)}), Pixels());
  // As wide as three: a column of three pixels for each.
  EXPECT_EQ(drawn({at(2.5, 4.5), at(4.5, 4.5)}, 3),
            (Pixels{{2, 3}, {2, 4}, {2, 5}, {3, 3}, {3, 4}, {3, 5}}));
}

// The end is moved to the right border of its pixel, to 1, past the start.
TEST(LineTestedEnds, NothingIsDrawnWhereAnEndPassesTheOther) {
  EXPECT_EQ(drawn({at(1025 / 2048., 0.5), at(1 / 2048., 0.5)}), Pixels());
  EXPECT_EQ(drawn({at(0.75, 0.5), at(-1 / 2048., 0.5)}), (Pixels{{0, 0}}));
}

// The start lies 64 1/2 steps to the right of a centre, and is rounded to 65. Its left side, 128
// steps before it, would be rounded to -64 by itself, and the side meet the centre of (1, 2).
TEST(LineTestedEnds, AnEndIsRoundedOnceForBothSides) {
  EXPECT_EQ(drawn({at(385 / 512., 3.75), at(2 + 65 / 256., 2 + 63 / 256.)}),
            (Pixels{{1, 3}, {2, 2}}));
}

}  // namespace
}  // namespace edgecase
