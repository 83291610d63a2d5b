// SPDX-License-Identifier: MIT
//
// Fragment operations on their way: facing, tests and blending in a request, the stencil buffer in
// an answer, and hits that are fewer than fragments.
#include <gmock/gmock.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "model/scene.h"
#include "tests/wire/scenes.h"
#include "wire/answer_line.h"
#include "wire/rendering_json.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kDigest = "0123456789abcdef";

// small_scene with everything of the kind: the triangle has all of it, the line the depth test off.
Scene operations_scene() {
  Scene scene = small_scene();
  scene.target.depth = DepthFormat::depth24;
  scene.target.stencil = StencilFormat::stencil8;
  scene.target.clear_depth = 0.1F;
  scene.target.clear_stencil = 200;
  scene.depth_range = {1, 0.25F};
  Draw& draw = scene.draws[0];
  draw.front_face = FrontFace::cw;
  draw.cull = CullMode::back;
  draw.polygon_offset = PolygonOffset{-1.5F, 0.1F, 0.25F};
  const StencilFace front{
      CompareFunction::notequal, 255, 15, 240, StencilOperation::zero, StencilOperation::incr_wrap,
      StencilOperation::replace};
  StencilFace back;
  back.pass = StencilOperation::invert;
  draw.operations.stencil = StencilTest{front, back};
  draw.operations.depth = {CompareFunction::lequal, false};
  draw.operations.blending = Blending{
      {BlendEquation::reverse_subtract, BlendFactor::constant_color, BlendFactor::dst_alpha},
      {BlendEquation::max, BlendFactor::one, BlendFactor::zero},
      {0.1F, 0, 1, 0.5F}};
  draw.operations.color_mask = {true, false, false, true};
  scene.draws[1].operations.depth.write = false;
  return scene;
}

std::string refusal_of(const std::string& scene) {
  return fault_in(parse_request(request_line("a", scene)));
}

Scene read_back(const Scene& scene) {
  const auto parsed = parse_request(request_line("a", scene_json(scene)));
  EXPECT_TRUE(std::holds_alternative<Request>(parsed)) << std::get<WireError>(parsed).message;
  return std::holds_alternative<Request>(parsed) ? std::get<Request>(parsed).scene : Scene{};
}

TEST(OperationRequests, HaveTheDocumentedForm) {
  const std::string json = scene_json(operations_scene());
  EXPECT_THAT(json, HasSubstr(R"("depth":"depth24","stencil":"stencil8","clear_depth":)"
                              R"(0.10000000149011612,"clear_stencil":200,"surface":"fbo")"));
  EXPECT_THAT(json, HasSubstr(R"("viewport":[-1,-2,8,16],"depth_range":[1.0,0.25],"draws":)"));
  EXPECT_THAT(
      json,
      HasSubstr(
          R"("front_face":"cw","cull":"back","polygon_offset":{"factor":-1.5,"units":)"
          R"(0.10000000149011612,"clamp":0.25},"stencil":{"front":{"test":"notequal",)"
          R"("reference":255,"read_mask":15,"write_mask":240,"fail":"zero","depth_fail":)"
          R"("incr_wrap","pass":"replace"},"back":{"test":"always","reference":0,"read_mask":255,)"
          R"("write_mask":255,"fail":"keep","depth_fail":"keep","pass":"invert"}},"depth":{"test":)"
          R"("lequal","write":false},"blend":{"color":{"equation":"reverse_subtract","source":)"
          R"("constant_color","destination":"dst_alpha"},"alpha":{"equation":"max","source":"one",)"
          R"("destination":"zero"},"constant":[0.10000000149011612,0.0,1.0,0.5]},"color_mask":)"
          R"([true,false,false,true],"vertices":)"));
  EXPECT_THAT(json, HasSubstr(R"("scissor":[-1,0,3,0],"depth":{"test":"always","write":false},)"));
}

