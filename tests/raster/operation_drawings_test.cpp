// SPDX-License-Identifier: MIT
//
// Fragment operations drawn by hand, each by itself, on targets of a few pixels.
#include <gtest/gtest.h>

#include <array>

#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "tests/raster/operation_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Rendering drawn(const Scene& scene, const Choices& rules = {}) {
  Policy policy;
  policy.rules = rules;
  return rasterize(scene, policy);
}

std::array<int, 4> pixel(const Rendering& rendering, int x, int y) {
  const std::uint8_t* p = rendering.pixels.data() + 4 * rendering.pixel_index(x, y);
  return {p[0], p[1], p[2], p[3]};
}

constexpr Viewport kAll = {0, 0, 3, 3};
constexpr Viewport kLeft = {0, 0, 2, 3};
constexpr Viewport kUpper = {0, 1, 3, 2};

// ---------------------------------------------------------------------------------- depth test

// Red to the left at depth 1/2, then green above at 3/8, 1/2 and 5/8, column by column.
Scene staircase(CompareFunction function, bool write = true) {
  Scene scene = operation_scene(3, DepthFormat::depth24, StencilFormat::none);
  Draw red = rectangle(kAll, 0.5, kRed);
  red.operations.depth.write = true;
  scene.draws = {red};
  for (int column = 0; column < 3; ++column) {
    Draw green = rectangle({column, 1, 1, 2}, (3 + column) / 8.0, kGreen);
    green.operations.depth = {function, write};
    scene.draws.push_back(green);
  }
  return scene;
}

TEST(OperationDrawings, ADepthTestComparesWithWhatIsStored) {
  const std::pair<CompareFunction, const char*> expected[] = {
      {CompareFunction::never, "RRR/RRR/RRR/"},   {CompareFunction::less, "GRR/GRR/RRR/"},
      {CompareFunction::equal, "RGR/RGR/RRR/"},   {CompareFunction::lequal, "GGR/GGR/RRR/"},
      {CompareFunction::greater, "RRG/RRG/RRR/"}, {CompareFunction::notequal, "GRG/GRG/RRR/"},
      {CompareFunction::gequal, "RGG/RGG/RRR/"},  {CompareFunction::always, "GGG/GGG/RRR/"}};
  for (const auto& [function, picture] : expected)
    EXPECT_EQ(colors(drawn(staircase(function))), picture) << name_of(function);
}

TEST(OperationDrawings, AllFragmentsAreReportedAndThoseThatPassAreCounted) {
  const Rendering rendering = drawn(staircase(CompareFunction::less));
  EXPECT_EQ(rendering.fragments.size(), 15u);
  EXPECT_EQ(hits(rendering), "211/211/111/");
  EXPECT_EQ(depths(rendering), "344/344/444/");
  EXPECT_TRUE(rendering.stencils.empty());
}

TEST(OperationDrawings, DepthIsWrittenWhereTheDrawSaysSo) {
  EXPECT_EQ(depths(drawn(staircase(CompareFunction::always))), "345/345/444/");
  EXPECT_EQ(depths(drawn(staircase(CompareFunction::always, false))), "444/444/444/");
  EXPECT_EQ(colors(drawn(staircase(CompareFunction::always, false))), "GGG/GGG/RRR/");
}

TEST(OperationDrawings, ADepthBufferIsClearedAsTheTargetSays) {
  Scene scene = operation_scene(3, DepthFormat::depth24, StencilFormat::none);
  scene.target.clear_depth = 0.25F;
  scene.draws = {rectangle(kLeft, 0.125, kRed), rectangle(kUpper, 0.5, kBlue)};
  for (Draw& draw : scene.draws) draw.operations.depth = {CompareFunction::less, true};
  EXPECT_EQ(colors(drawn(scene)), "RR./RR./RR./");
  EXPECT_EQ(depths(drawn(scene)), "112/112/112/");
  // 1/4 of 65535 is 16383.75.
  scene.target.depth = DepthFormat::depth16;
  EXPECT_EQ(drawn(scene).depths[2], 16384 / 65535.0);
  scene.target.depth = DepthFormat::depth32f;
  EXPECT_EQ(drawn(scene).depths[2], 0.25);
}

TEST(OperationDrawings, WithoutADepthBufferTheTestPasses) {
  Scene scene = staircase(CompareFunction::never);
  scene.target.depth = DepthFormat::none;
  EXPECT_EQ(colors(drawn(scene)), "GGG/GGG/RRR/");
  EXPECT_TRUE(drawn(scene).depths.empty());
}

