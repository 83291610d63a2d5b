// SPDX-License-Identifier: MIT
#include "casefile/scaffold.h"

#include <gtest/gtest.h>

#include "casefile/loader.h"

namespace edgecase {
namespace {

ScaffoldDraw draw_of(std::string_view text) {
  auto parsed = parse_scaffold_draw(text);
  EXPECT_TRUE(std::holds_alternative<ScaffoldDraw>(parsed)) << text;
  return std::get<ScaffoldDraw>(std::move(parsed));
}

Scaffold scaffold_of(std::vector<ScaffoldDraw> draws) {
  Scaffold scaffold;
  scaffold.words.title = "Title";
  scaffold.words.rules = {"line.snap"};
  scaffold.draws = std::move(draws);
  scaffold.width = scaffold.height = least_target(scaffold.draws);
  return scaffold;
}

Scene load(const std::string& text) {
  LoadedCases loaded = load_cases_text(text, "test.json", "test");
  EXPECT_EQ(loaded.cases.size(), 1U) << text;
  return loaded.cases.front().scene;
}

TEST(Scaffold, ReadsPrimitivesAndVertices) {
  const ScaffoldDraw draw = draw_of(" line_strip  1,2 ~0.1,1+1/2,0.5  3,4,0,2 ");
  EXPECT_EQ(draw.primitive, "line_strip");
  EXPECT_EQ(draw.vertices, (std::vector<std::vector<std::string>>{
                               {"1", "2"}, {"~0.1", "1+1/2", "0.5"}, {"3", "4", "0", "2"}}));
}

TEST(Scaffold, RefusesWhatIsNoDraw) {
  for (const char* text : {"", " ", "lines", "lines 1", "lines 1,2,3,4,5", "lines 1,2 3"})
    EXPECT_TRUE(std::holds_alternative<std::string>(parse_scaffold_draw(text))) << text;
}

TEST(Scaffold, TargetsArePowersOfTwoThatHoldAllVertices) {
  EXPECT_EQ(least_target({}), 8);
  EXPECT_EQ(least_target({draw_of("points 8,8")}), 8);
  EXPECT_EQ(least_target({draw_of("points 8,8+1/65536")}), 16);
  EXPECT_EQ(least_target({draw_of("points 1,1"), draw_of("points 300,1")}), 512);
  EXPECT_EQ(least_target({draw_of("points 5000,1")}), 4096);
  EXPECT_EQ(least_target({draw_of("points nonsense,1")}), 8);
}

TEST(Scaffold, LoadsAsTheSceneThatWasSaid) {
  Scaffold scaffold = scaffold_of({draw_of("lines 0.5,1 9,1+1/2")});
  scaffold.samples = 4;
  scaffold.depth = "depth24";
  scaffold.words.why = "Why";
  const Scene scene = load(scaffold_text(scaffold));
  EXPECT_EQ(scene.target.width, 16);
  EXPECT_EQ(scene.target.samples, 4);
  EXPECT_EQ(scene.target.depth, DepthFormat::depth24);
  ASSERT_EQ(scene.draws.size(), 1U);
  EXPECT_EQ(scene.draws[0].primitive, Primitive::lines);
  EXPECT_EQ(scene.draws[0].vertices[1].position.y, Fixed::from_raw(3 * Fixed::kOne / 2));
}

TEST(Scaffold, NumeralsStandAsGiven) {
  const std::string text = scaffold_text(scaffold_of({draw_of("points 1.50,~0.3")}));
  EXPECT_NE(text.find("[1.50, \"~0.3\"]"), std::string::npos) << text;
  // "1,2" would be two numbers in JSON, "true" none.
  EXPECT_NE(scaffold_text(scaffold_of({draw_of("points true,[1]")})).find("[\"true\", \"[1]\"]"),
            std::string::npos);
}

TEST(Scaffold, DrawingsStandInFull) {
  const std::string text = scaffold_text(scaffold_of({draw_of("points 0.5,0.5")}));
  std::vector<std::string> rows(8, "........");
  rows.back() = "#.......";
  const std::string drawn = with_drawing(text, rows);
  EXPECT_NE(drawn.find("\"coverage\": [\n        \"........\",\n"), std::string::npos) << drawn;
  const LoadedCases loaded = load_cases_text(drawn, "test.json", "test");
  ASSERT_EQ(loaded.cases.size(), 1U);
  ASSERT_EQ(loaded.cases[0].expect.size(), 1U);
  EXPECT_EQ(loaded.cases[0].expect[0].coverage[0], 1);
}

TEST(Scaffold, ColoursAreLeftToTheLoader) {
  const char* colored =
      "{\"title\": \"T\", \"rules\": [\"line.snap\"],"
      " \"target\": {\"width\": 8, \"height\": 8, \"clear\": [1, 0, 0]},"
      " \"draws\": [{\"primitive\": \"points\", \"vertices\": [[1.5, 1.5]], \"color\": [1, 1, 1]},"
      "  {\"primitive\": \"points\", \"vertices\": [{\"at\": [2.5, 1.5], \"color\": [0, 1, 1]}]}]}";
  const std::string text = without_colors(colored);
  EXPECT_EQ(text.find("color"), std::string::npos);
  EXPECT_EQ(text.find("clear"), std::string::npos);
  EXPECT_NE(text.find("[[2.5, 1.5]]"), std::string::npos) << text;
  EXPECT_EQ(load(text).draws[1].vertices[0].position.x, Fixed::from_raw(5 * Fixed::kOne / 2));
}

}  // namespace
}  // namespace edgecase
