// SPDX-License-Identifier: MIT
#include <array>
#include <span>
#include <vector>

#include "generate/random_scenes.h"
#include "generate/random_shapes.h"

namespace edgecase {
namespace {

// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kStream = 0x6300;
constexpr std::int64_t kOne = Fixed::kOne;
constexpr int kMostTarget = 16;  // pixels

// An offset from a multiple of `step`: 0, halfway to the next, or close to either.
std::int64_t random_offset(RandomSource& random, std::int64_t step) {
  if (random.one_in(3)) return 0;
  const std::int64_t place = random.between(-3, 3) * (step / 2);
  return place + random.between(-1, 1);
}

class Places {
 public:
  Places(RandomSource& random, int target) : random_(random), target_(target) {
    constexpr std::array kBits{4, 4, 4, 8, 8, 8, 0, 0};
    const int bits = random.one_of(std::span<const int>(kBits));
    step_ = kOne >> (bits == 0 ? random.between(2, 12) : bits);
  }

  // Near a multiple of half a pixel, an odd one if `on_centre`.
  Fixed coordinate(bool on_centre) {
    const std::int64_t whole = random_.between(1, target_ - 2) * kOne + (on_centre ? kOne / 2 : 0);
    return Fixed::from_raw(whole + random_offset(random_, step_));
  }
  Point point(bool on_centre) {
    const Fixed x = coordinate(on_centre);
    return {x, coordinate(on_centre)};
  }
  // Any multiple of the step, a point halfway, or a point close to either.
  Fixed anywhere() {
    const std::int64_t steps = random_.between(1, (target_ - 1) * (kOne / step_) - 1);
    return Fixed::from_raw(steps * step_ + random_offset(random_, step_));
  }

 private:
  RandomSource& random_;
  int target_;
  std::int64_t step_ = kOne;
};

// Most edges are axis-aligned, so that a vertex's snap decides a whole row of samples.
std::vector<Point> triangle_of(RandomSource& random, Places& places) {
  const Point corner = places.point(true);
  if (random.one_in(3)) return {corner, places.point(random.one_in(2)), places.point(true)};
  std::vector<Point> points{corner, {corner.x, places.anywhere()}, {places.anywhere(), corner.y}};
  if (random.one_in(2)) std::swap(points[0], points[1]);
  return points;
}

std::vector<Point> line_of(RandomSource& random, Places& places) {
  // An end at a diamond's corner or centre: one coordinate whole, one a half.
  const auto end = [&] {
    const bool upright = random.one_in(2);
    const Fixed x = places.coordinate(upright);
    return Point{x, places.coordinate(!upright)};
  };
  const Point a = end();
  if (random.one_in(2)) return {a, end()};
  const bool upright = random.one_in(2);
  const Fixed other = places.anywhere();
  return {a, upright ? Point{a.x, other} : Point{other, a.y}};
}

bool are_inside(const std::vector<Point>& points, int target) {
  for (const Point& point : points)
    if (!strictly_inside(point, target)) return false;
  return true;
}

}  // namespace

Scene random_snap_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kStream, index);
  for (;;) {
    const int target = random_frame(random, kMostTarget).target;
    Places places(random, target);
    std::vector<Point> points;
    Primitive primitive = Primitive::triangles;
    switch (random.below(4)) {
      case 0:
        primitive = Primitive::points;
        points = {places.point(false)};
        break;
      case 1:
        primitive = Primitive::lines;
        points = line_of(random, places);
        break;
      default:
        points = triangle_of(random, places);
        break;
    }
    // Offsets may cross the target's border.
    if (are_inside(points, target)) return scene_of(surface, target, primitive, points);
  }
}

}  // namespace edgecase
