// SPDX-License-Identifier: MIT
//
// Algorithms that draw lines, and how each draws a wide line.
//
// The diamond-exit rule is OpenGL's ideal. Its relaxed rules admit other algorithms. Direct3D,
// Vulkan, hardware and textbooks have theirs. This header lists the known ones and evaluates each
// by one function.
//
// A line wider than 1 starts as the line of width 1, moved down (left, if y-major) by (w - 1)/2.
// Each fragment is then replaced by a column (row) of w fragments (GL 4.6 core, 14.5.2). Here w is
// the width rounded to an integer. An area has the line's width itself; of the areas only
// `parallelogram-ends-tested` rounds it.
#pragma once

#include <span>
#include <vector>

#include "exact/fixed.h"
#include "rules/coverage/segment.h"
#include "rules/coverage/tie_rule.h"
#include "rules/rule.h"

namespace edgecase {

enum class LineAlgorithm {
  diamond_exit,
  walk_floor_to_floor,
  walk_ends_tested,
  walk_half_open_direction,
  walk_half_open_geometry,
  bresenham,
  bresenham_toward_zero,
  midpoint,
  rectangle,
  parallelogram,
  parallelogram_ends_tested,
};
template <>
inline constexpr auto kNames<LineAlgorithm> = std::to_array<TabledAlternative<LineAlgorithm>>({
    {LineAlgorithm::diamond_exit, "diamond-exit", Openness::open,
     "the fragments whose diamonds the segment exits"},
    {LineAlgorithm::walk_floor_to_floor, "walk-floor-to-floor", Openness::open,
     "a pixel in each column from the start's to the end's, both included"},
    {LineAlgorithm::walk_ends_tested, "walk-ends-tested", Openness::open,
     "a pixel in each column from the start's to the end's; the first and the last must pass the "
     "diamond-exit test"},
    {LineAlgorithm::walk_half_open_direction, "walk-half-open-direction", Openness::open,
     "a pixel in each column whose centre lies from the start, included, to the end, excluded"},
    {LineAlgorithm::walk_half_open_geometry, "walk-half-open-geometry", Openness::open,
     "a pixel in each column whose centre lies from the lower end, included, to the other, "
     "excluded"},
    {LineAlgorithm::bresenham, "bresenham", Openness::open,
     "Bresenham's algorithm between the pixels of the ends, without the last one"},
    {LineAlgorithm::bresenham_toward_zero, "bresenham-toward-zero", Openness::open,
     "the same, with coordinates truncated toward zero: negative ones move right or up"},
    {LineAlgorithm::midpoint, "midpoint", Openness::open,
     "the midpoint algorithm between the pixels of the ends, both drawn"},
    {LineAlgorithm::rectangle, "rectangle", Openness::open,
     "the centres in a rectangle of width 1 along the segment, as in Vulkan's strict lines"},
    {LineAlgorithm::parallelogram, "parallelogram", Openness::open,
     "the centres in a parallelogram whose ends run along the minor axis"},
    {LineAlgorithm::parallelogram_ends_tested, "parallelogram-ends-tested", Openness::open,
     "the same, with corners on a grid of 1/256 pixel; a diamond-exit test may move an end to the "
     "border of its pixel"},
});

// How a line of a width other than 1 is drawn.
enum class WideLine {
  replicate,
  rectangle,
  parallelogram,
  parallelogram_ends_tested,
  // Two triangles, half a pixel back along the major axis and 1/8 pixel down (right, if y-major),
  // scan-converted, as Mesa draws wide lines for drivers without their own.
  shifted_triangles,
};
template <>
inline constexpr auto kNames<WideLine> = std::to_array<TabledAlternative<WideLine>>(
    {{WideLine::replicate, "replicate", Openness::mandated,
      "columns (rows, if y-major) as high as the width rounded to an integer"},
     {WideLine::rectangle, "rectangle", Openness::illegal,
      "the centres in a rectangle as wide as the line; OpenGL has it under multisampling only"},
     {WideLine::parallelogram, "parallelogram", Openness::illegal,
      "the centres in a parallelogram whose ends run along the minor axis"},
     {WideLine::parallelogram_ends_tested, "parallelogram-ends-tested", Openness::illegal,
      "the same of the rounded width, with corners on a grid of 1/256 pixel; a diamond-exit test "
      "of the segment's end may move an end to the border of its pixel"},
     {WideLine::shifted_triangles, "shifted-triangles", Openness::illegal,
      "the parallelogram as two triangles, scan-converted; they are moved half a pixel back along "
      "the major axis and 1/8 pixel down (right, if y-major)"}});

struct LineChoice {
  LineAlgorithm algorithm = LineAlgorithm::diamond_exit;
  const DiamondBoundary* boundary = nullptr;  // never null in a resolved choice
  WideLine wide = WideLine::replicate;
  friend bool operator==(const LineChoice&, const LineChoice&) = default;
};

// True if a line of that width is an area with borders that belong to one side or the other. Then
// ties decide as for polygons.
bool fills_area(const LineChoice& choice, Fixed width);

Rule line_algorithm_rule();
Rule line_width_rule();
inline constexpr int kRulingOnSmallerWidth = 56;  // the next smaller integer

// The width of columns: rounded to the nearest integer, at least 1.
int rounded_width(Fixed width);

// The segment of width 1 whose fragments are the lowest of a wide line's columns.
Segment lowest_segment(const Segment& segment, int width);
// The same for a segment that is read as x-major, or as y-major.
Segment lowest_segment(const Segment& segment, int width, bool x_major);

// Columns (rows, if not x-major) of `width` pixels within `bounds` above the lowest ones, each
// pixel once. Some algorithms put two pixels into one column, so their columns overlap.
std::vector<PixelPosition> replicated(std::span<const PixelPosition> lowest, bool x_major,
                                      int width, const PixelBounds& bounds);

// The pixels within `bounds` that a line covers, each once, in no particular order. `ties` decides
// samples on the boundary of rectangles and parallelograms.
std::vector<PixelPosition> line_pixels(const Segment& segment, Fixed width,
                                       const PixelBounds& bounds, const LineChoice& choice,
                                       const TieRule& ties);

}  // namespace edgecase
