// SPDX-License-Identifier: MIT
//
// Colours and depths of fragments: flat ones are copied, smooth ones equal the textbook formula.
#include <gtest/gtest.h>

#include <algorithm>

#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Draw draw_of(Primitive primitive, Interpolation interpolation, ProvokingVertex provoking) {
  const Point positions[] = {at(1.25, 1.5), at(14.5, 3.75), at(4.25, 12.5)};
  Draw draw = make_draw(primitive, std::span(positions).first(
                                       static_cast<std::size_t>(vertices_of(kind_of(primitive)))));
  draw.interpolation = interpolation;
  draw.provoking_vertex = provoking;
  return draw;
}

Rendering render(const Draw& draw) {
  Scene scene = blank_scene(16, 16);
  scene.draws = {draw};
  return rasterize(scene, {});
}

// Barycentric coordinates of (x, y) in long double, on a triangle or along a line.
std::array<long double, 3> weights(const Draw& draw, long double x, long double y) {
  std::array<long double, 3> px{}, py{};
  for (std::size_t i = 0; i < draw.vertices.size(); ++i) {
    px[i] = static_cast<long double>(draw.vertices[i].position.x.to_double());
    py[i] = static_cast<long double>(draw.vertices[i].position.y.to_double());
  }
  if (draw.primitive == Primitive::lines) {
    const long double dx = px[1] - px[0], dy = py[1] - py[0];
    const long double t = ((x - px[0]) * dx + (y - py[0]) * dy) / (dx * dx + dy * dy);
    return {1 - t, t, 0};
  }
  const long double area = (px[1] - px[0]) * (py[2] - py[0]) - (py[1] - py[0]) * (px[2] - px[0]);
  const long double b = ((x - px[0]) * (py[2] - py[0]) - (y - py[0]) * (px[2] - px[0])) / area;
  const long double c = ((px[1] - px[0]) * (y - py[0]) - (py[1] - py[0]) * (x - px[0])) / area;
  return {1 - b - c, b, c};
}

TEST(Shade, FlatIsTheProvokingVertexOfEveryPrimitiveType) {
  for (Primitive primitive : {Primitive::points, Primitive::lines, Primitive::triangles})
    for (ProvokingVertex provoking : {ProvokingVertex::first, ProvokingVertex::last}) {
      const Draw draw = draw_of(primitive, Interpolation::flat, provoking);
      const Color& expected = provoking == ProvokingVertex::first ? draw.vertices.front().color
                                                                  : draw.vertices.back().color;
      const Rendering rendering = render(draw);
      ASSERT_FALSE(rendering.fragments.empty());
      for (const Fragment& f : rendering.fragments)
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_EQ(f.color[c], static_cast<double>(expected[c])) << name_of(primitive);
    }
}

TEST(Shade, SmoothColourAndDepthFollowTheFormula) {
  for (Primitive primitive : {Primitive::lines, Primitive::triangles}) {
    const Draw draw = draw_of(primitive, Interpolation::smooth, ProvokingVertex::last);
    const Rendering rendering = render(draw);
    ASSERT_GT(rendering.fragments.size(), 10u);
    for (const Fragment& f : rendering.fragments) {
      const auto w = weights(draw, f.x + 0.5L, f.y + 0.5L);
      long double depth = 0;
      std::array<long double, 4> color{};
      for (std::size_t v = 0; v < draw.vertices.size(); ++v) {
        depth += w[v] * (static_cast<long double>(draw.vertices[v].z.to_double()) + 1) / 2;
        for (std::size_t c = 0; c < 4; ++c)
          color[c] += w[v] * static_cast<long double>(draw.vertices[v].color[c]);
      }
      EXPECT_NEAR(f.depth, static_cast<double>(depth), 1e-14);
      for (std::size_t c = 0; c < 4; ++c)
        EXPECT_NEAR(f.color[c], static_cast<double>(color[c]), 1e-14);
    }
  }
}

// Snapping moves what is covered, never what is interpolated: attributes come from the vertices as
// given.
TEST(Shade, IsNotSnapped) {
  Policy snapped;
  snapped.rules = {{"subpixel.snap", "4-truncate"}};
  Scene scene = blank_scene(16, 16);
  const Point positions[] = {at(1 + 1.0 / 32, 1), at(14 + 1.0 / 32, 1), at(1 + 1.0 / 32, 14)};
  scene.draws = {make_draw(Primitive::triangles, positions)};
  scene.draws[0].interpolation = Interpolation::smooth;
  const Fragment plain = rasterize(scene, {}).fragments.at(20);
  int found = 0;
  for (const Fragment& f : rasterize(scene, snapped).fragments) {
    if (f.x != plain.x || f.y != plain.y) continue;
    ++found;
    EXPECT_EQ(f.color, plain.color);
    EXPECT_EQ(f.depth, plain.depth);
  }
  EXPECT_EQ(found, 1);
}

