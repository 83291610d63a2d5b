// SPDX-License-Identifier: MIT
//
// The parts of rulings that another reading survives, each with a number of its own: what breaks
// one of these breaks no other, and a little more breaks the ruling that it is a part of.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "raster/rasterizer.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/raster/operation_scenes.h"
#include "tests/support/causes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

std::set<int> broken(const Result& result) {
  std::set<int> rulings;
  for (const Disagreement& d : result.disagreements)
    if (!is_legal(d)) rulings.insert(d.ruling);
  return rulings;
}

// Ruling 49: of a coarse derivative nobody says how large the area is that shares it.
TEST(ContestedParts, CoarseDerivativesOfALargerArea) {
  Scene scene = blank_scene(16, 4);
  scene.details.derivatives = true;
  // What is interpolated depends on x alone.
  const Point corners[] = {at(-8, -40), at(40, 2), at(-8, 44)};
  Draw draw = make_draw(Primitive::triangles, corners);
  draw.interpolation = Interpolation::smooth;
  draw.vertices[1].w = 8;
  for (std::size_t i = 0; i < 3; ++i) draw.vertices[i].color = {i == 1 ? 1.0F : 0.0F, 0, 0, 1};
  scene.draws = {draw};
  const Rendering exact = rasterize(scene, {});
  // dFdx or dFdxFine of the fragment at (8, 2) as another one in its row has it.
  const auto rulings = [&](Derivative derivative, int x) {
    const auto kind = static_cast<std::size_t>(derivative);
    Rendering rendered = exact;
    const auto detail_at = [&](int column) {
      return static_cast<std::size_t>(
          rendered.fragments[static_cast<std::size_t>(2 * 16 + column)].detail);
    };
    rendered.details[detail_at(8)].derivatives[kind] =
        rendered.details[detail_at(x)].derivatives[kind];
    return broken(judge_output(scene, {}, rendered, Latitude::opengl, 16));
  };
  EXPECT_EQ(rulings(Derivative::x, 9), std::set<int>{});
  EXPECT_EQ(rulings(Derivative::x, 11), std::set<int>{49});
  EXPECT_EQ(rulings(Derivative::x, 14), std::set<int>{16});
  EXPECT_EQ(rulings(Derivative::x_coarse, 11), std::set<int>{49});
  EXPECT_EQ(rulings(Derivative::x_fine, 11), std::set<int>{16});
}

// Ruling 59: what is told of a depth may be a conversion of what was stored.
TEST(ContestedParts, DepthsOneCodeOff) {
  for (const DepthFormat format : {DepthFormat::depth16, DepthFormat::depth24})
    for (const bool tested : {false, true}) {
      const double codes = format == DepthFormat::depth16 ? 65535 : 16777215;
      Scene scene = operation_scene(4, format, StencilFormat::none);
      const double depth = 2001.0 / 131072;
      const int below = static_cast<int>(std::floor(depth * codes));
      scene.draws = {rectangle({0, 0, 4, 4}, depth, kRed)};
      scene.draws[0].operations.depth = {tested ? CompareFunction::less : CompareFunction::always,
                                         true};
      const Rendering exact = rasterize(scene, {});
      const auto rulings = [&](int code) {
        Rendering rendered = exact;
        rendered.depths.assign(rendered.depths.size(), (below + code) / codes);
        return broken(judge_output(scene, {}, rendered));
      };
      EXPECT_EQ(rulings(0), std::set<int>{});
      EXPECT_EQ(rulings(1), std::set<int>{});
      EXPECT_EQ(rulings(2), std::set<int>{59}) << tested;
      EXPECT_EQ(rulings(-1), std::set<int>{59}) << tested;
      EXPECT_FALSE(rulings(3).contains(59));
      EXPECT_FALSE(rulings(3).empty());
      EXPECT_FALSE(rulings(-2).contains(59));
    }
}

// Four samples, of which a rectangle covers so many of the pixels in its last column.
Rendering with_one_invocation(const Scene& scene, int covered) {
  Rendering rendered = rasterize(scene, {});
  std::vector<Fragment> kept;
  for (const Fragment& f : rendered.fragments) {
    std::uint32_t mask = 0;
    for (const Fragment& other : rendered.fragments)
      if (other.x == f.x && other.y == f.y && other.primitive == f.primitive)
        mask |= other.coverage;
    const bool is_merged = std::popcount(mask) == covered;
    const bool is_known = std::ranges::any_of(kept, [&](const Fragment& known) {
      return known.x == f.x && known.y == f.y && known.primitive == f.primitive;
    });
    if (is_merged && is_known) continue;
    kept.push_back(f);
    if (is_merged) kept.back().coverage = mask;
  }
  rendered.fragments = kept;
  return rendered;
}