// One part of it at a time: what is left out is what the scene has by default.
TEST(OperationRequests, AreReadBackPartByPart) {
  const Scene whole = operations_scene();
  EXPECT_TRUE(same_scene(read_back(whole), whole));
  const std::vector<std::function<void(Scene&)>> parts{
      [&](Scene& s) { s.target.stencil = whole.target.stencil; },
      [&](Scene& s) { s.target.clear_depth = 0; },
      [&](Scene& s) { s.target.clear_stencil = 1; },
      [&](Scene& s) { s.depth_range.near = 0.3F; },
      [&](Scene& s) { s.depth_range.far = 0; },
      [&](Scene& s) { s.draws[1].front_face = FrontFace::cw; },
      [&](Scene& s) { s.draws[1].cull = CullMode::front_and_back; },
      [&](Scene& s) { s.draws[1].polygon_offset = PolygonOffset{}; },
      [&](Scene& s) { s.draws[1].operations.stencil = StencilTest{}; },
      [&](Scene& s) { s.draws[1].operations.depth.function = CompareFunction::never; },
      [&](Scene& s) { s.draws[1].operations.blending = Blending{}; },
      [&](Scene& s) {
        s.draws[1].operations.color_mask = {false, false, false, false};
      },
  };
  const std::string plain = scene_json(small_scene());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Scene scene = small_scene();
    parts[i](scene);
    EXPECT_TRUE(same_scene(read_back(scene), scene)) << i;
    EXPECT_NE(scene_json(scene), plain) << i;
  }
}

// Digests of scenes without any of it are those that they always had.
TEST(OperationRequests, NameNothingOfWhatIsByDefault) {
  const std::string json = scene_json(small_scene());
  for (const char* key :
       {"stencil", "depth", "clear_", "front_face", "cull", "offset", "blend", "mask"})
    EXPECT_THAT(json, Not(HasSubstr(key)));
  EXPECT_EQ(digest_of(json), "71e04d09445b0cdc");
}

TEST(OperationRequests, AreRefusedForTheirFaults) {
  const std::string good = scene_json(operations_scene());
  EXPECT_EQ(refusal_of(good), "");
  const std::vector<std::array<std::string, 3>> faults{
      {R"("stencil8")", R"("stencil4")", "/scene/target/stencil is the unknown name \"stencil4\""},
      {R"("clear_stencil":200)", R"("clear_stencil":256)", "must be 0 to 255"},
      {R"("clear_depth":0.10000000149011612)", R"("clear_depth":0.1)",
       "/scene/target/clear_depth is 0.1, but it must be a float32 value of 0 to 1"},
      {"[1.0,0.25]", "[1.0,1.25]", "/scene/depth_range/1 is 1.25"},
      {"[1.0,0.25]", "[1.0]", "/scene/depth_range must have 2 elements"},
      {R"("front_face":"cw")", R"("front_face":"left")",
       "/scene/draws/0/front_face is the unknown"},
      {R"("cull":"back")", R"("cull":true)", "/scene/draws/0/cull must be a string"},
      {R"("clamp":0.25)", R"("bound":0.25)", "has the unknown key \"bound\""},
      {R"("factor":-1.5,)", "", "/scene/draws/0/polygon_offset has no \"factor\""},
      {R"("reference":255)", R"("reference":256)",
       "/scene/draws/0/stencil/front/reference is 256, but it must be 0 to 255"},
      {R"("fail":"zero",)", "", "/scene/draws/0/stencil/front has no \"fail\""},
      {R"("pass":"replace")", R"("pass":"add")", "/stencil/front/pass is the unknown name"},
      {R"("test":"notequal",)", R"("test":"equals",)", "/stencil/front/test is the unknown name"},
      {R"("write":false})", R"("write":0})", "/depth/write must be true or false"},
      {R"("source":"constant_color")", R"("source":"src1_color")", "/blend/color/source is the"},
      {R"("equation":"max")", R"("equation":"maximum")", "/blend/alpha/equation is the unknown"},
      {"0.0,1.0,0.5]", "0.0,1.5,0.5]", "/blend/constant/2 is 1.5"},
      {"[true,false,false,true]", "[true,false,false]", "/color_mask must have 4 elements"},
      {"[true,false,false,true]", "[true,false,false,1]", "/color_mask/3 must be true or false"},
  };
  for (const auto& [from, to, message] : faults)
    EXPECT_THAT(refusal_of(replaced(good, from, to)), HasSubstr(message));
}

