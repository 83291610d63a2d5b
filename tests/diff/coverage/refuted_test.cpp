// SPDX-License-Identifier: MIT
//
// Evidence against alternatives, held against drawing every one of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <vector>

#include "diff/coverage/cause.h"
#include "diff/coverage/refutation.h"
#include "raster/rasterizer.h"
#include "tests/raster/clipped_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

// Which alternatives draw the primitive otherwise than the choice does: of those that bear one
// name, all.
AlternativeSet drawn_otherwise(const CauseQuestion& question, const SampleCoverage& drawn) {
  std::map<AlternativeId, bool> draws_so;
  const CoverageTraits traits = coverage_traits(question.primitive, question.target);
  for (const Changes& rule : coverage_changes(traits, question.chosen))
    for (const Change& change : rule)
      draws_so[change.id] |=
          covered_samples(question.primitive, question.target,
                          change.applied_to(question.chosen).of(traits.kind), {}) == drawn;
  AlternativeSet refuted;
  for (const auto& [alternative, so] : draws_so)
    if (!so) refuted.add(alternative);
  return refuted;
}

const Policy kPolicies[] = {
    policy_of({}),
    policy_of({{"subpixel.snap", "8-half-even"}}),
    policy_of({{"subpixel.snap", "4-truncate"}, {"triangle.fill-rule", "open"}}),
    policy_of({{"triangle.fill-rule", "closed"}, {"triangle.row-order", "top-down"}}),
    policy_of({{"triangle.algorithm", "scan"}, {"line.row-order", "top-down"}}),
    policy_of({{"line.diamond-exit", "direct3d"}, {"triangle.row-order", "top-down"}}),
    policy_of({{"line.diamond-exit", "closed"}, {"line.row-order", "top-down"}}),
    policy_of({{"line.algorithm", "walk-ends-tested"}, {"subpixel.snap", "8-half-even"}}),
};

TEST(Refuted, IsWhatIsDrawnOtherwise) {
  std::size_t primitives = 0;
  std::size_t refuted = 0;
  RandomScenes scenes(5);
  // Whole pixels, pixel centres, grids of drivers, and finer than any; small, and large enough for
  // long lines.
  for (const std::int64_t step : {65536, 32768, 4096, 256, 1})
    for (int i = 0; i < 60; ++i) {
      Scene scene = scenes.next({i % 2 == 0 ? 8 : 24, step, 3, false});
      if (i % 10 == 0) scene.target.samples = 4;
      // Of some, the facing has a say.
      for (Draw& draw : scene.draws)
        if (scenes.below(3) == 0) draw.cull = CullMode::back;
      for (const Policy& policy : kPolicies) {
        const RuleChoices choices = resolve(policy, Surface::fbo);
        for (const ScenePrimitive& primitive : primitives_of(scene)) {
          const CauseQuestion question{primitive, scene.target, choices};
          const SampleCoverage drawn =
              covered_samples(primitive, scene.target, choices.of(primitive.kind), {});
          const AlternativeSet wanted = drawn_otherwise(question, drawn);
          // Where another primitive has refuted some before, they are not tried, and what is known
          // of the others must do when all are asked about.
          AlternativeSet half;
          std::size_t k = 0;
          wanted.for_each([&](AlternativeId id) {
            if (k++ % 2 != 0) half.add(id);
          });
          mark_refuted(question, {drawn, drawn}, half);
          ASSERT_TRUE(half == wanted) << policy.rules.size() << " " << step << " " << i;
          AlternativeSet marked;
          mark_refuted(question, {drawn, drawn}, marked);
          ASSERT_TRUE(marked == wanted) << policy.rules.size() << " " << step << " " << i;
          ++primitives;
          refuted += k;
        }
      }
    }
  std::printf("%zu primitives, %zu alternatives refuted\n", primitives, refuted);
  EXPECT_GT(refuted, 3 * primitives);
}

// A scene in other states: some decide what its primitives cover, and others leave it alone.
std::vector<Scene> in_other_states(const Scene& scene) {
  std::vector<Scene> others{scene};
  const auto add = [&](const auto& change) {
    change(others.emplace_back(scene));
    others.push_back(scene);
  };
  add([](Scene& one) { one.draws[0].line_width = Fixed::from_integer(3); });
  add([](Scene& one) { one.draws[0].point_size = Fixed::from_integer(3); });
  add([](Scene& one) { one.draws[0].scissor = Viewport{2, 1, 3, 4}; });
  add([](Scene& one) { one.draws[0].front_face = FrontFace::cw; });
  add([](Scene& one) { one.draws[0].cull = CullMode::front; });
  add([](Scene& one) { one.draws[0].cull = CullMode::none; });
  add([](Scene& one) { one.target.width = 4; });
  add([](Scene& one) { one.target.height = 5; });
  add([](Scene& one) {
    one.draws[0].vertices[0].position.x = one.draws[0].vertices[0].position.x + Fixed::from_raw(1);
  });
  add([](Scene& one) { one.draws[0].interpolation = Interpolation::smooth; });
  add([](Scene& one) { one.target.depth = DepthFormat::depth24; });
  return others;
}

