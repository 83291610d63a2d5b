// SPDX-License-Identifier: MIT
//
// Cluster entries: the differences of a renderer by their keys, and the one cause that the run has
// for those of a rule and kind.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "results/clusters.h"

namespace edgecase {

// A difference's key, and the cause that it looks like in its case alone.
struct ClusterEntryKey {
  ClusterKey of;
  std::string as_if;
  friend auto operator<=>(const ClusterEntryKey&, const ClusterEntryKey&) = default;
};

// A case whose members are added.
struct ClusterPlace {
  const CaseResults* one = nullptr;
  CaseSize size;
};

// Some differences of one case that belong to one cluster: one disagreement, or the values of one
// attribute.
struct ClusterMember {
  std::size_t count = 1;
  int x = 0;  // where to look at the first of them
  int y = 0;
  int primitive = -1;
  std::optional<std::string> situation{};  // null: only counted
  std::vector<Cause> likely{};             // causes under which they come out
};

class ClusterEntries {
 public:
  // `refuted`: by surface.
  explicit ClusterEntries(std::map<std::string, AlternativeSet> refuted);
  ~ClusterEntries();

  // A case whose differences are added next.
  void start(const CaseResults& one);
  void add(const ClusterEntryKey& key, const ClusterPlace& place, const ClusterMember& member);
  // To be called once. `is_apart`: by the cause that each difference looks like in its case alone.
  std::vector<Cluster> take(bool is_apart);

 private:
  class Lists;
  std::unique_ptr<Lists> lists_;
};

}  // namespace edgecase
