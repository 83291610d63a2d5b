// SPDX-License-Identifier: MIT
//
// Claims on edge functions: triangles by fixed point, by quotients, and the walks over their
// pixels. The sources are included whole, for what is local to them.
#include "claim.h"

#include "rules/coverage/homogeneous_triangle.cpp"
#include "rules/coverage/triangle_algorithm.cpp"

using namespace edgecase;

namespace {

struct FixedEdge {
  Point a, b;
};

FixedEdge any_edge() {
  const Point a = any_point();
  return {a, any_point()};
}

// The decision as triangle_covers takes it.
bool plain_inside(const FixedEdge& e, Point sample, const TieRule& ties) {
  return ties.positive(cross(e.a, e.b, sample), e.a.y.raw() - e.b.y.raw(),
                       e.b.x.raw() - e.a.x.raw());
}

// A vertex as it may come out of a projection, outside the clip volume too.
HomogeneousPoint any_vertex() {
  constexpr std::int64_t kMostW = std::int64_t{1} << 32;
  constexpr std::int64_t kMost = std::int64_t{1} << 46;
  const std::int64_t x = between(-kMost, kMost);
  const std::int64_t y = between(-kMost, kMost);
  return {x, y, between(-kMostW, kMostW)};
}

// A place within a pixel, at its w of 2^16.
HomogeneousPoint any_sample() {
  return homogeneous(any_point());
}

}  // namespace

extern "C" {

// fixed.h: the cross product of window coordinates stays within 2^61.
void claim_cross_product_of_fixed_points() {
  const FixedEdge e = any_edge();
  const std::int64_t value = cross(e.a, e.b, any_point());
  check(value <= (std::int64_t{1} << 61) && value >= -(std::int64_t{1} << 61));
}

// homogeneous.h: that of three vertices stays within Int128, and within 2^111 where one is a
// sample.
void claim_cross_product_of_vertices() {
  const HomogeneousPoint a = any_vertex();
  const HomogeneousPoint b = any_vertex();
  cross(a, b, any_vertex());
  const Int128 value = cross(a, b, any_sample());
  check(value <= (Int128{1} << 111) && value >= -(Int128{1} << 111));
}

void claim_equality_of_points() {
  const HomogeneousPoint a = any_vertex();
  same_point(a, any_vertex());
}

void claim_nearest_point() {
  const HomogeneousPoint p = any_homogeneous(32);
  const Point nearest = nearest_point(p);
  // Within half a step: 2 (nearest w - x) is at most w away from 0, in units of 2^-16.
  const Int128 off = 2 * (Int128{nearest.x.raw()} * p.w - Int128{p.x} * Fixed::kOne);
  check(p.w == Fixed::kOne || (off <= p.w && -off <= p.w));
}

// By quotients and by fixed point the same: the determinant is the cross product, times 2^16.
void claim_fixed_and_quotients_agree() {
  const FixedEdge e = any_edge();
  const Point sample = any_point();
  check(cross(homogeneous(e.a), homogeneous(e.b), homogeneous(sample)) ==
        Int128{cross(e.a, e.b, sample)} * Fixed::kOne);
  const TieRule ties = any_ties();
  check(inside_edge(homogeneous(e.a), homogeneous(e.b), homogeneous(sample), ties) ==
        plain_inside(e, sample, ties));
}

// The walk's first value is the plain decision's, at any pixel of the window.
void claim_walk_begins_as_the_plain_decision() {
  const FixedEdge e = any_edge();
  const int x = any_pixel();
  const int y = any_pixel();
  const TieRule ties = any_ties();
  const WalkedEdge<std::int64_t> walked = walked_edge(e.a, e.b, x, y, ties);
  check(walked.has_inside() == plain_inside(e, pixel_centre(x, y), ties));
}

// And stays it with every step, to one beyond the window.
void claim_walk_goes_on_as_it_began() {
  const FixedEdge e = any_edge();
  const int x = any_pixel();
  const int y = any_pixel();
  const TieRule ties = any_ties();
  const WalkedEdge<std::int64_t> here = walked_edge(e.a, e.b, x, y, ties);
  const WalkedEdge<std::int64_t> right = walked_edge(e.a, e.b, x + 1, y, ties);
  const WalkedEdge<std::int64_t> up = walked_edge(e.a, e.b, x, y + 1, ties);
  check(here.value + here.right == right.value);
  check(here.value + here.up == up.value);
  check(here.right == right.right && here.up == right.up && here.is_own == right.is_own);
  check(here.right == up.right && here.up == up.up && here.is_own == up.is_own);
}

void claim_walk_by_quotients() {
  const HomogeneousPoint a = any_homogeneous(32);
  const HomogeneousPoint b = any_homogeneous(32);
  const HomogeneousPoint sample = any_sample();
  const TieRule ties = any_ties();
  const WalkedEdge<Int128> here = walked_edge(a, b, sample, ties);
  check(here.has_inside() == inside_edge(a, b, sample, ties));
  const WalkedEdge<Int128> right =
      walked_edge(a, b, {sample.x + sample.w, sample.y, sample.w}, ties);
  const WalkedEdge<Int128> up = walked_edge(a, b, {sample.x, sample.y + sample.w, sample.w}, ties);
  check(here.value + here.right == right.value && here.right == right.right);
  check(here.value + here.up == up.value && here.up == up.up);
}

// Of two triangles on the two sides of an edge exactly one owns a sample on it, or all of one side.
void claim_a_shared_edge_is_owned_once() {
  const FixedEdge e = any_edge();
  const Point sample = any_point();
  const TieRule ties = any_perturbed_ties();
  check(e.a == e.b || plain_inside(e, sample, ties) != plain_inside({e.b, e.a}, sample, ties));
}

}  // extern "C"
