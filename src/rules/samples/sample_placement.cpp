// SPDX-License-Identifier: MIT
#include "rules/samples/sample_placement.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace edgecase {
namespace {

using Kind = SamplePlacement::Kind;

struct Sixteenths {
  int x;
  int y;
};

constexpr Sixteenths kOf1[] = {{8, 8}};
constexpr Sixteenths kOf2[] = {{12, 12}, {4, 4}};
constexpr Sixteenths kOf4[] = {{6, 2}, {14, 6}, {2, 10}, {10, 14}};
constexpr Sixteenths kOf8[] = {{9, 5},  {7, 11}, {13, 9},  {5, 3},
                               {3, 13}, {1, 7},  {11, 15}, {15, 1}};
constexpr Sixteenths kOf16[] = {{9, 9},   {7, 5},  {5, 10},  {12, 7}, {3, 6}, {10, 13},
                                {13, 11}, {11, 3}, {6, 14},  {8, 1},  {4, 2}, {2, 12},
                                {0, 8},   {15, 4}, {14, 15}, {1, 0}};

std::span<const Sixteenths> pattern_for(int samples) {
  if (samples <= 1) return kOf1;
  if (samples <= 2) return kOf2;
  if (samples <= 4) return kOf4;
  if (samples <= 8) return kOf8;
  return kOf16;
}

// The side of a square grid of this many samples; 0 if there is none, or only one sample.
int grid_side(std::size_t samples) {
  for (int side = 2; side * side <= kMaxSamples; ++side)
    if (static_cast<std::size_t>(side * side) == samples) return side;
  return 0;
}

// The multiple of 2^-16 at or below a quotient.
Fixed quotient(int above, int below) {
  return Fixed::from_raw(above * Fixed::kOne / below);
}

// Row by row from the bottom. Turning moves the samples of a row upward, each by 1/side of the
// distance more than the last, and those of a column to the left.
SamplePositions grid(int side, bool turned) {
  SamplePositions positions;
  const int parts = 2 * side * side;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const int x = turned ? 2 * (side - 1 - row) + 1 : side;
      const int y = turned ? 2 * column + 1 : side;
      positions.push_back(
          {quotient(2 * side * column + x, parts), quotient(2 * side * row + y, parts)});
    }
  return positions;
}

SamplePositions mirrored(SamplePositions positions, bool x, bool y) {
  const Fixed one = Fixed::from_integer(1);
  for (Point& p : positions) p = {x ? one - p.x : p.x, y ? one - p.y : p.y};
  return positions;
}

SamplePositions with_swapped(SamplePositions positions, int first, int second) {
  const int count = static_cast<int>(positions.size());
  if (first < 0 || second < 0 || first >= count || second >= count) return positions;
  std::swap(positions[static_cast<std::size_t>(first)],
            positions[static_cast<std::size_t>(second)]);
  return positions;
}

}  // namespace

SamplePositions standard_pattern(int samples) {
  SamplePositions positions;
  for (const Sixteenths& at : pattern_for(samples).first(static_cast<std::size_t>(samples)))
    positions.push_back({quotient(at.x, 16), quotient(at.y, 16)});
  return positions;
}

SamplePositions placed(const SamplePlacement& placement, const SamplePositions& reported) {
  const int side = grid_side(reported.size());
  switch (placement.kind) {
    case Kind::as_reported:
      return reported;
    case Kind::standard:
      return standard_pattern(static_cast<int>(reported.size()));
    case Kind::ordered_grid:
    case Kind::rotated_grid:
      return side == 0 ? reported : grid(side, placement.kind == Kind::rotated_grid);
    case Kind::centre:
      return SamplePositions(reported.size(), centre_of_pixel());
    case Kind::mirrored_x:
      return mirrored(reported, true, false);
    case Kind::mirrored_y:
      return mirrored(reported, false, true);
    case Kind::turned:
      return mirrored(reported, true, true);
    case Kind::swapped:
      return with_swapped(reported, placement.first, placement.second);
  }
  return reported;
}

std::vector<SamplePlacement> placements_of(int samples) {
  std::vector<SamplePlacement> placements;
  const bool has_grid = grid_side(static_cast<std::size_t>(samples)) != 0;
  for (const Kind kind : values_of<Kind>()) {
    const bool is_grid = kind == Kind::ordered_grid || kind == Kind::rotated_grid;
    if (kind == Kind::swapped || (is_grid && !has_grid)) continue;
    // The rotated grid of 4 is the standard pattern.
    if (kind == Kind::rotated_grid && samples == 4) continue;
    placements.push_back({kind, 0, 0});
  }
  for (int first = 0; first < samples; ++first)
    for (int second = first + 1; second < samples; ++second)
      placements.push_back({Kind::swapped, first, second});
  return placements;
}

std::string name_of(const SamplePlacement& placement) {
  return name_of(placement.kind);
}

bool parse_name(std::string_view name, SamplePlacement& placement) {
  Kind kind = Kind::as_reported;
  if (!parse_name(name, kind)) return false;
  placement = {kind, 0, kind == Kind::swapped ? 1 : 0};
  return true;
}

Rule sample_positions_rule() {
  return {
      RuleId::sample_positions,
      "A pixel's samples lie where the renderer reports them",
      "14.3.1 (multisampling)",
      "any positions within the pixel that GL_SAMPLE_POSITION reports (ruling 27)",
      "as-reported",
      alternatives_of<Kind>(),
      {{27,
        "GL_SAMPLE_POSITION says where attributes qualified sample and depths of a sample are "
        "evaluated, in every pixel, and the index under which it says so is the bit of the "
        "coverage "
        "mask. Where these positions are not those of the case, exact is drawn anew with them."},
       {kRulingOnOtherPlaces,
        "Contested: the coverage of a multisampled primitive at a sample is wrong for the position "
        "that GL_SAMPLE_POSITION reports, but right for another position in the sample's pixel or "
        "less than a pixel beyond it. A hole in a shared edge is contested, too, where some such "
        "position lies beyond the two triangles. GL_SAMPLE_POSITION says where samples are shaded. "
        "But 14.3.1 says that coverage is found at points that need not be these, cannot be "
        "queried and may lie beyond the pixel, and OpenGL ES 3.2 has the same words (13.4). The "
        "Khronos tests (dEQP-GLES3.functional.rasterization.fbo.rbo_multisample_*.primitives) "
        "leave all partly covered pixels free. What no such position explains is a violation "
        "(rulings 4, 5, 6, 28 and 42), and so is what a sample covers if no one position explains "
        "all of it (ruling 65)."},
       {kRulingOnSharedPlaces,
        "Contested: two samples of a pixel lie at one place, which the case does not ask for. "
        "14.3.1 leaves the places to the renderer, and does not say that they differ; neither does "
        "OpenGL ES 3.2 (13.4). But the Khronos tests "
        "(dEQP-GLES3.functional.multisample.*.num_samples) want at least one shade more than there "
        "are samples along edges, which samples at one place do not give."},
       {kRulingOnOnePlace,
        "A sample has one place in all pixels of a target whose sample locations are fixed, and in "
        "all such targets with as many samples: whoever reports places has such targets. Ruling 47 "
        "leaves open which place that is. Where no place, by the latitude of vertices, explains "
        "all that an answer covers of a sample, rulings 4, 5, 6 and 28 are broken; where each of "
        "two answers has a place and both have none, this one is."}}};
}

}  // namespace edgecase
