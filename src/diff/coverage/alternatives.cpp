// SPDX-License-Identifier: MIT
#include "diff/coverage/alternatives.h"

#include <fmt/format.h>

#include <string_view>

#include "diff/coverage/legality.h"
#include "rules/all_rules.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/window_origin.h"

namespace edgecase {
namespace {

RuleAlternatives snaps_beside(PrimitiveKind kind, Snap chosen) {
  RuleAlternatives result;
  for (Snap snap : all_snaps())
    if (snap != chosen)
      result.push_back({fmt::format("{}={}", snap_rule_of(kind), name_of(snap)),
                        [snap](CoverageChoice& choice) { choice.snap = snap; }});
  return result;
}

RuleAlternatives ties_beside(PrimitiveKind kind, const TieRule& chosen) {
  RuleAlternatives result;
  const auto rules = kind == PrimitiveKind::point ? point_tie_rules() : all_tie_rules();
  for (const TieRule& ties : rules)
    if (ties.name != chosen.name)
      result.push_back({fmt::format("{}={}", coverage_rule_of(kind), ties.name),
                        [&ties](CoverageChoice& choice) { choice.ties = ties; }});
  return result;
}

RuleAlternatives algorithms_beside(LineAlgorithm chosen) {
  RuleAlternatives result;
  for (LineAlgorithm algorithm : all_line_algorithms())
    if (algorithm != chosen)
      result.push_back(
          {fmt::format("line.algorithm={}", name_of(algorithm)),
           [algorithm](CoverageChoice& choice) { choice.line.algorithm = algorithm; }});
  return result;
}

RuleAlternatives boundaries_beside(const DiamondBoundary& chosen) {
  RuleAlternatives result;
  for (const DiamondBoundary& boundary : all_diamond_boundaries())
    if (boundary.name != chosen.name)
      result.push_back({fmt::format("line.diamond-exit={}", boundary.name),
                        [&boundary](CoverageChoice& choice) { choice.line.boundary = &boundary; }});
  return result;
}

RuleAlternatives wide_lines_beside(WideLine chosen) {
  RuleAlternatives result;
  for (WideLine wide : all_wide_lines())
    if (wide != chosen)
      result.push_back({fmt::format("line.width={}", name_of(wide)),
                        [wide](CoverageChoice& choice) { choice.line.wide = wide; }});
  return result;
}

RuleAlternatives row_orders_beside(PrimitiveKind kind, RowOrder chosen) {
  RuleAlternatives result;
  for (RowOrder rows : {RowOrder::bottom_up, RowOrder::top_down})
    if (rows != chosen)
      result.push_back({fmt::format("{}={}", row_order_rule_of(kind), name_of(rows)),
                        [rows](CoverageChoice& choice) { choice.rows = rows; }});
  return result;
}

RuleAlternatives offsets_beside(PointOffset chosen) {
  RuleAlternatives result;
  for (PointOffset offset : {PointOffset::none, PointOffset::right_down})
    if (offset != chosen)
      result.push_back({fmt::format("point.offset={}", name_of(offset)),
                        [offset](CoverageChoice& choice) { choice.point_offset = offset; }});
  return result;
}

RuleAlternatives triangle_algorithms_beside(TriangleAlgorithm chosen) {
  RuleAlternatives result;
  for (TriangleAlgorithm algorithm : all_triangle_algorithms())
    if (algorithm != chosen)
      result.push_back(
          {fmt::format("triangle.algorithm={}", name_of(algorithm)),
           [algorithm](CoverageChoice& choice) { choice.triangle_algorithm = algorithm; }});
  return result;
}

RuleAlternatives facings_beside(FacingMethod chosen) {
  RuleAlternatives result;
  for (FacingMethod facing : values_of<FacingMethod>())
    if (facing != chosen)
      result.push_back({fmt::format("polygon.facing={}", name_of(facing)),
                        [facing](CoverageChoice& choice) { choice.facing = facing; }});
  return result;
}

RuleAlternatives clip_methods_beside(ClipMethod chosen) {
  RuleAlternatives result;
  for (ClipMethod clip : values_of<ClipMethod>())
    if (clip != chosen)
      result.push_back({fmt::format("{}={}", kClipVolume, name_of(clip)),
                        [clip](CoverageChoice& choice) { choice.clip = clip; }});
  return result;
}

RuleAlternatives placements_beside(int samples, const SamplePlacement& chosen) {
  RuleAlternatives result;
  for (const SamplePlacement& placement : placements_of(samples))
    if (placement != chosen)
      result.push_back({fmt::format("sample.positions={}", name_of(placement)),
                        [placement](CoverageChoice& choice) { choice.placement = placement; }});
  return result;
}

RuleAlternatives multisampled_lines_beside(MultisampledLine chosen) {
  RuleAlternatives result;
  for (MultisampledLine line : values_of<MultisampledLine>())
    if (line != chosen)
      result.push_back({fmt::format("{}={}", kMultisampledLine, name_of(line)),
                        [line](CoverageChoice& choice) { choice.multisampled_line = line; }});
  return result;
}

RuleAlternatives switches_beside(MultisampleSwitch chosen) {
  RuleAlternatives result;
  for (MultisampleSwitch choice : values_of<MultisampleSwitch>())
    if (choice != chosen)
      result.push_back({fmt::format("sample.enable={}", name_of(choice)),
                        [choice](CoverageChoice& c) { c.multisample_switch = choice; }});
  return result;
}

RuleAlternatives masks_beside(SampleMask chosen) {
  RuleAlternatives result;
  for (SampleMask choice : {SampleMask::applied, SampleMask::ignored})
    if (choice != chosen)
      result.push_back({fmt::format("sample.mask={}", name_of(choice)),
                        [choice](CoverageChoice& c) { c.sample_mask = choice; }});
  return result;
}

std::vector<RuleAlternatives> line_alternatives(const CoverageTraits& traits,
                                                const CoverageChoice& chosen) {
  std::vector<RuleAlternatives> rules = {
      algorithms_beside(chosen.line.algorithm), boundaries_beside(*chosen.line.boundary),
      snaps_beside(traits.kind, chosen.snap), row_orders_beside(traits.kind, chosen.rows)};
  if (traits.is_wide) rules.push_back(wide_lines_beside(chosen.line.wide));
  return rules;
}

// Multisampled lines are rectangles, whose ties are those of polygons.
std::vector<RuleAlternatives> rectangle_alternatives(const CoverageChoice& chosen) {
  return {multisampled_lines_beside(chosen.multisampled_line),
          ties_beside(PrimitiveKind::triangle, chosen.ties),
          snaps_beside(PrimitiveKind::line, chosen.snap),
          row_orders_beside(PrimitiveKind::line, chosen.rows)};
}

}  // namespace

CoverageTraits coverage_traits(const ScenePrimitive& primitive, const Target& target) {
  const Multisampling& use = primitive.state->multisampling;
  CoverageTraits traits;
  traits.kind = primitive.kind;
  traits.samples = target.samples;
  traits.is_multisampled = is_multisampled(*primitive.state, target);
  traits.is_switched_off = target.samples > 1 && !use.enabled;
  traits.heeds_mask =
      traits.is_multisampled && writable_samples(use, target.samples, SampleMask::applied) !=
                                    writable_samples(use, target.samples, SampleMask::ignored);
  traits.is_wide = primitive.kind == PrimitiveKind::line &&
                   primitive.state->line_width != Fixed::from_integer(1);
  traits.is_clipped = primitive.is_clipped;
  traits.is_culled_by_facing = primitive.state->cull != CullMode::none;
  return traits;
}

std::vector<RuleAlternatives> alternatives_beside(const CoverageTraits& traits,
                                                  const CoverageChoice& chosen) {
  std::vector<RuleAlternatives> rules;
  switch (traits.kind) {
    case PrimitiveKind::point:
      rules = {ties_beside(traits.kind, chosen.ties), snaps_beside(traits.kind, chosen.snap),
               offsets_beside(chosen.point_offset), row_orders_beside(traits.kind, chosen.rows)};
      break;
    case PrimitiveKind::line:
      rules = traits.is_multisampled ? rectangle_alternatives(chosen)
                                     : line_alternatives(traits, chosen);
      break;
    case PrimitiveKind::triangle:
      rules = {ties_beside(traits.kind, chosen.ties), snaps_beside(traits.kind, chosen.snap),
               triangle_algorithms_beside(chosen.triangle_algorithm),
               row_orders_beside(traits.kind, chosen.rows)};
      if (traits.is_clipped) rules.push_back(clip_methods_beside(chosen.clip));
      if (traits.is_culled_by_facing) rules.push_back(facings_beside(chosen.facing));
      break;
  }
  if (traits.is_multisampled) rules.push_back(placements_beside(traits.samples, chosen.placement));
  if (traits.heeds_mask) rules.push_back(masks_beside(chosen.sample_mask));
  if (traits.is_switched_off) rules.push_back(switches_beside(chosen.multisample_switch));
  return rules;
}

std::vector<RuleAlternatives> alternatives_beside(const ScenePrimitive& primitive,
                                                  const Target& target,
                                                  const CoverageChoice& chosen) {
  return alternatives_beside(coverage_traits(primitive, target), chosen);
}

std::vector<Change> changes_between(const ScenePrimitive& primitive, const Target& target,
                                    const CoverageChoice& from, const CoverageChoice& to) {
  auto rules = alternatives_beside(primitive, target, from);
  if (primitive.kind == PrimitiveKind::line && !is_multisampled(*primitive.state, target) &&
      fills_area(to.line, primitive.state->line_width))
    rules.push_back(ties_beside(PrimitiveKind::triangle, from.ties));
  std::vector<Change> changes;
  for (const RuleAlternatives& rule : rules)
    for (const Change& change : rule)
      if (change.applied_to(to) == to) changes.push_back(change);
  return changes;
}

std::string choice_of(const CoverageChoice& choice, std::string_view rule) {
  if (rule.ends_with(".snap")) return name_of(choice.snap);
  if (rule == "point.ownership" || rule == "triangle.fill-rule")
    return std::string(choice.ties.name);
  if (rule == "line.algorithm") return name_of(choice.line.algorithm);
  if (rule == "line.diamond-exit") return std::string(choice.line.boundary->name);
  if (rule == "line.width") return name_of(choice.line.wide);
  if (rule == "point.offset") return name_of(choice.point_offset);
  if (rule == "triangle.algorithm") return name_of(choice.triangle_algorithm);
  if (rule == kClipVolume) return name_of(choice.clip);
  if (rule == "polygon.facing") return name_of(choice.facing);
  if (rule.ends_with(".row-order")) return name_of(choice.rows);
  if (rule == "sample.positions") return name_of(choice.placement);
  if (rule == kMultisampledLine) return name_of(choice.multisampled_line);
  if (rule == "sample.enable") return name_of(choice.multisample_switch);
  if (rule == "sample.mask") return name_of(choice.sample_mask);
  return "";
}

std::span<const std::string> alternative_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const char* id :
         {"point.ownership", "point.offset", "point.snap", "point.row-order", "line.algorithm",
          "line.diamond-exit", "line.width", "line.snap", "line.row-order", "triangle.algorithm",
          "triangle.fill-rule", "triangle.snap", "triangle.row-order", "line.multisampled",
          "sample.positions", "sample.enable", "sample.mask", "clip.volume", "polygon.facing"})
      for (const Alternative& alternative : find_rule(id)->alternatives)
        list.push_back(fmt::format("{}={}", id, alternative.name));
    list.push_back(kWindowOrigin);
    return list;
  }();
  return names;
}

}  // namespace edgecase
