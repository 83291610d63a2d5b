// SPDX-License-Identifier: MIT
#include "diff/coverage/coverage_report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <set>
#include <utility>

#include "diff/coverage/legality.h"
#include "diff/coverage/situation.h"
#include "exact/numeral.h"
#include "raster/coverage_stages.h"
#include "rules/all_rules.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/homogeneous_line.h"
#include "rules/coverage/homogeneous_triangle.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"

namespace edgecase {

DisagreementClass class_of(const ScenePrimitive& primitive, const CoverageDifference& difference,
                           const Target& target) {
  DisagreementClass of;
  of.sample = difference.sample;
  of.primitive = primitive.index;
  of.kind =
      difference.drawn < difference.exact ? DisagreementKind::missing : DisagreementKind::extra;
  of.rule = rule_on_coverage(primitive, target);
  return of;
}

DisagreementClass class_of_duplicate(const ScenePrimitive& primitive,
                                     const CoverageDifference& difference) {
  DisagreementClass of;
  of.sample = difference.sample;
  of.primitive = primitive.index;
  of.kind = DisagreementKind::duplicate;
  of.rule = RuleId::fragment_once;
  of.ruling = rule_of(of.rule).ruling;
  return of;
}

void describe_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                     Point sample, const Target& target, Disagreement& d) {
  d.exact = {static_cast<double>(difference.exact)};
  d.rendered = {static_cast<double>(difference.drawn)};
  d.situation = situation_of(primitive, sample, target);
}

void explain_difference(const ScenePrimitive& primitive, const CoverageDifference& difference,
                        Point sample, const Target& target, const CoverageChoice& choice,
                        Disagreement& d) {
  Explanation why = explain(primitive, sample, target, choice);
  d.explanation =
      fmt::format("{} {}: {}; exact {} {}, the renderer {}.", name_of(primitive.kind),
                  primitive.index, why.text, difference.exact > 0 ? "draws" : "does not draw",
                  target.samples > 1 ? fmt::format("sample {}", difference.sample) : "the pixel",
                  difference.drawn > 0 ? "draws it" : "does not");
  d.figure = std::move(why.figure);
}

void explain_duplicate(const CoverageDifference& difference, Point sample, const Target& target,
                       Disagreement& d) {
  d.explanation = fmt::format(
      "primitive {} produces the fragment of {}pixel ({}, {}) {} times. Ruling 7: once at most.",
      d.primitive, target.samples > 1 ? fmt::format("sample {} of ", d.sample) : "", d.x, d.y,
      difference.drawn);
  d.figure.marks = {sample_mark(sample)};
}

void merge_snaps(const std::vector<std::string>& more, std::vector<std::string>& names) {
  std::set<std::string> all(names.begin(), names.end());
  all.insert(more.begin(), more.end());
  names.clear();
  for (Snap snap : all_snaps())
    if (all.contains(name_of(snap))) names.push_back(name_of(snap));
}

