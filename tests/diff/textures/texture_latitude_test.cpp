// SPDX-License-Identifier: MIT
//
// Lookups that no alternative explains: inside what the specification permits, and beyond it;
// numbers that are none; and answers that leave details out.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "diff/display_data.h"
#include "diff/textures/texture_lookups.h"
#include "raster/rasterizer.h"
#include "rules/textures/texture_image.h"
#include "tests/diff/textures/texture_judging.h"
#include "tests/raster/texture_scenes.h"
#include "tests/support/causes.h"

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

TEST(TextureLatitude, ALevelInsideTheBandIsPermittedAndOneBeyondIsAFault) {
  const Scene& scene = textures_named("rotated");  // band: from 1.5027 to 2.6 about 1.6485
  for (const double by : {0.0217, -0.0131, 0.31, 0.61}) {
    Scene unreported = scene;
    const Result result = judged(unreported, [&](Fragment& f, FragmentDetail& detail) {
      level_moved(by)(f, detail);
      f.has_color = false;  // it would have to move along
    });
    EXPECT_EQ(result.verdict, Verdict::permitted) << by << "\n" << describe_textures(result);
    EXPECT_EQ(causes_of(result), Causes{""}) << by;
  }
  const Rendering one = changed_texture(scene, 100, level_moved(2.13));
  const Result result = judge_textures(scene, one);
  ASSERT_FALSE(result.disagreements.empty());
  EXPECT_EQ(result.verdict, Verdict::violation);
  for (const Disagreement& d : result.disagreements) EXPECT_EQ(d.cause, "");
}

// What is looked up must be of the level that the renderer itself tells.
TEST(TextureLatitude, AReportedLevelIsTheOneThatIsAccessedAndLookedUp) {
  const Scene& scene = textures_named("rotated");
  const Result accessed =
      judge_textures(scene, changed_texture(scene, 7, [](Fragment& f, FragmentDetail& detail) {
                       f.has_color = false;
                       detail.level_of_detail.value()[0] += 0.0687;
                     }));
  expect_one_fault(accessed, "texture.scale-factor");
  const Result coarse =
      judge_textures(scene, changed_texture(scene, 7, [](Fragment& f, FragmentDetail& detail) {
                       f.has_color = false;
                       detail.level_of_detail.value()[0] += 0.0287;
                     }));
  EXPECT_EQ(rulings_of(coarse), std::set<int>{50}) << describe_textures(coarse);
  const Result inside =
      judge_textures(scene, changed_texture(scene, 7, [](Fragment& f, FragmentDetail& detail) {
                       f.has_color = false;
                       detail.level_of_detail.value()[0] += 0.0033;
                     }));
  // A weight of 8 bits makes this level, and the pixel is right.
  EXPECT_EQ(inside.verdict, Verdict::convention) << describe_textures(inside);
  const Result color = judge_textures(
      scene, changed_texture(scene, 7, [](Fragment& f, FragmentDetail&) { f.color[1] += 90; }));
  expect_one_fault(color, "texture.filter");
}

// Bounds decide, whichever arithmetic is behind them: weights of 6 bits are no alternative of ours,
// and legal; those of 5 and 4 are contested, those of 3 a violation.
TEST(TextureLatitude, WeightsOfSixBitsArePermittedAndOfFewerAreNot) {
  const Scene& scene = textures_named("floor");
  const auto rulings_by = [&](double steps, bool to_nearest) {
    const Rendering rendered = changed_textures(scene, [&](Fragment& f, FragmentDetail& detail) {
      f.has_color = false;
      double& level = detail.level_of_detail.value()[0];
      level = (to_nearest ? std::round(level * steps) : std::floor(level * steps)) / steps;
    });
    return rulings_of(judge_textures(scene, rendered));
  };
  EXPECT_EQ(rulings_by(64, false), std::set<int>{});
  EXPECT_EQ(rulings_by(64, true), std::set<int>{});
  EXPECT_EQ(rulings_by(32, true), std::set<int>{});
  EXPECT_EQ(rulings_by(32, false), std::set<int>{50});
  EXPECT_EQ(rulings_by(16, false), std::set<int>{50});
  EXPECT_TRUE(rulings_by(4, false).contains(19));
}

// Downwards nothing hides an error of the logarithm where one partial derivative is all there is.
TEST(TextureLatitude, ALogarithmMayBeOffByA64thOfALevel) {
  const Scene& scene = textures_named("narrow");
  const auto rulings_by = [&](double by) {
    return rulings_of(judged(scene, [&](Fragment& f, FragmentDetail& detail) {
      level_moved(by)(f, detail);
      f.has_color = false;
    }));
  };
  EXPECT_EQ(rulings_by(-0.015), std::set<int>{});
  EXPECT_EQ(rulings_by(-0.03), std::set<int>{50});
  EXPECT_EQ(rulings_by(-0.06), std::set<int>{50});
  EXPECT_EQ(rulings_by(-0.085), std::set<int>{19});
  // A catalogued approximation is judged by its error, too.
  const Result line = judge_follower(scene, {"texture.log2=linear-mantissa"});
  EXPECT_TRUE(rulings_of(line).contains(19)) << describe_textures(line);
}

