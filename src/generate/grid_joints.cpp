// SPDX-License-Identifier: MIT
#include "generate/grid_joints.h"

#include <array>
#include <span>
#include <vector>

#include "generate/random_source.h"
#include "generate/scene_parts.h"

namespace edgecase {
namespace {

constexpr std::uint64_t kStream = 0x6400;
constexpr int kSize = 16;        // of the target, in pixels
constexpr int kSixteenths = 16;  // a pixel

// A point inside the target at multiples of so many sixteenths of a pixel.
Point random_point(RandomSource& random, std::int64_t step) {
  const auto coordinate = [&] {
    return Fixed::from_raw(random.between(1, kSize * kSixteenths / step - 1) * step * Fixed::kOne /
                           kSixteenths);
  };
  const Fixed x = coordinate();
  return {x, coordinate()};
}

}  // namespace

Scene grid_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  constexpr std::array<std::int64_t, 4> kStepsOfJoints{8, 8, 4, 1};
  constexpr std::array<std::int64_t, 4> kStepsOfEnds{8, 4, 2, 1};
  RandomSource random(seed, kStream, index);
  std::vector<Point> points;
  for (int i = 0; i < kGridJointsOfScene; ++i) {
    const Point joint =
        random_point(random, random.one_of(std::span<const std::int64_t>(kStepsOfJoints)));
    const auto end = [&] {
      return random_point(random, random.one_of(std::span<const std::int64_t>(kStepsOfEnds)));
    };
    points.insert(points.end(), {end(), joint, joint, end()});
  }
  Scene scene = scene_of(surface, kSize, Primitive::lines, points);
  if (random.one_in(4)) scene.draws[0].line_width = Fixed::from_raw(Fixed::kOne / 2);
  return scene;
}

}  // namespace edgecase
