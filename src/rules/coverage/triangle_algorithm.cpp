// SPDX-License-Identifier: MIT
#include "rules/coverage/triangle_algorithm.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "exact/binary32.h"

namespace edgecase {
namespace {

// The edge a -> b of a counter-clockwise triangle, starting at the centre of pixel (x, y). One step
// beyond a sample of the window stays below 2^62.
WalkedEdge<std::int64_t> walked_edge(Point a, Point b, int x, int y, const TieRule& ties) {
  const std::int64_t right = a.y.raw() - b.y.raw();
  const std::int64_t up = b.x.raw() - a.x.raw();
  return {cross(a, b, pixel_centre(x, y)), right * Fixed::kOne, up * Fixed::kOne,
          ties.positive(0, right, up)};
}

std::vector<PixelPosition> by_edge_functions(const Triangle& triangle, const PixelBounds& bounds,
                                             const TieRule& ties) {
  if (doubled_area(triangle) == 0) return {};
  const Triangle t = counter_clockwise(triangle);
  const PixelBounds some = sample_bounds(triangle, bounds);
  const auto edge = [&](std::size_t i) {
    return walked_edge(t[i], t[(i + 1) % 3], some.x_min, some.y_min, ties);
  };
  return walk_edges<std::int64_t>({edge(0), edge(1), edge(2)}, some);
}

// The function of the edge a -> b, where each operation is rounded.
Binary32 rounded_cross(Point a, Point b, Point p) {
  const auto x = [](Point of) { return Binary32::from_fixed(of.x); };
  const auto y = [](Point of) { return Binary32::from_fixed(of.y); };
  return (x(b) - x(a)) * (y(p) - y(a)) - (y(b) - y(a)) * (x(p) - x(a));
}

std::vector<PixelPosition> by_rounded_edges(const Triangle& triangle, const PixelBounds& bounds,
                                            const TieRule& ties) {
  if (doubled_area(triangle) == 0) return {};
  const Triangle t = counter_clockwise(triangle);
  const PixelBounds some = sample_bounds(triangle, bounds);
  const auto is_inside = [&](std::size_t i, Point sample) {
    const Point a = t[i], b = t[(i + 1) % 3];
    const Binary32 value = rounded_cross(a, b, sample);
    if (!value.is_zero()) return !value.is_negative();
    return ties.positive(0, a.y.raw() - b.y.raw(), b.x.raw() - a.x.raw());
  };
  std::vector<PixelPosition> pixels;
  for (int y = some.y_min; y <= some.y_max; ++y)
    for (int x = some.x_min; x <= some.x_max; ++x)
      if (const Point sample = pixel_centre(x, y);
          is_inside(0, sample) && is_inside(1, sample) && is_inside(2, sample))
        pixels.push_back({x, y});
  return pixels;
}

}  // namespace

bool has_tie_rule(TriangleAlgorithm algorithm) {
  return algorithm != TriangleAlgorithm::scan;
}

PixelBounds sample_bounds(const Triangle& t, const PixelBounds& bounds) {
  const auto [x_low, x_high] = std::minmax({t[0].x, t[1].x, t[2].x});
  const auto [y_low, y_high] = std::minmax({t[0].y, t[1].y, t[2].y});
  const auto low = [](int bound, Fixed value) {
    return static_cast<int>(std::max<std::int64_t>(bound, value.floor() - 1));
  };
  const auto high = [](int bound, Fixed value) {
    return static_cast<int>(std::min<std::int64_t>(bound, value.floor() + 1));
  };
  return {low(bounds.x_min, x_low), low(bounds.y_min, y_low), high(bounds.x_max, x_high),
          high(bounds.y_max, y_high)};
}

std::vector<PixelPosition> triangle_pixels(const Triangle& triangle, const PixelBounds& bounds,
                                           TriangleAlgorithm algorithm, const TieRule& ties) {
  switch (algorithm) {
    case TriangleAlgorithm::edge_functions:
      return by_edge_functions(triangle, bounds, ties);
    case TriangleAlgorithm::scan:
      return scanned_triangle_pixels(triangle, bounds);
    case TriangleAlgorithm::float_edges:
      return by_rounded_edges(triangle, bounds, ties);
  }
  return {};
}

std::vector<PixelPosition> tied_triangle_pixels(const Triangle& triangle,
                                                const PixelBounds& bounds) {
  std::vector<PixelPosition> pixels = by_edge_functions(triangle, bounds, closed_ties());
  std::erase_if(pixels,
                [&](PixelPosition p) { return triangle_covers(triangle, p.x, p.y, open_ties()); });
  return pixels;
}

Rule triangle_algorithm_rule() {
  Rule rule;
  rule.id = RuleId::triangle_algorithm;
  rule.title =
      "The samples inside a triangle are found exactly or by a known algorithm that rounds";
  rule.spec = "14.6.1 (basic polygon rasterization)";
  rule.latitude = "any algorithm that obeys rulings 4 and 5";
  rule.standard = "edge-functions";
  rule.alternatives = alternatives_of<TriangleAlgorithm>();
  return rule;
}

// ------------------------------------------------------------- scan conversion in single precision

namespace {

struct ScanVertex {
  Binary32 x;
  Binary32 y;
};

// No constexpr: clang 14 has not made the template by which it is rounded yet.
const Binary32 kHalf = Binary32::from_fixed(Fixed::from_raw(Fixed::kOne / 2));

// The first row whose centre is not below y.
std::int64_t first_row(Binary32 y) {
  return (y - kHalf).ceil();
}

// An edge that is walked upward: at the centre of row first + k it crosses at x + k * slope. x has
// half a pixel added, so that dropping the fraction gives the first pixel beyond the edge.
struct ScanEdge {
  Binary32 x;
  Binary32 slope;
  std::int64_t rows = 0;

