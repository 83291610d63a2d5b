// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstdlib>

#include "generate/random_shapes.h"

namespace edgecase {
namespace {

constexpr std::int64_t kOne = Fixed::kOne;
constexpr int kFinestSnap = 12;

// One of the eight ways to turn and mirror a square.
struct Turn {
  bool swapped = false;
  std::int64_t x = 1;
  std::int64_t y = 1;

  RawVector operator()(RawVector v) const {
    return swapped ? RawVector{y * v.y, x * v.x} : RawVector{x * v.x, y * v.y};
  }
};

Turn random_turn(RandomSource& random) {
  const bool swapped = random.one_in(2);
  const std::int64_t x = random.sign();
  return {swapped, x, random.sign()};
}

// The point lies on the line's end, up to half its width aside.
std::vector<Point> line_ending_at(Point point, RandomSource& random, const Frame& frame,
                                  std::int64_t width, std::int64_t step) {
  // Steps from which any number of 1024th parts can be taken.
  const RawVector along =
      random_vector(random, frame.extent, std::max<std::int64_t>(step, kOne / 64));
  const std::int64_t longer = std::max({std::abs(along.x), std::abs(along.y), std::int64_t{1}});
  const std::int64_t most = std::min<std::int64_t>(512 * width / longer, 1024);
  const std::int64_t parts = random.one_in(4) ? 0 : random.between(-most, most);
  const Point end = point + RawVector{-along.y * parts / 1024, along.x * parts / 1024};
  return {end, end + along};
}

// The point lies on a side of a line of an axis, or of a 3-4-5 triangle's direction, the only ones
// whose sides, half a pixel away, have dyadic points.
std::vector<Point> line_beside(Point point, RandomSource& random, const Frame& frame,
                               std::int64_t width, std::int64_t step) {
  const std::int64_t half = width / 2;
  const bool is_on_axis = random.one_in(2);
  const RawVector unit = is_on_axis ? RawVector{1, 0} : RawVector{4, 3};
  // 3 x - 4 y = 5 half for the slanted one.
  const RawVector aside = is_on_axis ? RawVector{0, half} : RawVector{-half, -2 * half};
  const std::int64_t steps = std::max<std::int64_t>(frame.extent / (is_on_axis ? 1 : 4) / step, 1);
  const std::int64_t before = step * random.between(0, steps);
  const std::int64_t after = step * steps - before;
  const Turn turned = random_turn(random);
  const Point foot = point + turned(aside);
  return {foot - before * turned(unit), foot + after * turned(unit)};
}

std::vector<Point> free_line(RandomSource& random, const Frame& frame) {
  const Grid grid = random_grid(random);
  const Point a = random_point(random, grid);
  if (random.one_in(64)) return {a, a};
  return {a, a + random_vector(random, frame.extent, grid.step)};
}

bool fits(const std::vector<Point>& line, const Frame& frame) {
  const RawVector along = line[1] - line[0];
  return std::abs(along.x) <= frame.most && std::abs(along.y) <= frame.most;
}

}  // namespace

std::vector<Point> random_area_line_shape(RandomSource& random, const Frame& frame,
                                          std::int64_t width, Point tied) {
  const Theme theme = random_theme(random);
  std::vector<Point> points;
  if (theme == Theme::free) {
    points = free_line(random, frame);
  } else {
    const std::int64_t step = step_of(random, theme);
    points = random.one_in(2) ? line_ending_at(tied, random, frame, width, step)
                              : line_beside(tied, random, frame, width, step);
  }
  if (!fits(points, frame)) points = free_line(random, frame);
  if (random.one_in(2)) std::reverse(points.begin(), points.end());
  shift_inside(random, frame.target, points);
  if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, points);
  return points;
}

}  // namespace edgecase
