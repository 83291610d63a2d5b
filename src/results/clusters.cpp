// SPDX-License-Identifier: MIT
#include "results/clusters.h"

#include <algorithm>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "base/threads.h"
#include "results/cluster_entries.h"
#include "rules/all_rules.h"
#include "rules/hypotheses.h"

namespace edgecase {
namespace {

using Place = ClusterPlace;

// What the portrait says of an answer, or nothing: of what it covers, and of its colours.
struct Explained {
  std::string coverage;
  std::string colors;
};

// Ties alone have a name in the catalogue, which covers what is allowed as well.
Explained explained_by(const Portrait& p, const ResultOutline& answer) {
  const bool has_name = p.coverage && is_about_ties_alone(p.coverage->hypothesis);
  return {has_name ? "" : Portrait{p.coverage, {}}.cause_of(answer),
          Portrait{{}, p.colors}.cause_of(answer)};
}

ClusterEntryKey key_of(const DisagreementClass& d, const Explained& explained,
                       const std::string& surface) {
  const std::string& told =
      d.kind == DisagreementKind::value ? explained.colors : explained.coverage;
  const bool is_open = is_legal(d) && is_open_choice(d.cause);
  const std::string as_if = text_of(d.cause);
  return {{is_open ? as_if : told, surface, d.legality, name_of(d.rule), name_of(d.kind), ""},
          is_open || !told.empty() ? "" : as_if};
}

ClusterEntryKey key_of(const ValueAggregate& values, const Explained& explained,
                       const std::string& surface) {
  const bool is_stored = values.cause.empty() && values.rule == RuleId::framebuffer_unorm8;
  return {{is_stored ? explained.colors : text_of(values.cause), surface, Legality::legal,
           name_of(values.rule), name_of(DisagreementKind::value), values.attribute},
          ""};
}

bool is_of_lookups(RuleId rule) {
  const std::string name = name_of(rule);
  return name.starts_with("texture.") || name.starts_with("mipmap.");
}

// True if the evidence tells causes of the disagreement. Values of operations are those of pixels.
bool is_about(const DisagreementClass& d, const Result::Evidence& evidence) {
  if (d.kind == DisagreementKind::value)
    return evidence.primitive == kAllValues && !evidence.causes.empty() &&
           (is_of_lookups(evidence.causes.front().rule()) ? is_of_lookups(d.rule)
                                                          : d.primitive < 0);
  return d.primitive == evidence.primitive && (evidence.pass < 0 || d.sample == evidence.pass);
}

// The causes under which differences of an answer come out.
class LikelyCauses {
 public:
  // Refers to the result.
  explicit LikelyCauses(const Result& result) : result_(result) {}

  const std::vector<Cause>& of(const DisagreementClass& d) {
    if (latest_ && latest_->primitive == d.primitive && latest_->sample == d.sample &&
        latest_->kind == d.kind && latest_->rule == d.rule && latest_->cause == d.cause)
      return causes_;
    latest_ = d;
    causes_.clear();
    if (!d.cause.empty()) causes_.push_back(d.cause);
    for (const Result::Evidence& evidence : result_.evidence)
      if (is_about(d, evidence))
        causes_.insert(causes_.end(), evidence.causes.begin(), evidence.causes.end());
    return causes_;
  }

