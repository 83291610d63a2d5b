// SPDX-License-Identifier: MIT
//
// Dithering, which is disabled (17.3.8): two codes for one colour are a violation, either one
// everywhere is not, and neither are two codes for two colours.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "raster/rasterizer.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr float kHalf = 0.5F;  // 127.5 of 255
const Color kGrey = {kHalf, kHalf, kHalf, 1};

// A quad of two draws of one triangle each.
Scene quad(const Color& color) {
  Scene scene = blank_scene(8, 8);
  scene.target.clear = {kHalf, 0, 0, 1};
  scene.draws = {make_draw(Primitive::triangles, std::vector{at(1, 1), at(7, 1), at(1, 7)}),
                 make_draw(Primitive::triangles, std::vector{at(7, 1), at(7, 7), at(1, 7)})};
  for (Draw& draw : scene.draws)
    for (Vertex& vertex : draw.vertices) vertex.color = color;
  return scene;
}

// Red is stored as `code` wherever `where` holds.
template <class Where>
Result with_red(const Scene& scene, int code, const Where& where) {
  Rendering rendering = rasterize(scene, {});
  for (int y = 0; y < rendering.height; ++y)
    for (int x = 0; x < rendering.width; ++x)
      if (where(x, y))
        rendering.pixels[4 * rendering.pixel_index(x, y)] = static_cast<std::uint8_t>(code);
  return judged(scene, rendering);
}

bool is_in_quad(int x, int y) {
  return x >= 1 && x < 7 && y >= 1 && y < 7;
}

// The code next to the half that exact does not store.
int other_code() {
  return 255 - to_unorm8(kHalf);
}

TEST(Dithering, IsAViolation) {
  const Result result = with_red(quad(kGrey), other_code(),
                                 [](int x, int y) { return is_in_quad(x, y) && (x + y) % 2 == 0; });
  EXPECT_EQ(result.verdict, Verdict::violation);
  EXPECT_EQ(broken_rulings(result), std::set<int>{10});
}

TEST(Dithering, OfASinglePixelIsAViolation) {
  const Result result =
      with_red(quad(kGrey), other_code(), [](int x, int y) { return x == 3 && y == 2; });
  EXPECT_EQ(result.verdict, Verdict::violation);
}

TEST(Dithering, OfTheClearColorIsAViolation) {
  const Result result =
      with_red(quad(kGrey), other_code(), [](int x, int y) { return x == 0 && y % 2 == 0; });
  EXPECT_EQ(result.verdict, Verdict::violation);
}

TEST(Dithering, IsNotTheOtherCodeThroughout) {
  const Scene scene = quad(kGrey);
  EXPECT_EQ(with_red(scene, other_code(), is_in_quad).verdict, Verdict::permitted);
  const auto outside = [](int x, int y) { return !is_in_quad(x, y); };
  EXPECT_EQ(with_red(scene, other_code(), outside).verdict, Verdict::permitted);
}

// Equal as they are reported, smooth colours may have differed before.
TEST(Dithering, IsNotJudgedOfSmoothColors) {
  Scene scene = quad(kGrey);
  for (Draw& draw : scene.draws) draw.interpolation = Interpolation::smooth;
  const Result result =
      with_red(scene, other_code(), [](int x, int y) { return x == 3 && y == 2; });
  EXPECT_EQ(result.verdict, Verdict::permitted);
}

TEST(Dithering, IsNotTwoCodesForTwoColors) {
  Scene scene = quad(kGrey);
  for (Vertex& vertex : scene.draws[1].vertices) vertex.color[0] = kHalf + 0.001F;
  // The first draw's colour is stored below, the second's above.
  Rendering rendering = rasterize(scene, {});
  for (const Fragment& f : rendering.fragments)
    rendering.pixels[4 * rendering.pixel_index(f.x, f.y)] = f.primitive == 0 ? 127 : 128;
  EXPECT_NE(judged(scene, rendering).verdict, Verdict::violation);
}

}  // namespace
}  // namespace edgecase
