// SPDX-License-Identifier: MIT
//
// What a place shares between attributes, corners and areas is what each would work out by itself:
// to the bit, against the formula of rules/values/interpolation.h evaluated corner by corner.
#include "rules/values/permitted_interpolation.h"

#include <gtest/gtest.h>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

constexpr double kClause = 1e-5;

Interval err(Interval value) {
  return widened(value, kClause);
}

using Vertices = std::array<std::array<Interval, 2>, 3>;

Vertices vertices_of(const Interpolant& f) {
  Vertices v;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto w = static_cast<double>(f.positions[i].w);
    v[i] = {Interval(static_cast<double>(f.positions[i].x)) / w,
            Interval(static_cast<double>(f.positions[i].y)) / w};
  }
  return v;
}

// Twice the area that an edge forms with a point; exact: no operation errs but for its rounding.
Interval area(const std::array<Interval, 2>& a, const std::array<Interval, 2>& b,
              const std::array<Interval, 2>& p, bool exact) {
  const auto of = [&](Interval value) { return widened(value, exact ? 0 : kClause); };
  const Interval ax = of(a[0] - p[0]), ay = of(a[1] - p[1]);
  const Interval bx = of(b[0] - p[0]), by = of(b[1] - p[1]);
  return of(of(ax * by) - of(ay * bx));
}

// The areas opposite to each vertex.
std::array<Interval, 3> areas(const Vertices& v, const std::array<Interval, 2>& p, bool exact) {
  return {area(v[1], v[2], p, exact), area(v[2], v[0], p, exact), area(v[0], v[1], p, exact)};
}

Interval over_w_total(const Interpolant& f, const std::array<Interval, 3>& shares) {
  Interval total = 0;
  for (std::size_t i = 0; i < 3; ++i) total = err(total + err(shares[i] / f.w[i]));
  return total;
}

Interval mean(const Interpolant& f, const Vertices& v, const std::array<Interval, 2>& p) {
  const Interval whole = area(v[1], v[2], v[0], false);
  std::array<Interval, 3> shares = areas(v, p, false);
  for (Interval& share : shares) share = err(share / whole);
  Interval sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Interval share = has_perspective(f) ? err(shares[i] / f.w[i]) : shares[i];
    sum = err(sum + err(share * f.values[i]));
  }
  return has_perspective(f) ? err(sum / over_w_total(f, shares)) : sum;
}

Interval total(const Interpolant& f, const Vertices& v, const std::array<Interval, 2>& p) {
  if (!has_perspective(f)) return area(v[1], v[2], v[0], false);
  return over_w_total(f, areas(v, p, false));
}

// Which of what is divided by lies above 0.
std::pair<bool, bool> signs(const Interpolant& f, const Vertices& v,
                            const std::array<Interval, 2>& p) {
  const bool whole = area(v[1], v[2], v[0], true).low > 0;
  if (!has_perspective(f)) return {whole, whole};
  const auto a = areas(v, p, true);
  return {whole, (a[0] / f.w[0] + a[1] / f.w[1] + a[2] / f.w[2]).low > 0};
}

// The hull of a formula over the vertices as they are and all 64 corners of their moves.
template <class Formula>
Interval over_corners(const Interpolant& f, Point sample, double reach, Formula formula) {
  const std::array<Interval, 2> p{sample.x.to_double(), sample.y.to_double()};
  const Vertices unmoved = vertices_of(f);
  Interval result = formula(f, unmoved, p);
  for (unsigned corner = 0; corner < 64; ++corner) {
    Vertices v = unmoved;
    for (unsigned axis = 0; axis < 6; ++axis) {
      Interval& moved = v[axis / 2][axis % 2];
      moved = moved + ((corner >> axis & 1U) != 0 ? reach : -reach);
    }
    if (signs(f, v, p) != signs(f, unmoved, p)) return Interval::everything();
    result = hull(result, formula(f, v, p));
  }
  return result;
}

