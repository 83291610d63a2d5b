// SPDX-License-Identifier: MIT
//
// Supersampled scenes on real OpenGL: what is drawn of each pass, and what becomes of them all.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>

#include "tests/reference/example.h"
#include "tests/reference/opengl_test.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// In quarters of a pixel.
ShadingPass shaded_at(int x, int y, std::int64_t weight = 1) {
  return {{Fixed::from_raw(x * (Fixed::kOne / 4)), Fixed::from_raw(y * (Fixed::kOne / 4))}, weight};
}

std::vector<double> accumulated_at(const Rendering& rendering, int x, int y) {
  const auto first =
      rendering.accumulated.begin() + static_cast<std::ptrdiff_t>(4 * rendering.pixel_index(x, y));
  return {first, first + 4};
}

std::string reason_of(const Outcome& outcome) {
  const auto* failure = std::get_if<Failure>(&outcome);
  if (failure == nullptr) return "drawn";
  EXPECT_EQ(failure->kind, FailureKind::unsupported);
  return failure->reason;
}

class SupersamplingTest : public OpenGlTest {
 protected:
  // Nothing on a surface that cannot have it, which must say so.
  std::optional<Rendering> drawn(const Scene& scene) {
    if (scene.target.surface == Surface::fbo) return render(renderer(), scene);
    EXPECT_EQ(reason_of(render_outcome(renderer(), scene)),
              "passes cannot be accumulated in a window: its colours have 8 bits");
    return std::nullopt;
  }

  // A pass must be what the scene itself would be, to the bit.
  void expect_same(const Rendering& pass, const Rendering& alone) {
    EXPECT_EQ(pass.pixels, alone.pixels);
    EXPECT_EQ(pass.hits, alone.hits);
    EXPECT_EQ(pass.depths, alone.depths);
    EXPECT_EQ(pass.mip_chains.size(), alone.mip_chains.size());
    ASSERT_EQ(pass.fragments.size(), alone.fragments.size());
    for (std::size_t i = 0; i < pass.fragments.size(); ++i) {
      const Fragment& a = pass.fragments[i];
      const Fragment& b = alone.fragments[i];
      EXPECT_EQ(std::tie(a.x, a.y, a.primitive, a.depth, a.color),
                std::tie(b.x, b.y, b.primitive, b.depth, b.color));
    }
  }

  Scene smooth_triangle() {
    Scene scene = blank(8, 8);
    scene.draws = {make_draw(Primitive::triangles, {{300, 200}, {1900, 500}, {700, 1800}})};
    scene.draws[0].interpolation = Interpolation::smooth;
    scene.draws[0].vertices[0].color = {4, -1, 0.1F, 1};
    scene.draws[0].vertices[1].color = {0, 2, 0.2F, 1};
    scene.draws[0].vertices[2].color = {1, 1, 0.3F, 0.5F};
    return scene;
  }
};

TEST_P(SupersamplingTest, APassIsWhatItsSceneIs) {
  Scene scene = smooth_triangle();
  scene.details.coordinates = true;
  scene.target.depth = DepthFormat::depth32f;
  if (scene.target.surface == Surface::window) scene.target.depth = DepthFormat::none;
  scene.supersampling = {shaded_at(1, 3), shaded_at(2, 2, 5), shaded_at(-4, 8)};
  const auto rendering = drawn(scene);
  if (!rendering) return;
  EXPECT_THAT(rendering->fragments, IsEmpty());
  EXPECT_THAT(rendering->hits, IsEmpty());
  ASSERT_THAT(rendering->passes, SizeIs(3));
  for (std::size_t k = 0; k < 3; ++k) {
    expect_same(rendering->passes[k], render(renderer(), pass_of(scene, k)));
    EXPECT_FALSE(rendering->passes[k].fragments.empty());
    EXPECT_THAT(rendering->passes[k].details, SizeIs(rendering->passes[k].fragments.size()));
    EXPECT_THAT(rendering->passes[k].depths, SizeIs(64));
  }
}

TEST_P(SupersamplingTest, WeighsNeitherClampsNorRounds) {
  Scene scene = blank(2, 1);
  scene.target.clear = {0.25F, 0.5F, 0.125F, 1};
  // Of pixel 0, the left half: two of the four places, 3 of 8 by weight.
  scene.draws = {rectangle(0, 0, 128, 256, {9, -3, 0.0625F, 0.5F})};
  scene.supersampling = {shaded_at(1, 2, 1), shaded_at(3, 2, 4), shaded_at(1, 3, 2),
                         shaded_at(3, 3, 1)};
  const auto rendering = drawn(scene);
  if (!rendering) return;
  EXPECT_THAT(accumulated_at(*rendering, 0, 0),
              ElementsAre((27 + 1.25) / 8, (-9 + 2.5) / 8, (0.1875 + 0.625) / 8, 6.5 / 8));
  EXPECT_THAT(accumulated_at(*rendering, 1, 0), ElementsAre(0.25, 0.5, 0.125, 1));
  // 0.1015625 is 25.898 of 255, 0.8125 is 207.1875; and clamped at last.
  EXPECT_THAT(pixel(*rendering, 0, 0), ElementsAre(255, 0, 26, 207));
}

TEST_P(SupersamplingTest, OnePassIsItsOwnMean) {
  Scene scene = smooth_triangle();
  scene.supersampling = {shaded_at(2, 2, 1 << 20)};
  const auto rendering = drawn(scene);
  if (!rendering) return;
  const Rendering& pass = rendering->passes.at(0);
  EXPECT_EQ(rendering->pixels, pass.pixels);
  for (const Fragment& fragment : pass.fragments)
    EXPECT_THAT(
        accumulated_at(*rendering, fragment.x, fragment.y),
        ElementsAre(fragment.color[0], fragment.color[1], fragment.color[2], fragment.color[3]));
}

