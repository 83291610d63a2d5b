// SPDX-License-Identifier: MIT
//
// Coordinates, derivatives and depth buffers on their way in an answer.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "tests/wire/scenes.h"
#include "wire/answer_line.h"
#include "wire/rendering_json.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kDigest = "0123456789abcdef";
constexpr double kInf = std::numeric_limits<double>::infinity();

// small_scene with a depth buffer, and everything asked for.
Scene asking_scene() {
  Scene scene = small_scene();
  scene.target.depth = DepthFormat::depth16;
  scene.details = {true, true};
  return scene;
}

// Three fragments: all details, coordinates alone, none; stored in another order than sorted.
Rendering detailed_rendering() {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.pixels.resize(24);
  rendering.depths = {0, 1, 1 / 65535.0, static_cast<double>(0.1f), 0.5, 1};
  rendering.details.resize(2);
  FragmentDetail& all = rendering.details[1];
  all.coordinates = {2.5, 1.5, static_cast<double>(0.3f), kInf};
  for (std::size_t i = 0; i < kDerivatives; ++i) {
    const double at = static_cast<double>(i);
    all.derivatives[i] = {at, -at / 3, i == 4 ? -kInf : 1e-30, 0};
  }
  rendering.details[0].coordinates = {0.5, 0.5, 0, 1};
  Fragment fragment;
  fragment.x = 2;
  fragment.y = 1;
  fragment.detail = 1;
  rendering.fragments.push_back(fragment);
  fragment.x = fragment.y = 0;
  fragment.detail = 0;
  rendering.fragments.push_back(fragment);
  fragment.x = 1;
  fragment.detail = -1;
  rendering.fragments.push_back(fragment);
  return rendering;
}

std::variant<Answer, WireError> parse(const std::string& line, const Scene& scene) {
  return parse_answer(line, kDigest, scene);
}

std::string message_of(const std::string& line, const Scene& scene = asking_scene()) {
  return fault_in(parse(line, scene));
}

TEST(AnswerDetails, AreReadBack) {
  const Rendering rendering = detailed_rendering();
  const auto parsed = parse(answer_line(kDigest, rendering, nullptr), asking_scene());
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Rendering& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_EQ(read.depths, rendering.depths);
  ASSERT_EQ(read.fragments.size(), 3u);
  ASSERT_EQ(read.details.size(), 2u);
  const auto detail_of = [&](std::size_t fragment) {
    return read.details.at(static_cast<std::size_t>(read.fragments[fragment].detail));
  };
  EXPECT_EQ(read.fragments[0].x, 0);
  EXPECT_EQ(detail_of(0).coordinates, rendering.details[0].coordinates);
  EXPECT_EQ(detail_of(0).derivatives, rendering.details[0].derivatives);
  EXPECT_EQ(read.fragments[1].x, 1);
  EXPECT_EQ(read.fragments[1].detail, -1);
  EXPECT_EQ(read.fragments[2].x, 2);
  EXPECT_EQ(detail_of(2).coordinates, rendering.details[1].coordinates);
  EXPECT_EQ(detail_of(2).derivatives, rendering.details[1].derivatives);
}

TEST(AnswerDetails, EachDerivativeMayBeMissing) {
  const std::string line = answer_line(kDigest, detailed_rendering(), nullptr);
  for (std::size_t missing = 0; missing < kDerivatives; ++missing) {
    Rendering rendering = detailed_rendering();
    rendering.details[1].derivatives[missing].reset();
    const std::string text = answer_line(kDigest, rendering, nullptr);
    const std::string key = fmt::format("\"{}\":", kNames<Derivative>[missing].name);
    EXPECT_THAT(line, HasSubstr(key));
    EXPECT_THAT(text, Not(HasSubstr(key)));
    const auto parsed = parse(text, asking_scene());
    ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
    const Rendering& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
    EXPECT_EQ(read.details[0].derivatives, rendering.details[1].derivatives);
  }
}

TEST(AnswerDetails, HaveTheDocumentedForm) {
  Rendering rendering = detailed_rendering();
  rendering.fragments.resize(1);
  for (const std::size_t missing : {1U, 2U, 4U, 5U})
    rendering.details[1].derivatives[missing].reset();
  EXPECT_EQ(fragments_json(rendering),
            R"([{"x":2,"y":1,"primitive":0,"coverage":1,"depth":0,"color":[0,0,0,0],)"
            R"("coordinates":[2.5,1.5,0.30000001192092896,"inf"],)"
            R"("derivatives":{"dFdx":[0,-0,1e-30,0],"dFdyFine":[3,-1,1e-30,0]}}])");
  EXPECT_THAT(rendering_json("a", rendering),
              HasSubstr(R"(,"depths":[0,1,1.5259021896696422e-05,0.10000000149011612,0.5,1]})"));
}

