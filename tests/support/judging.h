// SPDX-License-Identifier: MIT
//
// Policies of tests, one rendering judged by itself, and what was found.
#pragma once

#include <set>
#include <string>

#include "diff/compare.h"
#include "diff/judge.h"
#include "model/policy.h"
#include "model/rendering.h"
#include "model/result.h"
#include "model/scene.h"
#include "raster/rasterizer.h"
#include "tests/support/causes.h"

namespace edgecase {

inline Policy policy_of(const Choices& rules) {
  Policy policy;
  policy.rules = rules;
  return policy;
}

inline Policy policy_with(const std::string& rule, const std::string& alternative) {
  return policy_of({{rule, alternative}});
}

// A rendering held against exact under a policy, with samples where the rendering says, and judged
// alone. `profile`: what the renderer is measured to follow; null: not known.
inline Result judged(const Scene& scene, const Rendering& rendered, const Policy& policy = {},
                     int subpixel_bits = 8, const Policy* profile = nullptr) {
  const ResolvedPolicy followed = profile != nullptr ? *profile : Policy{};
  const Rendering exact = rasterize(scene, policy, rendered.sample_positions);
  Result result = compare(scene, policy, exact, rendered,
                          {subpixel_bits, profile != nullptr ? &followed : nullptr});
  Result* const alone[] = {&result};
  judge(alone, policy.latitude);
  return result;
}

// Of all disagreements.
inline std::set<std::string> rules_of(const Result& result) {
  std::set<std::string> rules;
  for (const Disagreement& d : result.disagreements) rules.insert(name_of(d.rule));
  return rules;
}
inline std::set<std::string> disagreement_causes_of(const Result& result) {
  std::set<std::string> causes;
  for (const Disagreement& d : result.disagreements) causes.insert(text_of(d.cause));
  return causes;
}
inline std::set<int> rulings_of(const Result& result) {
  std::set<int> rulings;
  for (const Disagreement& d : result.disagreements) rulings.insert(d.ruling);
  return rulings;
}
// Of those that are not legal.
inline std::set<int> broken_rulings(const Result& result) {
  std::set<int> rulings;
  for (const Disagreement& d : result.disagreements)
    if (!is_legal(d)) rulings.insert(d.ruling);
  return rulings;
}

// Of all aggregates.
inline std::set<std::string> aggregate_causes_of(const Result& result) {
  std::set<std::string> causes;
  for (const ValueAggregate& values : result.values) causes.insert(text_of(values.cause));
  return causes;
}

// Of all disagreements and aggregates.
inline std::set<std::string> causes_of(const Result& result) {
  std::set<std::string> causes = disagreement_causes_of(result);
  causes.merge(aggregate_causes_of(result));
  return causes;
}

}  // namespace edgecase
