// SPDX-License-Identifier: MIT
//
// Which alternatives yield what is stored where nothing that the specification permits does: one of
// them, or two of different rules. Each sample gets the cause that accounts for most of them, less
// those samples that agree and would not under it.
#pragma once

#include <map>
#include <vector>

#include "diff/output/fate_question.h"
#include "model/result.h"
#include "rules/changes.h"

namespace edgecase {

class FateCauses {
 public:
  FateCauses(const Scene& scene, const RuleChoices& chosen);

  void add(const FateQuestion& question);
  // Are there several to choose from?
  bool is_ambiguous() const { return found_.size() > 1; }
  // A sample that agrees.
  void weigh(const FateQuestion& question);
  // Of each question that was added, in that order; no cause where there is none.
  std::vector<Cause> take() const;

 private:
  struct Candidate {
    Cause cause;
    RuleChoices choice;
  };

  std::vector<Cause> search(const FateQuestion& question);
  void search_pairs(const FateQuestion& question, std::vector<Cause>& causes);

  Changes changes_;
  RuleChoices chosen_;
  std::vector<Candidate> singles_;
  std::vector<Candidate> found_;  // that yielded something so far, pairs too
  std::size_t searches_ = 0;
  std::map<Cause, std::ptrdiff_t> counts_;
  std::vector<std::vector<Cause>> causes_;
};

// -------------------------------------------------------------------------------------- aggregates
//
// What differs from the exact fate and is permitted, counted by what permits it, with the
// alternative that yields all of it.

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
