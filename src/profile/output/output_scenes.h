// SPDX-License-Identifier: MIT
//
// Scenes that ask what becomes of fragments: of their depths, stencil values and colours.
//
// A cell is a pixel with triangles of its own round its centre, strictly inside it, their vertices
// multiples of 1/4 pixel: neither snapping nor ties have a say, and each makes one fragment. Every
// triangle has one colour and, but for those of offset scenes with a slope, one depth. Each scene
// is a function of what it is made with alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/pixel.h"
#include "generate/random_source.h"
#include "model/scene.h"

namespace edgecase {

constexpr int kCellColumns = 16;  // of a scene, and rows
constexpr std::size_t kCells = std::size_t{kCellColumns} * kCellColumns;

// Formats of depth buffers, none not among them.
inline constexpr std::array kDepthFormats{DepthFormat::depth16, DepthFormat::depth24,
                                          DepthFormat::depth32f};

// ---------------------------------------------------------------------------------------- colours

// Plain colours: the float32 numbers next to every border between two codes, multiples of 1/256,
// and numbers beyond 0 to 1.
std::vector<Scene> plain_color_scenes(Surface surface);

// Every set of masked components, over codes of every kind.
std::vector<Scene> color_mask_scenes(std::uint64_t seed, Surface surface);

// Codes that are blended with random colours, half of these codes, too: every equation with every
// pair of factors, and for the over operator every alpha with every fourth code. Alpha is blended
// by a term of its own. Scenes of one factor of the destination follow each other.
std::vector<Scene> blend_scenes(std::uint64_t seed, Surface surface);

// ----------------------------------------------------------------------------------------- depths

// Depths swept over all codes, close to borders between two of them and to whole ones.
std::vector<Scene> depth_code_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function of the depth test between depths that are one and the same number, or apart by
// more than any rounding makes up. What they are lies below the middle between two codes, where
// converting to the nearest and truncating have the same.
std::vector<Scene> depth_test_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function and operation of the stencil test on triangles of either facing, with masks, and
// stored values from 0 to 255. With a depth buffer the depth test passes and fails, too.
std::vector<Scene> stencil_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// ----------------------------------------------------------------------------------------- offset

// Units alone, many enough to tell one step of a fixed-point buffer from 2^-n; of floating-point
// ones over depths of many exponents.
std::vector<Scene> offset_unit_scenes(Surface surface, DepthFormat format);

// Factors alone, on depths that rise by different amounts in x and in y.
std::vector<Scene> offset_slope_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// ------------------------------------------------------------------------------------------ cells

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
