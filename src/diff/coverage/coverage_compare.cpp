// SPDX-License-Identifier: MIT
#include "diff/coverage/coverage_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "diff/coverage/cause.h"
#include "diff/coverage/common_causes.h"
#include "diff/coverage/joint_faults.h"
#include "diff/coverage/legality.h"
#include "diff/coverage/refutation.h"
#include "diff/coverage/sample_legality.h"
#include "diff/coverage/sample_place.h"
#include "diff/coverage/shared_edge_blame.h"
#include "diff/coverage/shared_edge_faults.h"
#include "diff/coverage/size_latitude.h"
#include "diff/findings/add_disagreement.h"
#include "diff/findings/patience.h"
#include "raster/attributes.h"
#include "raster/rasterizer.h"
#include "raster/samples.h"
#include "rules/all_rules.h"
#include "rules/coverage/clip_volume.h"

namespace edgecase {
namespace {

class CoverageComparison {
 public:
  CoverageComparison(const CoverageContext& context, Result& result)
      : context_(context),
        standard_(standard_choices()),
        lawful_(positions_of(context.scene.target, standard_.triangles, context.reported)),
        chosen_(positions_of(context.scene.target, context.choices.triangles, context.reported)),
        places_(context),
        result_(result) {}

  void run() {
    for (const ScenePrimitive& primitive : context_.primitives) {
      compare_with_policy(primitive);
      if (context_.latitude == Latitude::opengl) compare_samples_with_specification(primitive);
    }
    for (const ScenePrimitive& primitive : context_.primitives)
      if (is_line(primitive)) judge_line(primitive);
    judge_joints();
    keep_common_causes(judge_shared_edges());
    note_places(context_, places_, result_);
  }

 private:
  // For each primitive, the others with which it breaks ruling 5.
  using Partners = std::map<int, std::set<int>>;

  // True if exact draws triangles by the specification's own rule, which leaves no hole.
  bool exact_fills_by_rule() const { return context_.choices.triangles == standard_.triangles; }
  const Scene& scene() const { return context_.scene; }
  const Target& target() const { return context_.scene.target; }
  const PrimitiveCoverage& coverage_of(const ScenePrimitive& primitive) const {
    return context_.coverage[static_cast<std::size_t>(primitive.index)];
  }
  const ScenePrimitive& primitive_at(int index) const {
    return context_.primitives[static_cast<std::size_t>(index)];
  }
  CauseQuestion question_about(const ScenePrimitive& primitive) const {
    return {primitive,        target(),          context_.choices,
            context_.profile, context_.reported, context_.likely_first};
  }
  bool is_multisampled(const ScenePrimitive& primitive) const {
    return edgecase::is_multisampled(*primitive.state, target());
  }
  // True for lines whose coverage the diamond-exit rule decides for the whole segment. A line
  // wholly outside the clip volume is none.
  bool is_line(const ScenePrimitive& primitive) const {
    return primitive.kind == PrimitiveKind::line && !primitive.is_clipped &&
           !is_multisampled(primitive);
  }
  Point within(const ScenePrimitive& primitive, const CoverageDifference& difference) const {
    return within(primitive, difference, lawful_);
  }
  Point within(const ScenePrimitive& primitive, const CoverageDifference& difference,
               const SamplePositions& positions) const {
    return is_multisampled(primitive) ? positions[static_cast<std::size_t>(difference.sample)]
                                      : centre_of_pixel();
  }
  Point place_of(const ScenePrimitive& primitive, const CoverageDifference& difference) const {
    return place_in(difference.pixel, within(primitive, difference));
  }
  // Adds a disagreement of the class; `explain` completes what is not only counted.
  template <class Explain>
  void add(const ScenePrimitive& primitive, const CoverageDifference& difference,
           const DisagreementClass& of, const Explain& explain) {
    Disagreement* const d = add_disagreement(result_, difference.pixel, of);
    if (d == nullptr) return;
    describe_sample(primitive, difference, place_of(primitive, difference), target(), *d);
    explain(*d);
  }

  void compare_with_policy(const ScenePrimitive& primitive) {
    const PrimitiveCoverage& coverage = coverage_of(primitive);
    CauseQuestion question = question_about(primitive);
    const std::size_t found = add_differences(primitive);
    if (found == 0 && context_.refute) mark_refuted(question, coverage, result_.refuted);
    if (found == 0) return;
    question.is_gross = found > kMostInFull;
    Result::Evidence evidence;
    evidence.primitive = primitive.index;
    evidence.causes = find_causes(question, coverage);
    if (evidence.causes.empty() && lacks_invocations_by_others(primitive))
      evidence.causes = {alternative_id(RuleId::sample_alpha_to_coverage,
                                        name_of(AlphaToCoverage::above_quotient_of_others))};
    note_swapped(primitive, evidence.causes);
    result_.evidence.push_back(std::move(evidence));
  }

