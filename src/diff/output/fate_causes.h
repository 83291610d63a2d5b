// SPDX-License-Identifier: MIT
//
// Which alternatives yield what is stored where nothing that the specification permits does: one of
// them, or two of different rules. Each sample gets the cause that accounts for most of them, less
// those samples that agree and would not under it.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diff/output/fate_question.h"

namespace edgecase {

class FateCauses {
 public:
  FateCauses(const Scene& scene, const FateChoice& chosen);

  void add(const FateQuestion& question);
  // Are there several to choose from?
  bool is_ambiguous() const { return found_.size() > 1; }
  // A sample that agrees.
  void weigh(const FateQuestion& question);
  // Of each question that was added, in that order; empty where there is none.
  std::vector<std::string> take() const;

 private:
  struct Candidate {
    std::string cause;
    FateChoice choice;
  };

  std::vector<std::string> search(const FateQuestion& question);
  void search_pairs(const FateQuestion& question, std::vector<std::string>& causes);

  std::vector<FateChange> changes_;
  FateChoice chosen_;
  std::vector<Candidate> singles_;
  std::vector<Candidate> found_;  // that yielded something so far, pairs too
  std::size_t searches_ = 0;
  std::map<std::string, std::ptrdiff_t> counts_;
  std::vector<std::vector<std::string>> causes_;
};

}  // namespace edgecase
