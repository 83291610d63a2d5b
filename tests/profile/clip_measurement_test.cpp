// SPDX-License-Identifier: MIT
//
// The measurement of clipping measured: the exact rasterizer under each alternative.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "profile/clipping/clipping.h"
#include "profile/evidence/inference.h"
#include "tests/profile/altered_renderer.h"
#include "tests/profile/found_traits.h"

namespace edgecase {
namespace {

SurfaceFindings findings_of(const Choices& rules, const Alter& alter = {}) {
  AlteredRenderer renderer(policy_of(rules), alter);
  Question question;
  question.scenes_per_kind = 10'000;
  SurfaceFindings before;
  before.found.triangles = resolve(policy_of(rules), Surface::fbo).triangles;
  SurfaceFindings findings = measured(kClippingSubject, renderer, question, std::move(before));
  EXPECT_EQ(findings.drawn.not_drawn, 0u);
  return findings;
}

TEST(ClipMeasurement, FindsEveryAlternative) {
  for (const std::string& name : names_of_alternatives(RuleId::clip_volume)) {
    const SurfaceFindings findings =
        findings_of({{"clip.volume", name}, {"triangle.snap", "4-half-even"}});
    const Trait& trait = findings.traits.back();
    EXPECT_EQ(trait.id, TraitId(RuleId::clip_volume));
    EXPECT_EQ(trait.alternative, name) << trait.remark;
    EXPECT_GT(trait.rate.of, 100u);
    EXPECT_LT(trait.runner_up_rate.agreeing, trait.rate.agreeing) << name << trait.runner_up;
    EXPECT_EQ(findings.choices.at("clip.volume"), name);
  }
}

TEST(ClipMeasurement, SaysThatNoneFits) {
  const SurfaceFindings findings = findings_of({}, [](const Task&, Rendering& rendering) {
    if (rendering.fragments.size() % 5 == 4) rendering.fragments.pop_back();
  });
  EXPECT_EQ(findings.traits.back().alternative, kNoneFits);
  EXPECT_EQ(findings.traits.back().runner_up, "homogeneous");
  EXPECT_TRUE(findings.choices.empty());
}

TEST(ClipMeasurement, TrianglesLeaveTheVolumeWithOneVertex) {
  for (const ClipPlace place : values_of<ClipPlace>())
    for (std::uint64_t s = 0; s < 200; ++s) {
      const Scene scene = clip_scene(1, Surface::fbo, place, s);
      int outside = 0;
      for (const Vertex& vertex : scene.draws[0].vertices)
        outside += is_in_clip_volume(*vertex.clip) ? 0 : 1;
      EXPECT_EQ(outside, 1);
      EXPECT_TRUE(primitives_of(scene)[0].is_clipped);
    }
}

}  // namespace
}  // namespace edgecase
