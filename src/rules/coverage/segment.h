// SPDX-License-Identifier: MIT
//
// A line segment from a to b: its major axis, and the pixels near it.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "exact/fixed.h"

namespace edgecase {

struct Segment {
  Point a;
  Point b;

  // Slope in [-1, 1]: 45 degrees counts as x-major, and so does a segment without length.
  bool x_major() const {
    return std::abs(b.x.raw() - a.x.raw()) >= std::abs(b.y.raw() - a.y.raw());
  }
};

// The pixels that a segment can pass: the search range for its fragments.
//
// Calls visit(pixel) for a superset of the pixels within `bounds` whose centre lies within |dx| +
// |dy| < 5/4 of the segment, ascending along the major axis.
//
// Such a centre lies less than 5/4 beyond the ends, so its column begins less than 7/4 before the
// first and less than 3/4 after the last. From the nearest point of the segment to the point where
// the column's centre meets the segment (clamped to its ends), the line moves sideways no more than
// along, since slopes are at most 1: there, too, it is less than 5/4 away.
template <class Visit>
void visit_pixels_near(const Segment& segment, const PixelBounds& bounds, Visit visit) {
  const bool x_major = segment.x_major();
  const auto major = [&](Point p) { return x_major ? p.x : p.y; };
  const auto minor = [&](Point p) { return x_major ? p.y : p.x; };
  const auto [first, last] = std::minmax({major(segment.a), major(segment.b)});
  const std::int64_t run = major(segment.b).raw() - major(segment.a).raw();
  const std::int64_t rise = minor(segment.b).raw() - minor(segment.a).raw();

  const int minor_low = x_major ? bounds.y_min : bounds.x_min;
  const int minor_high = x_major ? bounds.y_max : bounds.x_max;
  const auto begin =
      std::max<std::int64_t>(first.floor() - 1, x_major ? bounds.x_min : bounds.y_min);
  const auto end = std::min<std::int64_t>(last.floor() + 1, x_major ? bounds.x_max : bounds.y_max);
  for (std::int64_t m = begin; m <= end; ++m) {
    // Minor coordinate at the column's centre, clamped to the segment; off by less than a raw unit.
    const Fixed centre = std::clamp(Fixed::centre_of(m), first, last);
    const std::int64_t along = (centre.raw() - major(segment.a).raw()) * rise;
    const Fixed at = run == 0 ? minor(segment.a) : minor(segment.a) + Fixed::from_raw(along / run);
    const auto low = std::max<std::int64_t>(at.floor() - 2, minor_low);
    const auto high = std::min<std::int64_t>(at.floor() + 2, minor_high);
    for (std::int64_t n = low; n <= high; ++n)
      visit(PixelPosition{static_cast<int>(x_major ? m : n), static_cast<int>(x_major ? n : m)});
  }
}

}  // namespace edgecase
