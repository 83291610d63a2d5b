// SPDX-License-Identifier: MIT
//
// Variants: every image of hand-made scenes, vertex by vertex.
#include <gmock/gmock.h>

#include <map>
#include <string>
#include <vector>

#include "casefile/loader.h"
#include "exact/numeral.h"

namespace edgecase {
namespace {

using testing::ElementsAre;

constexpr const char* kSpots =
    R"([[1, 2], [2, 3], [3, 4], [4, 5], [5, 6], [6, 7]])";  // six vertices, told by x

// The cases of a file by what follows the id of the file.
std::map<std::string, Case> load(const std::string& draws, const std::string& variants,
                                 const std::string& target = R"("width": 8, "height": 8)") {
  const LoadedCases loaded =
      load_cases_text(R"({"title": "t", "rules": ["a.b"], "target": {)" + target +
                          R"(}, "draws": [)" + draws + R"(], "variants": )" + variants + "}",
                      "a.json", "a");
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  std::map<std::string, Case> result;
  for (const Case& one : loaded.cases) result[one.id.substr(1)] = one;
  return result;
}

std::string six(const std::string& primitive) {
  return R"({"primitive": ")" + primitive + R"(", "vertices": )" + kSpots + "}";
}

// "x,y" of each vertex.
std::vector<std::string> spots(const Case& one, std::size_t draw = 0) {
  std::vector<std::string> result;
  for (const Vertex& vertex : one.scene.draws[draw].vertices)
    result.push_back(to_decimal(vertex.position.x) + "," + to_decimal(vertex.position.y));
  return result;
}

std::string columns(const Case& one) {
  std::string result;
  for (const Vertex& vertex : one.scene.draws[0].vertices) result += to_decimal(vertex.position.x);
  return result;
}

TEST(Variants, ReverseStaysWithinSeparatePrimitives) {
  EXPECT_EQ(columns(load(six("lines"), R"(["reverse"])").at(":reverse")), "214365");
  EXPECT_EQ(columns(load(six("triangles"), R"(["reverse"])").at(":reverse")), "321654");
  EXPECT_EQ(columns(load(six("line_strip"), R"(["reverse"])").at(":reverse")), "654321");
  EXPECT_EQ(columns(load(six("line_loop"), R"(["reverse"])").at(":reverse")), "654321");
  EXPECT_EQ(columns(load(six("triangle_strip"), R"(["reverse"])").at(":reverse")), "654321");
  EXPECT_EQ(columns(load(six("triangle_fan"), R"(["reverse"])").at(":reverse")), "165432");
  EXPECT_EQ(columns(load(six("lines"), R"(["reverse"])").at("")), "123456");
}

TEST(Variants, ReverseTakesColoursAlong) {
  const auto cases =
      load(R"({"primitive": "lines", "vertices": [[1, 1], {"at": [2, 2], "color": [1, 0, 0]}]})",
           R"(["reverse"])");
  const Draw& draw = cases.at(":reverse").scene.draws[0];
  EXPECT_EQ(draw.vertices[0].color, (Color{1, 0, 0, 1}));
  EXPECT_NE(draw.vertices[1].color, cases.at("").scene.draws[0].vertices[0].color);
}

TEST(Variants, WindingExchangesSecondAndThird) {
  EXPECT_EQ(columns(load(six("triangles"), R"(["winding"])").at(":winding")), "132465");
}

TEST(Variants, TranslateMovesEverythingAndGrowsTheTarget) {
  const auto cases = load(
      R"({"primitive": "lines", "vertices": [[1, 2], ["-1/256", 3]],
          "state": {"scissor": {"x": 1, "y": 0, "width": 2, "height": 5}}})",
      R"(["translate"])",
      R"("width": 4, "height": 8, "viewport": {"x": -4, "y": 0, "width": 8, "height": 16})");
  ASSERT_EQ(cases.size(), 2U);
  const Scene& scene = cases.at(":translate=3,2").scene;
  EXPECT_THAT(spots(cases.at(":translate=3,2")), ElementsAre("4,4", "2.99609375,5"));
  EXPECT_EQ(scene.target.width, 7);
  EXPECT_EQ(scene.target.height, 10);
  EXPECT_EQ(scene.viewport.x, -1);
  EXPECT_EQ(scene.viewport.y, 2);
  EXPECT_EQ(scene.viewport.width, 8);
  ASSERT_TRUE(scene.draws[0].scissor.has_value());
  EXPECT_EQ(scene.draws[0].scissor->x, 4);
  EXPECT_EQ(scene.draws[0].scissor->y, 2);
  EXPECT_EQ(scene.draws[0].scissor->width, 2);
  EXPECT_EQ(scene.draws[0].scissor->height, 5);
}

