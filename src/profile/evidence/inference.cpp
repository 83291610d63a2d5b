// SPDX-License-Identifier: MIT
#include "profile/evidence/inference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include "raster/rasterizer.h"
#include "rules/all_rules.h"
#include "rules/choices.h"

namespace edgecase {

double Rate::share() const {
  return of == 0 ? 1 : static_cast<double>(agreeing) / static_cast<double>(of);
}

std::string percent(const Rate& rate) {
  if (rate.of == 0) return "-";
  if (rate.agreeing == rate.of) return "100 %";
  const std::size_t hundredths = rate.agreeing * 10'000 / rate.of;
  return fmt::format("{}.{:02} %", hundredths / 100, hundredths % 100);
}

std::string text_of(const TraitId& id) {
  if (id.rule == RuleId::none) return id.probe;
  return id.probe.empty() ? name_of(id.rule) : fmt::format("{}:{}", name_of(id.rule), id.probe);
}

void OwnershipTable::Cell::count(bool is_drawn) {
  ++of;
  if (is_drawn) ++drawn;
}

OwnershipTable::OwnershipTable(std::string table_title, std::vector<std::string> row_names,
                               std::vector<std::string> column_names)
    : title(std::move(table_title)),
      rows(std::move(row_names)),
      columns(std::move(column_names)),
      cells(rows.size(), std::vector<Cell>(columns.size())) {}

std::vector<std::string> names_of_alternatives(RuleId rule) {
  std::vector<std::string> names;
  for (const Alternative& alternative : rule_of(rule).alternatives)
    names.push_back(alternative.name);
  return names;
}

RuleChoices with_alternative(RuleChoices choices, RuleId rule, const std::string& alternative) {
  rule_of(rule).slot.put(choices, alternative);
  return choices;
}

std::vector<RuleChoices> choices_by_alternative(const RuleChoices& choices, RuleId rule) {
  std::vector<RuleChoices> result;
  for (const Alternative& alternative : rule_of(rule).alternatives)
    result.push_back(with_alternative(choices, rule, alternative.name));
  return result;
}

Policy policy_of(const Choices& rules) {
  Policy policy;
  policy.rules = rules;
  return policy;
}

Policy policy_with(const Choices& rules, RuleId rule, const std::string& alternative) {
  Policy policy = policy_of(rules);
  policy.rules[name_of(rule)] = alternative;
  return policy;
}

Trait leading(TraitId id, std::span<const std::string> names, std::span<const std::size_t> agreeing,
              std::size_t of, std::size_t standard) {
  const auto most = std::max_element(agreeing.begin(), agreeing.end());
  const std::size_t first =
      agreeing[standard] == *most ? standard : static_cast<std::size_t>(most - agreeing.begin());
  std::size_t second = first == 0 ? 1 : 0;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (i != first && agreeing[i] > agreeing[second]) second = i;
  return {std::move(id), names[first],           {agreeing[first], of},
          names[second], {agreeing[second], of}, ""};
}

Tally::Tally(RuleId rule) : Tally(names_of_alternatives(rule)) {
  const auto standard = std::ranges::find(names_, rule_of(rule).standard);
  standard_ = static_cast<std::size_t>(standard - names_.begin());
}

void Tally::add(const std::vector<bool>& yields) {
  const auto count = std::count(yields.begin(), yields.end(), true);
  ++all_;
  if (count == 0) ++none_;
  if (count == 0 || count == static_cast<std::ptrdiff_t>(yields.size())) return;
  ++of_;
  for (std::size_t i = 0; i < yields.size(); ++i)
    if (yields[i]) ++agreeing_[i];
}

void Tally::add_all(const std::vector<Facts>& facts) {
  for (std::size_t i = 0; i < facts.front().size(); ++i) {
    std::vector<bool> yields;
    for (const Facts& alternative : facts) yields.push_back(alternative[i]);
    add(yields);
  }
}

Trait Tally::trait(TraitId id, None none) const {
  const std::size_t of = of_ + (none == None::counted ? none_ : 0);
  Trait trait = leading(std::move(id), names_, agreeing_, of, standard_);
  if (none_ > 0) trait.remark = fmt::format("nothing catalogued yields {} of {}", none_, all_);
  if (of > 0) return trait;
  if (none_ == 0) trait.remark = "no reported value distinguishes the alternatives";
  trait.runner_up.clear();
  trait.runner_up_rate = {};
  return trait;
}

Trait Tally::fitting(TraitId id) const {
  Trait found = trait(std::move(id), None::counted);
  const auto [agreeing, of] = found.rate;
  if (agreeing == of) return found;
  found.runner_up = found.alternative;
  found.runner_up_rate = found.rate;
  found.alternative = kNoneFits;
  found.rate = {of - agreeing, of};
  return found;
}

namespace {

constexpr std::size_t kFirstRound = 100;  // scenes
constexpr std::size_t kFinalists = 3;
constexpr std::size_t kEquals = 64;       // most that are named as good as the best
constexpr std::size_t kRivals = 2;        // per rule, compared with all scenes
constexpr std::size_t kRivalRound = 600;  // scenes by which rivals are chosen
constexpr int kCheapTarget = 32;          // pixels; scenes up to this size decide the rounds

struct Candidate {
  RuleChoices choice;
  Cause cause;  // the deviation from the start, one change per rule
  std::size_t agreeing = 0;
};

bool draws(const CoverageChoice& choice, const Observation& observation) {
  const auto primitives = primitives_of(observation.scene);
  return is_drawn_by(choice, primitives[0], observation);
}

OpenRules openness_of(RuleId rule) {
  if (rule == RuleId::line_width) return OpenRules::width;
  return rule == RuleId::sample_positions ? OpenRules::placement : OpenRules::coverage;
}

// The rules that matter, each with its alternatives other than the start's.
std::vector<Changes> open_rules(const InferenceQuestion& question, const Observation& observation) {
  const auto primitives = primitives_of(observation.scene);
  std::vector<Changes> rules =
      coverage_changes(coverage_traits(primitives[0], observation.scene.target), question.start);
  std::erase_if(rules, [&](const Changes& rule) {
    return openness_of(rule.front().id.rule) != question.open;
  });
  // Placements that do not move the samples are not alternatives.
  const auto places = [&](const RuleChoices& choice) {
    return positions_of(observation.scene.target, choice.of(question.kind), observation.positions);
  };
  for (Changes& rule : rules)
    if (question.open == OpenRules::placement)
      std::erase_if(rule, [&](const Change& change) {
        return places(change.applied_to(question.start)) == places(question.start);
      });
  std::erase_if(rules, [](const Changes& rule) { return rule.empty(); });
  return rules;
}

// Whether the candidate differs only in a rule that nothing uses.
bool is_idle(const Candidate& candidate, RuleId rule) {
  if (rule == RuleId::triangle_fill_rule)
    return !has_tie_rule(candidate.choice.triangles.triangle_algorithm);
  return rule == RuleId::line_diamond_exit &&
         !tests_diamonds(candidate.choice.lines.line.algorithm);
}

std::vector<Candidate> all_candidates(const InferenceQuestion& question,
                                      std::span<const Changes> rules) {
  std::vector<Candidate> candidates = {{question.start, {}, 0}};
  for (const Changes& rule : rules) {
    const std::size_t before = candidates.size();
    for (const Change& change : rule)
      for (std::size_t i = 0; i < before; ++i) {
        Candidate candidate = candidates[i];
        if (is_idle(candidate, change.id.rule)) continue;
        change.apply(candidate.choice);
        candidate.cause.parts.push_back(change.id);
        candidates.push_back(std::move(candidate));
      }
  }
  return candidates;
}

// Rounded rectangles of multisampled lines have their own grid, so their snap does not matter.
bool has_no_snap(const CoverageChoice& choice) {
  switch (choice.multisampled_line) {
    case MultisampledLine::snapped_offset:
    case MultisampledLine::snapped_offset_across_borders:
    case MultisampledLine::snapped_corners:
      return true;
    case MultisampledLine::rectangle:
    case MultisampledLine::parallelogram:
    case MultisampledLine::single_sampled:
      return false;
  }
  return false;
}

// The number of scenes that choices draw as observed; choices that draw alike are computed once.
class SceneCounts {
 public:
  SceneCounts(std::span<const Observation* const> scenes, PrimitiveKind kind,
              bool are_multisampled_lines)
      : scenes_(scenes), kind_(kind), are_multisampled_lines_(are_multisampled_lines) {}

