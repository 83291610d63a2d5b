// SPDX-License-Identifier: MIT
#include "run/early_judgement.h"

#include <algorithm>

#include "diff/coverage/legality.h"
#include "rules/all_rules.h"

namespace edgecase {

bool is_surely_unexpected(const Case& one, const Result& result, Latitude latitude,
                          std::span<const KnownFault* const> faults) {
  const std::string surface = name_of(one.scene.target.surface);
  const auto is_known = [&](const auto&... what) {
    return std::ranges::any_of(faults, [&](const KnownFault* fault) {
      return accounts_for(*fault, one.id, surface, what...);
    });
  };
  if (result.failure)
    return result.failure->kind != FailureKind::unsupported && !is_known(*result.failure);
  if (latitude == Latitude::none) return !result.disagreements.empty() || !result.values.empty();
  return std::ranges::any_of(result.disagreements, [&](const Disagreement& d) {
    return !is_legal(d) && !is_about_a_line(d) && legality_against(d.ruling) == Legality::illegal &&
           !is_known(result, d);
  });
}

}  // namespace edgecase
