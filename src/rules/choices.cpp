// SPDX-License-Identifier: MIT
#include "rules/choices.h"

#include <cstddef>
#include <deque>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// The alternative that a policy chooses for a rule on a surface; empty where it chooses none.
std::string chosen(const Policy& policy, Surface surface, const std::string& rule) {
  if (const auto overrides = policy.surfaces.find(surface); overrides != policy.surfaces.end())
    if (const auto choice = overrides->second.find(rule); choice != overrides->second.end())
      return choice->second;
  const auto choice = policy.rules.find(rule);
  return choice != policy.rules.end() ? choice->second : "";
}

// The alternative chosen for a rule, or the catalogue's standard one.
std::string chosen_or_standard(const Policy& policy, Surface surface, const std::string& rule) {
  const std::string choice = chosen(policy, surface, rule);
  return choice.empty() ? find_rule(rule)->standard : choice;
}

LineChoice resolve_line(const Policy& policy, Surface surface) {
  LineChoice result;
  parse_name(chosen_or_standard(policy, surface, "line.algorithm"), result.algorithm);
  parse_name(chosen_or_standard(policy, surface, "line.width"), result.wide);
  result.boundary = find_diamond_boundary(chosen_or_standard(policy, surface, "line.diamond-exit"));
  return result;
}

CoverageChoice resolve_primitive(const Policy& policy, Surface surface, PrimitiveKind kind) {
  CoverageChoice result;
  std::string snap = chosen(policy, surface, snap_rule_of(kind));
  if (snap.empty()) snap = chosen_or_standard(policy, surface, "subpixel.snap");
  result.snap = *find_snap(snap);
  // Lines that are drawn as areas are drawn as polygons are.
  const bool point = kind == PrimitiveKind::point;
  result.ties = *find_tie_rule(
      chosen_or_standard(policy, surface, point ? "point.ownership" : "triangle.fill-rule"));
  result.line = resolve_line(policy, surface);
  parse_name(chosen_or_standard(policy, surface, row_order_rule_of(kind)), result.rows);
  parse_name(chosen_or_standard(policy, surface, row_order_rule_of(PrimitiveKind::triangle)),
             result.polygon_rows);
  parse_name(chosen_or_standard(policy, surface, "point.offset"), result.point_offset);
  parse_name(chosen_or_standard(policy, surface, "triangle.algorithm"), result.triangle_algorithm);
  parse_name(chosen_or_standard(policy, surface, "polygon.facing"), result.facing);
  parse_name(chosen_or_standard(policy, surface, "clip.volume"), result.clip);
  parse_name(chosen_or_standard(policy, surface, "sample.positions"), result.placement);
  parse_name(chosen_or_standard(policy, surface, "line.multisampled"), result.multisampled_line);
  parse_name(chosen_or_standard(policy, surface, "sample.enable"), result.multisample_switch);
  parse_name(chosen_or_standard(policy, surface, "sample.mask"), result.sample_mask);
  return result;
}

ValueChoice resolve_values(const Policy& policy, Surface surface) {
  ValueChoice result;
  const std::string provoking = chosen(policy, surface, "attribute.provoking-vertex");
  if (provoking == "first") result.provoking = ProvokingChoice::first;
  if (provoking == "last") result.provoking = ProvokingChoice::last;
  if (chosen(policy, surface, "attribute.smooth") == "major-axis")
    result.line_parameter = LineParameter::major_axis;
  parse_name(chosen_or_standard(policy, surface, "attribute.perspective"), result.perspective);
  parse_name(chosen_or_standard(policy, surface, "attribute.positions"), result.positions);
  for (const Derivative derivative : {Derivative::x, Derivative::x_fine, Derivative::x_coarse})
    parse_name(chosen_or_standard(policy, surface, derivative_rule_of(derivative)),
               result.derivatives[form_of(derivative)]);
  parse_name(chosen_or_standard(policy, surface, "derivative.quad-rows"), result.quad_rows);
  LocationChoice& locations = result.locations;
  parse_name(chosen_or_standard(policy, surface, "attribute.location"), locations.plain);
  parse_name(chosen_or_standard(policy, surface, "attribute.centroid"), locations.centroid);
  parse_name(chosen_or_standard(policy, surface, "sample.depth"), locations.depth);
  parse_name(chosen_or_standard(policy, surface, "offset.slope"), result.offset.slope);
  parse_name(chosen_or_standard(policy, surface, "offset.unit"), result.offset.unit);
  parse_name(chosen_or_standard(policy, surface, "offset.exponent"), result.offset.exponent);
  return result;
}

