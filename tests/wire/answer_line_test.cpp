// SPDX-License-Identifier: MIT
#include "wire/answer_line.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/wire/scenes.h"
#include "wire/message.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* kDigest = "0123456789abcdef";

Rendering small_rendering() {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.pixels.resize(24);
  for (std::size_t i = 0; i < 24; ++i) rendering.pixels[i] = static_cast<std::uint8_t>(i * 11);
  rendering.hits = {0, 2, 0, 0, 0, 1};
  Fragment fragment;
  fragment.x = 1;
  fragment.depth = static_cast<double>(0.3f);
  fragment.color = {static_cast<double>(0.1f), 1, std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
  rendering.fragments.push_back(fragment);
  fragment.primitive = 1;
  fragment.has_depth = false;
  fragment.depth = 0;
  fragment.has_color = false;
  fragment.color = {};
  rendering.fragments.push_back(fragment);
  fragment.x = 2;
  fragment.y = 1;
  fragment.has_color = true;
  rendering.fragments.push_back(fragment);
  return rendering;
}

std::variant<Answer, WireError> parse(const std::string& line) {
  return parse_answer(line, kDigest, small_scene());
}

std::string message_of(const std::string& line) {
  return fault_in(parse(line));
}

// An answer of a 3x2 target with these fragments and further members.
std::string answer_with(const std::string& fragments, const std::string& more = "") {
  return R"({"digest":"0123456789abcdef","pixels":[0,0,0,0,0,0,0,0,0,0,0,0,)"
         R"(0,0,0,0,0,0,0,0,0,0,0,0],"fragments":)" +
         fragments + more + "}";
}

TEST(AnswerLine, ReadsBackEveryFieldOfARendering) {
  const Rendering rendering = small_rendering();
  RendererInfo claims;
  claims.vendor = "a \"vendor\"";
  claims.version = "1";
  claims.device = "d\xc3\xa9vice";
  claims.subpixel_bits = 8;
  claims.traits = {{"capture", "ssbo"}};
  const auto parsed = parse(answer_line(kDigest, rendering, &claims));
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Answer& answer = std::get<Answer>(parsed);
  ASSERT_TRUE(answer.claims.has_value());
  EXPECT_EQ(answer.claims->vendor, claims.vendor);
  EXPECT_EQ(answer.claims->device, claims.device);
  EXPECT_EQ(answer.claims->subpixel_bits, 8);
  EXPECT_EQ(answer.claims->traits, claims.traits);
  const Rendering& read = std::get<Rendering>(answer.outcome);
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_EQ(read.pixels, rendering.pixels);
  EXPECT_EQ(read.hits, rendering.hits);
  ASSERT_EQ(read.fragments.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.fragments[i].x, rendering.fragments[i].x);
    EXPECT_EQ(read.fragments[i].y, rendering.fragments[i].y);
    EXPECT_EQ(read.fragments[i].primitive, rendering.fragments[i].primitive);
    EXPECT_EQ(read.fragments[i].coverage, 1u);
    EXPECT_EQ(read.fragments[i].has_color, rendering.fragments[i].has_color);
    EXPECT_EQ(read.fragments[i].color, rendering.fragments[i].color);
  }
  EXPECT_EQ(read.fragments[0].depth, rendering.fragments[0].depth);
  EXPECT_TRUE(read.fragments[0].has_depth);
  EXPECT_FALSE(read.fragments[1].has_depth);
}

TEST(AnswerLine, FillsInWhatIsOptionalAndSorts) {
  const auto parsed =
      parse(answer_with(R"([{"x":2,"y":1,"primitive":1,"depth":"nan","color":["nan",0,0,1]},)"
                        R"({"x":0,"y":0,"primitive":0,"coverage":1}])"));
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Answer& answer = std::get<Answer>(parsed);
  EXPECT_FALSE(answer.claims.has_value());
  const Rendering& rendering = std::get<Rendering>(answer.outcome);
  EXPECT_THAT(rendering.hits, IsEmpty());
  ASSERT_EQ(rendering.fragments.size(), 2u);
  EXPECT_EQ(rendering.fragments[0].x, 0);
  EXPECT_FALSE(rendering.fragments[0].has_color);
  EXPECT_FALSE(rendering.fragments[0].has_depth);
  EXPECT_TRUE(std::isnan(rendering.fragments[1].depth));
  EXPECT_TRUE(std::isnan(rendering.fragments[1].color[0]));
}

