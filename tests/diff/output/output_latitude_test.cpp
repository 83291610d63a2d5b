// SPDX-License-Identifier: MIT
//
// What fragment operations leave open: comparisons of depths that conversion may turn either way,
// and states that grow in number.
#include <gtest/gtest.h>

#include <chrono>

#include "raster/rasterizer.h"
#include "rules/values/framebuffer.h"
#include "tests/diff/output/output_judging.h"
#include "tests/raster/operation_scenes.h"
#include "tests/support/causes.h"

namespace edgecase {
namespace {

using Names = std::set<std::string>;

// Two rectangles of which the second is drawn where its depth compares.
Scene two_layers(double first, double second, CompareFunction function,
                 DepthFormat format = DepthFormat::depth16) {
  Scene scene = operation_scene(4, format, StencilFormat::none);
  scene.draws = {rectangle({0, 0, 4, 4}, first, kRed), rectangle({0, 0, 4, 4}, second, kGreen)};
  scene.draws[0].operations.depth = {CompareFunction::always, true};
  scene.draws[1].operations.depth = {function, true};
  return scene;
}

// What the renderer shows if the second one passes, and if it does not.
Rendering passing(bool passes, double first, double second) {
  return rasterize(
      two_layers(first, second, passes ? CompareFunction::always : CompareFunction::never), {});
}

Verdict verdict(CompareFunction function, double first, double second, bool passes) {
  const Scene scene = two_layers(first, second, function);
  Rendering rendered = passing(passes, first, second);
  return judge_output(scene, {}, rendered).verdict;
}

// Both lie between the same two codes of 16 bits, 20000 and 20001, so that either order of their
// codes may be: their exact ones are 20000 and 20001.
constexpr double kLow = 40001.0 / 131072;
constexpr double kHigh = 40002.0 / 131072;
// Several codes away.
constexpr double kFar = 40010.0 / 131072;

TEST(OutputLatitude, DepthsWithinOneCodeMayCompareEitherWay) {
  for (const CompareFunction function : {CompareFunction::less, CompareFunction::lequal,
                                         CompareFunction::equal, CompareFunction::notequal}) {
    const std::string name = name_of(function);
    EXPECT_NE(verdict(function, kHigh, kLow, true), Verdict::violation) << name;
    EXPECT_NE(verdict(function, kHigh, kLow, false), Verdict::violation) << name;
  }
  EXPECT_EQ(verdict(CompareFunction::less, kFar, kLow, true), Verdict::agree);
  EXPECT_EQ(verdict(CompareFunction::less, kFar, kLow, false), Verdict::violation);
}

// Where it is not, no depth that is between two codes equals any, which is contested.
TEST(OutputLatitude, OneNumberIsConvertedToOneCode) {
  const auto is_wrong = [](CompareFunction function, double depth, bool passes) {
    const Verdict found = verdict(function, depth, depth, passes);
    return found == Verdict::contested || found == Verdict::violation;
  };
  for (const double depth : {kLow, 0.5, kHigh})
    for (const CompareFunction function :
         {CompareFunction::less, CompareFunction::lequal, CompareFunction::equal}) {
      const bool passes = function != CompareFunction::less;
      EXPECT_FALSE(is_wrong(function, depth, passes)) << name_of(function) << depth;
      EXPECT_TRUE(is_wrong(function, depth, !passes)) << name_of(function) << depth;
    }
}

std::set<int> rulings_in(const Result& result) {
  std::set<int> rulings;
  for (const Disagreement& d : result.disagreements) rulings.insert(d.ruling);
  return rulings;
}

// A depth that no code of 16 bits is never equals a stored one, and is less or greater always. That
// accounts for all samples of the case, and is contested; what it accounts for in part is not.
TEST(OutputLatitude, DepthsThatAreComparedUnconvertedAreContested) {
  const auto rulings = [](CompareFunction function, DepthFormat format, double depth) {
    const Scene scene = two_layers(depth, depth, function, format);
    const bool wrong = function == CompareFunction::less || function == CompareFunction::notequal;
    const Scene other =
        two_layers(depth, depth, wrong ? CompareFunction::always : CompareFunction::never, format);
    const Result result = judge_output(scene, {}, rasterize(other, {}));
    for (const Disagreement& d : result.disagreements)
      if (d.ruling == 55) {
        EXPECT_EQ(d.cause, "depth.test=unconverted");
      }
    return rulings_in(result);
  };
  for (const CompareFunction function :
       {CompareFunction::equal, CompareFunction::lequal, CompareFunction::notequal}) {
    EXPECT_EQ(rulings(function, DepthFormat::depth16, kLow), std::set<int>{55});
    // 1/8 is a float32 number, and no quotient of 24 bits. It is stored as the larger neighbour,
    // than which it is less. In float32 nothing is converted.
    EXPECT_EQ(rulings(function, DepthFormat::depth24, 0.125),
              std::set<int>{function == CompareFunction::lequal ? 39 : 55});
    EXPECT_EQ(rulings(function, DepthFormat::depth32f, 0.125), std::set<int>{39});
  }
  // 1 is a code.
  EXPECT_EQ(rulings(CompareFunction::equal, DepthFormat::depth16, 1), std::set<int>{39});
  // Half of the pixels one way, half the other.
  const Scene scene = two_layers(kLow, kLow, CompareFunction::equal);
  Rendering mixed = passing(true, kLow, kLow);
  const Rendering failing = passing(false, kLow, kLow);
  for (std::size_t pixel = 0; pixel < 8; ++pixel) {
    for (std::size_t c = 0; c < 4; ++c) mixed.pixels[4 * pixel + c] = failing.pixels[4 * pixel + c];
    mixed.hits[pixel] = failing.hits[pixel];
    mixed.depths[pixel] = failing.depths[pixel];
  }
  EXPECT_EQ(rulings_in(judge_output(scene, {}, mixed)), std::set<int>{39});
}

TEST(OutputLatitude, AnOpenTestIsReportedAsSuch) {
  // Exact rounds the first up and the second down: less passes. Both codes may be the same, too.
  const Scene scene = two_layers(kHigh, kLow, CompareFunction::less);
  const Result result = judge_output(scene, {}, passing(false, kHigh, kLow));
  EXPECT_EQ(result.verdict, Verdict::permitted) << described(result);
  bool found = false;
  for (const ValueAggregate& values : result.values)
    if (values.rule == "depth.test") found = values.ruling == 39 && values.differing.size() == 16;
  EXPECT_TRUE(found) << described(result);
}

TEST(OutputLatitude, WhatIsOpenGoesOneWayInAllPlanes) {
  const Scene scene = two_layers(kHigh, kLow, CompareFunction::less);
  const Rendering passes = passing(true, kHigh, kLow);
  const Rendering fails = passing(false, kHigh, kLow);
  Rendering mixed = passes;
  mixed.hits = fails.hits;
  EXPECT_EQ(judge_output(scene, {}, mixed).verdict, Verdict::violation);
  mixed = passes;
  mixed.pixels = fails.pixels;
  EXPECT_EQ(judge_output(scene, {}, mixed).verdict, Verdict::violation);
  mixed = fails;
  mixed.depths.assign(mixed.depths.size(), 19000.0 / 65535);
  EXPECT_EQ(judge_output(scene, {}, mixed).verdict, Verdict::violation);
}

// Each of many layers may pass or fail and blends something of its own.
Scene many_layers(int count, bool blended) {
  Scene scene = operation_scene(2, DepthFormat::depth16);
  StencilFace face;
  face.pass = StencilOperation::incr;
  for (int i = 0; i < count; ++i) {
    Draw draw = rectangle({0, 0, 2, 2}, 0.5,
                          {static_cast<float>(i % 7) / 7, static_cast<float>(i % 5) / 5, 0, 0.5F});
    draw.operations.depth = {CompareFunction::less, true};
    draw.operations.stencil = {face, face};
    if (blended)
      draw.operations.blending =
          Blending{{BlendEquation::add, BlendFactor::src_alpha, BlendFactor::one_minus_src_alpha},
                   {BlendEquation::add, BlendFactor::one, BlendFactor::one_minus_src_alpha},
                   {}};
    scene.draws.push_back(std::move(draw));
  }
  return scene;
}

TEST(OutputLatitude, ManyOpenTestsAreDoneWithAndRefuteWhatCannotBe) {
  const Scene scene = many_layers(64, true);
  Rendering rendered = rasterize(scene, {});
  for (Fragment& fragment : rendered.fragments) fragment.has_depth = false;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NE(judge_output(scene, {}, rendered).verdict, Verdict::violation);
  // No layer has blue in it.
  Rendering blue = rendered;
  blue.pixels[4 * blue.pixel_index(1, 1) + 2] = 200;
  const Result result = judge_output(scene, {}, blue);
  EXPECT_EQ(result.verdict, Verdict::violation);
  ASSERT_EQ(result.disagreements.size(), 1u);
  EXPECT_NE(result.disagreements.front().explanation.find("fragments, then primitive"),
            std::string::npos);
  // As many as 64 may have passed, and the stencil buffer says the same number.
  Rendering counted = rendered;
  ++counted.stencils[0];
  EXPECT_EQ(judge_output(scene, {}, counted).verdict, Verdict::violation);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
}

TEST(OutputLatitude, AHundredSlopingLayersOfReportedDepths) {
  Scene scene = many_layers(100, false);
  Rendering rendered = rasterize(scene, {});
  for (Fragment& fragment : rendered.fragments)
    fragment.depth = 0.5 + 1e-8 * static_cast<double>(fragment.primitive);
  EXPECT_NE(judge_output(scene, {}, rendered).verdict, Verdict::violation);
  rendered.pixels[2] = 90;
  EXPECT_EQ(judge_output(scene, {}, rendered).verdict, Verdict::violation);
}

}  // namespace
}  // namespace edgecase
