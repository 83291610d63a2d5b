// SPDX-License-Identifier: MIT
//
// The OpenGL side against real OpenGL: what every conforming implementation must draw.
#include <gmock/gmock.h>

#include <map>
#include <optional>

#include "tests/reference/opengl_test.h"

namespace edgecase {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr const char* kRectangle =
    "........\n"
    "........\n"
    "........\n"
    ".####...\n"
    ".####...\n"
    ".####...\n"
    "........\n"
    "........\n";

// Columns 1 to 4, rows 2 to 4: no edge and not the diagonal touches a pixel's centre.
Draw known_rectangle(Color color = {1, 1, 1, 1}) {
  return rectangle(256 + 64, 256 + 192, 5 * 256 + 64, 4 * 256 + 192, color);
}

class SceneRendererTest : public OpenGlTest {};

TEST_P(SceneRendererTest, DrawsAKnownRectangle) {
  Scene scene = blank(8, 8);
  scene.draws = {known_rectangle({1, 0.2f, 0, 1})};
  const Rendering rendering = render(renderer(), scene);
  EXPECT_EQ(coverage(rendering), kRectangle);
  EXPECT_THAT(pixel(rendering, 1, 2), ElementsAre(255, 51, 0, 255));
  EXPECT_THAT(pixel(rendering, 4, 4), ElementsAre(255, 51, 0, 255));
  EXPECT_THAT(pixel(rendering, 5, 4), ElementsAre(0, 0, 0, 255));
  ASSERT_EQ(rendering.fragments.size(), 12u);
  EXPECT_EQ(rendering.fragments[0].depth, 0.5);
  EXPECT_EQ(rendering.fragments[0].color[1], static_cast<double>(0.2f));
}

TEST_P(SceneRendererTest, ClearsToTheClearColour) {
  Scene scene = blank(3, 2);
  scene.target.clear = {0.2f, 0.4f, 0.6f, 0.8f};
  const Rendering rendering = render(renderer(), scene);
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 2; ++y) EXPECT_THAT(pixel(rendering, x, y), ElementsAre(51, 102, 153, 204));
  EXPECT_EQ(rendering.hits, std::vector<std::uint32_t>(6, 0));
}

TEST_P(SceneRendererTest, TakesAViewportLargerThanTheTarget) {
  Scene scene = blank(8, 8);
  scene.viewport = {0, 0, 64, 32};
  scene.draws = {known_rectangle(), rectangle(7 * 256, 7 * 256, 60 * 256, 30 * 256)};
  std::string expected = kRectangle;
  expected[7] = '#';
  EXPECT_EQ(coverage(render(renderer(), scene)), expected);
}

TEST_P(SceneRendererTest, TakesAViewportWithNegativeOrigin) {
  Scene scene = blank(8, 8);
  scene.viewport = {-24, -8, 64, 32};
  scene.draws = {known_rectangle(), rectangle(-20 * 256, -6 * 256, 256, 256)};
  std::string expected = kRectangle;
  expected[7 * 9] = '#';
  EXPECT_EQ(coverage(render(renderer(), scene)), expected);
}

TEST_P(SceneRendererTest, HitCountsEqualTheCapture) {
  Scene scene = blank(8, 8);
  scene.draws = {known_rectangle(), known_rectangle(), known_rectangle()};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.hits.size(), 64u);
  EXPECT_EQ(rendering.hits[rendering.pixel_index(2, 3)], 3u);
  EXPECT_EQ(rendering.hits[rendering.pixel_index(0, 0)], 0u);
  EXPECT_EQ(rendering.fragments.size(), 36u);
}

