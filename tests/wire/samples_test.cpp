// SPDX-License-Identifier: MIT
//
// Samples on their way: positions and use of them in a request, planes of them in an answer.
#include <gmock/gmock.h>

#include "model/scene.h"
#include "tests/wire/scenes.h"
#include "wire/answer_line.h"
#include "wire/rendering_json.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kDigest = "0123456789abcdef";

Point point_of(std::int64_t raw_x, std::int64_t raw_y) {
  return {Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)};
}

// small_scene with two samples: the triangle uses them in its own way, the line as usual.
Scene two_samples() {
  Scene scene = small_scene();
  scene.target.samples = 2;
  scene.target.sample_positions = {point_of(0, 65535), point_of(49152, 1)};
  scene.draws[0].multisampling = {false, AttributeLocation::centroid, 0.3F, 2, true};
  return scene;
}

std::variant<Request, WireError> parse_scene(const std::string& scene) {
  return parse_request(request_line("a", scene));
}

Scene read_back(const Scene& scene) {
  const auto parsed = parse_scene(scene_json(scene));
  EXPECT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
  return std::holds_alternative<Request>(parsed) ? std::get<Request>(parsed).scene : Scene{};
}

TEST(SampleRequests, AreReadBack) {
  Scene scene = two_samples();
  EXPECT_TRUE(same_scene(read_back(scene), scene));
  for (const AttributeLocation location :
       {AttributeLocation::center, AttributeLocation::centroid, AttributeLocation::sample}) {
    scene.draws[1].multisampling.location = location;
    EXPECT_TRUE(same_scene(read_back(scene), scene));
  }
  for (int samples = 2; samples <= kMaxSamples; ++samples) {
    scene.target.samples = samples;
    scene.target.sample_positions.clear();
    EXPECT_TRUE(same_scene(read_back(scene), scene)) << samples;
    for (int i = 0; i < samples; ++i)
      scene.target.sample_positions.push_back(point_of(4097 * i, 65535 - i));
    EXPECT_TRUE(same_scene(read_back(scene), scene)) << samples;
  }
}

TEST(SampleRequests, HaveTheDocumentedForm) {
  const std::string text = scene_json(two_samples());
  EXPECT_THAT(text, HasSubstr(R"("samples":2,"sample_positions":[[0.0,0.9999847412109375],)"
                              R"([0.75,1.52587890625e-05]],"color":"rgba8")"));
  EXPECT_THAT(text, HasSubstr(R"("multisampling":{"enabled":false,"location":"centroid",)"
                              R"("min_sample_shading":0.30000001192092896,"mask":2,)"
                              R"("alpha_to_coverage":true},"vertices")"));
  EXPECT_THAT(text, HasSubstr(R"("scissor":[-1,0,3,0],"multisampling":{"enabled":true,)"
                              R"("location":"center","mask":3,"alpha_to_coverage":false},)"));
}

TEST(SampleRequests, SayNothingOfSamplesWhereThereIsOne) {
  Scene scene = small_scene();
  const std::string plain = scene_json(scene);
  EXPECT_THAT(plain, Not(HasSubstr("sampling")));
  EXPECT_THAT(plain, Not(HasSubstr("positions")));
  scene.draws[0].multisampling.mask = 1;
  EXPECT_EQ(scene_json(scene), plain);
}

TEST(SampleRequests, AMaskOfAllSamplesMasksNothing) {
  Scene scene = two_samples();
  scene.draws[0].multisampling.mask = 3;
  EXPECT_EQ(read_back(scene).draws[0].multisampling.mask, Multisampling{}.mask);
  scene.draws[0].multisampling.mask = 0xfffffffe;
  EXPECT_EQ(read_back(scene).draws[0].multisampling.mask, 2U);
}

TEST(SampleRequests, TellScenesApartInTheDigest) {
  const Scene scene = two_samples();
  std::vector<Scene> others(7, scene);
  others[0].target.samples = 4;
  others[0].target.sample_positions.clear();
  std::swap(others[1].target.sample_positions[0], others[1].target.sample_positions[1]);
  others[2].draws[1].multisampling.enabled = false;
  others[3].draws[1].multisampling.location = AttributeLocation::sample;
  others[4].draws[0].multisampling.min_sample_shading.reset();
  others[5].draws[1].multisampling.mask = 0;
  others[6].draws[1].multisampling.alpha_to_coverage = true;
  for (const Scene& other : others)
    EXPECT_NE(digest_of(scene_json(other)), digest_of(scene_json(scene)));
}

