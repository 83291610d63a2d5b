// SPDX-License-Identifier: MIT
//
// Ledger: what one renderer was found to do, over a whole search.
//
// Two things can only be said of a run as a whole: the snap with which lines are read, and which of
// several causes is the likeliest (diff/judge.h). So results are kept as a run's, read anew
// whenever there are twice as many, up to a few thousand, and everything is judged under the
// reading of its surface. What was found before is judged again then; finds that turn out to be the
// same become one.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "diff/judge.h"
#include "model/verdict.h"
#include "search/find.h"

namespace edgecase {

// A scene that shows something new.
struct Candidate {
  FindKey key;
  Verdict verdict = Verdict::agree;
  SourcedScene sourced;
  // Judged. Nothing where another scene shows it, too: those are many, and results are large.
  std::optional<Result> result;
};

class Ledger {
 public:
  // `least`: what is no worse than it is not looked at; convention or worse.
  Ledger(Latitude latitude, Verdict least) : latitude_(latitude), least_(least) {}

  // Finds that are known beforehand are counted and no more. The result must have been compared,
  // and is judged by itself, and as the run reads it.
  void know(FindKey key) { known_keys_.insert(std::move(key)); }
  void know(Scene scene, Result result);

  // A result of the run that shows something.
  void add(SourcedScene sourced, Result result);

  // Judges what was added since, and takes what was not there before: of each the smallest scene,
  // in the order in which they were added. Each comes once, and once more where a scene with
  // coordinates of kReadableBits (search/grid_search.h) shows it that had none before.
  std::vector<Candidate> take_candidates();

  // For each find that could still be easier to read, another scene that shows it, if there is one
  // that was not taken yet. Of each find a few are kept.
  std::vector<Candidate> take_others();

  // Is it new? Then it is kept; it takes the place of one that is the same and cannot be read as
  // easily. `find.result` must be judged under the reading.
  bool add_find(Find find);

  // How scenes on each surface are read now.
  const std::map<Surface, RunReading>& readings() const { return readings_; }

  // Reads the whole run, judges all finds by it, and takes them: worst first, then by title.
  std::vector<Find> take_finds();
  std::size_t finds() const { return finds_.size(); }
  // Known things that were met.
  std::size_t known_met() const { return known_met_.size(); }

 private:
  struct Pending {
    SourcedScene sourced;
    Result result;
  };
  struct Run {
    std::vector<Result> results;  // stripped to what a reading needs
    std::size_t read = 0;         // so many when it was last read
  };

  void read(bool all);
  void judge_again(Find& find) const;
  void judge_under_reading(const Scene& scene, Result& result) const;
  bool is_known(const FindKey& key);
  std::vector<Shown> shown(const Pending& pending) const;
  bool lacks_others(const FindKey& key) const;
  void merge_finds();

  Latitude latitude_;
  Verdict least_;
  std::vector<Pending> pending_;
  std::map<Surface, Run> runs_;
  std::map<Surface, RunReading> readings_;
  std::map<FindKey, std::size_t> seen_;  // scenes that showed it
  std::set<FindKey> readable_;           // of which a scene of kReadableBits was taken, or kept
  std::map<FindKey, std::deque<Candidate>> others_;  // that show it, and were not taken
  std::vector<Pending> known_;
  std::set<FindKey> known_keys_;
  std::set<FindKey> keys_of_known_;  // of `known_`, under the reading
  std::set<FindKey> known_met_;
  std::vector<Find> finds_;
};

}  // namespace edgecase
