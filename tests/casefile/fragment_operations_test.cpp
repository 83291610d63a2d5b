// SPDX-License-Identifier: MIT
//
// Fragment operations as case files give them, and back to text; each refusal has a file in bad/ or
// bad_loader_only/.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "casefile/case_writer.h"
#include "casefile/loader.h"
#include "model/scene.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

const std::string kBuffers = R"("depth": "depth24", "stencil": "stencil8")";

// One triangle, with this beside the target's size, and in its state.
LoadedCases load(const std::string& target, const std::string& state) {
  return load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 4, "height": 4, )" + target +
          R"(}, "draws": [{"primitive": "triangles", "vertices": [[0, 0], [2, 0], [0, 2]],
              "state": {)" +
          state + "}}]}",
      "a.json", "a");
}

Scene scene_of(const std::string& target, const std::string& state) {
  const LoadedCases loaded = load(target, state);
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  return loaded.cases.empty() ? Scene{} : loaded.cases[0].scene;
}

Draw draw_of(const std::string& state) {
  const Scene scene = scene_of(kBuffers, state);
  return scene.draws.empty() ? Draw{} : scene.draws[0];
}

CaseText written(const Scene& scene) {
  CaseWords words;
  words.title = "A scene";
  words.rules = {"depth.test"};
  return case_text(scene, words);
}

TEST(FragmentOperations, DefaultsAreThoseOfTheModel) {
  const Scene scene = scene_of("\"samples\": 1", "");
  EXPECT_FALSE(has_fragment_operations(scene));
  EXPECT_EQ(scene.depth_range, DepthRange{});
  EXPECT_EQ(scene.draws.at(0).cull, CullMode::none);
  EXPECT_FALSE(scene.draws.at(0).polygon_offset.has_value());
}

TEST(FragmentOperations, BuffersAreRead) {
  const Scene scene = scene_of(
      R"("depth": "depth32f", "stencil": "stencil8", "clear_depth": "1/4", "clear_stencil": 200,
         "depth_range": [1, 0.5])",
      "");
  EXPECT_EQ(scene.target.stencil, StencilFormat::stencil8);
  EXPECT_EQ(scene.target.clear_depth, 0.25F);
  EXPECT_EQ(scene.target.clear_stencil, 200);
  EXPECT_EQ(scene.depth_range, (DepthRange{1, 0.5F}));
  // A depth range needs no buffer, since fragments have a depth without one, too; and "none" is one
  // that is not there.
  EXPECT_EQ(scene_of(R"("depth_range": [0, "~0.1"], "stencil": "none")", "").depth_range.far, 0.1F);
}

TEST(FragmentOperations, DepthTestsAreRead) {
  const auto test = [](const std::string& text) {
    return draw_of("\"depth\": " + text).operations.depth;
  };
  for (const CompareFunction function :
       {CompareFunction::never, CompareFunction::less, CompareFunction::equal,
        CompareFunction::lequal, CompareFunction::greater, CompareFunction::notequal,
        CompareFunction::gequal, CompareFunction::always}) {
    const std::string name = std::string("\"") + name_of(function) + "\"";
    EXPECT_EQ(test(name), (DepthTest{function, true}));
    EXPECT_EQ(test("{\"test\": " + name + "}"), (DepthTest{function, true}));
    EXPECT_EQ(test("{\"write\": false, \"test\": " + name + "}"), (DepthTest{function, false}));
  }
  EXPECT_EQ(test("\"off\""), (DepthTest{CompareFunction::always, false}));
  EXPECT_EQ(test("{}"), DepthTest{});
  // What neither tests nor writes needs no buffer.
  EXPECT_FALSE(scene_of("\"samples\": 1", R"("depth": "off")").draws.at(0).operations.depth.write);
}

TEST(FragmentOperations, StencilTestsAreReadForBothFaces) {
  const auto test = [](const std::string& text) {
    return draw_of("\"stencil\": " + text).operations.stencil.value();
  };
  const StencilFace face{
      CompareFunction::greater, 1, 2, 3, StencilOperation::zero, StencilOperation::incr_wrap,
      StencilOperation::replace};
  const std::string text =
      R"({"test": "greater", "reference": 1, "read_mask": 2, "write_mask": 3, "fail": "zero",
          "depth_fail": "incr_wrap", "pass": "replace"})";
  EXPECT_EQ(test(text), (StencilTest{face, face}));
  EXPECT_EQ(test("{\"front\": " + text + "}"), (StencilTest{face, StencilFace{}}));
  EXPECT_EQ(test("{\"back\": " + text + "}"), (StencilTest{StencilFace{}, face}));
  EXPECT_EQ(test("{\"back\": " + text + ", \"front\": {\"pass\": \"invert\"}}").front.pass,
            StencilOperation::invert);
  EXPECT_EQ(test("{}"), StencilTest{});
}

