// SPDX-License-Identifier: MIT
#include "rules/chapters.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "rules/all_rules.h"

namespace edgecase {

std::span<const Chapter> chapters() {
  static const std::vector<Chapter> all = {
      {"window",
       "The window",
       "These rules hold for every primitive.",
       {{"The window's origin", "coverage/window", {RuleId::window_origin}},
        {"The order of rows",
         "coverage/window",
         {RuleId::point_row_order, RuleId::line_row_order, RuleId::triangle_row_order}},
        {"The sub-pixel grid",
         "coverage/window",
         {RuleId::subpixel_snap, RuleId::point_snap, RuleId::line_snap, RuleId::triangle_snap}},
        {"One fragment a pixel", "coverage/window", {RuleId::fragment_once}},
        {"A scene and its image", "coverage/window", {RuleId::fragment_invariant}},
        {"The clip volume", "coverage/clip_volume", {RuleId::clip_volume, RuleId::line_clip}}}},
      {"points",
       "Points",
       "A point is a square; a rule says who owns its border.",
       {{"The square around a vertex",
         "coverage/point_ownership",
         {RuleId::point_ownership, RuleId::point_offset, RuleId::point_clip}}}},
      {"lines",
       "Lines",
       "A line of width 1 has no area; diamonds say which pixels it draws.",
       {{"The diamond-exit rule",
         "coverage/diamond_exit",
         {RuleId::line_diamond_exit, RuleId::line_interior_gap}},
        {"Other algorithms, and wide lines",
         "coverage/line_algorithm",
         {RuleId::line_algorithm, RuleId::line_width}},
        {"Joints of lines", "coverage/line_joints", {RuleId::line_joint}}}},
      {"triangles",
       "Triangles",
       "A triangle draws the samples inside it; samples on an edge need a convention.",
       {{"The fill rule", "coverage/triangle_fill", {RuleId::triangle_fill_rule}},
        {"Shared edges", "coverage/triangle_fill", {RuleId::triangle_shared_edge}},
        {"Algorithms for triangles", "coverage/triangle_algorithm", {RuleId::triangle_algorithm}},
        {"Front and back", "coverage/triangle_fill", {RuleId::polygon_facing}}}},
      {"values",
       "Values",
       "What fragments carry: colours, depths, coordinates and their derivatives.",
       {{"Flat attributes",
         "values/attributes",
         {RuleId::attribute_flat, RuleId::attribute_provoking_vertex}},
        {"Interpolation",
         "values/attributes",
         {RuleId::attribute_smooth, RuleId::attribute_perspective, RuleId::attribute_positions,
          RuleId::fragment_depth, RuleId::fragment_coordinates}},
        {"Derivatives",
         "values/derivative",
         {RuleId::derivative_plain, RuleId::derivative_fine, RuleId::derivative_coarse,
          RuleId::derivative_quad_rows}}}},
      {"samples",
       "Several samples",
       "A pixel of several samples is covered sample by sample.",
       {{"Sample locations", "samples/sample_placement", {RuleId::sample_positions}},
        {"GL_MULTISAMPLE and the sample mask",
         "samples/sample_mask",
         {RuleId::sample_enable, RuleId::sample_mask}},
        {"Lines as rectangles", "samples/multisampled_line", {RuleId::line_multisampled}},
        {"Where attributes are evaluated",
         "samples/attribute_location",
         {RuleId::attribute_location, RuleId::attribute_centroid, RuleId::sample_depth}},
        {"How often the shader runs", "samples/attribute_location", {RuleId::sample_shading_rate}},
        {"Alpha as coverage", "samples/sample_mask", {RuleId::sample_alpha_to_coverage}},
        {"Resolving samples", "samples/resolve", {RuleId::sample_resolve}},
        {"Supersampling", "samples/resolve", {RuleId::supersample_accumulation}}}},
      {"textures",
       "Textures",
       "From the footprint of a pixel to a level, from a level to texels, from texels to a colour.",
       {{"Level of detail",
         "textures/level_of_detail",
         {RuleId::texture_scale_factor, RuleId::texture_derivatives, RuleId::texture_lod_bias}},
        {"The logarithm", "textures/level_of_detail", {RuleId::texture_log2}},
        {"Filters and levels",
         "textures/level_selection",
         {RuleId::texture_crossover, RuleId::texture_nearest_level, RuleId::texture_level_weight,
          RuleId::texture_level_limits}},
        {"Texels of a level",
         "textures/texel_filter",
         {RuleId::texture_filter, RuleId::texture_texel_grid}},
        {"Beyond the image", "textures/texture_image", {RuleId::texture_wrap}},
        {"Anisotropy", "textures/level_selection", {RuleId::texture_anisotropy}},
        {"Mip chains",
         "textures/mip_chain",
         {RuleId::mipmap_level_count, RuleId::mipmap_filter, RuleId::mipmap_rounding,
          RuleId::mipmap_srgb}}}},
      {"output",
       "Fragment operations",
       "Tests, blending, and what the framebuffer keeps.",
       {{"Polygon offset",
         "output/polygon_offset",
         {RuleId::offset_slope, RuleId::offset_unit, RuleId::offset_exponent}},
        {"The stencil test", "output/fragment_tests", {RuleId::stencil_test}},
        {"The depth test", "output/fragment_tests", {RuleId::depth_test, RuleId::depth_mask}},
        {"Blending",
         "output/blending",
         {RuleId::blend_equation, RuleId::blend_rounding, RuleId::color_mask}},
        {"Pixels", "values/framebuffer", {RuleId::framebuffer_unorm8, RuleId::framebuffer_order}},
        {"The depth buffer",
         "values/framebuffer",
         {RuleId::framebuffer_depth, RuleId::framebuffer_depth_bits}}}},
  };
  return all;
}

// ------------------------------------------------------------------------------- rulings and rules

namespace {

constexpr std::string_view kHead =
    R"(<!-- SPDX-License-Identifier: MIT -->
<!-- Generated. To renew: build/release/bin/edgecase rules --markdown > src/rules/RULINGS.md -->

# Rules and rulings

How Edgecase reads OpenGL 4.6, core profile. A **rule** is one statement of the specification; a
**ruling** says how we read it where it is silent or loose, and verdicts cite its number. This page is
printed by `edgecase rules --markdown` from the very entries that the program judges by.

The **basis** of a ruling is *normative* where a sentence of the text says so and nothing speaks against
it: what breaks it is a violation. It is *contested* where the letter forbids what the text elsewhere, an
open issue of the specification or the Khronos conformance tests accept: what breaks it is contested. A
ruling that fell is *withdrawn*; its number is not used again.

Window coordinates have y up. An alternative is *open* where the specification leaves the choice to
the implementation, *mandated* where it is the only one that conforms, and *illegal* where it is
known from faulty implementations. The one in bold is the choice of policy `opengl`.
)";

// Escapes characters that have a meaning in Markdown.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("*<|`\\").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

std::string sentence(std::string_view text) {
  return escaped(text) + (text.ends_with('.') ? "" : ".");
}

// GitHub's anchor of a heading that is a rule's id: dots are dropped.
std::string link_to(const Rule& rule) {
  std::string anchor = name_of(rule.id);
  std::erase(anchor, '.');
  return fmt::format("[`{}`](#{})", name_of(rule.id), anchor);
}

// By number, which is unique.
std::map<int, std::pair<const Ruling*, const Rule*>> numbered_rulings() {
  std::map<int, std::pair<const Ruling*, const Rule*>> rulings;
  for (const Rule& rule : all_rules())
    for (const Ruling& ruling : rule.rulings) rulings[ruling.number] = {&ruling, &rule};
  return rulings;
}

std::string rulings_section() {
  std::string text = "\n## Rulings\n";
  for (const auto& [number, entry] : numbered_rulings()) {
    text += fmt::format("\n### Ruling {}\n\nRule {}.\n\n{}\n", number, link_to(*entry.second),
                        sentence(entry.first->text));
    const char* separator = "\n";
    for (const RulingFact& fact : facts_of(*entry.first)) {
      text += fmt::format("{}- **{}.** {}\n", separator, fact.name, sentence(fact.text));
      separator = "";
    }
  }
  return text;
}

bool same_alternatives(const Rule& a, const Rule& b) {
  return a.standard == b.standard &&
         std::ranges::equal(
             a.alternatives, b.alternatives, [](const Alternative& x, const Alternative& y) {
               return x.name == y.name && x.openness == y.openness && x.meaning == y.meaning;
             });
}

// The first rule of the catalogue with the same alternatives, possibly the rule itself.
const Rule& first_with_alternatives_of(const Rule& rule) {
  for (const Rule& earlier : all_rules())
    if (same_alternatives(earlier, rule)) return earlier;
  return rule;
}

std::string alternatives_of(const Rule& rule) {
  if (rule.alternatives.empty()) return "";
  const Rule& first = first_with_alternatives_of(rule);
  if (&first != &rule)
    return fmt::format("\nAlternatives: those of {}, with the same one chosen.\n", link_to(first));
  std::string text = "\n| alternative | | meaning |\n|---|---|---|\n";
  for (const Alternative& alternative : rule.alternatives) {
    const bool standard = alternative.name == rule.standard;
    text += fmt::format("| {0}`{1}`{0} | {2} | {3} |\n", standard ? "**" : "", alternative.name,
                        name_of(alternative.openness), escaped(alternative.meaning));
  }
  return text;
}

std::string cited_rulings(const Rule& rule) {
  std::string text;
  for (const Ruling& ruling : rule.rulings)
    text += fmt::format("{}[ruling {}](#ruling-{})", text.empty() ? " Judged by " : ", ",
                        ruling.number, ruling.number);
  return text.empty() ? "" : text + ".";
}

std::string rule_section(const Rule& rule) {
  return fmt::format("\n### {}\n\n{} Section {}.{}\n\nLatitude: {}\n{}", name_of(rule.id),
                     sentence(rule.title), escaped(rule.spec), cited_rulings(rule),
                     sentence(rule.latitude), alternatives_of(rule));
}

}  // namespace

std::string rules_document() {
  std::string text(kHead);
  text += rulings_section();
  text += "\n## Rules\n";
  for (const Rule& rule : all_rules()) text += rule_section(rule);
  return text;
}

}  // namespace edgecase
