// SPDX-License-Identifier: MIT
//
// Coverage of vertices given as clip coordinates, from scenes to pixels. Where the quotients are
// multiples of 2^-16, everything is drawn as from positions; where they are not, the pixels are all
// those of the target for which the predicate says so, and no search may miss one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/point_ownership.h"
#include "tests/support/causes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr int kSize = 8;

Scene empty_scene(Primitive primitive) {
  Scene scene;
  scene.target.width = kSize;
  scene.target.height = kSize;
  scene.viewport = {0, 0, kSize, kSize};
  Draw draw;
  draw.primitive = primitive;
  scene.draws = {draw};
  return scene;
}

class Random {
 public:
  int between(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }

  // A vertex whose window position is a multiple of 1/16, by clip coordinates with any w.
  Vertex exact_quotient() {
    const int x = between(0, 16 * kSize);
    const int y = between(0, 16 * kSize);
    constexpr float kW[] = {1, 3, 5, 7, 0.75F, 1000, 1.0F / 1024};
    const float w = kW[between(0, 6)];
    const auto clip = [&](int sixteenths) {
      return static_cast<float>(sixteenths - 8 * kSize) / (8 * kSize) * w;
    };
    Vertex vertex;
    vertex.position = {Fixed::from_raw(x * Fixed::kOne / 16),
                       Fixed::from_raw(y * Fixed::kOne / 16)};
    vertex.clip = ClipPosition{clip(x), clip(y), 0, w};
    vertex.w = w;
    return vertex;
  }

  // One whose position need not be a multiple of anything.
  Vertex quotient(const Viewport& viewport) {
    constexpr float kW[] = {3, 5, 7, 9, 1.25F, 3.1415927F};
    const float w = kW[between(0, 5)];
    const auto clip = [&] {
      return static_cast<float>(between(-64, 64)) / 64 * (between(0, 1) == 0 ? w : 1);
    };
    Vertex vertex;
    const float x = clip();
    vertex.clip = ClipPosition{x, clip(), 0, w};
    vertex.w = w;
    vertex.position = nearest_point(window_position(*vertex.clip, viewport));
    return vertex;
  }

 private:
  std::mt19937 random_{17};
};

Scene without_clip(Scene scene) {
  for (Vertex& vertex : scene.draws[0].vertices) {
    vertex.clip.reset();
    vertex.w = 1;
  }
  return scene;
}

// Policies that choose each alternative of each rule of coverage for once, with either row order.
std::vector<Policy> policies() {
  std::vector<Policy> result;
  for (const Rule& rule : all_rules())
    for (const Alternative& alternative : rule.alternatives)
      for (const char* rows : {"bottom-up", "top-down"}) {
        Policy policy;
        for (const char* kind : {"point", "line", "triangle"})
          policy.rules[std::string(kind) + ".row-order"] = rows;
        policy.rules[name_of(rule.id)] = alternative.name;
        result.push_back(policy);
      }
  return result;
}

std::vector<PixelPosition> covered(const Scene& scene, const Policy& policy) {
  const ScenePrimitive primitive = primitives_of(scene)[0];
  return covered_pixels(primitive, scene.target, resolve(policy, Surface::fbo).of(primitive.kind));
}

TEST(ClipCoordinates, AreDrawnAsThePositionsThatTheyGive) {
  Random random;
  const auto all = policies();
  Dealer dealer;
  std::size_t pixels = 0;
  for (int round = 0; round < 120; ++round)
    for (Primitive kind : {Primitive::points, Primitive::lines, Primitive::triangles}) {
      Scene scene = empty_scene(kind);
      Draw& draw = scene.draws[0];
      draw.point_size = draw.line_width = Fixed::from_raw(random.between(1, 10) * Fixed::kOne / 2);
      if (round % 2 == 0) draw.line_width = Fixed::from_integer(1);
      for (int i = 0; i < vertices_of(kind_of(kind)); ++i)
        draw.vertices.push_back(random.exact_quotient());
      // In every third scene the first vertex is given where it lands.
      if (round % 3 == 0 && draw.vertices.size() > 1) draw.vertices[0].clip.reset();
      for (const Policy& policy : all) {
        if (!dealer.deal()) continue;
        const auto drawn = covered(scene, policy);
        ASSERT_EQ(drawn, covered(without_clip(scene), policy)) << name_of(kind) << " " << round;
        pixels += drawn.size();
      }
    }
  EXPECT_GT(pixels, least_of(10000u));
}