  ScanEdge(ScanVertex low, ScanVertex high) {
    const Binary32 rise = high.y - low.y;
    slope = rise.is_zero() ? Binary32() : (high.x - low.x) / rise;
    const Binary32 first = Binary32::from_integer(first_row(low.y));
    x = low.x + kHalf + (first - (low.y - kHalf)) * slope;
    rows = (high.y - kHalf - first).ceil();
  }
  std::int64_t crossing(std::int64_t row) const {
    return (x + Binary32::from_integer(row) * slope).truncate();
  }
  // Starts again, that many rows further up.
  void go_up(std::int64_t by) { x = x + Binary32::from_integer(by) * slope; }
};

// Draws `rows` rows from row `first`, from the left edge up to the right one, exclusive.
void fill(const ScanEdge& left, const ScanEdge& right, std::int64_t first, std::int64_t rows,
          const PixelBounds& bounds, std::vector<PixelPosition>& pixels) {
  const std::int64_t begin = std::max<std::int64_t>(first, bounds.y_min);
  const std::int64_t end = std::min<std::int64_t>(first + rows, bounds.y_max + 1);
  for (std::int64_t y = begin; y < end; ++y) {
    const auto from = std::max<std::int64_t>(left.crossing(y - first), bounds.x_min);
    const auto to = std::min<std::int64_t>(right.crossing(y - first), bounds.x_max + 1);
    for (std::int64_t x = from; x < to; ++x)
      pixels.push_back({static_cast<int>(x), static_cast<int>(y)});
  }
}

}  // namespace

std::vector<PixelPosition> scanned_triangle_pixels(const Triangle& triangle,
                                                   const PixelBounds& bounds) {
  std::array<ScanVertex, 3> v;
  for (std::size_t i = 0; i < 3; ++i)
    v[i] = {Binary32::from_fixed(triangle[i].x), Binary32::from_fixed(triangle[i].y)};
  std::stable_sort(v.begin(), v.end(), [](const ScanVertex& a, const ScanVertex& b) {
    return (a.y - b.y).is_negative();
  });
  const auto& [low, middle, high] = v;
  const Binary32 area =
      (high.x - low.x) * (middle.y - low.y) - (middle.x - low.x) * (high.y - low.y);
  // A triangle whose area rounds to zero is not drawn.
  if (area.is_zero()) return {};

  std::vector<PixelPosition> pixels;
  ScanEdge major(low, high);
  const ScanEdge bottom(low, middle);
  const ScanEdge top(middle, high);
  const bool major_left = area.is_negative();
  const auto fill_between = [&](const ScanEdge& other, std::int64_t first) {
    if (major_left)
      fill(major, other, first, other.rows, bounds, pixels);
    else
      fill(other, major, first, other.rows, bounds, pixels);
  };
  fill_between(bottom, first_row(low.y));
  major.go_up(bottom.rows);
  fill_between(top, first_row(low.y) + bottom.rows);
  return pixels;
}

// ---------------------------------------------------------- triangles whose vertices are quotients

namespace {

// A sample's coordinates are at most 2^30 and its w 2^16, so an edge function is below 2^111 by the
// bounds of exact/homogeneous.h: within the range of TieRule.
bool inside_edge(const HomogeneousPoint& a, const HomogeneousPoint& b,
                 const HomogeneousPoint& sample, const TieRule& ties) {
  [[maybe_unused]] constexpr std::int64_t kMost = std::int64_t{1} << 30;
  assert(std::abs(sample.x) <= kMost && std::abs(sample.y) <= kMost);
  assert(0 < sample.w && sample.w <= Fixed::kOne);
  const Int128 right = Int128{a.y} * b.w - Int128{b.y} * a.w;
  const Int128 up = Int128{b.x} * a.w - Int128{a.x} * b.w;
  return ties.positive(cross(a, b, sample), right, up);
}

// The same function, starting at a sample. The next pixel's sample has its coordinate larger by w.
WalkedEdge<Int128> walked_edge(const HomogeneousPoint& a, const HomogeneousPoint& b,
                               const HomogeneousPoint& sample, const TieRule& ties) {
  const Int128 right = Int128{a.y} * b.w - Int128{b.y} * a.w;
  const Int128 up = Int128{b.x} * a.w - Int128{a.x} * b.w;
  return {cross(a, b, sample), right * sample.w, up * sample.w, ties.positive(0, right, up)};
}

// The triangle moved so that the samples of pixels become their centres.
Triangle centred(const Triangle& triangle, Point within) {
  const Point centre = centre_of_pixel();
  const auto moved = [&](Point p) {
    return Point{p.x + centre.x - within.x, p.y + centre.y - within.y};
  };
  return {moved(triangle[0]), moved(triangle[1]), moved(triangle[2])};
}

}  // namespace

Triangle nearest_triangle(const HomogeneousTriangle& t) {
  return {nearest_point(t[0]), nearest_point(t[1]), nearest_point(t[2])};
}

bool triangle_covers(const HomogeneousTriangle& triangle, const HomogeneousPoint& sample,
                     const TieRule& ties) {
  const auto& [a, b, c] = triangle;
  const Int128 area = cross(a, b, c);
  if (area == 0) return false;
  const auto inside = [&](const HomogeneousPoint& from, const HomogeneousPoint& to) {
    return area > 0 ? inside_edge(from, to, sample, ties) : inside_edge(to, from, sample, ties);
  };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

std::vector<PixelPosition> triangle_pixels(const HomogeneousTriangle& triangle,
                                           const PixelBounds& bounds, TriangleAlgorithm algorithm,
                                           const TieRule& ties, Point within) {
  const Triangle nearest = nearest_triangle(triangle);
  if (algorithm != TriangleAlgorithm::edge_functions)
    return triangle_pixels(centred(nearest, within), bounds, algorithm, ties);
  // The nearest triangle's box reaches a pixel beyond it, so it contains the samples of this one.
  const PixelBounds some = sample_bounds(nearest, bounds);
  const auto& [a, b, c] = triangle;
  const Int128 area = cross(a, b, c);
  if (area == 0) return {};
  const bool at_centre = within == centre_of_pixel();
  const PixelPosition first{some.x_min, some.y_min};
  const HomogeneousPoint sample =
      at_centre ? homogeneous_centre(first.x, first.y) : homogeneous(place_in(first, within));
  const auto edge = [&](const HomogeneousPoint& from, const HomogeneousPoint& to) {
    return area > 0 ? walked_edge(from, to, sample, ties) : walked_edge(to, from, sample, ties);
  };
  return walk_edges<Int128>({edge(a, b), edge(b, c), edge(c, a)}, some);
}

}  // namespace edgecase
