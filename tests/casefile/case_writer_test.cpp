// SPDX-License-Identifier: MIT
//
// What the writer writes, the loader reads back to the very same scene: for every case of the suite
// and for random scenes. What a case file cannot say is refused, and why.
#include "casefile/case_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "casefile/loader.h"
#include "casefile/scene/viewport.h"
#include "model/scene.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

namespace fs = std::filesystem;

CaseWords words_of(const Case& one) {
  return {"", one.title, one.why, one.rules, one.spec, one.origin, one.tags};
}

CaseWords some_words() {
  CaseWords words;
  words.title = "A scene";
  words.rules = {"line.diamond-exit"};
  return words;
}

// Reads a text back under an id that salts colours otherwise than any id of the suite.
void expect_comes_back(const Scene& scene, const CaseWords& words) {
  const CaseText written = case_text(scene, words);
  for (const Diagnostic& diagnostic : written.diagnostics) ADD_FAILURE() << to_string(diagnostic);
  ASSERT_FALSE(written.text.empty());
  const LoadedCases read = load_cases_text(written.text, "a.json", "quite/another");
  ASSERT_EQ(read.cases.size(), 1U) << written.text;
  const Case& one = read.cases.front();
  EXPECT_EQ(one.id, "quite/another");
  EXPECT_TRUE(same_scene(one.scene, scene)) << written.text;
  EXPECT_EQ(one.title, words.title);
  EXPECT_EQ(one.why, words.why);
  EXPECT_EQ(one.rules, words.rules);
  EXPECT_EQ(one.spec, words.spec);
  EXPECT_EQ(one.origin, words.origin);
  EXPECT_EQ(one.tags, words.tags);
  EXPECT_EQ(case_text(one.scene, words).text, written.text);
}