TEST(OperationDrawings, APolicyChoosesHowDepthsAreCompared) {
  const auto picture = [](CompareFunction function, DepthTestMethod method) {
    return colors(drawn(staircase(function), {{"depth.test", name_of(method)}}));
  };
  EXPECT_EQ(picture(CompareFunction::less, DepthTestMethod::ties_pass), "GGR/GGR/RRR/");
  EXPECT_EQ(picture(CompareFunction::gequal, DepthTestMethod::ties_fail), "RRG/RRG/RRR/");
  EXPECT_EQ(picture(CompareFunction::never, DepthTestMethod::ignored), "GGG/GGG/RRR/");
}

// -------------------------------------------------------------------------------- stencil test

Draw with_stencil(Draw draw, const StencilFace& face) {
  draw.operations.stencil = {face, face};
  return draw;
}

StencilFace marking(std::uint8_t value) {
  StencilFace face;
  face.reference = value;
  face.pass = StencilOperation::replace;
  return face;
}

StencilFace admitting(CompareFunction function, std::uint8_t value) {
  StencilFace face;
  face.function = function;
  face.reference = value;
  return face;
}

TEST(OperationDrawings, AStencilMarksAreasAndAdmitsFragmentsToThem) {
  Scene scene = operation_scene(3, DepthFormat::none);
  scene.draws = {with_stencil(rectangle(kLeft, 0.5, kBlue), marking(2)),
                 with_stencil(rectangle(kUpper, 0.5, kRed), admitting(CompareFunction::equal, 2))};
  const Rendering rendering = drawn(scene);
  EXPECT_EQ(stencils(rendering), "220/220/220/");
  EXPECT_EQ(colors(rendering), "RR./RR./BB./");
  EXPECT_EQ(hits(rendering), "220/220/110/");
  EXPECT_EQ(rendering.fragments.size(), 12u);
  EXPECT_TRUE(rendering.depths.empty());
  scene.draws[1] =
      with_stencil(rectangle(kUpper, 0.5, kRed), admitting(CompareFunction::greater, 1));
  EXPECT_EQ(colors(drawn(scene)), "BBR/BBR/BB./");  // the reference is greater
}

// Stored 7 everywhere; the draw's stencil test passes to the left, its depth test above.
Scene every_outcome() {
  Scene scene = operation_scene(3);
  scene.target.clear_stencil = 1;
  Draw mark = with_stencil(rectangle(kLeft, 0.5, kBlue), marking(7));
  Draw wall = rectangle({0, 0, 3, 1}, 0.25, kBlue);
  wall.operations.depth.write = true;
  Draw tested = rectangle(kAll, 0.5, kRed);
  tested.operations.depth = {CompareFunction::less, true};
  StencilFace face = admitting(CompareFunction::equal, 7);
  face.fail = StencilOperation::incr;
  face.depth_fail = StencilOperation::zero;
  face.pass = StencilOperation::decr;
  scene.draws = {mark, wall, with_stencil(tested, face)};
  return scene;
}

TEST(OperationDrawings, EachOutcomeHasItsStencilOperation) {
  const Rendering rendering = drawn(every_outcome());
  EXPECT_EQ(stencils(rendering), "662/662/002/");
  EXPECT_EQ(colors(rendering), "RR./RR./BBB/");
  EXPECT_EQ(depths(rendering), "448/448/222/");
  EXPECT_EQ(hits(rendering), "220/220/221/");
}

TEST(OperationDrawings, WithoutADepthBufferNoDepthFails) {
  Scene scene = every_outcome();
  scene.target.depth = DepthFormat::none;
  EXPECT_EQ(stencils(drawn(scene)), "662/662/662/");
}

TEST(OperationDrawings, WithoutAStencilBufferTheTestPasses) {
  Scene scene = every_outcome();
  scene.target.stencil = StencilFormat::none;
  EXPECT_EQ(colors(drawn(scene)), "RRR/RRR/BBB/");
  EXPECT_TRUE(drawn(scene).stencils.empty());
}

TEST(OperationDrawings, AStencilBufferIsClearedEvenIfNobodyTests) {
  Scene scene = operation_scene(3);
  scene.target.clear_stencil = 5;
  scene.draws = {rectangle(kLeft, 0.5, kRed)};
  EXPECT_EQ(stencils(drawn(scene)), "555/555/555/");
  EXPECT_EQ(colors(drawn(scene)), "RR./RR./RR./");
}

