// SPDX-License-Identifier: MIT
//
// Lines by their walk hold exactly the pixels that diamond_exit_covers has: all segments of a small
// grid, random ones on every grid, and the longest there are.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "kernels/kernels.h"
#include "rules/coverage/diamond_exit.h"
#include "tests/kernels/kernel_canvas.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

// Those whose diamonds have no boundary of their own.
std::span<const DiamondBoundary> perturbed_boundaries() {
  return all_diamond_boundaries().first(8);
}

Pixels plain_pixels(const Segment& s, const PixelBounds& bounds, const DiamondBoundary& boundary) {
  return pixels_where(bounds, [&](int x, int y) { return diamond_exit_covers(s, x, y, boundary); });
}

Pixels sorted(Pixels pixels) {
  std::sort(pixels.begin(), pixels.end(),
            [](PixelPosition a, PixelPosition b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  return pixels;
}

Pixels filled_pixels(Canvas& canvas, const Segment& s, const TieRule& ties) {
  const FlatLine line{raw_point(s.a), raw_point(s.b), 7};
  fill_lines({{&canvas.plane(), 1}, {&kCentrePlace, 1}, canvas.bounds()}, {&line, 1},
             weights_of(ties));
  return canvas.take();
}

void expect_same(const Segment& s, const PixelBounds& bounds, const DiamondBoundary& boundary) {
  ASSERT_EQ(sorted(walked_line_pixels(s, bounds, *boundary.ties)),
            plain_pixels(s, bounds, boundary))
      << boundary.name << ": " << explain_line(s, 0, 0, boundary).text;
}

// Quarters of a pixel: corners, edges and centres of diamonds are all on the grid.
TEST(LineKernel, EverySegmentOfASmallGrid) {
  constexpr int kSide = 17, kPoints = kSide * kSide;
  const auto point = [](int i) {
    const auto at = [](int n) { return Fixed::from_raw((n - 2) * Fixed::kOne / 4); };
    return Point{at(i % kSide), at(i / kSide)};
  };
  const PixelBounds bounds{0, 0, 3, 3};
  for (int i = 0; i < kPoints * kPoints; ++i) {
    if (!is_in_share(static_cast<std::uint64_t>(i))) continue;
    const Segment s{point(i % kPoints), point(i / kPoints)};
    for (const DiamondBoundary& boundary : perturbed_boundaries())
      ASSERT_NO_FATAL_FAILURE(expect_same(s, bounds, boundary));
  }
}

TEST(LineKernel, RandomSegmentsOfEveryGrid) {
  RandomPoints random(share_seed(5));
  for (int i = 0; i < kernel_scenes(150000); ++i) {
    const int size = i % 4 != 0 ? 1 + random.below(12) : 1 + random.below(50);
    const int bits = random.below(17);
    const Segment s{random.point(size, bits), random.point(size, bits)};
    const DiamondBoundary& boundary = perturbed_boundaries()[static_cast<std::size_t>(i) % 8];
    Canvas canvas(size, size);
    ASSERT_NO_FATAL_FAILURE(expect_same(s, canvas.bounds(), boundary));
    if (i % 16 != 0) continue;
    ASSERT_EQ(filled_pixels(canvas, s, *boundary.ties), plain_pixels(s, canvas.bounds(), boundary));
    ASSERT_FALSE(canvas.has_spilled());
  }
}

// Heights at a column's centre that are a whole number, or off by the least there is.
TEST(LineKernel, NearestToTheBorderOfRows) {
  RandomPoints random(share_seed(8));
  const PixelBounds bounds{0, 0, 15, 15};
  for (int i = 0; i < kernel_scenes(60000); ++i) {
    const std::int64_t run = 1 + random.below(1 << 20);
    const std::int64_t rise = random.below(static_cast<int>(2 * run + 1)) - run;
    if (std::gcd(run, rise) != 1) continue;
    const RawVector from_a = vector_with_turn(run, rise, random.below(3) - 1);
    const std::int64_t border = (4 + random.below(8)) * Fixed::kOne;
    const std::int64_t centre = Fixed::centre_of(4 + random.below(8)).raw();
    const Point a{Fixed::from_raw(centre - from_a.x), Fixed::from_raw(border - from_a.y)};
    const Point b{Fixed::from_raw(a.x.raw() + run), Fixed::from_raw(a.y.raw() + rise)};
    const auto turned = [&](Point p) { return i % 2 == 0 ? p : Point{p.y, p.x}; };
    const Segment s = i % 4 < 2 ? Segment{turned(a), turned(b)} : Segment{turned(b), turned(a)};
    ASSERT_NO_FATAL_FAILURE(
        expect_same(s, bounds, perturbed_boundaries()[static_cast<std::size_t>(i) % 8]));
  }
}

// As far out as coordinates go, in a strip of the window that the line passes: at its borders, at
// its middle, and where a target's own border is.
TEST(LineKernel, TheLongestSegments) {
  RandomPoints random(share_seed(6));
  const std::int64_t far = kLargestRaw;
  for (int i = 0; i < kernel_scenes(100000); ++i) {
    const auto extreme = [&] {
      const auto at = [&] {
        const std::int64_t raw = (random.below(3) - 1) * far + random.below(131072) - 65536;
        return Fixed::from_raw(std::clamp(raw, -far, far));
      };
      return Point{at(), at()};
    };
    const Segment s{extreme(), extreme()};
    constexpr std::array kCorners{-8192, -2, 0, 8184};
    const int x = kCorners[static_cast<std::size_t>(random.below(4))];
    const int y = kCorners[static_cast<std::size_t>(random.below(4))];
    const PixelBounds bounds{x, y, x + 7, y + 7};
    ASSERT_NO_FATAL_FAILURE(
        expect_same(s, bounds, perturbed_boundaries()[static_cast<std::size_t>(i) % 8]));
  }
}

// A pixel each column, in ascending order, and a diagonal through corners is not drawn twice.
TEST(LineKernel, WalksUpward) {
  const Segment s{pixel_centre(9, 2), pixel_centre(1, 6)};
  const Pixels pixels = walked_line_pixels(s, {0, 0, 9, 9}, *find_tie_rule("left-bottom"));
  ASSERT_EQ(pixels.size(), 8u);
  for (std::size_t i = 1; i < pixels.size(); ++i) EXPECT_EQ(pixels[i].x, pixels[i - 1].x + 1);
}

}  // namespace
}  // namespace edgecase
