// SPDX-License-Identifier: MIT
//
// Texture coordinates, levels of detail and mip chains on their way in an answer.
#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/wire/scenes.h"
#include "wire/answer_line.h"
#include "wire/message.h"
#include "wire/rendering_json.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kDigest = "0123456789abcdef";
constexpr float kInf = std::numeric_limits<float>::infinity();

std::variant<Answer, WireError> parse(const std::string& line, const Scene& scene) {
  return parse_answer(line, kDigest, scene);
}

std::string message_of(const std::string& line, const Scene& scene = textured_scene()) {
  return fault_in(parse(line, scene));
}

// Four fragments of the textured triangle: both details, each alone, none. One of the line.
Rendering textured_rendering() {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.pixels.resize(24);
  rendering.details.resize(3);
  rendering.details[0].texture_coordinates = {0.25, static_cast<double>(-0.1f)};
  rendering.details[0].level_of_detail = {1.5, static_cast<double>(-kInf)};
  rendering.details[1].texture_coordinates = {static_cast<double>(kInf), 7};
  rendering.details[2].level_of_detail = {0, 0.75};
  for (int i = 0; i < 5; ++i) {
    Fragment fragment;
    fragment.x = i % 3;
    fragment.y = i / 3;
    fragment.detail = i < 3 ? i : -1;
    fragment.primitive = i == 4 ? 1 : 0;
    rendering.fragments.push_back(fragment);
  }
  rendering.mip_chains[2] = {texture_level(2, 2, TextureFormat::srgb8),
                             texture_level(1, 1, TextureFormat::srgb8)};
  return rendering;
}

// The rendering that a line tells.
Rendering read_back(const std::string& line, const Scene& scene = textured_scene()) {
  const auto parsed = parse(line, scene);
  EXPECT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  return std::get<Rendering>(std::get<Answer>(parsed).outcome);
}

TEST(TextureAnswers, AreReadBack) {
  const Rendering rendering = textured_rendering();
  const Rendering read = read_back(answer_line(kDigest, rendering, nullptr));
  ASSERT_EQ(read.fragments.size(), 5u);
  ASSERT_EQ(read.details.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(read.fragments[i].detail, static_cast<int>(i));
    const FragmentDetail& got = read.details[i];
    const FragmentDetail& told = rendering.details[i];
    EXPECT_EQ(got.texture_coordinates, told.texture_coordinates);
    EXPECT_EQ(got.level_of_detail, told.level_of_detail);
    EXPECT_FALSE(got.coordinates.has_value());
  }
  EXPECT_EQ(read.fragments[3].detail, -1);
  EXPECT_EQ(read.mip_chains, rendering.mip_chains);
}

TEST(TextureAnswers, NotANumberIsToldAsOne) {
  Rendering rendering = textured_rendering();
  rendering.details[0].level_of_detail = {std::nan(""), 0};
  const std::string line = answer_line(kDigest, rendering, nullptr);
  EXPECT_THAT(line, HasSubstr(R"("level_of_detail":["nan",0])"));
  EXPECT_TRUE(std::isnan(read_back(line).details[0].level_of_detail.value()[0]));
}

TEST(TextureAnswers, HaveTheDocumentedForm) {
  Rendering rendering = textured_rendering();
  rendering.fragments.resize(1);
  rendering.details[0].coordinates.emplace();
  rendering.mip_chains[11] = {texture_level(1, 1, TextureFormat::rgba32f)};
  EXPECT_EQ(fragments_json(rendering),
            R"([{"x":0,"y":0,"primitive":0,"coverage":1,"depth":0,"color":[0,0,0,0],)"
            R"("coordinates":[0,0,0,0],"texture_coordinates":[0.25,-0.10000000149011612],)"
            R"("level_of_detail":[1.5,"-inf"]}])");
  const std::string chains =
      R"(,"mip_chains":{"2":[{"width":2,"height":2,"texels":[0,37,74,111,148,185,222,3,40,77,114,)"
      R"(151,188,225,6,43]},{"width":1,"height":1,"texels":[0,37,74,111]}],"11":[{"width":1,)"
      R"("height":1,"texels":[-7.0,5.3333330154418945,17.66666603088379,30]}]})";
  EXPECT_THAT(rendering_json("a", rendering), HasSubstr("]" + chains + "}"));
  EXPECT_THAT(answer_line(kDigest, rendering, nullptr), HasSubstr("]" + chains + "}"));
  rendering.mip_chains.clear();
  EXPECT_THAT(rendering_json("a", rendering), Not(HasSubstr("mip_chains")));
  EXPECT_THAT(answer_line(kDigest, rendering, nullptr), Not(HasSubstr("mip_chains")));
}