TEST(AnswerLine, CarriesARefusalAsUnsupported) {
  const auto parsed = parse(refusal_line(kDigest, "no such thing", nullptr));
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed));
  const Failure& failure = std::get<Failure>(std::get<Answer>(parsed).outcome);
  EXPECT_EQ(failure.kind, FailureKind::unsupported);
  EXPECT_EQ(failure.reason, "no such thing");
}

TEST(AnswerLine, RefusesAnAnswerToAnotherScene) {
  Scene other = small_scene();
  other.draws[1].vertices[0].position.x = Fixed::from_raw(1);
  const std::string theirs = digest_of(scene_json(other));
  const std::string ours = digest_of(scene_json(small_scene()));
  const auto parsed =
      parse_answer(answer_line(theirs, small_rendering(), nullptr), ours, small_scene());
  ASSERT_TRUE(std::holds_alternative<WireError>(parsed));
  EXPECT_THAT(std::get<WireError>(parsed).message,
              HasSubstr("an answer to another scene than \"" + ours + "\""));
}

struct BadAnswer {
  std::string line;
  std::string message;  // a part of it
};

std::vector<BadAnswer> bad_answers() {
  const std::string head = R"({"digest":"0123456789abcdef",)";
  const std::string pixels = R"("pixels":[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0])";
  const std::string where = R"("x":0,"y":0,"primitive":0)";
  return {
      {"", "no line of JSON"},
      {"hello", "no line of JSON"},
      {answer_with("[]") + "]", "no line of JSON"},
      {answer_with("[]").substr(0, 60), "no line of JSON"},
      {answer_with("[") + "]}", "no line of JSON"},
      {"[1]", "the line must be an object, but it is array"},
      {"null", "the line must be an object, but it is null"},
      {"{}", "the line has no \"digest\""},
      {R"({"digest":7})", "/digest must be a string, but it is 7"},
      {R"({"digest":"0123"})", "/digest is \"0123\", an answer to another scene"},
      {R"({"digest":"0123456789abcdef"})", "the line has no \"pixels\""},
      {head + pixels + "}", "the line has no \"fragments\""},
      {head + R"("pixels":[],"fragments":[]})", "/pixels must have 24 elements, but it has 0"},
      {head + R"("pixels":7,"fragments":[]})", "/pixels must be an array, but it is 7"},
      {answer_with("[]").replace(answer_with("[]").find("[0,"), 3, "[256,"),
       "/pixels/0 is 256, but it must be 0 to 255"},
      {answer_with("[]").replace(answer_with("[]").find("[0,"), 3, "[-1,"),
       "/pixels/0 is -1, but it must be 0 to 255"},
      {answer_with("[]").replace(answer_with("[]").find("[0,"), 3, "[0.0,"),
       "/pixels/0 must be an integer, but it is 0.0"},
      {answer_with("[]").replace(answer_with("[]").find("[0,"), 3, "[1e999,"), "no line of JSON"},
      {answer_with("{}"), "/fragments must be an array, but it is object"},
      {answer_with("[3]"), "/fragments/0 must be an object, but it is 3"},
      {answer_with(R"([{"y":0,"primitive":0}])"), "/fragments/0 has no \"x\""},
      {answer_with(R"([{"x":3,"y":0,"primitive":0}])"),
       "/fragments/0/x is 3, but it must be 0 to 2"},
      {answer_with(R"([{"x":0,"y":-1,"primitive":0}])"), "/fragments/0/y is -1"},
      {answer_with(R"([{"x":0.5,"y":0,"primitive":0}])"), "/fragments/0/x must be an integer"},
      {answer_with(R"([{"x":18446744073709551615,"y":0,"primitive":0}])"),
       "/fragments/0/x is 18446744073709551615"},
      {answer_with(R"([{"x":0,"y":0,"primitive":2}])"),
       "/fragments/0/primitive is 2, but it must be 0 to 1"},
      {answer_with("[{" + where + R"(,"coverage":2}])"), "/fragments/0/coverage is 2"},
      {answer_with("[{" + where + R"(,"coverage":0}])"), "/fragments/0/coverage is 0"},
      {answer_with("[{" + where + R"(,"depth":"deep"}])"), "/fragments/0/depth must be a number"},
      {answer_with("[{" + where + R"(,"depth":null}])"), "/fragments/0/depth must be a number"},
      {answer_with("[{" + where + R"(,"color":[1,2,3]}])"),
       "/fragments/0/color must have 4 elements, but it has 3"},
      {answer_with("[{" + where + R"(,"color":[1,2,3,true]}])"),
       "/fragments/0/color/3 must be a number"},
      {answer_with("[{" + where + R"(,"colour":[1,2,3,4]}])"),
       "/fragments/0 has the unknown key \"colour\"; known are x, y, primitive"},
      {answer_with("[]", R"(,"hits":[0]})"), "no line of JSON"},
      {answer_with("[]", R"(,"hits":[0])"), "/hits must have 6 elements, but it has 1"},
      {answer_with("[]", R"(,"hits":[0,0,0,0,-1,0])"), "/hits/4 is -1"},
      {answer_with("[]", R"(,"hits":[0,0,0,0,1,0])"), "pixel (1, 1): 1 against 0"},
      {answer_with("[{" + where + "},{" + where + "}]", R"(,"hits":[1,0,0,0,0,0])"),
       "pixel (0, 0): 1 against 2"},
      {answer_with("[]", R"(,"hit":[])"), "the line has the unknown key \"hit\""},
      {answer_with("[]", R"(,"renderer":"me")"), "/renderer must be an object"},
      {answer_with("[]", R"(,"renderer":{"vendor":1})"), "/renderer/vendor must be a string"},
      {answer_with("[]", R"(,"renderer":{"subpixel_bits":99})"), "/renderer/subpixel_bits is 99"},
      {answer_with("[]", R"(,"renderer":{"traits":{"a":1}})"),
       "/renderer/traits/a must be a string"},
      {answer_with("[]", R"(,"not_run":"why")"), "both \"not_run\" and \"pixels\""},
      {head + R"("not_run":true})", "/not_run must be a string, but it is true"},
      {head + "\"not_run\":\"\xff\"}", "no line of JSON"},
  };
}

