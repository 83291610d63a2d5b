// SPDX-License-Identifier: MIT
#include "results/blessing.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "results/standing.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

using Counts = std::map<std::string, std::size_t>;  // by id of a fault: cases

// The key of new faults.
struct Subject {
  RuleId rule = RuleId::none;  // where no cause explains the difference
  std::string cause;           // text
  std::string failure;         // kind, of an answer that did not come
  friend auto operator<=>(const Subject&, const Subject&) = default;
};

// Differences of one subject without a known fault.
struct Gathered {
  Cause cause;
  std::set<RuleId> rules;
  std::set<std::string> kinds;
  std::set<std::string> surfaces;
  std::set<std::string> cases;  // ids
  std::set<std::string> files;  // of cases that show it and are not wanted
  std::string reason;           // that the first of them gives
};

// The name of a case's file: "lines/short/ends" of "lines/short/ends:dx=1".
std::string file_of(const std::string& id) {
  return id.substr(0, id.find(':'));
}

class Blessing {
 public:
  Blessing(const Results& results, std::size_t index, const KnownFaults& current,
           const BlessingOptions& options)
      : results_(results),
        index_(index),
        current_(current),
        options_(options),
        info_(results.renderers[index]),
        release_(release_of(info_)),
        after_(current.faults.begin(), current.faults.end()) {}

  std::vector<FaultChange> operator()() {
    for (std::size_t i = 0; i < results_.cases.size(); ++i) gather(i);
    std::vector<KnownFault> added;
    for (const auto& [subject, gathered] : largest_first())
      if (!widen(subject, *gathered)) added.push_back(new_fault(subject, *gathered));
    if (is_whole(results_) && !options_.is_wanted) count(added);
    return changes(std::move(added));
  }

 private:
  bool is_accounted(const CaseResults& one, const Result& result,
                    const DisagreementClass& d) const {
    return std::ranges::any_of(faults_of(current_, info_), [&](const KnownFault* fault) {
      return accounts_for(*fault, one.id, one.surface, result, d);
    });
  }

  void gather(std::size_t at) {
    const ResultOutline& answer = results_.cases.outline(at).answers[index_];
    if (answer.standing != Standing::unexpected) return;
    // A renderer that was unavailable shows nothing about the driver, and neither does a fault of
    // ours.
    if (answer.failure && (answer.failure->kind == FailureKind::unavailable ||
                           answer.failure->kind == FailureKind::internal))
      return;
    const CaseResults one = results_.cases[at];
    const Result& result = one.results[index_];
    if (result.failure) {
      const char* kind = name_of(result.failure->kind);
      add(one, result, {RuleId::none, "", kind}, kind);
    }
    for_each_class(result, [&](const DisagreementClass& d) {
      if (needs_fault(result, d) && !is_accounted(one, result, d))
        if (Gathered* gathered =
                add(one, result, {d.cause.empty() ? d.rule : RuleId::none, text_of(d.cause), ""},
                    name_of(d.kind))) {
          gathered->cause = d.cause;
          gathered->rules.insert(d.rule);
        }
    });
  }

  // Null if the case is not wanted.
  Gathered* add(const CaseResults& one, const Result& result, const Subject& subject,
                const char* kind) {
    Gathered& gathered = gathered_[subject];
    if (options_.is_wanted && !options_.is_wanted(one.id)) {
      gathered.files.insert(file_of(one.id));
      return nullptr;
    }
    if (gathered.cases.empty()) gathered.reason = reason_from(result);
    gathered.kinds.insert(kind);
    gathered.surfaces.insert(one.surface);
    gathered.cases.insert(one.id);
    return &gathered;
  }

  // The subjects of wanted cases, those of most cases first.
  std::vector<std::pair<Subject, const Gathered*>> largest_first() const {
    std::vector<std::pair<Subject, const Gathered*>> sorted;
    for (const auto& [subject, gathered] : gathered_)
      if (!gathered.cases.empty()) sorted.emplace_back(subject, &gathered);
    std::ranges::stable_sort(sorted, std::greater(),
                             [](const auto& item) { return item.second->cases.size(); });
    return sorted;
  }

  // The same fault in another release: its versions then hold this one, too.
  bool widen(const Subject& subject, const Gathered& gathered) {
    for (KnownFault& fault : after_) {
      const bool same = fault.is_failure() == !subject.failure.empty() && fault.versions &&
                        (fault.is_failure() || accounts(fault, gathered)) &&
                        fault.versions->product == release_.product &&
                        std::ranges::all_of(gathered.cases, [&](const std::string& id) {
                          return std::ranges::any_of(fault.cases, [&](const std::string& name) {
                            return names_case(name, id);
                          });
                        });
      if (!same || holds(*fault.versions, release_)) continue;
      if (is_before(release_.numbers, fault.versions->low))
        fault.versions->low = release_.numbers;
      else
        fault.versions->high.clear();
      return true;
    }
    return false;
  }

  // True if the fault is about these rules and this cause.
  static bool accounts(const KnownFault& fault, const Gathered& gathered) {
    return (!fault.cause || *fault.cause == gathered.cause) &&
           (fault.rules.empty() ||
            std::ranges::includes(std::set(fault.rules.begin(), fault.rules.end()),
                                  gathered.rules));
  }