// Whether a renderer makes the right levels is not for the reader to say.
TEST(TextureAnswers, ChainsOfTheWrongSizesAreCarried) {
  Rendering rendering = textured_rendering();
  for (auto [width, height] : {std::pair(1, 1), {2, 1}, {2, 2}})
    rendering.mip_chains[2].push_back(texture_level(width, height, TextureFormat::srgb8));
  EXPECT_EQ(read_back(answer_line(kDigest, rendering, nullptr)).mip_chains, rendering.mip_chains);
}

// One texel stands for a level of any size, so a short line could ask for gigabytes.
TEST(TextureAnswers, ChainsThatNoImageOfTheSizeHasAreRefused) {
  Rendering rendering = textured_rendering();
  std::vector<TextureLevel>& chain = rendering.mip_chains[2];
  chain.push_back(texture_level(3, 1, TextureFormat::srgb8));
  EXPECT_THAT(message_of(answer_line(kDigest, rendering, nullptr)),
              HasSubstr("/mip_chains/2/2/width is 3, but it must be 1 to 2"));
  chain.assign(11, texture_level(1, 1, TextureFormat::srgb8));
  EXPECT_EQ(message_of(answer_line(kDigest, rendering, nullptr)), "");
  chain.push_back(chain.back());
  EXPECT_THAT(message_of(answer_line(kDigest, rendering, nullptr)),
              HasSubstr("/mip_chains/2 has 12 levels, but there are 11 at most"));
}

// Bytes carry any floats.
TEST(TextureAnswers, ChainsAreCheckedAsBytes) {
  constexpr std::uint64_t kOfRequest = 62;
  const auto refusal = [&](const std::function<void(std::vector<TextureLevel>&)>& change) {
    Rendering rendering = textured_rendering();
    change(rendering.mip_chains[2]);
    return fault_in(parse_answer_message(answer_message(kOfRequest, rendering, false, nullptr),
                                         kOfRequest, textured_scene(), false));
  };
  EXPECT_EQ(refusal([](auto&) {}), "");
  for (const float texel : {256.0F, -1.0F, 0.5F, std::nanf("")})
    EXPECT_THAT(refusal([&](auto& chain) { chain[1].texels[2] = texel; }),
                HasSubstr("a texel that srgb8 does not hold"));
  EXPECT_THAT(refusal([](auto& chain) { chain[1] = texture_level(1, 3, TextureFormat::srgb8); }),
              HasSubstr("a level is 1x3, and the image is 2x2"));
  EXPECT_THAT(refusal([](auto& chain) { chain.resize(12, TextureLevel(chain[1])); }),
              HasSubstr("12 levels"));
}

TEST(TextureAnswers, FloatChainsMayHoldWhatIsNotFinite) {
  Scene scene = textured_scene();
  Texture texture = make_texture(2, 2, TextureFormat::rgba32f);
  texture.generated = true;
  scene.textures[2] = std::make_shared<const Texture>(texture);
  Rendering rendering = textured_rendering();
  TextureLevel& level = rendering.mip_chains[2][1];
  level.texels = {std::numeric_limits<float>::quiet_NaN(), kInf, -kInf, -0.1f};
  const std::string line = answer_line(kDigest, rendering, nullptr);
  EXPECT_THAT(line, HasSubstr(R"("texels":["nan","inf","-inf",-0.10000000149011612]})"));
  const Rendering read = read_back(line, scene);
  const std::vector<float>& texels = read.mip_chains.at(2)[1].texels;
  EXPECT_TRUE(std::isnan(texels[0]));
  EXPECT_EQ(texels[1], kInf);
  EXPECT_EQ(texels[2], -kInf);
  EXPECT_EQ(texels[3], -0.1f);
  EXPECT_THAT(message_of(line), HasSubstr("/mip_chains/2/1/texels/0 must be an integer"));
}

std::string with_fragment(const std::string& more, const std::string& chains = "") {
  return R"({"digest":"0123456789abcdef","pixels":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,)"
         R"(0,0],"fragments":[{"x":0,"y":0,"primitive":)" +
         more + "}]" + chains + "}";
}

TEST(TextureAnswers, WrongDetailsAreRefused) {
  EXPECT_EQ(message_of(with_fragment("0")), "");
  EXPECT_EQ(message_of(with_fragment(R"(0,"level_of_detail":["nan","-inf"])")), "");
  EXPECT_THAT(message_of(with_fragment(R"(0,"texture_coordinates":[0])")),
              HasSubstr("/fragments/0/texture_coordinates must have 2 elements, but it has 1"));
  EXPECT_THAT(message_of(with_fragment(R"(0,"texture_coordinates":[0,null])")),
              HasSubstr("/fragments/0/texture_coordinates/1 must be a number"));
  EXPECT_THAT(message_of(with_fragment(R"(0,"level_of_detail":1.5)")),
              HasSubstr("/fragments/0/level_of_detail must be an array"));
  EXPECT_THAT(message_of(with_fragment(R"(0,"level_of_detail":[1,"far"])")),
              HasSubstr("/fragments/0/level_of_detail/1 must be a number, \"nan\""));
}

