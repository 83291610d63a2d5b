// SPDX-License-Identifier: MIT
//
// Vertices with a w or clip coordinates, colours beyond 0 to 1, depth formats and details on their
// way in a request.
#include "wire/scene_json.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

#include "model/scene.h"
#include "tests/wire/scenes.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string message_of(const std::string& scene) {
  return fault_in(parse_request(request_line("a", scene)));
}

// A scene whose text has been read back and is the same scene.
void expect_carried(const Scene& scene) {
  const std::string text = scene_json(scene);
  const auto parsed = parse_request(request_line("a", text));
  ASSERT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
  EXPECT_TRUE(same_scene(std::get<Request>(parsed).scene, scene)) << text;
}

Vertex clip_vertex(const ClipPosition& clip, const Viewport& viewport, Fixed z) {
  Vertex vertex;
  vertex.clip = clip;
  vertex.w = clip.w;
  vertex.position = nearest_point(window_position(clip, viewport));
  vertex.z = z;
  return vertex;
}

// One triangle in the viewport -1, -2, 8, 16: a w that is 3, one that is 1, and clip coordinates.
Scene perspective_scene() {
  Scene scene = small_scene();
  scene.draws.pop_back();
  auto& vertices = scene.draws[0].vertices;
  vertices[0].position = {Fixed::from_raw(5 * Fixed::kOne / 2), Fixed::from_integer(4)};
  vertices[0].z = Fixed::from_raw(Fixed::kOne / 2);
  vertices[0].w = 3;
  vertices[1].position = {Fixed::from_integer(2), Fixed::from_integer(7)};
  vertices[2] = clip_vertex({1, -2, 0.75f, 3}, scene.viewport, Fixed::from_raw(Fixed::kOne / 4));
  return scene;
}

TEST(SceneValues, AVertexCarriesItsW) {
  const Scene scene = perspective_scene();
  expect_carried(scene);
  const std::string text = scene_json(scene);
  EXPECT_THAT(text, HasSubstr(R"({"position":[2.5,4.0,0.5],"w":3.0,"color":[1.0,)"));
  EXPECT_THAT(text, HasSubstr(R"({"position":[2.0,7.0,)"));
  EXPECT_THAT(text, HasSubstr(R"(,"clip":[1.0,-2.0,0.75,3.0],"color")"));
}

TEST(SceneValues, ASceneWithoutThemHasNoneOfTheirKeys) {
  const std::string text = scene_json(small_scene());
  for (const char* key : {"\"w\"", "\"clip\"", "\"details\"", "\"depth\""})
    EXPECT_THAT(text, Not(HasSubstr(key)));
}

TEST(SceneValues, WIsRefusedWhereItMakesNoClipCoordinates) {
  const std::string good = scene_json(perspective_scene());
  const auto with_w = [&](const char* w) { return message_of(replaced(good, "\"w\":3.0", w)); };
  EXPECT_EQ(message_of(good), "");
  EXPECT_THAT(with_w("\"w\":0.0"), HasSubstr("/vertices/0/w is 0.0, but it must be a float32 value "
                                             "of more than 0"));
  EXPECT_THAT(with_w("\"w\":-3.0"), HasSubstr("/w is -3.0"));
  EXPECT_THAT(with_w("\"w\":0.1"), HasSubstr("/w is 0.1"));
  EXPECT_THAT(with_w("\"w\":1e39"), HasSubstr("/w is 1e+39"));
  EXPECT_THAT(with_w("\"w\":\"inf\""), HasSubstr("/w must be a number"));
  EXPECT_THAT(with_w("\"w\":3.0,\"clip\":[0,0,0,1]"), HasSubstr("both \"clip\" and \"w\""));
  // A z of 2^-16 and a w of 24 bits: 24 bits. A z of 3/2^16: one too many.
  Scene scene = perspective_scene();
  scene.draws[0].vertices[0].w = 16777215;
  scene.draws[0].vertices[0].z = Fixed::from_raw(1);
  expect_carried(scene);
  scene.draws[0].vertices[0].z = Fixed::from_raw(3);
  EXPECT_THAT(message_of(scene_json(scene)),
              HasSubstr("/scene/draws/0/vertices/0 has a position whose clip coordinates are no"));
  // A third of the viewport's width is no float32 number, with a w of 3 it is one.
  scene.viewport.width = 3;
  scene.draws[0].vertices.pop_back();
  scene.draws[0].vertices.push_back(scene.draws[0].vertices[1]);
  scene.draws[0].vertices[0].z = Fixed();
  scene.draws[0].vertices[0].w = 3;
  expect_carried(scene);
  scene.draws[0].vertices[0].w = 5;
  EXPECT_THAT(message_of(scene_json(scene)), HasSubstr("clip coordinates are no float32 values"));
}

