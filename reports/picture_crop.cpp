// SPDX-License-Identifier: MIT
#include "reports/picture_crop.h"

#include <algorithm>
#include <limits>

namespace edgecase {
namespace {

constexpr int kWholeSide = 24;  // pixels; a longer drawing is cropped to what differs
constexpr int kAroundAll = 1;
constexpr int kAroundDifferences = 4;

// A box that grows over pixels; empty at first.
struct Box {
  Crop crop = {std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), 0, 0};
  void add(int x, int y) {
    crop = {std::min(crop.left, x), std::min(crop.bottom, y), std::max(crop.right, x + 1),
            std::max(crop.top, y + 1)};
  }
  bool is_empty() const { return crop.right == 0; }
  // With a margin of `by` pixels, within the target.
  Crop grown(int by, const DifferencePicture& picture) const {
    return {std::max(crop.left - by, 0), std::max(crop.bottom - by, 0),
            std::min(crop.right + by, picture.width), std::min(crop.top + by, picture.height)};
  }
};

}  // namespace

Crop crop_of(const DifferencePicture& picture) {
  Box different;
  for (const Disagreement& d : picture.disagreements) different.add(d.x, d.y);
  Box drawn = different;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto index = static_cast<std::size_t>(y * picture.width + x);
      if (picture.exact_hits[index] > 0 || picture.rendered_hits[index] > 0) drawn.add(x, y);
    }
  if (drawn.is_empty()) return {0, 0, picture.width, picture.height};
  const Crop all = drawn.grown(kAroundAll, picture);
  if (different.is_empty() || std::max(all.width(), all.height()) <= kWholeSide) return all;
  return different.grown(kAroundDifferences, picture);
}

}  // namespace edgecase