TEST_P(SceneRendererTest, CoverageAloneIsTheSameCoverage) {
  Scene scene = blank(8, 8);
  scene.draws = {known_rectangle(),
                 make_draw(Primitive::triangles, {{100, 50}, {1900, 400}, {700, 1800}}),
                 make_draw(Primitive::line_strip, {{30, 30}, {1500, 700}, {900, 1700}}),
                 make_draw(Primitive::points, {{640, 640}})};
  const Rendering whole = render(renderer(), scene);
  const Task task{"test", &scene, true};
  std::optional<Outcome> outcome;
  renderer().render({&task, 1}, [&](std::size_t, Outcome got) { outcome = std::move(got); });
  ASSERT_TRUE(outcome && std::holds_alternative<Rendering>(*outcome));
  const Rendering& coverage_alone = std::get<Rendering>(*outcome);
  EXPECT_TRUE(coverage_alone.pixels.empty());
  ASSERT_EQ(coverage_alone.fragments.size(), whole.fragments.size());
  for (std::size_t i = 0; i < whole.fragments.size(); ++i) {
    const Fragment& fragment = coverage_alone.fragments[i];
    EXPECT_FALSE(precedes(fragment, whole.fragments[i]) || precedes(whole.fragments[i], fragment));
    EXPECT_FALSE(fragment.has_depth || fragment.has_color);
  }
  // Nor does the pass that was left out leave anything to the next scene.
  EXPECT_EQ(render(renderer(), scene).pixels, whole.pixels);
}

TEST_P(SceneRendererTest, NumbersPrimitivesOverAllDraws) {
  Scene scene = blank(8, 2);
  const auto point = [](int column) {
    return make_draw(Primitive::points, {{column * 256 + 128, 128}});
  };
  scene.draws = {point(1), make_draw(Primitive::points, {{2 * 256 + 128, 128}, {640 + 256, 128}}),
                 rectangle(5 * 256 + 64, 64, 6 * 256 + 64, 256), point(7)};
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(coverage(rendering), "........\n.###.#.#\n");
  EXPECT_EQ(rendering.fragments[0].primitive, 0);
  EXPECT_EQ(rendering.fragments[1].primitive, 1);
  EXPECT_EQ(rendering.fragments[2].primitive, 2);
  EXPECT_EQ(rendering.fragments[4].primitive, 5);
}

TEST_P(SceneRendererTest, ObeysTheProvokingVertex) {
  for (ProvokingVertex which : {ProvokingVertex::first, ProvokingVertex::last}) {
    Scene scene = blank(8, 8);
    scene.draws = {known_rectangle()};
    scene.draws[0].provoking_vertex = which;
    scene.draws[0].vertices[0].color = {1, 0, 0, 1};
    scene.draws[0].vertices[2].color = {0, 1, 0, 1};
    const Rendering rendering = render(renderer(), scene);
    const int red = which == ProvokingVertex::first ? 255 : 0;
    EXPECT_THAT(pixel(rendering, 4, 2), ElementsAre(red, 255 - red, 0, 255));
  }
}

TEST_P(SceneRendererTest, InterpolatesColoursAndDepth) {
  Scene scene = blank(8, 1);
  scene.draws = {rectangle(0, 0, 8 * 256, 256)};
  scene.draws[0].interpolation = Interpolation::smooth;
  for (Vertex& vertex : scene.draws[0].vertices) {
    const bool right = vertex.position.x.raw() > 0;
    vertex.color = {right ? 1.0f : 0.0f, 0, 0, 1};
    vertex.z = Fixed::from_integer(right ? 1 : -1);
  }
  const Rendering rendering = render(renderer(), scene);
  ASSERT_EQ(rendering.fragments.size(), 8u);
  for (const Fragment& fragment : rendering.fragments) {
    const double across = (fragment.x + 0.5) / 8;
    EXPECT_NEAR(fragment.color[0], across, 1e-5);
    EXPECT_NEAR(fragment.depth, across, 1e-5);
  }
}

TEST_P(SceneRendererTest, LeaksNothingIntoTheNextScene) {
  Scene empty = blank(8, 8);
  Scene drawn = blank(8, 8);
  drawn.draws = {known_rectangle()};
  const Rendering before = render(renderer(), empty);
  render(renderer(), drawn);
  const Rendering after = render(renderer(), empty);
  EXPECT_EQ(after.pixels, before.pixels);
  EXPECT_EQ(after.hits, before.hits);
  EXPECT_TRUE(after.fragments.empty());
}

TEST_P(SceneRendererTest, CapturesMoreFragmentsThanItFirstHasRoomFor) {
  Scene scene = blank(128, 128);
  scene.draws = {rectangle(0, 0, 128 * 256, 128 * 256), rectangle(0, 0, 128 * 256, 128 * 256)};
  const Rendering rendering = render(renderer(), scene);
  EXPECT_EQ(rendering.fragments.size(), 2u * 128 * 128);
}