// Of a sweep, whose cases differ in numbers alone, every fifth and the first.
TEST(CaseWriter, EveryFileOfTheSuiteComesBack) {
  constexpr std::size_t kStep = 5;
  const fs::path suite[] = {fs::path(EDGECASE_ROOT) / "cases"};
  std::size_t count = 0;
  Dealer files;
  for (const CaseFile& file : find_cases(suite).cases) {
    if (!files.deal()) continue;
    const LoadedCases loaded = load_cases(file.file, file.id);
    for (std::size_t i = 0; i < loaded.cases.size(); i += kStep) {
      const Case& one = loaded.cases[i];
      SCOPED_TRACE(one.id);
      expect_comes_back(one.scene, words_of(one));
      ++count;
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(count, least_of(6000U));
}

TEST(CaseWriter, RandomScenesComeBack) {
  RandomScenes scenes(4);
  for (int round = 0; round < 3000; ++round) {
    const std::int64_t step = std::int64_t{1} << scenes.below(17);
    Scene scene = scenes.next({1 + scenes.below(40), step, 4, true});
    for (Draw& draw : scene.draws) {
      draw.line_width = Fixed::from_raw(1 + scenes.below(64 * 65536));
      draw.point_size = Fixed::from_raw(1 + scenes.below(64 * 65536));
      if (scenes.below(3) == 0) draw.scissor = Viewport{-1, scenes.below(5), scenes.below(5), 3};
      draw.vertices[0].color[3] = static_cast<float>(scenes.below(1000003)) / 1000003.0F;
    }
    if (scenes.below(2) == 0) scene.target.surface = Surface::window;
    scene.viewport = choose_viewport(scene.target, scene.draws).value();
    // Another viewport that holds the same vertices is written, and read back.
    if (scenes.below(2) == 0) {
      scene.viewport.x -= scene.viewport.width;
      scene.viewport.width *= 2;
    }
    // A coordinate may be too fine for the viewport that was made larger; the loader then says so.
    const CaseText written = case_text(scene, some_words());
    if (!written.diagnostics.empty()) {
      EXPECT_NE(written.diagnostics[0].message.find("significant bits"), std::string::npos)
          << to_string(written.diagnostics[0]);
      continue;
    }
    expect_comes_back(scene, some_words());
    if (HasFailure()) return;
  }
}

TEST(CaseWriter, EveryWayToGiveAVertexComesBack) {
  const fs::path file = fs::path(EDGECASE_ROOT) / "tests/casefile/good/values-everything.json";
  const LoadedCases loaded = load_cases(file, "values");
  EXPECT_GT(loaded.cases.size(), 100U);
  for (const Case& one : loaded.cases) {
    SCOPED_TRACE(one.id);
    EXPECT_TRUE(one.scene.details.any());
    expect_comes_back(one.scene, words_of(one));
    if (HasFailure()) return;
  }
}

// Any float32 numbers, on the grid of the model: one in four lies outside of the clip volume.
Vertex random_clip_vertex(RandomScenes& scenes, const Viewport& viewport) {
  const auto part = [&] {
    return static_cast<float>(scenes.below(2000001) - 1000000) / 1000001.0F;
  };
  const float w = std::ldexp(1.0F + std::fabs(part()), scenes.below(36) - 20);
  const float reach = scenes.below(4) == 0 ? 8.0F : 1.0F;
  const auto coordinate = [&] { return reach * w * part() * std::ldexp(1.0F, -scenes.below(30)); };
  Vertex vertex;
  vertex.clip = round_to_grid({coordinate(), coordinate(), coordinate(), w});
  vertex.color = {part() * 1e6F, part(), part() * 1e-6F, 1};
  place_clip_vertex(viewport, vertex);
  return vertex;
}

TEST(CaseWriter, RandomValuesComeBack) {
  RandomScenes scenes(5);
  constexpr DepthFormat kFormats[] = {DepthFormat::none, DepthFormat::depth16, DepthFormat::depth24,
                                      DepthFormat::depth32f};
  for (int round = 0; round < 1500; ++round) {
    Scene scene = blank_scene(1 + scenes.below(40), 1 + scenes.below(40));
    scene.target.depth = kFormats[scenes.below(4)];
    scene.details = {scenes.below(2) == 0, scenes.below(2) == 0};
    scene.viewport = scenes.below(2) == 0 ? clip_viewport(scene.target) : Viewport{-3, 5, 50, 21};
    Draw draw;
    draw.primitive = Primitive::triangles;
    for (int i = 0; i < 3; ++i) draw.vertices.push_back(random_clip_vertex(scenes, scene.viewport));
    scene.draws.push_back(draw);
    const Point points[] = {pixel_centre(0, 6)};
    Draw other = make_draw(Primitive::points, points);
    other.vertices[0].w = std::ldexp(1.0F, scenes.below(41) - 20);
    if (scene.viewport.x == -3) scene.viewport = {-3, 5, 64, 16};
    for (Vertex& vertex : scene.draws[0].vertices) place_clip_vertex(scene.viewport, vertex);
    if (scene.viewport.y + scene.viewport.height > 6) scene.draws.push_back(other);
    expect_comes_back(scene, some_words());
    if (HasFailure()) return;
  }
}

TEST(CaseWriter, WritesValuesWithAllTheirDigits) {
  Scene scene = blank_scene(8, 8);
  scene.target.depth = DepthFormat::depth16;
  scene.details.coordinates = true;
  const Point points[] = {pixel_centre(1, 1), pixel_centre(2, 2)};
  Draw draw = make_draw(Primitive::lines, points);
  for (Vertex& vertex : draw.vertices) vertex.color = {-1, 2.5F, 1e10F, 1};
  draw.vertices[0].z = Fixed();
  draw.vertices[0].w = 8;
  draw.vertices[1].clip = ClipPosition{0.25F, -0.5F, 0, 0.7F};
  place_clip_vertex(scene.viewport, draw.vertices[1]);
  scene.draws = {draw};
  EXPECT_EQ(case_text(scene, some_words()).text, R"({
  "title": "A scene",
  "rules": ["line.diamond-exit"],
  "target": {"width": 8, "height": 8, "depth": "depth16", "clear": [0, 0, 0]},
  "details": ["coordinates"],
  "draws": [
    {
      "primitive": "lines",
      "vertices": [[1.5, 1.5, 0, 8], {"clip": [0.25, -0.5, 0, 0.699999988079071044921875]}],
      "color": [-1, 2.5, 1e+10]
    }
  ]
}
)");
}

TEST(CaseWriter, WritesAsAPersonWould) {
  Scene scene = blank_scene(8, 4);
  const Point from{Fixed::from_raw(21 * Fixed::kOne / 8), Fixed::from_integer(1)};
  const Point to{Fixed::from_raw(6 * Fixed::kOne + 3 * Fixed::kOne / 256), Fixed::from_integer(3)};
  const Point ends[] = {from, to};
  scene.draws = {make_draw(Primitive::lines, ends), make_draw(Primitive::line_strip, ends)};
  for (Vertex& vertex : scene.draws[0].vertices) vertex.z = Fixed();
  for (Vertex& vertex : scene.draws[1].vertices) vertex.color = {1, 0.5F, 0, 1};
  scene.draws[1].interpolation = Interpolation::smooth;
  CaseWords words = some_words();
  words.schema = "../case.schema.json";
  words.why = "It \"crosses\" a corner.";
  EXPECT_EQ(case_text(scene, words).text, R"({
  "$schema": "../case.schema.json",
  "title": "A scene",
  "why": "It \"crosses\" a corner.",
  "rules": ["line.diamond-exit"],
  "target": {"width": 8, "height": 4, "clear": [0, 0, 0]},
  "draws": [
    {
      "primitive": "lines",
      "vertices": [
        {"at": [2.625, 1], "color": [0.43137255, 0.078431375, 0.15686275]},
        {"at": ["6+3/256", 3], "color": [0.5764706, 0.078431375, 0.16078432]}
      ]
    },
    {
      "primitive": "line_strip",
      "vertices": [[2.625, 1, -1], ["6+3/256", 3, -0.875]],
      "color": [1, 0.5, 0],
      "state": {"interpolation": "smooth"}
    }
  ]
}
)");
}

