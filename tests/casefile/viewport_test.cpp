// SPDX-License-Identifier: MIT
#include "casefile/scene/viewport.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>
#include <vector>

namespace edgecase {
namespace {

Draw points_at(const std::vector<Point>& positions) {
  Draw draw;
  draw.primitive = Primitive::points;
  for (const Point point : positions) draw.vertices.push_back({point, Fixed(), {}});
  return draw;
}

Target target_of(int width, int height) {
  Target target;
  target.width = width;
  target.height = height;
  return target;
}

Point whole(std::int64_t x, std::int64_t y) {
  return {Fixed::from_integer(x), Fixed::from_integer(y)};
}

// What OpenGL does in float32: the window coordinate of a clip coordinate.
float window_image(float clip, ViewportSide side) {
  const float half = static_cast<float>(side.size) / 2;
  return clip * half + (static_cast<float>(side.origin) + half);
}

void expect_survives(Fixed x, ViewportSide side) {
  const double half = side.size / 2.0;
  const double clip = (x.to_double() - (side.origin + half)) / half;
  EXPECT_EQ(static_cast<double>(static_cast<float>(clip)), clip);
  EXPECT_EQ(static_cast<double>(window_image(static_cast<float>(clip), side)), x.to_double());
  EXPECT_LT(clip, 1);
  EXPECT_GT(clip, -1);
}

TEST(Viewport, EqualsATargetWhoseSizesArePowersOfTwo) {
  const auto viewport = choose_viewport(target_of(8, 4), {points_at({whole(1, 1), whole(7, 3)})});
  ASSERT_TRUE(viewport.has_value());
  EXPECT_EQ(viewport->x, 0);
  EXPECT_EQ(viewport->y, 0);
  EXPECT_EQ(viewport->width, 8);
  EXPECT_EQ(viewport->height, 4);
}

TEST(Viewport, GrowsForVerticesOnTheTargetsEdge) {
  const auto viewport = choose_viewport(target_of(8, 8), {points_at({whole(0, 8)})});
  ASSERT_TRUE(viewport.has_value());
  EXPECT_EQ(viewport->x, -1);
  EXPECT_EQ(viewport->width, 16);
  EXPECT_EQ(viewport->y, 0);
  EXPECT_EQ(viewport->height, 16);
}

TEST(Viewport, LeavesRoomForWideLinesAndLargePoints) {
  Draw draw = points_at({whole(4, 4)});
  draw.point_size = Fixed::from_integer(6);  // covers 1 to 7, and a pixel more
  auto viewport = choose_viewport(target_of(8, 8), {draw});
  ASSERT_TRUE(viewport.has_value());
  EXPECT_EQ(viewport->width, 8);
  draw.point_size = Fixed::from_raw(6 * Fixed::kOne + 1);
  viewport = choose_viewport(target_of(8, 8), {draw});
  ASSERT_TRUE(viewport.has_value());
  EXPECT_EQ(viewport->x, -1);
  EXPECT_EQ(viewport->width, 16);
  draw.primitive = Primitive::line_loop;
  draw.vertices.push_back(draw.vertices[0]);
  EXPECT_EQ(choose_viewport(target_of(8, 8), {draw})->width, 8);  // points only have a size
  draw.line_width = Fixed::from_integer(7);
  EXPECT_EQ(choose_viewport(target_of(8, 8), {draw})->width, 16);
}

TEST(Viewport, MovesItsCentreForFineVertices) {
  // 1/65536 is exact within 256 pixels of the centre, which 1024 / 2 is not.
  const Point fine{Fixed::from_raw(1), Fixed::from_integer(1)};
  const auto viewport = choose_viewport(target_of(1024, 4), {points_at({fine})});
  ASSERT_TRUE(viewport.has_value());
  EXPECT_EQ(viewport->width, 2048);
  EXPECT_EQ(viewport->x, -768);
  expect_survives(fine.x, {viewport->x, viewport->width});
}

TEST(Viewport, IsMissingWhereVerticesAreTooFarApart) {
  EXPECT_FALSE(choose_viewport(target_of(8, 8), {points_at({whole(-8192, 1), whole(8192, 1)})}));
  EXPECT_TRUE(choose_viewport(target_of(8, 8), {points_at({whole(-8191, 1), whole(8191, 1)})}));
}

// Whatever float32 can hold at all reaches OpenGL unrounded through the viewport that is chosen.
TEST(Viewport, CarriesEveryFloat32CoordinateUnrounded) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 2000; ++round) {
    const int width = 1 + static_cast<int>(random() % 4096);
    std::vector<Point> points;
    for (int i = 0; i < 4; ++i) {
      // A magnitude of up to 2^28 raw is 2^12 pixels; cut to 24 significant bits.
      auto raw = static_cast<std::int64_t>(random() >> (36 + random() % 24));
      while (!fits_float32(raw)) raw &= raw - 1;
      points.push_back({Fixed::from_raw(random() % 2 == 0 ? raw : -raw), Fixed()});
    }
    const auto viewport = choose_viewport(target_of(width, 4), {points_at(points)});
    ASSERT_TRUE(viewport.has_value());
    const ViewportSide side{viewport->x, viewport->width};
    EXPECT_TRUE(std::has_single_bit(static_cast<unsigned>(side.size)));
    EXPECT_LE(side.origin, 0);
    EXPECT_GE(side.origin + side.size, width);
    for (const Point point : points) {
      const auto fault = find_inexactness(point.x, side, 'x');
      EXPECT_FALSE(fault.has_value()) << fault->message;
      expect_survives(point.x, side);
    }
  }
}

