// SPDX-License-Identifier: MIT
//
// Renderers that supersample otherwise than they should: each is convicted of exactly that, a right
// one of nothing. A renderer here is the exact side with something changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "raster/samples.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

constexpr const char* kRule = "supersample.accumulation";

Point place(int x, int y) {  // in sixteenths of a pixel
  return {Fixed::from_raw(x * (Fixed::kOne / 16)), Fixed::from_raw(y * (Fixed::kOne / 16))};
}

// Two triangles of smooth colours beyond 0 and 1, at places without any symmetry.
Scene lopsided() {
  Scene scene = blank_scene(10, 10);
  const std::vector<Point> corners = {place(16, 20),  place(144, 40),  place(44, 136),
                                      place(150, 20), place(130, 150), place(60, 90)};
  Draw draw = make_draw(Primitive::triangles, corners);
  draw.interpolation = Interpolation::smooth;
  for (std::size_t i = 0; i < corners.size(); ++i)
    draw.vertices[i].color = {static_cast<float>(i) - 1.5F, 2.75F, 0.3F, 1};
  scene.draws = {draw};
  scene.supersampling = {{place(1, 5), 1}, {place(3, 14), 2}, {place(6, 2), 5}, {place(13, 11), 9}};
  return scene;
}

Policy accumulating(const std::string& alternative) {
  return policy_with(kRule, alternative);
}

// With pixels that fit.
void show(Rendering& rendering) {
  std::ranges::transform(rendering.accumulated, rendering.pixels.begin(), to_unorm8);
}

// Of the image alone: the passes are right.
void expect_convicted(const Result& result, const std::string& cause) {
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(rules_of(result), std::set<std::string>{kRule});
  for (const Disagreement& d : result.disagreements) {
    EXPECT_EQ(d.sample, -1);
    EXPECT_EQ(d.primitive, -1);
    EXPECT_EQ(d.ruling, 36);
    EXPECT_EQ(d.cause, cause) << d.explanation;
  }
}

TEST(PassJudging, ExactAgreesWithItself) {
  const Scene scene = lopsided();
  const Result result = judged(scene, rasterize(scene, {}));
  EXPECT_EQ(result.verdict, Verdict::agree);
  EXPECT_TRUE(result.disagreements.empty());
  EXPECT_TRUE(result.values.empty());
  EXPECT_TRUE(result.evidence.empty());
  EXPECT_FALSE(result.refuted == AlternativeSet());
}

// It is exact's number, but a mean between two codes may become the other one.
TEST(PassJudging, ADoubleInSinglePrecisionDiffersByACodeAtMost) {
  const Scene scene = lopsided();
  const Rendering exact = rasterize(scene, {});
  Rendering rendering = exact;
  for (double& value : rendering.accumulated)
    value = static_cast<double>(static_cast<float>(value));
  EXPECT_EQ(judged(scene, rendering).verdict,
            rendering.accumulated == exact.accumulated ? Verdict::agree : Verdict::permitted);
  show(rendering);
  ASSERT_NE(rendering.pixels, exact.pixels);
  const Result result = judged(scene, rendering);
  EXPECT_EQ(result.verdict, Verdict::permitted);
  ASSERT_EQ(result.values.size(), 1u);
  EXPECT_EQ(result.values[0].attribute, "pixel");
}

TEST(PassJudging, SumsInSinglePrecisionAreAConvention) {
  const Scene scene = lopsided();
  const Result result = judged(scene, rasterize(scene, accumulating("float32-sum")));
  EXPECT_EQ(result.verdict, Verdict::convention);
  EXPECT_TRUE(result.disagreements.empty());
  EXPECT_EQ(causes_of(result), std::set<std::string>{"supersample.accumulation=float32-sum"});
  // A policy that has it so agrees with it, and has the exact mean as a convention in turn.
  const Policy policy = accumulating("float32-sum");
  EXPECT_EQ(judged(scene, rasterize(scene, policy), policy).verdict, Verdict::agree);
  const Result other = judged(scene, rasterize(scene, {}), policy);
  EXPECT_EQ(other.verdict, Verdict::convention);
  EXPECT_EQ(causes_of(other), std::set<std::string>{"supersample.accumulation=exact-mean"});
}

TEST(PassJudging, EveryAlternativeIsNamed) {
  const Scene scene = lopsided();
  for (const char* name : {"clamped", "bytes", "unweighted", "sum"}) {
    const Result result = judged(scene, rasterize(scene, accumulating(name)));
    expect_convicted(result, std::string(kRule) + "=" + name);
  }
}

