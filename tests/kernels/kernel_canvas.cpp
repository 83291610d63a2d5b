// SPDX-License-Identifier: MIT
#include "tests/kernels/kernel_canvas.h"

#include <hwy/targets.h>

#include <algorithm>
#include <utility>

namespace edgecase {

std::vector<std::int64_t> kernel_targets() {
  hwy::SetSupportedTargetsForTest(0);
  std::vector<std::int64_t> targets;
  for (std::int64_t rest = hwy::SupportedTargets(); rest != 0; rest &= rest - 1)
    targets.push_back(rest & -rest);
  return targets;
}

void use_kernel_target(std::int64_t target) {
  hwy::SetSupportedTargetsForTest(target);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

Canvas::Canvas(int width, int height) : width_(width), height_(height) {
  const auto pixels = static_cast<std::size_t>(width * height);
  words_.assign(PixelPlane::kSpare + pixels + PixelPlane::kSpare, kGuard);
  std::fill_n(words_.begin() + PixelPlane::kSpare, pixels, 0);
  plane_ = {words_.data() + PixelPlane::kSpare, width};
}

std::vector<PixelPosition> Canvas::take() {
  auto pixels = pixels_where(bounds(), [&](int x, int y) { return plane_.row(y)[x] != 0; });
  for (PixelPosition p : pixels) plane_.row(p.y)[p.x] = 0;
  return pixels;
}

bool Canvas::has_spilled() const {
  const auto is_guard = [](PixelWord word) { return word == kGuard; };
  return !std::all_of(words_.begin(), words_.begin() + PixelPlane::kSpare, is_guard) ||
         !std::all_of(words_.end() - PixelPlane::kSpare, words_.end(), is_guard);
}

// x solves dy x = -turn modulo dx: -turn times the inverse of dy.
RawVector vector_with_turn(std::int64_t dx, std::int64_t dy, std::int64_t turn) {
  std::int64_t old_rest = dx, rest = (dy % dx + dx) % dx, old_inverse = 0, inverse = 1;
  while (rest != 0) {
    const std::int64_t quotient = old_rest / rest;
    old_rest = std::exchange(rest, old_rest - quotient * rest);
    old_inverse = std::exchange(inverse, old_inverse - quotient * inverse);
  }
  const std::int64_t x = ((-turn * old_inverse) % dx + dx) % dx;
  return {x, (turn + dy * x) / dx};
}

Fixed RandomPoints::coordinate(std::int64_t low, std::int64_t high, std::int64_t step) {
  const auto count = static_cast<std::uint64_t>((high - low) / step + 1);
  return Fixed::from_raw(low + static_cast<std::int64_t>(engine_() % count) * step);
}

Point RandomPoints::point(int size, int bits) {
  const std::int64_t low = -2 * Fixed::kOne, high = (size + 2) * Fixed::kOne;
  const std::int64_t step = Fixed::kOne >> bits;
  return {coordinate(low, high, step), coordinate(low, high, step)};
}

}  // namespace edgecase
