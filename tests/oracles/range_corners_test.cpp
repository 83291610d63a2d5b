// SPDX-License-Identifier: MIT
//
// Coordinates at the ends of the range, +-2^13, and next to them by 2^-16: every predicate, against
// the oracles. Run under the undefined-behaviour sanitizer it shows that nothing overflows.
#include <gtest/gtest.h>

#include <random>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_areas.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "tests/oracles/areas.h"
#include "tests/oracles/support.h"

namespace edgecase {
namespace {

constexpr int kEnd = static_cast<int>(Fixed::kMaxCoordinate);
constexpr std::int64_t kEndRaw = Fixed::kMaxCoordinate * Fixed::kOne;

// Pixels at the four corners of the range and in the middle.
constexpr PixelBounds kWindows[] = {{-kEnd, -kEnd, 1 - kEnd, 1 - kEnd},
                                    {kEnd - 2, kEnd - 2, kEnd - 1, kEnd - 1},
                                    {-kEnd, kEnd - 2, 1 - kEnd, kEnd - 1},
                                    {kEnd - 2, -kEnd, kEnd - 1, 1 - kEnd},
                                    {-1, -1, 1, 1}};

class RangeCorners : public ::testing::Test {
 protected:
  std::int64_t up_to(std::int64_t last) {
    return static_cast<std::int64_t>(engine_() % (static_cast<std::uint64_t>(last) + 1));
  }
  template <class Range>
  const auto& one_of(const Range& range) {
    return range[static_cast<std::size_t>(up_to(std::ssize(range) - 1))];
  }
  Fixed coordinate() {
    constexpr std::int64_t kInward[] = {
        0, 0, 1, 2, Fixed::kOne / 2 - 1, Fixed::kOne / 2, Fixed::kOne / 2 + 1, Fixed::kOne};
    switch (up_to(4)) {
      case 0:
      case 1:
        return Fixed::from_raw(kEndRaw - one_of(kInward));
      case 2:
      case 3:
        return Fixed::from_raw(one_of(kInward) - kEndRaw);
      default:
        return Fixed::from_raw(one_of(kInward));
    }
  }
  Point point() { return {coordinate(), coordinate()}; }
  // A triangle; its first edge runs along the diagonal through pixel centres every other time.
  Triangle triangle() {
    Triangle t{point(), point(), point()};
    if (up_to(1) == 0) t[0].y = t[0].x;
    if (t[0].x == t[0].y) t[1].y = t[1].x;
    return t;
  }
  std::mt19937_64 engine_{20260501};
};

TEST_F(RangeCorners, LinesOfEveryAlgorithm) {
  Tally tally;
  for (LineScene scene : thin_line_kinds())
    for (int i = 0; i < 150; ++i) {
      scene.segment = {point(), point()};
      ASSERT_TRUE(agrees(scene, one_of(kWindows), tally));
    }
  tally.print("lines at the ends of the range");
}

TEST_F(RangeCorners, WideLines) {
  constexpr WideLine kWide[] = {WideLine::replicate, WideLine::rectangle, WideLine::parallelogram};
  Tally tally;
  for (LineScene scene : thin_line_kinds())
    for (int i = 0; i < 30; ++i) {
      scene.segment = {point(), point()};
      scene.width = Fixed::from_raw(64 * Fixed::kOne - up_to(1));
      scene.wide = one_of(kWide);
      ASSERT_TRUE(agrees(scene, one_of(kWindows), tally));
    }
  tally.print("wide lines at the ends of the range");
}

TEST_F(RangeCorners, Points) {
  for (int i = 0; i < 5000; ++i) {
    const SizedPoint p{point(), Fixed::from_raw(1 + up_to(64 * Fixed::kOne - 1))};
    const TieRule& rule = one_of(point_tie_rules());
    const oracle::Ties ties = oracle::ties_named(rule.name);
    const int bits = static_cast<int>(4 + up_to(12));
    const oracle::Rational step(1, 1 << bits);
    const PixelBounds& window = one_of(kWindows);
    for (int y = window.y_min; y <= window.y_max; ++y)
      for (int x = window.x_min; x <= window.x_max; ++x) {
        const oracle::Spot centre = oracle::centre_of_pixel(x, y);
        const oracle::Spot vertex = oracle::spot(p.vertex);
        const oracle::Rational size(p.size);
        const auto where = [&](const oracle::Rational& by, oracle::Move move) {
          return oracle::where_in_square(vertex, by, oracle::moved(centre, move));
        };
        ASSERT_EQ(point_covers(p, x, y, rule), ties.accept(where(size, ties.move)));
        // A vertex moved by less than a step: a square larger or smaller by that on every side.
        ASSERT_EQ(point_possibly_covered(p, x, y, grid_step(bits)),
                  where(size + step * 2, {0, 0}) > 0);
        ASSERT_EQ(point_possibly_uncovered(p, x, y, grid_step(bits)),
                  where(size - step * 2, {0, 0}) < 0);
        ASSERT_FALSE(explain_point(p, x, y, rule).text.empty());
      }
  }
}

TEST_F(RangeCorners, TrianglesAndTheirLatitude) {
  long on_edge = 0;
  for (int i = 0; i < 10000; ++i) {
    const Triangle t = triangle();
    const oracle::Corners spots{oracle::spot(t[0]), oracle::spot(t[1]), oracle::spot(t[2])};
    const TieRule& rule = one_of(all_tie_rules());
    const oracle::Ties ties = oracle::ties_named(rule.name);
    const int bits = static_cast<int>(1 + up_to(15));
    const oracle::Rational step(1, 1 << bits);
    const PixelBounds& window = one_of(kWindows);
    const int x = window.x_min + static_cast<int>(up_to(1));
    const int y = window.y_min + static_cast<int>(up_to(1));
    const oracle::Spot centre = oracle::centre_of_pixel(x, y);
    const oracle::Place sample = oracle::moved(centre, ties.move);
    const int where = oracle::where_by_half_planes(spots, sample);
    ASSERT_EQ(where, oracle::where_by_cross_products(spots, sample));
    ASSERT_EQ(where, oracle::where_by_barycentric_signs(spots, sample));
    ASSERT_EQ(triangle_covers(t, x, y, rule), ties.accept(where));
    ASSERT_EQ(triangle_possibly_covered(t, pixel_centre(x, y), grid_step(bits)),
              oracle::coverable(spots, centre, step));
    ASSERT_EQ(robustly_left(t[0], t[1], pixel_centre(x, y), grid_step(bits)),
              oracle::left_however_moved(spots[0], spots[1], centre, step));
    ASSERT_EQ(triangle_possibly_uncovered(t, pixel_centre(x, y), grid_step(bits)),
              oracle::leavable(spots, centre, step));
    ASSERT_FALSE(explain_triangle(t, x, y, rule).text.empty());
    on_edge += oracle::where_by_half_planes(spots, oracle::moved(centre, {0, 0})) == 0 ? 1 : 0;
  }
  EXPECT_GT(on_edge, 100);
}

// Two triangles on an edge from one end of the range to another hit each sample near it once.
TEST_F(RangeCorners, SharedEdges) {
  long on_edge = 0;
  for (int i = 0; i < 20000; ++i) {
    const Triangle left = triangle();
    const Triangle right{left[1], left[0], point()};
    if (doubled_area(left) <= 0 || doubled_area(right) <= 0) continue;
    const auto edge = shared_edge(left, right);
    ASSERT_TRUE(edge);
    const int bits = static_cast<int>(4 + up_to(12));
    const oracle::Rational step(1, 1 << bits);
    const PixelBounds& window = one_of(kWindows);
    const int x = window.x_min + static_cast<int>(up_to(1));
    const int y = window.y_min + static_cast<int>(up_to(1));
    const oracle::Spot p = oracle::centre_of_pixel(x, y);
    const auto robust = [&](Point a, Point b) {
      return oracle::left_however_moved(oracle::spot(a), oracle::spot(b), p, step);
    };
    const bool once = !robust(left[0], left[1]) && !robust(left[1], left[0]) &&
                      robust(left[1], left[2]) && robust(left[2], left[0]) &&
                      robust(left[0], right[2]) && robust(right[2], left[1]);
    ASSERT_EQ(must_hit_once(*edge, pixel_centre(x, y), grid_step(bits)), once);
    if (!once) continue;
    on_edge += cross(left[0], left[1], pixel_centre(x, y)) == 0 ? 1 : 0;
    for (const TieRule& rule : all_tie_rules()) {
      if (rule.kind != TieRule::Kind::perturbed) continue;
      ASSERT_NE(triangle_covers(left, x, y, rule), triangle_covers(right, x, y, rule)) << rule.name;
    }
  }
  EXPECT_GT(on_edge, 20);
}

TEST_F(RangeCorners, ExactLinesAreLegal) {
  for (int i = 0; i < 500; ++i)
    for (int width : {1, 2, 64}) {
      LineScene scene;
      scene.segment = {point(), point()};
      scene.width = Fixed::from_integer(width);
      const PixelBounds& window = one_of(kWindows);
      const SeenLine seen{scene.segment, width, window};
      ASSERT_EQ(broken_line_clause(seen, our_pixels(scene, window)), "")
          << describe(scene) << " window from " << window.x_min << " " << window.y_min;
      is_unseen(seen);
      for (const DiamondBoundary& boundary : all_diamond_boundaries())
        ASSERT_FALSE(
            explain_line(scene.segment, window.x_min, window.y_max, boundary).text.empty());
    }
}

}  // namespace
}  // namespace edgecase
