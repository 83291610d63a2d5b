// SPDX-License-Identifier: MIT
//
// Each phrase for a place on a primitive, by a drawn example.
#include "diff/coverage/situation.h"

#include <gtest/gtest.h>

#include "tests/raster/random_scenes.h"
#include "tests/support/points.h"

namespace edgecase {
namespace {

std::string situation(Primitive kind, const std::vector<Point>& points, PixelPosition pixel,
                      double size = 1) {
  Scene scene = blank_scene(16, 16);
  scene.draws = {make_draw(kind, points)};
  scene.draws[0].line_width = scene.draws[0].point_size = at(size, 0).x;
  return situation_of(primitives_of(scene)[0], pixel_centre(pixel.x, pixel.y), scene.target);
}

std::string line(Point a, Point b, PixelPosition pixel, double width = 1) {
  return situation(Primitive::lines, {a, b}, pixel, width);
}

std::string triangle(const std::vector<Point>& points, PixelPosition pixel) {
  return situation(Primitive::triangles, points, pixel);
}

std::string point(Point p, PixelPosition pixel, double size = 1) {
  return situation(Primitive::points, {p}, pixel, size);
}

TEST(SituationOfALine, NamesDirections) {
  const Point start = at(6.5, 6.5);
  const PixelPosition pixel{6, 6};
  const std::string there = ", first pixel, start at the centre of its diamond";
  EXPECT_EQ(line(start, at(12.5, 6.5), pixel), "line, horizontal right" + there);
  EXPECT_EQ(line(start, at(2.5, 6.5), pixel), "line, horizontal left" + there);
  EXPECT_EQ(line(start, at(6.5, 12.5), pixel), "line, vertical up" + there);
  EXPECT_EQ(line(start, at(6.5, 2.5), pixel), "line, vertical down" + there);
  EXPECT_EQ(line(start, at(12.5, 8.5), pixel), "line, x-major right and up" + there);
  EXPECT_EQ(line(start, at(2.5, 4.5), pixel), "line, x-major left and down" + there);
  EXPECT_EQ(line(start, at(8.5, 2.5), pixel), "line, y-major right and down" + there);
  EXPECT_EQ(line(start, at(4.5, 12.5), pixel), "line, y-major left and up" + there);
  EXPECT_EQ(line(start, at(9.5, 3.5), pixel), "line, diagonal right and down" + there);
  EXPECT_EQ(line(start, at(2.5, 10.5), pixel), "line, diagonal left and up" + there);
  EXPECT_EQ(line(start, at(12.5, 6.5), pixel, 3), "wide line, horizontal right" + there);
  EXPECT_EQ(line(start, at(12.5, 6.5), pixel, 1.25), "line, horizontal right" + there);
  EXPECT_EQ(line(start, start, pixel),
            "line, without length" + there + "; last pixel, end at the centre of its diamond");
}

TEST(SituationOfALine, NamesEveryPartOfTheDiamondThatAnEndLiesIn) {
  const auto first = [](double x, double y, PixelPosition pixel = {6, 6}) {
    const std::string described = line(at(x, y), at(x + 5, y), pixel);
    const std::string before = "line, horizontal right, first pixel, start ";
    EXPECT_EQ(described.substr(0, before.size()), before);
    return described.substr(before.size());
  };
  EXPECT_EQ(first(6.5, 6.5), "at the centre of its diamond");
  EXPECT_EQ(first(6.375, 6.375), "inside its diamond");
  EXPECT_EQ(first(6.125, 6.25), "outside its diamond");
  EXPECT_EQ(first(6, 6.5), "on the left corner of its diamond");
  EXPECT_EQ(first(6.5, 6), "on the lower corner of its diamond");
  EXPECT_EQ(first(6.25, 6.25), "on the lower left edge of its diamond");
  EXPECT_EQ(first(6.75, 6.25), "on the lower right edge of its diamond");
  EXPECT_EQ(first(6.25, 6.75), "on the upper left edge of its diamond");
  EXPECT_EQ(first(6.75, 6.75), "on the upper right edge of its diamond");
  EXPECT_EQ(first(7, 6.5), "on the right corner of its diamond") << "a corner belongs to two";
  EXPECT_EQ(first(6.5, 7), "on the upper corner of its diamond");
}

TEST(SituationOfALine, NamesEndsAndWhatLiesBetween) {
  const Point a = at(3.5, 4.5), b = at(8.25, 4.5);
  const std::string right = "line, horizontal right, ";
  EXPECT_EQ(line(a, b, {8, 4}), right + "last pixel, end inside its diamond");
  EXPECT_EQ(line(a, b, {5, 4}), right + "along the way");
  EXPECT_EQ(line(a, b, {2, 4}), right + "before the start");
  EXPECT_EQ(line(a, b, {9, 4}), right + "beyond the end");
  EXPECT_EQ(line(a, b, {5, 5}), right + "beside the line");
  EXPECT_EQ(line(b, a, {2, 4}), "line, horizontal left, beyond the end");
  EXPECT_EQ(line(at(3.5, 5), at(8.5, 5), {5, 4}),
            right + "along the way, where it only touches the diamond");
  EXPECT_EQ(line(at(5.5, 12.5), at(5.5, 3.5), {5, 13}), "line, vertical down, before the start");
  EXPECT_EQ(line(at(6.375, 9.5), at(6.625, 9.5), {6, 9}),
            right + "first pixel, start inside its diamond; last pixel, end inside its diamond");
}

const std::vector<Point> kRight = {at(4.5, 3.5), at(12.5, 3.5), at(4.5, 11.5)};

TEST(SituationOfATriangle, NamesTheEdgeThatASampleLiesOn) {
  for (const std::vector<Point>& t : {kRight, std::vector{kRight[0], kRight[2], kRight[1]}}) {
    EXPECT_EQ(triangle(t, {4, 6}), "triangle, sample exactly on a left edge");
    EXPECT_EQ(triangle(t, {7, 3}), "triangle, sample exactly on a bottom edge");
    EXPECT_EQ(triangle(t, {8, 7}), "triangle, sample exactly on a right edge");
    EXPECT_EQ(triangle(t, {4, 3}), "triangle, sample at a vertex");
  }
  EXPECT_EQ(triangle({at(4.5, 9.5), at(4.5, 3.5), at(10.5, 9.5)}, {7, 9}),
            "triangle, sample exactly on a top edge");
  EXPECT_EQ(triangle({at(4.5, 9.5), at(4.5, 3.5), at(4.5, 7)}, {4, 5}), "triangle without area");
}

TEST(SituationOfATriangle, NamesHowFarASampleLiesFromItsEdges) {
  // The left edge lies so far right of the centre of pixel (4, 6).
  const auto described = [](double distance) {
    const double left = 4.5 + distance;
    return triangle({at(left, 1), at(15, 1), at(left, 15)}, {4, 6});
  };
  EXPECT_EQ(described(1. / 256), "triangle, sample outside, within 1/256 pixel");
  EXPECT_EQ(described(1. / 256 + 1. / 65536), "triangle, sample outside, within 1/16 pixel");
  EXPECT_EQ(described(1. / 16), "triangle, sample outside, within 1/16 pixel");
  EXPECT_EQ(described(1), "triangle, sample outside, within 1 pixel");
  EXPECT_EQ(described(1.25), "triangle, sample outside, more than 1 pixel");
  EXPECT_EQ(described(-1. / 256), "triangle, sample inside, within 1/256 pixel");
  EXPECT_EQ(described(-1. / 256 - 1. / 65536), "triangle, sample inside, within 1/16 pixel");
  EXPECT_EQ(described(-.5), "triangle, sample inside, within 1 pixel");
  EXPECT_EQ(described(-2), "triangle, sample inside, more than 1 pixel");
  EXPECT_EQ(triangle(kRight, {4, 14}), "triangle, sample outside, more than 1 pixel")
      << "on the line of an edge, beyond its end";
  // Distances are across an edge, not along an axis: 3-4-5.
  EXPECT_EQ(triangle({at(2.5, 2.5), at(14.5, 11.5), at(2.5, 11.5)}, {5, 3}),
            "triangle, sample outside, within 1 pixel");
}

TEST(SituationOfAPoint, NamesSideCornerAndDistance) {
  EXPECT_EQ(point(at(5, 4.5), {4, 4}), "point of size 1, centre exactly on the left side");
  EXPECT_EQ(point(at(5, 4.5), {5, 4}), "point of size 1, centre exactly on the right side");
  EXPECT_EQ(point(at(4.5, 5), {4, 4}), "point of size 1, centre exactly on the bottom side");
  EXPECT_EQ(point(at(4.5, 5), {4, 5}), "point of size 1, centre exactly on the top side");
  EXPECT_EQ(point(at(5, 5), {4, 4}), "point of size 1, centre exactly on a corner");
  EXPECT_EQ(point(at(5 - 1. / 256, 4.5), {5, 4}),
            "point of size 1, centre outside, within 1/256 pixel");
  EXPECT_EQ(point(at(5 - 1. / 256, 4.5), {4, 4}),
            "point of size 1, centre inside, within 1/256 pixel");
  EXPECT_EQ(point(at(4.5, 4.5), {4, 4}), "point of size 1, centre inside, within 1 pixel");
  EXPECT_EQ(point(at(5 - 1. / 32, 4.5), {5, 4}),
            "point of size 1, centre outside, within 1/16 pixel");
  EXPECT_EQ(point(at(4.5, 4.5), {8, 4}), "point of size 1, centre outside, more than 1 pixel");
  EXPECT_EQ(point(at(8.5, 8.5), {8, 8}, 5), "sized point, centre inside, more than 1 pixel");
  EXPECT_EQ(point(at(8.5, 8.5), {10, 8}, 4), "sized point, centre exactly on the right side");
}

}  // namespace
}  // namespace edgecase
