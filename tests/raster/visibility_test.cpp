// SPDX-License-Identifier: MIT
//
// What a depth test is for: of triangles that intersect, each pixel shows the nearest, whatever the
// order in which they are drawn; and a stencil counts the faces of a volume before a point.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "exact/rational.h"
#include "raster/rasterizer.h"
#include "tests/raster/operation_scenes.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

constexpr int kSize = 8;

// A vertex in the window, in eighths: x, y, and the depth, 0 to 8.
struct Corner {
  int x = 0;
  int y = 0;
  int z = 0;
};
using Corners = std::array<Corner, 3>;

Corner random_corner(RandomScenes& random) {
  return {random.below(8 * kSize + 1), random.below(8 * kSize + 1), random.below(9)};
}

// Twice the area, in 64ths of a pixel.
int area_of(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

// The depth of the triangle's plane at the centre of a pixel.
Rational depth_at(const Corners& t, int x, int y) {
  const Corner p{8 * x + 4, 8 * y + 4, 0};
  const Integer sum = Integer(area_of(t[1], t[2], p)) * t[0].z +
                      Integer(area_of(t[2], t[0], p)) * t[1].z +
                      Integer(area_of(t[0], t[1], p)) * t[2].z;
  return quotient_of(sum, Integer(area_of(t[0], t[1], t[2])) * 8);
}

Draw triangle(const Corners& corners, int number) {
  std::vector<Point> positions;
  for (const Corner& c : corners)
    positions.push_back(
        {Fixed::from_raw(c.x * Fixed::kOne / 8), Fixed::from_raw(c.y * Fixed::kOne / 8)});
  Draw draw = make_draw(Primitive::triangles, positions);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    draw.vertices[i].z = Fixed::from_raw((corners[i].z - 4) * Fixed::kOne / 4);
    draw.vertices[i].color = color_of_bytes(number + 1, 0, 0);
  }
  draw.operations.depth = {CompareFunction::less, true};
  return draw;
}

// Which draw a pixel shows; -1 for none.
int shown_at(const Rendering& rendering, int x, int y) {
  return rendering.pixels[4 * rendering.pixel_index(x, y)] - 1;
}

struct Pile {
  std::vector<Corners> triangles;
  Scene scene;
};

Pile random_pile(RandomScenes& random, DepthFormat format) {
  Pile pile;
  pile.scene = operation_scene(kSize, format, StencilFormat::none);
  while (pile.triangles.size() < 6) {
    const Corners corners = {random_corner(random), random_corner(random), random_corner(random)};
    if (area_of(corners[0], corners[1], corners[2]) == 0) continue;
    pile.scene.draws.push_back(triangle(corners, static_cast<int>(pile.triangles.size())));
    pile.triangles.push_back(corners);
  }
  return pile;
}

// The step of the buffer that is nearest to a depth.
Integer step_of(const Rational& depth, DepthFormat format) {
  const int largest = format == DepthFormat::depth16 ? 65535 : 16777215;
  return floor_of(depth * largest + Rational(1, 2));
}

// The nearest of the fragments at a pixel by their exact depths, as the buffer keeps them apart: of
// equal ones the first, or the last.
int nearest_at(const Pile& pile, const std::vector<int>& drawn, int x, int y, bool last_of_equal) {
  int nearest = -1;
  std::optional<Integer> least;
  for (int i : drawn) {
    const Integer step = step_of(depth_at(pile.triangles[static_cast<std::size_t>(i)], x, y),
                                 pile.scene.target.depth);
    const bool first_to_clear = !least && step < step_of(1, pile.scene.target.depth);
    if (!(first_to_clear || (least && (last_of_equal ? step <= *least : step < *least)))) continue;
    nearest = i;
    least = step;
  }
  return nearest;
}

std::vector<int> drawn_at(const Rendering& rendering, int x, int y) {
  std::vector<int> primitives;
  for (const Fragment& f : rendering.fragments)
    if (f.x == x && f.y == y) primitives.push_back(f.primitive);
  return primitives;
}

TEST(Visibility, EachPixelShowsTheNearestTriangle) {
  RandomScenes random(83);
  int crossings = 0;
  for (int round = 0; round < 300; ++round) {
    const Pile pile =
        random_pile(random, round % 2 == 0 ? DepthFormat::depth24 : DepthFormat::depth16);
    const Rendering rendering = rasterize(pile.scene, {});
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const std::vector<int> drawn = drawn_at(rendering, x, y);
        const int nearest = nearest_at(pile, drawn, x, y, false);
        ASSERT_EQ(shown_at(rendering, x, y), nearest) << round << ": " << x << ", " << y;
        crossings += !drawn.empty() && nearest != drawn.back();
      }
  }
  EXPECT_GT(crossings, 1000);
}

// One level for all: the first drawn stays under `less`, the last one under `lequal`.
TEST(Visibility, TiesFollowTheFunction) {
  RandomScenes random(84);
  for (int round = 0; round < 100; ++round) {
    Pile pile = random_pile(random, DepthFormat::depth24);
    for (std::size_t i = 0; i < pile.triangles.size(); ++i)
      for (std::size_t v = 0; v < 3; ++v) {
        pile.triangles[i][v].z = 3;
        pile.scene.draws[i].vertices[v].z = Fixed::from_raw(-Fixed::kOne / 4);
      }
    for (CompareFunction function : {CompareFunction::less, CompareFunction::lequal}) {
      for (Draw& draw : pile.scene.draws) draw.operations.depth.function = function;
      const Rendering rendering = rasterize(pile.scene, {});
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
          const std::vector<int> drawn = drawn_at(rendering, x, y);
          const int expected = drawn.empty()                       ? -1
                               : function == CompareFunction::less ? drawn.front()
                                                                   : drawn.back();
          ASSERT_EQ(shown_at(rendering, x, y), expected);
        }
    }
  }
}

