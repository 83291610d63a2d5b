// SPDX-License-Identifier: MIT
//
// Supersampled scenes on their way: passes in a request, what they made in an answer.
#include <gmock/gmock.h>

#include <limits>

#include "model/scene.h"
#include "tests/wire/scenes.h"
#include "wire/answer_line.h"
#include "wire/rendering_json.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

constexpr const char* kDigest = "0123456789abcdef";

ShadingPass pass_at(std::int64_t raw_x, std::int64_t raw_y, std::int64_t weight) {
  return {{Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)}, weight};
}

Scene two_passes(Scene scene = small_scene()) {
  scene.supersampling = {pass_at(-65536, 1, 1), pass_at(131072, 49152, 1 << 20)};
  return scene;
}

std::variant<Request, WireError> parse_scene(const std::string& scene) {
  return parse_request(request_line("a", scene));
}

std::string refusal_of(const Scene& scene) {
  return fault_in(parse_scene(scene_json(scene)));
}

TEST(SupersampledRequests, AreReadBack) {
  for (const Scene& scene : {two_passes(), two_passes(textured_scene())}) {
    const auto parsed = parse_scene(scene_json(scene));
    ASSERT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
    EXPECT_TRUE(same_scene(std::get<Request>(parsed).scene, scene));
  }
  Scene most = small_scene();
  most.supersampling.resize(kMaxPasses, pass_at(7, 9, 3));
  EXPECT_EQ(refusal_of(most), "");
}

TEST(SupersampledRequests, HaveTheDocumentedForm) {
  EXPECT_THAT(scene_json(two_passes()),
              HasSubstr(R"(,1.0],"supersampling":[[-1.0,1.52587890625e-05,1],[2.0,0.75,1048576]]})"
                        R"(,"viewport")"));
  EXPECT_THAT(scene_json(small_scene()), Not(HasSubstr("supersampling")));
}

TEST(SupersampledRequests, TellScenesApartInTheDigest) {
  const Scene scene = two_passes();
  std::vector<Scene> others(4, scene);
  others[0].supersampling.clear();
  others[1].supersampling[0].at.x = Fixed();
  others[2].supersampling[1].weight = 1;
  std::swap(others[3].supersampling[0], others[3].supersampling[1]);
  for (const Scene& other : others)
    EXPECT_NE(digest_of(scene_json(other)), digest_of(scene_json(scene)));
}

TEST(SupersampledRequests, RefuseWhatIsNone) {
  const std::string good = scene_json(two_passes());
  const auto refusal = [&](const std::string& from, const std::string& to) {
    const auto parsed = parse_scene(replaced(good, from, to));
    const auto* error = std::get_if<WireError>(&parsed);
    return error == nullptr ? std::string() : error->message;
  };
  const std::string first = "[-1.0,1.52587890625e-05,1]";
  const std::string list = "[[-1.0,1.52587890625e-05,1],[2.0,0.75,1048576]]";
  EXPECT_THAT(refusal(list, "[]"), HasSubstr("/scene/target/supersampling has 0 elements"));
  EXPECT_THAT(refusal(list, "{}"), HasSubstr("/scene/target/supersampling must"));
  EXPECT_THAT(refusal(first, "[0.5,0.5]"), HasSubstr("supersampling/0 must have 3 elements"));
  EXPECT_THAT(refusal(first, "[-1.5,0.5,1]"),
              HasSubstr("supersampling/0/0 is -1.5, but it must be -1 to 2"));
  EXPECT_THAT(refusal(first, "[0.5,2.5,1]"), HasSubstr("supersampling/0/1 is 2.5"));
  EXPECT_THAT(refusal(first, "[0.1,0.5,1]"), HasSubstr("must be a multiple of 2^-16"));
  EXPECT_THAT(refusal(first, "[0.5,0.5,0]"), HasSubstr("supersampling/0/2 is 0"));
  EXPECT_THAT(refusal(first, "[0.5,0.5,1048577]"), HasSubstr("supersampling/0/2 is 1048577"));
  EXPECT_THAT(refusal(first, "[0.5,0.5,1.0]"), HasSubstr("supersampling/0/2"));
  EXPECT_THAT(refusal(R"("samples":1)", R"("samples":2)"),
              HasSubstr("supersampling is there, but the target has several samples"));
}

