// SPDX-License-Identifier: MIT
//
// Points, triangles and snapping on small grids, all of them, against the oracles.
#include <gtest/gtest.h>

#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "tests/oracles/areas.h"
#include "tests/oracles/support.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

// The two ways to move by a small e, 2^-16 and an e below every number, say the same.
TEST(SmallGrids, TwoWaysToMoveAgree) {
  const auto eighths = [](int count) { return oracle::Rational(count, 8); };
  long produced = 0;
  for (const TieRule& rule : all_tie_rules()) {
    if (rule.kind != TieRule::Kind::perturbed) continue;
    const oracle::Ties ties = oracle::ties_named(rule.name);
    for (int i = 0; i < 9 * 9 * 9 * 9; ++i) {
      const oracle::Eighths a{2 * (i % 9), 2 * (i / 9 % 9)};
      const oracle::Eighths b{2 * (i / 81 % 9), 2 * (i / 729)};
      const oracle::Line line{{eighths(a.x), eighths(a.y)}, {eighths(b.x), eighths(b.y)}};
      const bool exits = oracle::exits_diamond(line, oracle::boundary_named(rule.name), 0, 0);
      ASSERT_EQ(exits, oracle::line_produces(a, b, 0, 0, ties.move)) << rule.name << " " << i;
      const std::array<oracle::Eighths, 3> triangle{a, b, {12, 4}};
      const oracle::Corners spots{line.a, line.b, {eighths(12), eighths(4)}};
      const auto sample = oracle::moved(oracle::centre_of_pixel(0, 0), ties.move);
      ASSERT_EQ(oracle::where_by_half_planes(spots, sample) > 0,
                oracle::triangle_produces(triangle, 0, 0, ties.move))
          << rule.name << " " << i;
      produced += exits ? 1 : 0;
    }
  }
  EXPECT_GT(produced, 10000);
}

TEST(SmallGrids, PointsOfEverySize) {
  Tally tally;
  for (const TieRule& rule : all_tie_rules()) {
    const oracle::Ties ties = oracle::ties_named(rule.name);
    for (std::int64_t halves : {1, 2, 3, 4, 6, 9})
      for (Point vertex : grid(0, 2 * Fixed::kOne, Fixed::kOne / 8)) {
        const SizedPoint point{vertex, Fixed::from_raw(halves * Fixed::kOne / 2)};
        ++tally.scenes;
        bool tied = false;
        for (int y = -2; y <= 3; ++y)
          for (int x = -2; x <= 3; ++x, ++tally.decisions) {
            const auto ask = [&](oracle::Move move) {
              return oracle::where_in_square(oracle::spot(vertex), oracle::Rational(point.size),
                                             oracle::moved(oracle::centre_of_pixel(x, y), move));
            };
            ASSERT_EQ(point_covers(point, x, y, rule), ties.accept(ask(ties.move)))
                << rule.name << " size " << halves << "/2, pixel " << x << " " << y;
            tied = tied || ask({0, 0}) == 0;
          }
        tally.tied += tied ? 1 : 0;
      }
  }
  tally.print("points on a grid");
  EXPECT_EQ(tally.scenes, 10L * 6 * 17 * 17);
}

// The three tests that courses teach say the same as each other and as we do.
TEST(SmallGrids, TrianglesByThreeTests) {
  const auto corners = grid(0, 2 * Fixed::kOne, Fixed::kOne / 2);
  Dealer dealer;
  Tally tally;
  for (const TieRule& rule : all_tie_rules()) {
    const oracle::Ties ties = oracle::ties_named(rule.name);
    for (Point a : corners)
      for (Point b : corners)
        for (Point c : corners) {
          if (!dealer.deal()) continue;
          const oracle::Corners spots{oracle::spot(a), oracle::spot(b), oracle::spot(c)};
          ++tally.scenes;
          bool tied = false;
          for (int y = 0; y <= 1; ++y)
            for (int x = 0; x <= 1; ++x, ++tally.decisions) {
              const oracle::Spot centre = oracle::centre_of_pixel(x, y);
              const oracle::Place sample = oracle::moved(centre, ties.move);
              const int where = oracle::where_by_half_planes(spots, sample);
              ASSERT_EQ(where, oracle::where_by_cross_products(spots, sample));
              ASSERT_EQ(where, oracle::where_by_barycentric_signs(spots, sample));
              ASSERT_EQ(triangle_covers({a, b, c}, x, y, rule), ties.accept(where))
                  << rule.name << " " << describe(Segment{a, b}) << ", " << describe(Segment{b, c});
              tied = tied || oracle::where_by_half_planes(
                                 spots, oracle::moved(centre, oracle::Move{0, 0})) == 0;
            }
          tally.tied += tied ? 1 : 0;
        }
  }
  tally.print("triangles on a grid");
  EXPECT_EQ(dealer.items(), 10L * 25 * 25 * 25);
  EXPECT_GT(tally.tied, tally.scenes / 3);
}

