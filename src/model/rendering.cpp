// SPDX-License-Identifier: MIT
#include "model/rendering.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace edgecase {

bool precedes(const Fragment& a, const Fragment& b) {
  return std::tie(a.y, a.x, a.primitive, a.coverage) < std::tie(b.y, b.x, b.primitive, b.coverage);
}

void sort_fragments(Rendering& rendering) {
  // Most come sorted, and looking is much cheaper than sorting.
  if (std::is_sorted(rendering.fragments.begin(), rendering.fragments.end(), precedes)) return;
  std::stable_sort(rendering.fragments.begin(), rendering.fragments.end(), precedes);
}

std::uint8_t to_unorm8(double component) {
  if (!(component > 0)) return 0;
  if (component >= 1) return 255;
  return static_cast<std::uint8_t>(std::nearbyint(component * 255));
}

}  // namespace edgecase
