// SPDX-License-Identifier: MIT
#include "rules/coverage/homogeneous_line.h"

#include <cassert>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/segment.h"

namespace edgecase {
namespace {

// With w up to 2^33 a coordinate of an end is at most 2^47, u and v 2^48, a difference of two
// products by w 2^82. A diamond's u and v are at most 2^16 halves, so no determinant below exceeds
// 2^99.

// A rotated point stores u and v as its x and y.
HomogeneousPoint rotated(const HomogeneousPoint& p) {
  assert(0 < p.w && p.w <= std::int64_t{1} << 33);
  assert(std::abs(p.x) / p.w <= 1 << 14 && std::abs(p.y) / p.w <= 1 << 14);
  return {p.x + p.y, p.x - p.y, p.w};
}

// The components of b - a, times both w.
struct Direction {
  Int128 x;
  Int128 y;
};

Direction direction(const HomogeneousPoint& a, const HomogeneousPoint& b) {
  return {Int128{b.x} * a.w - Int128{a.x} * b.w, Int128{b.y} * a.w - Int128{a.y} * b.w};
}

Int128 magnitude(Int128 value) {
  return value < 0 ? -value : value;
}

// The sides of a pixel's diamond, in halves of a pixel: u and v of its centre, minus and plus 1.
struct Diamond {
  std::int64_t u_low, u_high, v_low, v_high;

