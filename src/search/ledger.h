// SPDX-License-Identifier: MIT
//
// Ledger: what one renderer was found to do during a whole search.
//
// Two things depend on a run as a whole: the snap with which lines are read, and which of several
// causes is the likeliest (diff/judge.h). So results are kept like those of a run, read again
// whenever their number has doubled, up to a few thousand, and judged under the reading of their
// surface. Earlier finds are then judged again, and finds that turn out to be equal are merged.
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
  // Judged. Absent if further scenes show the same find: those are many, and results are large.
  std::optional<Result> result;
};

class Ledger {
 public:
  // Ignores verdicts better than `least`, which is convention or worse.
  Ledger(Latitude latitude, Verdict least) : latitude_(latitude), least_(least) {}

  // Registers known finds, which are only counted. The result must have been compared; it is judged
  // by itself and under the run's reading.
  void know(FindKey key) { known_keys_.insert(std::move(key)); }
  void know(Scene scene, Result result);

  // Adds a result of the run that shows something.
  void add(SourcedScene sourced, Result result);

  // Judges the results added since the last call and returns new finds: for each the smallest
  // scene, in the order in which they were added. Each is returned once, and once more if a scene
  // with coordinates of kReadableBits (search/grid_search.h) shows it for the first time.
  std::vector<Candidate> take_candidates();

  // For each find that could still be easier to read, another scene that shows it, if there is one
  // that was not taken yet. A few are kept for each find.
  std::vector<Candidate> take_others();

  // Returns true if the find is new and keeps it. A find that equals an earlier one but is easier
  // to read replaces that one. `find.result` must be judged under the reading.
  bool add_find(Find find);

  // The current reading of scenes on each surface.
  const std::map<Surface, RunReading>& readings() const { return readings_; }

  // Reads the whole run, judges all finds by it, and returns them: worst first, then by title.
  std::vector<Find> take_finds();
  std::size_t finds() const { return finds_.size(); }
  // The number of known finds that were met.
  std::size_t known_met() const { return known_met_.size(); }

 private:
  struct Pending {
    SourcedScene sourced;
    Result result;
  };
  struct Run {
    std::vector<Result> results;  // reduced to what a reading needs
    std::size_t read = 0;         // the number of results when it was last read
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
  std::map<FindKey, std::size_t> seen_;              // scenes that showed it
  std::set<FindKey> readable_;                       // of which a readable scene was taken or kept
  std::map<FindKey, std::deque<Candidate>> others_;  // scenes that show it and were not taken
  std::vector<Pending> known_;
  std::set<FindKey> known_keys_;
  std::set<FindKey> keys_of_known_;  // of `known_`, under the reading
  std::set<FindKey> known_met_;
  std::vector<Find> finds_;
};

}  // namespace edgecase
