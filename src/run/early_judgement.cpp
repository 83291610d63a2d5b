// SPDX-License-Identifier: MIT
#include "run/early_judgement.h"

#include <algorithm>

#include "diff/judge.h"
#include "rules/all_rules.h"

namespace edgecase {

bool is_surely_unexpected(const Result& result, Latitude latitude, const Expectation* entry) {
  const bool agrees = !result.failure && result.disagreements.empty() && result.values.empty();
  // What is contested is tolerated, and whether it is may hang on the reading.
  const auto is_contested = [](const Disagreement& d) {
    return !is_legal(d) && legality_against(d.ruling) == Legality::contested;
  };
  if (std::ranges::any_of(result.disagreements, is_contested)) return false;
  if (entry == nullptr) return !agrees;
  if (agrees || entry->verdict == Verdict::agree)
    return agrees != (entry->verdict == Verdict::agree);
  Result alone = result;
  Result* const only = &alone;
  judge({&only, 1}, latitude);
  if (alone.fingerprint == entry->fingerprint) return false;
  // A fingerprint leaves values out of a violation, and the reading of lines may make it one.
  return result.illegal_line_snaps.empty();
}

}  // namespace edgecase
