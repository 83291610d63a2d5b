// SPDX-License-Identifier: MIT
//
// Exact held against itself agrees, whatever the scene, the policy and the bits that are reported.
#include <gtest/gtest.h>

#include "diff/compare.h"
#include "diff/judge.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"

namespace edgecase {
namespace {

void expect_agreement(const Scene& scene, const Policy& policy, const Rendering& rendered,
                      int bits) {
  Result result = compare(scene, policy, rasterize(scene, policy), rendered, {bits});
  Result* const results[] = {&result};
  judge(results, Latitude::opengl);
  ASSERT_EQ(result.verdict, Verdict::agree);
  judge(results, Latitude::none);
  ASSERT_EQ(result.verdict, Verdict::agree);
  ASSERT_TRUE(result.disagreements.empty() && result.values.empty() && result.evidence.empty());
  ASSERT_TRUE(result.fingerprint.empty());
  const std::size_t pixels = rendered.pixels.size() / 4;
  ASSERT_EQ(result.pixel_counts, (PixelCounts{{pixels, 0, 0, 0, 0}, pixels}));
}

TEST(SelfAgreement, OfRandomScenes) {
  RandomScenes scenes(11);
  std::size_t primitives = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::int64_t step = i % 3 == 0 ? Fixed::kOne / 2 : i % 3 == 1 ? Fixed::kOne / 16 : 1;
    const Scene scene = scenes.next({12, step, 4, true});
    expect_agreement(scene, {}, rasterize(scene, {}), i % 17);
    if (HasFatalFailure()) FAIL() << "scene " << i;
    primitives += primitives_of(scene).size();
  }
  EXPECT_GT(primitives, 8000u);
}

TEST(SelfAgreement, UnderEveryTieOrderAndSnap) {
  RandomScenes scenes(12);
  for (const char* rule :
       {"triangle.fill-rule", "line.diamond-exit", "point.ownership", "subpixel.snap", "line.snap"})
    for (const Alternative& alternative : find_rule(rule)->alternatives)
      for (int i = 0; i < 20; ++i) {
        Policy policy;
        policy.rules[rule] = alternative.name;
        const Scene scene = scenes.next({12, Fixed::kOne / 4 + i % 2, 3, true});
        expect_agreement(scene, policy, rasterize(scene, policy), 8);
        if (HasFatalFailure()) FAIL() << rule << "=" << alternative.name;
      }
}

// A renderer answers in float32, and may keep colours and depths of fragments to itself.
TEST(SelfAgreement, OfFloatsAndOfFragmentsThatTellNoValues) {
  for (const NamedScene& one : named_scenes()) {
    Rendering floats = rasterize(one.scene, {});
    for (Fragment& f : floats.fragments) {
      f.depth = static_cast<double>(static_cast<float>(f.depth));
      for (double& c : f.color) c = static_cast<double>(static_cast<float>(c));
    }
    expect_agreement(one.scene, {}, floats, 8);
    if (HasFatalFailure()) FAIL() << one.name;
    Rendering silent = floats;
    for (Fragment& f : silent.fragments) f.has_color = f.has_depth = false;
    expect_agreement(one.scene, {}, silent, 8);
    if (HasFatalFailure()) FAIL() << one.name << ", silent";
  }
}

}  // namespace
}  // namespace edgecase