TEST(TextureAnswers, DetailsAreRefusedWhereThereAreNone) {
  Scene scene = textured_scene();
  scene.details = {true, true, false};
  for (const char* key : {"texture_coordinates", "level_of_detail"}) {
    const std::string told = std::string(",\"") + key + "\":[0,0]";
    EXPECT_EQ(message_of(with_fragment("0" + told)), "");
    EXPECT_THAT(message_of(with_fragment("0" + told), scene),
                HasSubstr(std::string("/fragments/0 has \"") + key +
                          "\", which the request does not ask for"));
    // The line is not textured.
    EXPECT_THAT(
        message_of(with_fragment("1" + told)),
        HasSubstr(std::string("/fragments/0 has \"") + key + "\", but its draw has no texture"));
  }
}

TEST(TextureAnswers, WrongChainsAreRefused) {
  const auto chains = [](const std::string& text) {
    return message_of(with_fragment("0", ",\"mip_chains\":" + text));
  };
  const std::string level = R"({"width":1,"height":1,"texels":[0,1,2,255]})";
  EXPECT_EQ(chains("{}"), "");
  EXPECT_EQ(chains(R"({"2":[)" + level + "]}"), "");
  EXPECT_THAT(chains("[]"), HasSubstr("/mip_chains must be an object of arrays"));
  for (const std::string key : {"3", "02", "", "x", "2 ", "-1", "18446744073709551618"})
    EXPECT_THAT(chains("{\"" + key + "\":[" + level + "]}"),
                HasSubstr("/mip_chains has the key \"" + key + "\", which is no number of a"));
  EXPECT_THAT(chains(R"({"0":[)" + level + "]}"),
              HasSubstr("/mip_chains/0 is there, but the request gives this texture's levels"));
  EXPECT_THAT(chains(R"({"2":{}})"), HasSubstr("/mip_chains/2 must be an array"));
  EXPECT_THAT(chains(R"({"2":[]})"), HasSubstr("/mip_chains/2 must have an element"));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = level;
    return chains(R"({"2":[)" + text.replace(text.find(from), from.size(), to) + "]}");
  };
  EXPECT_THAT(changed("\"width\":1", "\"width\":0"), HasSubstr("/mip_chains/2/0/width is 0"));
  EXPECT_THAT(changed("\"height\":1", "\"height\":1025"), HasSubstr("/height is 1025"));
  EXPECT_THAT(changed("\"height\":1,", ""), HasSubstr("/mip_chains/2/0 has no \"height\""));
  EXPECT_THAT(changed("[0,", "["), HasSubstr("/texels must have 4 elements, but it has 3"));
  EXPECT_THAT(changed("255", "256"), HasSubstr("/mip_chains/2/0/texels/3 is 256"));
  EXPECT_THAT(changed("255", "0.5"), HasSubstr("/mip_chains/2/0/texels/3 must be an integer"));
}

TEST(TextureAnswers, FloatChainsAreHeldAgainstFloat32) {
  Scene scene = textured_scene();
  Texture texture = make_texture(2, 2, TextureFormat::rgba32f);
  texture.generated = true;
  scene.textures[2] = std::make_shared<const Texture>(texture);
  const auto texel = [&](const std::string& text) {
    return message_of(with_fragment("0", R"(,"mip_chains":{"2":[{"width":1,"height":1,"texels":[)" +
                                             text + ",0,0,0]}]}"),
                      scene);
  };
  EXPECT_EQ(texel("0.5"), "");
  EXPECT_THAT(texel("0.1"), HasSubstr("/mip_chains/2/0/texels/0 is 0.1, but it must be a float32"));
  EXPECT_THAT(texel("1e39"), HasSubstr("/texels/0 is 1e+39"));
  EXPECT_THAT(texel("\"far\""), HasSubstr("/texels/0 must be a number, \"nan\""));
}

TEST(TextureAnswers, CoverageAloneTellsNone) {
  const std::string line = coverage_line(kDigest, textured_rendering(), nullptr);
  const auto parsed = parse_answer(line, kDigest, textured_scene(), true);
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Rendering& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_TRUE(read.details.empty());
  EXPECT_TRUE(read.mip_chains.empty());
  const auto both = parse_answer(line.substr(0, line.size() - 1) + ",\"mip_chains\":{}}", kDigest,
                                 textured_scene(), true);
  ASSERT_TRUE(std::holds_alternative<WireError>(both));
  EXPECT_THAT(std::get<WireError>(both).message, HasSubstr("both \"coverage\" and \"mip_chains\""));
  EXPECT_THAT(message_of(R"({"digest":"0123456789abcdef","not_run":"why","mip_chains":{}})"),
              HasSubstr("both \"not_run\" and \"mip_chains\""));
}

}  // namespace
}  // namespace edgecase
