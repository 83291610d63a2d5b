// SPDX-License-Identifier: MIT
//
// Textures, what draws look up in them, and texture coordinates on their way in a request.
#include "wire/json_values.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <set>

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

void expect_carried(const Scene& scene) {
  const std::string text = scene_json(scene);
  const auto parsed = parse_request(request_line("a", text));
  ASSERT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
  const Scene& read = std::get<Request>(parsed).scene;
  EXPECT_TRUE(same_scene(read, scene)) << text;
  EXPECT_EQ(scene_json(read), text);
}

void expect_refused(const Scene& scene, const std::string& reason) {
  EXPECT_THAT(message_of(scene_json(scene)), HasSubstr(reason));
}

// textured_scene with this as its second texture.
Scene with_texture(const Texture& texture) {
  Scene scene = textured_scene();
  scene.textures[1] = std::make_shared<const Texture>(texture);
  return scene;
}

// A scene of one texel in the form that reference/PROTOCOL.md documents.
TEST(TextureValues, HaveTheDocumentedForm) {
  Scene scene = small_scene();
  scene.draws.pop_back();
  scene.draws[0].vertices.resize(1);
  scene.draws[0].primitive = Primitive::points;
  scene.details.texture = true;
  Texture texture = make_texture(1, 1, TextureFormat::rgba32f);
  texture.levels[0].texels = {255, -0.0f, 0.1f, 256};
  scene.textures = {std::make_shared<const Texture>(texture)};
  scene.draws[0].texture = TextureUse();
  scene.draws[0].vertices[0].texture_coordinates = {0.5f, 2};
  const std::string text = scene_json(scene);
  EXPECT_THAT(text, HasSubstr(R"(,"details":["texture"],"textures":[{"dimensions":1,)"
                              R"("format":"rgba32f","levels":[{"width":1,"height":1,)"
                              R"("texels":[255,-0.0,0.10000000149011612,256.0]}],)"
                              R"("generated":false}],"draws")"));
  EXPECT_THAT(text, HasSubstr(R"(,"texture":{"texture":0,"wrap":["repeat","repeat"],)"
                              R"("magnify":"linear","minify":"nearest","mipmap":"none",)"
                              R"("lod_bias":0.0,"min_lod":-1000.0,"max_lod":1000.0,)"
                              R"("base_level":0,"max_level":1000,"border":[0.0,0.0,0.0,0.0],)"
                              R"("max_anisotropy":1.0,"lookup":{"kind":"implicit"}},"vertices")"));
  EXPECT_THAT(text, HasSubstr(R"("color":[1.0,0.0,0.0,1.0],"texture_coordinates":[0.5,2.0]}])"));
  expect_carried(scene);
}

TEST(TextureValues, ASceneWithoutThemHasNoneOfTheirKeys) {
  EXPECT_THAT(scene_json(small_scene()), Not(HasSubstr("texture")));
  const Scene scene = textured_scene();
  EXPECT_EQ(scene_json(scene).find("texture_coordinates", scene_json(scene).find("\"lines\"")),
            std::string::npos);
}

TEST(TextureValues, TexturesOfEveryFormatAndSizeAreCarried) {
  for (TextureFormat format : {TextureFormat::rgba8, TextureFormat::srgb8, TextureFormat::rgba32f})
    for (auto [width, height] :
         {std::pair(1, 1), {5, 3}, {3, 5}, {8, 8}, {1, 7}, {7, 1}, {1024, 1}, {1, 1024}})
      for (bool whole : {false, true})
        expect_carried(with_texture(make_texture(width, height, format, whole)));
  Texture two = make_texture(7, 1, TextureFormat::rgba8, true);
  two.dimensions = 2;
  expect_carried(with_texture(two));
}

TEST(TextureValues, ALevelOfOneColourIsOneTexel) {
  Texture texture = make_texture(3, 2, TextureFormat::rgba32f);
  std::vector<float>& texels = texture.levels[0].texels;
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = i % 4 == 1 ? 0.5f : 0.0f;
  const Scene uniform = with_texture(texture);
  EXPECT_THAT(scene_json(uniform), HasSubstr(R"("width":3,"height":2,"texel":[0,0.5,0,0]})"));
  expect_carried(uniform);
  // Zeros of both signs are not the same.
  texels[20] = -0.0f;
  const Scene mixed = with_texture(texture);
  EXPECT_THAT(scene_json(mixed), HasSubstr(R"("width":3,"height":2,"texels":[0,0.5,0,0,0,)"));
  expect_carried(mixed);
}

