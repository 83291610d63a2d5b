// SPDX-License-Identifier: MIT
#include "suite/core_suite.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <thread>
#include <tuple>
#include <utility>

#include "base/threads.h"
#include "rules/all_rules.h"
#include "suite/separation.h"

namespace edgecase {
namespace {

// A pair of alternatives, or a rule alone for its rulings: then both places are equal.
using Goal = AlternativePair;

bool has_ruling_in_force(const Rule& rule) {
  return std::ranges::any_of(rule.rulings,
                             [](const Ruling& ruling) { return ruling.source.withdrawn.empty(); });
}

std::vector<Goal> goals_of(const Case& one) {
  std::vector<Goal> goals = pairs_told_apart(one);
  const std::set<std::string> named(one.rules.begin(), one.rules.end());
  for (const std::string& id : named)
    if (const Rule* rule = find_rule(id); rule != nullptr && has_ruling_in_force(*rule))
      goals.push_back({rule->id, 0, 0});
  return goals;
}

// A case's goals by number.
using Reached = std::vector<std::vector<std::size_t>>;

Reached numbered(const std::vector<std::vector<Goal>>& of_cases, std::vector<Goal>& goals) {
  std::map<Goal, std::size_t> numbers;
  Reached reached(of_cases.size());
  for (std::size_t i = 0; i < of_cases.size(); ++i)
    for (const Goal& goal : of_cases[i]) {
      const auto [at, is_new] = numbers.try_emplace(goal, numbers.size());
      if (is_new) goals.push_back(goal);
      reached[i].push_back(at->second);
    }
  return reached;
}

std::vector<std::vector<Goal>> goals_of_all(const CaseStore& cases) {
  std::vector<std::vector<Goal>> goals(cases.size());
  std::atomic<std::size_t> next = 0;
  run_threads(std::max(1U, std::thread::hardware_concurrency()), [&](std::size_t) {
    for (std::size_t i = next++; i < cases.size(); i = next++) goals[i] = goals_of(cases[i]);
  });
  return goals;
}

// Cases of at most 64 x 64 pixels are light: thousands are drawn in a second.
bool is_light(const CaseStore& cases, std::size_t i) {
  constexpr std::size_t kMostWeight = 64 * 64 + 256;
  return cases.weight(i) <= kMostWeight;
}

// How many cases must reach each goal: `times`, or all light ones, or all where none is light.
std::vector<std::size_t> demands_of(const CaseStore& cases, const Reached& reached,
                                    std::size_t goals, std::size_t times) {
  std::vector<std::size_t> all(goals);
  std::vector<std::size_t> light(goals);
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const std::size_t goal : reached[i]) {
      ++all[goal];
      if (is_light(cases, i)) ++light[goal];
    }
  for (std::size_t goal = 0; goal < goals; ++goal)
    all[goal] = std::min(light[goal] > 0 ? light[goal] : all[goal], times);
  return all;
}

// Takes the case that reaches the most open goals, a light one if any reaches some, until none is
// open. The open goals of a case only become fewer, so an old count that is still the largest need
// not be compared with others.
std::vector<std::size_t> greedy_cover(const CaseStore& cases, const Reached& reached,
                                      std::vector<std::size_t> open) {
  const auto gain = [&](std::size_t i) {
    return static_cast<std::size_t>(
        std::ranges::count_if(reached[i], [&](std::size_t goal) { return open[goal] > 0; }));
  };
  // Is it light, how much it gains, and two numbers that are smaller for a larger weight and place:
  // the largest is the best.
  using Offer = std::tuple<bool, std::size_t, std::size_t, std::size_t>;
  constexpr std::size_t kMost = static_cast<std::size_t>(-1);
  const auto offer = [&](std::size_t i) -> Offer {
    const std::size_t gained = gain(i);
    return {gained > 0 && is_light(cases, i), gained, kMost - cases.weight(i), kMost - i};
  };
  std::set<Offer> offers;
  for (std::size_t i = 0; i < reached.size(); ++i) offers.insert(offer(i));
  std::vector<std::size_t> taken;
  while (!offers.empty()) {
    const auto best = std::prev(offers.end());
    const std::size_t i = kMost - std::get<3>(*best);
    const Offer now = offer(i);
    const bool is_current = now == *best;
    offers.erase(best);
    if (std::get<1>(now) == 0) continue;
    if (!is_current) {
      offers.insert(now);
      continue;
    }
    taken.push_back(i);
    for (const std::size_t goal : reached[i])
      if (open[goal] > 0) --open[goal];
  }
  return taken;
}

// Drops cases without which the demands are met as well, those taken last first.
void drop_needless(const Reached& reached, const std::vector<std::size_t>& demands,
                   std::vector<std::size_t>& taken) {
  std::vector<std::size_t> met(demands.size());
  for (const std::size_t i : taken)
    for (const std::size_t goal : reached[i]) ++met[goal];
  for (std::size_t at = taken.size(); at-- > 0;) {
    const auto& goals = reached[taken[at]];
    if (std::ranges::any_of(goals, [&](std::size_t t) { return met[t] == demands[t]; })) continue;
    for (const std::size_t goal : goals) --met[goal];
    taken.erase(taken.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

// The demands of goals no two of which any case reaches together add up. Goals that few cases
// reach are chosen first.
std::size_t lower_bound_of(const Reached& reached, const std::vector<std::size_t>& demands) {
  std::vector<std::vector<std::size_t>> reaching(demands.size());
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const std::size_t goal : reached[i]) reaching[goal].push_back(i);
  std::vector<std::size_t> order(demands.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::stable_sort(order, {}, [&](std::size_t t) { return reaching[t].size(); });
  std::vector<bool> used(reached.size());
  std::size_t bound = 0;
  for (const std::size_t goal : order) {
    if (std::ranges::any_of(reaching[goal], [&](std::size_t i) { return used[i]; })) continue;
    for (const std::size_t i : reaching[goal]) used[i] = true;
    bound += demands[goal];
  }
  return bound;
}

}  // namespace

CoreSuite find_core(const CaseStore& cases, std::size_t times) {
  std::vector<Goal> goals;
  const Reached reached = numbered(goals_of_all(cases), goals);
  const std::vector<std::size_t> demands = demands_of(cases, reached, goals.size(), times);
  std::vector<std::size_t> taken = greedy_cover(cases, reached, demands);
  drop_needless(reached, demands, taken);
  CoreSuite core;
  for (const std::size_t i : taken) core.ids.push_back(cases.id(i));
  std::ranges::sort(core.ids);
  std::set<RuleId> named;
  for (const Goal& goal : goals)
    if (goal.later == goal.earlier) named.insert(goal.rule);
  core.rules = named.size();
  core.pairs = goals.size() - named.size();
  core.fewest = lower_bound_of(reached, demands);
  for (const Rule& rule : all_rules())
    if (has_ruling_in_force(rule) && !named.contains(rule.id))
      core.unnamed.push_back(name_of(rule.id));
  return core;
}

std::size_t add_shown(const Results& results, std::vector<std::string>& ids) {
  // By renderer and known fault, or "" for any violation: the first case, and whether one is
  // listed.
  struct Shown {
    std::string first;
    bool is_listed = false;
  };
  std::map<std::pair<std::size_t, std::string>, Shown> shown;
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const CaseOutline& one = results.cases.outline(i);
    const bool is_listed = std::ranges::binary_search(ids, one.id);
    for (std::size_t r = 0; r < one.answers.size(); ++r) {
      const ResultOutline& answer = one.answers[r];
      std::vector<std::string> of = answer.faults;
      if (of.empty() && answer.verdict == Verdict::violation) of.emplace_back();
      for (const std::string& fault : of) {
        Shown& known = shown[{r, fault}];
        if (known.first.empty()) known.first = one.id;
        known.is_listed = known.is_listed || is_listed;
      }
    }
  }
  const std::size_t before = ids.size();
  for (const auto& [fault, known] : shown)
    if (!known.is_listed && std::ranges::find(ids, known.first) == ids.end())
      ids.push_back(known.first);
  std::ranges::sort(ids);
  return ids.size() - before;
}

}  // namespace edgecase
