// SPDX-License-Identifier: MIT
//
// Whole scenes of random primitives against the oracles: fragments, hit counts, pixels and colours,
// under every one of the eight tie orders. What rasterize() should draw is put together here once
// more, from the oracles' answers and from the bytes that colours were made of.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>

#include "raster/rasterizer.h"
#include "tests/oracles/oracles.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr const char* kOrders[] = {"left-bottom", "left-top",     "right-bottom", "right-top",
                                   "bottom-left", "bottom-right", "top-left",     "top-right"};

// The move that an order's name stands for: the sample moves away from the side that owns.
oracle::Move move_named(const std::string& order) {
  oracle::Move move{};
  int size = 1;
  for (const std::string& word :
       {order.substr(0, order.find('-')), order.substr(order.find('-') + 1)}) {
    if (word == "left") move.x = size;
    if (word == "right") move.x = -size;
    if (word == "bottom") move.y = size;
    if (word == "top") move.y = -size;
    size = 2;
  }
  return move;
}

Policy policy_of(const std::string& order) {
  Policy policy;
  for (const char* rule : {"point.ownership", "line.diamond-exit", "triangle.fill-rule"})
    policy.rules[rule] = order;
  return policy;
}

oracle::Eighths eighths(Point p) {
  return {static_cast<int>(p.x.raw() * 8 / Fixed::kOne),
          static_cast<int>(p.y.raw() * 8 / Fixed::kOne)};
}

bool oracle_covers(const ScenePrimitive& primitive, int x, int y, oracle::Move move) {
  const auto at = [&](std::size_t i) { return eighths(primitive.vertices[i]->position); };
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return oracle::point_produces(at(0), x, y, move);
    case PrimitiveKind::line:
      return oracle::line_produces(at(0), at(1), x, y, move);
    case PrimitiveKind::triangle:
      return oracle::triangle_produces({at(0), at(1), at(2)}, x, y, move);
  }
  return false;
}

// GL 4.6 core, table 13.2: in a triangle fan the hub never provokes; in a strip the first of the
// three vertices in the order of the draw does, or the last.
Color flat_color(const ScenePrimitive& primitive) {
  const std::size_t count = static_cast<std::size_t>(vertices_of(primitive.kind));
  if (primitive.state->provoking_vertex == ProvokingVertex::last)
    return primitive.vertices[count - 1]->color;
  if (primitive.state->primitive == Primitive::triangle_fan) return primitive.vertices[1]->color;
  if (primitive.state->primitive == Primitive::triangle_strip)
    return std::min(primitive.vertices[0], primitive.vertices[1])->color;
  return primitive.vertices[0]->color;
}

std::uint8_t byte_of(float component) {
  return static_cast<std::uint8_t>(std::lround(component * 255.0f));
}

// Pixel by pixel, each primitive in turn: the order of rendering files, and drawing order in it.
void expect_as_oracle_says(const Scene& scene, const Rendering& rendering, oracle::Move move) {
  const auto primitives = primitives_of(scene);
  auto fragment = rendering.fragments.begin();
  for (int y = 0; y < scene.target.height; ++y)
    for (int x = 0; x < scene.target.width; ++x) {
      std::uint32_t hits = 0;
      Color color = scene.target.clear;
      for (const ScenePrimitive& primitive : primitives) {
        if (!oracle_covers(primitive, x, y, move)) continue;
        ASSERT_NE(fragment, rendering.fragments.end());
        ASSERT_EQ(std::tuple(fragment->x, fragment->y, fragment->primitive),
                  std::tuple(x, y, primitive.index));
        color = flat_color(primitive);
        for (std::size_t c = 0; c < 4; ++c)
          ASSERT_EQ(fragment->color[c], static_cast<double>(color[c]));
        ++fragment;
        ++hits;
      }
      ASSERT_EQ(rendering.hits[rendering.pixel_index(x, y)], hits);
      for (std::size_t c = 0; c < 4; ++c)
        ASSERT_EQ(rendering.pixels[4 * rendering.pixel_index(x, y) + c], byte_of(color[c]));
    }
  ASSERT_EQ(fragment, rendering.fragments.end());
}

