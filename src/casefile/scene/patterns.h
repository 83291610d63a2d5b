// SPDX-License-Identifier: MIT
//
// Generated patterns of points within a pixel, and generated images. Results of a seed are the same
// on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/sampling.h"
#include "model/texture.h"

namespace edgecase {

// The shaded points of a supersampled pixel and their weights: patterns and filters as taught in
// courses (Pharr, Jakob, Humphreys, Physically Based Rendering, chapters on sampling and on image
// reconstruction).
//
// Points are multiples of 2^-16 of a pixel, and only their choice involves rounding.

constexpr int kMaxSide = 32;  // of a grid of cells: kMaxSide^2 == kMaxPasses
constexpr int kMaxSeed = 65535;
// Range of x and y of a listed point, in pixels: it may lie in a neighbouring pixel.
constexpr int kLeastPlace = -1;
constexpr int kLargestPlace = 2;
constexpr Fixed kMaxRadius = Fixed::from_raw(3 * Fixed::kOne / 2);  // of a filter, pixels

// The finalizer of SplitMix64 (Steele, Lea, Flood 2014): a bijection of 64-bit words in which each
// bit of the input flips half of the output's bits.
std::uint64_t mix(std::uint64_t word);

// Points of one pixel, from its lower left corner: 0 to below 1, y up.
using Pattern = std::vector<Point>;

// The centres of n x n cells, row by row from the bottom left, rounded to multiples of 2^-16. n is
// 1 to 32.
Pattern grid_pattern(int n);

// One random point in each of n x n cells, row by row from the bottom left. n is 1 to 32.
Pattern jittered_pattern(int n, std::uint64_t seed);

// n random points, one in each row and one in each column of n x n cells, from left to right (P.
// Shirley, Discrepancy as a Quality Measure for Sample Distributions, 1991).
Pattern n_rooks_pattern(int n, std::uint64_t seed);

// n random points in the pixel.
Pattern random_pattern(int n, std::uint64_t seed);

enum class Kernel { box, tent, gaussian };
template <>
inline constexpr auto kNames<Kernel> = std::to_array<Named<Kernel>>(
    {{Kernel::box, "box"}, {Kernel::tent, "tent"}, {Kernel::gaussian, "gaussian"}});

// A weight that is the product of one factor along x and one along y. With d the distance from the
// pixel's centre along an axis and r the radius, the factor is 0 if |d| > r, and otherwise
//
//   box       1
//   tent      1 - |d| / r
//   gaussian  exp(-d^2 / (2 (r/2)^2))
struct ReconstructionFilter {
  Kernel kernel = Kernel::box;
  Fixed radius = Fixed::from_raw(Fixed::kOne / 2);  // pixels, above 0, at most 3/2
};

// The pattern with a filter's weights. If the radius exceeds 1/2, it is repeated in the eight
// neighbouring pixels, pixel by pixel, row by row from the bottom left. Weights of a box are 1,
// others are in units of 2^-16, rounded to nearest, ties to even. Points of weight 0 are omitted.
Supersampling filtered(const Pattern& pattern, const ReconstructionFilter& filter);

// Generated images and mip chains. They are the same on every machine: texels are computed in
// integers, or rounded once from the exact value.
//
// Texels are those of model/texture.h: rows from the bottom, whole codes of 0 to 255 in the 8-bit
// formats (for srgb8 the codes themselves are given and averaged, without the curve).

// Red, green, blue, alpha as a texture's format stores them.
using StoredTexel = std::array<float, 4>;

// A colour as the format stores it; for an 8-bit format, whose components are 0 to 1, the nearest
// codes, ties to even.
StoredTexel stored_texel(const std::array<float, 4>& color, TextureFormat format);

// The stored forms of white and black.
StoredTexel white_texel(TextureFormat format);
StoredTexel black_texel(TextureFormat format);

// One-dimensional images have height 1.
struct PatternSize {
  int width = 1;
  int height = 1;
};

// Squares of `cell` x `cell` texels: texel (i, j) is colors[(i / cell + j / cell) % 2].
TextureLevel checker_image(PatternSize size, int cell, const std::array<StoredTexel, 2>& colors);

// Bilinear interpolation between the corner texels, bottom left, bottom right, top left, top right,
// rounded to the nearest stored number, ties to even. A side of one texel has its first corner.
TextureLevel gradient_image(PatternSize size, const std::array<StoredTexel, 4>& corners,
                            TextureFormat format);

// Grey 1/2 + 1/2 cos(pi (x^2 + y^2) / larger side), x and y in texels from the centre; alpha 1.
TextureLevel zone_plate_image(PatternSize size, TextureFormat format);

// Each component of each texel by SplitMix64 from the seed, in the order of `texels`: the upper 8
// bits of each word or, for rgba32f, the upper 24 as multiples of 2^-24.
TextureLevel noise_image(PatternSize size, TextureFormat format, std::uint64_t seed);

TextureLevel flat_image(PatternSize size, const StoredTexel& texel);

// A whole chain of flat levels, each of one colour; `colors` has level_count entries.
std::vector<TextureLevel> flat_levels(PatternSize size, std::span<const StoredTexel> colors);

// Default colours of levels. For rgba32f, level k is (k, k/2, 1/4, 1), which identifies it in any
// mixture. For the others, eleven codes that differ from their neighbours by at least 127.
std::vector<StoredTexel> level_colors(int count, TextureFormat format);

// The next level: each texel is the mean of the 2 x 2 texels of `level` at 2i, 2i + 1 and 2j, 2j +
// 1 (of two, if there is only one row or column), rounded to the nearest stored number, ties to
// even. The last row or column of an odd size is ignored. `level` is larger than 1 x 1.
TextureLevel box_level(const TextureLevel& level, TextureFormat format);

// `base` and all levels down to 1 x 1, each made from the previous one as stored.
std::vector<TextureLevel> box_chain(TextureLevel base, TextureFormat format);

}  // namespace edgecase