  // Adds what differs from the policy. Returns how many samples do.
  std::size_t add_differences(const ScenePrimitive& primitive) {
    std::optional<SampleJudge> judge;  // most primitives need none
    std::size_t found = 0;
    Patience::check();
    for_each_difference(coverage_of(primitive), [&](const CoverageDifference& difference) {
      if (found++ == 0) judge.emplace(primitive, terms_of(primitive));
      if ((difference.drawn > 0) != (difference.exact > 0)) add(primitive, difference, *judge);
      if (difference.drawn > 1)
        add(primitive, difference, class_of_duplicate(primitive, difference), [&](Disagreement& d) {
          explain_duplicate(difference, place_of(primitive, difference), target(), d);
        });
    });
    return found;
  }

  // Names the exchanged samples, since all pairs share one name.
  void note_swapped(const ScenePrimitive& primitive, const std::vector<Cause>& causes) {
    const AlternativeId swapped =
        alternative_id(RuleId::sample_positions, name_of(SamplePlacement::Kind::swapped));
    if (std::ranges::find(causes, Cause(swapped)) == causes.end()) return;
    const std::string pairs = swapped_pairs(question_about(primitive), coverage_of(primitive));
    for (Disagreement& d : result_.disagreements)
      if (d.primitive == primitive.index && d.kind != DisagreementKind::value && !d.policy_agrees)
        d.explanation += fmt::format(" With samples {} exchanged, exact draws the same.", pairs);
  }

  // True if every difference from exact arises because alpha to coverage keeps invocations from
  // running by the alphas of other samples.
  bool lacks_invocations_by_others(const ScenePrimitive& primitive) const {
    const SampleChoice choice{context_.choices.samples.rate,
                              AlphaToCoverage::above_quotient_of_others};
    if (!is_multisampled(primitive) ||
        !heeds_others(primitive.state->multisampling, target().samples, choice))
      return false;
    const PrimitiveAttributes attributes = attributes_of(primitive, context_.choices, target());
    SampleCoverage left = coverage_of(primitive).exact;
    for (std::size_t s = 0; s < left.size(); ++s)
      std::erase_if(left[s], [&](PixelPosition pixel) {
        const std::uint32_t runs = runs_by_others(alphas_of_samples(
            primitive, attributes, pixel, chosen_, context_.choices.values.locations));
        return (runs >> s & 1) == 0;
      });
    return left == coverage_of(primitive).drawn;
  }

  void add(const ScenePrimitive& primitive, const CoverageDifference& difference,
           SampleJudge& judge) {
    DisagreementClass of = class_of(primitive, difference, target());
    // Rulings on lines are about whole segments: judge_line and judge() complete these.
    const bool is_of_line = is_line(primitive) && difference.sample == 0;
    const Point at = within(primitive, difference);
    if (!is_of_line) {
      const CoverageLegality legality = judge.decide(difference, at);
      of.legality = by_letter(legality.legal);
      of.rule = legality.rule;
      of.ruling = legality.ruling;
    }
    add(primitive, difference, of, [&](Disagreement& d) {
      explain_difference(primitive, difference,
                         place_in(difference.pixel, within(primitive, difference, chosen_)),
                         target(), context_.choices.of(primitive.kind), d);
      if (is_of_line) return;
      const CoverageLegality legality = judge.explain(difference, at);
      d.explanation += fmt::format(" Ruling {}: {}.", legality.ruling, legality.reason);
    });
  }

  SampleTerms terms_of(const ScenePrimitive& primitive) {
    const SupportedSizes sizes = sizes_that_excuse(primitive, coverage_of(primitive), context_);
    return {context_.bits,
            sizes,
            is_multisampled(primitive),
            is_missing(primitive),
            shape_fault(primitive, coverage_of(primitive), target()),
            have_one_place(context_) ? &places_ : nullptr};
  }

  // True if nothing of the primitive was drawn.
  bool is_missing(const ScenePrimitive& primitive) const {
    return std::ranges::all_of(coverage_of(primitive).drawn,
                               [](const auto& pixels) { return pixels.empty(); });
  }

  // Differences between the specification's own choice and the renderer.
  const std::vector<CoverageDifference>& differences_from_standard(
      const ScenePrimitive& primitive) {
    const auto [known, is_new] = from_standard_.try_emplace(primitive.index);
    if (!is_new) return known->second;
    const CoverageChoice& standard = standard_.of(primitive.kind);
    const PrimitiveCoverage& coverage = coverage_of(primitive);
    if (is_multisampled(primitive) || standard != context_.choices.of(primitive.kind))
      if (const auto own = covered_samples(primitive, target(), standard, context_.reported);
          own != coverage.exact)
        known->second = differences({own, coverage.drawn});
    return known->second;
  }

