// SPDX-License-Identifier: MIT
#include "diff/coverage_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "diff/cause.h"
#include "diff/explanation.h"
#include "diff/joint_faults.h"
#include "diff/legality.h"
#include "diff/situation.h"
#include "raster/rasterizer.h"

namespace edgecase {
namespace {

Disagreement at_pixel(const ScenePrimitive& primitive, const CoverageDifference& difference) {
  Disagreement d;
  d.x = difference.pixel.x;
  d.y = difference.pixel.y;
  d.primitive = primitive.index;
  d.exact = {static_cast<double>(difference.exact)};
  d.rendered = {static_cast<double>(difference.drawn)};
  d.kind =
      difference.drawn < difference.exact ? DisagreementKind::missing : DisagreementKind::extra;
  d.rule = coverage_rule_of(primitive.kind);
  d.situation = situation_of(primitive, difference.pixel);
  return d;
}

Disagreement duplicate(const ScenePrimitive& primitive, const CoverageDifference& difference) {
  Disagreement d = at_pixel(primitive, difference);
  d.kind = DisagreementKind::duplicate;
  d.rule = "fragment.once";
  d.ruling = 7;
  d.explanation = fmt::format(
      "primitive {} produces the fragment of pixel ({}, {}) {} times. Ruling 7: once at most.",
      primitive.index, d.x, d.y, difference.drawn);
  d.figure.marks = {sample_mark(pixel_centre(d.x, d.y))};
  return d;
}

// Adds names to others, the whole in catalogue order.
void merge_snaps(const std::vector<std::string>& more, std::vector<std::string>& names) {
  std::set<std::string> all(names.begin(), names.end());
  all.insert(more.begin(), more.end());
  names.clear();
  for (Snap snap : all_snaps())
    if (all.contains(name_of(snap))) names.push_back(name_of(snap));
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

class CoverageComparison {
 public:
  CoverageComparison(const CoverageContext& context, Result& result)
      : context_(context),
        standard_(resolve(Policy{}, context.scene.target.surface)),
        result_(result) {}

  void run() {
    for (const ScenePrimitive& primitive : context_.primitives) {
      compare_with_policy(primitive);
      if (context_.latitude == Latitude::opengl) compare_samples_with_specification(primitive);
    }
    for (const ScenePrimitive& primitive : context_.primitives)
      if (primitive.kind == PrimitiveKind::line) judge_line(primitive);
    judge_joints();
    judge_shared_edges();
  }

 private:
  const Scene& scene() const { return context_.scene; }
  const Target& target() const { return context_.scene.target; }
  const PrimitiveCoverage& coverage_of(const ScenePrimitive& primitive) const {
    return context_.coverage[static_cast<std::size_t>(primitive.index)];
  }
  const ScenePrimitive& primitive_at(int index) const {
    return context_.primitives[static_cast<std::size_t>(index)];
  }
  CauseQuestion question_about(const ScenePrimitive& primitive) const {
    return {primitive, target(), context_.choices.of(primitive.kind),
            context_.profile != nullptr ? &context_.profile->of(primitive.kind) : nullptr};
  }

  void compare_with_policy(const ScenePrimitive& primitive) {
    const PrimitiveCoverage& coverage = coverage_of(primitive);
    const auto found = differences(coverage);
    const CauseQuestion question = question_about(primitive);
    if (found.empty()) {
      if (context_.refute) mark_refuted(question, coverage, result_.refuted);
      return;
    }
    for (const CoverageDifference& difference : found) {
      if ((difference.drawn > 0) != (difference.exact > 0))
        result_.disagreements.push_back(disagreement(primitive, difference));
      if (difference.drawn > 1) result_.disagreements.push_back(duplicate(primitive, difference));
    }
    Result::Evidence evidence;
    evidence.primitive = primitive.index;
    evidence.causes = find_causes(question, coverage);
    result_.evidence.push_back(std::move(evidence));
  }

  Disagreement disagreement(const ScenePrimitive& primitive,
                            const CoverageDifference& difference) const {
    Disagreement d = at_pixel(primitive, difference);
    Explanation why = explain(primitive, difference.pixel, context_.choices.of(primitive.kind));
    d.explanation =
        fmt::format("{} {}: {}; exact {} the pixel, the renderer {}.", name_of(primitive.kind),
                    primitive.index, why.text, difference.exact > 0 ? "draws" : "does not draw",
                    difference.drawn > 0 ? "draws it" : "does not");
    d.figure = std::move(why.figure);
    // Rulings on lines speak of whole segments: judge_line and judge() complete these.
    if (primitive.kind == PrimitiveKind::line) return d;
    const Legality legality = judge_sample(primitive, difference, scene().viewport, context_.bits);
    d.legal = legality.legal;
    d.ruling = legality.ruling;
    d.explanation += fmt::format(" Ruling {}: {}.", legality.ruling, legality.reason);
    return d;
  }

  // What the specification's own choice and the renderer differ in where the policy sides with the
  // renderer.
  std::vector<CoverageDifference> excused_by_policy(const ScenePrimitive& primitive) const {
    const PrimitiveCoverage& coverage = coverage_of(primitive);
    const auto own = covered_pixels(primitive, target(), standard_.of(primitive.kind));
    if (own == coverage.exact) return {};
    auto found = differences({own, coverage.drawn});
    std::erase_if(found, [&](const CoverageDifference& difference) {
      return std::any_of(result_.disagreements.begin(), result_.disagreements.end(),
                         [&](const Disagreement& d) {
                           return d.primitive == primitive.index && d.x == difference.pixel.x &&
                                  d.y == difference.pixel.y;
                         });
    });
    return found;
  }

  void add_excused(const ScenePrimitive& primitive, const CoverageDifference& difference,
                   const Legality& why) {
    Disagreement d = at_pixel(primitive, difference);
    d.policy_agrees = true;
    d.rule = why.rule;
    d.ruling = why.ruling;
    Explanation explanation = explain(primitive, difference.pixel, standard_.of(primitive.kind));
    d.explanation = fmt::format(
        "{} {}: {}. The policy has it as the renderer does. Ruling {} does not allow it: {}.",
        name_of(primitive.kind), primitive.index, explanation.text, why.ruling, why.reason);
    d.figure = std::move(explanation.figure);
    d.cause = cause_of_excused(primitive);
    result_.disagreements.push_back(std::move(d));
  }

  // Which of the policy's alternatives draw the primitive so.
  const std::string& cause_of_excused(const ScenePrimitive& primitive) {
    const auto [place, is_new] = excused_causes_.try_emplace(primitive.index);
    if (is_new) {
      const auto causes = find_causes(
          {primitive, target(), standard_.of(primitive.kind), &context_.choices.of(primitive.kind)},
          coverage_of(primitive));
      if (!causes.empty()) place->second = causes.front();
    }
    return place->second;
  }

  void compare_samples_with_specification(const ScenePrimitive& primitive) {
    if (primitive.kind == PrimitiveKind::line) return;
    for (const CoverageDifference& difference : excused_by_policy(primitive)) {
      const Legality legality =
          judge_sample(primitive, difference, scene().viewport, context_.bits);
      if (!legality.legal) add_excused(primitive, difference, legality);
    }
  }

  Result::Evidence* evidence_of(const ScenePrimitive& primitive) {
    for (Result::Evidence& evidence : result_.evidence)
      if (evidence.primitive == primitive.index) return &evidence;
    return nullptr;
  }

  // A broken ruling on lines. A line that differs from the policy has it as evidence, since judge()
  // decides how lines are read; one that agrees is read as the policy says.
  void break_line(const ScenePrimitive& line, const std::vector<std::string>& illegal_snaps,
                  const std::string& clause, const char* rule, int ruling) {
    if (Result::Evidence* evidence = evidence_of(line)) {
      merge_snaps(illegal_snaps, evidence->illegal_line_snaps);
      if (clause.empty() || !evidence->broken_clause.empty()) return;
      evidence->broken_clause = clause;
      say_of_line(line, rule, ruling,
                  fmt::format("Ruling {}, for the segment as given: {}.", ruling, clause));
      return;
    }
    const bool excused = context_.latitude == Latitude::opengl &&
                         contains(illegal_snaps, name_of(context_.choices.lines.snap));
    if (!excused) return;
    const std::string reason = clause.empty() ? "not as the policy moves the segment" : clause;
    for (const CoverageDifference& difference : excused_by_policy(line))
      add_excused(line, difference, {false, ruling, rule, reason});
  }

  void say_of_line(const ScenePrimitive& line, const char* rule, int ruling,
                   const std::string& sentence) {
    for (Disagreement& d : result_.disagreements) {
      if (d.primitive != line.index || !is_about_a_line(d) || d.policy_agrees) continue;
      d.rule = rule;
      d.ruling = ruling;
      d.explanation += " " + sentence;
    }
  }

  void judge_line(const ScenePrimitive& line) {
    const PrimitiveCoverage& coverage = coverage_of(line);
    const auto illegal = illegal_line_snaps(line, coverage.drawn, scene());
    merge_snaps(illegal, result_.illegal_line_snaps);
    const int ruling = ruling_on_line(line, scene());
    const std::string clause = broken_clause_unsnapped(line, coverage.drawn, scene());
    if (!illegal.empty()) break_line(line, illegal, clause, "line.diamond-exit", ruling);
    if (clause.empty())
      say_of_line(line, "line.diamond-exit", ruling,
                  fmt::format("Ruling {} holds for the segment as given.", ruling));
  }

  void judge_joints() {
    for (const JointFault& fault : joint_faults(context_.primitives, context_.coverage, scene())) {
      merge_snaps(fault.illegal_snaps, result_.illegal_line_snaps);
      for (int index : {fault.first, fault.second})
        break_line(primitive_at(index), fault.illegal_snaps, fault.clause, "line.joint", 14);
    }
  }

  // A hole or a double hit on a shared edge turns the disagreements behind it into violations.
  void judge_shared_edges() {
    for (const SharedEdgeFault& fault :
         shared_edge_faults(context_.primitives, context_.coverage, scene(), context_.bits)) {
      const std::string reason = fmt::format(
          "triangles {} and {} share the edge here and together hit this sample {} times instead "
          "of once",
          fault.first, fault.second, fault.hits);
      if (blame(fault, reason) || context_.latitude != Latitude::opengl) continue;
      const Legality broken{false, 5, "triangle.shared-edge", reason};
      for (int index : {fault.first, fault.second})
        for (const CoverageDifference& difference : excused_by_policy(primitive_at(index)))
          if (difference.pixel == fault.pixel) add_excused(primitive_at(index), difference, broken);
    }
  }

  // Turns the disagreements of both triangles at the pixel; false where there is none.
  bool blame(const SharedEdgeFault& fault, const std::string& reason) {
    bool found = false;
    for (Disagreement& d : result_.disagreements) {
      const bool concerned = d.x == fault.pixel.x && d.y == fault.pixel.y &&
                             (d.primitive == fault.first || d.primitive == fault.second);
      if (!concerned || (d.rule != "triangle.fill-rule" && d.rule != "triangle.shared-edge"))
        continue;
      found = true;
      d.legal = false;
      d.rule = "triangle.shared-edge";
      d.ruling = 5;
      d.explanation += fmt::format(" Ruling 5: {}.", reason);
    }
    return found;
  }

  const CoverageContext& context_;
  const RuleChoices standard_;
  std::map<int, std::string> excused_causes_;  // by primitive
  Result& result_;
};

}  // namespace

void compare_coverage(const CoverageContext& context, Result& result) {
  CoverageComparison(context, result).run();
}

}  // namespace edgecase