TEST(OperationRequests, DoNotComeTogetherWithSupersampling) {
  Scene scene = small_scene();
  scene.supersampling = {{{Fixed::centre_of(0), Fixed::centre_of(0)}, 1}};
  scene.draws[0].cull = CullMode::front;
  scene.draws[0].polygon_offset = PolygonOffset{};
  scene.depth_range = {1, 0};
  EXPECT_TRUE(same_scene(read_back(scene), scene));
  scene.draws[1].operations.color_mask[1] = false;
  EXPECT_THAT(refusal_of(scene_json(scene)),
              HasSubstr("/scene/target/supersampling is there, but the scene has fragment"));
}

// Two fragments at (0, 0) and one at (2, 1), of which one at each passes.
Rendering tested() {
  Rendering rendering;
  rendering.width = 3;
  rendering.height = 2;
  rendering.pixels.assign(24, 1);
  rendering.hits = {1, 0, 0, 0, 0, 1};
  rendering.depths = {0, 1, 1, 1, 1, 0.5};
  rendering.stencils = {255, 0, 1, 2, 3, 4};
  rendering.fragments.resize(3);
  rendering.fragments[1].primitive = 1;
  rendering.fragments[2].x = 2;
  rendering.fragments[2].y = 1;
  return rendering;
}

std::string message_of(const std::string& line, const Scene& scene, bool coverage_only = false) {
  return fault_in(parse_answer(line, kDigest, scene, coverage_only));
}

TEST(OperationAnswers, AreReadBack) {
  const std::string line = answer_line(kDigest, tested(), nullptr);
  EXPECT_THAT(line, HasSubstr(R"("depths":[0,1,1,1,1,0.5],"stencils":[255,0,1,2,3,4],"hits":[)"));
  const auto parsed = parse_answer(line, kDigest, operations_scene());
  ASSERT_TRUE(std::holds_alternative<Answer>(parsed)) << std::get<WireError>(parsed).message;
  const auto& rendering = std::get<Rendering>(std::get<Answer>(parsed).outcome);
  EXPECT_THAT(rendering.stencils, ElementsAre(255, 0, 1, 2, 3, 4));
  EXPECT_THAT(rendering.hits, ElementsAre(1, 0, 0, 0, 0, 1));
  EXPECT_THAT(rendering_json("a", tested()),
              HasSubstr(R"("depths":[0,1,1,1,1,0.5],"stencils":[255,0,1,2,3,4]})"));
}

TEST(OperationAnswers, HaveStencilsExactlyWhereTheTargetHasThem) {
  const std::string good = answer_line(kDigest, tested(), nullptr);
  const std::string stencils = R"("stencils":[255,0,1,2,3,4],)";
  EXPECT_EQ(message_of(replaced(good, stencils, ""), operations_scene()),
            "the line has no \"stencils\"");
  EXPECT_THAT(message_of(replaced(good, "[255,", "["), operations_scene()),
              HasSubstr("/stencils must have 6 elements, but it has 5"));
  EXPECT_THAT(message_of(replaced(good, "[255,", "[256,"), operations_scene()),
              HasSubstr("/stencils/0 is 256, but it must be 0 to 255"));
  EXPECT_THAT(message_of(replaced(good, "[255,", "[0.5,"), operations_scene()),
              HasSubstr("/stencils/0 must be an integer"));
  Scene scene = operations_scene();
  scene.target.stencil = StencilFormat::none;
  EXPECT_EQ(message_of(good, scene),
            "the line has \"stencils\", but the target has no stencil buffer");
  EXPECT_EQ(message_of(replaced(good, stencils, ""), scene), "");
}

