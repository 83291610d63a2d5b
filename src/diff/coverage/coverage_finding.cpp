// SPDX-License-Identifier: MIT
#include "diff/coverage/coverage_finding.h"

#include <fmt/format.h>

#include <set>

#include "diff/coverage/legality.h"
#include "diff/coverage/situation.h"
#include "rules/coverage/explain.h"
#include "rules/coverage/snap.h"

namespace edgecase {

Disagreement at_sample(const ScenePrimitive& primitive, const CoverageDifference& difference,
                       Point sample, const Target& target) {
  Disagreement d;
  d.x = difference.pixel.x;
  d.y = difference.pixel.y;
  d.sample = difference.sample;
  d.primitive = primitive.index;
  d.exact = {static_cast<double>(difference.exact)};
  d.rendered = {static_cast<double>(difference.drawn)};
  d.kind =
      difference.drawn < difference.exact ? DisagreementKind::missing : DisagreementKind::extra;
  d.rule = rule_on_coverage(primitive, target);
  d.situation = situation_of(primitive, sample, target);
  return d;
}

Disagreement duplicate(const ScenePrimitive& primitive, const CoverageDifference& difference,
                       Point sample, const Target& target) {
  Disagreement d = at_sample(primitive, difference, sample, target);
  d.kind = DisagreementKind::duplicate;
  d.rule = RuleId::fragment_once;
  d.ruling = 7;
  d.explanation = fmt::format(
      "primitive {} produces the fragment of {}pixel ({}, {}) {} times. Ruling 7: once at most.",
      primitive.index, target.samples > 1 ? fmt::format("sample {} of ", d.sample) : "", d.x, d.y,
      difference.drawn);
  d.figure.marks = {sample_mark(sample)};
  return d;
}

void merge_snaps(const std::vector<std::string>& more, std::vector<std::string>& names) {
  std::set<std::string> all(names.begin(), names.end());
  all.insert(more.begin(), more.end());
  names.clear();
  for (Snap snap : all_snaps())
    if (all.contains(name_of(snap))) names.push_back(name_of(snap));
}

}  // namespace edgecase