 private:
  const Result& result_;
  std::optional<DisagreementClass> latest_;
  std::vector<Cause> causes_;
};

void gather_disagreements(const Place& place, const Result& result, const Explained& explained,
                          ClusterEntries& gatherer) {
  LikelyCauses likely(result);
  for (const Disagreement& d : result.disagreements)
    gatherer.add(key_of(d, explained, place.one->surface), place,
                 {1, d.x, d.y, d.primitive, d.situation, likely.of(d)});
  for (const CountedDisagreements& d : result.counted) {
    if (d.runs.empty()) continue;
    const PixelRun& first = d.runs.front();
    gatherer.add(key_of(d, explained, place.one->surface), place,
                 {d.count(), first.begin, first.y, d.primitive, {}, likely.of(d)});
  }
}

void gather_values(const Place& place, const Result& result, const Explained& explained,
                   ClusterEntries& gatherer) {
  for (const ValueAggregate& values : result.values) {
    if (values.differing.empty()) continue;
    const ValueAggregate::Place& worst = values.worst;
    gatherer.add(key_of(values, explained, place.one->surface), place,
                 {values.differing.size(), worst.x, worst.y, worst.primitive, "", {}});
  }
}

bool comes_before(const Cluster& a, const Cluster& b) {
  const auto order = [](const Cluster& c) {
    // The key of the cluster is part of it, so that no two are equal.
    return std::tuple(-static_cast<int>(c.legality), -static_cast<long>(c.cases),
                      -static_cast<long>(c.disagreements),
                      std::tie(c.cause, c.rule, c.kind, c.attribute, c.surface));
  };
  return order(a) < order(b);
}

}  // namespace

ClusterGatherer::ClusterGatherer(Portrait portrait, std::map<std::string, AlternativeSet> refuted)
    : portrait_(std::move(portrait)), entries_(new ClusterEntries(std::move(refuted))) {}

ClusterGatherer::ClusterGatherer(const Results& results, std::size_t renderer)
    : ClusterGatherer(portrait_of(results, renderer)) {
  const auto found = results.refuted.find(results.renderers[renderer].name);
  if (found != results.refuted.end()) entries_ = std::make_unique<ClusterEntries>(found->second);
}

ClusterGatherer::~ClusterGatherer() = default;
ClusterGatherer::ClusterGatherer(ClusterGatherer&&) noexcept = default;

void ClusterGatherer::add(const CaseResults& one, const Result& result) {
  entries_->start(one);
  const Place place{&one, CaseSize(one)};
  const Explained explained = explained_by(portrait_, result);
  gather_disagreements(place, result, explained, *entries_);
  gather_values(place, result, explained, *entries_);
}

namespace {

std::vector<Cluster> sorted(std::vector<Cluster> clusters) {
  std::ranges::sort(clusters, comes_before);
  return clusters;
}

}  // namespace

std::vector<Cluster> ClusterGatherer::take() {
  return sorted(entries_->take(false));
}

std::vector<Cluster> ClusterGatherer::take_apart() {
  return sorted(entries_->take(true));
}

std::vector<Cluster> clusters_of(const Results& results, std::size_t renderer) {
  ClusterGatherer gatherer(results, renderer);
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const std::vector<ResultOutline>& answers = results.cases.outline(i).answers;
    if (renderer >= answers.size() || !has_details(results.cases.outline(i))) continue;
    const CaseResults one = results.cases[i];
    gatherer.add(one, one.results[renderer]);
  }
  return gatherer.take();
}

std::vector<std::vector<Cluster>> clusters_of(const Results& results) {
  std::vector<ClusterGatherer> gatherers;
  for (std::size_t r = 0; r < results.renderers.size(); ++r) gatherers.emplace_back(results, r);
  const auto case_of = [&](std::size_t i) {
    std::optional<CaseResults> one;
    if (has_details(results.cases.outline(i))) one = results.cases[i];
    return one;
  };
  const auto add = [&](std::size_t, const std::optional<CaseResults>& one) {
    if (!one) return;
    for (std::size_t r = 0; r < std::min(gatherers.size(), one->results.size()); ++r)
      gatherers[r].add(*one, one->results[r]);
  };
  make_in_order(results.cases.size(), case_of, add,
                [&](std::size_t i) { return results.cases.bytes(i); });
  std::vector<std::vector<Cluster>> clusters;
  for (ClusterGatherer& gatherer : gatherers) clusters.push_back(gatherer.take());
  return clusters;
}

CaseSize::CaseSize(const CaseResults& one)
    : primitives(std::ranges::count(one.figure.marks, MarkRole::primitive, &Mark::role)),
      pixels(static_cast<std::ptrdiff_t>(one.width) * one.height),
      length(one.id.size()),
      id(one.id) {}

std::optional<ClusterKey> leading_key(const CaseResults& one, const Result& result,
                                      const Portrait& portrait) {
  const Explained explained = explained_by(portrait, result);
  const auto worst = std::ranges::max_element(result.disagreements, {}, &Disagreement::legality);
  if (worst != result.disagreements.end()) return key_of(*worst, explained, one.surface).of;
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty()) return key_of(values, explained, one.surface).of;
  return std::nullopt;
}

const Cluster* cluster_of(std::span<const Cluster> clusters, const ClusterKey& key) {
  const auto found = std::ranges::find_if(clusters, [&](const Cluster& cluster) {
    return std::ranges::find(cluster.keys, key) != cluster.keys.end();
  });
  return found == clusters.end() ? nullptr : &*found;
}

const Cluster* told_by(const CaseResults& one, const Result& result, const Portrait& portrait,
                       std::span<const Cluster> clusters) {
  const auto key = leading_key(one, result, portrait);
  return key ? cluster_of(clusters, *key) : nullptr;
}

std::string title_of(const Cluster& cluster) {
  const std::string what =
      cluster.attribute.empty() ? cluster.kind : cluster.attribute + " within what is permitted";
  const std::string text = cluster.cause.empty() ? cluster.rule + " " + what : cluster.cause;
  return cluster.surface.empty() ? text : text + ", " + cluster.surface;
}

}  // namespace edgecase
