// SPDX-License-Identifier: MIT
//
// Vertices with a w and vertices in clip coordinates: what the scene holds, what images and sweeps
// make of them, and the direction of y.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "casefile/loader.h"
#include "casefile/scene/viewport.h"
#include "exact/numeral.h"

namespace edgecase {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

LoadedCases load(const std::string& draws, const std::string& rest = "",
                 const std::string& target = R"("width": 8, "height": 8)") {
  LoadedCases loaded = load_cases_text(R"({"title": "t", "rules": ["a.b"], "target": {)" + target +
                                           R"(}, "draws": [)" + draws + "]" + rest + "}",
                                       "a.json", "a");
  for (const Diagnostic& fault : loaded.diagnostics) ADD_FAILURE() << to_string(fault);
  return loaded;
}

// The cases of a file by what follows the id of the file.
std::map<std::string, Scene> scenes(const LoadedCases& loaded) {
  std::map<std::string, Scene> result;
  for (const Case& one : loaded.cases) result[one.id.substr(1)] = one.scene;
  return result;
}

std::vector<int> sides(const Viewport& r) {
  return {r.x, r.y, r.width, r.height};
}

TEST(ClipVertices, WIsKeptWithTheWindowPosition) {
  const auto loaded = load(R"({"primitive": "lines", "vertices":
      [[1, 2.5, 0.5, 4], {"at": [6, 2, 0, "1/2"]}]})");
  ASSERT_EQ(loaded.cases.size(), 1U);
  const auto& vertices = loaded.cases[0].scene.draws[0].vertices;
  EXPECT_EQ(vertices[0].w, 4);
  EXPECT_EQ(vertices[0].position.y, Fixed::from_raw(5 * Fixed::kOne / 2));
  EXPECT_EQ(vertices[1].w, 0.5F);
  EXPECT_FALSE(vertices[1].clip.has_value());
}

