// SPDX-License-Identifier: MIT
//
// How random primitives come about: first a size, then a shape of about that size round pixel
// (0, 0), then a shift by whole pixels that takes it to a random place strictly inside the target.
// Whole pixels change nothing about ties, so a shape can be built round one beforehand.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "generate/random_scenes.h"
#include "generate/random_source.h"
#include "generate/scene_parts.h"

namespace edgecase {

// How large a scene is.
struct Frame {
  int target = 0;           // pixels: a power of two
  std::int64_t extent = 0;  // raw: of the primitive's longer side
  std::int64_t most = 0;    // raw: a shape no longer than this fits the target somewhere
};
// `largest`: of the target, pixels, a power of two.
Frame random_frame(RandomSource& random, int largest = kMostRandomExtent);

// The same on a target of at least 8 pixels: shapes of several primitives need room.
Frame with_room(Frame frame);

// Coordinates of a scene: offset + any multiple of step; raw.
struct Grid {
  std::int64_t step = Fixed::kOne;
  std::int64_t offset = 0;
};
// From whole pixels to 2^-16, pixel centres and the midpoints between sub-pixel steps among them.
Grid random_grid(RandomSource& random);
// A step of 2^-1 to 2^-16 pixel, coarse ones often.
std::int64_t random_step(RandomSource& random);

// A vector with a longer component of about `extent`, of any direction: axes, diagonals, flat and
// steep ones often. Its components are multiples of `step`, unless they are shorter; both may be 0
// only where the extent is.
RawVector random_vector(RandomSource& random, std::int64_t extent, std::int64_t step);

// A point of the grid in pixel (0, 0), its left and lower border included.
Point random_point(RandomSource& random, const Grid& grid);

// Any point of a square, `size` raw wide, that contains two points and may reach beyond them;
// multiples of `step` away from the first.
Point random_neighbour(RandomSource& random, Point a, Point b, std::int64_t size,
                       std::int64_t step);

// Shifts points by whole pixels, so that all lie strictly inside the target. They must span no more
// than Frame::most.
void shift_inside(RandomSource& random, int target, std::span<Point> points);

// Moves coordinates by fractions of a step of 2^-4 to 2^-`finest` pixel, so that it depends on how
// vertices are snapped where a tie ends up. A vertex that would leave the target stays.
void nudge(RandomSource& random, int finest, int target, std::span<Point> points);

// What a scene is built round.
enum class Theme {
  tie,       // a sample exactly on a boundary
  near_tie,  // the same, nudged
  free,      // nothing: any numbers
};
Theme random_theme(RandomSource& random);

// The step of a tie's vertices: one that nudges do not hide.
std::int64_t step_of(RandomSource& random, Theme theme);

// The points of each kind of primitive.
struct RandomPoint {
  Point vertex;
  Fixed size;
};
RandomPoint random_point_shape(RandomSource& random, const Frame& frame);
std::vector<Point> random_line_shape(RandomSource& random, const Frame& frame);
// Ties are with a point of pixel (0, 0).
std::vector<Point> random_triangle_shape(RandomSource& random, const Frame& frame,
                                         Point tied = pixel_centre(0, 0));
// Six: two triangles on opposite sides of their common edge.
std::vector<Point> random_pair_shape(RandomSource& random, const Frame& frame);

// A line that is an area, raw units wide. Ties are with a point of pixel (0, 0): on one of its ends
// or on one of its sides.
std::vector<Point> random_area_line_shape(RandomSource& random, const Frame& frame,
                                          std::int64_t width, Point tied);

}  // namespace edgecase
