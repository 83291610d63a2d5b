// SPDX-License-Identifier: MIT
#include "generate/seam_scenes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <vector>

#include "generate/grids.h"
#include "generate/random_scenes.h"

namespace edgecase {
namespace {

// Generators of one seed with different purposes are independent.
constexpr std::uint64_t kStream = 0x6600;
constexpr std::int64_t kOne = Fixed::kOne;
constexpr int kLeastBits = 4;
constexpr int kMostBits = 16;
constexpr int kSignificantBits = 24;  // of single precision

// Whole numbers c with turn(u, c) = 1, by Euclid's algorithm.
std::optional<RawVector> unit_turn(RawVector u) {
  // Each remainder is x * u.x + y * u.y.
  struct Step {
    std::int64_t remainder, x, y;
  };
  Step last{u.x, 1, 0};
  Step next{u.y, 0, 1};
  while (next.remainder != 0) {
    const std::int64_t quotient = last.remainder / next.remainder;
    const Step rest{last.remainder - quotient * next.remainder, last.x - quotient * next.x,
                    last.y - quotient * next.y};
    last = next;
    next = rest;
  }
  if (std::abs(last.remainder) != 1) return std::nullopt;
  return last.remainder * RawVector{-last.y, last.x};
}

std::int64_t rounded_quotient(std::int64_t dividend, std::int64_t divisor) {
  const std::int64_t twice = 2 * dividend + divisor;
  const std::int64_t quotient = twice / (2 * divisor);
  return quotient * 2 * divisor > twice ? quotient - 1 : quotient;
}

// The grid and the size of a scene.
struct SeamFrame {
  int target = 0;           // pixels
  std::int64_t step = 0;    // raw, of the grid
  std::int64_t extent = 0;  // raw: the longest that a shape may be

