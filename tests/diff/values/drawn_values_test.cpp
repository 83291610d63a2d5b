// SPDX-License-Identifier: MIT
//
// What exact drew settles most values. Each is judged as it is without knowing what exact drew.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "diff/values/drawn_fragments.h"
#include "diff/values/value_diff.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/named_scenes.h"
#include "tests/diff/values/value_mutants.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"

namespace edgecase {
namespace {

// All that is found, in one text.
std::string text_of(const Result& result) {
  std::string text;
  for (const Disagreement& d : result.disagreements)
    text += fmt::format("{} {} {} {} {} {} {} {}\n", d.x, d.y, d.primitive, name_of(d.rule),
                        d.ruling, d.policy_agrees, text_of(d.cause), d.explanation);
  for (const ValueAggregate& v : result.values)
    text += fmt::format("{} {} {} {} {} {} {} {} {} {} {} {} {} {}\n", v.attribute, name_of(v.rule),
                        text_of(v.cause), v.compared, v.components, v.differing.size(), v.worst.x,
                        v.worst.y, v.worst_component, v.worst_exact, v.worst_rendered, v.mean_ulp,
                        v.worst_relative, fmt::join(v.ulp_histogram, " "));
  return text;
}

// A value as renderers have it: right, off by an ULP, by less or more than what is permitted.
class Noise {
 public:
  double operator()(double value) {
    constexpr double kParts[] = {0, 0, 0x1p-24, -0x1p-22, 3e-6, -8.5e-6, 9.5e-6, 3e-5, 1e-3};
    const double part = kParts[engine_() % std::size(kParts)];
    const float nearest = static_cast<float>(value * (1 + part));
    return static_cast<double>(engine_() % 200 == 0 ? HUGE_VALF : nearest);
  }

 private:
  std::mt19937_64 engine_{5};
};

Rendering noisy(Rendering rendering, Noise& noise) {
  for (Fragment& fragment : rendering.fragments) {
    for (double& component : fragment.color) component = noise(component);
    fragment.depth = noise(fragment.depth);
  }
  for (FragmentDetail& detail : rendering.details) {
    if (detail.coordinates)
      for (const std::size_t i : {std::size_t{2}, std::size_t{3}})
        (*detail.coordinates)[i] = noise((*detail.coordinates)[i]);
    if (detail.texture_coordinates)
      for (double& component : *detail.texture_coordinates) component = noise(component);
  }
  return rendering;
}

// Returns what was found. `policy` draws, and judges.
std::string expect_judged_alike(Scene scene, const ResolvedPolicy& policy, Noise& noise) {
  scene.details.coordinates = true;
  const Rendering exact = rasterize(scene, policy);
  const Rendering rendered = noisy(exact, noise);
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  const auto judged = [&](const Rendering& known) {
    const ValueContext context(scene, primitives, policy.on(scene.target.surface), 8,
                               policy.latitude());
    Result result;
    compare_fragment_values(context, known, rendered, result);
    compare_coordinates(context, known, rendered, result);
    return text_of(result);
  };
  const std::string with = judged(exact);
  EXPECT_EQ(with, judged(Rendering()));
  return with;
}

const std::vector<ResolvedPolicy>& policies() {
  static const std::vector<ResolvedPolicy> kPolicies = [] {
    std::vector<ResolvedPolicy> all{ResolvedPolicy{}};
    for (Policy policy : {policy_with("attribute.perspective", "never"),
                          policy_with("attribute.positions", "snapped"),
                          policy_with("attribute.location", "half-pixel-off")})
      for (const Latitude latitude : {Latitude::opengl, Latitude::none}) {
        policy.latitude = latitude;
        all.emplace_back(policy);
      }
    return all;
  }();
  return kPolicies;
}

TEST(DrawnValues, ChangeNoVerdictOfRandomScenes) {
  RandomScenes scenes(23);
  Noise noise;
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    const std::int64_t step = i % 3 == 0 ? Fixed::kOne / 2 : i % 3 == 1 ? Fixed::kOne / 16 : 1;
    const Scene scene = scenes.next({12, step, 4, true});
    for (const ResolvedPolicy& policy : policies())
      found += expect_judged_alike(scene, policy, noise).empty() ? 0 : 1;
    if (HasFailure()) FAIL() << "scene " << i;
  }
  EXPECT_GT(found, 700);
}

// Clipping, perspective, offsets, textures, several samples, wide lines and flat colours.
TEST(DrawnValues, ChangeNoVerdictOfNamedScenes) {
  Noise noise;
  for (const ResolvedPolicy& policy : policies()) {
    for (const NamedScene& one : named_scenes()) {
      if (!one.scene.supersampling.empty()) continue;
      expect_judged_alike(one.scene, policy, noise);
      if (HasFailure()) FAIL() << one.name;
    }
    for (const ValueScene& one : value_scenes()) {
      expect_judged_alike(one.scene, policy, noise);
      if (HasFailure()) FAIL() << one.name;
    }
  }
}

TEST(DrawnFragments, AreFoundInAnyOrder) {
  Rendering exact = rasterize(value_scene("linear triangle"), {});
  std::vector<Fragment> asked = exact.fragments;
  // Every second one is not drawn.
  for (std::size_t i = 0; i < exact.fragments.size(); ++i)
    exact.fragments.erase(exact.fragments.begin() + static_cast<std::ptrdiff_t>(i));
  std::mt19937_64 engine(7);
  for (int round = 0; round < 20; ++round) {
    DrawnFragments drawn(exact);
    for (const Fragment& fragment : asked) {
      const auto there = std::ranges::find_if(
          exact.fragments, [&](const Fragment& one) { return cover_alike(one, fragment); });
      EXPECT_EQ(drawn.find(fragment),
                there == exact.fragments.end() ? nullptr : std::to_address(there));
    }
    std::ranges::shuffle(asked, engine);
  }
  EXPECT_EQ(DrawnFragments(Rendering()).find(asked[0]), nullptr);
}

}  // namespace
}  // namespace edgecase