// The message of the one fault that a scene has.
std::string fault_of(const Scene& scene, const CaseWords& words = some_words()) {
  const CaseText written = case_text(scene, words);
  EXPECT_TRUE(written.text.empty());
  if (written.diagnostics.empty()) return "none";
  EXPECT_FALSE(written.diagnostics[0].remedy.empty());
  return to_string(written.diagnostics[0]);
}

TEST(CaseWriter, SaysWhatACaseFileCannotSay) {
  Scene scene = blank_scene(8, 8);
  const Point ends[] = {pixel_centre(1, 1), pixel_centre(6, 9)};
  scene.draws = {make_draw(Primitive::lines, ends)};
  EXPECT_NE(fault_of(scene).find("/draws/0/vertices/1/at/1: y = 9.5 does not lie strictly inside "
                                 "the viewport"),
            std::string::npos)
      << fault_of(scene);
  scene.draws[0].vertices[1].position.y = Fixed::from_integer(3);
  EXPECT_TRUE(case_text(scene, some_words()).diagnostics.empty());
  Scene samples = scene;
  samples.target.samples = 17;
  EXPECT_NE(fault_of(samples).find("samples is 17, out of range"), std::string::npos);
  Scene bright = scene;
  bright.target.clear[0] = 1.5F;
  EXPECT_NE(fault_of(bright).find("out of range"), std::string::npos);
  Scene clipped = scene;
  clipped.viewport = {0, 0, 8, 8};
  clipped.draws[0].vertices[0].clip = ClipPosition{0, 0, 0, 0};
  EXPECT_NE(fault_of(clipped).find("clip coordinates (0, 0, 0, 0), out of range"),
            std::string::npos);
  clipped.draws[0].vertices[0].clip.reset();
  clipped.draws[0].vertices[0].w = 0.1F;
  clipped.draws[0].vertices[0].position.x = Fixed::from_raw(3 * Fixed::kOne + 12345);
  EXPECT_NE(fault_of(clipped).find("with w = 0.1"), std::string::npos) << fault_of(clipped);
  bright.target.clear[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(fault_of(bright), "none");
  EXPECT_NE(fault_of(Scene{}), "none");
  EXPECT_NE(fault_of(scene, CaseWords{}).find("title"), std::string::npos);
  CaseWords words = some_words();
  words.title = "\xFF";
  EXPECT_NE(fault_of(scene, words).find("UTF-8"), std::string::npos);
  words = some_words();
  words.origin = "a mail";
  EXPECT_NE(fault_of(scene, words).find("no link"), std::string::npos);
}

}  // namespace
}  // namespace edgecase
