// SPDX-License-Identifier: MIT
//
// How far values of lines and points may be off: by which axis a diagonal line's go (ruling 46),
// and by what a point's attributes may be divided and multiplied (ruling 9).
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "tests/diff/named_scenes.h"
#include "tests/raster/random_scenes.h"
#include "tests/support/judging.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

Scene line_to(double x, double y) {
  Scene scene = blank_scene(16, 16);
  Draw draw = make_draw(Primitive::lines, std::vector{at(2.25, 2.5), at(x, y)});
  draw.interpolation = Interpolation::smooth;
  draw.vertices[0].color = {0, 0, 0, 1};
  draw.vertices[1].color = {1, 0, 0, 1};
  scene.draws = {draw};
  return scene;
}

// Every fragment with what a line has by a parameter, and so much more of it.
Rendering by_parameter(const Scene& scene, LineParameter parameter, double more = 0) {
  std::vector<Fragment> fragments = rasterize(scene, {}).fragments;
  RuleChoices choices = resolve({}, Surface::fbo);
  choices.values.line_parameter = parameter;
  const PrimitiveAttributes attributes =
      attributes_of(primitives_of(scene).front(), choices, scene.target);
  for (Fragment& f : fragments)
    f.color[0] = to_float(middle(color_exact(attributes, 0, pixel_centre(f.x, f.y), {f.x, f.y})) *
                          (1 + more));
  return compose(scene, fragments);
}

TEST(ValueLatitude, ADiagonalLineMayGoByEitherAxisAndIsContested) {
  const Scene scene = line_to(13.25, 13.5);
  for (const auto parameter : {LineParameter::major_axis, LineParameter::minor_axis}) {
    const Result result = judged(scene, by_parameter(scene, parameter));
    EXPECT_EQ(result.verdict, Verdict::contested);
    EXPECT_EQ(broken_rulings(result), std::set<int>{46});
    for (const Disagreement& d : result.disagreements)
      EXPECT_EQ(d.cause, "attribute.smooth=major-axis") << d.explanation;
    const Result beyond = judged(scene, by_parameter(scene, parameter, 1e-3));
    EXPECT_EQ(beyond.verdict, Verdict::violation);
    EXPECT_TRUE(broken_rulings(beyond).contains(9));
  }
}

TEST(ValueLatitude, OtherLinesMayNotGoByTheirShorterAxis) {
  for (const Scene& scene : {line_to(13.25, 12.5), line_to(12.25, 13.5)}) {
    EXPECT_EQ(judged(scene, by_parameter(scene, LineParameter::major_axis)).verdict,
              Verdict::contested);
    const Result result = judged(scene, by_parameter(scene, LineParameter::minor_axis));
    EXPECT_EQ(result.verdict, Verdict::violation);
    EXPECT_TRUE(broken_rulings(result).contains(9));
  }
}

Scene point_of(Interpolation interpolation, float w) {
  Scene scene = blank_scene(8, 8);
  Draw draw = make_draw(Primitive::points, std::vector{at(3.5, 3.5)});
  draw.interpolation = interpolation;
  draw.vertices[0].color = {0.75, 0.5, 0.25, 1};
  draw.vertices[0].z = Fixed::from_raw(Fixed::kOne / 2);
  draw.vertices[0].w = w;
  scene.draws = {draw};
  return scene;
}

Verdict with_red(const Scene& scene, double red) {
  std::vector<Fragment> fragments = rasterize(scene, {}).fragments;
  for (Fragment& f : fragments) f.color[0] = to_float(red);
  return judged(scene, compose(scene, fragments)).verdict;
}