TEST(AnswerDetails, SayWhatIsWrongAndWhere) {
  const auto answer_with = [](const std::string& more, const std::string& depths) {
    return R"({"digest":"0123456789abcdef","pixels":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,)"
           R"(0,0],"fragments":[{"x":0,"y":0,"primitive":0)" +
           more + "}]" + depths + "}";
  };
  const std::string depths = R"(,"depths":[0,1,1,1,1,1])";
  const auto fragment = [&](const std::string& more) {
    return message_of(answer_with(more, depths));
  };
  EXPECT_EQ(fragment(""), "");
  EXPECT_EQ(fragment(R"(,"derivatives":{})"), "");
  EXPECT_EQ(fragment(R"(,"derivatives":{"dFdx":["nan","inf","-inf",0]})"), "");
  EXPECT_THAT(fragment(R"(,"coordinates":[1,2,3])"),
              HasSubstr("/fragments/0/coordinates must have 4 elements"));
  EXPECT_THAT(fragment(R"(,"coordinates":[1,2,3,"far"])"),
              HasSubstr("/fragments/0/coordinates/3 must be a number"));
  EXPECT_THAT(fragment(R"(,"derivatives":[])"),
              HasSubstr("/fragments/0/derivatives must be an object"));
  EXPECT_THAT(fragment(R"(,"derivatives":{"dFdz":[0,0,0,0]})"),
              HasSubstr("unknown key \"dFdz\"; known are dFdx, dFdy, dFdxFine"));
  EXPECT_THAT(fragment(R"(,"derivatives":{"dFdyCoarse":[0,0,null,0]})"),
              HasSubstr("/fragments/0/derivatives/dFdyCoarse/2 must be a number"));
  EXPECT_THAT(message_of(answer_with("", "")), HasSubstr("the line has no \"depths\""));
  EXPECT_THAT(message_of(answer_with("", R"(,"depths":[0])")),
              HasSubstr("/depths must have 6 elements, but it has 1"));
  EXPECT_THAT(message_of(answer_with("", R"(,"depths":[0,0,1.5,0,0,0])")),
              HasSubstr("/depths/2 is 1.5, but it must be 0 to 1"));
  EXPECT_THAT(message_of(answer_with("", R"(,"depths":[0,0,0,0,-1,0])")),
              HasSubstr("/depths/4 is -1"));
  EXPECT_THAT(message_of(answer_with("", R"(,"depths":[0,0,0,0,0,"nan"])")),
              HasSubstr("/depths/5 must be a number"));
  const std::string head = R"({"digest":"0123456789abcdef",)";
  EXPECT_THAT(message_of(head + R"("not_run":"why","depths":[]})"),
              HasSubstr("both \"not_run\" and \"depths\""));
}

// What rounding takes beyond 0 or 1 is the judge's business where the format can hold it.
TEST(AnswerDetails, FloatDepthsMayLieBeyondTheRange) {
  Rendering rendering = detailed_rendering();
  rendering.depths[1] = -0x1p-28;
  rendering.depths[2] = 1 + 0x1p-23;
  const std::string line = answer_line(kDigest, rendering, nullptr);
  Scene scene = asking_scene();
  scene.target.depth = DepthFormat::depth32f;
  EXPECT_EQ(message_of(line, scene), "");
  scene.target.depth = DepthFormat::depth16;
  EXPECT_THAT(message_of(line, scene), HasSubstr("/depths/1 is -3.725290298461914e-09"));
}

TEST(AnswerDetails, AreRefusedWhereTheyWereNotAskedFor) {
  const std::string line = answer_line(kDigest, detailed_rendering(), nullptr);
  Scene scene = asking_scene();
  scene.details.coordinates = false;
  EXPECT_THAT(message_of(line, scene),
              HasSubstr("/fragments/0 has \"coordinates\", which the request does not ask for"));
  scene.details = {true, false};
  EXPECT_THAT(message_of(line, scene),
              HasSubstr("/fragments/0 has \"derivatives\", which the request does not ask for"));
  scene = asking_scene();
  scene.target.depth = DepthFormat::none;
  EXPECT_THAT(message_of(line, scene),
              HasSubstr("the line has \"depths\", but the target has no depth buffer"));
}

TEST(AnswerDetails, CoverageAloneTellsNone) {
  const Rendering rendering = detailed_rendering();
  const std::string line = coverage_line(kDigest, rendering, nullptr);
  const auto parsed = parse_answer(line, kDigest, asking_scene(), true);
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Rendering& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_TRUE(read.depths.empty());
  EXPECT_TRUE(read.details.empty());
  for (const Fragment& fragment : read.fragments) EXPECT_EQ(fragment.detail, -1);
  const auto both = parse_answer(line.substr(0, line.size() - 1) + ",\"depths\":[]}", kDigest,
                                 asking_scene(), true);
  ASSERT_TRUE(std::holds_alternative<WireError>(both));
  EXPECT_THAT(std::get<WireError>(both).message, HasSubstr("both \"coverage\" and \"depths\""));
}

}  // namespace
}  // namespace edgecase
