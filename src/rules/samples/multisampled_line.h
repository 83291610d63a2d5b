// SPDX-License-Identifier: MIT
//
// Multisampled lines (GL 4.6 core, 14.5.4).
//
// Under multisampling a line is an area and not a row of pixels. The area is the rectangle of
// 14.5.3, centred on the segment, as long as the segment and as wide as the line. GL_LINE_SMOOTH
// makes no difference. The line covers each sample inside the rectangle. The diamond-exit rule does
// not apply, even to a line of width 1. The width is not rounded. Implementations round the
// rectangle's corners.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "exact/fixed.h"
#include "exact/homogeneous.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

Rule multisampled_line_rule();  // line.multisampled

enum class MultisampledLine {
  rectangle,
  // Rounded, and affected by no other snap: RectangleRounding::offset and corners.
  snapped_offset,
  snapped_offset_across_borders,  // the same, but lost between borders of pixels: crosses_borders
  snapped_corners,
  parallelogram,   // its ends run along the minor axis
  single_sampled,  // as without multisampling, with all samples of each pixel
};
template <>
inline constexpr auto kNames<MultisampledLine> = std::to_array<TabledAlternative<MultisampledLine>>(
    {{MultisampledLine::rectangle, "rectangle", Openness::open,
      "the samples in a rectangle as long as the segment and as wide as the line"},
     {MultisampledLine::snapped_offset, "snapped-offset", Openness::open,
      "the samples in that rectangle, with the segment's ends and the offset from them to the "
      "corners each rounded to 1/256 pixel"},
     {MultisampledLine::snapped_offset_across_borders, "snapped-offset-across-borders",
      Openness::illegal,
      "the same, but a line draws nothing unless a left and a lower border of pixels of the target "
      "run through its rectangle's extent"},
     {MultisampledLine::snapped_corners, "snapped-corners", Openness::open,
      "the samples in that rectangle, with its corners rounded to 1/16 pixel"},
     {MultisampledLine::parallelogram, "parallelogram", Openness::illegal,
      "the samples in a parallelogram whose ends run along the minor axis"},
     {MultisampledLine::single_sampled, "single-sampled", Openness::illegal,
      "all samples of the pixels that are drawn without multisampling"}});

// True if the rectangle of a line of some width (pixels, more than 0, at most 64) contains the
// sample (in the window). A segment without length has no rectangle.
bool multisampled_line_covers(const HomogeneousSegment& segment, Fixed width, Point sample,
                              const TieRule& ties);

// The pixels within `bounds` whose sample, at position `within`, lies in the rectangle; each once,
// in no particular order.
std::vector<PixelPosition> multisampled_line_pixels(const HomogeneousSegment& segment, Fixed width,
                                                    const PixelBounds& bounds, Point within,
                                                    const TieRule& ties);

// Whether the specification's latitude permits the sample to be covered, and to be uncovered. Each
// end may move by less than `reach` in x and in y, and the boundary is open. The result of a
// possible move is always permitted; for each side of the rectangle, the results of all moves are
// permitted, as though the sides moved independently. reach: 0 to a pixel.
bool multisampled_line_possibly_covered(const Segment& segment, Fixed width, Point sample,
                                        Fixed reach);
bool multisampled_line_possibly_uncovered(const Segment& segment, Fixed width, Point sample,
                                          Fixed reach);

// ---------------------------------------------------------------- the rectangle, rounded to a grid
//
// The rectangle of a multisampled line, rounded to a sub-pixel grid.
//
// Its corners are irrational, a +- n and b +- n with n = (width / 2) (-dy, dx) / |b - a|, and
// implementations fill polygons whose corners lie on a grid. So they round either the corners or
// the ends and n separately. The covered area is then the polygon of the rounded corners.

enum class RectangleRounding {
  offset,   // ends and n to 1/256 pixel, a tie away from 0
  corners,  // corners to 1/16 pixel, a tie to the even grid line
};

// The nearest multiple for a number halfway between two.
enum class HalfwayTo { even, away_from_zero };

// The multiple of 2^-bits nearest to whole + above / sqrt(below), all in units of 2^-16.
// Magnitudes: whole up to 2^30, above up to 2^53, sqrt(below) up to 2^32, their quotient up to
// 2^22.
Fixed nearest_with_root(std::int64_t whole, std::int64_t above, std::uint64_t below, int bits,
                        HalfwayTo halfway);

// The rounded corners, counter-clockwise. The segment must have a length; width: more than 0, at
// most 64 pixels.
std::array<Point, 4> rounded_corners(const Segment& segment, Fixed width,
                                     RectangleRounding rounding);

// True if the polygon contains the sample: it lies to the left of all sides. A polygon turned over
// by rounding contains nothing.
bool rounded_rectangle_covers(const std::array<Point, 4>& corners, Point sample,
                              const TieRule& ties);

// True if the left border of some column within `bounds` runs through the polygon's extent in x,
// and the lower border of some row through its extent in y. A border on the lesser side of the
// extent counts, one on the greater side does not. llvmpipe draws no other lines: its box of pixels
// begins with the first column whose left border lies inside, and is empty if there is none.
bool crosses_borders(const std::array<Point, 4>& corners, const PixelBounds& bounds);

// The pixels within `bounds` whose sample, at position `within`, lies in the polygon of a line;
// each once, in no particular order.
std::vector<PixelPosition> rounded_rectangle_pixels(const Segment& segment, Fixed width,
                                                    RectangleRounding rounding,
                                                    const PixelBounds& bounds, Point within,
                                                    const TieRule& ties);

}  // namespace edgecase
