// SPDX-License-Identifier: MIT
//
// permitted_locations drawn by hand: the corners of what the pixel from (1, 1) to (2, 2) shares
// with points, lines and triangles, to the last 2^-16.
#include <gtest/gtest.h>

#include "rules/samples/attribute_location.h"
#include "tests/rules/samples/held_primitive.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

constexpr PixelPosition kPixel{1, 1};
constexpr double kRaw = 1.0 / Fixed::kOne;

using Points = std::vector<Point>;

Fixed pixels(double value) {
  return at(value, 0).x;
}

Points region(PrimitiveKind kind, std::array<Point, 3> points, double size, double reach = 0) {
  const Held shape(kind, points, pixels(size), AttributeLocation::centroid);
  return permitted_locations(shape.primitive, kPixel, {}, pixels(reach));
}

// The corners of a rectangle, as permitted_locations has them.
Points box(double left, double bottom, double right, double top) {
  return {at(left, bottom), at(right, bottom), at(left, top), at(right, top)};
}

TEST(PermittedLocations, DrawnExamples) {
  const Fixed one = Fixed::from_integer(1);
  const std::array<Point, 3> lower_left = {at(0, 0), at(2.5, 0), at(0, 2.5)};
  const auto of = [&](AttributeLocation location) {
    const Held shape(PrimitiveKind::triangle, lower_left, one, location);
    return permitted_locations(shape.primitive, kPixel, at(0.25, 0.5), Fixed());
  };
  EXPECT_EQ(of(AttributeLocation::centroid), (Points{at(1, 1), at(1.5, 1), at(1, 1.5)}));
  EXPECT_EQ(of(AttributeLocation::center), (Points{at(1, 1), at(2, 1), at(1, 2), at(2, 2)}));
  EXPECT_EQ(of(AttributeLocation::sample), Points{at(1.25, 1.5)});
  // Nothing shared: the whole pixel.
  const Held far(PrimitiveKind::triangle, {at(7, 7), at(8, 7), at(7, 8)}, one,
                 AttributeLocation::centroid);
  EXPECT_EQ(permitted_locations(far.primitive, kPixel, {}, one).size(), 4u);
}

TEST(PermittedLocations, UnderSampleShadingAndWithoutMultisampling) {
  Held shape(PrimitiveKind::triangle, {at(0, 0), at(9, 0), at(0, 9)}, Fixed::from_integer(1),
             AttributeLocation::center);
  const auto count = [&] {
    return permitted_locations(shape.primitive, kPixel, at(0.25, 0.5), Fixed()).size();
  };
  shape.draw.multisampling.min_sample_shading = 0.5F;
  EXPECT_EQ(count(), 4u);
  shape.draw.multisampling.min_sample_shading = 1.0F;
  EXPECT_EQ(count(), 1u);
  // gl_FragCoord is bound to the sample by the share alone, whatever else is.
  const auto of_coordinates = [&] {
    return permitted_coordinate_locations(shape.draw.multisampling, kPixel, at(0.25, 0.5));
  };
  EXPECT_EQ(of_coordinates(), std::vector<Point>{at(1.25, 1.5)});
  shape.draw.multisampling.min_sample_shading = 0.5F;
  for (const AttributeLocation location :
       {AttributeLocation::sample, AttributeLocation::centroid}) {
    shape.draw.multisampling.location = location;
    EXPECT_EQ(of_coordinates().size(), 4u);
  }
  // Without GL_MULTISAMPLE nothing is bound.
  shape.draw.multisampling.min_sample_shading = 1.0F;
  shape.draw.multisampling.enabled = false;
  EXPECT_EQ(count(), 4u);
  EXPECT_EQ(of_coordinates().size(), 4u);
}

// The other vertices of a point are none of its.
Points of_point(Point place, double size, double reach = 0) {
  return region(PrimitiveKind::point, {place, at(0, 0), at(9, 9)}, size, reach);
}

TEST(PermittedLocations, APointsSquare) {
  EXPECT_EQ(of_point(at(1.5, 1.5625), 0.5), box(1.25, 1.3125, 1.75, 1.8125));
  EXPECT_EQ(of_point(at(1.5, 1.5625), 0.5, 0.0625), box(1.1875, 1.25, 1.8125, 1.875));
  EXPECT_EQ(of_point(at(1.125, 1.875), 0.5), box(1, 1.625, 1.375, 2));
  // Half of an odd size is rounded up, half of an even one is what it is.
  EXPECT_EQ(of_point(at(1.5, 1.5), 3 * kRaw),
            box(1.5 - 2 * kRaw, 1.5 - 2 * kRaw, 1.5 + 2 * kRaw, 1.5 + 2 * kRaw));
  EXPECT_EQ(of_point(at(1.5, 1.5), 4 * kRaw),
            box(1.5 - 2 * kRaw, 1.5 - 2 * kRaw, 1.5 + 2 * kRaw, 1.5 + 2 * kRaw));
}