TEST(TextureValues, ATexelStandsInPlaceOfTexels) {
  Texture texture = make_texture(3, 2, TextureFormat::rgba8);
  for (float& texel : texture.levels[0].texels) texel = 7;
  const std::string good = scene_json(with_texture(texture));
  const std::string texel = R"("texel":[7,7,7,7])";
  EXPECT_THAT(message_of(replaced(good, texel, texel + R"(,"texels":[])")),
              HasSubstr("/levels/0 has both \"texel\" and \"texels\""));
  EXPECT_THAT(message_of(replaced(good, texel, R"("texel":[7,7,7])")),
              HasSubstr("/levels/0/texel must have 4 elements, but it has 3"));
  EXPECT_THAT(message_of(replaced(good, texel, R"("texel":[7,7,7,256])")),
              HasSubstr("/levels/0/texel/3 is 256"));
}

TEST(TextureValues, EveryKindOfFloatIsCarried) {
  Texture texture = make_texture(2, 2, TextureFormat::rgba32f);
  constexpr float kMax = std::numeric_limits<float>::max();
  constexpr float kTiny = std::numeric_limits<float>::denorm_min();
  const std::vector<float> texels = {0,     -0.0f, 1,           -1,      254.5f, 255,
                                     256,   -255,  kTiny,       -kTiny,  kMax,   -kMax,
                                     1e10f, 1e20f, 16777216.0f, 0x1p-24f};
  texture.levels[0].texels = texels;
  const Scene scene = with_texture(texture);
  const auto parsed = parse_request(request_line("a", scene_json(scene)));
  ASSERT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
  const auto& read = std::get<Request>(parsed).scene.textures[1]->levels[0].texels;
  EXPECT_EQ(read, texels);
  EXPECT_TRUE(std::signbit(read[1]));
}

TEST(TextureValues, EveryPartOfATextureUseIsCarriedAndInTheDigest) {
  std::set<std::string> texts;
  const auto expect_new = [&](auto change) {
    Scene scene = textured_scene();
    change(*scene.draws[0].texture);
    expect_carried(scene);
    EXPECT_TRUE(texts.insert(digest_of(scene_json(scene))).second) << scene_json(scene);
  };
  expect_new([](TextureUse&) {});
  for (std::size_t axis : {0u, 1u})
    for (Wrap wrap : {Wrap::mirrored_repeat, Wrap::clamp_to_edge, Wrap::clamp_to_border})
      expect_new([&](TextureUse& use) { use.sampler.wrap[axis] = wrap; });
  expect_new([](TextureUse& use) { use.texture = 1; });
  expect_new([](TextureUse& use) { use.texture = 2; });
  expect_new([](TextureUse& use) { use.sampler.magnify = Filter::nearest; });
  expect_new([](TextureUse& use) { use.sampler.minify = Filter::linear; });
  expect_new([](TextureUse& use) { use.sampler.mipmap = MipFilter::nearest; });
  expect_new([](TextureUse& use) { use.sampler.mipmap = MipFilter::linear; });
  expect_new([](TextureUse& use) { use.sampler.lod_bias = -16; });
  expect_new([](TextureUse& use) { use.sampler.min_lod = 1000; });
  expect_new([](TextureUse& use) { use.sampler.max_lod = 0.1f; });
  expect_new([](TextureUse& use) { use.sampler.base_level = 2; });
  expect_new([](TextureUse& use) { use.sampler.max_level = 0; });
  expect_new([](TextureUse& use) { use.sampler.border = {-1, 0.1f, 2, 1}; });
  expect_new([](TextureUse& use) { use.sampler.max_anisotropy = 16; });
  for (LookupKind kind : {LookupKind::bias, LookupKind::lod, LookupKind::gradients})
    expect_new([&](TextureUse& use) { use.lookup.kind = kind; });
  expect_new([](TextureUse& use) { use.lookup = {LookupKind::bias, 0.3f, {}, {}}; });
  expect_new([](TextureUse& use) { use.lookup = {LookupKind::lod, -2, {}, {}}; });
  expect_new([](TextureUse& use) {
    use.lookup = {LookupKind::gradients, 0, {0.1f, 0}, {-3, 1e-30f}};
  });
}

