// SPDX-License-Identifier: MIT
#include "rules/choices.h"

#include "model/side_clipping.h"
#include "rules/all_rules.h"
#include "rules/coverage/window.h"

namespace edgecase {
namespace {

// The alternative that a policy chooses for a rule on a surface; empty if it chooses none.
std::string chosen(const Policy& policy, Surface surface, const std::string& rule) {
  if (const auto overrides = policy.surfaces.find(surface); overrides != policy.surfaces.end())
    if (const auto choice = overrides->second.find(rule); choice != overrides->second.end())
      return choice->second;
  const auto choice = policy.rules.find(rule);
  return choice != policy.rules.end() ? choice->second : "";
}

template <class T>
const T& one_of(PrimitiveKind kind, const T& point, const T& line, const T& triangle) {
  switch (kind) {
    case PrimitiveKind::point:
      return point;
    case PrimitiveKind::line:
      return line;
    case PrimitiveKind::triangle:
      return triangle;
  }
  return triangle;
}

}  // namespace

const CoverageChoice& RuleChoices::of(PrimitiveKind kind) const {
  return one_of(kind, points, lines, triangles);
}

RuleId coverage_rule_of(PrimitiveKind kind) {
  return one_of(kind, RuleId::point_ownership, RuleId::line_diamond_exit,
                RuleId::triangle_fill_rule);
}

RuleId snap_rule_of(PrimitiveKind kind) {
  return one_of(kind, RuleId::point_snap, RuleId::line_snap, RuleId::triangle_snap);
}

RuleId row_order_rule_of(PrimitiveKind kind) {
  return one_of(kind, RuleId::point_row_order, RuleId::line_row_order, RuleId::triangle_row_order);
}

RuleChoices resolve(const Policy& policy, Surface surface) {
  RuleChoices choices;
  for (const Rule& rule : all_rules()) {
    if (rule.slot.put == nullptr) continue;
    const std::string choice = chosen(policy, surface, name_of(rule.id));
    if (!choice.empty())
      rule.slot.put(choices, choice);
    else if (!rule.slot.stays)
      rule.slot.put(choices, rule.standard);
  }
  return choices;
}

const RuleChoices& standard_choices() {
  static const RuleChoices choices = resolve(Policy{}, Surface::fbo);
  return choices;
}

ResolvedPolicy::ResolvedPolicy(const Policy& policy)
    : latitude_(policy.latitude), is_standard_(policy.rules.empty() && policy.surfaces.empty()) {
  for (const Surface surface : values_of<Surface>())
    choices_[static_cast<std::size_t>(surface)] = resolve(policy, surface);
}

namespace {

// The rules with a choice that have a say, in the order of their ids.
template <class HasSay>
std::vector<RuleId> rules_where(const HasSay& has_say) {
  std::vector<RuleId> rules;
  for (const RuleId id : values_of<RuleId>())
    if (id != RuleId::none && rule_of(id).slot.put != nullptr && has_say(rule_of(id).say))
      rules.push_back(id);
  return rules;
}

std::vector<RuleId> rules_for(const CoverageTraits& traits) {
  return rules_where(
      [&](const auto& say) { return say.in_coverage != nullptr && say.in_coverage(traits); });
}

Changes placements_beside(int samples, const SamplePlacement& chosen) {
  Changes changes;
  for (const SamplePlacement& placement : placements_of(samples))
    if (placement != chosen)
      changes.push_back({alternative_id(RuleId::sample_positions, name_of(placement)), placement});
  return changes;
}

}  // namespace

void Change::apply(RuleChoices& choices) const {
  if (placement)
    for (CoverageChoice* choice : {&choices.points, &choices.lines, &choices.triangles})
      choice->placement = *placement;
  else
    rule_of(id.rule).slot.put(choices, alternative_of(id)->name);
}

Cause cause_of(const Changes& changes) {
  Cause cause;
  for (const Change& change : changes) cause.parts.push_back(change.id);
  return cause;
}

RuleChoices applied(const Changes& changes, RuleChoices choices) {
  for (const Change& change : changes) change.apply(choices);
  return choices;
}

Changes changes_beside(RuleId rule, const RuleChoices& chosen) {
  const std::string kept = rule_of(rule).slot.kept(chosen);
  Changes changes;
  for (std::size_t i = 0; i < rule_of(rule).alternatives.size(); ++i)
    if (rule_of(rule).alternatives[i].name != kept)
      changes.push_back({{rule, static_cast<std::uint8_t>(i)}});
  return changes;
}

Changes changes_beside(std::span<const RuleId> rules, const RuleChoices& chosen) {
  Changes changes;
  for (const RuleId rule : rules) {
    const Changes more = changes_beside(rule, chosen);
    changes.insert(changes.end(), more.begin(), more.end());
  }
  return changes;
}

std::optional<Change> change_between(RuleId rule, const RuleChoices& from, const RuleChoices& to) {
  const std::string kept = rule_of(rule).slot.kept(to);
  if (kept == rule_of(rule).slot.kept(from)) return std::nullopt;
  return Change{alternative_id(rule, kept)};
}

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
  traits.leaves_sides = leaves_sides(primitive);
  traits.is_culled_by_facing = primitive.state->cull != CullMode::none;
  return traits;
}