// Whatever the loader lets through reaches OpenGL unrounded: the three products are float32
// numbers.
TEST(ClipVertices, ProductsWithWAreExact) {
  std::mt19937 random(5);
  int kept = 0;
  int refused = 0;
  for (int round = 0; round < 4000; ++round) {
    const int shift = static_cast<int>(random() % 24);
    const float w = std::ldexp(static_cast<float>((random() % (1U << 24) >> shift) + 1),
                               static_cast<int>(random() % 8) - 12);
    const auto coordinate = [&] {
      const std::int64_t grid = std::int64_t{1} << (random() % 17);
      return to_decimal(
          Fixed::from_raw(static_cast<std::int64_t>(random() % (8 * 65536)) / grid * grid));
    };
    const std::string text = R"({"title": "t", "rules": ["a.b"], "target":
        {"width": 8, "height": 8}, "draws": [{"primitive": "points", "vertices": [[)" +
                             coordinate() + "," + coordinate() + "," +
                             to_decimal(Fixed::from_raw(random() % 65536)) + ",\"~" +
                             std::to_string(w) + "\"]]}]}";
    const LoadedCases loaded = load_cases_text(text, "a.json", "a");
    if (loaded.cases.empty()) {
      for (const Diagnostic& fault : loaded.diagnostics) {
        EXPECT_THAT(fault.message, HasSubstr("OpenGL's float32 holds 24")) << text;
        EXPECT_FALSE(fault.remedy.empty());
      }
      ++refused;
      continue;
    }
    ++kept;
    const Scene& scene = loaded.cases[0].scene;
    const Vertex& vertex = scene.draws[0].vertices[0];
    const auto ndc = [](Fixed at, int origin, int size) {
      return (at.to_double() - origin - size / 2.0) / (size / 2.0);  // powers of two: exact
    };
    const double wide = static_cast<double>(vertex.w);
    // 24 by 24 significant bits fit in a double.
    for (const double product :
         {ndc(vertex.position.x, scene.viewport.x, scene.viewport.width) * wide,
          ndc(vertex.position.y, scene.viewport.y, scene.viewport.height) * wide,
          vertex.z.to_double() * wide})
      EXPECT_EQ(static_cast<double>(static_cast<float>(product)), product) << text;
  }
  EXPECT_GT(kept, 100);
  EXPECT_GT(refused, 100);
}

TEST(ClipVertices, LandWhereTheirQuotientLies) {
  const auto loaded = load(R"({"primitive": "triangles", "vertices":
      [{"clip": [1, -1, 0.5, 2]}, {"clip": [1, 0, 0, 3]}, {"clip": ["1/4", -0, -3, "~3.1"]}]})");
  ASSERT_EQ(loaded.cases.size(), 1U);
  const Scene& scene = loaded.cases[0].scene;
  EXPECT_THAT(sides(scene.viewport), ElementsAre(0, 0, 8, 8));
  const auto& vertices = scene.draws[0].vertices;
  EXPECT_EQ(vertices[0].clip, (ClipPosition{1, -1, 0.5F, 2}));
  EXPECT_EQ(vertices[0].position, (Point{Fixed::from_integer(6), Fixed::from_integer(2)}));
  EXPECT_EQ(vertices[0].z.raw(), Fixed::kOne / 4);
  EXPECT_EQ(vertices[0].w, 2);
  EXPECT_EQ(vertices[1].position.x.raw(), 349525);  // 16/3 = 349525.33 / 65536
  EXPECT_EQ(vertices[2].w, 3.1F);
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_THAT(loaded.notes[0].message, HasSubstr("~3.1 is taken as 3.0999999"));
}

TEST(ClipVertices, FineNumbersAreRoundedAndNoted) {
  const auto loaded = load(R"({"primitive": "points", "vertices":
      [{"clip": ["~1e-9", 0.25, 0, 1]}, {"clip": ["~0.1", 0, 0, 1]}]})");
  ASSERT_EQ(loaded.cases.size(), 1U);
  EXPECT_EQ(loaded.cases[0].scene.draws[0].vertices[0].clip->x, std::ldexp(1.0F, -30));
  ASSERT_EQ(loaded.notes.size(), 3U);
  EXPECT_EQ(loaded.notes[1].pointer, "/draws/0/vertices/0/clip");
  EXPECT_THAT(loaded.notes[1].message, HasSubstr("rounded"));
  const ClipPosition fine{std::ldexp(3.0F, -31), std::ldexp(1.0F, -31), -std::ldexp(1.0F, -40),
                          1.5F};
  const ClipPosition rounded = round_to_grid(fine);
  EXPECT_EQ(rounded.x, std::ldexp(1.0F, -29));  // a tie, to the even multiple of 2^-30
  EXPECT_EQ(rounded.y, 0);
  EXPECT_FALSE(std::signbit(rounded.z));
  EXPECT_EQ(round_to_grid({std::ldexp(3.0F, -31), 0, 0, 0.75F}).x, std::ldexp(3.0F, -31));
}

// Rounded coordinates are multiples of 2^(e-30), the nearest, and stay inside.
TEST(ClipVertices, TheGridIsThatOfTheModel) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> part(-1, 1);
  for (int round = 0; round < 20000; ++round) {
    const float w =
        std::ldexp(1.0F + std::fabs(part(random)), static_cast<int>(random() % 40) - 20);
    const float x = w * part(random) * std::ldexp(1.0F, -static_cast<int>(random() % 30));
    if (!(std::fabs(x) < w)) continue;
    const ClipPosition clip = round_to_grid({x, 0, 0, w});
    const double unit = std::ldexp(1.0, std::ilogb(w) - 30);
    const double units = static_cast<double>(clip.x) / unit;
    EXPECT_EQ(units, std::nearbyint(units));
    EXPECT_LE(std::fabs(static_cast<double>(clip.x) - static_cast<double>(x)), unit / 2);
    EXPECT_FALSE(find_clip_fault(clip, "it").has_value());
  }
}

// Outside the clip volume all four are rounded, w too, by the largest of them.
TEST(ClipVertices, OutsideTheVolumeTheLargestDecidesTheGrid) {
  std::mt19937 random(12);
  std::uniform_real_distribution<float> part(-1, 1);
  for (int round = 0; round < 20000; ++round) {
    const auto number = [&] {
      return part(random) * std::ldexp(1.0F, static_cast<int>(random() % 38) - 19);
    };
    const ClipPosition given{number(), number(), number(), number()};
    if (find_clip_fault(given, "it")) continue;
    const ClipPosition clip = round_to_grid(given);
    const float largest =
        std::max({std::fabs(given.x), std::fabs(given.y), std::fabs(given.z), std::fabs(given.w)});
    const double unit = std::ldexp(1.0, std::ilogb(largest) - 30);
    for (const auto& [value, before] :
         {std::pair(clip.x, given.x), {clip.y, given.y}, {clip.z, given.z}, {clip.w, given.w}}) {
      const double units = static_cast<double>(value) / unit;
      EXPECT_EQ(units, std::nearbyint(units));
      EXPECT_LE(std::fabs(static_cast<double>(value) - static_cast<double>(before)), unit / 2);
    }
    EXPECT_EQ(round_to_grid(clip), clip);
  }
}