TEST(SampleRequests, RefuseWhatIsNone) {
  const std::string good = scene_json(two_samples());
  const auto refusal = [&](const std::string& from, const std::string& to) {
    const auto parsed = parse_scene(replaced(good, from, to));
    const auto* error = std::get_if<WireError>(&parsed);
    return error == nullptr ? "" : error->message;
  };
  EXPECT_THAT(refusal(R"("samples":2)", R"("samples":17)"),
              HasSubstr("/scene/target/samples is 17, but it must be 1 to 16"));
  EXPECT_THAT(refusal(R"("samples":2)", R"("samples":4)"),
              HasSubstr("/scene/target/sample_positions must have 4 elements, but it has 2"));
  EXPECT_THAT(refusal(R"("samples":2)", R"("samples":1)"),
              HasSubstr("/scene/target/sample_positions is there, but the target has one sample"));
  EXPECT_THAT(refusal("[0.75,1.52587890625e-05]", "[0.75]"),
              HasSubstr("/scene/target/sample_positions/1 must have 2 elements, but it has 1"));
  EXPECT_THAT(refusal("[0.75,", "[1.0,"),
              HasSubstr("/scene/target/sample_positions/1/0 is 1.0, but it must be 0 to below 1"));
  EXPECT_THAT(refusal("[0.75,", "[-0.25,"), HasSubstr("is -0.25, but it must be 0 to below 1"));
  EXPECT_THAT(refusal("[0.75,", "[0.7,"),
              HasSubstr("/0 is 0.7, but it must be a multiple of 2^-16"));
  EXPECT_THAT(refusal("[0.75,", "[\"0.75\","), HasSubstr("must be a number"));
  EXPECT_THAT(refusal(R"("enabled":false)", R"("enabled":0)"),
              HasSubstr("/scene/draws/0/multisampling/enabled must be true or false"));
  EXPECT_THAT(refusal(R"("enabled":false,)", ""),
              HasSubstr("/scene/draws/0/multisampling has no \"enabled\""));
  EXPECT_THAT(refusal("\"centroid\"", "\"centre\""), HasSubstr("unknown name \"centre\""));
  EXPECT_THAT(refusal("0.30000001192092896", "0.3"), HasSubstr("float32 value of 0 to 1"));
  EXPECT_THAT(refusal("0.30000001192092896", "1.5"), HasSubstr("float32 value of 0 to 1"));
  EXPECT_THAT(refusal(R"("mask":2)", R"("mask":4)"),
              HasSubstr("/scene/draws/0/multisampling/mask is 4, but it must be 0 to 3"));
  EXPECT_THAT(refusal(R"("mask":2)", R"("mask":2,"masks":2)"), HasSubstr("unknown key \"masks\""));
  EXPECT_THAT(refusal(R"("alpha_to_coverage":true)", R"("alpha_to_coverage":null)"),
              HasSubstr("alpha_to_coverage must be true or false"));
  EXPECT_THAT(refusal(R"("multisampling":{"enabled":true,"location":"center","mask":3,)"
                      R"("alpha_to_coverage":false},)",
                      ""),
              HasSubstr("/scene/draws/1 has no \"multisampling\""));
  const auto parsed = parse_scene(
      replaced(scene_json(small_scene()), R"("vertices")", R"("multisampling":{},"vertices")"));
  ASSERT_TRUE(std::holds_alternative<WireError>(parsed));
  EXPECT_THAT(std::get<WireError>(parsed).message,
              HasSubstr("/scene/draws/0 has \"multisampling\", but the target has one sample"));
}

// 3 x 2 pixels of two samples: a fragment for both of a pixel, and one each of another.
Rendering two_planes() {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.samples = 2;
  rendering.sample_positions = {point_of(16384, 16384), point_of(49152, 49153)};
  rendering.pixels.resize(24, 7);
  for (int i = 0; i < 48; ++i) rendering.sample_pixels.push_back(static_cast<std::uint8_t>(5 * i));
  rendering.hits = {1, 0, 0, 0, 0, 8, 0, 0, 0, 0, 0, 1};
  for (int i = 0; i < 12; ++i) rendering.depths.push_back(i / 16.0);
  for (const std::uint32_t coverage : {3U, 1U, 2U}) {
    Fragment fragment;
    fragment.x = coverage == 3 ? 0 : 2;
    fragment.coverage = coverage;
    rendering.fragments.push_back(fragment);
  }
  return rendering;
}

