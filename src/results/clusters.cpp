// SPDX-License-Identifier: MIT
#include "results/clusters.h"

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>

#include "rules/all_rules.h"

namespace edgecase {
namespace {

// What the members of a cluster share; rule, kind and situation stay empty where there is a cause.
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

// A case with what it is ordered by: primitives, pixels of the target, length of the id, id.
struct SizedCase {
  const CaseResults* one = nullptr;
  std::size_t primitives = 0;

  explicit SizedCase(const CaseResults& results)
      : one(&results),
        primitives(static_cast<std::size_t>(
            std::ranges::count(results.figure.marks, MarkRole::primitive, &Mark::role))) {}

  friend bool operator<(const SizedCase& a, const SizedCase& b) {
    const auto size = [](const SizedCase& sized) {
      const CaseResults& results = *sized.one;
      const auto pixels = static_cast<long>(results.width) * results.height;
      return std::tuple(sized.primitives, pixels, results.id.size(), std::string_view(results.id));
    };
    return size(a) < size(b);
  }
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

class Gatherer {
 public:
  void add(const Key& key, const SizedCase& place, const Member& member) {
    Entry& entry = entries_[key];
    Cluster& cluster = entry.cluster;
    if (cluster.disagreements == 0) {
      cluster.rule = member.rule;
      cluster.kind = member.kind;
    }
    // Of several rules or kinds none is named, rather than the first.
    if (cluster.rule != member.rule) cluster.rule.clear();
    if (cluster.kind != member.kind) cluster.kind.clear();
    cluster.disagreements += member.count;
    if (entry.latest != place.one) ++cluster.cases;
    entry.latest = place.one;
    if (entry.smallest && !(place < *entry.smallest)) return;
    entry.smallest = place;
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
    const CaseResults* latest = nullptr;  // the case of the last member
    std::optional<SizedCase> smallest;
  };
  std::map<Key, Entry> entries_;
};

void gather_disagreements(const SizedCase& place, const Result& result, Gatherer& gatherer) {
  for (const Disagreement& d : result.disagreements) {
    Key key;
    key.cause = text_of(d.cause);
    key.surface = place.one->surface;
    key.legality = d.legality;
    if (d.cause.empty()) {
      key.rule = name_of(d.rule);
      key.kind = name_of(d.kind);
      key.situation = d.situation;
    }
    gatherer.add(key, place, {name_of(d.rule), name_of(d.kind), 1, d.x, d.y, d.primitive});
  }
}

void gather_values(const SizedCase& place, const Result& result, Gatherer& gatherer) {
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

std::vector<Cluster> clusters_of(const Results& results, std::size_t renderer) {
  Gatherer gatherer;
  for (const CaseResults& one : results.cases) {
    if (renderer >= one.results.size()) continue;
    const SizedCase place(one);
    gather_disagreements(place, one.results[renderer], gatherer);
    gather_values(place, one.results[renderer], gatherer);
  }
  std::vector<Cluster> clusters = gatherer.take();
  std::ranges::sort(clusters, comes_before);
  return clusters;
}

bool is_simpler(const CaseResults& a, const CaseResults& b) {
  return SizedCase(a) < SizedCase(b);
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
