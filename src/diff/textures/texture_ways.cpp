// SPDX-License-Identifier: MIT
#include "diff/textures/texture_ways.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

#include "rules/all_rules.h"
#include "rules/change_search.h"

namespace edgecase {
namespace {

RuleChoices with_textures(const TextureChoice& choice) {
  RuleChoices choices;
  choices.textures = choice;
  return choices;
}

TextureChoice applied(const TextureChoice& choice, const Change& change) {
  return change.applied_to(with_textures(choice)).textures;
}

TextureWay changed(const TextureWay& way, const Change& change) {
  const TextureChoice choice = applied(way.choice, change);
  return {choice, way.cause + change.id, illegal_part(choice).empty()};
}

// True if any of the lookups can distinguish the two.
bool differ(const TextureChoice& a, const TextureChoice& b, std::span<const LookupKinship> kinds) {
  return std::ranges::any_of(kinds, [&](const LookupKinship& kin) {
    return relevant_part(a, kin) != relevant_part(b, kin);
  });
}

// Every alternative of every rule of a lookup that any of the lookups can distinguish from those of
// `chosen`.
Changes shown_changes(const TextureChoice& chosen, std::span<const LookupKinship> kinds) {
  Changes changes = changes_beside(lookup_rules(), with_textures(chosen));
  std::erase_if(changes, [&](const Change& change) {
    return !differ(applied(chosen, change), chosen, kinds);
  });
  return changes;
}

std::vector<TextureWay> singles_beside(const TextureWay& way, const Changes& changes) {
  std::vector<TextureWay> singles;
  for (const Change& change : changes) singles.push_back(changed(way, change));
  return singles;
}

// All pairs of these changes, which alone make `singles`, in which one shows beside the other.
std::vector<TextureWay> shown_pairs(const Changes& changes, const std::vector<TextureWay>& singles,
                                    std::span<const LookupKinship> kinds) {
  std::vector<TextureWay> pairs;
  for_each_pair(changes, [&](std::size_t i, std::size_t j) {
    TextureWay pair = changed(singles[i], changes[j]);
    if (differ(pair.choice, singles[i].choice, kinds) &&
        differ(pair.choice, singles[j].choice, kinds))
      pairs.push_back(std::move(pair));
  });
  return pairs;
}

// The changes from the policy to the profile that lookups can distinguish.
Changes steps_towards(const TextureChoice& chosen, const TextureChoice& profile,
                      std::span<const LookupKinship> kinds) {
  Changes steps;
  for (const RuleId rule : lookup_rules()) {
    const auto step = change_between(rule, with_textures(chosen), with_textures(profile));
    if (!step) continue;
    const auto back = change_between(rule, with_textures(profile), with_textures(chosen));
    if (differ(applied(chosen, *step), chosen, kinds) ||
        differ(profile, applied(profile, *back), kinds))
      steps.push_back(*step);
  }
  return steps;
}

// The ways between the policy and the profile: every set of these changes, the smallest first.
// There are at most ten rules.
std::vector<TextureWay> ways_by(const Changes& steps, const TextureWay& own) {
  std::vector<TextureWay> ways;
  for (unsigned set = 1; set < 1u << steps.size(); ++set) {
    TextureWay way = own;
    for (std::size_t i = 0; i < steps.size(); ++i)
      if ((set >> i & 1u) != 0) way = changed(way, steps[i]);
    ways.push_back(std::move(way));
  }
  std::stable_sort(ways.begin(), ways.end(), [](const TextureWay& a, const TextureWay& b) {
    return a.cause.size() < b.cause.size();
  });
  return ways;
}

constexpr std::size_t kSample = 48;

// One search in one case.
class Search {
 public:
  explicit Search(const WaySearchLookups& lookups)
      : lookups_(lookups), agreeing_(sample_of(lookups.agreeing, kSample)), open_(lookups.others) {
    std::iota(open_.begin(), open_.end(), std::size_t{0});
  }

  std::vector<std::optional<TextureWay>> run(const std::vector<std::vector<TextureWay>>& tiers) {
    std::vector<std::optional<TextureWay>> result(lookups_.others);
    while (first_ < open_.size()) {
      const TextureWay* best = best_way(tiers);
      if (best == nullptr) {
        ++first_;  // nothing explains it
        continue;
      }
      open_.erase(open_.begin(), open_.begin() + static_cast<std::ptrdiff_t>(first_));
      first_ = 0;
      std::erase_if(open_, [&](std::size_t index) {
        const bool found = explains(*best, index);
        if (found) result[index] = *best;
        return found;
      });
    }
    return result;
  }

 private:
  // How well a way fits: how many lookups it explains, how many of the agreeing ones it yields, and
  // whether it is open.
  using Fit = std::tuple<std::ptrdiff_t, std::ptrdiff_t, bool>;

