// SPDX-License-Identifier: MIT
//
// Many large triangles: tile by tile, and of each tile only what is seen last.
//
// Each triangle is held against the tiles of its bounding box by the corners that lie most inside
// and most outside each edge (rules/coverage/block_walk.h has the argument): a tile that an edge
// has wholly outside is rejected, and one that all edges have inside is covered. Every triangle
// replaces what was there, so that a tile that is covered forgets all that came before. Then the
// tiles are drawn, one after the other, each while it lies in the cache nearest to the core.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernels/edge_functions.h"

namespace edgecase {

class TileBins {
 public:
  static constexpr int kSide = 64;  // pixels

  // Of what may be drawn, columns and rows not negative; not empty.
  explicit TileBins(const PixelBounds& bounds)
      : bounds_(bounds),
        columns_(bounds.x_max / kSide + 1),
        bins_(static_cast<std::size_t>(columns_ * (bounds.y_max / kSide + 1))) {}

  // Number `index` in the order of drawing: ascending. `box`: the triangle's own.
  void add(std::size_t index, const std::array<EdgeFunction, 3>& edges, const PixelBounds& box) {
    const PixelBounds some = common_part(box, bounds_);
    if (is_empty(some)) return;
    for (int y = some.y_min / kSide; y <= some.y_max / kSide; ++y)
      for (int x = some.x_min / kSide; x <= some.x_max / kSide; ++x) {
        const Held held = hold(edges, std::int64_t{x} * kSide, std::int64_t{y} * kSide);
        if (held == Held::rejected) continue;
        std::vector<Entry>& bin = bins_[static_cast<std::size_t>(y * columns_ + x)];
        if (held == Held::covered) bin.clear();
        bin.push_back({index, held == Held::covered});
      }
  }

  // Calls draw(index, part, is_covered) for what is left, each tile's in the order of drawing.
  // `part`: of the bounds; is_covered: the triangle covers all of it.
  template <class Draw>
  void draw(Draw&& draw) const {
    for (std::size_t i = 0; i < bins_.size(); ++i) {
      const int x = static_cast<int>(i) % columns_ * kSide;
      const int y = static_cast<int>(i) / columns_ * kSide;
      const PixelBounds part = common_part({x, y, x + kSide - 1, y + kSide - 1}, bounds_);
      for (const Entry& entry : bins_[i]) draw(entry.index, part, entry.is_covered);
    }
  }

 private:
  enum class Held { rejected, open, covered };
  struct Entry {
    std::size_t index;
    bool is_covered;
  };

  // The tile whose lower left pixel this is. Of one that the bounds cut, all of it is asked.
  static Held hold(const std::array<EdgeFunction, 3>& edges, std::int64_t x, std::int64_t y) {
    bool is_covered = true;
    for (const EdgeFunction& edge : edges) {
      const std::int64_t corner = edge.at(x, y);
      const std::int64_t right = edge.right * (kSide - 1), up = edge.up * (kSide - 1);
      constexpr std::int64_t kNone = 0;
      if (corner + std::max(right, kNone) + std::max(up, kNone) < 0) return Held::rejected;
      is_covered = is_covered && corner + std::min(right, kNone) + std::min(up, kNone) >= 0;
    }
    return is_covered ? Held::covered : Held::open;
  }

  PixelBounds bounds_;
  int columns_;
  std::vector<std::vector<Entry>> bins_;
};

// Is it worth the while? Where triangles are some tiles large, and lie many times over one another.
// `vertices_of_triangle(i)`: the three vertices of each of `count` triangles.
template <class Vertices>
bool wants_bins(std::size_t count, const PixelBounds& bounds, Vertices&& vertices_of_triangle) {
  constexpr std::int64_t kLayers = 4;
  constexpr std::int64_t kLeastBox = std::int64_t{2 * TileBins::kSide} * 2 * TileBins::kSide;
  if (is_empty(bounds)) return false;
  std::int64_t boxes = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b, c] = vertices_of_triangle(i);
    const std::int64_t width = std::max({a.x, b.x, c.x}) - std::min({a.x, b.x, c.x});
    const std::int64_t height = std::max({a.y, b.y, c.y}) - std::min({a.y, b.y, c.y});
    boxes += (width >> Fixed::kFractionBits) * (height >> Fixed::kFractionBits);
  }
  const std::int64_t target =
      std::int64_t{bounds.x_max - bounds.x_min + 1} * (bounds.y_max - bounds.y_min + 1);
  return boxes >= kLayers * target && boxes >= kLeastBox * static_cast<std::int64_t>(count);
}

}  // namespace edgecase
