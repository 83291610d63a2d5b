// SPDX-License-Identifier: MIT
#include "half_space.h"

#include <utility>

namespace {

using Place = std::array<double, 2>;

double side(const Place& a, const Place& b, const Place& p) {
  return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
}

// Is p to the left of the edge a -> b, or on an edge that the triangle owns: one on its left, which
// goes down, or one on its top, which goes left?
bool is_inside(const Place& a, const Place& b, const Place& p) {
  const double s = side(a, b, p);
#ifdef CLOSED_EDGES
  return s >= 0;
#else
  return s > 0 || (s == 0 && (b[1] < a[1] || (b[1] == a[1] && b[0] < a[0])));
#endif
}

}  // namespace

std::vector<PixelPlace> half_space_pixels(const std::array<std::array<double, 2>, 3>& triangle,
                                          int width, int height) {
  auto [a, b, c] = triangle;
  if (side(a, b, c) == 0) return {};
  if (side(a, b, c) < 0) std::swap(b, c);
  std::vector<PixelPlace> pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Place centre{x + 0.5, y + 0.5};
      if (is_inside(a, b, centre) && is_inside(b, c, centre) && is_inside(c, a, centre))
        pixels.push_back({x, y});
    }
  return pixels;
}
