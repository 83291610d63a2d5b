// SPDX-License-Identifier: MIT
#include "run/earlier_answers.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "raster/rasterizer.h"
#include "run/answer_digest.h"

namespace edgecase {
namespace {

Case textured_triangle() {
  Case one;
  one.id = "textures/one";
  one.file = "cases/textures/one.json";
  one.source = SharedText(std::string("{}"));
  one.scene.target.width = one.scene.target.height = 4;
  one.scene.viewport = {0, 0, 4, 4};
  Draw draw;
  draw.primitive = Primitive::triangles;
  for (const auto& [x, y] : {std::pair{0, 0}, {4, 0}, {0, 4}}) {
    Vertex vertex;
    vertex.position = {Fixed::from_integer(x), Fixed::from_integer(y)};
    vertex.color = {1, 0.5F, 0.25F, 1};
    draw.vertices.push_back(vertex);
  }
  one.scene.draws = {draw};
  return one;
}

// All that a digest is made of.
struct Asked {
  Policy policy;
  Policy profile;
  RendererInfo info;
  Case one = textured_triangle();
  Rendering rendering = rasterize(one.scene, policy);

  std::uint64_t digest() const {
    Profiles profiles;
    profiles[info.name] = ReleaseProfiles(profile);
    return AnswerDigests(policy, profiles).of(one, rendering, info);
  }
};

TEST(AnswerDigests, DifferWithAllThatAComparisonDependsOn) {
  const std::vector<std::function<void(Asked&)>> changes = {
      [](Asked&) {},
      [](Asked& a) { a.policy.name = "other"; },
      [](Asked& a) { a.policy.latitude = Latitude::none; },
      [](Asked& a) { a.policy.rules["line.diamond"] = "closed"; },
      [](Asked& a) { a.policy.surfaces[Surface::window]["line.diamond"] = "closed"; },
      [](Asked& a) { a.profile.rules["line.diamond"] = "closed"; },
      [](Asked& a) { a.info.subpixel_bits = 8; },
      [](Asked& a) { a.info.traits["point_size_steps"] = "1 by 0.125"; },
      [](Asked& a) { a.info.traits["sampled_line_width_steps"] = "1 by 0.125"; },
      [](Asked& a) { a.info.traits["max_texture_lod_bias"] = "16"; },
      [](Asked& a) { a.info.traits["api"] = "OpenGL ES"; },
      [](Asked& a) { a.one.id = "textures/two"; },
      [](Asked& a) { a.one.file = "cases/two.json"; },
      [](Asked& a) { a.one.source = SharedText(std::string("{ }")); },
      [](Asked& a) { a.one.scene.draws[0].vertices[0].color[2] = 0; },
      [](Asked& a) { a.rendering.pixels.back() ^= 1; },
      [](Asked& a) { a.rendering.fragments.pop_back(); },
      [](Asked& a) { a.rendering.fragments[0].depth += 0x1p-24; },
      [](Asked& a) { a.rendering.fragments[0].color[3] += 0x1p-40; },
      [](Asked& a) { a.rendering.fragments[0].has_color = false; },
      [](Asked& a) { a.rendering.fragments[0].coverage = 3; },
      [](Asked& a) { a.rendering.hits[0] += 1; },
      [](Asked& a) { a.rendering.hits.clear(); },
      [](Asked& a) { a.rendering.depths.push_back(1); },
      [](Asked& a) { a.rendering.stencils.push_back(1); },
      [](Asked& a) { a.rendering.accumulated.push_back(1); },
      [](Asked& a) { a.rendering.sample_positions.push_back({}); },
      [](Asked& a) { a.rendering.mip_chains[0].emplace_back(); },
      [](Asked& a) { a.rendering.passes.push_back(a.rendering); },
      [](Asked& a) {
        a.rendering.fragments[0].detail = 0;
        a.rendering.details.emplace_back().texture_coordinates = {0, 0};
      },
  };
  std::set<std::uint64_t> digests;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Asked asked;
    changes[i](asked);
    EXPECT_TRUE(digests.insert(asked.digest()).second) << "change " << i;
  }
}

TEST(AnswerDigests, AreThoseOfAnyReleaseThatIsToldTheSame) {
  Asked asked;
  const std::uint64_t before = asked.digest();
  asked.info.name = "mine";
  asked.info.version = "4.6 Mesa 99";
  asked.info.device = "another";
  asked.info.traits["glsl"] = "4.60";
  EXPECT_EQ(asked.digest(), before);
}

// Of the bytes of the answer, which nobody has to write again.
TEST(AnswerDigests, TakeThatOfTheOutcomeWhereItIsKnown) {
  const Asked asked;
  const Profiles profiles;
  AnswerDigests digests(asked.policy, profiles);
  const auto of = [&](std::uint64_t outcome) {
    return digests.of(asked.one, asked.rendering, asked.info, outcome);
  };
  EXPECT_EQ(of(1), of(1));
  EXPECT_NE(of(1), of(2));
  EXPECT_NE(of(1), of(0));
}

// Results of renderers a and b: a case that both draw right, and one that b draws wrong.
Results earlier_results() {
  Results results;
  for (const char* name : {"a", "b"}) results.renderers.emplace_back().name = name;
  std::uint64_t digest = 0;
  for (const char* id : {"differs", "same"}) {
    CaseResults one;
    one.id = id;
    for (const char* name : {"a", "b"}) {
      Result& result = one.results.emplace_back();
      const bool is_wrong = one.id == "differs" && *name == 'b';
      result.verdict = is_wrong ? Verdict::violation : Verdict::agree;
      if (is_wrong) result.disagreements.emplace_back();
      result.standing = is_wrong ? Standing::known : Standing::expected;
      result.answer_digest = ++digest;
    }
    results.cases.push_back(one);
  }
  return results;
}

TEST(EarlierAnswers, AreFoundByCaseRendererAndDigest) {
  const Results results = earlier_results();
  const EarlierAnswers earlier(results, {"b"});
  EXPECT_TRUE(earlier.has("differs", 0, 2));
  EXPECT_TRUE(earlier.has("same", 0, 4));
  EXPECT_FALSE(earlier.has("differs", 0, 1));  // a's
  EXPECT_FALSE(earlier.has("differs", 0, 4));  // of another case
  EXPECT_FALSE(earlier.has("new", 0, 2));
  EXPECT_FALSE(EarlierAnswers(results, {"c"}).has("differs", 0, 2));
}

TEST(EarlierAnswers, HaveNoStandingAndAreThoseOfThePresentRenderers) {
  const Results results = earlier_results();
  const std::vector<std::vector<std::string>> present = {{"b"}, {"a", "b"}, {"b", "a"}};
  for (const std::vector<std::string>& names : present) {
    const EarlierAnswers earlier(results, names);
    const CaseResults one = earlier.whole("differs", std::make_shared<Shelf>()).whole();
    ASSERT_EQ(one.results.size(), names.size());
    for (std::size_t r = 0; r < names.size(); ++r) {
      EXPECT_EQ(one.results[r].disagreements.size(), names[r] == "b" ? 1U : 0U);
      EXPECT_EQ(one.results[r].answer_digest, names[r] == "b" ? 2U : 1U);
      EXPECT_EQ(one.results[r].standing, Standing::expected);
      EXPECT_EQ(earlier.result("differs", r).answer_digest, one.results[r].answer_digest);
      EXPECT_EQ(earlier.result("differs", r).standing, Standing::expected);
    }
  }
}

// Where all agree, a results file has no pictures: nobody else can be held against them.
TEST(EarlierAnswers, OfCasesWhereAllAgreeAreOfUseToOneRendererOnly) {
  const Results results = earlier_results();
  const EarlierAnswers earlier(results, {"a", "c"});
  EXPECT_TRUE(earlier.has("differs", 0, 1));
  EXPECT_FALSE(earlier.has("same", 0, 3));
}

TEST(EarlierAnswers, AreNoFlakesAndNoAnswersWithoutADigest) {
  Results results = earlier_results();
  results.cases.answer(0, 1).again = Judgement{};
  results.cases.answer(1, 1).answer_digest = 0;
  const EarlierAnswers earlier(results, {"b"});
  EXPECT_FALSE(earlier.has("differs", 0, 2));
  EXPECT_FALSE(earlier.has("same", 0, 4));
}

}  // namespace
}  // namespace edgecase