// A hair beyond what the ruling permits, and a hair within.
TEST(PassJudging, TheBoundIsThatOfTheRuling) {
  const Scene scene = lopsided();
  const Rendering exact = rasterize(scene, {});
  std::size_t i = 0;
  std::vector<Interval> permitted;
  for_each_shown(scene, exact.passes, [&](std::span<const double> shown) {
    permitted.push_back(
        accumulation_permitted(shown, scene.supersampling, Accumulation::exact_mean));
  });
  i = 4 * exact.pixel_index(4, 4) + 1;
  Rendering within = exact;
  within.accumulated[i] = permitted[i].high;
  EXPECT_EQ(judged(scene, within).verdict, Verdict::permitted);
  Rendering beyond = exact;
  beyond.accumulated[i] = std::nextafter(permitted[i].high, 1e9);
  const Result result = judged(scene, beyond);
  expect_convicted(result, "");
  ASSERT_EQ(result.disagreements.size(), 1U);
  EXPECT_EQ(result.disagreements[0].x, 4);
  EXPECT_EQ(result.disagreements[0].y, 4);
}

TEST(PassJudging, NotANumberIsConvicted) {
  const Scene scene = lopsided();
  Rendering rendering = rasterize(scene, {});
  rendering.accumulated[7] = std::numeric_limits<double>::quiet_NaN();
  rendering.pixels[7] = 0;
  expect_convicted(judged(scene, rendering), "");
}

TEST(PassJudging, APassThatIsLeftOutOfTheMean) {
  const Scene scene = lopsided();
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    Rendering rendering = rasterize(scene, {});
    Scene fewer = scene;
    fewer.supersampling.erase(fewer.supersampling.begin() + static_cast<std::ptrdiff_t>(left_out));
    std::vector<Rendering> passes = rendering.passes;
    passes.erase(passes.begin() + static_cast<std::ptrdiff_t>(left_out));
    rendering.accumulated = accumulated_image(fewer, passes);
    show(rendering);
    expect_convicted(judged(scene, rendering), "");
  }
}

TEST(PassJudging, AWeightThatIsWrong) {
  const Scene scene = lopsided();
  for (std::size_t k = 0; k < 4; ++k) {
    Rendering rendering = rasterize(scene, {});
    Scene heavier = scene;
    ++heavier.supersampling[k].weight;
    rendering.accumulated = accumulated_image(heavier, rendering.passes);
    show(rendering);
    expect_convicted(judged(scene, rendering), "");
  }
}

// In its 8 bits alone.
TEST(PassJudging, PixelsAreTheAccumulatedImage) {
  const Scene scene = lopsided();
  Rendering rendering = rasterize(scene, {});
  const std::size_t i = 4 * rendering.pixel_index(3, 5) + 2;
  const double bytes = rendering.accumulated[i] * 255;
  ASSERT_NE(bytes, std::floor(bytes));
  rendering.pixels[i] = static_cast<std::uint8_t>(
      to_unorm8(rendering.accumulated[i]) == std::floor(bytes) ? std::ceil(bytes)
                                                               : std::floor(bytes));
  EXPECT_EQ(judged(scene, rendering).verdict, Verdict::permitted);
  rendering.pixels[i] = static_cast<std::uint8_t>(std::ceil(bytes) + 1);
  const Result result = judged(scene, rendering);
  EXPECT_EQ(result.verdict, Verdict::violation);
  ASSERT_EQ(result.disagreements.size(), 1U);
  EXPECT_EQ(result.disagreements[0].rule, "framebuffer.unorm8");
  EXPECT_EQ(result.disagreements[0].sample, -1);
}

// A renderer that tells its own wrong passes is convicted by them, and not by their mean.
TEST(PassJudging, PlacesThatAreMirroredOrExchanged) {
  const Scene scene = lopsided();
  const auto turned = [&](auto turn) {
    Scene other = scene;
    for (ShadingPass& pass : other.supersampling) pass.at = turn(pass.at);
    return judged(scene, rasterize(other, {}));
  };
  const Fixed one = Fixed::from_integer(1);
  const Result results[] = {turned([&](Point at) {
                              return Point{one - at.x, at.y};
                            }),
                            turned([&](Point at) {
                              return Point{at.x, one - at.y};
                            }),
                            turned([&](Point at) {
                              return Point{one - at.x, one - at.y};
                            }),
                            turned([](Point at) {
                              return Point{at.y, at.x};
                            })};
  for (const Result& result : results) {
    EXPECT_EQ(result.verdict, Verdict::violation);
    const auto rules = rules_of(result);
    EXPECT_TRUE(rules.contains("triangle.fill-rule"));
    EXPECT_TRUE(rules.contains("attribute.smooth"));
    EXPECT_FALSE(rules.contains(kRule));
    std::set<int> passes;
    for (const Disagreement& d : result.disagreements) passes.insert(d.sample);
    EXPECT_EQ(passes, (std::set<int>{0, 1, 2, 3}));
  }
}

