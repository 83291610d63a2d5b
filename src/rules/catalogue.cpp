// SPDX-License-Identifier: MIT
#include "rules/catalogue.h"

#include <algorithm>
#include <vector>

#include "rules/choices.h"
#include "rules/coverage/clip_volume.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/line_algorithm.h"
#include "rules/coverage/line_joints.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_algorithm.h"
#include "rules/coverage/triangle_fill.h"
#include "rules/coverage/window.h"
#include "rules/output/blending.h"
#include "rules/output/fragment_tests.h"
#include "rules/output/polygon_offset.h"
#include "rules/samples/attribute_location.h"
#include "rules/samples/multisampled_line.h"
#include "rules/samples/resolve.h"
#include "rules/samples/sample_mask.h"
#include "rules/samples/sample_placement.h"
#include "rules/samples/shading_rate.h"
#include "rules/textures/level_of_detail.h"
#include "rules/textures/level_selection.h"
#include "rules/textures/mip_chain.h"
#include "rules/textures/texel_filter.h"
#include "rules/textures/texture_image.h"
#include "rules/values/attributes.h"
#include "rules/values/derivative.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

void put_name(std::string_view name, Snap& choice) {
  choice = *find_snap(name);
}
void put_name(std::string_view name, TieRule& choice) {
  choice = *find_tie_rule(name);
}
void put_name(std::string_view name, const DiamondBoundary*& choice) {
  choice = find_diamond_boundary(name);
}
template <class Choice>
void put_name(std::string_view name, Choice& choice) {
  parse_name(name, choice);
}

std::string kept_name(const TieRule& choice) {
  return std::string(choice.name);
}
std::string kept_name(const DiamondBoundary* choice) {
  return std::string(choice->name);
}
template <class Choice>
std::string kept_name(const Choice& choice) {
  return name_of(choice);
}

// The member at the end of a path of members.
template <auto First, auto... Rest, class Whole>
auto& at(Whole& whole) {
  if constexpr (sizeof...(Rest) == 0)
    return whole.*First;
  else
    return at<Rest...>(whole.*First);
}

template <auto... Path>
constexpr Slot kept_at() {
  return {[](RuleChoices& c, std::string_view name) { put_name(name, at<Path...>(c)); },
          [](const RuleChoices& c) { return kept_name(at<Path...>(c)); }};
}

template <auto... Path>
constexpr Slot of_points() {
  return kept_at<&RuleChoices::points, Path...>();
}
template <auto... Path>
constexpr Slot of_lines() {
  return kept_at<&RuleChoices::lines, Path...>();
}
template <auto... Path>
constexpr Slot of_triangles() {
  return kept_at<&RuleChoices::triangles, Path...>();
}

// A choice kept once for every kind of primitive.
template <auto... Path>
constexpr Slot of_all_kinds() {
  Slot slot = of_triangles<Path...>();
  slot.put = [](RuleChoices& c, std::string_view name) {
    for (CoverageChoice* choice : {&c.points, &c.lines, &c.triangles})
      put_name(name, at<Path...>(*choice));
  };
  return slot;
}

// Lines drawn as areas use the ties of polygons, and see the target as polygons do.
constexpr Slot ties_of_polygons() {
  Slot slot = of_triangles<&CoverageChoice::ties>();
  slot.put = [](RuleChoices& c, std::string_view name) {
    put_name(name, c.triangles.ties);
    put_name(name, c.lines.ties);
  };
  return slot;
}
constexpr Slot rows_of_polygons() {
  Slot slot = of_triangles<&CoverageChoice::rows>();
  slot.put = [](RuleChoices& c, std::string_view name) {
    put_name(name, c.triangles.rows);
    for (CoverageChoice* choice : {&c.points, &c.lines, &c.triangles})
      put_name(name, choice->polygon_rows);
  };
  return slot;
}

// A kind's own grid; the common one, unless the policy chooses it.
template <auto Kind>
constexpr Slot own_snap() {
  Slot slot = kept_at<Kind, &CoverageChoice::snap>();
  slot.stays = true;
  return slot;
}

template <std::size_t Form>
constexpr Slot derivatives_of_form() {
  return {[](RuleChoices& c, std::string_view name) { put_name(name, c.values.derivatives[Form]); },
          [](const RuleChoices& c) { return kept_name(c.values.derivatives[Form]); }};
}

template <auto... Path>
constexpr Slot of_values() {
  return kept_at<&RuleChoices::values, Path...>();
}
template <auto... Path>
constexpr Slot of_samples() {
  return kept_at<&RuleChoices::samples, Path...>();
}
template <auto... Path>
constexpr Slot of_textures() {
  return kept_at<&RuleChoices::textures, Path...>();
}
template <auto... Path>
constexpr Slot of_output() {
  return kept_at<&RuleChoices::output, Path...>();
}

using Traits = CoverageTraits;