Scene scene_of_planes() {
  Scene scene = two_samples();
  scene.target.depth = DepthFormat::depth24;
  scene.target.sample_positions.clear();
  return scene;
}

std::variant<Answer, WireError> parse(const std::string& line,
                                      const Scene& scene = scene_of_planes()) {
  return parse_answer(line, kDigest, scene);
}

std::string message_of(const std::string& line, const Scene& scene = scene_of_planes()) {
  return fault_in(parse(line, scene));
}

Rendering read_answer(const std::string& line) {
  const auto parsed = parse(line);
  if (const auto* error = std::get_if<WireError>(&parsed)) {
    ADD_FAILURE() << error->message;
    return {};
  }
  return std::get<Rendering>(std::get<Answer>(parsed).outcome);
}

TEST(SampleAnswers, AreReadBackPlaneByPlane) {
  const Rendering told = two_planes();
  const Rendering read = read_answer(answer_line(kDigest, told, nullptr));
  EXPECT_EQ(read.samples, 2);
  EXPECT_EQ(read.sample_positions, told.sample_positions);
  EXPECT_EQ(read.pixels, told.pixels);
  EXPECT_EQ(read.sample_pixels, told.sample_pixels);
  EXPECT_EQ(read.hits, told.hits);
  EXPECT_EQ(read.depths, told.depths);
  EXPECT_THAT(read.fragments,
              ElementsAre(Field(&Fragment::coverage, 3), Field(&Fragment::coverage, 1),
                          Field(&Fragment::coverage, 2)));
}

TEST(SampleAnswers, NeedNotTellPlanesOrPositions) {
  Rendering told = two_planes();
  told.sample_positions.clear();
  told.sample_pixels.clear();
  told.hits.clear();
  const std::string line = answer_line(kDigest, told, nullptr);
  EXPECT_THAT(line, Not(HasSubstr("\"sample_")));
  const Rendering read = read_answer(line);
  EXPECT_THAT(read.sample_positions, IsEmpty());
  EXPECT_THAT(read.sample_pixels, IsEmpty());
  EXPECT_THAT(read.hits, IsEmpty());
}

TEST(SampleAnswers, HaveTheDocumentedForm) {
  Rendering rendering;
  rendering.width = rendering.height = 1;
  rendering.samples = 2;
  rendering.pixels = {1, 2, 3, 4};
  rendering.sample_positions = {point_of(0, 32768), point_of(49152, 1)};
  rendering.sample_pixels = {5, 6, 7, 8, 9, 10, 11, 12};
  rendering.hits = {1, 0};
  rendering.depths = {0.5, 1};
  const std::string samples = R"("sample_positions":[[0.0,0.5],[0.75,1.52587890625e-05]],)"
                              R"("sample_pixels":[5,6,7,8,9,10,11,12],"depths":[0.5,1])";
  EXPECT_EQ(answer_line(kDigest, rendering, nullptr),
            R"({"digest":"0123456789abcdef","pixels":[1,2,3,4],"fragments":[],)" + samples +
                R"(,"hits":[1,0]})");
  EXPECT_EQ(rendering_json("a", rendering),
            R"({"id":"a","width":1,"height":1,"samples":2,"fragments":[],"pixels":[1,2,3,4],)" +
                samples + "}");
}

TEST(SampleAnswers, PositionsAreTakenToTheNearestMultiples) {
  const std::string line = answer_line(kDigest, two_planes(), nullptr);
  const auto positions = [&](const std::string& first) {
    return read_answer(replaced(line, "[0.25,0.25]", first)).sample_positions.at(0);
  };
  EXPECT_EQ(positions("[0.1,0.3]"), point_of(6554, 19661));
  EXPECT_EQ(positions("[0,0.000007]"), point_of(0, 0));
  EXPECT_EQ(positions("[0.000008,0.99999999]"), point_of(1, 65535));
}

