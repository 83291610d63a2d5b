// SPDX-License-Identifier: MIT
//
// Attributes of wide lines: each fragment of a column has those of the column's lowest, as the line
// moved by -(w - 1)/2 has them there (GL 4.6 core, 14.5.2.2); depth and gl_FragCoord are its own.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr int kSize = 24;

Scene line_scene(Point a, Point b, double width) {
  Scene scene = blank_scene(kSize, kSize);
  const Point ends[] = {a, b};
  Draw draw = make_draw(Primitive::lines, ends);
  draw.interpolation = Interpolation::smooth;
  draw.line_width = at(width, 0).x;
  scene.draws = {draw};
  return scene;
}

struct Slanted {
  Point a, b;
  bool x_major;
};
const Slanted kLines[] = {{at(3.25, 9.5), at(20.75, 12.25), true},
                          {at(20.5, 13.75), at(4.25, 6.5), true},
                          {at(9.5, 3.25), at(12.25, 20.75), false},
                          {at(4.5, 4.5), at(18.5, 18.5), true}};

const Fragment* fragment_in(const Rendering& rendering, int x, int y) {
  const auto found = std::ranges::find_if(rendering.fragments,
                                          [&](const Fragment& f) { return f.x == x && f.y == y; });
  return found != rendering.fragments.end() ? &*found : nullptr;
}

TEST(WideLineValues, AreThoseOfTheAdjustedLine) {
  for (const auto& [a, b, x_major] : kLines)
    for (const int width : {2, 3, 4, 7}) {
      const Rendering wide = rasterize(line_scene(a, b, width), {});
      const double down = (width - 1) / 2.0;
      const Point move = x_major ? at(0, down) : at(down, 0);
      const Rendering thin =
          rasterize(line_scene({a.x - move.x, a.y - move.y}, {b.x - move.x, b.y - move.y}, 1), {});
      ASSERT_EQ(wide.fragments.size(), thin.fragments.size() * static_cast<std::size_t>(width));
      for (const Fragment& lowest : thin.fragments)
        for (int i = 0; i < width; ++i) {
          const Fragment* const copy = x_major ? fragment_in(wide, lowest.x, lowest.y + i)
                                               : fragment_in(wide, lowest.x + i, lowest.y);
          ASSERT_NE(copy, nullptr);
          for (std::size_t c = 0; c < 4; ++c)
            EXPECT_NEAR(copy->color[c], lowest.color[c], 1e-12) << width << " " << i;
        }
    }
}

TEST(WideLineValues, DepthsAreOfEachOwnCentre) {
  const Scene scene = line_scene(kLines[0].a, kLines[0].b, 5);
  const Draw& draw = scene.draws.front();
  const auto number = [](Fixed value) { return value.to_double(); };
  const double ax = number(kLines[0].a.x), ay = number(kLines[0].a.y);
  const double dx = number(kLines[0].b.x) - ax, dy = number(kLines[0].b.y) - ay;
  for (const Fragment& f : rasterize(scene, {}).fragments) {
    const double t = ((f.x + 0.5 - ax) * dx + (f.y + 0.5 - ay) * dy) / (dx * dx + dy * dy);
    const double z = (1 - t) * number(draw.vertices[0].z) + t * number(draw.vertices[1].z);
    EXPECT_NEAR(f.depth, (z + 1) / 2, 1e-12);
  }
}

// The column goes on where nothing of it is seen.
TEST(WideLineValues, AreTheSameWhereABorderCutsTheColumn) {
  const Rendering whole = rasterize(line_scene(at(3.25, 9.5), at(20.75, 12.25), 7), {});
  const Rendering cut = rasterize(line_scene(at(3.25, 1.5), at(20.75, 4.25), 7), {});
  ASSERT_LT(cut.fragments.size(), whole.fragments.size());
  for (const Fragment& f : cut.fragments) {
    const Fragment* const other = fragment_in(whole, f.x, f.y + 8);
    ASSERT_NE(other, nullptr);
    for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(f.color[c], other->color[c], 1e-12);
  }
  Scene scissored = line_scene(at(3.25, 9.5), at(20.75, 12.25), 7);
  scissored.draws.front().scissor = Viewport{0, 10, kSize, 2};
  for (const Fragment& f : rasterize(scissored, {}).fragments)
    EXPECT_EQ(f.color, fragment_in(whole, f.x, f.y)->color);
}

TEST(WideLineValues, OfAreasAndThinLinesAreOfEachOwnCentre) {
  const auto rows_differ = [](double width, const char* wide) {
    Policy policy;
    policy.rules["line.width"] = wide;
    const Rendering drawn = rasterize(line_scene(kLines[0].a, kLines[0].b, width), policy);
    const Fragment& first = drawn.fragments[drawn.fragments.size() / 2];
    const Fragment* const above = fragment_in(drawn, first.x, first.y + 1);
    const Fragment* const below = fragment_in(drawn, first.x, first.y - 1);
    const Fragment* const other = above != nullptr ? above : below;
    return other != nullptr && other->color != first.color;
  };
  EXPECT_FALSE(rows_differ(5, "replicate"));
  EXPECT_TRUE(rows_differ(5, "rectangle"));
}

// A target that is seen upside down has its columns the other way up, and the same middle of them.
TEST(WideLineValues, AreTheSameWhicheverWayRowsAreCounted) {
  Policy turned;
  turned.rules["line.row-order"] = "top-down";
  for (const auto& [a, b, x_major] : kLines)
    for (const int width : {3, 4}) {
      const Rendering up = rasterize(line_scene(a, b, width), {});
      for (const Fragment& f : rasterize(line_scene(a, b, width), turned).fragments) {
        const Fragment* const same = fragment_in(up, f.x, f.y);
        if (same == nullptr) continue;
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_NEAR(f.color[c], same->color[c], width % 2 == 0 ? 0.1 : 1e-12);
      }
    }
}

}  // namespace
}  // namespace edgecase
