// SPDX-License-Identifier: MIT
#include "diff/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "diff/cause.h"
#include "diff/coverage_diff.h"
#include "diff/legality.h"
#include "diff/value_diff.h"
#include "exact/numeral.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "rules/coverage/diamond_exit.h"
#include "rules/coverage/point_ownership.h"
#include "rules/coverage/triangle_fill.h"

namespace edgecase {
namespace {

// What the comparison of one primitive needs, beside the primitive.
struct Context {
  const Scene& scene;
  const RuleChoices& choices;
  int bits;
};

// Lines of width 1 by the diamond-exit rule are explained by its numbers, others by the algorithm.
Explanation explain_line_choice(const ScenePrimitive& line, const Segment& segment, PixelPosition p,
                                const CoverageChoice& choice) {
  Explanation why = explain_line(segment, p.x, p.y, *choice.line.boundary);
  const bool thin = line.state->line_width == Fixed::from_integer(1);
  if (thin && choice.line.algorithm == LineAlgorithm::diamond_exit) return why;
  const Rule& rule = *find_rule(thin ? "line.algorithm" : "line.width");
  const char* name = thin ? name_of(choice.line.algorithm) : name_of(choice.line.wide);
  why.text =
      fmt::format("the segment {} to {} of width {} is drawn as {} says ({})",
                  format_point(segment.a), format_point(segment.b),
                  to_decimal(line.state->line_width), name, find_alternative(rule, name)->meaning);
  return why;
}

Explanation explain(const ScenePrimitive& primitive, PixelPosition p,
                    const CoverageChoice& choice) {
  const auto at = [&](std::size_t i) { return choice.snap(primitive.vertices[i]->position); };
  switch (primitive.kind) {
    case PrimitiveKind::point:
      return explain_point({at(0), primitive.state->point_size}, p.x, p.y, choice.ties);
    case PrimitiveKind::line:
      return explain_line_choice(primitive, {at(0), at(1)}, p, choice);
    case PrimitiveKind::triangle:
      return explain_triangle({at(0), at(1), at(2)}, p.x, p.y, choice.ties);
  }
  return {};
}

Disagreement coverage_disagreement(const ScenePrimitive& primitive,
                                   const CoverageDifference& difference, const Context& context) {
  Disagreement d;
  d.x = difference.pixel.x;
  d.y = difference.pixel.y;
  d.primitive = primitive.index;
  d.exact = {static_cast<double>(difference.exact)};
  d.rendered = {static_cast<double>(difference.drawn)};
  d.kind =
      difference.drawn < difference.exact ? DisagreementKind::missing : DisagreementKind::extra;
  d.rule = coverage_rule_of(primitive.kind);
  Explanation why = explain(primitive, difference.pixel, context.choices.of(primitive.kind));
  d.explanation =
      fmt::format("{} {}: {}; exact {} the pixel, the renderer {}.", name_of(primitive.kind),
                  primitive.index, why.text, difference.exact > 0 ? "draws" : "does not draw",
                  difference.drawn > 0 ? "draws it" : "does not");
  d.figure = std::move(why.figure);
  // Rulings on lines speak of whole segments: compare_primitive and judge() complete these.
  if (primitive.kind == PrimitiveKind::line) return d;
  const Legality legality = judge_sample(primitive, difference, context.bits);
  d.legal = legality.legal;
  d.ruling = legality.ruling;
  d.explanation += fmt::format(" Ruling {}: {}.", legality.ruling, legality.reason);
  return d;
}

Disagreement duplicate(const ScenePrimitive& primitive, const CoverageDifference& difference) {
  Disagreement d;
  d.x = difference.pixel.x;
  d.y = difference.pixel.y;
  d.primitive = primitive.index;
  d.kind = DisagreementKind::duplicate;
  d.rule = "fragment.once";
  d.ruling = 7;
  d.exact = {static_cast<double>(difference.exact)};
  d.rendered = {static_cast<double>(difference.drawn)};
  d.explanation = fmt::format(
      "primitive {} produces the fragment of pixel ({}, {}) {} times. Ruling 7: once at most.",
      primitive.index, d.x, d.y, difference.drawn);
  d.figure.marks = {sample_mark(pixel_centre(d.x, d.y))};
  return d;
}

// What the rulings on lines say of the segment, for all of its disagreements.
void judge_line(const ScenePrimitive& line, const PrimitiveCoverage& coverage, const Target& target,
                Result::Evidence& evidence, Result& result) {
  evidence.illegal_line_snaps = illegal_line_snaps(line, coverage.drawn, target);
  evidence.broken_clause = broken_clause_unsnapped(line, coverage.drawn, target);
  const int ruling = ruling_on_line(line, target);
  for (Disagreement& d : result.disagreements) {
    if (d.primitive != line.index || d.rule != "line.diamond-exit") continue;
    d.ruling = ruling;
    d.explanation += evidence.broken_clause.empty()
                         ? fmt::format(" Ruling {} holds for the segment as given.", ruling)
                         : fmt::format(" Ruling {}, for the segment as given: {}.", ruling,
                                       evidence.broken_clause);
  }
}

void compare_primitive(const ScenePrimitive& primitive, const PrimitiveCoverage& coverage,
                       const Context& context, Result& result) {
  const auto found = differences(coverage);
  const CoverageChoice& chosen = context.choices.of(primitive.kind);
  if (found.empty()) {
    mark_refuted(primitive, context.scene.target, chosen, coverage, result.refuted);
    return;
  }
  for (const CoverageDifference& difference : found) {
    if ((difference.drawn > 0) != (difference.exact > 0))
      result.disagreements.push_back(coverage_disagreement(primitive, difference, context));
    if (difference.drawn > 1) result.disagreements.push_back(duplicate(primitive, difference));
  }
  Result::Evidence evidence;
  evidence.primitive = primitive.index;
  evidence.causes = find_causes(primitive, context.scene.target, chosen, coverage);
  if (primitive.kind == PrimitiveKind::line)
    judge_line(primitive, coverage, context.scene.target, evidence, result);
  result.evidence.push_back(std::move(evidence));
}

// Snaps under which some line of the scene is not legal, whether it differs from exact or not, in
// catalogue order.
std::vector<std::string> all_illegal_line_snaps(std::span<const ScenePrimitive> primitives,
                                                std::span<const PrimitiveCoverage> coverage,
                                                const Target& target) {
  std::set<std::string> illegal;
  for (const ScenePrimitive& primitive : primitives) {
    if (primitive.kind != PrimitiveKind::line) continue;
    illegal.merge([&] {
      const auto names = illegal_line_snaps(
          primitive, coverage[static_cast<std::size_t>(primitive.index)].drawn, target);
      return std::set<std::string>(names.begin(), names.end());
    }());
  }
  std::vector<std::string> ordered;
  for (Snap snap : all_snaps())
    if (illegal.contains(name_of(snap))) ordered.push_back(name_of(snap));
  return ordered;
}

// A hole or a double hit on a shared edge turns the disagreements behind it into violations.
void apply_shared_edge_fault(const SharedEdgeFault& fault, Result& result) {
  for (Disagreement& d : result.disagreements) {
    const bool concerned = d.x == fault.pixel.x && d.y == fault.pixel.y &&
                           (d.primitive == fault.first || d.primitive == fault.second) &&
                           d.rule == "triangle.fill-rule";
    if (!concerned) continue;
    d.legal = false;
    d.rule = "triangle.shared-edge";
    d.ruling = 5;
    d.explanation += fmt::format(
        " Ruling 5: triangles {} and {} share the edge here and together hit this sample {} times "
        "instead of once.",
        fault.first, fault.second, fault.hits);
  }
}

bool reads_before(const Disagreement& a, const Disagreement& b) {
  return std::tie(a.y, a.x, a.primitive, a.kind, a.rule) <
         std::tie(b.y, b.x, b.primitive, b.kind, b.rule);
}

}  // namespace

Result compare(const Scene& scene, const Policy& policy, const Rendering& exact,
               const Rendering& rendered, int reported_subpixel_bits) {
  const RuleChoices choices = resolve(policy, scene.target.surface);
  const int bits = latitude_bits(reported_subpixel_bits);
  const std::vector<ScenePrimitive> primitives = primitives_of(scene);
  const auto coverage = match_coverage(primitives.size(), exact, rendered);

  Result result;
  result.pixels = rendered.pixels;
  result.refuted.assign(alternative_names().size(), '0');
  for (const ScenePrimitive& primitive : primitives)
    compare_primitive(primitive, coverage[static_cast<std::size_t>(primitive.index)],
                      {scene, choices, bits}, result);
  for (const SharedEdgeFault& fault : shared_edge_faults(primitives, coverage, scene.target, bits))
    apply_shared_edge_fault(fault, result);
  result.illegal_line_snaps = all_illegal_line_snaps(primitives, coverage, scene.target);
  const ValueContext values{scene, primitives, choices.values, bits};
  compare_fragment_values(values, rendered, result);
  compare_pixels(values, rendered, result);
  std::sort(result.disagreements.begin(), result.disagreements.end(), reads_before);
  return result;
}

Result not_run(Failure failure) {
  Result result;
  result.verdict = Verdict::not_run;
  result.failure = std::move(failure);
  return result;
}

Figure scene_figure(const Scene& scene) {
  Figure figure;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const auto count = static_cast<std::size_t>(vertices_of(primitive.kind));
    Mark outline{MarkRole::primitive, count == 3, {}, std::to_string(primitive.index)};
    for (std::size_t i = 0; i < count; ++i) {
      const Point position = primitive.vertices[i]->position;
      outline.points.push_back(position_of(position));
      figure.marks.push_back(
          {MarkRole::vertex, false, {position_of(position)}, format_point(position)});
    }
    figure.marks.push_back(std::move(outline));
  }
  return figure;
}

std::vector<PixelExplanation> explain_pixel(const Scene& scene, const Policy& policy, int x,
                                            int y) {
  const RuleChoices choices = resolve(policy, scene.target.surface);
  std::vector<PixelExplanation> result;
  for (const ScenePrimitive& primitive : primitives_of(scene)) {
    const CoverageChoice& choice = choices.of(primitive.kind);
    const auto pixels = covered_pixels(primitive, scene.target, choice);
    Explanation why = explain(primitive, {x, y}, choice);
    result.push_back({primitive.index,
                      std::find(pixels.begin(), pixels.end(), PixelPosition{x, y}) != pixels.end(),
                      coverage_rule_of(primitive.kind), std::move(why.text),
                      std::move(why.figure)});
  }
  return result;
}

}  // namespace edgecase
