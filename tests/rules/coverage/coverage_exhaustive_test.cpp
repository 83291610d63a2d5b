// SPDX-License-Identifier: MIT
//
// Every scene of small grids, our predicates against the literal oracles, under all eight tie
// rules.
#include <gtest/gtest.h>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "tests/oracles/oracles.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using oracle::Eighths;

Point to_point(Eighths p) {
  return {Fixed::from_raw(p.x * Fixed::kOne / 8), Fixed::from_raw(p.y * Fixed::kOne / 8)};
}

oracle::Move move_of(const TieRule& rule) {
  return {rule.first_x != 0 ? rule.first_x : 2 * rule.second_x,
          rule.first_y != 0 ? rule.first_y : 2 * rule.second_y};
}

// All positions from 0 to `last` eighths in steps.
std::vector<Eighths> grid(int last, int step) {
  std::vector<Eighths> positions;
  for (int y = 0; y <= last; y += step)
    for (int x = 0; x <= last; x += step) positions.push_back({x, y});
  return positions;
}

std::vector<TieRule> perturbed_rules() {
  std::vector<TieRule> rules;
  for (const TieRule& rule : all_tie_rules())
    if (rule.kind == TieRule::Kind::perturbed) rules.push_back(rule);
  return rules;
}

TEST(CoverageExhaustive, PointsOnAnEighthGrid) {
  long decisions = 0;
  for (const TieRule& rule : perturbed_rules())
    for (Eighths p : grid(24, 1))
      for (int y = -1; y <= 3; ++y)
        for (int x = -1; x <= 3; ++x, ++decisions)
          ASSERT_EQ(point_covers({to_point(p)}, x, y, rule),
                    oracle::point_produces(p, x, y, move_of(rule)))
              << rule.name << " point " << p.x << "/8 " << p.y << "/8 pixel " << x << " " << y;
  EXPECT_EQ(decisions, 8 * 25 * 25 * 25);
}

TEST(CoverageExhaustive, LinesOnAQuarterGrid) {
  const auto ends = grid(20, 2);
  long decisions = 0;
  long ties = 0;
  for (const TieRule& rule : perturbed_rules())
    for (Eighths a : ends)
      for (Eighths b : ends)
        for (int y = 0; y <= 2; ++y)
          for (int x = 0; x <= 2; ++x, ++decisions) {
            const Segment segment{to_point(a), to_point(b)};
            const bool produced =
                diamond_exit_covers(segment, x, y, *find_diamond_boundary(rule.name));
            ASSERT_EQ(produced, oracle::line_produces(a, b, x, y, move_of(rule)))
                << rule.name << " from " << a.x << "/8 " << a.y << "/8 to " << b.x << "/8 " << b.y
                << "/8 pixel " << x << " " << y;
            ties += diamond_exit_covers(segment, x, y, *find_diamond_boundary("open")) != produced
                        ? 1
                        : 0;
          }
  EXPECT_EQ(decisions, 8L * 121 * 121 * 9);
  EXPECT_GT(ties, decisions / 100) << "the grid must hold ties, or it proves nothing about them";
}

TEST(CoverageExhaustive, TrianglesOnAHalfGrid) {
  const auto vertices = grid(24, 4);
  Dealer dealer;
  for (const TieRule& rule : perturbed_rules())
    for (Eighths a : vertices)
      for (Eighths b : vertices)
        for (Eighths c : vertices) {
          if (!dealer.deal()) continue;
          for (int y = 0; y <= 2; ++y)
            for (int x = 0; x <= 2; ++x)
              ASSERT_EQ(triangle_covers({to_point(a), to_point(b), to_point(c)}, x, y, rule),
                        oracle::triangle_produces({a, b, c}, x, y, move_of(rule)))
                  << rule.name << " " << a.x << " " << a.y << " " << b.x << " " << b.y << " " << c.x
                  << " " << c.y << " (eighths) pixel " << x << " " << y;
        }
  EXPECT_EQ(dealer.items(), 8L * 49 * 49 * 49);
}

// Every pair of triangles on opposite sides of an edge: each sample that lies inside their union
// away from the edge's ends is hit exactly once, whatever the tie rule.
TEST(CoverageExhaustive, SharedEdgesAreHitOnce) {
  const auto vertices = grid(16, 4);
  long edges = 0;
  long on_edge = 0;
  for (Eighths a : vertices)
    for (Eighths b : vertices)
      for (Eighths c : vertices)
        for (Eighths d : vertices) {
          const Triangle left{to_point(a), to_point(b), to_point(c)};
          const Triangle right{to_point(b), to_point(a), to_point(d)};
          if (doubled_area(left) <= 0 || doubled_area(right) <= 0) continue;
          const auto edge = shared_edge(left, right);
          ASSERT_TRUE(edge);
          ++edges;
          for (int y = 0; y <= 1; ++y)
            for (int x = 0; x <= 1; ++x) {
              const Point sample = pixel_centre(x, y);
              if (cross(left[0], left[1], sample) == 0) ++on_edge;
              if (!must_hit_once(*edge, sample, grid_step(8))) continue;
              for (const TieRule& rule : perturbed_rules())
                ASSERT_NE(triangle_covers(left, x, y, rule), triangle_covers(right, x, y, rule))
                    << rule.name;
              ASSERT_TRUE(triangle_covers(left, x, y, *find_tie_rule("closed")) &&
                          triangle_covers(right, x, y, *find_tie_rule("closed")));
              ASSERT_FALSE(triangle_covers(left, x, y, *find_tie_rule("open")) ||
                           triangle_covers(right, x, y, *find_tie_rule("open")));
            }
        }
  EXPECT_GT(edges, 10000);
  EXPECT_GT(on_edge, 1000);
}

// The walk along the major axis finds what testing every pixel finds.
TEST(CoverageExhaustive, LineWalkMissesNothing) {
  const PixelBounds bounds{0, 0, 3, 3};
  for (const DiamondBoundary& rule : all_diamond_boundaries())
    for (Eighths a : grid(32, 3))
      for (Eighths b : grid(32, 3)) {
        const Segment segment{to_point(a), to_point(b)};
        std::vector<PixelPosition> tested;
        for (int y = 0; y <= 3; ++y)
          for (int x = 0; x <= 3; ++x)
            if (diamond_exit_covers(segment, x, y, rule)) tested.push_back({x, y});
        auto walked = diamond_exit_pixels(segment, bounds, rule);
        std::sort(walked.begin(), walked.end());
        std::sort(tested.begin(), tested.end());
        ASSERT_EQ(walked, tested) << rule.name;
      }
}

}  // namespace
}  // namespace edgecase
