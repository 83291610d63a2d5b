// SPDX-License-Identifier: MIT
#include "wire/request_line.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/wire/scenes.h"

namespace edgecase {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

std::string message_of(const std::string& line) {
  return fault_in(parse_request(line));
}

// A request with this scene and the digest that belongs to it.
std::string request_of(const std::string& scene) {
  return request_line("a", scene);
}

TEST(RequestLine, ReadsBackEveryFieldOfAScene) {
  const Scene scene = small_scene();
  const std::string text = scene_json(scene);
  const auto parsed = parse_request(request_line("lines/\"odd\" name", text));
  ASSERT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
  const Request& request = std::get<Request>(parsed);
  EXPECT_EQ(request.id, "lines/\"odd\" name");
  EXPECT_EQ(request.digest, digest_of(text));
  EXPECT_EQ(request.scene.target.width, 3);
  EXPECT_EQ(request.scene.target.height, 2);
  EXPECT_EQ(request.scene.target.clear, scene.target.clear);
  EXPECT_EQ(request.scene.viewport.x, -1);
  EXPECT_EQ(request.scene.viewport.y, -2);
  EXPECT_EQ(request.scene.viewport.width, 8);
  EXPECT_EQ(request.scene.viewport.height, 16);
  ASSERT_EQ(request.scene.draws.size(), 2u);
  EXPECT_EQ(request.scene.draws[0].interpolation, Interpolation::smooth);
  EXPECT_EQ(request.scene.draws[0].provoking_vertex, ProvokingVertex::first);
  EXPECT_EQ(request.scene.draws[1].primitive, Primitive::lines);
  EXPECT_EQ(request.scene.draws[0].line_width, Fixed::from_integer(1));
  EXPECT_EQ(request.scene.draws[1].line_width, Fixed::from_raw(5 * Fixed::kOne / 2));
  EXPECT_EQ(request.scene.draws[1].point_size, Fixed::from_raw(1));
  EXPECT_FALSE(request.scene.draws[0].scissor.has_value());
  ASSERT_TRUE(request.scene.draws[1].scissor.has_value());
  EXPECT_EQ(request.scene.draws[1].scissor->x, -1);
  EXPECT_EQ(request.scene.draws[1].scissor->y, 0);
  EXPECT_EQ(request.scene.draws[1].scissor->width, 3);
  EXPECT_EQ(request.scene.draws[1].scissor->height, 0);
  for (std::size_t d = 0; d < 2; ++d) {
    ASSERT_EQ(request.scene.draws[d].vertices.size(), scene.draws[d].vertices.size());
    for (std::size_t v = 0; v < scene.draws[d].vertices.size(); ++v) {
      EXPECT_EQ(request.scene.draws[d].vertices[v].position, scene.draws[d].vertices[v].position);
      EXPECT_EQ(request.scene.draws[d].vertices[v].z, scene.draws[d].vertices[v].z);
      EXPECT_EQ(request.scene.draws[d].vertices[v].color, scene.draws[d].vertices[v].color);
    }
  }
}

TEST(RequestLine, AsksForCoverageAlone) {
  const std::string text = scene_json(small_scene());
  for (bool coverage_only : {false, true}) {
    const auto parsed = parse_request(request_line("a", text, coverage_only));
    ASSERT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
    EXPECT_EQ(std::get<Request>(parsed).coverage_only, coverage_only);
    EXPECT_EQ(std::get<Request>(parsed).digest, digest_of(text));
  }
  const std::string asking = request_line("a", text, true);
  EXPECT_THAT(asking, HasSubstr(R"("answer":"coverage")"));
}

// A later version may ask for more beside the scene, and a whole answer is always right.
TEST(RequestLine, IgnoresWhatIsUnknownBesideTheScene) {
  const std::string asking = request_line("a", scene_json(small_scene()), true);
  for (const char* other : {R"("answer":"depths")", R"("answer":1)", R"("hint":{"of":"more"})"}) {
    const auto parsed = parse_request(replaced(asking, R"("answer":"coverage")", other));
    ASSERT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
    EXPECT_FALSE(std::get<Request>(parsed).coverage_only);
  }
}

// What an older worker is sent: a key that only a later version has, in any object of a scene.
TEST(RequestLine, RefusesAPlantedKeyByItsName) {
  Scene scene = textured_scene();
  scene.target.samples = 2;
  scene.draws[0].polygon_offset.emplace();
  scene.draws[0].operations.stencil.emplace();
  scene.draws[0].operations.depth.write = false;
  scene.draws[0].operations.blending.emplace();
  const json whole = json::parse(scene_json(scene));
  std::set<std::string> objects;
  const json leaves = whole.flatten();
  for (const auto& [leaf, value] : leaves.items())
    for (json::json_pointer at(leaf); !at.empty();) {
      at = at.parent_pointer();
      if (whole.at(at).is_object()) objects.insert(at.to_string());
    }
  EXPECT_GE(objects.size(), 25u);
  for (const std::string& object : objects) {
    json planted = whole;
    planted[json::json_pointer(object)]["planted"] = 1;
    const auto parsed = parse_request(request_of(planted.dump()));
    ASSERT_TRUE(std::holds_alternative<WireError>(parsed)) << object;
    const auto& refused = std::get<WireError>(parsed);
    EXPECT_THAT(refused.message, HasSubstr("/scene" + object + " has the unknown key \"planted\""));
    EXPECT_EQ(refused.digest, digest_of(planted.dump()));
  }
}

// Texts that belong together as bytes: digests of them are compared.
TEST(RequestLine, WritesNumbersAsShortAsTheyReadBack) {
  Scene scene = small_scene();
  scene.draws.pop_back();
  scene.draws[0].scissor = Viewport{-1, 2, 3, 0};
  EXPECT_EQ(scene_json(scene),
            R"({"target":{"width":3,"height":2,"samples":1,"color":"rgba8","surface":"fbo",)"
            R"("clear":[0.0,0.25,0.10000000149011612,1.0]},"viewport":[-1,-2,8,16],"draws":[)"
            R"({"primitive":"triangles","interpolation":"smooth","provoking_vertex":"first",)"
            R"("line_width":1.0,"point_size":1.0,"scissor":[-1,2,3,0],"vertices":[)"
            R"({"position":[1.52587890625e-05,-1.52587890625e-05,0.0],"color":[1.0,0.0,0.0,1.0]},)"
            R"({"position":[3.0517730712890625,0.9999847412109375,0.43595)"
            R"(88623046875],"color":[0.0,0.30000001192092896,0.0,1.0]},)"
            R"({"position":[0.0,2.0,0.0],"color":[0.0,0.0,1.0000000116860974e-07,0.5]}]}]})");
}

TEST(RequestLine, CarriesEveryName) {
  Scene scene = small_scene();
  const auto read_back = [&] {
    const auto parsed = parse_request(request_of(scene_json(scene)));
    return std::holds_alternative<Request>(parsed) ? std::get<Request>(parsed).scene : Scene();
  };
  scene.target.surface = Surface::window;
  EXPECT_EQ(read_back().target.surface, Surface::window);
  Draw& draw = scene.draws[0];
  draw.interpolation = Interpolation::noperspective;
  for (Primitive primitive :
       {Primitive::points, Primitive::line_strip, Primitive::line_loop, Primitive::triangles,
        Primitive::triangle_strip, Primitive::triangle_fan}) {
    draw.primitive = primitive;
    ASSERT_EQ(read_back().draws.size(), 2u) << name_of(primitive);
    EXPECT_EQ(read_back().draws[0].primitive, primitive);
    EXPECT_EQ(read_back().draws[0].interpolation, Interpolation::noperspective);
  }
}

TEST(RequestLine, TellsSizesApartInTheDigest) {
  const Scene plain = small_scene();
  Scene wide = plain;
  wide.draws[0].line_width = Fixed::from_integer(2);
  Scene big = plain;
  big.draws[0].point_size = Fixed::from_integer(2);
  Scene cut = plain;
  cut.draws[0].scissor = Viewport{0, 0, 1, 1};
  const std::string digest = digest_of(scene_json(plain));
  for (const Scene& other : {wide, big, cut}) EXPECT_NE(digest_of(scene_json(other)), digest);
}

TEST(RequestLine, CarriesEveryCoordinateExactly) {
  // Every fraction of 2^-16, at the largest magnitude, where doubles have the fewest digits left.
  Scene scene = small_scene();
  for (std::int64_t fraction = 0; fraction < Fixed::kOne; fraction += 13) {
    scene.draws[1].vertices[0].position.x =
        Fixed::from_raw(-Fixed::kMaxCoordinate * Fixed::kOne + fraction);
    const auto parsed = parse_request(request_of(scene_json(scene)));
    ASSERT_TRUE(std::holds_alternative<Request>(parsed));
    ASSERT_EQ(std::get<Request>(parsed).scene.draws[1].vertices[0].position.x,
              scene.draws[1].vertices[0].position.x);
  }
}

TEST(RequestLine, IsOneLineInTheDocumentedForm) {
  Scene scene;
  scene.target.width = 1;
  scene.target.height = 1;
  scene.viewport = {0, 0, 1, 1};
  Draw draw;
  draw.primitive = Primitive::points;
  draw.vertices.resize(1);
  draw.vertices[0].position = {Fixed::centre_of(0), Fixed::from_raw(1)};
  scene.draws = {draw};
  EXPECT_EQ(scene_json(scene),
            R"({"target":{"width":1,"height":1,"samples":1,"color":"rgba8","surface":"fbo",)"
            R"("clear":[0.0,0.0,0.0,1.0]},"viewport":[0,0,1,1],"draws":[{"primitive":"points",)"
            R"("interpolation":"flat","provoking_vertex":"last","line_width":1.0,)"
            R"("point_size":1.0,"vertices":[{"position":)"
            R"([0.5,1.52587890625e-05,0.0],"color":[1.0,1.0,1.0,1.0]}]}]})");
}

TEST(RequestLine, DigestIsFnv1a) {
  // The published test values of the function.
  EXPECT_EQ(digest_of(""), "cbf29ce484222325");
  EXPECT_EQ(digest_of("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(digest_of("foobar"), "85944171f73967e8");
}

TEST(RequestLine, RefusesWhatIsNoRequest) {
  const std::string good = request_of(scene_json(small_scene()));
  EXPECT_EQ(message_of(good), "");
  EXPECT_THAT(message_of(""), HasSubstr("no line of JSON"));
  EXPECT_THAT(message_of(good + "x"), HasSubstr("no line of JSON"));
  EXPECT_THAT(message_of("[]"), HasSubstr("has no \"digest\""));
  EXPECT_THAT(message_of(replaced(good, "\"edgecase\":1", "\"edgecase\":2")),
              HasSubstr("/edgecase is 2, but it must be 1"));
  EXPECT_THAT(message_of(replaced(good, "\"digest\":\"", "\"digest\":\"0")),
              HasSubstr("but the scene's is"));
}

TEST(RequestLine, RefusesWhatIsNoScene) {
  const std::string good = scene_json(small_scene());
  const auto refusal = [&](const std::string& from, const std::string& to) {
    return message_of(request_of(replaced(good, from, to)));
  };
  EXPECT_THAT(refusal("\"width\":3", "\"width\":4097"), HasSubstr("/scene/target/width is 4097"));
  EXPECT_THAT(refusal("\"fbo\"", "\"screen\""), HasSubstr("unknown name \"screen\""));
  EXPECT_THAT(refusal("[-1,-2,8,16]", "[-1,-2,8,0]"), HasSubstr("/scene/viewport/3 is 0"));
  EXPECT_THAT(refusal("[-1,-2,8,16]", "[-1,-2,8]"), HasSubstr("must have 4 elements"));
  EXPECT_THAT(refusal("[-0.5,0.5,", "[0.1,0.5,"),
              HasSubstr("/scene/draws/1/vertices/0/position/0 is 0.1"));
  EXPECT_THAT(refusal("[-0.5,0.5,", "[9000,0.5,"), HasSubstr("must be a multiple of 2^-16"));
  EXPECT_THAT(refusal("\"lines\"", "\"triangles\""),
              HasSubstr("has 2 vertices, which make no whole triangles"));
  EXPECT_THAT(refusal("\"triangles\"", "\"lines\""), HasSubstr("make no whole lines"));
  EXPECT_THAT(refusal("\"lines\"", "\"triangle_fan\""), HasSubstr("make no whole triangle_fan"));
  EXPECT_THAT(refusal("\"lines\"", "\"quads\""), HasSubstr("unknown name \"quads\""));
  EXPECT_THAT(refusal("\"line_width\":2.5,", ""),
              HasSubstr("/scene/draws/1 has no \"line_width\""));
  EXPECT_THAT(refusal("\"line_width\":2.5", "\"line_width\":0"),
              HasSubstr("/scene/draws/1/line_width is 0, but it must be more than 0"));
  EXPECT_THAT(refusal("\"line_width\":2.5", "\"line_width\":-1"), HasSubstr("line_width is -1"));
  EXPECT_THAT(refusal("\"line_width\":2.5", "\"line_width\":64.5"), HasSubstr("at most 64"));
  EXPECT_THAT(refusal("\"line_width\":2.5", "\"line_width\":0.1"), HasSubstr("multiple of 2^-16"));
  EXPECT_THAT(refusal("\"point_size\":1.0", "\"point_size\":\"1\""),
              HasSubstr("/scene/draws/0/point_size must be a number"));
  EXPECT_THAT(refusal("[-1,0,3,0]", "[-1,0,3,-1]"), HasSubstr("/scene/draws/1/scissor/3 is -1"));
  EXPECT_THAT(refusal("[-1,0,3,0]", "null"), HasSubstr("/scene/draws/1/scissor must be an array"));
  EXPECT_THAT(refusal("[-1,0,3,0]", "[-0.5,0,3,0]"), HasSubstr("scissor/0 must be an integer"));
  EXPECT_THAT(refusal("[1.0,0.0,0.0,1.0]", "[2,0,0,1e39]"), HasSubstr("color/3 is 1e+39"));
  EXPECT_THAT(refusal("[1.0,0.0,0.0,1.0]", "[0.1,0,0,1]"), HasSubstr("float32"));
  EXPECT_THAT(refusal("\"viewport\"", "\"window\""), HasSubstr("unknown key \"window\""));
}

}  // namespace
}  // namespace edgecase
