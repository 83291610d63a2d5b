// SPDX-License-Identifier: MIT
#include "results/standing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/threads.h"
#include "model/text.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using Faults = std::span<const KnownFault* const>;

// How far a driver's faults account for an answer.
struct Accounted {
  std::vector<const KnownFault*> by;  // in the file's order
  std::size_t differences = 0;        // that need a fault
  std::size_t open = 0;               // of them, without one
};

// True if a fault must account for the answer.
bool is_forbidden(const ResultOutline& answer) {
  if (answer.again) return false;
  if (answer.failure) return answer.failure->kind != FailureKind::unsupported;
  return answer.verdict >= Verdict::contested;
}

// A difference counts for the first fault of the file that fits.
Accounted account(const CaseResults& one, const Result& result, Faults faults) {
  Accounted accounted;
  const auto take = [&](std::size_t differences, const auto& difference_fits) {
    accounted.differences += differences;
    const auto found = std::ranges::find_if(faults, difference_fits);
    if (found == faults.end())
      accounted.open += differences;
    else if (std::ranges::find(accounted.by, *found) == accounted.by.end())
      accounted.by.push_back(*found);
  };
  if (result.failure)
    take(1, [&](const KnownFault* fault) {
      return accounts_for(*fault, one.id, one.surface, *result.failure);
    });
  const auto take_class = [&](const DisagreementClass& d, std::size_t differences) {
    if (needs_fault(result, d))
      take(differences, [&](const KnownFault* fault) {
        return accounts_for(*fault, one.id, one.surface, result, d);
      });
  };
  for (const Disagreement& d : result.disagreements) take_class(d, 1);
  for (const CountedDisagreements& counted : result.counted) take_class(counted, counted.count());
  return accounted;
}

void set_standing(ResultOutline& answer, Standing standing, std::string standing_reason) {
  answer.standing = standing;
  answer.standing_reason = std::move(standing_reason);
}

// For an answer for which a fault must account.
void set_by_faults(ResultOutline& answer, const Accounted& accounted) {
  std::vector<std::string> reasons;
  for (const KnownFault* fault : accounted.by) {
    answer.faults.push_back(fault->id);
    reasons.push_back(fmt::format("{} ({})", fault->reason, fault->id));
  }
  const std::string known = fmt::format("{}", fmt::join(reasons, "; "));
  if (accounted.open == 0 && !known.empty()) return set_standing(answer, Standing::known, known);
  if (answer.failure) return set_standing(answer, Standing::unexpected, "no known fault is this");
  std::string text = fmt::format("no known fault accounts for {} of {}", accounted.open,
                                 counted(accounted.differences, "difference", "differences"));
  if (accounted.open == accounted.differences) text = "no known fault accounts for this";
  set_standing(answer, Standing::unexpected, known.empty() ? text : text + "; known: " + known);
}

// `accounted` looks into the answer, where a fault must account for it.
template <class Look>
void set_standing(ResultOutline& answer, Latitude latitude, const Look& accounted) {
  answer.faults.clear();
  if (answer.again)
    return set_standing(answer, Standing::flake,
                        fmt::format("it answered {}, and when asked again {}",
                                    describe(judgement_of(answer)), describe(*answer.again)));
  if (!is_forbidden(answer))
    return answer.failure ? set_standing(answer, Standing::tolerated, "not supported")
                          : set_standing(answer, Standing::expected, "");
  if (latitude == Latitude::none && !answer.failure)
    return set_standing(answer, Standing::unexpected, "no latitude is granted");
  set_by_faults(answer, accounted());
  if (answer.verdict == Verdict::contested && answer.standing == Standing::unexpected)
    answer.standing = Standing::tolerated;
}

FaultState state_of(const FaultSeen& seen) {
  if (seen.cases == 0) return FaultState::fixed;
  if (!seen.before) return FaultState::uncounted;
  if (seen.cases == *seen.before) return FaultState::known;
  return seen.cases > *seen.before ? FaultState::grown : FaultState::shrunk;
}

void add_faults_seen(Faults faults, std::size_t index, Results& results) {
  const RendererInfo& info = results.renderers[index];
  const Release release = release_of(info);
  for (const KnownFault* fault : faults) {
    FaultSeen seen{info.name, fault->id,    fault->reason,    fault->link,
                   0,         std::nullopt, FaultState::known};
    for (const CaseOutline& one : results.cases.outlines())
      if (std::ranges::find(one.answers[index].faults, fault->id) !=
          one.answers[index].faults.end())
        ++seen.cases;
    if (const auto found = fault->cases_on.find(text_of(release)); found != fault->cases_on.end())
      seen.before = found->second;
    const bool is_all = is_whole(results) && !is_partial(results, index, *fault);
    if (is_all || (is_whole(results) && seen.cases > seen.before.value_or(0)))
      seen.state = state_of(seen);
    // OpenGL ES does not support many cases, and has faults of its own.
    const bool is_elsewhere = !seen.before && (release.is_es || is_of_es_alone(*fault));
    const bool is_missed = seen.cases == 0 && (!is_all || is_elsewhere);
    if (!is_missed) results.faults.push_back(std::move(seen));
  }
}

}  // namespace

