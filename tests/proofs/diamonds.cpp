// SPDX-License-Identifier: MIT
//
// Claims on the diamond test of lines, by fixed point and by quotients. The sources are included
// whole, for what is local to them.
#include "claim.h"

// Both files have these names.
#define Diamond FixedDiamond
#define inside_sides fixed_inside_sides
#define meets_by_ties fixed_meets_by_ties
#define contains fixed_contains
#define touches_part fixed_touches_part
#define owned_parts fixed_owned_parts
#include "rules/coverage/diamond_exit.cpp"
#undef Diamond
#undef inside_sides
#undef meets_by_ties
#undef contains
#undef touches_part
#undef owned_parts
#include "rules/coverage/homogeneous_line.cpp"

using namespace edgecase;

namespace {

struct PixelOfWindow {
  std::int64_t x, y;
};

PixelOfWindow any_pixel_of_window() {
  const std::int64_t x = any_pixel();
  return {x, any_pixel()};
}

Segment any_segment() {
  const Point a = any_point();
  return {a, any_point()};
}

FixedDiamond diamond_of(PixelOfWindow pixel) {
  return {rotate(pixel_centre(pixel.x, pixel.y))};
}

}  // namespace

extern "C" {

// Of a radius of up to two pixels: possible and certain fragments ask for such.
void claim_diamonds_of_any_size() {
  const Segment s = any_segment();
  FixedDiamond diamond = diamond_of(any_pixel_of_window());
  diamond.radius = between(1, 2 * Fixed::kOne);
  fixed_meets_by_ties(rotate(s.a), rotate(s.b), diamond, any_ties());
}

void claim_edges_and_corners_of_diamonds() {
  const Segment s = any_segment();
  const PixelOfWindow pixel = any_pixel_of_window();
  fixed_touches_part({rotate(s.a), rotate(s.b)}, rotate(pixel_centre(pixel.x, pixel.y)),
                     static_cast<unsigned>(between(0, 255)));
}

// The sides of the diamond, by fixed point and by quotients.
void claim_sides_by_fixed_point_and_quotients_agree() {
  const Segment s = any_segment();
  const PixelOfWindow pixel = any_pixel_of_window();
  const TieRule ties = any_ties();
  const Rotated a = rotate(s.a);
  const Rotated b = rotate(s.b);
  const Rotated low{std::min(a.u, b.u), std::min(a.v, b.v)};
  const Rotated high{std::max(a.u, b.u), std::max(a.v, b.v)};
  check(fixed_inside_sides(low, high, diamond_of(pixel), ties) ==
        inside_sides(rotated(homogeneous(s.a)), rotated(homogeneous(s.b)),
                     Diamond(pixel.x, pixel.y), ties));
}

void claim_meeting_by_fixed_point_and_quotients_agree() {
  const Segment s = any_segment();
  const PixelOfWindow pixel = any_pixel_of_window();
  const TieRule ties = any_ties();
  check(fixed_meets_by_ties(rotate(s.a), rotate(s.b), diamond_of(pixel), ties) ==
        meets_by_ties(rotated(homogeneous(s.a)), rotated(homogeneous(s.b)),
                      Diamond(pixel.x, pixel.y), ties));
}

// Whoever meets the open diamond meets the closed one, and of the diamonds in between neither more
// than the closed one nor less than the open one.
void claim_open_and_closed_diamonds_enclose_the_others() {
  const Segment s = any_segment();
  const FixedDiamond diamond = diamond_of(any_pixel_of_window());
  TieRule open;
  open.kind = TieRule::Kind::open;
  TieRule closed;
  closed.kind = TieRule::Kind::closed;
  const bool met = fixed_meets_by_ties(rotate(s.a), rotate(s.b), diamond, any_ties());
  check(!fixed_meets_by_ties(rotate(s.a), rotate(s.b), diamond, open) || met);
  check(!met || fixed_meets_by_ties(rotate(s.a), rotate(s.b), diamond, closed));
}

// What it is to meet a diamond: some point of the segment, a + (b - a) n/d, lies within it. One
// direction, the other is the axis test's theorem: no point does where the test says no.
void claim_a_point_within_the_diamond_is_seen() {
  const Segment s = any_segment();
  const FixedDiamond diamond = diamond_of(any_pixel_of_window());
  TieRule open;
  open.kind = TieRule::Kind::open;
  const Rotated a = rotate(s.a);
  const Rotated b = rotate(s.b);
  const Int128 d = between(1, 1 << 30);
  const Int128 n = between(0, 1 << 30);
  assume(n <= d);
  const Int128 u = (a.u - diamond.centre.u) * d + Int128{b.u - a.u} * n;
  const Int128 v = (a.v - diamond.centre.v) * d + Int128{b.v - a.v} * n;
  const Int128 radius = diamond.radius * d;
  assume(u < radius && -u < radius && v < radius && -v < radius);
  check(fixed_meets_by_ties(a, b, diamond, open));
}

// Quotients with the largest w that a moved end has.
void claim_diamonds_of_quotients() {
  const HomogeneousPoint a = any_homogeneous(33);
  const HomogeneousPoint b = any_homogeneous(33);
  const PixelOfWindow pixel = any_pixel_of_window();
  meets_by_ties(rotated(a), rotated(b), Diamond(pixel.x, pixel.y), any_ties());
}

}  // extern "C"
