// SPDX-License-Identifier: MIT
#include "diff/coverage/legality.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "diff/coverage/vertex_latitude.h"
#include "diff/findings/patience.h"
#include "model/side_clipping.h"
#include "raster/coverage_stages.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_latitude.h"
#include "rules/coverage/loose_segment.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

// SeenLine::find, with kernels if they are in use.
std::vector<PixelPosition> fragments_of_rule(const Segment& segment, const PixelBounds& bounds) {
  static const CoverageChoice choice = [] {
    CoverageChoice standard;
    standard.line.boundary = find_diamond_boundary("left-bottom");
    return standard;
  }();
  return found_line_pixels(segment, Fixed::from_integer(1), bounds, choice);
}

// The terms by which a line is judged: its permitted widths, the pixels that are tested, and what
// is the same under every snap.
struct LineTerms {
  std::vector<int> widths;
  PixelBounds bounds;
  EndErrors errors;
};

// The nearest integers to the width: two for a half, since 14.5.2.2 does not decide ties.
LineTerms terms_of(const ScenePrimitive& line, const Scene& scene) {
  const Fixed width = line.state->line_width;
  LineTerms terms{
      {rounded_width(width)}, drawable_bounds(*line.state, scene.target), end_errors(line)};
  const bool is_half = width.raw() % Fixed::kOne == Fixed::kOne / 2;
  if (is_half && terms.widths[0] > 1) terms.widths.push_back(terms.widths[0] - 1);
  return terms;
}

SeenLine seen_line(const ScenePrimitive& line, Snap snap, const LineTerms& terms) {
  const auto [segment, reach] = snapped_segment(line, snap, terms.errors);
  return {segment, terms.widths[0], terms.bounds, reach, fragments_of_rule};
}

// The clause that is broken for every permitted width.
std::string broken_clause(SeenLine line, const LineTerms& terms,
                          std::span<const PixelPosition> drawn) {
  std::string first;
  for (const int width : terms.widths) {
    line.width = width;
    const std::string clause = broken_line_clause(line, drawn);
    if (clause.empty()) return "";
    if (first.empty()) first = clause;
  }
  return first;
}

}  // namespace

int latitude_bits(int reported_subpixel_bits) {
  return std::clamp(reported_subpixel_bits, 4, Fixed::kFractionBits);
}

RuleId rule_on_coverage(const ScenePrimitive& primitive, const Target& target) {
  if (primitive.is_clipped) return kClipVolume;
  const bool rectangle =
      primitive.kind == PrimitiveKind::line && is_multisampled(*primitive.state, target);
  return rectangle ? kMultisampledLine : coverage_rule_of(primitive.kind);
}

namespace {

std::vector<std::string> snaps_that_break(const ScenePrimitive& line,
                                          std::span<const PixelPosition> drawn,
                                          const LineTerms& terms) {
  // Many snaps leave a line where it is; each position is judged once.
  std::vector<std::pair<SeenLine, bool>> judged;
  std::vector<std::string> result;
  for (Snap snap : all_snaps()) {
    Patience::check();
    const SeenLine seen = seen_line(line, snap, terms);
    auto found = std::find_if(judged.begin(), judged.end(), [&](const auto& known) {
      return known.first.segment.a == seen.segment.a && known.first.segment.b == seen.segment.b &&
             known.first.reach == seen.reach;
    });
    if (found == judged.end())
      found = judged.insert(found, {seen, !broken_clause(seen, terms, drawn).empty()});
    if (found->second) result.push_back(name_of(snap));
  }
  return result;
}

}  // namespace

std::vector<std::string> illegal_line_snaps(const ScenePrimitive& line,
                                            std::span<const PixelPosition> drawn,
                                            const Scene& scene) {
  return snaps_that_break(line, drawn, terms_of(line, scene));
}

namespace {

// True for one fragment at most one unit from a pixel whose closed diamond the segment meets.
bool is_near_empty_line(const SeenLine& line, std::span<const PixelPosition> drawn) {
  if (line.width != 1 || drawn.size() != 1 || !is_unseen(line)) return false;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if (may_meet_diamond({line.segment, line.reach}, {drawn[0].x + dx, drawn[0].y + dy}))
        return true;
  return false;
}

}  // namespace

CoverageLegality legality_under(RuleId rule, bool legal, std::string reason) {
  return {legal, rule_of(rule).ruling, rule, std::move(reason)};
}

int contested_ruling_on_line(const ScenePrimitive& line, std::span<const PixelPosition> drawn,
                             const Scene& scene) {
  const LineTerms terms = terms_of(line, scene);
  if (is_near_empty_line(seen_line(line, Snap{}, terms), drawn)) return kRulingOnEmptyLine;
  const std::size_t broken = snaps_that_break(line, drawn, terms).size();
  const auto holds_under_more = [&](const LineTerms& other) {
    return snaps_that_break(line, drawn, other).size() < broken;
  };
  const PixelBounds viewport = common_part(terms.bounds, pixels_in(line.viewport));
  const bool is_inside =
      std::ranges::all_of(drawn, [&](PixelPosition pixel) { return viewport.contains(pixel); });
  if (viewport != terms.bounds && is_inside &&
      holds_under_more({terms.widths, viewport, terms.errors}))
    return kRulingOnViewport;
  const Fixed width = line.state->line_width;
  const int smaller = static_cast<int>(width.floor());
  const bool is_smaller = smaller >= 1 && smaller < terms.widths.back();
  if (is_smaller && holds_under_more({{smaller}, terms.bounds, terms.errors}))
    return kRulingOnSmallerWidth;
  return 0;
}

bool is_cut_at_sides(const ScenePrimitive& line, std::span<const PixelPosition> drawn,
                     const Scene& scene) {
  if (line.clips_sides || !leaves_sides(line)) return false;
  const ScenePrimitive cut = with_sides(line, true);
  if (cut.is_clipped || drawn.empty()) return cut.is_clipped && drawn.empty();
  return illegal_line_snaps(cut, drawn, scene).size() < all_snaps().size() ||
         contested_ruling_on_line(cut, drawn, scene) == kRulingOnViewport;
}

std::string broken_clause_unsnapped(const ScenePrimitive& line,
                                    std::span<const PixelPosition> drawn, const Scene& scene) {
  const LineTerms terms = terms_of(line, scene);
  return broken_clause(seen_line(line, Snap{}, terms), terms, drawn);
}

int ruling_on_line(const ScenePrimitive& line, const Scene& scene) {
  const SeenLine seen = seen_line(line, Snap{}, terms_of(line, scene));
  if (seen.width != 1) return rule_of(RuleId::line_width).ruling;
  return is_unseen(seen) ? kRulingOnUnseenLine : rule_of(RuleId::line_diamond_exit).ruling;
}

bool is_about_a_line(const DisagreementClass& disagreement) {
  return disagreement.rule == RuleId::line_diamond_exit || disagreement.rule == RuleId::line_joint;
}

}  // namespace edgecase
