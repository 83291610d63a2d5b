// SPDX-License-Identifier: MIT
//
// Clusters: the differences of a renderer, grouped by the one cause that the run has for them.
//
// Ten thousand disagreements of a run may be three faults. What the renderer's portrait explains,
// and what an open choice does, forms a cluster each. All other differences of a rule and kind are
// one cluster, with the cause that explains at least nine in ten of their cases and that no other
// answer refutes, or without one. A cluster without a cause tells in rows where on a primitive its
// differences lie, and which causes some of them look like, and in words what they have in common.
// Clusters of one cause are one. Different surfaces and legalities are never in one cluster.
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "results/results.h"

namespace edgecase {

// What decides on the cluster of a difference. `cause` is set where the portrait or an open choice
// explains it.
struct ClusterKey {
  std::string cause;
  std::string surface;  // "fbo", "window"
  Legality legality = Legality::illegal;
  std::string rule;       // id
  std::string kind;       // "missing"
  std::string attribute;  // of permitted values; else empty
  friend auto operator<=>(const ClusterKey&, const ClusterKey&) = default;
};

// Some differences of a cluster without a cause: by where on a primitive they lie, or by the cause
// that they look like in their case alone ("as if …").
struct ClusterSituation {
  std::string text;         // in words
  bool is_counted = false;  // they are only counted (Result::counted); the text says so
  std::size_t disagreements = 0;
  std::size_t cases = 0;  // that have at least one of them
  friend bool operator==(const ClusterSituation&, const ClusterSituation&) = default;
};

// [text, disagreements, cases], for every kind of document of the JSON library.
template <class Json>
void to_json(Json& json, const ClusterSituation& situation) {
  json = Json::array({situation.text, situation.disagreements, situation.cases});
}

struct Cluster {
  std::string rule;                       // id; empty: several, which the cause joins
  std::string kind;                       // "missing"; empty: several, which the cause joins
  std::string surface;                    // "fbo", "window"
  Legality legality = Legality::illegal;  // of all of them
  std::string cause;                      // empty: none found
  // The most frequent first; none where there is a cause, and for values.
  std::vector<ClusterSituation> situations;
  // What all have in common where there is no cause: "y-major, in the lowest row"; or empty.
  std::string common;
  // "color", "depth", "pixel": values that differ within the permitted range; empty otherwise.
  std::string attribute;
  std::size_t disagreements = 0;  // with `attribute`: values
  std::size_t cases = 0;          // that have at least one of them
  std::vector<ClusterKey> keys;   // of its differences

  // The case to look at first: fewest primitives, then the smallest target, then the shortest id,
  // then the first id; and the place of its first difference.
  std::string smallest_case;  // id
  std::string smallest_file;  // path of its case file, as given
  int x = 0;                  // pixel column
  int y = 0;                  // pixel row, y up
  int primitive = -1;         // index in drawing order; -1: the pixel as a whole
};

// The key of the difference that an answer is told by: the first of the worst, else the first
// attribute whose values differ. Nothing for an answer in which nothing differs, or that is none.
std::optional<ClusterKey> leading_key(const CaseResults& one, const Result& result,
                                      const Portrait& portrait = {});

// The cluster of differences with that key; null: none of these.
const Cluster* cluster_of(std::span<const Cluster> clusters, const ClusterKey& key);

// The cluster of the difference that an answer is told by; null: nothing differs.
const Cluster* told_by(const CaseResults& one, const Result& result, const Portrait& portrait,
                       std::span<const Cluster> clusters);

// The clusters of the renderer at `renderer`: illegal ones first, then contested ones, then legal
// ones. Within each, those that most cases share come first, then those of most differences; ties
// go by the texts. The same results give the same clusters.
std::vector<Cluster> clusters_of(const Results& results, std::size_t renderer);

// The same of all renderers, in their order.
std::vector<std::vector<Cluster>> clusters_of(const Results& results);

// The same of results that come one after the other, of one renderer.
class ClusterGatherer {
 public:
  // `refuted`: by surface, what answers of the renderer refute.
  explicit ClusterGatherer(Portrait portrait = {},
                           std::map<std::string, AlternativeSet> refuted = {});
  // What the results say of the renderer at `renderer`.
  ClusterGatherer(const Results& results, std::size_t renderer);
  ~ClusterGatherer();
  ClusterGatherer(ClusterGatherer&&) noexcept;

  // A result of a case.
  void add(const CaseResults& one, const Result& result);
  // To be called once.
  std::vector<Cluster> take();
  // The same by the cause that each difference looks like in its case alone. To be called once.
  std::vector<Cluster> take_apart();

 private:
  Portrait portrait_;
  std::unique_ptr<class ClusterEntries> entries_;
};

// The order of cases: the least is the one to look at first (Cluster::smallest_case).
struct CaseSize {
  std::ptrdiff_t primitives = 0;
  std::ptrdiff_t pixels = 0;
  std::size_t length = 0;  // of the id
  std::string id;

  explicit CaseSize(const CaseResults& one);
  friend auto operator<=>(const CaseSize&, const CaseSize&) = default;
};

// The name of a cluster among those of its renderer, on one line: "line.diamond-exit extra, window"
// or "triangle.fill-rule=left-bottom, fbo". Without legality and counts.
std::string title_of(const Cluster& cluster);

}  // namespace edgecase