std::variant<Answer, WireError> parse_coverage(const std::string& line) {
  return parse_answer(line, kDigest, small_scene(), true);
}

// x, y, primitive of every fragment.
std::vector<std::array<int, 3>> places_of(const Rendering& rendering) {
  std::vector<std::array<int, 3>> places;
  for (const Fragment& fragment : rendering.fragments)
    places.push_back({fragment.x, fragment.y, fragment.primitive});
  return places;
}

TEST(CoverageAlone, ReadsBackEveryFragmentWithoutValues) {
  Rendering rendering = small_rendering();
  // Two primitives in one row, a gap, a pixel drawn twice, and runs that end where others begin.
  rendering.hits.clear();
  rendering.fragments.clear();
  for (const auto& [x, y, primitive] : std::vector<std::array<int, 3>>{
           {0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 1}, {2, 0, 0}, {2, 0, 1}, {0, 1, 1}}) {
    Fragment fragment;
    fragment.x = x;
    fragment.y = y;
    fragment.primitive = primitive;
    rendering.fragments.push_back(fragment);
  }
  const std::string line = coverage_line(kDigest, rendering, nullptr);
  EXPECT_THAT(line, HasSubstr(R"("coverage":[0,0,0,0,0,0,2,2,1,0,0,1,1,0,1,2,1,1,0,0]})"));
  const auto parsed = parse_coverage(line);
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Rendering& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_EQ(read.width, 3);
  EXPECT_EQ(read.height, 2);
  EXPECT_THAT(read.pixels, IsEmpty());
  EXPECT_THAT(read.hits, IsEmpty());
  EXPECT_EQ(places_of(read), places_of(rendering));
  for (const Fragment& fragment : read.fragments) {
    EXPECT_FALSE(fragment.has_depth);
    EXPECT_FALSE(fragment.has_color);
    EXPECT_EQ(fragment.coverage, 1u);
  }
}

