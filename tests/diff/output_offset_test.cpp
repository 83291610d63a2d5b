// SPDX-License-Identifier: MIT
//
// Polygon offset (ruling 38): fragments' depths that follow each alternative, and depths that
// follow none.
#include <gtest/gtest.h>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/output_judging.h"
#include "tests/raster/operation_scenes.h"
#include "tests/rules/support.h"

namespace edgecase {
namespace {

// A triangle whose depth rises along both axes, offset by so much.
Scene sloping(DepthFormat format, const PolygonOffset& offset, bool has_operations = false) {
  Scene scene = operation_scene(8, format, StencilFormat::none);
  Draw draw = make_draw(Primitive::triangles, std::vector<Point>{at(0, 0), at(8, 0), at(0, 8)});
  const std::int64_t heights[] = {-60000, -58000, -57000};
  for (std::size_t i = 0; i < 3; ++i) draw.vertices[i].z = Fixed::from_raw(heights[i]);
  draw.polygon_offset = offset;
  if (has_operations) draw.operations.depth = {CompareFunction::less, true};
  scene.draws = {draw};
  return scene;
}

// What a renderer that has one rule otherwise makes of it.
Result under(const Scene& scene, const std::string& rule, const std::string& alternative) {
  return judge_output(scene, {}, rasterize(scene, policy_of(rule, alternative)));
}

bool is_named(const Result& result, const std::string& cause) {
  return causes_in(result).contains(cause) || aggregate_causes_in(result).contains(cause);
}

// An alternative that never conforms as such may still lie within what ruling 38 allows: four steps
// of 24 bits are what rounding a float32 depth can hide.
Verdict verdict_on(const Alternative& alternative, DepthFormat format) {
  if (alternative.openness != Openness::illegal) return Verdict::convention;
  const bool hidden = alternative.name == "four-steps" && format == DepthFormat::depth24;
  return hidden ? Verdict::permitted : Verdict::violation;
}

TEST(OutputOffset, EveryAlternativeIsNamedAndJudgedByItsOpenness) {
  const struct {
    const char* rule;
    DepthFormat format;
    PolygonOffset offset;
  } tried[] = {{"offset.slope", DepthFormat::depth24, {8, 0, 0}},
               {"offset.unit", DepthFormat::depth24, {0, 40000, 0}},
               {"offset.unit", DepthFormat::depth16, {0, 300, 0}},
               {"offset.exponent", DepthFormat::depth32f, {0, 400000, 0}}};
  for (const auto& [rule, format, offset] : tried)
    for (const Alternative& alternative : find_rule(rule)->alternatives) {
      const std::string cause = std::string(rule) + "=" + alternative.name;
      for (const bool has_operations : {false, true}) {
        const Scene scene = sloping(format, offset, has_operations);
        const Result result = under(scene, rule, alternative.name);
        if (result.verdict == Verdict::agree) continue;
        EXPECT_EQ(result.verdict, verdict_on(alternative, format)) << cause << told(result);
        EXPECT_TRUE(is_named(result, cause)) << cause << told(result);
        for (const Disagreement& d : result.disagreements) EXPECT_EQ(d.rule, rule) << told(result);
      }
    }
}

// What all depths with an offset follow counts those that it leaves as they are, too, though one
// stands for many that tell the same.
TEST(OutputOffset, WhatIsFollowedCountsFragmentsAlike) {
  Scene scene = sloping(DepthFormat::depth24, {8, 0, 0});
  Draw level = scene.draws[0];  // in the other half, where its fragments follow each other
  level.vertices[0].position = at(8, 8);
  for (Vertex& vertex : level.vertices) {
    vertex.z = level.vertices[0].z;
    vertex.color = level.vertices[0].color;
  }
  scene.draws.push_back(level);
  std::size_t followed = 0;
  for (const Alternative& alternative : find_rule("offset.slope")->alternatives) {
    const Rendering rendered = rasterize(scene, policy_of("offset.slope", alternative.name));
    for (const ValueAggregate& values : judge_output(scene, {}, rendered).values)
      if (values.attribute == "depth" && values.cause == "offset.slope=" + alternative.name) {
        EXPECT_EQ(values.compared, rendered.fragments.size()) << values.cause;
        ++followed;
      }
  }
  EXPECT_GT(followed, 0u);
}

TEST(OutputOffset, AnIgnoredOffsetIsAViolation) {
  const Scene scene = sloping(DepthFormat::depth24, {8, 0, 0});
  const Result result = under(scene, "offset.slope", "ignored");
  EXPECT_EQ(result.verdict, Verdict::violation);
  ASSERT_FALSE(result.disagreements.empty());
  EXPECT_EQ(result.disagreements.front().ruling, 38);
}

TEST(OutputOffset, ADepthThatNoOffsetYields) {
  for (const PolygonOffset& offset : {PolygonOffset{8, 0, 0}, PolygonOffset{0, 40000, 0}}) {
    const Scene scene = sloping(DepthFormat::depth24, offset, true);
    Rendering rendered = rasterize(scene, {});
    rendered.fragments.front().depth += 0.01;
    const Result result = judge_output(scene, {}, rendered);
    EXPECT_EQ(result.verdict, Verdict::violation);
    const std::set<std::string> rules = rules_in(result);
    EXPECT_TRUE(rules.contains(offset.factor != 0 ? "offset.slope" : "offset.unit"))
        << told(result);
  }
}

// 14.6.5: beyond 0 and 1 depths are clamped, of a floating-point buffer too.
TEST(OutputOffset, DepthsAreClampedOnceTheyAreOffset) {
  for (const DepthFormat format : {DepthFormat::depth24, DepthFormat::depth32f})
    for (const float units : {-1e9F, 1e9F}) {
      const Scene scene = sloping(format, {0, units, 0});
      Rendering rendered = rasterize(scene, {});
      for (const Fragment& f : rendered.fragments) ASSERT_EQ(f.depth, units < 0 ? 0 : 1);
      EXPECT_EQ(judge_output(scene, {}, rendered).verdict, Verdict::agree);
      for (Fragment& f : rendered.fragments) f.depth = units < 0 ? -0.5 : 1.5;
      EXPECT_EQ(judge_output(scene, {}, rendered).verdict, Verdict::violation);
    }
}

}  // namespace
}  // namespace edgecase
