// SPDX-License-Identifier: MIT
//
// Grid lines: every line once up to whole pixels, held against all segments of small targets.
#include "generate/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>

#include "tests/generate/scene_checks.h"

namespace edgecase {
namespace {

using Ends = std::array<std::int64_t, 4>;  // x and y of the start, then of the end, raw

Ends ends_of(const std::array<Point, 2>& line) {
  return {line[0].x.raw(), line[0].y.raw(), line[1].x.raw(), line[1].y.raw()};
}

// As near to the origin as whole pixels bring it, no end upon an axis.
Ends moved(Ends ends) {
  for (const std::size_t axis : {0u, 1u}) {
    const std::int64_t least = std::min(ends[axis], ends[axis + 2]);
    const std::int64_t by = (least - 1) / Fixed::kOne * Fixed::kOne;
    ends[axis] -= by;
    ends[axis + 2] -= by;
  }
  return ends;
}

TEST(GridLines, AreAllSegmentsUpToWholePixels) {
  constexpr std::array<std::array<int, 2>, 4> kGrids{{{2, 1}, {2, 2}, {2, 4}, {3, 2}}};
  for (const auto& [size, steps] : kGrids) {
    const std::int64_t step = Fixed::kOne / steps, end = size * Fixed::kOne;
    std::set<Ends> all;
    for (std::int64_t ax = step; ax < end; ax += step)
      for (std::int64_t ay = step; ay < end; ay += step)
        for (std::int64_t bx = step; bx < end; bx += step)
          for (std::int64_t by = step; by < end; by += step) all.insert(moved({ax, ay, bx, by}));
    const GridLines lines(size, steps);
    std::set<Ends> ours, strewn;
    for (std::uint64_t i = 0; i < lines.count(); ++i) {
      ours.insert(ends_of(lines.line(i)));
      strewn.insert(ends_of(lines.line(lines.strewn(7, i))));
    }
    EXPECT_EQ(ours, all) << size << " pixels, " << steps << " steps";
    EXPECT_EQ(strewn, all);
    EXPECT_EQ(lines.count(), all.size());
  }
}

TEST(GridLines, AreStrewn) {
  // Of the first thousand, a tenth starts in any tenth of all.
  std::array<int, 10> tenths{};
  for (std::uint64_t i = 0; i < 1000; ++i)
    ++tenths[kReadableLines.strewn(1, i) * 10 / kReadableLines.count()];
  for (const int count : tenths) EXPECT_NEAR(count, 100, 5);
  EXPECT_NE(kReadableLines.strewn(1, 0), kReadableLines.strewn(2, 0));
  EXPECT_EQ(kReadableLines.strewn(1, kReadableLines.count() + 3), kReadableLines.strewn(1, 3));
}

TEST(GridLines, ScenesHoldThemOneAfterAnother) {
  EXPECT_EQ(kReadableLines.count(), 7904u * 7904u);
  EXPECT_EQ(grid_line_scenes(), 1'952'288u);
  for (const std::uint64_t index : {std::uint64_t{0}, std::uint64_t{77}, grid_line_scenes() - 1}) {
    const Scene scene = grid_line_scene(5, Surface::window, index);
    EXPECT_EQ(fault_of(scene), "");
    EXPECT_EQ(scene.target.surface, Surface::window);
    const auto& vertices = scene.draws.at(0).vertices;
    ASSERT_EQ(vertices.size(), 2 * kGridLinesOfScene);
    for (std::uint64_t i = 0; i < kGridLinesOfScene; ++i) {
      const auto line =
          kReadableLines.line(kReadableLines.strewn(5, index * kGridLinesOfScene + i));
      EXPECT_EQ(vertices[2 * i].position, line[0]);
      EXPECT_EQ(vertices[2 * i + 1].position, line[1]);
    }
    const Scene wide = wide_grid_line_scene(5, Surface::window, index);
    EXPECT_EQ(wide.target.surface, Surface::window);
    for (const Draw& draw : wide.draws) EXPECT_EQ(draw.line_width, Fixed::from_integer(2));
  }
}

TEST(GridLines, OfFourSamplesAreOneInAScene) {
  EXPECT_EQ(multisampled_grid_line_scenes(), kReadableLines.count());
  const std::uint64_t index = 4711;
  const Scene scene = multisampled_grid_line_scene(5, Surface::window, index);
  EXPECT_EQ(fault_of(scene), "");
  EXPECT_EQ(scene.target.samples, 4);
  EXPECT_EQ(scene.target.surface, Surface::fbo);
  const auto line = kReadableLines.line(kReadableLines.strewn(5, index));
  ASSERT_EQ(scene.draws.at(0).vertices.size(), 2u);
  EXPECT_EQ(scene.draws[0].vertices[0].position, line[0]);
  EXPECT_EQ(scene.draws[0].vertices[1].position, line[1]);
}

}  // namespace
}  // namespace edgecase