namespace {

PixelPosition pixel_of(Point sample) {
  return {static_cast<int>(sample.x.floor()), static_cast<int>(sample.y.floor())};
}

// Explains a multisampled line by the position of its rectangle.
Explanation explain_rectangle(const ScenePrimitive& line, const Segment& segment, Point sample,
                              const CoverageChoice& choice) {
  const double dx = (segment.b.x - segment.a.x).to_double();
  const double dy = (segment.b.y - segment.a.y).to_double();
  const double px = (sample.x - segment.a.x).to_double();
  const double py = (sample.y - segment.a.y).to_double();
  const double length = std::hypot(dx, dy);
  Explanation why;
  why.figure.marks = {sample_mark(sample), segment_mark(MarkRole::edge, segment.a, segment.b)};
  if (length == 0) {
    why.text = "a segment without length has no area";
    return why;
  }
  const double half = line.state->line_width.to_double() / 2 / length;
  const auto corner = [&](Point end, double side) {
    return std::pair(end.x.to_double() - side * dy * half, end.y.to_double() + side * dx * half);
  };
  why.figure.marks.push_back(
      {MarkRole::region,
       true,
       {corner(segment.a, 1), corner(segment.b, 1), corner(segment.b, -1), corner(segment.a, -1)},
       ""});
  const Rule& rule = rule_of(RuleId::line_multisampled);
  const char* name = name_of(choice.multisampled_line);
  why.text = fmt::format(
      "the sample {} lies {:.6g} pixels from the segment {} to {} of width {}, {:.6g} of {:.6g} "
      "pixels along it; as {} has it: {}",
      format_point(sample), std::fabs(dx * py - dy * px) / length, format_point(segment.a),
      format_point(segment.b), to_decimal(line.state->line_width), (dx * px + dy * py) / length,
      length, name, find_alternative(rule, name)->meaning);
  return why;
}

// Explains lines of width 1 under the diamond-exit rule by its numbers, others by the algorithm.
Explanation explain_line_choice(const ScenePrimitive& line, const Segment& segment, PixelPosition p,
                                const CoverageChoice& choice) {
  Explanation why = explain_line(segment, p.x, p.y, *choice.line.boundary);
  const bool thin = line.state->line_width == Fixed::from_integer(1);
  if (thin && choice.line.algorithm == LineAlgorithm::diamond_exit) return why;
  const Rule& rule = rule_of(thin ? RuleId::line_algorithm : RuleId::line_width);
  const char* name = thin ? name_of(choice.line.algorithm) : name_of(choice.line.wide);
  why.text =
      fmt::format("the segment {} to {} of width {} is drawn as {} says ({})",
                  format_point(segment.a), format_point(segment.b),
                  to_decimal(line.state->line_width), name, find_alternative(rule, name)->meaning);
  return why;
}

// Adds what the rule's own explanation leaves out: an algorithm other than edge functions, an
// offset, a target that is seen upside down.
std::string notes_on(const ScenePrimitive& primitive, const Target& target,
                     const CoverageChoice& choice) {
  std::string notes;
  const auto add = [&](RuleId rule, const char* name) {
    notes +=
        fmt::format("; as {} has it: {}", name, find_alternative(rule_of(rule), name)->meaning);
  };
  if (primitive.kind == PrimitiveKind::triangle &&
      choice.triangle_algorithm != TriangleAlgorithm::edge_functions)
    add(RuleId::triangle_algorithm, name_of(choice.triangle_algorithm));
  if (primitive.kind == PrimitiveKind::point && choice.point_offset != PointOffset::none)
    add(RuleId::point_offset, name_of(choice.point_offset));
  if (primitive.kind == PrimitiveKind::point && choice.point_clip != PointClip::as_set)
    add(RuleId::point_clip, name_of(choice.point_clip));
  if (primitive.is_clipped && choice.clip != ClipMethod::homogeneous)
    add(RuleId::clip_volume, name_of(choice.clip));
  if (choice.rows != RowOrder::bottom_up)
    add(row_order_rule_of(primitive.kind), name_of(choice.rows));
  if (is_multisampled(*primitive.state, target) && choice.placement != SamplePlacement{})
    add(RuleId::sample_positions, name_of(choice.placement).c_str());
  return notes;
}

// True if the rule that decides by quotients covers the pixel. Known only for the ideal rules, with
// y up.
std::optional<bool> covered_by(const ScenePrimitive& primitive,
                               const std::array<HomogeneousPoint, 3>& positions, Point sample,
                               const CoverageChoice& choice) {
  const PixelPosition p = pixel_of(sample);
  if (sample != pixel_centre(p.x, p.y)) return std::nullopt;
  if (choice.rows != RowOrder::bottom_up) return std::nullopt;
  const Draw& state = *primitive.state;
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return point_covers({moved(positions[0], choice.point_offset), state.point_size}, p.x, p.y,
                          choice.ties);
    case PrimitiveKind::line:
      if (state.line_width != Fixed::from_integer(1)) return std::nullopt;
      if (choice.line.algorithm != LineAlgorithm::diamond_exit) return std::nullopt;
      return diamond_exit_covers(HomogeneousSegment{positions[0], positions[1]}, p.x, p.y,
                                 *choice.line.boundary);
    case PrimitiveKind::triangle:
      if (choice.triangle_algorithm != TriangleAlgorithm::edge_functions) return std::nullopt;
      return triangle_covers(positions, p.x, p.y, choice.ties);
  }
  return std::nullopt;
}

// Text and figures give positions as decimals: of a vertex that is a quotient, the nearest. Adds a
// note where that would change the decision.
std::string note_on_quotients(const ScenePrimitive& primitive, Point sample,
                              const CoverageChoice& choice) {
  if (!choice.snap.is_none() || !has_clip_positions(primitive)) return "";
  // The explanation of a clipped primitive mentions quotients itself.
  if (primitive.is_clipped) return "";
  std::array<HomogeneousPoint, 3> nearest;
  for (std::size_t i = 0; i < nearest.size(); ++i)
    nearest[i] = homogeneous(nearest_point(primitive.positions[i]));
  const auto exact = covered_by(primitive, primitive.positions, sample, choice);
  const bool differs = exact != covered_by(primitive, nearest, sample, choice);
  std::string note =
      "; vertices given as clip coordinates are quotients by w, here given to the nearest 1/65536 "
      "pixel";
  if (differs)
    note += fmt::format(", and as quotients they {} the pixel", *exact ? "cover" : "do not cover");
  return note;
}

// Explains by the rule that decides, with the vertices as the choice has them.
Explanation explain_by_rule(const ScenePrimitive& primitive, Point sample, const Target& target,
                            const CoverageChoice& choice) {
  if (primitive.is_clipped)
    return primitive.kind == PrimitiveKind::triangle
               ? explain_clipped_triangle(primitive, sample, choice.ties)
               : explain_clipped_point(primitive, sample);
  const auto at = [&](std::size_t i) { return choice.snap(primitive.positions[i]); };
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return explain_point({at(0), primitive.state->point_size}, sample, choice.ties);
    case PrimitiveKind::line:
      if (is_multisampled(*primitive.state, target))
        return explain_rectangle(primitive, {at(0), at(1)}, sample, choice);
      return explain_line_choice(primitive, {at(0), at(1)}, pixel_of(sample), choice);
    case PrimitiveKind::triangle:
      return explain_triangle({at(0), at(1), at(2)}, sample, choice.ties);
  }
  return {};
}

}  // namespace

Explanation explain(const ScenePrimitive& primitive, Point sample, const Target& target,
                    const CoverageChoice& choice) {
  if (auto culled = explain_culling(primitive, target, choice)) {
    culled->figure.marks.push_back(sample_mark(sample));
    return *culled;
  }
  Explanation why = explain_by_rule(primitive, sample, target, choice);
  why.text += notes_on(primitive, target, choice) + note_on_quotients(primitive, sample, choice);
  return why;
}

}  // namespace edgecase
