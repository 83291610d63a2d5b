// SPDX-License-Identifier: MIT
//
// Polygon offset (ruling 38): fragments' depths that follow each alternative, and depths that
// follow none.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/values/framebuffer.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/operation_scenes.h"
#include "tests/support/causes.h"
#include "tests/support/points.h"

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
  return judge_output(scene, {}, rasterize(scene, policy_with(rule, alternative)));
}

bool is_named(const Result& result, const std::string& cause) {
  return disagreement_causes_of(result).contains(cause) ||
         aggregate_causes_of(result).contains(cause);
}

Verdict verdict_on(const Alternative& alternative) {
  return alternative.openness == Openness::illegal ? Verdict::violation : Verdict::convention;
}

// Two triangles side by side, offset by so many units of 16 bits, as a renderer has them whose unit
// is so many steps.
Result with_units(double first, double second, float units = 2000) {
  Scene scene = sloping(DepthFormat::depth16, {0, units, 0});
  scene.draws.push_back(scene.draws[0]);
  for (Vertex& vertex : scene.draws[1].vertices) {
    vertex.position.x = Fixed::from_integer(8) - vertex.position.x;
    vertex.position.y = Fixed::from_integer(8) - vertex.position.y;
  }
  std::swap(scene.draws[1].vertices[1], scene.draws[1].vertices[2]);
  Scene plain = scene;
  for (Draw& draw : plain.draws) draw.polygon_offset.reset();
  Rendering rendered = rasterize(plain, {});
  for (Fragment& f : rendered.fragments) {
    f.depth += static_cast<double>(units) * (f.primitive == 0 ? first : second) / 65535;
    f.depth = std::clamp(static_cast<double>(static_cast<float>(f.depth)), 0.0, 1.0);
    rendered.depths[rendered.pixel_index(f.x, f.y)] = to_depth(f.depth, DepthFormat::depth16);
  }
  return judge_output(scene, {}, rendered);
}

// 14.6.5 has no upper bound for the unit of a fixed-point buffer; a constant is all it asks for, of
// no less than one step.
TEST(OutputOffset, TheUnitOfAFixedPointBufferIsAnyConstantOfOneStepOrMore) {
  for (const double steps : {1.0, 1.3, 2.02, 4.0, 100.0})
    for (const float units : {2000.0F, 300.0F, -300.0F})
      EXPECT_TRUE(rules_of(with_units(steps, steps, units)).empty())
          << steps << described(with_units(steps, steps, units));
  for (const double steps : {0.98, 0.5, 0.0}) {
    const Result less = with_units(steps, steps);
    EXPECT_EQ(less.verdict, Verdict::violation) << steps;
    ASSERT_FALSE(less.disagreements.empty()) << steps;
    EXPECT_EQ(less.disagreements.front().ruling, 38);
  }
  // Not one constant: one of the two is odd, and both together say so.
  const Result two = with_units(2, 2.01);
  EXPECT_EQ(two.verdict, Verdict::violation) << described(two);
  std::set<int> odd;
  for (const Disagreement& d : two.disagreements) {
    EXPECT_EQ(d.rule, "offset.unit");
    EXPECT_EQ(d.ruling, d.primitive < 0 ? 64 : 38);
    odd.insert(d.primitive);
  }
  EXPECT_EQ(odd.size(), 2U);
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
        EXPECT_EQ(result.verdict, verdict_on(alternative)) << cause << described(result);
        EXPECT_TRUE(is_named(result, cause)) << cause << described(result);
        for (const Disagreement& d : result.disagreements)
          EXPECT_EQ(d.rule, rule) << described(result);
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
    const Rendering rendered = rasterize(scene, policy_with("offset.slope", alternative.name));
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
    const std::set<std::string> rules = rules_of(result);
    EXPECT_TRUE(rules.contains(offset.factor != 0 ? "offset.slope" : "offset.unit"))
        << described(result);
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
      // Depths as they are before they are clamped: the largest is 0.07, beyond 2^-4.
      const double unit = format == DepthFormat::depth32f ? 0x1p-27 : 0x1p-24;
      const Rendering plain = rasterize(sloping(format, {}), {});
      for (std::size_t i = 0; i < rendered.fragments.size(); ++i)
        rendered.fragments[i].depth =
            to_float(plain.fragments[i].depth + static_cast<double>(units) * unit);
      const Result unclamped = judge_output(scene, {}, rendered);
      ASSERT_FALSE(unclamped.disagreements.empty());
      for (const Disagreement& d : unclamped.disagreements)
        EXPECT_EQ(d.ruling, 45) << described(unclamped);
      // The fragment's depth is contested; what is stored of it is clamped, and right.
      EXPECT_EQ(rules_of(unclamped),
                std::set<std::string>{format == DepthFormat::depth32f ? "offset.exponent"
                                                                      : "offset.unit"})
          << described(unclamped);
    }
}

// Of a fragment whose depth the renderer tells unclamped, 0 is stored, and nothing else.
TEST(OutputOffset, AStoredDepthIsClampedWhateverTheFragmentReports) {
  for (const bool has_operations : {false, true}) {
    const Scene scene = sloping(DepthFormat::depth32f, {0, -1e9F, 0}, has_operations);
    const Rendering exact = rasterize(scene, {});
    for (const double stored : {-0.6875, -0x1p-20, 0x1p-20}) {
      Rendering rendered = exact;
      for (Fragment& f : rendered.fragments) f.depth = -0.6875;
      rendered.depths[rendered.pixel_index(rendered.fragments.front().x,
                                           rendered.fragments.front().y)] = stored;
      EXPECT_TRUE(rules_of(judge_output(scene, {}, rendered)).contains("framebuffer.depth"))
          << stored;
    }
  }
}

}  // namespace
}  // namespace edgecase