TEST(TextureValues, TextureCoordinatesAndTexelsAreInTheDigest) {
  const std::string digest = digest_of(scene_json(textured_scene()));
  Scene moved = textured_scene();
  moved.draws[0].vertices[1].texture_coordinates[1] += 1e24f;
  EXPECT_NE(digest_of(scene_json(moved)), digest);
  Texture texture = *textured_scene().textures[1];
  texture.levels[0].texels[7] = 0.5f;
  EXPECT_NE(digest_of(scene_json(with_texture(texture))), digest);
  texture = *textured_scene().textures[1];
  texture.generated = true;
  EXPECT_NE(digest_of(scene_json(with_texture(texture))), digest);
}

TEST(TextureValues, WrongTexturesAreRefused) {
  const std::string good = scene_json(textured_scene());
  const auto refusal = [&](const std::string& from, const std::string& to) {
    return message_of(replaced(good, from, to));
  };
  EXPECT_EQ(message_of(good), "");
  EXPECT_THAT(
      message_of(replaced(scene_json(small_scene()), "\"draws\"", R"("textures":[],"draws")")),
      HasSubstr("/scene/textures must have an element"));
  EXPECT_THAT(refusal("\"dimensions\":2", "\"dimensions\":3"),
              HasSubstr("/scene/textures/0/dimensions is 3, but it must be 1 to 2"));
  EXPECT_THAT(refusal("\"dimensions\":2", "\"dimensions\":1"),
              HasSubstr("/scene/textures/0/levels/0/height is 3, but a one-dimensional"));
  EXPECT_THAT(refusal("\"format\":\"rgba8\"", "\"format\":\"rgb8\""),
              HasSubstr("/scene/textures/0/format is the unknown name \"rgb8\""));
  EXPECT_THAT(refusal(",\"generated\":false", ""),
              HasSubstr("/scene/textures/0 has no \"generated\""));
  EXPECT_THAT(refusal("\"generated\":false", "\"generated\":0"),
              HasSubstr("/scene/textures/0/generated must be true or false, but it is 0"));
  EXPECT_THAT(refusal("\"generated\":false", "\"generated\":true"),
              HasSubstr("/levels has 3 levels, but generated ones are not given"));
  EXPECT_THAT(refusal("\"dimensions\":2", "\"dimensions\":2,\"file\":\"a\""),
              HasSubstr("unknown key \"file\""));
  EXPECT_THAT(refusal("{\"width\":5,", "{\"width\":1025,"),
              HasSubstr("/scene/textures/0/levels/0/width is 1025, but it must be 1 to 1024"));
  EXPECT_THAT(refusal("\"height\":3,", "\"height\":0,"), HasSubstr("/levels/0/height is 0"));
  EXPECT_THAT(refusal("{\"width\":5,", "{\"width\":6,"),
              HasSubstr("/scene/textures/0/levels/0/texels must have 72 elements, but it has 60"));
}

TEST(TextureValues, WrongTexelsAreRefused) {
  const std::string good = scene_json(textured_scene());
  const auto code = [&](const std::string& text) {
    return message_of(replaced(good, "\"texels\":[0,37,", "\"texels\":[0," + text + ","));
  };
  EXPECT_EQ(code("37"), message_of(good));
  EXPECT_THAT(code("256"), HasSubstr("/levels/0/texels/1 is 256, but it must be 0 to 255"));
  EXPECT_THAT(code("-1"), HasSubstr("/texels/1 is -1"));
  EXPECT_THAT(code("37.0"), HasSubstr("/texels/1 must be an integer"));
  const auto number = [&](const std::string& text) {
    return message_of(replaced(good, "\"texels\":[-7.0,", "\"texels\":[" + text + ","));
  };
  EXPECT_THAT(number("0.1"),
              HasSubstr("/scene/textures/1/levels/0/texels/0 is 0.1, but it must be a float32"));
  EXPECT_THAT(number("1e39"), HasSubstr("/texels/0 is 1e+39"));
  EXPECT_THAT(number("\"nan\""), HasSubstr("/texels/0 must be a number"));
}

