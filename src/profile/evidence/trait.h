// SPDX-License-Identifier: MIT
//
// Trait: one finding about a renderer, and how much of the evidence agrees with it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/rule_id.h"

namespace edgecase {

// In how many scenes something is as claimed, of how many.
struct Rate {
  std::size_t agreeing = 0;
  std::size_t of = 0;

  // 0 to 1; 1 where there is nothing to disagree.
  double share() const;
};

// "100 %" for all, else rounded down, so that one scene of many still shows: "99.99 %".
std::string percent(const Rate& rate);

// What a trait is about: a rule of the catalogue, or a question of no rule, and how it was asked.
struct TraitId {
  RuleId rule = RuleId::none;  // none: the question is of no rule
  std::string probe = {};      // "depth16", "multisampled"; empty: the rule itself

  TraitId(RuleId asked, std::string way = {}) : rule(asked), probe(std::move(way)) {}
  // A question that is of no rule: "clip.triangle".
  explicit TraitId(std::string question) : probe(std::move(question)) {}
  TraitId() = default;

  // Does the trait say which alternative of the rule is followed, in general?
  bool is_rule() const { return rule != RuleId::none && probe.empty(); }
  friend bool operator==(const TraitId&, const TraitId&) = default;
};

// "line.snap", "offset.unit:depth16", "clip.triangle".
std::string text_of(const TraitId& id);

// One finding about one surface.
struct Trait {
  TraitId id = {};
  std::string alternative = {};  // the alternative that is followed, or the finding in words
  Rate rate = {};                // of the scenes, pixels or numbers that agree with it
  std::string runner_up = {};    // the best other alternative; empty: none to compare with
  Rate runner_up_rate = {};
  std::string remark = {};  // what people should know, a sentence; often empty

  // Could the runner-up just as well be it?
  bool is_undecided() const {
    return !runner_up.empty() && rate.agreeing == runner_up_rate.agreeing;
  }
};

// Who owns the parts of a boundary: what was seen at probes, by row and column.
struct OwnershipTable {
  struct Cell {
    std::size_t drawn = 0;
    std::size_t of = 0;

    void count(bool is_drawn);
  };
  std::string title;  // "start of a line on its pixel's diamond"
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> cells;  // [row][column]

  // A table of empty cells.
  OwnershipTable(std::string title, std::vector<std::string> rows,
                 std::vector<std::string> columns);
};

}  // namespace edgecase