TEST(FragmentOperations, BlendingIsRead) {
  const auto blending = [](const std::string& text) {
    return draw_of("\"blend\": " + text).operations.blending.value();
  };
  constexpr auto kAdd = BlendEquation::add;
  using enum BlendFactor;
  const BlendTerm over{kAdd, one, one_minus_src_alpha};
  EXPECT_EQ(blending("\"over\""), (Blending{{kAdd, src_alpha, one_minus_src_alpha}, over, {}}));
  EXPECT_EQ(blending("\"premultiplied-over\""), (Blending{over, over, {}}));
  EXPECT_EQ(blending("\"add\""), (Blending{{kAdd, one, one}, {kAdd, one, one}, {}}));
  EXPECT_EQ(blending("\"multiply\""),
            (Blending{{kAdd, dst_color, zero}, {kAdd, dst_color, zero}, {}}));
  const BlendTerm term{BlendEquation::subtract, constant_alpha, src_alpha_saturate};
  const std::string text =
      R"("equation": "subtract", "source": "constant_alpha", "destination": "src_alpha_saturate")";
  EXPECT_EQ(blending("{" + text + "}"), (Blending{term, term, {}}));
  EXPECT_EQ(blending("{\"constant\": [0, 0.5, 1], " + text + "}"),
            (Blending{term, term, {0, 0.5F, 1, 1}}));
  EXPECT_EQ(blending("{\"constant\": [0, 0.1, 1, 0.25], \"alpha\": {" + text +
                     "}, \"color\": {\"equation\": \"min\"}}"),
            (Blending{{BlendEquation::min, one, zero}, term, {0, 0.1F, 1, 0.25F}}));
}

TEST(FragmentOperations, MasksFacesAndOffsetsAreRead) {
  const char* const letters[] = {"r", "g", "b", "a"};
  for (int bits = 0; bits < 16; ++bits) {
    std::string text;
    for (int i = 0; i < 4; ++i) text += (bits >> i & 1) != 0 ? letters[i] : "";
    const Draw draw = draw_of("\"color_mask\": \"" + text + "\"");
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_EQ(draw.operations.color_mask[i], (bits >> i & 1) != 0) << text;
  }
  for (const CullMode mode :
       {CullMode::none, CullMode::front, CullMode::back, CullMode::front_and_back})
    EXPECT_EQ(draw_of(std::string("\"cull\": \"") + name_of(mode) + "\"").cull, mode);
  EXPECT_EQ(draw_of(R"("front_face": "cw")").front_face, FrontFace::cw);
  EXPECT_EQ(draw_of(R"("front_face": "ccw")").front_face, FrontFace::ccw);
  EXPECT_EQ(draw_of(R"("polygon_offset": {})").polygon_offset, PolygonOffset{});
  EXPECT_EQ(draw_of(R"("polygon_offset": {"factor": -1, "units": "~0.1", "clamp": "1/4"})")
                .polygon_offset,
            (PolygonOffset{-1, 0.1F, 0.25F}));
}

// The front face is one of the window, whichever way the file counts y.
TEST(FragmentOperations, FacesDoNotTurnWithY) {
  EXPECT_EQ(scene_of("\"y\": \"down\"", R"("front_face": "cw")").draws.at(0).front_face,
            FrontFace::cw);
  EXPECT_EQ(scene_of("\"y\": \"down\"", "").draws.at(0).front_face, FrontFace::ccw);
}

TEST(FragmentOperations, CullingAndOffsetsComeTogetherWithSupersampling) {
  const Scene scene =
      scene_of(R"("depth": "depth16", "depth_range": [1, 0], "supersample": {"grid": 2})",
               R"("cull": "back", "front_face": "cw", "polygon_offset": {"units": 3},
                  "depth": "always", "color_mask": "rgba")");
  EXPECT_FALSE(has_fragment_operations(scene));
  EXPECT_EQ(scene.supersampling.size(), 4U);
  EXPECT_EQ(scene.draws.at(0).polygon_offset.value().units, 3);
}

