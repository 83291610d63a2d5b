// SPDX-License-Identifier: MIT
//
// Alternatives of the rules of samples that real renderers follow, each planted: what follows from
// one is told with its name, all of it. A renderer here is the exact side under another policy,
// which reports the standard positions all the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

using Causes = std::set<std::string>;

Result judged_under(const Scene& scene, const Choices& rules, int subpixel_bits = 8) {
  Policy policy;
  policy.rules = rules;
  Rendering rendered = rasterize(scene, policy);
  rendered.sample_positions = rasterize(scene, {}).sample_positions;
  Result result = compare(scene, {}, rasterize(scene, {}), rendered, {subpixel_bits, nullptr});
  Result* const only = &result;
  judge({&only, 1}, Latitude::opengl);
  return result;
}

Point sixteenths(std::int64_t x, std::int64_t y) {
  return {Fixed::from_raw(x * 4096), Fixed::from_raw(y * 4096)};
}

// Triangles that cover pixels in part, with colours and depths that grow quickly.
Scene steep(Primitive primitive = Primitive::triangles) {
  Scene scene =
      multisampled_scene(16, 4, primitive,
                         {sixteenths(20, 30), sixteenths(230, 90), sixteenths(40, 221),
                          sixteenths(120, 41), sixteenths(250, 150), sixteenths(90, 250)});
  scene.target.depth = DepthFormat::depth32f;
  Draw& draw = scene.draws.front();
  draw.interpolation = Interpolation::smooth;
  const std::int64_t heights[] = {-50000, 20000, 60000};
  for (std::size_t i = 0; i < draw.vertices.size(); ++i) {
    draw.vertices[i].color = {static_cast<float>(i % 3 == 0), static_cast<float>(i % 3 == 1),
                              static_cast<float>(i) / 8, 1};
    draw.vertices[i].z = Fixed::from_raw(heights[i % 3]);
  }
  return scene;
}

TEST(SampleAlternatives, RoundedRectanglesAreConventions) {
  for (const char* name : {"snapped-offset", "snapped-corners"}) {
    Scene scene = steep(Primitive::lines);
    scene.draws.front().interpolation = Interpolation::flat;
    scene.target.depth = DepthFormat::none;
    RandomPoints random(8);
    Result result;
    // Some line shows it.
    for (int round = 0; round < 50 && result.disagreements.empty(); ++round) {
      for (Vertex& vertex : scene.draws.front().vertices)
        vertex.position = random.point(1, 15, 256);
      result = judged_under(scene, {{"line.multisampled", name}}, 4);
    }
    EXPECT_EQ(result.verdict, Verdict::convention) << name;
    EXPECT_EQ(disagreement_causes_of(result), Causes{"line.multisampled=" + std::string(name)});
  }
}

TEST(SampleAlternatives, ALineThatIsLostBetweenBordersIsAFault) {
  Scene scene =
      multisampled_scene(4, 4, Primitive::lines, {sixteenths(18, 20), sixteenths(26, 20)});
  const Choices rules{{"line.multisampled", "snapped-offset-across-borders"}};
  const Result lost = judged_under(scene, rules);
  EXPECT_EQ(lost.verdict, Verdict::contested);
  EXPECT_EQ(rules_of(lost), std::set<std::string>{"line.multisampled"});
  // A little longer, and the second column's left border runs through it.
  scene.draws.front().vertices.back().position = sixteenths(33, 20);
  EXPECT_EQ(judged_under(scene, rules).verdict, Verdict::agree);
}

TEST(SampleAlternatives, ConsequencesOfAnIgnoredSwitchAreReportedWithIt) {
  for (const Primitive primitive : {Primitive::triangles, Primitive::points}) {
    Scene scene = steep(primitive);
    Draw& draw = scene.draws.front();
    draw.multisampling.enabled = false;
    draw.point_size = Fixed::from_integer(3);
    const Result result = judged_under(scene, {{"sample.enable", "ignored"}});
    EXPECT_EQ(result.verdict, Verdict::violation);
    EXPECT_EQ(disagreement_causes_of(result), Causes{"sample.enable=ignored"});
    EXPECT_TRUE(rules_of(result).contains("framebuffer.unorm8"));
    EXPECT_TRUE(rules_of(result).contains("framebuffer.depth"));
    const auto is_of_hits = [](const Disagreement& d) {
      return d.rule == "sample.enable" && d.kind == DisagreementKind::value;
    };
    EXPECT_TRUE(std::ranges::any_of(result.disagreements, is_of_hits));
  }
}

TEST(SampleAlternatives, AColourDrawnEarlierIsWhatFollowsFromAnIgnoredSwitch) {
  Scene scene = steep();
  scene.draws.push_back(scene.draws.front());
  scene.draws.front().multisampling.enabled = false;
  scene.draws.back().multisampling.enabled = false;
  for (Vertex& vertex : scene.draws.back().vertices) vertex.color = {0, 0, 0.5F, 1};
  for (Vertex& vertex : scene.draws.front().vertices)
    vertex.position.x = vertex.position.x - Fixed::from_raw(Fixed::kOne / 8);
  const Result result = judged_under(scene, {{"sample.enable", "ignored"}});
  EXPECT_TRUE(rules_of(result).contains("framebuffer.order"));
  EXPECT_EQ(disagreement_causes_of(result), Causes{"sample.enable=ignored"});
}

