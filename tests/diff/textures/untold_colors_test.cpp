// SPDX-License-Identifier: MIT
//
// Who tells no colours of textured fragments is judged by the picture: what it stores must be what
// the lookup may yield.
#include "diff/textures/untold_colors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "raster/rasterizer.h"
#include "tests/diff/textures/texture_judging.h"

namespace edgecase {
namespace {

Rendering without_colors(Rendering rendering) {
  for (Fragment& f : rendering.fragments) f.has_color = false;
  return rendering;
}

TEST(UntoldColors, ThatAreRightAgree) {
  for (const TexturedScene& textured : judged_textures()) {
    SCOPED_TRACE(textured.name);
    const Result result =
        judge_textures(textured.scene, without_colors(rasterize(textured.scene, {})));
    EXPECT_EQ(result.verdict, Verdict::agree);
  }
}

// Black, white, and the codes exchanged with their complements.
TEST(UntoldColors, OfAWrongPictureNeverAgree) {
  std::size_t violations = 0;
  std::size_t all = 0;
  for (const TexturedScene& textured : judged_textures()) {
    const Rendering right = without_colors(rasterize(textured.scene, {}));
    for (const int mask : {0x000, 0x0ff, 0x1ff}) {
      Rendering wrong = right;
      for (std::uint8_t& code : wrong.pixels)
        code = static_cast<std::uint8_t>(mask < 0x100 ? mask : 255 - code);
      if (wrong.pixels == right.pixels) continue;
      SCOPED_TRACE(textured.name + ", " + std::to_string(mask));
      const Result result = judge_textures(textured.scene, wrong);
      EXPECT_NE(result.verdict, Verdict::agree);
      ++all;
      violations += result.verdict == Verdict::violation ? 1 : 0;
    }
  }
  EXPECT_GT(all, 20u);
  EXPECT_GT(violations, all / 2) << "of " << all;
}

// One texel of red: nothing but red may be looked up, and the sentence says so.
TEST(UntoldColors, AreTheTexelsOfATextureOfOneColour) {
  Scene scene = textures_named("floor");
  scene.details = {};
  Texture texture = *scene.textures[0];
  for (TextureLevel& level : texture.levels)
    for (std::size_t i = 0; i < level.texels.size(); ++i)
      level.texels[i] = i % 4 == 0 || i % 4 == 3 ? 1.0F : 0.0F;
  scene.textures[0] = std::make_shared<const Texture>(texture);
  Rendering black = without_colors(rasterize(scene, {}));
  const Fragment first = black.fragments.front();
  black.pixels[4 * black.pixel_index(first.x, first.y)] = 0;
  const Result result = judge_textures(scene, black);
  EXPECT_EQ(result.verdict, Verdict::violation);
  ASSERT_EQ(result.disagreements.size(), 1u);
  EXPECT_EQ(result.disagreements[0].rule, RuleId::framebuffer_unorm8);
  EXPECT_NE(result.disagreements[0].explanation.find("does not tell its colour"),
            std::string::npos);
  EXPECT_EQ(result.disagreements[0].exact[0], 255);
}

}  // namespace
}  // namespace edgecase