  // Those of them where the policy agrees with the renderer, and that are not reported yet.
  std::vector<CoverageDifference> excused_by_policy(const ScenePrimitive& primitive) {
    std::vector<CoverageDifference> found = differences_from_standard(primitive);
    if (found.empty()) return found;
    std::set<SamplePlace> reported = excused_[primitive.index];
    for_each_difference(coverage_of(primitive), [&](const CoverageDifference& difference) {
      reported.insert(sample_place(difference));
    });
    std::erase_if(found, [&](const CoverageDifference& difference) {
      return reported.contains(sample_place(difference));
    });
    return found;
  }

  void add_excused(const ScenePrimitive& primitive, const CoverageDifference& difference,
                   const CoverageLegality& why) {
    DisagreementClass of = class_of(primitive, difference, target());
    of.policy_agrees = true;
    of.rule = why.rule;
    of.ruling = why.ruling;
    of.cause = cause_of_excused(primitive);
    excused_[primitive.index].insert(sample_place(difference));
    add(primitive, difference, of, [&](Disagreement& d) {
      Explanation explanation = explain(primitive, place_of(primitive, difference), target(),
                                        standard_.of(primitive.kind));
      d.explanation = fmt::format(
          "{} {}: {}. The policy has it as the renderer does. Ruling {} does not allow it: {}.",
          name_of(primitive.kind), primitive.index, explanation.text, why.ruling, why.reason);
      d.figure = std::move(explanation.figure);
    });
  }

  // The policy's alternatives that draw the primitive so; if primitives elsewhere are drawn
  // differently, any alternatives that draw it so.
  const Cause& cause_of_excused(const ScenePrimitive& primitive) {
    const auto [place, is_new] = excused_causes_.try_emplace(primitive.index);
    if (!is_new) return place->second;
    const CauseQuestion question{primitive,         target(),          standard_,
                                 &context_.choices, context_.reported, context_.likely_first};
    place->second = cause_in_profile(question, coverage_of(primitive));
    if (!place->second.empty()) return place->second;
    const auto causes = find_causes(question, coverage_of(primitive));
    if (!causes.empty()) place->second = causes.front();
    return place->second;
  }

  void compare_samples_with_specification(const ScenePrimitive& primitive) {
    if (is_line(primitive)) return;
    const std::vector<CoverageDifference> excused = excused_by_policy(primitive);
    if (excused.empty()) return;
    SampleJudge judge(primitive, terms_of(primitive));
    for (const CoverageDifference& difference : excused)
      if (const Point at = within(primitive, difference); !judge.decide(difference, at).legal)
        add_excused(primitive, difference, judge.explain(difference, at));
  }

  Result::Evidence* evidence_of(const ScenePrimitive& primitive) {
    for (Result::Evidence& evidence : result_.evidence)
      if (evidence.primitive == primitive.index) return &evidence;
    return nullptr;
  }

  // Reports a broken ruling on lines. A line that differs from the policy has it as evidence, since
  // judge() decides how lines are read; one that agrees is read as the policy says.
  void break_line(const ScenePrimitive& line, const std::vector<std::string>& illegal_snaps,
                  const std::string& clause, RuleId rule, int ruling) {
    if (Result::Evidence* evidence = evidence_of(line)) {
      merge_snaps(illegal_snaps, evidence->illegal_line_snaps);
      if (clause.empty() || !evidence->broken_clause.empty()) return;
      evidence->broken_clause = clause;
      say_of_line(line, rule, ruling,
                  fmt::format("Ruling {}, for the segment as given: {}.", ruling, clause));
      return;
    }
    const bool excused =
        context_.latitude == Latitude::opengl &&
        std::ranges::count(illegal_snaps, name_of(context_.choices.lines.snap)) > 0;
    if (!excused) return;
    const std::string reason = clause.empty() ? "not as the policy moves the segment" : clause;
    for (const CoverageDifference& difference : excused_by_policy(line))
      add_excused(line, difference, {false, ruling, rule, reason});
  }

  void say_of_line(const ScenePrimitive& line, RuleId rule, int ruling,
                   const std::string& sentence) {
    const auto is_of_line = [&](const DisagreementClass& d) {
      return d.primitive == line.index && is_about_a_line(d) && !d.policy_agrees;
    };
    for (Disagreement& d : result_.disagreements)
      if (is_of_line(d)) d.explanation += " " + sentence;
    for_each_class(result_, [&](DisagreementClass& d) {
      if (is_of_line(d)) std::tie(d.rule, d.ruling) = std::pair(rule, ruling);
    });
  }