  std::size_t of(const RuleChoices& choices) {
    CoverageChoice choice = choices.of(kind_);
    if (!are_multisampled_lines_ || !has_no_snap(choice)) return count(choice);
    choice.snap = {};
    const auto known = std::find_if(known_.begin(), known_.end(),
                                    [&](const auto& one) { return one.first == choice; });
    if (known != known_.end()) return known->second;
    return known_.emplace_back(choice, count(choice)).second;
  }

 private:
  std::size_t count(const CoverageChoice& choice) const {
    return static_cast<std::size_t>(
        std::count_if(scenes_.begin(), scenes_.end(),
                      [&](const Observation* scene) { return draws(choice, *scene); }));
  }

  std::span<const Observation* const> scenes_;
  PrimitiveKind kind_;
  bool are_multisampled_lines_;
  std::vector<std::pair<CoverageChoice, std::size_t>> known_;  // those without a snap
};

std::string kept_by(const RuleChoices& choice, RuleId rule) {
  return rule_of(rule).slot.kept(choice);
}

class Contest {
 public:
  Contest(const InferenceQuestion& question, std::span<const Observation* const> observations)
      : kind_(question.kind), start_(question.start) {
    for (const Observation* observation : observations)
      if (observation->failure.empty()) all_.push_back(observation);
    cheap_ = all_;
    std::erase_if(cheap_, [](const Observation* observation) {
      return observation->scene.target.width > kCheapTarget;
    });
    if (all_.empty()) return;
    are_multisampled_lines_ =
        question.kind == PrimitiveKind::line &&
        std::all_of(all_.begin(), all_.end(), [](const Observation* observation) {
          return is_multisampled(observation->scene.draws[0], observation->scene.target);
        });
    rules_ = open_rules(question, *all_.front());
    candidates_ = all_candidates(question, rules_);
  }

