// SPDX-License-Identifier: MIT
#include "casefile/mesh/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "exact/rational.h"

namespace edgecase {
namespace {

using Polygon = std::vector<Vector>;

// Twice the exact area of corners a, b, c, seen along z.
Rational doubled_area(const Vector& a, const Vector& b, const Vector& c) {
  const auto from = [&](const Vector& p, std::size_t axis) -> Rational {
    return rational_of(p[axis]) - rational_of(a[axis]);
  };
  return from(b, 0) * from(c, 1) - from(b, 1) * from(c, 0);
}

Rational doubled_area(const Polygon& polygon) {
  Rational area = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    area += doubled_area(polygon[0], polygon[i - 1], polygon[i]);
  return area;
}

// Triangles of one sense whose edges inside the polygon come in pairs, and whose areas add up to
// its own, cover it once.
void expect_cut(const Polygon& polygon) {
  const auto triangles = triangles_of(polygon);
  ASSERT_EQ(triangles.size(), polygon.size() - 2);
  const Rational whole = doubled_area(polygon);
  Rational sum = 0;
  std::map<std::pair<std::size_t, std::size_t>, int> edges;
  for (const auto& triangle : triangles) {
    const Rational area =
        doubled_area(polygon[triangle[0]], polygon[triangle[1]], polygon[triangle[2]]);
    EXPECT_GE(area * whole, 0);
    sum += area;
    for (std::size_t k = 0; k < 3; ++k) ++edges[{triangle[k], triangle[(k + 1) % 3]}];
  }
  EXPECT_EQ(sum, whole);
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    if ((edge.first + 1) % polygon.size() != edge.second) {
      EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
  }
}

// Corners at rising angles round a place: it never crosses itself.
Polygon star(std::mt19937& random, int count, double right, bool clockwise) {
  std::uniform_real_distribution<double> part(0, 1);
  constexpr double kRadii[] = {0.3, 1, 2, 3};
  Polygon polygon;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.7 * part(random)) / count;
    const double radius = kRadii[random() % 4];
    polygon.push_back({static_cast<float>(right + radius * std::cos(angle)),
                       static_cast<float>(right + radius * std::sin(angle)), 0});
  }
  if (clockwise) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

TEST(Triangulation, CoversStarsOnceWhereverTheyLie) {
  std::mt19937 random(11);
  int concave = 0;
  for (int round = 0; round < 800; ++round) {
    const double right = std::array{0.0, 100.0, 8000.0, 1e6}[static_cast<std::size_t>(round % 4)];
    const Polygon polygon = star(random, 4 + round % 9, right, round % 3 == 0);
    SCOPED_TRACE(round);
    // Far away a float32 has few steps, and rounded corners may cross.
    const bool is_cut = !triangles_of(polygon).empty();
    EXPECT_TRUE(is_cut || right == 1e6);
    if (!is_cut) continue;
    expect_cut(polygon);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const std::size_t n = polygon.size();
      concave += doubled_area(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < 0 ? 1 : 0;
    }
    // Any corner may be the first, and any axis the one that looks at it.
    Polygon turned = polygon;
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    expect_cut(turned);
    for (Vector& corner : turned) corner = {corner[2], corner[0], corner[1]};
    EXPECT_EQ(triangles_of(turned).size(), turned.size() - 2);
  }
  EXPECT_GT(concave, 400);
}

// Twice the area of three points of a small grid, each 0 to 8, by rows of 3.
int grid_area(int a, int b, int c) {
  return (b % 3 - a % 3) * (c / 3 - a / 3) - (b / 3 - a / 3) * (c % 3 - a % 3);
}

// Whether a point lies on the way from a to b, its ends included.
bool is_on_way(int a, int b, int point) {
  return grid_area(a, b, point) == 0 && std::min(a % 3, b % 3) <= point % 3 &&
         point % 3 <= std::max(a % 3, b % 3) && std::min(a / 3, b / 3) <= point / 3 &&
         point / 3 <= std::max(a / 3, b / 3);
}

// Polygons of five corners on a grid of 3 x 3: those whose edges do not meet are cut, those whose
// edges cross are not, and all triangles add up.
TEST(Triangulation, OfAllSmallPolygons) {
  int cut = 0;
  int crossing = 0;
  for (int code = 0; code < 9 * 9 * 9 * 9 * 9; code += 4) {
    Polygon polygon;
    std::array<int, 5> at{};
    for (int rest = code, i = 0; i < 5; ++i, rest /= 9) {
      at[static_cast<std::size_t>(i)] = rest % 9;
      polygon.push_back({static_cast<float>(rest % 3), static_cast<float>(rest % 9 / 3), 0});
    }
    bool crosses = false;
    bool meets = false;
    for (std::size_t i = 0; i < 5; ++i)
      for (std::size_t j = 0; j < 5; ++j) {
        const int a = at[i], b = at[(i + 1) % 5], c = at[j], d = at[(j + 1) % 5];
        crosses = crosses || (grid_area(a, b, c) * grid_area(a, b, d) < 0 &&
                              grid_area(c, d, a) * grid_area(c, d, b) < 0);
        meets = meets || (j != i && j != (i + 1) % 5 && is_on_way(a, b, c));
      }
    const auto triangles = triangles_of(polygon);
    crossing += crosses ? 1 : 0;
    ASSERT_TRUE(!crosses || triangles.empty()) << code;
    ASSERT_TRUE(crosses || meets || !triangles.empty()) << code;
    if (triangles.empty()) continue;
    int sum = -grid_area(at[0], at[1], at[2]) - grid_area(at[0], at[2], at[3]) -
              grid_area(at[0], at[3], at[4]);
    for (const auto& [a, b, c] : triangles) sum += grid_area(at[a], at[b], at[c]);
    ASSERT_EQ(sum, 0) << code;
    cut += meets ? 0 : 1;
  }
  EXPECT_GT(cut, 500);
  EXPECT_GT(crossing, 1000);
}

TEST(Triangulation, LeadsToAHoleAndBack) {
  // A square of 4 x 4 with one of 2 x 2 cut out of it, by a way from (0, 0) to (1, 1).
  const Polygon frame{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                      {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
  const auto triangles = triangles_of(frame);
  ASSERT_EQ(triangles.size(), 8U);
  Rational sum = 0;
  for (const auto& [a, b, c] : triangles) {
    const Rational area = doubled_area(frame[a], frame[b], frame[c]);
    EXPECT_GE(area, 0);
    sum += area;
  }
  EXPECT_EQ(sum, 24);
}

TEST(Triangulation, CutsFourCornersInside) {
  using Triangles = std::vector<std::array<std::size_t, 3>>;
  EXPECT_EQ(triangles_of(Polygon{{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {0, 1, 0}}),
            (Triangles{{0, 1, 3}, {1, 2, 3}}));  // the shorter
  EXPECT_EQ(triangles_of(Polygon{{0, 0, 0}, {9, 1, 0}, {0, 2, 0}, {1, 1, 0}}),
            (Triangles{{0, 1, 3}, {1, 2, 3}}));
  EXPECT_EQ(triangles_of(Polygon{{1, 1, 0}, {0, 0, 0}, {9, 1, 0}, {0, 2, 0}}),
            (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_TRUE(triangles_of(Polygon{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
}

TEST(Triangulation, OfNoAreaHasTrianglesWithout) {
  EXPECT_EQ(triangles_of(Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}).size(), 2U);
  EXPECT_EQ(triangles_of(Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 1, 1}}).size(),
            3U);
  EXPECT_EQ(triangles_of(Polygon(6, {1, 2, 3})).size(), 4U);
}

}  // namespace
}  // namespace edgecase
