// SPDX-License-Identifier: MIT
#include "rules/coverage/line_latitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace edgecase {
namespace {

const TieRule& perturbed() {
  static const TieRule& rule = *find_tie_rule("left-bottom");
  return rule;
}

bool within_one(PixelPosition a, PixelPosition b) {
  return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1;
}

// Ruling 1, first clause.
std::string stray_fragment(std::span<const PixelPosition> exact,
                           std::span<const PixelPosition> drawn) {
  for (PixelPosition p : drawn)
    if (std::none_of(exact.begin(), exact.end(), [&](PixelPosition e) { return within_one(e, p); }))
      return fmt::format("pixel ({}, {}) has no diamond-exit fragment within one unit", p.x, p.y);
  return "";
}

// Ruling 1, second clause, with the fragments near the border counted kindly.
std::string wrong_count(std::span<const PixelPosition> exact, std::size_t drawn,
                        const PixelBounds& target) {
  const auto within = [&](const PixelBounds& bounds) {
    return static_cast<std::size_t>(std::count_if(
        exact.begin(), exact.end(), [&](PixelPosition p) { return bounds.contains(p); }));
  };
  const std::size_t least = within(target.grown(-1));
  const std::size_t most = within(target.grown(1));
  if (drawn + 1 >= least && drawn <= most + 1) return "";
  if (least == most)
    return fmt::format(
        "{} fragments are drawn where the diamond-exit rule has {}; one more or less "
        "is allowed",
        drawn, least);
  return fmt::format(
      "{} fragments are drawn where the diamond-exit rule has {} to {} that may be "
      "seen; one more or less is allowed",
      drawn, least, most);
}

// Ruling 1, third clause.
std::string crowded_line(const Segment& segment, std::span<const PixelPosition> drawn) {
  const bool x_major = segment.x_major();
  std::vector<int> seen;
  for (PixelPosition p : drawn) seen.push_back(x_major ? p.x : p.y);
  std::sort(seen.begin(), seen.end());
  const auto twice = std::adjacent_find(seen.begin(), seen.end());
  if (twice == seen.end()) return "";
  return fmt::format("{} {} holds two fragments of one segment", x_major ? "column" : "row",
                     *twice);
}

// Ruling 2.
std::string stray_of_empty(const Segment& segment, std::span<const PixelPosition> drawn) {
  if (drawn.size() > 1)
    return fmt::format("{} fragments are drawn where the diamond-exit rule has none", drawn.size());
  for (PixelPosition p : drawn)
    if (!meets_diamond(segment, p.x, p.y, *find_tie_rule("closed")))
      return fmt::format("pixel ({}, {}) is drawn, and the segment does not meet its diamond", p.x,
                         p.y);
  return "";
}

}  // namespace

std::string broken_line_clause(const Segment& segment, std::span<const PixelPosition> drawn,
                               const PixelBounds& target) {
  // One unit beyond the border a fragment of the rule still justifies a drawn one inside; two are
  // looked at so that emptiness is judged on more than what one step may hide.
  const auto exact = diamond_exit_pixels(segment, target.grown(2), perturbed());
  if (exact.empty()) return stray_of_empty(segment, drawn);
  if (std::string clause = stray_fragment(exact, drawn); !clause.empty()) return clause;
  if (std::string clause = crowded_line(segment, drawn); !clause.empty()) return clause;
  return wrong_count(exact, drawn.size(), target);
}

}  // namespace edgecase