std::vector<Changes> coverage_changes(const CoverageTraits& traits, const RuleChoices& chosen) {
  std::vector<Changes> rules;
  for (const RuleId rule : rules_for(traits))
    rules.push_back(rule == RuleId::sample_positions
                        ? placements_beside(traits.samples, chosen.of(traits.kind).placement)
                        : changes_beside(rule, chosen));
  return rules;
}

Changes coverage_changes_between(const ScenePrimitive& primitive, const Target& target,
                                 const RuleChoices& from, const RuleChoices& to) {
  const CoverageTraits traits = coverage_traits(primitive, target);
  std::vector<RuleId> rules = rules_for(traits);
  if (traits.kind == PrimitiveKind::line && !traits.is_multisampled &&
      fills_area(to.lines.line, primitive.state->line_width))
    rules.push_back(RuleId::triangle_fill_rule);
  Changes changes;
  for (const RuleId rule : rules)
    if (const auto change = change_between(rule, from, to)) changes.push_back(*change);
  return changes;
}

Changes operations_changes(const Scene& scene, const RuleChoices& chosen) {
  const auto rules = rules_where(
      [&](const auto& say) { return say.in_operations != nullptr && say.in_operations(scene); });
  return changes_beside(rules, chosen);
}

const std::vector<RuleId>& lookup_rules() {
  static const auto rules = rules_where([](const auto& say) { return say.in_lookups; });
  return rules;
}

const std::vector<RuleId>& coverage_rules() {
  static const auto rules = rules_where([](const auto& say) { return say.in_coverage != nullptr; });
  return rules;
}

namespace {

// The alternatives that an agreeing primitive can refute.
const std::vector<AlternativeId>& refutable() {
  static const std::vector<AlternativeId> all = [] {
    std::vector<AlternativeId> ids;
    for (const RuleId rule : coverage_rules())
      for (std::size_t i = 0; i < rule_of(rule).alternatives.size(); ++i)
        ids.push_back({rule, static_cast<std::uint8_t>(i)});
    ids.push_back({kWindowOrigin});
    return ids;
  }();
  return all;
}

}  // namespace

std::string text_of_refuted(const AlternativeSet& refuted) {
  std::string text;
  if (refuted == AlternativeSet()) return text;
  for (const AlternativeId id : refutable()) text += refuted.contains(id) ? '1' : '0';
  return text;
}

std::optional<AlternativeSet> parse_refuted(std::string_view text) {
  if (text.empty()) return AlternativeSet();
  if (text.size() != refutable().size() || text.find_first_not_of("01") != text.npos)
    return std::nullopt;
  AlternativeSet refuted;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '1') refuted.add(refutable()[i]);
  return refuted;
}

}  // namespace edgecase