std::string describe(const Judgement& answer) {
  return answer.fingerprint.empty()
             ? std::string(name_of(answer.verdict))
             : fmt::format("{} {}", name_of(answer.verdict), answer.fingerprint);
}

void apply_known_faults(Results& results, std::span<const KnownFaults> known) {
  results.faults.clear();
  for (std::size_t r = 0; r < results.renderers.size(); ++r) {
    const KnownFaults* own = faults_about(known, results.renderers[r]);
    std::vector<const KnownFault*> faults;
    if (own != nullptr) faults = faults_of(*own, results.renderers[r]);
    for_each_index(results.cases.size(), [&](std::size_t i) {
      set_standing(results.cases.answer(i, r), results.latitude, [&] {
        const CaseResults one = results.cases[i];
        return account(one, one.results[r], faults);
      });
    });
    if (results.latitude == Latitude::opengl) add_faults_seen(faults, r, results);
  }
}

Standing standing_of(const CaseResults& one, Result result, Faults faults, Latitude latitude) {
  set_standing(result, latitude, [&] { return account(one, result, faults); });
  return result.standing;
}

void hold_contested(Results& results) {
  for (std::size_t i = 0; i < results.cases.size(); ++i)
    for (std::size_t r = 0; r < results.renderers.size(); ++r) {
      ResultOutline& answer = results.cases.answer(i, r);
      if (answer.verdict == Verdict::contested && answer.standing == Standing::tolerated)
        answer.standing = Standing::unexpected;
    }
}

std::vector<const KnownFault*> faults_behind(const CaseResults& one, const Result& result,
                                             Faults faults) {
  return is_forbidden(result) ? account(one, result, faults).by : std::vector<const KnownFault*>();
}

bool is_partial(const Results& results, std::size_t renderer, const KnownFault& fault) {
  std::size_t named = 0;
  std::size_t unsupported = 0;
  for (const CaseOutline& one : results.cases.outlines()) {
    const auto names = [&](const std::string& name) { return names_case(name, one.id); };
    const bool is_there = fault.surface.empty() || fault.surface == one.surface;
    if (!is_there || std::ranges::none_of(fault.cases, names)) continue;
    const auto& failure = one.answers[renderer].failure;
    ++named;
    if (failure && failure->kind == FailureKind::unsupported) ++unsupported;
  }
  const auto found = fault.cases_on.find(text_of(release_of(results.renderers[renderer])));
  const std::size_t before = found == fault.cases_on.end() ? 1 : found->second;
  return unsupported + before > named && unsupported > 0;
}

std::string shortest_case_with(const Results& results, const std::string& renderer,
                               const std::string& fault) {
  const auto at = std::ranges::find(results.renderers, renderer, &RendererInfo::name);
  if (at == results.renderers.end()) return "";
  const auto index = static_cast<std::size_t>(at - results.renderers.begin());
  std::string shortest;
  for (const CaseOutline& one : results.cases.outlines()) {
    if (!shortest.empty() && one.id.size() >= shortest.size()) continue;
    const std::vector<std::string>& faults = one.answers[index].faults;
    if (std::ranges::find(faults, fault) != faults.end()) shortest = one.id;
  }
  return shortest;
}

bool has_grown(const Results& results) {
  return std::ranges::any_of(results.faults,
                             [](const FaultSeen& seen) { return seen.state == FaultState::grown; });
}

const KnownFaults* faults_about(std::span<const KnownFaults> known, const RendererInfo& info) {
  const auto found = std::ranges::find(known, driver_of(info), &KnownFaults::driver);
  return found != known.end() ? &*found : nullptr;
}

bool needs_fault(const Result& result, const DisagreementClass& d) {
  return d.legality == Legality::illegal ||
         (result.verdict == Verdict::contested && d.legality == Legality::contested);
}

std::string reason_from(const Result& result) {
  if (result.failure)
    return fmt::format("{}: {}", name_of(result.failure->kind), result.failure->reason);
  std::set<std::string> rules;
  std::set<std::string> causes;
  std::set<int> broken;
  for_each_class(result, [&](const DisagreementClass& d) {
    rules.insert(name_of(d.rule));
    causes.insert(text_of(d.cause));
    if (!is_legal(d)) broken.insert(d.ruling);
  });
  const std::size_t count = count_disagreements(result);
  const bool unexplained = causes.erase("") > 0;
  std::string text;
  if (!rules.empty())
    text = fmt::format("{} by {}",
                       count == 1 ? "one difference" : fmt::format("{} differences", count),
                       fmt::join(rules, ", "));
  if (!broken.empty()) text += fmt::format(", against ruling {}", fmt::join(broken, ", "));
  if (!causes.empty()) text += fmt::format("; it follows {}", fmt::join(causes, " and "));
  if (unexplained)
    text += causes.empty() ? "; no catalogued alternative draws this"
                           : "; some follow no catalogued alternative";
  for (const ValueAggregate& values : result.values)
    text += values.cause.empty()
                ? fmt::format("{}{} rounded otherwise than exactly, within what is permitted",
                              text.empty() ? "" : "; ", values.attribute)
                : fmt::format("{}{} by {}", text.empty() ? "" : "; ", values.attribute,
                              text_of(values.cause));
  return text;
}

}  // namespace edgecase
