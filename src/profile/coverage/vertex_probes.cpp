// SPDX-License-Identifier: MIT
//
// Probes of vertices: beyond the viewport, and provoking ones.
#include <array>
#include <optional>

#include "generate/random_scenes.h"
#include "generate/random_shapes.h"
#include "profile/coverage/coverage.h"

namespace edgecase {

// ---------------------------------------------------------------------------------------- clipping

// Primitives that leave the viewport. Each side of a set has a vertex beyond it; lines and
// triangles keep a vertex inside or cross the viewport from one side to the opposite one, so that
// there is something to draw. Numbers come from a generator with a fixed seed.

namespace {

constexpr std::int64_t kOne = Fixed::kOne;
constexpr std::uint64_t kSeed = 20260402;
constexpr std::array kSizes{8, 16, 32, 64};
// The unclipped viewport: the same centre, eight times the size.
constexpr int kEnlarged = 8;
// Viewport 64: x from -192 to 256, off the centre by less than 2^8 pixels, 24 bits with fractions.
static_assert(7 * kSizes.back() / 2 < 256);

// The region of a vertex: one of these in x and one in y.
enum class Zone { before, within, after };

struct VertexZone {
  Zone x = Zone::within;
  Zone y = Zone::within;
};

// The single sides, then the corners.
constexpr std::array<VertexZone, 8> kOutside{{{Zone::before, Zone::within},
                                              {Zone::after, Zone::within},
                                              {Zone::within, Zone::before},
                                              {Zone::within, Zone::after},
                                              {Zone::before, Zone::before},
                                              {Zone::after, Zone::before},
                                              {Zone::before, Zone::after},
                                              {Zone::after, Zone::after}}};

VertexZone opposite(VertexZone zone) {
  const auto mirrored = [](Zone z) {
    return z == Zone::within ? z : z == Zone::before ? Zone::after : Zone::before;
  };
  return {mirrored(zone.x), mirrored(zone.y)};
}

// A coordinate of a zone on a grid of 2^-1 to 2^-16 pixel, beyond the viewport by more than 0 and
// less than `reach`.
Fixed random_coordinate(RandomSource& random, Zone zone, int size, std::int64_t reach) {
  constexpr std::array kBits{1, 1, 4, 8, 16};
  const std::int64_t step = kOne >> random.one_of(std::span<const int>(kBits));
  const std::int64_t length = zone == Zone::within ? size * kOne : reach;
  const std::int64_t inside = random.between(1, length / step - 1) * step;
  if (zone == Zone::before) return Fixed::from_raw(-inside);
  return Fixed::from_raw(zone == Zone::within ? inside : size * kOne + inside);
}

Point random_point(RandomSource& random, VertexZone zone, int size, std::int64_t reach) {
  const Fixed x = random_coordinate(random, zone.x, size, reach);
  return {x, random_coordinate(random, zone.y, size, reach)};
}

unsigned sides_beyond(const Scene& scene) {
  const Fixed end = Fixed::from_integer(scene.target.width);
  unsigned sides = 0;
  for (const Vertex& vertex : scene.draws[0].vertices) {
    if (vertex.position.x < Fixed()) sides |= kClipLeft;
    if (vertex.position.x > end) sides |= kClipRight;
    if (vertex.position.y < Fixed()) sides |= kClipBottom;
    if (vertex.position.y > end) sides |= kClipTop;
  }
  return sides;
}

ClipProbe make_probe(Scene scene) {
  const int size = scene.target.width;
  const int margin = size * (kEnlarged - 1) / 2;
  ClipProbe probe{std::move(scene), 0, {}};
  probe.sides = sides_beyond(probe.scene);
  probe.unclipped = probe.scene;
  probe.unclipped.viewport = {-margin, -margin, kEnlarged * size, kEnlarged * size};
  return probe;
}

// A point whose vertex lies outside; wide ones extend into the viewport.
Scene point_scene(RandomSource& random, Surface surface, int size, VertexZone zone, bool wide) {
  const std::int64_t width = wide ? random.between(4, 16) : 1;
  const Point vertex = random_point(random, zone, size, wide ? width * kOne / 2 : 3 * size * kOne);
  Scene scene = scene_of(surface, size, Primitive::points, std::array{vertex});
  scene.draws[0].point_size = Fixed::from_integer(width);
  return scene;
}

Scene shape_scene(RandomSource& random, Surface surface, int size,
                  std::span<const VertexZone> zones) {
  std::vector<Point> points;
  for (VertexZone zone : zones) points.push_back(random_point(random, zone, size, 3 * size * kOne));
  return scene_of(surface, size, zones.size() == 2 ? Primitive::lines : Primitive::triangles,
                  points);
}

// The zones of lines and triangles that leave the viewport towards one zone outside.
std::vector<std::vector<VertexZone>> shapes_towards(VertexZone out) {
  const VertexZone in;
  const VertexZone back = opposite(out);
  const VertexZone aside{out.y, out.x == Zone::within ? Zone::after : opposite(out).x};
  return {{in, out},      {out, in},       {back, out},       {in, in, out},
          {in, out, out}, {in, out, back}, {out, back, aside}};
}

}  // namespace

std::vector<ClipProbe> clip_probes(Surface surface) {
  std::vector<ClipProbe> result;
  for (int size : kSizes)
    for (VertexZone out : kOutside)
      for (int variant = 0; variant < 3; ++variant) {
        RandomSource random(kSeed, 0, result.size());
        result.push_back(make_probe(point_scene(random, surface, size, out, variant > 0)));
        for (const std::vector<VertexZone>& zones : shapes_towards(out))
          result.push_back(make_probe(shape_scene(random, surface, size, zones)));
      }
  return result;
}

// ------------------------------------------------------------------------------ provoking vertices

namespace {

constexpr int kTarget = 32;
constexpr int kMostPrimitives = 4;

constexpr std::array kPrimitives{
    Primitive::points,    Primitive::lines,          Primitive::line_strip,  Primitive::line_loop,
    Primitive::triangles, Primitive::triangle_strip, Primitive::triangle_fan};

int vertex_count(Primitive primitive, int primitives) {
  switch (primitive) {
    case Primitive::points:
      return primitives;
    case Primitive::lines:
      return 2 * primitives;
    case Primitive::line_strip:
      return primitives + 1;
    case Primitive::line_loop:
      return primitives;
    case Primitive::triangles:
      return 3 * primitives;
    case Primitive::triangle_strip:
    case Primitive::triangle_fan:
      return primitives + 2;
  }
  return 0;
}

// Corners of a convex polygon, counter-clockwise, none at a sample; seven suffice for a fan.
constexpr std::array<std::array<int, 2>, 7> kPolygon{
    {{72, 36}, {406, 52}, {459, 181}, {422, 389}, {260, 470}, {118, 442}, {43, 261}}};

// Vertex v of a primitive type, in sixteenths of a pixel: primitives cover distinct pixels.
Point position(Primitive primitive, int v) {
  switch (primitive) {
    case Primitive::points:
      return in_sixteenths(40 + 96 * v, 56 + 64 * v);
    case Primitive::lines:
    case Primitive::line_strip:
      return in_sixteenths(v % 2 == 0 ? 43 : 357, 38 + 51 * v);
    case Primitive::triangles: {
      const int column = v / 3 % 2 * 240;
      const int row = v / 3 / 2 * 240;
      constexpr std::array<std::array<int, 2>, 3> kCorners{{{37, 42}, {219, 61}, {74, 228}}};
      const auto corner = kCorners[static_cast<std::size_t>(v % 3)];
      return in_sixteenths(column + corner[0], row + corner[1]);
    }
    case Primitive::triangle_strip:
      return in_sixteenths(v % 2 == 0 ? 51 : 422, 38 + 74 * v);
    case Primitive::line_loop:
    case Primitive::triangle_fan:
      break;
  }
  const auto corner = kPolygon[static_cast<std::size_t>(v)];
  return in_sixteenths(corner[0], corner[1]);
}

}  // namespace

std::vector<Scene> provoking_probes(Surface surface) {
  std::vector<Scene> result;
  for (Primitive primitive : kPrimitives)
    for (int primitives = 1; primitives <= kMostPrimitives; ++primitives) {
      // Two vertices make a loop that runs back on itself.
      if (primitive == Primitive::line_loop && primitives < 3) continue;
      std::vector<Point> positions;
      for (int v = 0; v < vertex_count(primitive, primitives); ++v)
        positions.push_back(position(primitive, v));
      for (const auto convention : {ProvokingVertex::first, ProvokingVertex::last}) {
        result.push_back(scene_of(surface, kTarget, primitive, positions));
        result.back().draws[0].provoking_vertex = convention;
      }
    }
  return result;
}

}  // namespace edgecase
