// SPDX-License-Identifier: MIT
//
// Triangles by masks and by spans hold exactly the samples that triangle_covers has inside: all
// triangles of a small grid, random ones on every grid, and the largest there are.
#include <gtest/gtest.h>

#include <numeric>

#include "kernels/kernels.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/triangle_algorithm.h"
#include "tests/kernels/kernel_canvas.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

class TriangleKernel : public testing::Test {
 protected:
  ~TriangleKernel() override { use_kernel_target(0); }
};

// The triangle moved so that a sample's place becomes the centre of its pixel.
Triangle centred(const Triangle& t, Point place) {
  const Point centre = pixel_centre(0, 0);
  const auto moved = [&](Point p) {
    return Point{p.x + centre.x - place.x, p.y + centre.y - place.y};
  };
  return {moved(t[0]), moved(t[1]), moved(t[2])};
}

Pixels plain_pixels(const Triangle& t, const PixelBounds& bounds, const TieRule& ties) {
  return pixels_where(bounds, [&](int x, int y) { return triangle_covers(t, x, y, ties); });
}

Pixels filled_pixels(Canvas& canvas, const Triangle& t, const TieRule& ties,
                     const PixelBounds& bounds, Point place = pixel_centre(0, 0)) {
  const RawPoint raw_place = raw_point(place);
  const FlatTriangle flat{{raw_point(t[0]), raw_point(t[1]), raw_point(t[2])}, 0x01020304};
  fill_triangles({{&canvas.plane(), 1}, {&raw_place, 1}, bounds}, {&flat, 1}, weights_of(ties));
  return canvas.take();
}

std::string described(const Triangle& t, const TieRule& ties) {
  return explain_triangle(t, 0, 0, ties).text;
}

// A triangle's pixels are just those, and neither one less, nor one more, nor another.
void expect_just(const Pixels& plain, const Triangle& t, const PixelBounds& bounds,
                 const TieRule& ties) {
  ASSERT_TRUE(walks_just(plain, t, bounds, ties)) << described(t, ties);
  Pixels more = plain;
  more.push_back({bounds.x_max, bounds.y_max + 1});
  ASSERT_FALSE(walks_just(more, t, bounds, ties)) << described(t, ties);
  if (plain.empty()) return;
  ASSERT_FALSE(walks_just(std::span(plain).first(plain.size() - 1), t, bounds, ties));
  ASSERT_FALSE(walks_just(std::span(plain).subspan(1), t, bounds, ties));
  const std::size_t middle = plain.size() / 2;
  Pixels other = plain;
  other.erase(other.begin() + static_cast<std::ptrdiff_t>(middle));
  ASSERT_FALSE(walks_just(other, t, bounds, ties)) << described(t, ties);
}

// All triangles whose vertices lie on a grid of 6x6 half pixels, from one pixel beyond the window's
// corner on, under every tie rule.
TEST_F(TriangleKernel, EveryTriangleOfASmallGrid) {
  constexpr int kSide = 6, kPoints = kSide * kSide;
  const auto point = [](int i) {
    const auto at = [](int n) { return Fixed::from_raw((n - 1) * Fixed::kOne / 2); };
    return Point{at(i % kSide), at(i / kSide)};
  };
  Canvas canvas(3, 3);
  for (const std::int64_t target : kernel_targets()) {
    use_kernel_target(target);
    int covered = 0, ties_of_all = 0;
    for (int i = 0; i < kPoints * kPoints * kPoints; ++i) {
      if (!is_in_share(static_cast<std::uint64_t>(i))) continue;
      const Triangle t{point(i % kPoints), point(i / kPoints % kPoints),
                       point(i / kPoints / kPoints)};
      for (const TieRule& ties : all_tie_rules()) {
        const Pixels plain = plain_pixels(t, canvas.bounds(), ties);
        ASSERT_EQ(filled_pixels(canvas, t, ties, canvas.bounds()), plain) << described(t, ties);
        ASSERT_EQ(walked_triangle_pixels(t, canvas.bounds(), ties), plain) << described(t, ties);
        ASSERT_NO_FATAL_FAILURE(expect_just(plain, t, canvas.bounds(), ties));
        covered += static_cast<int>(plain.size());
      }
      const Pixels tied = tied_triangle_pixels(t, canvas.bounds());
      ASSERT_EQ(walked_tied_pixels(t, canvas.bounds()), tied) << described(t, open_ties());
      ties_of_all += static_cast<int>(tied.size());
    }
    EXPECT_GT(covered, least_of(100000));
    EXPECT_GT(ties_of_all, least_of(20000));
  }
  EXPECT_FALSE(canvas.has_spilled());
}

