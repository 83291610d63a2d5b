// SPDX-License-Identifier: MIT
#include "rules/coverage/line_areas.h"

#include <algorithm>
#include <cstdint>

namespace edgecase {
namespace {

// A cross product is below 2^61, so four times its square is below 2^124; a squared length is below
// 2^62 and the square of a width of 64 pixels is 2^44. All of these fit in 128 bits. What has no
// squares fits in 64.
static_assert(2 * Fixed::kMaxCoordinate * Fixed::kOne <= (std::int64_t{1} << 30));

// True if the sample's distance from the line is at most half the width. `side` is the cross
// product of the segment and the sample, positive to its left, in units of 2^-32.
bool within_half_width(const Segment& s, Fixed width, Point sample, const TieRule& ties) {
  const Int128 dx = s.b.x.raw() - s.a.x.raw();
  const Int128 dy = s.b.y.raw() - s.a.y.raw();
  const Int128 side = cross(s.a, s.b, sample);
  // |side| / |d| < width / 2, squared and without fractions; both in units of 2^-64.
  const Int128 left = 4 * side * side;
  const Int128 right = (dx * dx + dy * dy) * width.raw() * width.raw();
  // The distance is linear on either side of the line: its gradient points away from the line.
  const Int128 away = side > 0 ? 1 : -1;
  if (left != right) return left < right;
  return ties.positive(0, away * dy, -away * dx);
}

// True if the sample is between the two ends, along the segment (rectangle) or its major axis.
bool between_ends(const Segment& s, LineArea area, Point sample, const TieRule& ties) {
  std::int64_t dx = s.b.x.raw() - s.a.x.raw();
  std::int64_t dy = s.b.y.raw() - s.a.y.raw();
  if (area == LineArea::parallelogram) (s.x_major() ? dy : dx) = 0;
  const auto along = [&](Point from) {
    return dx * (sample.x.raw() - from.x.raw()) + dy * (sample.y.raw() - from.y.raw());
  };
  return ties.positive(along(s.a), dx, dy) && ties.positive(-along(s.b), -dx, -dy);
}

// True if the sample is within half the width of the line along the minor axis.
bool within_half_height(const Segment& s, Fixed width, Point sample, const TieRule& ties) {
  const std::int64_t dx = s.b.x.raw() - s.a.x.raw();
  const std::int64_t dy = s.b.y.raw() - s.a.y.raw();
  const std::int64_t side = cross(s.a, s.b, sample);
  // The vertical (horizontal) distance is side / |dx| (side / |dy|).
  const std::int64_t run = s.x_major() ? (dx < 0 ? -dx : dx) : (dy < 0 ? -dy : dy);
  const std::int64_t reach = run * width.raw();
  return ties.positive(reach + 2 * side, -dy, dx) && ties.positive(reach - 2 * side, dy, -dx);
}

// The search range round a line, in pixels: beyond its ends, and to either side of the point where
// a column's (row's) centre meets it.
struct Margins {
  std::int64_t beyond;
  std::int64_t aside;
};

std::vector<PixelPosition> pixels_round(const Segment& segment, const Margins& margins,
                                        const PixelBounds& bounds) {
  const bool x_major = segment.x_major();
  const auto major = [&](Point p) { return x_major ? p.x : p.y; };
  const auto minor = [&](Point p) { return x_major ? p.y : p.x; };
  const auto [first, last] = std::minmax({major(segment.a), major(segment.b)});
  const std::int64_t length = major(segment.b).raw() - major(segment.a).raw();
  const std::int64_t run = length == 0 ? 1 : length;  // without length there is no rise either
  const std::int64_t rise = minor(segment.b).raw() - minor(segment.a).raw();

  std::vector<PixelPosition> pixels;
  const auto take = [&](std::int64_t m, std::int64_t n) {
    const PixelPosition pixel{static_cast<int>(x_major ? m : n), static_cast<int>(x_major ? n : m)};
    if (bounds.contains(pixel)) pixels.push_back(pixel);
  };
  const std::int64_t begin =
      std::max<std::int64_t>(first.floor() - margins.beyond, x_major ? bounds.x_min : bounds.y_min);
  const std::int64_t end =
      std::min<std::int64_t>(last.floor() + margins.beyond, x_major ? bounds.x_max : bounds.y_max);
  for (std::int64_t m = begin; m <= end; ++m) {
    const std::int64_t along = Fixed::centre_of(m).raw() - major(segment.a).raw();
    const std::int64_t at = (minor(segment.a) + Fixed::from_raw(along * rise / run)).floor();
    for (std::int64_t n = at - margins.aside; n <= at + margins.aside; ++n) take(m, n);
  }
  return pixels;
}

}  // namespace

// A column's centre meets the line less than a raw unit away from pixel `at`. So the centre of
// pixel n lies within the width w of it only if n - at is between -w - 1/2 and w + 1/2, plus or
// minus that unit; in whole numbers, from -w to w.
std::vector<PixelPosition> pixels_centred_near_line(const Segment& segment, Fixed width, int beyond,
                                                    const PixelBounds& bounds) {
  const std::int64_t margin = width.ceil();
  return pixels_round(segment, {margin + beyond, margin}, bounds);
}

bool line_area_covers(const Segment& segment, Fixed width, LineArea area, Point sample,
                      const TieRule& ties) {
  if (segment.a == segment.b) return false;
  if (!between_ends(segment, area, sample, ties)) return false;
  return area == LineArea::rectangle ? within_half_width(segment, width, sample, ties)
                                     : within_half_height(segment, width, sample, ties);
}

// Slopes along the major axis are at most 1, so a point within half the width of the line is within
// the width of it along the minor axis.
std::vector<PixelPosition> pixels_near_line(const Segment& segment, Fixed width,
                                            const PixelBounds& bounds) {
  const std::int64_t margin = width.ceil() + 2;
  return pixels_round(segment, {margin, margin}, bounds);
}

std::vector<PixelPosition> line_area_pixels(const Segment& segment, Fixed width, LineArea area,
                                            const PixelBounds& bounds, const TieRule& ties) {
  std::vector<PixelPosition> pixels = pixels_centred_near_line(segment, width, 0, bounds);
  std::erase_if(pixels, [&](PixelPosition pixel) {
    return !line_area_covers(segment, width, area, pixel_centre(pixel.x, pixel.y), ties);
  });
  return pixels;
}

}  // namespace edgecase
