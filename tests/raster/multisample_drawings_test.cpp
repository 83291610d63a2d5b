// SPDX-License-Identifier: MIT
//
// Multisampled primitives drawn by hand: masks as hexadecimal digits, bit s for sample s, top row
// first. With the standard pattern of 4 the samples of a pixel lie, in sixteenths from its lower
// left corner, at
//
//        . . 3 .        0 (6, 2)
//        2 . . .        1 (14, 6)
//        . . . 1        2 (2, 10)
//        . 0 . .        3 (10, 14)
#include <gtest/gtest.h>

#include "tests/raster/multisampled_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

std::string masks(const Scene& scene, const Choices& rules = {},
                  const SamplePositions& reported = {}) {
  Policy policy;
  policy.rules = rules;
  return masks_drawn(rasterize(scene, policy, reported));
}

Scene triangle(std::vector<Point> positions) {
  return multisampled_scene(3, 4, Primitive::triangles, std::move(positions));
}

TEST(MultisampleDrawings, ATriangleCutsPixels) {
  // The left edge at x = 1/2 keeps samples 1 and 3 of column 0; the top one at y = 1.75 is that of
  // no sample, and keeps 0, 1 and 2 of row 1.
  EXPECT_EQ(masks(triangle({at(0.5, -8), at(0.5, 1.75), at(16, 1.75)})), ". . ./2 7 7/a f f/");
  // The diagonal below x = y: it passes through no sample.
  EXPECT_EQ(masks(triangle({at(0, 0), at(8, 0), at(8, 8)})), ". . 3/. 3 f/3 f f/");
}

TEST(MultisampleDrawings, ATieIsDecidedAtEachSample) {
  // The left edge runs through the samples 0 of column 1, the top edge through 3 of row 1.
  const Scene scene = triangle({at(1.375, -8), at(1.375, 1.875), at(16, 1.875)});
  EXPECT_EQ(masks(scene), ". . ./. b f/. b f/");
  EXPECT_EQ(masks(scene, {{"triangle.fill-rule", "right-top"}}), ". . ./. a f/. a f/");
  EXPECT_EQ(masks(scene, {{"triangle.fill-rule", "left-bottom"}}), ". . ./. 3 7/. b f/");
}

TEST(MultisampleDrawings, APointIsASquareOfItsOwnSize) {
  Scene scene = multisampled_scene(3, 4, Primitive::points, {at(1.5, 1.5)});
  EXPECT_EQ(masks(scene), ". . ./. f ./. . ./");
  scene.draws[0].point_size = Fixed::from_raw(Fixed::kOne / 2);
  EXPECT_EQ(masks(scene), ". . ./. . ./. . ./");
  scene.draws[0].point_size = Fixed::from_raw(Fixed::kOne * 3 / 2);
  // From 0.75 to 2.25: right sample 1 of the left column, left sample 2 of the right one; of the
  // row above 0, of the row below 3.
  EXPECT_EQ(masks(scene), ". 1 ./2 f 4/. 8 ./");
}

TEST(MultisampleDrawings, ALineIsARectangleOfItsOwnWidth) {
  Scene scene = multisampled_scene(3, 4, Primitive::lines, {at(0.5, 1.5), at(2.5, 1.5)});
  EXPECT_EQ(masks(scene), ". . ./a f 5/. . ./");
  scene.draws[0].line_width = Fixed::from_raw(Fixed::kOne / 2);
  EXPECT_EQ(masks(scene), ". . ./2 6 4/. . ./");
  // A width of 1.5 is not rounded to 2.
  scene.draws[0].line_width = Fixed::from_raw(Fixed::kOne * 3 / 2);
  EXPECT_EQ(masks(scene), ". 1 1/a f 5/8 8 ./");
  // Without length there is nothing.
  EXPECT_EQ(masks(multisampled_scene(3, 4, Primitive::lines, {at(1.5, 1.5), at(1.5, 1.5)})),
            ". . ./. . ./. . ./");
}

// The upper side, at 33 5/8 sixteenths, is rounded to 34, where samples 0 of the row above lie.
// Were the ends snapped before, it would be at 33 1/4 and rounded to 33.
TEST(MultisampleDrawings, ARoundedRectangleHasAGridOfItsOwn) {
  const double y = 25.375 / 16;
  Scene scene = multisampled_scene(3, 4, Primitive::lines, {at(0.5, y), at(2.5, y)});
  scene.draws[0].line_width = Fixed::from_raw(Fixed::kOne * 33 / 32);
  for (const char* snap : {"none", "4-half-even"})
    EXPECT_EQ(masks(scene, {{"line.multisampled", "snapped-corners"}, {"line.snap", snap}}),
              ". 1 1/a f 5/. . ./");
  EXPECT_EQ(masks(scene, {{"line.snap", "4-half-even"}}), ". . ./a f 5/. . ./");
  // A triangle's vertices are snapped as ever: its upper side moves onto samples 2 of its row.
  const Scene other = triangle({at(0, -8), at(0, 25.75 / 16), at(16, 25.75 / 16)});
  EXPECT_EQ(masks(other, {{"line.multisampled", "snapped-corners"}}), ". . ./3 3 3/f f f/");
  EXPECT_EQ(
      masks(other, {{"line.multisampled", "snapped-corners"}, {"triangle.snap", "4-half-even"}}),
      ". . ./7 7 7/f f f/");
}

