// SPDX-License-Identifier: MIT
#include "rules/coverage/line_algorithm.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "exact/fixed.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_areas.h"
#include "rules/coverage/scan_conversion.h"
#include "rules/coverage/tested_ends.h"

namespace edgecase {
namespace {

// Lines as walks along the major axis: one pixel per column (per row, if y-major).
//
// All walks follow the line along its major axis. In each column they draw the pixel that contains
// the line at the column's centre; integer algorithms draw the pixel nearest to a line between
// integer ends. They differ in the columns that take part, and in the ends. None of them is the
// diamond-exit rule; all of them are in use.

// The columns that take part.
enum class WalkRange {
  floor_to_floor,       // from the start's column to the end's, both included
  ends_tested,          // the same, but the first and last pixel must pass the diamond-exit test
  half_open_direction,  // centres from the start, included, to the end, excluded
  half_open_geometry,   // centres from the left (lower) end, included, to the other, excluded
};

// How integer algorithms round coordinates to pixels.
enum class ToInteger { floor, toward_zero };

Int128 floor_divide(Int128 value, Int128 by) {
  const Int128 quotient = value / by;
  return quotient * by > value ? quotient - 1 : quotient;  // by > 0
}

// A segment turned so that its major axis is the first one.
struct Turned {
  bool x_major;
  Fixed a_major, a_minor, b_major, b_minor;

  explicit Turned(const Segment& s)
      : x_major(s.x_major()),
        a_major(x_major ? s.a.x : s.a.y),
        a_minor(x_major ? s.a.y : s.a.x),
        b_major(x_major ? s.b.x : s.b.y),
        b_minor(x_major ? s.b.y : s.b.x) {}

  PixelPosition pixel(std::int64_t major, std::int64_t minor) const {
    return {static_cast<int>(x_major ? major : minor), static_cast<int>(x_major ? minor : major)};
  }