TextureChoice resolve_textures(const Policy& policy, Surface surface) {
  TextureChoice result;
  const auto resolve_rule = [&](const char* rule, auto& choice) {
    parse_name(chosen_or_standard(policy, surface, rule), choice);
  };
  resolve_rule("texture.wrap", result.wrap);
  resolve_rule("texture.texel-grid", result.texel_grid);
  resolve_rule("texture.scale-factor", result.scale_factor);
  resolve_rule("texture.log2", result.log2);
  resolve_rule("texture.derivatives", result.derivatives);
  resolve_rule("texture.lod-bias", result.bias);
  resolve_rule("texture.crossover", result.crossover);
  resolve_rule("texture.nearest-level", result.nearest_level);
  resolve_rule("texture.level-weight", result.level_weight);
  resolve_rule("texture.anisotropy", result.anisotropy);
  resolve_rule("mipmap.level-count", result.level_count);
  resolve_rule("mipmap.filter", result.mipmap.filter);
  resolve_rule("mipmap.rounding", result.mipmap.rounding);
  result.mipmap.linear_srgb = chosen_or_standard(policy, surface, "mipmap.srgb") == "linear";
  return result;
}

SampleChoice resolve_samples(const Policy& policy, Surface surface) {
  SampleChoice result;
  parse_name(chosen_or_standard(policy, surface, "sample.shading-rate"), result.rate);
  parse_name(chosen_or_standard(policy, surface, "sample.alpha-to-coverage"),
             result.alpha_to_coverage);
  parse_name(chosen_or_standard(policy, surface, "sample.resolve"), result.resolve);
  parse_name(chosen_or_standard(policy, surface, "supersample.accumulation"), result.accumulation);
  return result;
}

OutputChoice resolve_output(const Policy& policy, Surface surface) {
  OutputChoice result;
  parse_name(chosen_or_standard(policy, surface, "depth.test"), result.depth);
  parse_name(chosen_or_standard(policy, surface, "depth.mask"), result.depth_mask);
  parse_name(chosen_or_standard(policy, surface, "stencil.test"), result.stencil);
  parse_name(chosen_or_standard(policy, surface, "blend.equation"), result.blend.method);
  parse_name(chosen_or_standard(policy, surface, "blend.rounding"), result.blend.rounding);
  parse_name(chosen_or_standard(policy, surface, "color.mask"), result.blend.mask);
  return result;
}

RuleChoices resolve_anew(const Policy& policy, Surface surface) {
  return {resolve_primitive(policy, surface, PrimitiveKind::point),
          resolve_primitive(policy, surface, PrimitiveKind::line),
          resolve_primitive(policy, surface, PrimitiveKind::triangle),
          resolve_values(policy, surface),
          resolve_textures(policy, surface),
          resolve_samples(policy, surface),
          resolve_output(policy, surface)};
}

}  // namespace

const CoverageChoice& RuleChoices::of(PrimitiveKind kind) const {
  switch (kind) {
    case PrimitiveKind::point:
      return points;
    case PrimitiveKind::line:
      return lines;
    case PrimitiveKind::triangle:
      return triangles;
  }
  return triangles;
}

const char* coverage_rule_of(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
      return "point.ownership";
    case PrimitiveKind::line:
      return "line.diamond-exit";
    case PrimitiveKind::triangle:
      return "triangle.fill-rule";
  }
  return "?";
}

const char* snap_rule_of(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
      return "point.snap";
    case PrimitiveKind::line:
      return "line.snap";
    case PrimitiveKind::triangle:
      return "triangle.snap";
  }
  return "?";
}

const char* row_order_rule_of(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::point:
      return "point.row-order";
    case PrimitiveKind::line:
      return "line.row-order";
    case PrimitiveKind::triangle:
      return "triangle.row-order";
  }
  return "?";
}

// All cases of a run are drawn by one policy or a few: what it chooses is looked up once.
RuleChoices resolve(const Policy& policy, Surface surface) {
  struct Known {
    Choices rules, overrides;
    RuleChoices choices;
  };
  constexpr std::size_t kMostKnown = 8;
  thread_local std::deque<Known> known;
  static const Choices kNone;
  const auto found = policy.surfaces.find(surface);
  const Choices& overrides = found == policy.surfaces.end() ? kNone : found->second;
  for (const Known& one : known)
    if (one.rules == policy.rules && one.overrides == overrides) return one.choices;
  if (known.size() == kMostKnown) known.pop_back();
  known.push_front({policy.rules, overrides, resolve_anew(policy, surface)});
  return known.front().choices;
}

}  // namespace edgecase
