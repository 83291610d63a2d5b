// SPDX-License-Identifier: MIT
//
// What stands between the predicates and a rendering: the scissor rectangle, the part of the target
// that is searched, the order of pixels, and what a policy's words come to.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <tuple>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

using Pixels = std::vector<PixelPosition>;

Target target_of(int width, int height) {
  Target target;
  target.width = width;
  target.height = height;
  return target;
}

Draw draw_of(Primitive primitive, std::initializer_list<Point> points) {
  Draw draw;
  draw.primitive = primitive;
  for (Point p : points) {
    Vertex vertex;
    vertex.position = p;
    draw.vertices.push_back(vertex);
  }
  return draw;
}

Pixels covered(const Draw& draw, const Target& target, const Policy& policy = {}) {
  Scene scene;
  scene.target = target;
  scene.draws = {draw};
  const auto primitives = primitives_of(scene);
  return covered_pixels(primitives.at(0), target,
                        resolve(policy, target.surface).of(primitives.at(0).kind));
}

bool is_row_by_row(const Pixels& pixels) {
  return std::is_sorted(pixels.begin(), pixels.end(), [](PixelPosition a, PixelPosition b) {
    return std::tie(a.y, a.x) < std::tie(b.y, b.x);
  });
}

// ------------------------------------------------------------------------------------- scissor

TEST(DrawableBounds, AreTheTargetWithinTheScissor) {
  Draw draw;
  const Target target = target_of(20, 10);
  const auto bounds = [&](Viewport scissor) {
    draw.scissor = scissor;
    const PixelBounds b = drawable_bounds(draw, target);
    return std::tuple(b.x_min, b.y_min, b.x_max, b.y_max);
  };
  EXPECT_EQ(bounds({3, 2, 5, 4}), std::tuple(3, 2, 7, 5));
  EXPECT_EQ(bounds({-4, -3, 9, 7}), std::tuple(0, 0, 4, 3));
  EXPECT_EQ(bounds({15, 6, 90, 90}), std::tuple(15, 6, 19, 9));
  EXPECT_EQ(bounds({-5, -5, 90, 90}), std::tuple(0, 0, 19, 9));
  // Without size: no pixel.
  EXPECT_EQ(bounds({4, 4, 0, 0}), std::tuple(4, 4, 3, 3));
  draw.scissor.reset();
  EXPECT_EQ(drawable_bounds(draw, target).x_max, 19);
  EXPECT_EQ(drawable_bounds(draw, target).y_max, 9);
}

// ------------------------------------------------------------------------ the part that is
// searched

TEST(CoveredPixels, OfAPointAreAllThatItsSquareHolds) {
  const Target target = target_of(80, 70);
  std::mt19937_64 random(11);
  const auto coordinate = [&](int low, int high) {
    return Fixed::from_raw(
        std::uniform_int_distribution<std::int64_t>(low * Fixed::kOne, high * Fixed::kOne)(random));
  };
  for (int i = 0; i < 200; ++i) {
    Draw draw = draw_of(Primitive::points, {{coordinate(-8, 88), coordinate(-8, 78)}});
    // Whole sizes, sizes with a fraction, and the greatest; vertices on the grid that makes ties.
    draw.point_size = i % 3 == 0   ? Fixed::from_integer(1 + i % 64)
                      : i % 3 == 1 ? coordinate(1, 64)
                                   : Fixed::from_integer(64);
    if (i % 2 == 0) {
      Point& p = draw.vertices[0].position;
      p = {Fixed::from_raw(p.x.raw() / (Fixed::kOne / 2) * (Fixed::kOne / 2)),
           Fixed::from_raw(p.y.raw() / (Fixed::kOne / 2) * (Fixed::kOne / 2))};
    }
    for (const char* ties : {"right-top", "left-bottom", "closed"}) {
      Policy policy;
      policy.rules = {{"point.ownership", ties}};
      Pixels expected;
      for (int y = 0; y < target.height; ++y)
        for (int x = 0; x < target.width; ++x)
          if (point_covers({draw.vertices[0].position, draw.point_size}, x, y,
                           *find_tie_rule(ties)))
            expected.push_back({x, y});
      ASSERT_EQ(covered(draw, target, policy), expected) << i << ties;
    }
  }
}

TEST(CoveredPixels, OfATriangleAreAllThatItHolds) {
  const Target target = target_of(24, 20);
  std::mt19937_64 random(12);
  // Quarters of pixels, some of them far outside the target.
  const auto coordinate = [&](int limit) {
    return Fixed::from_raw(std::uniform_int_distribution<std::int64_t>(-limit, limit)(random) *
                           Fixed::kOne / 4);
  };
  for (int i = 0; i < 600; ++i) {
    const int limit = i % 5 == 0 ? 4 * 8192 : i % 5 == 1 ? 12 : 120;
    Triangle t;
    for (Point& p : t) p = {coordinate(limit), coordinate(limit)};
    const Draw draw = draw_of(Primitive::triangles, {t[0], t[1], t[2]});
    for (const char* ties : {"left-top", "right-bottom", "closed"}) {
      Policy policy;
      policy.rules = {{"triangle.fill-rule", ties}};
      Pixels expected;
      for (int y = 0; y < target.height; ++y)
        for (int x = 0; x < target.width; ++x)
          if (triangle_covers(t, x, y, *find_tie_rule(ties))) expected.push_back({x, y});
      ASSERT_EQ(covered(draw, target, policy), expected) << i << ties;
    }
  }
}

