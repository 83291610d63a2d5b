// SPDX-License-Identifier: MIT
#include "search/families.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>

#include "casefile/json/text.h"
#include "casefile/scene/fragment_operations.h"
#include "generate/clip_scenes.h"
#include "generate/grids.h"
#include "generate/random_scenes.h"
#include "generate/seam_scenes.h"
#include "generate/texture_scenes.h"
#include "generate/value_scenes.h"
#include "model/names.h"
#include "rules/samples/sample_placement.h"

namespace edgecase {
namespace {

// A scene's index among `count` alternating kinds: its kind, and its index within that kind.
struct Turn {
  std::size_t kind;
  std::uint64_t index;
};
Turn turn_of(std::uint64_t index, std::size_t count) {
  return {static_cast<std::size_t>(index % count), index / count};
}

Scene point_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  return random_scene({seed, PrimitiveKind::point, surface}, index);
}

// One in four is wide.
Scene line_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  const Turn turn = turn_of(index, 4);
  if (turn.kind == 3) return random_wide_line(seed, surface, turn.index);
  return random_scene({seed, PrimitiveKind::line, surface}, 3 * turn.index + turn.kind);
}

Scene triangle_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  return random_scene({seed, PrimitiveKind::triangle, surface}, index);
}

Scene sample_scene(std::uint64_t seed, Surface, std::uint64_t index) {
  constexpr std::array kSamples{4, 2, 8};
  constexpr std::array kKinds{MultisampledKind::triangle, MultisampledKind::line,
                              MultisampledKind::wide_line};
  const Turn samples = turn_of(index, kSamples.size());
  const Turn kind = turn_of(samples.index, kKinds.size());
  return random_multisampled_scene(seed, kKinds[kind.kind],
                                   standard_pattern(kSamples[samples.kind]), kind.index);
}

// Levels at ties and at the crossover, then levels that rise over the target.
Scene level_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  constexpr std::array kQuestions{TextureQuestion::implicit_tie, TextureQuestion::bias_tie,
                                  TextureQuestion::explicit_tie, TextureQuestion::crossover};
  const std::span<const RampKind> ramps = values_of<RampKind>();
  const Turn turn = turn_of(index, kQuestions.size() + ramps.size());
  if (turn.kind < kQuestions.size())
    return texture_probe({seed, surface, kQuestions[turn.kind]}, turn.index);
  return ramp_scene({seed, surface, ramps[turn.kind - kQuestions.size()]}, turn.index);
}

// In every second scene of a mode the first vertex provokes.
Scene attribute_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  const std::span<const ValueMode> modes = all_value_modes();
  const Turn turn = turn_of(index, modes.size());
  Scene scene = value_scene({seed, surface, modes[turn.kind]}, turn.index);
  if (turn.index % 2 == 1)
    for (Draw& draw : scene.draws) draw.provoking_vertex = ProvokingVertex::first;
  return scene;
}

// Minimum and maximum ignore factors, and a case file cannot give any.
void drop_unused_factors(BlendTerm& term) {
  if (!takes_factors(term.equation))
    term = {term.equation, BlendTerm().source, BlendTerm().destination};
}

Scene output_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  constexpr std::array kDepths{DepthFormat::depth24, DepthFormat::depth16, DepthFormat::depth32f};
  const Turn kind = turn_of(index, values_of<OutputKind>().size());
  // The depth buffer of a window depends on its configuration.
  const DepthFormat depth = kDepths[surface == Surface::window ? 0 : kind.index % kDepths.size()];
  Scene scene =
      random_output_scene({seed, static_cast<OutputKind>(kind.kind), surface, depth}, kind.index);
  for (Draw& draw : scene.draws) {
    if (!draw.operations.blending) continue;
    drop_unused_factors(draw.operations.blending->color);
    drop_unused_factors(draw.operations.blending->alpha);
  }
  return scene;
}

Scene clipping_scene(std::uint64_t seed, Surface surface, std::uint64_t index) {
  const Turn place = turn_of(index, values_of<ClipPlace>().size());
  return clip_scene(seed, surface, static_cast<ClipPlace>(place.kind), place.index);
}

bool matches(const std::string& pattern, const char* text) {
  return fnmatch(pattern.c_str(), text, 0) == 0;
}

std::string unknown_pattern(const std::string& pattern) {
  std::vector<std::string> names;
  std::set<std::string> rules;
  for (const Family& family : all_families()) {
    names.emplace_back(family.name);
    for (const RuleId rule : family.rules) rules.insert(name_of(rule));
  }
  std::vector<std::string> all = names;
  all.insert(all.end(), rules.begin(), rules.end());
  const std::string nearest = nearest_name(pattern, all);
  return fmt::format(
      "\"{}\" is neither a family of scenes nor the rule of one; {}families are {}; their rules "
      "are {}",
      pattern, nearest.empty() ? "" : fmt::format("did you mean {}? ", quote(nearest)),
      fmt::join(names, ", "), fmt::join(rules, ", "));
}

}  // namespace

