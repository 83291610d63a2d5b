// SPDX-License-Identifier: MIT
#include <algorithm>
#include <vector>

#include "generate/diamond_places.h"
#include "generate/random_scenes.h"
#include "generate/random_shapes.h"

namespace edgecase {
namespace {

// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kStream = 0x6100;
constexpr int kFinestSnap = 12;
constexpr std::int64_t kOne = Fixed::kOne;

using Chain = std::vector<Point>;

enum class Course {
  straight,   // one direction
  wandering,  // one major axis and direction along it
  turning,    // any directions
  back,       // to and fro
};

// A direction with the same major axis and sign; 45 degrees counts as x-major.
LineDirection neighbour_of(RandomSource& random, LineDirection direction) {
  const int axis = (static_cast<int>(direction) + 2) / 4 * 4;
  const int most = axis % 8 == 0 ? 2 : 1;
  return static_cast<LineDirection>((axis + random.between(-most, most) + kLineDirections) %
                                    kLineDirections);
}

LineDirection next_direction(RandomSource& random, Course course, LineDirection direction) {
  switch (course) {
    case Course::straight:
      return direction;
    case Course::wandering:
      return neighbour_of(random, direction);
    case Course::turning:
      return static_cast<LineDirection>(random.below(kLineDirections));
    case Course::back:
      return static_cast<LineDirection>((static_cast<int>(direction) + kLineDirections / 2) %
                                        kLineDirections);
  }
  return direction;
}

Course random_course(RandomSource& random) {
  const std::int64_t share = random.below(16);
  return share < 4    ? Course::straight
         : share < 9  ? Course::wandering
         : share < 15 ? Course::turning
                      : Course::back;
}

bool spans_at_most(const Chain& chain, std::int64_t most) {
  for (const Point& p : chain)
    for (const Point& q : chain)
      if ((p - q).x > most || (p - q).y > most) return false;
  return true;
}

// The first joint is at a place of pixel (0, 0), where a segment's end is usually a tie.
Chain random_chain(RandomSource& random, const Frame& frame, std::int64_t step) {
  const auto place = static_cast<DiamondPlace>(random.below(kDiamondPlaces));
  const Point joint = random_point_at(place, random, std::min(step, kOne / 16));
  const Course course = random_course(random);
  const std::int64_t segments = random.between(2, 6);
  const std::int64_t most = std::max(2 * frame.most / (3 * segments), 2 * step);
  const auto length = [&] {
    return random.one_in(4) ? random.between(kOne / 8, kOne) : random.between(1, most);
  };
  auto direction = static_cast<LineDirection>(random.below(kLineDirections));
  if (course == Course::wandering) direction = neighbour_of(random, direction);
  Chain chain{joint - random_along(random, direction, length(), step), joint};
  while (static_cast<std::int64_t>(chain.size()) <= segments) {
    direction = next_direction(random, course, direction);
    chain.push_back(chain.back() + random_along(random, direction, length(), step));
  }
  return chain;
}

Chain fitting_chain(RandomSource& random, const Frame& frame) {
  for (;;) {
    const Theme theme = random_theme(random);
    const std::int64_t step = std::min(step_of(random, theme), kOne / 2);
    Chain chain = random_chain(random, frame, step);
    if (!spans_at_most(chain, frame.most)) continue;
    if (random.one_in(2)) std::reverse(chain.begin(), chain.end());
    shift_inside(random, frame.target, chain);
    if (theme == Theme::near_tie) nudge(random, kFinestSnap, frame.target, chain);
    return chain;
  }
}

Chain separated(const Chain& chain) {
  Chain pairs;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    pairs.push_back(chain[i - 1]);
    pairs.push_back(chain[i]);
  }
  return pairs;
}

Scene drawn(RandomSource& random, Surface surface, int target, const Chain& chain) {
  switch (random.below(4)) {
    case 0:
      return scene_of(surface, target, Primitive::lines, separated(chain));
    case 1:
      return scene_of(surface, target, Primitive::line_loop, chain);
    default:
      return scene_of(surface, target, Primitive::line_strip, chain);
  }
}

}  // namespace

Scene random_joint_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kStream, index);
  // Two segments of two steps each need room.
  const Frame frame = with_room(random_frame(random, kMostCompoundTarget));
  Scene scene = drawn(random, surface, frame.target, fitting_chain(random, frame));
  if (random.one_in(8))
    scene.draws[0].line_width = Fixed::from_raw(random.between(5, 24) * kOne / 4);
  return scene;
}

}  // namespace edgecase
