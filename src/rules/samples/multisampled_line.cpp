// SPDX-License-Identifier: MIT
#include "rules/samples/multisampled_line.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "exact/homogeneous.h"
#include "exact/rational.h"
#include "model/sampling.h"
#include "rules/coverage/line_areas.h"

namespace edgecase {
namespace {

int sign_of(const Integer& value) {
  return value.sign();
}

// b - a, times both w: at most 2^79.
struct Direction {
  Int128 x;
  Int128 y;
};

Direction direction(const HomogeneousSegment& s) {
  return {Int128{s.b.x} * s.a.w - Int128{s.a.x} * s.b.w,
          Int128{s.b.y} * s.a.w - Int128{s.a.y} * s.b.w};
}

// The sample's distance from an end along the segment, times the squares of both w.
Integer along(const HomogeneousPoint& end, const Direction& d, Point sample) {
  const Int128 x = Int128{sample.x.raw()} * end.w - Int128{end.x} * Fixed::kOne;
  const Int128 y = Int128{sample.y.raw()} * end.w - Int128{end.y} * Fixed::kOne;
  return integer_of(x) * integer_of(d.x) + integer_of(y) * integer_of(d.y);
}

bool within_half_width(const HomogeneousSegment& s, const Direction& d, Fixed width, Point sample,
                       const TieRule& ties) {
  const Int128 side = cross(s.a, s.b, homogeneous(sample));
  // Compares 2 |side| with the width times the length, both times 2^16 and both w, squared.
  const Integer distance = integer_of(side) * 2;
  const Integer x = integer_of(d.x);
  const Integer y = integer_of(d.y);
  const Integer reach = (x * x + y * y) * width.raw() * width.raw();
  const int order = sign_of(reach - distance * distance);
  // The distance grows away from the line.
  const Int128 away = side > 0 ? 1 : -1;
  return ties.positive(order, away * d.y, -away * d.x);
}

// With coordinates of 2^13 pixels and a reach of one, differences stay below 2^30 + 2^18 raw units,
// and sums of two of their products below 2^62.

// Bounds on the way along the segment from one end to a sample, (p - a).(b - a), as the ends move:
// found one axis at a time, from the products of the possible differences.
struct WayAlong {
  Int128 least = 0;
  Int128 most = 0;