// Scissor and depth test are those of the draws, never of what adds the passes up; and nothing is
// left for the scene after.
TEST_P(SupersamplingTest, LeavesNoStateBehind) {
  Scene scene = blank(6, 6);
  scene.target.clear = {0, 0, 0.5F, 1};
  scene.draws = {rectangle(0, 0, 6 * 256, 6 * 256, {1, 0, 0, 1}),
                 rectangle(0, 0, 6 * 256, 6 * 256, {0, 1, 0, 1})};
  scene.draws[0].scissor = Viewport{1, 1, 3, 3};
  scene.draws[1].scissor = Viewport{5, 5, 1, 1};
  const Rendering before = render(renderer(), scene);
  Scene supersampled = scene;
  supersampled.supersampling = {shaded_at(2, 2), shaded_at(2, 2, 3)};
  const auto rendering = drawn(supersampled);
  if (!rendering) return;
  EXPECT_EQ(rendering->pixels, before.pixels);
  EXPECT_THAT(accumulated_at(*rendering, 0, 0), ElementsAre(0, 0, 0.5, 1));
  EXPECT_THAT(accumulated_at(*rendering, 1, 1), ElementsAre(1, 0, 0, 1));
  EXPECT_THAT(accumulated_at(*rendering, 5, 5), ElementsAre(0, 1, 0, 1));
  expect_same(render(renderer(), scene), before);
}

TEST_P(SupersamplingTest, AThousandPassesAddUp) {
  Scene scene = blank(1, 1);
  scene.target.clear = {0, 0, 0, 1};
  scene.draws = {rectangle(0, 0, 256, 64, {1, 0.5F, 0.25F, 1})};
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 32; ++j)
      scene.supersampling.push_back({{Fixed::from_raw((2 * j + 1) * (Fixed::kOne / 64)),
                                      Fixed::from_raw((2 * i + 1) * (Fixed::kOne / 64))},
                                     1});
  for (int time = 0; time < 3; ++time) {
    const auto rendering = drawn(scene);
    if (!rendering) return;
    ASSERT_THAT(rendering->passes, SizeIs(1024));
    // About a quarter: renderers snap vertices.
    const auto covered = std::ranges::count_if(
        rendering->passes, [](const Rendering& pass) { return !pass.fragments.empty(); });
    EXPECT_NEAR(static_cast<double>(covered), 256, 64);
    const double share = static_cast<double>(covered) / 1024;
    EXPECT_THAT(accumulated_at(*rendering, 0, 0), ElementsAre(share, share / 2, share / 4, 1));
  }
}

TEST_P(SupersamplingTest, DrawsTheSameTwice) {
  Scene scene = smooth_triangle();
  for (int i = 0; i < 9; ++i) scene.supersampling.push_back(shaded_at(i / 3, i % 3, 1 + i * i));
  const auto first = drawn(scene);
  if (!first) return;
  // Another size, and another depth buffer, in between.
  Scene other = blank(3, 5);
  other.target.depth = DepthFormat::depth16;
  other.supersampling = {shaded_at(0, 0)};
  render_outcome(renderer(), other);
  const auto second = drawn(scene);
  EXPECT_EQ(first->accumulated, second->accumulated);
  EXPECT_EQ(first->pixels, second->pixels);
  for (const double value : first->accumulated)
    EXPECT_EQ(value, static_cast<double>(static_cast<float>(value)));
}

TEST_P(SupersamplingTest, TexturesAreLookedUpInEachPass) {
  Scene scene = blank(2, 1);
  auto texture = std::make_shared<Texture>();
  texture->dimensions = 2;
  texture->levels = {{2, 1, {1, 0, 0, 1, 0, 1, 0, 1}}};
  texture->format = TextureFormat::rgba32f;
  scene.textures = {texture};
  Draw draw = rectangle(0, 0, 512, 256);
  for (Vertex& vertex : draw.vertices)
    vertex.texture_coordinates = {vertex.position.x == Fixed() ? 0.0F : 1.0F,
                                  vertex.position.y == Fixed() ? 0.0F : 1.0F};
  draw.interpolation = Interpolation::smooth;
  draw.texture = TextureUse{};
  draw.texture->sampler.magnify = Filter::nearest;
  draw.texture->sampler.minify = Filter::nearest;
  scene.draws = {draw};
  scene.viewport = {-2, -2, 8, 8};
  // The second shades a pixel to the right of the first, where the target's pixel 1 shows nothing.
  scene.target.clear = {0, 0, 1, 0};
  scene.supersampling = {shaded_at(2, 2, 3), shaded_at(6, 2, 1)};
  const auto rendering = drawn(scene);
  if (!rendering) return;
  EXPECT_THAT(accumulated_at(*rendering, 0, 0), ElementsAre(0.75, 0.25, 0, 1));
  EXPECT_THAT(accumulated_at(*rendering, 1, 0), ElementsAre(0, 0.75, 0.25, 0.75));
}

TEST(Supersampling, TheExampleRefusesIt) {
  Scene scene = blank_scene(4, 1);
  scene.draws = {make_draw(Primitive::points, {{384, 128}})};
  scene.supersampling = {shaded_at(2, 2)};
  EXPECT_EQ(reason_of(render_outcome(example(), scene)), "this example draws one pass");
}

INSTANTIATE_TEST_SUITE_P(Renderers, SupersamplingTest, EDGECASE_ALL_PLACES, place_name);

}  // namespace
}  // namespace edgecase