// In a target of 8 x 4 pixels (1, 0.5) becomes (7, 0.5), (1, 3.5), (7, 3.5), and these transposed.
TEST(Variants, OctantsOfARectangularTarget) {
  const auto cases = load(
      R"({"primitive": "lines", "vertices": [[1, 0.5], ["2+1/256", 3]],
          "state": {"scissor": {"x": 1, "y": 0, "width": 5, "height": 3}}})",
      R"(["octants"])",
      R"("width": 8, "height": 4, "viewport": {"x": 0, "y": -2, "width": 16, "height": 8})");
  ASSERT_EQ(cases.size(), 8U);
  const auto at = [&](const char* octant) { return spots(cases.at(octant)); };
  EXPECT_THAT(at(""), ElementsAre("1,0.5", "2.00390625,3"));
  EXPECT_THAT(at(":octant=1"), ElementsAre("7,0.5", "5.99609375,3"));
  EXPECT_THAT(at(":octant=2"), ElementsAre("1,3.5", "2.00390625,1"));
  EXPECT_THAT(at(":octant=3"), ElementsAre("7,3.5", "5.99609375,1"));
  EXPECT_THAT(at(":octant=4"), ElementsAre("0.5,1", "3,2.00390625"));
  EXPECT_THAT(at(":octant=5"), ElementsAre("0.5,7", "3,5.99609375"));
  EXPECT_THAT(at(":octant=6"), ElementsAre("3.5,1", "1,2.00390625"));
  EXPECT_THAT(at(":octant=7"), ElementsAre("3.5,7", "1,5.99609375"));
}

TEST(Variants, OctantsTurnTargetViewportAndScissor) {
  const auto cases = load(
      R"({"primitive": "lines", "vertices": [[1, 1], [2, 3]],
          "state": {"scissor": {"x": 1, "y": 0, "width": 5, "height": 3}}})",
      R"(["octants"])",
      R"("width": 8, "height": 4, "viewport": {"x": 0, "y": -2, "width": 16, "height": 8})");
  const auto rectangle = [](const Viewport& r) { return std::vector{r.x, r.y, r.width, r.height}; };
  const Scene& mirrored = cases.at(":octant=3").scene;
  EXPECT_EQ(mirrored.target.width, 8);
  EXPECT_THAT(rectangle(mirrored.viewport), ElementsAre(-8, -2, 16, 8));
  EXPECT_THAT(rectangle(*mirrored.draws[0].scissor), ElementsAre(2, 1, 5, 3));
  const Scene& turned = cases.at(":octant=5").scene;
  EXPECT_EQ(turned.target.width, 4);
  EXPECT_EQ(turned.target.height, 8);
  EXPECT_THAT(rectangle(turned.viewport), ElementsAre(-2, -8, 8, 16));
  EXPECT_THAT(rectangle(*turned.draws[0].scissor), ElementsAre(0, 2, 3, 5));
}

TEST(Variants, AddUpAndEachHasColoursOfItsOwn) {
  const auto cases = load(six("triangles"), R"(["reverse", "winding", "octants", "translate"])");
  EXPECT_EQ(cases.size(), 11U);
  std::vector<Color> clears;
  for (const auto& [part, one] : cases) {
    EXPECT_THAT(clears, testing::Not(testing::Contains(one.scene.target.clear))) << part;
    clears.push_back(one.scene.target.clear);
    EXPECT_EQ(":" + (one.parts.empty() ? "" : one.parts[0]), part.empty() ? ":" : part);
  }
}

TEST(Variants, ReachingOutOfRangeIsRefused) {
  const LoadedCases loaded = load_cases_text(
      R"({"title": "t", "rules": ["a.b"], "target": {"width": 8, "height": 8}, "draws":
      [{"primitive": "points", "vertices": [[8191, 1]]}], "variants": ["translate"]})",
      "a.json", "a");
  ASSERT_EQ(loaded.diagnostics.size(), 1U);
  EXPECT_EQ(loaded.diagnostics[0].pointer, "/draws/0/vertices/0/0");
  EXPECT_EQ(loaded.diagnostics[0].message,
            "the variant moves a coordinate to 8194, out of range (with translate=3,2)");
}

}  // namespace
}  // namespace edgecase
