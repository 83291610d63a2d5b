// SPDX-License-Identifier: MIT
#include "results/clusters.h"

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "model/threads.h"
#include "rules/all_rules.h"

namespace edgecase {
namespace {

// What an answer begins with: with a cause, or without one.
struct Beginning {
  std::size_t renderer = 0;
  Verdict verdict = Verdict::agree;
  std::string cause;
  std::string rule;
  int kind = 0;
  std::string situation;
  friend auto operator<=>(const Beginning&, const Beginning&) = default;
};

Beginning beginning_of(const Result& result, std::size_t renderer) {
  // The first of the worst.
  const auto worst = std::ranges::max_element(result.disagreements, {}, &Disagreement::legality);
  if (worst != result.disagreements.end()) {
    if (!worst->cause.empty()) return {renderer, result.verdict, text_of(worst->cause), "", 0, ""};
    return {
        renderer,        result.verdict, "", name_of(worst->rule), static_cast<int>(worst->kind),
        worst->situation};
  }
  const int kind = static_cast<int>(DisagreementKind::value);
  for (const ValueAggregate& values : result.values)
    if (!values.differing.empty())
      return {renderer, result.verdict,  text_of(values.cause), name_of(values.rule),
              kind,     values.attribute};
  const std::string failure = result.failure ? name_of(result.failure->kind) : "";
  return {renderer, result.verdict, "", failure, 0, ""};
}

// 0 for the worst. What was not run comes last: nothing is known of it.
int rank_of(Verdict verdict) {
  constexpr int kLast = static_cast<int>(Verdict::not_run);
  return verdict == Verdict::not_run ? kLast : kLast - 1 - static_cast<int>(verdict);
}

}  // namespace

std::vector<const Disagreement*> worst_first(const Result& result) {
  std::vector<const Disagreement*> order;
  for (const Disagreement& d : result.disagreements) order.push_back(&d);
  std::ranges::stable_sort(order, std::ranges::greater(),
                           [](const Disagreement* d) { return d->legality; });
  return order;
}

class WorstFirst::Entries {
 public:
  void add(AnswerPlace place, const Result& result) {
    std::size_t& count = counts_[beginning_of(result, place.renderer)];
    ++count;
    sorted_.push_back({place, rank_of(result.verdict), &count});
  }

  std::vector<AnswerPlace> take() {
    std::ranges::stable_sort(sorted_, [](const Sorted& a, const Sorted& b) {
      return std::tuple(a.rank, *b.alike) < std::tuple(b.rank, *a.alike);
    });
    std::vector<AnswerPlace> places;
    for (const Sorted& one : sorted_) places.push_back(one.place);
    return places;
  }

 private:
  struct Sorted {
    AnswerPlace place;
    int rank = 0;
    const std::size_t* alike = nullptr;
  };
  std::map<Beginning, std::size_t> counts_;
  std::vector<Sorted> sorted_;
};

WorstFirst::WorstFirst() : entries_(std::make_unique<Entries>()) {}

WorstFirst::~WorstFirst() = default;

void WorstFirst::add(AnswerPlace place, const Result& result) {
  entries_->add(place, result);
}

std::vector<AnswerPlace> WorstFirst::take() {
  return entries_->take();
}

std::vector<AnswerPlace> worst_first(const Results& results, const WantedAnswer& is_wanted) {
  WorstFirst order;
  const auto case_of = [&](std::size_t i) {
    std::optional<CaseResults> one;
    if (std::ranges::any_of(results.cases.outline(i).answers, is_wanted)) one = results.cases[i];
    return one;
  };
  const auto add = [&](std::size_t i, const std::optional<CaseResults>& one) {
    for (std::size_t r = 0; one && r < one->results.size() && r < results.renderers.size(); ++r)
      if (is_wanted(one->results[r])) order.add({i, r}, one->results[r]);
  };
  make_in_order(results.cases.size(), case_of, add,
                [&](std::size_t i) { return results.cases.bytes(i); });
  return order.take();
}

namespace {

// The common key of a cluster's members; rule, kind and situation are empty if there is a cause.
struct Key {
  std::string cause;
  std::string surface;
  Legality legality = Legality::illegal;
  std::string rule;
  std::string kind;
  std::string situation;
  std::string attribute;
  friend auto operator<=>(const Key&, const Key&) = default;
};

// A case whose members are added.
struct Place {
  const CaseResults* one = nullptr;
  CaseSize size;
};

// Some differences of one case that belong to one cluster: one disagreement, or the values of one
// attribute.
struct Member {
  std::string rule;
  std::string kind;
  std::size_t count = 1;
  int x = 0;  // where to look at the first of them
  int y = 0;
  int primitive = -1;
};

}  // namespace

class ClusterGatherer::Entries {
 public:
  void add(const Key& key, const Place& place, const Member& member) {
    Entry& entry = entries_[key];
    Cluster& cluster = entry.cluster;
    if (cluster.disagreements == 0) {
      cluster.rule = member.rule;
      cluster.kind = member.kind;
    }
    // A cluster with several rules or kinds names none.
    if (cluster.rule != member.rule) cluster.rule.clear();
    if (cluster.kind != member.kind) cluster.kind.clear();
    cluster.disagreements += member.count;
    if (entry.latest != place.one->id) ++cluster.cases;
    entry.latest = place.one->id;
    if (entry.smallest && !(place.size < *entry.smallest)) return;
    entry.smallest = place.size;
    cluster.smallest_case = place.one->id;
    cluster.smallest_file = place.one->file;
    cluster.x = member.x;
    cluster.y = member.y;
    cluster.primitive = member.primitive;
  }