bool is_point(const Traits& traits) {
  return traits.kind == PrimitiveKind::point;
}
bool is_line(const Traits& traits) {
  return traits.kind == PrimitiveKind::line;
}
bool is_triangle(const Traits& traits) {
  return traits.kind == PrimitiveKind::triangle;
}
bool is_diamond_line(const Traits& traits) {
  return is_line(traits) && !traits.is_multisampled;
}
bool is_rectangle(const Traits& traits) {
  return is_line(traits) && traits.is_multisampled;
}

template <class Predicate>
bool any_draw(const Scene& scene, const Predicate& predicate) {
  return std::ranges::any_of(scene.draws, predicate);
}

bool has_stencil_test(const Scene& scene) {
  return scene.target.stencil != StencilFormat::none &&
         any_draw(scene, [](const Draw& draw) { return draw.operations.stencil.has_value(); });
}
bool has_depth_test(const Scene& scene) {
  return scene.target.depth != DepthFormat::none && any_draw(scene, [](const Draw& draw) {
           return draw.operations.depth.function != CompareFunction::always;
         });
}
bool has_depth_codes(const Scene& scene) {
  return bits_of(scene.target.depth) > 0;
}
bool masks_depths(const Scene& scene) {
  return scene.target.depth != DepthFormat::none &&
         any_draw(scene, [](const Draw& draw) { return !draw.operations.depth.write; });
}
bool masks_colors(const Scene& scene) {
  return any_draw(scene, [](const Draw& draw) {
    return std::ranges::any_of(draw.operations.color_mask, [](bool on) { return !on; });
  });
}
bool blends(const Scene& scene) {
  return any_draw(scene, [](const Draw& draw) { return draw.operations.blending.has_value(); });
}
bool has_alpha_to_coverage(const Scene& scene) {
  return scene.target.samples > 1 &&
         any_draw(scene, [](const Draw& draw) { return draw.multisampling.alpha_to_coverage; });
}
bool is_switched_off(const Scene& scene) {
  return scene.target.samples > 1 &&
         any_draw(scene, [](const Draw& draw) { return !draw.multisampling.enabled; });
}
bool has_depths_of_samples(const Scene& scene) {
  return scene.target.samples > 1 && scene.target.depth != DepthFormat::none;
}

constexpr Say kInLookups{.in_lookups = true};

// `ruling`: for a rule that has none of its own.
Rule with(Rule rule, Slot slot, Say say = {}, int ruling = 0) {
  rule.slot = slot;
  rule.say = say;
  rule.ruling = ruling;
  return rule;
}

using C = CoverageChoice;
using V = ValueChoice;
using S = SampleChoice;
using T = TextureChoice;
using O = OutputChoice;

}  // namespace