  // Renderers take long to draw large areas, and longer to tell of them.
  bool has_only_slivers() const { return target > kMostRandomExtent; }
};

// A term of an edge function, of a shape of 2^e pixels with b bits, has up to 2 (e + b) - 1 bits:
// the least e with more of them than single precision holds.
int least_exponent(int bits) {
  return std::max(3, kSignificantBits / 2 + 1 - bits);
}

// Seams of 4 bits need large targets, and are rare.
int random_bits(RandomSource& random) {
  constexpr std::array kUsual{8, 8, 8, 12, 12, 16};
  if (random.one_in(32)) return kLeastBits;
  if (random.one_in(8)) return static_cast<int>(random.between(kLeastBits + 1, kMostBits - 1));
  return random.one_of(std::span<const int>(kUsual));
}

SeamFrame random_seam_frame(RandomSource& random) {
  const int bits = random_bits(random);
  const int least = least_exponent(bits);
  const int most = std::min(kSignificantBits - bits, 10);
  const int usual = std::clamp(random.one_in(8) ? 8 : 7, least, most);
  const auto target = static_cast<int>(random.between(least, random.one_in(64) ? most : usual));
  const auto extent = static_cast<int>(random.one_in(2) ? target : random.between(least, target));
  return {1 << target, kOne >> bits, ((std::int64_t{1} << extent) - 1) * kOne - kOne / 4};
}

// From a centre to the near end of an edge that ends `times` as far beyond the centre. Half of the
// edges are so flat or steep, if the grid is fine, that their terms have 1 to 7 bits more than
// single precision holds: with many more, all centres near an edge would be ties.
RawVector to_near_end(RandomSource& random, const SeamFrame& frame, std::int64_t times) {
  const std::int64_t length = random.between(frame.extent / 8, frame.extent) / (times + 1);
  if (random.one_in(2)) return random_vector(random, length, frame.step);
  const std::int64_t longer = std::max<std::int64_t>(length / frame.step, 1);
  const std::int64_t term = std::int64_t{1} << random.between(kSignificantBits + 1, 31);
  const std::int64_t most = std::min(term / (longer * (times + 1) * (times + 1)) + 1, longer);
  const std::int64_t shorter = random.between((most + 1) / 2, most);
  const RawVector flat{random.sign() * longer, random.sign() * shorter};
  return frame.step * (random.one_in(2) ? flat : RawVector{flat.y, flat.x});
}

// The far end of an edge that passes a centre at 1 to 3 units; nothing if there is none.
std::optional<Point> far_end(RandomSource& random, const SeamFrame& frame, Point end, Point centre,
                             std::int64_t times) {
  const RawVector u = end - centre;
  const std::int64_t side = random.sign();
  const std::int64_t k = side * random.between(1, kMostSeamUnits);
  const auto v = beyond_centre({u.x / frame.step, u.y / frame.step}, k, times);
  return v ? std::optional(centre + frame.step * *v) : std::nullopt;
}

// A vertex on the left of an edge, from its middle half by up to the extent, or by a quarter of a
// pixel to two.
Point vertex_beside(RandomSource& random, const SeamFrame& frame, Point a, Point b) {
  const RawVector along = b - a;
  const auto on_grid = [&](std::int64_t raw) { return raw - raw % frame.step; };
  const std::int64_t part = random.between(64, 192);
  const Point foot = a + RawVector{on_grid(along.x * part / 256), on_grid(along.y * part / 256)};
  const bool is_sliver = frame.has_only_slivers() || random.one_in(3);
  const std::int64_t distance = on_grid(is_sliver ? random.between(kOne / 4, 2 * kOne)
                                                  : random.between(kOne, frame.extent / 2));
  const RawVector off =
      std::abs(along.x) >= std::abs(along.y) ? RawVector{0, distance} : RawVector{distance, 0};
  return turn(along, off) > 0 ? foot + off : foot - off;
}

// How much farther beyond the centre an edge goes on. From the nearer end its terms are smaller, so
// that single precision may see from there alone that the centre is not on the edge.
std::int64_t random_times(RandomSource& random) {
  return random.log_uniform(3);
}

using Attempt = std::optional<TriangleMesh>;

Attempt pair_of_triangles(RandomSource& random, const SeamFrame& frame) {
  const Point centre = pixel_centre(0, 0);
  const std::int64_t times = random_times(random);
  const Point a = centre + to_near_end(random, frame, times);
  const auto b = far_end(random, frame, a, centre, times);
  if (!b) return std::nullopt;
  return TriangleMesh{
      Primitive::triangle_strip,
      {vertex_beside(random, frame, a, *b), a, *b, vertex_beside(random, frame, *b, a)}};
}

// Counter-clockwise round its hub.
bool is_fan(const TriangleMesh& mesh) {
  const std::vector<Point>& v = mesh.vertices;
  for (std::size_t i = 1; i + 1 < v.size(); ++i)
    if (turn(v[i] - v[0], v[i + 1] - v[0]) <= 0) return false;
  return true;
}

// A fan whose spokes pass these centres, in counter-clockwise order.
Attempt fan_past(RandomSource& random, const SeamFrame& frame, Point hub,
                 std::span<const Point> centres, bool is_closed, std::int64_t times) {
  TriangleMesh mesh{Primitive::triangle_fan, {hub}};
  for (const Point centre : centres) {
    const auto end = far_end(random, frame, hub, centre, times);
    if (!end) return std::nullopt;
    mesh.vertices.push_back(*end);
  }
  if (is_closed) mesh.vertices.push_back(mesh.vertices[1]);
  return is_fan(mesh) ? Attempt(mesh) : std::nullopt;
}

Point random_hub(RandomSource& random, const SeamFrame& frame) {
  return random_point(random, {frame.step, 0});
}

// Of the centres round a hub.
std::int64_t random_radius(RandomSource& random, const SeamFrame& frame, std::int64_t times) {
  const std::int64_t most = frame.extent / (2 * times + 2);
  return random.between(std::max(most / 2, kOne), std::max(most, kOne));
}

Attempt wide_fan(RandomSource& random, const SeamFrame& frame) {
  const Point hub = random_hub(random, frame);
  const std::int64_t times = random_times(random);
  const bool is_closed = random.one_in(2);
  const std::int64_t spokes = is_closed ? random.between(4, 8) : random.between(3, 6);
  const std::int64_t first = random.below(kLineDirections);
  std::vector<Point> centres;
  for (std::int64_t i = 0; i < spokes; ++i) {
    // Sixteenths of a turn: spread evenly in a closed fan, adjacent otherwise.
    const std::int64_t turned = is_closed ? i * kLineDirections / spokes : i;
    const auto direction = static_cast<LineDirection>((first + turned) % kLineDirections);
    const std::int64_t radius = random_radius(random, frame, times);
    const Point near = hub + random_along(random, direction, radius, frame.step);
    centres.push_back(pixel_centre(near.x.floor(), near.y.floor()));
  }
  return fan_past(random, frame, hub, centres, is_closed, times);
}

// Its spokes pass the centres of adjacent pixels.
Attempt fan_of_slivers(RandomSource& random, const SeamFrame& frame) {
  const Point hub = random_hub(random, frame);
  const std::int64_t times = random_times(random);
  const RawVector spoke = random_vector(random, random_radius(random, frame, times), frame.step);
  const bool is_flat = std::abs(spoke.x) >= std::abs(spoke.y);
  const std::int64_t way = (is_flat ? spoke.x > 0 : spoke.y < 0) ? kOne : -kOne;
  const Point near = hub + spoke;
  std::vector<Point> centres{pixel_centre(near.x.floor(), near.y.floor())};
  for (std::int64_t i = random.between(2, 5); i > 0; --i)
    centres.push_back(centres.back() + (is_flat ? RawVector{0, way} : RawVector{way, 0}));
  return fan_past(random, frame, hub, centres, false, times);
}

TriangleMesh random_seams(RandomSource& random, const SeamFrame& frame) {
  for (;;) {
    const std::int64_t kind = random.below(4);
    Attempt mesh = kind == 0 && !frame.has_only_slivers() ? wide_fan(random, frame)
                   : kind == 1                            ? fan_of_slivers(random, frame)
                                                          : pair_of_triangles(random, frame);
    if (mesh && spans_at_most(mesh->vertices, frame.extent)) return *mesh;
  }
}

}  // namespace

std::optional<RawVector> beyond_centre(RawVector u, std::int64_t k, std::int64_t times) {
  const auto unit = unit_turn(u);
  if (!unit) return std::nullopt;
  const RawVector any = k * *unit;
  const std::int64_t along = any.x * u.x + any.y * u.y;
  const std::int64_t length = u.x * u.x + u.y * u.y;
  return any + (-times - rounded_quotient(along, length)) * u;
}

Scene seam_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  RandomSource random(seed, kStream + window_streams(surface), index);
  const SeamFrame frame = random_seam_frame(random);
  TriangleMesh mesh = random_seams(random, frame);
  shift_inside(random, frame.target, mesh.vertices);
  if (random.one_in(2)) mesh = separated(random, mesh);
  // A fan keeps its hub.
  else if (random.one_in(2))
    std::reverse(mesh.vertices.begin() + (mesh.primitive == Primitive::triangle_fan ? 1 : 0),
                 mesh.vertices.end());
  return scene_of(surface, frame.target, mesh.primitive, mesh.vertices);
}

}  // namespace edgecase