// On grids of 0 to 16 bits, in targets up to 70 pixels wide: masks, spans, and boxes that the
// target cuts.
TEST_F(TriangleKernel, RandomTrianglesOfEveryGrid) {
  const auto targets = kernel_targets();
  RandomPoints random(share_seed(1));
  const std::span<const TieRule> rules = all_tie_rules();
  const int count = kernel_scenes(60000);
  for (int i = 0; i < count; ++i) {
    const int size = i % 8 != 0 ? 1 + random.below(18) : 1 + random.below(70);
    const int bits = random.below(17);
    Triangle t{random.point(size, bits), random.point(size, bits), random.point(size, bits)};
    // Now and then a box of any height and few columns, or the other way round.
    if (i % 5 == 0) t[2] = {t[0].x + Fixed::from_raw(random.below(3)), t[2].y};
    const TieRule& ties = rules[static_cast<std::size_t>(random.below(10))];
    Canvas canvas(size, size);
    const PixelBounds bounds = canvas.bounds();
    const Pixels plain = plain_pixels(t, bounds, ties);
    ASSERT_EQ(walked_triangle_pixels(t, bounds, ties), plain) << described(t, ties);
    ASSERT_NO_FATAL_FAILURE(expect_just(plain, t, bounds, ties));
    ASSERT_EQ(walked_tied_pixels(t, bounds), tied_triangle_pixels(t, bounds)) << described(t, ties);
    for (const std::int64_t target : targets) {
      use_kernel_target(target);
      ASSERT_EQ(filled_pixels(canvas, t, ties, bounds), plain) << described(t, ties);
    }
    ASSERT_FALSE(canvas.has_spilled()) << described(t, ties);
  }
}

// Samples beside the centre, and bounds within the plane.
TEST_F(TriangleKernel, AnyPlaceInThePixelAndAnyBounds) {
  RandomPoints random(share_seed(2));
  const std::span<const TieRule> rules = all_tie_rules();
  const auto targets = kernel_targets();
  const int count = kernel_scenes(20000);
  Canvas canvas(24, 24);
  for (int i = 0; i < count; ++i) {
    const int bits = random.below(17);
    const Triangle t{random.point(24, bits), random.point(24, bits), random.point(24, bits)};
    const std::int64_t step = Fixed::kOne >> random.below(17);
    const Point place{random.coordinate(0, Fixed::kOne - 1, step),
                      random.coordinate(0, Fixed::kOne - 1, step)};
    const int x = random.below(24), y = random.below(24);
    const PixelBounds bounds{x, y, x + random.below(24 - x), y + random.below(24 - y)};
    const TieRule& ties = rules[static_cast<std::size_t>(random.below(10))];
    use_kernel_target(targets[static_cast<std::size_t>(i) % targets.size()]);
    ASSERT_EQ(filled_pixels(canvas, t, ties, bounds, place),
              plain_pixels(centred(t, place), bounds, ties))
        << described(t, ties);
  }
}

// Vertices as far apart as coordinates go, every sign of every bound: the pixels where edges pass.
TEST_F(TriangleKernel, TheLargestTriangles) {
  RandomPoints random(share_seed(3));
  const std::int64_t far = kLargestRaw;
  const auto extreme = [&] {
    const auto at = [&] {
      const std::int64_t base = random.below(3) * far - far;
      const std::int64_t raw = base + random.below(9) - 4;
      return Fixed::from_raw(std::clamp(raw, -far, far));
    };
    return Point{at(), at()};
  };
  const std::span<const TieRule> rules = all_tie_rules();
  for (int i = 0; i < kernel_scenes(200000); ++i) {
    const Triangle t{extreme(), extreme(), extreme()};
    const TieRule& ties = rules[static_cast<std::size_t>(random.below(10))];
    // In a corner of the largest target, or by the origin.
    const int x = random.below(2) * 8180, y = random.below(2) * 8180;
    const PixelBounds bounds{x, y, x + 6, y + 6};
    ASSERT_EQ(walked_triangle_pixels(t, bounds, ties), plain_pixels(t, bounds, ties))
        << described(t, ties);
    ASSERT_EQ(walked_tied_pixels(t, bounds), tied_triangle_pixels(t, bounds)) << described(t, ties);
  }
}

