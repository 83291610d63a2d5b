// SPDX-License-Identifier: MIT
#include "diff/output/fate_causes.h"

#include <algorithm>

namespace edgecase {
namespace {

// All alternatives are tried on so many samples, pairs of them on these first ones; on all others
// those that yielded something.
constexpr std::size_t kMostSearches = 2048;
constexpr std::size_t kMostPairSearches = 64;
// Where more fragments than this meet, pairs take too long.
constexpr std::size_t kMostFragments = 16;

}  // namespace

FateCauses::FateCauses(const Scene& scene, const RuleChoices& chosen)
    : changes_(fate_changes(scene, chosen)), chosen_(chosen) {
  for (const Change& change : changes_) singles_.push_back({change.id, change.applied_to(chosen)});
}

void FateCauses::add(const FateQuestion& question) {
  std::vector<Cause> causes;
  if (searches_ < kMostSearches) {
    causes = search(question);
  } else {
    for (const Candidate& candidate : found_)
      if (question.yields(candidate.choice)) causes.push_back(candidate.cause);
  }
  for (const Cause& cause : causes) ++counts_[cause];
  causes_.push_back(std::move(causes));
}

void FateCauses::weigh(const FateQuestion& question) {
  for (const Candidate& candidate : found_)
    if (!question.yields(candidate.choice)) --counts_[candidate.cause];
}

std::vector<Cause> FateCauses::search(const FateQuestion& question) {
  ++searches_;
  const auto known = [&](const Cause& cause) {
    return std::ranges::any_of(found_, [&](const Candidate& c) { return c.cause == cause; });
  };
  std::vector<Cause> causes;
  for (const Candidate& candidate : singles_) {
    if (!question.yields(candidate.choice)) continue;
    causes.push_back(candidate.cause);
    if (!known(candidate.cause)) found_.push_back(candidate);
  }
  if (!causes.empty()) return causes;
  for (const Candidate& candidate : found_)
    if (candidate.cause.size() > 1 && question.yields(candidate.choice))
      causes.push_back(candidate.cause);
  if (causes.empty() && searches_ <= kMostPairSearches &&
      question.fragments().size() <= kMostFragments)
    search_pairs(question, causes);
  return causes;
}

void FateCauses::search_pairs(const FateQuestion& question, std::vector<Cause>& causes) {
  for (std::size_t i = 0; i < changes_.size(); ++i)
    for (std::size_t j = i + 1; j < changes_.size(); ++j) {
      if (changes_[i].id.rule == changes_[j].id.rule) continue;
      const RuleChoices choice = changes_[j].applied_to(singles_[i].choice);
      if (!question.yields(choice)) continue;
      causes.push_back(Cause(changes_[i].id) + changes_[j].id);
      found_.push_back({causes.back(), choice});
    }
}

std::vector<Cause> FateCauses::take() const {
  std::vector<Cause> best;
  for (const std::vector<Cause>& causes : causes_) {
    Cause& most = best.emplace_back();
    for (const Cause& cause : causes)
      if (most.empty() || counts_.at(cause) > counts_.at(most)) most = cause;
  }
  return best;
}

}  // namespace edgecase