TEST(CoveredPixels, ComeRowByRowUnderEveryAlgorithm) {
  const Target target = target_of(12, 12);
  Draw line = draw_of(Primitive::lines, {at(2.25, 10.5), at(9.5, 1.25)});
  for (const int width : {1, 3})
    for (const Alternative& algorithm : find_rule("line.algorithm")->alternatives)
      for (const Alternative& wide : find_rule("line.width")->alternatives) {
        line.line_width = Fixed::from_integer(width);
        Policy policy;
        policy.rules = {{"line.algorithm", algorithm.name}, {"line.width", wide.name}};
        const Pixels pixels = covered(line, target, policy);
        EXPECT_GT(pixels.size(), 4u) << algorithm.name << wide.name;
        EXPECT_TRUE(is_row_by_row(pixels)) << algorithm.name << wide.name;
      }
  const Draw triangle =
      draw_of(Primitive::triangles, {at(1.25, 1.5), at(11, 3.25), at(4.5, 10.75)});
  for (const Alternative& algorithm : find_rule("triangle.algorithm")->alternatives) {
    Policy policy;
    policy.rules = {{"triangle.algorithm", algorithm.name}};
    EXPECT_GT(covered(triangle, target, policy).size(), 20u);
    EXPECT_TRUE(is_row_by_row(covered(triangle, target, policy))) << algorithm.name;
  }
}

// ------------------------------------------------------------------------------------- policies

TEST(Policies, SayHowWideAWideLineIs) {
  Draw line = draw_of(Primitive::lines, {at(2.5, 5.5), at(9.5, 5.5)});
  line.line_width = Fixed::from_integer(3);
  Policy policy;
  EXPECT_EQ(covered(line, target_of(12, 12), policy).size(), 21u);
  // Replicated, 1.5 is rounded to 2; a rectangle as high as that holds one row of centres.
  line.line_width = Fixed::from_raw(3 * Fixed::kOne / 2);
  EXPECT_EQ(covered(line, target_of(12, 12), policy).size(), 14u);
  policy.rules = {{"line.width", "rectangle"}};
  EXPECT_EQ(covered(line, target_of(12, 12), policy).size(), 7u);
}

TEST(Policies, SayWhereAPointLies) {
  const Draw point = draw_of(Primitive::points, {at(2.9375, 3.0625)});
  EXPECT_EQ(covered(point, target_of(8, 8)), (Pixels{{2, 3}}));
  Policy policy;
  policy.rules = {{"point.offset", "right-down"}};
  EXPECT_EQ(covered(point, target_of(8, 8), policy), (Pixels{{3, 2}}));
}

TEST(Policies, SayWhatClipsAPoint) {
  Draw point = draw_of(Primitive::points, {at(0, 3.5), at(4.5, 3.5)});
  point.point_size = Fixed::from_integer(3);
  const auto drawn = [&](const char* alternative) {
    Scene scene;
    scene.target = target_of(8, 8);
    scene.viewport = Viewport{0, 0, 5, 8};
    scene.draws = {point};
    Policy policy;
    policy.rules = {{"point.clip", alternative}};
    std::set<int> columns;
    for (const Fragment& fragment : rasterize(scene, policy).fragments) columns.insert(fragment.x);
    return columns;
  };
  // The first vertex lies on the viewport's left side, the second half a pixel within its right.
  EXPECT_EQ(drawn("as-set"), (std::set{0, 1, 3, 4, 5}));
  EXPECT_EQ(drawn("border-dropped"), (std::set{3, 4, 5}));
  EXPECT_EQ(drawn("cut-at-viewport"), (std::set{0, 1, 3, 4}));
}

TEST(Policies, SayWhichVertexProvokesAndHowLinesAreShaded) {
  Scene scene;
  scene.target = target_of(8, 8);
  Draw line = draw_of(Primitive::lines, {at(0.5, 0.5), at(6.5, 3.5)});
  line.vertices[0].color = {0, 0, 0, 1};
  line.vertices[1].color = {1, 1, 1, 1};
  line.provoking_vertex = ProvokingVertex::first;
  scene.draws = {line};
  const auto red = [&](const char* rule, const char* alternative) {
    Policy policy;
    policy.rules = {{rule, alternative}};
    return rasterize(scene, policy).fragments.at(1).color[0];
  };
  EXPECT_EQ(red("attribute.provoking-vertex", "as-set"), 0);
  EXPECT_EQ(red("attribute.provoking-vertex", "first"), 0);
  EXPECT_EQ(red("attribute.provoking-vertex", "last"), 1);
  scene.draws[0].provoking_vertex = ProvokingVertex::last;
  EXPECT_EQ(red("attribute.provoking-vertex", "as-set"), 1);
  EXPECT_EQ(red("attribute.provoking-vertex", "first"), 0);
  scene.draws[0].interpolation = Interpolation::smooth;
  // Pixel (1, 1) lies 1/2 above the line: (6 + 3) / 45 along it, 1/6 of the way in x.
  EXPECT_EQ(rasterize(scene, {}).fragments.at(1).x, 1);
  EXPECT_EQ(rasterize(scene, {}).fragments.at(1).y, 1);
  EXPECT_NEAR(red("attribute.smooth", "projection"), 9.0 / 45, 1e-12);
  EXPECT_NEAR(red("attribute.smooth", "major-axis"), 1.0 / 6, 1e-12);
}

