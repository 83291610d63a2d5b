// SPDX-License-Identifier: MIT
#include "raster/primitives.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "raster/rasterizer.h"
#include "raster/vertex_attributes.h"
#include "rules/all_rules.h"
#include "rules/coverage/clip_polygon.h"

namespace edgecase {

namespace {

using Corners = std::array<HomogeneousPoint, 3>;

Corners snapped_corners(const ScenePrimitive& triangle, const Target& target,
                        const CoverageChoice& choice) {
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = snapped_position(triangle, i, choice, target);
  return corners;
}

// The area in square pixels, as text for people. A triangle behind the eye has none.
std::string area_of(const ScenePrimitive& triangle, const Corners& p) {
  if (triangle.is_clipped) return "seen from the eye";
  const double scale =
      static_cast<double>(p[0].w) * static_cast<double>(p[1].w) * static_cast<double>(p[2].w);
  return fmt::format("area {:.6g} square pixels",
                     static_cast<double>(cross(p[0], p[1], p[2])) / scale / 2);
}

std::string way_round(const Corners& corners) {
  const Int128 area = cross(corners[0], corners[1], corners[2]);
  if (area == 0) return "neither way round";
  return area > 0 ? "counter-clockwise" : "clockwise";
}

std::string note_on(FacingMethod method) {
  if (method == FacingMethod::as_set) return "";
  const char* name = name_of(method);
  return fmt::format("; as {} has it: {}", name,
                     find_alternative(rule_of(RuleId::polygon_facing), name)->meaning);
}

}  // namespace

bool is_front_facing(const ScenePrimitive& primitive, const Target& target,
                     const CoverageChoice& choice) {
  if (primitive.kind != PrimitiveKind::triangle) return true;
  return is_front_facing(primitive, snapped_corners(primitive, target, choice), choice.facing);
}

bool is_culled(const ScenePrimitive& primitive, const Target& target,
               const CoverageChoice& choice) {
  if (primitive.kind != PrimitiveKind::triangle || primitive.state->cull == CullMode::none)
    return false;
  return is_culled(primitive, snapped_corners(primitive, target, choice), choice.facing);
}

std::optional<Explanation> explain_culling(const ScenePrimitive& primitive, const Target& target,
                                           const CoverageChoice& choice) {
  if (!is_culled(primitive, target, choice)) return std::nullopt;
  const Corners corners = snapped_corners(primitive, target, choice);
  std::vector<Point> points;
  if (primitive.is_clipped)
    for (const ClipPolygonVertex& vertex : seen_polygon(primitive))
      points.push_back(vertex.position);
  else
    for (const HomogeneousPoint& corner : corners) points.push_back(nearest_point(corner));
  std::string places;
  for (const Point point : points)
    places += fmt::format("{}{}", places.empty() ? " " : ", ", format_point(point));
  const Draw& draw = *primitive.state;
  Explanation why;
  why.text = fmt::format(
      "the triangle{} is culled and makes no fragments: its vertices run {} in the window ({}), "
      "front faces are {}, so that it faces the {}, and cull is {}{}",
      places, way_round(corners), area_of(primitive, corners), name_of(draw.front_face),
      is_front_facing(primitive, corners, choice.facing) ? "front" : "back", name_of(draw.cull),
      note_on(choice.facing));
  why.figure.marks = {{MarkRole::edge, true, {}, ""}};
  for (Point point : points) why.figure.marks[0].points.push_back(position_of(point));
  return why;
}

namespace {

// Why there is no block walk of the primitive; empty if there is one.
std::string absence_of(const ScenePrimitive& primitive, const Target& target,
                       const CoverageChoice& choice) {
  if (primitive.kind != PrimitiveKind::triangle)
    return fmt::format("it is a {}, and a block walk is of triangles", name_of(primitive.kind));
  if (auto why = explain_culling(primitive, target, choice)) return why->text;
  if (primitive.is_clipped)
    return "it reaches out of the clip volume, and a block walk is of triangles that lie within";
  if (choice.triangle_algorithm != TriangleAlgorithm::edge_functions)
    return fmt::format("as triangle.algorithm={} has it no edge functions are asked",
                       name_of(choice.triangle_algorithm));
  return "";
}

}  // namespace

PrimitiveBlocks blocks_of(const ScenePrimitive& primitive, const Target& target,
                          const CoverageChoice& choice, std::span<const int> sizes) {
  PrimitiveBlocks blocks;
  blocks.absence = absence_of(primitive, target, choice);
  if (!blocks.absence.empty()) return blocks;
  for (std::size_t i = 0; i < blocks.triangle.size(); ++i)
    blocks.triangle[i] = snapped_position(primitive, i, choice, target);
  const bool by_sample = sampling_of(primitive, target, choice) == Unsampled::by_each_sample;
  blocks.places = by_sample ? positions_of(target, choice, {}) : SamplePositions{centre_of_pixel()};
  const TieRule ties = choice.rows == RowOrder::top_down ? turned_over(choice.ties) : choice.ties;
  blocks.walk = walk_blocks(
      blocks.triangle, {drawable_bounds(*primitive.state, target), sizes, blocks.places}, ties);
  if (!blocks.walk.blocks.empty()) return blocks;
  const auto& t = blocks.triangle;
  blocks.absence =
      cross(t[0], t[1], t[2]) == 0 ? "it has no area" : "no sample lies in its bounding box";
  return blocks;
}

}  // namespace edgecase
