// SPDX-License-Identifier: MIT
#include "rules/all_rules.h"

#include <map>
#include <vector>

#include "rules/coverage/clip_volume.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/fragment_once.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_joints.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/polygon_facing.h"
#include "rules/coverage/row_order.h"
#include "rules/coverage/shared_edge.h"
#include "rules/coverage/snap.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window_origin.h"
#include "rules/output/blending.h"
#include "rules/output/depth_test.h"
#include "rules/output/polygon_offset.h"
#include "rules/output/stencil_test.h"
#include "rules/ruling_sources.h"
#include "rules/samples/accumulation.h"
#include "rules/samples/alpha_to_coverage.h"
#include "rules/samples/attribute_location.h"
#include "rules/samples/multisampled_line.h"
#include "rules/samples/resolve.h"
#include "rules/samples/sample_mask.h"
#include "rules/samples/sample_placement.h"
#include "rules/samples/shading_rate.h"
#include "rules/textures/anisotropy.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/level_selection.h"
#include "rules/textures/log2_method.h"
#include "rules/textures/mip_chain.h"
#include "rules/textures/texel_filter.h"
#include "rules/textures/wrap.h"
#include "rules/values/depth_buffer.h"
#include "rules/values/derivative.h"
#include "rules/values/flat_attribute.h"
#include "rules/values/framebuffer.h"
#include "rules/values/smooth_attribute.h"

namespace edgecase {

const char* name_of(Openness openness) {
  switch (openness) {
    case Openness::open:
      return "open";
    case Openness::mandated:
      return "mandated";
    case Openness::illegal:
      return "illegal";
  }
  return "?";
}

const char* name_of(Basis basis) {
  switch (basis) {
    case Basis::normative:
      return "normative";
    case Basis::contested:
      return "contested";
  }
  return "?";
}

namespace {

// The table of contents. An explicit list: nothing registers itself.
std::vector<Rule> table_of_contents() {
  return {
      window_origin_rule(),
      fragment_once_rule(),
      point_ownership_rule(),
      point_offset_rule(),
      diamond_exit_rule(),
      interior_gap_rule(),
      line_joint_rule(),
      line_algorithm_rule(),
      line_width_rule(),
      triangle_algorithm_rule(),
      triangle_fill_rule(),
      shared_edge_rule(),
      snap_rule("subpixel.snap"),
      snap_rule("point.snap"),
      snap_rule("line.snap"),
      snap_rule("triangle.snap"),
      row_order_rule("point.row-order"),
      row_order_rule("line.row-order"),
      row_order_rule("triangle.row-order"),
      clip_volume_rule(),
      polygon_facing_rule(),
      flat_attribute_rule(),
      provoking_vertex_rule(),
      smooth_attribute_rule(),
      perspective_rule(),
      attribute_positions_rule(),
      derivative_rule(),
      fine_derivative_rule(),
      coarse_derivative_rule(),
      quad_rows_rule(),
      depth_rule(),
      offset_slope_rule(),
      offset_unit_rule(),
      offset_exponent_rule(),
      fragment_coordinates_rule(),
      sample_positions_rule(),
      multisample_switch_rule(),
      multisampled_line_rule(),
      sample_mask_rule(),
      shading_rate_rule(),
      attribute_location_rule(),
      centroid_rule(),
      sample_depth_rule(),
      alpha_to_coverage_rule(),
      resolve_rule(),
      accumulation_rule(),
      texel_filter_rule(),
      texel_grid_rule(),
      wrap_rule(),
      scale_factor_rule(),
      log2_rule(),
      level_derivatives_rule(),
      lod_bias_rule(),
      crossover_rule(),
      nearest_level_rule(),
      level_weight_rule(),
      anisotropy_rule(),
      level_count_rule(),
      mipmap_filter_rule(),
      mipmap_rounding_rule(),
      mipmap_srgb_rule(),
      stencil_test_rule(),
      depth_test_rule(),
      depth_mask_rule(),
      blend_equation_rule(),
      blend_rounding_rule(),
      color_mask_rule(),
      unorm8_rule(),
      depth_buffer_rule(),
      order_rule(),
  };
}

}  // namespace

std::span<const Rule> all_rules() {
  static const std::vector<Rule> rules = [] {
    std::vector<Rule> complete = table_of_contents();
    for (Rule& rule : complete)
      for (Ruling& ruling : rule.rulings) ruling.source = source_of(ruling.number);
    return complete;
  }();
  return rules;
}

const Rule* find_rule(std::string_view id) {
  for (const Rule& rule : all_rules())
    if (rule.id == id) return &rule;
  return nullptr;
}

const Alternative* find_alternative(const Rule& rule, std::string_view name) {
  for (const Alternative& alternative : rule.alternatives)
    if (alternative.name == name) return &alternative;
  return nullptr;
}

const Ruling* find_ruling(int number) {
  static const std::map<int, const Ruling*> rulings = [] {
    std::map<int, const Ruling*> numbered;
    for (const Rule& rule : all_rules())
      for (const Ruling& ruling : rule.rulings) numbered.emplace(ruling.number, &ruling);
    return numbered;
  }();
  const auto found = rulings.find(number);
  return found == rulings.end() ? nullptr : found->second;
}

std::vector<RulingFact> facts_of(const Ruling& ruling) {
  const RulingSource& source = ruling.source;
  std::vector<RulingFact> facts;
  const auto add = [&facts](const char* name, const std::string& text) {
    if (!text.empty()) facts.push_back({name, text});
  };
  add("Withdrawn", source.withdrawn);
  add("Basis",
      std::string(name_of(source.basis)) + (source.contest.empty() ? "" : ": " + source.contest));
  if (!source.clause.empty())
    add("Text", source.revision + ", " + source.clause + ": \"" + source.quotation + "\"");
  add("Conformance tests", source.khronos);
  add("OpenGL ES", source.es);
  return facts;
}

Legality legality_against(int ruling) {
  const Ruling* broken = find_ruling(ruling);
  return broken != nullptr && broken->source.basis == Basis::contested ? Legality::contested
                                                                       : Legality::illegal;
}

}  // namespace edgecase
