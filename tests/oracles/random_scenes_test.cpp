// SPDX-License-Identifier: MIT
//
// More than a million random scenes, against the oracles: lines of every algorithm, boundary and
// width, triangles under every tie rule by all three tests that courses teach, points of every
// size. Coordinates are multiples of 2^-1 to 2^-16, coarse ones often, so that scenes hold ties.
#include <gtest/gtest.h>

#include <random>

#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "tests/oracles/areas.h"
#include "tests/oracles/support.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

class Random {
 public:
  std::int64_t up_to(std::int64_t last) {
    return static_cast<std::int64_t>(engine_() % (static_cast<std::uint64_t>(last) + 1));
  }
  template <class Range>
  const auto& one_of(const Range& range) {
    return range[static_cast<std::size_t>(up_to(static_cast<std::int64_t>(range.size()) - 1))];
  }
  // The grid that the vertices of a scene lie on, raw.
  std::int64_t step() {
    constexpr int kBits[] = {1, 1, 1, 1, 1, 2, 2, 3, 4, 16};
    return Fixed::kOne >> one_of(std::span(kBits));
  }
  // Around a point, up to three pixels from 0.
  Point point(std::int64_t step) {
    const std::int64_t last = 3 * Fixed::kOne / step;
    const auto coordinate = [&] { return Fixed::from_raw((up_to(last) - last / 3) * step); };
    return {coordinate(), coordinate()};
  }

 private:
  std::mt19937_64 engine_{share_seed(20260331)};
};

LineScene random_line(Random& random, const std::vector<LineScene>& kinds) {
  LineScene scene = random.one_of(kinds);
  const std::int64_t step = random.step();
  scene.segment = {random.point(step), random.point(step)};
  if (random.up_to(7) == 0) {
    constexpr WideLine kWide[] = {WideLine::replicate, WideLine::rectangle,
                                  WideLine::parallelogram};
    scene.width = Fixed::from_raw((1 + random.up_to(15)) * Fixed::kOne / 4);
    scene.wide = random.one_of(std::span(kWide));
  }
  return scene;
}

Tally compare_lines(long count) {
  const auto kinds = thin_line_kinds();
  Random random;
  Tally tally;
  while (tally.scenes < count) {
    const LineScene scene = random_line(random, kinds);
    const int x = static_cast<int>(random.up_to(1)) - 1;
    const int y = static_cast<int>(random.up_to(1)) - 1;
    if (!agrees(scene, {x, y, x + 2, y + 2}, tally)) break;
  }
  return tally;
}

// The samples of 2x2 pixels by the three tests and by ours; false where one of them differs.
bool triangle_agrees(const Triangle& triangle, const TieRule& rule, Tally& tally) {
  const oracle::Corners corners{oracle::spot(triangle[0]), oracle::spot(triangle[1]),
                                oracle::spot(triangle[2])};
  const oracle::Ties ties = oracle::ties_named(rule.name);
  bool tied = false;
  for (int y = 0; y <= 1; ++y)
    for (int x = 0; x <= 1; ++x) {
      const oracle::Spot centre = oracle::centre_of_pixel(x, y);
      const oracle::Place sample = oracle::moved(centre, ties.move);
      const bool ours = triangle_covers(triangle, x, y, rule);
      const bool agree = ties.accept(oracle::where_by_half_planes(corners, sample)) == ours &&
                         ties.accept(oracle::where_by_cross_products(corners, sample)) == ours &&
                         ties.accept(oracle::where_by_barycentric_signs(corners, sample)) == ours;
      EXPECT_TRUE(agree) << rule.name << " " << describe(Segment{triangle[0], triangle[1]}) << ", "
                         << describe(Segment{triangle[1], triangle[2]}) << ", pixel " << x << " "
                         << y << ": ours says " << ours;
      if (!agree) return false;
      ++tally.decisions;
      tied = tied || oracle::where_by_half_planes(corners, oracle::moved(centre, {0, 0})) == 0;
    }
  ++tally.scenes;
  tally.tied += tied ? 1 : 0;
  return true;
}

Tally compare_triangles(long count) {
  Random random;
  Tally tally;
  while (tally.scenes < count) {
    const std::int64_t step = random.step();
    Triangle triangle{random.point(step), random.point(step), random.point(step)};
    // Two vertices opposite each other, seen from a pixel's centre, put it on their edge.
    if (random.up_to(2) == 0) {
      const Point a = triangle[0];
      const Fixed twice = Fixed::from_integer(1 + 2 * random.up_to(1));
      triangle[1] = {twice - a.x, twice - a.y};
    }
    if (!triangle_agrees(triangle, random.one_of(all_tie_rules()), tally)) break;
  }
  return tally;
}

bool point_agrees(const SizedPoint& point, const TieRule& rule, Tally& tally) {
  const oracle::Spot vertex = oracle::spot(point.vertex);
  const oracle::Rational size(point.size);
  const oracle::Ties ties = oracle::ties_named(rule.name);
  bool tied = false;
  for (int y = -1; y <= 2; ++y)
    for (int x = -1; x <= 2; ++x) {
      const oracle::Spot centre = oracle::centre_of_pixel(x, y);
      const int where = oracle::where_in_square(vertex, size, oracle::moved(centre, ties.move));
      const bool ours = point_covers(point, x, y, rule);
      EXPECT_EQ(ours, ties.accept(where))
          << rule.name << " " << describe(Segment{point.vertex, point.vertex}) << " pixel " << x
          << " " << y;
      if (ours != ties.accept(where)) return false;
      ++tally.decisions;
      tied = tied || oracle::where_in_square(vertex, size, oracle::moved(centre, {0, 0})) == 0;
    }
  ++tally.scenes;
  tally.tied += tied ? 1 : 0;
  return true;
}

Tally compare_points(long count) {
  constexpr std::int64_t kHalves[] = {1, 2, 3, 4, 6, 9};  // sizes 1/2 to 4.5
  Random random;
  Tally tally;
  while (tally.scenes < count) {
    SizedPoint point{random.point(random.step()), {}};
    point.size = Fixed::from_raw(random.one_of(std::span(kHalves)) * Fixed::kOne / 2);
    if (random.up_to(9) == 0) point.size = Fixed::from_raw(1 + random.up_to(64 * Fixed::kOne - 1));
    // Half a size to the right of a centre puts it on the square's side.
    if (random.up_to(5) == 0)
      point.vertex.x = Fixed::centre_of(0) + Fixed::from_raw(point.size.raw() / 2);
    if (!point_agrees(point, random.one_of(point_tie_rules()), tally)) break;
  }
  return tally;
}

TEST(RandomScenes, AMillionAgree) {
  Tally all;
  const auto take = [&](const char* what, const Tally& tally) {
    tally.print(what);
    EXPECT_GT(tally.tied, tally.scenes / 3) << what;
    all.add(tally);
  };
  take("random lines", compare_lines(share_of(600'000L)));
  take("random triangles", compare_triangles(share_of(250'000L)));
  take("random points", compare_points(share_of(250'000L)));
  all.print("random scenes");
  RecordProperty("scenes", static_cast<int>(all.scenes));
  EXPECT_GE(all.scenes, share_of(1'100'000L));
  EXPECT_GT(all.decisions, share_of(10'000'000L));
}

}  // namespace
}  // namespace edgecase
