// SPDX-License-Identifier: MIT
#include "rules/coverage/homogeneous_point.h"

namespace edgecase {

HomogeneousPoint moved(const HomogeneousPoint& vertex, PointOffset offset) {
  return offset == PointOffset::none ? vertex : moved(vertex, 1, -1, 8);
}

bool point_covers(const HomogeneousSizedPoint& point, Point sample, const TieRule& ties) {
  // In units of 2^-17/w pixels: the size is at most 2^22 w, a distance 2^32 w, w 2^35.
  const HomogeneousPoint& vertex = point.vertex;
  const Int128 size = Int128{point.size.raw()} * vertex.w;
  const auto distance = [&](Fixed place, std::int64_t coordinate) {
    return 2 * (place.raw() * Int128{vertex.w} - Fixed::kOne * Int128{coordinate});
  };
  const Int128 dx = distance(sample.x, vertex.x);
  const Int128 dy = distance(sample.y, vertex.y);
  return ties.positive(size + dx, 1, 0) && ties.positive(size - dx, -1, 0) &&
         ties.positive(size + dy, 0, 1) && ties.positive(size - dy, 0, -1);
}

}  // namespace edgecase
