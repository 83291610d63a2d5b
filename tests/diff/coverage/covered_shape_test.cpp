// SPDX-License-Identifier: MIT
//
// What one triangle covers is one shape: hulls and holes against a slow oracle, no fault in what
// moved triangles cover, and faults in what no triangle covers.
#include "diff/coverage/covered_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "rules/coverage/triangle_fill.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

long side(PixelPosition a, PixelPosition b, PixelPosition p) {
  return long{b.x - a.x} * (p.y - a.y) - long{b.y - a.y} * (p.x - a.x);
}

// By definition: no line through two of the pixels has all of them on one side and p on the other,
// nor p beyond them on it.
bool is_in_hull(const Pixels& pixels, PixelPosition p) {
  if (pixels.empty()) return false;
  for (const PixelPosition a : pixels)
    for (const PixelPosition b : pixels) {
      if (a == b) continue;
      const bool all_left =
          std::ranges::all_of(pixels, [&](PixelPosition q) { return side(a, b, q) >= 0; });
      if (all_left && side(a, b, p) < 0) return false;
    }
  const auto within = [&](auto coordinate) {
    const auto [low, high] = std::ranges::minmax(pixels, {}, coordinate);
    return coordinate(low) <= coordinate(p) && coordinate(p) <= coordinate(high);
  };
  return within([](PixelPosition q) { return q.x; }) && within([](PixelPosition q) { return q.y; });
}

Pixels by_row(Pixels pixels) {
  std::ranges::sort(pixels, {}, [](PixelPosition p) { return std::pair(p.y, p.x); });
  return pixels;
}

// By definition: some line through it and one of the pixels has all of them on one side.
bool is_on_border(const Pixels& pixels, PixelPosition p) {
  return std::ranges::any_of(pixels, [&](PixelPosition a) {
    if (a == p) return false;
    const auto is_left = [&](PixelPosition q) { return side(a, p, q) >= 0; };
    const auto is_right = [&](PixelPosition q) { return side(a, p, q) <= 0; };
    return std::ranges::all_of(pixels, is_left) || std::ranges::all_of(pixels, is_right);
  });
}

TEST(PixelHull, IsTheHull) {
  RandomScenes random(41);
  for (int i = 0; i < 4000; ++i) {
    Pixels pixels;
    for (int count = random.below(7); count > 0; --count)
      pixels.push_back({random.below(9) - 3, random.below(9) - 3});
    pixels = by_row(std::move(pixels));
    const PixelHull hull(pixels);
    const std::vector<Hole> holes = holes_in(pixels);
    auto next = holes.begin();
    for (int y = -4; y <= 6; ++y)
      for (int x = -4; x <= 6; ++x) {
        const PixelPosition p{x, y};
        const bool is_in = is_in_hull(pixels, p);
        ASSERT_EQ(hull.contains(p), is_in) << i << ": " << x << ", " << y;
        if (!is_in || std::ranges::find(pixels, p) != pixels.end()) continue;
        ASSERT_NE(next, holes.end()) << i;
        ASSERT_EQ(next->pixel, p) << i;
        ASSERT_EQ(next->is_on_border, is_on_border(pixels, p)) << i << ": " << x << ", " << y;
        ++next;
      }
    ASSERT_EQ(next, holes.end()) << i;
  }
}

TEST(Holes, AreInNoTriangleOfAnyTieRule) {
  RandomScenes random(42);
  for (int i = 0; i < 4000; ++i) {
    Triangle triangle;
    for (Point& corner : triangle) corner = at(0.5 * random.below(24), 0.5 * random.below(24));
    for (const TieRule& ties : all_tie_rules()) {
      Pixels covered;
      for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x)
          if (triangle_covers(triangle, x, y, ties)) covered.push_back({x, y});
      ASSERT_TRUE(holes_in(covered).empty()) << i << " " << ties.name;
    }
  }
}

Scene lone_triangle(Point a, Point b, Point c) {
  Scene scene = blank_scene(16, 10);
  scene.draws.push_back(make_draw(Primitive::triangles, std::vector{a, b, c}));
  return scene;
}

