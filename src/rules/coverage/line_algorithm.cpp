// SPDX-License-Identifier: MIT
#include "rules/coverage/line_algorithm.h"

#include <algorithm>
#include <cstdlib>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_areas.h"
#include "rules/coverage/line_walks.h"
#include "rules/coverage/triangle_algorithm.h"

namespace edgecase {
namespace {

// The parallelogram of a wide line as two triangles, moved half a pixel back along the major axis
// and an eighth down (right, if y-major); here 45 degrees counts as y-major.
std::vector<PixelPosition> shifted_triangle_pixels(const Segment& segment, Fixed width,
                                                   const PixelBounds& bounds) {
  const auto length = [](Fixed a, Fixed b) { return std::abs(b.raw() - a.raw()); };
  const bool x_major = length(segment.a.x, segment.b.x) > length(segment.a.y, segment.b.y);
  const bool forward = x_major ? segment.a.x < segment.b.x : segment.a.y < segment.b.y;
  const std::int64_t half_pixel = Fixed::kOne / 2;
  const Fixed back = Fixed::from_raw(forward ? -half_pixel : half_pixel);
  const Fixed aside = Fixed::from_raw(x_major ? -Fixed::kOne / 8 : Fixed::kOne / 8);
  const auto corner = [&](Point p, int side) {
    const Fixed across = aside + Fixed::from_raw(side * width.raw() / 2);
    return x_major ? Point{p.x + back, p.y + across} : Point{p.x + across, p.y + back};
  };
  const Point start[] = {corner(segment.a, -1), corner(segment.a, 1)};
  const Point end[] = {corner(segment.b, -1), corner(segment.b, 1)};
  auto pixels = scanned_triangle_pixels({start[0], end[0], end[1]}, bounds);
  const auto others = scanned_triangle_pixels({start[0], end[1], start[1]}, bounds);
  pixels.insert(pixels.end(), others.begin(), others.end());
  return pixels;
}

std::vector<PixelPosition> thin_pixels(const Segment& segment, const PixelBounds& bounds,
                                       const LineChoice& choice, const TieRule& ties) {
  const DiamondBoundary& boundary = *choice.boundary;
  const Fixed one = Fixed::from_integer(1);
  switch (choice.algorithm) {
    case LineAlgorithm::diamond_exit:
      return diamond_exit_pixels(segment, bounds, boundary);
    case LineAlgorithm::walk_floor_to_floor:
      return walk_pixels(segment, bounds, WalkRange::floor_to_floor, boundary);
    case LineAlgorithm::walk_ends_tested:
      return walk_pixels(segment, bounds, WalkRange::ends_tested, boundary);
    case LineAlgorithm::walk_half_open_direction:
      return walk_pixels(segment, bounds, WalkRange::half_open_direction, boundary);
    case LineAlgorithm::walk_half_open_geometry:
      return walk_pixels(segment, bounds, WalkRange::half_open_geometry, boundary);
    case LineAlgorithm::bresenham:
      return bresenham_pixels(segment, bounds, ToInteger::floor);
    case LineAlgorithm::bresenham_toward_zero:
      return bresenham_pixels(segment, bounds, ToInteger::toward_zero);
    case LineAlgorithm::midpoint:
      return midpoint_pixels(segment, bounds);
    case LineAlgorithm::rectangle:
      return line_area_pixels(segment, one, LineArea::rectangle, bounds, ties);
    case LineAlgorithm::parallelogram:
      return line_area_pixels(segment, one, LineArea::parallelogram, bounds, ties);
    case LineAlgorithm::parallelogram_ends_tested:
      return tested_ends_pixels(segment, 1, bounds, ties);
  }
  return {};
}

}  // namespace

bool tests_diamonds(LineAlgorithm algorithm) {
  return algorithm == LineAlgorithm::diamond_exit || algorithm == LineAlgorithm::walk_ends_tested;
}

int rounded_width(Fixed width) {
  return static_cast<int>(
      std::max<std::int64_t>(1, (width + Fixed::from_raw(Fixed::kOne / 2)).floor()));
}

Segment lowest_segment(const Segment& segment, int width) {
  return lowest_segment(segment, width, segment.x_major());
}

Segment lowest_segment(const Segment& segment, int width, bool x_major) {
  const Fixed down = Fixed::from_raw((width - 1) * Fixed::kOne / 2);
  if (x_major) return {{segment.a.x, segment.a.y - down}, {segment.b.x, segment.b.y - down}};
  return {{segment.a.x - down, segment.a.y}, {segment.b.x - down, segment.b.y}};
}

std::vector<PixelPosition> replicated(std::span<const PixelPosition> lowest, bool x_major,
                                      int width, const PixelBounds& bounds) {
  std::vector<PixelPosition> pixels;
  for (PixelPosition base : lowest)
    for (int i = 0; i < width; ++i) {
      const PixelPosition pixel =
          x_major ? PixelPosition{base.x, base.y + i} : PixelPosition{base.x + i, base.y};
      if (bounds.contains(pixel)) pixels.push_back(pixel);
    }
  std::sort(pixels.begin(), pixels.end());
  pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
  return pixels;
}

std::vector<PixelPosition> line_pixels(const Segment& segment, Fixed width,
                                       const PixelBounds& bounds, const LineChoice& choice,
                                       const TieRule& ties) {
  if (width == Fixed::from_integer(1)) return thin_pixels(segment, bounds, choice, ties);
  const int rounded = rounded_width(width);
  switch (choice.wide) {
    case WideLine::replicate:
      return replicated(
          thin_pixels(lowest_segment(segment, rounded), bounds.grown(rounded), choice, ties),
          segment.x_major(), rounded, bounds);
    case WideLine::rectangle:
      return line_area_pixels(segment, width, LineArea::rectangle, bounds, ties);
    case WideLine::parallelogram:
      return line_area_pixels(segment, width, LineArea::parallelogram, bounds, ties);
    case WideLine::parallelogram_ends_tested:
      return tested_ends_pixels(segment, rounded, bounds, ties);
    case WideLine::shifted_triangles:
      return shifted_triangle_pixels(segment, width, bounds);
  }
  return {};
}

bool fills_area(const LineChoice& choice, Fixed width) {
  const bool is_replicated = width == Fixed::from_integer(1) || choice.wide == WideLine::replicate;
  if (!is_replicated) return choice.wide != WideLine::shifted_triangles;
  return choice.algorithm == LineAlgorithm::rectangle ||
         choice.algorithm == LineAlgorithm::parallelogram ||
         choice.algorithm == LineAlgorithm::parallelogram_ends_tested;
}

Rule line_algorithm_rule() {
  Rule rule;
  rule.id = RuleId::line_algorithm;
  rule.title = "A line of width 1 is drawn by the diamond-exit rule or by an algorithm close to it";
  rule.spec = "14.5.1 (basic line segment rasterization)";
  rule.latitude =
      "any algorithm that obeys rulings 1 and 2; the diamond-exit rule takes vertices divided by w "
      "as they are; other algorithms round those that are not snapped to the nearest multiple of "
      "2^-16";
  rule.standard = "diamond-exit";
  rule.alternatives = alternatives_of<LineAlgorithm>();
  return rule;
}

Rule line_width_rule() {
  Rule rule;
  rule.id = RuleId::line_width;
  rule.title =
      "A wide line is a line of width 1 whose fragments are replicated along the minor axis";
  rule.spec = "14.5.2 (other line segment features)";
  rule.latitude = "as for lines of width 1, for the lowest fragment of each column";
  rule.standard = "replicate";
  rule.alternatives = alternatives_of<WideLine>();
  rule.rulings = {
      {12,
       "Wide lines: each column (row, if y-major) holds one run of as many fragments as the "
       "width rounded to the nearest integer, a half to either, and the lowest fragments of the "
       "runs satisfy rulings 1 and 2 for the segment moved by -(w - 1)/2 along the minor axis. A "
       "run that the target's border cuts is assumed to continue beyond it."},
      {56,
       "A wide line is as wide as the nearest integer to its width, and not as the next smaller "
       "one."}};
  return rule;
}

}  // namespace edgecase