TEST(CoverageAlone, TakesRunsInAnyOrderAndChecksHits) {
  const std::string head = R"({"digest":"0123456789abcdef","coverage":[1,1,0,2,0,0,1,1,1,1,2,2])";
  const auto parsed = parse_coverage(head + R"(,"hits":[0,1,0,1,1,2]})");
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Rendering& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_EQ(places_of(read), (std::vector<std::array<int, 3>>{
                                 {1, 0, 0}, {0, 1, 1}, {1, 1, 1}, {2, 1, 1}, {2, 1, 1}}));
  EXPECT_EQ(read.hits, (std::vector<std::uint32_t>{0, 1, 0, 1, 1, 2}));
  EXPECT_TRUE(std::holds_alternative<Answer>(
      parse_coverage(R"({"digest":"0123456789abcdef","coverage":[]})")));
}

TEST(CoverageAlone, TellsHitsOnlyWhereTheyContradict) {
  Rendering rendering = small_rendering();
  EXPECT_THAT(coverage_line(kDigest, rendering, nullptr), Not(HasSubstr("hits")));
  rendering.hits[1] = 3;
  const auto parsed = parse_coverage(coverage_line(kDigest, rendering, nullptr));
  ASSERT_TRUE(std::holds_alternative<WireError>(parsed));
  EXPECT_THAT(std::get<WireError>(parsed).message, HasSubstr("pixel (1, 0): 3 against 2"));
}

TEST(CoverageAlone, AWholeAnswerIsAnAnswerToo) {
  const auto parsed = parse_coverage(answer_line(kDigest, small_rendering(), nullptr));
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const Rendering& read = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_EQ(read.pixels, small_rendering().pixels);
  EXPECT_TRUE(read.fragments[0].has_color);
}

TEST(CoverageAlone, IsRefusedWhereItWasNotAskedFor) {
  EXPECT_THAT(message_of(R"({"digest":"0123456789abcdef","coverage":[]})"),
              HasSubstr("the request asked for a whole answer"));
}

TEST(CoverageAlone, SaysWhatIsWrongAndWhere) {
  const std::string head = R"({"digest":"0123456789abcdef","coverage":)";
  const std::vector<BadAnswer> bad_answers = {
      {head + "7}", "/coverage must be an array, but it is 7"},
      {head + "[0,0,0]}", "/coverage must have four numbers for each run, but it has 3 elements"},
      {head + "[2,0,0,0]}", "/coverage/0 is 2, but it must be 0 to 1"},
      {head + "[-1,0,0,0]}", "/coverage/0 is -1, but it must be 0 to 1"},
      {head + "[0,2,0,0]}", "/coverage/1 is 2, but it must be 0 to 1"},
      {head + "[0,0,3,3]}", "/coverage/2 is 3, but it must be 0 to 2"},
      {head + "[0,0,0,0,0,0,0,3]}", "/coverage/7 is 3, but it must be 0 to 2"},
      {head + "[0,0,2,1]}", "/coverage/3 is 1, but it must be 2"},
      {head + "[0,0,0,1.0]}", "/coverage/3 must be an integer, but it is 1.0"},
      {head + R"([0,0,0,"1"]})", "/coverage/3 must be an integer"},
      {head + R"([],"pixels":[]})", "both \"coverage\" and \"pixels\""},
      {head + R"([],"fragments":[]})", "both \"coverage\" and \"fragments\""},
      {head + R"([],"not_run":"why"})", "both \"not_run\" and \"coverage\""},
      {head + R"([0,0,0,0],"hits":[0,0,0,0,0,0]})", "pixel (0, 0): 0 against 1"},
  };
  for (const BadAnswer& bad : bad_answers) {
    const auto parsed = parse_coverage(bad.line);
    ASSERT_TRUE(std::holds_alternative<WireError>(parsed)) << bad.line;
    EXPECT_THAT(std::get<WireError>(parsed).message, HasSubstr(bad.message)) << bad.line;
  }
}