  // "line.diamond-exit" or, if that is taken, "line.diamond-exit-2".
  std::string free_id(const Subject& subject) {
    const std::string base = !subject.failure.empty() ? subject.failure
                             : subject.cause.empty()  ? name_of(subject.rule)
                                                      : subject.cause;
    std::string id = base;
    const auto is_taken = [&] {
      return ids_.contains(id) || std::ranges::find(after_, id, &KnownFault::id) != after_.end();
    };
    for (int i = 2; is_taken(); ++i) id = fmt::format("{}-{}", base, i);
    ids_.insert(id);
    return id;
  }

  // The files of the cases; of a file with cases that are not wanted, the cases.
  static std::vector<std::string> names_of(const Gathered& gathered) {
    std::set<std::string> names;
    for (const std::string& id : gathered.cases)
      names.insert(gathered.files.contains(file_of(id)) ? id : file_of(id));
    return {names.begin(), names.end()};
  }

  KnownFault new_fault(const Subject& subject, const Gathered& gathered) {
    KnownFault fault;
    fault.id = free_id(subject);
    fault.rules.assign(gathered.rules.begin(), gathered.rules.end());
    fault.kinds.assign(gathered.kinds.begin(), gathered.kinds.end());
    if (subject.failure.empty()) fault.cause = gathered.cause;
    if (gathered.surfaces.size() == 1) fault.surface = *gathered.surfaces.begin();
    fault.cases = names_of(gathered);
    if (!release_.numbers.empty())
      fault.versions = VersionRange{release_.product, release_.numbers, {}};
    fault.reason = options_.reason.empty() ? gathered.reason : options_.reason;
    fault.link = options_.link;
    return fault;
  }

  // Sets the counts of this release, and closes faults that it does not show.
  void count(std::vector<KnownFault>& added) {
    KnownFaults all{current_.driver, after_};
    all.faults.insert(all.faults.end(), added.begin(), added.end());
    const auto faults = faults_of(all, info_);
    Counts counts;
    for (std::size_t i = 0; i < results_.cases.size(); ++i) {
      if (results_.cases.outline(i).answers[index_].verdict < Verdict::contested) continue;
      const CaseResults one = results_.cases[i];
      for (const KnownFault* fault : faults_behind(one, one.results[index_], faults))
        ++counts[fault->id];
    }
    const std::string release = text_of(release_);
    for (KnownFault& fault : added) fault.cases_on[release] = counts[fault.id];
    for (std::size_t i = 0; i < after_.size(); ++i) {
      if (std::ranges::find(faults, &all.faults[i]) == faults.end()) continue;
      const std::size_t count = counts[after_[i].id];
      if (is_partial(results_, index_, current_.faults[i]) && count <= count_before(after_[i]))
        continue;
      if (count > 0)
        after_[i].cases_on[release] = count;
      else if (!release_.is_es && !is_of_es_alone(after_[i]))
        close(after_[i]);
    }
  }

  std::size_t count_before(const KnownFault& fault) const {
    const auto found = fault.cases_on.find(text_of(release_));
    return found == fault.cases_on.end() ? 0 : found->second;
  }

  void close(KnownFault& fault) {
    fault.cases_on.erase(text_of(release_));
    const bool is_older =
        fault.versions && !fault.cases_on.empty() &&
        (fault.versions->low.empty() || is_before(fault.versions->low, release_.numbers));
    if (is_older)
      fault.versions->high = release_.numbers;
    else
      gone_.insert(fault.id);
  }

  std::vector<FaultChange> changes(std::vector<KnownFault> added) const {
    std::vector<FaultChange> changes;
    for (std::size_t i = 0; i < after_.size(); ++i) {
      const KnownFault& before = current_.faults[i];
      if (gone_.contains(before.id))
        changes.push_back({before, std::nullopt});
      else if (after_[i] != before)
        changes.push_back({before, after_[i]});
    }
    for (KnownFault& fault : added) changes.push_back({std::nullopt, std::move(fault)});
    return changes;
  }

  const Results& results_;
  std::size_t index_;
  const KnownFaults& current_;
  const BlessingOptions& options_;
  const RendererInfo& info_;
  Release release_;
  std::vector<KnownFault> after_;  // as `current_`, changed
  std::map<Subject, Gathered> gathered_;
  std::set<std::string> ids_;   // of new faults
  std::set<std::string> gone_;  // of old ones
};

}  // namespace

std::vector<FaultChange> plan_blessing(const Results& results, std::size_t index,
                                       const KnownFaults& current, const BlessingOptions& options) {
  return Blessing(results, index, current, options)();
}

KnownFaults with_changes(const KnownFaults& current, std::span<const FaultChange> changes) {
  KnownFaults changed = current;
  for (const FaultChange& change : changes) {
    if (!change.before) {
      changed.faults.push_back(*change.after);
      continue;
    }
    const auto found = std::ranges::find(changed.faults, change.before->id, &KnownFault::id);
    if (change.after)
      *found = *change.after;
    else
      changed.faults.erase(found);
  }
  return changed;
}

}  // namespace edgecase
