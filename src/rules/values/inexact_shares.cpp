// SPDX-License-Identifier: MIT
#include "rules/values/inexact_shares.h"

#include <cstddef>

namespace edgecase {
namespace {

WindowPlace place_of(const HomogeneousPoint& p) {
  const auto w = static_cast<double>(p.w);
  return {Interval(static_cast<double>(p.x)) / w, Interval(static_cast<double>(p.y)) / w};
}

std::size_t count_of(const Interpolant& f) {
  return static_cast<std::size_t>(vertices_of(f.kind));
}

Interval weighted_sum(const Interpolant& f, const Shares& shares) {
  Interval sum = 0;
  for (std::size_t i = 0; i < count_of(f); ++i)
    sum = kInexact.add(sum, kInexact.multiply(shares[i], f.values[i]));
  return sum;
}

}  // namespace

WindowPlace place_of(Point point) {
  return {point.x.to_double(), point.y.to_double()};
}

WindowPlaces places_of(const Interpolant& f) {
  return {place_of(f.positions[0]), place_of(f.positions[1]), place_of(f.positions[2])};
}

Interval area_of(const Inexact& op, const WindowPlace& a, const WindowPlace& b,
                 const WindowPlace& p) {
  const Interval ax = op.subtract(a[0], p[0]);
  const Interval ay = op.subtract(a[1], p[1]);
  const Interval bx = op.subtract(b[0], p[0]);
  const Interval by = op.subtract(b[1], p[1]);
  return op.subtract(op.multiply(ax, by), op.multiply(ay, bx));
}

Shares triangle_shares(const WindowPlaces& v, const WindowPlace& p) {
  const Inexact& op = kInexact;
  const Interval area = area_of(op, v[1], v[2], v[0]);
  return {op.divide(area_of(op, v[1], v[2], p), area), op.divide(area_of(op, v[2], v[0], p), area),
          op.divide(area_of(op, v[0], v[1], p), area)};
}

SharesOverW divided_by_w(const Interpolant& f, const Shares& shares) {
  SharesOverW result;
  for (std::size_t i = 0; i < count_of(f); ++i) {
    result.shares[i] = kInexact.divide(shares[i], f.w[i]);
    result.total = kInexact.add(result.total, result.shares[i]);
  }
  return result;
}

Interval inexact_mean(const Interpolant& f, const Shares& shares) {
  if (has_perspective(f)) return inexact_mean(f, divided_by_w(f, shares));
  if (f.kind != PrimitiveKind::line) return weighted_sum(f, shares);
  const Inexact& op = kInexact;
  const Interval mean =
      op.add(f.values[0], op.multiply(shares[1], op.subtract(f.values[1], f.values[0])));
  // Of (1 - t) a + t b three operations err by a part of the first product, and two by one of the
  // second; by equation 14.6, where every w is the same, five more: both sums have divisions by w,
  // and one is divided by the other. Shares that are intervals would not sum to 1 there.
  const double more = f.perspective ? 5 : 0;
  const double error = op.relative * 1.001 *
                       ((3 + more) * (shares[0] * f.values[0]).magnitude() +
                        (2 + more) * (shares[1] * f.values[1]).magnitude());
  return mean + Interval(-error, error);
}

Interval inexact_mean(const Interpolant& f, const SharesOverW& over_w) {
  return kInexact.divide(weighted_sum(f, over_w.shares), over_w.total);
}

}  // namespace edgecase
