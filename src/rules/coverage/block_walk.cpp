// SPDX-License-Identifier: MIT
#include "rules/coverage/block_walk.h"

#include <algorithm>
#include <cassert>
#include <tuple>

namespace edgecase {
namespace {

// A function of the sample for one edge of a triangle, positive inside.
class Edge {
 public:
  // The interior lies to the left of from -> to.
  Edge(const HomogeneousPoint& from, const HomogeneousPoint& to, std::span<const Point> places)
      : from_(from),
        to_(to),
        right_(Int128{from.y} * to.w - Int128{to.y} * from.w),
        up_(Int128{to.x} * from.w - Int128{from.x} * to.w) {
    // A component of the normal is at most 2^79, and a position at most 2^16.
    assert(-kLargestNormal <= right_ && right_ <= kLargestNormal);
    assert(-kLargestNormal <= up_ && up_ <= kLargestNormal);
    const auto [outside, inside] =
        std::minmax_element(places.begin(), places.end(),
                            [&](Point a, Point b) { return growth_to(a) < growth_to(b); });
    most_inside_ = *inside;
    most_outside_ = *outside;
  }

  bool has_inside(PixelPosition pixel, Point place, const TieRule& ties) const {
    return ties.positive(cross(from_, to_, homogeneous(place_in(pixel, place))), right_, up_);
  }
  bool has_some_inside(const PixelBounds& block, const TieRule& ties) const {
    return has_inside({right_ > 0 ? block.x_max : block.x_min, up_ > 0 ? block.y_max : block.y_min},
                      most_inside_, ties);
  }
  bool has_all_inside(const PixelBounds& block, const TieRule& ties) const {
    return has_inside({right_ > 0 ? block.x_min : block.x_max, up_ > 0 ? block.y_min : block.y_max},
                      most_outside_, ties);
  }

 private:
  Int128 growth_to(Point place) const { return right_ * place.x.raw() + up_ * place.y.raw(); }

  [[maybe_unused]] static constexpr Int128 kLargestNormal = Int128{1} << 79;

  HomogeneousPoint from_, to_;
  Int128 right_, up_;  // its growth to the right and up
  Point most_inside_, most_outside_;
};

using EdgeNumbers = std::vector<int>;
const EdgeNumbers kAllEdges = {0, 1, 2};

// The largest pixel whose sample is not beyond the coordinate: floor(coordinate/w - place).
// The coordinate is at most 2^14 w, and w at most 2^35.
int last_pixel(std::int64_t coordinate, std::int64_t w, Fixed place) {
  assert(0 < w && w <= std::int64_t{1} << 35 && std::abs(coordinate) / w <= 1 << 14);
  const Int128 above = Int128{coordinate} * Fixed::kOne - Int128{place.raw()} * w;
  const Int128 below = Int128{w} * Fixed::kOne;
  return static_cast<int>(above / below - (above % below < 0 ? 1 : 0));
}
// The smallest pixel whose sample is not before the coordinate.
int first_pixel(std::int64_t coordinate, std::int64_t w, Fixed place) {
  return -last_pixel(-coordinate, w, -place);
}

PixelBounds box_of(const HomogeneousTriangle& triangle, const BlockGrid& grid) {
  const auto [left, right] = std::minmax_element(grid.places.begin(), grid.places.end(),
                                                 [](Point a, Point b) { return a.x < b.x; });
  const auto [low, high] = std::minmax_element(grid.places.begin(), grid.places.end(),
                                               [](Point a, Point b) { return a.y < b.y; });
  const PixelBounds& bounds = grid.bounds;
  PixelBounds box{bounds.x_max + 1, bounds.y_max + 1, bounds.x_min - 1, bounds.y_min - 1};
  for (const HomogeneousPoint& p : triangle) {
    box.x_min = std::min(box.x_min, first_pixel(p.x, p.w, right->x));
    box.y_min = std::min(box.y_min, first_pixel(p.y, p.w, high->y));
    box.x_max = std::max(box.x_max, last_pixel(p.x, p.w, left->x));
    box.y_max = std::max(box.y_max, last_pixel(p.y, p.w, low->y));
  }
  return common_part(box, bounds);
}

class Walker {
 public:
  Walker(const HomogeneousTriangle& triangle, const BlockGrid& grid, const TieRule& ties)
      : grid_(grid), ties_(ties) {
    const bool is_left = cross(triangle[0], triangle[1], triangle[2]) > 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const HomogeneousPoint& a = triangle[i];
      const HomogeneousPoint& b = triangle[(i + 1) % 3];
      edges_.emplace_back(is_left ? a : b, is_left ? b : a, grid.places);
    }
    walk_.box = box_of(triangle, grid);
  }

