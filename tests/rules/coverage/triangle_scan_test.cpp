// SPDX-License-Identifier: MIT
//
// Scan conversion and edge functions in single precision against the same algorithms written with
// the processor's.
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/scan_conversion.h"
#include "rules/coverage/triangle_algorithm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/support/points.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

struct V {
  float x, y;
};

struct Edge {
  float dx, dy, slope, x, y;
  int rows;
};

Edge edge(V low, V high, float high_shifted) {
  Edge e{};
  e.dx = high.x - low.x;
  e.dy = high.y - low.y;
  e.slope = e.dy != 0 ? e.dx / e.dy : 0.0f;
  const float y = low.y - 0.5f;
  e.y = std::ceil(y);
  const float back = (e.y - y) * e.slope;
  e.x = (low.x + 0.5f) + back;
  e.rows = static_cast<int>(std::ceil(high_shifted - e.y));
  return e;
}

void rows(Edge& left, Edge& right, int count, const PixelBounds& bounds, Pixels& pixels) {
  const int first = static_cast<int>(left.y);
  for (int k = 0; k < count; ++k) {
    const float lk = static_cast<float>(k) * left.slope;
    const float rk = static_cast<float>(k) * right.slope;
    for (int x = static_cast<int>(left.x + lk); x < static_cast<int>(right.x + rk); ++x)
      if (bounds.contains({x, first + k})) pixels.push_back({x, first + k});
  }
  const float lines = static_cast<float>(count);
  const float lx = lines * left.slope;
  const float rx = lines * right.slope;
  left.x += lx;
  right.x += rx;
  left.y += lines;
  right.y += lines;
}

Pixels literal(const Triangle& triangle, const PixelBounds& bounds) {
  std::array<V, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = {static_cast<float>(triangle[i].x.to_double()),
            static_cast<float>(triangle[i].y.to_double())};
  std::stable_sort(v.begin(), v.end(), [](V a, V b) { return a.y < b.y; });
  Edge major = edge(v[0], v[2], v[2].y - 0.5f);
  Edge top = edge(v[1], v[2], v[2].y - 0.5f);
  Edge bottom = edge(v[0], v[1], v[1].y - 0.5f);
  const float p = major.dx * bottom.dy;
  const float q = bottom.dx * major.dy;
  const float area = p - q;
  if (area == 0) return {};
  Pixels pixels;
  if (area < 0) {
    rows(major, bottom, bottom.rows, bounds, pixels);
    rows(major, top, top.rows, bounds, pixels);
  } else {
    rows(bottom, major, bottom.rows, bounds, pixels);
    rows(top, major, top.rows, bounds, pixels);
  }
  return pixels;
}

TEST(TriangleScan, DrawsWhatSinglePrecisionDoes) {
  std::mt19937_64 random(share_seed(11));
  int inexact = 0;
  for (int i = 0; i < share_of(60'000, 6'000); ++i) {
    const int size = 1 << (2 + random() % 6);
    const int grid = static_cast<int>(random() % 17);
    const auto coordinate = [&] {
      const auto raw = static_cast<std::int64_t>(
          random() % (static_cast<std::uint64_t>(size) * Fixed::kOne + 1));
      return Fixed::from_raw(raw >> grid << grid);
    };
    const Triangle triangle = {Point{coordinate(), coordinate()},
                               {coordinate(), coordinate()},
                               {coordinate(), coordinate()}};
    const PixelBounds bounds{0, 0, size - 1, size - 1};
    const Pixels scanned = sorted(scanned_triangle_pixels(triangle, bounds));
    ASSERT_EQ(scanned, sorted(literal(triangle, bounds)));
    const Pixels exact = triangle_pixels(triangle, bounds, TriangleAlgorithm::edge_functions,
                                         *find_tie_rule("right-top"));
    if (scanned != sorted(exact)) ++inexact;
  }
  // It would prove little if rounding never showed.
  EXPECT_GT(inexact, least_of(100));
}

TEST(TriangleScan, OwnsRightAndTopEdges) {
  const auto at = [](int x, int y) { return Point{Fixed::centre_of(x), Fixed::centre_of(y)}; };
  const PixelBounds bounds{0, 0, 7, 7};
  // A square of two triangles from centre to centre: its left column and bottom row are not drawn.
  Pixels pixels = scanned_triangle_pixels({at(1, 1), at(4, 1), at(4, 4)}, bounds);
  const Pixels other = scanned_triangle_pixels({at(1, 1), at(4, 4), at(1, 4)}, bounds);
  pixels.insert(pixels.end(), other.begin(), other.end());
  EXPECT_THAT(sorted(pixels), ::testing::SizeIs(9));
  for (PixelPosition p : pixels) {
    EXPECT_GE(p.x, 2);
    EXPECT_LE(p.x, 4);
  }
}

// The whole bounding box, by three edge functions in the processor's floats; counter-clockwise.
Pixels literal_edges(const Triangle& t, const PixelBounds& bounds, bool closed) {
  const auto area = (t[1].x - t[0].x).to_double() * (t[2].y - t[0].y).to_double() -
                    (t[1].y - t[0].y).to_double() * (t[2].x - t[0].x).to_double();
  if (area == 0) return {};
  std::array<V, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = {static_cast<float>(t[i].x.to_double()), static_cast<float>(t[i].y.to_double())};
  if (area < 0) std::swap(v[1], v[2]);
  Pixels pixels;
  for (int y = bounds.y_min; y <= bounds.y_max; ++y)
    for (int x = bounds.x_min; x <= bounds.x_max; ++x) {
      const V p{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const V a = v[i], b = v[(i + 1) % 3];
        const float rise = (b.x - a.x) * (p.y - a.y);
        const float run = (b.y - a.y) * (p.x - a.x);
        const float value = rise - run;
        inside = inside && (closed ? value >= 0 : value > 0);
      }
      if (inside) pixels.push_back({x, y});
    }
  return pixels;
}

TEST(FloatEdges, DrawWhatSinglePrecisionDoes) {
  std::mt19937_64 random(share_seed(12));
  int inexact = 0;
  for (int i = 0; i < share_of(20'000, 1'000); ++i) {
    const int size = 1 << (4 + random() % 3);
    const auto coordinate = [&] {
      return Fixed::from_raw(static_cast<std::int64_t>(
          random() % (static_cast<std::uint64_t>(size) * Fixed::kOne + 1)));
    };
    Triangle triangle = {Point{coordinate(), coordinate()},
                         {coordinate(), coordinate()},
                         {coordinate(), coordinate()}};
    // An edge through a centre, but for the rounding of its end.
    const Point through = pixel_centre(size / 2, size / 2);
    const auto opposite = [&](Fixed end, Fixed middle) {
      const std::int64_t distance = (middle - end).raw();
      return middle + Fixed::from_raw(distance - distance / 3);
    };
    if (i % 8 != 0)
      triangle[1] = {opposite(triangle[0].x, through.x), opposite(triangle[0].y, through.y)};
    const PixelBounds bounds{0, 0, size - 1, size - 1};
    for (const bool closed : {false, true}) {
      const TieRule ties = closed ? closed_ties() : open_ties();
      const Pixels rounded =
          sorted(triangle_pixels(triangle, bounds, TriangleAlgorithm::float_edges, ties));
      ASSERT_EQ(rounded, sorted(literal_edges(triangle, bounds, closed))) << i;
      if (rounded !=
          sorted(triangle_pixels(triangle, bounds, TriangleAlgorithm::edge_functions, ties)))
        ++inexact;
    }
  }
  EXPECT_GT(inexact, least_of(50));
}

}  // namespace
}  // namespace edgecase