// The largest boxes that masks take, with vertices just within the next pixels.
TEST_F(TriangleKernel, TheLargestMasks) {
  RandomPoints random(share_seed(4));
  const std::span<const TieRule> rules = all_tie_rules();
  Canvas canvas(60, 80);
  const auto targets = kernel_targets();
  for (int i = 0; i < kernel_scenes(4000); ++i) {
    const auto near = [&](int pixel) {
      return Fixed::from_raw(Fixed::centre_of(pixel).raw() + random.below(65536) - 32768);
    };
    const int x = random.below(20), y = random.below(12);
    const Triangle t{Point{near(x), near(y)}, Point{near(x + 32), near(y + random.below(2) * 64)},
                     Point{near(x + random.below(2) * 32), near(y + 64)}};
    const TieRule& ties = rules[static_cast<std::size_t>(random.below(10))];
    use_kernel_target(targets[static_cast<std::size_t>(i) % targets.size()]);
    ASSERT_EQ(filled_pixels(canvas, t, ties, canvas.bounds()),
              plain_pixels(t, canvas.bounds(), ties))
        << described(t, ties);
  }
}

// Samples whose cross product with an edge is 0, 1 or -1: the nearest that a sample comes to an
// edge without lying on it.
TEST_F(TriangleKernel, NearestToAnEdge) {
  RandomPoints random(share_seed(7));
  const std::span<const TieRule> rules = all_tie_rules();
  Canvas canvas(12, 12);
  int covered = 0;
  const int count = kernel_scenes(100000);
  for (int i = 0; i < count; ++i) {
    const std::int64_t dx = 1 + random.below(1 << 19), dy = random.below(1 << 20) - (1 << 19);
    if (std::gcd(dx, dy) != 1) continue;
    const Point sample = pixel_centre(4 + random.below(4), 4 + random.below(4));
    const RawVector from_a = vector_with_turn(dx, dy, random.below(3) - 1);
    const Point a{Fixed::from_raw(sample.x.raw() - from_a.x),
                  Fixed::from_raw(sample.y.raw() - from_a.y)};
    const Point b{Fixed::from_raw(a.x.raw() + dx), Fixed::from_raw(a.y.raw() + dy)};
    ASSERT_LE(std::abs(cross(a, b, sample)), 1);
    const Triangle t{a, b, random.point(12, 4)};
    const TieRule& ties = rules[static_cast<std::size_t>(random.below(10))];
    const Pixels plain = plain_pixels(t, canvas.bounds(), ties);
    ASSERT_EQ(filled_pixels(canvas, t, ties, canvas.bounds()), plain) << described(t, ties);
    ASSERT_EQ(walked_triangle_pixels(t, canvas.bounds(), ties), plain) << described(t, ties);
    covered += triangle_covers(t, static_cast<int>(sample.x.floor()),
                               static_cast<int>(sample.y.floor()), ties);
  }
  EXPECT_GT(covered, count / 10);
}

// A tie bias that is off by one, either way, changes what the small grid covers: the tests above
// would see it.
TEST_F(TriangleKernel, AnotherTieRuleIsSeen) {
  const Triangle t{pixel_centre(1, 1), pixel_centre(5, 1), pixel_centre(1, 5)};
  Canvas canvas(8, 8);
  const TieRule& right = *find_tie_rule("left-bottom");
  const Pixels plain = plain_pixels(t, canvas.bounds(), right);
  EXPECT_EQ(filled_pixels(canvas, t, right, canvas.bounds()), plain);
  for (const char* wrong : {"open", "closed", "left-top", "right-bottom"})
    EXPECT_NE(filled_pixels(canvas, t, *find_tie_rule(wrong), canvas.bounds()), plain) << wrong;
}

}  // namespace
}  // namespace edgecase