TEST(Refuted, IsKnownOfTheSameShapeAlone) {
  RandomScenes scenes(9);
  std::size_t differ = 0;
  for (const std::int64_t step : {32768, 4096, 1})
    for (int i = 0; i < 40; ++i) {
      Scene scene = scenes.next({8, step, 1, false});
      scene.draws[0].cull = CullMode::back;
      const RuleChoices choices = resolve(kPolicies[i % 3], Surface::fbo);
      std::optional<AlternativeSet> of_scene;
      for (const Scene& other : in_other_states(scene)) {
        const ScenePrimitive primitive = primitives_of(other).at(0);
        const CauseQuestion question{primitive, other.target, choices};
        const SampleCoverage drawn =
            covered_samples(primitive, other.target, choices.of(primitive.kind), {});
        const AlternativeSet wanted = drawn_otherwise(question, drawn);
        AlternativeSet marked;
        mark_refuted(question, {drawn, drawn}, marked);
        ASSERT_TRUE(marked == wanted) << step << " " << i;
        if (!of_scene) of_scene = wanted;
        if (!(wanted == *of_scene)) ++differ;
      }
    }
  EXPECT_GT(differ, 200U);
}

// Triangles of clip positions. Of those that are clipped, corners are moved in some ways to clip
// and not in others. Sides are culled of some.
TEST(Refuted, IsWhatIsDrawnOtherwiseOfClipPositions) {
  ClippedScenes random(6);
  std::size_t clipped = 0, whole = 0, refuted = 0;
  const Policy policies[] = {
      policy_of({}),
      policy_of({{"clip.volume", "polygon"}, {"subpixel.snap", "8-half-even"}}),
      policy_of({{"clip.volume", "doubled-sides"}, {"subpixel.snap", "4-truncate"}}),
      policy_of({{"triangle.fill-rule", "closed"}, {"triangle.row-order", "top-down"}}),
      policy_of({{"subpixel.snap", "4-half-up"}}),
  };
  for (int i = 0; i < 320; ++i) {
    Scene scene = random.scene(Primitive::triangles, 3, {0, 0, 8, 8});
    if (i % 2 != 0)
      for (Vertex& vertex : scene.draws[0].vertices) vertex = random.vertex_inside();
    if (i % 3 == 0) scene.draws[0].cull = CullMode::back;
    const ScenePrimitive primitive = primitives_of(scene).at(0);
    ++(primitive.is_clipped ? clipped : whole);
    for (const Policy& policy : policies) {
      const RuleChoices choices = resolve(policy, Surface::fbo);
      const CauseQuestion question{primitive, scene.target, choices};
      const SampleCoverage drawn = covered_samples(primitive, scene.target, choices.triangles, {});
      const AlternativeSet wanted = drawn_otherwise(question, drawn);
      AlternativeSet marked;
      mark_refuted(question, {drawn, drawn}, marked);
      ASSERT_TRUE(marked == wanted) << policy.rules.size() << " " << i;
      wanted.for_each([&](AlternativeId) { ++refuted; });
    }
  }
  EXPECT_GT(clipped, 100U);
  EXPECT_GT(whole, 100U);
  EXPECT_GT(refuted, clipped);
}

// What is kept of a primitive is not taken for another's that differs in one thing.
TEST(Refuted, IsKeptForOnePrimitiveAlone) {
  Scene scene;
  scene.target.width = scene.target.height = 8;
  scene.viewport = {0, 0, 8, 8};
  Draw& draw = scene.draws.emplace_back();
  draw.primitive = Primitive::lines;
  const auto at = [](int n) { return Fixed::from_raw(n * Fixed::kOne / 16); };
  draw.vertices.resize(2);
  draw.vertices[0].position = {at(9), at(23)};
  draw.vertices[1].position = {at(100), at(70)};
  const auto expect_right = [&](const char* what) {
    const RuleChoices choices = resolve(Policy{}, Surface::fbo);
    for (const ScenePrimitive& primitive : primitives_of(scene)) {
      const CauseQuestion question{primitive, scene.target, choices};
      const SampleCoverage drawn =
          covered_samples(primitive, scene.target, choices.of(primitive.kind), {});
      AlternativeSet marked;
      mark_refuted(question, {drawn, drawn}, marked);
      EXPECT_TRUE(marked == drawn_otherwise(question, drawn)) << what;
    }
  };
  expect_right("as it is");
  draw.line_width = Fixed::from_integer(3);
  expect_right("wider");
  draw.line_width = Fixed::from_integer(1);
  draw.scissor = Viewport{2, 1, 3, 4};
  expect_right("cut");
  draw.scissor.reset();
  scene.target.height = 3;
  expect_right("of a lower target");
  draw.primitive = Primitive::points;
  expect_right("as points");
  draw.point_size = Fixed::from_integer(5);
  expect_right("as larger points");
}

}  // namespace
}  // namespace edgecase