// Lines and triangles, both without GL_MULTISAMPLE.
Scene lines_and_triangles() {
  Scene scene = steep();
  scene.draws.push_back(steep(Primitive::lines).draws.front());
  for (Draw& draw : scene.draws) draw.multisampling.enabled = false;
  for (Vertex& vertex : scene.draws.back().vertices)
    vertex.position.y = vertex.position.y + Fixed::from_raw(Fixed::kOne / 4);
  return scene;
}

TEST(SampleAlternatives, TheSwitchMayBeIgnoredByKind) {
  for (const char* name : {"ignored-but-for-lines", "ignored-but-whole-lines"}) {
    const Result result = judged_under(lines_and_triangles(), {{"sample.enable", name}});
    EXPECT_EQ(result.verdict, Verdict::violation);
    EXPECT_EQ(disagreement_causes_of(result), Causes{"sample.enable=" + std::string(name)});
  }
}

TEST(SampleAlternatives, ADepthForSampleZeroAlone) {
  const Result result = judged_under(lines_and_triangles(), {{"sample.enable", "depth-of-first"}});
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(rules_of(result), Causes{"framebuffer.depth"});
  EXPECT_EQ(disagreement_causes_of(result), Causes{"sample.enable=depth-of-first"});
  for (const Disagreement& d : result.disagreements) EXPECT_GT(d.sample, 0);
}

TEST(SampleAlternatives, AlphasOfOtherSamples) {
  Scene scene = steep();
  Draw& draw = scene.draws.front();
  draw.multisampling.alpha_to_coverage = true;
  draw.multisampling.min_sample_shading = 1;
  for (std::size_t i = 0; i < draw.vertices.size(); ++i)
    draw.vertices[i].color[3] = i % 3 == 0 ? -6.0F : 7.0F;
  const Result result =
      judged_under(scene, {{"sample.alpha-to-coverage", "above-quotient-of-others"}});
  EXPECT_EQ(result.verdict, Verdict::violation);
  const Causes others{"sample.alpha-to-coverage=above-quotient-of-others"};
  for (const Disagreement& d : result.disagreements)
    EXPECT_TRUE(others.contains(text_of(d.cause))) << d.explanation;
  // Invocations that do not run, and samples that are not written.
  EXPECT_TRUE(rules_of(result).contains("triangle.fill-rule"));
  EXPECT_TRUE(rules_of(result).contains("sample.alpha-to-coverage"));
}

TEST(SampleAlternatives, WAtThePixelsCentre) {
  Scene scene = steep();
  Draw& draw = scene.draws.front();
  for (std::size_t i = 0; i < draw.vertices.size(); i += 3) draw.vertices[i].w = 0.125F;
  EXPECT_EQ(judged_under(scene, {{"attribute.perspective", "w-of-centre"}}).verdict, Verdict::agree)
      << "at the centre itself there is no difference";
  draw.multisampling.location = AttributeLocation::sample;
  Result result = judged_under(scene, {{"attribute.perspective", "w-of-centre"}});
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(disagreement_causes_of(result), Causes{"attribute.perspective=w-of-centre"});
  // At a place that is not the policy's either.
  draw.multisampling.location = AttributeLocation::centroid;
  result = judged_under(
      scene, {{"attribute.perspective", "w-of-centre"}, {"attribute.centroid", "mean-covered"}});
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(disagreement_causes_of(result).contains(
      "attribute.perspective=w-of-centre + attribute.centroid=mean-covered"));
  EXPECT_FALSE(disagreement_causes_of(result).contains(""));
}

TEST(SampleAlternatives, GlFragCoordZHasTheCauseOfTheDepth) {
  Scene scene = steep();
  scene.details.coordinates = true;
  scene.draws.front().multisampling.mask = 0b1110;
  Result result = judged_under(scene, {{"sample.depth", "mirrored-x-or-zero"}});
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_TRUE(rules_of(result).contains("fragment.coordinates"));
  for (const Disagreement& d : result.disagreements) {
    const bool reported = d.rule == "fragment.coordinates" || d.rule == "fragment.depth";
    EXPECT_EQ(d.cause, reported ? "sample.depth=mirrored-x-or-zero" : "sample.depth=mirrored-x");
    EXPECT_EQ(reported, d.rendered == std::vector<double>{0});
  }
  scene = steep(Primitive::lines);
  scene.details.coordinates = true;
  scene.draws.front().multisampling.min_sample_shading = 1;
  result = judged_under(scene, {{"sample.depth", "half-pixel-off"}});
  EXPECT_TRUE(rules_of(result).contains("fragment.coordinates"));
  for (const Disagreement& d : result.disagreements)
    EXPECT_EQ(d.cause, "sample.depth=half-pixel-off") << d.explanation;
}

TEST(SampleAlternatives, SamplesThatAreExchangedAreNamed) {
  const Scene scene = steep();
  const SamplePositions standard = rasterize(scene, {}).sample_positions;
  SamplePositions swapped = standard;
  std::swap(swapped[1], swapped[3]);
  Rendering rendered = rasterize(scene, {}, swapped);
  rendered.sample_positions = standard;
  const Result result = compare(scene, {}, rasterize(scene, {}), rendered, {8, nullptr});
  int reported = 0;
  for (const Disagreement& d : result.disagreements) {
    if (d.kind == DisagreementKind::value) continue;
    ++reported;
    EXPECT_NE(d.explanation.find("With samples 1 and 3 exchanged, exact draws the same."),
              std::string::npos)
        << d.explanation;
  }
  EXPECT_GT(reported, 10);
}

}  // namespace
}  // namespace edgecase
