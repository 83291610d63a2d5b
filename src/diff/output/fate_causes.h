// SPDX-License-Identifier: MIT
//
// Which alternatives yield what is stored where nothing that the specification permits does: one of
// them, or two of different rules. Each sample gets the cause that accounts for most of them, less
// those samples that agree and would not under it.
#pragma once

#include <map>
#include <vector>

#include "diff/output/fate_question.h"
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

}  // namespace edgecase