  Inference operator()() {
    if (all_.empty()) return {start_, {}, {}, {}};
    play_rounds();
    SceneCounts counts(all_, kind_, are_multisampled_lines_);
    for (Candidate& finalist : candidates_) finalist.agreeing = counts.of(finalist.choice);
    Candidate best = *std::min_element(candidates_.begin(), candidates_.end(), better);
    // A rival that does better on all scenes replaces the best. This ends, since the number of
    // agreeing scenes only grows.
    for (;;) {
      const std::vector<Candidate> rivals = rivals_of(best);
      const auto winner = std::min_element(rivals.begin(), rivals.end(), better);
      if (winner == rivals.end() || winner->agreeing <= best.agreeing) return report(best, rivals);
      best = *winner;
    }
  }

 private:
  using Scenes = std::vector<const Observation*>;

  static bool better(const Candidate& a, const Candidate& b) {
    if (a.agreeing != b.agreeing) return a.agreeing > b.agreeing;
    return a.cause.size() < b.cause.size();
  }

  void play_rounds() {
    std::size_t from = 0;
    for (std::size_t size = kFirstRound; candidates_.size() > kFinalists && from < cheap_.size();
         size *= 2) {
      const auto scenes = std::span(cheap_).subspan(from, std::min(size, cheap_.size() - from));
      SceneCounts counts(scenes, kind_, are_multisampled_lines_);
      for (Candidate& candidate : candidates_) candidate.agreeing += counts.of(candidate.choice);
      std::stable_sort(candidates_.begin(), candidates_.end(), better);
      candidates_.resize(std::max(kFinalists, candidates_.size() / 3));
      from += scenes.size();
    }
    std::stable_sort(candidates_.begin(), candidates_.end(), better);
    for (const Candidate& candidate : candidates_)
      if (candidate.agreeing == candidates_.front().agreeing && equals_.size() < kEquals)
        equals_.push_back(candidate.choice);
    candidates_.resize(std::min(candidates_.size(), kFinalists));
  }

