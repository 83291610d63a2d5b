// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>

#include "generate/random_shapes.h"

namespace edgecase {
namespace {

constexpr int kFinestSnap = 12;

struct Edge {
  Point a;
  Point b;
};

// An edge through a point that is a whole number of equal steps from either end; with `from` 0 it
// may start there.
Edge edge_through(Point point, RandomSource& random, const Frame& frame, std::int64_t step,
                  std::int64_t from) {
  const std::int64_t before = random.between(from, 3);
  const std::int64_t after = random.between(1, 3);
  const RawVector part = random_vector(random, frame.extent / (before + after), step);
  return {point - before * part, point + after * part};
}

Edge free_edge(RandomSource& random, const Frame& frame, const Grid& grid) {
  const Point a = random_point(random, grid);
  return {a, a + random_vector(random, frame.extent, grid.step)};
}

// The third vertex. In a quarter of all cases it is so near to the edge that the triangle is a
// sliver, from a pixel down to 2^-16 thick; rarely the triangle has no area.
Point third_vertex(RandomSource& random, const Frame& frame, const Edge& edge, std::int64_t step) {
  if (random.one_in(64)) return random.one_in(2) ? edge.a : edge.a + 2 * (edge.b - edge.a);
  if (!random.one_in(4)) {
    const std::int64_t size = random.one_in(2) ? frame.most : frame.extent;
    return random_neighbour(random, edge.a, edge.b, size, step);
  }
  const RawVector along = edge.b - edge.a;
  const std::int64_t part = random.between(0, 256);
  const Point foot = edge.a + RawVector{along.x * part / 256, along.y * part / 256};
  const std::int64_t distance = random.log_uniform(16);
  const std::int64_t off = random.sign() * distance;
  return std::abs(along.x) >= std::abs(along.y) ? foot + RawVector{0, off}
                                                : foot + RawVector{off, 0};
}

bool spans_at_most(std::span<const Point> points, std::int64_t most) {
  for (Point p : points)
    for (Point q : points)
      if ((p - q).x > most || (p - q).y > most) return false;
  return true;
}

struct EdgeOfTheme {
  Edge edge;
  std::int64_t step;
};

EdgeOfTheme random_edge(RandomSource& random, const Frame& frame, Theme theme, std::int64_t from,
                        Point tied) {
  if (theme == Theme::free) {
    const Grid grid = random_grid(random);
    return {free_edge(random, frame, grid), grid.step};
  }
  const std::int64_t step = step_of(random, theme);
  return {edge_through(tied, random, frame, step, from), step};
}

}  // namespace

std::vector<Point> random_triangle_shape(RandomSource& random, const Frame& frame, Point tied) {
  const Theme theme = random_theme(random);
  const auto [edge, step] = random_edge(random, frame, theme, 0, tied);
  Point third = third_vertex(random, frame, edge, step);
  if (!spans_at_most(std::array{edge.a, edge.b, third}, frame.most)) third = edge.b;
  std::vector<Point> points{edge.a, edge.b, third};
  std::rotate(points.begin(), points.begin() + random.below(3), points.end());
  if (random.one_in(2)) std::swap(points[0], points[1]);
  shift_inside(random, frame.target, points);
  if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, points);
  return points;
}

std::vector<Point> random_pair_shape(RandomSource& random, const Frame& frame) {
  for (;;) {
    const Theme theme = random_theme(random);
    const auto [edge, step] = random_edge(random, frame, theme, 1, pixel_centre(0, 0));
    std::vector<Point> points{edge.a, edge.b, third_vertex(random, frame, edge, step),
                              third_vertex(random, frame, edge, step)};
    if (!spans_at_most(points, frame.most)) continue;
    shift_inside(random, frame.target, points);
    if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, points);
    const RawVector along = points[1] - points[0];
    const std::int64_t left = turn(along, points[2] - points[0]);
    const std::int64_t right = turn(along, points[3] - points[0]);
    // On opposite sides; other samples are discarded.
    if (left == 0 || right == 0 || (left > 0) == (right > 0)) continue;
    const Point a = points[0];
    const Point b = points[1];
    std::array<Point, 3> first{a, b, points[2]};
    std::array<Point, 3> second{b, a, points[3]};
    std::rotate(first.begin(), first.begin() + random.below(3), first.end());
    std::rotate(second.begin(), second.begin() + random.below(3), second.end());
    if (random.one_in(2)) std::swap(second[0], second[1]);
    return {first[0], first[1], first[2], second[0], second[1], second[2]};
  }
}

}  // namespace edgecase
