// SPDX-License-Identifier: MIT
#include "kernels/color_planes.h"

#include <cmath>

namespace edgecase {
namespace {

constexpr double kShare = 0x1p-46;  // of M, for the margin
constexpr double kLeast = 0x1p-44;  // of a code: the last product of the plain path

// The edge function opposite to a vertex: its value at a sample and its growth per pixel.
struct Weight {
  double value;
  double right;
  double up;
};

Weight opposite(RawPoint a, RawPoint b, RawPoint sample) {
  const std::int64_t right = std::int64_t{a.y} - b.y, up = std::int64_t{b.x} - a.x;
  return {static_cast<double>(right * (std::int64_t{sample.x} - a.x) +
                              up * (std::int64_t{sample.y} - a.y)),
          static_cast<double>(right * Fixed::kOne), static_cast<double>(up * Fixed::kOne)};
}

std::int64_t area_of(const std::array<RawPoint, 3>& p) {
  return (std::int64_t{p[1].x} - p[0].x) * (std::int64_t{p[2].y} - p[0].y) -
         (std::int64_t{p[1].y} - p[0].y) * (std::int64_t{p[2].x} - p[0].x);
}

}  // namespace

ValuePlanes value_planes(const std::array<RawPoint, 3>& corners,
                         const std::array<std::array<float, 4>, 3>& values, double scale,
                         const PixelBounds& box) {
  const RawPoint sample = raw_point(pixel_centre(box.x_min, box.y_min));
  const double factor = scale / static_cast<double>(area_of(corners));
  const double width = box.x_max - box.x_min, height = box.y_max - box.y_min;
  std::array<Weight, 3> weights{};
  for (std::size_t i = 0; i < 3; ++i)
    weights[i] = opposite(corners[(i + 1) % 3], corners[(i + 2) % 3], sample);
  ValuePlanes planes;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto value = [&](std::size_t i) { return static_cast<double>(values[i][c]); };
    if (value(0) == value(1) && value(0) == value(2)) {
      // This equals the plain path to the bit, so nothing is left open.
      planes.corner[c] = scale * value(0);
      continue;
    }
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [at, right, up] = weights[i];
      planes.corner[c] += value(i) * at;
      planes.right[c] += value(i) * right;
      planes.up[c] += value(i) * up;
      most += std::abs(value(i)) * (std::abs(at) + std::abs(right) * width + std::abs(up) * height);
    }
    planes.corner[c] *= factor;
    planes.right[c] *= factor;
    planes.up[c] *= factor;
    planes.margin[c] = most * std::abs(factor) * kShare + kLeast;
  }
  return planes;
}

}  // namespace edgecase
