// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <vector>

#include "generate/random_scenes.h"
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

namespace {

// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kStream = 0x6300;
constexpr std::int64_t kOne = Fixed::kOne;
constexpr int kMostTarget = 16;  // pixels

// An offset from a multiple of `step`: 0, halfway to the next, or close to either.
std::int64_t random_offset(RandomSource& random, std::int64_t step) {
  if (random.one_in(3)) return 0;
  const std::int64_t place = random.between(-3, 3) * (step / 2);
  return place + random.between(-1, 1);
}

class Places {
 public:
  Places(RandomSource& random, int target) : random_(random), target_(target) {
    constexpr std::array kBits{4, 4, 4, 8, 8, 8, 0, 0};
    const int bits = random.one_of(std::span<const int>(kBits));
    step_ = kOne >> (bits == 0 ? random.between(2, 12) : bits);
  }

  // Near a multiple of half a pixel, an odd one if `on_centre`.
  Fixed coordinate(bool on_centre) {
    const std::int64_t whole = random_.between(1, target_ - 2) * kOne + (on_centre ? kOne / 2 : 0);
    return Fixed::from_raw(whole + random_offset(random_, step_));
  }
  Point point(bool on_centre) {
    const Fixed x = coordinate(on_centre);
    return {x, coordinate(on_centre)};
  }
  // Any multiple of the step, a point halfway, or a point close to either.
  Fixed anywhere() {
    const std::int64_t steps = random_.between(1, (target_ - 1) * (kOne / step_) - 1);
    return Fixed::from_raw(steps * step_ + random_offset(random_, step_));
  }

 private:
  RandomSource& random_;
  int target_;
  std::int64_t step_ = kOne;
};

// Most edges are axis-aligned, so that a vertex's snap decides a whole row of samples.
std::vector<Point> triangle_of(RandomSource& random, Places& places) {
  const Point corner = places.point(true);
  if (random.one_in(3)) return {corner, places.point(random.one_in(2)), places.point(true)};
  std::vector<Point> points{corner, {corner.x, places.anywhere()}, {places.anywhere(), corner.y}};
  if (random.one_in(2)) std::swap(points[0], points[1]);
  return points;
}

std::vector<Point> line_of(RandomSource& random, Places& places) {
  // An end at a diamond's corner or centre: one coordinate whole, one a half.
  const auto end = [&] {
    const bool upright = random.one_in(2);
    const Fixed x = places.coordinate(upright);
    return Point{x, places.coordinate(!upright)};
  };
  const Point a = end();
  if (random.one_in(2)) return {a, end()};
  const bool upright = random.one_in(2);
  const Fixed other = places.anywhere();
  return {a, upright ? Point{a.x, other} : Point{other, a.y}};
}

bool are_inside(const std::vector<Point>& points, int target) {
  for (const Point& point : points)
    if (!strictly_inside(point, target)) return false;
  return true;
}

}  // namespace

Scene random_snap_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kStream, index);
  for (;;) {
    const int target = random_frame(random, kMostTarget).target;
    Places places(random, target);
    std::vector<Point> points;
    Primitive primitive = Primitive::triangles;
    switch (random.below(4)) {
      case 0:
        primitive = Primitive::points;
        points = {places.point(false)};
        break;
      case 1:
        primitive = Primitive::lines;
        points = line_of(random, places);
        break;
      default:
        points = triangle_of(random, places);
        break;
    }
    // Offsets may cross the target's border.
    if (are_inside(points, target)) return scene_of(surface, target, primitive, points);
  }
}

}  // namespace edgecase