// With a w, what is sent is the product: a centre is found that keeps it exact, or the check says
// which factor has too many bits.
TEST(Viewport, ProductsWithWAreChecked) {
  // 65531/65536 to the left of the centre: 16 significant bits.
  const Fixed x = Fixed::from_raw(3 * Fixed::kOne + 5);
  EXPECT_FALSE(find_inexactness(x, {0, 8}, 'x', 1048576));
  EXPECT_FALSE(find_inexactness(x, {0, 8}, 'x', 255));  // 16 bits and 8 make 24
  const auto fault = find_inexactness(x, {0, 8}, 'x', 0.1F);
  ASSERT_TRUE(fault.has_value());
  EXPECT_NE(fault->message.find("with w = 0.1: the product has 40 significant bits"),
            std::string::npos)
      << fault->message;
  EXPECT_NE(fault->remedy.find("a power of two as w, or one of 8 significant bits at most"),
            std::string::npos)
      << fault->remedy;
  EXPECT_FALSE(find_depth_inexactness(Fixed::from_raw(Fixed::kOne / 2), 0.1F));
  EXPECT_TRUE(find_depth_inexactness(Fixed::from_raw(3), 0.1F));
}

TEST(Viewport, MovesItsCentreForTheSakeOfW) {
  // 3 (2^24 - 1) has 26 significant bits, (2^24 - 1) has 24: the centre has to be 2 pixels off.
  Draw draw = points_at({whole(5, 5)});
  draw.vertices[0].w = 16777215.0F / 16;
  const auto viewport = choose_viewport(target_of(8, 16), {draw});
  ASSERT_TRUE(viewport.has_value());
  EXPECT_FALSE(find_inexactness(draw.vertices[0].position.x, {viewport->x, viewport->width}, 'x',
                                draw.vertices[0].w));
  EXPECT_FALSE(find_inexactness(draw.vertices[0].position.y, {viewport->y, viewport->height}, 'y',
                                draw.vertices[0].w));
  EXPECT_EQ(viewport->width, 8);    // centre 4
  EXPECT_EQ(viewport->height, 32);  // 16 high, its centre would be 8: 3 pixels off
}

TEST(Viewport, ClipCoordinatesTakeThatOfTheTarget) {
  Draw draw = points_at({whole(-7, 3), whole(2, 2)});
  EXPECT_EQ(choose_viewport(target_of(8, 8), {draw})->width, 16);
  draw.vertices[0].clip = ClipPosition{};
  const auto viewport = choose_viewport(target_of(9, 8), {draw});
  EXPECT_EQ(viewport->x, 0);
  EXPECT_EQ(viewport->width, 16);
  EXPECT_EQ(viewport->height, 8);
}

// The check speaks exactly when float32 arithmetic would move the vertex or clip it.
TEST(Viewport, FindsInexactnessInEveryOddViewport) {
  for (int size = 1; size <= 48; ++size) {
    const ViewportSide side{-3, size};
    for (std::int64_t sixteenth = -3 * 16 + 1; sixteenth < (size - 3) * 16; ++sixteenth) {
      const Fixed x = Fixed::from_raw(sixteenth * Fixed::kOne / 16);
      const double half = size / 2.0;
      // Exact in double where it is dyadic at all: 10 significant bits over an odd factor.
      const double clip = (x.to_double() - (-3 + half)) / half;
      const bool dyadic = clip * 1048576 == static_cast<double>(static_cast<long>(clip * 1048576));
      EXPECT_EQ(!find_inexactness(x, side, 'x').has_value(), dyadic) << size << " " << sixteenth;
    }
  }
  EXPECT_TRUE(find_inexactness(Fixed::from_integer(0), {0, 8}, 'x').has_value());
  EXPECT_TRUE(find_inexactness(Fixed::from_integer(8), {0, 8}, 'x').has_value());
  EXPECT_TRUE(find_inexactness(Fixed::from_raw((1 << 26) + 1), {0, 4096}, 'x').has_value());
}

}  // namespace
}  // namespace edgecase