// What exact draws, without some pixels and with others.
Rendering changed(const Scene& scene, const Pixels& without, const Pixels& with) {
  std::vector<Fragment> fragments;
  for (const Fragment& f : rasterize(scene, {}).fragments)
    if (std::ranges::find(without, PixelPosition{f.x, f.y}) == without.end())
      fragments.push_back(f);
  for (const PixelPosition p : with) fragments.push_back(fragment_at(scene, 0, p.x, p.y));
  return compose(scene, std::move(fragments));
}

// Every second pixel of row 2 is drawn, whose centres lie in row 2.5.
Rendering dashed(const Scene& scene) {
  Pixels row;
  for (int x = 0; x < 16; ++x) row.push_back({x, 2});
  return changed(scene, row, {{4, 2}, {6, 2}, {8, 2}, {10, 2}});
}

bool tells_of_shape(const Disagreement& d) {
  return !is_legal(d) &&
         d.explanation.find("no move of the vertices makes a triangle") != std::string::npos;
}

// 4 bits may put the lower edge 1/32 above or below: the whole row is drawn or not.
TEST(Shapes, OfDashesAreViolations) {
  for (const double bottom : {2.5 - 1.0 / 32, 2.5 + 1.0 / 32}) {
    const Scene scene = lone_triangle(at(0, bottom), at(16, bottom), at(8, 10));
    const Result result = judged(scene, dashed(scene), {}, 4);
    EXPECT_EQ(result.verdict, Verdict::violation) << bottom;
    EXPECT_EQ(broken_rulings(result), std::set<int>{4});
    EXPECT_TRUE(std::ranges::any_of(result.disagreements, tells_of_shape));
  }
}

TEST(Shapes, OfWholeRowsMayBeMoved) {
  const Scene inside = lone_triangle(at(0, 2.5 - 1.0 / 32), at(16, 2.5 - 1.0 / 32), at(8, 10));
  const Scene outside = lone_triangle(at(0, 2.5 + 1.0 / 32), at(16, 2.5 + 1.0 / 32), at(8, 10));
  for (const auto& [scene, other] : {std::pair(inside, outside), std::pair(outside, inside)})
    EXPECT_NE(judged(scene, rasterize(other, {}), {}, 4).verdict, Verdict::violation);
}

// Where the edge itself passes through the centres, each of them may go either way.
TEST(Shapes, MayHaveAnySamplesOfAnEdge) {
  const Scene scene = lone_triangle(at(0, 2.5), at(16, 2.5), at(8, 10));
  EXPECT_NE(judged(scene, dashed(scene), {}, 4).verdict, Verdict::violation);
}

// The edge passes 1/64 below the centres of five pixels, two columns and a row apart.
TEST(Shapes, WithAHoleInAnyDirectionAreViolations) {
  constexpr double kBelow = 1.0 / 64;
  const Scene scene = lone_triangle(at(2, 1.25 - kBelow), at(11, 5.75 - kBelow), at(2, 9.5));
  const Pixels along = {{2, 1}, {4, 2}, {6, 3}, {8, 4}, {10, 5}};
  EXPECT_NE(judged(scene, changed(scene, along, {}), {}, 4).verdict, Verdict::violation);
  for (const PixelPosition hole : {along[1], along[2], along[3]})
    EXPECT_EQ(judged(scene, changed(scene, {hole}, {}), {}, 4).verdict, Verdict::violation);
}

TEST(Shapes, OfTwoEqualVerticesAreEmpty) {
  Scene scene = lone_triangle(at(1, 2.5), at(7, 2.5), at(7, 2.5));
  for (Vertex& vertex : scene.draws[0].vertices) vertex.color = {1, 0, 0, 1};
  const auto draws_row = [&] {
    return judged(scene, changed(scene, {}, {{2, 2}, {3, 2}, {4, 2}, {5, 2}}), {}, 8);
  };
  const Result result = draws_row();
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(broken_rulings(result).contains(4));
  // Three different ones may be moved off the line.
  scene.draws[0].vertices[2].position = at(6, 2.5);
  EXPECT_FALSE(broken_rulings(draws_row()).contains(4));
}

}  // namespace
}  // namespace edgecase
