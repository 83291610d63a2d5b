// SPDX-License-Identifier: MIT
//
// Where a pixel is shaded when a scene is supersampled, and how much each place counts: the
// patterns and filters that courses teach (Pharr, Jakob, Humphreys, Physically Based Rendering,
// chapters on sampling and on image reconstruction).
//
// Places are multiples of 2^-16 of a pixel, so nothing but the choice of them is rounded.
#pragma once

#include <cstdint>
#include <vector>

#include "model/sampling.h"

namespace edgecase {

// Points of one pixel, from its lower left corner: 0 to below 1, y up.
using Pattern = std::vector<Point>;

// The centres of n x n cells, row by row from the bottom left, each taken to the nearest multiple.
// n is 1 to 32.
Pattern grid_pattern(int n);

// One place at random in each of n x n cells, row by row from the bottom left. n is 1 to 32.
Pattern jittered_pattern(int n, std::uint64_t seed);

// n places, one in each row and one in each column of n x n cells, at random in their cells; from
// the left (P. Shirley, Discrepancy as a Quality Measure for Sample Distributions, 1991).
Pattern n_rooks_pattern(int n, std::uint64_t seed);

// n places, each at random in the pixel.
Pattern random_pattern(int n, std::uint64_t seed);

enum class Kernel { box, tent, gaussian };

// A weight that is the product of one along x and one along y. With d the distance from the pixel's
// centre along an axis and r the radius, 0 where |d| > r, and else
//
//   box       1
//   tent      1 - |d| / r
//   gaussian  exp(-d^2 / (2 (r/2)^2))
struct ReconstructionFilter {
  Kernel kernel = Kernel::box;
  Fixed radius = Fixed::from_raw(Fixed::kOne / 2);  // pixels, above 0, at most 3/2
};

// The pattern under a filter: of a radius above 1/2 repeated in the eight pixels round the pixel,
// too, pixel by pixel, row by row from the bottom left. Weights of a box are 1, others are in units
// of 2^-16, rounded to the nearest, a tie to even. Places of weight 0 are left out.
Supersampling filtered(const Pattern& pattern, const ReconstructionFilter& filter);

}  // namespace edgecase
