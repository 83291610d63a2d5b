// SPDX-License-Identifier: MIT
//
// Scenes about fragment operations: depths, stencil values and colours.
//
// A cell is a pixel with its own triangles round its centre, strictly inside it, with vertices at
// multiples of 1/4 pixel: neither snapping nor ties matter, and each triangle makes one fragment.
// Every triangle has one colour and, except in offset scenes with a slope, one depth. Each scene
// depends only on its arguments.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/fixed.h"
#include "generate/random_source.h"
#include "model/scene.h"

namespace edgecase {

constexpr int kCellColumns = 16;  // of a scene; also rows
constexpr std::size_t kCells = std::size_t{kCellColumns} * kCellColumns;

// Formats of depth buffers, without none.
inline constexpr std::array kDepthFormats{DepthFormat::depth16, DepthFormat::depth24,
                                          DepthFormat::depth32f};

// ---------------------------------------------------------------------------------------- colours

// Plain colours: the float32 numbers next to every border between two codes, multiples of 1/256,
// and numbers beyond 0 to 1.
std::vector<Scene> plain_color_scenes(Surface surface);

// Every set of masked components, over codes of every kind.
std::vector<Scene> color_mask_scenes(std::uint64_t seed, Surface surface);

// Codes blended with random colours, half of which are codes, too: every equation with every pair
// of factors, and for the over operator every alpha with every fourth code. Alpha has a separate
// term. Scenes with the same factor of the destination are consecutive.
std::vector<Scene> blend_scenes(std::uint64_t seed, Surface surface);

// ----------------------------------------------------------------------------------------- depths

// Depths swept over all codes, close to borders between two of them and to whole ones.
std::vector<Scene> depth_code_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function of the depth test between depths that are equal, or differ by more than any
// rounding. They lie below the middle between two codes, where rounding to nearest and truncating
// give the same.
std::vector<Scene> depth_test_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// Every function and operation of the stencil test on triangles of either facing, with masks, and
// stored values from 0 to 255. With a depth buffer the depth test passes and fails, too.
std::vector<Scene> stencil_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// ----------------------------------------------------------------------------------------- offset

// Only units: enough to distinguish one step of a fixed-point buffer from 2^-n; for floating-point
// buffers over depths of many exponents.
std::vector<Scene> offset_unit_scenes(Surface surface, DepthFormat format);

// Only factors, on depths that rise by different amounts in x and in y.
std::vector<Scene> offset_slope_scenes(std::uint64_t seed, Surface surface, DepthFormat format);

// ------------------------------------------------------------------------------------------ cells

// Window depths of 0 to 1 are multiples of 2^-17, since z is a multiple of 2^-16.
constexpr std::int64_t kDepthOne = 2 * Fixed::kOne;
constexpr Fixed z_of_depth(std::int64_t depth) {
  return Fixed::from_raw(depth - Fixed::kOne);
}

// Generators of one seed with different purposes are independent.
enum class OutputStream : std::uint64_t { masks = 0x5d00, blends, codes, tests, stencils, slopes };
RandomSource random_of(std::uint64_t seed, OutputStream stream, Surface surface,
                       std::uint64_t index);

// An empty target of cells.
Scene cell_scene(Surface surface);

// A draw of triangles, without vertices yet.
Draw cell_draw();

// One triangle in the pixel of a cell, counter-clockwise if front-facing, with its corners at (1/4,
// 1/4), (3/4, 1/4) and (1/2, 3/4), so that the pixel's centre halves its height.
struct CellTriangle {
  Color color{1, 1, 1, 1};
  std::array<Fixed, 3> z{};  // of the corners
  bool front_facing = true;
};
void add_triangle(Draw& draw, std::size_t cell, const CellTriangle& triangle);

// Of one depth, a multiple of 2^-17.
CellTriangle flat_triangle(const Color& color, std::int64_t depth, bool front_facing = true);

// The pixel that contains a triangle.
PixelPosition cell_pixel(const ScenePrimitive& primitive);

// The float32 nearest to an 8-bit colour value.
float code_color(std::int64_t code);
Color random_codes(RandomSource& random);

}  // namespace edgecase
