// SPDX-License-Identifier: MIT
#include "rules/coverage/loose_segment.h"

#include <cstdint>
#include <cstdlib>

#include "rules/coverage/diamond_exit.h"

namespace edgecase {
namespace {

const TieRule& ties_named(const char* name) {
  return *find_tie_rule(name);
}

// The diamonds for possible and for certain fragments.
struct GrownAndShrunk {
  SizedDiamond grown;
  SizedDiamond shrunk;
};

GrownAndShrunk diamonds(PixelPosition pixel, Fixed reach) {
  static const TieRule& open = ties_named("open");
  static const TieRule& closed = ties_named("closed");
  const Fixed half = Fixed::from_raw(Fixed::kOne / 2);
  return {{pixel, half + reach + reach, closed}, {pixel, half - reach - reach, open}};
}

template <class IsCovered>
std::vector<PixelPosition> pixels_where(const LooseSegment& loose, const PixelBounds& bounds,
                                        IsCovered is_covered) {
  if (loose.reach == Fixed())
    return diamond_exit_pixels(loose.segment, bounds, *find_diamond_boundary("left-bottom"));
  std::vector<PixelPosition> pixels;
  visit_pixels_near(loose.segment, bounds, [&](PixelPosition p) {
    if (is_covered(diamonds(p, loose.reach))) pixels.push_back(p);
  });
  return pixels;
}

// How much longer the segment is in x than in y, raw.
std::int64_t excess_in_x(const Segment& s) {
  return std::abs(s.b.x.raw() - s.a.x.raw()) - std::abs(s.b.y.raw() - s.a.y.raw());
}

}  // namespace

// Either length changes by two reaches at most.
bool surely_x_major(const LooseSegment& loose) {
  return excess_in_x(loose.segment) >= 4 * loose.reach.raw();
}

bool surely_y_major(const LooseSegment& loose) {
  return -excess_in_x(loose.segment) > 4 * loose.reach.raw();
}

std::vector<PixelPosition> possible_pixels(const LooseSegment& loose, const PixelBounds& bounds) {
  return pixels_where(loose, bounds, [&](const GrownAndShrunk& diamonds) {
    return meets(loose.segment, diamonds.grown) && !ends_in(loose.segment, diamonds.shrunk);
  });
}

std::vector<PixelPosition> certain_pixels(const LooseSegment& loose, const PixelBounds& bounds) {
  return pixels_where(loose, bounds, [&](const GrownAndShrunk& diamonds) {
    return meets(loose.segment, diamonds.shrunk) && !ends_in(loose.segment, diamonds.grown);
  });
}

bool may_meet_diamond(const LooseSegment& loose, PixelPosition pixel) {
  return meets(loose.segment, diamonds(pixel, loose.reach).grown);
}

}  // namespace edgecase
