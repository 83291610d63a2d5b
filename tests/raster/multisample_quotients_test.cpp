// SPDX-License-Identifier: MIT
//
// Primitives whose vertices are quotients, sample by sample, against fractions without a bound on
// their size, with both row orders; and the same positions given in both ways.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rules/coverage/tie_rule.h"
#include "rules/coverage/window.h"
#include "tests/oracles/quotients.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr int kSize = 4;

// Clip coordinates with a w of 3, 5, 6 or 7 that land in and round the target, on thirds and so on
// of eighths of a pixel, so that edges run through samples.
Vertex random_vertex(RandomPoints& random) {
  constexpr int kW[] = {3, 5, 6, 7};
  const int w = kW[random.between(0, 3)];
  const auto coordinate = [&] { return static_cast<float>(random.between(-4 * w, 4 * w)) / 4; };
  Vertex vertex;
  const float x = coordinate();
  vertex.clip = ClipPosition{x, coordinate(), 0, static_cast<float>(w)};
  vertex.w = static_cast<float>(w);
  return vertex;
}

bool oracle_has(const ScenePrimitive& primitive, Point sample, const oracle::Ties& ties) {
  const auto vertex = [&](std::size_t i) { return oracle::divided(primitive.positions[i]); };
  const oracle::Location at = oracle::location(sample);
  const auto fraction = [](Fixed value) { return oracle::Fraction(value.raw(), Fixed::kOne); };
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return oracle::point_has(vertex(0), fraction(primitive.state->point_size), at, ties);
    case PrimitiveKind::line:
      return oracle::rectangle_has(vertex(0), vertex(1), fraction(primitive.state->line_width), at,
                                   ties);
    case PrimitiveKind::triangle:
      return oracle::triangle_has({vertex(0), vertex(1), vertex(2)}, at, ties);
  }
  return false;
}

class MultisampledQuotients : public testing::TestWithParam<Primitive> {};

TEST_P(MultisampledQuotients, CoverWhatFractionsSay) {
  RandomPoints random(share_seed(static_cast<std::uint64_t>(GetParam()) + 100));
  long covered = 0;
  long tied = 0;
  // Few points are tied, and they cost little.
  const int rounds = GetParam() == Primitive::points ? 150 : share_of(150, 48);
  for (int round = 0; round < rounds; ++round) {
    Scene scene = multisampled_scene(kSize, 4, GetParam(), {});
    Draw& draw = scene.draws[0];
    for (int i = 0; i < vertices_of(kind_of(GetParam())); ++i)
      draw.vertices.push_back(random_vertex(random));
    // Lines that are level have sides that samples lie on.
    if (GetParam() == Primitive::lines && round % 3 == 0)
      for (Vertex& vertex : draw.vertices) vertex.clip->y = 0;
    draw.line_width = draw.point_size = Fixed::from_raw(random.between(2, 8) * Fixed::kOne / 2);
    const ScenePrimitive primitive = primitives_of(scene).at(0);
    const SamplePositions positions = round % 2 == 0 ? standard_pattern(4) : random.positions(4);
    for (const TieRule& rule : all_tie_rules()) {
      CoverageChoice choice;
      choice.ties = rule;
      const SampleCoverage coverage = covered_samples(primitive, scene.target, choice, positions);
      const oracle::Ties ties = oracle::ties_named(rule.name);
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
          for (std::size_t s = 0; s < 4; ++s) {
            const Point sample = place_in({x, y}, positions[s]);
            const bool ours = (mask_at(coverage, {x, y}) >> s & 1) != 0;
            ASSERT_EQ(ours, oracle_has(primitive, sample, ties)) << rule.name << " " << round;
            covered += ours ? 1 : 0;
            // Which samples are tied does not depend on the rule.
            if (&rule != &all_tie_rules().front()) continue;
            tied += oracle_has(primitive, sample, oracle::ties_named("closed")) !=
                            oracle_has(primitive, sample, oracle::ties_named("open"))
                        ? 1
                        : 0;
          }
    }
  }
  EXPECT_GT(covered, least_of(5000));
  EXPECT_GT(tied, least_of(5));
}