// Ruling 60: which samples share an invocation is open, and so all that is covered may share one.
TEST(ContestedParts, InvocationsOfPartlyCoveredPixels) {
  Scene scene =
      multisampled_scene(8, 4, Primitive::triangles, {at(0, 0), at(9.5, 0.25), at(0.25, 9.5)});
  scene.draws.front().interpolation = Interpolation::flat;
  const auto rulings = [&](float share, int covered) {
    scene.draws.front().multisampling.min_sample_shading = share;
    std::set<int> found;
    for (const Disagreement& d :
         judge_output(scene, {}, with_one_invocation(scene, covered)).disagreements)
      if (d.rule == "sample.shading-rate") found.insert(d.ruling);
    return found;
  };
  EXPECT_EQ(rulings(0.5F, 2), std::set<int>{});
  EXPECT_EQ(rulings(0.5F, 3), std::set<int>{60});
  EXPECT_EQ(rulings(0.5F, 4), std::set<int>{34});
  // Each sample has an invocation of its own.
  EXPECT_EQ(rulings(1, 3), std::set<int>{34});
}

// Ruling 61: five codes of a blended component, which the Khronos tests take.
TEST(ContestedParts, BlendedColorsAFewCodesOff) {
  Scene scene = operation_scene(4, DepthFormat::none, StencilFormat::none);
  Draw half = rectangle({0, 0, 4, 4}, 0, {0.75F, 0, 0.25F, 0.5F});
  half.operations.blending =
      Blending{{BlendEquation::add, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha},
               {BlendEquation::add, BlendFactor::one, BlendFactor::zero},
               {}};
  half.operations.color_mask = {true, false, true, true};
  scene.draws = {rectangle({0, 0, 4, 4}, 0, {0.5F, 0.5F, 0.5F, 1}), half};
  const Rendering exact = rasterize(scene, {});
  const auto rulings = [&](std::size_t component, int codes) {
    Rendering rendered = exact;
    for (std::size_t i = component; i < rendered.pixels.size(); i += 4)
      rendered.pixels[i] = static_cast<std::uint8_t>(rendered.pixels[i] + codes);
    return broken(judge_output(scene, {}, rendered));
  };
  EXPECT_EQ(rulings(0, 0), std::set<int>{});
  EXPECT_EQ(rulings(0, 5), std::set<int>{61});
  EXPECT_EQ(rulings(0, -5), std::set<int>{61});
  EXPECT_FALSE(rulings(0, 9).empty());
  EXPECT_FALSE(rulings(0, 9).contains(61));
  // What is masked keeps what is stored.
  EXPECT_FALSE(rulings(1, 3).contains(61));
  EXPECT_FALSE(rulings(1, 3).empty());
}

// Points smaller than the fade threshold (14.4 and 17.2): their alpha may be that of the shader, or
// its product by the square of the size, and no less.
TEST(ContestedParts, SmallPointsMayFade) {
  const auto verdict = [](double size, int alpha) {
    Scene scene = multisampled_scene(4, 4, Primitive::points, {at(1.5, 1.5)});
    scene.draws.front().point_size = at(size, 0).x;
    for (Vertex& vertex : scene.draws.front().vertices) vertex.color = {1, 1, 1, 1};
    Rendering rendered = rasterize(scene, {});
    const std::size_t plane = rendered.pixels.size();
    for (const Fragment& f : rendered.fragments)
      for (std::size_t s = 0; s < 4; ++s)
        if ((f.coverage >> s & 1) != 0)
          rendered.sample_pixels[s * plane + 4 * rendered.pixel_index(f.x, f.y) + 3] =
              static_cast<std::uint8_t>(alpha);
    rendered.pixels.clear();
    EXPECT_FALSE(rendered.fragments.empty());
    return judge_output(scene, {}, rendered).verdict;
  };
  EXPECT_LE(verdict(0.75, 255), Verdict::permitted);
  EXPECT_LE(verdict(0.75, 144), Verdict::permitted);
  EXPECT_EQ(verdict(0.75, 120), Verdict::violation);
  EXPECT_EQ(verdict(1, 144), Verdict::violation);
}

// Ruling 33: fragments of one pixel with the same alpha keep the same samples.
TEST(ContestedParts, FragmentsOfOneAlphaKeepTheSameSamples) {
  Scene scene = multisampled_scene(4, 4, Primitive::triangles, {at(0, 0), at(9, 0), at(0, 9)});
  scene.draws.front().interpolation = Interpolation::smooth;
  scene.draws.front().multisampling.alpha_to_coverage = true;
  for (Vertex& vertex : scene.draws.front().vertices) vertex.color = {1, 1, 1, 0.5F};
  scene.draws.push_back(scene.draws.front());
  const auto rulings = [&](const std::array<std::uint32_t, 4>& hits) {
    Rendering rendered = rasterize(scene, {});
    for (int s = 0; s < 4; ++s)
      rendered.hits[rendered.sample_index(1, 1, s)] = hits[static_cast<std::size_t>(s)];
    rendered.sample_pixels.clear();
    rendered.pixels.clear();
    return broken(judge_output(scene, {}, rendered));
  };
  EXPECT_EQ(rulings({2, 2, 0, 0}), std::set<int>{});
  EXPECT_EQ(rulings({0, 2, 0, 2}), std::set<int>{});
  EXPECT_EQ(rulings({2, 1, 1, 0}), std::set<int>{33});
}

}  // namespace
}  // namespace edgecase