TEST(OperationAnswers, OfSeveralSamplesHaveAPlaneForEach) {
  Scene scene = operations_scene();
  scene.target.samples = 2;
  Rendering rendering = tested();
  rendering.samples = 2;
  const auto twice = [](auto& plane) {
    const auto first = plane;
    plane.insert(plane.end(), first.begin(), first.end());
  };
  twice(rendering.hits);
  twice(rendering.depths);
  EXPECT_THAT(message_of(answer_line(kDigest, rendering, nullptr), scene),
              HasSubstr("/stencils must have 12 elements, but it has 6"));
  twice(rendering.stencils);
  EXPECT_EQ(message_of(answer_line(kDigest, rendering, nullptr), scene), "");
  rendering.hits[11] = 2;
  EXPECT_EQ(message_of(answer_line(kDigest, rendering, nullptr), scene),
            "more hits than fragments at pixel (2, 1), sample 1: 2 against 1");
}

TEST(OperationAnswers, HaveAtMostAsManyHitsAsFragments) {
  Rendering rendering = tested();
  rendering.hits = {2, 0, 0, 0, 0, 1};
  EXPECT_EQ(message_of(answer_line(kDigest, rendering, nullptr), operations_scene()), "");
  rendering.hits = {0, 0, 0, 0, 0, 0};
  EXPECT_EQ(message_of(answer_line(kDigest, rendering, nullptr), operations_scene()), "");
  rendering.hits = {0, 0, 0, 1, 0, 0};
  EXPECT_EQ(message_of(answer_line(kDigest, rendering, nullptr), operations_scene()),
            "more hits than fragments at pixel (0, 1): 1 against 0");
  rendering.hits.clear();
  EXPECT_EQ(message_of(answer_line(kDigest, rendering, nullptr), operations_scene()), "");
  EXPECT_FALSE(excess_of_hits(rendering).has_value());
}

// Culled triangles make no fragments, and an offset drops none: hits are all fragments still.
TEST(OperationAnswers, WithoutTestsHaveAHitForEachFragment) {
  Rendering rendering = tested();
  rendering.depths.clear();
  rendering.stencils.clear();
  Scene scene = small_scene();
  scene.draws[0].cull = CullMode::front;
  const std::string fewer = answer_line(kDigest, rendering, nullptr);
  EXPECT_EQ(message_of(fewer, scene),
            "hit counts and fragments contradict each other at pixel (0, 0): 1 against 2");
  scene.draws[1].operations.color_mask[0] = false;
  EXPECT_EQ(message_of(fewer, scene), "");
}

TEST(OperationAnswers, OfCoverageAloneTellHitsThatDiffer) {
  Rendering rendering = tested();
  const std::string line = coverage_line(kDigest, rendering, nullptr);
  EXPECT_THAT(line, AllOf(HasSubstr(R"("hits":[1,0,0,0,0,1])"), Not(HasSubstr("stencils"))));
  EXPECT_EQ(message_of(line, operations_scene(), true), "");
  rendering.hits = {2, 0, 0, 0, 0, 1};
  EXPECT_THAT(coverage_line(kDigest, rendering, nullptr), Not(HasSubstr("hits")));
}

TEST(OperationAnswers, ExcludeOtherForms) {
  const std::string start = R"({"digest":"0123456789abcdef","stencils":[],)";
  EXPECT_THAT(message_of(start + R"("not_run":"no"})", operations_scene()),
              HasSubstr("has both \"not_run\" and \"stencils\""));
  EXPECT_THAT(message_of(start + R"("coverage":[]})", operations_scene(), true),
              HasSubstr("has both \"coverage\" and \"stencils\""));
  Scene scene = small_scene();
  scene.supersampling = {{{Fixed::centre_of(0), Fixed::centre_of(0)}, 1}};
  EXPECT_THAT(message_of(start + R"("pixels":[]})", scene),
              HasSubstr("the line has \"stencils\" beside the passes"));
}

}  // namespace
}  // namespace edgecase