TEST(CoverageAlone, CannotTellSamples) {
  Scene scene = small_scene();
  scene.target.samples = 4;
  const auto parsed =
      parse_answer(R"({"digest":"0123456789abcdef","coverage":[]})", kDigest, scene, true);
  ASSERT_TRUE(std::holds_alternative<WireError>(parsed));
  EXPECT_THAT(std::get<WireError>(parsed).message, HasSubstr("which samples are covered"));
}

// A line of 60 kB that stands for more fragments than there may be.
TEST(CoverageAlone, AShortLineCannotAskForAllMemory) {
  Scene scene = small_scene();
  scene.target.width = 4096;
  std::string runs = "[0,0,0,4095";
  for (int i = 1; i < 4096; ++i) runs += ",0,0,0,4095";
  const std::string head = R"({"digest":"0123456789abcdef","coverage":)";
  const auto parsed = parse_answer(head + runs + ",0,0,0,0]}", kDigest, scene, true);
  ASSERT_TRUE(std::holds_alternative<WireError>(parsed));
  EXPECT_THAT(std::get<WireError>(parsed).message, HasSubstr("more than 16777216 fragments"));
}

TEST(AnswerLine, SaysWhatIsWrongAndWhere) {
  const auto answers = bad_answers();
  EXPECT_GE(answers.size(), 40u);
  for (const BadAnswer& bad : answers)
    EXPECT_THAT(message_of(bad.line), HasSubstr(bad.message)) << bad.line;
}

TEST(AnswerLine, RefusesFragmentsOfASceneThatDrawsNothing) {
  Scene scene = small_scene();
  scene.draws.clear();
  const auto parsed = parse_answer(answer_with(R"([{"x":0,"y":0,"primitive":0}])"), kDigest, scene);
  ASSERT_TRUE(std::holds_alternative<WireError>(parsed));
  EXPECT_THAT(std::get<WireError>(parsed).message, HasSubstr("the scene draws nothing"));
}

TEST(AnswerLine, RefusesMoreFragmentsThanAFaultMakes) {
  // Of two primitives and six pixels, four times.
  for (const auto& [count, message] :
       {std::pair(48, ""),
        std::pair(49, "/fragments has 49 elements, more than 4 for each of 2")}) {
    std::string fragments;
    for (int i = 0; i < count; ++i)
      fragments += (i > 0 ? "," : "") + std::string(R"({"x":2,"y":1,"primitive":0})");
    EXPECT_THAT(message_of(answer_with("[" + fragments + "]")), HasSubstr(message));
    EXPECT_EQ(message_of(answer_with("[" + fragments + "]")).empty(), count == 48);
  }
}

TEST(AnswerLine, ClaimsAreCheckedAsBytesToo) {
  for (const int bits : {-1, 0, 32, 33}) {
    RendererInfo claims;
    claims.subpixel_bits = bits;
    const auto parsed = parse_answer_message(answer_message(1, small_rendering(), false, &claims),
                                             1, small_scene(), false);
    EXPECT_EQ(std::holds_alternative<Answer>(parsed), bits == 0 || bits == 32) << bits;
  }
}

TEST(AnswerLine, MessagesStayShort) {
  const std::string line = "{\"" + std::string(100'000, 'k') + "\":1}";
  EXPECT_LT(message_of(line).size(), 300u);
  EXPECT_LT(message_of(std::string(100'000, 'x')).size(), 300u);
  EXPECT_LT(message_of("\"" + std::string(100'000, '\\')).size(), 300u);
}

TEST(AnswerLine, SurvivesDeepNesting) {
  EXPECT_NE(message_of(std::string(1'000'000, '[')), "");
  EXPECT_NE(message_of(std::string(1'000'000, '[') + std::string(1'000'000, ']')), "");
}

}  // namespace
}  // namespace edgecase
