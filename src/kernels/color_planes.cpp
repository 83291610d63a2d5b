// SPDX-License-Identifier: MIT
#include "kernels/color_planes.h"

#include <cmath>

#include "rules/values/weighted_mean.h"

namespace edgecase {
namespace {

constexpr double kShare = 0x1p-46;  // of M, for the margin
constexpr double kLeast = 0x1p-44;  // of a code: the last product of the plain path

// A linear function: its value at a sample and its growth per pixel.
struct Plane {
  double value = 0;
  double right = 0;
  double up = 0;
  friend Plane operator+(const Plane& a, const Plane& b) {
    return {a.value + b.value, a.right + b.right, a.up + b.up};
  }
  friend Plane operator*(const Plane& a, double factor) {
    return {a.value * factor, a.right * factor, a.up * factor};
  }
};

Plane edge_function(RawPoint a, RawPoint b, RawPoint sample) {
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
  const auto weights = by_opposite_edge(
      corners, [&](RawPoint a, RawPoint b) { return edge_function(a, b, sample); });
  ValuePlanes planes;
  for (std::size_t c = 0; c < 4; ++c) {
    const WeightsOf<double> of{values[0][c], values[1][c], values[2][c]};
    if (of[0] == of[1] && of[0] == of[2]) {
      // This equals the plain path to the bit, so nothing is left open.
      planes.corner[c] = scale * of[0];
      continue;
    }
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& [at, right, up] = weights[i];
      most += std::abs(of[i]) * (std::abs(at) + std::abs(right) * width + std::abs(up) * height);
    }
    const Plane mean = add_weighted(kOwnOperators, Plane{}, weights, of, 0, 3) * factor;
    planes.corner[c] = mean.value;
    planes.right[c] = mean.right;
    planes.up[c] = mean.up;
    planes.margin[c] = most * std::abs(factor) * kShare + kLeast;
  }
  return planes;
}

}  // namespace edgecase
