// SPDX-License-Identifier: MIT
#include "diff/output/operations_causes.h"

#include <algorithm>
#include <cmath>

#include "rules/all_rules.h"
#include "rules/change_search.h"
#include "rules/values/framebuffer.h"

namespace edgecase {
namespace {

// All alternatives are tried on this many samples, and pairs of them on the first few; later
// samples only try those that fitted an earlier one.
constexpr std::size_t kMostSearches = 2048;
constexpr std::size_t kMostPairSearches = 64;
// With more fragments than this, pairs take too long.
constexpr std::size_t kMostFragments = 16;

}  // namespace

OperationsCauses::OperationsCauses(const Scene& scene, const RuleChoices& chosen)
    : changes_(operations_changes(scene, chosen)) {
  for (const Change& change : changes_) singles_.push_back({change.id, change.applied_to(chosen)});
}

void OperationsCauses::add(const OperationsQuestion& question) {
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

void OperationsCauses::weigh(const OperationsQuestion& question) {
  for (const Candidate& candidate : found_)
    if (!question.yields(candidate.choice)) --counts_[candidate.cause];
}

std::vector<Cause> OperationsCauses::search(const OperationsQuestion& question) {
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

void OperationsCauses::search_pairs(const OperationsQuestion& question,
                                    std::vector<Cause>& causes) {
  for_each_pair(changes_, [&](std::size_t i, std::size_t j) {
    const RuleChoices choice = changes_[j].applied_to(singles_[i].choice);
    if (!question.yields(choice)) return;
    causes.push_back(singles_[i].cause + changes_[j].id);
    found_.push_back({causes.back(), choice});
  });
}

std::vector<Cause> OperationsCauses::common() const {
  std::vector<Cause> common;
  for (const auto& [cause, count] : counts_)
    if (count == std::ssize(causes_)) common.push_back(cause);
  return common;
}

std::vector<Cause> OperationsCauses::take() const {
  std::vector<Cause> best;
  for (const std::vector<Cause>& causes : causes_) {
    Cause& most = best.emplace_back();
    for (const Cause& cause : causes)
      if (most.empty() || counts_.at(cause) > counts_.at(most)) most = cause;
  }
  return best;
}

// -------------------------------------------------------------------------------------- aggregates

namespace {

// The distance between stored values near this one.
double step_at(double depth, DepthFormat format) {
  const int bits = bits_of(format);
  return bits == 0 ? float_ulp(depth) : 1 / (std::ldexp(1.0, bits) - 1);
}

ValueAggregate::Place question_place(const OperationsQuestion& question) {
  return {question.pixel.x, question.pixel.y, -1};
}

}  // namespace

OperationsAggregates::OperationsAggregates(const Scene& scene, const RuleChoices& chosen) {
  for (const Change& change : operations_changes(scene, chosen))
    for (Part* part : {&blended_, &depth_tests_, &facings_, &alphas_})
      if (part->rule == change.id.rule)
        part->followed.push_back({change.id, change.applied_to(chosen)});
}

void OperationsAggregates::count(const StoredSample& stored) {
  ++samples_;
  colors_ += stored.color != nullptr ? 1U : 0U;
  depths_ += stored.depth ? 1U : 0U;
}

OperationsAggregates::Part& OperationsAggregates::part_for(OperationsReason reason) {
  return reason == OperationsReason::depth_test    ? depth_tests_
         : reason == OperationsReason::facing      ? facings_
         : reason == OperationsReason::test_of_one ? tests_of_one_
                                                   : alphas_;
}

void OperationsAggregates::add(const OperationsQuestion& question, OperationsReason reason,
                               const ExactSample& exact) {
  if (reason == OperationsReason::conversion) {
    if (!has_color(exact, question.stored)) {
      if (exact.blended) follow_roundings(question);
      add_colors(question, exact, exact.blended ? blended_ : converted_);
    }
    add_depth(question, exact);
    return;
  }
  Part& part = part_for(reason);
  std::erase_if(part.followed,
                [&](const Followed& followed) { return !question.agrees(followed.choice, {}); });
  add_outcome(question, exact, part);
}

void OperationsAggregates::follow_roundings(const OperationsQuestion& question) {
  std::erase_if(blended_.followed, [&](const Followed& followed) {
    return !has_color(question.exact(followed.choice), question.stored);
  });
}

void OperationsAggregates::add_colors(const OperationsQuestion& question, const ExactSample& exact,
                                      Part& part) const {
  Place place{question_place(question), {}};
  for (std::size_t c = 0; c < 4; ++c) {
    const double rendered = question.stored.color[c];
    if (rendered != exact.color[c])
      place.errors.push_back({static_cast<int>(c), static_cast<double>(exact.color[c]), rendered,
                              std::fabs(rendered - exact.color[c]), 255});
  }
  part.places.push_back(std::move(place));
}

void OperationsAggregates::add_depth(const OperationsQuestion& question, const ExactSample& exact) {
  if (!question.stored.depth || *question.stored.depth == exact.depth) return;
  const double rendered = *question.stored.depth;
  const double ulp = std::fabs(rendered - exact.depth) / step_at(rendered, question.target().depth);
  stored_depths_.places.push_back({question_place(question), {{0, exact.depth, rendered, ulp, 1}}});
}

// Counts an open outcome by the first plane that shows it: hits, else colour, depth or stencil.
void OperationsAggregates::add_outcome(const OperationsQuestion& question, const ExactSample& exact,
                                       Part& part) const {
  const StoredSample& stored = question.stored;
  const auto add_one = [&](double one, double other) {
    part.places.push_back({question_place(question),
                           {{0, one, other, std::fabs(other - one), std::fabs(other - one)}}});
  };
  if (stored.hits && *stored.hits != exact.hits)
    add_one(exact.hits, *stored.hits);
  else if (!has_color(exact, stored))
    add_colors(question, exact, part);
  else if (stored.depth && *stored.depth != exact.depth)
    add_one(exact.depth, *stored.depth);
  else if (stored.stencil && *stored.stencil != exact.stencil)
    add_one(exact.stencil, *stored.stencil);
}

void OperationsAggregates::flush(const Part& part, std::size_t compared, std::size_t components,
                                 Result& result) const {
  const bool has_cause = !part.places.empty() && !part.followed.empty();
  ValueAggregator aggregator(part.attribute, part.rule, rule_of(part.rule).ruling,
                             has_cause ? Cause(part.followed.front().id) : Cause());
  for (std::size_t i = 0; i < compared; ++i) aggregator.count_compared(components);
  for (const Place& place : part.places) {
    for (const ValueAggregator::Error& error : place.errors)
      aggregator.add_error(place.place, error);
    aggregator.add_place(place.place);
  }
  aggregator.flush(result);
}

void OperationsAggregates::flush(Result& result) const {
  flush(converted_, colors_, 4, result);
  flush(blended_, colors_, 4, result);
  flush(stored_depths_, depths_, 1, result);
  for (const Part* part : {&depth_tests_, &facings_, &alphas_, &tests_of_one_})
    flush(*part, samples_, 1, result);
}

}  // namespace edgecase
