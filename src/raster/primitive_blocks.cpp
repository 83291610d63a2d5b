// SPDX-License-Identifier: MIT
#include "raster/primitive_blocks.h"

#include <fmt/format.h>

#include "raster/facing.h"
#include "raster/rasterizer.h"
#include "raster/vertex_attributes.h"

namespace edgecase {
namespace {

// Why a primitive has no edges to walk by; empty where it has.
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
