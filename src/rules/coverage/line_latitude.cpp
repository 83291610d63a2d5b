// SPDX-License-Identifier: MIT
#include "rules/coverage/line_latitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/loose_segment.h"

namespace edgecase {
namespace {

// The diamond-exit rule's fragments in and near the bounds: those for some ends within reach, and
// those for all of them. The two are the same if the ends are known.
struct RuleFragments {
  std::vector<PixelPosition> possible;
  std::vector<PixelPosition> certain;

  // Uses the segment in place of the line's own.
  RuleFragments(const Segment& segment, const SeenLine& line, const PixelBounds& target)
      : possible(possible_ones({segment, line.reach}, line, looked_at(target))),
        certain(line.reach == Fixed() ? possible
                                      : certain_pixels({segment, line.reach}, looked_at(target))) {}

 private:
  static std::vector<PixelPosition> possible_ones(const LooseSegment& loose, const SeenLine& line,
                                                  const PixelBounds& bounds) {
    const bool is_found = loose.reach == Fixed() && line.find != nullptr;
    return is_found ? line.find(loose.segment, bounds) : possible_pixels(loose, bounds);
  }
  // A fragment of the rule one unit outside the border still justifies a drawn one inside. The
  // search goes two units out, so that emptiness depends on more than one hidden step.
  static PixelBounds looked_at(const PixelBounds& target) { return target.grown(2); }
};

bool within_one(PixelPosition a, PixelPosition b) {
  return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1;
}

// Ruling 1, first clause. Both lists are mostly in the same order, or in opposite ones, so the
// search continues at the latest match.
std::string stray_fragment(std::span<const PixelPosition> possible,
                           std::span<const PixelPosition> drawn) {
  auto latest = possible.begin();
  for (PixelPosition p : drawn) {
    const auto justifies = [&](PixelPosition e) { return within_one(e, p); };
    auto found = std::find_if(latest, possible.end(), justifies);
    if (found == possible.end()) {
      found = std::find_if(possible.begin(), latest, justifies);
      if (found == latest)
        return fmt::format("pixel ({}, {}) has no diamond-exit fragment within one unit", p.x, p.y);
    }
    latest = found;
  }
  return "";
}

// Ruling 1, second clause; fragments near the border count in the line's favour.
std::string wrong_count(const RuleFragments& rule, std::size_t drawn, const PixelBounds& target) {
  const auto within = [](const std::vector<PixelPosition>& pixels, const PixelBounds& bounds) {
    return static_cast<std::size_t>(std::count_if(
        pixels.begin(), pixels.end(), [&](PixelPosition p) { return bounds.contains(p); }));
  };
  const std::size_t least = within(rule.certain, target.grown(-1));
  const std::size_t most = within(rule.possible, target.grown(1));
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
std::string crowded_line(bool x_major, std::span<const PixelPosition> drawn) {
  std::vector<int> seen;
  for (PixelPosition p : drawn) seen.push_back(x_major ? p.x : p.y);
  std::sort(seen.begin(), seen.end());
  const auto twice = std::adjacent_find(seen.begin(), seen.end());
  if (twice == seen.end()) return "";
  return fmt::format("{} {} holds two fragments of one segment", x_major ? "column" : "row",
                     *twice);
}

// Ruling 2.
std::string stray_of_empty(const LooseSegment& loose, std::span<const PixelPosition> drawn) {
  if (drawn.size() > 1)
    return fmt::format("{} fragments are drawn where the diamond-exit rule has none", drawn.size());
  for (PixelPosition p : drawn)
    if (!may_meet_diamond(loose, p))
      return fmt::format("pixel ({}, {}) is drawn, and the segment does not meet its diamond", p.x,
                         p.y);
  return "";
}

// Rulings 1 and 2, for a line of width 1 that is read as x-major or as y-major.
std::string broken_thin_clause(const RuleFragments& rule, const LooseSegment& loose, bool x_major,
                               std::span<const PixelPosition> drawn, const PixelBounds& target) {
  if (rule.certain.empty()) {
    std::string clause = stray_of_empty(loose, drawn);
    if (clause.empty() || rule.possible.empty()) return clause;
  }
  if (std::string clause = stray_fragment(rule.possible, drawn); !clause.empty()) return clause;
  if (std::string clause = crowded_line(x_major, drawn); !clause.empty()) return clause;
  return wrong_count(rule, drawn.size(), target);
}

// A wide line's fragments by their major coordinate, as minor coordinates.
std::map<int, std::vector<int>> columns_of(bool x_major, std::span<const PixelPosition> drawn) {
  std::map<int, std::vector<int>> columns;
  for (PixelPosition p : drawn) columns[x_major ? p.x : p.y].push_back(x_major ? p.y : p.x);
  for (auto& [major, minors] : columns) std::sort(minors.begin(), minors.end());
  return columns;
}

// Where a run between `low` and `high` on the minor axis may start: as near as possible to a
// fragment of the rule within a column of it, or else to the nearest one along the line.
int kindest_start(std::span<const PixelPosition> possible, int major, bool x_major, int low,
                  int high) {
  const auto distances = [&](PixelPosition p) {
    const int minor = x_major ? p.y : p.x;
    return std::pair{std::max(1, std::abs((x_major ? p.x : p.y) - major)),
                     std::abs(minor - std::clamp(minor, low, high))};
  };
  const auto nearest = std::min_element(
      possible.begin(), possible.end(),
      [&](PixelPosition a, PixelPosition b) { return distances(a) < distances(b); });
  return std::clamp(x_major ? nearest->y : nearest->x, low, high);
}

// Ruling 12, for a line that is read as x-major or as y-major.
std::string broken_wide_clause(const SeenLine& line, bool x_major,
                               std::span<const PixelPosition> drawn) {
  const int low = x_major ? line.bounds.y_min : line.bounds.x_min;
  const int high = x_major ? line.bounds.y_max : line.bounds.x_max;
  const LooseSegment thin{lowest_segment(line.segment, line.width, x_major), line.reach};
  PixelBounds bounds = line.bounds;
  (x_major ? bounds.y_min : bounds.x_min) -= line.width - 1;
  const RuleFragments rule(thin.segment, line, bounds);

  std::vector<PixelPosition> lowest;
  for (const auto& [major, minors] : columns_of(x_major, drawn)) {
    const int run = static_cast<int>(minors.size());
    const bool whole = minors.back() - minors.front() == run - 1 &&
                       std::adjacent_find(minors.begin(), minors.end()) == minors.end();
    const bool cut_below = run < line.width && minors.front() == low;
    const bool cut_above = run < line.width && minors.back() == high;
    if (!whole || (run != line.width && !cut_below && !cut_above))
      return fmt::format("{} {} holds {} fragments, not one run of {}", x_major ? "column" : "row",
                         major, run, line.width);
    // A run cut by the lower border continues below it; a run cut by both borders is assumed to be
    // as near as possible to the rule's fragments.
    int base = cut_below ? minors.back() - line.width + 1 : minors.front();
    if (cut_below && cut_above && !rule.possible.empty())
      base = kindest_start(rule.possible, major, x_major, base, low);
    lowest.push_back(x_major ? PixelPosition{major, base} : PixelPosition{base, major});
  }
  return broken_thin_clause(rule, thin, x_major, lowest, bounds);
}

using Pixels = std::vector<PixelPosition>;

// The pixels that the diamond-exit rule itself draws, with ties decided by a boundary.
Pixels drawn_by_rule(const SeenLine& line, const DiamondBoundary& ties) {
  const Segment thin = lowest_segment(line.segment, line.width);
  PixelBounds bounds = line.bounds;
  (thin.x_major() ? bounds.y_min : bounds.x_min) -= line.width - 1;
  return replicated(diamond_exit_pixels(thin, bounds, ties), thin.x_major(), line.width,
                    line.bounds);
}

// True if the line is drawn by the diamond-exit rule with both ends moved as little as in the text,
// but in another direction. A renderer's arithmetic, which is accurate to about 1 part in 10^5 (GL
// 4.6 core, 2.3.4.1), may have moved them there.
bool follows_other_ties(const SeenLine& line, std::span<const PixelPosition> drawn) {
  if (line.reach != Fixed()) return false;
  Pixels sorted(drawn.begin(), drawn.end());
  std::ranges::sort(sorted);
  return std::ranges::any_of(all_diamond_boundaries(), [&](const DiamondBoundary& ties) {
    if (ties.ties == nullptr || ties.ties->kind != TieRule::Kind::perturbed) return false;
    Pixels pixels = drawn_by_rule(line, ties);
    std::ranges::sort(pixels);
    return pixels == sorted;
  });
}

// A line whose major axis depends on its exact ends may be read either way, in its favour.
std::string broken_clause(const SeenLine& line, std::span<const PixelPosition> drawn) {
  const LooseSegment loose{line.segment, line.reach};
  std::string first;
  std::optional<RuleFragments> thin;  // the same for both readings
  if (line.width == 1) thin.emplace(line.segment, line, line.bounds);
  for (const bool x_major : {true, false}) {
    if (x_major ? surely_y_major(loose) : surely_x_major(loose)) continue;
    const std::string clause = thin ? broken_thin_clause(*thin, loose, x_major, drawn, line.bounds)
                                    : broken_wide_clause(line, x_major, drawn);
    if (clause.empty()) return "";
    if (first.empty()) first = clause;
  }
  return first;
}

}  // namespace

std::string broken_line_clause(const SeenLine& line, std::span<const PixelPosition> drawn) {
  std::string clause = broken_clause(line, drawn);
  if (!clause.empty() && follows_other_ties(line, drawn)) clause.clear();
  return clause;
}

bool is_unseen(const SeenLine& line) {
  return RuleFragments(line.segment, line, line.bounds).possible.empty();
}

}  // namespace edgecase
