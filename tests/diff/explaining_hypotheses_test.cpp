// SPDX-License-Identifier: MIT
//
// An answer that is drawn by a hypothesis is explained by it, and a right one by none.
#include "diff/explaining_hypotheses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "raster/rasterizer.h"
#include "rules/coverage/tie_rule.h"
#include "rules/hypotheses.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

constexpr int kSize = 24;  // pixels

// A few triangles and points in two draws, on quarters of a pixel.
Scene random_scene(std::uint32_t seed) {
  std::minstd_rand random(seed);
  const auto coordinate = [&] {
    return Fixed::from_raw(static_cast<std::int64_t>(random() % (4 * kSize)) * Fixed::kOne / 4);
  };
  Scene scene;
  scene.target.width = scene.target.height = kSize;
  scene.viewport = {0, 0, kSize, kSize};
  for (const Primitive primitive : {Primitive::triangles, Primitive::points}) {
    Draw draw;
    draw.primitive = primitive;
    draw.point_size = Fixed::from_integer(3);
    for (int i = 0; i < 6; ++i) {
      Vertex vertex;
      vertex.position = {coordinate(), coordinate()};
      vertex.color = {1, 0.5F, 0.25F, 1};
      draw.vertices.push_back(vertex);
    }
    scene.draws.push_back(draw);
  }
  return scene;
}

// The scene whose right drawing is that of the hypothesis: literal, vertex by vertex.
Scene drawn_by(const CoverageHypothesis& hypothesis, Scene scene) {
  const auto step = [&](Fixed value) {
    switch (hypothesis.grid) {
      case VertexGrid::whole_truncated:
        return Fixed::from_integer(static_cast<int>(value.floor()));
      case VertexGrid::whole_rounded:
        return Fixed::from_integer(
            static_cast<int>((value + Fixed::from_raw(Fixed::kOne / 2)).floor()));
      default:
        return value;
    }
  };
  const auto half = Fixed::from_raw(Fixed::kOne / 2);
  const auto one = Fixed::from_integer(1);
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) {
      Point& at = vertex.position;
      at = {step(at.x), step(at.y)};
      if (hypothesis.place == SampledPlace::lower_left) at = {at.x + half, at.y + half};
      if (hypothesis.place == SampledPlace::upper_left) at = {at.x + half, at.y - half};
      if (hypothesis.place == SampledPlace::one_above) at = {at.x, at.y + one};
    }
  if (hypothesis.left_out == LeftOut::later_draws) scene.draws.resize(1);
  if (hypothesis.left_out == LeftOut::everything) scene.draws.clear();
  return scene;
}

Rendering turned_over(Rendering rendering) {
  for (Fragment& fragment : rendering.fragments) fragment.y = kSize - 1 - fragment.y;
  sort_fragments(rendering);
  return rendering;
}

std::vector<NumberRun> explained(const Scene& scene, const Rendering& rendered) {
  const ResolvedPolicy policy;
  const Rendering exact = rasterize(scene, policy);
  const RendererFacts facts{8};
  return explaining_hypotheses({scene, policy, exact, rendered, facts});
}

bool contains(const std::vector<NumberRun>& runs, std::uint16_t number) {
  return std::ranges::any_of(
      runs, [&](const NumberRun& run) { return run.first <= number && number <= run.last; });
}

TEST(Hypotheses, HaveNumbersThatAreTheirOwn) {
  const int count = CoverageHypothesis::kPlaces * CoverageHypothesis::kGrids *
                    CoverageHypothesis::kLeftOuts * CoverageHypothesis::kTies * 2;
  for (int number = 0; number < count; ++number) {
    const auto one = CoverageHypothesis::of(static_cast<std::uint16_t>(number));
    ASSERT_EQ(one.number(), number);
    ASSERT_FALSE(is_about_colors(one.number()));
    if (is_fault(one.number())) {
      ASSERT_NE(meaning_of(one), "");
    }
  }
}

TEST(Hypotheses, ExplainNothingOfARightAnswer) {
  for (std::uint32_t seed = 1; seed < 20; ++seed) {
    const Scene scene = random_scene(seed);
    EXPECT_TRUE(explained(scene, rasterize(scene, {})).empty());
  }
}

TEST(Hypotheses, ExplainWhatIsDrawnByThem) {
  const auto closed =
      static_cast<int>(std::ranges::find(all_tie_rules(), TieRule::Kind::closed, &TieRule::kind) -
                       all_tie_rules().begin() + 1);
  const std::vector<CoverageHypothesis> hypotheses = {
      {.place = SampledPlace::lower_left},
      {.place = SampledPlace::one_above},
      {.grid = VertexGrid::whole_truncated},
      {.grid = VertexGrid::whole_rounded, .place = SampledPlace::upper_left},
      {.grid = VertexGrid::whole_truncated, .place = SampledPlace::lower_left, .ties = closed},
      {.left_out = LeftOut::later_draws},
      {.left_out = LeftOut::everything},
      {.place = SampledPlace::lower_left, .left_out = LeftOut::later_draws},
      {.is_upside_down = true},
      {.place = SampledPlace::lower_left, .is_upside_down = true},
  };
  for (const CoverageHypothesis& hypothesis : hypotheses) {
    std::size_t asked = 0;
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
      const Scene scene = random_scene(seed);
      const Policy ties =
          hypothesis.ties == 0
              ? Policy{}
              : policy_of({{"triangle.fill-rule", "closed"}, {"point.ownership", "closed"}});
      Rendering rendered = rasterize(drawn_by(hypothesis, scene), ties);
      if (hypothesis.is_upside_down) rendered = turned_over(rendered);
      const auto found = explained(scene, rendered);
      if (!contains(found, kAskedOfCoverage)) continue;  // it makes no difference here
      ++asked;
      EXPECT_TRUE(contains(found, hypothesis.number())) << meaning_of(hypothesis) << ", " << seed;
      EXPECT_TRUE(std::ranges::is_sorted(found, {}, &NumberRun::first));
    }
    EXPECT_GT(asked, 10U) << meaning_of(hypothesis);
  }
}

TEST(Hypotheses, AboutColoursAreAskedWhereTheRightPixelsAreCovered) {
  const Scene scene = random_scene(3);
  Rendering rendered = rasterize(scene, {});
  for (std::size_t i = 0; i < rendered.pixels.size(); i += 4)
    std::swap(rendered.pixels[i], rendered.pixels[i + 2]);
  const auto red_and_blue = static_cast<std::uint16_t>(ColorHypothesis::red_and_blue_exchanged);
  EXPECT_EQ(explained(scene, rendered), (std::vector<NumberRun>{{red_and_blue, red_and_blue},
                                                                {kAskedOfColors, kAskedOfColors}}));
  rendered.pixels[0] ^= 64;
  EXPECT_EQ(explained(scene, rendered), (std::vector<NumberRun>{{kAskedOfColors, kAskedOfColors}}));
}

}  // namespace
}  // namespace edgecase