TEST(ClipVertices, OutsideTheVolumeTheyHaveNoPosition) {
  const auto loaded = load(R"({"primitive": "triangles", "vertices":
      [{"clip": [1, -1, 0.5, -2]}, {"clip": [3, 0, 0, 3]}, {"clip": [1, 0, 4, 3]}]})");
  ASSERT_EQ(loaded.cases.size(), 1U);
  const auto& vertices = loaded.cases[0].scene.draws[0].vertices;
  for (const std::size_t i : {0U, 2U}) {
    EXPECT_EQ(vertices[i].position, Point());
    EXPECT_EQ(vertices[i].z, Fixed());
  }
  EXPECT_EQ(vertices[0].w, -2);
  EXPECT_EQ(vertices[1].position, (Point{Fixed::from_integer(8), Fixed::from_integer(4)}));
  const ScenePrimitive triangle = primitives_of(loaded.cases[0].scene).front();
  EXPECT_TRUE(triangle.is_clipped);
  EXPECT_FALSE(triangle.is_cut);
}

TEST(ClipVertices, ALineIsCutWhereItLeavesTheVolume) {
  const auto loaded = load(R"({"primitive": "lines", "vertices":
      [{"clip": [-1, 0, -3, 1]}, {"clip": [1, 0, 1, 1]}, {"clip": [-2, 0, 0, 1]}, [2, 6]]})");
  ASSERT_EQ(loaded.cases.size(), 1U);
  const auto lines = primitives_of(loaded.cases[0].scene);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_TRUE(lines[0].is_cut);
  EXPECT_FALSE(lines[0].is_clipped);
  EXPECT_EQ(nearest_point(lines[0].positions[0]),
            (Point{Fixed::from_integer(4), Fixed::from_integer(4)}));
  EXPECT_EQ(nearest_point(lines[0].positions[1]),
            (Point{Fixed::from_integer(8), Fixed::from_integer(4)}));
  // From (-4, 4) to (2, 6): at x = 0 two thirds of the way.
  EXPECT_TRUE(same_point(lines[1].positions[0], HomogeneousPoint{0, 16, 3}));
}

TEST(ClipVertices, ChooseTheViewportRoundTheTarget) {
  const std::string point = R"({"primitive": "points", "vertices": [{"clip": [0.5, 0.5, 0, 1]}]})";
  EXPECT_THAT(sides(load(point, "", R"("width": 5, "height": 17)").cases.at(0).scene.viewport),
              ElementsAre(0, 0, 8, 32));
  const auto given =
      load(point, "",
           R"("width": 5, "height": 17, "viewport": {"x": 1, "y": 2, "width": 3, "height": 5})");
  EXPECT_THAT(sides(given.cases.at(0).scene.viewport), ElementsAre(1, 2, 3, 5));
  EXPECT_EQ(to_decimal(given.cases.at(0).scene.draws[0].vertices[0].position.x), "3.25");
}

// In a target of 6 x 4 pixels the viewport is 8 x 4: mirrored, it starts at -2.
TEST(ClipVertices, ImagesTurnAboutTheTargetsCentre) {
  const auto images = scenes(
      load(R"({"primitive": "lines", "vertices": [{"clip": [0.5, 0.25, 0, 2]}, [5, 1, 0, 2]]})",
           R"(, "variants": ["octants", "translate", "reverse"])", R"("width": 6, "height": 4)"));
  ASSERT_EQ(images.size(), 10U);
  const auto at = [&](const char* part, std::size_t vertex) {
    const Point point = images.at(part).draws[0].vertices[vertex].position;
    return to_decimal(point.x) + "," + to_decimal(point.y);
  };
  EXPECT_EQ(at("", 0), "5,2.25");
  EXPECT_EQ(at(":octant=1", 0), "1,2.25");
  EXPECT_EQ(at(":octant=1", 1), "1,1");
  EXPECT_THAT(sides(images.at(":octant=1").viewport), ElementsAre(-2, 0, 8, 4));
  EXPECT_EQ(at(":octant=2", 0), "5,1.75");
  EXPECT_EQ(at(":octant=4", 0), "2.25,5");
  EXPECT_THAT(sides(images.at(":octant=4").viewport), ElementsAre(0, 0, 4, 8));
  EXPECT_EQ(at(":octant=7", 0), "1.75,1");
  EXPECT_EQ(images.at(":octant=7").draws[0].vertices[0].clip, (ClipPosition{-0.25F, -0.5F, 0, 2}));
  EXPECT_EQ(at(":translate=3,2", 0), "8,4.25");
  EXPECT_EQ(at(":translate=3,2", 1), "8,3");
  EXPECT_THAT(sides(images.at(":translate=3,2").viewport), ElementsAre(3, 2, 8, 4));
  EXPECT_EQ(at(":reverse", 1), "5,2.25");
}

