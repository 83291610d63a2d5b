// SPDX-License-Identifier: MIT
//
// Finds the alternatives that yield what is stored if nothing permitted does: one, or two of
// different rules. Each sample gets the cause that accounts for most of the samples, less those
// samples that agree and would not under it.
#pragma once

#include <map>
#include <vector>

#include "diff/output/operations_question.h"
#include "model/result.h"
#include "rules/choices.h"

namespace edgecase {

class OperationsCauses {
 public:
  OperationsCauses(const Scene& scene, const RuleChoices& chosen);

  void add(const OperationsQuestion& question);
  // True if there are several to choose from.
  bool is_ambiguous() const { return found_.size() > 1; }
  // Counts a sample that agrees against the causes that would change it.
  void weigh(const OperationsQuestion& question);
  // The causes that account for every added question and leave every weighed one as it is.
  std::vector<Cause> common() const;
  // The cause of each added question, in order; empty for questions without one.
  std::vector<Cause> take() const;

 private:
  struct Candidate {
    Cause cause;
    RuleChoices choice;
  };

  std::vector<Cause> search(const OperationsQuestion& question);
  void search_pairs(const OperationsQuestion& question, std::vector<Cause>& causes);

  Changes changes_;
  std::vector<Candidate> singles_;
  std::vector<Candidate> found_;  // that fitted a sample so far, pairs too
  std::size_t searches_ = 0;
  std::map<Cause, std::ptrdiff_t> counts_;
  std::vector<std::vector<Cause>> causes_;
};

// -------------------------------------------------------------------------------------- aggregates
//
// Differences from exact's states that are permitted, counted by the reason that permits them, with
// the alternative that yields all of them.

class OperationsAggregates {
 public:
  OperationsAggregates(const Scene& scene, const RuleChoices& chosen);

  // Counts a compared sample with these planes.
  void count(const StoredSample& stored);
  // Adds a permitted sample, whose reason is not `none`, with exact's state there.
  void add(const OperationsQuestion& question, OperationsReason reason, const ExactSample& exact);
  void flush(Result& result) const;

 private:
  struct Place {
    ValueAggregate::Place place;
    std::vector<ValueAggregator::Error> errors;
  };
  // An alternative that yields everything so far.
  struct Followed {
    AlternativeId id;
    RuleChoices choice;
  };
  struct Part {
    const char* attribute;
    RuleId rule;
    std::vector<Followed> followed;
    std::vector<Place> places;
  };

  Part& part_for(OperationsReason reason);
  void add_colors(const OperationsQuestion& question, const ExactSample& exact, Part& part) const;
  void add_depth(const OperationsQuestion& question, const ExactSample& exact);
  void add_outcome(const OperationsQuestion& question, const ExactSample& exact, Part& part) const;
  void follow_roundings(const OperationsQuestion& question);
  void flush(const Part& part, std::size_t compared, std::size_t components, Result& result) const;

  std::size_t colors_ = 0;
  std::size_t depths_ = 0;
  std::size_t samples_ = 0;
  Part converted_{"pixel", RuleId::framebuffer_unorm8, {}, {}};
  Part blended_{"pixel", RuleId::blend_rounding, {}, {}};
  Part stored_depths_{"depth buffer", RuleId::framebuffer_depth, {}, {}};
  Part depth_tests_{"depth test", RuleId::depth_test, {}, {}};
  Part facings_{"facing", RuleId::polygon_facing, {}, {}};
  Part alphas_{"written samples", RuleId::sample_alpha_to_coverage, {}, {}};
  Part tests_of_one_{"tests of one sample for all", RuleId::sample_enable, {}, {}};
};

}  // namespace edgecase