// sRGB texels may be decoded after they are filtered (8.24).
TEST(TextureLatitude, SrgbMayBeDecodedBeforeOrAfterTheFilter) {
  for (const MipFilter mipmap : {MipFilter::none, MipFilter::linear}) {
    const double texels = mipmap == MipFilter::none ? 0.0631 : 2.9;
    const Sampler sampler = sampler_of(Filter::linear, mipmap);
    Scene scene = flat_scene(texels, TextureFormat::srgb8, sampler);
    scene.draws[0].vertices.resize(3);
    Scene codes = scene;
    Texture texture = *scene.textures[0];
    texture.format = TextureFormat::rgba8;
    codes.textures = {std::make_shared<const Texture>(texture)};
    const Rendering filtered = rasterize(codes, {});
    // Three fragments will do.
    const auto rulings_by = [&](double by) {
      std::size_t fragment = 0;
      return rulings_of(judged(scene, [&](Fragment& f, FragmentDetail&) {
        const std::size_t i = fragment++;
        if (i % 32 != 5) return;
        for (std::size_t c = 0; c < 3; ++c)
          f.color[c] = srgb_to_linear_number(filtered.fragments[i].color[c]) + by;
      }));
    };
    EXPECT_EQ(rulings_by(0), std::set<int>{}) << name_of(mipmap);
    EXPECT_EQ(rulings_by(-0.2), std::set<int>{24}) << name_of(mipmap);
  }
}

// Of a nearest texel, which no filter changes.
TEST(TextureLatitude, SrgbThatIsDecodedInexactlyIsContested) {
  const Scene scene =
      flat_scene(0.25, TextureFormat::srgb8, sampler_of(Filter::nearest, MipFilter::none));
  const auto off_by = [&](double off) {
    return rulings_of(judge_textures(
        scene,
        changed_texture(scene, 5, [&](Fragment& f, FragmentDetail&) { f.color[1] += off; })));
  };
  EXPECT_EQ(off_by(0.000005), std::set<int>{});
  EXPECT_EQ(off_by(0.0012), std::set<int>{53});
  EXPECT_EQ(off_by(-0.0049), std::set<int>{53});
  EXPECT_EQ(off_by(0.0052), std::set<int>{24});
}

// Biases of 10 and 9 are beyond every limit that an implementation may have.
TEST(TextureLatitude, BiasesBeyondTheLimitMayBeClampedAnyhow) {
  const Scene& scene = textures_named("far bias");
  const Result unclamped = judge_follower(scene, {"texture.lod-bias=unclamped"});
  EXPECT_EQ(unclamped.verdict, Verdict::convention) << describe_textures(unclamped);
  // A bias of 0.3066 is within it.
  const Result off = judged(textures_named("odd bias"), [](Fragment& f, FragmentDetail& detail) {
    f.has_color = false;
    level_moved(-0.09)(f, detail);
  });
  EXPECT_EQ(rulings_of(off), std::set<int>{19}) << describe_textures(off);
}

