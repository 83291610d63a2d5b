// SPDX-License-Identifier: MIT
//
// Means of two vertices where each operation errs by 1 part in 10^5: how far around the mean, by
// hand.
#include "rules/values/inexact_interpolation.h"

#include <gtest/gtest.h>

#include "tests/rules/values/interpolants.h"

namespace edgecase {
namespace {

Interpolant line_of(Interval first, Interval second, bool perspective = false) {
  Interpolant line{PrimitiveKind::line, {vertex_at(0, 0), vertex_at(4, 0), {}}, {first, second, 0}};
  line.perspective = perspective;
  line.w = {1, 1, 1};
  return line;
}

// At a quarter of the way from 4 to 8 the mean is 5: from the first vertex on a difference, a
// product and a sum are 4, 1 and 5, each off by 1 part, a difference and its product by two: 2 + 5.
// The products of equation 14.7 are 3, three times off, and 2, twice: 13 more.
TEST(InexactMean, ErrsByItsOperationsBothWays) {
  const Interval mean = inexact_mean(line_of(4, 8), Shares{0.75, 0.25, 0});
  EXPECT_NEAR(mean.low, 5 - 20e-5, 0.1e-5);
  EXPECT_NEAR(mean.high, 5 + 20e-5, 0.1e-5);
}

// Divisions by a w that is 1 everywhere: five operations more of each product, 3 and 2.
TEST(InexactMean, ErrsMoreWhereItDividesByW) {
  const Interval mean = inexact_mean(line_of(4, 8, true), Shares{0.75, 0.25, 0});
  EXPECT_NEAR(mean.low, 5 - 45e-5, 0.1e-5);
  EXPECT_NEAR(mean.high, 5 + 45e-5, 0.1e-5);
}

// Values of both signs cancel; their errors do not.
TEST(InexactMean, ErrsAroundZeroToo) {
  const Interval mean = inexact_mean(line_of(-1, 1), Shares{0.5, 0.5, 0});
  // 2 parts of the product, 1, and none of the sum, 0; then 3 and 2 parts of one half.
  EXPECT_NEAR(mean.low, -4.5e-5, 0.1e-5);
  EXPECT_NEAR(mean.high, 4.5e-5, 0.1e-5);
}

}  // namespace
}  // namespace edgecase
