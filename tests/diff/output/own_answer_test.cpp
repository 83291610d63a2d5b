// SPDX-License-Identifier: MIT
//
// Exact's own fragments, replayed: one state, which holds what exact has drawn, to the bit, under
// every alternative of the rules of fragment operations.
#include <gtest/gtest.h>

#include <algorithm>

#include "diff/output/operations_replay.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/output/output_judging.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr const char* kRules[] = {"depth.test",   "depth.mask",     "framebuffer.depth-bits",
                                  "stencil.test", "blend.equation", "blend.rounding",
                                  "color.mask",   "polygon.facing", "sample.alpha-to-coverage",
                                  "sample.depth"};

ExactSample drawn_at(const Rendering& rendering, std::size_t sample) {
  const auto& colors = rendering.samples > 1 ? rendering.sample_pixels : rendering.pixels;
  ExactSample drawn;
  std::copy_n(&colors[4 * sample], 4, drawn.color.begin());
  if (!rendering.depths.empty()) drawn.depth = rendering.depths[sample];
  if (!rendering.stencils.empty()) drawn.stencil = rendering.stencils[sample];
  drawn.hits = rendering.hits[sample];
  return drawn;
}

// True if planes that the target has hold the same.
bool is_same(const ExactSample& a, const ExactSample& b, const Target& target) {
  return a.color == b.color && a.hits == b.hits &&
         (target.depth == DepthFormat::none || a.depth == b.depth) &&
         (target.stencil == StencilFormat::none || a.stencil == b.stencil);
}

ExactSample exact_of(const PermittedSample& state) {
  return {state.color.exact, state.depth.exact, state.stencil, state.hits};
}

void expect_own_answer(const Scene& scene, const Policy& policy, long& hits) {
  const Rendering drawn = rasterize(scene, policy);
  const auto primitives = primitives_of(scene);
  const RuleChoices choices = resolve(policy, scene.target.surface);
  const ValueContext context(scene, primitives, choices, 8, Latitude::none);
  const Arrivals arrivals(context);
  const OutputRules rules{scene.target, choices.output};
  auto next = drawn.fragments.begin();
  for (int y = 0; y < drawn.height; ++y)
    for (int x = 0; x < drawn.width; ++x) {
      const auto first = next;
      while (next != drawn.fragments.end() && next->x == x && next->y == y) ++next;
      for (int s = 0; s < drawn.samples; ++s) {
        const ExactSample expected = drawn_at(drawn, drawn.sample_index(x, y, s));
        hits += expected.hits;
        const auto& at_sample = arrivals.at({first, next}, s, choices, Tracked::permitted);
        const auto states = replayed(at_sample, rules);
        ASSERT_EQ(states.size(), 1U);
        ASSERT_TRUE(is_same(exact_of(states[0]), expected, scene.target)) << x << ", " << y;
        ExactSample exact = cleared_sample<ExactNumbers>(scene.target);
        for (const Arrival& arrival : at_sample) arrive(arrival, rules, exact);
        ASSERT_TRUE(is_same(exact, expected, scene.target)) << x << ", " << y << " s " << s;
      }
    }
}

// Draws of two triangles each, so that some fragments of one draw meet at a sample.
Scene paired(Scene scene) {
  for (std::size_t i = 0; i < scene.draws.size(); ++i) {
    std::vector<Vertex>& vertices = scene.draws[i].vertices;
    const auto& others = scene.draws[(i + 1) % scene.draws.size()].vertices;
    const std::vector<Vertex> second(others.begin(), others.begin() + 3);
    vertices.insert(vertices.end(), second.begin(), second.end());
  }
  return scene;
}

TEST(OwnAnswer, ReplayedIsOneStateThatHoldsWhatIsDrawn) {
  RandomScenes random(86);
  Dealer dealer;
  long hits = 0;
  for (const char* rule : kRules)
    for (const Alternative& alternative : find_rule(rule)->alternatives)
      for (int i = 0; i < 40; ++i) {
        const Scene scene = i % 2 == 0 ? paired(random_multisampled_output_scene(random))
                                       : random_output_scene(random);
        if (!dealer.deal()) continue;
        expect_own_answer(scene, policy_with(rule, alternative.name), hits);
        if (HasFatalFailure()) FAIL() << rule << "=" << alternative.name << " " << i;
      }
  EXPECT_GT(hits, least_of(50000));
}

}  // namespace
}  // namespace edgecase