  void add_axis(Fixed way, Fixed run, std::int64_t reach) {
    [[maybe_unused]] constexpr std::int64_t kMost =
        (std::int64_t{1} << 30) + (std::int64_t{1} << 18);
    assert(std::abs(way.raw()) + reach < kMost && std::abs(run.raw()) + 2 * reach < kMost);
    const Int128 low = way.raw() - reach, high = way.raw() + reach;
    const Int128 slow = run.raw() - 2 * reach, fast = run.raw() + 2 * reach;
    const auto [least_product, most_product] =
        std::minmax({low * slow, low * fast, high * slow, high * fast});
    least += least_product;
    most += most_product;
  }
};

WayAlong way_along(Point from, Point to, Point sample, std::int64_t reach) {
  WayAlong way;
  way.add_axis(sample.x - from.x, to.x - from.x, reach);
  way.add_axis(sample.y - from.y, to.y - from.y, reach);
  return way;
}

// A segment whose ends have moved by the whole reach in x and in y.
struct MovedSegment {
  Int128 side;     // of the sample from it, times its length
  Int128 squared;  // its length
  Int128 along;    // its projection onto the given segment, times the length of that one
};

std::array<MovedSegment, 16> moved_segments(const Segment& s, Point p, std::int64_t reach) {
  const Int128 dx = s.b.x.raw() - s.a.x.raw();
  const Int128 dy = s.b.y.raw() - s.a.y.raw();
  std::array<MovedSegment, 16> moved{};
  for (std::size_t corner = 0; corner < moved.size(); ++corner) {
    const auto move = [&](int bit) { return (corner >> bit & 1) != 0 ? reach : -reach; };
    const Int128 ax = s.a.x.raw() + move(0), ay = s.a.y.raw() + move(1);
    const Int128 run_x = s.b.x.raw() + move(2) - ax, run_y = s.b.y.raw() + move(3) - ay;
    moved[corner] = {run_x * (p.y.raw() - ay) - run_y * (p.x.raw() - ax),
                     run_x * run_x + run_y * run_y, run_x * dx + run_y * dy};
  }
  return moved;
}

// The square of a product with the length of a segment.
Integer squared_product(Int128 value, Int128 squared_length) {
  const Integer factor = integer_of(value);
  return factor * factor * integer_of(squared_length);
}

Int128 squared_length(const Segment& s) {
  const Int128 dx = s.b.x.raw() - s.a.x.raw();
  const Int128 dy = s.b.y.raw() - s.a.y.raw();
  return dx * dx + dy * dy;
}

// True if moves can bring the line to within half the width of the sample. For a segment d that
// moves to d', |d'| is at most (|d'|^2 + |d|^2) / (2 |d|), and hardly less. That bound less the
// distance is convex in each coordinate of each end, so it is largest if all move by the whole
// reach.
bool may_lie_within(const Segment& s, Fixed width, Point sample, std::int64_t reach) {
  const auto moved = moved_segments(s, sample, reach);
  const auto [low, high] = std::minmax_element(
      moved.begin(), moved.end(),
      [](const MovedSegment& a, const MovedSegment& b) { return a.side < b.side; });
  if (low->side <= 0 && high->side >= 0) return true;
  const Int128 squared = squared_length(s);
  return std::any_of(moved.begin(), moved.end(), [&](const MovedSegment& m) {
    const Integer bound = integer_of(m.squared + squared) * width.raw();
    return bound * bound > squared_product(4 * m.side, squared);
  });
}

// True if moves can bring the line farther from the sample than half the width. |d'| is at least
// its projection onto d, and hardly more.
bool may_lie_beyond(const Segment& s, Fixed width, Point sample, std::int64_t reach) {
  const auto moved = moved_segments(s, sample, reach);
  const Int128 squared = squared_length(s);
  return std::any_of(moved.begin(), moved.end(), [&](const MovedSegment& m) {
    if (m.along <= 0) return true;
    const Integer bound = integer_of(m.along) * width.raw();
    return squared_product(2 * m.side, squared) > bound * bound;
  });
}

const TieRule& ties_named(const char* name) {
  return *find_tie_rule(name);
}

}  // namespace

bool multisampled_line_covers(const HomogeneousSegment& segment, Fixed width, Point sample,
                              const TieRule& ties) {
  const Direction d = direction(segment);
  if (d.x == 0 && d.y == 0) return false;
  return ties.positive(sign_of(along(segment.a, d, sample)), d.x, d.y) &&
         ties.positive(-sign_of(along(segment.b, d, sample)), -d.x, -d.y) &&
         within_half_width(segment, d, width, sample, ties);
}

std::vector<PixelPosition> multisampled_line_pixels(const HomogeneousSegment& segment, Fixed width,
                                                    const PixelBounds& bounds, Point within,
                                                    const TieRule& ties) {
  // The rectangle lies inside that of the nearest segment, if that is a little wider and longer.
  std::vector<PixelPosition> pixels;
  for (PixelPosition pixel : pixels_near_line(nearest_segment(segment), width, bounds))
    if (multisampled_line_covers(segment, width, place_in(pixel, within), ties))
      pixels.push_back(pixel);
  return pixels;
}

// Moves by the whole reach are not permitted, so testing them permits slightly more than real moves
// yield; without a reach only the boundary is open.
bool multisampled_line_possibly_covered(const Segment& segment, Fixed width, Point sample,
                                        Fixed reach) {
  if (reach == Fixed())
    return line_area_covers(segment, width, LineArea::rectangle, sample, ties_named("closed"));
  return way_along(segment.a, segment.b, sample, reach.raw()).most > 0 &&
         way_along(segment.b, segment.a, sample, reach.raw()).most > 0 &&
         may_lie_within(segment, width, sample, reach.raw());
}

bool multisampled_line_possibly_uncovered(const Segment& segment, Fixed width, Point sample,
                                          Fixed reach) {
  if (reach == Fixed())
    return !line_area_covers(segment, width, LineArea::rectangle, sample, ties_named("open"));
  return way_along(segment.a, segment.b, sample, reach.raw()).least < 0 ||
         way_along(segment.b, segment.a, sample, reach.raw()).least < 0 ||
         may_lie_beyond(segment, width, sample, reach.raw());
}

Rule multisampled_line_rule() {
  return {
      RuleId::line_multisampled,
      "A multisampled line covers the samples in its rectangle",
      "14.5.4 (line multisample rasterization)",
      "a sample exactly on the boundary may count or not; the ends, or the corners of the "
      "rectangle, may be moved to the sub-pixel grid",
      "rectangle",
      alternatives_of<MultisampledLine>(),
      {{28,
        "Multisampled lines: each end may be moved by less than one step of 2^-b in x and in y "
        "(b as in ruling 4), and a sample on the boundary may be covered or not. A sample may be "
        "covered if for each side of the rectangle some such moves put it inside that side or on "
        "it, and left out if some put it outside one of them or on it. The rectangle is as wide "
        "as the line, whose width is not rounded; a width that the renderer's "
        "GL_SMOOTH_LINE_WIDTH_GRANULARITY does not include becomes the nearest supported one: "
        "one width for the whole line, no farther away than the nearest of those that it includes "
        "and 1, which must be supported."}}};
}

}  // namespace edgecase
