// SPDX-License-Identifier: MIT
//
// What differs from the exact fate and is permitted, counted by what permits it, with the
// alternative that yields all of it.
#pragma once

#include <vector>

#include "diff/output/fate_question.h"
#include "model/result.h"
#include "rules/changes.h"

namespace edgecase {

class FateAggregates {
 public:
  FateAggregates(const Scene& scene, const RuleChoices& chosen);

  // A sample with these planes is compared.
  void count(const StoredSample& stored);
  // A sample that is permitted, for a reason other than none, and what exact has there.
  void add(const FateQuestion& question, FateReason reason, const FateState& exact);
  void flush(Result& result) const;

 private:
  struct Place {
    ValueAggregate::Place place;
    std::vector<ValueAggregator::Error> errors;
  };
  struct Part {
    const char* attribute;
    RuleId rule;
    Changes followed;  // alternatives that yield all there is so far
    std::vector<Place> places;
  };

  Part& part_for(FateReason reason);
  void add_colors(const FateQuestion& question, const FateState& exact, Part& part) const;
  void add_depth(const FateQuestion& question, const FateState& exact);
  void add_outcome(const FateQuestion& question, const FateState& exact, Part& part) const;
  void follow_roundings(const FateQuestion& question);
  void flush(const Part& part, std::size_t compared, std::size_t components, Result& result) const;

  const Scene& scene_;
  const RuleChoices& chosen_;
  std::size_t colors_ = 0;
  std::size_t depths_ = 0;
  std::size_t samples_ = 0;
  Part converted_{"pixel", RuleId::framebuffer_unorm8, {}, {}};
  Part blended_;
  Part stored_depths_{"depth buffer", RuleId::framebuffer_depth, {}, {}};
  Part depth_tests_;
  Part facings_;
  Part alphas_;
};

}  // namespace edgecase