TEST(SupersampledRequests, KeepToTheLimitsOfScenes) {
  Scene scene = small_scene();
  scene.supersampling.resize(kMaxPasses + 1, pass_at(7, 9, 3));
  EXPECT_THAT(refusal_of(scene), HasSubstr("has 1025 elements, but it must have 1 to 1024"));
  scene = two_passes();
  scene.target.width = scene.target.height = 2048;
  EXPECT_THAT(refusal_of(scene), HasSubstr("2 passes of 4194309 pixels"));
  scene = two_passes();
  scene.draws[1].vertices[0].position.x = Fixed::from_integer(8192);
  EXPECT_THAT(refusal_of(scene), HasSubstr("/supersampling/0 moves a vertex out of its range"));
  scene.supersampling[0].at.x = Fixed::from_integer(1);
  EXPECT_EQ(refusal_of(scene), "");
}

// 3 x 2 pixels: the second pass has a fragment, the first one none.
Rendering two_pass_rendering() {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.pixels.resize(24, 7);
  for (int i = 0; i < 24; ++i) rendering.accumulated.push_back(i / 3.0 - 1);
  rendering.accumulated[3] = std::numeric_limits<double>::infinity();
  Rendering pass;
  pass.width = 3;
  pass.height = 2;
  pass.pixels.resize(24, 9);
  pass.hits.resize(6);
  pass.depths.resize(6, 1);
  rendering.passes = {pass, pass};
  Fragment fragment;
  fragment.x = 2;
  fragment.detail = 0;
  FragmentDetail detail;
  detail.coordinates = {2.5, 0.5, 0.25, 1};
  Rendering& second = rendering.passes[1];
  second.fragments = {fragment};
  second.details = {detail};
  second.hits[2] = 1;
  second.depths[2] = 0.25;
  return rendering;
}

Scene scene_of_answer() {
  Scene scene = two_passes();
  scene.target.depth = DepthFormat::depth24;
  scene.details.coordinates = true;
  return scene;
}

std::variant<Answer, WireError> parse(const std::string& line,
                                      const Scene& scene = scene_of_answer()) {
  return parse_answer(line, kDigest, scene, true);
}

std::string message_of(const std::string& line, const Scene& scene = scene_of_answer()) {
  return fault_in(parse(line, scene));
}

TEST(SupersampledAnswers, AreReadBackPassByPass) {
  const Rendering told = two_pass_rendering();
  const auto parsed = parse(answer_line(kDigest, told, nullptr));
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const auto& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_EQ(read.pixels, told.pixels);
  EXPECT_EQ(read.accumulated, told.accumulated);
  EXPECT_THAT(read.fragments, IsEmpty());
  EXPECT_THAT(read.hits, IsEmpty());
  EXPECT_THAT(read.depths, IsEmpty());
  ASSERT_THAT(read.passes, SizeIs(2));
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read.passes[k].width, 3);
    EXPECT_EQ(read.passes[k].pixels, told.passes[k].pixels);
    EXPECT_EQ(read.passes[k].hits, told.passes[k].hits);
    EXPECT_EQ(read.passes[k].depths, told.passes[k].depths);
    EXPECT_THAT(read.passes[k].fragments, SizeIs(k));
  }
  EXPECT_EQ(read.passes[1].fragments[0].x, 2);
  ASSERT_THAT(read.passes[1].details, SizeIs(1));
  EXPECT_EQ(read.passes[1].details[0].coordinates, (std::array<double, 4>{2.5, 0.5, 0.25, 1}));
}

TEST(SupersampledAnswers, MayBeRefusedByTheRenderer) {
  const auto parsed = parse(refusal_line(kDigest, "no passes", nullptr));
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed));
  EXPECT_EQ(std::get<Failure>(std::get<Answer>(parsed).outcome).reason, "no passes");
}

TEST(SupersampledAnswers, HaveTheDocumentedForm) {
  Rendering rendering;
  rendering.width = rendering.height = 1;
  rendering.pixels = {1, 2, 3, 4};
  rendering.accumulated = {0.5, -1, std::numeric_limits<double>::quiet_NaN(), 1};
  Rendering pass;
  pass.pixels = {5, 6, 7, 8};
  rendering.passes = {pass, pass};
  rendering.passes[1].depths = {0.5};
  rendering.passes[1].hits = {0};
  rendering.passes[1].mip_chains[3] = {{1, 1, {1, 2, 3, 4}}};
  const std::string passes =
      R"("accumulated":[0.5,-1,"nan",1],"passes":[{"pixels":[5,6,7,8],"fragments":[]},)"
      R"({"pixels":[5,6,7,8],"fragments":[],"depths":[0.5],"mip_chains":{"3":[)";
  EXPECT_THAT(answer_line(kDigest, rendering, nullptr),
              HasSubstr(R"({"digest":"0123456789abcdef","pixels":[1,2,3,4],)" + passes));
  EXPECT_THAT(answer_line(kDigest, rendering, nullptr), HasSubstr(R"(]},"hits":[0]}]})"));
  EXPECT_THAT(rendering_json("a", rendering),
              HasSubstr(R"("samples":1,"fragments":[],"pixels":[1,2,3,4],)" + passes));
}

