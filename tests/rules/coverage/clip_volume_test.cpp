// SPDX-License-Identifier: MIT
//
// Clipped triangles, without clipping: against the literal solution in fractions.
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/clip_polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "rules/coverage/triangle_fill.h"
#include "rules/values/clipped_attributes.h"
#include "rules/values/interpolation.h"
#include "tests/oracles/clip_space.h"
#include "tests/support/share.h"

namespace edgecase {
namespace {

constexpr Viewport kViewport{1, 2, 8, 4};
constexpr int kSize = 10;  // of the target: the viewport's sides lie inside of it

using ClipTriangle = std::array<ClipPosition, 3>;

Scene scene_of(const ClipTriangle& triangle) {
  Scene scene;
  scene.target.width = scene.target.height = kSize;
  scene.viewport = kViewport;
  Draw& draw = scene.draws.emplace_back();
  for (const ClipPosition& clip : triangle) {
    Vertex vertex;
    vertex.clip = clip;
    vertex.w = clip.w;
    draw.vertices.push_back(vertex);
  }
  return scene;
}

class ClipTriangles {
 public:
  float number(int limit) {
    return static_cast<float>(std::uniform_int_distribution<int>(-limit, limit)(random_));
  }
  // Small integers, so that edges run through samples and vertices lie on planes.
  ClipTriangle small() {
    ClipTriangle triangle;
    for (ClipPosition& clip : triangle) clip = {number(4), number(4), number(3), number(2)};
    return triangle;
  }
  // All 24 bits of float32 and exponents far apart.
  ClipTriangle large() {
    ClipTriangle triangle;
    for (ClipPosition& clip : triangle) {
      const float scale = std::ldexp(1.0F, static_cast<int>(number(20)));
      const auto component = [&] { return number(1 << 24) * scale; };
      clip = {component(), component(), component(), component()};
    }
    return triangle;
  }
  ClipTriangle any(int round) { return round % 3 == 0 ? large() : small(); }

 private:
  std::mt19937_64 random_{share_seed(41)};
};

Rational square(const Rational& x) {
  return x * x;
}

// With the sample moved by (e, -e^2), as left-top has it.
bool literally_covered(const ClipTriangle& triangle, PixelPosition pixel, bool depth) {
  const Rational e = power_of_two(-200);
  const Rational x = Rational(2 * pixel.x + 1) / 2, y = Rational(2 * pixel.y + 1) / 2;
  const auto at = [&](const Rational& px, const Rational& py) {
    return oracle::shares_at(triangle, oracle::normalized(px, kViewport.x, kViewport.width),
                             oracle::normalized(py, kViewport.y, kViewport.height));
  };
  if (x < kViewport.x || x > kViewport.x + kViewport.width) return false;
  if (y < kViewport.y || y > kViewport.y + kViewport.height) return false;
  const auto b = at(x, y);
  if (!b) return false;
  // Far from all edges the move changes nothing, and its numbers are long.
  const bool tied = std::ranges::any_of(*b, [](const Rational& share) { return share == 0; });
  const auto moved = tied ? at(Rational(x + e), Rational(y - square(e))) : b;
  if (std::ranges::any_of(*moved, [](const Rational& share) { return share < 0; })) return false;
  if (!depth) return true;
  Rational z = 0;
  for (std::size_t i = 0; i < 3; ++i) z += (*b)[i] * rational_of(triangle[i].z);
  return z >= -1 && z <= 1;
}

TEST(ClipVolume, HoldsTheSamplesThatTheLiteralSolutionHas) {
  ClipTriangles random;
  const TieRule& ties = *find_tie_rule("left-top");
  int behind = 0, cut = 0, covered = 0;
  for (int round = 0; round < share_of(900, 150); ++round) {
    const ClipTriangle triangle = random.any(round);
    const Scene scene = scene_of(triangle);
    const ScenePrimitive primitive = primitives_of(scene)[0];
    const UnclippedTriangle given{primitive.positions, primitive.z};
    for (const bool depth : {true, false}) {
      const auto pixels = clipped_triangle_pixels(given, kViewport, {0, 0, kSize - 1, kSize - 1},
                                                  ties, centre_of_pixel(), depth);
      for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) {
          const bool drawn = std::ranges::find(pixels, PixelPosition{x, y}) != pixels.end();
          ASSERT_EQ(drawn, literally_covered(triangle, {x, y}, depth))
              << "round " << round << " (" << x << ", " << y << ") depth " << depth;
          covered += drawn;
          cut += drawn && !depth && !literally_covered(triangle, {x, y}, true);
        }
    }
    behind += std::ranges::any_of(triangle, [](const ClipPosition& c) { return c.w <= 0; });
  }
  EXPECT_GT(behind, least_of(300));
  EXPECT_GT(cut, least_of(300));
  EXPECT_GT(covered, least_of(3000));
}

// The polygon that clipping makes holds the same samples, but for those near its border.
TEST(ClipVolume, ThePolygonHoldsTheSameSamplesButAtItsBorder) {
  ClipTriangles random;
  const TieRule& ties = *find_tie_rule("left-top");
  int inside = 0;
  for (int round = 0; round < 900; ++round) {
    const ClipTriangle triangle = random.any(round);
    const Scene scene = scene_of(triangle);
    const ScenePrimitive primitive = primitives_of(scene)[0];
    const UnclippedTriangle given{primitive.positions, primitive.z};
    const auto polygon = clip_polygon(given, sides_of(kViewport), 100000);
    ASSERT_LE(polygon.size(), 9u);
    const auto covered = clipped_triangle_pixels(given, kViewport, {0, 0, kSize - 1, kSize - 1},
                                                 ties, centre_of_pixel());
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const Point sample = pixel_centre(x, y);
        // On one side of all edges, by more than rounding.
        int left = 0, right = 0;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const Point a = polygon[i].position, b = polygon[(i + 1) % polygon.size()].position;
          left += robustly_left(a, b, sample, Fixed::from_raw(2));
          right += robustly_left(b, a, sample, Fixed::from_raw(2));
        }
        const int edges = static_cast<int>(polygon.size());
        if (edges == 0) continue;
        const bool is_covered = std::ranges::find(covered, PixelPosition{x, y}) != covered.end();
        if (left == edges || right == edges) {
          EXPECT_TRUE(is_covered) << round << " (" << x << ", " << y << ")";
          ++inside;
        } else if (left > 0 && right > 0) {
          // Robustly outside of one edge and inside of another.
          EXPECT_FALSE(is_covered) << round << " (" << x << ", " << y << ")";
        }
      }
  }
  EXPECT_GT(inside, 1000);
}

