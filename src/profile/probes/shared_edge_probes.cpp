// SPDX-License-Identifier: MIT
//
// Triangles side by side. What decides about a hole is where the common edges lie: through samples,
// or off them by a step of a sub-pixel grid or less. So each shape comes at several fractions of a
// pixel from a sample, as quads, strips and fans.
#include <array>

#include "generate/scene_parts.h"
#include "profile/probes/probe_scenes.h"

namespace edgecase {
namespace {

constexpr int kTarget = 64;
constexpr std::int64_t kOne = Fixed::kOne;

// Where a shape lies: offsets from a pixel's centre, raw.
constexpr std::array<RawVector, 7> kOffsets{{{0, 0},
                                             {kOne / 2, kOne / 2},
                                             {kOne / 16, -kOne / 16},
                                             {kOne / 256, kOne / 512},
                                             {-kOne / 256, kOne / 16},
                                             {1, -1},
                                             {-1, 0}}};

const char* const kShapeNames[] = {"quad", "strip", "fan"};

SharedEdgeProbe make_probe(Surface surface, SharedEdgeShape shape, Primitive primitive,
                           const std::vector<Point>& positions) {
  SharedEdgeProbe probe;
  probe.scene = scene_of(surface, kTarget, primitive, positions);
  probe.shape = shape;
  return probe;
}

// The triangles of a strip or fan, one by one; every other vertex order reversed on the way.
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

// The vectors along two sides of a quad, pixels: upright, square, tilted, flat and thin ones.
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

// A strip between two rows of vertices: `run` from one vertex to the next of the same row, `rise`
// from row to row, half a run on; raw, along x or along y.
struct Strip {
  int triangles;
  std::int64_t run;
  std::int64_t rise;
  std::int64_t slant;  // by how much a row rises from vertex to vertex
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

// A place on the border of the square |x|, |y| <= radius, counter-clockwise from its lower right
// corner; `way` is 0 to 8 radii, whole radii are corners and middles of sides.
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

// All round, the last vertex is the first of the rim again; else the rim is a part of the right
// side as long as half a radius, which makes slivers.
std::vector<Point> fan_points(int triangles, std::int64_t radius, RawVector offset, bool closed) {
  const Point hub = pixel_centre(kTarget / 2, kTarget / 2) + offset;
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

const char* name_of(SharedEdgeShape shape) {
  return kShapeNames[static_cast<std::size_t>(shape)];
}

std::vector<SharedEdgeProbe> shared_edge_probes(Surface surface) {
  std::vector<SharedEdgeProbe> result;
  add_quads(result, surface);
  add_strips(result, surface);
  add_fans(result, surface);
  return result;
}

}  // namespace edgecase