TEST(SupersampledAnswers, AreRefusedForTheirFaults) {
  const std::string good = answer_line(kDigest, two_pass_rendering(), nullptr);
  EXPECT_EQ(message_of(good), "");
  const auto refusal = [&](const std::string& from, const std::string& to) {
    return message_of(replaced(good, from, to));
  };
  EXPECT_THAT(refusal(R"("accumulated":[-1,)", R"("accumulated":[)"),
              HasSubstr("/accumulated must have 24 elements, but it has 23"));
  EXPECT_THAT(refusal(R"("accumulated":[-1,)", R"("accumulated":[true,)"),
              HasSubstr("/accumulated/0 must be a number"));
  EXPECT_THAT(refusal(R"("accumulated")", R"("image")"), HasSubstr("unknown key \"image\""));
  EXPECT_THAT(refusal(R"("passes":[)", R"("passes":[{},)"),
              HasSubstr("/passes must have 2 elements, but it has 3"));
  EXPECT_THAT(refusal(R"({"pixels":[9,)", R"({"pixels":[)"),
              HasSubstr("/passes/0/pixels must have 24 elements, but it has 23"));
  EXPECT_THAT(refusal(R"("x":2)", R"("x":3)"), HasSubstr("/passes/1/fragments/0/x is 3"));
  EXPECT_THAT(refusal(R"("hits":[0,0,0)", R"("hits":[0,1,0)"),
              HasSubstr("/passes/0: hit counts and fragments contradict each other at pixel (1"));
  EXPECT_THAT(refusal(R"({"pixels")", R"({"digest":"x","pixels")"),
              HasSubstr("unknown key \"digest\""));
  EXPECT_THAT(refusal(R"("depths":[1,)", R"("depths":[2,)"),
              HasSubstr("/passes/0/depths/0 is 2, but it must be 0 to 1"));
  Scene flat = scene_of_answer();
  flat.target.depth = DepthFormat::none;
  EXPECT_THAT(message_of(good, flat),
              HasSubstr("/passes/0 has \"depths\", but the target has no depth buffer"));
}

TEST(SupersampledAnswers, TellNothingBesideThePasses) {
  const std::string good = answer_line(kDigest, two_pass_rendering(), nullptr);
  for (const char* key : {"fragments", "coverage", "depths", "mip_chains", "hits",
                          "sample_positions", "sample_pixels"}) {
    const std::string line = "{\"" + std::string(key) + "\":[]," + good.substr(1);
    EXPECT_THAT(message_of(line), HasSubstr("\"" + std::string(key) + "\"")) << key;
  }
  EXPECT_THAT(message_of("{\"hits\":[]," + good.substr(1)),
              HasSubstr("has \"hits\" beside the passes of a supersampled scene"));
  EXPECT_THAT(message_of("{\"not_run\":\"no\"," + good.substr(1)),
              HasSubstr("has both \"not_run\" and"));
}

TEST(SupersampledAnswers, BelongToSupersampledScenes) {
  const Rendering rendering = two_pass_rendering();
  EXPECT_THAT(message_of(answer_line(kDigest, rendering, nullptr), small_scene()),
              HasSubstr("has \"passes\", but the scene is not supersampled"));
  EXPECT_THAT(message_of(R"({"digest":"0123456789abcdef","accumulated":[]})", small_scene()),
              HasSubstr("has \"accumulated\", but the scene is not supersampled"));
  Rendering plain = rendering.passes[0];
  EXPECT_THAT(message_of(answer_line(kDigest, plain, nullptr)),
              HasSubstr("has \"fragments\" beside the passes"));
  EXPECT_THAT(message_of(coverage_line(kDigest, plain, nullptr)),
              HasSubstr("has \"coverage\" beside the passes"));
}

}  // namespace
}  // namespace edgecase
