// SPDX-License-Identifier: MIT
//
// Comparison: how each case changed from one results file to another, between two drivers, versions
// or policies.
//
// Renderers are matched by name; if each file has only one, these two are compared whatever their
// names. Answers are compared with answers, by verdict and fingerprint; known faults play no part.
// Changes are grouped by rule and cause, so that one fault of a new version is one line, however
// many cases show it.
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
template <>
inline constexpr auto kNames<ChangeKind> =
    std::to_array<Named<ChangeKind>>({{ChangeKind::new_disagreement, "new-disagreement"},
                                      {ChangeKind::worse, "worse"},
                                      {ChangeKind::not_run, "not-run"},
                                      {ChangeKind::changed, "changed"},
                                      {ChangeKind::appeared, "appeared"},
                                      {ChangeKind::disappeared, "disappeared"},
                                      {ChangeKind::runs, "runs"},
                                      {ChangeKind::better, "better"},
                                      {ChangeKind::fixed, "fixed"}});

struct CaseChange {
  std::string id;
  ChangeKind change = ChangeKind::changed;
  std::optional<Judgement> before;  // nothing: the case is not there
  std::optional<Judgement> after;
};

// The changes of one kind by one rule and cause. A case with several rules counts in each.
struct ChangeCluster {
  ChangeKind change = ChangeKind::changed;
  std::string rule;   // id; of cases that are not rendered "not-run"
  std::string cause;  // empty: none found; of cases that are not rendered the kind of failure
  std::size_t cases = 0;
  std::size_t disagreements = 0;  // and values inside what is permitted
  std::string first_case;         // by id
};

// A difference that is not about a case.
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

// "triangle.fill-rule, fbo" -> the alternatives that a renderer's answers leave.
std::map<std::string, std::string> remaining_in(const Results& results,
                                                const std::string& renderer);

// Returns a sentence instead if no renderer can be compared.
std::variant<Comparison, std::string> compare_results(const Results& before, const Results& after);

// True if any case has changed, or only one file has a renderer. Facts do not count.
bool differs(const Comparison& comparison);

// The comparison as JSON, complete:
//
//   {"edgecase_comparison": 1, "facts": [{"what", "before", "after"}], "renderers": [{"before",
//    "after", "facts", "same", "counts": {CHANGE: number}, "clusters": [{"change", "rule", "cause",
//    "cases", "disagreements", "first_case"}], "cases": [{"id", "change", "before": {"verdict",
//    "fingerprint"}, "after"}]}], "only_before", "only_after"}
//
// A case that is missing on one side has no "before" or "after".
std::string comparison_json(const Comparison& comparison);

}  // namespace edgecase