TEST(ValueLatitude, APointsAttributesMayErrTwiceWhereTheirWIsNotOne) {
  for (const auto interpolation : {Interpolation::smooth, Interpolation::noperspective}) {
    const Scene scene = point_of(interpolation, 3);
    EXPECT_EQ(with_red(scene, 0.75 * (1 + 1.9e-5)), Verdict::permitted);
    EXPECT_EQ(with_red(scene, 0.75 * (1 + 2.1e-5)), Verdict::violation);
    EXPECT_EQ(with_red(point_of(interpolation, 1), 0.75 * (1 + 1e-6)), Verdict::violation);
  }
  EXPECT_EQ(with_red(point_of(Interpolation::flat, 3), 0.75 * (1 + 1e-6)), Verdict::violation);
}

// Nothing multiplies 1/w by w: gl_FragCoord.w and the depth err by what makes them alone.
TEST(ValueLatitude, APointsDepthIsNotDividedByItsW) {
  for (const auto interpolation : {Interpolation::smooth, Interpolation::noperspective}) {
    const Scene scene = point_of(interpolation, 3);
    const PrimitiveAttributes attributes =
        attributes_of(primitives_of(scene).front(), resolve({}, Surface::fbo), scene.target);
    for (const Interpolant& f : {attributes.depth, attributes.inverse_w}) {
      const Interval value = interpolate_inexact(f, at(3.5, 3.5));
      EXPECT_EQ(value.low, f.values[0].low);
      EXPECT_EQ(value.high, f.values[0].high);
    }
  }
}

Result judged_as_es(const Scene& scene, const Rendering& rendered) {
  RendererFacts facts{8, nullptr};
  facts.lookups.is_es = true;
  Result result = compare(scene, Policy{}, rasterize(scene, {}), rendered, facts);
  Result* const alone[] = {&result};
  judge(alone, Latitude::opengl);
  return result;
}

// A flat primitive whose red is off by a part.
Rendering off_by(const Scene& scene, double part) {
  std::vector<Fragment> fragments = rasterize(scene, {}).fragments;
  for (Fragment& f : fragments) f.color[0] = to_float(f.color[0] * (1 - part));
  return compose(scene, fragments);
}

// ES 3.2, 13.7.1: flat floats of polygons are interpolated, and "precision may be lost"; of lines
// (13.6.1) and points they are not.
TEST(ValueLatitude, OpenGlEsMayInterpolateFlatPolygons) {
  for (const Primitive kind : {Primitive::triangles, Primitive::lines}) {
    Scene scene = blank_scene(8, 8);
    Draw draw = make_draw(kind, std::vector{at(0.25, 0.5), at(7.25, 0.5), at(0.5, 7.75)});
    if (kind == Primitive::lines) draw.vertices.pop_back();
    for (Vertex& vertex : draw.vertices) vertex.color = {1, 0.5, 0.25, 1};
    draw.interpolation = Interpolation::flat;
    scene.draws = {draw};
    const bool is_polygon = kind == Primitive::triangles;
    const Verdict permitted = is_polygon ? Verdict::permitted : Verdict::violation;
    for (const double part : {0x1p-24, 5e-5}) {
      const Rendering off = off_by(scene, part);
      EXPECT_EQ(judged_as_es(scene, off).verdict, permitted) << part;
      EXPECT_EQ(judged(scene, off).verdict, Verdict::violation) << part;
    }
    EXPECT_EQ(judged_as_es(scene, off_by(scene, 2e-4)).verdict, Verdict::violation);
  }
}

// ES 3.2, 13.6.1: the formula "may be approximated" by coordinates on the major axis.
TEST(ValueLatitude, OpenGlEsMayGoByTheMajorAxis) {
  const Scene scene = line_to(13.25, 9.5);
  const Result result = judged_as_es(scene, by_parameter(scene, LineParameter::major_axis));
  EXPECT_TRUE(broken_rulings(result).empty());
  EXPECT_NE(result.verdict, Verdict::agree);
  for (const Disagreement& d : result.disagreements)
    EXPECT_EQ(d.cause, "attribute.smooth=major-axis") << d.explanation;
  const Result beyond = judged_as_es(scene, by_parameter(scene, LineParameter::major_axis, 1e-3));
  EXPECT_EQ(beyond.verdict, Verdict::violation);
}

}  // namespace
}  // namespace edgecase