bool has_ties(const Rendering& rendering) {
  for (std::size_t i = 1; i < rendering.fragments.size(); ++i)
    for (std::size_t k = i; k-- > 0;) {
      const Fragment &f = rendering.fragments[k], &g = rendering.fragments[i];
      if (f.x != g.x || f.y != g.y) break;
      if (static_cast<float>(f.depth) == static_cast<float>(g.depth)) return true;
    }
  return false;
}

TEST(Visibility, WithoutTiesTheOrderDoesNotMatter) {
  RandomScenes random(85);
  int compared = 0;
  for (int round = 0; round < 200; ++round) {
    Pile pile = random_pile(random, DepthFormat::depth32f);
    const Rendering first = rasterize(pile.scene, {});
    if (has_ties(first)) continue;
    ++compared;
    for (int order = 0; order < 4; ++order) {
      auto& draws = pile.scene.draws;
      std::swap(draws[static_cast<std::size_t>(random.below(6))],
                draws[static_cast<std::size_t>(random.below(6))]);
      std::rotate(draws.begin(), draws.begin() + 1 + random.below(5), draws.end());
      const Rendering other = rasterize(pile.scene, {});
      ASSERT_EQ(other.pixels, first.pixels);
      ASSERT_EQ(other.depths, first.depths);
    }
  }
  EXPECT_GT(compared, 100);
}

// ------------------------------------------------------------------------------ shadow volumes

using Tetrahedron = std::array<Corner, 4>;

// Six times the volume.
long volume_of(const Tetrahedron& t) {
  const auto way = [&](std::size_t i) {
    return std::array<long, 3>{t[i].x - t[0].x, t[i].y - t[0].y, t[i].z - t[0].z};
  };
  const auto a = way(1), b = way(2), c = way(3);
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// Four triangles that all run counter-clockwise seen from outside, which window depths that grow
// away from the viewer turn round.
std::array<Corners, 4> faces_of(Tetrahedron t) {
  if (volume_of(t) < 0) std::swap(t[2], t[3]);
  return {Corners{t[0], t[1], t[2]}, Corners{t[0], t[3], t[1]}, Corners{t[0], t[2], t[3]},
          Corners{t[1], t[3], t[2]}};
}

// Counts front faces up and back faces down; those before the wall, or those behind it the other
// way round.
Scene shadow_scene(const Tetrahedron& volume, bool before) {
  Scene scene = operation_scene(kSize);
  scene.target.clear_stencil = 254;  // counting wraps
  Draw wall = rectangle({0, 0, kSize, kSize}, 9.0 / 16, kBlue);
  wall.operations.depth.write = true;
  scene.draws = {wall};
  StencilFace up, down;
  (before ? up.pass : up.depth_fail) = StencilOperation::incr_wrap;
  (before ? down.pass : down.depth_fail) = StencilOperation::decr_wrap;
  for (const Corners& face : faces_of(volume)) {
    Draw draw = triangle(face, 1);
    draw.operations.depth = {CompareFunction::less, false};
    draw.operations.color_mask = {false, false, false, false};
    draw.operations.stencil = before ? StencilTest{up, down} : StencilTest{down, up};
    scene.draws.push_back(draw);
  }
  return scene;
}

// Is the wall's point at a pixel in the volume: before some face there and behind another?
bool is_inside(const Tetrahedron& volume, const Rendering& rendering, int x, int y) {
  const auto faces = faces_of(volume);
  bool before = false, behind = false;
  for (const Fragment& f : rendering.fragments) {
    if (f.x != x || f.y != y || f.primitive < 2) continue;  // the wall is two triangles
    const Rational depth = depth_at(faces[static_cast<std::size_t>(f.primitive - 2)], x, y);
    (depth < Rational(9, 16) ? behind : before) = true;
  }
  return before && behind;
}

TEST(Visibility, AStencilCountsTheFacesOfAVolume) {
  RandomScenes random(86);
  int lit = 0, shadowed = 0;
  for (int round = 0; round < 300; ++round) {
    const Tetrahedron volume = {random_corner(random), random_corner(random), random_corner(random),
                                random_corner(random)};
    if (volume_of(volume) == 0) continue;
    const Rendering passed = rasterize(shadow_scene(volume, true), {});
    const Rendering failed = rasterize(shadow_scene(volume, false), {});
    ASSERT_EQ(passed.stencils, failed.stencils);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const bool inside = is_inside(volume, passed, x, y);
        ASSERT_EQ(passed.stencils[passed.pixel_index(x, y)], inside ? 255 : 254)
            << round << ": " << x << ", " << y;
        ++(inside ? shadowed : lit);
      }
    EXPECT_TRUE(std::ranges::all_of(passed.pixels, [](int value) { return value % 255 == 0; }));
  }
  EXPECT_GT(shadowed, 500);
  EXPECT_GT(lit, 5000);
}

}  // namespace
}  // namespace edgecase
