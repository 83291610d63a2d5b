// SPDX-License-Identifier: MIT
//
// Many large triangles: drawn tile by tile, skipping those of a tile that are hidden later.
//
// Each triangle is tested against the tiles of its bounding box at the tile corners most inside and
// most outside each edge (rules/coverage/block_walk.h has the argument). A tile wholly outside an
// edge is rejected; a tile inside all edges is covered. Since every triangle replaces older
// colours, a covered tile drops all earlier entries. Tiles are then drawn one after another, each
// while it fits in the cache nearest to the core.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "kernels/edge_functions.h"

namespace edgecase {

class TileBins {
 public:
  static constexpr int kSide = 64;  // pixels

  // `bounds`: the pixels that may be drawn, not empty, with columns and rows of 0 or more.
  explicit TileBins(const PixelBounds& bounds)
      : bounds_(bounds),
        columns_(bounds.x_max / kSide + 1),
        bins_(static_cast<std::size_t>(columns_ * (bounds.y_max / kSide + 1))) {}

  // `index`: the triangle's number in drawing order, ascending. `box`: the triangle's own.
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

  // Calls draw(index, part, is_covered) for the remaining entries, tile by tile in drawing order.
  // `part`: the tile within the bounds; is_covered: the triangle covers all of it.
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

  // Classifies the tile with lower left pixel (x, y), tested whole even if the bounds cut it.
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

// Whether bins pay: triangles are several tiles large and overlap many times.
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