TEST(ClipVertices, YDownReflectsEverything) {
  const auto loaded = load(
      R"({"primitive": "triangles", "vertices": [[1, 1], [3, 1, 0, 2], {"clip": [0, 0.5, 0, 1]}],
          "state": {"scissor": {"x": 0, "y": 1, "width": 4, "height": 2}}})",
      "", R"("width": 4, "height": 8, "y": "down",
             "viewport": {"x": -2, "y": -4, "width": 8, "height": 16})");
  ASSERT_EQ(loaded.cases.size(), 1U);
  const Scene& scene = loaded.cases[0].scene;
  EXPECT_THAT(sides(scene.viewport), ElementsAre(-2, -4, 8, 16));
  EXPECT_THAT(sides(*scene.draws[0].scissor), ElementsAre(0, 5, 4, 2));
  const auto& vertices = scene.draws[0].vertices;
  EXPECT_EQ(vertices[0].position, (Point{Fixed::from_integer(1), Fixed::from_integer(7)}));
  EXPECT_EQ(vertices[1].w, 2);
  EXPECT_EQ(vertices[2].clip, (ClipPosition{0, -0.5F, 0, 1}));
  EXPECT_EQ(vertices[2].position.y, Fixed::from_integer(0));
}

// Counted from above or from below, the same scene.
TEST(ClipVertices, YDownIsTheMirroredScene) {
  const std::string draw =
      R"({"primitive": "lines", "vertices": [[1, "2+1/16"], [3, 1]], "color": [1, 0, 0]})";
  const auto down = load(draw, "", R"("width": 4, "height": 7, "y": "down")");
  const auto up = scenes(load(draw, R"(, "variants": ["octants"])", R"("width": 4, "height": 7)"));
  const auto& flipped = up.at(":octant=2");
  ASSERT_EQ(down.cases.size(), 1U);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(down.cases[0].scene.draws[0].vertices[i].position,
              flipped.draws[0].vertices[i].position);
  EXPECT_EQ(sides(down.cases[0].scene.viewport), sides(flipped.viewport));
}

TEST(ClipVertices, SweepsReachEveryNumber) {
  const auto loaded = load(
      R"({"primitive": "points", "vertices": [[1, 1], {"clip": [0, 0, 0, 1], "color": [1, 0, 0]},
                                              {"object": [0, 0, 0]}],
          "transform": {"model": [{"translate": [0, 0, 0]}]}})",
      R"(, "sweep": {
        "w": {"set": ["/draws/0/vertices/0/w"], "values": [1, 9.5367431640625e-07, 1048576]},
        "x": {"add_to": ["/draws/0/vertices/1/x", "/draws/0/vertices/2/y"], "values": [0, "1/2"]},
        "cw": {"set": ["/draws/0/vertices/1/w"], "values": [4]},
        "z": {"set": ["/draws/0/transform/model/0/translate/2"], "values": ["1/4"]},
        "at": {"set": ["/draws/0/vertices/1"], "points": [{"clip": [0, 0, 0, 2]}, [2, 3]]}})");
  ASSERT_EQ(loaded.cases.size(), 12U);
  const auto all = scenes(loaded);
  const auto& one = all.at(":w=9.536743e-07:x=0.5:cw=4:z=0.25:at=#0").draws[0].vertices;
  EXPECT_EQ(one[0].w, std::ldexp(1.0F, -20));
  EXPECT_EQ(one[1].clip, (ClipPosition{0.5F, 0, 0, 4}));
  EXPECT_EQ(one[2].clip, (ClipPosition{0, 0.5F, 0.25F, 1}));
  const auto& other = all.at(":w=1048576:x=0:cw=4:z=0.25:at=#1").draws[0].vertices;
  EXPECT_EQ(other[0].w, 1048576);
  // A position in place of clip coordinates: the vertex keeps its colour.
  EXPECT_FALSE(other[1].clip.has_value());
  EXPECT_EQ(other[1].w, 4);
  EXPECT_EQ(other[1].color, (Color{1, 0, 0, 1}));
}

TEST(ClipVertices, DetailsAndDepthAreRead) {
  const auto loaded =
      load(R"({"primitive": "points", "vertices": [[1, 1]]})", R"(, "details": ["derivatives"])",
           R"("width": 8, "height": 8, "depth": "depth32f")");
  ASSERT_EQ(loaded.cases.size(), 1U);
  EXPECT_EQ(loaded.cases[0].scene.details, (Details{false, true}));
  EXPECT_EQ(loaded.cases[0].scene.target.depth, DepthFormat::depth32f);
}

TEST(ClipVertices, ColoursOfVerticesHaveNoBounds) {
  const auto loaded = load(R"({"primitive": "points", "vertices":
      [{"at": [1, 1], "color": [-1e18, 18446744073709551616, 1e-40, 0.1]}]})");
  ASSERT_EQ(loaded.cases.size(), 1U);
  EXPECT_EQ(loaded.cases[0].scene.draws[0].vertices[0].color,
            (Color{-1e18F, 18446744073709551616.0F, 1e-40F, 0.1F}));
}

}  // namespace
}  // namespace edgecase