// Against a check of its own: clip coordinates that are made by multiplication always pass, with a
// bit more than float32 has they never do.
TEST(SceneValues, ExactProductsAreToldFromRoundedOnes) {
  std::mt19937 random(7);
  std::uniform_int_distribution<std::int64_t> mantissa(1 << 23, (1 << 24) - 1);
  for (int round = 0; round < 2000; ++round) {
    Scene scene = perspective_scene();
    scene.draws[0].vertices.resize(2);
    scene.draws[0].primitive = Primitive::lines;
    Vertex& vertex = scene.draws[0].vertices[0];
    const std::int64_t w = mantissa(random);
    const std::int64_t z = mantissa(random) >> (8 + round % 16);
    vertex.position = {Fixed::from_integer(3), Fixed::from_integer(6)};  // the viewport's centre
    vertex.w = std::ldexp(static_cast<float>(w), round % 60 - 30);
    vertex.z = Fixed::from_raw(z);
    std::int64_t product = w * z;
    while (product % 2 == 0) product /= 2;
    const bool fits = product < (std::int64_t{1} << 24);
    EXPECT_EQ(message_of(scene_json(scene)).empty(), fits) << w << " * " << z;
  }
}

TEST(SceneValues, ClipCoordinatesAreHeldAgainstTheirLimits) {
  const std::string good = scene_json(perspective_scene());
  const auto with_clip = [&](const char* clip) {
    return message_of(replaced(good, "[1.0,-2.0,0.75,3.0]", clip));
  };
  EXPECT_THAT(with_clip("[1.0,-2.0,0.75]"), HasSubstr("/vertices/2/clip must have 4 elements"));
  EXPECT_THAT(with_clip("[0.0,0.0,0.0,0.0]"), HasSubstr("/vertices/2/clip is 0 in all four"));
  EXPECT_THAT(with_clip("[1.0,-2.0,0.75,3.1]"),
              HasSubstr("/clip/3 is 3.1, but it must be a float32 value"));
  EXPECT_THAT(with_clip("[1.0,-2.0,\"nan\",3.0]"), HasSubstr("/clip/2 must be a number"));
  // 2^-29 is the step below a w of 2 to 4.
  EXPECT_THAT(with_clip("[1.0,-2.0,9.313225746154785e-10,3.0]"),
              HasSubstr("/clip/2 is 9.313225746154785e-10, but it must be a multiple of 2^-29"));
  EXPECT_THAT(with_clip("[1.862645149230957e-09,-2.0,0.75,3.0]"),
              HasSubstr("/vertices/2/position is ["));
}

// Behind the eye and beyond any of the six planes a position says nothing, and is 0.
TEST(SceneValues, OutsideTheClipVolumeThePositionIsZero) {
  Scene scene = perspective_scene();
  Vertex& vertex = scene.draws[0].vertices[2];
  for (const ClipPosition& clip : {ClipPosition{1, -2, 0.75F, 0},
                                   {1, -2, 0.75F, -3},
                                   {3.5F, -2, 0.75F, 3},
                                   {1, 3.5F, 0, 3},
                                   {1, -2, -3.5F, 3},
                                   {1, -2, 3.5F, 3}}) {
    vertex.clip = clip;
    vertex.w = clip.w;
    vertex.position = {};
    vertex.z = {};
    expect_carried(scene);
    vertex.position.y = Fixed::from_raw(1);
    EXPECT_THAT(message_of(scene_json(scene)), HasSubstr("make it [0,0,0]"));
    vertex.position.y = {};
    vertex.z = Fixed::from_raw(-1);
    EXPECT_THAT(message_of(scene_json(scene)), HasSubstr("make it [0,0,0]"));
  }
}

TEST(SceneValues, PositionsThatAreNotThoseOfTheirClipCoordinatesAreRefused) {
  Scene scene = perspective_scene();
  // x/w is a third: 3 + 4/3 pixels, whose nearest multiple of 2^-16 is its floor.
  const Vertex vertex = scene.draws[0].vertices[2];
  EXPECT_EQ(vertex.position.x, Fixed::from_raw(13 * Fixed::kOne / 3));
  for (int part = 0; part < 3; ++part) {
    for (int step : {-1, 1}) {
      Vertex& moved = scene.draws[0].vertices[2] = vertex;
      Fixed& number = part == 0 ? moved.position.x : part == 1 ? moved.position.y : moved.z;
      number = number + Fixed::from_raw(step);
      EXPECT_THAT(message_of(scene_json(scene)),
                  HasSubstr("but its clip coordinates make it [4.3333282470703125,"));
    }
  }
}

