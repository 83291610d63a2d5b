// SPDX-License-Identifier: MIT
//
// Probes of chains: connected segments, and triangles that share edges.
#include <algorithm>
#include <array>

#include "generate/grids.h"
#include "generate/random_shapes.h"
#include "profile/coverage/coverage.h"
#include "rules/coverage/line_joints.h"

namespace edgecase {

// ------------------------------------------------------------------------------------------ joints

// Chains of segments. First their first joint is at every place of a diamond, for every direction
// of the chain; then joints are anywhere, at places of diamonds and close together; finally chains
// turn. Chains that are not enumerated come from a generator with a fixed seed.

namespace {

constexpr int kTarget = 32;
constexpr std::int64_t kOne = Fixed::kOne;
constexpr std::uint64_t kSeed = 20260401;
constexpr int kWanderingChains = 400;

enum Stream : std::uint64_t { kPlaced, kWandering, kTurning };

using Chain = std::vector<Point>;

std::int64_t random_chain_step(RandomSource& random) {
  constexpr std::array kBits{1, 2, 4, 4, 8, 8, 16};
  return kOne >> random.one_of(std::span<const int>(kBits));
}

// From less than a pixel to five.
std::int64_t random_length(RandomSource& random) {
  return random.one_in(4) ? random.between(kOne / 8, kOne) : random.between(kOne, 5 * kOne);
}

// Shifts the chain by whole pixels to the middle of the target; false if it is too long.
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

// A strip contains each joint once, separate lines contain it twice.
Scene joint_scene(Surface surface, const Chain& chain, bool as_strip) {
  if (as_strip) return scene_of(surface, kTarget, Primitive::line_strip, chain);
  return scene_of(surface, kTarget, Primitive::lines, separate_lines(chain));
}

// A chain in one direction whose first joint is at a place of pixel (0, 0).
Chain placed_chain(RandomSource& random, LineDirection direction, DiamondPlace place,
                   int segments) {
  for (;;) {
    const std::int64_t step = random_chain_step(random);
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

// A chain with a constant major axis and direction along it that rises and falls. Its joints are at
// places of diamonds or anywhere.
Chain wandering_chain(RandomSource& random, int segments) {
  for (;;) {
    const std::int64_t step = random_chain_step(random);
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

// Two segments of different directions with their joint at a place of pixel (0, 0), sometimes with
// more segments after the second.
Chain turning_chain(RandomSource& random, LineDirection from, LineDirection to,
                    DiamondPlace place) {
  for (;;) {
    const std::int64_t step = random_chain_step(random);
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

// Every pair of directions once, with alternating places.
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

// ------------------------------------------------------------------------------------ shared edges

// Adjacent triangles. Holes depend on where the common edges lie: through samples, or off them by a
// step of a sub-pixel grid or less. So each shape comes at several fractions of a pixel from a
// sample, as quads, strips and fans.

namespace {

constexpr int kTrianglesTarget = 64;

// The position of a shape: offsets from a pixel's centre, raw.
constexpr std::array<RawVector, 7> kOffsets{{{0, 0},
                                             {kOne / 2, kOne / 2},
                                             {kOne / 16, -kOne / 16},
                                             {kOne / 256, kOne / 512},
                                             {-kOne / 256, kOne / 16},
                                             {1, -1},
                                             {-1, 0}}};

SharedEdgeProbe make_probe(Surface surface, SharedEdgeShape shape, Primitive primitive,
                           const std::vector<Point>& positions) {
  SharedEdgeProbe probe;
  probe.scene = scene_of(surface, kTrianglesTarget, primitive, positions);
  probe.shape = shape;
  return probe;
}

// The triangles of a strip or fan, separately, with the vertex order of every other one reversed.
std::vector<Point> separated(Primitive primitive, const std::vector<Point>& positions) {
  std::vector<Point> result;
  for (std::size_t i = 2; i < positions.size(); ++i) {
    const Point first = primitive == Primitive::triangle_fan ? positions[0] : positions[i - 2];
    const bool reversed = i % 3 == 0;
    result.push_back(first);
    result.push_back(reversed ? positions[i] : positions[i - 1]);
    result.push_back(reversed ? positions[i - 1] : positions[i]);
  }
  return result;
}

// As the primitive itself, and as separate triangles.
void add_both(std::vector<SharedEdgeProbe>& probes, Surface surface, SharedEdgeShape shape,
              Primitive primitive, const std::vector<Point>& positions, bool closed) {
  probes.push_back(make_probe(surface, shape, primitive, positions));
  probes.back().closed = closed;
  probes.push_back(
      make_probe(surface, shape, Primitive::triangles, separated(primitive, positions)));
  probes.back().closed = closed;
}

// The vectors along two sides of a quad, in pixels: upright, square, tilted, flat and thin ones.
struct Quad {
  RawVector across;
  RawVector up;
};
constexpr std::array<Quad, 10> kQuads{{{{1, 0}, {0, 1}},
                                       {{4, 0}, {0, 4}},
                                       {{8, 0}, {0, 3}},
                                       {{2, 0}, {0, 20}},
                                       {{5, 2}, {-2, 5}},
                                       {{4, 4}, {-4, 4}},
                                       {{9, 1}, {-1, 3}},
                                       {{12, 5}, {3, 7}},
                                       {{1, 20}, {-1, 20}},
                                       {{25, 13}, {-6, 11}}}};

void add_quads(std::vector<SharedEdgeProbe>& probes, Surface surface) {
  for (RawVector offset : kOffsets)
    for (const Quad& quad : kQuads)
      for (const bool rising : {true, false}) {
        const Point a = pixel_centre(24, 16) + offset;
        const Point b = a + kOne * quad.across;
        const Point c = b + kOne * quad.up;
        const Point d = a + kOne * quad.up;
        const std::vector<Point> split =
            rising ? std::vector<Point>{a, b, c, c, d, a} : std::vector<Point>{b, c, d, a, b, d};
        probes.push_back(make_probe(surface, SharedEdgeShape::quad, Primitive::triangles, split));
      }
}

// A strip between two rows of vertices: `run` between vertices of a row, `rise` from row to row,
// shifted by half a run; raw, along x or along y.
struct Strip {
  int triangles;
  std::int64_t run;
  std::int64_t rise;
  std::int64_t slant;  // rise of a row from vertex to vertex
};
constexpr std::array<Strip, 7> kStrips{{{4, 4 * kOne, 5 * kOne, 0},
                                        {9, 2 * kOne, 2 * kOne, 0},
                                        {14, 6 * kOne, 8 * kOne, kOne},
                                        {20, 2 * kOne, 30 * kOne, kOne},
                                        {24, kOne, 12 * kOne, 0},
                                        {40, kOne / 2, 20 * kOne, kOne / 16},
                                        {60, kOne / 8, 40 * kOne, kOne / 256}}};

std::vector<Point> strip_points(const Strip& strip, RawVector offset, bool along_x) {
  const Point start = pixel_centre(5, 5) + offset;
  std::vector<Point> result;
  for (int i = 0; i < strip.triangles + 2; ++i) {
    const std::int64_t along = i * strip.run / 2;
    const std::int64_t across = i % 2 * strip.rise + i / 2 * strip.slant;
    result.push_back(start + (along_x ? RawVector{along, across} : RawVector{across, along}));
  }
  return result;
}

void add_strips(std::vector<SharedEdgeProbe>& probes, Surface surface) {
  for (RawVector offset : kOffsets)
    for (const Strip& strip : kStrips)
      for (const bool along_x : {true, false})
        add_both(probes, surface, SharedEdgeShape::strip, Primitive::triangle_strip,
                 strip_points(strip, offset, along_x), false);
}

// A point on the border of the square |x|, |y| <= radius, counter-clockwise from its lower right
// corner; `way` is 0 to 8 radii, of which whole radii are corners and middles of sides.
RawVector on_square(std::int64_t radius, std::int64_t way) {
  const std::int64_t side = way / (2 * radius) % 4;
  const std::int64_t on_side = way % (2 * radius) - radius;
  switch (side) {
    case 0:
      return {radius, on_side};
    case 1:
      return {-on_side, radius};
    case 2:
      return {-radius, -on_side};
    default:
      return {on_side, -radius};
  }
}

// If closed, the last vertex repeats the first of the rim. Otherwise the rim is a part of the right
// side, half a radius long, which makes slivers.
std::vector<Point> fan_points(int triangles, std::int64_t radius, RawVector offset, bool closed) {
  const Point hub = pixel_centre(kTrianglesTarget / 2, kTrianglesTarget / 2) + offset;
  std::vector<Point> result{hub};
  for (int i = 0; i <= triangles; ++i) {
    const std::int64_t all = closed ? 8 * radius : radius / 2;
    const std::int64_t first = closed ? 0 : 3 * radius / 4;
    const std::int64_t way = first + (closed ? i % triangles : i) * all / triangles;
    result.push_back(hub + on_square(radius, way));
  }
  return result;
}

void add_fans(std::vector<SharedEdgeProbe>& probes, Surface surface) {
  constexpr std::array kTriangles{3, 4, 5, 6, 7, 8, 12, 16, 24, 32, 48, 64};
  // Whole, so that edges through the hub meet other samples; and one that is not.
  constexpr std::array<std::int64_t, 3> kRadii{4 * kOne, 24 * kOne, 19 * kOne + kOne * 5 / 16};
  for (RawVector offset : kOffsets)
    for (int triangles : kTriangles)
      for (std::int64_t radius : kRadii)
        for (const bool closed : {true, false})
          add_both(probes, surface, SharedEdgeShape::fan, Primitive::triangle_fan,
                   fan_points(triangles, radius, offset, closed), closed);
}

}  // namespace

std::vector<SharedEdgeProbe> shared_edge_probes(Surface surface) {
  std::vector<SharedEdgeProbe> result;
  add_quads(result, surface);
  add_strips(result, surface);
  add_fans(result, surface);
  return result;
}

}  // namespace edgecase