::testing::AssertionResult same(Interval a, Interval b) {
  if (a.low == b.low && a.high == b.high) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << a.low << " to " << a.high << " is not " << b.low << " to " << b.high;
}

TEST(PermittedPlace, ATriangleSharesWhatEachAttributeWouldWorkOut) {
  RandomNumbers numbers(9);
  int everything = 0, perspective = 0;
  constexpr int kTriangles = 600;
  for (int round = 0; round < kTriangles; ++round) {
    // Every third one is a sliver; every other one has w that differ.
    const std::int64_t size = round % 3 == 0 ? 512 : 32 * 256;
    std::array<Interpolant, 3> f;
    for (std::size_t i = 0; i < 3; ++i) {
      const HomogeneousPoint position{256 * numbers.integer(0, 32 * 256),
                                      256 * numbers.integer(0, i == 2 ? size : 32 * 256),
                                      Fixed::kOne};
      const Interval w = round % 2 == 0 ? numbers.clip_w(2) : Interval(1);
      for (Interpolant& one : f) {
        one.positions[i] = position;
        one.values[i] = numbers.attribute(1);
        one.w[i] = w;
      }
    }
    f[2].perspective = false;
    const double reach = round % 5 == 0 ? 0.5 : 1.0 / 256;
    const Point sample = at(static_cast<double>(numbers.integer(0, 31)) + 0.5,
                            static_cast<double>(numbers.integer(0, 31)) + 0.5);
    const MovedVertices vertices(f[0], reach);
    const PermittedPlace place(vertices, sample);
    const MovedShares shares(vertices, sample);
    for (const Interpolant& one : f) {
      const Interval expected = over_corners(one, sample, reach, mean);
      ASSERT_TRUE(same(place.value(one), expected)) << round;
      ASSERT_TRUE(same(interpolate_permitted(one, sample, reach), expected)) << round;
      ASSERT_TRUE(same(shares.total(one), over_corners(one, sample, reach, total))) << round;
      const auto slopes = place.slopes(one, place.value(one));
      for (const Axis axis : {Axis::x, Axis::y}) {
        const Interval slope = differentiate_permitted(one, sample, axis, reach);
        ASSERT_TRUE(same(place.slope(one, axis), slope));
        ASSERT_TRUE(same(slopes[axis == Axis::x ? 0 : 1], slope));
      }
      everything += is_everything(expected) ? 1 : 0;
      perspective += has_perspective(one) ? 1 : 0;
    }
  }
  EXPECT_GT(everything, 50);
  EXPECT_LT(everything, kTriangles);
  EXPECT_EQ(perspective, kTriangles);
}

// A place has no memory: lines and points are asked for in any order, too.
TEST(PermittedPlace, LinesAndPointsAreAsTheyAreByThemselves) {
  RandomNumbers numbers(10);
  for (int round = 0; round < 200; ++round) {
    for (const PrimitiveKind kind : {PrimitiveKind::line, PrimitiveKind::point}) {
      std::array<Interpolant, 2> f;
      for (std::size_t i = 0; i < 2; ++i)
        for (Interpolant& one : f) {
          one.kind = kind;
          one.positions[i] = f[0].positions[i] = {256 * numbers.integer(0, 8192),
                                                  256 * numbers.integer(0, 8192), Fixed::kOne};
          one.values[i] = numbers.attribute(1);
        }
      f[1].positions = f[0].positions;
      const Point sample = at(7.5, 9.5);
      const MovedVertices vertices(f[0], 1.0 / 16);
      const PermittedPlace place(vertices, sample);
      for (const Interpolant& one : f) {
        EXPECT_TRUE(same(place.value(one), interpolate_permitted(one, sample, 1.0 / 16)));
        EXPECT_TRUE(same(place.slope(one, Axis::y),
                         differentiate_permitted(one, sample, Axis::y, 1.0 / 16)));
      }
    }
  }
}

}  // namespace
}  // namespace edgecase
