// SPDX-License-Identifier: MIT
//
// Chains of segments. Their first joint lies at every place of a diamond, for every direction that
// they go on in; then joints lie anywhere, at places of diamonds and close together; last, chains
// turn. What is not enumerated comes from a generator with a fixed seed.
#include <algorithm>
#include <array>

#include "generate/diamond_places.h"
#include "generate/scene_parts.h"
#include "profile/probes/probe_scenes.h"
#include "rules/coverage/line_joints.h"

namespace edgecase {
namespace {

constexpr int kTarget = 32;
constexpr std::int64_t kOne = Fixed::kOne;
constexpr std::uint64_t kSeed = 20260401;
constexpr int kWanderingChains = 400;

enum Stream : std::uint64_t { kPlaced, kWandering, kTurning };

using Chain = std::vector<Point>;

std::int64_t random_step(RandomSource& random) {
  constexpr std::array kBits{1, 2, 4, 4, 8, 8, 16};
  return kOne >> random.one_of(std::span<const int>(kBits));
}

// From less than a pixel to five.
std::int64_t random_length(RandomSource& random) {
  return random.one_in(4) ? random.between(kOne / 8, kOne) : random.between(kOne, 5 * kOne);
}

// Shifts the chain by whole pixels to the middle of the target; false where it is too long.
bool centre_chain(Chain& chain) {
  const auto by_x = [](Point p, Point q) { return p.x < q.x; };
  const auto by_y = [](Point p, Point q) { return p.y < q.y; };
  const auto [left, right] = std::minmax_element(chain.begin(), chain.end(), by_x);
  const auto [bottom, top] = std::minmax_element(chain.begin(), chain.end(), by_y);
  const auto shift = [](Fixed low, Fixed high) {
    return kTarget / 2 - Fixed::from_raw((low.raw() + high.raw()) / 2).floor();
  };
  const std::int64_t dx = shift(left->x, right->x) * kOne;
  const std::int64_t dy = shift(bottom->y, top->y) * kOne;
  for (Point& point : chain) point = point + RawVector{dx, dy};
  return std::all_of(chain.begin(), chain.end(),
                     [](Point p) { return strictly_inside(p, kTarget); });
}

// A strip has each joint once, separate lines have it twice.
Scene joint_scene(Surface surface, const Chain& chain, bool as_strip) {
  if (as_strip) return scene_of(surface, kTarget, Primitive::line_strip, chain);
  Chain pairs;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    pairs.push_back(chain[i - 1]);
    pairs.push_back(chain[i]);
  }
  return scene_of(surface, kTarget, Primitive::lines, pairs);
}

// A chain in one direction whose first joint lies at a place of pixel (0, 0).
Chain placed_chain(RandomSource& random, LineDirection direction, DiamondPlace place,
                   int segments) {
  for (;;) {
    const std::int64_t step = random_step(random);
    const Point joint = random_point_at(place, random, std::min(step, kOne / 16));
    const std::int64_t first = random_length(random);
    Chain chain{joint - random_along(random, direction, first, step), joint};
    while (static_cast<int>(chain.size()) <= segments) {
      const std::int64_t length = random_length(random);
      chain.push_back(chain.back() + random_along(random, direction, length, step));
    }
    if (centre_chain(chain)) return chain;
  }
}

// A chain that keeps its major axis and direction along it, but rises and falls. Its joints lie at
// places of diamonds or anywhere.
Chain wandering_chain(RandomSource& random, int segments) {
  for (;;) {
    const std::int64_t step = random_step(random);
    const int axis = static_cast<int>(4 * random.below(4));
    const auto place = static_cast<DiamondPlace>(random.below(kDiamondPlaces));
    Chain chain{random_point_at(place, random, std::min(step, kOne / 16))};
    while (static_cast<int>(chain.size()) <= segments) {
      // The axis, and the octants and diagonals on either side; 45 degrees counts as x-major.
      const int most = axis % 8 == 0 ? 2 : 1;
      const int direction = (axis + static_cast<int>(random.between(-most, most)) + 16) % 16;
      const std::int64_t length = random_length(random);
      chain.push_back(chain.back() +
                      random_along(random, static_cast<LineDirection>(direction), length, step));
    }
    if (centre_chain(chain)) return chain;
  }
}

// Two segments of different directions with their joint at a place of pixel (0, 0), and at times
// more that go on from the second.
Chain turning_chain(RandomSource& random, LineDirection from, LineDirection to,
                    DiamondPlace place) {
  for (;;) {
    const std::int64_t step = random_step(random);
    const Point joint = random_point_at(place, random, std::min(step, kOne / 16));
    const std::int64_t before = random_length(random);
    Chain chain{joint - random_along(random, from, before, step), joint};
    const std::int64_t more = random.between(1, 3);
    for (std::int64_t i = 0; i < more; ++i) {
      const std::int64_t length = random_length(random);
      chain.push_back(chain.back() + random_along(random, to, length, step));
    }
    if (centre_chain(chain)) return chain;
  }
}

bool turns(const Chain& chain) {
  return !goes_on({chain[0], chain[1]}, {chain[1], chain[2]});
}

void add_placed(std::vector<JointProbe>& probes, Surface surface) {
  for (int direction = 0; direction < kLineDirections; ++direction)
    for (int place = 0; place < kDiamondPlaces; ++place)
      for (int variant = 0; variant < 4; ++variant) {
        RandomSource random(kSeed, kPlaced, probes.size());
        JointProbe probe;
        probe.direction = static_cast<LineDirection>(direction);
        probe.place = static_cast<DiamondPlace>(place);
        const int segments = variant < 2 ? 2 : static_cast<int>(random.between(3, 6));
        const Chain chain = placed_chain(random, *probe.direction, *probe.place, segments);
        probe.scene = joint_scene(surface, chain, variant % 2 == 0);
        probes.push_back(std::move(probe));
      }
}

void add_wandering(std::vector<JointProbe>& probes, Surface surface) {
  for (int i = 0; i < kWanderingChains; ++i) {
    RandomSource random(kSeed, kWandering, static_cast<std::uint64_t>(i));
    JointProbe probe;
    const Chain chain = wandering_chain(random, static_cast<int>(random.between(2, 6)));
    probe.scene = joint_scene(surface, chain, i % 2 == 0);
    probes.push_back(std::move(probe));
  }
}

// Every pair of directions once, the places in turn.
void add_turning(std::vector<JointProbe>& probes, Surface surface) {
  for (int from = 0; from < kLineDirections; ++from)
    for (int to = 0; to < kLineDirections; ++to) {
      const int number = from * kLineDirections + to;
      RandomSource random(kSeed, kTurning, static_cast<std::uint64_t>(number));
      JointProbe probe;
      probe.place = static_cast<DiamondPlace>(number % kDiamondPlaces);
      const Chain chain = turning_chain(random, static_cast<LineDirection>(from),
                                        static_cast<LineDirection>(to), *probe.place);
      if (!turns(chain)) continue;
      probe.goes_on = false;
      probe.scene = joint_scene(surface, chain, number % 2 == 0);
      probes.push_back(std::move(probe));
    }
}

}  // namespace

std::vector<JointProbe> joint_probes(Surface surface) {
  std::vector<JointProbe> result;
  add_placed(result, surface);
  add_wandering(result, surface);
  add_turning(result, surface);
  return result;
}

}  // namespace edgecase
