// SPDX-License-Identifier: MIT
#include <array>

#include "generate/scene_parts.h"
#include "profile/probes/probe_scenes.h"

namespace edgecase {
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

// Corners of a polygon counter-clockwise, convex, none at a sample; seven suffice for a fan.
constexpr std::array<std::array<int, 2>, 7> kPolygon{
    {{72, 36}, {406, 52}, {459, 181}, {422, 389}, {260, 470}, {118, 442}, {43, 261}}};

// Vertex v of a primitive type, in sixteenths of a pixel: all primitives cover pixels of their own.
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
      // Two vertices make a loop that runs back upon itself.
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