TEST(SceneValues, ClipCoordinatesOfEveryMagnitudeAreCarried) {
  Scene scene = perspective_scene();
  for (int exponent = -149; exponent <= 127; ++exponent) {
    const float w = std::ldexp(1.0f, exponent);
    scene.draws[0].vertices[2] = clip_vertex({w, -w, 0, w}, scene.viewport, Fixed());
    expect_carried(scene);
  }
  const float w = 16777215;
  const auto depth = Fixed::from_raw(-Fixed::kOne);  // nearest to -1 + 2^-24, as is -1 itself
  scene.draws[0].vertices[2] = clip_vertex({1, -w, 1 - w, w}, scene.viewport, depth);
  expect_carried(scene);
}

TEST(SceneValues, VertexColoursMayBeAnyFiniteFloat) {
  Scene scene = small_scene();
  constexpr float kMax = std::numeric_limits<float>::max();
  scene.draws[0].vertices[0].color = {-2.5f, 1000, kMax, -kMax};
  scene.draws[0].vertices[1].color = {std::numeric_limits<float>::denorm_min(), -1e-30f, 0, 1};
  expect_carried(scene);
  const std::string good = scene_json(small_scene());
  const auto with_red = [&](const char* red) {
    return message_of(replaced(good, "\"color\":[1.0,", std::string("\"color\":[") + red + ","));
  };
  EXPECT_EQ(with_red("-2.5"), "");
  EXPECT_THAT(with_red("1e39"),
              HasSubstr("/vertices/0/color/0 is 1e+39, but it must be a float32"));
  EXPECT_THAT(with_red("0.1"), HasSubstr("color/0 is 0.1, but it must be a float32 value"));
  EXPECT_THAT(with_red("\"inf\""), HasSubstr("color/0 must be a number"));
}

TEST(SceneValues, ClearColoursMayNot) {
  const std::string good = scene_json(small_scene());
  for (const char* red : {"1.5", "-0.5", "0.1"})
    EXPECT_THAT(
        message_of(replaced(good, "\"clear\":[0.0,", std::string("\"clear\":[") + red + ",")),
        HasSubstr("/scene/target/clear/0 is " + std::string(red) +
                  ", but it must be a float32 value of 0 to 1"));
}

TEST(SceneValues, DepthFormatsAreCarried) {
  Scene scene = small_scene();
  std::string last = scene_json(scene);
  for (DepthFormat format : {DepthFormat::depth16, DepthFormat::depth24, DepthFormat::depth32f}) {
    scene.target.depth = format;
    expect_carried(scene);
    EXPECT_THAT(scene_json(scene), HasSubstr(std::string("\"color\":\"rgba8\",\"depth\":\"") +
                                             name_of(format) + "\",\"surface\""));
  }
  EXPECT_THAT(message_of(replaced(scene_json(scene), "depth32f", "depth32")),
              HasSubstr("/scene/target/depth is the unknown name \"depth32\""));
  EXPECT_THAT(message_of(replaced(scene_json(scene), "\"depth32f\"", "32")),
              HasSubstr("/scene/target/depth must be a string"));
}

TEST(SceneValues, DetailsAreCarried) {
  Scene scene = small_scene();
  scene.details.coordinates = true;
  expect_carried(scene);
  EXPECT_THAT(scene_json(scene), HasSubstr(R"(,"details":["coordinates"],"draws")"));
  scene.details.derivatives = true;
  expect_carried(scene);
  EXPECT_THAT(scene_json(scene), HasSubstr(R"("details":["coordinates","derivatives"])"));
  const std::string good = scene_json(scene);
  const auto with = [&](const char* details) {
    return message_of(replaced(good, R"(["coordinates","derivatives"])", details));
  };
  EXPECT_THAT(with("[]"), HasSubstr("/scene/details must have an element"));
  EXPECT_THAT(with("\"derivatives\""), HasSubstr("/scene/details must be an array"));
  EXPECT_THAT(with("[1]"), HasSubstr("/scene/details/0 must be a string"));
  EXPECT_THAT(with(R"(["depth"])"), HasSubstr("/scene/details/0 is the unknown name \"depth\""));
  EXPECT_THAT(with(R"(["coordinates","coordinates"])"),
              HasSubstr("/scene/details/1 names \"coordinates\" again"));
  scene.details.coordinates = false;
  expect_carried(scene);
  EXPECT_THAT(scene_json(scene), HasSubstr(R"("details":["derivatives"])"));
}

}  // namespace
}  // namespace edgecase
