// SPDX-License-Identifier: MIT
//
// Joints of connected segments (GL 4.6 core, 14.5.1, the fourth of the relaxed rules): where both
// have the same major axis and direction, no fragment may come twice and none may be missing so as
// to interrupt the line. The diamond-exit rule itself must hold what it asks of others: every pair
// of segments on a small grid. Where the line turns back, a pixel may come twice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "rules/coverage/diamond_exit.h"
#include "tests/oracles/support.h"

namespace edgecase {
namespace {

constexpr PixelBounds kWindow{-2, -2, 5, 5};

// 1 to the right, -1 to the left, 2 up, -2 down along the major axis; 0 without length.
int direction(const Segment& s) {
  if (s.a == s.b) return 0;
  if (s.x_major()) return s.a.x < s.b.x ? 1 : -1;
  return s.a.y < s.b.y ? 2 : -2;
}

// A fault in the pixels of two joined segments of one direction; empty if there is none.
std::string joint_fault(std::vector<PixelPosition> pixels, bool x_major) {
  if (!x_major)
    for (PixelPosition& p : pixels) std::swap(p.x, p.y);
  std::sort(pixels.begin(), pixels.end());
  for (std::size_t i = 1; i < pixels.size(); ++i) {
    if (pixels[i] == pixels[i - 1]) return "a pixel comes twice";
    if (pixels[i].x == pixels[i - 1].x) return "a column holds two pixels";
    if (pixels[i].x != pixels[i - 1].x + 1) return "a column is missing";
    if (std::abs(pixels[i].y - pixels[i - 1].y) > 1) return "neighbours are apart";
  }
  return "";
}

// On two grids: fine within 2x2 pixels, and as many points over 4x4.
class Joints : public ::testing::TestWithParam<int> {
 protected:
  using Pixels = std::vector<PixelPosition>;

  // The pixels of the segment between two points of the grid, under one boundary.
  void draw(const DiamondBoundary& boundary) {
    pixels_.clear();
    for (Point a : points_)
      for (Point b : points_) pixels_.push_back(diamond_exit_pixels({a, b}, kWindow, boundary));
  }
  const Pixels& pixels(std::size_t a, std::size_t b) const {
    return pixels_[a * points_.size() + b];
  }
  // Calls with every three points a, b, c.
  template <class Visit>
  void each_joint(Visit visit) const {
    for (std::size_t a = 0; a < points_.size(); ++a)
      for (std::size_t b = 0; b < points_.size(); ++b)
        for (std::size_t c = 0; c < points_.size(); ++c) visit(a, b, c);
  }
  Pixels both(std::size_t a, std::size_t b, std::size_t c) const {
    Pixels result = pixels(a, b);
    result.insert(result.end(), pixels(b, c).begin(), pixels(b, c).end());
    return result;
  }

  const std::vector<Point> points_ =
      grid(0, GetParam() * Fixed::kOne, GetParam() * Fixed::kOne / 8);
  std::vector<Pixels> pixels_;
};

TEST_P(Joints, SameDirectionGivesOnePixelPerColumn) {
  for (const TieRule& ties : all_tie_rules()) {
    if (ties.kind != TieRule::Kind::perturbed) continue;
    draw(*find_diamond_boundary(ties.name));
    long joints = 0;
    long straight = 0;
    std::map<std::string, long> faults;
    each_joint([&](std::size_t a, std::size_t b, std::size_t c) {
      const Segment first{points_[a], points_[b]};
      const Segment second{points_[b], points_[c]};
      if (direction(first) == 0 || direction(first) != direction(second)) return;
      ++joints;
      straight += cross(points_[a], points_[b], points_[c]) == 0 ? 1 : 0;
      const std::string fault = joint_fault(both(a, b, c), first.x_major());
      if (!fault.empty() && faults[fault]++ == 0)
        std::cout << ties.name << ": " << fault << " " << describe(first) << " then "
                  << describe(second) << "\n";
    });
    for (const auto& [fault, count] : faults)
      EXPECT_EQ(count, 0) << ties.name << ": " << fault << " of " << joints;
    // The same figure for every rule: all pairs of a grid of 9 by 9 points.
    EXPECT_EQ(joints, 48728);
    EXPECT_EQ(straight, 5424);
  }
}

TEST_P(Joints, ATurnBackMayHitAPixelTwice) {
  draw(*find_diamond_boundary("left-bottom"));
  long twice = 0;
  each_joint([&](std::size_t a, std::size_t b, std::size_t c) {
    Pixels hit = both(a, b, c);
    std::sort(hit.begin(), hit.end());
    twice += std::adjacent_find(hit.begin(), hit.end()) != hit.end() ? 1 : 0;
  });
  EXPECT_GT(twice, 1000);
  // Up to the right, past pixel (0, 0), and back down through it.
  const auto at = [](int quarters) { return Fixed::from_raw(quarters * Fixed::kOne / 4); };
  const auto& boundary = *find_diamond_boundary("left-bottom");
  EXPECT_TRUE(diamond_exit_covers({{at(0), at(2)}, {at(6), at(4)}}, 0, 0, boundary));
  EXPECT_TRUE(diamond_exit_covers({{at(6), at(4)}, {at(2), at(0)}}, 0, 0, boundary));
}

INSTANTIATE_TEST_SUITE_P(Grids, Joints, ::testing::Values(2, 4));

}  // namespace
}  // namespace edgecase