// A target seen upside down, with the samples turned over too, draws what the target seen upright
// draws with the other vertical tie.
TEST_P(MultisampledQuotients, TurnedOverTargetsTurnSamplesOver) {
  const std::pair<const char*, const char*> turned[] = {
      {"left-top", "left-bottom"}, {"bottom-right", "top-right"}, {"open", "open"}};
  RandomPoints random(static_cast<std::uint64_t>(GetParam()) + 200);
  for (int round = 0; round < 100; ++round) {
    Scene scene = multisampled_scene(kSize, 4, GetParam(), {});
    for (int i = 0; i < vertices_of(kind_of(GetParam())); ++i) {
      Vertex vertex = random_vertex(random);
      if (round % 2 == 0) vertex = {random.point(-1, 5, 8), {}, {}};
      scene.draws[0].vertices.push_back(vertex);
    }
    const ScenePrimitive primitive = primitives_of(scene).at(0);
    const SamplePositions positions = random.positions(4);
    for (const auto& [tie, other] : turned) {
      CoverageChoice upside_down;
      upside_down.rows = upside_down.polygon_rows = RowOrder::top_down;
      upside_down.ties = *find_tie_rule(tie);
      CoverageChoice upright;
      upright.ties = *find_tie_rule(other);
      EXPECT_EQ(covered_samples(primitive, scene.target, upside_down, positions),
                covered_samples(primitive, scene.target, upright, positions));
    }
  }
}

// The left end at 4/3 pixels lies a third of 2^-16 to the right of the multiple that is nearest to
// it, where sample 0 lies; sample 1 is the next one.
TEST(MultisampledQuotientLines, EndWhereTheyDo) {
  Scene scene = multisampled_scene(kSize, 2, Primitive::lines, {});
  Draw& draw = scene.draws[0];
  draw.vertices.resize(2);
  draw.vertices[0].clip = ClipPosition{-1, 0, 0, 3};
  draw.vertices[1].clip = ClipPosition{1, 0, 0, 1};
  const ScenePrimitive primitive = primitives_of(scene).at(0);
  const Fixed y = Fixed::from_raw(Fixed::kOne * 3 / 4);
  CoverageChoice choice;
  choice.ties = *find_tie_rule("closed");
  const SampleCoverage coverage = covered_samples(
      primitive, scene.target, choice, {{Fixed::from_raw(21845), y}, {Fixed::from_raw(21846), y}});
  EXPECT_EQ(mask_at(coverage, {1, 1}), 2u);
  EXPECT_EQ(mask_at(coverage, {2, 1}), 3u);
}

// From (1, 1) to (2, 2), as MultisampleDrawings has it.
TEST(MultisampledQuotientLines, MayBeParallelograms) {
  Scene scene = multisampled_scene(kSize, 4, Primitive::lines, {});
  scene.draws[0].vertices.resize(2);
  scene.draws[0].vertices[0].clip = ClipPosition{-0.5, -0.5, 0, 1};
  scene.draws[0].vertices[1].clip = ClipPosition{0, 0, 0, 1};
  EXPECT_EQ(masks_drawn(rasterize(scene, {})), ". . . ./. . . ./2 f 4 ./. . . ./");
  Policy policy;
  policy.rules = {{"line.multisampled", "parallelogram"}};
  EXPECT_EQ(masks_drawn(rasterize(scene, policy)), ". . . ./. 2 . ./. d . ./. . . ./");
}

INSTANTIATE_TEST_SUITE_P(Kinds, MultisampledQuotients,
                         testing::Values(Primitive::points, Primitive::lines,
                                         Primitive::triangles));

// The largest w and coordinates: a thin triangle and a line across the whole range, and samples
// just inside and outside of them.
TEST(MultisampledFarQuotients, KeepTheirSigns) {
  const std::int64_t w = std::int64_t{1} << 32;
  const std::int64_t far = w << 13;
  // From the lower left to the upper right, and a hair above.
  const HomogeneousPoint a{-far, -far, w};
  const HomogeneousPoint b{far, far, w - 1};
  const TieRule& open = *find_tie_rule("open");
  const HomogeneousSegment segment{a, b};
  const oracle::Location from = oracle::divided(a);
  const oracle::Location to = oracle::divided(b);
  int covered = 0;
  for (int x = 0; x <= 32; ++x)
    for (int y = 0; y <= 32; ++y) {
      const Point sample{Fixed::from_raw(x * 2048), Fixed::from_raw(y * 2048)};
      const bool expected =
          oracle::rectangle_has(from, to, 1, oracle::location(sample), oracle::ties_named("open"));
      covered += expected ? 1 : 0;
      EXPECT_EQ(multisampled_line_covers(segment, Fixed::from_integer(1), sample, open), expected);
    }
  EXPECT_GT(covered, 100);
  EXPECT_LT(covered, 33 * 33);
}

}  // namespace
}  // namespace edgecase
