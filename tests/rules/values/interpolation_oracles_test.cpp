// SPDX-License-Identifier: MIT
//
// Interpolation with perspective against its three classical forms, on 10^6 triangles: ratios of
// areas, the inverse of the matrix of homogeneous vertices, and planes. The forms are worked out in
// 113 bits, u = 2^-113, and agree with each other within 32 u times their spread
// (tests/oracles/projected_triangle.h says what that is; products of differences are up to four
// times as large as R^2, and each form rounds them some four times by half a unit). The largest
// distance seen is 14 u times it. The exact interval holds all three and is at most 32 2^-53 times
// the spread of its sum wide, that is 2^-47 of the largest value where the sample lies inside; the
// largest width seen is 26 2^-53 times it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracles/area_ratios.h"
#include "tests/oracles/attribute_planes.h"
#include "tests/oracles/inverse_matrix.h"
#include "tests/rules/values/interpolants.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr double kFormulas = 32;
constexpr double kInterval = 32;

class TriangleSource {
 public:
  explicit TriangleSource(std::uint64_t seed) : numbers_(seed) {}

  // Never without area.
  Interpolant next() {
    for (;;) {
      const Interpolant f = any();
      if (cross(f.positions[0], f.positions[1], f.positions[2]) != 0) return f;
    }
  }

  // Half of them inside, as good as the grid allows.
  Point sample(const Interpolant& f) {
    if (numbers_.one_in(2)) return numbers_.point(near_ ? Fixed::kOne * 16 : Fixed::kOne * 8192);
    double rest = 1;
    double x = 0, y = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = i == 2 ? rest : numbers_.real(0, rest);
      const auto w = static_cast<double>(f.positions[i].w);
      x += share * (static_cast<double>(f.positions[i].x) / w);
      y += share * (static_cast<double>(f.positions[i].y) / w);
      rest -= share;
    }
    return at(x, y);
  }

 private:
  Interpolant any() {
    Interpolant f;
    near_ = numbers_.one_in(2);
    const bool quotients = numbers_.one_in(2);
    for (std::size_t i = 0; i < 3; ++i) {
      f.positions[i] = quotients ? quotient() : homogeneous(numbers_.point(limit()));
      f.values[i] = numbers_.attribute(2);
    }
    if (!quotients && numbers_.one_in(3)) make_sliver(f);
    // Ratios of w up to 2^20, and often none.
    const double bits = numbers_.one_in(4) ? 0 : numbers_.real(0, 10);
    for (Interval& w : f.w) w = numbers_.clip_w(bits);
    return f;
  }
  std::int64_t limit() const { return Fixed::kOne * (near_ ? 8 : 8192); }
  HomogeneousPoint quotient() {
    const std::int64_t w = numbers_.integer(1, std::int64_t{1} << numbers_.integer(1, 32));
    const std::int64_t most = w * (near_ ? 8 : 8192);
    const std::int64_t x = numbers_.integer(-most, most);
    return {x, numbers_.integer(-most, most), w};
  }
  // The third vertex some units beside the line of the two others.
  void make_sliver(Interpolant& f) {
    const double t = numbers_.real(-0.5, 1.5);
    const auto beside = [&](std::int64_t a, std::int64_t b) {
      return a + static_cast<std::int64_t>(t * static_cast<double>(b - a)) +
             numbers_.integer(-4, 4);
    };
    f.positions[2].x = beside(f.positions[0].x, f.positions[1].x);
    f.positions[2].y = beside(f.positions[0].y, f.positions[1].y);
  }

  RandomNumbers numbers_;
  bool near_ = true;
};

// The worst that was seen, as multiples of what the bounds are stated in.
struct Worst {
  double between_forms = 0;
  double off_interval = 0;
  double width = 0;
  int inside = 0;
  int strong = 0;  // ratios of w beyond 2^10
};

void update(Worst& worst, const Interpolant& f, Point sample) {
  const auto v = projected<Wide>(f);
  const Wide x = sample.x.to_double(), y = sample.y.to_double();
  const Wide forms[] = {by_area_ratios(v, x, y), by_inverse_matrix(v, x, y),
                        AttributePlanes<Wide>(v).at(x, y)};
  const Interval exact = interpolate_exact(f, sample);
  const Spread spread = spread_of(v, x, y);
  const auto [least, most] = std::minmax_element(std::begin(forms), std::end(forms));
  const double unit = std::ldexp(spread.of_formulas, -113);
  worst.between_forms = std::max(worst.between_forms, static_cast<double>(*most - *least) / unit);
  const Wide below = static_cast<Wide>(exact.low) - *least;
  const Wide above = *most - static_cast<Wide>(exact.high);
  worst.off_interval = std::max(
      {worst.off_interval, static_cast<double>(below) / unit, static_cast<double>(above) / unit});
  worst.width = std::max(worst.width, width_of(exact) / std::ldexp(spread.of_sum, -53));
  const auto [narrow, wide] = std::minmax({f.w[0].low, f.w[1].low, f.w[2].low});
  if (wide > 1024 * narrow) ++worst.strong;
  const auto [low, high] = std::minmax_element(v.values.begin(), v.values.end());
  if (*low <= *most && *least <= *high) ++worst.inside;
}

void expect_agreement(int count, std::uint64_t seed) {
  TriangleSource source(seed);
  Worst worst;
  for (int i = 0; i < count; ++i) {
    const Interpolant f = source.next();
    update(worst, f, source.sample(f));
  }
  EXPECT_LE(worst.between_forms, kFormulas);
  EXPECT_LE(worst.off_interval, kFormulas);
  EXPECT_LE(worst.width, kInterval);
  EXPECT_GT(worst.inside, count / 3);
  EXPECT_GT(worst.strong, count / 20);
}

TEST(InterpolationOracles, AMillionTrianglesAgree) {
  expect_agreement(share_of(1'000'000), share_seed(20260301));
}

TEST(InterpolationOracles, TenThousandTrianglesAgree) {
  expect_agreement(10'000, 20260302);
}

}  // namespace
}  // namespace edgecase
