// SPDX-License-Identifier: MIT
#include "suite/separation.h"

#include <algorithm>
#include <map>
#include <vector>

#include "model/policy.h"
#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/choices.h"
#include "wire/answer_line.h"
#include "wire/request_line.h"

namespace edgecase {
namespace {

// The coverage and depths of a scene.
struct Drawn {
  std::vector<SampleCoverage> covered;  // by each primitive
  std::vector<double> depths;           // of samples, where a draw does without GL_MULTISAMPLE
  friend bool operator==(const Drawn&, const Drawn&) = default;
};

// All that exact answers, as a number.
std::string answer_under(const Scene& scene, const ResolvedPolicy& policy) {
  return digest_of(answer_line("", rasterize(scene, policy), nullptr));
}

bool is_switched_off(const Scene& scene) {
  return scene.target.samples > 1 && std::ranges::any_of(scene.draws, [](const Draw& draw) {
           return !draw.multisampling.enabled;
         });
}

Drawn drawn_under(const Scene& scene, const ResolvedPolicy& policy) {
  const RuleChoices& choices = policy.on(scene.target.surface);
  Drawn drawn;
  for (const ScenePrimitive& primitive : primitives_of(scene))
    drawn.covered.push_back(
        covered_samples(primitive, scene.target, choices.of(primitive.kind), SamplePositions{}));
  if (is_switched_off(scene)) drawn.depths = rasterize(scene, policy).depths;
  return drawn;
}

// A policy for each alternative of a rule.
std::vector<ResolvedPolicy> policies_of(RuleId rule) {
  std::vector<ResolvedPolicy> policies;
  for (const Alternative& alternative : rule_of(rule).alternatives) {
    Policy policy;
    policy.rules[name_of(rule)] = alternative.name;
    policies.emplace_back(policy);
  }
  return policies;
}

std::vector<Drawn> drawn_under_each(const Scene& scene,
                                    const std::vector<ResolvedPolicy>& policies) {
  std::vector<Drawn> drawn;
  for (const ResolvedPolicy& policy : policies) drawn.push_back(drawn_under(scene, policy));
  return drawn;
}

void count_case(const Scene& scene, const std::vector<ResolvedPolicy>& policies,
                SeparationMatrix& matrix) {
  const std::vector<Drawn> drawn = drawn_under_each(scene, policies);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t j = 0; j < drawn.size(); ++j)
      if (drawn[i] != drawn[j]) ++matrix.cases[i][j];
}

// Every boundary open, or every one closed.
ResolvedPolicy with_boundaries(const char* alternative) {
  Policy policy;
  for (const PrimitiveKind kind : values_of<PrimitiveKind>())
    policy.rules[name_of(coverage_rule_of(kind))] = alternative;
  return policy;
}

bool has_tie(const Scene& scene) {
  static const ResolvedPolicy open = with_boundaries("open");
  static const ResolvedPolicy closed = with_boundaries("closed");
  return drawn_under(scene, open) != drawn_under(scene, closed);
}

SeparationMatrix empty_matrix(RuleId id) {
  SeparationMatrix matrix;
  matrix.rule = name_of(id);
  for (const Alternative& alternative : rule_of(id).alternatives)
    matrix.alternatives.push_back(alternative.name);
  const std::size_t size = matrix.alternatives.size();
  matrix.cases.assign(size, std::vector<std::size_t>(size, 0));
  return matrix;
}

}  // namespace

std::size_t SeparationMatrix::least() const {
  std::size_t result = static_cast<std::size_t>(-1);
  for (std::size_t i = 0; i < alternatives.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) result = std::min(result, cases[i][j]);
  return result;
}

Separation measure_separation(const CaseStore& cases) {
  Separation result;
  result.cases = cases.size();
  std::vector<std::vector<ResolvedPolicy>> policies;
  for (const RuleId rule : coverage_rules()) {
    result.matrices.push_back(empty_matrix(rule));
    policies.push_back(policies_of(rule));
  }
  for (const Case& one : cases) {
    if (has_tie(one.scene)) ++result.with_ties;
    for (std::size_t i = 0; i < policies.size(); ++i)
      count_case(one.scene, policies[i], result.matrices[i]);
  }
  return result;
}

namespace {

template <class Outcome>
void add_pairs(RuleId rule, const std::vector<Outcome>& outcomes,
               std::vector<AlternativePair>& pairs) {
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (outcomes[i] != outcomes[j]) pairs.push_back({rule, i, j});
}

}  // namespace

std::vector<AlternativePair> pairs_told_apart(const Case& one) {
  static const std::map<RuleId, std::vector<ResolvedPolicy>> policies = [] {
    std::map<RuleId, std::vector<ResolvedPolicy>> made;
    for (const Rule& rule : all_rules())
      if (!rule.alternatives.empty()) made.emplace(rule.id, policies_of(rule.id));
    return made;
  }();
  std::vector<AlternativePair> pairs;
  for (const auto& [rule, under] : policies) {
    if (rule_of(rule).say.in_coverage != nullptr) {
      add_pairs(rule, drawn_under_each(one.scene, under), pairs);
    } else if (std::ranges::find(one.rules, name_of(rule)) != one.rules.end()) {
      std::vector<std::string> answers;
      for (const ResolvedPolicy& policy : under) answers.push_back(answer_under(one.scene, policy));
      add_pairs(rule, answers, pairs);
    }
  }
  return pairs;
}

}  // namespace edgecase