std::span<const Family> all_families() {
  static const std::vector<Family> families{
      {"points",
       "points of sizes 1 to 64",
       {RuleId::point_ownership, RuleId::point_offset, RuleId::point_snap, RuleId::point_row_order},
       true,
       true,
       point_scene},
      {"lines",
       "lines, one in four wide",
       {RuleId::line_diamond_exit, RuleId::line_interior_gap, RuleId::line_algorithm,
        RuleId::line_width, RuleId::line_snap, RuleId::line_row_order},
       true,
       true,
       line_scene},
      {"grid-lines",
       "every line between multiples of 1/16 within 16x16 pixels, 32 in a scene",
       {RuleId::line_diamond_exit, RuleId::line_algorithm, RuleId::line_snap,
        RuleId::line_row_order},
       true,
       true,
       grid_line_scene,
       grid_line_scenes()},
      {"grid-lines-2-wide",
       "the lines of grid-lines, 2 pixels wide",
       {RuleId::line_width, RuleId::line_snap, RuleId::line_row_order},
       true,
       true,
       wide_grid_line_scene,
       grid_line_scenes()},
      {"joints",
       "segments that follow each other, as strips, loops and separate lines",
       {RuleId::line_joint, RuleId::line_diamond_exit, RuleId::line_width},
       true,
       true,
       random_joint_scene},
      {"grid-joints",
       "joints of lines between multiples of 1/16 within 16x16 pixels, 16 in a scene",
       {RuleId::line_joint},
       true,
       true,
       grid_joint_scene},
      {"shared-edges",
       "two triangles on opposite sides of one edge",
       {RuleId::triangle_shared_edge, RuleId::triangle_fill_rule},
       true,
       true,
       shared_edge_scene},
      {"seams",
       "edges of triangles that pass pixel centres at 1 to 3 units of grids of 4 to 16 bits",
       {RuleId::triangle_shared_edge, RuleId::triangle_fill_rule, RuleId::triangle_algorithm},
       true,
       true,
       seam_scene},
      {"triangles",
       "triangles, down to slivers",
       {RuleId::triangle_fill_rule, RuleId::triangle_algorithm, RuleId::triangle_snap,
        RuleId::triangle_row_order},
       true,
       true,
       triangle_scene},
      {"fans",
       "fans, strips and T-junctions",
       {RuleId::triangle_shared_edge, RuleId::triangle_fill_rule},
       true,
       true,
       random_fan_scene},
      {"snapping",
       "vertices on, between and beside the steps of sub-pixel grids",
       {RuleId::subpixel_snap, RuleId::point_snap, RuleId::line_snap, RuleId::triangle_snap},
       true,
       true,
       random_snap_scene},
      {"samples",
       "triangles and lines on targets of 2, 4 and 8 samples",
       {RuleId::sample_positions, RuleId::line_multisampled},
       false,
       false,
       sample_scene},
      {"grid-lines-of-4-samples",
       "the lines of grid-lines, on targets of 4 samples",
       {RuleId::line_multisampled},
       false,
       false,
       multisampled_grid_line_scene,
       multisampled_grid_line_scenes()},
      {"lod",
       "textures whose levels of detail lie at ties, at the crossover and on ramps",
       {RuleId::texture_nearest_level, RuleId::texture_crossover, RuleId::texture_scale_factor,
        RuleId::texture_log2, RuleId::texture_derivatives, RuleId::texture_anisotropy,
        RuleId::texture_lod_bias},
       false,
       true,
       level_scene},
      {"attributes",
       "flat, smooth and noperspective colours, of either provoking vertex, w not 1",
       {RuleId::attribute_flat, RuleId::attribute_provoking_vertex, RuleId::attribute_smooth,
        RuleId::attribute_perspective, RuleId::fragment_coordinates},
       false,
       true,
       attribute_scene},
      {"output",
       "depth-tested, blended, offset and stencilled triangles",
       {RuleId::depth_test, RuleId::depth_mask, RuleId::stencil_test, RuleId::blend_equation,
        RuleId::blend_rounding, RuleId::color_mask, RuleId::offset_slope, RuleId::offset_unit,
        RuleId::offset_exponent, RuleId::framebuffer_unorm8, RuleId::framebuffer_depth},
       false,
       true,
       output_scene},
      {"clipping",
       "triangles that leave the clip volume",
       {RuleId::clip_volume},
       false,
       true,
       clipping_scene},
  };
  return families;
}

const Family* find_family(const std::string& name) {
  const auto families = all_families();
  const auto found = std::ranges::find(families, name, &Family::name);
  return found == families.end() ? nullptr : &*found;
}

std::variant<std::vector<const Family*>, std::string> select_families(
    std::span<const std::string> patterns) {
  const auto means = [](const std::string& pattern, const Family& family) {
    return matches(pattern, family.name) || std::ranges::any_of(family.rules, [&](RuleId rule) {
             return matches(pattern, name_of(rule));
           });
  };
  for (const std::string& pattern : patterns)
    if (std::ranges::none_of(all_families(),
                             [&](const Family& family) { return means(pattern, family); }))
      return unknown_pattern(pattern);
  std::vector<const Family*> selected;
  for (const Family& family : all_families())
    if (patterns.empty() || std::ranges::any_of(patterns, [&](const std::string& pattern) {
          return means(pattern, family);
        }))
      selected.push_back(&family);
  return selected;
}

}  // namespace edgecase