TEST(OperationDrawings, MasksOfAStencilTestHideBits) {
  Scene scene = operation_scene(3, DepthFormat::none);
  scene.target.clear_stencil = 5;
  StencilFace face = admitting(CompareFunction::equal, 3);
  face.pass = StencilOperation::replace;
  face.read_mask = 0b001;
  face.write_mask = 0b010;
  scene.draws = {with_stencil(rectangle(kLeft, 0.5, kRed), face)};
  EXPECT_EQ(stencils(drawn(scene)), "775/775/775/");
  const Choices unmasked = {{"stencil.test", name_of(StencilMethod::unmasked)}};
  EXPECT_EQ(colors(drawn(scene, unmasked)), ".../.../.../");
}

TEST(OperationDrawings, EachFaceHasAStencilStateOfItsOwn) {
  Scene scene = operation_scene(3, DepthFormat::none);
  StencilTest test{marking(3), marking(4)};
  Draw front = rectangle({0, 0, 1, 3}, 0.5, kRed);
  Draw back = turned_round(rectangle({1, 0, 1, 3}, 0.5, kRed));
  Draw points = make_draw(Primitive::points, std::vector<Point>{at(2.5, 1.5)});
  for (Draw* draw : {&front, &back, &points}) {
    draw->operations.stencil = test;
    scene.draws.push_back(*draw);
  }
  EXPECT_EQ(stencils(drawn(scene)), "340/343/340/");
  for (Draw& draw : scene.draws) draw.front_face = FrontFace::cw;
  EXPECT_EQ(stencils(drawn(scene)), "430/433/430/");
  const Choices reversed = {{"polygon.facing", name_of(FacingMethod::reversed)}};
  EXPECT_EQ(stencils(drawn(scene, reversed)), "340/343/340/");
  const Choices one_sided = {{"stencil.test", name_of(StencilMethod::one_sided)}};
  EXPECT_EQ(stencils(drawn(scene, one_sided)), "330/333/330/");
}

// ---------------------------------------------------------------------- blending, colour mask

// Halfway between two codes as near as doubles can say, where a product decides.
TEST(OperationDrawings, WhatIsNotBlendedIsConvertedAsEverywhereElse) {
  const Scene scene = blank_scene(1, 1);
  Rendering rendering;
  rendering.width = rendering.height = 1;
  rendering.pixels.resize(4);
  rendering.hits.resize(1);
  const OutputChoice choice;
  const FragmentStage stage(rendering, scene.target, choice);
  for (int code = 0; code < 255; ++code) {
    const double halfway = (code + 0.5) / 255;
    stage.draw({{halfway, halfway, -halfway, 1 + halfway}, 0, true}, {}, 0);
    ASSERT_EQ(rendering.pixels,
              (std::vector<std::uint8_t>{to_unorm8(halfway), to_unorm8(halfway), 0, 255}));
  }
  EXPECT_EQ(rendering.hits[0], 255u);
}

Scene blended(const BlendTerm& color, const BlendTerm& alpha, const Color& source) {
  Scene scene = blank_scene(1, 1);
  scene.target.clear = {0.2F, 0.4F, 0.6F, 0.8F};  // 51, 102, 153, 204
  Draw draw = rectangle({0, 0, 1, 1}, 0.5, source);
  draw.operations.depth.write = true;
  draw.operations.blending = Blending{color, alpha, {0, 0.25F, 0.5F, 1}};
  scene.draws = {draw};
  return scene;
}

TEST(OperationDrawings, BlendingPutsColoursTogether) {
  using enum BlendFactor;
  const Color source = {1, 0.5F, 0, 0.25F};
  const BlendTerm over{BlendEquation::add, src_alpha, one_minus_src_alpha};
  const BlendTerm alpha_over{BlendEquation::add, one, one_minus_src_alpha};
  EXPECT_EQ(pixel(drawn(blended(over, alpha_over, source)), 0, 0),
            (std::array{102, 108, 115, 217}));
  const BlendTerm sum{BlendEquation::add, one, one};
  EXPECT_EQ(pixel(drawn(blended(sum, sum, source)), 0, 0), (std::array{255, 230, 153, 255}));
  const BlendTerm difference{BlendEquation::reverse_subtract, constant_color, one};
  EXPECT_EQ(pixel(drawn(blended(difference, sum, source)), 0, 0), (std::array{51, 70, 153, 255}));
  const BlendTerm least{BlendEquation::min, zero, zero}, most{BlendEquation::max, zero, zero};
  EXPECT_EQ(pixel(drawn(blended(least, most, source)), 0, 0), (std::array{51, 102, 0, 204}));
}

