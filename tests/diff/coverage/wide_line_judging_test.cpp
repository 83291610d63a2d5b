// SPDX-License-Identifier: MIT
//
// What is judged of wide lines beside their width: attributes (rulings 13 and 46), and a cut at the
// sides of the viewport (ruling 54), which points know, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/multisampled_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Scene slanted_line(int width, int samples = 1) {
  Scene scene =
      multisampled_scene(16, samples, Primitive::lines, {at(2.25, 6.5), at(13.75, 10.25)});
  Draw& draw = scene.draws.front();
  draw.interpolation = Interpolation::smooth;
  draw.line_width = Fixed::from_integer(width);
  draw.multisampling.enabled = false;
  draw.vertices[0].color = {0, 0, 0, 1};
  draw.vertices[1].color = {1, 0, 0, 1};
  return scene;
}

// Every fragment with the colour of a place so many pixels above its own centre.
Rendering with_colors_above(const Scene& scene, double pixels, bool reports_colors = true) {
  Rendering rendering = rasterize(scene, {});
  const ScenePrimitive line = primitives_of(scene).front();
  const PrimitiveAttributes attributes =
      attributes_of(line, resolve({}, Surface::fbo), scene.target);
  for (Fragment& f : rendering.fragments) {
    const Point centre = pixel_centre(f.x, f.y);
    const Point place{centre.x, centre.y + at(0, pixels).y};
    const double red = to_float(middle(color_exact(attributes, 0, place, {f.x, f.y})));
    f.color[0] = red;
    f.has_color = reports_colors;
    for (std::size_t s = 0; s < static_cast<std::size_t>(scene.target.samples); ++s) {
      const std::size_t index = 4 * rendering.sample_index(f.x, f.y, static_cast<int>(s));
      (scene.target.samples > 1 ? rendering.sample_pixels : rendering.pixels)[index] =
          to_unorm8(red);
    }
  }
  if (scene.target.samples > 1) rendering.pixels.clear();
  return rendering;
}

TEST(WideLineJudging, ValuesOfEachOwnCentreArePermitted) {
  for (const int samples : {1, 4})
    for (const bool reported : {true, false}) {
      const Scene scene = slanted_line(5, samples);
      EXPECT_LE(judged(scene, rasterize(scene, {})).verdict, Verdict::permitted);
      const Result own = judged(scene, with_colors_above(scene, 0, reported));
      EXPECT_EQ(broken_rulings(own), std::set<int>{}) << samples << reported;
      EXPECT_EQ(own.verdict, Verdict::permitted) << samples << reported;
    }
}

TEST(WideLineJudging, ValuesOfTheWholeColumnAreReplicatedOnesWithoutMultisamplingToo) {
  const Scene scene = slanted_line(5, 4);
  const Rendering exact = rasterize(scene, {});
  const Fragment& middle_one = exact.fragments[exact.fragments.size() / 2];
  int alike = 0;
  for (const Fragment& f : exact.fragments)
    if (f.x == middle_one.x && f.color == middle_one.color) ++alike;
  EXPECT_EQ(alike, 5);
}

// Farther away than half a column no method leads; up to a whole one it is contested.
TEST(WideLineJudging, ValuesOfOtherFragmentsOfTheColumnAreContested) {
  const Scene scene = slanted_line(5);
  EXPECT_EQ(broken_rulings(judged(scene, with_colors_above(scene, 1.9))), std::set<int>{});
  EXPECT_EQ(broken_rulings(judged(scene, with_colors_above(scene, 3.5))), std::set<int>{46});
  const std::set<int> far = broken_rulings(judged(scene, with_colors_above(scene, 6)));
  EXPECT_TRUE(far.contains(9));
}

// A target of which the viewport is the left or lower half.
Scene half_seen(Primitive primitive, std::vector<Point> positions, bool left) {
  Scene scene = blank_scene(16, 16);
  scene.viewport = left ? Viewport{0, 0, 8, 16} : Viewport{0, 0, 16, 8};
  Draw draw = make_draw(primitive, positions);
  draw.point_size = draw.line_width = Fixed::from_integer(3);
  scene.draws = {draw};
  return scene;
}

template <class Predicate>
Rendering without(const Scene& scene, const Predicate& is_left_out) {
  std::vector<Fragment> fragments = rasterize(scene, {}).fragments;
  std::erase_if(fragments, is_left_out);
  return compose(scene, fragments);
}

TEST(WideLineJudging, PointsThatAreCutAtTheViewportBreakARulingOfTheirOwn) {
  const Scene scene = half_seen(Primitive::points, {at(7.25, 5.5)}, true);
  EXPECT_EQ(judged(scene, rasterize(scene, {})).verdict, Verdict::agree);
  const Result cut = judged(scene, without(scene, [](const Fragment& f) { return f.x >= 8; }));
  EXPECT_EQ(broken_rulings(cut), std::set<int>{54});
  EXPECT_EQ(cut.verdict, Verdict::contested);
  const Result torn = judged(scene, without(scene, [](const Fragment& f) { return f.x == 7; }));
  EXPECT_EQ(broken_rulings(torn), std::set<int>{6});
  EXPECT_EQ(torn.verdict, Verdict::violation);
}

TEST(WideLineJudging, LinesThatAreCutAtTheViewportBreakARulingOfTheirOwn) {
  const Scene scene = half_seen(Primitive::lines, {at(2.5, 7.25), at(13.5, 7.25)}, false);
  EXPECT_EQ(judged(scene, rasterize(scene, {})).verdict, Verdict::agree);
  const Result cut = judged(scene, without(scene, [](const Fragment& f) { return f.y >= 8; }));
  EXPECT_EQ(broken_rulings(cut), std::set<int>{54});
  EXPECT_EQ(cut.verdict, Verdict::contested);
  const Result torn = judged(scene, without(scene, [](const Fragment& f) { return f.y == 7; }));
  EXPECT_EQ(torn.verdict, Verdict::violation);
}

}  // namespace
}  // namespace edgecase