TEST(Rasterize, DepthsAreOneWhereNothingIsDrawnAndThereIsABuffer) {
  Scene scene = blank_scene(4, 2);
  const Point corner[] = {at(0.5, 0.5)};
  scene.draws = {make_draw(Primitive::points, corner)};
  scene.draws[0].vertices[0].z = Fixed();
  EXPECT_TRUE(rasterize(scene, {}).depths.empty());
  scene.target.depth = DepthFormat::depth32f;
  EXPECT_EQ(rasterize(scene, {}).depths, (std::vector<double>{0.5, 1, 1, 1, 1, 1, 1, 1}));
}

TEST(Rasterize, FragmentsHaveDetailsWhereASceneAsksForThem) {
  Scene scene = blank_scene(4, 4);
  scene.draws = {draw_of(Primitive::triangles, Interpolation::smooth, ProvokingVertex::last)};
  const Rendering plain = rasterize(scene, {});
  EXPECT_TRUE(plain.details.empty());
  scene.details.coordinates = true;
  const Rendering detailed = rasterize(scene, {});
  ASSERT_EQ(detailed.fragments.size(), plain.fragments.size());
  ASSERT_EQ(detailed.details.size(), plain.fragments.size());
  for (const Fragment& fragment : detailed.fragments) {
    ASSERT_GE(fragment.detail, 0);
    const FragmentDetail& detail = detailed.details[static_cast<std::size_t>(fragment.detail)];
    EXPECT_EQ(detail.coordinates.value()[0], fragment.x + 0.5);
    EXPECT_EQ(detail.coordinates.value()[1], fragment.y + 0.5);
  }
}

TEST(Rasterize, FragmentsOfWhatIsLinearShareADetail) {
  Scene scene = blank_scene(16, 16);
  scene.draws = {draw_of(Primitive::triangles, Interpolation::smooth, ProvokingVertex::last)};
  scene.draws.push_back(scene.draws[0]);
  scene.draws[1].vertices[2].color = {0, 1, 0.25F, 0.5F};
  scene.details.derivatives = true;
  const Rendering shared = rasterize(scene, {});
  ASSERT_EQ(shared.details.size(), 2U);
  for (const Fragment& fragment : shared.fragments) EXPECT_EQ(fragment.detail, fragment.primitive);
  EXPECT_NE(shared.details[0].derivatives, shared.details[1].derivatives);
  scene.details.texture = true;  // of which there is nothing to tell
  EXPECT_EQ(rasterize(scene, {}).details.size(), 2U);

  scene.details.coordinates = true;
  const Rendering apart = rasterize(scene, {});
  ASSERT_EQ(apart.details.size(), apart.fragments.size());
  for (const Fragment& fragment : apart.fragments)
    EXPECT_EQ(apart.details[static_cast<std::size_t>(fragment.detail)].derivatives,
              shared.details[static_cast<std::size_t>(fragment.primitive)].derivatives);

  scene.details.coordinates = false;
  scene.draws[1].vertices[1].w = 3;
  const Rendering divided = rasterize(scene, {});
  const auto of_second = std::ranges::count(divided.fragments, 1, &Fragment::primitive);
  EXPECT_GT(of_second, 1);
  EXPECT_EQ(divided.details.size(), 1 + static_cast<std::size_t>(of_second));
}

TEST(Rasterize, ForComparisonsAllButDetailsIsTheSame) {
  Scene scene = blank_scene(4, 4);
  scene.draws = {draw_of(Primitive::triangles, Interpolation::smooth, ProvokingVertex::last)};
  scene.details = {true, true, false};
  for (const int samples : {1, 4}) {
    scene.target.samples = samples;
    scene.details.derivatives = samples == 1;
    const Rendering all = rasterize(scene, {});
    const Rendering bare = rasterize_for_comparison(scene, {});
    EXPECT_FALSE(all.details.empty());
    EXPECT_TRUE(bare.details.empty());
    EXPECT_EQ(bare.pixels, all.pixels);
    EXPECT_EQ(bare.hits, all.hits);
    EXPECT_EQ(bare.sample_pixels, all.sample_pixels);
    ASSERT_EQ(bare.fragments.size(), all.fragments.size());
    for (std::size_t i = 0; i < all.fragments.size(); ++i) {
      EXPECT_EQ(bare.fragments[i].detail, -1);
      EXPECT_EQ(bare.fragments[i].x, all.fragments[i].x);
      EXPECT_EQ(bare.fragments[i].y, all.fragments[i].y);
      EXPECT_EQ(bare.fragments[i].color, all.fragments[i].color);
      EXPECT_EQ(bare.fragments[i].depth, all.fragments[i].depth);
    }
  }
}

}  // namespace
}  // namespace edgecase