  Diamond(std::int64_t x, std::int64_t y)
      : u_low(2 * (x + y) + 1), u_high(u_low + 2), v_low(2 * (x - y) - 1), v_high(v_low + 2) {}
  HomogeneousPoint centre() const { return {u_low + 1, v_low + 1, 2}; }
  HomogeneousPoint corner(std::int64_t u, std::int64_t v) const { return {u, v, 2}; }
};

// An end's u or v minus a number of halves, times 2 w.
Int128 beyond(std::int64_t coordinate, std::int64_t w, std::int64_t halves) {
  return 2 * Int128{coordinate} - Int128{halves} * w;
}

// True if no side of the diamond has both ends outside. u and v of the sides grow by (1, 1) and (1,
// -1) as the sample moves right and up.
bool inside_sides(const HomogeneousPoint& a, const HomogeneousPoint& b, const Diamond& d,
                  const TieRule& ties) {
  const auto above = [&](const HomogeneousPoint& p) {
    return ties.positive(beyond(p.x, p.w, d.u_low), -1, -1);
  };
  const auto below = [&](const HomogeneousPoint& p) {
    return ties.positive(-beyond(p.x, p.w, d.u_high), 1, 1);
  };
  const auto right = [&](const HomogeneousPoint& p) {
    return ties.positive(beyond(p.y, p.w, d.v_low), -1, 1);
  };
  const auto left = [&](const HomogeneousPoint& p) {
    return ties.positive(-beyond(p.y, p.w, d.v_high), 1, -1);
  };
  return (above(a) || above(b)) && (below(a) || below(b)) && (right(a) || right(b)) &&
         (left(a) || left(b));
}

// True if the segment meets the diamond, with ties decided by a tie rule. Ends in rotated
// coordinates.
bool meets_by_ties(const HomogeneousPoint& a, const HomogeneousPoint& b, const Diamond& d,
                   const TieRule& ties) {
  if (!inside_sides(a, b, d, ties)) return false;
  const auto [du, dv] = direction(a, b);
  if (du == 0 && dv == 0) return true;
  // The segment's normal (-dv, du): the centre may be at most half the diamond's width away.
  const Int128 offset = cross(a, b, d.centre());
  const Int128 reach = magnitude(du) + magnitude(dv);
  const Int128 gradient_x = du - dv;
  const Int128 gradient_y = -du - dv;
  return ties.positive(reach + offset, gradient_x, gradient_y) &&
         ties.positive(reach - offset, -gradient_x, -gradient_y);
}

// True if two numbers are on different sides of zero, or one of them is zero.
bool straddle(Int128 a, Int128 b) {
  return sign(a) * sign(b) <= 0;
}

// True if the segment contains a corner of the diamond.
bool contains(const HomogeneousPoint& a, const HomogeneousPoint& b,
              const HomogeneousPoint& corner) {
  return cross(a, b, corner) == 0 &&
         straddle(beyond(a.x, a.w, corner.x), beyond(b.x, b.w, corner.x)) &&
         straddle(beyond(a.y, a.w, corner.y), beyond(b.y, b.w, corner.y));
}

// True if the segment meets the open edge {u == at, v strictly between low and high}.
bool meets_u_edge(const HomogeneousPoint& a, const HomogeneousPoint& b, std::int64_t at,
                  std::int64_t low, std::int64_t high) {
  const Int128 of_a = beyond(a.x, a.w, at);
  const Int128 of_b = beyond(b.x, b.w, at);
  if (of_a == 0 && of_b == 0)
    return (beyond(a.y, a.w, low) > 0 || beyond(b.y, b.w, low) > 0) &&
           (beyond(a.y, a.w, high) < 0 || beyond(b.y, b.w, high) < 0);
  if (!straddle(of_a, of_b)) return false;
  return sign(cross(a, b, {at, low, 2})) * sign(cross(a, b, {at, high, 2})) < 0;
}

HomogeneousPoint u_and_v_exchanged(const HomogeneousPoint& p) {
  return {p.y, p.x, p.w};
}

// True if the segment meets one of these parts of the diamond's boundary. Rotated coordinates.
bool touches_part(const HomogeneousPoint& a, const HomogeneousPoint& b, const Diamond& d,
                  unsigned parts) {
  const auto has_corner = [&](DiamondPart part, std::int64_t u, std::int64_t v) {
    return (parts & part) != 0 && contains(a, b, d.corner(u, v));
  };
  const auto has_u_edge = [&](DiamondPart part, std::int64_t u) {
    return (parts & part) != 0 && meets_u_edge(a, b, u, d.v_low, d.v_high);
  };
  const auto has_v_edge = [&](DiamondPart part, std::int64_t v) {
    return (parts & part) != 0 &&
           meets_u_edge(u_and_v_exchanged(a), u_and_v_exchanged(b), v, d.u_low, d.u_high);
  };
  // Right is high u and v, top is high u and low v.
  return has_corner(kRightCorner, d.u_high, d.v_high) ||
         has_corner(kLeftCorner, d.u_low, d.v_low) || has_corner(kTopCorner, d.u_high, d.v_low) ||
         has_corner(kBottomCorner, d.u_low, d.v_high) || has_u_edge(kUpperRightEdge, d.u_high) ||
         has_u_edge(kLowerLeftEdge, d.u_low) || has_v_edge(kLowerRightEdge, d.v_high) ||
         has_v_edge(kUpperLeftEdge, d.v_low);
}

unsigned owned_parts(const HomogeneousSegment& segment, const DiamondBoundary& boundary) {
  return segment.x_major() ? boundary.x_major_parts : boundary.y_major_parts;
}

}  // namespace

bool HomogeneousSegment::x_major() const {
  const auto [dx, dy] = direction(a, b);
  return magnitude(dx) >= magnitude(dy);
}

Segment nearest_segment(const HomogeneousSegment& segment) {
  return {nearest_point(segment.a), nearest_point(segment.b)};
}

bool meets_diamond(const HomogeneousSegment& segment, int x, int y,
                   const DiamondBoundary& boundary) {
  const HomogeneousPoint a = rotated(segment.a);
  const HomogeneousPoint b = rotated(segment.b);
  const Diamond diamond(x, y);
  if (boundary.ties != nullptr) return meets_by_ties(a, b, diamond, *boundary.ties);
  return meets_by_ties(a, b, diamond, open_ties()) ||
         touches_part(a, b, diamond, owned_parts(segment, boundary));
}

bool ends_in_diamond(const HomogeneousSegment& segment, int x, int y,
                     const DiamondBoundary& boundary) {
  const HomogeneousPoint end = rotated(segment.b);
  const Diamond diamond(x, y);
  if (boundary.ties != nullptr) return inside_sides(end, end, diamond, *boundary.ties);
  return inside_sides(end, end, diamond, open_ties()) ||
         touches_part(end, end, diamond, owned_parts(segment, boundary));
}

bool diamond_exit_covers(const HomogeneousSegment& segment, int x, int y,
                         const DiamondBoundary& boundary) {
  return meets_diamond(segment, x, y, boundary) && !ends_in_diamond(segment, x, y, boundary);
}

std::vector<PixelPosition> diamond_exit_pixels(const HomogeneousSegment& segment,
                                               const PixelBounds& bounds,
                                               const DiamondBoundary& boundary) {
  std::vector<PixelPosition> result;
  // A diamond that the segment meets is less than 1/2 + 2^-15 away from the nearest segment.
  visit_pixels_near(nearest_segment(segment), bounds, [&](PixelPosition p) {
    if (diamond_exit_covers(segment, p.x, p.y, boundary)) result.push_back(p);
  });
  return result;
}

HomogeneousSegment lowest_segment(const HomogeneousSegment& segment, int width) {
  const int dx = segment.x_major() ? 0 : 1 - width;
  const int dy = segment.x_major() ? 1 - width : 0;
  return {moved(segment.a, dx, dy, 2), moved(segment.b, dx, dy, 2)};
}

std::vector<PixelPosition> line_pixels(const HomogeneousSegment& segment, Fixed width,
                                       const PixelBounds& bounds, const LineChoice& choice,
                                       const TieRule& ties) {
  const bool thin = width == Fixed::from_integer(1);
  const bool exact = choice.algorithm == LineAlgorithm::diamond_exit &&
                     (thin || choice.wide == WideLine::replicate);
  if (!exact) return line_pixels(nearest_segment(segment), width, bounds, choice, ties);
  if (thin) return diamond_exit_pixels(segment, bounds, *choice.boundary);
  const int rounded = rounded_width(width);
  const auto lowest = diamond_exit_pixels(lowest_segment(segment, rounded), bounds.grown(rounded),
                                          *choice.boundary);
  return replicated(lowest, segment.x_major(), rounded, bounds);
}

}  // namespace edgecase