  bool explains(const TextureWay& way, std::size_t index) const {
    return lookups_.yields(index, way.choice);
  }

  Fit fit_of(const TextureWay& way, const std::vector<std::size_t>& sample) const {
    const auto explained = std::ranges::count_if(
        sample, [&](std::size_t place) { return explains(way, open_[first_ + place]); });
    const auto agreeing = std::ranges::count_if(
        agreeing_, [&](std::size_t index) { return lookups_.agrees(index, way.choice); });
    return {explained, agreeing, way.open};
  }

  const TextureWay* best_of(const std::vector<TextureWay>& tier,
                            const std::vector<std::size_t>& sample, Fit& best_fit) const {
    const Fit whole{std::ssize(sample), std::ssize(agreeing_), true};
    const TextureWay* best = nullptr;
    for (const TextureWay& way : tier) {
      if (!explains(way, open_[first_])) continue;
      const Fit fit = fit_of(way, sample);
      if (best != nullptr && fit <= best_fit) continue;
      best = &way;
      best_fit = fit;
      if (fit == whole) break;  // no later one fits better
    }
    return best;
  }

  // The best way for the first lookup that is still open.
  const TextureWay* best_way(const std::vector<std::vector<TextureWay>>& tiers) {
    const std::vector<std::size_t> sample = sample_of(open_.size() - first_, kSample);
    const TextureWay* best = nullptr;
    std::ptrdiff_t most = 0;
    for (std::size_t tier = 0; tier < tiers.size(); ++tier) {
      if (most == std::ssize(sample)) break;
      if (tier + 1 == tiers.size() && !may_try_pairs()) break;
      Fit fit;
      const TextureWay* found = best_of(tiers[tier], sample, fit);
      if (found == nullptr || std::get<0>(fit) <= 2 * most) continue;
      best = found;
      most = std::get<0>(fit);
    }
    return best;
  }

  // A search among all pairs is expensive: it is tried only a limited number of times per case.
  bool may_try_pairs() {
    constexpr int kMost = 8;
    return pair_searches_++ < kMost;
  }

  const WaySearchLookups& lookups_;
  std::vector<std::size_t> agreeing_;
  std::vector<std::size_t> open_;  // from first_ on
  std::size_t first_ = 0;
  int pair_searches_ = 0;
};

}  // namespace

Cause illegal_part(const TextureChoice& choice) {
  Cause cause;
  for (const RuleId rule : lookup_rules()) {
    const AlternativeId id = alternative_id(rule, rule_of(rule).slot.kept(with_textures(choice)));
    if (!is_open_choice(id)) cause.parts.push_back(id);
  }
  return cause;
}

std::vector<std::size_t> sample_of(std::size_t count, std::size_t most) {
  constexpr std::size_t kScatter = 40503;
  const std::size_t taken = std::min(count, most);
  std::vector<std::size_t> sample;
  for (std::size_t i = 0; i < taken; ++i) {
    const std::size_t begin = i * count / taken;
    const std::size_t stretch = (i + 1) * count / taken - begin;
    sample.push_back(begin + i * kScatter / 16 % stretch);
  }
  return sample;
}

TextureWaySearch::TextureWaySearch(const TextureChoice& chosen, const TextureChoice* profile,
                                   std::span<const LookupKinship> kinds) {
  const TextureWay own{chosen, {}, illegal_part(chosen).empty()};
  const Changes changes = shown_changes(chosen, kinds);
  tiers_.push_back(singles_beside(own, changes));
  const Changes steps = profile != nullptr ? steps_towards(chosen, *profile, kinds) : Changes{};
  if (!steps.empty()) {
    tiers_.push_back(ways_by(steps, own));
    const TextureWay whole = tiers_.back().back();
    Changes further = shown_changes(whole.choice, kinds);
    std::erase_if(further, [&](const Change& change) {
      return std::ranges::any_of(
          steps, [&](const Change& step) { return step.id.rule == change.id.rule; });
    });
    tiers_.push_back(singles_beside(whole, further));
  }
  tiers_.push_back(shown_pairs(changes, tiers_.front(), kinds));
}

std::vector<std::optional<TextureWay>> TextureWaySearch::explain(
    const WaySearchLookups& lookups) const {
  return Search(lookups).run(tiers_);
}

std::vector<Cause> TextureWaySearch::common(const WaySearchLookups& lookups) const {
  const std::vector<std::size_t> others = sample_of(lookups.others, kSample);
  const std::vector<std::size_t> agreeing = sample_of(lookups.agreeing, kSample);
  std::vector<Cause> common;
  for (const TextureWay& way : tiers_.front())
    if (std::ranges::all_of(others, [&](auto i) { return lookups.yields(i, way.choice); }) &&
        std::ranges::all_of(agreeing, [&](auto i) { return lookups.agrees(i, way.choice); }))
      common.push_back(way.cause);
  return common;
}

}  // namespace edgecase