  // The row that contains the line at the centre of a column; a pixel owns its lower border.
  std::int64_t row_at(std::int64_t column) const {
    Int128 run = b_major.raw() - a_major.raw();
    if (run == 0) return a_minor.floor();
    Int128 rise = b_minor.raw() - a_minor.raw();
    if (run < 0) {
      run = -run;
      rise = -rise;
    }
    const Int128 along = Fixed::centre_of(column).raw() - a_major.raw();
    const Int128 minor = a_minor.raw() * run + along * rise;  // times run
    return static_cast<std::int64_t>(floor_divide(minor, run * Fixed::kOne));
  }
};

// The first column whose centre is not below a coordinate.
std::int64_t first_centre_from(Fixed coordinate) {
  return Fixed::from_raw(coordinate.raw() - Fixed::kOne / 2).ceil();
}

// The last column whose centre is not above a coordinate.
std::int64_t last_centre_to(Fixed coordinate) {
  return Fixed::from_raw(coordinate.raw() - Fixed::kOne / 2).floor();
}

std::pair<std::int64_t, std::int64_t> columns_of(const Turned& t, WalkRange range) {
  const auto [low, high] = std::minmax({t.a_major, t.b_major});
  const Fixed ulp = Fixed::from_raw(1);
  switch (range) {
    case WalkRange::floor_to_floor:
    case WalkRange::ends_tested:
      return {low.floor(), high.floor()};
    case WalkRange::half_open_geometry:
      return {first_centre_from(low), last_centre_to(high - ulp)};
    case WalkRange::half_open_direction:
      if (t.a_major <= t.b_major)
        return {first_centre_from(t.a_major), last_centre_to(t.b_major - ulp)};
      return {first_centre_from(t.b_major + ulp), last_centre_to(t.a_major)};
  }
  return {0, -1};
}

std::int64_t to_integer(Fixed value, ToInteger rounding) {
  if (rounding == ToInteger::floor) return value.floor();
  return value.raw() / Fixed::kOne;
}

void keep(PixelPosition pixel, const PixelBounds& bounds, std::vector<PixelPosition>& pixels) {
  if (bounds.contains(pixel)) pixels.push_back(pixel);
}

// The pixels within `bounds`, ascending along the major axis. A segment without length draws one
// pixel or none, depending on its range. `boundary` is only for ends_tested.
std::vector<PixelPosition> walk_pixels(const Segment& segment, const PixelBounds& bounds,
                                       WalkRange range, const DiamondBoundary& boundary) {
  const Turned t(segment);
  const auto [first, last] = columns_of(t, range);
  const std::int64_t low = t.x_major ? bounds.x_min : bounds.y_min;
  const std::int64_t high = t.x_major ? bounds.x_max : bounds.y_max;
  std::vector<PixelPosition> pixels;
  for (std::int64_t column = std::max(first, low); column <= std::min(last, high); ++column) {
    const PixelPosition pixel = t.pixel(column, t.row_at(column));
    const bool tested = range == WalkRange::ends_tested && (column == first || column == last);
    if (tested && !diamond_exit_covers(segment, pixel.x, pixel.y, boundary)) continue;
    keep(pixel, bounds, pixels);
  }
  return pixels;
}

// Bresenham's algorithm between the ends' pixels, from the start, without the end's pixel; if the
// line passes midway between two pixels, the step is taken. Equal distances count as y-major.
std::vector<PixelPosition> bresenham_pixels(const Segment& segment, const PixelBounds& bounds,
                                            ToInteger rounding) {
  std::int64_t x = to_integer(segment.a.x, rounding);
  std::int64_t y = to_integer(segment.a.y, rounding);
  const std::int64_t dx = to_integer(segment.b.x, rounding) - x;
  const std::int64_t dy = to_integer(segment.b.y, rounding) - y;
  const bool x_major = std::abs(dx) > std::abs(dy);
  const std::int64_t major = x_major ? std::abs(dx) : std::abs(dy);
  const std::int64_t minor = x_major ? std::abs(dy) : std::abs(dx);
  const std::int64_t x_step = dx < 0 ? -1 : 1;
  const std::int64_t y_step = dy < 0 ? -1 : 1;

  std::vector<PixelPosition> pixels;
  std::int64_t error = 2 * minor - major;
  for (std::int64_t i = 0; i < major; ++i) {
    keep({static_cast<int>(x), static_cast<int>(y)}, bounds, pixels);
    (x_major ? x : y) += x_major ? x_step : y_step;
    if (error >= 0) {
      (x_major ? y : x) += x_major ? y_step : x_step;
      error -= 2 * major;
    }
    error += 2 * minor;
  }
  return pixels;
}

// The midpoint algorithm between the ends' pixels, from left to right (bottom to top, if y-major),
// with both ends drawn; if the line passes midway between two pixels, no step is taken.
std::vector<PixelPosition> midpoint_pixels(const Segment& segment, const PixelBounds& bounds) {
  const auto centre = [](Point p) { return pixel_centre(p.x.floor(), p.y.floor()); };
  Segment whole{centre(segment.a), centre(segment.b)};
  if (Turned(whole).a_major > Turned(whole).b_major) std::swap(whole.a, whole.b);
  const Turned t(whole);
  const std::int64_t run = (t.b_major.raw() - t.a_major.raw()) / Fixed::kOne;
  const std::int64_t rise = std::abs(t.b_minor.raw() - t.a_minor.raw()) / Fixed::kOne;
  const std::int64_t step = t.b_minor < t.a_minor ? -1 : 1;

  std::vector<PixelPosition> pixels;
  std::int64_t minor = t.a_minor.floor();
  std::int64_t decision = 2 * rise - run;  // for the line at the first midpoint, half a step on
  for (std::int64_t i = 0; i <= run; ++i) {
    keep(t.pixel(t.a_major.floor() + i, minor), bounds, pixels);
    if (decision > 0) {
      minor += step;
      decision -= 2 * run;
    }
    decision += 2 * rise;
  }
  return pixels;
}

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
       "Wide lines: each column (row, if y-major) holds one run of as many fragments as the width "
       "rounded to the nearest integer, a half to either. The lowest fragments of the runs satisfy "
       "rulings 1 and 2 for the segment moved by -(w - 1)/2 along the minor axis; if that segment "
       "has no diamond-exit fragments, the one run starts at a pixel whose closed diamond it "
       "meets. A run that the target's border cuts is assumed to continue beyond it."},
      {kRulingOnSmallerWidth,
       "Contested: a wide line is as wide as the next integer below its width, where the nearest "
       "integer is the one above. 14.5.2.2 rounds the width to the nearest integer, and so does "
       "OpenGL ES 3.2 (13.6.2.1). But the Khronos tests "
       "(dEQP-GLES3.functional.rasterization.primitives.lines_wide) accept the next smaller width, "
       "too, where the width asked for has a fraction."}};
  return rule;
}

}  // namespace edgecase
