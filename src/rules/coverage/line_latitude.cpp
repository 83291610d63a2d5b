// SPDX-License-Identifier: MIT
#include "rules/coverage/line_latitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

#include "rules/coverage/line_algorithm.h"

namespace edgecase {
namespace {

const DiamondBoundary& perturbed() {
  static const DiamondBoundary& boundary = *find_diamond_boundary("left-bottom");
  return boundary;
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
    if (!meets_diamond(segment, p.x, p.y, *find_diamond_boundary("closed")))
      return fmt::format("pixel ({}, {}) is drawn, and the segment does not meet its diamond", p.x,
                         p.y);
  return "";
}

// One unit beyond the border a fragment of the rule still justifies a drawn one inside; two are
// looked at so that emptiness is judged on more than what one step may hide.
std::vector<PixelPosition> nearby_pixels(const Segment& segment, const PixelBounds& target) {
  return diamond_exit_pixels(segment, target.grown(2), perturbed());
}

// Rulings 1 and 2, for a line of width 1.
std::string broken_thin_clause(const Segment& segment, std::span<const PixelPosition> drawn,
                               const PixelBounds& target) {
  const auto exact = nearby_pixels(segment, target);
  if (exact.empty()) return stray_of_empty(segment, drawn);
  if (std::string clause = stray_fragment(exact, drawn); !clause.empty()) return clause;
  if (std::string clause = crowded_line(segment, drawn); !clause.empty()) return clause;
  return wrong_count(exact, drawn.size(), target);
}

// The fragments of a wide line by their place on the major axis, as places on the minor axis.
std::map<int, std::vector<int>> columns_of(const SeenLine& line,
                                           std::span<const PixelPosition> drawn) {
  const bool x_major = line.segment.x_major();
  std::map<int, std::vector<int>> columns;
  for (PixelPosition p : drawn) columns[x_major ? p.x : p.y].push_back(x_major ? p.y : p.x);
  for (auto& [major, minors] : columns) std::sort(minors.begin(), minors.end());
  return columns;
}

// The place on the minor axis of the fragment that the diamond-exit rule has nearest to a column.
int exact_minor_near(std::span<const PixelPosition> exact, int major, bool x_major) {
  const auto distance = [&](PixelPosition p) { return std::abs((x_major ? p.x : p.y) - major); };
  const auto nearest =
      std::min_element(exact.begin(), exact.end(),
                       [&](PixelPosition a, PixelPosition b) { return distance(a) < distance(b); });
  return x_major ? nearest->y : nearest->x;
}

// Ruling 12.
std::string broken_wide_clause(const SeenLine& line, std::span<const PixelPosition> drawn) {
  const bool x_major = line.segment.x_major();
  const int low = x_major ? line.bounds.y_min : line.bounds.x_min;
  const int high = x_major ? line.bounds.y_max : line.bounds.x_max;
  const Segment thin = lowest_segment(line.segment, line.width);
  PixelBounds bounds = line.bounds;
  (x_major ? bounds.y_min : bounds.x_min) -= line.width - 1;
  const auto exact = nearby_pixels(thin, bounds);

  std::vector<PixelPosition> lowest;
  for (const auto& [major, minors] : columns_of(line, drawn)) {
    const int run = static_cast<int>(minors.size());
    const bool whole = minors.back() - minors.front() == run - 1 &&
                       std::adjacent_find(minors.begin(), minors.end()) == minors.end();
    const bool cut_below = run < line.width && minors.front() == low;
    const bool cut_above = run < line.width && minors.back() == high;
    if (!whole || (run != line.width && !cut_below && !cut_above))
      return fmt::format("{} {} holds {} fragments, not one run of {}", x_major ? "column" : "row",
                         major, run, line.width);
    // What the lower border cuts goes on below it; a run that both borders cut is taken to lie as
    // near to where the rule has it as it can.
    int base = cut_below ? minors.back() - line.width + 1 : minors.front();
    if (cut_below && cut_above && !exact.empty())
      base = std::clamp(exact_minor_near(exact, major, x_major), base, low);
    lowest.push_back(x_major ? PixelPosition{major, base} : PixelPosition{base, major});
  }
  return broken_thin_clause(thin, lowest, bounds);
}

}  // namespace

std::string broken_line_clause(const SeenLine& line, std::span<const PixelPosition> drawn) {
  if (line.width == 1) return broken_thin_clause(line.segment, drawn, line.bounds);
  return broken_wide_clause(line, drawn);
}

bool is_unseen(const SeenLine& line) {
  return nearby_pixels(line.segment, line.bounds).empty();
}

}  // namespace edgecase