// Under a choice that snaps, a quotient is drawn where it is snapped to.
TEST(ClipCoordinates, AreSnappedFromTheQuotient) {
  Random random;
  for (int round = 0; round < 300; ++round) {
    Scene scene = empty_scene(Primitive::triangles);
    scene.viewport = {0, 0, 7, 5};
    for (int i = 0; i < 3; ++i) scene.draws[0].vertices.push_back(random.quotient(scene.viewport));
    for (Snap snap : all_snaps()) {
      if (snap.is_none()) continue;
      Policy policy;
      policy.rules["subpixel.snap"] = name_of(snap);
      Scene snapped = without_clip(scene);
      const ScenePrimitive primitive = primitives_of(scene)[0];
      for (std::size_t i = 0; i < 3; ++i)
        snapped.draws[0].vertices[i].position = snap(primitive.positions[i]);
      ASSERT_EQ(covered(scene, policy), covered(snapped, {})) << name_of(snap);
    }
  }
}

// What the predicate of the kind says of one pixel, with rows from the bottom or from the top.
bool is_covered(const ScenePrimitive& primitive, PixelPosition pixel, const RuleChoices& choices,
                bool turned) {
  auto p = primitive.positions;
  if (turned) {
    pixel.y = kSize - 1 - pixel.y;
    for (HomogeneousPoint& point : p) point.y = kSize * point.w - point.y;
  }
  const Draw& draw = *primitive.state;
  if (primitive.kind == PrimitiveKind::point)
    return point_covers({p[0], draw.point_size}, pixel.x, pixel.y, choices.points.ties);
  if (primitive.kind == PrimitiveKind::triangle)
    return triangle_covers(p, pixel.x, pixel.y, choices.triangles.ties);
  // Of a wide line, some pixel of the line of width 1 lies less than the width below.
  const HomogeneousSegment segment{p[0], p[1]};
  const int width = rounded_width(draw.line_width);
  for (int i = 0; i < width; ++i) {
    const bool x_major = segment.x_major();
    if (diamond_exit_covers(lowest_segment(segment, width), x_major ? pixel.x : pixel.x - i,
                            x_major ? pixel.y - i : pixel.y, *choices.lines.line.boundary))
      return true;
  }
  return false;
}

TEST(ClipCoordinates, CoverEveryPixelOfTheTargetThatThePredicateNames) {
  Random random;
  std::size_t pixels = 0;
  for (int round = 0; round < 4000; ++round)
    for (Primitive kind : {Primitive::points, Primitive::lines, Primitive::triangles}) {
      Scene scene = empty_scene(kind);
      // Some positions are hidden by the target's border.
      scene.viewport = {random.between(-4, 1), random.between(-4, 1), random.between(5, 13), 11};
      Draw& draw = scene.draws[0];
      draw.point_size = draw.line_width = Fixed::from_integer(random.between(1, 5));
      for (int i = 0; i < vertices_of(kind_of(kind)); ++i)
        draw.vertices.push_back(random.quotient(scene.viewport));
      const ScenePrimitive primitive = primitives_of(scene)[0];
      for (const char* rows : {"bottom-up", "top-down"}) {
        Policy policy;
        for (const char* name : {"point", "line", "triangle"})
          policy.rules[std::string(name) + ".row-order"] = rows;
        std::vector<PixelPosition> expected;
        for (int y = 0; y < kSize; ++y)
          for (int x = 0; x < kSize; ++x)
            if (is_covered(primitive, {x, y}, resolve(policy, Surface::fbo),
                           rows == std::string("top-down")))
              expected.push_back({x, y});
        ASSERT_EQ(covered(scene, policy), expected) << name_of(kind) << " " << round << rows;
        pixels += expected.size();
      }
    }
  EXPECT_GT(pixels, 10000u);
}

// What is less than 2^-16 off a tie is no tie.
TEST(ClipCoordinates, AreNotRoundedBeforeTheyDecide) {
  Scene scene = empty_scene(Primitive::points);
  Vertex vertex;
  const float w = 3;
  vertex.clip = ClipPosition{-0.75F, 0.375F, 0, w};
  vertex.w = w;
  vertex.position = nearest_point(window_position(*vertex.clip, scene.viewport));
  scene.draws[0].vertices = {vertex};
  // Exactly x = 3: the centres at 2.5 and 3.5 tie, right-top owns the one to the right.
  EXPECT_EQ(covered(scene, {}), (std::vector<PixelPosition>{{3, 4}}));
  // The next number below: x lies less than 2^-20 to the left, where 2^-16 sees nothing.
  scene.draws[0].vertices[0].clip->x = std::nextafter(-0.75F, -1.0F);
  ASSERT_EQ(nearest_point(primitives_of(scene)[0].positions[0]), vertex.position);
  EXPECT_EQ(covered(scene, {}), (std::vector<PixelPosition>{{2, 4}}));
}

}  // namespace
}  // namespace edgecase