  // For each rule the best other alternatives, with all other rules as in `best`.
  std::vector<Candidate> rivals_of(const Candidate& best) const {
    std::vector<Candidate> rivals;
    const auto some = std::span(all_).first(std::min(kRivalRound, all_.size()));
    SceneCounts counts_of_some(some, kind_, are_multisampled_lines_);
    SceneCounts counts_of_all(all_, kind_, are_multisampled_lines_);
    for (const Changes& rule : rules_) {
      const RuleId id = rule.front().id.rule;
      if (is_idle(best, id)) continue;
      std::vector<Candidate> others = others_of(best, rule, id);
      for (Candidate& other : others) other.agreeing = counts_of_some.of(other.choice);
      std::stable_sort(others.begin(), others.end(), better);
      if (others.size() > kRivals) others.resize(kRivals);
      for (Candidate& other : others) {
        other.agreeing = counts_of_all.of(other.choice);
        rivals.push_back(std::move(other));
      }
    }
    return rivals;
  }

  // The alternatives of a rule other than that of `best`, including the start's own.
  std::vector<Candidate> others_of(const Candidate& best, const Changes& rule, RuleId id) const {
    Candidate without = best;
    std::erase_if(without.cause.parts, [&](AlternativeId part) { return part.rule == id; });
    std::vector<Candidate> others;
    const auto has = [](const Candidate& candidate, const Change& change) {
      return std::ranges::find(candidate.cause.parts, change.id) != candidate.cause.parts.end();
    };
    if (without.cause.size() != best.cause.size()) {
      without.choice = start_;
      for (const Changes& all : rules_)
        for (const Change& change : all)
          if (has(without, change)) change.apply(without.choice);
      others.push_back(without);
    }
    for (const Change& change : rule) {
      if (has(best, change)) continue;
      Candidate other = without;
      other.choice = best.choice;
      change.apply(other.choice);
      other.cause.parts.push_back(change.id);
      others.push_back(std::move(other));
    }
    return others;
  }

  Inference report(const Candidate& best, std::span<const Candidate> rivals) const {
    Inference result{best.choice, {best.agreeing, all_.size()}, {}, equals_};
    for (const Changes& rule : rules_) {
      const RuleId id = rule.front().id.rule;
      if (is_idle(best, id)) continue;
      InferredRule inferred{id, kept_by(best.choice, id), result.rate, "", {}};
      const Candidate* runner_up = nullptr;
      for (const Candidate& rival : rivals)
        if (kept_by(rival.choice, id) != inferred.alternative &&
            (runner_up == nullptr || better(rival, *runner_up)))
          runner_up = &rival;
      if (runner_up != nullptr) {
        inferred.runner_up = kept_by(runner_up->choice, id);
        inferred.runner_up_rate = {runner_up->agreeing, all_.size()};
      }
      result.rules.push_back(std::move(inferred));
    }
    return result;
  }

  Scenes all_;
  Scenes cheap_;
  bool are_multisampled_lines_ = false;
  PrimitiveKind kind_;
  RuleChoices start_;
  std::vector<Changes> rules_;
  std::vector<Candidate> candidates_;
  std::vector<RuleChoices> equals_;
};

}  // namespace

Inference infer(const InferenceQuestion& question,
                std::span<const Observation* const> observations) {
  return Contest(question, observations)();
}

}  // namespace edgecase
