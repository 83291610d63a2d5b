// SPDX-License-Identifier: MIT
#include "rules/coverage/shared_edge.h"

namespace edgecase {

std::optional<SharedEdge> shared_edge(const Triangle& first, const Triangle& second) {
  if (doubled_area(first) == 0 || doubled_area(second) == 0) return std::nullopt;
  const Triangle p = counter_clockwise(first);
  const Triangle q = counter_clockwise(second);
  // Triangles on opposite sides run along the common edge in opposite directions.
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (p[i] == q[(j + 1) % 3] && p[(i + 1) % 3] == q[j])
        return SharedEdge{p[i], p[(i + 1) % 3], p[(i + 2) % 3], q[(j + 2) % 3]};
  return std::nullopt;
}

bool must_hit_once(const SharedEdge& edge, Point sample, Fixed reach) {
  // Away from the edge, the rule for single triangles decides.
  if (robustly_left(edge.a, edge.b, sample, reach)) return false;
  if (robustly_left(edge.b, edge.a, sample, reach)) return false;
  return lies_between(edge, sample, reach);
}

bool lies_between(const SharedEdge& edge, Point sample, Fixed reach) {
  return robustly_left(edge.b, edge.left, sample, reach) &&
         robustly_left(edge.left, edge.a, sample, reach) &&
         robustly_left(edge.a, edge.right, sample, reach) &&
         robustly_left(edge.right, edge.b, sample, reach);
}

Rule shared_edge_rule() {
  return {
      RuleId::triangle_shared_edge,
      "A sample on an edge that two triangles share is hit exactly once",
      "14.6.1 (basic polygon rasterization)",
      "none: exactly one triangle gets the sample; which of the two is open",
      "",
      {},
      {{5,
        "Shared edges: two triangles on opposite sides of an edge with bit-identical ends hit a "
        "sample exactly once, if for every move that ruling 4 allows (the same for "
        "bit-identical vertices) the sample lies strictly inside the four other edges. Holes "
        "and double hits there are violations."}}};
}

}  // namespace edgecase
