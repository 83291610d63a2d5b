// SPDX-License-Identifier: MIT
//
// Lookups that no alternative explains: inside what the specification permits, and beyond it;
// numbers that are none; and answers that leave details out.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "diff/textures/level_ramp.h"
#include "diff/textures/texture_lookups.h"
#include "raster/rasterizer.h"
#include "tests/diff/texture_judging.h"
#include "tests/raster/texture_scenes.h"

namespace edgecase {
namespace {

using Causes = std::set<std::string>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Result judged(const Scene& scene, const TextureChange& change) {
  return judge_textures(scene, changed_textures(scene, change));
}

void expect_one_fault(const Result& result, const std::string& rule) {
  EXPECT_EQ(result.verdict, Verdict::violation) << describe_textures(result);
  ASSERT_EQ(result.disagreements.size(), 1u) << describe_textures(result);
  EXPECT_EQ(result.disagreements[0].rule, rule);
  EXPECT_EQ(result.disagreements[0].cause, "");
  EXPECT_FALSE(is_legal(result.disagreements[0]));
  EXPECT_FALSE(result.disagreements[0].explanation.empty());
}

// lambda' and what is accessed, moved together by so many levels.
TextureChange level_moved(double by) {
  return [by](Fragment&, FragmentDetail& detail) {
    for (double& level : detail.level_of_detail) level += by;
  };
}

TEST(TextureLatitude, ALevelInsideTheBandIsPermittedAndOneBeyondIsAFault) {
  const Scene& scene = textures_named("rotated");  // band: 1.5027 to 2.5132 about 1.6485
  for (const double by : {0.0217, -0.0131, 0.31, 0.61}) {
    Scene untold = scene;
    const Result result = judged(untold, [&](Fragment& f, FragmentDetail& detail) {
      level_moved(by)(f, detail);
      f.has_color = false;  // it would have to move along
    });
    EXPECT_EQ(result.verdict, Verdict::permitted) << by << "\n" << describe_textures(result);
    EXPECT_EQ(causes_of(result), Causes{""}) << by;
  }
  const Rendering one = changed_texture(scene, 100, level_moved(1.13));
  const Result result = judge_textures(scene, one);
  ASSERT_FALSE(result.disagreements.empty());
  EXPECT_EQ(result.verdict, Verdict::violation);
  for (const Disagreement& d : result.disagreements) EXPECT_EQ(d.cause, "");
}

// What is looked up must be of the level that the renderer itself tells.
TEST(TextureLatitude, ALevelThatIsToldIsTheOneThatIsAccessedAndLookedUp) {
  const Scene& scene = textures_named("rotated");
  const Result accessed =
      judge_textures(scene, changed_texture(scene, 7, [](Fragment& f, FragmentDetail& detail) {
                       f.has_color = false;
                       detail.level_of_detail[0] += 0.0287;
                     }));
  expect_one_fault(accessed, "texture.scale-factor");
  const Result inside =
      judge_textures(scene, changed_texture(scene, 7, [](Fragment& f, FragmentDetail& detail) {
                       f.has_color = false;
                       detail.level_of_detail[0] += 0.0033;
                     }));
  EXPECT_EQ(inside.verdict, Verdict::permitted) << describe_textures(inside);
  const Result color = judge_textures(
      scene, changed_texture(scene, 7, [](Fragment& f, FragmentDetail&) { f.color[1] += 9; }));
  expect_one_fault(color, "texture.filter");
}

TEST(TextureLatitude, ColoursNearerThanAPartIn100000ArePermitted) {
  const Scene& scene = textures_named("off the grid");
  const Result near = judged(scene, [](Fragment& f, FragmentDetail&) { f.color[0] += 4e-4; });
  EXPECT_EQ(near.verdict, Verdict::permitted) << describe_textures(near);
  EXPECT_EQ(causes_of(near), Causes{""});
  const Result far = judge_textures(
      scene, changed_texture(scene, 3, [](Fragment& f, FragmentDetail&) { f.color[2] -= 3; }));
  expect_one_fault(far, "texture.filter");
}

// Codes of 8 bits: half a code for each mean, and no more.
TEST(TextureLatitude, CodesMayBeRounded) {
  const Scene scene =
      flat_scene(0.0631, TextureFormat::rgba8, sampler_of(Filter::linear, MipFilter::none));
  const Result rounded = judged(scene, [](Fragment& f, FragmentDetail&) {
    for (double& component : f.color) component = std::round(component * 255) / 255;
  });
  EXPECT_EQ(rounded.verdict, Verdict::permitted) << describe_textures(rounded);
  const Result three = judge_textures(
      scene,
      changed_texture(scene, 3, [](Fragment& f, FragmentDetail&) { f.color[0] += 3. / 255; }));
  expect_one_fault(three, "texture.filter");
}

TEST(TextureLatitude, ColoursThatAreNoNumbersAreFaults) {
  for (const char* name : {"rotated", "floor of nearest levels", "mirrored", "magnified codes"})
    for (const double value : {kNan, kInfinity, -kInfinity}) {
      const Scene& scene = textures_named(name);
      const Result result = judge_textures(
          scene,
          changed_texture(scene, 5, [&](Fragment& f, FragmentDetail&) { f.color[1] = value; }));
      expect_one_fault(result, "texture.filter");
    }
}

TEST(TextureLatitude, LevelsThatAreNoNumbersAreFaults) {
  const Scene& scene = textures_named("rotated");
  for (const std::size_t which : {0u, 1u})
    for (const double value : {kNan, kInfinity, -kInfinity}) {
      const Result result =
          judge_textures(scene, changed_texture(scene, 5, [&](Fragment&, FragmentDetail& detail) {
                           detail.level_of_detail[which] = value;
                         }));
      expect_one_fault(result, "texture.scale-factor");
    }
}

// A texture that does not move has a level of minus infinity, or far below all others.
TEST(TextureLatitude, ATextureThatDoesNotMoveMayBeAnywhereBelowItsFirstLevel) {
  const Placement place{{0, 0}, {8, 8}, {0.3f, 0.6f}, {0.3f, 0.6f}};
  const Scene scene = textured_scene(8, 8, *textures_named("floor").textures[0], place,
                                     sampler_of(Filter::linear, MipFilter::linear));
  const Rendering exact = rasterize(scene, {});
  EXPECT_EQ(exact.details[0].level_of_detail[1], -kInfinity);
  EXPECT_EQ(judge_textures(scene, exact).verdict, Verdict::agree);
  for (const auto& point : level_ramp(scene, {}, exact, {8})) {
    EXPECT_EQ(point.low, -kInfinity);
    EXPECT_LT(point.high, -7);
  }
  for (const double told : {-31.75, -63.5, -127.0}) {
    const Result result =
        judged(scene, [&](Fragment&, FragmentDetail& detail) { detail.level_of_detail[1] = told; });
    EXPECT_EQ(result.verdict, Verdict::permitted) << told << "\n" << describe_textures(result);
  }
  const Result above =
      judge_textures(scene, changed_texture(scene, 0, [](Fragment& f, FragmentDetail& detail) {
                       f.has_color = false;
                       detail.level_of_detail = {1, 1};
                     }));
  EXPECT_EQ(above.verdict, Verdict::violation) << describe_textures(above);
}

// That they are not finite is told as such; what they lead to is not told again.
TEST(TextureLatitude, CoordinatesThatAreNoNumbersExcuseTheColour) {
  for (const char* name : {"rotated", "mirrored", "magnified codes", "floor"})
    for (const double value : {kNan, kInfinity, -kInfinity}) {
      const Scene& scene = textures_named(name);
      const Result result =
          judge_textures(scene, changed_texture(scene, 4, [&](Fragment& f, FragmentDetail& detail) {
                           detail.texture_coordinates[0] = value;
                           f.color = rasterize(scene, {}).fragments[9].color;
                         }));
      EXPECT_EQ(result.verdict, Verdict::violation);
      for (const Disagreement& d : result.disagreements) {
        EXPECT_EQ(d.rule, "attribute.smooth") << name << "\n" << describe_textures(result);
      }
    }
  const Scene& scene = textures_named("off the grid");
  const Result none =
      judge_textures(scene, changed_texture(scene, 4, [](Fragment& f, FragmentDetail& detail) {
                       detail.texture_coordinates[1] = kNan;
                       f.color.fill(kNan);
                     }));
  for (const Disagreement& d : none.disagreements) EXPECT_EQ(d.rule, "attribute.smooth");
}

// Texels that are no numbers are what the texture holds.
TEST(TextureLatitude, TexturesMayHoldNoNumbers) {
  const auto texel = [](int i, int j, int) -> std::array<float, 4> {
    return {i == 3 ? std::nanf("") : 1, j == 2 ? HUGE_VALF : 2, 3, i == 5 ? -HUGE_VALF : 4};
  };
  const Texture texture = single_of(8, 8, TextureFormat::rgba32f, texel);
  for (const Filter filter : {Filter::nearest, Filter::linear}) {
    const Scene scene = textured_scene(8, 8, texture, {{0, 0}, {8, 8}, {0.05f, 0}, {1, 1.3f}},
                                       sampler_of(filter, MipFilter::none));
    const Rendering exact = rasterize(scene, {});
    EXPECT_EQ(judge_textures(scene, exact).verdict, Verdict::agree) << name_of(filter);
    const Result wrong = judge_textures(
        scene, changed_texture(scene, 0, [](Fragment& f, FragmentDetail&) { f.color[2] = kNan; }));
    EXPECT_EQ(wrong.verdict, Verdict::violation) << name_of(filter);
  }
}

TEST(TextureLatitude, DetailsMayBeMissing) {
  for (const TexturedScene& one : judged_textures()) {
    Rendering bare = rasterize(one.scene, {});
    bare.mip_chains.clear();
    for (FragmentDetail& detail : bare.details)
      detail.has_texture_coordinates = detail.has_level_of_detail = false;
    EXPECT_EQ(judge_textures(one.scene, bare).verdict, Verdict::agree) << one.name;
    for (Fragment& fragment : bare.fragments) fragment.detail = -1;
    EXPECT_EQ(judge_textures(one.scene, bare).verdict, Verdict::agree) << one.name;
  }
  // By colours alone a fault is still found.
  const Scene& scene = textures_named("mirrored");
  Rendering wrong = rasterize(scene, policy_of({"texture.wrap=mirrored-as-repeat"}));
  for (Fragment& fragment : wrong.fragments) fragment.detail = -1;
  EXPECT_EQ(judge_textures(scene, wrong).verdict, Verdict::violation);
}

// Of levels that a renderer generates and does not tell, nothing is known.
TEST(TextureLatitude, AnyColourComesOfAChainThatIsNotTold) {
  const Scene& scene = textures_named("generated codes");
  Rendering untold = changed_textures(scene, [](Fragment& f, FragmentDetail&) {
    f.color = {0.125, 0.25, 0.5, 1};
  });
  EXPECT_EQ(judge_textures(scene, untold).verdict, Verdict::violation);
  untold.mip_chains.clear();
  EXPECT_EQ(judge_textures(scene, untold).verdict, Verdict::permitted);
}

TEST(TextureLatitude, TheRampIsWhatFragmentsOfAStripTell) {
  const Placement place{{0, 0}, {32, 2}, {0, 0}, {1.5f, 0.0625f}};
  Scene strip = textured_scene(32, 2, *textures_named("floor").textures[0], place,
                               sampler_of(Filter::linear, MipFilter::linear));
  for (const std::size_t right : {1u, 3u}) strip.draws[0].vertices[right].w = 8;
  const auto ramp = level_ramp(strip, {}, changed_textures(strip, level_moved(0.01)), {8});
  ASSERT_EQ(ramp.size(), 32u);
  const Rendering exact = rasterize(strip, {});
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    const Result::LevelPoint& point = ramp[i];
    EXPECT_EQ(point.x, static_cast<int>(i));
    EXPECT_EQ(point.y, 0);
    const Fragment& f = exact.fragments[i];
    EXPECT_EQ(point.exact, exact.details[static_cast<std::size_t>(f.detail)].level_of_detail[1]);
    EXPECT_NEAR(point.rendered, point.exact + 0.01, 1e-9);
    EXPECT_LT(point.low, point.exact);
    EXPECT_GT(point.high, point.exact);
    EXPECT_LT(point.high - point.low, 3);
  }
}

// The band of an axis-aligned footprint, worked out by hand: log2 of max(m_u, m_v) to m_u + m_v.
TEST(TextureLatitude, TheBandIsThatOfTheLeastAndTheMost) {
  const Texture texture = chain_of(64, 64, TextureFormat::rgba32f, distinct);
  for (const double u : {1.5, 3.0, 5.25})
    for (const double v : {0.25, 2.0}) {
      const Placement place{
          {0, 0}, {32, 2}, {0, 0}, {static_cast<float>(u / 2), static_cast<float>(v / 32)}};
      const Scene strip =
          textured_scene(32, 2, texture, place, sampler_of(Filter::linear, MipFilter::linear));
      const auto ramp = level_ramp(strip, {}, rasterize(strip, {}), {8});
      EXPECT_EQ(ramp.size(), 32u);
      for (const auto& point : ramp) {
        EXPECT_NEAR(point.low, std::log2(std::max(u, v)), 0.06);
        EXPECT_NEAR(point.high, std::log2(u + v), 0.06);
        EXPECT_LE(point.low, std::log2(std::max(u, v)));
        EXPECT_GE(point.high, std::log2(u + v));
      }
    }
}

// A renderer that says less exactly where vertices are may look up what a finer one may.
TEST(TextureLatitude, WiderLatitudeHoldsTheNarrower) {
  for (const char* name : {"floor", "steep", "rotated", "off the grid", "magnified codes"}) {
    const Scene& scene = textures_named(name);
    const Rendering exact = rasterize(scene, {});
    const auto primitives = primitives_of(scene);
    const RuleChoices choices = resolve({}, scene.target.surface);
    const ValueContext fine(scene, primitives, choices, 12, Latitude::opengl);
    const ValueContext coarse(scene, primitives, choices, 4, Latitude::opengl);
    TextureLookups of_fine(fine, exact, exact), of_coarse(coarse, exact, exact);
    for (const Fragment& f : exact.fragments) {
      const Interval own = of_fine.levels(f, choices.textures)[0][1];
      const Interval near = of_fine.permitted_lambda(f, TextureLookups::Reach::near);
      const Interval narrow = of_fine.permitted_lambda(f);
      const Interval wide = of_coarse.permitted_lambda(f);
      const auto contains = [](Interval outer, Interval inner) {
        return outer.low <= inner.low && inner.high <= outer.high;
      };
      ASSERT_TRUE(contains(near, own) && contains(narrow, near) && contains(wide, narrow)) << name;
    }
  }
}

}  // namespace
}  // namespace edgecase
