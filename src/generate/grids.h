// SPDX-License-Identifier: MIT
//
// Grid lines: all lines between points of a coarse grid, one after another.
//
// What a search finds with fine coordinates may also exist with coarse ones, which are easy to
// read. Random scenes cannot rule that out; these scenes are complete. Lines that differ by whole
// pixels count as one, the one nearest to the origin.
#pragma once

#include <array>
#include <cstdint>

#include "exact/fixed.h"
#include "generate/random_scenes.h"
#include "generate/random_shapes.h"
#include "model/scene.h"

namespace edgecase {

// The cases that a line rule distinguishes: the parts of a pixel's diamond, and the directions in
// which a line can pass them.

// The direction of a line, y up, counter-clockwise from the right: the axes, the exact diagonals,
// and the eight octants between them.
enum class LineDirection {
  right,
  x_major_right_rising,
  diagonal_right_rising,
  y_major_right_rising,
  up,
  y_major_left_rising,
  diagonal_left_rising,
  x_major_left_rising,
  left,
  x_major_left_falling,
  diagonal_left_falling,
  y_major_left_falling,
  down,
  y_major_right_falling,
  diagonal_right_falling,
  x_major_right_falling,
};
constexpr int kLineDirections = 16;

// A vector in a direction whose longer component is about `length`, both multiples of `step`; raw
// units, at least two steps long.
RawVector random_along(RandomSource& random, LineDirection direction, std::int64_t length,
                       std::int64_t step);

// A place in a pixel relative to the diamond |dx| + |dy| < 1/2 round its centre. Edges exclude
// their ends; an outside place is a quarter of the pixel's square without its border.
enum class DiamondPlace {
  left_corner,
  right_corner,
  bottom_corner,
  top_corner,
  lower_left_edge,
  lower_right_edge,
  upper_left_edge,
  upper_right_edge,
  inside,
  lower_left_outside,
  lower_right_outside,
  upper_left_outside,
  upper_right_outside,
};
constexpr int kDiamondPlaces = 13;

// The point of pixel (0, 0) at a place, given one number: raw units, at least 2 and less than 1/2
// pixel. On an edge it is the horizontal distance from the centre; outside, half the distance from
// either side of the pixel's square; inside, the distance from the centre, halved in x and
// quartered in y. A corner is a single point.
Point point_at(DiamondPlace place, std::int64_t along);

// One of those points, with coordinates that are multiples of `step`: raw, a power of two up to
// 1/16 pixel.
Point random_point_at(DiamondPlace place, RandomSource& random, std::int64_t step);

// The lines of a square target whose ends lie strictly inside it, on multiples of a fraction of a
// pixel, including lines of length 0.
class GridLines {
 public:
  // `size`: pixels per side, at least 2; `steps`: per pixel, a power of two up to 2^16.
  constexpr GridLines(int size, int steps) : size_(size), steps_(steps) {}

  std::uint64_t count() const { return pairs() * pairs(); }
  // Start and end of a line. `number` is below count(); different numbers give different lines.
  std::array<Point, 2> line(std::uint64_t number) const;
  // For consecutive indices, a permutation of all numbers that is spread over them from the start;
  // `seed` determines where it begins. It repeats after count().
  std::uint64_t strewn(std::uint64_t seed, std::uint64_t index) const;

 private:
  // The pairs of both ends' coordinates along one axis.
  std::uint64_t pairs() const;
  std::array<Fixed, 2> pair(std::uint64_t number) const;

  int size_;
  int steps_;
};

// Easily readable lines: multiples of 1/16 within 16x16 pixels.
inline constexpr GridLines kReadableLines{16, 16};
inline constexpr std::uint64_t kGridLinesOfScene = 32;

// Lines of kReadableLines, kGridLinesOfScene per scene. Scenes 0 to grid_line_scenes() - 1 of one
// seed contain every line once. The second form draws them 2 pixels wide.
Scene grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index);
Scene wide_grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index);
std::uint64_t grid_line_scenes();

// The same with 4 samples per pixel, on framebuffer objects, one line per scene: renderers answer
// sample by sample, which takes as long as a scene of 32 lines without samples.
Scene multisampled_grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index);
std::uint64_t multisampled_grid_line_scenes();

// Grid joints: two lines that meet, between points of a coarse grid.
//
// They are too many to be listed completely, as grid lines are, but faults of joints with fine
// coordinates are found here with readable ones.
inline constexpr int kGridJointsOfScene = 16;

// kGridJointsOfScene pairs of lines in one draw: the first of a pair ends where the second starts.
// All points are multiples of 1/16 strictly inside a target of 16x16 pixels; half of the joints are
// at multiples of 1/2, where ends usually are ties. In one of four scenes lines are half a pixel
// wide, which are drawn as wide as a pixel.
Scene grid_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index);

}  // namespace edgecase
