// SPDX-License-Identifier: MIT
//
// For tests of kernels: planes to draw on, and every SIMD target in turn.
#pragma once

#include <random>
#include <vector>

#include "kernels/kernels.h"

namespace edgecase {

// The targets that are compiled and that this machine has, the portable one among them.
std::vector<std::int64_t> kernel_targets();
// Kernels run on that target until this is called again; 0: on the best.
void use_kernel_target(std::int64_t target);

// A plane of which every pixel is 0 until it is drawn, and what surrounds it must stay.
class Canvas {
 public:
  Canvas(int width, int height);

  PixelBounds bounds() const { return {0, 0, width_ - 1, height_ - 1}; }
  const PixelPlane& plane() const { return plane_; }
  // Those that were drawn, row by row from the bottom. Clears them.
  std::vector<PixelPosition> take();
  // Was something written outside of the plane?
  bool has_spilled() const;

 private:
  static constexpr PixelWord kGuard = 0xdeadbeef;
  int width_, height_;
  std::vector<PixelWord> words_;
  PixelPlane plane_;
};

// The pixels for which `covers(x, y)` holds, row by row from the bottom.
template <class Covers>
std::vector<PixelPosition> pixels_where(const PixelBounds& bounds, Covers covers) {
  std::vector<PixelPosition> pixels;
  for (int y = bounds.y_min; y <= bounds.y_max; ++y)
    for (int x = bounds.x_min; x <= bounds.x_max; ++x)
      if (covers(x, y)) pixels.push_back({x, y});
  return pixels;
}

// (x, y) with dx y - dy x = turn, the smallest x >= 0 of them. dx > 0, and coprime to dy.
struct RawVector {
  std::int64_t x;
  std::int64_t y;
};
RawVector vector_with_turn(std::int64_t dx, std::int64_t dy, std::int64_t turn);

class RandomPoints {
 public:
  explicit RandomPoints(std::uint64_t seed) : engine_(seed) {}
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  // From `low` to `high`, both inclusive, raw, in multiples of `step`.
  Fixed coordinate(std::int64_t low, std::int64_t high, std::int64_t step);
  // Within a square of that many pixels and two more on each side, on a grid of 2^-bits pixels.
  Point point(int size, int bits);

 private:
  std::mt19937_64 engine_;
};

}  // namespace edgecase