TEST_P(SceneRendererTest, ManySizesOneAfterTheOther) {
  for (int size = 1; size <= 40; ++size) {
    Scene scene = blank(size, 41 - size);
    scene.viewport = {0, 0, 64, 64};
    scene.draws = {rectangle(0, 0, 50 * 256, 50 * 256)};
    const Rendering rendering = render(renderer(), scene);
    EXPECT_EQ(rendering.fragments.size(), static_cast<std::size_t>(size * (41 - size)));
  }
}

TEST_P(SceneRendererTest, SaysWhoItIs) {
  const RendererInfo info = renderer().info();
  EXPECT_EQ(info.name, name());
  EXPECT_FALSE(info.vendor.empty());
  EXPECT_FALSE(info.version.empty());
  EXPECT_GE(info.subpixel_bits, 4);
  EXPECT_EQ(info.traits.at("capture"), "ssbo");
  EXPECT_THAT(info.traits.at("derivatives"), StartsWith("plain"));
  const std::string driver = name().substr(name().find(':') + 1);
  const std::map<std::string, std::string> over = {{"zink", "zink (llvmpipe"},
                                                   {"zink-swiftshader", "zink (SwiftShader"}};
  const auto found = over.find(driver);
  if (!driver.starts_with("device")) {
    EXPECT_THAT(info.device, StartsWith(found == over.end() ? driver : found->second));
  }
  EXPECT_EQ(info.traits.contains("stack"), found != over.end());
  EXPECT_EQ(info.traits.at("provoking_vertices"), "first last");
}

INSTANTIATE_TEST_SUITE_P(OpenGl, SceneRendererTest, EDGECASE_ALL_PLACES, place_name);

// Two drivers under one name would make a suite compare a driver with itself.
class DriversTest : public ::testing::TestWithParam<std::string> {};

TEST_P(DriversTest, LlvmpipeAndSoftpipeAreDifferentProgramsAtWork) {
  Scene scene = blank_scene(8, 8);
  // Its third edge passes through the centres of five pixels.
  scene.draws = {make_draw(Primitive::triangles, {{384, 384}, {1664, 640}, {640, 1664}})};
  Renderer& llvmpipe = shared_renderer(GetParam() + ":llvmpipe");
  Renderer& softpipe = shared_renderer(GetParam() + ":softpipe");
  const Outcome first = render_outcome(llvmpipe, scene);
  const Outcome second = render_outcome(softpipe, scene);
  if (const auto* failure = std::get_if<Failure>(&first);
      failure != nullptr && failure->reason.find("cannot be opened") != std::string::npos)
    GTEST_SKIP() << failure->reason;
  ASSERT_TRUE(std::holds_alternative<Rendering>(first));
  ASSERT_TRUE(std::holds_alternative<Rendering>(second));
  EXPECT_THAT(llvmpipe.info().device, HasSubstr("llvmpipe"));
  EXPECT_THAT(softpipe.info().device, HasSubstr("softpipe"));
  EXPECT_NE(coverage(std::get<Rendering>(first)), coverage(std::get<Rendering>(second)));
}

// 16 steps to a pixel against 256: what snapping makes of a corner tells the two apart.
TEST(ZinkTest, LavapipeAndSwiftShaderAreDifferentProgramsAtWork) {
  Scene scene = blank_scene(8, 8);
  // A sliver above a row of centres, thinner than half a step of the coarser grid.
  scene.draws = {make_draw(Primitive::triangles, {{128, 640}, {1920, 640 + 6}, {128, 640 - 6}})};
  const Outcome first = render_outcome(shared_renderer("egl:zink"), scene);
  const Outcome second = render_outcome(shared_renderer("egl:zink-swiftshader"), scene);
  for (const Outcome* outcome : {&first, &second})
    if (const auto* failure = std::get_if<Failure>(outcome);
        failure != nullptr && is_lacking("egl:zink-swiftshader", *failure))
      GTEST_SKIP() << failure->reason;
  ASSERT_TRUE(std::holds_alternative<Rendering>(first));
  ASSERT_TRUE(std::holds_alternative<Rendering>(second));
  EXPECT_NE(coverage(std::get<Rendering>(first)), coverage(std::get<Rendering>(second)));
}

INSTANTIATE_TEST_SUITE_P(OpenGl, DriversTest, ::testing::Values("osmesa", "egl"));

}  // namespace
}  // namespace edgecase
