// SPDX-License-Identifier: MIT
//
// Comparison: what became of each case from one results file to another, between two drivers,
// versions or policies.
//
// Renderers are matched by name; where each file has one alone, these two are compared whatever
// they are called. Expectations play no part: answers are compared with answers, by verdict and
// fingerprint. What differs is grouped by rule and cause, so that one fault that came with a new
// version is one line, however many cases show it.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "results/results.h"

namespace edgecase {

// Worst first.
enum class ChangeKind {
  new_disagreement,  // it agreed, and does not any more
  worse,             // the verdict is a worse one
  not_run,           // it was rendered, and is not any more
  changed,           // the verdict is the same, the fingerprint is not
  appeared,          // only the new results have the case
  disappeared,       // only the old results have it
  runs,              // it was not rendered, and is now
  better,            // the verdict is a better one, short of agreement
  fixed,             // it agrees now, and did not
};

inline constexpr std::array kAllChanges = {ChangeKind::new_disagreement,
                                           ChangeKind::worse,
                                           ChangeKind::not_run,
                                           ChangeKind::changed,
                                           ChangeKind::appeared,
                                           ChangeKind::disappeared,
                                           ChangeKind::runs,
                                           ChangeKind::better,
                                           ChangeKind::fixed};

const char* name_of(ChangeKind);  // "new-disagreement"

struct CaseChange {
  std::string id;
  ChangeKind change = ChangeKind::changed;
  std::optional<Judgement> before;  // nothing: the case is not there
  std::optional<Judgement> after;
};

// What changed in one way, by one rule and cause. A case of several rules counts in each.
struct ChangeCluster {
  ChangeKind change = ChangeKind::changed;
  std::string rule;   // id; of cases that are not rendered "not-run"
  std::string cause;  // empty: none found; of cases that are not rendered the kind of failure
  std::size_t cases = 0;
  std::size_t disagreements = 0;  // and values inside what is permitted
  std::string first_case;         // by id
};

// Something beside the cases that is not the same in both.
struct FactChange {
  std::string what;  // "version"
  std::string before;
  std::string after;
};

struct RendererComparison {
  std::string before;  // name
  std::string after;
  std::vector<FactChange> facts;  // what it says of itself
  std::size_t same = 0;           // cases that did not change
  std::map<ChangeKind, std::size_t> counts;
  std::vector<ChangeCluster> clusters;  // by change, then the largest first
  std::vector<CaseChange> cases;        // that changed, by id
};

struct Comparison {
  std::vector<FactChange> facts;  // tool, policy, what is not whole
  std::vector<RendererComparison> renderers;
  std::vector<std::string> only_before;  // renderers that the other file does not have
  std::vector<std::string> only_after;
};

// A sentence instead where no renderer can be compared.
std::variant<Comparison, std::string> compare_results(const Results& before, const Results& after);

// Is any case, or a renderer, not as it was? Facts do not count.
bool differs(const Comparison& comparison);

// The comparison as JSON, complete:
//
//   {"edgecase_comparison": 1, "facts": [{"what", "before", "after"}], "renderers": [{"before",
//    "after", "facts", "same", "counts": {CHANGE: number}, "clusters": [{"change", "rule", "cause",
//    "cases", "disagreements", "first_case"}], "cases": [{"id", "change", "before": {"verdict",
//    "fingerprint"}, "after"}]}], "only_before", "only_after"}
//
// "before" or "after" of a case is absent where the case is.
std::string comparison_json(const Comparison& comparison);

}  // namespace edgecase
