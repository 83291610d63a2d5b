// SPDX-License-Identifier: MIT
//
// Requests and answers as bytes: the same scenes and the same renderings as by JSON, and what is no
// rendering of the scene refused as there.
#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <string>

#include "model/scene.h"
#include "tests/wire/scenes.h"
#include "wire/message.h"
#include "wire/rendering_json.h"

namespace edgecase {
namespace {

using ::testing::HasSubstr;

constexpr std::uint64_t kDigest = 0x0123456789abcdef;
constexpr const char* kLineDigest = "0123456789abcdef";
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Point point_of(std::int64_t raw_x, std::int64_t raw_y) {
  return {Fixed::from_raw(raw_x), Fixed::from_raw(raw_y)};
}

// textured_scene with everything that a scene may say and a default leaves out.
Scene full_scene() {
  Scene scene = textured_scene();
  scene.target.samples = 2;
  scene.target.sample_positions = {point_of(0, 65535), point_of(49152, 1)};
  scene.target.depth = DepthFormat::depth32f;
  scene.target.stencil = StencilFormat::stencil8;
  scene.target.surface = Surface::window;
  scene.target.clear_depth = 0.1F;
  scene.target.clear_stencil = 200;
  scene.depth_range = {1, 0.25F};
  scene.details = {true, true, true};
  scene.supersampling = {{point_of(1, 2), 3}};
  Draw& draw = scene.draws[0];
  draw.multisampling = {false, AttributeLocation::centroid, 0.3F, 2, true};
  draw.front_face = FrontFace::cw;
  draw.cull = CullMode::back;
  draw.polygon_offset = PolygonOffset{-1.5F, 0.1F, 0.25F};
  draw.operations.stencil = StencilTest{{CompareFunction::less, 1, 2, 3}, {}};
  draw.operations.depth = {CompareFunction::lequal, false};
  draw.operations.blending = Blending{{}, {BlendEquation::max}, {0.1F, 0, 1, 0.5F}};
  draw.operations.color_mask = {true, false, false, true};
  draw.texture->sampler.wrap[1] = Wrap::clamp_to_border;
  draw.texture->sampler.border = {1, 2, 3, 4};
  draw.texture->lookup = {LookupKind::gradients, 0.5F, {1, 2}, {3, 4}};
  draw.vertices[1].clip = ClipPosition{1, 2, 3, 4};
  draw.vertices[2].w = 0.5F;
  return scene;
}

TEST(RequestMessages, AreReadBack) {
  for (const Scene& scene : {small_scene(), textured_scene(), full_scene()}) {
    const OutgoingRequest sent = request_message("a/b:c", scene, true);
    const auto parsed = parse_request_message(sent.bytes);
    ASSERT_TRUE(std::holds_alternative<IncomingRequest>(parsed));
    const auto& received = std::get<IncomingRequest>(parsed);
    EXPECT_EQ(received.id, "a/b:c");
    EXPECT_EQ(received.digest, sent.digest);
    EXPECT_TRUE(received.coverage_only);
    EXPECT_TRUE(same_scene(received.scene, scene));
  }
}

TEST(RequestMessages, ThatWereCutOrChangedAreRefused) {
  const std::string good = request_message("a", textured_scene(), false).bytes;
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_TRUE(std::holds_alternative<WireError>(parse_request_message(good.substr(0, length))));
  for (std::size_t at = 0; at < good.size(); ++at) {
    std::string changed = good;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    EXPECT_TRUE(std::holds_alternative<WireError>(parse_request_message(changed))) << at;
  }
  EXPECT_TRUE(std::holds_alternative<WireError>(parse_request_message(good + '\0')));
}

// Of a 3x2 target: a fragment that tells everything, one that tells coverage alone.
Rendering two_fragments(int samples = 1) {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.samples = samples;
  for (int i = 0; i < 24; ++i) rendering.pixels.push_back(static_cast<std::uint8_t>(11 * i));
  Fragment fragment;
  fragment.x = 2;
  fragment.y = 1;
  fragment.depth = 0.1;
  fragment.color = {1, -0.0, kNaN, 1e300};
  rendering.fragments.push_back(fragment);
  fragment = {};
  fragment.primitive = 1;
  fragment.has_depth = fragment.has_color = false;
  rendering.fragments.push_back(fragment);
  if (samples == 1) rendering.hits = {1, 0, 0, 0, 0, 1};
  return rendering;
}

// The same of values that a float32 holds.
Rendering two_float_fragments() {
  Rendering rendering = two_fragments();
  rendering.fragments[0].depth = 0.125;
  rendering.fragments[0].color = {static_cast<double>(0.1f), -0.0, kNaN,
                                  static_cast<double>(3e38f)};
  return rendering;
}

Rendering multisampled() {
  Rendering rendering = two_fragments(2);
  rendering.fragments[0].coverage = 2;
  rendering.sample_positions = {point_of(0, 65535), point_of(49152, 1)};
  rendering.sample_pixels.resize(48, 7);
  rendering.hits.assign(12, 1);
  return rendering;
}

Scene multisampled_scene() {
  Scene scene = small_scene();
  scene.target.samples = 2;
  return scene;
}

// Every member that a whole answer may have, in one scene or another.
Scene detailed_scene() {
  Scene scene = textured_scene();
  scene.target.depth = DepthFormat::depth16;
  scene.target.stencil = StencilFormat::stencil8;
  scene.details = {true, true, true};
  return scene;
}

Rendering detailed() {
  Rendering rendering = two_fragments();
  rendering.depths = {0, 1, 1, 1, 1, 0.5};
  rendering.stencils = {255, 0, 1, 2, 3, 4};
  rendering.mip_chains[2] = {texture_level(2, 2, TextureFormat::srgb8),
                             texture_level(1, 1, TextureFormat::srgb8)};
  rendering.details.resize(2);  // of which the second tells nothing
  rendering.fragments[0].detail = 0;
  rendering.fragments[1].detail = 1;
  FragmentDetail& detail = rendering.details[0];
  detail.coordinates = {2.5, 1.5, 0.25, 1};
  detail.derivatives[3] = {1, 2, 3, 4};
  detail.level_of_detail = {0.5, -1};
  return rendering;
}

Scene supersampled_scene() {
  Scene scene = small_scene();
  scene.supersampling = {{point_of(32768, 32768), 1}, {point_of(1, 1), 2}};
  return scene;
}

Rendering supersampled() {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.pixels.resize(24, 9);
  rendering.accumulated.assign(24, 0.25);
  rendering.passes = {two_fragments(), two_fragments()};
  return rendering;
}

Answer answer_by_message(const Scene& scene, const Outcome& outcome, bool coverage_only,
                         const RendererInfo* claims = nullptr) {
  auto parsed = parse_answer_message(answer_message(kDigest, outcome, coverage_only, claims),
                                     kDigest, scene, coverage_only);
  if (const auto* error = std::get_if<WireError>(&parsed)) ADD_FAILURE() << error->message;
  return std::holds_alternative<Answer>(parsed) ? std::move(std::get<Answer>(parsed)) : Answer{};
}

std::string all_of(const Answer& answer) {
  return answer_line("", std::get<Rendering>(answer.outcome), nullptr);
}

TEST(AnswerMessages, AreTheRenderingsThatLinesAre) {
  const std::pair<Scene, Rendering> answers[] = {{small_scene(), two_fragments()},
                                                 {small_scene(), two_float_fragments()},
                                                 {multisampled_scene(), multisampled()},
                                                 {detailed_scene(), detailed()},
                                                 {supersampled_scene(), supersampled()}};
  for (const auto& [scene, rendering] : answers) {
    const auto line =
        parse_answer(answer_line(kLineDigest, rendering, nullptr), kLineDigest, scene);
    ASSERT_TRUE(std::holds_alternative<Answer>(line)) << std::get<WireError>(line).message;
    EXPECT_EQ(all_of(answer_by_message(scene, rendering, false)), all_of(std::get<Answer>(line)));
  }
}

TEST(AnswerMessages, AreShorterWhereValuesAreFloatsAndHitsCountFragments) {
  const Rendering narrow = two_float_fragments();
  const std::size_t length = answer_message(kDigest, narrow, false, nullptr).size();
  for (const double value : {0.1, 1e39, 1e-50}) {
    Rendering wide = narrow;
    wide.fragments[1].color[2] = value;
    EXPECT_EQ(answer_message(kDigest, wide, false, nullptr).size(), length + 2 * 20) << value;
  }
  Rendering discarding = narrow;
  discarding.hits[5] = 0;  // which is told, since it does not count the fragments
  EXPECT_EQ(answer_message(kDigest, discarding, false, nullptr).size(), length + 6 * 4 + 8);
}

TEST(AnswerMessages, OfCoverageAreTheRenderingsThatLinesAre) {
  const auto line = parse_answer(coverage_line(kLineDigest, two_fragments(), nullptr), kLineDigest,
                                 small_scene(), true);
  ASSERT_TRUE(std::holds_alternative<Answer>(line));
  EXPECT_EQ(all_of(answer_by_message(small_scene(), two_fragments(), true)),
            all_of(std::get<Answer>(line)));
}

TEST(AnswerMessages, TellWhoAnswersAndWhyNot) {
  RendererInfo claims;
  claims.vendor = "V";
  claims.version = "4.5";
  claims.device = "D";
  claims.subpixel_bits = 8;
  claims.traits = {{"context", "C"}, {"glsl", "4.50"}};
  const Failure failure{FailureKind::unsupported, "no \"such\" thing"};
  const Answer answer = answer_by_message(small_scene(), failure, false, &claims);
  ASSERT_TRUE(answer.claims);
  EXPECT_EQ(answer.claims->vendor + answer.claims->version + answer.claims->device, "V4.5D");
  EXPECT_EQ(answer.claims->subpixel_bits, 8);
  EXPECT_EQ(answer.claims->traits, claims.traits);
  EXPECT_EQ(std::get<Failure>(answer.outcome).reason, failure.reason);
  EXPECT_EQ(std::get<Failure>(answer.outcome).kind, FailureKind::unsupported);
}

TEST(AnswerMessages, HaveADigestOfRequestAndAnswerAndNotOfWhoAnswers) {
  RendererInfo claims;
  claims.vendor = "V";
  const auto digest = [](const Rendering& rendering, std::uint64_t request = kDigest,
                         const RendererInfo* who = nullptr) {
    const auto parsed = parse_answer_message(answer_message(request, rendering, false, who),
                                             request, small_scene(), false);
    return std::get<Answer>(parsed).digest;
  };
  const std::uint64_t usual = digest(two_fragments());
  EXPECT_NE(usual, 0u);
  EXPECT_EQ(digest(two_fragments()), usual);
  EXPECT_EQ(digest(two_fragments(), kDigest, &claims), usual);
  EXPECT_NE(digest(two_fragments(), kDigest + 1), usual);
  Rendering other = two_fragments();
  other.pixels.back() ^= 1;
  EXPECT_NE(digest(other), usual);
  other = two_fragments();
  other.fragments[1].color[2] += 0x1p-30;
  EXPECT_NE(digest(other), usual);
  const auto line =
      parse_answer(answer_line(kLineDigest, two_fragments(), nullptr), kLineDigest, small_scene());
  EXPECT_EQ(std::get<Answer>(line).digest, 0u) << "a line has none";
}

std::string refusal_of(const Scene& scene, const Rendering& rendering, bool coverage_only = false,
                       bool asked_for_coverage = false) {
  const auto parsed =
      parse_answer_message(answer_message(kDigest, rendering, coverage_only, nullptr), kDigest,
                           scene, asked_for_coverage);
  const auto* error = std::get_if<WireError>(&parsed);
  return error == nullptr ? "" : error->message;
}

TEST(AnswerMessages, ThatWereCutAreRefused) {
  const std::string good = answer_message(kDigest, detailed(), false, nullptr);
  for (std::size_t length = 0; length < good.size(); ++length)
    EXPECT_TRUE(std::holds_alternative<WireError>(
        parse_answer_message(good.substr(0, length), kDigest, detailed_scene(), false)))
        << length;
  EXPECT_TRUE(std::holds_alternative<WireError>(
      parse_answer_message(good + '\0', kDigest, detailed_scene(), false)));
}

// Whatever a changed byte says, there is an answer or a refusal.
TEST(AnswerMessages, ThatWereChangedAreReadOrRefused) {
  const std::pair<Scene, Rendering> answers[] = {{small_scene(), two_fragments()},
                                                 {small_scene(), two_float_fragments()},
                                                 {multisampled_scene(), multisampled()},
                                                 {detailed_scene(), detailed()},
                                                 {supersampled_scene(), supersampled()}};
  std::size_t refused = 0;
  for (const auto& [scene, rendering] : answers) {
    const std::string good = answer_message(kDigest, rendering, false, nullptr);
    for (std::size_t at = 0; at < good.size(); ++at)
      for (const int mask : {1, 2, 128, 255}) {
        std::string changed = good;
        changed[at] = static_cast<char>(changed[at] ^ mask);
        const auto parsed = parse_answer_message(changed, kDigest, scene, false);
        refused += std::holds_alternative<WireError>(parsed) ? 1U : 0U;
      }
  }
  EXPECT_GT(refused, 0U);
}

TEST(AnswerMessages, ToAnotherSceneAreRefused) {
  const auto parsed = parse_answer_message(answer_message(kDigest, two_fragments(), false, nullptr),
                                           kDigest + 1, small_scene(), false);
  ASSERT_TRUE(std::holds_alternative<WireError>(parsed));
  EXPECT_THAT(std::get<WireError>(parsed).message, HasSubstr("another scene"));
}

struct Change {
  const char* what;
  std::function<void(Rendering&)> make;
};

TEST(AnswerMessages, ThatAreNoRenderingOfTheSceneAreRefused) {
  const Change changes[] = {
      {"pixels", [](Rendering& r) { r.pixels.pop_back(); }},
      {"depths", [](Rendering& r) { r.depths.pop_back(); }},
      {"depths", [](Rendering& r) { r.depths.clear(); }},
      {"depth16", [](Rendering& r) { r.depths[1] = 1.5; }},
      {"depth16", [](Rendering& r) { r.depths[1] = kNaN; }},
      {"stencils", [](Rendering& r) { r.stencils.push_back(0); }},
      {"hits", [](Rendering& r) { r.hits.push_back(0); }},
      {"more hits", [](Rendering& r) { r.hits[1] = 1; }},
      {"samples", [](Rendering& r) { r.sample_pixels.resize(24); }},
      {"positions", [](Rendering& r) { r.sample_positions = {point_of(0, 0)}; }},
      {"accumulated", [](Rendering& r) { r.accumulated.resize(24); }},
      {"passes", [](Rendering& r) { r.passes = {two_fragments()}; }},
      {"outside", [](Rendering& r) { r.fragments[0].x = 3; }},
      {"outside", [](Rendering& r) { r.fragments[0].y = -1; }},
      {"primitive 2", [](Rendering& r) { r.fragments[0].primitive = 2; }},
      {"primitive -1", [](Rendering& r) { r.fragments[0].primitive = -1; }},
      {"coverage 0", [](Rendering& r) { r.fragments[0].coverage = 0; }},
      {"coverage 2", [](Rendering& r) { r.fragments[0].coverage = 2; }},
      {"detail",
       [](Rendering& r) { r.details[1].texture_coordinates.emplace(); }},  // not a textured draw
      {"no texture", [](Rendering& r) { r.mip_chains[1] = r.mip_chains[2]; }},
      {"no texture", [](Rendering& r) { r.mip_chains[7] = r.mip_chains[2]; }},
      {"no level", [](Rendering& r) { r.mip_chains[2].clear(); }},
      {"a level", [](Rendering& r) { r.mip_chains[2][0].width = 0; }},
      {"a level", [](Rendering& r) { r.mip_chains[2][0].texels.pop_back(); }},
  };
  Scene scene = detailed_scene();
  scene.draws[0].operations.depth = {CompareFunction::less, true};
  EXPECT_EQ(refusal_of(scene, detailed()), "");
  for (const Change& change : changes) {
    Rendering rendering = detailed();
    change.make(rendering);
    EXPECT_THAT(refusal_of(scene, rendering), HasSubstr(change.what));
  }
}

TEST(AnswerMessages, WhoseHitsContradictFragmentsAreRefused) {
  Rendering rendering = two_fragments();
  rendering.hits[0] = 0;
  EXPECT_THAT(refusal_of(small_scene(), rendering), HasSubstr("contradict"));
  EXPECT_THAT(refusal_of(small_scene(), rendering, true, true), HasSubstr("contradict"));
}

TEST(AnswerMessages, OfCoverageThatNobodyAskedForAreRefused) {
  EXPECT_THAT(refusal_of(small_scene(), two_fragments(), true, false), HasSubstr("not asked for"));
  EXPECT_EQ(refusal_of(small_scene(), two_fragments(), false, true), "");
  Rendering outside = two_fragments();
  outside.fragments[0].x = 3;
  outside.hits.clear();
  EXPECT_THAT(refusal_of(small_scene(), outside, true, true), HasSubstr("0 to 2"));
}

TEST(AnswerMessages, OfSamplesAreCheckedSampleBySample) {
  EXPECT_EQ(refusal_of(multisampled_scene(), multisampled()), "");
  Rendering rendering = multisampled();
  rendering.fragments[0].coverage = 4;
  EXPECT_THAT(refusal_of(multisampled_scene(), rendering), HasSubstr("coverage 4"));
  rendering = multisampled();
  rendering.sample_positions[0].x = Fixed::from_raw(Fixed::kOne);
  EXPECT_THAT(refusal_of(multisampled_scene(), rendering), HasSubstr("outside its pixel"));
  rendering = multisampled();
  rendering.sample_pixels.pop_back();
  EXPECT_THAT(refusal_of(multisampled_scene(), rendering), HasSubstr("pixels of samples"));
}

TEST(AnswerMessages, OfPassesAreCheckedPassByPass) {
  EXPECT_EQ(refusal_of(supersampled_scene(), supersampled()), "");
  Rendering rendering = supersampled();
  rendering.passes.pop_back();
  EXPECT_THAT(refusal_of(supersampled_scene(), rendering), HasSubstr("passes"));
  rendering.passes.resize(3, two_fragments());
  EXPECT_THAT(refusal_of(supersampled_scene(), rendering), HasSubstr("more passes"));
  rendering = supersampled();
  rendering.passes[1].fragments[0].x = 3;
  EXPECT_THAT(refusal_of(supersampled_scene(), rendering), HasSubstr("outside"));
  rendering = supersampled();
  rendering.passes[1].passes = {two_fragments()};
  EXPECT_THAT(refusal_of(supersampled_scene(), rendering), HasSubstr("a pass has passes"));
  rendering = supersampled();
  rendering.hits = two_fragments().hits;
  EXPECT_THAT(refusal_of(supersampled_scene(), rendering), HasSubstr("beside the passes"));
}

}  // namespace
}  // namespace edgecase
