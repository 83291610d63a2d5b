// SPDX-License-Identifier: MIT
//
// Points and lines; random_triangles.cpp has the triangles.
#include "generate/random_shapes.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "generate/grids.h"

namespace edgecase {

namespace {

constexpr std::int64_t kOne = Fixed::kOne;
constexpr int kFinestSnap = 12;  // fraction bits of the finest sub-pixel grid in the catalogue

Fixed random_size(RandomSource& random, const Frame& frame) {
  if (!random.one_in(3)) return Fixed::from_integer(1);
  const std::int64_t largest = std::min(frame.target, 64);
  const std::int64_t whole = random.log_uniform(6);
  if (whole >= largest) return Fixed::from_integer(largest);
  if (random.one_in(2)) return Fixed::from_integer(whole);
  return Fixed::from_raw(whole * kOne + random.below(16) * kOne / 16);
}

// A vertex whose square has the centre of pixel (0, 0) on one side or on two.
Point tied_vertex(RandomSource& random, std::int64_t size, std::int64_t step) {
  const std::int64_t half = size / 2;
  const std::int64_t columns = random.sign() * half;
  const std::int64_t rows = random.sign() * half;
  const std::int64_t inner = half - half % step;
  const std::int64_t aside = random.between(-inner / step, inner / step) * step;
  const Point centre = pixel_centre(0, 0);
  switch (random.below(3)) {
    case 0:
      return centre + RawVector{columns, aside};
    case 1:
      return centre + RawVector{aside, rows};
    default:
      return centre + RawVector{columns, rows};
  }
}

// Places where a line's end is a tie, or next to one; places inside a diamond are rare.
DiamondPlace random_place(RandomSource& random) {
  return static_cast<DiamondPlace>(random.one_in(8)
                                       ? random.below(kDiamondPlaces)
                                       : random.below(static_cast<int>(DiamondPlace::inside)));
}

// Steps of a point on a diamond's edge must not exceed a sixteenth.
std::int64_t place_step(std::int64_t step) {
  return std::min(step, kOne / 16);
}

std::vector<Point> line_from_place(RandomSource& random, const Frame& frame, std::int64_t step) {
  const Point a = random_point_at(random_place(random), random, place_step(step));
  return {a, a + random_vector(random, frame.extent, step)};
}

std::vector<Point> line_between_places(RandomSource& random, const Frame& frame,
                                       std::int64_t step) {
  const Point a = random_point_at(random_place(random), random, place_step(step));
  const Point b = random_point_at(random_place(random), random, place_step(step));
  // Two points of one pixel are up to a pixel apart.
  const std::int64_t room = std::max<std::int64_t>(frame.extent / kOne - 1, 0);
  const RawVector away = random_vector(random, room * kOne, kOne);
  return {a, b + away};
}

// A line through a corner of a diamond of pixel (0, 0); the corner is a whole number of equal steps
// from either end.
std::vector<Point> line_through_corner(RandomSource& random, const Frame& frame,
                                       std::int64_t step) {
  const std::int64_t before = random.between(1, 3);
  const std::int64_t after = random.between(1, 3);
  const RawVector part = random_vector(random, frame.extent / (before + after), step);
  const auto corner = static_cast<DiamondPlace>(random.below(4));
  const Point through = point_at(corner, 2);
  return {through - before * part, through + after * part};
}

// A line along boundaries of diamonds: axis-aligned between rows of pixels, or diagonal.
std::vector<Point> line_along_boundaries(RandomSource& random, const Frame& frame,
                                         std::int64_t step) {
  const std::int64_t length =
      frame.extent < step ? frame.extent : frame.extent - frame.extent % step;
  const std::int64_t start = step * random.below(kOne / step);
  const std::int64_t forth = random.sign();
  const std::int64_t up = random.sign();
  if (random.one_in(2)) {
    const Point a{Fixed::from_raw(start), Fixed()};
    const Point b = a + RawVector{length, 0};
    const auto turned = [](Point p) { return Point{p.y, p.x}; };
    const bool upright = random.one_in(2);
    const std::vector<Point> line =
        upright ? std::vector<Point>{turned(a), turned(b)} : std::vector<Point>{a, b};
    return forth > 0 ? line : std::vector<Point>{line[1], line[0]};
  }
  const Point a =
      point_at(static_cast<DiamondPlace>(random.below(4)), 2) + RawVector{start, up * start};
  return {a, a + RawVector{forth * length, forth * up * length}};
}

std::vector<Point> tied_line(RandomSource& random, const Frame& frame, std::int64_t step) {
  switch (random.below(8)) {
    case 0:
    case 1:
    case 2:
    case 3:
      return line_from_place(random, frame, step);
    case 4:
      return line_between_places(random, frame, step);
    case 5:
    case 6:
      return line_through_corner(random, frame, step);
    default:
      return line_along_boundaries(random, frame, step);
  }
}

std::vector<Point> free_line(RandomSource& random, const Frame& frame) {
  if (random.one_in(64)) {
    const Point a = random_point(random, random_grid(random));
    return {a, a};
  }
  const Grid grid = random_grid(random);
  const Point a = random_point(random, grid);
  return {a, a + random_vector(random, frame.extent, grid.step)};
}

}  // namespace

RandomPoint random_point_shape(RandomSource& random, const Frame& frame) {
  const Fixed size = random_size(random, frame);
  // A point has only one vertex for snapping to move, so points are nudged more often.
  const Theme theme = random.one_in(3) ? Theme::near_tie : random_theme(random);
  const Point vertex = theme == Theme::free
                           ? random_point(random, random_grid(random))
                           : tied_vertex(random, size.raw(), step_of(random, theme));
  // The centre moves along, so that it ends up inside the target, too.
  std::vector<Point> points{vertex};
  if (theme != Theme::free) points.push_back(pixel_centre(0, 0));
  shift_inside(random, frame.target, points);
  points.resize(1);
  if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, points);
  return {points[0], size};
}