TEST(PassJudging, ADisagreementSaysWhichPassItIsOf) {
  const Scene scene = lopsided();
  Rendering rendering = rasterize(scene, {});
  Fragment& fragment = rendering.passes[2].fragments[5];
  fragment.depth += 0.25;
  const Result result = judged(scene, rendering);
  ASSERT_EQ(result.disagreements.size(), 1U);
  const Disagreement& d = result.disagreements[0];
  EXPECT_EQ(d.rule, "fragment.depth");
  EXPECT_EQ(d.sample, 2);
  EXPECT_TRUE(d.explanation.starts_with(
      "pass 3 of 4 (at 0.375, 0.125; weight 5), the scene moved by (0.125, 0.375): "))
      << d.explanation;
  // Where it was shaded.
  ASSERT_EQ(d.figure.marks.size(), 1U);
  EXPECT_EQ(d.figure.marks[0].points[0], std::pair(d.x + 0.375, d.y + 0.125));
}

// Point 0 lies on a border of pixels in pass 1 alone.
TEST(PassJudging, EvidenceIsOfItsPassAlone) {
  Scene scene = lopsided();
  scene.draws = {make_draw(Primitive::points, std::vector<Point>{place(43, 62), place(110, 27)})};
  Policy otherwise;
  otherwise.rules["point.ownership"] = "left-bottom";
  Rendering rendering = rasterize(scene, {});
  rendering.passes[1] = rasterize(pass_of(scene, 1), otherwise);
  Rendering& last = rendering.passes[3];
  std::erase_if(last.fragments, [](const Fragment& f) { return f.primitive == 1; });
  const Result result = judged(scene, rendering);
  ASSERT_EQ(result.evidence.size(), 2U);
  EXPECT_EQ(result.evidence[0].pass, 1);
  EXPECT_EQ(result.evidence[0].primitive, 0);
  EXPECT_EQ(result.evidence[1].pass, 3);
  EXPECT_EQ(result.evidence[1].primitive, 1);
  int of_pass_1 = 0;
  for (const Disagreement& d : result.disagreements) {
    if (d.kind == DisagreementKind::value) continue;
    EXPECT_TRUE(d.sample == 1 || d.sample == 3);
    EXPECT_EQ(d.primitive, d.sample == 1 ? 0 : 1);
    if (d.sample != 1) continue;
    ++of_pass_1;
    EXPECT_EQ(d.cause, "point.ownership=left-bottom");
    EXPECT_TRUE(is_legal(d));
  }
  EXPECT_EQ(of_pass_1, 2);
}

TEST(PassJudging, ValuesAreCountedOverAllPasses) {
  const Scene scene = lopsided();
  Rendering rendering = rasterize(scene, {});
  std::size_t fragments = 0;
  for (const Rendering& pass : rendering.passes) fragments += pass.fragments.size();
  const auto nudge = [](Fragment& fragment, int steps) {
    float red = static_cast<float>(fragment.color[0]);
    for (int i = 0; i < steps; ++i) red = std::nextafterf(red, 9);
    fragment.color[0] = static_cast<double>(red);
  };
  nudge(rendering.passes[0].fragments[7], 2);
  nudge(rendering.passes[3].fragments[9], 4);
  nudge(rendering.passes[3].fragments[10], 1);
  rendering.accumulated = accumulated_image(scene, rendering.passes);
  show(rendering);
  const Result result = judged(scene, rendering);
  EXPECT_EQ(result.verdict, Verdict::permitted);
  ASSERT_EQ(result.values.size(), 1U);
  const ValueAggregate& values = result.values[0];
  EXPECT_EQ(values.attribute, "color");
  EXPECT_EQ(values.compared, fragments);
  EXPECT_EQ(values.components, 4 * fragments);
  EXPECT_EQ(values.differing.size(), 3U);
  EXPECT_EQ(values.worst.x, rendering.passes[3].fragments[9].x);
  EXPECT_NEAR(values.mean_ulp * static_cast<double>(values.components), 7, 2);
}

// Who tells no colours is given every colour that ruling 9 permits, and no more.
TEST(PassJudging, ColoursThatAreNotReported) {
  const Scene scene = lopsided();
  Rendering rendering = rasterize(scene, {});
  for (Rendering& pass : rendering.passes)
    for (Fragment& fragment : pass.fragments) {
      fragment.has_color = false;
      fragment.color = {};
    }
  EXPECT_EQ(judged(scene, rendering).verdict, Verdict::agree);
  const std::size_t i = 4 * rendering.pixel_index(4, 4);
  rendering.accumulated[i] += 0.75;
  show(rendering);
  const Result result = judged(scene, rendering);
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(rules_of(result), std::set<std::string>{kRule});
}

}  // namespace
}  // namespace edgecase
