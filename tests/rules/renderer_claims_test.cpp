// SPDX-License-Identifier: MIT
#include "rules/renderer_claims.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>

namespace edgecase {
namespace {

RendererInfo renderer_with(std::map<std::string, std::string> traits) {
  RendererInfo info;
  info.subpixel_bits = 8;
  info.traits = std::move(traits);
  return info;
}

TEST(RendererClaims, TellOpenGlEsByItsApi) {
  EXPECT_FALSE(claims_of(renderer_with({})).lookups.is_es);
  EXPECT_FALSE(claims_of(renderer_with({{"api", "OpenGL"}})).lookups.is_es);
  EXPECT_TRUE(claims_of(renderer_with({{"api", "OpenGL ES"}})).lookups.is_es);
}

TEST(RendererClaims, HaveStepsAboveZero) {
  const RendererClaims claims = claims_of(renderer_with({{"point_size_steps", "1 by 0.125"}}));
  EXPECT_EQ(claims.sizes.points.step, 0.125);
  EXPECT_TRUE(claims.refused.empty());
  for (const char* steps : {"1 by 0", "1 by -1", "-1 by 1", "2 by 1", "1"}) {
    const RendererClaims wrong = claims_of(renderer_with({{"point_size_steps", steps}}));
    EXPECT_EQ(wrong.refused.size(), 1u) << steps;
    EXPECT_EQ(wrong.sizes.points.step, 0) << steps;
  }
}

}  // namespace
}  // namespace edgecase
