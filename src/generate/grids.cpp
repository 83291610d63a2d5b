// SPDX-License-Identifier: MIT
#include "generate/grids.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>
#include <vector>

#include "generate/random_scenes.h"
#include "generate/random_shapes.h"

namespace edgecase {
namespace {

constexpr std::int64_t kHalf = Fixed::kOne / 2;

// The quadrant of a slanting edge or of a place outside the diamond, as signs of x and y.
struct Quarter {
  std::int64_t x;
  std::int64_t y;
};
constexpr std::array<Quarter, 4> kQuarters{{{-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

Point at_offset(std::int64_t dx, std::int64_t dy) {
  return {Fixed::from_raw(kHalf + dx), Fixed::from_raw(kHalf + dy)};
}

}  // namespace

Point point_at(DiamondPlace place, std::int64_t along) {
  const int number = static_cast<int>(place);
  if (place == DiamondPlace::left_corner) return at_offset(-kHalf, 0);
  if (place == DiamondPlace::right_corner) return at_offset(kHalf, 0);
  if (place == DiamondPlace::bottom_corner) return at_offset(0, -kHalf);
  if (place == DiamondPlace::top_corner) return at_offset(0, kHalf);
  if (place == DiamondPlace::inside) return at_offset(along / 2, -(along / 4));
  const bool on_edge = number < static_cast<int>(DiamondPlace::inside);
  const int first =
      static_cast<int>(on_edge ? DiamondPlace::lower_left_edge : DiamondPlace::lower_left_outside);
  const Quarter quarter = kQuarters[static_cast<std::size_t>(number - first)];
  const std::int64_t dx = on_edge ? along : kHalf - along / 2;
  const std::int64_t dy = on_edge ? kHalf - along : dx;
  return at_offset(quarter.x * dx, quarter.y * dy);
}

Point random_point_at(DiamondPlace place, RandomSource& random, std::int64_t step) {
  // Halved twice, the result is still a multiple of `step`.
  const bool on_edge = place >= DiamondPlace::lower_left_edge && place < DiamondPlace::inside;
  const std::int64_t stride = on_edge ? step : 4 * step;
  return point_at(place, stride * random.between(1, (kHalf - 1) / stride));
}

RawVector random_along(RandomSource& random, LineDirection direction, std::int64_t length,
                       std::int64_t step) {
  const int number = static_cast<int>(direction);
  const std::int64_t longer = std::max(length / step, std::int64_t{2}) * step;
  const bool on_axis = number % 4 == 0;
  const bool diagonal = number % 4 == 2;
  const std::int64_t between = random.between(1, longer / step - 1) * step;
  const std::int64_t shorter = on_axis ? 0 : diagonal ? longer : between;
  const bool x_major = number % 8 <= 2 || number % 8 >= 6;
  const bool left = number > 4 && number < 12;
  const bool down = number > 8;
  const RawVector v = x_major ? RawVector{longer, shorter} : RawVector{shorter, longer};
  return {left ? -v.x : v.x, down ? -v.y : v.y};
}

namespace {

// A step that visits all of `count` numbers: about the golden section of `count`, so that
// consecutive numbers are far apart.
std::uint64_t stride_of(std::uint64_t count) {
  std::uint64_t stride = count / 1000 * 618 + count % 1000 * 618 / 1000;
  while (std::gcd(stride, count) != 1) ++stride;
  return stride;
}

// `count` lines, starting with number `first`.
Scene scene_of_lines(std::uint64_t seed, Surface surface, std::uint64_t first,
                     std::uint64_t count) {
  std::vector<Point> ends;
  for (std::uint64_t i = 0; i < count; ++i)
    for (const Point end : kReadableLines.line(kReadableLines.strewn(seed, first + i)))
      ends.push_back(end);
  return scene_of(surface, 16, Primitive::lines, ends);
}

}  // namespace

// All pairs of coordinates of which at least one lies in the first pixel.
std::uint64_t GridLines::pairs() const {
  const auto places = static_cast<std::uint64_t>(size_) * static_cast<std::uint64_t>(steps_) - 1;
  const std::uint64_t beyond = places - static_cast<std::uint64_t>(steps_);
  return places * places - beyond * beyond;
}

// First the pairs whose first coordinate lies in the first pixel, then those with only the second
// there.
std::array<Fixed, 2> GridLines::pair(std::uint64_t number) const {
  const auto steps = static_cast<std::uint64_t>(steps_);
  const auto places = static_cast<std::uint64_t>(size_) * steps - 1;
  const auto at = [&](std::uint64_t place) {
    return Fixed::from_raw(static_cast<std::int64_t>(place + 1) * Fixed::kOne / steps_);
  };
  if (number < steps * places) return {at(number / places), at(number % places)};
  number -= steps * places;
  return {at(steps + number / steps), at(number % steps)};
}

std::array<Point, 2> GridLines::line(std::uint64_t number) const {
  const std::array<Fixed, 2> x = pair(number / pairs());
  const std::array<Fixed, 2> y = pair(number % pairs());
  return {Point{x[0], y[0]}, Point{x[1], y[1]}};
}

std::uint64_t GridLines::strewn(std::uint64_t seed, std::uint64_t index) const {
  const std::uint64_t all = count();
  return (index % all * stride_of(all) + seed % all) % all;
}

Scene grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  return scene_of_lines(seed, surface, index * kGridLinesOfScene, kGridLinesOfScene);
}

Scene wide_grid_line_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  Scene scene = grid_line_scene(seed, surface, index);
  for (Draw& draw : scene.draws) draw.line_width = Fixed::from_integer(2);
  return scene;
}

std::uint64_t grid_line_scenes() {
  return (kReadableLines.count() + kGridLinesOfScene - 1) / kGridLinesOfScene;
}

Scene multisampled_grid_line_scene(std::uint64_t seed, Surface, std::uint64_t index) {
  Scene scene = scene_of_lines(seed, Surface::fbo, index, 1);
  scene.target.samples = 4;
  return scene;
}

std::uint64_t multisampled_grid_line_scenes() {
  return kReadableLines.count();
}

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
