// SPDX-License-Identifier: MIT
//
// What is left out of an answer that holds what exact holds: judged all the same, none of its
// values differs.
#include "diff/values/value_diff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "casefile/loader.h"
#include "diff/drawing_compare.h"
#include "raster/rasterizer.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/causes.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

// All values judged, whether they are exact's or not.
void expect_correct_values(const Scene& scene, const Rendering& exact, int bits) {
  const ResolvedPolicy policy;
  const RendererFacts facts{bits};
  const Drawing drawing{scene, policy, exact, exact, facts};
  const Result whole = compare_drawing(drawing, AlternativeSet::all(), Compared::all);
  EXPECT_TRUE(whole.disagreements.empty());
  for (const ValueAggregate& values : whole.values) EXPECT_TRUE(values.differing.empty());
}

TEST(EqualValues, AreCorrectInEveryPlainScene) {
  RandomScenes scenes(17);
  for (int i = 0; i < 4000; ++i) {
    const std::int64_t step = i % 3 == 0 ? Fixed::kOne / 2 : i % 3 == 1 ? Fixed::kOne / 16 : 1;
    const Scene scene = scenes.next({12, step, 4, true});
    const Rendering exact = rasterize_for_comparison(scene, {});
    ASSERT_TRUE(has_exact_values(scene, {}, exact, exact)) << i;
    expect_correct_values(scene, exact, i % 17);
    if (HasFailure()) FAIL() << "scene " << i;
  }
}

TEST(EqualValues, AreCorrectInEveryNamedScene) {
  int known = 0;
  for (const NamedScene& one : named_scenes()) {
    const Rendering exact = rasterize_for_comparison(one.scene, {});
    if (!has_exact_values(one.scene, {}, exact, exact)) continue;
    ++known;
    expect_correct_values(one.scene, exact, 8);
    if (HasFailure()) FAIL() << one.name;
  }
  EXPECT_GT(known, 5);
}

// Smooth colours, clipped primitives and depths among them.
TEST(EqualValues, AreCorrectInEveryCaseOfTheSuite) {
  const std::filesystem::path suite[] = {std::filesystem::path(EDGECASE_ROOT) / "cases"};
  int known = 0, smooth = 0, clipped = 0;
  Dealer files;
  for (const CaseFile& file : find_cases(suite).cases) {
    if (!files.deal()) continue;
    for (const Case& one : load_cases(file.file, file.id).cases) {
      if (one.scene.target.samples > 1 || !one.scene.textures.empty()) continue;
      const Rendering exact = rasterize_for_comparison(one.scene, {});
      if (!has_exact_values(one.scene, {}, exact, exact)) continue;
      ++known;
      smooth += std::ranges::any_of(one.scene.draws, [](const Draw& draw) {
        return draw.interpolation == Interpolation::smooth;
      });
      clipped += std::ranges::any_of(primitives_of(one.scene), &ScenePrimitive::is_clipped);
      expect_correct_values(one.scene, exact, 8);
      if (HasFailure()) FAIL() << one.id;
    }
  }
  std::printf("%d cases, %d of them smooth, %d clipped\n", known, smooth, clipped);
  EXPECT_GT(known, least_of(1000));
  EXPECT_GT(smooth, least_of(50));
  EXPECT_GT(clipped, least_of(50));
}

// A target with a depth buffer, so that there is a value of each kind.
struct Answer {
  Scene scene;
  Rendering exact;
};

Answer with_depths() {
  RandomScenes scenes(18);
  Answer answer;
  do {
    answer.scene = scenes.next({12, Fixed::kOne / 2, 4, true});
    answer.scene.target.depth = DepthFormat::depth24;
    answer.exact = rasterize_for_comparison(answer.scene, {});
  } while (answer.exact.fragments.empty());
  return answer;
}

TEST(EqualValues, AreNotSaidOfAnythingElse) {
  const auto [scene, exact] = with_depths();
  ASSERT_TRUE(has_exact_values(scene, {}, exact, exact));
  using Change = std::function<void(Rendering&)>;
  const std::vector<Change> changes = {
      [](Rendering& r) { r.pixels.back() ^= 1; },
      [](Rendering& r) { r.pixels.clear(); },
      [](Rendering& r) { r.depths.back() = 0.25; },
      [](Rendering& r) { r.depths.clear(); },
      [](Rendering& r) { r.fragments.pop_back(); },
      [](Rendering& r) { ++r.fragments.back().x; },
      [](Rendering& r) { ++r.fragments.back().y; },
      [](Rendering& r) { ++r.fragments.back().primitive; },
      [](Rendering& r) { r.fragments.back().coverage = 0; },
      [](Rendering& r) { r.fragments.back().depth = 0.25; },
      [](Rendering& r) { r.fragments.back().color[3] = 0.5; },
      [](Rendering& r) { r.fragments.back().has_depth = false; },
      [](Rendering& r) { r.fragments.back().has_color = false; },
      [](Rendering& r) { r.fragments.back().detail = 0; },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Rendering other = exact;
    changes[i](other);
    EXPECT_FALSE(has_exact_values(scene, {}, exact, other)) << i;
  }
}

// 0 is not -0 here: comparing decides what that means.
TEST(EqualValues, AreEqualToTheBit) {
  const auto [scene, exact] = with_depths();
  Rendering zero = exact;
  zero.fragments.back().color[0] = 0.0;
  Rendering negative = zero;
  negative.fragments.back().color[0] = -0.0;
  EXPECT_TRUE(has_exact_values(scene, {}, zero, zero));
  EXPECT_FALSE(has_exact_values(scene, {}, zero, negative));
}

TEST(EqualValues, AreSaidOnlyOfPlainScenesDrawnByOpenGLsOwnChoices) {
  const auto [scene, exact] = with_depths();
  Policy own;
  own.rules["triangle.fill-rule"] = "left-bottom";
  EXPECT_FALSE(has_exact_values(scene, own, exact, exact));
  Policy of_surface;
  of_surface.surfaces[Surface::fbo]["triangle.fill-rule"] = "left-bottom";
  EXPECT_FALSE(has_exact_values(scene, of_surface, exact, exact));
  const std::vector<std::function<void(Scene&)>> changes = {
      [](Scene& s) { s.target.samples = 4; },
      [](Scene& s) { s.supersampling.resize(4); },
      [](Scene& s) { s.textures.emplace_back(); },
      [](Scene& s) { s.draws.front().polygon_offset.emplace(); },
      [](Scene& s) { s.draws.front().operations.blending.emplace(); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    Scene other = scene;
    changes[i](other);
    EXPECT_FALSE(has_exact_values(other, {}, exact, exact)) << i;
  }
}

}  // namespace
}  // namespace edgecase