  void judge_line(const ScenePrimitive& line) {
    const PrimitiveCoverage& coverage = coverage_of(line);
    const auto& drawn = coverage.drawn.front();
    const auto illegal = illegal_line_snaps(line, drawn, scene());
    if (illegal.empty() && evidence_of(line) == nullptr) return;
    const bool is_cut = !illegal.empty() && is_cut_at_sides(line, drawn, scene());
    // What a cut leaves out tells nothing of how vertices are snapped.
    if (!is_cut) merge_snaps(illegal, result_.illegal_line_snaps);
    const int contested = illegal.empty() ? 0 : contested_ruling_on_line(line, drawn, scene());
    const int ruling = contested != 0 ? contested
                       : is_cut       ? kRulingOnSides
                                      : ruling_on_line(line, scene());
    const std::string clause = broken_clause_unsnapped(line, drawn, scene());
    if (!illegal.empty()) break_line(line, illegal, clause, RuleId::line_diamond_exit, ruling);
    if (!clause.empty()) return;
    const int kept = ruling_on_line(line, scene());
    say_of_line(line, RuleId::line_diamond_exit, kept,
                fmt::format("Ruling {} holds for the segment as given.", kept));
  }

  void judge_joints() {
    for (const JointFault& fault : joint_faults(context_.primitives, context_.coverage, scene())) {
      merge_snaps(fault.illegal_snaps, result_.illegal_line_snaps);
      for (int index : {fault.first, fault.second})
        break_line(primitive_at(index), fault.illegal_snaps, fault.clause, RuleId::line_joint,
                   rule_of(RuleId::line_joint).ruling);
    }
  }

  // True if what was drawn of a point, a triangle or a multisampled line breaks a ruling. The run
  // decides this for other lines.
  bool breaks_a_ruling(const ScenePrimitive& primitive) const {
    return !is_line(primitive) && any_class(result_, [&](const DisagreementClass& d) {
      return d.primitive == primitive.index && d.kind != DisagreementKind::value && !is_legal(d) &&
             !d.policy_agrees;
    });
  }

  // The other primitives of the same draw, and primitives of other draws with which this one breaks
  // ruling 5.
  std::vector<DrawnPrimitive> others_of(const ScenePrimitive& primitive,
                                        const Partners& partners) const {
    std::vector<DrawnPrimitive> others;
    const auto own = partners.find(primitive.index);
    for (const ScenePrimitive& other : context_.primitives) {
      const bool is_partner = own != partners.end() && own->second.contains(other.index);
      if (other.index != primitive.index && (other.draw == primitive.draw || is_partner))
        others.push_back({&other, &coverage_of(other)});
    }
    return others;
  }

  void keep_common_causes(const Partners& partners) {
    for (Result::Evidence& evidence : result_.evidence) {
      const ScenePrimitive& primitive = primitive_at(evidence.primitive);
      if (evidence.causes.empty() || !breaks_a_ruling(primitive)) continue;
      evidence.causes = common_causes(question_about(primitive), coverage_of(primitive),
                                      evidence.causes, others_of(primitive, partners));
    }
  }

  // A hole or a double hit on a shared edge turns the disagreements behind it into violations.
  Partners judge_shared_edges() {
    Partners partners;
    if (exact_fills_by_rule() && result_.evidence.empty()) return partners;
    SharedEdgeBlame blame(result_);
    for (SharedEdgeFault& fault :
         shared_edge_faults(context_.primitives, context_.coverage, scene(), context_.bits, lawful_,
                            exact_fills_by_rule())) {
      if (!fault.is_certain && have_one_place(context_) && !places_.of(fault.sample))
        fault.is_certain = true;
      partners[fault.first].insert(fault.second);
      partners[fault.second].insert(fault.first);
      const std::string reason = fmt::format(
          "triangles {} and {} share the edge here and together hit this sample {} times instead "
          "of once",
          fault.first, fault.second, fault.hits);
      if (blame.add(fault, reason) || context_.latitude != Latitude::opengl) continue;
      const CoverageLegality broken{false, ruling_on(fault), RuleId::triangle_shared_edge, reason};
      for (int index : {fault.first, fault.second})
        for (const CoverageDifference& difference : excused_by_policy(primitive_at(index)))
          if (difference.pixel == fault.pixel && difference.sample == fault.sample)
            add_excused(primitive_at(index), difference, broken);
    }
    blame.finish();
    return partners;
  }

  const CoverageContext& context_;
  const RuleChoices& standard_;
  const SamplePositions lawful_;  // of samples, as reported
  const SamplePositions chosen_;  // of samples, under the policy
  SamplePlaces places_;
  std::map<int, Cause> excused_causes_;                           // by primitive
  std::map<int, std::vector<CoverageDifference>> from_standard_;  // by primitive
  std::map<int, std::set<SamplePlace>> excused_;                  // by primitive
  Result& result_;
};

}  // namespace

void compare_coverage(const CoverageContext& context, Result& result) {
  CoverageComparison(context, result).run();
}

}  // namespace edgecase