TEST(TextureValues, WrongChainsAreRefused) {
  Texture texture = make_texture(5, 3, TextureFormat::rgba8, true);
  texture.levels.pop_back();
  expect_refused(with_texture(texture),
                 "/scene/textures/1/levels has 2 levels, but a whole chain has 3");
  texture.levels.push_back(texture_level(1, 1, texture.format));
  texture.levels.push_back(texture_level(1, 1, texture.format));
  expect_refused(with_texture(texture), "/levels has 4 levels, but a whole chain has 3");
  texture.levels.clear();
  expect_refused(with_texture(texture), "/scene/textures/1/levels must have an element");
  texture = make_texture(5, 3, TextureFormat::rgba8, true);
  texture.levels[1] = texture_level(3, 2, texture.format);
  expect_refused(with_texture(texture),
                 "/scene/textures/1/levels/1 is 3x2, but this level must be 2x1");
}

TEST(TextureValues, WrongTextureUsesAreRefused) {
  const std::string good = scene_json(textured_scene());
  const auto refusal = [&](const std::string& from, const std::string& to) {
    return message_of(replaced(good, from, to));
  };
  EXPECT_THAT(refusal("{\"texture\":0", "{\"texture\":3"),
              HasSubstr("/scene/draws/0/texture/texture is 3, but it must be 0 to 2"));
  EXPECT_THAT(refusal("[\"repeat\",\"repeat\"]", "[\"repeat\"]"),
              HasSubstr("/scene/draws/0/texture/wrap must have 2 elements"));
  EXPECT_THAT(refusal("[\"repeat\",\"repeat\"]", "[\"repeat\",\"clamp\"]"),
              HasSubstr("/texture/wrap/1 is the unknown name \"clamp\""));
  EXPECT_THAT(refusal("\"magnify\":\"linear\"", "\"magnify\":\"cubic\""),
              HasSubstr("/texture/magnify is the unknown name \"cubic\""));
  EXPECT_THAT(refusal("\"minify\":\"nearest\",", ""), HasSubstr("/texture has no \"minify\""));
  EXPECT_THAT(refusal("\"mipmap\":\"none\"", "\"mipmap\":true"),
              HasSubstr("/texture/mipmap must be a string"));
  EXPECT_THAT(refusal("\"lod_bias\":0.0", "\"lod_bias\":16.5"),
              HasSubstr("/texture/lod_bias is 16.5, but it must be a float32 value of -16 to 16"));
  EXPECT_THAT(refusal("\"min_lod\":-1000.0", "\"min_lod\":0.1"), HasSubstr("/min_lod is 0.1"));
  EXPECT_THAT(refusal("\"max_lod\":1000.0", "\"max_lod\":\"inf\""),
              HasSubstr("/max_lod must be a number"));
  EXPECT_THAT(refusal("\"min_lod\":-1000.0", "\"min_lod\":1000.5"),
              HasSubstr("/min_lod is 1000.5, but it must be a float32 value of -1000 to 1000"));
  EXPECT_THAT(refusal("\"min_lod\":-1000.0,\"max_lod\":1000.0", "\"min_lod\":2.5,\"max_lod\":2.0"),
              HasSubstr("/scene/draws/0/texture: min_lod is 2.5, above max_lod, which is 2"));
  EXPECT_THAT(refusal("\"base_level\":0", "\"base_level\":3"),
              HasSubstr("/texture: base_level is 3, and the texture has 3"));
  EXPECT_THAT(refusal("\"base_level\":0", "\"base_level\":-1"), HasSubstr("base_level is -1"));
  EXPECT_THAT(refusal("\"base_level\":0,\"max_level\":1000", "\"base_level\":2,\"max_level\":1"),
              HasSubstr("/texture: max_level is 1, below base_level, which is 2"));
  EXPECT_THAT(refusal("\"border\":[0.0,", "\"border\":["),
              HasSubstr("/texture/border must have 4 elements"));
  EXPECT_THAT(refusal("\"border\":[0.0,", "\"border\":[0.1,"),
              HasSubstr("/texture/border/0 is 0.1"));
  for (const char* anisotropy : {"0.5", "16.5"})
    EXPECT_THAT(refusal("\"max_anisotropy\":1.0", std::string("\"max_anisotropy\":") + anisotropy),
                HasSubstr(std::string("/max_anisotropy is ") + anisotropy +
                          ", but it must be a float32 value of 1 to 16"));
  EXPECT_THAT(refusal("{\"texture\":0", "{\"swizzle\":0,\"texture\":0"),
              HasSubstr("unknown key \"swizzle\""));
}