// The nearest multiple of 2^-16 of a quotient is up to half of one off.
TEST(PermittedLocations, OfClipPositions) {
  Held shape(PrimitiveKind::point, {at(1.5, 1.5), {}, {}}, pixels(0.5),
             AttributeLocation::centroid);
  shape.vertices[0].clip.emplace();
  EXPECT_EQ(permitted_locations(shape.primitive, kPixel, {}, Fixed()),
            box(1.25 - kRaw, 1.25 - kRaw, 1.75 + kRaw, 1.75 + kRaw));
}

Points of_triangle(std::array<Point, 3> points, double reach = 0) {
  return region(PrimitiveKind::triangle, points, 1, reach);
}

TEST(PermittedLocations, ATriangleWithinThePixel) {
  const Points corners = {at(1.25, 1.25), at(1.75, 1.25), at(1.5, 1.75)};
  EXPECT_EQ(of_triangle({corners[0], corners[1], corners[2]}), corners);
  EXPECT_EQ(of_triangle({corners[0], corners[2], corners[1]}), corners);
  EXPECT_EQ(of_triangle({corners[2], corners[0], corners[1]}), corners);
}

// The triangle and a square: the box cuts off what edges alone would leave at sharp corners.
TEST(PermittedLocations, ATriangleOfWhichVerticesMove) {
  EXPECT_EQ(of_triangle({at(1.25, 1.25), at(1.75, 1.25), at(1.25, 1.75)}, 0.125),
            (Points{at(1.125, 1.125), at(1.875, 1.125), at(1.875, 1.375), at(1.125, 1.875),
                    at(1.375, 1.875)}));
  EXPECT_EQ(of_triangle({at(1.75, 1.75), at(1.25, 1.75), at(1.75, 1.25)}, 0.125),
            (Points{at(1.625, 1.125), at(1.875, 1.125), at(1.125, 1.625), at(1.125, 1.875),
                    at(1.875, 1.875)}));
}

TEST(PermittedLocations, ATriangleOfHardlyAnyArea) {
  const Points smallest = {at(1.5, 1.5), at(1.5 + kRaw, 1.5), at(1.5, 1.5 + kRaw)};
  EXPECT_EQ(of_triangle({smallest[0], smallest[1], smallest[2]}), smallest);
  EXPECT_EQ(of_triangle({smallest[0], smallest[2], smallest[1]}), smallest);
  // Without any, the box round it.
  EXPECT_EQ(of_triangle({at(1.25, 1.25), at(1.5, 1.5), at(1.75, 1.75)}),
            box(1.25, 1.25, 1.75, 1.75));
}

Points of_line(Point a, Point b, double width, double reach = 0) {
  return region(PrimitiveKind::line, {a, b, {}}, width, reach);
}

TEST(PermittedLocations, ALinesRectangle) {
  EXPECT_EQ(of_line(at(1.25, 1.5), at(1.75, 1.5), 0.25), box(1.25, 1.375, 1.75, 1.625));
  EXPECT_EQ(of_line(at(1.75, 1.5), at(1.25, 1.5), 0.25), box(1.25, 1.375, 1.75, 1.625));
  EXPECT_EQ(of_line(at(1.5, 1.25), at(1.5, 1.75), 0.25), box(1.375, 1.25, 1.625, 1.75));
  EXPECT_EQ(of_line(at(1.5, 1.25), at(1.5, 7), 0.25), box(1.375, 1.25, 1.625, 2));
  // Of 3, 4 and 5.
  EXPECT_EQ(of_line(at(1.25, 1.25), at(1.625, 1.75), 0.3125),
            (Points{at(1.375, 1.15625), at(1.125, 1.34375), at(1.75, 1.65625), at(1.5, 1.84375)}));
}

TEST(PermittedLocations, ALineOfTheLeastLengthAndWidth) {
  EXPECT_EQ(of_line(at(1.5, 1.5), at(1.5 + kRaw, 1.5), 3 * kRaw),
            box(1.5, 1.5 - 2 * kRaw, 1.5 + kRaw, 1.5 + 2 * kRaw));
}

// With a reach r of 1/64, a segment that runs for 1/2, the product of it and of the way from an end
// to the pixel's farthest place changes by 2 r (way + 2 r) + r / 2. From the first end that way is
// 7/8 + 1/2, from the second one 5/8 + 1/2: 53/1024 and 45/1024. The half width times the length,
// which may have grown by 3 r, is 35/512.
TEST(PermittedLocations, ALineOfWhichEndsMove) {
  const double first = 53.0 / 512, second = 45.0 / 512, aside = 2 * (35.0 / 512 + 53.0 / 1024);
  EXPECT_EQ(of_line(at(1.125, 1.5), at(1.625, 1.5), 0.25, 1.0 / 64),
            box(1.125 - first, 1.5 - aside, 1.625 + second, 1.5 + aside));
  EXPECT_EQ(of_line(at(1.5, 1.875), at(1.5, 1.375), 0.25, 1.0 / 64),
            box(1.5 - aside, 1.375 - second, 1.5 + aside, 1.875 + first));
}

}  // namespace
}  // namespace edgecase
