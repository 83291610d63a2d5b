// SPDX-License-Identifier: MIT
//
// Claims that are wrong, each in one way that the prover must see: else it could prove anything.
#include "claim.h"

using namespace edgecase;

extern "C" {

// The rotated form of a product that fits as given: 63 bits and a sign do not hold it.
void claim_overflow_of_a_product() {
  const Point a = any_point();
  const Point b = any_point();
  const std::int64_t u = a.x.raw() + a.y.raw();
  const std::int64_t v = b.x.raw() + b.y.raw();
  check(u * v * 8 <= INT64_MAX);
}

// One step beyond the bound, at a single input.
void claim_overflow_of_a_sum() {
  const std::int64_t a = between(0, INT64_MAX);
  check(a + between(0, 1) >= 0);
}

// Out of reach but for one value of many.
void claim_that_fails_at_one_value() {
  const std::int64_t a = between(-1'000'000, 1'000'000);
  check(a * a * a != 999'999LL * 999'999LL * 999'999LL);
}

void claim_on_one_path_only() {
  const std::int64_t a = between(-100, 100);
  std::int64_t b = a;
  if (a > 50) b = 50;
  check(b < 50);
}

void claim_number_cut_off() {
  const std::int64_t a = between(0, std::int64_t{1} << 31);
  check(static_cast<int>(a) != 7 || a == 7);
}

void claim_half_of_a_wide_number_cut_off() {
  const Int128 a = Int128{between(0, INT64_MAX)} + between(0, 1);
  check(static_cast<std::int64_t>(a) != 7 || a == 7);
}

void claim_division_by_zero() {
  const std::int64_t a = between(0, 10);
  check(100 / a >= 10);
}

// The two ends of an edge exchanged: a tie goes to the other triangle.
void claim_closed_edges_are_owned_once() {
  const Point a = any_point();
  const Point b = any_point();
  TieRule closed;
  closed.kind = TieRule::Kind::closed;
  const Point sample = any_point();
  check(a == b ||
        closed.positive(cross(a, b, sample), 0, 0) != closed.positive(cross(b, a, sample), 0, 0));
}

}  // extern "C"