TEST(TextureValues, LevelsAreRefusedOfATextureThatHasNone) {
  Scene scene = textured_scene();
  TextureUse& use = *scene.draws[0].texture;
  use.texture = 1;
  use.sampler.mipmap = MipFilter::linear;
  expect_refused(scene,
                 "/texture: the mip filter is \"linear\", and the texture has level 0 alone");
  use.sampler.mipmap = MipFilter::none;
  use.sampler.base_level = 1;
  expect_refused(scene, "/texture: base_level is 1, and the texture has 1");
  use.texture = 2;  // generated: two levels
  use.sampler.mipmap = MipFilter::nearest;
  expect_carried(scene);
  use.sampler.base_level = 2;
  expect_refused(scene, "/texture: base_level is 2, and the texture has 2");
}

TEST(TextureValues, WrongLookupsAreRefused) {
  const std::string good = scene_json(textured_scene());
  const auto lookup = [&](const std::string& text) {
    return message_of(replaced(good, R"({"kind":"implicit"})", text));
  };
  EXPECT_THAT(lookup("{}"), HasSubstr("/scene/draws/0/texture/lookup has no \"kind\""));
  EXPECT_THAT(lookup(R"({"kind":"fetch"})"), HasSubstr("/kind is the unknown name \"fetch\""));
  EXPECT_THAT(lookup(R"({"kind":"implicit","value":1})"),
              HasSubstr("/lookup has \"value\", which a lookup of kind \"implicit\" does not"));
  EXPECT_THAT(lookup(R"({"kind":"lod"})"), HasSubstr("/lookup has no \"value\""));
  EXPECT_THAT(lookup(R"({"kind":"bias","value":"nan"})"),
              HasSubstr("/lookup/value must be a number"));
  EXPECT_THAT(lookup(R"({"kind":"lod","value":1,"dx":[0,0]})"),
              HasSubstr("/lookup has \"dx\", which a lookup of kind \"lod\" does not take"));
  EXPECT_THAT(lookup(R"({"kind":"gradients","dx":[0,0]})"), HasSubstr("/lookup has no \"dy\""));
  EXPECT_THAT(lookup(R"({"kind":"gradients","dx":[0,0],"dy":[0]})"),
              HasSubstr("/lookup/dy must have 2 elements"));
  EXPECT_THAT(lookup(R"({"kind":"gradients","dx":[0,0.1],"dy":[0,0]})"),
              HasSubstr("/lookup/dx/1 is 0.1, but it must be a float32 value"));
}

TEST(TextureValues, TextureCoordinatesBelongToTexturedDraws) {
  const std::string good = scene_json(textured_scene());
  const std::string first = ",\"texture_coordinates\":[-0.5,0.10000000149011612]";
  EXPECT_THAT(message_of(replaced(good, first, "")),
              HasSubstr("/scene/draws/0/vertices/0 has no \"texture_coordinates\""));
  const auto given = [&](const char* text) {
    return message_of(replaced(good, first, std::string(",\"texture_coordinates\":") + text));
  };
  EXPECT_THAT(given("[0.5]"), HasSubstr("/vertices/0/texture_coordinates must have 2 elements"));
  EXPECT_THAT(given("[0.5,0.1]"), HasSubstr("/texture_coordinates/1 is 0.1, but it must be a"));
  EXPECT_THAT(given("[\"nan\",0]"), HasSubstr("/texture_coordinates/0 must be a number"));
  EXPECT_THAT(
      message_of(replaced(scene_json(small_scene()), "\"color\":[1.0,0",
                          "\"texture_coordinates\":[0,0],\"color\":[1.0,0")),
      HasSubstr("/scene/draws/0/vertices/0 has \"texture_coordinates\", but its draw has no"));
  Scene scene = textured_scene();
  scene.textures.clear();
  expect_refused(scene, "/scene/draws/0/texture is there, but the scene has no textures");
}

}  // namespace
}  // namespace edgecase