// One fault is told once: of a buffer whose format is faulty, nobody knows whether it is there.
TEST(FragmentOperations, AFaultyFormatIsNoMissingBuffer) {
  const auto count = [](const std::string& target, const std::string& state) {
    return load(target, state).diagnostics.size();
  };
  const std::string clears = R"(, "clear_depth": 0.5)";
  EXPECT_EQ(
      count(R"("depth": "depth8")" + clears, R"("depth": "less", "polygon_offset": {"units": 1})"),
      1U);
  EXPECT_EQ(count(R"("stencil": 8, "clear_stencil": 1)", R"("stencil": {})"), 1U);
  EXPECT_EQ(count("\"samples\": 1" + clears, R"("depth": "less", "polygon_offset": {})"), 3U);
}

TEST(FragmentOperations, EveryCaseComesBack) {
  const fs::path file = fs::path(EDGECASE_ROOT) / "tests/casefile/good/operations-everything.json";
  std::size_t count = 0;
  for (const Case& one : load_cases(file, "operations").cases) {
    SCOPED_TRACE(one.id);
    EXPECT_TRUE(has_fragment_operations(one.scene));
    const CaseText text = written(one.scene);
    for (const Diagnostic& fault : text.diagnostics) ADD_FAILURE() << to_string(fault);
    const LoadedCases read = load_cases_text(text.text, "a.json", "another");
    ASSERT_EQ(read.cases.size(), 1U) << text.text;
    EXPECT_TRUE(same_scene(read.cases[0].scene, one.scene)) << text.text;
    EXPECT_EQ(written(read.cases[0].scene).text, text.text);
    ++count;
  }
  EXPECT_EQ(count, 2U * 3 * 2 * 2 * 3 * 2 * 2);
}

TEST(FragmentOperations, SweptValuesArriveWhereTheyAreSet) {
  const fs::path file = fs::path(EDGECASE_ROOT) / "tests/casefile/good/operations-everything.json";
  const LoadedCases loaded = load_cases(file, "a");
  ASSERT_FALSE(loaded.cases.empty());
  const Scene& last = loaded.cases.back().scene;
  EXPECT_EQ(last.target.samples, 4);
  EXPECT_EQ(last.target.clear_depth, 1);
  EXPECT_EQ(last.target.clear_stencil, 8);
  EXPECT_EQ(last.depth_range, (DepthRange{1, 1}));
  const Draw& triangle = last.draws.at(0);
  EXPECT_EQ(triangle.operations.depth, (DepthTest{CompareFunction::always, false}));
  EXPECT_EQ(triangle.operations.stencil->front.reference, 1);
  EXPECT_EQ(triangle.operations.stencil->back.pass, StencilOperation::decr_wrap);
  EXPECT_EQ(triangle.operations.color_mask, FragmentOperations().color_mask);
  EXPECT_EQ(triangle.cull, CullMode::front_and_back);
  EXPECT_EQ(triangle.polygon_offset->units, 65536);
  EXPECT_EQ(loaded.cases.front().scene.draws.at(0).polygon_offset->units, 0x1p-20F);
  EXPECT_EQ(last.draws.at(1).operations.blending->color.destination,
            BlendFactor::one_minus_src_alpha);
  EXPECT_EQ(last.draws.at(2).operations.depth, DepthTest{});
  EXPECT_EQ(last.draws.at(2).operations.blending->alpha.source, BlendFactor::src_alpha);
}