  BlockWalk walk() {
    if (walk_.box.x_min > walk_.box.x_max || walk_.box.y_min > walk_.box.y_max) return {};
    walk_.plain_evaluations = count_plainly();
    walk_within(walk_.box, 0, kAllEdges);
    return std::move(walk_);
  }

 private:
  // The blocks of one size that meet the part `some` of the box.
  void walk_within(const PixelBounds& some, std::size_t level, const EdgeNumbers& open) {
    const int size = grid_.sizes[level];
    for (int y = some.y_min - some.y_min % size; y <= some.y_max; y += size)
      for (int x = some.x_min - some.x_min % size; x <= some.x_max; x += size)
        visit(common_part({x, y, x + size - 1, y + size - 1}, grid_.bounds), level, open);
  }

  void visit(const PixelBounds& pixels, std::size_t level, const EdgeNumbers& open) {
    WalkedBlock block{pixels, grid_.sizes[level], BlockDecision::rejected, -1, {}};
    for (int i : open) {
      ++walk_.evaluations;
      if (edge(i).has_some_inside(pixels, ties_)) continue;
      block.edge = i;
      walk_.blocks.push_back(std::move(block));
      return;
    }
    EdgeNumbers left;
    for (int i : open) {
      ++walk_.evaluations;
      if (!edge(i).has_all_inside(pixels, ties_)) left.push_back(i);
    }
    const bool is_last = level + 1 == grid_.sizes.size();
    block.decision = left.empty() ? BlockDecision::accepted
                     : is_last    ? BlockDecision::tested
                                  : BlockDecision::divided;
    if (block.decision == BlockDecision::tested) block.covered = tested(pixels, left);
    walk_.blocks.push_back(std::move(block));
    if (!left.empty() && !is_last) walk_within(common_part(pixels, walk_.box), level + 1, left);
  }

  std::vector<PixelSamples> tested(const PixelBounds& pixels, const EdgeNumbers& open) {
    const PixelBounds some = common_part(pixels, walk_.box);
    std::vector<PixelSamples> covered;
    for (int y = some.y_min; y <= some.y_max; ++y)
      for (int x = some.x_min; x <= some.x_max; ++x) {
        PixelSamples samples{{x, y}, 0};
        for (std::size_t s = 0; s < grid_.places.size(); ++s)
          if (is_inside({x, y}, grid_.places[s], open, walk_.evaluations))
            samples.covered |= std::uint32_t{1} << s;
        if (samples.covered != 0) covered.push_back(samples);
      }
    return covered;
  }

  std::int64_t count_plainly() const {
    std::int64_t count = 0;
    const PixelBounds& box = walk_.box;
    for (int y = box.y_min; y <= box.y_max; ++y)
      for (int x = box.x_min; x <= box.x_max; ++x)
        for (Point place : grid_.places) is_inside({x, y}, place, kAllEdges, count);
    return count;
  }

  // Counts the edge functions that are evaluated.
  bool is_inside(PixelPosition pixel, Point place, const EdgeNumbers& open,
                 std::int64_t& count) const {
    return std::all_of(open.begin(), open.end(), [&](int i) {
      ++count;
      return edge(i).has_inside(pixel, place, ties_);
    });
  }

  const Edge& edge(int i) const { return edges_[static_cast<std::size_t>(i)]; }

  const BlockGrid& grid_;
  const TieRule& ties_;
  std::vector<Edge> edges_;
  BlockWalk walk_;
};

}  // namespace

BlockWalk walk_blocks(const HomogeneousTriangle& triangle, const BlockGrid& grid,
                      const TieRule& ties) {
  if (cross(triangle[0], triangle[1], triangle[2]) == 0) return {};
  return Walker(triangle, grid, ties).walk();
}

std::vector<PixelSamples> covered_samples(const BlockWalk& walk, int samples) {
  const std::uint32_t all = (std::uint32_t{1} << samples) - 1;
  std::vector<PixelSamples> result;
  for (const WalkedBlock& block : walk.blocks) {
    result.insert(result.end(), block.covered.begin(), block.covered.end());
    if (block.decision != BlockDecision::accepted) continue;
    for (int y = block.pixels.y_min; y <= block.pixels.y_max; ++y)
      for (int x = block.pixels.x_min; x <= block.pixels.x_max; ++x)
        result.push_back({{x, y}, all});
  }
  std::sort(result.begin(), result.end(), [](const PixelSamples& a, const PixelSamples& b) {
    return std::tie(a.pixel.y, a.pixel.x) < std::tie(b.pixel.y, b.pixel.x);
  });
  return result;
}

}  // namespace edgecase