// Whatever an anisotropic filter does, it does on levels that the sampler lets it access.
TEST(TextureLatitude, AnisotropicFiltersStayAmongTheirLevels) {
  Scene scene = textures_named("anisotropic");
  const auto rulings_by = [&](const TextureChange& change) {
    return rulings_of(judge_textures(scene, changed_texture(scene, 9, change)));
  };
  const auto accessed = [&](double level) {
    return rulings_by([&](Fragment& f, FragmentDetail& detail) {
      f.has_color = false;
      detail.level_of_detail = {level, 77};
    });
  };
  EXPECT_EQ(accessed(0), std::set<int>{});
  EXPECT_EQ(accessed(5), std::set<int>{});  // of 32x32, the last one
  EXPECT_EQ(accessed(5.25), std::set<int>{23});
  const auto far = [](Fragment& f, FragmentDetail&) { f.color[2] += 1e6; };
  EXPECT_EQ(rulings_by(far), std::set<int>{23});
  // Filters with negative weights may lead beyond the texels by their range, and no further.
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const TextureLevel& level : scene.textures[0]->levels)
    for (std::size_t i = 2; i < level.texels.size(); i += 4) {
      least = std::min(least, static_cast<double>(level.texels[i]));
      most = std::max(most, static_cast<double>(level.texels[i]));
    }
  const double unit = scene.textures[0]->format == TextureFormat::rgba32f ? 1 : 255;
  const auto blue = [&](double shares_beyond) {
    return rulings_by([&](Fragment& f, FragmentDetail&) {
      f.color[2] = (most + shares_beyond * (most - least)) / unit;
    });
  };
  EXPECT_EQ(blue(0), std::set<int>{});
  EXPECT_EQ(blue(0.9), std::set<int>{57});
  EXPECT_EQ(blue(1.2), std::set<int>{23});
  EXPECT_EQ(blue(-1.9), std::set<int>{57});
  EXPECT_EQ(blue(-2.2), std::set<int>{23});
  scene.draws[0].texture->sampler.mipmap = MipFilter::none;
  EXPECT_EQ(accessed(0), std::set<int>{});
  EXPECT_EQ(accessed(0.5), std::set<int>{23});
  // Levels of one colour each tell which one was accessed.
  scene.textures = {std::make_shared<const Texture>(
      chain_of(32, 32, TextureFormat::rgba32f, [](int, int, int level) -> std::array<float, 4> {
        return {static_cast<float>(level), 0, 0, 1};
      }))};
  const auto red = [&](double value) {
    return rulings_by([&](Fragment& f, FragmentDetail&) { f.color[0] = value; });
  };
  EXPECT_EQ(red(0), std::set<int>{});
  EXPECT_EQ(red(0.5), std::set<int>{23});
  scene.draws[0].texture->sampler.mipmap = MipFilter::linear;
  EXPECT_EQ(red(3.75), std::set<int>{});
  scene.draws[0].texture->sampler.max_level = 3;
  EXPECT_EQ(red(3), std::set<int>{});
  EXPECT_EQ(red(3.75), std::set<int>{23});
}

TEST(TextureLatitude, ColoursNearerThanAPartIn100000ArePermitted) {
  const Scene& scene = textures_named("off the grid");
  const Result near = judged(scene, [](Fragment& f, FragmentDetail&) { f.color[0] += 4e-4; });
  EXPECT_EQ(near.verdict, Verdict::permitted) << describe_textures(near);
  EXPECT_EQ(causes_of(near), Causes{""});
  const Result far = judge_textures(
      scene, changed_texture(scene, 3, [](Fragment& f, FragmentDetail&) { f.color[2] -= 30; }));
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
  const Result thirty = judge_textures(
      scene,
      changed_texture(scene, 3, [](Fragment& f, FragmentDetail&) { f.color[0] += 30. / 255; }));
  expect_one_fault(thirty, "texture.filter");
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
                           detail.level_of_detail.value()[which] = value;
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
  EXPECT_EQ(exact.details[0].level_of_detail.value()[1], -kInfinity);
  EXPECT_EQ(judge_textures(scene, exact).verdict, Verdict::agree);
  for (const auto& point : level_ramp(scene, {}, exact, {8})) {
    EXPECT_EQ(point.low, -kInfinity);
    EXPECT_LT(point.high, -6);
  }
  for (const double reported : {-31.75, -63.5, -127.0}) {
    const Result result = judged(scene, [&](Fragment&, FragmentDetail& detail) {
      detail.level_of_detail.value()[1] = reported;
    });
    EXPECT_EQ(result.verdict, Verdict::permitted) << reported << "\n" << describe_textures(result);
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
                           detail.texture_coordinates.value()[0] = value;
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
                       detail.texture_coordinates.value()[1] = kNan;
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
    for (FragmentDetail& detail : bare.details) {
      detail.texture_coordinates.reset();
      detail.level_of_detail.reset();
    }
    EXPECT_EQ(judge_textures(one.scene, bare).verdict, Verdict::agree) << one.name;
    for (Fragment& fragment : bare.fragments) fragment.detail = -1;
    EXPECT_EQ(judge_textures(one.scene, bare).verdict, Verdict::agree) << one.name;
  }
  // By colours alone a fault is still found.
  const Scene& scene = textures_named("mirrored");
  Rendering wrong = rasterize(scene, policy_from({"texture.wrap=mirrored-as-repeat"}));
  for (Fragment& fragment : wrong.fragments) fragment.detail = -1;
  EXPECT_EQ(judge_textures(scene, wrong).verdict, Verdict::violation);
}

// Of levels that a renderer generates and does not tell, nothing is known.
TEST(TextureLatitude, AChainThatIsNotReportedYieldsAnyColour) {
  const Scene& scene = textures_named("generated codes");
  Rendering unreported = changed_textures(scene, [](Fragment& f, FragmentDetail&) {
    f.color = {0.125, 0.25, 0.5, 1};
  });
  EXPECT_EQ(judge_textures(scene, unreported).verdict, Verdict::violation);
  unreported.mip_chains.clear();
  EXPECT_EQ(judge_textures(scene, unreported).verdict, Verdict::permitted);
}

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
