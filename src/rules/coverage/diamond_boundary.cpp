// SPDX-License-Identifier: MIT
#include "rules/coverage/diamond_boundary.h"

#include <vector>

namespace edgecase {
namespace {

std::vector<DiamondBoundary> make_boundaries() {
  std::vector<DiamondBoundary> result;
  for (const TieRule& rule : all_tie_rules()) result.push_back({rule.name, &rule, 0, 0});
  const unsigned lower = kLowerLeftEdge | kLowerRightEdge | kBottomCorner;
  result.push_back({"direct3d", nullptr, lower, lower | kRightCorner});
  const unsigned edges = kLowerLeftEdge | kLowerRightEdge | kUpperLeftEdge | kUpperRightEdge;
  const unsigned scotty = edges | kLeftCorner | kBottomCorner;
  result.push_back({"scotty3d", nullptr, scotty, scotty});
  return result;
}

}  // namespace

std::span<const DiamondBoundary> all_diamond_boundaries() {
  static const std::vector<DiamondBoundary> boundaries = make_boundaries();
  return boundaries;
}

const DiamondBoundary* find_diamond_boundary(std::string_view name) {
  for (const DiamondBoundary& boundary : all_diamond_boundaries())
    if (boundary.name == name) return &boundary;
  return nullptr;
}

}  // namespace edgecase
