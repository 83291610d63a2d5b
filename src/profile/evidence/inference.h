// SPDX-License-Identifier: MIT
//
// Inference: which alternatives of the catalogue draw what a renderer draws.
//
// Every combination of the alternatives that matter for a kind of primitive is a candidate, nearly
// two thousand for lines. They compete in rounds: each round uses twice as many scenes as the one
// before and keeps the best third. The few that are left, and for each rule the nearest other
// choices, are compared with all scenes. Agreement means a whole scene: every pixel.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/policy.h"
#include "model/rule_id.h"
#include "profile/evidence/drawing.h"
#include "rules/choices.h"

namespace edgecase {

// Tally: which alternatives of a rule yield what a renderer drew.

// Trait: one finding about a renderer, and how much of the evidence agrees with it.

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

  // Whether a scene, pixel or number distinguished the alternatives at all.
  bool is_asked() const { return rate.of > 0; }
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

// The alternative of a trait if none of the catalogue yields everything.
inline constexpr const char* kNoneFits = "none fits";

// The names of a rule's alternatives, in the catalogue's order.
std::vector<std::string> names_of_alternatives(RuleId rule);

// The choices with another alternative of one rule; the name must be one of the rule's.
RuleChoices with_alternative(RuleChoices choices, RuleId rule, const std::string& alternative);

// The choices under each alternative of a rule, in the catalogue's order, all else being equal.
std::vector<RuleChoices> choices_by_alternative(const RuleChoices& choices, RuleId rule);

// The policy of rules, and the same with another alternative of one rule.
Policy policy_of(const Choices& rules);
Policy policy_with(const Choices& rules, RuleId rule, const std::string& alternative);

// The trait of the alternative with most agreeing observations, with the next best as runner-up.
// Among equals, `standard` comes first, then the first of the list.
Trait leading(TraitId id, std::span<const std::string> names, std::span<const std::size_t> agreeing,
              std::size_t of, std::size_t standard = 0);

// For each of several facts, whether an alternative yields it.
using Facts = std::vector<bool>;

// Counts, observation by observation, which of a rule's alternatives yield it. An observation that
// all of them yield is evidence for none.
class Tally {
 public:
  // With all alternatives; the rule's standard one is preferred among equals.
  explicit Tally(RuleId rule);
  // `standard`: the index of the preferred alternative.
  explicit Tally(std::vector<std::string> names, std::size_t standard = 0)
      : names_(std::move(names)), agreeing_(names_.size()), standard_(standard) {}

  // yields[a]: whether alternative a yields the observation.
  void add(const std::vector<bool>& yields);
  // facts[a][i]: whether alternative a yields fact i; all have the same number of facts.
  void add_all(const std::vector<Facts>& facts);

  // The rate covers observations that some alternatives yield and some do not. Those that none
  // yields are mentioned in a remark, or counted as well.
  enum class None { remarked, counted };
  Trait trait(TraitId id, None none = None::remarked) const;
  // The alternative that yields every observation; otherwise kNoneFits, with the closest one as
  // runner-up.
  Trait fitting(TraitId id) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::size_t> agreeing_;
  std::size_t standard_;
  std::size_t of_ = 0;    // observations that some yield and some do not
  std::size_t none_ = 0;  // observations that none yields
  std::size_t all_ = 0;
};

// The alternative found for one rule.
struct InferredRule {
  RuleId rule = RuleId::none;
  std::string alternative;
  Rate rate;              // of the whole choice, over all scenes
  std::string runner_up;  // the best other alternative of this rule, all else being equal
  Rate runner_up_rate;
};

struct Inference {
  RuleChoices choice;
  Rate rate;
  std::vector<InferredRule> rules;  // those that matter in the scenes
  // Others that were as good as the best in the rounds: several rules may differ at once.
  std::vector<RuleChoices> equals;
};

// The rules whose alternatives are tried.
enum class OpenRules {
  coverage,   // all that matter, except the next two
  width,      // line.width
  placement,  // sample.positions
};

// Which rules are open, and the choices for the others.
struct InferenceQuestion {
  PrimitiveKind kind = PrimitiveKind::triangle;
  RuleChoices start;  // preferred if candidates tie: fewest deviating rules
  OpenRules open = OpenRules::coverage;
};

// Failed observations are ignored; all others must have one primitive of the kind. Without any, the
// start is returned with an empty rate.
Inference infer(const InferenceQuestion& question,
                std::span<const Observation* const> observations);

}  // namespace edgecase