TEST(Policies, SayHowTrianglesAreScanned) {
  // Legs through centres: by edge functions the left one is drawn, by scanning the bottom one is.
  const Draw draw = draw_of(Primitive::triangles, {at(0.5, 0.5), at(4.5, 0.5), at(0.5, 4.5)});
  const Target target = target_of(8, 8);
  const auto by = [&](const char* algorithm) {
    Policy policy;
    policy.rules = {{"triangle.algorithm", algorithm}};
    return covered(draw, target, policy);
  };
  EXPECT_EQ(by("edge-functions"), covered(draw, target));
  EXPECT_NE(by("scan"), covered(draw, target));
  // A square of two triangles: its right and bottom sides are drawn, and neither left nor top.
  const Draw square = draw_of(Primitive::triangles, {at(1.5, 1.5), at(4.5, 1.5), at(4.5, 4.5),
                                                     at(1.5, 1.5), at(4.5, 4.5), at(1.5, 4.5)});
  Policy scan;
  scan.rules = {{"triangle.algorithm", "scan"}};
  std::set<int> columns, rows;
  for (const PixelPosition p : covered(square, target, scan)) {
    columns.insert(p.x);
    rows.insert(p.y);
  }
  EXPECT_EQ(columns, (std::set{2, 3, 4}));
  EXPECT_EQ(rows, (std::set{1, 2, 3}));
}

// A target seen upside down: the scissor rectangle turns with it, and nothing leaves it.
TEST(Policies, TurnTheScissorWithTheRows) {
  const Target target = target_of(12, 16);
  Draw draws[] = {draw_of(Primitive::triangles, {at(0.25, 0.25), at(11.75, 1.25), at(2.25, 15.75)}),
                  draw_of(Primitive::lines, {at(1.25, 0.25), at(6.75, 15.25)}),
                  draw_of(Primitive::points, {at(5.25, 7.25)})};
  draws[2].point_size = Fixed::from_integer(9);
  for (Draw& draw : draws) {
    const Pixels all = covered(draw, target);
    draw.scissor = Viewport{2, 1, 6, 9};
    Pixels expected;
    for (PixelPosition p : all)
      if (p.x >= 2 && p.x < 8 && p.y >= 1 && p.y < 10) expected.push_back(p);
    EXPECT_GT(expected.size(), 6u);
    for (const char* rows : {"bottom-up", "top-down"}) {
      Policy policy;
      for (const char* kind : {"point", "line", "triangle"})
        policy.rules[std::string(kind) + ".row-order"] = rows;
      EXPECT_EQ(covered(draw, target, policy), expected) << rows;
    }
  }
}

// ------------------------------------------------------------------------------------- renderings

TEST(Rasterize, MakesARenderingOfTheTargetsSize) {
  Scene scene;
  scene.target = target_of(5, 3);
  scene.target.samples = 4;
  scene.target.clear = {1, 0, 0.2f, 1};
  scene.draws = {draw_of(Primitive::points, {at(1.5, 1.5)})};
  const Rendering rendering = rasterize(scene, {});
  EXPECT_EQ(rendering.width, 5);
  EXPECT_EQ(rendering.height, 3);
  EXPECT_EQ(rendering.samples, 4);
  EXPECT_EQ(rendering.pixels.size(), 60u);
  EXPECT_EQ(rendering.sample_pixels.size(), 240u);
  EXPECT_EQ(rendering.hits.size(), 60u);
  for (std::size_t pixel : {0u, 14u}) {
    EXPECT_EQ(rendering.pixels[4 * pixel], 255);
    EXPECT_EQ(rendering.pixels[4 * pixel + 1], 0);
    EXPECT_EQ(rendering.pixels[4 * pixel + 2], 51);
    EXPECT_EQ(rendering.pixels[4 * pixel + 3], 255);
  }
  scene.target.samples = 1;
  EXPECT_EQ(rasterize(scene, {}).hits.size(), 15u);
  EXPECT_TRUE(rasterize(scene, {}).sample_pixels.empty());
}

TEST(ExactRendererInfo, NamesNoDeviceButItself) {
  const RendererInfo info = ExactRenderer(Policy{}).info();
  EXPECT_EQ(info.vendor, "Edgecase");
  EXPECT_EQ(info.device, "exact rasterizer");
}

}  // namespace
}  // namespace edgecase
