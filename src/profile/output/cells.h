// SPDX-License-Identifier: MIT
//
// Cells, which the scenes of this folder are made of: see profile/output/output_scenes.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "generate/random_source.h"
#include "model/scene.h"
#include "profile/output/output_scenes.h"

namespace edgecase {

// Window depths of 0 to 1 count in multiples of 2^-17: what z has as a multiple of 2^-16.
constexpr std::int64_t kDepthOne = 2 * Fixed::kOne;
constexpr Fixed z_of_depth(std::int64_t depth) {
  return Fixed::from_raw(depth - Fixed::kOne);
}

// Generators of one seed and different purpose have nothing in common.
enum class OutputStream : std::uint64_t { masks = 0x5d00, blends, codes, tests, stencils, slopes };
RandomSource random_of(std::uint64_t seed, OutputStream stream, Surface surface,
                       std::uint64_t index);

// An empty target of cells.
Scene cell_scene(Surface surface);

// Triangles without vertices.
Draw cell_draw();

// One triangle in the pixel of a cell: counter-clockwise where it is front-facing, its corners
// at (1/4, 1/4), (3/4, 1/4) and (1/2, 3/4), so that the pixel's centre halves its height.
struct CellTriangle {
  Color color{1, 1, 1, 1};
  std::array<Fixed, 3> z{};  // of the corners
  bool front_facing = true;
};
void add_triangle(Draw& draw, std::size_t cell, const CellTriangle& triangle);

// Of one depth, a multiple of 2^-17.
CellTriangle flat_triangle(const Color& color, std::int64_t depth, bool front_facing = true);

// The pixel that a triangle lies in.
PixelPosition cell_pixel(const ScenePrimitive& primitive);

// A colour that is an 8-bit value, as near as float32 has it.
float code_color(std::int64_t code);
Color random_codes(RandomSource& random);

}  // namespace edgecase
