// SPDX-License-Identifier: MIT
#include "results/results.h"

#include <algorithm>
#include <functional>

namespace edgecase {

std::map<Verdict, std::size_t> count_verdicts(const Results& results, std::size_t index) {
  std::map<Verdict, std::size_t> counts;
  for (const CaseOutline& one : results.cases.outlines())
    if (index < one.answers.size()) ++counts[one.answers[index].verdict];
  return counts;
}

std::size_t count_unexpected(const Results& results) {
  std::size_t count = 0;
  for (const CaseOutline& one : results.cases.outlines())
    count += static_cast<std::size_t>(std::ranges::count_if(
        one.answers, [](const ResultOutline& answer) { return is_unexpected(answer.standing); }));
  return count;
}

std::size_t count_unexpected(const Results& results, std::size_t renderer) {
  const auto stands_out = [&](const CaseOutline& one) {
    return renderer < one.answers.size() && is_unexpected(one.answers[renderer].standing);
  };
  return static_cast<std::size_t>(std::ranges::count_if(results.cases.outlines(), stands_out));
}

std::vector<Refusal> refusals_of(const Results& results, std::size_t renderer) {
  std::map<std::string, std::size_t> counts;
  for (const CaseOutline& one : results.cases.outlines()) {
    if (renderer >= one.answers.size()) continue;
    const auto& failure = one.answers[renderer].failure;
    if (failure && failure->kind == FailureKind::unsupported) ++counts[failure->reason];
  }
  std::vector<Refusal> refusals;
  for (const auto& [reason, count] : counts) refusals.push_back({reason, count});
  std::ranges::stable_sort(refusals, std::greater(), &Refusal::cases);
  return refusals;
}

bool drew_nothing(const Results& results, std::size_t renderer) {
  if (results.interrupted) return false;
  bool has_refused = false;
  for (const CaseOutline& one : results.cases.outlines()) {
    if (renderer >= one.answers.size()) continue;
    const auto& failure = one.answers[renderer].failure;
    if (!failure) return false;
    has_refused = has_refused || failure->kind == FailureKind::unsupported;
  }
  return has_refused;
}

std::vector<std::size_t> idle_renderers(const Results& results) {
  std::vector<std::size_t> idle;
  if (results.shard && results.shard->count > 1) return idle;
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    if (drew_nothing(results, r)) idle.push_back(r);
  return idle;
}

Portrait portrait_of(const Results& results, std::size_t renderer) {
  PortraitGatherer gatherer;
  for (const CaseOutline& one : results.cases.outlines())
    if (renderer < one.answers.size()) gatherer.add(one.answers[renderer]);
  return gatherer.portrait();
}

}  // namespace edgecase