TEST(OperationDrawings, ASourceColourIsClampedBeforeItIsBlended) {
  const BlendTerm half{BlendEquation::add, BlendFactor::constant_alpha, BlendFactor::zero};
  Scene scene = blended(half, half, {4, -1, 0.5F, 1});
  scene.draws[0].operations.blending->constant[3] = 0.5F;
  EXPECT_EQ(pixel(drawn(scene), 0, 0), (std::array{128, 0, 64, 128}));
}

TEST(OperationDrawings, BlendingSeesWhatWasDrawnBefore) {
  Scene scene = blank_scene(3, 3);
  const BlendTerm sum{BlendEquation::add, BlendFactor::one, BlendFactor::one};
  scene.draws = {rectangle(kLeft, 0.5, kRed), rectangle(kUpper, 0.5, kBlue)};
  for (Draw& draw : scene.draws) draw.operations.blending = Blending{sum, sum, {}};
  EXPECT_EQ(colors(drawn(scene)), "MMB/MMB/RR./");
  const Choices ignored = {{"blend.equation", name_of(BlendMethod::ignored)}};
  EXPECT_EQ(colors(drawn(scene, ignored)), "BBB/BBB/RR./");
}

TEST(OperationDrawings, AColourMaskKeepsComponents) {
  Scene scene = operation_scene(3);
  scene.draws = {rectangle(kLeft, 0.5, kWhite), rectangle(kUpper, 0.5, kBlue)};
  scene.draws[0].operations.color_mask = {true, true, false, true};
  scene.draws[1].operations.color_mask = {false, true, true, true};
  EXPECT_EQ(colors(drawn(scene)), "MMB/MMB/YY./");
  const Choices ignored = {{"color.mask", name_of(ColorMaskMethod::ignored)}};
  EXPECT_EQ(colors(drawn(scene, ignored)), "BBB/BBB/WW./");
}

TEST(OperationDrawings, ADepthMaskKeepsDepths) {
  Scene scene = operation_scene(3);
  scene.draws = {rectangle(kLeft, 0.25, kWhite), rectangle(kUpper, 0.5, kBlue)};
  scene.draws[0].operations.depth = {CompareFunction::less, false};
  scene.draws[1].operations.depth = {CompareFunction::less, true};
  EXPECT_EQ(colors(drawn(scene)), "BBB/BBB/WW./");
  const Choices ignored = {{"depth.mask", name_of(DepthMaskMethod::ignored)}};
  EXPECT_EQ(colors(drawn(scene, ignored)), "WWB/WWB/WW./");
  EXPECT_EQ(depths(drawn(scene, ignored)), "224/224/228/");
}

TEST(OperationDrawings, EachFragmentOfADrawCountsInTheStencilBuffer) {
  Scene scene = operation_scene(3);
  Draw twice = rectangle(kLeft, 0.5, kRed);
  const std::vector<Vertex> again = twice.vertices;
  twice.vertices.insert(twice.vertices.end(), again.begin(), again.end());
  twice.operations.stencil.emplace();
  twice.operations.stencil->front.pass = StencilOperation::incr;
  twice.operations.stencil->back.pass = StencilOperation::incr;
  scene.draws = {twice, twice};
  EXPECT_EQ(stencils(drawn(scene)), "660/660/660/");
  const Choices once = {{"stencil.test", name_of(StencilMethod::once_a_draw)}};
  EXPECT_EQ(stencils(drawn(scene, once)), "220/220/220/");
}

TEST(OperationDrawings, AHiddenFragmentStillWritesDepthAndStencilAndIsCounted) {
  Scene scene = operation_scene(3);
  Draw draw = with_stencil(rectangle(kLeft, 0.25, kWhite), marking(1));
  draw.operations.color_mask = {false, false, false, false};
  draw.operations.depth.write = true;
  scene.draws = {draw};
  const Rendering rendering = drawn(scene);
  EXPECT_EQ(colors(rendering), ".../.../.../");
  EXPECT_EQ(depths(rendering), "228/228/228/");
  EXPECT_EQ(stencils(rendering), "110/110/110/");
  EXPECT_EQ(hits(rendering), "110/110/110/");
}

}  // namespace
}  // namespace edgecase