// What ruling 4 leaves open, from its text: where moved vertices can take the sample.
TEST(SmallGrids, LatitudeOfTriangles) {
  const auto corners = grid(0, Fixed::kOne + Fixed::kOne / 2, Fixed::kOne / 2);
  long open = 0;
  for (int bits : {1, 2, 4})
    for (Point a : corners)
      for (Point b : corners)
        for (Point c : corners) {
          const oracle::Corners spots{oracle::spot(a), oracle::spot(b), oracle::spot(c)};
          const oracle::Rational step(1, 1 << bits);
          for (std::int64_t quarters : {1, 2, 4}) {
            const Point sample{Fixed::from_raw(quarters * Fixed::kOne / 4), Fixed::centre_of(0)};
            const oracle::Spot p = oracle::spot(sample);
            const bool coverable = oracle::coverable(spots, p, step);
            ASSERT_EQ(triangle_possibly_covered({a, b, c}, sample, grid_step(bits)), coverable)
                << describe(Segment{a, b}) << ", " << describe(Segment{b, c}) << " bits " << bits
                << " sample " << quarters << "/4";
            ASSERT_EQ(robustly_left(a, b, sample, grid_step(bits)),
                      oracle::left_however_moved(spots[0], spots[1], p, step))
                << describe(Segment{a, b}) << " bits " << bits << " sample " << quarters << "/4";
            ASSERT_EQ(triangle_possibly_uncovered({a, b, c}, sample, grid_step(bits)),
                      oracle::leavable(spots, p, step))
                << describe(Segment{a, b}) << ", " << describe(Segment{b, c}) << " bits " << bits;
            open += coverable && triangle_possibly_uncovered({a, b, c}, sample, grid_step(bits))
                        ? 1
                        : 0;
          }
        }
  EXPECT_GT(open, 1000);
}

// Every kind of snapping: all of two coarse steps round 0, and the ends of the range.
TEST(SmallGrids, EverySnap) {
  long compared = 0;
  for (const Snap& snap : all_snaps()) {
    const std::string name = name_of(snap);
    const std::size_t dash = name.find('-');
    const auto check = [&](std::int64_t raw) {
      const Fixed value = Fixed::from_raw(raw);
      const oracle::Rational exact(value);
      const auto nearest = dash == std::string::npos
                               ? exact
                               : oracle::snapped(exact, std::stoi(name), name.substr(dash + 1));
      ++compared;
      return oracle::Rational(snap(value)) == nearest;
    };
    for (std::int64_t raw = -Fixed::kOne / 8; raw <= Fixed::kOne / 8; ++raw)
      ASSERT_TRUE(check(raw)) << name << " " << raw;
    constexpr std::int64_t kEnd = Fixed::kMaxCoordinate * Fixed::kOne;
    for (std::int64_t inward = 0; inward <= 5000; ++inward)
      ASSERT_TRUE(check(kEnd - inward) && check(inward - kEnd)) << name << " " << inward;
    EXPECT_TRUE(snap(Fixed::from_raw(kEnd - 1)).in_coordinate_range()) << name;
    EXPECT_TRUE(snap(Fixed::from_raw(1 - kEnd)).in_coordinate_range()) << name;
  }
  EXPECT_EQ(compared, 28L * (16385 + 2 * 5001));
}

}  // namespace
}  // namespace edgecase
