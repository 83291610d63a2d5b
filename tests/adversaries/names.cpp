// SPDX-License-Identifier: MIT
//
// The adversaries by name: each freedom where it shows most, many of them at once, and the crimes.
#include <cstdio>

#include "tests/adversaries/freedoms.h"

namespace edgecase::adversary {
namespace {

constexpr Adversary kLegal[] = {
    {"plain", {}},
    // Ties, pixels and samples; 16 bits, so that every tie is one.
    {"left-bottom", {.tie_x = 1, .tie_y = 1, .line = LineWay::moved, .quad_x = 1}},
    {"right-top", {.tie_x = -1, .tie_y = -1, .line = LineWay::one_more, .quad_y = 1}},
    {"right-bottom", {.tie_x = -1, .tie_y = 1, .line = LineWay::one_fewer, .halves_down = true}},
    {"top-left", {.tie_x = 1, .tie_y = -1, .tie_y_first = true, .line = LineWay::gap}},
    {"top-right", {.tie_x = -1, .tie_y = -1, .tie_y_first = true, .line = LineWay::sideways}},
    {"bottom-left", {.tie_x = 1, .tie_y = 1, .tie_y_first = true, .draws_points_outside = true}},
    {"bottom-right", {.tie_x = -1, .tie_y = 1, .tie_y_first = true, .cut_at_viewport = true}},
    {"tie-of-each-edge",
     {.tie_by_edge = true, .tie_by_point = true, .guard_band = 4, .fan_pivot = 1}},
    // Grids.
    {"8-down",
     {.bits = 8,
      .snap = Snap::down,
      .arithmetic = Arithmetic::binary32,
      .formula = Formula::differences,
      .values_from_snapped = true}},
    {"4-up", {.bits = 4, .snap = Snap::up, .fan_pivot = 1}},
    {"4-either", {.bits = 4, .snap = Snap::either, .guard_band = 4, .values_from_snapped = true}},
    // Arithmetic.
    {"binary32", {.bits = 8, .arithmetic = Arithmetic::binary32, .formula = Formula::planes}},
    {"low", {.arithmetic = Arithmetic::low, .conversion = Conversion::down, .coarse_plain = true}},
    {"high", {.arithmetic = Arithmetic::high, .conversion = Conversion::up}},
    {"either",
     {.replicates_values = true,
      .arithmetic = Arithmetic::either,
      .conversion = Conversion::either}},
    {"analytic",
     {.conversion = Conversion::either,
      .analytic = true,
      .offset_by_partial = true,
      .offset_unit = 3.7,
      .tells_clamped_depths = false}},
    // Samples.
    {"samples",
     {.own_pattern = true,
      .shades_each_sample = true,
      .own_depths = true,
      .alpha_rounding = 1,
      .dithered_alpha = true,
      .resolves_down = true}},
    {"samples-anywhere",
     {.own_pattern = true,
      .attributes_anywhere = true,
      .alpha_rounding = -1,
      .dithered_alpha = true}},
    {"samples-elsewhere", {.coverage_elsewhere = true}},
    // Textures and blending.
    {"textures-low",
     {.arithmetic = Arithmetic::low,
      .conversion = Conversion::down,
      .scale = ScaleFactor::largest_partial,
      .level_error = -1,
      .texel_error = -1,
      .weight_bits = 6,
      .clamps_each_bias = true}},
    {"textures-high",
     {.arithmetic = Arithmetic::high,
      .conversion = Conversion::up,
      .scale = ScaleFactor::sum_of_partials,
      .level_error = 1,
      .texel_error = 1,
      .ties_of_levels_up = true,
      .nearest_mipmaps = true}},
    {"textures-in-codes",
     {.conversion = Conversion::either,
      .scale = ScaleFactor::root_two_of_sums,
      .codes_of_8_bits = true,
      .decodes_after = true,
      .takes_sharper_level = true,
      .blends_in_codes = true}},
    // All of it.
    {"everything",
     {.bits = 8,
      .snap = Snap::either,
      .tie_by_edge = true,
      .tie_by_point = true,
      .guard_band = 4,
      .draws_points_outside = true,
      .line = LineWay::moved,
      .replicates_values = true,
      .arithmetic = Arithmetic::either,
      .conversion = Conversion::either,
      .coarse_plain = true,
      .offset_by_partial = true,
      .offset_unit = 5,
      .own_pattern = true,
      .attributes_anywhere = true,
      .dithered_alpha = true,
      .scale = ScaleFactor::sum_of_partials,
      .level_error = 1,
      .texel_error = 1,
      .weight_bits = 6,
      .codes_of_8_bits = true,
      .decodes_after = true,
      .clamps_each_bias = true,
      .nearest_mipmaps = true,
      .blends_in_codes = true,
      .tells_less = true}},
};

constexpr Adversary kCrimes[] = {
    {"a step too far", {.bits = 8}},
    {"a tie rule for each triangle", {}},
    {"points a step larger", {.bits = 8}},
    {"points on the side dropped", {}},
    {"lines two units off", {}},
    {"lines two longer", {}},
    {"lines two shorter", {}},
    {"two in a column", {}},
    {"joints with a gap", {}},
    {"lines one wider", {}},
    {"flat by one unit", {}},
    {"values a quarter pixel off", {}},
    {"values beyond the hull", {}},
    {"units of half the size", {}},
    {"units that differ", {}},
    {"coordinates by one unit", {}},
    {"derivatives two pixels away", {}},
    {"masks ignored", {}},
    {"a sample too few", {}},
    {"shaded once", {}},
    {"centroids at the centre", {}},
    {"attributes beside the pixel", {}},
    {"alpha 1 keeps all but one", {}},
    {"scale factors below the least", {}},
    {"scale factors beyond the most", {}},
    {"levels five 64ths off", {.scale = ScaleFactor::sum_of_partials, .level_error = 5}},
    {"texels a 14th off", {.texel_error = 9}},
    {"biases clamped at 1", {}},
    {"mipmaps darker by two codes", {}},
    {"codes one beyond", {}},
    {"a depth converted in two ways", {}},
    {"blending in 4 bits", {}},
    {"means off by 1 in 10^5", {}},
};

}  // namespace

const Freedoms* find(std::string_view name) {
  for (const Adversary& one : kLegal)
    if (one.name == name) return &one.freedoms;
  static Freedoms guilty;
  for (const Adversary& one : kCrimes) {
    if (one.name != name) continue;
    guilty = one.freedoms;
    guilty.crime = one.name;
    return &guilty;
  }
  return nullptr;
}

void print_names() {
  for (const Adversary& one : kLegal) std::printf("legal %s\n", one.name.data());
  for (const Adversary& one : kCrimes) std::printf("crime %s\n", one.name.data());
}

}  // namespace edgecase::adversary