// The wider the three places stand apart, the better the plane between them is known: none of the
// polygon that is seen span a larger triangle.
TEST(ClippedPlane, ItsPlacesSpanTheLargestTriangle) {
  ClipTriangles random;
  int without_the_first = 0;
  for (int round = 0; round < 900; ++round) {
    const Scene scene = scene_of(random.any(round));
    const ScenePrimitive primitive = primitives_of(scene)[0];
    const auto plane = ClippedPlane::of(primitive);
    if (!plane) continue;
    std::vector<HomogeneousPoint> corners;
    for (const ClipPolygonVertex& vertex : seen_polygon(primitive))
      corners.push_back(homogeneous(vertex.position));
    Int128 largest = 0;
    for (const HomogeneousPoint& a : corners)
      for (const HomogeneousPoint& b : corners)
        for (const HomogeneousPoint& c : corners) largest = std::max(largest, cross(a, b, c));
    const auto& places = plane->positions();
    const Int128 area = cross(places[0], places[1], places[2]);
    EXPECT_EQ(area < 0 ? -area : area, largest) << round;
    without_the_first += std::none_of(places.begin(), places.end(), [&](const auto& place) {
      return same_point(place, corners[0]);
    });
  }
  EXPECT_GT(without_the_first, 20);
}

// Attributes and depths of what is seen, at the centres of pixels, against the solution in
// fractions: each interval holds it and is narrow.
TEST(ClippedPlane, HoldsWhatTheLiteralSolutionHas) {
  ClipTriangles random;
  int compared = 0, wide = 0;
  for (int round = 0; round < 900; ++round) {
    const ClipTriangle triangle = random.any(round);
    const Scene scene = scene_of(triangle);
    const ScenePrimitive primitive = primitives_of(scene)[0];
    const auto plane = ClippedPlane::of(primitive);
    if (!plane) continue;
    const std::array<double, 3> values{0.25, -3, 7};
    Interpolant smooth{
        PrimitiveKind::triangle,  plane->positions(), plane->smooth(values), plane->w(), true,
        LineParameter::projection};
    Interpolant plain{PrimitiveKind::triangle,
                      plane->positions(),
                      plane->noperspective(values),
                      {1, 1, 1},
                      false,
                      LineParameter::projection};
    Interpolant depth{
        PrimitiveKind::triangle,  plane->positions(), plane->depths(), {1, 1, 1}, false,
        LineParameter::projection};
    Interpolant over = inverse_w(smooth);
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        if (!literally_covered(triangle, {x, y}, true)) continue;
        const auto b = oracle::shares_at(
            triangle, oracle::normalized(Rational(2 * x + 1) / 2, kViewport.x, kViewport.width),
            oracle::normalized(Rational(2 * y + 1) / 2, kViewport.y, kViewport.height));
        Rational value = 0, sum = 0, z = 0, in_window = 0, largest = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          value += (*b)[i] * rational_of(values[i]);
          const Rational share = (*b)[i] * rational_of(triangle[i].w);
          in_window += share * rational_of(values[i]);
          largest = std::max(largest, Rational(share < 0 ? -share : share));
          sum += (*b)[i];
          z += (*b)[i] * rational_of(triangle[i].z);
        }
        const Point sample = pixel_centre(x, y);
        const auto holds = [&](Interval interval, const Rational& exact, double scale) {
          const Interval narrow = interval_of(exact);
          EXPECT_LE(interval.low, narrow.high) << round;
          EXPECT_GE(interval.high, narrow.low) << round;
          if (interval.high - interval.low > std::ldexp(scale, -30)) ++wide;
        };
        holds(interpolate_exact(smooth, sample), value / sum, 7);
        holds(interpolate_exact(plain, sample), in_window, 7 * interval_of(largest).high);
        holds(interpolate_exact(depth, sample), z, 1);
        holds(interpolate_exact(over, sample), sum, interval_of(sum).high);
        ++compared;
      }
  }
  EXPECT_GT(compared, 1000);
  EXPECT_LT(wide, compared / 100);
}

}  // namespace
}  // namespace edgecase