  std::vector<Cluster> take() {
    std::vector<Cluster> clusters;
    for (auto& [key, entry] : entries_) {
      Cluster& cluster = entry.cluster;
      cluster.surface = key.surface;
      cluster.legality = key.legality;
      cluster.cause = key.cause;
      cluster.situation = key.situation;
      cluster.attribute = key.attribute;
      clusters.push_back(std::move(cluster));
    }
    return clusters;
  }

 private:
  struct Entry {
    Cluster cluster;
    std::optional<std::string> latest;  // id of the last member's case
    std::optional<CaseSize> smallest;
  };
  std::map<Key, Entry> entries_;
};

namespace {

Key key_of(const DisagreementClass& d, const std::string& situation, const std::string& surface) {
  Key key;
  key.cause = text_of(d.cause);
  key.surface = surface;
  key.legality = d.legality;
  if (d.cause.empty()) {
    key.rule = name_of(d.rule);
    key.kind = name_of(d.kind);
    key.situation = situation;
  }
  return key;
}

template <class Entries>
void gather_disagreements(const Place& place, const Result& result, Entries& gatherer) {
  for (const Disagreement& d : result.disagreements)
    gatherer.add(key_of(d, d.situation, place.one->surface), place,
                 {name_of(d.rule), name_of(d.kind), 1, d.x, d.y, d.primitive});
  for (const CountedDisagreements& d : result.counted) {
    if (d.runs.empty()) continue;
    const PixelRun& first = d.runs.front();
    gatherer.add(key_of(d, kSituationOfCounted, place.one->surface), place,
                 {name_of(d.rule), name_of(d.kind), d.count(), first.begin, first.y, d.primitive});
  }
}

template <class Entries>
void gather_values(const Place& place, const Result& result, Entries& gatherer) {
  const char* const kind = name_of(DisagreementKind::value);
  for (const ValueAggregate& values : result.values) {
    if (values.differing.empty()) continue;
    Key key{
        text_of(values.cause), place.one->surface, Legality::legal, name_of(values.rule), kind, "",
        values.attribute};
    if (!values.cause.empty()) key.rule = key.kind = key.attribute = "";
    const ValueAggregate::Place& worst = values.worst;
    gatherer.add(
        key, place,
        {name_of(values.rule), kind, values.differing.size(), worst.x, worst.y, worst.primitive});
  }
}

bool comes_before(const Cluster& a, const Cluster& b) {
  const auto order = [](const Cluster& c) {
    // The key of the cluster is part of it, so that no two are equal.
    return std::tuple(-static_cast<int>(c.legality), -static_cast<long>(c.cases),
                      -static_cast<long>(c.disagreements),
                      std::tie(c.cause, c.rule, c.kind, c.situation, c.attribute, c.surface));
  };
  return order(a) < order(b);
}

}  // namespace

ClusterGatherer::ClusterGatherer() : entries_(new Entries) {}

ClusterGatherer::~ClusterGatherer() = default;

ClusterGatherer::ClusterGatherer(ClusterGatherer&&) noexcept = default;

void ClusterGatherer::add(const CaseResults& one, const Result& result) {
  const Place place{&one, CaseSize(one)};
  gather_disagreements(place, result, *entries_);
  gather_values(place, result, *entries_);
}

std::vector<Cluster> ClusterGatherer::take() {
  std::vector<Cluster> clusters = entries_->take();
  std::ranges::sort(clusters, comes_before);
  return clusters;
}

std::vector<Cluster> clusters_of(const Results& results, std::size_t renderer) {
  ClusterGatherer gatherer;
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const std::vector<ResultOutline>& answers = results.cases.outline(i).answers;
    if (renderer >= answers.size() || answers[renderer].verdict == Verdict::agree) continue;
    const CaseResults one = results.cases[i];
    gatherer.add(one, one.results[renderer]);
  }
  return gatherer.take();
}

std::vector<std::vector<Cluster>> clusters_of(const Results& results) {
  std::vector<ClusterGatherer> gatherers(results.renderers.size());
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

std::optional<Cluster> leading_cluster(const CaseResults& one, const Result& result) {
  Cluster cluster;
  cluster.surface = one.surface;
  if (const auto worst =
          std::ranges::max_element(result.disagreements, {}, &Disagreement::legality);
      worst != result.disagreements.end()) {
    cluster.cause = text_of(worst->cause);
    cluster.legality = worst->legality;
    cluster.rule = name_of(worst->rule);
    cluster.kind = name_of(worst->kind);
    if (worst->cause.empty()) cluster.situation = worst->situation;
    return cluster;
  }
  for (const ValueAggregate& values : result.values) {
    if (values.differing.empty()) continue;
    cluster.cause = text_of(values.cause);
    cluster.legality = Legality::legal;
    cluster.rule = name_of(values.rule);
    cluster.kind = name_of(DisagreementKind::value);
    if (values.cause.empty()) cluster.attribute = values.attribute;
    return cluster;
  }
  return std::nullopt;
}

bool is_same_cluster(const Cluster& a, const Cluster& b) {
  if (a.cause != b.cause || a.surface != b.surface || a.legality != b.legality) return false;
  const auto without_cause = [](const Cluster& cluster) {
    return std::tie(cluster.rule, cluster.kind, cluster.situation, cluster.attribute);
  };
  return !a.cause.empty() || without_cause(a) == without_cause(b);
}

std::string title_of(const Cluster& cluster) {
  std::string text = cluster.cause;
  if (text.empty()) {
    text = cluster.rule + " " + (cluster.attribute.empty() ? cluster.kind : cluster.attribute);
    if (!cluster.attribute.empty()) text += " within what is permitted";
    if (!cluster.situation.empty()) text += ", " + cluster.situation;
  }
  return cluster.surface.empty() ? text : text + ", " + cluster.surface;
}

}  // namespace edgecase