TEST(SampleAnswers, PositionsAreThoseThatTheSceneRequires) {
  Scene scene = scene_of_planes();
  const std::string line = answer_line(kDigest, two_planes(), nullptr);
  scene.target.sample_positions = two_planes().sample_positions;
  EXPECT_TRUE(std::holds_alternative<Answer>(parse(line, scene)));
  std::swap(scene.target.sample_positions[0], scene.target.sample_positions[1]);
  EXPECT_THAT(message_of(line, scene), HasSubstr("elsewhere than the scene requires"));
}

// What is written to a sample is decided after the shader.
TEST(SampleAnswers, HitsMayDifferFromFragments) {
  Rendering rendering = two_planes();
  EXPECT_FALSE(contradiction_of_hits(rendering).has_value());
  rendering.samples = 1;
  rendering.hits.resize(6);
  EXPECT_TRUE(contradiction_of_hits(rendering).has_value());
}

TEST(SampleAnswers, AreRefusedForTheirFaults) {
  const std::string good = answer_line(kDigest, two_planes(), nullptr);
  EXPECT_EQ(message_of(good), "");
  const auto refusal = [&](const std::string& from, const std::string& to) {
    return message_of(replaced(good, from, to));
  };
  EXPECT_THAT(refusal("[[0.25,0.25],", "["),
              HasSubstr("/sample_positions must have 2 elements, but it has 1"));
  EXPECT_THAT(refusal("[0.25,0.25]", "[0.25,1]"),
              HasSubstr("/sample_positions/0/1 is 1, but it must be 0 to below 1"));
  EXPECT_THAT(refusal("[0.25,0.25]", "[-1e-9,0.25]"), HasSubstr("must be 0 to below 1"));
  EXPECT_THAT(refusal("[0.25,0.25]", "[\"nan\",0.25]"), HasSubstr("must be a number"));
  EXPECT_THAT(refusal("\"sample_pixels\":[0,", "\"sample_pixels\":["),
              HasSubstr("/sample_pixels must have 48 elements, but it has 47"));
  EXPECT_THAT(refusal("\"sample_pixels\":[0,", "\"sample_pixels\":[256,"),
              HasSubstr("/sample_pixels/0 is 256"));
  EXPECT_THAT(refusal("\"hits\":[1,0,0,0,0,8,", "\"hits\":["),
              HasSubstr("/hits must have 12 elements, but it has 6"));
  // More often than its two primitives could write it.
  EXPECT_THAT(refusal("\"hits\":[1,0,0,0,0,8,", "\"hits\":[1,0,0,0,0,9,"),
              HasSubstr("a sample has 9 hits, more than 4 for each primitive"));
  EXPECT_THAT(refusal("\"depths\":[0,", "\"depths\":["),
              HasSubstr("/depths must have 12 elements, but it has 11"));
  EXPECT_THAT(refusal("\"coverage\":3", "\"coverage\":4"),
              HasSubstr("/fragments/0/coverage is 4, but it must be 1 to 3"));
  EXPECT_THAT(refusal("\"coverage\":3", "\"coverage\":0"), HasSubstr("must be 1 to 3"));
  EXPECT_THAT(refusal("\"coverage\":3,", ""),
              HasSubstr("/fragments/0 has no \"coverage\", and the target has several samples"));
}

TEST(SampleAnswers, OfOneSampleTellNothingOfSamples) {
  Rendering rendering = two_planes();
  rendering.fragments.clear();
  rendering.depths.clear();
  rendering.hits.clear();
  Rendering planes = rendering;
  planes.sample_positions.clear();
  EXPECT_THAT(message_of(answer_line(kDigest, planes, nullptr), small_scene()),
              HasSubstr("has \"sample_pixels\", but the target has one sample"));
  rendering.sample_pixels.clear();
  EXPECT_THAT(message_of(answer_line(kDigest, rendering, nullptr), small_scene()),
              HasSubstr("/sample_positions is there, but the target has one sample"));
}

TEST(SampleAnswers, ExcludeOtherForms) {
  for (const char* more : {R"("sample_pixels":[])", R"("sample_positions":[])"}) {
    const std::string start = R"({"digest":"0123456789abcdef",)" + std::string(more);
    EXPECT_THAT(message_of(start + R"(,"not_run":"no"})"), HasSubstr("has both \"not_run\" and"));
    EXPECT_THAT(message_of(start + R"(,"coverage":[]})"), HasSubstr("has both \"coverage\" and"));
  }
}

}  // namespace
}  // namespace edgecase
