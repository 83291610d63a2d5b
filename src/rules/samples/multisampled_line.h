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
#include <vector>

#include "exact/fixed.h"
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

}  // namespace edgecase