// The table of contents: every rule, where its choice is kept, and what it decides. An explicit
// list: nothing registers itself.
std::vector<Rule> table_of_contents() {
  return {
      window_origin_rule(),
      fragment_once_rule(),
      fragment_invariant_rule(),
      with(point_ownership_rule(), of_points<&C::ties>(), {is_point}),
      with(point_offset_rule(), of_all_kinds<&C::point_offset>(), {is_point}),
      with(point_clip_rule(), of_all_kinds<&C::point_clip>(), {is_point}),
      with(diamond_exit_rule(), of_all_kinds<&C::line, &LineChoice::boundary>(), {is_diamond_line}),
      interior_gap_rule(),
      line_joint_rule(),
      with(line_algorithm_rule(), of_all_kinds<&C::line, &LineChoice::algorithm>(),
           {is_diamond_line}),
      with(line_width_rule(), of_all_kinds<&C::line, &LineChoice::wide>(),
           {[](const Traits& traits) { return is_diamond_line(traits) && traits.is_wide; }}),
      with(triangle_algorithm_rule(), of_all_kinds<&C::triangle_algorithm>(), {is_triangle}),
      with(triangle_fill_rule(), ties_of_polygons(),
           {[](const Traits& traits) { return is_triangle(traits) || is_rectangle(traits); }}),
      shared_edge_rule(),
      with(snap_rule(RuleId::subpixel_snap), of_all_kinds<&C::snap>()),
      with(snap_rule(RuleId::point_snap), own_snap<&RuleChoices::points>(), {is_point}),
      with(snap_rule(RuleId::line_snap), own_snap<&RuleChoices::lines>(), {is_line}),
      with(snap_rule(RuleId::triangle_snap), own_snap<&RuleChoices::triangles>(), {is_triangle}),
      with(row_order_rule(RuleId::point_row_order), of_points<&C::rows>(), {is_point}),
      with(row_order_rule(RuleId::line_row_order), of_lines<&C::rows>(), {is_line}),
      with(row_order_rule(RuleId::triangle_row_order), rows_of_polygons(), {is_triangle}),
      with(clip_volume_rule(), of_all_kinds<&C::clip>(),
           {[](const Traits& traits) { return is_triangle(traits) && traits.is_clipped; }}),
      with(line_clip_rule(), of_all_kinds<&C::line_clip>(),
           {[](const Traits& traits) { return is_line(traits) && traits.leaves_sides; }}),
      with(polygon_facing_rule(), of_all_kinds<&C::facing>(),
           {[](const Traits& traits) { return is_triangle(traits) && traits.is_culled_by_facing; },
            has_stencil_test}),
      flat_attribute_rule(),
      with(provoking_vertex_rule(), of_values<&V::provoking>()),
      with(smooth_attribute_rule(), of_values<&V::line_parameter>()),
      with(perspective_rule(), of_values<&V::perspective>()),
      with(attribute_positions_rule(), of_values<&V::positions>()),
      with(derivative_rule(), derivatives_of_form<form_of(Derivative::x)>()),
      with(fine_derivative_rule(), derivatives_of_form<form_of(Derivative::x_fine)>()),
      with(coarse_derivative_rule(), derivatives_of_form<form_of(Derivative::x_coarse)>()),
      with(quad_rows_rule(), of_values<&V::quad_rows>()),
      depth_rule(),
      with(offset_slope_rule(), of_values<&V::offset, &OffsetChoice::slope>(), {}, 38),
      with(offset_unit_rule(), of_values<&V::offset, &OffsetChoice::unit>()),
      with(offset_exponent_rule(), of_values<&V::offset, &OffsetChoice::exponent>(), {}, 38),
      fragment_coordinates_rule(),
      with(sample_positions_rule(), of_all_kinds<&C::placement>(),
           {[](const Traits& traits) { return traits.is_multisampled; }}),
      with(multisample_switch_rule(), of_all_kinds<&C::multisample_switch>(),
           {[](const Traits& traits) { return traits.is_switched_off; }, is_switched_off}),
      with(multisampled_line_rule(), of_all_kinds<&C::multisampled_line>(), {is_rectangle}),
      with(sample_mask_rule(), of_all_kinds<&C::sample_mask>(),
           {[](const Traits& traits) { return traits.heeds_mask; }}),
      with(shading_rate_rule(), of_samples<&S::rate>()),
      with(attribute_location_rule(), of_values<&V::locations, &LocationChoice::plain>()),
      with(centroid_rule(), of_values<&V::locations, &LocationChoice::centroid>()),
      with(sample_depth_rule(), of_values<&V::locations, &LocationChoice::depth>(),
           {nullptr, has_depths_of_samples}, 18),
      with(alpha_to_coverage_rule(), of_samples<&S::alpha_to_coverage>(),
           {nullptr, has_alpha_to_coverage}),
      with(resolve_rule(), of_samples<&S::resolve>()),
      with(accumulation_rule(), of_samples<&S::accumulation>()),
      texel_filter_rule(),
      with(texel_grid_rule(), of_textures<&T::texel_grid>(), kInLookups),
      with(wrap_rule(), of_textures<&T::wrap>(), kInLookups),
      with(scale_factor_rule(), of_textures<&T::scale_factor>(), kInLookups),
      with(log2_rule(), of_textures<&T::log2>(), kInLookups),
      with(level_derivatives_rule(), of_textures<&T::derivatives>(), kInLookups),
      with(lod_bias_rule(), of_textures<&T::bias>(), kInLookups),
      with(crossover_rule(), of_textures<&T::crossover>(), kInLookups),
      with(nearest_level_rule(), of_textures<&T::nearest_level>(), kInLookups),
      with(level_weight_rule(), of_textures<&T::level_weight>(), kInLookups),
      with(level_limits_rule(), of_textures<&T::limits>(), kInLookups, 20),
      with(anisotropy_rule(), of_textures<&T::anisotropy>(), kInLookups),
      with(level_count_rule(), of_textures<&T::level_count>()),
      with(mipmap_filter_rule(), of_textures<&T::mipmap, &MipmapMethod::filter>()),
      with(mipmap_rounding_rule(), of_textures<&T::mipmap, &MipmapMethod::rounding>()),
      with(mipmap_srgb_rule(), of_textures<&T::mipmap, &MipmapMethod::srgb>()),
      with(stencil_test_rule(), of_output<&O::stencil>(), {nullptr, has_stencil_test}),
      with(depth_test_rule(), of_output<&O::depth>(), {nullptr, has_depth_test}),
      with(depth_mask_rule(), of_output<&O::depth_mask>(), {nullptr, masks_depths}, 41),
      with(blend_equation_rule(), of_output<&O::blend, &BlendChoice::method>(), {nullptr, blends}),
      with(blend_rounding_rule(), of_output<&O::blend, &BlendChoice::rounding>(), {nullptr, blends},
           37),
      with(color_mask_rule(), of_output<&O::blend, &BlendChoice::mask>(), {nullptr, masks_colors},
           41),
      unorm8_rule(),
      depth_buffer_rule(),
      with(depth_bits_rule(), of_output<&O::depth_bits>(), {nullptr, has_depth_codes}, 18),
      order_rule(),
  };
}

}  // namespace edgecase
