// SPDX-License-Identifier: MIT
//
// How often two triangles beside a seam hit the samples near it (ruling 5), however the seam is
// given: as an edge that both have, or as what clipping leaves of one.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "diff/coverage/coverage_diff.h"
#include "diff/coverage/shared_edge_faults.h"
#include "diff/findings/patience.h"
#include "model/scene.h"
#include "rules/coverage/window.h"

namespace edgecase {

// The samples that both triangles may write, by index, with their positions in a pixel.
std::map<int, Point> shared_samples(const ScenePrimitive& first, const ScenePrimitive& second,
                                    const Target& target, const SamplePositions& positions);

// How often a pixel occurs among pixels sorted by row.
long hits_at(std::span<const PixelPosition> pixels, PixelPosition p);

// Pixels of a target whose centres may lie near the segment a-b: its bounding box, grown by one.
PixelBounds bounds_near(Point a, Point b, const PixelBounds& target);

// Appends the pixels whose sample, at position `within`, two triangles must hit once but do not. A
// side has the pixels `near` it, whether it `is_multisampled`, must_hit_once(sample), and
// is_clear(sample, more): whether a sample is further than its latitude and `more` inside all other
// edges.
template <class Side>
void add_seam_faults(const Side& side, int first, int second, int sample, Point within,
                     std::span<const PrimitiveCoverage> coverage,
                     std::vector<SharedEdgeFault>& faults) {
  const auto hits_of = [&](int primitive, PixelPosition p) {
    const SampleCoverage& drawn = coverage[static_cast<std::size_t>(primitive)].drawn;
    return hits_at(drawn[static_cast<std::size_t>(sample)], p);
  };
  // Where the whole pixel, and less than a pixel around it, is clear of other edges, two triangles
  // may nowhere leave a sample out.
  const auto is_clear_around = [&](PixelPosition pixel) {
    const Fixed half = Fixed::from_raw(Fixed::kOne / 2);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (!side.is_clear(pixel_centre(pixel.x + dx, pixel.y + dy), half)) return false;
    return true;
  };
  for (int y = side.near.y_min; y <= side.near.y_max; ++y) {
    Patience::check();
    for (int x = side.near.x_min; x <= side.near.x_max; ++x) {
      const long hits = hits_of(first, {x, y}) + hits_of(second, {x, y});
      if (hits == 1 || !side.must_hit_once(place_in({x, y}, within))) continue;
      const bool is_certain = hits > 1 || !side.is_multisampled || is_clear_around({x, y});
      faults.push_back({{x, y}, sample, first, second, static_cast<int>(hits), is_certain});
    }
  }
}

}  // namespace edgecase
