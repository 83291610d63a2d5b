// SPDX-License-Identifier: MIT
#include "results/clusters.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "model/threads.h"
#include "rules/all_rules.h"
#include "rules/hypotheses.h"

namespace edgecase {
namespace {

// The common key of a cluster's members; rule and kind are empty if there is a cause.
struct Key {
  std::string cause;
  std::string surface;
  Legality legality = Legality::illegal;
  std::string rule;
  std::string kind;
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
  std::optional<std::string> situation{};  // null: only counted
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
    if (key.cause.empty() && key.attribute.empty()) entry.count(member);
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
      if (key.cause.empty()) cluster.situations = entry.take_situations();
      cluster.attribute = key.attribute;
      clusters.push_back(std::move(cluster));
    }
    return clusters;
  }

 private:
  struct Situation {
    std::size_t disagreements = 0;
    std::size_t cases = 0;
    std::string latest{};  // id of the last case that has it
  };

  struct Entry {
    Cluster cluster;
    std::optional<std::string> latest;  // id of the last member's case
    std::optional<CaseSize> smallest;
    std::map<std::optional<std::string>, Situation> situations;

    void count(const Member& member) {
      if (member.situation == "") return;
      Situation& situation = situations[member.situation];
      situation.disagreements += member.count;
      if (situation.cases == 0 || situation.latest != *latest) ++situation.cases;
      situation.latest = *latest;
    }

    std::vector<ClusterSituation> take_situations() const {
      std::vector<ClusterSituation> list;
      for (const auto& [text, situation] : situations)
        list.push_back({text.value_or("of a gross fault, only counted"), !text,
                        situation.disagreements, situation.cases});
      std::ranges::stable_sort(list, std::ranges::greater(), &ClusterSituation::disagreements);
      return list;
    }
  };
  std::map<Key, Entry> entries_;
};

namespace {

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

std::string cause_of(const DisagreementClass& d, const Explained& explained) {
  const std::string& told =
      d.kind == DisagreementKind::value ? explained.colors : explained.coverage;
  const bool is_open = is_legal(d) && is_open_choice(d.cause);
  return told.empty() || is_open ? text_of(d.cause) : told;
}

std::string cause_of(const ValueAggregate& values, const Explained& explained) {
  return values.cause.empty() && values.rule == RuleId::framebuffer_unorm8 ? explained.colors
                                                                           : text_of(values.cause);
}

Key key_of(const DisagreementClass& d, const Explained& explained, const std::string& surface) {
  Key key;
  key.cause = cause_of(d, explained);
  key.surface = surface;
  key.legality = d.legality;
  if (key.cause.empty()) {
    key.rule = name_of(d.rule);
    key.kind = name_of(d.kind);
  }
  return key;
}

template <class Entries>
void gather_disagreements(const Place& place, const Result& result, const Explained& explained,
                          Entries& gatherer) {
  for (const Disagreement& d : result.disagreements)
    gatherer.add(key_of(d, explained, place.one->surface), place,
                 {name_of(d.rule), name_of(d.kind), 1, d.x, d.y, d.primitive, d.situation});
  for (const CountedDisagreements& d : result.counted) {
    if (d.runs.empty()) continue;
    const PixelRun& first = d.runs.front();
    gatherer.add(
        key_of(d, explained, place.one->surface), place,
        {name_of(d.rule), name_of(d.kind), d.count(), first.begin, first.y, d.primitive, {}});
  }
}

template <class Entries>
void gather_values(const Place& place, const Result& result, const Explained& explained,
                   Entries& gatherer) {
  const char* const kind = name_of(DisagreementKind::value);
  for (const ValueAggregate& values : result.values) {
    if (values.differing.empty()) continue;
    Key key{cause_of(values, explained),
            place.one->surface,
            Legality::legal,
            name_of(values.rule),
            kind,
            values.attribute};
    if (!key.cause.empty()) key.rule = key.kind = key.attribute = "";
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
                      std::tie(c.cause, c.rule, c.kind, c.attribute, c.surface));
  };
  return order(a) < order(b);
}

}  // namespace

ClusterGatherer::ClusterGatherer(Portrait portrait)
    : portrait_(std::move(portrait)), entries_(new Entries) {}

ClusterGatherer::~ClusterGatherer() = default;
ClusterGatherer::ClusterGatherer(ClusterGatherer&&) noexcept = default;

void ClusterGatherer::add(const CaseResults& one, const Result& result) {
  const Place place{&one, CaseSize(one)};
  const Explained explained = explained_by(portrait_, result);
  gather_disagreements(place, result, explained, *entries_);
  gather_values(place, result, explained, *entries_);
}

std::vector<Cluster> ClusterGatherer::take() {
  std::vector<Cluster> clusters = entries_->take();
  std::ranges::sort(clusters, comes_before);
  return clusters;
}

std::vector<Cluster> clusters_of(const Results& results, std::size_t renderer) {
  ClusterGatherer gatherer(portrait_of(results, renderer));
  for (std::size_t i = 0; i < results.cases.size(); ++i) {
    const std::vector<ResultOutline>& answers = results.cases.outline(i).answers;
    if (renderer >= answers.size() || answers[renderer].verdict == Verdict::agree) continue;
    const CaseResults one = results.cases[i];
    gatherer.add(one, one.results[renderer]);
  }
  return gatherer.take();
}

std::vector<std::vector<Cluster>> clusters_of(const Results& results) {
  std::vector<ClusterGatherer> gatherers;
  for (std::size_t r = 0; r < results.renderers.size(); ++r)
    gatherers.emplace_back(portrait_of(results, r));
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

std::optional<Cluster> leading_cluster(const CaseResults& one, const Result& result,
                                       const Portrait& portrait) {
  const Explained explained = explained_by(portrait, result);
  Cluster cluster;
  cluster.surface = one.surface;
  const auto told = [&](const std::string& cause, Legality legality, const auto& of) {
    cluster.cause = cause;
    cluster.legality = legality;
    cluster.rule = name_of(of.rule);
    return cluster;
  };
  cluster.kind = name_of(DisagreementKind::value);
  const auto worst = std::ranges::max_element(result.disagreements, {}, &Disagreement::legality);
  if (worst != result.disagreements.end()) {
    cluster.kind = name_of(worst->kind);
    return told(cause_of(*worst, explained), worst->legality, *worst);
  }
  for (const ValueAggregate& values : result.values) {
    if (values.differing.empty()) continue;
    const std::string cause = cause_of(values, explained);
    if (cause.empty()) cluster.attribute = values.attribute;
    return told(cause, Legality::legal, values);
  }
  return std::nullopt;
}

bool is_same_cluster(const Cluster& a, const Cluster& b) {
  const auto key = [](const Cluster& c) { return std::tie(c.cause, c.surface, c.legality); };
  const auto rest = [](const Cluster& c) { return std::tie(c.rule, c.kind, c.attribute); };
  return key(a) == key(b) && (!a.cause.empty() || rest(a) == rest(b));
}

std::string title_of(const Cluster& cluster) {
  const std::string what =
      cluster.attribute.empty() ? cluster.kind : cluster.attribute + " within what is permitted";
  const std::string text = cluster.cause.empty() ? cluster.rule + " " + what : cluster.cause;
  return cluster.surface.empty() ? text : text + ", " + cluster.surface;
}

}  // namespace edgecase