// From (1.25, 1) to (1.75, 2) no left border runs through the rectangle, from (0.75, 1) one does;
// from (2, 1) on there are borders, but the target's last one is the rectangle's own.
TEST(MultisampleDrawings, ALineBetweenBordersIsLost) {
  const auto drawn = [](double from, double to) {
    return masks(multisampled_scene(3, 4, Primitive::lines, {at(from, 1.5), at(to, 1.5)}),
                 {{"line.multisampled", "snapped-offset-across-borders"}});
  };
  EXPECT_EQ(drawn(1.25, 1.75), ". . ./. . ./. . ./");
  EXPECT_EQ(drawn(1, 2), ". . ./. f ./. . ./");
  EXPECT_EQ(drawn(0.75, 1.75), ". . ./2 d ./. . ./");
  EXPECT_EQ(drawn(2.25, 3.5), ". . ./. . ./. . ./");
  EXPECT_EQ(drawn(1.25, 3.5), ". . ./. b f/. . ./");
  EXPECT_EQ(drawn(-1, 0), ". . ./. . ./. . ./");
}

TEST(MultisampleDrawings, ADiagonalLineEndsAcross) {
  const Scene scene = multisampled_scene(3, 4, Primitive::lines, {at(1, 1), at(2, 2)});
  // x + y runs from 2 to 4 and |x - y| is at most 0.707: that holds (0.875, 1.375) and, mirrored,
  // (2.125, 1.625).
  EXPECT_EQ(masks(scene), ". . ./2 f 4/. . ./");
  // The ends along the minor axis: x from 1 to 2 and |x - y| up to 1/2, where (1.875, 2.375) is on
  // the upper side and (1.875, 1.375) on the lower.
  EXPECT_EQ(masks(scene, {{"line.multisampled", "parallelogram"}}), ". 2 ./. d ./. . ./");
}

TEST(MultisampleDrawings, ASingleSampledLineHasAllSamples) {
  Scene scene = multisampled_scene(3, 4, Primitive::lines, {at(0.5, 1.5), at(2.5, 1.5)});
  EXPECT_EQ(masks(scene, {{"line.multisampled", "single-sampled"}}), ". . ./f f ./. . ./");
  // Without GL_MULTISAMPLE the fragment has its one bit, and writes all samples.
  scene.draws[0].multisampling.enabled = false;
  EXPECT_EQ(masks(scene), ". . ./1 1 ./. . ./");
  EXPECT_EQ(masks(scene, {{"sample.enable", "ignored"}}), ". . ./a f 5/. . ./");
}

TEST(MultisampleDrawings, TheSampleMaskClearsBits) {
  Scene scene = triangle({at(0.5, -8), at(0.5, 1.75), at(16, 1.75)});
  scene.draws[0].multisampling.mask = 0b1101;
  EXPECT_EQ(masks(scene), ". . ./. 5 5/8 d d/");
  EXPECT_EQ(masks(scene, {{"sample.mask", "ignored"}}), ". . ./2 7 7/a f f/");
  scene.draws[0].multisampling.mask = 0xfffffff0;  // bits beyond the samples
  EXPECT_EQ(masks(scene), ". . ./. . ./. . ./");
}

TEST(MultisampleDrawings, SamplesLieWhereTheRendererSays) {
  Scene scene = triangle({at(0.5, -8), at(0.5, 1.75), at(16, 1.75)});
  const SamplePositions reported =
      placed({SamplePlacement::Kind::turned, 0, 0}, standard_pattern(4));
  // Turned they lie at (10, 14), (2, 10), (14, 6), (6, 2).
  EXPECT_EQ(masks(scene, {}, reported), ". . ./4 e e/5 f f/");
  EXPECT_EQ(masks(scene, {{"sample.positions", "turned"}}), masks(scene, {}, reported));
  scene.target.sample_positions = reported;
  EXPECT_EQ(masks(scene), ". . ./4 e e/5 f f/");
  // What a renderer reports comes before what the case asks for.
  EXPECT_EQ(masks(scene, {}, standard_pattern(4)), ". . ./2 7 7/a f f/");
  EXPECT_EQ(masks(scene, {{"sample.positions", "standard"}}), ". . ./2 7 7/a f f/");
  EXPECT_EQ(masks(scene, {{"sample.positions", "centre"}}), ". . ./f f f/f f f/");
}

TEST(MultisampleDrawings, ManySamplesHaveManyDigits) {
  EXPECT_EQ(masks(multisampled_scene(2, 8, Primitive::points, {at(0.5, 0.5)})), ". ./ff ./");
  // Sample 12 of 16 lies on the pixel's left side, 15 on its bottom: the square has its right and
  // top sides, and so 15 of the pixel above.
  EXPECT_EQ(masks(multisampled_scene(2, 16, Primitive::points, {at(1.5, 0.5)})), ". 8000/. 6fff/");
  // Of 2 samples the first lies to the upper right.
  EXPECT_EQ(masks(multisampled_scene(2, 2, Primitive::points, {at(1, 1)})), ". 2/1 ./");
}

}  // namespace
}  // namespace edgecase