std::vector<Point> random_line_shape(RandomSource& random, const Frame& frame) {
  const Theme theme = random_theme(random);
  std::vector<Point> points = theme == Theme::free
                                  ? free_line(random, frame)
                                  : tied_line(random, frame, step_of(random, theme));
  if (random.one_in(2)) std::reverse(points.begin(), points.end());
  shift_inside(random, frame.target, points);
  if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, points);
  return points;
}

namespace {

// One of the eight rotations and reflections of a square.
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

// The point lies on the line's end, up to half its width from the middle.
std::vector<Point> line_ending_at(Point point, RandomSource& random, const Frame& frame,
                                  std::int64_t width, std::int64_t step) {
  // Steps of which any number of 1024ths can be taken.
  const RawVector along =
      random_vector(random, frame.extent, std::max<std::int64_t>(step, kOne / 64));
  const std::int64_t longer = std::max({std::abs(along.x), std::abs(along.y), std::int64_t{1}});
  const std::int64_t most = std::min<std::int64_t>(512 * width / longer, 1024);
  const std::int64_t parts = random.one_in(4) ? 0 : random.between(-most, most);
  const Point end = point + RawVector{-along.y * parts / 1024, along.x * parts / 1024};
  return {end, end + along};
}

// The point lies on a side of an axis-aligned line, or of one with the slope of a 3-4-5 triangle:
// only their sides, half a pixel away, have dyadic points.
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

std::vector<Point> free_area_line(RandomSource& random, const Frame& frame) {
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
    points = free_area_line(random, frame);
  } else {
    const std::int64_t step = step_of(random, theme);
    points = random.one_in(2) ? line_ending_at(tied, random, frame, width, step)
                              : line_beside(tied, random, frame, width, step);
  }
  if (!fits(points, frame)) points = free_area_line(random, frame);
  if (random.one_in(2)) std::reverse(points.begin(), points.end());
  shift_inside(random, frame.target, points);
  if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, points);
  return points;
}

}  // namespace edgecase
