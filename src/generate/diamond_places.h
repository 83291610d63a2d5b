// SPDX-License-Identifier: MIT
//
// The cases that a line rule distinguishes: the parts of a pixel's diamond, and the directions in
// which a line can pass them.
#pragma once

#include <optional>

#include "exact/fixed.h"
#include "exact/pixel.h"
#include "generate/random_source.h"
#include "generate/scene_parts.h"
#include "model/names.h"
#include "rules/coverage/segment.h"

namespace edgecase {

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

template <>
inline constexpr auto kNames<LineDirection> = std::to_array<Named<LineDirection>>(
    {{LineDirection::right, "right"},
     {LineDirection::x_major_right_rising, "x-major right, rising"},
     {LineDirection::diagonal_right_rising, "diagonal right, rising"},
     {LineDirection::y_major_right_rising, "y-major right, rising"},
     {LineDirection::up, "up"},
     {LineDirection::y_major_left_rising, "y-major left, rising"},
     {LineDirection::diagonal_left_rising, "diagonal left, rising"},
     {LineDirection::x_major_left_rising, "x-major left, rising"},
     {LineDirection::left, "left"},
     {LineDirection::x_major_left_falling, "x-major left, falling"},
     {LineDirection::diagonal_left_falling, "diagonal left, falling"},
     {LineDirection::y_major_left_falling, "y-major left, falling"},
     {LineDirection::down, "down"},
     {LineDirection::y_major_right_falling, "y-major right, falling"},
     {LineDirection::diagonal_right_falling, "diagonal right, falling"},
     {LineDirection::x_major_right_falling, "x-major right, falling"}});

// The segment must not have length 0.
LineDirection direction_of(const Segment& segment);

// A vector in a direction whose longer component is about `length`, both multiples of `step`; raw
// units, at least two steps long.
RawVector random_along(RandomSource& random, LineDirection direction, std::int64_t length,
                       std::int64_t step);

// A place in a pixel relative to the diamond |dx| + |dy| < 1/2 round its centre. Edges exclude
// their ends; an outside place is a quarter of the pixel's square without its border. The first
// eight are the bits of DiamondPart (rules/coverage/tie_rule.h), in order.
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

template <>
inline constexpr auto kNames<DiamondPlace> = std::to_array<Named<DiamondPlace>>(
    {{DiamondPlace::left_corner, "left corner"},
     {DiamondPlace::right_corner, "right corner"},
     {DiamondPlace::bottom_corner, "bottom corner"},
     {DiamondPlace::top_corner, "top corner"},
     {DiamondPlace::lower_left_edge, "lower left edge"},
     {DiamondPlace::lower_right_edge, "lower right edge"},
     {DiamondPlace::upper_left_edge, "upper left edge"},
     {DiamondPlace::upper_right_edge, "upper right edge"},
     {DiamondPlace::inside, "inside"},
     {DiamondPlace::lower_left_outside, "outside, lower left"},
     {DiamondPlace::lower_right_outside, "outside, lower right"},
     {DiamondPlace::upper_left_outside, "outside, upper left"},
     {DiamondPlace::upper_right_outside, "outside, upper right"}});

// The place of a point in a pixel; nothing if it is beyond the pixel's square, or on its border but
// not at a corner of the diamond.
std::optional<DiamondPlace> place_in_pixel(Point point, PixelPosition pixel);

// The point of pixel (0, 0) at a place, by one number: raw, at least 2 and less than 1/2 pixel.
// The point of pixel (0, 0) at a place, given one number: raw units, at least 2 and less than 1/2
// pixel. On an edge it is the horizontal distance from the centre; outside, half the distance from
// either side of the pixel's square; inside, the distance from the centre, halved in x and
// quartered in y. A corner is a single point.
Point point_at(DiamondPlace place, std::int64_t along);

// One of those points, with coordinates that are multiples of `step`: raw, a power of two up to
// 1/16 pixel.
Point random_point_at(DiamondPlace place, RandomSource& random, std::int64_t step);

// Whether some boundary decides if the segment meets the pixel's diamond, or ends in it.
bool is_tied(const Segment& segment, PixelPosition pixel);

}  // namespace edgecase