// Of anything that a test, a stencil state or a blending can be.
FragmentOperations random_operations(RandomScenes& scenes) {
  const auto function = [&] { return static_cast<CompareFunction>(scenes.below(8)); };
  const auto byte = [&] { return static_cast<std::uint8_t>(scenes.below(256)); };
  const auto face = [&] {
    const auto operation = [&] { return static_cast<StencilOperation>(scenes.below(8)); };
    return scenes.below(3) == 0 ? StencilFace{}
                                : StencilFace{function(),  byte(),      byte(),     byte(),
                                              operation(), operation(), operation()};
  };
  const auto term = [&] {
    const auto factor = [&] { return static_cast<BlendFactor>(scenes.below(15)); };
    BlendTerm result{static_cast<BlendEquation>(scenes.below(5)), factor(), factor()};
    if (result.equation >= BlendEquation::min) result = {result.equation};
    return result;
  };
  const auto part = [&] { return static_cast<float>(scenes.below(3000001)) / 3000001.0F; };
  FragmentOperations operations;
  operations.depth = {function(), scenes.below(2) == 0};
  if (scenes.below(2) == 0) operations.stencil = StencilTest{face(), face()};
  if (scenes.below(2) == 0) {
    operations.blending = Blending{term(), term(), {}};
    if (scenes.below(2) == 0) operations.blending->alpha = operations.blending->color;
    if (scenes.below(2) == 0) operations.blending->constant = {part(), part(), part(), part()};
  }
  for (bool& written : operations.color_mask) written = scenes.below(3) != 0;
  return operations;
}

TEST(FragmentOperations, RandomOnesComeBack) {
  RandomScenes scenes(8);
  for (int round = 0; round < 1000; ++round) {
    Scene scene = scene_of(kBuffers, "");
    scene.target.clear_depth = static_cast<float>(scenes.below(1000003)) / 1000003.0F;
    scene.target.clear_stencil = static_cast<std::uint8_t>(scenes.below(256));
    scene.depth_range.near = static_cast<float>(scenes.below(3)) / 3;
    Draw& draw = scene.draws[0];
    draw.front_face = static_cast<FrontFace>(scenes.below(2));
    draw.cull = static_cast<CullMode>(scenes.below(4));
    if (scenes.below(2) == 0)
      draw.polygon_offset = PolygonOffset{static_cast<float>(scenes.below(7)) / 3 - 1,
                                          scenes.below(2) == 0 ? 0 : 0.1F, -0.1F};
    draw.operations = random_operations(scenes);
    const CaseText text = written(scene);
    for (const Diagnostic& fault : text.diagnostics) ADD_FAILURE() << to_string(fault);
    if (HasFailure()) return;
  }
}

std::string state_text(const Draw& draw) {
  Scene scene = scene_of(kBuffers, "");
  scene.draws[0].front_face = draw.front_face;
  scene.draws[0].polygon_offset = draw.polygon_offset;
  scene.draws[0].operations = draw.operations;
  const std::string text = written(scene).text;
  const std::size_t at = text.find("\"state\": ");
  return at == std::string::npos ? "" : text.substr(at + 9, text.find("\n", at) - at - 9);
}

TEST(FragmentOperations, AreWrittenInTheirShortestForm) {
  for (const char* state :
       {R"({"depth": "less"})", R"({"depth": "off"})",
        R"({"depth": {"test": "less", "write": false}})", R"({"stencil": {}})",
        R"({"stencil": {"test": "equal", "reference": 3}})",
        R"({"stencil": {"back": {"pass": "incr"}}})", R"({"blend": "over"})",
        R"({"blend": "premultiplied-over"})", R"({"blend": "add"})", R"({"blend": "multiply"})",
        R"({"blend": {"equation": "max"}})",
        R"({"blend": {"source": "one", "destination": "zero"}})",
        R"({"blend": {"source": "one", "destination": "one", "constant": [0, 0, 0]}})",
        R"({"color_mask": ""})", R"({"color_mask": "ga"})", R"({"front_face": "cw"})",
        R"({"polygon_offset": {"units": 2}})", R"({"polygon_offset": {}})"}) {
    const std::string inner(state);
    EXPECT_EQ(state_text(draw_of(inner.substr(1, inner.size() - 2))), state);
  }
  EXPECT_EQ(state_text(draw_of(R"("depth": "always", "color_mask": "rgba", "cull": "none")")), "");
}

TEST(FragmentOperations, WhatNoFileCanSayIsRefused) {
  Scene scene = scene_of(kBuffers, R"("blend": {"equation": "min"})");
  scene.draws[0].operations.blending->color.source = BlendFactor::zero;
  EXPECT_TRUE(written(scene).text.empty());
  scene = scene_of(kBuffers, R"("depth": "less")");
  scene.target.depth = DepthFormat::none;
  ASSERT_EQ(written(scene).diagnostics.size(), 1U);
  EXPECT_EQ(written(scene).diagnostics[0].pointer, "/draws/0/state/depth");
}

}  // namespace
}  // namespace edgecase