// Does any decision of the scene hang on a tie?
bool has_tie(const Scene& scene) {
  const auto drawn = [&](const char* order) {
    return rasterize(scene, policy_of(order)).fragments;
  };
  const auto open = drawn("open"), closed = drawn("closed");
  return !std::equal(open.begin(), open.end(), closed.begin(), closed.end(),
                     [](const Fragment& a, const Fragment& b) {
                       return std::tie(a.x, a.y, a.primitive) == std::tie(b.x, b.y, b.primitive);
                     });
}

// Vertices on pixel corners, centres and mid-sides, where ties abound.
Scene scene_with_tie(RandomScenes& scenes) {
  for (;;) {
    const Scene scene = scenes.next({8, Fixed::kOne / 2, 4, false});
    if (has_tie(scene)) return scene;
  }
}

TEST(RandomScenes, AreDrawnAsTheOraclesSay) {
  const int count = share_of(100000);
  RandomScenes scenes(share_seed(2026));
  long fragments = 0;
  for (int i = 0; i < count; ++i) {
    const Scene scene =
        i % 2 == 0 ? scene_with_tie(scenes) : scenes.next({8, Fixed::kOne / 8, 4, false});
    const std::string order = kOrders[scenes.below(8)];
    const Rendering rendering = rasterize(scene, policy_of(order));
    expect_as_oracle_says(scene, rendering, move_named(order));
    if (HasFatalFailure()) FAIL() << "scene " << i << " under " << order;
    fragments += static_cast<long>(rendering.fragments.size());
  }
  EXPECT_GT(fragments, 10L * count);
  std::printf("%d scenes, every other one with ties, %ld fragments\n", count, fragments);
}

TEST(RandomScenes, ATriangleDoesNotDependOnTheOrderOfItsVertices) {
  constexpr std::size_t kOrderings[][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                           {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  RandomScenes scenes(6);
  for (int i = 0; i < 5000; ++i) {
    Scene scene = scenes.next({8, Fixed::kOne / 4, 1, false});
    if (scene.draws[0].primitive != Primitive::triangles) continue;
    scene.draws[0].interpolation = i % 2 == 0 ? Interpolation::flat : Interpolation::smooth;
    const Rendering first = rasterize(scene, {});
    for (const auto& ordering : kOrderings) {
      Scene permuted = scene;
      for (std::size_t v = 0; v < 3; ++v)
        permuted.draws[0].vertices[v] = scene.draws[0].vertices[ordering[v]];
      const Rendering other = rasterize(permuted, {});
      ASSERT_EQ(other.hits, first.hits);
      const Color provoking = permuted.draws[0].provoking_vertex == ProvokingVertex::first
                                  ? permuted.draws[0].vertices[0].color
                                  : permuted.draws[0].vertices[2].color;
      for (std::size_t f = 0; f < first.fragments.size(); ++f) {
        ASSERT_NEAR(other.fragments[f].depth, first.fragments[f].depth, 1e-14);
        for (std::size_t c = 0; c < 4; ++c)
          if (i % 2 == 0)
            ASSERT_EQ(other.fragments[f].color[c], static_cast<double>(provoking[c]));
          else
            ASSERT_NEAR(other.fragments[f].color[c], first.fragments[f].color[c], 1e-14);
      }
    }
  }
}

TEST(RandomScenes, ConstantAttributesStayConstantToTheBit) {
  RandomScenes scenes(9);
  const Color color{0.1f, 1.0f / 3, 0.7f, 0.9f};
  const Fixed z = Fixed::from_raw(12345);
  long compared = 0;
  for (int i = 0; i < 5000; ++i) {
    Scene scene = scenes.next({8, 1, 3, false});
    for (Draw& draw : scene.draws) {
      draw.interpolation = Interpolation::smooth;
      for (Vertex& vertex : draw.vertices) vertex.color = color, vertex.z = z;
    }
    for (const Fragment& f : rasterize(scene, {}).fragments) {
      ++compared;
      ASSERT_EQ(f.depth, (z.to_double() + 1) / 2);
      for (std::size_t c = 0; c < 4; ++c) ASSERT_EQ(f.color[c], static_cast<double>(color[c]));
    }
  }
  EXPECT_GT(compared, 10000);
}

}  // namespace
}  // namespace edgecase
