// SPDX-License-Identifier: MIT
//
// Walking the edges of a triangle finds exactly the pixels that the plain predicates cover: of all
// triangles of a small grid, and of random ones as far out as coordinates go.
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_algorithm.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/support/share.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

constexpr auto kWalked = TriangleAlgorithm::edge_functions;

// Row by row from the bottom, as walks go.
template <class Covers>
Pixels covered(const PixelBounds& bounds, Covers covers) {
  Pixels pixels;
  for (int y = bounds.y_min; y <= bounds.y_max; ++y)
    for (int x = bounds.x_min; x <= bounds.x_max; ++x)
      if (covers(x, y)) pixels.push_back({x, y});
  return pixels;
}

Pixels covered(const Triangle& t, const PixelBounds& bounds, const TieRule& ties) {
  return covered(bounds, [&](int x, int y) { return triangle_covers(t, x, y, ties); });
}

Pixels covered(const HomogeneousTriangle& t, const PixelBounds& bounds, const TieRule& ties,
               Point within) {
  return covered(bounds, [&](int x, int y) {
    return triangle_covers(t, homogeneous(place_in({x, y}, within)), ties);
  });
}

// A point with another w.
HomogeneousPoint weighted(Point p, std::int64_t by) {
  return {p.x.raw() * by, p.y.raw() * by, Fixed::kOne * by};
}

class RandomTriangles {
 public:
  // From -reach to reach, pixels; every coordinate a multiple of `step`, raw.
  Triangle next(std::int64_t reach, std::int64_t step) {
    std::uniform_int_distribution<std::int64_t> steps(-reach * Fixed::kOne / step,
                                                      reach * Fixed::kOne / step);
    Triangle t;
    for (Point& p : t)
      p = {Fixed::from_raw(steps(engine_) * step), Fixed::from_raw(steps(engine_) * step)};
    return t;
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }

 private:
  std::mt19937 engine_{11};
};

// Of all triangles between halves of pixels in 3x3 pixels.
TEST(TiedPixels, AreTheOnlyOnesAtWhichTieRulesDiffer) {
  constexpr int kSide = 7, kPoints = kSide * kSide;
  const auto point = [](int i) {
    const auto at = [](int n) { return Fixed::from_raw(n * Fixed::kOne / 2); };
    return Point{at(i % kSide), at(i / kSide)};
  };
  const PixelBounds bounds{0, 0, 2, 2};
  const TieRule& open = *find_tie_rule("open");
  const TieRule& closed = *find_tie_rule("closed");
  Dealer dealer;
  for (int i = 0; i < kPoints; ++i)
    for (int j = 0; j < kPoints; ++j)
      for (int k = 0; k < kPoints; ++k) {
        if (!dealer.deal()) continue;
        const Triangle t{point(i), point(j), point(k)};
        ASSERT_EQ(tied_triangle_pixels(t, bounds), covered(bounds, [&](int x, int y) {
                    return triangle_covers(t, x, y, closed) && !triangle_covers(t, x, y, open);
                  }));
        for (const TieRule& ties : all_tie_rules())
          covered(bounds, [&](int x, int y) {
            const bool drawn = triangle_covers(t, x, y, ties);
            EXPECT_LE(triangle_covers(t, x, y, open), drawn) << ties.name;
            EXPECT_LE(drawn, triangle_covers(t, x, y, closed)) << ties.name;
            return drawn;
          });
      }
}

TEST(EdgeWalk, CoversWhatThePredicateDoesOfAllTrianglesOfAGrid) {
  constexpr PixelBounds kBounds{0, 0, 2, 2};
  Pixels corners;
  for (int y = -1; y <= 6; ++y)
    for (int x = -1; x <= 6; ++x) corners.push_back({x, y});
  const auto half = [](PixelPosition p) {
    return Point{Fixed::from_raw(p.x * Fixed::kOne / 2), Fixed::from_raw(p.y * Fixed::kOne / 2)};
  };
  for (PixelPosition a : corners)
    for (PixelPosition b : corners)
      for (PixelPosition c : corners) {
        const Triangle t{half(a), half(b), half(c)};
        const TieRule& ties = all_tie_rules()[static_cast<std::size_t>(a.x + b.y + 2) % 10];
        ASSERT_EQ(triangle_pixels(t, kBounds, kWalked, ties), covered(t, kBounds, ties));
      }
}

TEST(EdgeWalk, CoversWhatThePredicateDoesOfEveryTieRule) {
  RandomTriangles random;
  constexpr PixelBounds kBounds{1, 0, 9, 7};
  for (int i = 0; i < 20000; ++i) {
    const Triangle t = random.next(10, Fixed::kOne / 2);
    for (const TieRule& ties : all_tie_rules())
      ASSERT_EQ(triangle_pixels(t, kBounds, kWalked, ties), covered(t, kBounds, ties))
          << i << " " << ties.name;
  }
}

// Where numbers are as large as they get, an overflow would show.
TEST(EdgeWalk, CoversWhatThePredicateDoesFarOut) {
  RandomTriangles random;
  const TieRule& ties = *find_tie_rule("left-top");
  for (const PixelBounds bounds : {PixelBounds{4090, 4090, 4095, 4095}, PixelBounds{0, 0, 5, 5}})
    for (int i = 0; i < 20000; ++i) {
      const Triangle t = random.next(Fixed::kMaxCoordinate, 1);
      ASSERT_EQ(triangle_pixels(t, bounds, kWalked, ties), covered(t, bounds, ties)) << i;
    }
}

TEST(EdgeWalk, CoversWhatThePredicateDoesOfQuotients) {
  RandomTriangles random;
  constexpr PixelBounds kBounds{0, 0, 7, 7};
  const Point places[] = {centre_of_pixel(),
                          {Fixed::from_raw(Fixed::kOne / 8), Fixed::from_raw(Fixed::kOne / 4)}};
  for (int i = 0; i < 20000; ++i) {
    const std::int64_t reach = i % 2 == 0 ? 10 : Fixed::kMaxCoordinate;
    const Triangle t = random.next(reach, i % 2 == 0 ? Fixed::kOne / 8 : 1);
    const HomogeneousTriangle other{weighted(t[0], 1 + random.below(65536)),
                                    weighted(t[1], 1 + random.below(7)), weighted(t[2], 65536)};
    const TieRule& ties = all_tie_rules()[static_cast<std::size_t>(i % 10)];
    const Point within = places[random.below(2)];
    ASSERT_EQ(triangle_pixels(other, kBounds, kWalked, ties, within),
              covered(other, kBounds, ties, within))
        << i << " " << ties.name;
  }
}

}  // namespace
}  // namespace edgecase
