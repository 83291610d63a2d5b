// SPDX-License-Identifier: MIT
//
// Trait: one finding about a renderer, and how much of the evidence agrees with it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/rule_id.h"

namespace edgecase {

// In how many of a number of scenes a claim holds.
struct Rate {
  std::size_t agreeing = 0;
  std::size_t of = 0;

  // 0 to 1; 1 without any scene.
  double share() const;
};

// "100 %" for all, otherwise rounded down, so that one scene of many still shows: "99.99 %".
std::string percent(const Rate& rate);

// The subject of a trait: a rule of the catalogue, or a question without a rule, and its probe.
struct TraitId {
  RuleId rule = RuleId::none;  // none: the question has no rule
  std::string probe = {};      // "depth16", "multisampled"; empty: the rule itself

  TraitId(RuleId asked, std::string way = {}) : rule(asked), probe(std::move(way)) {}
  // A question without a rule: "clip.triangle".
  explicit TraitId(std::string question) : probe(std::move(question)) {}
  TraitId() = default;

  // Whether the trait states which alternative of the rule is followed in general.
  bool is_rule() const { return rule != RuleId::none && probe.empty(); }
  friend bool operator==(const TraitId&, const TraitId&) = default;
};

// "line.snap", "offset.unit:depth16", "clip.triangle".
std::string text_of(const TraitId& id);

// One finding about one surface.
struct Trait {
  TraitId id = {};
  std::string alternative = {};  // the alternative that is followed, or the finding as text
  Rate rate = {};                // of the agreeing scenes, pixels or numbers
  std::string runner_up = {};    // the best other alternative; empty: there is none
  Rate runner_up_rate = {};
  std::string remark = {};  // a sentence for people; often empty

  // Whether the runner-up fits equally well.
  bool is_undecided() const {
    return !runner_up.empty() && rate.agreeing == runner_up_rate.agreeing;
  }
};

// Who owns the parts of a boundary: observations at probes, by row and column.
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
